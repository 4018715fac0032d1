"""The surface cut into charts: connected regions that each look one way, as few as possible.

Regions grow from seeds, the seeds move to their regions' middles, and so on ("Variational Shape
Approximation", Cohen-Steiner et al. 2004), with ways along the surface for the distance, so that
charts are compact; then neighbours are joined where both still look one way. The directions are
those of the surface without its finest ripples: how many charts there are depends on the shape,
not on how finely it is cut up.
"""

import heapq

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components

from core.geometry.faces import areas_and_normals, neighbours, unit
from core.kernels.charts import grow
from core.texture.borders import shortest

SMOOTHING = 12  # rounds, each over the faces next to a face
SIMILAR = 0.6  # length between two normals, 35 degrees: of an edge, not of a ripple
ACROSS = 0.03  # weight of what looks anywhere else: noise has no edges
WIDEST = 0.34  # least cosine between a face and its chart: 70 degrees
ONE_WAY = 0.5  # least length of the mean of a chart's normals, for it to be the chart's axis
ROUNDS = 8  # of growing from better seeds
STRAIGHTENING = 4  # rounds
LARGEST = 0.2  # of the surface: larger ones sprawl and leave room between them
LARGEST_JOINED = 0.12


def charts(verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]) -> Int[np.ndarray, " f"]:
    """The chart of each face, 0 and up without gaps. The same mesh gives the same charts."""
    adjacent = neighbours(faces)
    area, normal = areas_and_normals(verts, faces)
    # Never 0: a chart of empty faces only would have no mean.
    area = np.maximum(area, 1e-6 * area.mean() + 1e-30)
    normal = smooth(normal, area, adjacent)
    chart = grown(adjacent, verts[faces].mean(1), normal, area)
    # Straightening may part a chart: each component becomes a chart.
    chart = components(straightened(chart, adjacent, normal), adjacent)
    chart = merged(chart, adjacent, normal, area)
    axis = unit(sums(chart, normal, area))
    chart = shortest(chart, adjacent, verts[faces], normal, axis, WIDEST)
    return components(chart, adjacent)


def smooth(
    normal: Float[np.ndarray, "f 3"],
    area: Float[np.ndarray, " f"],
    adjacent: Int[np.ndarray, "f 3"],
) -> Float[np.ndarray, "f 3"]:
    """Normals averaged over the faces around, by area, SMOOTHING times; hardly across edges.

    Jones et al., "Non-Iterative, Feature-Preserving Mesh Smoothing", 2003: what looks elsewhere
    counts less.
    """
    count = len(adjacent)
    face, side = np.nonzero(adjacent >= 0)
    rows, columns = np.r_[face, np.arange(count)], np.r_[adjacent[face, side], np.arange(count)]
    for _ in range(SMOOTHING):
        # Each face is among its own neighbours: one without any keeps its normal.
        apart = np.square(normal[rows] - normal[columns]).sum(1)
        weight = area[columns] * np.maximum(np.exp(-apart / SIMILAR**2), ACROSS)
        normal = unit(csr_array((weight, (rows, columns)), shape=(count, count)) @ normal)
    return normal


def grown(
    adjacent: Int[np.ndarray, "f 3"],
    centre: Float[np.ndarray, "f 3"],
    normal: Float[np.ndarray, "f 3"],
    area: Float[np.ndarray, " f"],
) -> Int[np.ndarray, " f"]:
    """Charts grown from seeds in their middles; what no seed may reach gets seeds of its own."""
    chart = with_rest(np.full(len(adjacent), -1, np.int64), adjacent)
    for _ in range(ROUNDS):
        # Each round: cut what sprawls, find new seeds, and grow all charts again.
        chart = halved(chart, np.bincount(chart, area) > LARGEST * area.sum(), adjacent, centre)
        weight = np.bincount(chart, area)[:, None]
        middle, axis = sums(chart, centre, area) / weight, sums(chart, normal, area) / weight
        # The factor is 1.1 to 3.1: never 0, so that the distance always counts.
        away = np.square(centre - middle[chart]).sum(1) * (2.1 - (normal * axis[chart]).sum(1))
        # Sorted by chart and then by ``away``: the first face of each chart is its seed.
        order = np.lexsort((away, chart))
        seeds = order[np.flatnonzero(np.r_[True, np.diff(chart[order]) != 0])]
        # A chart that closes on itself has no mean direction; it takes its seed's.
        one_way = np.linalg.norm(axis, axis=1, keepdims=True) > ONE_WAY
        axis = np.where(one_way, unit(axis), normal[seeds])
        chart = with_rest(grow(adjacent, centre, normal, seeds, axis, WIDEST), adjacent)
    return chart


def sums(
    chart: Int[np.ndarray, " f"], values: Float[np.ndarray, "f 3"], area: Float[np.ndarray, " f"]
) -> Float[np.ndarray, "c 3"]:
    """The sum over each chart's faces, weighted by area."""
    return np.stack([np.bincount(chart, area * x) for x in values.T], 1)


def with_rest(
    chart: Int[np.ndarray, " f"], adjacent: Int[np.ndarray, "f 3"]
) -> Int[np.ndarray, " f"]:
    """Faces without a chart get new ones, one for each connected component."""
    rest = chart < 0
    new = chart.copy()
    new[rest] = chart.max() + 1 + components(chart, adjacent)[rest]
    return np.unique(new, return_inverse=True)[1].reshape(-1)


def components(
    chart: Int[np.ndarray, " f"], adjacent: Int[np.ndarray, "f 3"]
) -> Int[np.ndarray, " f"]:
    """A number for each connected component of a chart."""
    face, side = np.nonzero(adjacent >= 0)
    other = adjacent[face, side]
    same = chart[face] == chart[other]
    ends = face[same], other[same]
    graph = coo_array((np.ones(len(ends[0]), np.int8), ends), shape=(len(chart),) * 2)
    return connected_components(graph, directed=False)[1].astype(np.int64)


def straightened(
    chart: Int[np.ndarray, " f"], adjacent: Int[np.ndarray, "f 3"], normal: Float[np.ndarray, "f 3"]
) -> Int[np.ndarray, " f"]:
    """Borders without teeth: a face goes over to the chart of two of its neighbours."""
    for _ in range(STRAIGHTENING):
        # Borders get three different numbers, so that two of them are no majority.
        around = np.where(adjacent >= 0, chart[adjacent], -1 - np.arange(3))
        a, b, c = around.T
        two = np.where(a == b, a, np.where(b == c, b, np.where(a == c, c, chart)))
        near = adjacent[np.arange(len(chart)), (around == two[:, None]).argmax(1)]
        similar = (normal * normal[near]).sum(1) > WIDEST
        chart = np.where((two >= 0) & similar, two, chart)
    return chart


def merged(
    chart: Int[np.ndarray, " f"],
    adjacent: Int[np.ndarray, "f 3"],
    normal: Float[np.ndarray, "f 3"],
    area: Float[np.ndarray, " f"],
) -> Int[np.ndarray, " f"]:
    """Neighbours made one where both keep within WIDEST of one axis, the longest border first."""
    order = np.argsort(chart, kind="stable")
    # Faces by chart, and the borders in a heap: the longest comes first.
    faces_of = dict(enumerate(np.split(order, np.flatnonzero(np.diff(chart[order])) + 1)))
    border, largest = borders(chart, adjacent), LARGEST_JOINED * area.sum()
    heap = [(-n, a, b) for a in border for b, n in border[a].items() if a < b]
    heapq.heapify(heap)
    while heap:
        count, a, b = heapq.heappop(heap)
        if border.get(a, {}).get(b) != -count:
            continue  # of charts that are joined already
        both = np.concatenate([faces_of[a], faces_of[b]])
        axis = area[both] @ normal[both]
        # Multiplied, not divided, by the axis' length: it may be 0.
        turned_away = (normal[both] @ axis).min() < WIDEST * np.linalg.norm(axis)
        if turned_away or area[both].sum() > largest:
            continue
        faces_of[a] = both
        del faces_of[b]
        # b's borders become a's; a border to the same third chart is now one.
        for c, n in border.pop(b).items():
            del border[c][b]
            if c != a:
                border[a][c] = border[c][a] = border[a].get(c, 0) + n
        # Entered again at their new lengths; the old entries are skipped above.
        for c, n in border[a].items():
            heapq.heappush(heap, (-n, min(a, c), max(a, c)))
    for label, found in enumerate(faces_of.values()):
        chart[found] = label
    return chart


def borders(
    chart: Int[np.ndarray, " f"], adjacent: Int[np.ndarray, "f 3"]
) -> dict[int, dict[int, int]]:
    """For each chart, the edges that it shares with each other."""
    face, side = np.nonzero(adjacent >= 0)
    pair = np.stack([chart[face], chart[adjacent[face, side]]], 1)
    unique, count = np.unique(pair[pair[:, 0] != pair[:, 1]], axis=0, return_counts=True)
    border: dict[int, dict[int, int]] = {int(c): {} for c in np.unique(chart)}
    for (a, b), n in zip(unique.tolist(), count.tolist(), strict=True):
        border[a][b] = n
    return border


def halved(
    chart: Int[np.ndarray, " f"],
    these: Bool[np.ndarray, " c"],
    adjacent: Int[np.ndarray, "f 3"],
    centre: Float[np.ndarray, "f 3"],
) -> Int[np.ndarray, " f"]:
    """The charts ``these`` cut across their longest sides; what falls apart is a chart each."""
    chart = chart.copy()
    for one in np.flatnonzero(these):
        faces = np.flatnonzero(chart == one)
        away = centre[faces] - centre[faces].mean(0)
        # eigh sorts ascending: the last vector is the direction of the largest spread.
        along = away @ np.linalg.eigh(away.T @ away)[1][:, -1]
        chart[faces[along > np.median(along)]] = chart.max() + 1
    return components(chart, adjacent)
