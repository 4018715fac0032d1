"""The signed distance to any mesh from the wild. The only file that casts rays with Embree.

Sign: the generalised winding number (Jacobson et al. 2013; fast: Barill et al. 2018) is right in
spite of holes, overlapping shells and faces in bad company, as long as the faces look outward.
Faces that do not are turned first: all at once if that does it, or else patch by patch (faces that
share edges), by rays (Takayama et al. 2014): the side from which more rays escape is outside.
"""

import igl
import igl.embree
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError

# Fraction of the surface, by area, that may stand at a winding number that no solid has.
TOLERATED = 0.05
PROBES = 2000  # points of the surface that are looked at
RAYS = 20000  # in all; and at least 10 for each patch


class SolidMesh:
    """A mesh prepared once for many distances: welded, without empty faces, facing outward."""

    def __init__(self, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> None:
        """Raises UserError for a mesh without area."""
        v, f = _clean(verts.detach().cpu().double().numpy(), faces.cpu().numpy())
        self._verts = v
        self._faces, self._windings = facing_outward(v, f)
        self._tree = igl.AABB()
        self._tree.init(self._verts, self._faces)

    @property
    def arrays(self) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and faces."""
        return self._verts, self._faces

    def thin_part(self, thickness: float) -> "SolidMesh | None":
        """The faces behind which there is less of the solid than ``thickness``, by their middles.

        A sheet's are among them, since nothing is behind it. None where there are none.
        """
        normals = _normals(self._verts, self._faces)
        # Never 0 / 0: _clean left no face without an area.
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        behind = self._verts[self._faces].mean(1) - thickness * normals
        winding = self._windings.winding_number(np.ascontiguousarray(behind))
        thin = self._faces[winding <= 0.5]
        if not len(thin):
            return None
        return SolidMesh(torch.from_numpy(self._verts), torch.from_numpy(thin))

    def winding(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """How often the surface winds round each point: about 1 inside, 0 outside."""
        query = np.ascontiguousarray(points.detach().cpu().double().numpy())
        return torch.from_numpy(self._windings.winding_number(query)).to(points)

    def distance(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Distance to the surface, not negative."""
        query = np.ascontiguousarray(points.detach().cpu().double().numpy())
        squared = self._tree.squared_distance(self._verts, self._faces, query)[0]
        return torch.from_numpy(squared).sqrt().to(points)

    def nearest(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """The point of the surface that is nearest to each."""
        query = np.ascontiguousarray(points.detach().cpu().double().numpy())
        found = self._tree.squared_distance(self._verts, self._faces, query)[2]
        return torch.from_numpy(found).to(points)

    def sdf(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distance, negative inside."""
        distance = self.distance(points)
        # Halfway between outside (0) and inside (1): around holes the number is a fraction.
        return torch.where(self.winding(points) > 0.5, -distance, distance)


def mesh_sdf(
    points: Float[Tensor, "n 3"], verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]
) -> Float[Tensor, " n"]:
    """Signed distance of ``points`` to a mesh, negative inside; see :class:`SolidMesh`."""
    return SolidMesh(verts, faces).sdf(points)


def facing_outward(
    verts: np.ndarray, faces: np.ndarray
) -> tuple[np.ndarray, igl.FastWindingNumberBVH]:
    """``faces`` turned so that they look outward, and what their winding numbers are read from.

    The wall of a void keeps looking into it, unless rays had to decide: they fill the void.
    """
    inside_out = np.ascontiguousarray(faces[:, ::-1])
    # The cheap test first; rays are for meshes whose faces disagree.
    for candidate in (faces, inside_out):
        windings = _windings(verts, candidate)
        if _is_solid(verts, candidate, windings):
            return candidate, windings
    flip, _ = igl.embree.reorient_facets_raycast(verts, faces, RAYS)
    turned = np.ascontiguousarray(np.where(flip[:, None], inside_out, faces))
    return turned, _windings(verts, turned)


def _windings(verts: np.ndarray, faces: np.ndarray) -> igl.FastWindingNumberBVH:
    """The hierarchy of a mesh, which takes as long to make as ten thousands of points to read."""
    made = igl.FastWindingNumberBVH()
    made.init(verts, faces)
    return made


def _clean(verts: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices in one place joined; faces without area left out."""
    welded, number = np.unique(verts, axis=0, return_inverse=True)
    faces = number.reshape(-1)[faces].astype(np.int64)
    areas = np.linalg.norm(_normals(welded, faces), axis=1)
    faces = np.ascontiguousarray(faces[areas > 0])
    if not len(faces):
        raise UserError("The mesh has no face with an area.", "Give a mesh that is a surface.")
    return np.ascontiguousarray(welded), faces


def _normals(verts: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Normals as long as twice the face's area."""
    a, b, c = (verts[faces[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def _is_solid(verts: np.ndarray, faces: np.ndarray, windings: igl.FastWindingNumberBVH) -> bool:
    """Whether nearly everywhere just in front of the surface the winding number is 0, 1, 2, ...

    (1 and more within other shells). -1 is a piece that looks inward, a fraction a sheet whose
    neighbours look the other way.
    """
    normals = _normals(verts, faces)
    areas = np.linalg.norm(normals, axis=1)
    at = (np.arange(PROBES) + 0.5) / PROBES * areas.sum()  # evenly by area
    picked = np.searchsorted(areas.cumsum(), at).clip(max=len(faces) - 1)
    # Just off the surface, across which the winding number jumps.
    lift = 1e-4 * np.linalg.norm(verts.max(0) - verts.min(0))
    front = verts[faces[picked]].mean(1) + lift * normals[picked] / areas[picked, None]
    winding = windings.winding_number(np.ascontiguousarray(front))
    # Clipped at 0: a negative number is not near any that a solid has.
    off = np.abs(winding - np.round(winding.clip(min=0)))
    return float((off > 0.25).mean()) <= TOLERATED
