"""The signed distance to any mesh from the wild.

Sign: the generalised winding number (Jacobson et al. 2013; fast: Barill et al. 2018) is right in
spite of holes, overlapping shells and faces in bad company, as long as the faces look outward.
Faces that do not are turned first: all at once if that does it, or else patch by patch (faces that
share edges), by rays (Takayama et al. 2014): the side from which more rays escape is outside.
"""

import igl
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.faces import agreeing, areas_and_normals

# Fraction of the surface, by area, that may be at a winding number that no solid has.
TOLERATED = 0.05
PROBES = 2000  # points of the surface that are looked at
RAYS, LEAST_RAYS = 20000, 10  # to either side: in all, and of each patch
RAY_CHUNK = 1 << 16
LIFT = 1e-6  # of the box's diagonal: rays start so far off their face
# The inverse powers of the root of x^5 = x + 1: M. Roberts' sequence in four dimensions.
R4 = 1.1673039782614187 ** -np.arange(1.0, 5.0)


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
    agreed, patch = agreeing(verts, faces)
    flip = _seen_from_behind(verts, agreed, patch)[patch]
    turned = np.ascontiguousarray(np.where(flip[:, None], agreed[:, ::-1], agreed))
    return turned, _windings(verts, turned)


def _seen_from_behind(verts: np.ndarray, faces: np.ndarray, patch: np.ndarray) -> np.ndarray:
    """Whether (P,) more rays escape from behind each patch of faces than from its front.

    Where as many do, it is whether those that hit something go farther behind. The rays are the
    same ones each time (libigl's own function draws them by the clock).
    """
    areas, normals = areas_and_normals(verts, faces)
    order = np.argsort(patch, kind="stable")
    ends, total = areas[order].cumsum(), np.bincount(patch, areas)
    count = np.maximum(RAYS * total / total.sum(), LEAST_RAYS).astype(np.int64)
    of = np.repeat(np.arange(len(total)), count)
    number = np.arange(len(of)) - np.repeat(count.cumsum() - count, count)
    # Evenly over each patch, by area.
    at = (total.cumsum() - total)[of] + (number + 0.5) / count[of] * total[of]
    face = order[np.searchsorted(ends, at).clip(max=len(faces) - 1)]
    tree = igl.AABB()
    tree.init(verts, faces)
    lift = LIFT * np.linalg.norm(verts.max(0) - verts.min(0))
    escaped, gone = np.zeros((2, len(total))), np.zeros((2, len(total)))  # in front, behind
    for start in range(0, len(face), RAY_CHUNK):
        some = face[start : start + RAY_CHUNK]
        u, v, w, x = (np.arange(start, start + len(some))[:, None] * R4 % 1).T
        root = np.sqrt(u)  # uniform over the triangle (Osada et al. 2002)
        weights = np.stack([1 - root, root * (1 - v), root * v], 1)
        origin = np.einsum("nk,nkc->nc", weights, verts[faces[some]])
        height, turn = 2 * w - 1, 2 * np.pi * x  # uniform over the sphere
        across = np.sqrt(1 - height**2)
        ray = np.stack([across * np.cos(turn), across * np.sin(turn), height], 1)
        ray *= np.where((ray * normals[some]).sum(1, keepdims=True) < 0, -1, 1)
        for side, sign in enumerate((1, -1)):
            begin = origin + sign * lift * normals[some]
            hit, distance, _ = tree.intersect_ray_first(verts, faces, begin, sign * ray)
            free = np.asarray(hit) < 0
            escaped[side] += np.bincount(patch[some], free, len(total))
            gone[side] += np.bincount(patch[some], np.where(free, 0, distance), len(total))
    (front, behind), (near, far) = escaped, gone
    return (behind > front) | ((behind == front) & (far > near))


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

    (1 and more within other shells). -1 is a component that looks inward, a fraction a sheet whose
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
