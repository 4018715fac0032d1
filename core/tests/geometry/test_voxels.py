"""A solid of cubes: closed, manifold, on its solid, linked, and within its budget."""

from itertools import product

import numpy as np
import pytest
import torch
from scipy.ndimage import label

from core.geometry.mesh import Mesh, health
from core.geometry.voxels import (
    TOUCHING,
    Lattice,
    atlas,
    linked,
    manifold,
    squares_of,
    surface,
    voxelised,
)
from core.tests.meshes import sphere
from core.texture.texels import uv_faults

BALL = Mesh(*sphere(4))
CUBE = surface(np.ones((1, 1, 1), bool))
FAR = 9.0  # cubes outside


def outside(*full: tuple[int, int, int], size: int = 4) -> np.ndarray:
    found = np.full((size,) * 3, FAR)
    found[tuple(np.array(full).T)] = -0.5
    return found


def block(*sides: float) -> Mesh:
    nodes, squares = CUBE
    verts = torch.from_numpy(nodes).float() * torch.tensor(sides)
    return Mesh(verts, torch.from_numpy(squares[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)))


def made_of(full: np.ndarray) -> dict[str, object]:
    nodes, squares = surface(full)
    faces = squares[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    return health(torch.from_numpy(nodes).float(), torch.from_numpy(faces))


def test_a_cube_is_a_cube():
    report = made_of(outside((1, 1, 1)) < 0)
    assert (report["verts"], report["faces"], report["genus"]) == (8, 12, 0)
    assert report["manifold"] and report["volume"] == pytest.approx(1)  # it looks outward


def test_a_ball_of_cubes():
    mesh = voxelised(BALL, 20, 20_000)
    report = health(mesh.verts, mesh.faces)
    assert report["closed"] and report["manifold"] and report["oriented"]
    assert (report["components"], report["genus"]) == (1, 0)
    radius = float(BALL.verts.norm(dim=1).max())
    assert report["volume"] == pytest.approx(4 / 3 * np.pi * radius**3, rel=0.15)
    assert float(mesh.verts[:, 2].min()) == pytest.approx(float(BALL.verts[:, 2].min()), abs=1e-5)
    assert mesh.flat
    sides = mesh.verts.amax(0) - mesh.verts.amin(0)
    cell = 2 * radius / 20
    torch.testing.assert_close(sides, sides.div(cell).round() * cell)  # whole cubes
    # What is mirrored stays so.
    for axis in (0, 1):
        flip = torch.ones(3)
        flip[axis] = -1
        nearest = torch.cdist((mesh.verts * flip).double(), mesh.verts.double()).amin(1)
        assert nearest.max() < 1e-4


def test_each_square_has_its_own_place_in_the_uv():
    mesh = voxelised(BALL, 12, 20_000)
    uv, face_uvs = mesh.atlas
    assert not uv_faults(uv, face_uvs)
    middles, outward = squares_of(mesh)
    assert 2 * len(middles) == len(mesh.faces)
    a, b, c = mesh.verts[mesh.faces[1::2]].unbind(1)  # the second half of each
    torch.testing.assert_close((a + b) / 2, middles)
    cell = float(outward[0].norm())
    torch.testing.assert_close(outward.norm(dim=1), torch.full((len(outward),), cell))
    assert float((b - c).norm(dim=1).max()) == pytest.approx(cell, rel=1e-4)
    assert (outward * middles).sum(1).min() > 0  # of a ball about the origin


def test_rows_of_squares_stay_apart():
    uv, corners = atlas(5)  # three in a row
    low, high = uv[corners].amin((1, 2)), uv[corners].amax((1, 2))
    assert len(corners) == 10 and low.min() > 0 and high.max() < 1
    places = uv[corners[::2]].mean(1)
    apart = (places[:, None] - places).abs().amax(-1) + torch.eye(5)
    assert apart.min() > 0.25


def test_too_many_faces_make_larger_cubes():
    many, few = voxelised(BALL, 24, 100_000), voxelised(BALL, 24, 900)
    assert len(few.faces) <= 900 < len(many.faces)


@pytest.mark.parametrize("thickness", [0.02, 0.1])
def test_what_is_thinner_than_a_cube_is_a_cube_thick(thickness):
    plate = block(1.0, thickness, 0.6)
    mesh = voxelised(plate, 10, 20_000)
    sides = (mesh.verts.amax(0) - mesh.verts.amin(0)) * 10
    torch.testing.assert_close(sides, torch.tensor([10.0, 1, 6]), atol=1e-3, rtol=0)
    assert health(mesh.verts, mesh.faces)["components"] == 1


def test_components_are_linked_where_the_solid_is_nearest():
    """Two cubes, and between them a rod that is too thin for any middle."""
    found = outside((0, 1, 1), (4, 1, 1), size=5)
    found[1:4, 1, 1] = 0.4
    found[1:4, 3, 3] = 0.4  # elsewhere: on the way to nothing
    full = linked(found, 1)
    assert full[:, 1, 1].all() and full.sum() == 5
    assert linked(found, 2).sum() == 2  # they are apart in the solid, too


def test_components_are_linked_around_what_is_far_outside():
    found = np.full((5, 3, 1), FAR)
    found[:, 0, 0] = (-0.5, 1.4, 1.4, 1.4, -0.5)  # straight
    found[:, 1, 0] = (FAR, 0.3, 0.3, 0.3, FAR)  # a little way round
    assert linked(found, 1)[:, :, 0].sum(0).tolist() == [2, 3, 0]


def test_of_what_no_middle_is_inside_there_is_something():
    found = np.full((3, 1, 1), 0.5)
    found[1] = 0.4
    assert linked(found, 1)[1, 0, 0]


def test_what_is_too_far_apart_stays_so():
    full = linked(outside((0, 0, 0), (3, 3, 3)), 1)
    assert label(full, TOUCHING)[1] == 2


def test_any_eight_cubes_become_a_manifold():
    for code in range(1, 256):
        full = (code >> np.arange(8) & 1).astype(bool).reshape(2, 2, 2)
        distance = np.where(full, -0.5, np.arange(8).reshape(2, 2, 2) + 1.0)
        found = manifold(full, distance)
        report = made_of(found)
        assert (found & full == full).all(), code
        assert report["manifold"] and report["closed"], code


def test_the_cube_that_is_least_outside_mends_an_edge():
    distance = outside((1, 1, 1), (2, 2, 1))
    distance[2, 1, 1] = 0.5
    found = manifold(distance < 0, distance)
    assert found[2, 1, 1] and found.sum() == 3


def test_a_lattice_is_about_the_middle_and_on_the_ground():
    plate = block(1.0, 0.55, 0.38)
    lattice = Lattice.around(plate, 10)
    assert lattice.outside.shape == (10, 6, 4)
    low, high = plate.verts.amin(0).numpy(), plate.verts.amax(0).numpy()
    end = lattice.start + lattice.cell * np.array(lattice.outside.shape)
    assert lattice.start[2] == pytest.approx(low[2])
    assert np.allclose((lattice.start + end)[:2], (low + high)[:2], atol=1e-6)
    at = np.array(list(product(*map(range, lattice.outside.shape))))
    inside = lattice.start + (at + 0.5) * lattice.cell
    truth = ((inside > low) & (inside < high)).all(1).reshape(lattice.outside.shape)
    assert (truth == (lattice.outside < 0)).all()
