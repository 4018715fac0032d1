"""The multiresolution hash grid that Ψ and Γ share: β of Eqs. 2 and 6.

Each level is a cubic grid of feature vectors over [-extent, extent]³, trilinearly sampled. A level
whose nodes outnumber the table is stored by a hash of the node, collisions and all.
Source: Müller et al. 2022, §3; 16 levels, 2 features, 2^19 rows, 16 to 4096 cells there and here.
"""

import itertools

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

PRIMES = (1, 2654435761, 805459861)  # Müller et al. 2022, Eq. 4
CORNERS = tuple(itertools.product((0, 1), repeat=3))


class HashGrid(nn.Module):
    """Features of points, one table row a node, all levels in one parameter."""

    def __init__(
        self,
        levels: int = 16,
        features: int = 2,
        log2_size: int = 19,
        base: int = 16,
        finest: int = 4096,
        extent: float = 1.05,
        generator: torch.Generator | None = None,
    ) -> None:
        """``base`` to ``finest``: cells along an axis, growing geometrically over ``levels``.

        ``log2_size``: logarithm of the most rows that a level has. ``generator``: of the initial
        features, uniform within ±1e-4.
        """
        super().__init__()
        self.extent = extent
        self.width = levels * features
        growth = (finest / base) ** (1 / max(levels - 1, 1))
        # 1e-6: so that a power that is whole but for rounding is not cut to the number below.
        self.resolutions = [int(base * growth**level + 1e-6) for level in range(levels)]
        self.sizes = [min((r + 1) ** 3, 1 << log2_size) for r in self.resolutions]
        table = torch.empty(sum(self.sizes), features)
        self.table = nn.Parameter(table.uniform_(-1e-4, 1e-4, generator=generator))

    def forward(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n w"]:
        """Features of points in [-extent, extent]³, coarse levels first; outside: the nearest's."""
        unit = (points / (2 * self.extent) + 0.5).clamp(0, 1)
        levels = zip(self.table.split(self.sizes), self.resolutions, strict=True)
        return torch.cat([_Level.apply(rows, unit, r) for rows, r in levels], -1)


def node_index(node: Int[Tensor, "n 3"], resolution: int, size: int) -> Int[Tensor, "n 8"]:
    """Table rows of the eight corners of the cells that start at ``node``, in CORNERS' order."""
    if (resolution + 1) ** 3 <= size:
        side = resolution + 1
        x, y, z = (torch.stack([node[:, d], node[:, d] + 1], 1) for d in range(3))
        x, y = x * (side * side), y * side
        return (x[:, :, None, None] + y[:, None, :, None] + z[:, None, None, :]).view(-1, 8)
    x, y, z = (torch.stack([node[:, d], node[:, d] + 1], 1) * PRIMES[d] for d in range(3))
    return (x[:, :, None, None] ^ y[:, None, :, None] ^ z[:, None, None, :]).view(-1, 8) & (
        size - 1
    )


def corner_weights(w: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
    """Trilinear weights of a point at ``w`` in [0, 1]³ of its cell, in CORNERS' order."""
    x, y, z = torch.stack([1 - w, w], 1).unbind(-1)
    return (x[:, :, None, None] * y[:, None, :, None] * z[:, None, None, :]).reshape(-1, 8)


class _Level(torch.autograd.Function):
    """One level's sample. Its own backward: autograd would keep every gathered corner."""

    @staticmethod
    def forward(ctx, rows, unit, resolution):
        scaled = unit * resolution
        node = scaled.long().clamp(max=resolution - 1)
        index = node_index(node, resolution, len(rows))
        w = scaled - node
        weight = corner_weights(w)
        ctx.save_for_backward(rows, index, w)
        ctx.resolution = resolution
        corners = rows.index_select(0, index.view(-1)).view(-1, 8, rows.shape[1])
        return torch.bmm(weight[:, None], corners).squeeze(1)

    @staticmethod
    def backward(ctx, grad):
        rows, index, w = ctx.saved_tensors
        flat = index.view(-1)
        grad_rows = grad_unit = None
        if ctx.needs_input_grad[0]:
            spread = corner_weights(w)[..., None] * grad[:, None]
            grad_rows = torch.zeros_like(rows).index_add_(0, flat, spread.view(-1, rows.shape[1]))
        if ctx.needs_input_grad[1]:
            corners = rows.index_select(0, flat).view(-1, 8, rows.shape[1])
            along = (corners * grad[:, None]).sum(-1).view(-1, 2, 2, 2)
            x, y, z = torch.stack([1 - w, w], 1).unbind(-1)
            slopes = (
                torch.einsum("nyz,ny,nz->n", along[:, 1] - along[:, 0], y, z),
                torch.einsum("nxz,nx,nz->n", along[:, :, 1] - along[:, :, 0], x, z),
                torch.einsum("nxy,nx,ny->n", along[..., 1] - along[..., 0], x, y),
            )
            grad_unit = torch.stack(slopes, 1) * ctx.resolution
        return grad_rows, grad_unit, None
