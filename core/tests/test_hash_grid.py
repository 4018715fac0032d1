"""The hash grid against a slow reference implementation, its gradients, and its edges."""

import math

import pytest
import torch

from core.hash_grid import CORNERS, HashGrid, corner_weights, node_rows

PRIMES = (1, 2654435761, 805459861)


def small(features=2, dtype=torch.float64, **changes):
    """A grid with dense levels and hashed ones, and features of a size that shows."""
    settings = {"levels": 4, "log2_size": 8, "base": 3, "finest": 24} | changes
    grid = HashGrid(features=features, generator=torch.Generator().manual_seed(0), **settings)
    with torch.no_grad():
        grid.table.uniform_(-1, 1, generator=torch.Generator().manual_seed(1))
    return grid.to(dtype)


def points(count, seed=2, dtype=torch.float64):
    generator = torch.Generator().manual_seed(seed)
    return (torch.rand(count, 3, generator=generator, dtype=dtype) * 2 - 1) * 1.05


def slow_reference(grid, point):
    """One point's features by the paper's words, in Python's own integers."""
    features, start = [], 0
    for resolution, size in zip(grid.resolutions, grid.sizes, strict=True):
        scaled = [(float(x) / 2.1 + 0.5) * resolution for x in point]
        node = [min(math.floor(x), resolution - 1) for x in scaled]
        value = torch.zeros(grid.table.shape[1], dtype=torch.float64)
        for corner in CORNERS:
            i, j, k = (n + c for n, c in zip(node, corner, strict=True))
            if (resolution + 1) ** 3 <= size:
                row = (i * (resolution + 1) + j) * (resolution + 1) + k
            else:
                row = (i * PRIMES[0] ^ j * PRIMES[1] ^ k * PRIMES[2]) % size
            weight = 1.0
            for x, n, c in zip(scaled, node, corner, strict=True):
                weight *= x - n if c else 1 - (x - n)
            value += weight * grid.table[start + row].detach()
        features.append(value)
        start += size
    return torch.cat(features)


@pytest.mark.parametrize("features", [1, 2, 3])
def test_features_against_a_slow_reference(features):
    grid = small(features)
    assert 0 < sum((r + 1) ** 3 <= s for r, s in zip(grid.resolutions, grid.sizes, strict=True)) < 4
    p = points(40)
    expected = torch.stack([slow_reference(grid, point) for point in p])
    torch.testing.assert_close(grid(p).detach(), expected)


def test_hash_of_large_nodes_does_not_overflow():
    node = torch.tensor([[4095, 4095, 4095], [0, 1, 4000]], dtype=torch.int32)
    rows = node_rows(node.T, 4096, 2**19).T
    for n, found in zip(node.tolist(), rows.tolist(), strict=True):
        for corner, row in zip(CORNERS, found, strict=True):
            i, j, k = (a + b for a, b in zip(n, corner, strict=True))
            assert row == (i ^ j * PRIMES[1] ^ k * PRIMES[2]) % 2**19


@pytest.mark.parametrize("features", [2, 3])
def test_gradients_in_table_and_points(features):
    grid = small(features, levels=2, log2_size=6, finest=6)
    p = points(9).requires_grad_()
    assert torch.autograd.gradcheck(
        lambda table, p: torch.func.functional_call(grid, {"table": table}, (p,)),
        (grid.table, p),
        fast_mode=True,
    )


def test_a_repeated_point_adds_its_gradients():
    grid = small(dtype=torch.float32)
    p = points(3, dtype=torch.float32)
    (once,) = torch.autograd.grad(grid(p).sum(), grid.table)
    (thrice,) = torch.autograd.grad(grid(p.repeat(3, 1)).sum(), grid.table)
    torch.testing.assert_close(thrice, 3 * once)


def test_weights_of_a_cell_add_up_and_pick_their_corner():
    w = torch.rand(3, 50)
    torch.testing.assert_close(corner_weights(w).sum(0), torch.ones(50))
    corners = torch.tensor(CORNERS, dtype=torch.float32)
    torch.testing.assert_close(corner_weights(corners.T), torch.eye(8))
    torch.testing.assert_close(corners.T @ corner_weights(w), w)


def test_the_far_corner_and_the_outside_take_the_rim():
    grid = small()
    rim = torch.tensor([[1.05, 1.05, 1.05], [-1.05, 0.3, 1.05]], dtype=torch.float64)
    beyond = torch.tensor([[3.0, 1.2, 9.0], [-7.0, 0.3, 2.0]], dtype=torch.float64)
    torch.testing.assert_close(grid(beyond), grid(rim))
    coarse = grid.resolutions[0]
    last = grid.table[(coarse + 1) ** 3 - 1]
    torch.testing.assert_close(grid(rim)[0, :2], last)


def test_levels_grow_from_base_to_finest():
    grid = HashGrid(levels=16, log2_size=4)
    assert grid.resolutions[0] == 16
    assert grid.resolutions[-1] == 4096
    ratios = [b / a for a, b in zip(grid.resolutions, grid.resolutions[1:], strict=False)]
    assert max(ratios) - min(ratios) < 0.07
    assert HashGrid(levels=1).resolutions == [16]
    assert len(grid.table) == sum(grid.sizes) == 16 * 16


def test_the_initial_features_are_small_and_follow_the_generator():
    tables = [
        HashGrid(levels=2, generator=torch.Generator().manual_seed(s)).table for s in (1, 1, 2)
    ]
    assert torch.equal(tables[0], tables[1])
    assert not torch.equal(tables[0], tables[2])
    assert 0.9e-4 < float(tables[0].detach().abs().max()) <= 1e-4


def test_no_points_give_no_features():
    grid = small(dtype=torch.float32)
    empty = grid(torch.zeros(0, 3))
    assert empty.shape == (0, 8)
    empty.sum().backward()
    assert grid.table.grad.abs().max() == 0
