import math

import pytest
import torch

from core.geometry.mesh import Mesh
from core.geometry.uv_health import island_count, uv_health
from core.tests.texture_shapes import square, torus, torus_uv


def test_a_true_map_has_no_stretch_whatever_its_size() -> None:
    verts, faces, uv, face_uvs = square()
    for scale in (1.0, 0.1):
        found = uv_health(Mesh(verts, faces, scale * uv, face_uvs))
        assert found["uv_stretch"] == pytest.approx(1, abs=1e-4)
        assert found["uv_fill"] == pytest.approx(scale**2, abs=1e-4)


@pytest.mark.parametrize("k", [2.0, 5.0])
def test_a_map_drawn_out_along_u(k: float) -> None:
    """Singular values 1 / k and 1: root of (1 + 1 / k²) / 2, times the root of the area's k."""
    verts, faces, uv, face_uvs = square()
    wide = uv * torch.tensor([1.0, 1 / k])
    expected = math.sqrt((1 + k**2) / 2) / math.sqrt(k)
    assert uv_health(Mesh(verts, faces, wide, face_uvs))["uv_stretch"] == pytest.approx(
        expected, rel=1e-4
    )


def test_uneven_texels_count_as_stretch() -> None:
    """Two squares, one with a quarter of the other's texels: √((1 + 4) / 2 · (1 + 1/4) / 2)."""
    verts, faces, uv, face_uvs = square()
    verts = torch.cat([verts, verts + 2])
    faces, face_uvs = torch.cat([faces, faces + 4]), torch.cat([face_uvs, face_uvs + 4])
    found = uv_health(Mesh(verts, faces, torch.cat([uv, uv / 2]), face_uvs))
    assert found["uv_stretch"] == pytest.approx(1.25, rel=1e-4)
    assert found["uv_islands"] == 2


def test_faces_without_texels_are_counted_and_left_out() -> None:
    verts, faces, uv, face_uvs = square()
    face_uvs = face_uvs.clone()
    face_uvs[1] = 0
    found = uv_health(Mesh(verts, faces, uv, face_uvs))
    assert found["uv_flat"] == 1
    assert found["uv_stretch"] == pytest.approx(1, abs=1e-4)


def test_one_island_round_a_torus() -> None:
    verts, faces = torus()
    uv, face_uvs = torus_uv()
    assert island_count(face_uvs, len(uv)) == 1
    found = uv_health(Mesh(verts, faces, uv, face_uvs))
    assert 1 < found["uv_stretch"] < 1.5
    assert found["uv_fill"] == pytest.approx((1 - 0.12) ** 2, abs=1e-4)
