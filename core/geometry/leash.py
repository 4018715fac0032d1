"""How far a guide lets Ψ's surface go: a leash about the guide, as long as its strength allows.

Not in the paper, whose guide is a start alone, from which distilling may go anywhere; ours. With
the guide's distance g and a leash of length r

    s(p) = g(p) + r φ((Ψ(p) - g(p)) / r),   φ(x) = x / (1 + |x|)

so |s - g| < r: what is farther off than r stays empty. Inwards r is shorter: what is deeper in the
guide than that stays solid, so that words add to a guide more than they take from it, and its limbs
do not come off. A drawn solid, which has limbs of its own, is cut off at r to either side.
"""

from collections.abc import Callable

import torch
from jaxtyping import Float
from torch import Tensor, nn

from core.geometry.residual import read_lattice
from core.geometry.signed_distance import SolidMesh

# Length at strength 1/2, training units: a ninth of the radius of the guide's sphere.
HALF_REACH = 0.1
INWARD = 1 / 3  # fraction of the leash that reaches into the guide
# Two sides of a sheet stay this far from it: in one place, no renderer could separate them.
LEAST_REACH = 0.001


def reach_of(strength: float) -> float:
    """Length of the leash, training units: nothing at strength 1, any at 0."""
    return HALF_REACH * (1 - strength) / strength if strength > 0 else float("inf")


class Leash(nn.Module):
    """Keeps Ψ's values, and the mesh's vertices, within reach of the guide."""

    distance: Tensor

    def __init__(
        self, solid: SolidMesh, distance: Float[Tensor, "1 1 x y z"], extent: float, reach: float
    ) -> None:
        """``solid``: the guide's triangles. ``distance``: g at the nodes of a lattice over
        [-extent, extent]³, of the guide with the skin that its thin parts need."""
        super().__init__()
        self.solid, self.extent, self.reach = solid, extent, max(reach, LEAST_REACH)
        self.cell = 2 * extent / (distance.shape[-1] - 1)
        # Made from the guide, whenever a run continues: in no checkpoint.
        self.register_buffer("distance", distance, persistent=False)

    def forward(
        self,
        points: Float[Tensor, "n 3"],
        sdf: Float[Tensor, " n"],
        offset: Float[Tensor, "n 3"],
        cell: float,
    ) -> tuple[Float[Tensor, " n"], Float[Tensor, "n 3"]]:
        """Ψ's values at lattice nodes, leashed; the offsets, too, end with the leash."""
        guide = read_lattice(self.distance, points, self.extent)[:, 0]
        missing = sdf - guide  # positive where Ψ lacks what the guide has
        reach = torch.where(missing > 0, self.reach * INWARD, self.reach)
        return guide + missing / (1 + missing.abs() / reach), offset * min(1, 2 * self.reach / cell)

    def parts(
        self, distances: Callable[[Tensor], Tensor], count: int
    ) -> Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n _"]]:
        """Signed distances of a solid's ``count`` parts, cut off where the leash ends, and of one
        more: what is deeper in the guide than the leash is long."""

        def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, "n _"]:
            guide = read_lattice(self.distance, points, self.extent)
            held = distances(points)[:, :count].maximum(guide - self.reach)
            return torch.cat([held, guide + self.reach], 1)

        return at

    def hold(self, verts: Float[Tensor, "v 3"]) -> Float[Tensor, "v 3"]:
        """Vertices, none farther from the guide's own triangles than the leash is long.

        Up to a cell beyond it they are of the skin that the lattice gives to sheets, or of what
        came after Ψ. From two on they are of a wall that closes a hole of the guide, and stay.
        """
        nearest = self.solid.nearest(verts)
        away = verts - nearest
        length = away.norm(dim=1, keepdim=True).clamp_min(1e-12)
        beyond = length - self.reach
        kept = beyond * (beyond / self.cell - 1).clamp(0, 1)
        return torch.where(beyond > 0, nearest + away * ((self.reach + kept) / length), verts)
