"""A thing that is put together from simple solids, which are known exactly: it is not drawn."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import cast

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.lattice import Lattice
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Component, Mesh, Place
from core.geometry.parts.forms import Forms
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.sizes import Changed, changed, groups
from core.guidance.builtin.palette import looks
from core.guidance.builtin.solid import FAR, Solid
from core.guidance.builtin.solid_net import PARTS, SolidNet, Triplane
from core.guidance.builtin.stretch import STRETCH, frame_of
from core.guidance.builtin.words.phrases.slots import Words

EDGE = 0.05  # training units: of the meshes' flat faces
ERROR = 0.02  # training units
ALONG_SHORTEST = {"thick": 1.4, "thin": 0.62, "round": 1.4}  # times: a plump animal is wide
NOTHING = Triplane([], [], torch.zeros(1, 0), torch.zeros(1, 2, dtype=torch.bool))  # is asked


@dataclass(frozen=True)
class ConstructedSolid(Solid):
    """Simple solids by part of its noun, training units."""

    solids: Mapping[str, Sequence[Primitive | Changed]] = field(kw_only=True)
    names: tuple[str, ...] = field(kw_only=True)  # of the noun's parts

    @torch.no_grad()
    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """Each part's signed distance."""
        far = torch.full_like(points[:, 0], FAR)
        columns = [self.away(n, points) if self.solids.get(n) else far for n in self.names]
        return torch.stack([*columns, *[far] * (PARTS - len(columns))], 1)

    def away(self, name: str, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """The signed distance from the part of that name."""
        scale, center = (points.new_tensor(of) for of in (self.frame.scale, self.frame.center))
        local = points / scale + center
        each = torch.stack([one.distance(local) for one in self.solids[name]])
        return each.amin(0) * min(self.frame.scale)

    def surface_of(self, one: Primitive | Changed) -> Mesh:
        """A solid's surface."""
        verts, faces = one.mesh(EDGE)
        return self._placed(verts), faces

    def stretched(self, adjective: str) -> "ConstructedSolid":
        """The thing stretched for an adjective, in the training's place and size; a thick, a thin
        or a round one along its shortest side."""
        factors = list(STRETCH[adjective][0])
        if by := ALONG_SHORTEST.get(adjective):
            verts = self.mesh[0]
            shortest = int((verts.amax(0) - verts.amin(0)).argmin())
            factors = [by if axis == shortest else 1.0 for axis in range(3)]
        x, y, z = factors
        frame = frame_of(self.mesh[0], (x, y, z))
        return replace(self, frame=frame)

    def sized(self, sizes: Mapping[str, tuple[float, float]]) -> "ConstructedSolid":
        """With parts in another size, in the training's place and size: how many times as large
        each is, and of that how many times as long."""
        there = {name: by for name, by in sizes.items() if self.solids.get(name)}
        others = len([name for name in self.solids if self.solids[name]])
        if not there or others < 2:
            return self
        made = {name: changed(self.solids, name, *by, EDGE) for name, by in there.items()}
        solid = replace(self, solids={**self.solids, **made})
        return cast(ConstructedSolid, solid.framing(solid.mesh[0]))

    @cached_property
    def known(self) -> "ConstructedParts":
        """Its parts, each with its exact surface."""
        return ConstructedParts(self)

    @cached_property
    def mesh(self) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
        """The surfaces of all its solids."""
        meshes = [self.known.surface_of(k) for k in range(len(self.known.components))]
        starts = np.cumsum([0, *(len(verts) for verts, _ in meshes)])
        faces = [f + int(start) for (_, f), start in zip(meshes, starts, strict=False)]
        return torch.cat([verts for verts, _ in meshes]).float(), torch.cat(faces)

    @cached_property
    def part_of_mesh(self) -> Int[Tensor, " v"]:
        """The part of each vertex of its mesh."""
        each = self.known.components
        return torch.cat([torch.full((len(one.verts),), one.place.part) for one in each])


class ConstructedParts(KnownParts):
    """The parts of such a thing."""

    def __init__(self, solid: ConstructedSolid) -> None:
        self.solid = solid
        count = len(solid.names)
        super().__init__(solid.distances, Forms((0.0,) * count, ((0.0,) * count,) * 3))

    @cached_property
    def components(self) -> list[Component]:
        """Each solid of each part."""
        each = enumerate(self.solid.names)
        return [
            self._component(k, one) for k, name in each for one in self.solid.solids.get(name, ())
        ]

    def _component(self, part: int, one: Primitive | Changed) -> Component:
        verts, faces = self.solid.surface_of(one)
        ends = [end.double().numpy() for end in (verts.amin(0), verts.amax(0))]
        here = Place(part, *ends, lambda points: torch.zeros(len(points), dtype=torch.bool))
        lattice = Lattice(np.zeros((1, 1, 1)), ends[0], EDGE)
        return Component(here, verts.float(), faces, lattice, ERROR)

    def surface_of(self, index: int, exact: bool = True) -> Mesh:
        """A solid's surface."""
        del exact  # it is, always
        component = self.components[index]
        return component.verts, component.faces

    def component_boxes(self) -> list[list[Float[Tensor, "2 3"]]]:
        """Of each part those of what hangs together: solids whose boxes meet are one."""
        return [_joined(own) for own in super().component_boxes()]

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances."""
        return self.solid.distances(points)[:, : len(self.solid.names)]


def solid_of_parts(
    words: Words, net: SolidNet, parts: Mapping[str, Sequence[Primitive]]
) -> ConstructedSolid:
    """These parts of the noun as a solid, without the absent ones."""
    there = {name: own for name, own in parts.items() if name not in words.absent}
    solid = ConstructedSolid(net, NOTHING, solids=there, names=tuple(looks(words.noun)))
    return solid.stretched(words.shape) if words.shape else solid


def _joined(boxes: Sequence[Float[Tensor, "2 3"]]) -> list[Float[Tensor, "2 3"]]:
    """The boxes around those that meet."""
    if not boxes:
        return []
    low, high = torch.stack(list(boxes)).unbind(1)
    group = groups(boxes)
    each = (group == k for k in range(int(group.max()) + 1))
    return [torch.stack([low[own].amin(0), high[own].amax(0)]) for own in each]
