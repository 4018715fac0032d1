"""The multiresolution hash grid that Ψ and Γ share: β of Eqs. 2 and 6.

Each level is a cubic grid of feature vectors over [-extent, extent]³, trilinearly sampled. A level
whose nodes outnumber the table is stored by a hash of the node, collisions and all.
Source: Müller et al. 2022, §3; 16 levels, 2 features, 2^19 rows, 16 to 4096 cells there and here.
"""

import itertools

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn
from torch.nn.functional import embedding_bag

from core import kernels

# Müller et al. 2022, Eq. 4: 1, 2654435761, 805459861; the second as the int32 of the same bits.
PRIMES = (1, 2654435761 - 2**32, 805459861)
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
        if kernels.supports(self.table, points):
            return kernels.SampleHashGrid.apply(self.table, unit, self.resolutions, self.sizes)
        return _Sample.apply(self.table, unit.T.contiguous(), self.resolutions, self.sizes)


def node_rows(node: Int[Tensor, "3 n"], resolution: int, size: int) -> Int[Tensor, "8 n"]:
    """Table rows of the eight corners of the cells that start at ``node``, in CORNERS' order."""
    side = resolution + 1
    dense = side**3 <= size
    strides = (side * side, side, 1) if dense else PRIMES
    low = [node[d] * stride for d, stride in enumerate(strides)]
    x, y, z = (torch.stack([a, a + s]) for a, s in zip(low, strides, strict=True))
    if dense:
        return (x[:, None, None] + y[None, :, None] + z).view(8, -1)
    return ((x[:, None, None] ^ y[None, :, None] ^ z) & (size - 1)).view(8, -1)


def corner_weights(w: Float[Tensor, "3 n"]) -> Float[Tensor, "8 n"]:
    """Trilinear weights of points at ``w`` in [0, 1]³ of their cells, in CORNERS' order."""
    x, y, z = torch.stack([1 - w, w], 1)
    return (x[:, None, None] * y[None, :, None] * z).view(8, -1)


class _Sample(torch.autograd.Function):
    """All levels' samples of points (3, N) in [0, 1]³.

    Its own backward: autograd would keep every gathered corner. Corners come before points in
    memory, so that the arithmetic runs along the points.
    """

    @staticmethod
    def forward(ctx, table, unit, resolutions, sizes):
        ctx.levels, samples, saved = list(zip(resolutions, sizes, strict=True)), [], []
        for rows, (resolution, size) in zip(table.split(sizes), ctx.levels, strict=True):
            node, w = _cell(unit, resolution)
            index, weight = node_rows(node, resolution, size), corner_weights(w)
            saved += [index, weight]
            index, weight = index.T.contiguous(), weight.T.contiguous()
            samples.append(embedding_bag(index, rows, mode="sum", per_sample_weights=weight))
        ctx.save_for_backward(table, unit, *saved)
        return torch.cat(samples, 1)

    @staticmethod
    def backward(ctx, grad):
        table, unit, *saved = ctx.saved_tensors
        sizes, features = [size for _, size in ctx.levels], table.shape[1]
        grad_table = torch.zeros_like(table) if ctx.needs_input_grad[0] else None
        grad_unit = torch.zeros_like(unit) if ctx.needs_input_grad[1] else None
        for level, part in enumerate(grad.split(features, 1)):
            index, weight = saved[2 * level : 2 * level + 2]
            if grad_table is not None:
                _add_rows(grad_table.split(sizes)[level], index.view(-1), _outer(weight, part))
            if grad_unit is not None:
                resolution = ctx.levels[level][0]
                rows = table.split(sizes)[level].index_select(0, index.view(-1))
                along = (rows.view(8, -1, features) * part).sum(-1)
                grad_unit += _slope(along, _cell(unit, resolution)[1]) * resolution
        return grad_table, grad_unit, None, None


def _cell(
    unit: Float[Tensor, "3 n"], resolution: int
) -> tuple[Int[Tensor, "3 n"], Float[Tensor, "3 n"]]:
    """The cell's first node, and the place within the cell, in [0, 1]³."""
    scaled = unit * resolution
    node = scaled.int().clamp(max=resolution - 1)
    return node, scaled - node


def _outer(weight: Float[Tensor, "8 n"], part: Float[Tensor, "n c"]) -> Float[Tensor, "m c"]:
    """Each corner's part of the gradient ``part``, corners before points: m = 8 n."""
    gradients = part.new_empty(*weight.shape, part.shape[1])
    for gradient, column in zip(gradients.unbind(-1), part.T.contiguous(), strict=True):
        torch.mul(
            weight, column, out=gradient
        )  # in place: stacking the columns takes thrice as long
    return gradients.flatten(0, 1)


def _add_rows(
    table: Float[Tensor, "r c"], index: Int[Tensor, " m"], values: Float[Tensor, "m c"]
) -> None:
    """Add ``values`` to the table's rows ``index``, in place."""
    if table.shape[1] == 2 and table.device.type == "cpu":
        # A pair as one complex number: half the time there.
        table, values = torch.view_as_complex(table), torch.view_as_complex(values)
    table.index_add_(0, index, values)


def _slope(corners: Float[Tensor, "8 n"], w: Float[Tensor, "3 n"]) -> Float[Tensor, "3 n"]:
    """Derivative, by the place in the cell, of the trilinear interpolant of ``corners``."""
    x, y, z = torch.stack([1 - w, w], 1)
    v = corners.view(2, 2, 2, -1)
    return torch.stack(
        [
            ((v[1] - v[0]) * y[:, None] * z).sum((0, 1)),
            ((v[:, 1] - v[:, 0]) * x[:, None] * z).sum((0, 1)),
            ((v[:, :, 1] - v[:, :, 0]) * x[:, None] * y).sum((0, 1)),
        ]
    )
