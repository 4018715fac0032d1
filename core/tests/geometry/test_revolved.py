"""Round parts brought onto their profile."""

import numpy as np
import torch

from core.geometry.faces import normals_of, unit
from core.geometry.revolved import axis, connected, on_one_axis, revolved
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, tet_grid
from core.prior.solids import box, cut, join, lathe, moved, ring, tube

GRID = tet_grid(40)
CELL = 2 * EXTENT / 40
AXIS = (0.13, -0.07)
VASE = lathe([(0.3, -0.7), (0.55, -0.1), (0.25, 0.4), (0.4, 0.7)], center=AXIS)


def lumpy(solid, height=0.4):
    """The solid's mesh from a lattice, with lumps of ``height`` cells."""
    points = GRID.tet_verts
    lumps = (points * torch.tensor([9.0, 11.0, 5.0])).sin().prod(1)
    verts, faces, *_ = surface(solid(points) + height * CELL * lumps, points, GRID)
    return verts, faces


def upright(*fraction: float) -> tuple[tuple[float, ...], ...]:
    """Of each part, the same all around an upright axis."""
    return (0.0,) * len(fraction), (0.0,) * len(fraction), fraction


def test_a_lumpy_vase_comes_to_its_profile_about_its_own_axis():
    verts, faces = lumpy(VASE)
    part = torch.zeros(len(verts), dtype=torch.long)
    made = revolved(verts, faces, part, upright(0.95), CELL)
    # Away from the rims, which a mean over the profile rounds.
    inner = verts[:, 2].abs() < 0.6
    before, after = (VASE(v[inner]).abs() / CELL for v in (verts, made))
    assert after.mean() < 0.5 * before.mean()
    assert float((made - verts).norm(dim=1).max()) <= 1.5 * CELL + 1e-6


def test_the_axis_is_found_next_to_the_middle_and_past_a_handle():
    solid = join(VASE, moved(tube((0.0, 0.0, -0.3), (0.35, 0.0, 0.3), 0.08), (0.5, -0.07, 0.0)))
    verts, faces = lumpy(solid, 0.2)
    v, f = verts.double().numpy() / CELL, faces.numpy()
    found = axis(v, unit(normals_of(v, f))) * CELL
    assert abs(found[0] - AXIS[0]) < 0.5 * CELL and abs(found[1] - AXIS[1]) < 0.5 * CELL


def test_other_parts_and_parts_that_are_not_round_stay_to_the_last_bit():
    leg = box((0.8, 0.0, 0.0), (0.1, 0.1, 0.6))
    verts, faces = lumpy(join(VASE, leg))
    part = (verts[:, 0] > 0.7).long()
    made = revolved(verts, faces, part, upright(0.95, 0.9), CELL)
    assert torch.equal(made[part == 1], verts[part == 1].double().to(made.dtype))
    assert not torch.equal(made[part == 0], verts[part == 0])
    same = revolved(verts, faces, part, upright(0.9, 0.9), CELL)
    assert torch.allclose(same, verts, atol=1e-7)


def test_where_the_part_ends_its_vertices_go_as_their_neighbours_do():
    handle = moved(tube((0.0, 0.0, -0.1), (0.35, 0.0, 0.1), 0.1), (0.45, -0.07, 0.0))
    verts, faces = lumpy(join(VASE, handle))
    part = (verts[:, 0] > 0.62).long()
    made = revolved(verts, faces, part, upright(0.95, 0.0), CELL)
    one, other = faces[:, [0, 1, 2]].reshape(-1), faces[:, [1, 2, 0]].reshape(-1)
    border = part[one] != part[other]
    stretched = (made[one] - made[other] - verts[one] + verts[other]).norm(dim=1)[border]
    assert len(stretched) > 10 and float(stretched.quantile(0.95)) < 0.4 * CELL


def test_each_wheel_comes_to_a_profile_about_its_own_lying_axis():
    wheels = [tube((-0.9, y, z), (-0.5, y, z), 0.3, 0.04) for y, z in ((-0.5, 0.0), (0.5, 0.1))]
    verts, faces = lumpy(join(*wheels), 0.8)
    part = torch.zeros(len(verts), dtype=torch.long)
    along_x = (0.95,), (0.2,), (0.2,)
    made = revolved(verts, faces, part, along_x, CELL)
    for wheel, side in zip(wheels, (verts[:, 1] < 0, verts[:, 1] > 0), strict=True):
        # Away from the edges, which a mean over the profile rounds.
        middle = side & ((verts[:, 0] + 0.7).abs() < 0.12)
        before, after = (wheel(v[middle]).abs() / CELL for v in (verts, made))
        assert after.mean() < 0.6 * before.mean()
    upright_instead = revolved(verts, faces, part, along_x[::-1], CELL)
    assert (join(*wheels)(upright_instead).abs()).mean() > join(*wheels)(made).abs().mean()


def test_components_are_told_apart_by_their_edges():
    faces = np.array([[0, 1, 2], [2, 3, 4], [5, 6, 7]])
    found = connected(faces, np.array([1, 1, 0, 1, 1, 1, 1, 0], bool))
    assert sorted(np.flatnonzero(each).tolist() for each in found) == [[0, 1], [3, 4], [5, 6]]


def test_components_on_one_axis_are_one_and_small_ones_join_where_there_is_no_other():
    vase, faces = lumpy(VASE, 0.2)
    v, f = vase.double().numpy() / CELL, faces.numpy()
    band = np.abs(v[:, 2]) < 1.5  # a hoop parts the vase in two
    (found,) = on_one_axis(v, f, ~band)
    assert np.array_equal(found, ~band)
    beside_it = join(VASE, tube((-0.8, 0.7, -0.3), (-0.8, 0.7, 0.3), 0.2))
    verts, faces = lumpy(beside_it, 0.2)
    every = np.ones(len(verts), bool)
    both = on_one_axis(verts.double().numpy() / CELL, faces.numpy(), every)
    assert len(both) == 2 and not (both[0] & both[1]).any()


def test_a_rim_is_a_sharp_line():
    cup = tube((0.0, 0.0, -0.6), (0.0, 0.0, 0.6), 0.5)
    verts, faces = lumpy(cup, 0.1)
    part = torch.zeros(len(verts), dtype=torch.long)
    made = revolved(verts, faces, part, upright(0.95), CELL)
    corner = torch.tensor([0.5, 0.6])
    near = (radius_and_height(verts) - corner).norm(dim=1) < 0.6 * CELL
    before, after = (radius_and_height(m)[near].std(0) / CELL for m in (verts, made))
    assert near.sum() > 50
    assert (after < before / 2).all(), (before, after)


def test_the_rim_of_a_thin_wall_is_no_blade():
    wall, height = 2.2 * CELL, 0.6
    outer = tube((0.0, 0.0, -height), (0.0, 0.0, height), 0.6)
    inner = tube((0.0, 0.0, wall - height), (0.0, 0.0, 1.0), 0.6 - wall)
    rim = ring((0.0, 0.0, height), 0.6 - wall / 2, wall / 2)
    verts, faces = lumpy(join(cut(outer, inner), rim), 0.5)
    part = torch.zeros(len(verts), dtype=torch.long)
    made = radius_and_height(revolved(verts, faces, part, upright(0.95), CELL))
    top = made[(verts[:, 2] > height) & (verts[:, :2].norm(dim=1) > 0.6 - wall)]
    assert len(top) > 100
    assert top[:, 0].std() > 0.5 * CELL  # of a half circle of that width: 0.78


def radius_and_height(verts: torch.Tensor) -> torch.Tensor:
    return torch.stack([verts[:, :2].norm(dim=1), verts[:, 2].abs()], 1)
