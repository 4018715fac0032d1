"""A glass vessel as a thing of a composition: its parts are solids known exactly, one is hollow."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.lattice import Lattice
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Component, Place
from core.geometry.parts.forms import Forms
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.composition.glass.vessels import Shape
from core.guidance.builtin.composition.placing.placement import Body, training_size
from core.guidance.builtin.palette import looks
from core.guidance.builtin.solid import FAR, Solid
from core.guidance.builtin.solid_net import PARTS
from core.guidance.builtin.words.phrases.slots import Words

EDGE = 0.05  # training units: of the meshes' flat faces
ERROR = 0.02  # training units


@dataclass(frozen=True)
class Vessel(Solid):
    """A vessel as one solid."""

    shape: Shape = field(kw_only=True)
    names: tuple[str, ...] = field(kw_only=True)  # of the noun's parts

    @torch.no_grad()
    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """Each part's signed distance."""
        far = torch.full_like(points[:, 0], FAR)
        columns = [self._away(name, points) if self._has(name) else far for name in self.names]
        return torch.stack([*columns, *[far] * (PARTS - len(columns))], 1)

    def _has(self, name: str) -> bool:
        return bool(self.shape.parts.get(name))

    def _away(self, name: str, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        away = torch.stack([one.distance(points) for one in self.shape.parts[name]]).amin(0)
        if name != self.shape.glass:
            return away
        return torch.maximum(away, -self.shape.room.distance(points))

    @cached_property
    def known(self) -> "VesselParts":
        """Its parts, each with its exact surface."""
        return VesselParts(self)

    def body(self, words: Words) -> Body:
        """As placing needs to know it."""
        meshes = [self.known.surface_of(k) for k in range(len(self.known.components))]
        starts = np.cumsum([0, *(len(verts) for verts, _ in meshes)])
        of = [one.place.part for one in self.known.components]
        part = [torch.full((len(v),), k) for k, (v, _) in zip(of, meshes, strict=True)]
        faces = [f + int(start) for (_, f), start in zip(meshes, starts, strict=False)]
        verts = torch.cat([verts for verts, _ in meshes]).float()
        body = Body(words, verts, torch.cat(faces), torch.cat(part))
        size = words.size
        longest = size.longest(body.sides.tolist()) if size else words.usual()[0]
        return replace(body, metres=longest / body.longest)


def vessel_of(words: Words, drawn: Solid, shape: Shape) -> Vessel:
    """The vessel in the place and size in which things are drawn."""
    meshes = [one.mesh(EDGE)[0] for own in shape.parts.values() for one in own]
    scale, shift = training_size(torch.cat(meshes).float())
    framed = shape.framed(scale, shift.double().numpy())
    return Vessel(drawn.net, drawn.triplane, shape=framed, names=tuple(looks(words.noun)))


class VesselParts(KnownParts):
    """The parts of a vessel. The surface of the glass is that around it and that of its room."""

    def __init__(self, vessel: Vessel) -> None:
        self.vessel = vessel
        count = len(vessel.names)
        super().__init__(vessel.distances, Forms((0.0,) * count, ((0.0,) * count,) * 3))

    @cached_property
    def components(self) -> list[Component]:
        """Each solid of each part."""
        each = enumerate(self.vessel.names)
        shape = self.vessel.shape
        return [self._component(k, one) for k, name in each for one in shape.parts.get(name, ())]

    def _component(self, part: int, one: Primitive) -> Component:
        verts, faces = one.mesh(EDGE)
        glass = self.vessel.shape.parts.get(self.vessel.shape.glass)
        if glass and one is glass[0]:
            inner, wall = self.vessel.shape.room.mesh(EDGE)
            faces = torch.cat([faces, wall.flip(1) + len(verts)])
            verts = torch.cat([verts, inner.to(verts)])
        ends = [end.double().numpy() for end in (verts.amin(0), verts.amax(0))]
        here = Place(part, *ends, lambda points: torch.zeros(len(points), dtype=torch.bool))
        lattice = Lattice(np.zeros((1, 1, 1)), ends[0], EDGE)
        return Component(here, verts.float(), faces, lattice, ERROR)

    @property
    def enclosed(self) -> Sequence[Sequence[int]]:
        """What floats in the room."""
        loose = self.vessel.shape.loose
        return [
            [k]
            for k, one in enumerate(self.components)
            if loose and self.vessel.names[one.place.part] == loose
        ]

    def surface_of(self, index: int, exact: bool = True) -> tuple[Tensor, Tensor]:
        """A solid's surface."""
        del exact  # it is, always
        component = self.components[index]
        return component.verts, component.faces

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances."""
        return self.vessel.distances(points)[:, : len(self.vessel.names)]
