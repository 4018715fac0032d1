"""Ψ, the shape (Eq. 2):

    (s(p), Δp) = Ψ(β(p); ψ)

β is an encoding of the point p: the paper's hash grid (released code: 16 levels of 2 features, a
table of 2^19, 16 to 4096 cells), or a few Fourier features, which need no table and are the
draft's on a CPU. Ψ is an MLP of three layers. The SDF is negative inside.
"""

import itertools
import math
from dataclasses import dataclass
from typing import Annotated, Literal, NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from core.geometry.leash import Leash
from core.geometry.marching_tets import crossing_edges, marching_tets
from core.geometry.residual import Residual
from core.geometry.tet_grid import EXTENT, TetGrid
from core.hash_grid import HashGrid
from core.ops import places
from core.ranges import Range


@dataclass(frozen=True, kw_only=True)
class SdfNetConfig:
    """Ψ's encoding and widths; the defaults are the paper's and the released code's."""

    encoding: Literal["hash", "fourier"] = "hash"
    width: Annotated[int, Range(1, 4096)] = 32  # hidden units
    # Hidden layers; the paper's three layers are two hidden and the output.
    hidden: Annotated[int, Range(1, 16)] = 2
    levels: Annotated[int, Range(1, 32)] = 16  # of the hash grid, and so on
    features: Annotated[int, Range(1, 8)] = 2
    log2_size: Annotated[int, Range(4, 24)] = 19
    base: Annotated[int, Range(1, 1024)] = 16
    finest: Annotated[int, Range(16, 65536)] = 4096
    octaves: Annotated[int, Range(0, 16)] = 3  # of the Fourier features
    # Scale of a lattice of values added to Ψ, on the fine lattice; 0 is none.
    residual: Annotated[float, Range(0.0, 10.0)] = 0.0


FINER = 1.001  # a lattice whose cells are not larger than this times the residual's has it
CACHED_POINTS = 4096  # of the MLP at a time on a CPU

HASH = SdfNetConfig()
FOURIER = SdfNetConfig(encoding="fourier", width=64)


class Surface(NamedTuple):
    """A mesh and the lattice values that it was drawn from."""

    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    sdf: Float[Tensor, " nt"]
    positions: Float[Tensor, "nt 3"]


class FourierFeatures(nn.Module):
    """p, then sin and cos of 1.5 · 2^k p for k below ``octaves``: 3 + 6 · octaves features.

    1.5 rad a unit: the lowest octave does not repeat within the lattice's ±1.05.
    """

    frequencies: Tensor

    def __init__(self, octaves: int) -> None:
        super().__init__()
        self.register_buffer("frequencies", 1.5 * 2.0 ** torch.arange(octaves), persistent=False)
        self.width = 3 + 6 * octaves

    def forward(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n w"]:
        phase = (points[:, None, :] * self.frequencies[:, None]).flatten(1)
        return torch.cat([points, phase.sin(), phase.cos()], -1)


class SdfNet(nn.Module):
    """Ψ over the lattice's cube; random until :func:`core.geometry.init_shape.fit` (Eq. 3)."""

    def __init__(
        self,
        cell: float,
        config: SdfNetConfig = HASH,
        extent: float = EXTENT,
        generator: torch.Generator | None = None,
    ) -> None:
        """``cell``: the lattice's; an offset stays within half of it. ``extent``: the cube's."""
        super().__init__()
        self.cell = cell
        if config.encoding == "hash":
            self.encoding = HashGrid(
                levels=config.levels,
                features=config.features,
                log2_size=config.log2_size,
                base=config.base,
                finest=config.finest,
                extent=extent,
                generator=generator,
            )
        else:
            self.encoding = FourierFeatures(config.octaves)
        # The hash grid's released network has ReLUs and no bias. Smooth features want a smooth
        # activation: the kinks of a ReLU would show on the surface.
        hashed = config.encoding == "hash"
        widths = [self.encoding.width] + [config.width] * config.hidden
        layers: list[nn.Module] = []
        for inputs, outputs in itertools.pairwise(widths):
            layers.append(_linear(inputs, outputs, not hashed, generator))
            # beta 20: within ln 2 / 20 = 0.035 of a ReLU everywhere, and smooth.
            layers.append(nn.ReLU() if hashed else nn.Softplus(beta=20))
        layers.append(_linear(widths[-1], 4, not hashed, generator))
        self.mlp = nn.Sequential(*layers)
        self.residual: Residual | None = None
        self.leash: Leash | None = None  # of a guide
        # Γ, where one network is responsible for both (the paper's entangled ablation).
        self.material: nn.Module | None = None

    def forward(
        self, points: Float[Tensor, "n 3"]
    ) -> tuple[Float[Tensor, " n"], Float[Tensor, "n 3"]]:
        """SDF in units of length, and the node's offset, each part within half a cell."""
        features = self.encoding(points)
        # On a CPU the hidden units then stay in its cache, which saves up to a third of the time.
        at_once = CACHED_POINTS if points.device.type == "cpu" else max(len(points), 1)
        y = torch.cat([self.mlp(part) for part in features.split(at_once)])
        # tanh: no node gets farther than half a cell, so neighbours along an axis cannot pass.
        sdf, offset = y[:, 0], y[:, 1:].tanh() * (self.cell / 2)
        if self.residual is not None and self.cell <= FINER * self.residual.cell:
            more = self.residual(points)
            sdf = sdf + more[:, 0]
            offset = (offset + more[:, 1:]).clamp(-self.cell / 2, self.cell / 2)
        if self.leash is not None:
            sdf, offset = self.leash(points, sdf, offset, self.cell)
        return sdf, offset


def _linear(inputs: int, outputs: int, bias: bool, generator: torch.Generator | None) -> nn.Linear:
    """A linear layer with torch's own initial distribution, drawn from ``generator``."""
    layer = nn.Linear(inputs, outputs, bias=bias)
    bound = 1 / math.sqrt(inputs)
    for parameter in layer.parameters():
        nn.init.uniform_(parameter, -bound, bound, generator=generator)
    return layer


def sdf_on_grid(net: SdfNet, grid: TetGrid) -> tuple[Float[Tensor, " nt"], Float[Tensor, "nt 3"]]:
    """SDF and moved position of every node, all with gradient: for regularisers and ray_sdf."""
    sdf, offset = net(grid.tet_verts)
    return sdf, grid.tet_verts + offset


def surface(sdf: Float[Tensor, " nt"], positions: Float[Tensor, "nt 3"], grid: TetGrid) -> Surface:
    """The surface of lattice values, such as those of :func:`sdf_on_grid`."""
    return Surface(*marching_tets(positions, sdf, grid), sdf, positions)


class Band(NamedTuple):
    """A lattice's values, and the nodes about the surface that are worth evaluating again."""

    sdf: Float[Tensor, " nt"]
    positions: Float[Tensor, "nt 3"]
    near: Int[Tensor, " near"]


@torch.no_grad()
def band_about(net: SdfNet, grid: TetGrid, reach: int) -> Band:
    """The nodes within ``reach`` cells of the surface, along each axis."""
    drawn = extract(net, grid)
    mask = torch.zeros(len(drawn.sdf), device=drawn.sdf.device)
    mask[grid.edges[crossing_edges(drawn.sdf, grid)].view(-1)] = 1
    volume = mask.view(1, 1, *grid.shape)
    for axis in range(3):  # a box is a line after a line after a line
        kernel = [2 * reach + 1 if k == axis else 1 for k in range(3)]
        volume = torch.nn.functional.max_pool3d(volume, kernel, 1, [k // 2 for k in kernel])
    return Band(drawn.sdf, drawn.positions, volume.view(-1).nonzero().squeeze(1))


def extract(net: SdfNet, grid: TetGrid, band: Band | None = None, chunk: int = 1 << 17) -> Surface:
    """The surface with its gradient, at the price of few nodes: a mesh depends on the ends of the
    crossing edges alone (about 4 % of the nodes), so the others are evaluated without gradient.

    Exact for a loss on ``verts``; ``sdf`` and ``positions`` carry gradient at those ends only.
    ``band``: only its nodes are evaluated, the others keep its values; for a surface that has
    not left it. ``chunk``: nodes at a time in the first pass.
    """
    with torch.no_grad():
        if band is None:
            sdf, positions = _values(net, grid.tet_verts, chunk)
        else:
            points = grid.tet_verts.index_select(0, band.near)
            sdf, positions = _values(net, points, chunk)
            # Nodes outside the band keep the values that they had when it was made.
            sdf = band.sdf.index_copy(0, band.near, sdf)
            positions = band.positions.index_copy(0, band.near, positions)
        # The ends of the crossing edges.
        touched = torch.zeros(len(sdf), dtype=torch.bool, device=sdf.device)
        touched[grid.edges[crossing_edges(sdf, grid)].view(-1)] = True
        (near,) = places(touched)
    if torch.is_grad_enabled() and len(near):
        points = grid.tet_verts.index_select(0, near)
        # The second pass: the few nodes that the mesh depends on, now with gradient.
        near_sdf, near_offset = net(points)
        sdf = sdf.index_copy(0, near, near_sdf)
        positions = positions.index_copy(0, near, points + near_offset)
    return surface(sdf, positions, grid)


def _values(
    net: SdfNet, points: Float[Tensor, "n 3"], chunk: int
) -> tuple[Float[Tensor, " n"], Float[Tensor, "n 3"]]:
    """SDF and moved positions of nodes."""
    parts = [net(part) for part in points.split(chunk)]
    return torch.cat([part[0] for part in parts]), points + torch.cat([part[1] for part in parts])
