"""The loop of :mod:`core.texture.placing`: charts put one by one, as low as they go."""

import numpy as np

from core.kernels.compiled import compiled


@compiled
def place(order, sizes, first, spans, room):
    """Where each chart lies and in which turn, as (turn, column, row); of one without room -1.

    ``sizes`` (C,T,2): width and height in cells, of each chart in each turn. Its cells are
    ``spans[first[c * T + t] : first[c * T + t + 1]]``: rows of (row, from, to), to exclusive.
    """
    charts, turns = sizes.shape[:2]
    # How many cells are taken to the left of each: a span is free where both ends have the same.
    taken = np.zeros((room, room + 1), np.int32)
    found = np.full((charts, 3), -1, np.int64)
    for c in order:
        best = 4 * room * room
        for t in range(turns):
            width, height = sizes[c, t]
            own = spans[first[c * turns + t] : first[c * turns + t + 1]]
            for y in range(room - height + 1):
                for x in range(room - width + 1):
                    # Its middle lies as low as may be, then as far to the left.
                    cost = room * (2 * y + height) + x + width
                    if cost >= best:
                        break
                    if _is_free(taken, own, x, y):
                        best = cost
                        found[c] = (t, x, y)
                        break
        if found[c, 0] < 0:
            return found
        k = c * turns + found[c, 0]
        _take(taken, spans[first[k] : first[k + 1]], found[c, 1], found[c, 2])
    return found


@compiled
def _is_free(taken, own, x, y):
    for i in range(len(own)):
        row = y + own[i, 0]
        if taken[row, x + own[i, 2]] != taken[row, x + own[i, 1]]:
            return False
    return True


@compiled
def _take(taken, own, x, y):
    for i in range(len(own)):
        row, start, end = y + own[i, 0], x + own[i, 1], x + own[i, 2]
        for column in range(start, taken.shape[1] - 1):
            taken[row, column + 1] += min(column + 1, end) - start
