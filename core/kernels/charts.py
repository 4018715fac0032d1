"""The loops of :mod:`core.texture.charts`."""

import heapq

import numpy as np

from core.kernels.compiled import compiled

BEND = 8.0  # how much longer a way is that leaves its chart's plane by 60 degrees


@compiled
def grow(adjacent, centre, normal, seeds, axis, least):
    """The chart of each face, the one whose seed is nearest: (F,) int64, -1 where none may reach.

    Ways go from face to face over ``adjacent`` (F,3), -1 at a border, between the ``centre`` (F,3)
    of each; one is the longer the more ``normal`` (F,3) leaves ``axis`` (C,3) of the chart, and
    none enters a face whose cosine to it is below ``least``.
    """
    chart = np.full(len(adjacent), -1, np.int64)
    # Dijkstra's algorithm from all seeds at once. Ties go by face, then chart.
    heap = [(0.0, np.int64(seeds[c]), np.int64(c)) for c in range(len(seeds))]
    heapq.heapify(heap)
    while len(heap) > 0:
        way, face, c = heapq.heappop(heap)
        # A shorter way came first; entries stay in the heap when a better one is found.
        if chart[face] >= 0:
            continue
        chart[face] = c
        for side in range(3):
            other = adjacent[face, side]
            if other < 0 or chart[other] >= 0:
                continue
            cosine, length = 0.0, 0.0
            for k in range(3):
                cosine += normal[other, k] * axis[c, k]
                length += (centre[other, k] - centre[face, k]) ** 2
            if cosine >= least:
                # 2 (1 - cosine) is 1 at 60 degrees, which BEND is given for.
                step = np.sqrt(length) * (1 + BEND * 2 * (1 - cosine))
                heapq.heappush(heap, (way + step, other, c))
    return chart
