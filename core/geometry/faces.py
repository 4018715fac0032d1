"""Properties of a mesh's faces and which are adjacent; in numpy, double precision."""

import igl
import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

# Volume by area to the power of 1.5, below which a component has no inside: it is its own back.
SHEET = 1e-6


def areas_and_normals(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]
) -> tuple[Float[np.ndarray, " f"], Float[np.ndarray, "f 3"]]:
    """Area and unit normal of each face; the normal of one without area is zero."""
    a, b, c = (verts[faces[:, i]] for i in range(3))
    cross = np.cross(b - a, c - a)
    return np.linalg.norm(cross, axis=1) / 2, unit(cross)


def neighbours(faces: Int[np.ndarray, "f 3"]) -> Int[np.ndarray, "f 3"]:
    """The face across the edge from corner i to i + 1.

    -1 unless exactly two faces share it, and both look to the same side of the surface: libigl's
    triangle_triangle_adjacency joins faces of opposite winding, and two of three at one edge.
    """
    a, b, same = _pairs(faces)
    a, b = a[same], b[same]
    adjacent = np.full(faces.size, -1, np.int64)
    adjacent[a], adjacent[b] = b // 3, a // 3
    return adjacent.reshape(-1, 3)


def agree(faces: Int[np.ndarray, "f 3"]) -> bool:
    """Whether all two faces that share an edge, and are alone there, look to the same side."""
    return not len(faces) or bool(_pairs(faces)[2].all())


def agreeing(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]
) -> tuple[Int[np.ndarray, "f 3"], Int[np.ndarray, " f"]]:
    """Faces turned until neighbours look to the same side, and the patch that each is in.

    A patch is joined by edges of two faces. It looks where most of its area did. On a surface with
    a single side (Möbius) some neighbours disagree still.
    """
    turned, patch = igl.bfs_orient(np.ascontiguousarray(faces))
    flip, patch = (np.asarray(turned) != faces).any(1), np.asarray(patch).astype(np.int64)
    area = areas_and_normals(verts, faces)[0]
    flip ^= (np.bincount(patch, area * flip) > np.bincount(patch, area) / 2)[patch]
    return np.ascontiguousarray(np.where(flip[:, None], faces[:, ::-1], faces)), patch


def outward(verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]) -> bool:
    """Whether no face of an opaque mesh can be seen from behind, whatever it looks like.

    Each edge has two faces, they look to the same side, and no component (faces joined by edges) is
    inside out. The wall of a void is, though no one sees it. A component as flat as a sheet is not.
    """
    if not len(faces):
        return True
    adjacent = neighbours(faces)
    if (adjacent < 0).any():
        return False
    links = np.repeat(np.arange(len(faces)), 3), adjacent.reshape(-1)
    graph = coo_array((np.ones(faces.size, np.int8), links), shape=(len(faces),) * 2)
    _, component = connected_components(graph, directed=False)
    a, b, c = (verts[faces[:, i]] - verts.mean(0) for i in range(3))
    volume = np.bincount(component, (a * np.cross(b, c)).sum(1) / 6)
    area = np.bincount(component, areas_and_normals(verts, faces)[0])
    return bool((volume >= -SHEET * area**1.5).all())


def _pairs(
    faces: Int[np.ndarray, "f 3"],
) -> tuple[Int[np.ndarray, " e"], Int[np.ndarray, " e"], Bool[np.ndarray, " e"]]:
    """The two half-edges (3 f + i, from corner i to i + 1) of each edge that has two faces, and
    whether these look to the same side."""
    ends = np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2)
    key = ends.min(1) * (int(faces.max()) + 1) + ends.max(1)
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.r_[True, np.diff(key[order]) != 0])
    two = starts[np.diff(np.r_[starts, len(key)]) == 2]
    a, b = order[two], order[two + 1]
    # Faces that look to one side run along the edge in opposite directions.
    return a, b, ends[a, 0] != ends[b, 0]


def unit(x: Float[np.ndarray, "n k"]) -> Float[np.ndarray, "n k"]:
    """At length one; a zero stays."""
    return x / np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-30)


def normals_of(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]
) -> Float[np.ndarray, "v 3"]:
    """The vertices' normals, weighted by area, not unit; zero for a vertex without faces."""
    a, b, c = (verts[faces[:, i]] for i in range(3))
    cross = np.repeat(np.cross(b - a, c - a), 3, 0)
    return np.stack([np.bincount(faces.reshape(-1), x, len(verts)) for x in cross.T], 1)


def bending(verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]) -> float:
    """The absolute mean curvature of the whole mesh: half of each edge's length times the angle
    between its faces, radians. What makes planes flat lessens it, what tears them adds to it."""
    _, normal = areas_and_normals(verts, faces)
    length = np.linalg.norm(verts[faces] - verts[np.roll(faces, -1, 1)], axis=2)
    adjacent = neighbours(faces)
    cosine = (normal[:, None] * normal[adjacent]).sum(2).clip(-1, 1)
    # Each edge is met from both sides.
    return float((length * np.arccos(cosine))[adjacent >= 0].sum() / 4)
