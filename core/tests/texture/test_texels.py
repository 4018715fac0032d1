"""Texel -> point of the surface -> texel."""

import pytest
import torch

from core.errors import UserError
from core.tests.texture_shapes import square, torus_uv
from core.texture import texels as module
from core.texture.texels import barycentric, texel_points, uv_faults

SIZE = 64


def test_round_trip() -> None:
    """A point's uv is in the texel that it was found for, at one of its grid points."""
    uv, face_uvs = torus_uv()
    texels = texel_points(uv, face_uvs, SIZE, 4)
    at = torch.einsum("nk,nkc->nc", texels.bary, uv[face_uvs[texels.face]])
    column, row = at[:, 0] * SIZE, (1 - at[:, 1]) * SIZE
    assert torch.equal(row.floor().long() * SIZE + column.floor().long(), texels.index)
    for x in (column, row):
        assert ((x * 2 - 0.5) - (x * 2 - 0.5).round()).abs().max() < 1e-3


def test_bary_are_weights() -> None:
    texels = texel_points(*torus_uv(), SIZE, 4)
    assert texels.bary.amin() >= 0
    torch.testing.assert_close(texels.bary.sum(1), torch.ones(len(texels.bary)))


@pytest.mark.parametrize("samples", [1, 4, 9])
def test_coverage_is_area(samples: int) -> None:
    """The fraction of points that hit is the uv area, up to the border's perimeter."""
    uv, face_uvs = torus_uv(margin=0.13)
    texels = texel_points(uv, face_uvs, SIZE, samples)
    fraction = len(texels.index) / (SIZE**2 * samples)
    assert fraction == pytest.approx(0.74**2, abs=4 * 0.74 / SIZE)
    counts = texels.index.bincount()
    assert counts.max() == samples


def test_row_zero_is_the_top() -> None:
    """v = 1 is row 0, u = 0 is column 0."""
    verts, faces, uv, face_uvs = square()
    texels = texel_points(uv, face_uvs, 8, 1)
    points = torch.einsum("nk,nkc->nc", texels.bary, verts[faces[texels.face]])
    assert torch.equal(texels.index, torch.arange(64))
    torch.testing.assert_close(points[0], torch.tensor([0.5 / 8, 0, 7.5 / 8]))
    torch.testing.assert_close(points[-1], torch.tensor([7.5 / 8, 0, 0.5 / 8]))


def test_bands_change_nothing(monkeypatch) -> None:
    whole = texel_points(*torus_uv(), SIZE, 4)
    monkeypatch.setattr(module, "BAND", SIZE * 4 * 5)
    banded = texel_points(*torus_uv(), SIZE, 4)
    assert torch.equal(whole.index, banded.index)
    assert (whole.face == banded.face).float().mean() > 0.999  # points on a common edge
    at = [torch.einsum("nk,nkc->nc", t.bary, torus_uv()[0][torus_uv()[1][t.face]])
          for t in (whole, banded)]  # fmt: skip
    torch.testing.assert_close(*at)


def test_tiny_triangles_keep_their_points() -> None:
    """A triangle of a ten-thousandth of the texture: weights still give the point back."""
    corners = torch.tensor([[[0.7, 0.7], [0.7001, 0.7], [0.7, 0.7001]]])
    want = torch.tensor([[0.2, 0.5, 0.3]])
    at = torch.einsum("nk,nkc->nc", want.double(), corners.double()).float()
    torch.testing.assert_close(barycentric(at, corners), want, atol=2e-3, rtol=0)


def test_flat_triangle_has_no_weights_that_are_not_finite() -> None:
    corners = torch.tensor([[[0.5, 0.5], [0.6, 0.6], [0.7, 0.7]]])
    assert barycentric(torch.tensor([[0.55, 0.55]]), corners).isfinite().all()


def test_samples_are_a_square_number() -> None:
    with pytest.raises(UserError, match="3 samples"):
        texel_points(*torus_uv(), SIZE, 3)


def test_faults_of_a_users_uv() -> None:
    uv, face_uvs = torus_uv()
    assert uv_faults(uv, face_uvs) == []
    assert "outside" in uv_faults(uv + 0.5, face_uvs)[0]
    assert "no area" in uv_faults(uv * torch.tensor([1.0, 0.0]), face_uvs)[0]
    folded = torch.stack([(uv[:, 0] - 0.5).abs(), uv[:, 1]], -1)
    assert "overlap" in uv_faults(folded, face_uvs)[0]
