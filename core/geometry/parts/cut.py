"""Parts that something is cut out of."""

from collections.abc import Collection
from functools import cached_property

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Component, Mesh
from core.geometry.tet_grid import EXTENT
from core.geometry.tools import Tool
from core.geometry.union import joined_to_largest, less, volume

GAP = 0.05  # training units: what is farther from the rest than so falls off
CRUMB = 2e-5  # cubic training units
TOUCHED = 0.97  # of its volume, at most, what is left of a component that is cut


class CutParts(KnownParts):
    """The parts of a thing without what is inside a tool, in one connected component."""

    def __init__(
        self, whole: KnownParts, tool: Tool, spared: Collection[int], brittle: Collection[int]
    ) -> None:
        """
        Args:
            spared: parts that are not cut.
            brittle: parts whose components are whole or are left out.
        """
        super().__init__(self._distances, whole.forms)
        self.whole, self.tool, self.spared, self.brittle = whole, tool, spared, brittle

    @cached_property
    def components(self) -> list[Component]:
        """Those of which something is left."""
        return [self.whole.components[index] for index in self._left]

    def surface_of(self, index: int, exact: bool = True) -> Mesh:
        """What is left of a component's surface."""
        if exact:
            return self._left[list(self._left)[index]]
        of = list(self._left)[index]
        drawn = self._cut(of, exact=False)
        return drawn if len(drawn[1]) else self._left[of]

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances from their exact surfaces."""
        return self._without(self.whole.near(points), points)

    def without_missing(
        self, distances: Float[Tensor, "n p"], points: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n p"]:
        """Distances of the parts, far where a brittle component is left out."""
        found = distances.clone()
        for part, low, high in self._missing:
            here = ((points > low.to(points)) & (points < high.to(points))).all(1)
            found[here, part] = EXTENT
        return found

    @cached_property
    def _missing(self) -> list[tuple[int, Float[Tensor, " 3"], Float[Tensor, " 3"]]]:
        """The part of each brittle component that is left out, and the box around it."""
        found = []
        for index, component in enumerate(self.whole.components):
            part = component.place.part
            if index not in self._left and part in self.brittle:
                verts, _ = self.whole.surface_of(index)
                found.append((part, verts.amin(0) - GAP, verts.amax(0) + GAP))
        return found

    @cached_property
    def _left(self) -> dict[int, Mesh]:
        """What is left of each component, by its index in the whole; what is cut off from the
        largest piece is not."""
        cut = {}
        for index, component in enumerate(self.whole.components):
            mesh = self._cut(index, exact=True)
            if component.place.part in self.brittle and len(mesh[1]):
                whole = volume(self.whole.surface_of(index))
                if volume(mesh) < TOUCHED * whole:
                    continue
            if len(mesh[1]):
                cut[index] = mesh
        if not cut:
            return cut
        kept = joined_to_largest([*cut.values()], GAP, CRUMB)
        return {index: mesh for index, mesh in zip(cut, kept, strict=True) if len(mesh[1])}

    def _cut(self, index: int, exact: bool) -> Mesh:
        mesh = self.whole.surface_of(index, exact)
        if self.whole.components[index].place.part in self.spared:
            return mesh
        return less(mesh, (self.tool.verts, self.tool.faces))

    def _distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        return self._without(self.whole.distances(points), points)

    def _without(
        self, distances: Float[Tensor, "n p"], points: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n p"]:
        away = -self.tool.distance(points)[:, None]
        found = torch.maximum(distances, away)
        kept = list(self.spared)
        found[:, kept] = distances[:, kept]
        return found
