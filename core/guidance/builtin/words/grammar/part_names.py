"""A thing's names for its parts, and the parts that it always has. Standard library only."""

from collections.abc import Collection

from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.part_forms import is_solid
from core.guidance.builtin.substances import CLASS_OF, METAL, natural_kind
from core.guidance.builtin.words.grammar.lexicon import PART_FORMS, Entry, forms_of
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.part_tables import (
    BORNE,
    CALLED,
    COUNTED_OF_LIVING,
    FEET,
    HARDWARE,
    LEGS,
    MANY_LEGS,
    NEVER_COUNTED,
    NO_PARTS,
    OF_BODIES,
    OPTIONS,
    PART_ALSO,
    PART_SYNONYMS,
    PART_WORDS,
    SEATS,
    TRIM,
    WHOLE,
)

FOUR_LEGS = frozenset(
    """bench chair pig turtle cat dog wolf fox bear lion cow sheep elephant giraffe horse unicorn
    corgi desk deer frog""".split()
)


LIQUID = "liquid"
ASKED = "?"  # role of a part that is drawn only where the prompt states something of it
CONTAINED = ("liquid", "brew", "water")
# Roles of most of a thing, and of its trim; the second only without any of the first.
WIDE = dict.fromkeys(WHOLE, ("*&",)) | dict.fromkeys(TRIM, ("+", "&"))


def may_state(noun: str, part: str) -> bool:
    """Whether a caption may state that the noun has the part, or how many of it."""
    states = OPTIONS.get(noun, ())
    return part in states or (part in LEGS and any(state in LEGS for state in states))


def as_part(entry: Entry, noun: str) -> str:
    """The name of a thing as a part of another: a bottle's cap, a piano's keys; or ""."""
    for name in (entry.form, entry.word):
        states = [state.removeprefix("no ") for state in OPTIONS.get(noun, ())]
        if name in states or own_name(noun, name):
            return name
    return ""


def own_name(noun: str, part: str) -> str:
    """The noun's own name for the part; "" without one."""
    return next(iter(own_names(noun, part)), "")


def own_names(noun: str, part: str, taken: Collection[str] = ()) -> list[str]:
    """All of the noun's parts that the name covers: for a chest's body also the lid; for a word for
    most of the thing those that are not ``taken``."""
    looks = looks_of(noun)
    part = CALLED.get(noun, {}).get(part, part)
    named = [name for name in _names(part) if name in looks]
    roles = WIDE.get(part, ())
    free = {name: look[0] for name, look in looks.items() if name not in taken}
    each = ([name for name, role in free.items() if role in some] for some in roles)
    if part in HARDWARE and not named:
        others = (name for name, role in free.items() if role != "*")
        metal = [name for name in others if CLASS_OF.get(natural_kind(noun, name)) == METAL]
        each = iter((metal, *each))
    found = named[:1] or next(filter(None, each), [])
    if part in TRIM and any(one[0] in "+&" for name, one in looks.items() if name != "body"):
        found = [name for name in found if name != "body"]  # "a rifle with blue accents"
    if part in TRIM and found and set(found) <= set(SEATS):  # "a chair with metal accents"
        return [name for name in FEET if name in looks][:1] or found
    return found


def is_own(noun: str, form: str) -> bool:
    """Whether the noun has a part of that name or plural: a tiger's stripes."""
    return form in looks_of(noun) or f"{form}s" in looks_of(noun)


def owns(noun: str, word: str) -> bool:
    """Whether the word names a part of the noun, not most of it."""
    return bool(own_name(noun, word)) and not is_wide(noun, word)


def is_wide(noun: str, part: str) -> bool:
    """Whether it is only a word for most of the thing, or for its trim, not for a separate part."""
    return part in WIDE and part not in looks_of(noun) and part not in CALLED.get(noun, {})


def is_asked(noun: str, form: str) -> bool:
    """Whether a part of this name is drawn only where the prompt states something of it."""
    return looks_of(noun).get(own_name(noun, form), "").startswith(ASKED)


def is_within(noun: str, form: str) -> bool:
    """Whether the noun's shape includes such a part, but not as a separate one."""
    body = is_creature(noun) and form in OF_BODIES
    return body or form in NO_PARTS.get(noun, "").split()


def has_legs(noun: str) -> bool:
    """Whether it has legs, which are not counted where a caption may not state them."""
    return noun in FOUR_LEGS or is_creature(noun) or bool(lacked(noun, "legs", "legs"))


def counted_name(noun: str, part: str) -> str:
    """The noun's name for a part of several components that may be counted: a cake's candles, a
    table's legs; "" where that is not one."""
    name = own_name(noun, "legs" if part in LEGS else part)
    if not name or not is_solid(noun, name) or not name.endswith("s"):
        return ""
    if part in LEGS and MANY_LEGS not in OPTIONS.get(noun, ()):
        return ""
    if is_creature(noun):
        return name if name in COUNTED_OF_LIVING else ""
    return "" if name in NEVER_COUNTED else name


def always_has(noun: str, part: str) -> bool:
    """Whether every such thing has the part, so that stating it changes nothing."""
    if any(part == state.removeprefix("no ") for state in OPTIONS.get(noun, ())):
        return False
    if part in LEGS:
        return part == "four legs" and noun in FOUR_LEGS
    return bool(own_names(noun, part))


def shows_liquid(noun: str) -> bool:
    """Whether the noun's content is a part of it, or is visible through it."""
    name = own_name(noun, LIQUID)
    return name in CONTAINED or "glass" in looks_of(noun).get(name, "").split()


def lacked(noun: str, part: str, form: str) -> str:
    """The noun's part that is meant by a missing ``form``; "" without one of that name. A robot
    without arms keeps its limbs."""
    looks = {name: look for name, look in looks_of(noun).items() if look[0] != ASKED}
    return next((name for name in [form, *_names(part, also=False)] if name in looks), "")


def borne(noun: str, part: str) -> list[str]:
    """The noun's parts that are removed with ``part``: the hubs with the wheels."""
    return [name for name in forms_of(BORNE.get(part, "")) if name in looks_of(noun)]


def can_lack(noun: str, parts: Collection[str]) -> bool:
    """Whether the noun remains a thing without these parts: with a main part, or, such as a tree
    without leaves, with some part that no removed part bore."""
    left = {name: look for name, look in looks_of(noun).items() if name not in parts}
    main = any(look[0] == "*" for look in left.values())
    return main or bool(left and not is_creature(noun) and not WHOLE.intersection(parts))


def _names(part: str, also: bool = True) -> list[str]:
    """Possible names of the part in a noun; ``also``: similar ones too."""
    forms = forms_of(PART_WORDS.get(part, "")) + forms_of(PART_SYNONYMS.get(part, ""))
    names = [part, PART_FORMS.get(part, part), *forms]
    names += forms_of(PART_ALSO.get(part, "")) if also else []
    return [form for name in names for form in (name, f"{name}s", name.removesuffix("s"))]


def looks_of(noun: str) -> dict[str, str]:
    """The noun's parts with their looks; none if unknown."""
    return NOUNS[noun].looks if noun in NOUNS else {}
