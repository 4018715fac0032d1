"""The areas of a drawn solid, each of one colour: its parts, and the colours of a patterned part.

Γ learns colours from pictures of 64², where a border between two areas is a pixel or two wide, 6 %
of the object. The areas themselves are known in space, so a texel near a border takes the material
from a little farther inside its own area, and the border is as sharp as the texture.
"""

from collections.abc import Callable
from typing import NamedTuple

import torch
import torch.nn.functional as F
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.patterns import Margins
from core.guidance.guidance import Area
from core.ops import across

CELLS = 80  # of the lattice on which the parts are known, along an edge
INSET = 0.06  # training units: width of a picture's blur
STEPS = 3  # on the way; each searches the border again
UNCLEAR = 2.5  # cells: depths that differ by less are ambiguous on the lattice
FLUSH = 0.015  # training units
ALONG = 0.9  # cosine between two parallel surfaces
TAP = 0.003  # training units
LEAST_SLOPE = 1e-3  # of the margin: below it no border is near
STEEPEST = 3.0  # largest slope of a margin, the difference of two distances

Field = Callable[
    [Float[Tensor, "n 3"]], tuple[Float[Tensor, " n"], Float[Tensor, "n a"]]
]  # signed distance and how deep in each area, at points
Heights = Callable[
    [Float[Tensor, "n 3"], Int[Tensor, " n"]], Float[Tensor, " n"]
]  # how far the surface stands out of the solid's, at points of areas; training units


class AreaFields(NamedTuple):
    """An object's areas in space."""

    drawn: Field
    near: Field  # the same, exact near the surface
    each: tuple[Area, ...]  # their properties by the words and by nature
    heights: Heights


def depths(distances: Callable[[Tensor], Tensor], parts: int) -> Field:
    """The field of the first ``parts`` parts, from all parts' distances."""

    def at(points: Float[Tensor, "n 3"]) -> tuple[Float[Tensor, " n"], Float[Tensor, "n a"]]:
        found = distances(points)
        return found.amin(1), -found[:, :parts]

    return at


def patterned(field: Field, margins: "list[Margins | None]") -> Field:
    """The field of the areas from that of the parts: one for each part, or one for each colour of
    the part's pattern."""

    def at(points: Float[Tensor, "n 3"]) -> tuple[Float[Tensor, " n"], Float[Tensor, "n a"]]:
        distance, depths = field(points)
        areas = []
        for depth, margin in zip(depths.T, margins, strict=True):
            inside = margin(points) if margin else torch.zeros_like(depth)[:, None]
            areas.append(depth[:, None] + inside.clamp_max(0))
        return distance, torch.cat(areas, 1)

    return at


class SolidAreas:
    """The areas of one solid, on a lattice of their depths."""

    def __init__(
        self,
        field: Field,
        each: tuple[Area, ...],
        near: Field | None = None,
        heights: Heights | None = None,
        cells: int = CELLS,
    ) -> None:
        """
        Args:
            each: the properties of the areas by the words and by nature.
            near: the field that distinguishes them near the borders; None: ``field``.
            heights: None: all is level.
        """
        self.each, self.field, self.near, self.heights = each, field, near or field, heights
        self.spacing = 2 * EXTENT / cells
        side = torch.linspace(-EXTENT, EXTENT, cells + 1)
        nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)
        distance, depths = field(nodes.view(-1, 3))
        self.sizes = (depths > 0).sum(0)  # nodes
        values = torch.cat([distance[:, None], depths], 1)
        # grid_sample's first coordinate runs along the last axis.
        self.values = values.T.view(-1, cells + 1, cells + 1, cells + 1).permute(0, 3, 2, 1)[None]

    def nearest(self) -> Int[Tensor, "k k k"]:
        """The area of each node of the lattice."""
        return self.values[0, 1:].argmax(0).permute(2, 1, 0)

    def of(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """The area of each point."""
        return self.certain(points, 0.0)[0]

    def certain(
        self, points: Float[Tensor, "n 3"], reach: float
    ) -> tuple[Int[Tensor, " n"], Bool[Tensor, " n"]]:
        """The area of each point, and whether it is surely that of all within ``reach``."""
        depths = self._at(points)[:, 1:]
        area = depths.argmax(1)
        clear = torch.ones_like(area, dtype=torch.bool)
        if depths.shape[1] == 1:
            return area, clear
        near = _second(depths) < max(UNCLEAR * self.spacing, 2 * reach)
        if near.any():
            area[near], margin = self._owner(points[near])
            clear[near] = margin >= max(FLUSH, 2 * reach)  # a margin is of two distances
        return area, clear

    def inside(self, points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]) -> Float[Tensor, "n 3"]:
        """The points; near a border, places along the surface ``INSET`` from the border, each in
        its ``area``."""
        start = self._at(points)
        if start.shape[1] == 2:  # no border
            return points
        moved, level = points.clone(), start[:, 0]
        here = (self._over(start, area)[:, 0] < STEEPEST * INSET).nonzero().squeeze(1)
        for step in range(STEPS):  # of the points that are near a border
            place, mine = moved[here], area[here]
            margin, slope, normal = self._margin(place, mine)
            slope = slope - (slope * normal).sum(1, keepdim=True) * normal  # along the surface
            steep = slope.norm(dim=1, keepdim=True)
            way = (INSET - margin[:, None] / steep.clamp_min(LEAST_SLOPE)).clamp(0, INSET)
            go = ((way > 0) & (steep > LEAST_SLOPE))[:, 0]
            here = here[go]
            to = place[go] + (way * slope / steep)[go] / (STEPS - step)
            # Back to the distance from the surface that the point had.
            moved[here] = to - (self._at(to)[:, :1] - level[here, None]) * normal[go]
        return moved

    def slope(
        self,
        points: Float[Tensor, "n 3"],
        normals: Float[Tensor, "n 3"],
        area: Int[Tensor, " n"],
        step: float,
    ) -> Float[Tensor, "n 3"]:
        """See :class:`Areas`: near a border, in areas that are not level."""
        found, depths = torch.zeros_like(points), self._at(points)[:, 1:]
        if self.heights is None or depths.shape[1] == 1:
            return found
        uneven = area.new_tensor([not one.level for one in self.each]).bool()[area]
        here = ((_second(depths) < UNCLEAR * self.spacing) & uneven).nonzero().squeeze(1)
        place, mine = points[here], area[here]
        for way in across(normals[here]):
            up, down = (self.heights(place + by * way, mine) for by in (step, -step))
            found[here] += ((up - down) / (2 * step))[:, None] * way
        return found

    def _owner(self, points: Float[Tensor, "n 3"]) -> tuple[Int[Tensor, " n"], Float[Tensor, " n"]]:
        """The area whose exact surface each point is on, and how much deeper the point is in it
        than in any other. A smaller area drawn there replaces it where its surface runs along the
        exact one, no deeper below it than the error of the drawn one: a pane in a wall, but not an
        eye that stands out of a head."""
        exact = self.near(points)[1]
        first, second = exact.topk(2, 1)
        owner, margin = second[:, 0].clone(), first[:, 0] - first[:, 1]
        close = margin < FLUSH  # where another one may be the right one
        place, mine = points[close], owner[close]
        other = self.field(place)[1].argmax(1)
        under = first[close, 0] - exact[close].gather(1, other[:, None])[:, 0]
        smaller = self.sizes[other] < self.sizes[mine]  # a wheel's rim is not the body's
        flush = (under < FLUSH) & smaller
        flush[flush.clone()] = self._along(place[flush], mine[flush], other[flush])
        owner[close] = torch.where(flush, other, mine)
        return owner, margin

    def _along(
        self, points: Float[Tensor, "n 3"], one: Int[Tensor, " n"], other: Int[Tensor, " n"]
    ) -> Bool[Tensor, " n"]:
        """Whether the exact surfaces of two areas are parallel at each point."""
        if not len(points):
            return torch.zeros(0, dtype=torch.bool)
        taps = TAP * torch.cat([torch.eye(3), -torch.eye(3)]).to(points)
        around = torch.stack([self.near(points + tap)[1] for tap in taps])  # (6, n, a)
        slopes = (around[:3] - around[3:]).movedim(0, 2)  # (n, a, 3)
        rows = torch.arange(len(points))
        return F.cosine_similarity(slopes[rows, one], slopes[rows, other], dim=1) > ALONG

    def _margin(
        self, points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]
    ) -> tuple[Float[Tensor, " n"], Float[Tensor, "n 3"], Float[Tensor, "n 3"]]:
        """How much deeper the area is than the others, the gradient of that margin, and the
        surface's normal; by central differences."""
        taps = torch.eye(3).to(points) * self.spacing
        here = self._over(self._at(points), area)
        ahead = [self._over(self._at(points + tap), area) for tap in taps]
        behind = [self._over(self._at(points - tap), area) for tap in taps]
        slopes = torch.stack(ahead, 1) - torch.stack(behind, 1)  # (n, 3, 2)
        slope = slopes / (2 * self.spacing)
        normal = F.normalize(slope[..., 1], dim=1)
        return here[:, 0], slope[..., 0], normal

    @staticmethod
    def _over(values: Float[Tensor, "n c"], area: Int[Tensor, " n"]) -> Float[Tensor, "n 2"]:
        """The area's margin over the deepest other one, and the distance."""
        depths = values[:, 1:]
        own = depths.gather(1, area[:, None])
        others = depths.scatter(1, area[:, None], -torch.inf).amax(1, keepdim=True)
        return torch.cat([own - others, values[:, :1]], 1)

    def _at(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n c"]:
        """Distance and depths, trilinear."""
        at = (points / EXTENT)[None, None, None]
        found = F.grid_sample(self.values, at, align_corners=True, padding_mode="border")
        return found[0, :, 0, 0].T


def _second(depths: Float[Tensor, "n a"]) -> Float[Tensor, " n"]:
    """How much deeper each point is in its own area than in the next."""
    first, second = depths.topk(2, 1).values.T
    return first - second
