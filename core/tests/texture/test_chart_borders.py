"""Borders between charts are least cuts: short on what is flat, on edges where there are some."""

import numpy as np
import pytest
import trimesh

from core.geometry.faces import areas_and_normals, neighbours, unit
from core.texture.borders import cut, shortest


def test_a_jagged_border_on_a_plane_becomes_straight() -> None:
    """Teeth two squares long, one wide."""
    n = 24
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij")
    verts = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).reshape(-1)
    b = a + n + 1
    faces = np.concatenate([np.stack([a, b, a + 1], 1), np.stack([b, b + 1, a + 1], 1)])
    middle = verts[faces].mean(1)
    jagged = (middle[:, 0] + 2 * (middle[:, 1].astype(int) % 2) > 13).astype(np.int64)
    straight = drawn(verts, faces, jagged)
    assert length(verts, faces, straight) <= n + 1e-9 < 2 * n < length(verts, faces, jagged)


def test_a_border_goes_to_the_edge_next_to_it() -> None:
    """Of a box that was cut below its upper edges."""
    solid = trimesh.creation.box((1.0, 1.0, 1.0))
    for _ in range(4):
        solid = solid.subdivide()
    verts, faces = np.asarray(solid.vertices), np.asarray(solid.faces)
    middle = verts[faces].mean(1)
    found = drawn(verts, faces, (middle[:, 2] > 0.35).astype(np.int64))
    normal = areas_and_normals(verts, faces)[1]
    assert np.array_equal(found == 1, normal[:, 2] > 0.5)


@pytest.mark.parametrize("narrow", [0, 1])
def test_a_narrow_chart_keeps_its_middle(narrow: int) -> None:
    """Or the wide one, whose middle is farther from the border, would take all of it."""
    solid = trimesh.creation.box((1.0, 1.0, 0.2))
    for _ in range(4):
        solid = solid.subdivide()
    verts, faces = np.asarray(solid.vertices), np.asarray(solid.faces)
    middle = verts[faces].mean(1)
    spot = (np.abs(middle[:, :2]).max(1) < 0.12) & (middle[:, 2] > 0.09)
    found = drawn(verts, faces, np.where(spot, narrow, 1 - narrow))
    assert 0 < (found == narrow).sum() < 0.5 * len(found)


def test_the_least_cut_is_that_of_all_cuts() -> None:
    """Of a strip of ten faces."""
    faces = np.array([[i, i + 1, i + 2] if i % 2 else [i, i + 2, i + 1] for i in range(10)])
    cost = np.random.default_rng(0).integers(1, 100, (10, 3))
    adjacent = neighbours(faces)
    for f in range(10):
        for side, other in enumerate(adjacent[f]):
            if other > f:
                cost[other, adjacent[other].tolist().index(f)] = cost[f, side]
    fixed, mine = np.isin(np.arange(10), (0, 9)), np.arange(10) < 5
    found = cut(np.arange(10), adjacent, cost, fixed, mine)
    best = min(total(adjacent, cost, np.arange(10) < k) for k in range(1, 10))
    assert found[0]
    assert not found[9]
    assert total(adjacent, cost, found) == best


def total(adjacent: np.ndarray, cost: np.ndarray, mine: np.ndarray) -> int:
    """What the border of ``mine`` costs."""
    face, side = np.nonzero(adjacent >= 0)
    border = mine[face] & ~mine[adjacent[face, side]]
    return int(cost[face, side][border].sum())


def drawn(
    verts: np.ndarray, faces: np.ndarray, chart: np.ndarray, widest: float = -1.0
) -> np.ndarray:
    """``chart`` of two with the shortest border."""
    normal = areas_and_normals(verts, faces)[1]
    axis = unit(np.stack([normal[chart == one].sum(0) for one in (0, 1)]))
    return shortest(chart, neighbours(faces), verts[faces], normal, axis, widest)


def length(verts: np.ndarray, faces: np.ndarray, chart: np.ndarray) -> float:
    """Of the border between the charts."""
    adjacent = neighbours(faces)
    face, side = np.nonzero(adjacent >= 0)
    border = chart[face] > chart[adjacent[face, side]]
    ends = verts[faces[face, side]], verts[faces[face, (side + 1) % 3]]
    return float(np.linalg.norm(ends[0] - ends[1], axis=1)[border].sum())
