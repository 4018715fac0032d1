"""What a mesh's faces are, and which lie side by side; in numpy, double precision."""

import numpy as np
from jaxtyping import Float, Int


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
    ends = np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2)
    key = ends.min(1) * (int(faces.max()) + 1) + ends.max(1)
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.r_[True, np.diff(key[order]) != 0])
    two = starts[np.diff(np.r_[starts, len(key)]) == 2]
    a, b = order[two], order[two + 1]
    # Faces that look to one side run along the edge in opposite directions.
    alike = ends[a, 0] != ends[b, 0]
    a, b = a[alike], b[alike]
    adjacent = np.full(len(key), -1, np.int64)
    adjacent[a], adjacent[b] = b // 3, a // 3
    return adjacent.reshape(-1, 3)


def unit(x: Float[np.ndarray, "n k"]) -> Float[np.ndarray, "n k"]:
    """At length one; a zero stays."""
    return x / np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-30)


def normals_of(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]
) -> Float[np.ndarray, "v 3"]:
    """Of the vertices, by area, as long as it comes; zero for a vertex without faces."""
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
