"""Planes found in a mesh, and its vertices moved onto them."""

import numpy as np
import pytest
import torch

from core.geometry.crisp import crisp, patch_of
from core.geometry.faces import areas_and_normals, neighbours
from core.geometry.mesh import health
from core.geometry.planar import planes_of
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, tet_grid
from core.prior.solids import Solid, ball, box, join, tube

GRID = tet_grid(40)
CELL = 2 * EXTENT / 40
HALF = (0.62, 0.41, 0.53)
BOX = box((0.0, 0.0, 0.0), HALF, rounding=0.05)


def rippled(solid: Solid, height: float = 0.3) -> tuple[torch.Tensor, torch.Tensor]:
    """The solid's mesh from a lattice, with ripples of ``height`` cells."""
    points = GRID.tet_verts
    ripples = (points * torch.tensor([9.0, 11.0, 7.0])).sin().prod(1)
    verts, faces, *_ = surface(solid(points) + height * CELL * ripples, points, GRID)
    return verts, faces


def made(solid: Solid, part=None, flatness=(1.0,), height: float = 0.3):
    """The rippled mesh, and the same made crisp."""
    verts, faces = rippled(solid, height)
    of = torch.zeros(len(verts), dtype=torch.long) if part is None else part(verts)
    return verts, faces, crisp(verts, faces, verts, of, flatness, CELL)


def off_the_box(verts: torch.Tensor) -> torch.Tensor:
    """How far each vertex is from the nearest of the box's six planes."""
    return (verts.abs() - torch.tensor(HALF)).abs().amin(1)


def turned(verts: torch.Tensor, faces: torch.Tensor) -> int:
    """Faces that look away from a neighbour."""
    area, normal = areas_and_normals(verts.double().numpy(), faces.numpy())
    adjacent = neighbours(faces.numpy())
    cosine = (normal[adjacent] * normal[:, None]).sum(-1)
    return int(((cosine < -0.5).any(1) & (area > 1e-9)).sum())


def test_a_rippled_box_gets_its_planes_edges_and_corners_back():
    before, _, (verts, _faces) = made(BOX)
    assert off_the_box(before).max() > 0.3 * CELL
    # The planes are where the ripples' mean is, the same for all of a face's vertices.
    assert off_the_box(verts).max() < 0.1 * CELL
    for axis in range(3):
        for side in (-1, 1):
            on = (side * verts[:, axis] - HALF[axis]).abs() < 0.1 * CELL
            assert verts[on, axis].std() < 1e-6
    corners = torch.cartesian_prod(*(torch.tensor([-h, h]) for h in HALF))
    assert torch.cdist(corners, verts).amin(1).max() < 0.2 * CELL
    assert torch.cdist(corners, before).amin(1).max() > 0.6 * CELL


def test_the_mesh_stays_sound():
    _, old, (verts, faces) = made(BOX)
    report = health(verts, faces)
    assert report["closed"] and report["manifold"] and report["oriented"] and report["genus"] == 0
    assert report["degenerate_faces"] == 0 and turned(verts, faces) == 0
    assert 0.95 * len(old) < len(faces) < len(old)  # the slivers of the rounded edges are gone


@pytest.mark.parametrize("flatness", [0.0, 0.4, 1.0])
def test_what_is_round_stays_round(flatness):
    solid = join(ball((0.0, 0.0, 0.3), 0.45), tube((0.0, 0.0, -0.8), (0.0, 0.0, 0.0), 0.2))
    before, _, (verts, _) = made(solid, flatness=(flatness,), height=0.1)
    on_top = verts[:, 2] > 0
    radius = (verts[on_top] - torch.tensor([0.0, 0.0, 0.3])).norm(dim=1)
    was = (before[before[:, 2] > 0] - torch.tensor([0.0, 0.0, 0.3])).norm(dim=1)
    assert radius.std() < 1.1 * was.std() + 1e-6


CAN = tube((0.0, 0.0, -0.6), (0.0, 0.0, 0.6), 0.5)


def top_and_side(verts: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """Heights of the can's lid inside its rim; distances of its side from the axis."""
    radius = verts[:, :2].norm(dim=1)
    lid = ((verts[:, 2] - 0.6).abs() < 0.3 * CELL) & (radius < 0.4)
    return verts[lid, 2], radius[verts[:, 2].abs() < 0.4]


def test_a_mostly_round_thing_keeps_its_flat_ends():
    before, _, (verts, _) = made(CAN, flatness=(0.3,), height=0.15)
    top, side = top_and_side(verts)
    assert len(top) > 100 and top.std() < 1e-6
    assert side.std() < 1.1 * top_and_side(before)[1].std()


def test_what_bends_loses_its_ripples_if_wished_and_what_is_flat_stays_flat():
    before, faces = rippled(CAN, 0.0)
    noise = 0.08 * CELL * torch.randn(before.shape, generator=torch.Generator().manual_seed(0))
    of = torch.zeros(len(before), dtype=torch.long)
    stay, smooth = (
        crisp(before + noise, faces, before + noise, of, (0.3,), CELL, smooth=smooth)[0]
        for smooth in (False, True)
    )
    for verts in (stay, smooth):
        top, _ = top_and_side(verts)
        assert ((top - top.median()).abs() < 1e-6).float().mean() > 0.95
    assert top_and_side(smooth)[1].std() < 0.6 * top_and_side(stay)[1].std()
    assert smooth[:, :2].norm(dim=1).max() < 0.5 + CELL  # and goes nowhere else


def test_no_plane_goes_on_into_another_part():
    """A plate that stands out by little from a wall stays a plate where the parts are known."""
    wall, plate = box((0.0, 0.2, 0.0), (0.6, 0.2, 0.6)), box((0.0, 0.0, 0.0), (0.3, 0.05, 0.3))
    solid = join(wall, plate)

    def part(verts):
        inside = (verts[:, 0].abs() < 0.31) & (verts[:, 2].abs() < 0.31) & (verts[:, 1] < -0.01)
        return inside.long()

    _, _, (verts, _) = made(solid, part, (1.0, 1.0), height=0.1)
    middle = verts[(verts[:, 0].abs() < 0.2) & (verts[:, 2].abs() < 0.2) & (verts[:, 1] < 0.1)]
    around = verts[(verts[:, 0].abs() > 0.4) & (verts[:, 0].abs() < 0.55) & (verts[:, 1] < 0.1)]
    around = around[around[:, 2].abs() < 0.5]
    assert middle[:, 1].std() < 1e-6 and around[:, 1].std() < 1e-6
    assert float(around[:, 1].mean() - middle[:, 1].mean()) == pytest.approx(0.05, abs=0.2 * CELL)


def test_planes_nearly_along_an_axis_are_and_nearly_equal_ones_are_one():
    legs = [box((x, 0.0, 0.0), (0.14, 0.3, 0.7)) for x in (-0.5, 0.5)]
    tilted = join(*legs)
    verts, faces = rippled(lambda p: tilted(p + torch.tensor([0.0, 0.0, 0.03]) * p[:, :1]), 0.2)
    cells = verts.double().numpy() / CELL
    part = np.zeros(len(verts), np.int64)
    planes = planes_of(patch_of(cells, cells, faces.numpy(), part, np.array([1.0])))
    used = np.unique(planes.label[planes.label >= 0])
    table = planes.table[used]
    assert np.abs(table[:, :3]).max(1) == pytest.approx(1.0)
    # Both legs stand on one plane and end at one: two, and two in front and behind.
    assert (np.abs(table[:, 2]) == 1).sum() == 2 and (np.abs(table[:, 1]) == 1).sum() == 2
    assert (np.abs(table[:, 0]) == 1).sum() == 4
