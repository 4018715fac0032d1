"""The drawn solid in a guide's proportions: those of its box, and as far as it bends, those of its
parts."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.bend import bend_to, stiffness_of
from core.geometry.guide import guide_shape
from core.geometry.mesh import Mesh, normalise
from core.geometry.signed_distance import SolidMesh
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.stretch import Frame

MOST_RADIUS = 1.0  # training units: a camera sees 1.026

Points = Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n 3"]]


@dataclass(frozen=True)
class BentSolid(Solid):
    """A solid whose points are looked up at their places before the bend."""

    bend: Points = torch.Tensor.clone

    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """Each part's signed distance; less exact where it is bent."""
        return super().distances(self.bend(points))


def bent(
    solid: Solid, flat: tuple[float, ...], guide: Mesh, strength: float, least: float
) -> BentSolid:
    """``solid`` in the proportions of ``guide``, the more the stronger.

    Args:
        flat: for each part, the fraction of it that should be flat.
        least: half of the thickness that the guide's thin parts get, training units.
    """
    fitted = in_box(solid, normalise(guide.verts)[0], least)
    verts, faces = fitted.mesh
    flatness = float(torch.tensor(flat)[fitted.part(verts)].mean())
    stiffness = stiffness_of(strength, flatness)
    # By its mesh: the solid's own distances are too short where the box is uneven.
    bend = bend_to(SolidMesh(verts, faces).sdf, guide_shape(guide, least).sdf, stiffness)
    return BentSolid(solid.net, solid.triplane, fitted.frame, solid.swell, solid.absent, bend=bend)


def in_box(solid: Solid, guide: Float[Tensor, "v 3"], least: float) -> Solid:
    """``solid`` scaled along each axis to the box around ``guide``, which is centred at the origin.

    It is scaled less where its corners would leave the pictures: a crate in the box of a ball.
    """
    verts, frame = solid.mesh[0], solid.frame
    low, high = verts.amin(0), verts.amax(0)
    # A guide may be flat.
    factors = (guide.amax(0) - guide.amin(0)).clamp_min(2 * least) / (high - low)
    radius = float(((verts - (low + high) / 2) * factors).norm(dim=1).max())
    old = low.new_tensor(frame.scale)
    a, b, c = (low.new_tensor(frame.center) + (low + high) / 2 / old).tolist()
    x, y, z = (old * factors * min(1, MOST_RADIUS / radius)).tolist()
    return replace(solid, frame=Frame((a, b, c), (x, y, z)))
