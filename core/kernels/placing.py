"""The loop of :mod:`core.texture.placing`: charts put one by one, as low as they go."""

import numpy as np

from core.kernels.compiled import compiled


@compiled
def place(order, sizes, first, spans, room):
    """Each chart's turn and place, as (turn, column, row); -1 for one without room.

    ``sizes`` (C,T,2): width and height in cells, of each chart in each turn. Its cells are
    ``spans[first[c * T + t] : first[c * T + t + 1]]``: rows of (row, from, to), to exclusive.
    """
    charts, turns = sizes.shape[:2]
    # The last taken cell up to each one of a row, -1 for none: a span is free where that of its
    # end is before its start.
    taken = np.full((room, room), -1, np.int32)
    found = np.full((charts, 3), -1, np.int64)
    for c in order:
        best = 4 * room * room
        for t in range(turns):
            width, height = sizes[c, t]
            own = spans[first[c * turns + t] : first[c * turns + t + 1]]
            for y in range(room - height + 1):
                x = 0
                while x <= room - width:
                    # Its middle is as low as possible, then as far to the left.
                    cost = room * (2 * y + height) + x + width
                    if cost >= best:
                        break
                    step = _blocked(taken, own, x, y)
                    if step == 0:
                        best = cost
                        found[c] = (t, x, y)
                        break
                    x += step
        if found[c, 0] < 0:
            return found
        k = c * turns + found[c, 0]
        _take(taken, spans[first[k] : first[k + 1]], found[c, 1], found[c, 2])
    return found


@compiled
def _blocked(taken, own, x, y):
    """How far to the right the first span that is not free becomes free; 0 where all are."""
    for i in range(len(own)):
        start = x + own[i, 1]
        last = taken[y + own[i, 0], x + own[i, 2] - 1]
        if last >= start:
            return last - start + 1
    return 0


@compiled
def _take(taken, own, x, y):
    for i in range(len(own)):
        row, start, end = y + own[i, 0], x + own[i, 1], x + own[i, 2]
        for column in range(start, taken.shape[1]):
            taken[row, column] = max(taken[row, column], min(column, end - 1))
