"""Charts laid side by side in the unit square, at one scale and as large as they go.

On a square of cells, each chart at the lowest place where it fits, in the quarter turn that lies
lowest, the largest first.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from jaxtyping import Bool, Float, Int

from core.kernels.packing import lowest_place, mark, spans, take, widened

CELLS = 512  # along the square, at most
SHRINK = 0.85  # of the scale, until all charts find a place
SMALLEST = 1e-3  # of the scale that would be the best of all
HALVINGS = 6  # of what lies between a scale that fits and one that does not
SHUFFLES = 40  # orders tried for a larger scale, of MANY charts; of more, fewer
MANY = 200
STEP = 1.01  # to the next scale tried
DISORDER = 0.25  # of a shuffle: standard deviation of the logarithm of a chart's size


class Chart(NamedTuple):
    """One chart, its box's corner at the origin, its box the least of any turn."""

    uvs: Int[np.ndarray, " n"]  # which rows of uv
    at: Float[np.ndarray, "n 2"]
    corners: Int[np.ndarray, "f 3"]  # of its faces, into ``at``


class Place(NamedTuple):
    """Where a chart lies: quarter turns, then its box's corner, in cells."""

    turns: int
    row: int
    column: int
    shape: tuple[int, int]  # rows and columns of its cells before the turn


def pack(
    uv: Float[np.ndarray, "u 2"],
    face_uvs: Int[np.ndarray, "f 3"],
    chart: Int[np.ndarray, " f"],
    gap: float,
    progress: Callable[[float], None] = lambda _: None,
) -> Float[np.ndarray, "u 2"] | None:
    """``uv``, each chart moved and turned, all scaled alike; ``gap`` lies round every chart.

    ``gap`` is in parts of the square's side. None where so many charts and gaps find no room.
    """
    found = charts_of(uv, face_uvs, chart)
    space, edge = (max(1, int(np.ceil(n * gap * CELLS - 1e-6))) for n in (2, 1))
    side = CELLS - 2 * edge
    area = sum(float(triangle_areas(c.at[c.corners]).sum()) for c in found)
    size = np.array([c.at.max() for c in found])
    random = np.random.default_rng(0)

    def tried(scale: float, order: Int[np.ndarray, " c"]) -> list[tuple[Chart, Place]] | None:
        return placed([found[i] for i in order], scale, side, space)

    order = np.argsort(-size, kind="stable")
    scale = high = largest = side * min(0.9 / np.sqrt(max(area, 1e-30)), 1 / max(size.max(), 1e-15))
    while not (best := tried(scale, order)):
        high, scale = scale, SHRINK * scale
        if scale < SMALLEST * largest:
            return None
    for _ in range(HALVINGS if high > scale else 0):
        middle = (scale + high) / 2
        found_there = tried(middle, order)
        best, scale, high = (found_there, middle, high) if found_there else (best, scale, middle)
    tries = int(SHUFFLES * min(1, MANY / len(found)))
    for i in range(tries):
        progress(i / tries)
        order = np.argsort(-size * np.exp(DISORDER * random.standard_normal(len(size))))
        if better := tried(STEP * scale, order):
            best, scale = better, STEP * scale
    out = np.empty_like(uv)
    for one, place in best:
        corner = np.array([place.column, place.row]) + edge
        out[one.uvs] = (turned(one.at * scale, place) + corner) / CELLS
    return out


def charts_of(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"], chart: Int[np.ndarray, " f"]
) -> list[Chart]:
    """Each chart by itself, turned so that its box is least."""
    order = np.argsort(chart, kind="stable")
    found = []
    for faces in np.split(order, np.flatnonzero(np.diff(chart[order])) + 1):
        uvs, corners = np.unique(face_uvs[faces], return_inverse=True)
        at = in_least_box(uv[uvs])
        found.append(Chart(uvs, at, corners.reshape(-1, 3)))
    return found


def in_least_box(at: Float[np.ndarray, "n 2"], steps: int = 45) -> Float[np.ndarray, "n 2"]:
    """Turned so that the box along the axes is least, and moved to the origin."""
    angles = np.arange(steps) * (np.pi / 2 / steps)
    turns = np.stack([np.cos(angles), -np.sin(angles), np.sin(angles), np.cos(angles)], 1)
    boxes = np.stack([np.ptp(at @ t.reshape(2, 2).T, axis=0).prod() for t in turns])
    at = at @ turns[boxes.argmin()].reshape(2, 2).T
    return at - at.min(0)


def triangle_areas(corners: Float[np.ndarray, "f 3 2"]) -> Float[np.ndarray, " f"]:
    """Without sign."""
    p, q = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.abs(p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]) / 2


def placed(
    charts: list[Chart], scale: float, side: int, space: int
) -> list[tuple[Chart, Place]] | None:
    """A place for each chart on ``side`` cells, ``space`` cells apart; None where one has none."""
    taken = np.zeros((side, side), np.bool_)
    run_end = np.full((side, side), side, np.int64)
    places = []
    for one in charts:
        mask = cells_under(one.at[one.corners] * scale)
        if min(mask.shape) > side:
            return None
        lying = [np.ascontiguousarray(np.rot90(mask, turns)) for turns in range(4)]
        found = [lowest_place(taken, run_end, spans(m), *m.shape) for m in lying]
        fits = [i for i in range(4) if found[i][0] >= 0]
        if not fits:
            return None
        turns = min(fits, key=lambda i: found[i][0] + lying[i].shape[0])
        row, column = found[turns]
        take(taken, run_end, widened(lying[turns], space), row - space, column - space)
        places.append((one, Place(turns, row, column, mask.shape)))
    return places


def cells_under(corners: Float[np.ndarray, "f 3 2"]) -> Bool[np.ndarray, "h w"]:
    """The cells that a chart touches, its box's corner at the origin."""
    width, height = (int(x) + 1 for x in corners.max((0, 1)))
    mask = np.zeros((height, width), np.bool_)
    mark(corners, mask)
    return mask


def turned(at: Float[np.ndarray, "n 2"], place: Place) -> Float[np.ndarray, "n 2"]:
    """As ``np.rot90`` turns the chart's cells."""
    height, width = place.shape
    for _ in range(place.turns):
        at = np.stack([at[:, 1], width - at[:, 0]], 1)
        height, width = width, height
    return at
