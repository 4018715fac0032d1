"""Whether the thing that a phrase names may accompany a prompt's first thing, and how.

Standard library only.
"""

import re
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.words.companions import known_as
from core.guidance.builtin.words.companions.known_as import is_dressed
from core.guidance.builtin.words.grammar.findings import with_article
from core.guidance.builtin.words.grammar.lexicon import Entry
from core.guidance.builtin.words.grammar.openers import Relation, ends_in_name, named_in
from core.guidance.builtin.words.grammar.part_names import (
    as_part,
    is_asked,
    is_wide,
    is_within,
    owns,
)
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.living import is_animal, is_creature
from core.guidance.builtin.words.tables.part_tables import OPTIONS, WITH_PARTS

_PLACING = ("on", "in")  # a thing has one of these
USING = ("using", "uses")
# Done with a thing in one's hands or under one's feet, or next to it: "playing" a flute or a piano.
BY_IT_TOO = ("playing", "plays", "play", "eating", "eats", "reading", "reads", *USING)
BY_IT_TOO += ("hugging", "hugs", "embracing", "lifting", "swinging")
BY_IT_TOO += ("jumping", "jumps", "leaping", "leaps", "bounding", "vaulting", "hopping")
_DRIVING = ("driving", "drives", "drive")
_PEDESTAL = re.compile(r"\bpedestal$", re.IGNORECASE)  # a table's is its leg


class Found(NamedTuple):
    """A companion, as written and as parsed."""

    relation: Relation
    phrase: str
    words: Words
    verb: str = ""  # the activity of the first thing


class Read(NamedTuple):
    """A parsed phrase: the entry of its thing, and its words."""

    entry: Entry
    words: Words
    stated: str = ""  # the words for its count


Reader = Callable[[str], Read | None]  # None: the phrase is refused, or names no thing


def standing_in(read: Reader) -> Reader:
    """The reader, with the nearest known thing for a few things that others stand on: a log for a
    perch."""

    def of(phrase: str) -> Read | None:
        got = read(phrase)
        for rule, name in known_as.STAND_INS.items() if got is None else ():
            instead = re.sub(rf"\b{rule}$", name, phrase.strip(), flags=re.IGNORECASE)
            if instead != phrase.strip() and (other := read(instead)):
                noun = with_article("noun", other.words.noun)
                said = re.search(rf"\b{rule}$", phrase.strip(), flags=re.IGNORECASE)
                note = f"{said[0] if said else phrase}: made as {noun}."
                return other._replace(words=replace(other.words, notes=(note, *other.words.notes)))
        return got

    return of


def fitting(
    read: Reader,
    relation: Relation,
    phrase: str,
    first: str,
    found: list[Found],
    verb: str = "",
    weak: bool = False,
) -> Found | None:
    """The companion that the phrase names, if the first thing may have it so, in addition to
    ``found``."""
    if verb in _DRIVING and named_in(phrase) in known_as.CONTAINERS:
        relation = "in"
    is_worn = not weak or relation == "in"  # "in boots", not "with boots"
    if relation == "in":
        relation = known_as.as_meant(named_in(phrase))
    if relation in _PLACING and any(one.relation in _PLACING for one in found):
        return None
    no_place = known_as.is_no_place(phrase) and not known_as.is_rack(first, phrase)
    if relation in _PLACING and no_place:
        return None
    if relation == "in":
        phrase = known_as.as_container(phrase)
    grows = named_in(phrase) in APPENDAGES
    if weak and relation == "wears" and not (is_dressed(first) or grows):
        return None
    if "one leg" in OPTIONS.get(first, ()) and _PEDESTAL.search(phrase):
        return None
    got = read(phrase)
    of_another = " ".join(WITH_PARTS.get(first, {}).values()).split()
    if got and got.entry.form in of_another:  # "a horse with wings": a pegasus
        return None
    if got and got.entry.form == "horn" and is_creature(first) and not owns(first, "horn"):
        got = read(re.sub(r"horn$", "unicorn horn", phrase))
    if got is None or got.entry.form in known_as.GROWN:
        return None
    other, words = got.words.noun, got.words
    if weak and relation == "wears" and other not in known_as.WORN:  # "a girl with a kite"
        meant = known_as.has_with(first, got.entry.form, other)
        if meant is None or not ends_in_name(phrase, other):
            return None
        relation = meant
    heaped = words.count > 1 and words.order != "row"
    if relation == "in" and words.order == "heap":  # "in a pile of leaves"
        relation = "on"
    if verb in USING and is_animal(first):  # its mouth would be in it
        relation = "beside"
    if relation == "holds" and other in known_as.ON_BACKS:
        relation = "wears"
    hats = [one for one in found if one.relation == "wears" and one.words.noun in known_as.HEADWEAR]
    if relation == "wears" and other in known_as.HEADWEAR and hats:  # one has one head
        return None
    # Another kind of hat replaces its own; "a hat" does not.
    own = owns(first, other) or owns(first, got.entry.form)  # a mushroom's cap
    another = relation == "wears" and other in known_as.HEADWEAR and not own
    kind, _, of = got.entry.form.rpartition(" ")  # "an angel with bat wings", "a dog with cat ears"
    another |= other in APPENDAGES and bool(kind) and bool(of) and kind != first
    added = relation == "wears" and known_as.is_put_on(first, other)
    # "With white socks" is of a horse's legs, and "wearing socks" of its clothes.
    added = added or (relation == "wears" and is_worn and is_asked(first, got.entry.form))
    flies = relation == "on" and other == known_as.BROOM  # and not on what it sweeps with
    if not (another or added or flies) and is_part(got.entry, first):
        return None
    is_so = {
        "on": lambda: known_as.may_bear(other, first, heaped),
        "in": lambda: known_as.may_contain(other, first),
        "wears": lambda: known_as.may_wear(first, other),
        "holds": lambda: (
            is_dressed(first) and first not in known_as.NO_HANDS and known_as.is_held(other, verb)
        ),
        "bears": lambda: other not in known_as.HUNG and first not in known_as.NO_BEARERS,
        "beside": lambda: other != first,
        "around": lambda: other != first,
    }
    fits = relation not in is_so or is_so[relation]()
    if relation in ("holds", "on") and verb in BY_IT_TOO and not fits and is_dressed(first):
        relation, fits = "beside", other != first
    elif verb and relation == "beside":
        fits &= is_dressed(first)
    if relation == "around" and other == "log":
        relation = "on"
    if relation == "around" and not known_as.may_coil(first, other):
        notes = (f"{with_article('noun', first)} keeps its own form: the {other} is next to it.",)
        relation, words = "beside", replace(words, notes=(*words.notes, *notes))
    if relation in ("wears", "holds"):
        words = _only_one(words, got.stated)
    return Found(relation, phrase, words, verb) if fits else None


def _only_one(words: Words, stated: str) -> Words:
    """Reduce a worn or held thing to one."""
    notes = [f"{stated}: one thing is made at a time."] if stated and words.count > 1 else []
    return replace(words, count=1, order="row", notes=(*words.notes, *notes))


def is_part(entry: Entry, first: str) -> bool:
    """Whether the other thing is a part that the first has anyway: a knight's sword."""
    part = as_part(entry, first) and not is_wide(first, entry.form)
    # A cactus has a pot of its own, whatever it is of.
    return bool(part) or owns(first, entry.form.split()[-1]) or is_within(first, entry.form)
