"""Faces that look against their surface are taken out, and the mesh stays as it is otherwise."""

import numpy as np
import pytest
import torch

from core.geometry.faces import areas_and_normals, unit
from core.geometry.mesh import compact, health
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
    """Vertices of a ball pushed over their neighbours, so that faces are on others' backs."""
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


def grid(size: int) -> tuple[np.ndarray, np.ndarray]:
    x, y = (a.ravel() for a in np.meshgrid(np.arange(size), np.arange(size), indexing="ij"))
    cells = [i * size + j for i in range(size - 1) for j in range(size - 1)]
    corners = [f for a in cells for f in ((a, a + size, a + size + 1), (a, a + size + 1, a + 1))]
    return np.stack([x, y, 0 * x], 1).astype(np.float64), np.array(corners)


@pytest.mark.parametrize("size", [6, 9])
def test_an_open_border_stays_where_it_is(size: int) -> None:
    verts, faces = grid(size)
    rim = [k for k, (x, y, _) in enumerate(verts) if {x, y} & {0, size - 1}]
    middle = size * (size // 2) + size // 2
    verts[middle, :2] += 1.3  # over the next ones
    made = unfolded(verts, faces, from_a_plane)
    before, after = (areas_and_normals(verts, f)[1][:, 2].min() for f in (faces, made))
    assert before < 0 < after
    assert set(rim) <= set(made.ravel().tolist())


def test_no_face_is_made_that_has_no_area() -> None:
    """The second face is folded; its edge turned would leave one whose corners are in line."""
    flat = [(4, 0), (1, 1), (0, 0), (3, 0), (5, 0), (5, 1), (4, 2), (1, 2), (0, 2), (-1, 2)]
    verts = np.array([(x, y, 0.0) for x, y in flat])
    faces = np.array([[0, 1, 2], [1, 0, 3], [0, 4, 5], [0, 5, 6], [1, 7, 8], [1, 8, 9]])
    made = unfolded(verts, faces, from_a_plane)
    assert areas_and_normals(verts, made)[0].min() > 0.1


@pytest.mark.parametrize("seed", range(6))
def test_whatever_is_folded_the_topology_and_the_border_stay(seed: int) -> None:
    """Half a ball, its vertices strewn about but for those of its border."""
    verts, faces = (x.numpy() for x in sphere(3)[:2])
    verts = unit(verts.astype(np.float64))
    faces = faces[(verts[faces][..., 2] > -1e-9).all(1)]
    inner = verts[:, 2] > 1e-9
    rng = np.random.default_rng(seed)
    strewn = unit(verts + inner[:, None] * rng.normal(scale=0.12, size=verts.shape))
    made = unfolded(strewn, faces, from_a_ball)
    before, after = (
        health(*compact(torch.from_numpy(strewn), torch.from_numpy(f))) for f in (faces, made)
    )
    assert against(strewn, made) < against(strewn, faces) / 2
    for key in ("manifold", "oriented", "components", "euler", "open_edges", "degenerate_faces"):
        assert after[key] == before[key], key
    rim = set(np.flatnonzero(np.abs(verts[:, 2]) < 1e-9).tolist())
    assert rim <= set(made.ravel().tolist())


def test_faces_back_to_back_are_left_alone() -> None:
    verts = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    faces = np.array([[0, 1, 2], [0, 2, 1]])
    assert np.array_equal(unfolded(verts, faces, from_a_plane), faces)
    assert len(unfolded(verts, faces[:0], from_a_plane)) == 0
