"""The bilateral filter of normals: planes get flat, edges and round things stay as they are."""

import math

import pytest
import torch
from scipy.spatial import KDTree

from core.benchmarks import ball
from core.benchmarks.fit_scores import curvature_error
from core.geometry.bilateral import flattened
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import face_areas, health
from core.geometry.tet_grid import tet_grid

HALF = 0.5
ROUNDS, SIGMA = 2, 0.3


def cube():
    """A cube askew in the lattice, as marching tets has it."""
    grid = tet_grid(32, extent=1.0)
    turn = torch.linalg.qr(torch.randn(3, 3, generator=torch.Generator().manual_seed(1)))[0]
    q = (grid.tet_verts @ turn).abs() - HALF
    sdf = q.clamp_min(0).norm(dim=1) + q.amax(1).clamp_max(0)
    return *marching_tets(grid.tet_verts, sdf, grid), turn


def noisy(verts, size):
    return verts + size * torch.randn(verts.shape, generator=torch.Generator().manual_seed(0))


def normals(verts, faces):
    a, b, c = verts[faces].unbind(1)
    return torch.nn.functional.normalize(torch.linalg.cross(b - a, c - a), dim=1)


def plane_error_deg(verts, faces, turn):
    """Mean angle, by area, of the faces to the cube's planes, two cells from its edges or more."""
    centres = (verts[faces].mean(1) @ turn).abs().sort(1).values
    inner = centres[:, 1] < HALF - 0.125
    cosine = (normals(verts, faces)[inner] @ turn).abs().amax(1).clamp(max=1)
    areas = face_areas(verts, faces)[inner]
    return float(torch.rad2deg((cosine.arccos() * areas).sum() / areas.sum()))


def edge_gap(verts, turn):
    """How far the middles of the cube's edges are from the surface."""
    middles = torch.tensor([[a * HALF, b * HALF, 0.0] for a in (-1, 1) for b in (-1, 1)])
    at = torch.cat([middles.roll(k, 1) for k in range(3)]) @ turn.T
    return float(KDTree(verts.numpy()).query(at.numpy())[0].mean())


def test_a_noisy_cube_gets_flat_and_keeps_its_edges() -> None:
    clean, faces, turn = cube()
    verts = noisy(clean, 0.003)
    flat = flattened(verts, faces, ROUNDS, SIGMA)
    assert plane_error_deg(verts, faces, turn) > 8
    assert plane_error_deg(flat, faces, turn) < 2.5
    # The lattice itself cuts the edges; the filter takes nothing more from them.
    assert edge_gap(flat, turn) < edge_gap(clean, turn) + 0.01


def test_a_ball_stays_round() -> None:
    verts, faces = ball(20_000, bump=0.0)
    flat = flattened(verts, faces, ROUNDS, SIGMA)
    assert curvature_error(flat, faces, 0.75) < 0.03
    assert float((flat.norm(dim=1) / 0.75 - 1).abs().max()) < 0.005


def test_thin_round_legs_do_not_get_square() -> None:
    """A tube as thin as a chair's leg on the draft's lattice: its section stays a circle."""
    grid = tet_grid(64)
    radius, p = 0.08, grid.tet_verts
    sdf = torch.maximum(p[:, :2].norm(dim=1) - radius, p[:, 2].abs() - 0.6)
    verts, faces = marching_tets(p, sdf, grid)
    flat = flattened(verts, faces, ROUNDS, SIGMA)
    section = flat[flat[:, 2].abs() < 0.45, :2]
    angle = torch.atan2(section[:, 1], section[:, 0])
    off = section.norm(dim=1) / radius - 1
    fourth = 2 * ((off - off.mean()) * (4 * angle).cos()).mean()
    assert abs(float(fourth)) < 0.03
    assert float(off.mean()) == pytest.approx(0, abs=0.02)


def test_closed_stays_closed_and_no_face_turns_over() -> None:
    clean, faces, _ = cube()
    verts = noisy(clean, 0.003)
    flat = flattened(verts, faces, ROUNDS, SIGMA)
    before, after = health(verts, faces), health(flat, faces)
    names = ("closed", "manifold", "genus", "components")
    assert [after[n] for n in names] == [before[n] for n in names] == [True, True, 0, 1]
    assert after["degenerate_faces"] <= before["degenerate_faces"]
    turned = (normals(verts, faces) * normals(flat, faces)).sum(1) < 0
    assert int(turned.sum()) == 0


def test_no_rounds_change_nothing_and_places_do_not_matter() -> None:
    verts, faces = ball(2_000)
    assert flattened(verts, faces, 0, SIGMA) is verts
    flat = flattened(verts.double(), faces, 1, SIGMA)
    angle = math.radians(40)
    turn = torch.eye(3, dtype=torch.float64)
    turn[0, 0] = turn[1, 1] = math.cos(angle)
    turn[0, 1], turn[1, 0] = -math.sin(angle), math.sin(angle)
    moved = flattened(3 * verts.double() @ turn.T + 5, faces, 1, SIGMA)
    assert torch.allclose(moved, 3 * flat @ turn.T + 5, atol=1e-9)
