"""The tetrahedral lattice: it fills the cube, and its tables agree with one another."""

import pytest
import torch

from core.errors import UserError
from core.geometry.tet_grid import TET_CORNERS, tet_grid


@pytest.mark.parametrize("resolution", [2, 3, 6])
def test_tets_fill_the_cube(resolution):
    grid = tet_grid(resolution, extent=0.7)
    p = grid.tet_verts.double()[grid.tets.long()]
    volumes = torch.linalg.det(p[:, 1:] - p[:, :1]) / 6
    torch.testing.assert_close(volumes, torch.full_like(volumes, grid.cell**3 / 6))
    assert len(grid.tets) == 6 * resolution**3
    assert len(grid.tet_verts) == (resolution + 1) ** 3


@pytest.mark.parametrize("resolution", [2, 5])
def test_tables_equal_those_found_by_sorting(resolution):
    grid = tet_grid(resolution)
    pairs = grid.tets.long()[:, torch.tensor(TET_CORNERS)].sort(-1).values
    distinct = {tuple(pair) for pair in pairs.view(-1, 2).tolist()}
    assert sorted(distinct) == sorted(tuple(edge) for edge in grid.edges.tolist())
    assert torch.equal(grid.edges.long()[grid.tet_edges.long()], pairs)


def test_tets_fit_face_to_face():
    grid = tet_grid(3)
    t = grid.tets.long()
    sides = torch.cat([t[:, [i for i in range(4) if i != j]] for j in range(4)]).sort(-1).values
    _, count = sides.unique(dim=0, return_counts=True)
    on_rim = 12 * 3**2  # two triangles on each of the 6 n² outer squares
    assert (count == 1).sum() == on_rim
    assert count.max() == 2


def test_nodes_are_where_the_docstring_states():
    grid = tet_grid(4, extent=1.0)
    i, j, k = 1, 3, 2
    node = grid.tet_verts[(i * 5 + j) * 5 + k]
    torch.testing.assert_close(node, -1 + grid.cell * torch.tensor([i, j, k]))
    assert grid.cell == 0.5
    assert torch.equal(grid.boundary, grid.tet_verts.abs().amax(1) == 1.0)


@pytest.mark.parametrize(("resolution", "extent"), [(1, 1.0), (0, 1.0), (-3, 1.0), (8, 0.0)])
def test_useless_lattices_are_refused(resolution, extent):
    with pytest.raises(UserError, match=r"resolution|extent"):
        tet_grid(resolution, extent)
