"""Marching tetrahedra: the zero surface of an SDF on the lattice, differentiable in both inputs.

Inside is sdf < 0; an exact zero is outside. The nodes on the lattice's rim count as outside, so
the mesh is always closed. Which edges the surface crosses is decided without gradient; where it
crosses them carries the gradient:

    v = p_a + t (p_b - p_a),  t = s_a / (s_a - s_b)

Source: Doi and Koide 1991; as a differentiable layer, Shen et al. 2021 (DMTet).
"""

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.geometry.tet_grid import DIRECTIONS, TetGrid
from core.ops import constant, places

# Two triangles at most, as edges of TET_CORNERS, for each set of inside corners (bit c = corner c
# inside) of a positively oriented tetrahedron; counter-clockwise seen from outside.
TRIANGLES = (
    (),
    (0, 1, 2),
    (0, 4, 3),
    (1, 2, 4, 1, 4, 3),
    (1, 3, 5),
    (0, 3, 5, 0, 5, 2),
    (0, 4, 5, 0, 5, 1),
    (2, 4, 5),
    (2, 5, 4),
    (0, 1, 5, 0, 5, 4),
    (0, 5, 3, 0, 2, 5),
    (1, 5, 3),
    (1, 3, 4, 1, 4, 2),
    (0, 3, 4),
    (0, 2, 1),
    (),
)
# A vertex stays this fraction of its edge away from the nodes. Where the SDF is 0 at a node all the
# edges around it would end in one point, and the triangles between them would have no normal.
MARGIN = 1e-3


def close_rim(sdf: Float[Tensor, " nt"], grid: TetGrid) -> Float[Tensor, " nt"]:
    """``sdf`` with the lattice's rim outside by half a cell at least."""
    return torch.where(grid.boundary, sdf.clamp(min=grid.cell / 2), sdf)


def crossing_edges(sdf: Float[Tensor, " nt"], grid: TetGrid) -> Int[Tensor, " c"]:
    """Indices into ``grid.edges`` of the edges with one end inside, ascending."""
    return places(_changes(_inside(sdf, grid), grid))[0]


def marching_tets(
    positions: Float[Tensor, "nt 3"], sdf: Float[Tensor, " nt"], grid: TetGrid
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The surface sdf = 0 of the lattice whose nodes are moved to ``positions``.

    One vertex for each crossing edge, in the order of :func:`crossing_edges`; faces face outward.
    Closed and edge-manifold for every finite ``sdf``; empty where nothing is inside.
    """
    with torch.no_grad():
        inside = _inside(sdf, grid)
        crossing, cubes = places(_changes(inside, grid), _crossed_cubes(inside))
        faces = _faces(inside, crossing, cubes, grid)
        ends = grid.edges.index_select(0, crossing).view(-1)
    # Values and positions of the crossing edges' ends only: the rest of the lattice gets no
    # gradient.
    s = close_rim(sdf, grid).index_select(0, ends).view(-1, 2)
    p = positions.index_select(0, ends).view(-1, 2, 3)
    t = _crossing(s[:, 0], s[:, 1])[:, None]
    return torch.lerp(p[:, 0], p[:, 1], t), faces


def _inside(sdf: Float[Tensor, " nt"], grid: TetGrid) -> Bool[Tensor, "x y z"]:
    return ((sdf < 0) & ~grid.boundary).view(grid.shape)


def _crossing(a: Float[Tensor, " c"], b: Float[Tensor, " c"]) -> Float[Tensor, " c"]:
    """t = a / (a - b) within MARGIN of [0, 1]; the gradient is that of the quotient."""
    # Values of opposite sign this small (1e-12 of a cell or less) would divide 0 by 0 backwards.
    difference = a - b
    t = a / torch.where(difference < 0, difference.clamp(max=-1e-12), difference.clamp(min=1e-12))
    # The clamp moves the value only: with its own gradient, 0, a vertex could not leave the margin.
    return t + (t.clamp(MARGIN, 1 - MARGIN) - t).detach()


def _changes(inside: Bool[Tensor, "x y z"], grid: TetGrid) -> Bool[Tensor, " e"]:
    """Whether an edge's ends differ, direction by direction as ``grid.edges`` is laid out."""
    n = grid.resolution
    changes = []
    for d in DIRECTIONS[1:]:
        low = inside[tuple(slice(0, n + 1 - s) for s in d)]
        high = inside[tuple(slice(s, n + 1) for s in d)]
        changes.append((low != high).reshape(-1))
    return torch.cat(changes)


def _faces(
    inside: Bool[Tensor, "x y z"],
    crossing: Int[Tensor, " c"],
    cubes: Int[Tensor, " k"],
    grid: TetGrid,
) -> Int[Tensor, "f 3"]:
    """The triangles of every tetrahedron that the surface crosses; all are in ``cubes``."""
    tets = (cubes[:, None] * 6 + torch.arange(6, device=cubes.device)).view(-1)
    corners = grid.tets.index_select(0, tets).view(-1)
    bits = inside.view(-1).index_select(0, corners).view(-1, 4).to(torch.uint8)
    case = bits[:, 0] | bits[:, 1] << 1 | bits[:, 2] << 2 | bits[:, 3] << 3
    case = case.long()  # as an index a uint8 tensor would be taken for a mask
    # From an edge's index to its vertex's; edges that are not crossed are never asked for.
    vertex = torch.zeros(len(grid.edges), dtype=torch.int64, device=inside.device)
    vertex[crossing] = torch.arange(len(crossing), device=inside.device)
    faces = []
    # Tetrahedra of one triangle and of two apart: no padding has to be taken out afterwards. A row
    # of the other kind is zeros, and never picked.
    kinds = [constant(tuple(len(t) == n for t in TRIANGLES), case.device) for n in (3, 6)]
    for n, where in zip((3, 6), places(*(has[case] for has in kinds)), strict=True):
        rows = tuple(t if len(t) == n else (0,) * n for t in TRIANGLES)
        table = constant(rows, case.device)[case.index_select(0, where)]
        edges = grid.tet_edges.index_select(0, tets.index_select(0, where)).long()
        faces.append(vertex[edges.gather(1, table)].view(-1, 3))
    return torch.cat(faces)


def _crossed_cubes(inside: Bool[Tensor, "x y z"]) -> Bool[Tensor, " q"]:
    """Whether a cube's corners differ; without it all tetrahedra would have to be gathered."""
    # Any and all of a cube's eight corners, one axis after another.
    any_z, all_z = inside[..., 1:] | inside[..., :-1], inside[..., 1:] & inside[..., :-1]
    any_y, all_y = any_z[:, 1:] | any_z[:, :-1], all_z[:, 1:] & all_z[:, :-1]
    mixed = (any_y[1:] | any_y[:-1]) & ~(all_y[1:] & all_y[:-1])
    return mixed.reshape(-1)
