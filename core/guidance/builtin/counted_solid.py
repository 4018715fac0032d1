"""A drawn solid with another number of some of its parts' components: five candles, not three."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.parts.balls import Ball
from core.geometry.parts.components import Component, Distances
from core.geometry.parts.counted import Copy, Recount, recounted
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.stretch import Vector, frame_of

ROOM = 0.08  # training units, around a component: within it its own distance is known
EDGE = 0.01  # training units, around a part of a component
INSIDE = EXTENT - 0.01  # of the cube, where a copy may be


@dataclass(frozen=True)
class Moved:
    """One part's components that are replaced, and where the copies are."""

    part: int
    verts: Float[np.ndarray, "v 3"]  # of all of the part's components
    owner: Int[np.ndarray, " v"]  # the component of each vertex
    replaced: tuple[int, ...]
    boxes: Mapping[int, tuple[Tensor, Tensor]]
    copies: tuple[Copy, ...]
    balls: Mapping[int, Ball]
    cut: frozenset[int] = frozenset()  # sources that are only parts of components

    def distance(
        self, drawn: Float[Tensor, " n"], points: Float[Tensor, "n 3"], known: Distances
    ) -> Float[Tensor, " n"]:
        """The part's distances at points; ``drawn``: those of what is drawn."""
        found = drawn.clone()
        tree = KDTree(self.verts)
        near = drawn < ROOM
        if near.any():
            _, nearest = tree.query(points[near].cpu().numpy())
            gone = np.isin(self.owner[nearest], self.replaced)
            values = found[near]
            values[torch.from_numpy(gone)] = ROOM
            found[near] = values
        for copy in self.copies:
            local = copy.into(points)
            low, high = self.boxes[copy.source]
            beyond = torch.maximum(low - local, local - high).clamp_min(0).norm(dim=1)
            here = (beyond < ROOM).nonzero().squeeze(1)
            away = ROOM + beyond
            if ball := self.balls.get(copy.source):
                away[here] = ball.distance(local[here])
            elif len(here):
                own = known(local[here])[:, self.part]
                _, nearest = tree.query(local[here].cpu().numpy())
                mine = torch.from_numpy(self.owner[nearest] == copy.source)
                away[here] = torch.where(mine, own, own.clamp_min(ROOM))
                if copy.source in self.cut:  # a leg below a frame is no wider above
                    out = torch.maximum(low - local, local - high)[here].amax(1) - EDGE
                    away[here] = torch.maximum(away[here], out)
            found = torch.minimum(found, away * copy.least)
        return found


@dataclass(frozen=True)
class CountedSolid(Solid):
    """A solid with copies of its components in their places, or fewer of them."""

    moved: tuple[Moved, ...] = ()
    unfit: tuple[int, ...] = ()  # parts without so many as are stated
    zoom: float = 1.0  # of all, about ``middle``, after the copies are placed
    middle: Vector = (0.0, 0.0, 0.0)

    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """Each part's signed distance."""
        inner = points / self.zoom + points.new_tensor(self.middle)
        found = super().distances(inner)
        for one in self.moved:
            found[:, one.part] = one.distance(found[:, one.part], inner, super().distances)
        return found * self.zoom

    def framing(self, verts: Float[Tensor, "v 3"]) -> "CountedSolid":
        """As of any solid; the copies keep their places in it."""
        center, (by, *_) = frame_of(verts)
        x, y, z = (old + at / self.zoom for old, at in zip(self.middle, center, strict=True))
        return replace(self, zoom=self.zoom * by, middle=(x, y, z))

    def drawn_alone(self) -> Solid:
        """The solid as it was drawn."""
        return Solid(self.net, self.triplane, self.frame, self.swell, self.absent)

    def _placed(self, local: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        return (super()._placed(local) - local.new_tensor(self.middle)) * self.zoom


def counted_solid(
    solid: Solid, components: list[Component], counts: Mapping[int, int]
) -> CountedSolid:
    """The solid with so many components of each part, where that is possible."""
    moved: list[Moved] = []
    unfit = []
    for part, count in counts.items():
        found = recounted(solid.distances, components, part, count)
        if found is None or not _is_within(components, found):
            unfit.append(part)
        else:
            moved += _moved(components, found)
    drawn = solid.net, solid.triplane, solid.frame, solid.swell, solid.absent
    return CountedSolid(*drawn, tuple(moved), tuple(unfit))


def _is_within(components: list[Component], found: Recount) -> bool:
    """Whether all copies are in the cube."""
    drawn = dict(enumerate(components)) | dict(found.apart)
    verts = {k: one.verts for k, one in drawn.items()}
    verts |= {k: ball.points() for k, ball in found.balls.items()}
    each = (copy.out(verts[copy.source]) for copy in found.copies)
    return all(float(one.abs().max()) < INSIDE for one in each)


def _moved(components: list[Component], found: Recount) -> list[Moved]:
    """The replaced components and the copies, by part."""
    made = []
    for part in dict.fromkeys(copy.part for copy in found.copies):
        own = {k: one for k, one in enumerate(components) if one.place.part == part}
        own |= {k: one for k, one in found.apart.items() if one.place.part == part}
        own = {k: one for k, one in own.items() if len(one.verts)}
        gone = tuple(k for k in found.replaced if k in own)
        verts = np.concatenate([one.verts.numpy() for one in own.values()])
        owner = np.concatenate([np.full(len(one.verts), k) for k, one in own.items()])
        boxes = {k: _box(one.verts) for k, one in own.items()}
        boxes |= {k: _box(ball.points()) for k, ball in found.balls.items()}
        copies = tuple(copy for copy in found.copies if copy.part == part)
        made.append(
            Moved(part, verts, owner, gone, boxes, copies, found.balls, frozenset(found.apart))
        )
    return made


def _box(points: Float[Tensor, "n 3"]) -> tuple[Float[Tensor, " 3"], Float[Tensor, " 3"]]:
    return points.amin(0), points.amax(0)
