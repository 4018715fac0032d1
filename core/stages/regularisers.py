"""Terms beyond the paper that constrain Ψ where the pictures give no information."""

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.sdf_net import Band, SdfNet
from core.geometry.tet_grid import TetGrid
from core.render.antialias import EdgeTable

FAR_NODES = 4096  # outside of the band, looked at in one step: enough to see a wall come up


def eikonal(sdf: Float[Tensor, " nt"], grid: TetGrid) -> Float[Tensor, ""]:
    """Mean of (|∇s| - 1)² over the lattice's inner nodes, by central differences.

    Gropp et al. 2020, "Implicit geometric regularization", Eq. 2.
    """
    s = sdf.view(grid.shape)
    # Central differences need both neighbours.
    inner = slice(1, -1)
    gradient = torch.stack(
        [
            s[2:, inner, inner] - s[:-2, inner, inner],
            s[inner, 2:, inner] - s[inner, :-2, inner],
            s[inner, inner, 2:] - s[inner, inner, :-2],
        ],
        -1,
    ) / (2 * grid.cell)
    length = (gradient.square().sum(-1) + 1e-12).sqrt()  # the root has no slope at 0
    return (length - 1).square().mean()


def bending(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], edges: EdgeTable
) -> Float[Tensor, ""]:
    """Mean of 1 - cos of the angle between adjacent faces."""
    a, b, c = (verts.index_select(0, faces[:, k]) for k in range(3))
    n = torch.nn.functional.normalize(torch.linalg.cross(b - a, c - a), dim=-1, eps=1e-12)
    # An edge of a border has one face and no angle.
    inner = edges.faces[:, 1] >= 0
    n0, n1 = (n.index_select(0, face) for face in edges.faces.clamp(min=0).unbind(1))
    return torch.where(inner, 1 - (n0 * n1).sum(-1), 0).sum() / inner.sum()


def strays(net: SdfNet, grid: TetGrid, band: Band, generator: torch.Generator) -> Float[Tensor, ""]:
    """How far Ψ falls short, in cells, of the side that nodes outside of the band were on.

    Of ``FAR_NODES`` nodes, drawn at random. The pictures do not show them, so a network
    which is fitted to the band alone may put walls where nothing was.
    """
    outside = torch.ones(len(grid.tet_verts), dtype=torch.bool, device=grid.tet_verts.device)
    outside[band.near] = False
    nodes = outside.nonzero().squeeze(1)
    if not len(nodes):
        return band.sdf.new_zeros(())
    nodes = nodes[torch.randint(len(nodes), (FAR_NODES,), generator=generator).to(nodes.device)]
    kept = band.sdf.index_select(0, nodes)
    sdf, _ = net(grid.tet_verts.index_select(0, nodes))
    # A cell of distance is enough: farther away the value is free, only its sign counts.
    return (kept.abs().clamp_max(grid.cell) - sdf * kept.sign()).clamp_min(0).mean() / grid.cell
