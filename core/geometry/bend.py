"""A free-form deformation that brings one solid to another: a drawn chair to a guide's proportions.

Not in the paper; ours. A cubic B-spline over a coarse lattice moves the space (Sederberg and Parry
1986), and its control points are found by making the solids overlap against its bending energy
(Rueckert et al. 1999, "Nonrigid registration using free-form deformations", Eqs. 1, 3):

    min_u  mean_p (o(g(p)) - o(d(p + u(p))))² + stiffness · bending(u),   o(x) = sigmoid(-x / τ)

with the signed distances g of the target and d of the solid. Nothing is drawn at random, so that
what is the same on both sides stays so.
"""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from core.adam import Adam
from core.geometry.residual import lattice_nodes, read_lattice
from core.geometry.tet_grid import EXTENT

CONTROLS = 8  # control points along an axis; one is beyond each end
# Cubes of the lattices on which the solids are compared, and d is read. No node of the one is the
# other's, where the slope to one side would be taken for both.
NODES, READ = 24, 49
NEAR = 0.25  # training units: farther from both surfaces, distances show nothing
BLUR = (0.12, 0.04)  # τ, training units, at the first and at the last step
STEPS, RATE = 80, 0.012
CHUNK = 1 << 14  # points at a time
# At strength 1/2, of a soft thing; and what is flat is stiffer, or its planes would warp.
STIFFNESS, FLAT_STIFFNESS = 0.005, 0.024

Distance = Callable[[Float[Tensor, "n 3"]], Float[Tensor, " n"]]


@dataclass(frozen=True)
class Bend:
    """The places of the bent solid's points in the straight one."""

    controls: Float[Tensor, "k k k 3"]  # displacements, training units

    def __call__(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """p + u(p)."""
        moves = self.controls.view(-1, 3)
        found = [basis(part, len(self.controls)) @ moves for part in points.cpu().split(CHUNK)]
        return points + torch.cat(found).to(points)


def stiffness_of(strength: float, flat: float) -> float:
    """How stiff the solid is: nothing bends at strength 0, all at 1.

    ``flat``: the flat fraction of its surface.
    """
    if strength == 0:
        return float("inf")
    return (STIFFNESS + FLAT_STIFFNESS * flat) * (1 - strength) / strength


def bend_to(solid: Distance, target: Distance, stiffness: float) -> Bend:
    """The deformation under which ``solid`` is most like ``target``, both in the lattice's cube."""
    controls = torch.zeros(CONTROLS, CONTROLS, CONTROLS, 3)
    if stiffness == float("inf"):
        return Bend(controls)
    n = READ + 1
    distance = solid(lattice_nodes(READ, EXTENT)).view(1, 1, n, n, n)
    points = lattice_nodes(NODES, EXTENT)
    wanted = target(points)
    near = (wanted < NEAR) | (read_lattice(distance, points, EXTENT)[:, 0] < NEAR)
    points, wanted = points[near], wanted[near]
    # The nodes stay, so that their weights are found once, and for each axis alone.
    weights = splines(torch.linspace(-EXTENT, EXTENT, NODES + 1), CONTROLS)
    controls.requires_grad_(True)
    optimizer = Adam([controls], RATE)
    for step in range(STEPS):
        tau = BLUR[0] * (BLUR[1] / BLUR[0]) ** (step / STEPS)
        moved = points + _at_nodes(controls, weights)[near]
        found = read_lattice(distance, moved, EXTENT)[:, 0]
        unlike = ((-wanted / tau).sigmoid() - (-found / tau).sigmoid()).square().mean()
        optimizer.zero_grad()
        (unlike + stiffness * bending(controls)).backward()
        optimizer.step()
    return Bend(controls.detach())


def _at_nodes(
    controls: Float[Tensor, "k k k 3"], weights: Float[Tensor, "s k"]
) -> Float[Tensor, "_ 3"]:
    """The displacements of all nodes of a lattice, by the weights along an axis."""
    moves = controls.permute(3, 0, 1, 2)
    for _ in range(3):  # each time the first axis of those left, to the end
        moves = torch.tensordot(moves, weights, ([1], [1]))
    return moves.flatten(1).T


def basis(points: Float[Tensor, "n 3"], count: int) -> Float[Tensor, "n _"]:
    """The weight of each of ``count``³ control points at each point."""
    x, y, z = splines(points, count).unbind(1)
    return (x[:, :, None, None] * y[:, None, :, None] * z[:, None, None]).flatten(1)


def splines(places: Float[Tensor, "*n"], count: int) -> Float[Tensor, "*n _"]:
    """The weight of each of ``count`` control points along an axis, by cubic B-splines.

    The second and the last but one are at the ends of the lattice's cube; beyond it, all fade out.
    """
    at = (places / EXTENT + 1) * ((count - 3) / 2) + 1
    away = (at[..., None] - torch.arange(count)).abs()
    near, far = 2 / 3 - away.square() + away**3 / 2, (2 - away) ** 3 / 6
    return torch.where(away < 1, near, torch.where(away < 2, far, 0))


def bending(controls: Float[Tensor, "k k k 3"]) -> Float[Tensor, ""]:
    """The mean square of the second differences, in units of the control points' distance."""
    cell = 2 * EXTENT / (len(controls) - 3)
    total = controls.new_zeros(())
    for a in range(3):
        for b in range(3):
            total = total + controls.diff(dim=a).diff(dim=b).square().sum()
    return total / (len(controls) ** 3 * cell**2)
