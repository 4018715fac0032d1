"""The place of a text or a shape on a thing: the largest nearly even rectangle that faces the
front, a side or up."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy import ndimage
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.geometry.tet_grid import EXTENT

CELLS = 72  # of the picture of a thing, along an edge
SAMPLES = 240_000  # places of its surface
ABOUT = 0.9  # of the largest side: a rectangle as large and nearer to the middle replaces it
HOLES = 0.05  # usual fraction of a rectangle that may be uneven
FACING = 0.55  # least cosine between the direction and a place's normal
ASIDE = 0.9  # loss of a rectangle's worth at a thing's edge
SMALL = 0.06  # fraction of the seen area: nothing is written on a smaller part
STEP = 0.3  # largest step in depth from a cell to the next, training units


class Way(NamedTuple):
    """A direction from which a thing is seen."""

    to: tuple[int, int]  # the axis towards the eye, and its side
    right: tuple[int, int]
    up: tuple[int, int]
    worth: float  # of a place there, where the prompt names no side


WAYS = {
    "front": Way((1, -1), (0, 1), (2, 1), 1.0),
    "side": Way((0, 1), (1, 1), (2, 1), 0.45),  # the other side is its mirror
    "top": Way((2, 1), (0, 1), (1, 1), 0.4),
    "back": Way((1, 1), (0, -1), (2, 1), 0.0),
}


class Window(NamedTuple):
    """A rectangle on a thing."""

    part: int  # the one that most of it is on
    way: Way
    middle: tuple[float, float]  # along the axes to the right and up
    half: float  # of its height, training units
    behind: float  # along ``way.to``: the plane that limits its depth
    wide: float = 1.0  # times as wide as high

    def at(self, points: Float[Tensor, "p 3"]) -> Float[Tensor, "p 2"]:
        """Positions of places in the window, from its middle in its halves; seen from the side, on
        both sides."""
        (axis, side), (u, way_u), (v, way_v) = self.way.to, self.way.right, self.way.up
        mirrored = points[:, axis].sign() * side if axis == 0 else 1.0
        right = (points[:, u] - self.middle[0]) * way_u * mirrored
        up = (points[:, v] - self.middle[1]) * way_v
        return torch.stack([right, up], 1) / self.half

    def before(self, points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
        """How far in front of the window's back plane places are."""
        axis, side = self.way.to
        toward = points[:, axis].abs() if axis == 0 else points[:, axis] * side
        return toward - self.behind


class Seen(NamedTuple):
    """A thing seen from one direction, in cells with the proportions of what is drawn on it."""

    part: Int[np.ndarray, "r c"]  # -1: none, or one that faces elsewhere
    near: Float[np.ndarray, "r c"]  # towards the eye
    wide: float  # of a cell, training units

    def covered(self, window: Window) -> Bool[np.ndarray, "r c"]:
        """The cells in a window of the same direction."""
        rows, columns = self.part.shape
        u = (np.arange(columns) + 0.5 - columns / 2) * self.wide - window.middle[0]
        v = (np.arange(rows) + 0.5) * (2 * EXTENT / CELLS) - EXTENT - window.middle[1]
        here = np.abs(u) < window.half * window.wide, np.abs(v) < window.half
        return here[1][:, None] & here[0]


def window_on(
    parts: KnownParts,
    worth: Sequence[float],
    wide: float,
    asked: str = "",
    taken: Sequence[Window] = (),
    holes: float = HOLES,
) -> Window | None:
    """The best window for content ``wide`` times as wide as high; None without one.

    Args:
        worth: by part, the worth of a place on it; 0: never there.
        asked: one of ``WAYS``; "": any but the back.
        taken: windows in use.
        holes: the fraction of it that may be uneven.
    """
    surface = surface_places(parts)
    found = []
    for name, way in WAYS.items():
        if (name == asked) if asked else way.worth:
            seen = _seen(*surface, way, wide)
            for other in taken:
                if other.way == way:
                    seen.part[seen.covered(other)] = -1
            found += _windows(seen, way, np.array(worth), holes)
    return max(found, key=lambda one: one[0])[1] if found else None


@lru_cache(2)
def surface_places(
    parts: KnownParts,
) -> tuple[Float[np.ndarray, "n 3"], Float[np.ndarray, "n 3"], Int[np.ndarray, " n"]]:
    """Places on the exact surfaces of all components, their normals and parts."""
    import trimesh  # takes half a second; needed only for things with emblems

    meshes = [
        trimesh.Trimesh(*parts.surface_of(k), process=False) for k in range(len(parts.components))
    ]
    whole = sum(mesh.area for mesh in meshes)
    found, normals, of = [], [], []
    for component, mesh in zip(parts.components, meshes, strict=True):
        count = max(int(SAMPLES * mesh.area / whole), 1)
        places, faces = trimesh.sample.sample_surface(mesh, count, seed=0)[:2]
        found.append(places)
        normals.append(mesh.face_normals[faces])
        of.append(np.full(len(places), component.place.part))
    return np.concatenate(found), np.concatenate(normals), np.concatenate(of)


def _seen(places: np.ndarray, normals: np.ndarray, of: np.ndarray, way: Way, wide: float) -> Seen:
    """The places nearest to the eye."""
    (axis, side), (u, _), (v, _) = way.to, way.right, way.up
    toward, cell = places[:, axis] * side, 2 * EXTENT / CELLS
    columns = int(np.ceil(CELLS / wide)) + 2
    column = np.floor(places[:, u] / (cell * wide) + columns / 2).astype(int)
    row = np.floor((places[:, v] + EXTENT) / cell).astype(int)
    # A bent solid may leave the cube.
    here = (row >= 0) & (row <= CELLS) & (column >= 0) & (column < columns)
    row, column, toward, normals, of = (x[here] for x in (row, column, toward, normals, of))
    index = row * columns + column
    order = np.lexsort((toward, index))
    last = order[np.append(np.diff(index[order]) > 0, True)]
    part, near = np.full((CELLS + 1) * columns, -1), np.full((CELLS + 1) * columns, -np.inf)
    part[index[last]] = np.where(normals[last, axis] * side > FACING, of[last], -1)
    near[index[last]] = toward[last]
    return Seen(part.reshape(-1, columns), near.reshape(-1, columns), cell * wide)


def _windows(
    seen: Seen, way: Way, worth: Float[np.ndarray, " k"], holes: float
) -> "list[tuple[float, Window]]":
    """The largest windows on all parts and on those of the most worth, each with its worth."""
    cell, found = 2 * EXTENT / CELLS, []
    fraction = np.bincount(seen.part[seen.part >= 0], minlength=len(worth)) / max(
        (seen.part >= 0).sum(), 1
    )
    worth = np.where(fraction >= SMALL, worth, 0.0)  # knobs and buttons
    of_cell = np.where(seen.part >= 0, worth[seen.part], 0.0)
    center = seen.part.shape[1] / 2  # the column of the middle
    for least in np.unique(worth[worth > 0]):
        mask = of_cell >= least
        near, far = np.where(mask, seen.near, -np.inf), np.where(mask, seen.near, np.inf)
        step = ndimage.maximum_filter(near, 3) - ndimage.minimum_filter(far, 3)
        size, (top, left) = largest_square(mask & (step < STEP), holes)
        if not size:
            continue
        here = np.s_[top : top + size, left : left + size]
        on = seen.part[here][mask[here]]
        pure = np.bincount(on).max() / len(on)
        across = (left + size / 2 - center) * seen.wide
        middle = across, (top + size / 2) * cell - EXTENT
        behind = float(seen.near[here][mask[here]].min()) - cell
        part, wide = int(np.bincount(on).argmax()), seen.wide / cell
        window = Window(part, way, middle, size * cell / 2, behind, wide)
        aside = abs(left + size / 2 - center) / (mask.any(0).sum() / 2)
        even = pure * (1 - ASIDE * min(aside, 1))
        found.append(((way.worth or 1.0) * worth[on].mean() * size * even, window))
    return found


def largest_square(
    mask: Bool[np.ndarray, "r c"], holes: float = HOLES
) -> tuple[int, tuple[int, int]]:
    """The side of about the largest square that is nearly all True, and its first row and column;
    of squares ``ABOUT`` as large, the one nearest to the middle."""
    before = np.pad(mask.astype(int).cumsum(0).cumsum(1), ((1, 0), (1, 0)))

    def squares(side: int) -> Bool[np.ndarray, "n m"]:
        a, b = before[:-side, :-side], before[:-side, side:]
        c, d = before[side:, :-side], before[side:, side:]
        return d - b - c + a >= (1 - holes) * side * side

    sides = [side for side in range(1, min(mask.shape) + 1) if squares(side).any()]
    if not sides:
        return 0, (0, 0)
    most = max(round(ABOUT * sides[-1]), sides[0])
    side = max(one for one in sides if one <= most)
    places = np.stack(squares(side).nonzero(), 1)
    away = np.abs(places + side / 2 - np.array(mask.nonzero()).mean(1) - 0.5).sum(1)
    top, left = places[away.argmin()]
    return side, (int(top), int(left))
