"""Parts that are the same all around an axis, made exactly so: a mug's body, a car's wheels.

In the half plane through the axis every vertex of such a part lies on one curve, the profile, next
to vertices from all around. Each goes to the mean of these along its normal (the projection of
Alexa et al., "Computing and Rendering Point Set Surfaces", 2003, in that half plane): lumps go, and
what the profile has stays. Lengths are in cells of the lattice that the mesh comes from.
"""

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree
from scipy.spatial.distance import cdist
from torch import Tensor

from core.geometry.faces import normals_of, unit
from core.geometry.mesh import mean_around

# Of a part's surface that the families have the same all around: a square seat has 0.76.
ROUND = 0.92
UPRIGHT = 0.5  # a normal's upright part, above which it does not show where the axis is
ASKED = 6000  # vertices of a part, evenly taken: the profile is found from these
NEAREST, FEWEST = 160, 20  # of them, in the half plane
REACH = 2.5  # cells
NORMAL_REACH = 3.5  # cells that normals at a right angle are apart: edges of the profile stay
TANGENTS = 1.3  # cells: the deviation of the weights of tangents, for where they cross
TURNS = 0.1  # the least fraction of the tangents that go another way: the profile turns there
# Cosines to a normal, below which others go another way and the opposite way, and the fraction of
# such, to either side of a place, or opposite to it, that is no corner: a rim's wall is thin there.
OTHER_WAY, OPPOSITE, ON_RIM = 0.5, -0.6, 0.03
RIM_ASKED = 800  # vertices that it is found from
SNAP = 0.9  # cells to a corner, of what goes there
CORNER_ROUNDS = 3  # of mean shift
SMOOTHING = (4, 0, 0)  # rounds, of how far neighbours go, in each round of the vertices
FADE = 4  # the same, of where the part is: its border goes as its neighbours do
FARTHEST = 1.5  # cells that a vertex moves
OUTSIDE = 1.0  # cells off the profile, of a vertex that is not part of it
LEAST = 80  # vertices of a component
SAME = 2.0  # cells between the axes of components that are on one
AXIS_ROUNDS = 10


def revolved(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    part: Int[Tensor, " v"],
    fractions: tuple[tuple[float, ...], ...],
    cell: float,
) -> Float[Tensor, "v 3"]:
    """The vertices of round parts on their profile; all others stay.

    Args:
        part: of each vertex.
        fractions: of each part, the fraction of its surface that is the same all around an axis of
            each of its components: along x, along y, along z.
        cell: of the lattice that the mesh comes from, in units of ``verts``.
    """
    places, of = verts.detach().cpu().double().numpy() / cell, part.cpu().numpy()
    faces_np = faces.cpu().numpy()
    for k, around in enumerate(np.array(fractions).T):
        if around.max() < ROUND:
            continue
        along = int(around.argmax())
        upright = np.roll(np.arange(3), 2 - along)  # the axes, turned so that this one is the third
        for mine in on_one_axis(places[:, upright], faces_np, of == k):
            places = on_profile(places[:, upright], faces_np, mine)[:, np.argsort(upright)]
    return torch.from_numpy(places * cell).to(verts)


def on_one_axis(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], mine: Bool[np.ndarray, " v"]
) -> list[Bool[np.ndarray, " v"]]:
    """The vertices of ``mine`` that are round about each upright axis: of a barrel between its
    hoops all, of wheels those of one axle. With one axis, small components are about it too."""
    normal = unit(normals_of(verts, faces))
    large = [component for component in connected(faces, mine) if component.sum() >= LEAST]
    found: list[tuple[np.ndarray, np.ndarray]] = []
    for component in sorted(large, key=np.sum, reverse=True):
        at = axis(verts[component], normal[component])
        for k, (other, already) in enumerate(found):
            if np.linalg.norm(at - other) < SAME:
                found[k] = other, already | component
                break
        else:
            found.append((at, component))
    return [mine] if len(found) == 1 else [components for _, components in found]


def connected(
    faces: Int[np.ndarray, "f 3"], mine: Bool[np.ndarray, " v"]
) -> list[Bool[np.ndarray, " v"]]:
    """The connected components of the vertices of ``mine``."""
    edges = faces[:, [0, 1, 1, 2]].reshape(-1, 2)
    edges = edges[mine[edges].all(1)]
    graph = coo_array((np.ones(len(edges)), edges.T), shape=(len(mine), len(mine)))
    component = np.where(mine, connected_components(graph, directed=False)[1], -1)
    return [component == each for each in np.unique(component[mine])]


def on_profile(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], mine: Bool[np.ndarray, " v"]
) -> Float[np.ndarray, "v 3"]:
    """The vertices with those of ``mine`` on the profile about their axis."""
    start, normal, around = verts, unit(normals_of(verts, faces)), mean_around(faces, len(verts))
    centre, fraction = axis(verts[mine], normal[mine]), mine.astype(float)
    for _ in range(FADE):
        fraction = np.where(mine, around @ fraction, 0.0)
    for rounds in SMOOTHING:
        out = verts[mine, :2] - centre
        radius = np.maximum(np.linalg.norm(out, axis=1), 1e-6)
        out = out / radius[:, None]
        # The normal in the half plane; short where the surface leans around the axis.
        across = np.stack([(normal[mine, :2] * out).sum(1), normal[mine, 2]], 1)
        place = np.stack([radius, verts[mine, 2]], 1)
        move = _towards_profile(place, unit(across))
        step = np.concatenate([out * move[:, :1], move[:, 1:]], 1)
        every = np.zeros_like(verts)
        every[mine] = step
        # Neighbours go the same way: at a rim they may be of two sides of the profile.
        for _ in range(rounds):
            every = around @ every
        verts = verts + every * (fraction if rounds == 0 else mine)[:, None]
        normal = unit(normals_of(verts, faces))
    moved = verts - start
    length = np.linalg.norm(moved, axis=1, keepdims=True)
    return start + moved * np.minimum(1, FARTHEST / np.maximum(length, 1e-9))


def _towards_profile(
    place: Float[np.ndarray, "n 2"], normal: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "n 2"]:
    """From each place to the profile: to its corner, where one is near, or else to the line through
    the mean of those around it, square to their mean normal; none to what is far off."""
    at = np.c_[place, NORMAL_REACH * normal]
    asked = slice(None, None, -(-len(at) // ASKED))
    tree = KDTree(at[asked])
    away, near = tree.query(at[asked], NEAREST, distance_upper_bound=REACH)
    # What is farther away than that has the index after the last.
    weight = np.isfinite(away).astype(float)
    weight /= np.maximum(weight.sum(1, keepdims=True), 1)
    values = np.r_[np.c_[place, normal][asked], np.zeros((1, 4))]
    mean = np.einsum("nk,nkc->nc", weight, values[near])
    way, enough = unit(mean[:, 2:]), np.isfinite(away).sum(1) >= FEWEST
    on_line = values[:-1, :2] + ((mean[:, :2] - values[:-1, :2]) * way).sum(1, keepdims=True) * way
    corners = _corners(on_line[enough], values[:-1, 2:][enough])
    mine = tree.query(at)[1]
    off = ((mean[mine, :2] - place) * way[mine]).sum(1)
    sound = (np.abs(off) < OUTSIDE) & enough[mine]
    move = np.where(sound, off, 0.0)[:, None] * way[mine]
    if len(corners):
        away, which = KDTree(corners).query(place + move, distance_upper_bound=SNAP)
        there = np.isfinite(away)
        move[there] = corners[np.asarray(which)[there]] - place[there]
    return move


def _corners(
    place: Float[np.ndarray, "n 2"], normal: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "m 2"]:
    """The corners of a profile: where the point with the least squared distances to the tangents
    of those around it, as in Ju et al., "Dual Contouring of Hermite Data", 2002, is near by."""
    away, near = KDTree(place).query(place, NEAREST, distance_upper_bound=REACH)
    near_by = np.minimum(away, REACH)  # what is farther away has an infinite distance
    weight = np.isfinite(away) * np.exp(-0.5 * (near_by / TANGENTS) ** 2)
    values = np.r_[np.c_[place, normal], np.zeros((1, 4))][near]
    at, square = values[..., :2], values[..., 2:]
    system = np.einsum("nk,nki,nkj->nij", weight, square, square)
    right = np.einsum("nk,nki,nk->ni", weight, square, (square * at).sum(-1))
    least, most = np.linalg.eigvalsh(system).T
    turns = least > TURNS * most
    found = np.linalg.solve(system[turns], right[turns, :, None])[..., 0]
    found = found[np.linalg.norm(found - place[turns], axis=1) < SNAP]
    for _ in range(CORNER_ROUNDS if len(found) else 0):  # those of one corner become one point
        away, near = KDTree(found).query(found, NEAREST, distance_upper_bound=SNAP)
        one = np.isfinite(away)[..., None]
        found = (np.r_[found, np.zeros((1, 2))][near] * one).sum(1) / one.sum(1)
    rim = place[_on_rim(place, normal)]
    if len(rim) and len(found):
        found = found[KDTree(rim).query(found)[0] > SNAP]
    return found


def _on_rim(
    place: Float[np.ndarray, "n 2"], normal: Float[np.ndarray, "n 2"]
) -> Bool[np.ndarray, " n"]:
    """Whether the profile turns to either side of a place within reach, or comes back, as at a thin
    wall's rim: its two corners would be taken for one, a blade."""
    some = slice(None, None, -(-len(place) // RIM_ASKED))
    near = cdist(place, place[some]) < REACH
    cosine = normal @ normal[some].T
    side = normal[:, :1] * normal[some, 1] - normal[:, 1:] * normal[some, 0]
    other, least = near & (cosine < OTHER_WAY), ON_RIM * near.sum(1)
    either = np.minimum((other & (side > 0)).sum(1), (other & (side < 0)).sum(1))
    return np.maximum(either, (near & (cosine < OPPOSITE)).sum(1)) > least


def axis(
    verts: Float[np.ndarray, "n 3"], normal: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, " 2"]:
    """Where the upright axis is: the normals of the sides point to it or away from it.

    The point with the least sum of distances to the lines along them, by reweighted least squares.
    """
    side = np.abs(normal[:, 2]) < UPRIGHT
    at, way = verts[side, :2], unit(normal[side, :2])
    across = np.stack([-way[:, 1], way[:, 0]], 1)
    height, weight = (across * at).sum(1), np.ones(len(at))
    centre = verts[:, :2].mean(0)
    for _ in range(AXIS_ROUNDS):
        system = (across * weight[:, None]).T @ across + 1e-9 * np.eye(2)
        centre = np.linalg.solve(system, (across * weight[:, None]).T @ height)
        weight = 1 / np.maximum(np.abs(across @ centre - height), 0.25)
    return centre
