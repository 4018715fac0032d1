"""The surface before it was simplified, whose shape the normal map keeps."""

import igl
import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.mesh import Mesh
from core.geometry.tangents import smooth_normals
from core.ops import dot, normalize
from core.texture.rounded import RoundedEdges
from core.texture.simplify import oriented

# Cosine to the coarse surface's normal: below it the nearest point is another side of a thin part.
SAME_SIDE = 0.2
EDGE_DEG = 50.0  # between two faces, from which they are shaded apart


class FineSurface:
    """Normals of a fine mesh, found from points of a coarse one."""

    def __init__(self, mesh: Mesh, edge_radius: float = 0.0) -> None:
        """``edge_radius``: of the convex edges, as a fraction of the longest side; 0: sharp."""
        mesh = Mesh(*oriented(mesh.verts, mesh.faces))  # as the coarse one was
        self._verts = np.ascontiguousarray(mesh.verts.cpu().double().numpy())
        self._faces = np.ascontiguousarray(mesh.faces.cpu().numpy().astype(np.int64))
        self._normals = torch.from_numpy(self._by_corner(smooth_normals(mesh.verts, mesh.faces)))
        self._tree = igl.AABB()
        self._tree.init(self._verts, self._faces)
        radius = edge_radius * float(np.ptp(self._verts, axis=0).max())
        self._edges = RoundedEdges(self._verts, self._faces, radius) if radius else None

    def _by_corner(self, smooth: Float[Tensor, "v 3"]) -> Float[np.ndarray, "f 3 3"]:
        """Each corner's normal: the vertex's, or at an edge of the shape its own side's."""
        found = smooth.cpu().double().numpy()[self._faces]
        apart = np.asarray(igl.per_corner_normals(self._verts, self._faces, EDGE_DEG)).reshape(
            -1, 3, 3
        )
        edge = (found * apart).sum(-1) < np.cos(np.radians(EDGE_DEG / 2))
        return np.where(edge[..., None], apart, found)

    def normals(
        self, points: Float[Tensor, "n 3"], coarse: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n 3"]:
        """Unit normals at the fine surface's points nearest to ``points``.

        ``coarse``: the coarse surface's own there, unit, which stay where the nearest point is on
        another side.
        """
        query = np.ascontiguousarray(points.double().numpy())
        _, face, at = self._tree.squared_distance(self._verts, self._faces, query)
        face = np.asarray(face).reshape(-1)
        corners = self._faces[face]
        a, b, c = (np.ascontiguousarray(self._verts[corners[:, k]]) for k in range(3))
        weights = torch.from_numpy(igl.barycentric_coordinates(np.ascontiguousarray(at), a, b, c))
        # A face without area has none.
        weights = weights.nan_to_num(1 / 3, 1 / 3, 1 / 3)
        fine = torch.einsum("nk,nkc->nc", weights, self._normals[torch.from_numpy(face)])
        fine = normalize(fine).to(points)
        if self._edges:
            fine = self._edges.normals(torch.from_numpy(at), fine)
        return torch.where(dot(fine, coarse) > SAME_SIDE, fine, coarse)


def turned(
    vector: Float[Tensor, "n 3"], start: Float[Tensor, "n 3"], end: Float[Tensor, "n 3"]
) -> Float[Tensor, "n 3"]:
    """``vector`` by the least turn that takes ``start`` to ``end``, which are unit.

    So a normal map goes on top of another one: C. Barré-Brisebois and S. Hill, "Blending in Detail:
    Reoriented Normal Mapping", 2012.
    """
    half = start + end
    # Two reflections: across the plane between start and end, and start's own.
    scale = dot(half, vector) / (1 + dot(start, end)).clamp(min=1e-6)
    return vector - scale * half + 2 * dot(start, vector) * end
