"""Mass, centre and inertia of a triangle mesh: of the solid inside it, or of a thin shell.

Closed forms over tetrahedra and triangles: A. DiCarlo and A. Paoluzzi, "Fast computation of inertia
through affinely extended Euler tensor", Computer-Aided Design 38, 2006.
"""

from dataclasses import dataclass, replace

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import face_areas, health

WALL = 0.01  # of the longest side: how thick the shell of an open mesh is taken to be


@dataclass(frozen=True, eq=False)
class Mass:
    """The mass properties of a rigid body, in kilograms and metres."""

    mass: float
    center: Float[Tensor, " 3"]
    inertia: Float[Tensor, "3 3"]  # about the centre, along the mesh's axes

    def scaled_to(self, mass: float) -> "Mass":
        """The same body of another mass, spread in the same way."""
        return replace(self, mass=mass, inertia=self.inertia * (mass / self.mass))

    @property
    def principal(self) -> tuple[Float[Tensor, " 3"], Float[Tensor, "3 3"]]:
        """Moments and axes: ``inertia = axes diag(moments) axes^T``, a right-handed rotation."""
        moments, axes = torch.linalg.eigh(self.inertia)
        axes[:, 0] *= torch.linalg.det(axes).sign()  # eigenvectors come with any sign
        return moments, axes


def mass_of(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], density: float) -> Mass:
    """Those of the solid where the mesh encloses one, else of a shell; ``density`` in kg/m³.

    Raises UserError for a mesh without volume or area.
    """
    report = health(verts, faces)
    points = verts.detach().cpu().double()
    origin = points.mean(0)  # far from it large numbers would cancel
    corners = (points - origin)[faces.cpu()]
    if report["closed"] and report["oriented"]:
        found = solid(corners, density)
    else:
        size = float((points.amax(0) - points.amin(0)).max())
        found = shell(corners, density * WALL * size)
    if not found.mass > 0:
        raise UserError("The mesh has neither a volume nor an area.", "Give a mesh with faces.")
    return replace(found, center=found.center + origin)


def solid(corners: Float[Tensor, "f 3 3"], density: float) -> Mass:
    """Those of the volume in faces with these ``corners``: signed tetrahedra to the origin."""
    a, b, c = corners.unbind(1)
    volumes = (a * torch.linalg.cross(b, c)).sum(1) / 6
    volumes = volumes * volumes.sum().sign()  # of faces that all look inward too
    # A tetrahedron's fourth corner is the origin: it adds to the mean, not to the sums.
    return _body(corners, density * volumes, 4)


def shell(corners: Float[Tensor, "f 3 3"], weight: float) -> Mass:
    """Those of the surface alone; ``weight`` in kg/m²."""
    flat = corners.reshape(-1, 3)
    areas = face_areas(flat, torch.arange(len(flat)).view(-1, 3))
    return _body(corners, weight * areas, 3)


def _body(corners: Float[Tensor, "f 3 3"], masses: Float[Tensor, " f"], count: int) -> Mass:
    """Those of simplices with ``count`` corners (beyond three at the origin), each of its mass.

    The second moment of a simplex of mass m with n corners p and their sum s is
    m / (n (n + 1)) (sum p p^T + s s^T).
    """
    mass = masses.sum()
    sums = corners.sum(1)
    center = (masses[:, None] * sums).sum(0) / (count * mass)
    outer = torch.einsum("fki,fkj->fij", corners, corners) + torch.einsum("fi,fj->fij", sums, sums)
    second = (masses[:, None, None] * outer).sum(0) / (count * (count + 1))
    second = second - mass * torch.outer(center, center)  # about the centre (parallel axes)
    inertia = second.trace() * torch.eye(3, dtype=second.dtype) - second
    return Mass(float(mass), center, inertia)
