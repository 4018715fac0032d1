"""A tetrahedral lattice of any resolution, with its edge tables, all in closed form.

Each cube of a regular grid is cut into six congruent tetrahedra along its (1, 1, 1) diagonal
(Freudenthal; the same cut in every cube, so neighbours fit). The released Fantasia3D loads
Quartet's body-centred files instead. The cubic nodes are worth more here than the rounder cells:
trilinear samples, finite differences and the Fourier features of the nodes need no search.
"""

import itertools
from dataclasses import dataclass

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.errors import UserError

# The six monotone paths from a cube's corner 0 to its corner 7, one tetrahedron each.
PATHS = tuple(itertools.permutations(range(3)))
# Direction (dx, dy, dz) of an edge, by its code dx * 4 + dy * 2 + dz in 1..7.
DIRECTIONS = tuple(itertools.product((0, 1), repeat=3))
# The two corners of each of a tetrahedron's six edges.
TET_CORNERS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))

EXTENT = 1.05  # half the side of the cube that the training happens in


@dataclass(frozen=True, eq=False)
class TetGrid:
    """The lattice over the cube [-extent, extent]³.

    Node (i, j, k) has the index (i (n+1) + j) (n+1) + k, n the resolution, and is at
    -extent + cell (i, j, k). Cube c owns the tetrahedra 6c to 6c + 5. ``tets`` is positively
    oriented; ``tet_edges`` follows TET_CORNERS. Index tables are int32: half the memory.
    """

    tet_verts: Float[Tensor, "nt 3"]
    tets: Int[Tensor, "t 4"]
    edges: Int[Tensor, "e 2"]  # lower node first
    tet_edges: Int[Tensor, "t 6"]
    resolution: int  # cubes along an axis
    extent: float
    boundary: Bool[Tensor, " nt"]  # nodes on the cube's surface

    @property
    def cell(self) -> float:
        """Length of a cube's side."""
        return 2 * self.extent / self.resolution

    @property
    def shape(self) -> tuple[int, int, int]:
        """Nodes along x, y, z; ``sdf.view(grid.shape)`` is the volume."""
        return (self.resolution + 1,) * 3


def tet_grid(
    resolution: int, extent: float = EXTENT, device: "torch.device | str" = "cpu"
) -> TetGrid:
    """The lattice of ``resolution``³ cubes: (n+1)³ nodes, 6n³ tetrahedra.

    Raises UserError if there is no inner node (resolution below 2) or the extent is not positive.
    """
    if resolution < 2:
        raise UserError(
            f"The tetrahedral grid's resolution is {resolution}; it must be 2 or more.",
            "Choose a resolution between 16 (a draft) and 128.",
        )
    if not extent > 0:
        raise UserError(f"The grid's extent is {extent}; it must be positive.")
    n = resolution
    axis = torch.linspace(-extent, extent, n + 1, device=device)
    tet_verts = torch.stack(torch.meshgrid(axis, axis, axis, indexing="ij"), -1).view(-1, 3)
    rim = torch.zeros(n + 1, dtype=torch.bool, device=device)
    rim[0] = rim[-1] = True
    boundary = rim[:, None, None] | rim[None, :, None] | rim[None, None, :]
    return TetGrid(
        tet_verts=tet_verts,
        tets=_tets(n, device),
        edges=_edges(n, device),
        tet_edges=_tet_edges(n, device),
        resolution=n,
        extent=extent,
        boundary=boundary.reshape(-1),
    )


def _corners(path: tuple[int, int, int]) -> list[tuple[int, ...]]:
    """The tetrahedron of a path: its four corners within the cube, positively oriented."""
    corner, corners = [0, 0, 0], [(0, 0, 0)]
    for axis in path:
        corner[axis] = 1
        corners.append(tuple(corner))
    # An odd permutation's tetrahedron is inside out; exchanging two corners turns it.
    odd = sum(path[i] > path[j] for i, j in itertools.combinations(range(3), 2)) % 2
    return [corners[i] for i in ((0, 2, 1, 3) if odd else (0, 1, 2, 3))]


def _lattice_index(
    shape: tuple[int, int, int], start: tuple[int, ...], n: int, device: "torch.device | str"
) -> Int[Tensor, "n n n"]:
    """Flat index, in a volume of ``shape``, of cube (i, j, k)'s corner ``start``."""
    i, j, k = (torch.arange(s, s + n, dtype=torch.int32, device=device) for s in start)
    return (i[:, None, None] * shape[1] + j[:, None]) * shape[2] + k


def _tets(n: int, device: "torch.device | str") -> Int[Tensor, "t 4"]:
    """Nodes of every tetrahedron, cube by cube."""
    tets = torch.empty(n, n, n, 6, 4, dtype=torch.int32, device=device)
    for t, path in enumerate(PATHS):
        for c, corner in enumerate(_corners(path)):
            tets[..., t, c] = _lattice_index((n + 1,) * 3, corner, n, device)
    return tets.view(-1, 4)


def _edge_blocks(n: int) -> list[tuple[int, tuple[int, int, int]]]:
    """For each direction code: its first edge's index, and its edges' counts along x, y, z."""
    # No edge has code 0; an empty block keeps the codes usable as indices.
    blocks, first = [(0, (0, 0, 0))], 0
    for dx, dy, dz in DIRECTIONS[1:]:
        shape = (n + 1 - dx, n + 1 - dy, n + 1 - dz)
        blocks.append((first, shape))
        first += shape[0] * shape[1] * shape[2]
    return blocks


def _edges(n: int, device: "torch.device | str") -> Int[Tensor, "e 2"]:
    """Both nodes of every edge, direction by direction."""
    node = torch.arange((n + 1) ** 3, dtype=torch.int32, device=device).view((n + 1,) * 3)
    blocks = []
    for (dx, dy, dz), (_, (x, y, z)) in list(zip(DIRECTIONS, _edge_blocks(n), strict=True))[1:]:
        ends = node[:x, :y, :z], node[dx : dx + x, dy : dy + y, dz : dz + z]
        blocks.append(torch.stack([end.reshape(-1) for end in ends], 1))
    return torch.cat(blocks)


def _tet_edges(n: int, device: "torch.device | str") -> Int[Tensor, "t 6"]:
    """Edges of every tetrahedron, cube by cube, in the order of TET_CORNERS."""
    blocks = _edge_blocks(n)
    tet_edges = torch.empty(n, n, n, 6, 6, dtype=torch.int32, device=device)
    for t, path in enumerate(PATHS):
        corners = _corners(path)
        for e, (a, b) in enumerate(TET_CORNERS):
            # Paths are monotone: the lower end is lower along every axis, so the step is a
            # DIRECTION.
            low, high = sorted((corners[a], corners[b]))
            step = tuple(p - q for p, q in zip(high, low, strict=True))
            first, shape = blocks[DIRECTIONS.index(step)]
            tet_edges[..., t, e] = first + _lattice_index(shape, low, n, device)
    return tet_edges.view(-1, 6)
