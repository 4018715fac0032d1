"""A closer packing than xatlas's: each chart takes the best of its quarter turns.

Charts as masks of cells, the largest first, each where its middle is lowest. xatlas turns
a chart by transposing it, which mirrors it, so it gets turns by chance (:mod:`.packing`).
"""

from typing import NamedTuple

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.ndimage import maximum_filter

from core.kernels.cells import mark
from core.kernels.placing import place

TURNS = 4  # by a quarter each


class Chart(NamedTuple):
    """One chart, its box's corner at the origin, its box the least of any turn."""

    uvs: Int[np.ndarray, " n"]  # which rows of uv
    at: Float[np.ndarray, "n 2"]
    corners: Int[np.ndarray, "f 3"]  # of its faces, into ``at``


def turned(at: Float[np.ndarray, "n 2"], turn: int) -> Float[np.ndarray, "n 2"]:
    """``at`` by so many quarter turns, its box's corner at the origin."""
    for _ in range(turn):
        at = np.stack([at[:, 1].max() - at[:, 1], at[:, 0]], 1)
    return at


class Cells(NamedTuple):
    """Charts at one scale in each of their turns: chart c in turn t is number c * TURNS + t."""

    at: list[Float[np.ndarray, "_ 2"]]
    area: Int[np.ndarray, " c"]  # in cells, the padding too
    sizes: Int[np.ndarray, "c t 2"]  # width and height, likewise
    first: Int[np.ndarray, " n"]  # where each one's rows start in ``rows``
    rows: Int[np.ndarray, "s 3"]
    padding: int


def cells_of(found: list[Chart], scale: float, padding: int) -> Cells:
    """The cells that charts take at ``scale`` cells a unit, with ``padding`` cells round each."""
    at = [turned(one.at * scale, turn) for one in found for turn in range(TURNS)]
    corners = [one.corners for one in found for _ in range(TURNS)]
    masks = [mask_of(*one, padding) for one in zip(at, corners, strict=True)]
    sizes = np.array([mask.shape[::-1] for mask in masks]).reshape(len(found), TURNS, 2)
    rows = [spans_of(mask) for mask in masks]
    first = np.cumsum([0, *map(len, rows)])
    area = np.array([mask.sum() for mask in masks[::TURNS]])
    return Cells(at, area, sizes, first, np.concatenate(rows), padding)


def placed(
    cells: Cells, room: int, random: np.random.Generator
) -> list[Float[np.ndarray, "_ 2"]] | None:
    """Where each chart's uv are in a square of ``room`` cells a side, in cells.

    The padding may be outside of the square. None: they do not fit. ``random`` varies the order.
    """
    factor = random.uniform(0.8, 1.25, len(cells.area))
    order = np.argsort(-cells.area * factor, kind="stable")
    side = room + 2 * cells.padding  # the square with the padding about it
    where = place(order, cells.sizes, cells.first, cells.rows, side)
    if (where < 0).any():
        return None
    return [
        cells.at[chart * TURNS + turn] + (x, y) for chart, (turn, x, y) in enumerate(where.tolist())
    ]


def mask_of(
    at: Float[np.ndarray, "n 2"], corners: Int[np.ndarray, "f 3"], padding: int
) -> Bool[np.ndarray, "h w"]:
    """The cells that a chart touches, and ``padding`` cells round them."""
    width, height = np.floor(at.max(0)).astype(int) + 1
    mask = np.zeros((height + 2 * padding, width + 2 * padding), np.bool_)
    mark(at[corners] + padding, mask)
    return maximum_filter(mask.view(np.uint8), 2 * padding + 1, mode="constant").view(np.bool_)


def spans_of(mask: Bool[np.ndarray, "h w"]) -> Int[np.ndarray, "s 3"]:
    """The runs of a mask's rows, as (row, from, to)."""
    edges = np.diff(np.pad(mask, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, start = np.nonzero(edges == 1)
    _, end = np.nonzero(edges == -1)
    return np.stack([row, start, end], 1)
