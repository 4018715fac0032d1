"""A glass vessel as a thing of a composition: its parts are solids known exactly, one is hollow."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.components import Mesh
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.composition.glass.vessels import Shape
from core.guidance.builtin.constructed.solid import EDGE, ConstructedParts, ConstructedSolid
from core.guidance.builtin.palette import looks
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.stretch import training_size
from core.guidance.builtin.words.phrases.slots import Words


@dataclass(frozen=True)
class Vessel(ConstructedSolid):
    """A vessel as one solid."""

    shape: Shape = field(kw_only=True)

    def away(self, name: str, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """The signed distance from a part; the glass has a room."""
        away = super().away(name, points)
        if name != self.shape.glass:
            return away
        return torch.maximum(away, -self.shape.room.distance(points))

    def surface_of(self, one: Primitive) -> Mesh:
        """A solid's surface; the glass's is that around it and that of its room."""
        verts, faces = super().surface_of(one)
        if one is self.solids[self.shape.glass][0]:
            inner, wall = self.shape.room.mesh(EDGE)
            faces = torch.cat([faces, wall.flip(1) + len(verts)])
            verts = torch.cat([verts, inner.to(verts)])
        return verts, faces

    @cached_property
    def known(self) -> "VesselParts":
        """Its parts, each with its exact surface."""
        return VesselParts(self)


def vessel_of(words: Words, drawn: Solid, shape: Shape) -> Vessel:
    """The vessel in the place and size in which things are drawn."""
    meshes = [one.mesh(EDGE)[0] for own in shape.parts.values() for one in own]
    scale, shift = training_size(torch.cat(meshes).float())
    framed = shape.framed(scale, shift.double().numpy())
    names = tuple(looks(words.noun))
    return Vessel(drawn.net, drawn.triplane, solids=framed.parts, names=names, shape=framed)


class VesselParts(ConstructedParts):
    """The parts of a vessel."""

    def __init__(self, vessel: Vessel) -> None:
        super().__init__(vessel)
        self.loose = vessel.shape.loose

    @property
    def enclosed(self) -> Sequence[Sequence[int]]:
        """What floats in the room."""
        each = enumerate(self.components)
        names = self.solid.names
        return [[k] for k, one in each if self.loose and names[one.place.part] == self.loose]
