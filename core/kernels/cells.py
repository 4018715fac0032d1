"""The loop of :mod:`core.texture.unwrap`: which cells of a square a chart covers, and twice."""

import numpy as np

from core.kernels.compiled import compiled


@compiled
def mark(corners, mask):
    """Mark the cells that the triangles ``corners`` (F,3,2) touch; how many centres two cover.

    A cell (row, column) of ``mask`` reaches from (column, row) to one further.
    """
    height, width = mask.shape
    under = np.zeros((height, width), np.uint8)
    twice = 0
    for f in range(len(corners)):
        t = corners[f]
        low = max(0, int(np.floor(min(t[0, 1], t[1, 1], t[2, 1]))))
        high = min(height - 1, int(np.floor(max(t[0, 1], t[1, 1], t[2, 1]))))
        for row in range(low, high + 1):
            # Touched cells: the triangle's extent over the whole height of the row.
            left, right = _reach(t, float(row), row + 1.0)
            for column in range(max(0, int(np.floor(left))), min(width, int(np.floor(right)) + 1)):
                mask[row, column] = True
            # Covered centres: its extent at the row's middle, half open, so that of two neighbours
            # one has a centre on their common side.
            left, right = _reach(t, row + 0.5, row + 0.5)
            first, after = int(np.ceil(left - 0.5)), int(np.ceil(right - 0.5))
            for column in range(max(0, first), min(width, after)):
                twice += under[row, column] == 1
                # Not beyond 2: a cell counts once, however many triangles are over it.
                under[row, column] = min(2, under[row, column] + 1)
    return twice


@compiled
def _reach(t, low, high):
    """The range in x where the triangle is between two heights; (inf, -inf) if nowhere."""
    left, right = np.inf, -np.inf
    for i in range(3):
        x0, y0, x1, y1 = t[i, 0], t[i, 1], t[(i + 1) % 3, 0], t[(i + 1) % 3, 1]
        if low <= y0 <= high:
            left, right = min(left, x0), max(right, x0)
        # A level side reaches no farther than its ends.
        if y0 == y1:
            continue
        for y in (low, high):
            along = (y - y0) / (y1 - y0)
            if 0 <= along <= 1:
                x = x0 + along * (x1 - x0)
                left, right = min(left, x), max(right, x)
    return left, right
