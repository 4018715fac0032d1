"""The size and the mass of a prompt's thing. Standard library only."""

from collections.abc import Iterable

from core.errors import UserError
from core.guidance.builtin.words.companions.glassware import usual_of_whole
from core.guidance.builtin.words.grammar.measures import set_apart
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse


def usual_of(prompt: str) -> tuple[float, float]:
    """The usual size in metres and density in kg/m³ of the thing of ``prompt``; of an unknown thing
    1 m and that of light wood. For any guidance: its prompt may be beyond the built-in words."""
    # With a noun first: "a grey rock" is a boulder only where it has to be a thing.
    for noun_needed in (True, False):
        try:
            return usual_of_whole(parse(prompt, noun_needed=noun_needed, ignore_unknown=True))
        except UserError:  # such as two nouns
            continue
    return Words().usual()


def longest_side(prompt: str, extents: Iterable[float]) -> float:
    """The longest side, in metres, of the thing of ``prompt`` with a box of the ``extents`` x, y
    and z: by the stated size, else the usual one."""
    _, sizes, _ = set_apart(prompt)
    return sizes[0].longest(extents) if sizes else usual_of(prompt)[0]
