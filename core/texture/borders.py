"""Borders between charts drawn again: short, and along the edges of the shape where there are some.

Between each two charts the least cut through a strip about their border (Katz and Tal,
"Hierarchical Mesh Decomposition Using Fuzzy Clustering and Cuts", 2003, §3.4): of the ways from one
end to the other the shortest, where a length over an edge counts less.
"""

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.sparse import csr_array
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

STRIP = 5  # faces deep on each side, at most
CHEAP = 0.1  # a length over an edge, by one over what is flat
EDGE = 0.6  # length between two normals, 35 degrees
UNITS = 1000  # of capacity, in the mean length of an edge


def shortest(
    chart: Int[np.ndarray, " f"],
    adjacent: Int[np.ndarray, "f 3"],
    corners: Float[np.ndarray, "f 3 3"],
    normal: Float[np.ndarray, "f 3"],
    allowed: Float[np.ndarray, "c 3"],
    widest: float,
) -> Int[np.ndarray, " f"]:
    """``chart`` with the shortest borders; each keeps the faces in its middle.

    Args:
        corners: places of the faces' corners.
        normal: of the faces, without ripples.
        allowed: the axis of each chart; it gets no face whose cosine to it is below ``widest``.
        widest: that cosine.
    """
    chart, cost = chart.copy(), costs(adjacent, corners, normal)
    face, side = np.nonzero(adjacent >= 0)
    pairs = np.stack([chart[face], chart[adjacent[face, side]]], 1)
    for one, other in np.unique(pairs[pairs[:, 0] < pairs[:, 1]], axis=0).tolist():
        depth = depths(chart, adjacent, one, other)
        strip = np.flatnonzero(depth >= 0)
        mine = chart[strip] == one
        # The middles stay: the deepest faces of each side, and those that look another way.
        deepest = [depth[strip[of]].max(initial=-1) for of in (mine, ~mine)]
        if min(deepest) < 1:
            continue
        fixed = depth[strip] == np.where(mine, *deepest)
        away = np.where(mine[:, None], allowed[other], allowed[one])
        fixed |= (normal[strip] * away).sum(1) < widest
        chart[strip] = np.where(cut(strip, adjacent, cost, fixed, mine), one, other)
    return chart


def costs(
    adjacent: Int[np.ndarray, "f 3"],
    corners: Float[np.ndarray, "f 3 3"],
    normal: Float[np.ndarray, "f 3"],
) -> Int[np.ndarray, "f 3"]:
    """The cost of a border along each side of each face: its length, less where it is an edge."""
    length = np.linalg.norm(np.roll(corners, -1, 1) - corners, axis=2)
    apart = np.square(normal[:, None] - normal[adjacent]).sum(2)
    weight = np.maximum(np.exp(-apart / EDGE**2), CHEAP)
    return 1 + np.round(UNITS * weight * length / max(length.mean(), 1e-30)).astype(np.int64)


def depths(
    chart: Int[np.ndarray, " f"], adjacent: Int[np.ndarray, "f 3"], one: int, other: int
) -> Int[np.ndarray, " f"]:
    """How many faces each is from the border between two charts, up to STRIP; -1 for the rest."""
    beyond = np.where(adjacent >= 0, chart[adjacent], -1)
    depth = np.full(len(chart), -1)
    for own, across in ((one, other), (other, one)):
        near = np.flatnonzero((chart == own) & (beyond == across).any(1))
        for step in range(STRIP + 1):
            depth[near] = step
            near = np.unique(adjacent[near])
            near = near[near >= 0]
            near = near[(chart[near] == own) & (depth[near] < 0)]
    return depth


def cut(
    strip: Int[np.ndarray, " n"],
    adjacent: Int[np.ndarray, "f 3"],
    cost: Int[np.ndarray, "f 3"],
    fixed: Bool[np.ndarray, " n"],
    mine: Bool[np.ndarray, " n"],
) -> Bool[np.ndarray, " n"]:
    """The faces of a strip on the first side of its least cut; ``fixed`` ones stay."""
    count = len(strip)
    place = np.full(len(adjacent), -1)
    place[strip] = np.arange(count)
    row, side = np.nonzero(adjacent[strip] >= 0)
    column = place[adjacent[strip[row], side]]
    inside = column >= 0
    row, side, column = row[inside], side[inside], column[inside]
    source, sink = count, count + 1
    ends = np.flatnonzero(fixed & mine), np.flatnonzero(fixed & ~mine)
    # Beyond all costs, and below what 32 bits hold.
    most = np.full(fixed.sum(), 1 << 29)
    rows = np.r_[row, np.full(len(ends[0]), source), ends[1]]
    columns = np.r_[column, ends[0], np.full(len(ends[1]), sink)]
    capacity = np.r_[cost[strip[row], side].clip(max=1 << 20), most].astype(np.int32)
    graph = csr_array((capacity, (rows, columns)), shape=(count + 2,) * 2)
    rest = graph - maximum_flow(graph, source, sink).flow
    rest.data[rest.data < 0] = 0
    rest.eliminate_zeros()
    reached = breadth_first_order(rest, source, return_predecessors=False)
    out = np.zeros(count + 2, np.bool_)
    out[reached] = True
    return out[:count]
