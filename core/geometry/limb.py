"""The sphere sweep that a piece is: fitted along the way between its farthest ends.

The way inside that keeps farthest from the surface is the first guess of the curve; then by least
squares (:mod:`core.geometry.fitting`), for as few stops as will do.
"""

import itertools

import numpy as np
from jaxtyping import Float
from scipy.optimize import least_squares
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, dijkstra

from core.geometry.lattice import Lattice
from core.geometry.pieces import Piece, points_of
from core.geometry.primitives import Points, Primitive
from core.geometry.sphere_sweep import Stops, bends, distance, samples

STOPS = (4, 6, 8)  # as many as are tried
# Errors in the mean: before it is fitted, at most; with which fewer stops will do; no more would.
AT_FIRST, NEAR, FAR = 0.7, 0.06, 0.45
GAIN = 0.9  # of the error with fewer stops, at most
LONG = 1.5  # times as long as wide, at least
SLICE = 1.5  # cells
AWAY, WIDER = 1.5, 3.0  # radii that a stop moves, times that its radius changes, at most
EVEN = 10.0  # errors for stops that are not as far apart as others, of a whole way between
SOFT = 0.3  # errors, beyond which a point counts less
EVALUATIONS = 25
TIGHT = 0.95  # of a fold
# To half of a node's neighbours.
STEPS = [s for s in itertools.product((-1, 0, 1), repeat=3) if s > (0, 0, 0)]


def limb(piece: Piece) -> Primitive | None:
    """The sphere sweep that is nearest to the piece; None for what is hardly longer than wide, or
    no such thing at first sight."""
    way, points, error = middle_way(piece.lattice), points_of(piece), piece.error
    length = np.linalg.norm(np.diff(way[:, :3], axis=0), axis=1).sum()
    if length < LONG * 2 * np.median(way[:, 3]):
        return None
    if swept(spaced(way, STOPS[-1])).off(points, error) > AT_FIRST:
        return None
    best = None
    for count in STOPS:
        one = _fitted(points, spaced(way, count), error)
        if bends(samples(one.lengths.reshape(-1, 4))).max() > TIGHT:
            continue
        if best is not None and one.off(points, error) > GAIN * best.off(points, error):
            continue
        best = one
        if not NEAR < best.off(points, error) < FAR:
            break
    return best


def swept(stops: Stops) -> Primitive:
    """Through these stops."""
    return Primitive("limb", np.zeros(3), np.zeros(3), stops.ravel())


def middle_way(lattice: Lattice) -> Stops:
    """The middles of the slices that are as far, inside, from the end that is farthest from
    another; and their radii, as of discs (a level set diagram: Lazarus and Verroust 1999)."""
    inside = np.pad(lattice.values < 0, 1)
    number = np.full(inside.shape, -1)
    number[inside] = np.arange(inside.sum())
    pairs, lengths = [], []
    for step in STEPS:
        beside = np.roll(number, [-s for s in step], (0, 1, 2))
        both = (number >= 0) & (beside >= 0)
        pairs.append(np.stack([number[both], beside[both]]))
        lengths.append(np.full(both.sum(), np.linalg.norm(step)))
    count = int(inside.sum())
    graph = coo_array((np.concatenate(lengths), np.concatenate(pairs, 1)), (count,) * 2).tocsr()
    label = connected_components(graph, directed=False)[1]
    far = np.where(label == np.bincount(label).argmax(), 0.0, np.inf)
    for _ in range(3):
        far = dijkstra(
            graph, directed=False, indices=int(np.where(np.isfinite(far), far, -1).argmax())
        )
    mine = np.isfinite(far)
    slices = max(int(far[mine].max() / SLICE), 2)
    which = np.minimum((far[mine] / far[mine].max() * slices).astype(int), slices - 1)
    nodes = np.bincount(which, minlength=slices)
    places = np.argwhere(inside[1:-1, 1:-1, 1:-1])[mine]
    middles = np.stack([np.bincount(which, c, slices) / nodes.clip(1) for c in places.T], 1)
    radii = np.sqrt(nodes / (far[mine].max() / slices) / np.pi)
    way = np.c_[middles * lattice.cell + lattice.low, radii * lattice.cell]
    return way[nodes > 0]


def spaced(way: Stops, count: int) -> Stops:
    """So many stops as far apart along the way; the first and the last as far inside as it is
    thick there."""
    length = np.linalg.norm(np.diff(way[:, :3], axis=0), axis=1)
    at = np.concatenate([[0.0], length.cumsum()])
    quarter = at[-1] / 4
    ends = [
        max(np.interp(k * quarter, at, way[:, 3]) for k in (a, b))
        for a, b in ((0.3, 0.6), (3.4, 3.7))
    ]
    first, last = (min(0.7 * end, quarter) for end in ends)
    where = np.linspace(first, at[-1] - last, count)
    return np.stack([np.interp(where, at, column) for column in way.T], 1)


def _fitted(points: Points, stops: Stops, error: float) -> Primitive:
    def of(x: Float[np.ndarray, " k"]) -> Stops:
        found = x.reshape(-1, 4).copy()
        found[:, 3] = np.exp(found[:, 3])
        return found

    def residuals(x: Float[np.ndarray, " k"]) -> Float[np.ndarray, " r"]:
        found = of(x)
        gaps = np.linalg.norm(np.diff(found[:, :3], axis=0), axis=1)
        off = distance(points, samples(found)) / error
        return np.concatenate([off, EVEN * (gaps / gaps.mean() - 1)])

    first = np.c_[stops[:, :3], np.log(stops[:, 3:])].ravel()
    reach = np.c_[np.repeat(AWAY * stops[:, 3:], 3, 1), np.full(len(stops), np.log(WIDER))].ravel()
    solved = least_squares(
        residuals,
        first,
        bounds=(first - reach, first + reach),
        loss="soft_l1",
        f_scale=SOFT,
        max_nfev=EVALUATIONS,
    )
    return swept(of(solved.x))


def paired(pieces: list[Piece]) -> list[Piece]:
    """The pieces, with a sweep that is about another's mirror image across x = 0 exactly so."""
    made, limbs = list(pieces), [k for k, p in enumerate(pieces) if is_limb(p)]
    for first, second in itertools.combinations(limbs, 2):
        one, other = pieces[first], pieces[second]
        if one.place.part != other.place.part or made[second] is not other:
            continue
        stops = one.primitive.lengths.reshape(-1, 4) * (-1, 1, 1, 1)
        mirrored = swept(stops)
        if mirrored.fits(points_of(other), other.error):
            made[second] = other._replace(primitive=mirrored)
    return made


def is_limb(piece: Piece) -> bool:
    """Whether the piece is a sphere sweep."""
    return piece.primitive is not None and piece.primitive.form == "limb"
