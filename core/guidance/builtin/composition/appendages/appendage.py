"""Appendages as things of a composition: grown on the first one, or made by themselves."""

from collections.abc import Sequence

from core.guidance.builtin.composition.appendages.mount import Mount
from core.guidance.builtin.composition.appendages.shapes import SHAPES, joined_alone
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.constructed.shapes import Parts, of_training_size
from core.guidance.builtin.constructed.solid import solid_of_parts
from core.guidance.builtin.words.companions.search import Relation

SIZES = (0.6, 1.6)  # of the usual size, at least and at most


def grown(
    things: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation]
) -> tuple[list[Thing], list[Body]]:
    """The things with the appendages of the first one in their places on it."""
    things, bodies = list(things), list(bodies)
    mount: Mount | None = None
    for k, how in enumerate(relations, 1):
        words, solid = things[k].words, things[k].solid
        if how != "wears" or words.noun not in SHAPES or solid is None:
            continue
        mount = mount or Mount.of(bodies[0])
        factor = min(max(words.scale**0.5, SIZES[0]), SIZES[1])
        parts = SHAPES[words.noun](mount.times(factor))
        own = solid_of_parts(words, solid.net, parts)
        things[k], bodies[k] = things[k].with_solid(own), Body.of(words, own)
    return things, bodies


def solids_of(noun: str) -> Parts:
    """The solids of appendages of nothing, joined, in the place and size in which things are
    drawn."""
    mount = Mount.alone()
    return of_training_size(joined_alone(SHAPES[noun](mount), mount))
