"""The loops of :mod:`core.texture.packing`: charts as rows of cells, laid on a square of cells."""

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
            left, right = _reach(t, float(row), row + 1.0)
            for column in range(max(0, int(np.floor(left))), min(width, int(np.floor(right)) + 1)):
                mask[row, column] = True
            left, right = _reach(t, row + 0.5, row + 0.5)
            first, after = int(np.ceil(left - 0.5)), int(np.ceil(right - 0.5))
            for column in range(max(0, first), min(width, after)):
                twice += under[row, column] == 1
                under[row, column] = min(2, under[row, column] + 1)
    return twice


@compiled
def _reach(t, low, high):
    """From where to where in x the triangle lies between two heights; nowhere is (inf, -inf)."""
    left, right = np.inf, -np.inf
    for i in range(3):
        x0, y0, x1, y1 = t[i, 0], t[i, 1], t[(i + 1) % 3, 0], t[(i + 1) % 3, 1]
        if low <= y0 <= high:
            left, right = min(left, x0), max(right, x0)
        if y0 == y1:
            continue
        for y in (low, high):
            share = (y - y0) / (y1 - y0)
            if 0 <= share <= 1:
                x = x0 + share * (x1 - x0)
                left, right = min(left, x), max(right, x)
    return left, right


@compiled
def widened(mask, by):
    """The cells at most ``by`` away along either axis; the mask grows by as much on every side."""
    height, width = mask.shape
    wide = np.zeros((height + 2 * by, width + 2 * by), np.bool_)
    for row in range(height):
        until = -1  # the first column that this row does not reach
        for column in range(width):
            if mask[row, column]:
                for x in range(max(column, until), column + 2 * by + 1):
                    wide[row, x] = True
                until = column + 2 * by + 1
    out = np.zeros_like(wide)
    for column in range(width + 2 * by):
        until = 0
        for row in range(height):
            if wide[row, column]:
                for y in range(max(row, until), row + 2 * by + 1):
                    out[y, column] = True
                until = row + 2 * by + 1
    return out


@compiled
def spans(mask):
    """The runs of marked cells: (row, first, after), the longest first."""
    found = []
    height, width = mask.shape
    for row in range(height):
        column = 0
        while column < width:
            if mask[row, column]:
                first = column
                while column < width and mask[row, column]:
                    column += 1
                found.append((row, first, column))
            column += 1
    out = np.empty((len(found), 3), np.int64)
    for i in range(len(found)):
        out[i] = found[i]
    return out[np.argsort(out[:, 1] - out[:, 2])]


@compiled
def lowest_place(taken, run_end, rows, height, width):
    """The lowest (row, column) where a chart of this size, its ``rows``, meets no taken cell.

    ``run_end``: for each cell the first column after it that is not as it is. (-1, -1): nowhere.
    """
    side = len(taken)
    for y in range(side - height + 1):
        x = 0
        while x <= side - width:
            step = 0
            for i in range(len(rows)):
                row, first, after = y + rows[i, 0], x + rows[i, 1], x + rows[i, 2]
                if taken[row, first]:
                    step = run_end[row, first] - first
                    break
                block = run_end[row, first]
                if block < after:
                    step = run_end[row, block] - first
                    break
            if step == 0:
                return y, x
            x += step
    return -1, -1


@compiled
def take(taken, run_end, mask, y, x):
    """Mark the cells of ``mask``, laid at (y, x); what lies outside is cut off."""
    side = len(taken)
    for row in range(max(0, -y), min(mask.shape[0], side - y)):
        for column in range(max(0, -x), min(mask.shape[1], side - x)):
            if mask[row, column]:
                taken[y + row, x + column] = True
        end = side
        for column in range(side - 1, -1, -1):
            if column + 1 < side and taken[y + row, column] != taken[y + row, column + 1]:
                end = column + 1
            run_end[y + row, column] = end
