"""Triangle meshes as plain tensors: into the training's cube, and their health."""

import math
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components
from torch import Tensor

from core.errors import UserError

# Of the bounding sphere of a normalised object; the lattice's cube reaches to 1.05.
NORMAL_RADIUS = 0.9


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with welded vertices; the world's axes: +Z up, the front faces -Y."""

    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    uv: Float[Tensor, "u 2"] | None = None  # (0, 0) bottom left
    face_uvs: Int[Tensor, "f 3"] | None = None
    base_color: Float[Tensor, "h w 3"] | None = None  # the file's texture, linear, row 0 = top
    flat: bool = False  # each face is shaded as the plane that it is; else smooth

    @property
    def atlas(self) -> tuple[Float[Tensor, "u 2"], Int[Tensor, "f 3"]]:
        """uv and face_uvs of a mesh that has them."""
        assert self.uv is not None and self.face_uvs is not None, "the mesh has no UV map"
        return self.uv, self.face_uvs


def normalise(
    verts: Float[Tensor, "v 3"],
) -> tuple[Float[Tensor, "v 3"], Float[Tensor, " 3"], float]:
    """``(verts - center) * scale``, center and scale: the box's centre comes to the origin, the
    farthest vertex to NORMAL_RADIUS from it.

    Raises UserError for a mesh without extent.
    """
    center = (verts.amin(0) + verts.amax(0)) / 2
    radius = float((verts - center).norm(dim=1).max())
    if not radius > 0:
        raise UserError("All the mesh's vertices are one point.", "Give a mesh with an extent.")
    scale = NORMAL_RADIUS / radius
    return (verts - center) * scale, center, scale


def turned(verts: Float[Tensor, "v 3"], angle: float) -> Float[Tensor, "v 3"]:
    """Vertices turned about +Z by ``angle``, radians."""
    c, s = math.cos(angle), math.sin(angle)
    x, y, z = verts.unbind(1)
    return torch.stack([c * x - s * y, s * x + c * y, z], 1)


def face_areas(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, " f"]:
    """Area of each face."""
    a, b, c = verts[faces].unbind(1)
    return torch.linalg.cross(b - a, c - a).norm(dim=1) / 2


def component_labels(faces: Int[Tensor, "f 3"], vert_count: int) -> tuple[int, np.ndarray]:
    """How many components the faces connect to (by vertices), and the one (F,) of each face."""
    f = faces.cpu().numpy()
    if not len(f):
        return 0, np.zeros(0, np.int64)
    # Two of its edges hold a face's three corners together.
    links = (np.concatenate([f[:, 0], f[:, 1]]), np.concatenate([f[:, 1], f[:, 2]]))
    _, of_vert = _connected(*links, vert_count)
    components, of_face = np.unique(of_vert[f[:, 0]], return_inverse=True)
    return len(components), of_face


def health(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> dict[str, object]:
    """A mesh's health report for the user, in plain Python types.

    verts, faces, loose_verts (in no face), components, euler (V - E + F),
    genus (summed over the components; None unless closed, manifold and oriented),
    closed (no edge has one face only), manifold (no edge has more than two faces, and the faces
    round a vertex make one fan), oriented (the two faces of an edge run along it in opposite
    directions), open_edges, nonmanifold_edges, nonmanifold_verts, degenerate_faces (a corner
    twice, or an area below 1e-12 of the box's diagonal squared), area,
    volume (signed; positive where faces look outward; None unless closed and oriented),
    bounds ([low, high]; None for an empty mesh).
    """
    v, f = verts.detach().double().cpu(), faces.cpu()
    edge_count, open_edges, crowded, oriented = _edge_report(f.numpy())
    used = len(np.unique(f.numpy()))
    components, _ = component_labels(f, len(v))
    split_verts = _fan_count(f.numpy()) - used
    closed = len(f) > 0 and open_edges == 0
    manifold = crowded == 0 and split_verts == 0
    euler = used - edge_count + len(f)
    sound = closed and manifold and oriented
    areas = face_areas(v, f)
    bounds = [v.amin(0).tolist(), v.amax(0).tolist()] if len(v) else None
    diagonal = float((v.amax(0) - v.amin(0)).norm()) if len(v) else 0.0
    repeated = (f == f.roll(1, 1)).any(1)
    return {
        "verts": len(v),
        "faces": len(f),
        "loose_verts": len(v) - used,
        "components": components,
        "euler": euler,
        # The Euler characteristic is the sum of 2 - 2 g over the components.
        "genus": (2 * components - euler) // 2 if sound else None,
        "closed": closed,
        "manifold": manifold,
        "oriented": oriented,
        "open_edges": open_edges,
        "nonmanifold_edges": crowded,
        "nonmanifold_verts": split_verts,
        "degenerate_faces": int((repeated | (areas <= 1e-12 * diagonal**2)).sum()),
        "area": float(areas.sum()),
        "volume": signed_volume(v, f) if closed and oriented else None,
        "bounds": bounds,
    }


def signed_volume(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> float:
    """Volume of a closed mesh, positive where its faces look outward."""
    # About the mean: far from the origin large volumes would cancel.
    a, b, c = (verts - verts.mean(0))[faces].unbind(1)
    return float((a * torch.linalg.cross(b, c)).sum() / 6)


def drop_floaters(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    keep_ratio: float = 0.05,
    rooms: bool = False,
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """The mesh without its small components, and without the walls of voids that no one can see;
    ``rooms``: one looks through what is around these.

    A component stays if its area is at least ``keep_ratio`` of the largest's. One turned inside
    out, where the largest looks outward, is the wall of a void: marching tets makes no others.
    """
    count, of_face = component_labels(faces, len(verts))
    if count < 2:
        return compact(verts, faces)
    label = torch.from_numpy(of_face).to(faces.device)
    v = verts.detach().double()
    area = v.new_zeros(count).index_add_(0, label, face_areas(v, faces))
    a, b, c = (v - v.mean(0))[faces].unbind(1)
    volume = v.new_zeros(count).index_add_(0, label, (a * torch.linalg.cross(b, c)).sum(1))
    keep = area >= keep_ratio * area.max()
    if volume[area.argmax()] > 0 and not rooms:
        keep &= volume > 0
    return compact(verts, faces[keep[label]])


def polished(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], rounds: int
) -> Float[Tensor, "v 3"]:
    """Vertices after :func:`taubin`; 0 rounds leave them as they are."""
    if rounds == 0:
        return verts
    smooth = taubin(verts.cpu().double().numpy(), faces.cpu().numpy(), rounds)
    return torch.from_numpy(smooth).to(verts)


def taubin(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], rounds: int
) -> Float[np.ndarray, "v 3"]:
    """Smoothed without shrinking: each round is a step inwards and a longer one outwards.

    G. Taubin, "A Signal Processing Approach to Fair Surface Design", 1995; λ = 0.5, μ = -0.53.
    """
    around, smooth = mean_around(faces, len(verts)), verts.astype(float)
    for step in (0.5, -0.53) * rounds:
        smooth += step * (around @ smooth - smooth)
    return smooth


def mean_around(faces: Int[np.ndarray, "f 3"], count: int) -> csr_array:
    """The mean over the vertices that share an edge with each."""
    a, b = faces.reshape(-1), np.roll(faces, -1, 1).reshape(-1)
    graph = coo_array((np.ones(2 * len(a)), (np.r_[a, b], np.r_[b, a])), shape=(count, count))
    graph = csr_array(graph)
    # An edge of two faces was added up twice; each neighbour counts once.
    graph.data[:] = 1
    # A vertex of no face gets a row of zeros, not 0 / 0.
    total = np.maximum(graph.sum(1), 1)
    return csr_array(graph / total[:, None])


def compact(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "f 3"]]:
    """The mesh without the vertices that no face uses; their order stays."""
    used = torch.zeros(len(verts), dtype=torch.bool, device=verts.device)
    used[faces.view(-1)] = True
    renumbered = used.cumsum(0) - 1
    return verts[used], renumbered[faces]


def _connected(a: np.ndarray, b: np.ndarray, count: int) -> tuple[int, np.ndarray]:
    graph = coo_array((np.ones(len(a), np.int8), (a, b)), shape=(count, count))
    return connected_components(graph, directed=False)


def _half_edges(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Start and end (3F,) of every corner's edge to the next corner."""
    return faces.reshape(-1), np.roll(faces, -1, axis=1).reshape(-1)


def _edge_report(faces: np.ndarray) -> tuple[int, int, int, bool]:
    """Edges; those with one face, with more than two; whether the neighbours agree in winding."""
    if not len(faces):
        return 0, 0, 0, True
    start, end = (x.astype(np.int64) for x in _half_edges(faces))
    size = faces.max() + 1
    # Both directions of an edge as one whole number; int64, since the square of the number of
    # vertices does not fit in 32 bits.
    key = np.minimum(start, end) * size + np.maximum(start, end)
    _, edge, count = np.unique(key, return_inverse=True, return_counts=True)
    # Directions as +1 and -1: neighbours that agree in winding cancel.
    balance = np.bincount(edge, np.where(start < end, 1, -1))
    return (
        len(count),
        int((count == 1).sum()),
        int((count > 2).sum()),
        bool((balance[count == 2] == 0).all()),
    )


def _fan_count(faces: np.ndarray) -> int:
    """Fans of faces round the vertices: as many as vertices where each has one."""
    if not len(faces):
        return 0
    start, end = (x.astype(np.int64) for x in _half_edges(faces))
    corner = np.arange(len(start))
    following = corner.reshape(-1, 3)[:, [1, 2, 0]].reshape(-1)
    key = np.minimum(start, end) * (faces.max() + 1) + np.maximum(start, end)
    # Half-edges of one edge are next to each other: each is linked to the one before it.
    order = np.argsort(key, kind="stable")
    same = key[order[1:]] == key[order[:-1]]
    one, other = order[1:][same], order[:-1][same]
    # A half-edge's first corner is at its start; the neighbour's at either end.
    forth = start[one] == start[other]
    first = np.where(forth, corner[other], following[other])
    second = np.where(forth, following[other], corner[other])
    # Corners at the same end of a common edge are in one fan.
    links = np.concatenate([corner[one], following[one]]), np.concatenate([first, second])
    return _connected(*links, len(start))[0]
