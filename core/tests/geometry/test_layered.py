"""What is flat outlines one upon another is found so; what is not, is not."""

import numpy as np
import pytest
import torch
from scipy.spatial.transform import Rotation

from core.geometry.lattice import Lattice
from core.geometry.mesh import health
from core.geometry.parts.components import Component, Place
from core.geometry.parts.layered import drift, ends_fraction, layered, segments, wall
from core.geometry.parts.primitives import Primitive, packed, unpacked
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import tet_grid
from core.tests.geometry.test_outline import rectangle

ERROR, COUNT = 0.04, 40
GRID = tet_grid(COUNT, 0.9)
NODES = GRID.tet_verts.double().numpy()
UP, ALONG_Y = np.eye(3), np.roll(np.eye(3), 1, 1)
BOX = ((0.0, 0.0, 0.0), (0.6, 0.25, 0.5))


def box(p, center=BOX[0], half=BOX[1]):
    q = np.abs(p - center) - half
    return np.linalg.norm(q.clip(min=0), axis=1) + q.max(1).clip(max=0)


def arch(p):
    return np.maximum(box(p), 0.35 - np.hypot(p[:, 0], p[:, 2] + 0.5))


def shelf(p):
    """A board behind, a frame in front with two places."""
    empty = [box(p, (0.0, -0.1, z), (0.5, 0.25, 0.18)) for z in (-0.24, 0.24)]
    return np.maximum(box(p), -np.minimum(*empty))


def blade(p):
    """It tapers."""
    return np.maximum(box(p, half=(0.3, 0.1, 0.7)), (np.abs(p[:, 0]) + 0.5 * p[:, 2] - 0.35) / 1.12)


def crown(p):
    """Six points on a ring, each cut straight."""
    r, angle = np.hypot(p[:, 0], p[:, 1]), np.arctan2(p[:, 0], -p[:, 1])
    ring = np.maximum(np.abs(r - 0.6) - 0.09, np.abs(p[:, 2]) - 0.4)
    point = np.abs((angle * 6 / np.pi) % 2 - 1)  # 0 at a point, 1 between two
    return np.maximum(ring, (p[:, 2] + 0.1 - 0.5 * (1 - point)) * 0.5)


def component_of(distance, wave=0.0):
    field = distance(NODES) + wave * np.sin(19 * NODES).sum(1)
    verts, faces, *_ = surface(torch.from_numpy(field).float(), GRID.tet_verts, GRID)
    lattice = Lattice(field.reshape(GRID.shape), NODES[0], GRID.cell)
    place = Place(0, NODES[0], NODES[-1], lambda points: torch.zeros(len(points), dtype=torch.bool))
    return Component(place, verts, faces, lattice, ERROR)


def found_in(distance, frame, wave=0.0):
    return layered(component_of(distance, wave), frame)


def farthest(one, distance):
    """Off the true surface, of what the one's mesh has."""
    verts, _ = one.mesh(0.05)
    return np.abs(distance(verts.double().numpy())).max()


@pytest.mark.parametrize(("distance", "count"), [(arch, 1), (shelf, 2)])
def test_layers_are_found_along_their_axis(distance, count):
    one = found_in(distance, ALONG_Y, wave=0.002)
    assert one is not None and len(unpacked(one.lengths)) == count
    assert farthest(one, distance) < 0.02
    health_of = health(*one.mesh(0.05))
    assert health_of["closed"] and health_of["manifold"] and health_of["components"] == 1


def test_a_shelf_has_its_places_and_their_back():
    one = found_in(shelf, ALONG_Y)
    front, back = sorted(unpacked(one.lengths), key=lambda layer: -len(layer[2]))
    assert [len(layer[2]) for layer in (front, back)] == [3, 1]
    low, high = min(front[0], back[0]), max(front[1], back[1])
    assert (low, high) == pytest.approx((-0.25, 0.25), abs=5e-3)
    assert front[1] == back[0] == pytest.approx(0.15, abs=0.01)
    # Outside both have the same sides: no step.
    ends = [np.concatenate(layer[2]) for layer in (front, back)]
    assert np.array_equal(ends[0].min(0), ends[1].min(0))
    assert np.array_equal(ends[0].max(0), ends[1].max(0))


def test_layers_are_found_in_a_frame_of_their_own():
    turn = Rotation.from_rotvec([0.4, 0.2, 0.0]).as_matrix()
    tilted = lambda p: arch(p @ turn)  # noqa: E731
    assert found_in(tilted, ALONG_Y) is None or farthest(found_in(tilted, ALONG_Y), tilted) > 0.05
    one = found_in(tilted, turn @ ALONG_Y)
    assert one is not None and farthest(one, tilted) < 0.025


def test_the_rounded_ends_of_a_layer_do_not_lessen_its_outline():
    (layer,) = unpacked(found_in(cushion, ALONG_Y).lengths)
    ends = np.stack([x(np.concatenate(layer[2]), axis=0) for x in (np.min, np.max)])
    np.testing.assert_allclose(ends, [(-0.5, -0.6), (0.5, 0.6)], atol=1e-3)


def cushion(p):
    return box(p, half=(0.52, 0.17, 0.42)) - 0.08


def test_what_is_nearly_the_same_on_both_sides_is_so_in_a_layer():
    (layer,) = unpacked(found_in(arch, ALONG_Y, wave=0.002).lengths)
    x = np.concatenate(layer[2])[:, 1]
    assert abs(x.min() + x.max()) < 1e-3  # the waves are not: 0.004


def tower(p):
    """Three boxes, the middle one narrow."""
    return np.min([box(p, (0.0, 0.0, z), (x, x, 0.25)) for z, x in TOWER], 0)


TOWER = ((-0.5, 0.6), (0.0, 0.3), (0.5, 0.6))  # heights, half widths


def test_there_are_no_more_than_so_many_layers(monkeypatch):
    assert len(unpacked(found_in(tower, UP).lengths)) == 3
    monkeypatch.setattr("core.geometry.parts.layered.MOST", 2)
    assert found_in(tower, UP) is None


def test_a_layer_without_height_is_none(monkeypatch):
    """Both of its ends are the same faces."""
    monkeypatch.setattr("core.geometry.parts.layered.step_at", lambda *_: 0.0)
    assert found_in(arch, ALONG_Y) is None


def test_a_blade_has_no_layers():
    assert found_in(blade, UP) is None


@pytest.mark.parametrize("distance", [blade, lambda p: np.linalg.norm(p, axis=1) - 0.5])
def test_what_tapers_or_bulges_is_not_of_layers(distance):
    component = component_of(distance)
    one = layered(component, UP)
    assert one is None or not one.fits(component.verts.double().numpy(), ERROR)


def test_an_outline_around_a_line_is_a_wall():
    one = wall(component_of(crown, wave=0.002))
    assert one is not None and one.form == "wall"
    verts, faces = one.mesh(0.06)
    found = health(verts, faces)
    assert found["closed"] and found["manifold"] and (found["components"], found["genus"]) == (1, 1)
    p = verts.double().numpy()
    r = np.hypot(p[:, 0], p[:, 1])
    assert np.minimum(np.abs(r - 0.51), np.abs(r - 0.69)).max() < 0.1
    assert (r.min(), r.max()) == pytest.approx((0.51, 0.69), abs=0.015)  # inside and outside
    assert p[:, 2].min() == pytest.approx(-0.4, abs=0.015)
    assert np.quantile(np.abs(crown(p)), 0.9) < 0.02
    assert one.distance(verts).abs().max() < 0.015  # where the outline comes together
    # The six points are as high as each other, also where the outline comes together behind.
    angle = np.arctan2(p[:, 0], -p[:, 1])
    tops = [p[np.cos(angle - (k + 0.5) * np.pi / 3) > 0.99][:, 2].max() for k in range(6)]
    assert np.ptp(tops) < 0.05 and min(tops) > 0.3


def notched(p):
    """A ring with a notch in front."""
    r, angle = np.hypot(p[:, 0], p[:, 1]), np.arctan2(p[:, 0], -p[:, 1])
    notch = np.maximum(0.6 * np.abs(angle) - 0.2, -0.1 - p[:, 2])
    return np.maximum(np.maximum(np.abs(r - 0.6) - 0.09, np.abs(p[:, 2]) - 0.4), -notch)


def test_the_front_of_a_wall_is_in_front():
    assert farthest(wall(component_of(notched)), notched) < 0.06


def test_a_wall_within_another_is_none():
    def two(p):
        r = np.hypot(p[:, 0], p[:, 1])
        inner = np.maximum(np.abs(r - 0.4) - 0.1, np.abs(p[:, 2]) - 0.5)
        return np.minimum(inner, np.maximum(np.abs(r - 0.6) - 0.1, np.abs(p[:, 2] + 0.3) - 0.2))

    assert wall(component_of(two)) is None


def column(p):
    return np.maximum(np.hypot(p[:, 0], p[:, 1]) - 0.5, np.abs(p[:, 2]) - 0.5)


@pytest.mark.parametrize("distance", [arch, column, lambda p: np.linalg.norm(p, axis=1) - 0.5])
def test_what_has_no_empty_middle_or_bulges_is_no_wall(distance):
    assert wall(component_of(distance)) is None


def test_segments_are_the_runs_of_like_sections():
    one, other = np.full((6, 6), 1.0), np.full((6, 6), 1.0)
    one[1:4, 1:4], other[2:5, 1:3] = -1.0, -1.0
    mixed = np.stack([one] * 5 + [other] * 3 + [one] * 4)
    mixed += 0.1 * np.random.default_rng(0).standard_normal(mixed.shape) * (mixed < 0)
    assert segments(mixed) == [0, 5, 8, 12]
    assert segments(np.stack([one] * 7)) == [0, 7]


def test_drift_is_how_far_an_outline_moves():
    x, y = np.meshgrid(np.arange(24.0), np.arange(24.0), indexing="ij")
    still = np.stack([rectangle(x - 12, y - 12, (6.0, 4.0))] * 9)
    moving = np.stack([rectangle(x - 12 - k / 4, y - 12, (6.0, 4.0)) for k in range(9)])
    assert drift(still) == 0
    assert drift(moving) == pytest.approx(1.5, abs=0.1)  # from its second section to its eighth


def test_ends_are_what_is_across_the_axis():
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    turn = np.array([0.3, 0.2, 0.1])
    one = Primitive("layers", np.zeros(3), turn, packed([(0.0, 0.5, [square])]))
    assert ends_fraction(one) == pytest.approx(2 / (2 + 4 * 0.5))


def test_layers_as_numbers_and_back():
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    layers = [(-0.5, 0.25, [square, square[::-1] / 4 + 0.3]), (0.25, 0.5, [square * 2])]
    for (low, high, loops), (a, b, others) in zip(layers, unpacked(packed(layers)), strict=True):
        assert (low, high) == (a, b)
        assert len(loops) == len(others)
        assert all(np.array_equal(x, y) for x, y in zip(loops, others, strict=True))


def test_the_distance_of_layers_is_that_of_their_mesh():
    square = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])
    layers = [(-0.5, 0.0, [square, square[::-1] / 2]), (0.0, 0.3, [square / 2])]
    one = Primitive("layers", np.array([0.1, 0.0, -0.1]), np.array([0.3, 0.2, 0.1]), packed(layers))
    verts, faces = one.mesh(0.1)
    assert one.distance(verts).abs().max() < 1e-6
    middles = verts[faces].mean(1)
    assert one.distance(middles).abs().max() < 1e-6
    local = torch.tensor(
        [[0.0, 0.0, -0.25], [0.4, 0.0, -0.25], [0.0, 0.0, 0.15], [0.7, 0.0, -0.25], [0.5, 0.0, 0.4]]
    )
    placed = one._replace(center=np.zeros(3), turn=np.zeros(3))
    expected = [0.25, -0.1, -0.15, 0.2, np.hypot(0.25, 0.1)]
    # The empty middle is nearest to the layer upon it.
    assert placed.distance(local).tolist() == pytest.approx(expected, abs=1e-6)
