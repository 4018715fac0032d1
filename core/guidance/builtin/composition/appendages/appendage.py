"""Appendages as things of a composition: grown on the first one, or made by themselves."""

from collections.abc import Mapping, Sequence

import torch

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.composition.appendages.mount import Mount
from core.guidance.builtin.composition.appendages.shapes import SHAPES, joined_alone
from core.guidance.builtin.composition.exact import EDGE, ExactSolid
from core.guidance.builtin.composition.placing.placement import Body, training_size
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.palette import looks
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.words.companions.search import Relation
from core.guidance.builtin.words.phrases.slots import Words

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
        own = _exact(words, solid, SHAPES[words.noun](mount.times(factor)))
        things[k], bodies[k] = things[k].with_solid(own), own.body(words)
    return things, bodies


def alone(words: Words, drawn: Solid) -> ExactSolid:
    """The appendages of nothing."""
    return _exact(words, drawn, solids_of(words.noun))


def solids_of(noun: str) -> Mapping[str, Sequence[Primitive]]:
    """The solids of appendages of nothing, joined, in the place and size in which things are
    drawn."""
    mount = Mount.alone()
    meshes = [one.mesh(EDGE)[0] for own in _joined(noun, mount).values() for one in own]
    scale, shift = training_size(torch.cat(meshes).float())
    return _joined(noun, mount.moved(scale, shift.double().numpy()))


def _joined(noun: str, mount: Mount) -> Mapping[str, Sequence[Primitive]]:
    return joined_alone(SHAPES[noun](mount), mount)


def _exact(words: Words, drawn: Solid, parts: Mapping[str, Sequence[Primitive]]) -> ExactSolid:
    return ExactSolid(drawn.net, drawn.triplane, solids=parts, names=tuple(looks(words.noun)))
