"""Thin faces are taken out, and what that would break is left."""

import numpy as np
import pytest
import torch

from core.geometry.mesh import health
from core.texture.remesh import without_thin

THIN = 0.01


def taken_out(verts: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Both without thin faces."""
    out = without_thin(torch.from_numpy(verts), torch.from_numpy(faces), THIN)
    return out[0].numpy(), out[1].numpy()


def sheet(columns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A flat sheet of squares, whose columns of vertices are at ``columns``."""
    x, y = np.meshgrid(columns, np.linspace(0, 1, 6), indexing="ij")
    verts = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
    a = (np.arange(len(columns) - 1)[:, None] * 6 + np.arange(5)).reshape(-1)
    faces = np.concatenate([np.stack([a, a + 6, a + 1], 1), np.stack([a + 6, a + 7, a + 1], 1)])
    return verts, faces


def test_a_thin_strip_inside_goes_and_the_sheet_stays() -> None:
    verts, faces = sheet(np.array([0, 0.3, 0.6, 0.602, 0.8, 1]))
    points, left = taken_out(verts, faces)
    assert areas(points, left).sum() == pytest.approx(1, abs=1e-9)
    # But for one face at each end, whose short side is on the open border.
    assert (areas(points, left) < 1e-3).sum() == 2 < (areas(verts, faces) < 1e-3).sum()


def test_an_open_border_stays_where_it_is() -> None:
    verts, faces = sheet(np.array([0, 0.002, 0.3, 0.6, 1]))
    points, left = taken_out(verts, faces)
    assert border(points, left) == border(verts, faces)


def test_no_edge_is_made_twice() -> None:
    """The thin face (a, b, d) can't give its long side for the edge from a to e: there is one."""
    a, b, d, e, f, g = range(6)
    verts = np.array([[0, 1e-3, 0], [-1, 0, 0], [1, 0, 0], [0, -1, 0], [-0.5, -0.5, -1],
                      [0.5, -0.5, -1]], dtype=np.float64)  # fmt: skip
    faces = np.array([[a, b, d], [e, d, b], [a, f, b], [f, e, b], [a, d, g], [g, d, e],
                      [a, e, f], [a, g, e]])  # fmt: skip
    assert health(torch.from_numpy(verts), torch.from_numpy(faces))["closed"]
    points, left = taken_out(verts, faces)
    report = health(torch.from_numpy(points), torch.from_numpy(left))
    assert report["closed"]
    assert report["manifold"]


def areas(verts: np.ndarray, faces: np.ndarray) -> np.ndarray:
    p = verts[faces]
    return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2


def border(verts: np.ndarray, faces: np.ndarray) -> set[tuple[float, ...]]:
    """The places of the vertices on open edges."""
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), 1)
    found, count = np.unique(edges, axis=0, return_counts=True)
    return {tuple(x) for x in verts[np.unique(found[count == 1])].tolist()}
