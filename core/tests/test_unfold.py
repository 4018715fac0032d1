"""Faces that look against their surface are taken out, and the mesh stays as it is otherwise."""

import numpy as np
import pytest
import torch

from core.geometry.faces import areas_and_normals, unit
from core.geometry.mesh import health
from core.tests.meshes import sphere
from core.texture.unfold import unfolded


def from_a_ball(points: np.ndarray, normals: np.ndarray) -> np.ndarray:
    return 1 - (unit(points) * normals).sum(1)


def from_a_plane(points: np.ndarray, normals: np.ndarray) -> np.ndarray:
    return 1 - normals[:, 2]


def against(verts: np.ndarray, faces: np.ndarray) -> int:
    middles, (_, normals) = verts[faces].mean(1), areas_and_normals(verts, faces)
    return int((from_a_ball(middles, normals) > 1).sum())


def folded_ball() -> tuple[np.ndarray, np.ndarray]:
    """Vertices of a ball pushed over their neighbours, so that faces lie on others' backs."""
    verts, faces = (x.numpy() for x in sphere(4)[:2])
    verts = unit(verts.astype(np.float64))
    for vertex in range(20, len(verts), 97):
        ring = faces[(faces == vertex).any(1)]
        far = next(v for v in ring[0] if v != vertex)
        verts[vertex] = unit((verts[far] + 0.9 * (verts[far] - verts[vertex]))[None])[0]
    return verts, faces.astype(np.int64)


def test_what_is_folded_is_taken_out_and_the_topology_stays() -> None:
    verts, faces = folded_ball()
    made = unfolded(verts, faces, from_a_ball)
    assert (against(verts, faces), against(verts, made)) == (20, 0)
    report = health(torch.from_numpy(verts), torch.from_numpy(made))
    assert report["closed"] and report["oriented"] and report["manifold"]
    assert (report["genus"], report["degenerate_faces"]) == (0, 0)
    assert len(made) > 0.95 * len(faces)


def test_what_has_no_folds_stays_to_the_index() -> None:
    verts, faces = (x.numpy() for x in sphere(3)[:2])
    assert np.array_equal(unfolded(verts.astype(float), faces, from_a_ball), faces)


@pytest.mark.parametrize("size", [6, 9])
def test_an_open_border_stays_where_it_is(size: int) -> None:
    x, y = (a.ravel() for a in np.meshgrid(np.arange(size), np.arange(size), indexing="ij"))
    verts = np.stack([x, y, 0 * x], 1).astype(np.float64)
    cells = [i * size + j for i in range(size - 1) for j in range(size - 1)]
    faces = np.array(
        [f for a in cells for f in ((a, a + size, a + size + 1), (a, a + size + 1, a + 1))]
    )
    middle = size * (size // 2) + size // 2
    verts[middle, :2] += 1.3  # over the next ones
    made = unfolded(verts, faces, from_a_plane)
    before, after = (areas_and_normals(verts, f)[1][:, 2].min() for f in (faces, made))
    assert before < 0 < after
    rim = [k for k in range(len(verts)) if {x[k], y[k]} & {0, size - 1}]
    assert set(rim) <= set(made.ravel().tolist())


def test_faces_back_to_back_are_left_alone() -> None:
    verts = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    faces = np.array([[0, 1, 2], [0, 2, 1]])
    assert np.array_equal(unfolded(verts, faces, from_a_plane), faces)
    assert len(unfolded(verts, faces[:0], from_a_plane)) == 0
