"""Faces that look the wrong way, or have no area, taken out of a mesh by collapsing an edge.

Two vertices become one where that leaves a manifold of the same topology (the link condition: Dey
et al., "Topology Preserving Edge Contraction", 1999) and turns no other face over.
"""

import itertools

import numpy as np
from jaxtyping import Float, Int
from scipy.sparse import csr_array

from core.geometry.faces import areas_and_normals

LEAST_COSINE = 0.2  # between a face and where it should look
STEADY = 0.95  # the same, where a vertex leaves a plane of its own
LEAST_AREA = 1e-4  # of the mean face's
PASSES = 6


def without_turned(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    wanted: Float[np.ndarray, "f 3"],
    held: csr_array,
) -> Int[np.ndarray, "g 3"]:
    """The faces without those that do not look along ``wanted``, as far as that may be.

    ``held`` (V, P): by what each vertex is held where it is. One gives way rather to another that
    is held by all of the same.
    """
    mesh = _Mesh(verts, faces, wanted, held)
    for _ in range(PASSES):
        if not sum(mesh.collapse(face) for face in mesh.wrong()):
            break
    return mesh.faces[mesh.there]


class _Mesh:
    """A mesh that loses faces."""

    def __init__(self, verts: np.ndarray, faces: np.ndarray, wanted: np.ndarray, held: csr_array):
        self.verts, self.faces, self.wanted = verts, faces.copy(), wanted
        self.there = np.ones(len(faces), bool)
        self.least_area = LEAST_AREA * areas_and_normals(verts, faces)[0].mean()
        corners = faces.reshape(-1)
        starts = np.searchsorted(np.sort(corners), np.arange(len(verts) + 1))
        order = (np.argsort(corners, kind="stable") // 3).tolist()
        self.around = [set(order[a:b]) for a, b in itertools.pairwise(starts)]
        self.held = [set(x.tolist()) for x in np.split(held.indices, held.indptr[1:-1])]

    def wrong(self) -> list[int]:
        """The faces to take out."""
        area, normal = areas_and_normals(self.verts, self.faces)
        turned = (normal * self.wanted).sum(1) < LEAST_COSINE
        return np.flatnonzero(self.there & (turned | (area < self.least_area))).tolist()

    def collapse(self, face: int) -> bool:
        """Whether an edge of the face could be collapsed, the shortest first."""
        if not self.there[face]:  # an earlier one took it along
            return False
        corners = self.faces[face].tolist()
        edges = [(a, b) for a in corners for b in corners if a != b]
        return any(self._merge(*edge) for edge in sorted(edges, key=self._length))

    def _length(self, edge: tuple[int, int]) -> float:
        return float(np.linalg.norm(self.verts[edge[0]] - self.verts[edge[1]]))

    def _merge(self, gone: int, stays: int) -> bool:
        """One vertex into the other, if the mesh stays sound."""
        both = self.around[gone] & self.around[stays]
        rings = [set(self.faces[list(self.around[end])].flat) for end in (gone, stays)]
        # Two faces at the edge, and no neighbours in common but their third corners.
        if len(both) != 2 or len(rings[0] & rings[1]) != 4:
            return False
        moved = sorted(self.around[gone] - both)
        before = self.faces[moved]
        after = np.where(before == gone, stays, before)
        was, now = (self._cosines(faces, moved) for faces in (before, after))
        least = LEAST_COSINE if self.held[gone] <= self.held[stays] else STEADY
        if (now < np.minimum(least, was)).any():
            return False
        self.faces[moved] = after
        for face in both:
            self.there[face] = False
            for vert in self.faces[face].tolist():
                self.around[vert].discard(face)
        self.around[stays] |= set(moved)
        self.around[gone] = set()
        return True

    def _cosines(self, faces: np.ndarray, of: list[int]) -> np.ndarray:
        return (areas_and_normals(self.verts, faces)[1] * self.wanted[of]).sum(1)
