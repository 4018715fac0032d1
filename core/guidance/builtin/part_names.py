"""What a thing calls its parts, and which it always has. Standard library only."""

from core.guidance.builtin.lexicon import PART_FORMS, Entry, forms_of
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.words import (
    LEGS,
    OPTIONS,
    PART_ALSO,
    PART_SYNONYMS,
    PART_WORDS,
    TRIM,
    WHOLE,
)

FOUR_LEGS = frozenset(
    """bench chair pig turtle cat dog wolf fox bear lion cow sheep elephant giraffe horse unicorn
    corgi desk deer frog""".split()
)


# Of what most of a thing is, and of its trim; the second only where there are none of the first.
WIDE = dict.fromkeys(WHOLE, ("*&",)) | dict.fromkeys(TRIM, ("+", "&"))


def may_state(noun: str, part: str) -> bool:
    """Whether a caption may state that the noun has the part, or how many of it."""
    states = OPTIONS.get(noun, ())
    return part in states or (part in LEGS and any(state in LEGS for state in states))


def as_part(entry: Entry, noun: str) -> str:
    """The name under which a thing is a part of another: a bottle's cap, a piano's keys; or ""."""
    for name in (entry.word, entry.form):
        states = [state.removeprefix("no ") for state in OPTIONS.get(noun, ())]
        if name in states or own_name(noun, name):
            return name
    return ""


def own_name(noun: str, part: str) -> str:
    """What the noun itself calls the part; "" where it has none of that name."""
    return next(iter(own_names(noun, part)), "")


def own_names(noun: str, part: str) -> list[str]:
    """All that the noun has of the part: of a chest's body the lid too."""
    looks = looks_of(noun)
    named = [name for name in _names(part) if name in looks]
    roles = WIDE.get(part, ())
    each = ([name for name, look in looks.items() if look[0] in some] for some in roles)
    return named[:1] or next(filter(None, each), [])


def is_wide(noun: str, part: str) -> bool:
    """Whether it is only a word for most of the thing, or for its trim, and no part by itself."""
    return part in WIDE and part not in looks_of(noun)


def always_has(noun: str, part: str) -> bool:
    """Whether every such thing has the part, so that stating it changes nothing."""
    if any(part == state.removeprefix("no ") for state in OPTIONS.get(noun, ())):
        return False
    if part in LEGS:
        return part == "four legs" and noun in FOUR_LEGS
    return bool(own_names(noun, part))


def _names(part: str) -> list[str]:
    """What a noun may call the part."""
    forms = forms_of(PART_WORDS.get(part, "")) + forms_of(PART_SYNONYMS.get(part, ""))
    also = forms_of(PART_ALSO.get(part, ""))
    names = [part, PART_FORMS.get(part, part), *forms, *also]
    return [form for name in names for form in (name, f"{name}s")]


def looks_of(noun: str) -> dict[str, str]:
    """The noun's parts with their looks; none where it is not known."""
    return NOUNS[noun].looks if noun in NOUNS else {}
