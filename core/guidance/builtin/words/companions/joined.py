"""The words of a thing with those of its companions. Standard library only."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from core.guidance.builtin.words.companions.fit import Found
from core.guidance.builtin.words.companions.known_as import CLOTHING, FITTED
from core.guidance.builtin.words.grammar.accents import Accent
from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up
from core.guidance.builtin.words.grammar.part_names import owns
from core.guidance.builtin.words.phrases.poses import pose_of
from core.guidance.builtin.words.phrases.slots import Companion, Words
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.words import SHAPES

SUITS = re.compile(r"\b(?:suit|tuxedo)\b", re.IGNORECASE)
SHAPED = tuple(f": made {shape}." for shape in SHAPES)
ITS_SIZE = ("times its usual size.", "the size of a grown one.")


def with_companions(words: Words, found: Iterable[Found]) -> Words:
    """The thing with these companions, and their notes."""
    found = list(found)
    companions = tuple(Companion(one.relation, _matched(words, one), one.verb) for one in found)
    words = replace(words, accents=(*words.accents, *_of_suits(words, found)))
    does = (pose_of(words.noun, one.verb)[0] for one in found)
    words = replace(words, pose=words.pose or next(filter(None, does), ""))
    notes = (_about(note, one.words.noun) for one in companions for note in one.words.notes)
    left_out = (word for one in companions for word in one.words.left_out)
    return replace(
        words,
        companions=companions,
        notes=tuple(dict.fromkeys((*words.notes, *notes))),
        left_out=tuple(dict.fromkeys((*words.left_out, *left_out))),
    )


def _of_suits(words: Words, found: Iterable[Found]) -> Iterator[Accent]:
    """The trousers of a worn suit, for a wearer with other ones."""
    if words.is_statue:
        return
    stated = {words.target, *(accent.part for accent in words.accents)}
    for one in found:
        suit = one.relation == "wears" and one.words.noun == "jacket" and SUITS.search(one.phrase)
        if suit and owns(words.noun, "trousers") and "trousers" not in stated:
            other = one.words
            pattern = (other.pattern, other.second, other.second_form) if other.pattern else ()
            yield Accent("trousers", other.color, other.color_form, "", "", "", *pattern)


def _matched(first: Words, found: Found) -> Words:
    """Companions of a statue have its material, unless one is stated."""
    words = found.words
    if found.relation == "wears" and words.noun in FITTED:  # it is as large as its wearer
        notes = tuple(note for note in words.notes if not note.endswith((*ITS_SIZE, *SHAPED)))
        scale = 1.0 if words.noun in CLOTHING else words.scale  # "huge wings"
        words = replace(words, scale=scale, size=None, shape="", notes=notes)
    joined = found.relation in ("wears", "holds") or is_creature(words.noun)
    if not (first.is_statue and joined) or _states_look(found.phrase):
        return words
    form = first.material_form
    plain = {"color": "", "color_form": "", "second": "", "second_form": "", "target": ""}
    of = {"material": first.material, "material_form": form, "accents": ()}
    return replace(words, is_statue=True, **plain, **of)


def _states_look(phrase: str) -> bool:
    """Whether it names a colour or a material: a tuxedo is black by itself."""
    return phrase.split() != without_look(phrase).split()


def without_look(phrase: str) -> str:
    """The phrase without the colours and materials that it names."""
    entries = {word: look_up(word.lower(), SLOTS) for word in phrase.split()}
    looks = {word for word, one in entries.items() if one and one.slot in ("color", "material")}
    return " ".join(word for word in phrase.split() if word not in looks)


def _about(note: str, noun: str) -> str:
    """A note on a companion, which would be taken for the first thing otherwise."""
    return note.replace(": made ", f": the {noun} is made ") if note.endswith(ITS_SIZE) else note
