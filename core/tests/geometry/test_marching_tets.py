"""Marching tetrahedra: closed, outward, second order, and with the right gradient."""

import itertools
import math

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from core.geometry.marching_tets import MARGIN, TRIANGLES, crossing_edges, marching_tets
from core.geometry.mesh import face_areas, health, signed_volume
from core.geometry.tet_grid import TET_CORNERS, tet_grid

SMALL = tet_grid(5)


def sphere(resolution, radius=0.8):
    grid = tet_grid(resolution)
    p = grid.tet_verts.double()
    return marching_tets(p, p.norm(dim=1) - radius, grid)


def test_every_case_of_one_tet_separates_inside_from_outside():
    p = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    middle = torch.stack([(p[a] + p[b]) / 2 for a, b in TET_CORNERS])
    for case, triangles in enumerate(TRIANGLES):
        inside = [bool(case >> c & 1) for c in range(4)]
        crossed = [e for e, (a, b) in enumerate(TET_CORNERS) if inside[a] != inside[b]]
        assert sorted(set(triangles)) == crossed
        for first in range(0, len(triangles), 3):
            a, b, c = middle[list(triangles[first : first + 3])]
            side = (p - a) @ torch.linalg.cross(b - a, c - a)
            assert [bool(s < 0) for s in side] == inside


def test_sphere_is_closed_outward_and_of_genus_0():
    verts, faces = sphere(12)
    report = health(verts, faces)
    assert report["closed"]
    assert report["manifold"]
    assert report["oriented"]
    assert (report["euler"], report["genus"], report["components"]) == (2, 0, 1)
    a, b, c = verts[faces].unbind(1)
    assert ((a + b + c) * torch.linalg.cross(b - a, c - a)).sum(1).min() > 0


def test_torus_has_genus_1():
    grid = tet_grid(24)
    x, y, z = grid.tet_verts.unbind(1)
    sdf = ((x**2 + y**2).sqrt() - 0.6).square().add(z**2).sqrt() - 0.25
    assert health(*marching_tets(grid.tet_verts, sdf, grid))["genus"] == 1


def test_area_and_volume_converge_at_second_order():
    errors = []
    for resolution in (12, 24, 48):
        verts, faces = sphere(resolution)
        area = float(face_areas(verts, faces).sum()) / (4 * math.pi * 0.8**2)
        volume = signed_volume(verts, faces) / (4 / 3 * math.pi * 0.8**3)
        errors.append((abs(1 - area), abs(1 - volume)))
    for coarse, fine in itertools.pairwise(errors):
        for e_coarse, e_fine in zip(coarse, fine, strict=True):
            assert math.log2(e_coarse / e_fine) == pytest.approx(2, abs=0.35)
    assert max(errors[-1]) < 0.002


def test_verts_are_on_the_zero_of_the_linear_interpolant():
    verts, _ = sphere(10)
    grid = tet_grid(10)
    p = grid.tet_verts.double()
    s = p.norm(dim=1) - 0.8
    ends = grid.edges[crossing_edges(s, grid)].long()
    length = (p[ends[:, 1]] - p[ends[:, 0]]).norm(dim=1)
    t = (verts - p[ends[:, 0]]).norm(dim=1) / length
    inner = (t > MARGIN * 1.01) & (t < 1 - MARGIN * 1.01)
    value = s[ends[:, 0]] * (1 - t) + s[ends[:, 1]] * t
    assert inner.sum() > 100
    assert value[inner].abs().max() < 1e-12


def test_gradient_in_sdf_and_positions():
    grid = tet_grid(3)
    g = torch.Generator().manual_seed(3)
    sdf = torch.rand(len(grid.tet_verts), generator=g, dtype=torch.float64) + 0.2
    sdf = torch.where(torch.rand(sdf.shape, generator=g) < 0.5, sdf, -sdf).requires_grad_()
    noise = torch.randn(grid.tet_verts.shape, generator=g, dtype=torch.float64)
    positions = (grid.tet_verts + 0.1 * noise).requires_grad_()
    assert len(marching_tets(positions, sdf, grid)[1]) > 20

    def verts(p, s):
        return marching_tets(p, s, grid)[0]

    assert torch.autograd.gradcheck(verts, (positions, sdf))


@settings(max_examples=40, deadline=None)
@given(
    seed=st.integers(0, 2**31),
    fraction=st.floats(0, 1),
    zeros=st.floats(0, 0.5),
    scale=st.sampled_from([1e-40, 1e-30, 1e-6, 1.0, 1e30]),
)
def test_any_sdf_gives_a_closed_manifold_with_finite_gradient(seed, fraction, zeros, scale):
    g = torch.Generator().manual_seed(seed)
    sdf = (torch.rand(len(SMALL.tet_verts), generator=g) - fraction) * scale
    sdf = sdf * (torch.rand(sdf.shape, generator=g) >= zeros)
    sdf.requires_grad_()
    verts, faces = marching_tets(SMALL.tet_verts, sdf, SMALL)
    if not len(faces):
        assert not ((sdf < 0) & ~SMALL.boundary).any()
        return
    report = health(verts, faces)
    assert report["closed"]
    assert report["manifold"]
    assert report["oriented"]
    assert report["loose_verts"] == 0
    assert report["volume"] > 0
    verts.square().sum().backward()
    assert sdf.grad is not None
    assert sdf.grad.isfinite().all()


def test_zeros_are_outside_and_leave_no_face_without_normal():
    grid = tet_grid(8, extent=1.0)
    sdf = grid.tet_verts.abs().amax(1) - 0.5  # a box whose faces are lattice planes: all ties
    verts, faces = marching_tets(grid.tet_verts, sdf, grid)
    report = health(verts, faces)
    assert report["closed"]
    assert report["genus"] == 0
    assert report["degenerate_faces"] == 0
    on_box = verts.abs().amax(1)
    assert (on_box - 0.5).abs().max() < MARGIN
    assert crossing_edges(torch.zeros_like(sdf), grid).numel() == 0


def test_all_inside_is_a_closed_box():
    report = health(*marching_tets(SMALL.tet_verts, -torch.ones(6**3), SMALL))
    assert report["closed"]
    assert report["genus"] == 0


def test_scale_of_the_sdf_does_not_matter():
    p = SMALL.tet_verts
    sdf = p.norm(dim=1) - 0.55
    torch.testing.assert_close(
        marching_tets(p, sdf * 1e-4, SMALL)[0], marching_tets(p, sdf, SMALL)[0]
    )
