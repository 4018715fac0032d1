"""A component's primitive is found from its points, and its mesh is that solid."""

import numpy as np
import pytest
import torch
from scipy.spatial.transform import Rotation

from core.geometry.init_shape import sample_surface
from core.geometry.mesh import health
from core.geometry.parts.fitting import (
    ANY,
    Faces,
    _covered,
    _evened,
    _fitted,
    pointed,
    primitive_of,
)
from core.geometry.parts.primitives import Primitive

ERROR = 0.04
BLOCK = Faces(block=True)
CENTER = np.array([0.1, 0.2, 0.3])
TILTED, SIDEWAYS = np.array([0.0, 0.4, 0.0]), np.array([0.0, np.pi / 2, 0.0])


def solid(form, lengths, turn=(0.0, 0.0, 0.0)):
    return Primitive(form, CENTER, np.array(turn), np.array(lengths))


SOLIDS = [
    solid("ellipsoid", (0.2, 0.3, 0.1)),
    solid("ellipsoid", (0.2, 0.2, 0.2)),
    solid("box", (0.2, 0.3, 0.1, 0.0)),
    solid("box", (0.2, 0.3, 0.12, 0.0), TILTED),
    solid("box", (0.3, 0.4, 0.2, 0.09)),
    solid("frustum", (0.1, 0.3, 0.3, 0.0), SIDEWAYS),
    solid("frustum", (0.5, 0.2, 0.1, 0.0), TILTED),
    solid("capsule", (0.3, 0.12, 0.12)),
    solid("ring", (0.4, 0.12), SIDEWAYS),
]


def points_on(one, noise=0.005, count=400):
    verts, faces = one.mesh(0.05)
    points = sample_surface(verts, faces, count, torch.Generator().manual_seed(0)).double().numpy()
    return points + noise * np.random.default_rng(0).standard_normal(points.shape)


@pytest.mark.parametrize("one", SOLIDS, ids=lambda one: one.form)
def test_a_primitive_is_found_from_points_of_it(one):
    found = primitive_of(points_on(one), ERROR)
    assert found is not None and found.form == one.form
    # The same solid, though its axes may have other names: each is on the other's surface.
    for a, b in ((one, found), (found, one)):
        assert np.abs(a.at(points_on(b, noise=0.0))).max() < 0.02
    if one.form == "ellipsoid" and np.ptp(one.lengths) == 0:
        assert np.ptp(found.lengths) == 0  # a ball is one exactly
    if one.form == "frustum" and one.lengths[1] == one.lengths[2]:
        assert found.lengths[1] == found.lengths[2]
    if one.turn is not TILTED and np.abs(one.frame).max(0).min() > 0.999:
        assert np.abs(found.frame).max(0).min() == pytest.approx(1, abs=1e-12)  # exactly upright
    if one.form in ("box", "frustum") and not one.lengths[3]:
        assert not found.lengths[3]  # and sharp


def test_edges_that_are_hardly_blurred_are_sharp():
    points = points_on(solid("box", (0.2, 0.3, 0.1, 0.02)), noise=0.002)
    assert primitive_of(points, ERROR).lengths[3] == 0


def test_a_cone_gets_the_tip_that_was_rounded_off():
    rounded = solid("frustum", (0.5, 0.4, 0.03, 0.0), TILTED)
    found = primitive_of(points_on(rounded, noise=0.001), ERROR)
    assert found.lengths[1:3].min() == 0
    # Where the sides meet: by similar triangles 0.03 / (0.4 - 0.03) of the height farther.
    tip = CENTER + rounded.frame[:, 2] * (0.5 + 0.03 / 0.37)
    apex = found.center + found.frame[:, 2] * found.lengths[0] * (
        1 if found.lengths[2] == 0 else -1
    )
    assert np.linalg.norm(apex - tip) < 0.02


@pytest.mark.parametrize("lengths", [(0.5, 0.4, 0.09), (0.4, 0.06, 0.03), (0.1, 0.3, 0.25)])
def test_what_is_cut_short_stays_so(lengths):
    cut = solid("frustum", (*lengths, 0.0))
    assert pointed(cut, ERROR) is None
    assert primitive_of(points_on(cut), ERROR).lengths[1:3].min() > 0.02


def test_lengths_that_are_not_meant_to_be_one_stay_two():
    found = primitive_of(points_on(solid("ellipsoid", (0.4, 0.35, 0.2))), ERROR)
    assert found.lengths[:2] == pytest.approx((0.4, 0.35), abs=5e-3)
    one = solid("ellipsoid", (0.4, 0.3, 0.2))
    assert _evened(one, lambda _: 1.0) is one  # however well it fits


def test_a_ring_without_a_hole_covers_nothing():
    for tube, covered in ((0.12, True), (0.18, False)):
        one = solid("ring", (0.2, tube))
        assert _covered(one, points_on(one, noise=0.0), ERROR) == covered


def test_rims_are_no_rounder_than_a_ball():
    ball = points_on(solid("ellipsoid", (0.3, 0.3, 0.3)))
    *half, rim = _fitted(solid("box", (0.3, 0.3, 0.3, 0.05)), ball, ERROR, rims=True).lengths
    assert min(half) >= rim > 0.28


def test_points_far_off_count_less():
    ball = solid("ellipsoid", (0.3, 0.3, 0.3))
    points = points_on(ball, noise=0.002)
    points[::20] += (CENTER - points[::20]) / 2
    assert np.abs(_fitted(ball, points, ERROR).lengths - 0.3).max() < 5e-3  # 0.01 by plain squares


@pytest.mark.parametrize("one", SOLIDS, ids=lambda one: one.form)
def test_a_primitive_has_the_mesh_of_its_distance(one):
    verts, faces = one.mesh(0.05)
    found = health(verts, faces)
    assert found["closed"] and found["manifold"] and found["components"] == 1
    assert found["genus"] == (1 if one.form == "ring" else 0) and found["volume"] > 0
    assert one.distance(verts).abs().max() < 2e-3
    edges = verts[faces] - verts[faces].roll(1, 1)
    assert edges.norm(dim=2).max() < 2 * 0.05
    far = verts.double() + 5 * (verts - torch.from_numpy(CENTER))
    assert one.distance(far).min() > 0


def test_the_exact_distance_of_a_frustum_a_box_and_a_capsule():
    places = np.array([[0.5, 0.0, 0.0], [0.0, 0.0, 0.9], [0.5, 0.0, 0.9], [0.0, 0.0, 0.0]])
    cylinder = Primitive("frustum", np.zeros(3), np.zeros(3), np.array([0.6, 0.2, 0.2, 0.0]))
    np.testing.assert_allclose(cylinder.at(places), [0.3, 0.3, 0.3 * 2**0.5, -0.2], atol=1e-6)
    box = Primitive("box", np.zeros(3), np.zeros(3), np.array([0.2, 0.2, 0.6, 0.0]))
    np.testing.assert_allclose(box.at(places), [0.3, 0.3, 0.3 * 2**0.5, -0.2], atol=1e-6)
    soft = Primitive("box", np.zeros(3), np.zeros(3), np.array([0.2, 0.2, 0.6, 0.1]))
    np.testing.assert_allclose(soft.at(places)[2], 0.4 * 2**0.5 - 0.1, atol=1e-6)
    capsule = Primitive("capsule", np.zeros(3), np.zeros(3), np.array([0.4, 0.2, 0.2]))
    np.testing.assert_allclose(capsule.at(places), [0.3, 0.3, 0.5 * 2**0.5 - 0.2, -0.2], atol=1e-6)


def test_a_capsule_is_the_hull_of_two_balls():
    one = Primitive("capsule", np.zeros(3), np.zeros(3), np.array([0.4, 0.2, 0.08]))
    t = np.linspace(0, 1, 4001)[:, None]
    places = np.random.default_rng(0).uniform(-0.8, 0.8, (200, 3))
    middles = np.concatenate([0 * t, 0 * t, 0.8 * t - 0.4], 1)
    off = np.linalg.norm(places - middles[:, None], axis=2) - (0.2 - 0.12 * t)
    np.testing.assert_allclose(one.at(places), off.min(0), atol=1e-4)


def test_a_solid_of_revolution_has_the_distance_of_its_profile():
    # A bowl: its outline from the middle of its foot, up outside, and back inside.
    outline = np.array([(0.0, 0.0), (0.4, 0.0), (0.5, 0.4), (0.44, 0.4), (0.35, 0.06), (0.0, 0.06)])
    bowl = Primitive("turned", np.zeros(3), np.zeros(3), outline.ravel())
    at = np.array([[0.0, 0.0, 0.03], [0.0, 0.0, 0.2], [0.0, 0.0, -0.1], [0.9, 0.0, 0.4]])
    np.testing.assert_allclose(bowl.at(at), [-0.03, 0.14, 0.1, 0.4], atol=1e-6)
    verts, faces = bowl.mesh(0.05)
    found = health(verts, faces)
    assert found["closed"] and found["manifold"] and found["genus"] == 0
    assert bowl.distance(verts).abs().max() < 2e-3


def test_what_is_no_primitive_is_none():
    # An L of two boxes.
    arms = solid("box", (0.4, 0.1, 0.1, 0.0)), solid("box", (0.1, 0.1, 0.4, 0.0))
    moved = points_on(arms[1]) + np.array([0.4, 0.0, 0.4])
    assert primitive_of(np.concatenate([points_on(arms[0]), moved])[::2], ERROR) is None


def test_rims_are_given_back_what_a_network_blurs():
    def rim(of):
        return solid("box", (0.3, 0.4, 0.2, of)).sharp().lengths[3]

    assert rim(0.05) == 0 and rim(0.055) == 0
    assert 0.03 < rim(0.065) < 0.04 and rim(0.09) == 0.09
    assert rim(0.0) == 0 and solid("ring", (0.4, 0.1)).sharp().lengths[1] == 0.1


@pytest.mark.parametrize("flip", [np.eye(3), np.diag([-1.0, 1, 1]), np.diag([-1.0, -1, 1])])
def test_a_placed_primitive_is_the_mirrored_or_turned_one(flip):
    one = solid("frustum", (0.5, 0.2, 0.1, 0.0), (0.3, 0.4, 0.1))
    origin = np.array([0.3, -0.2, 0.1])
    for frame in (flip, Rotation.from_rotvec([0, 0, 0.7]).as_matrix()):
        placed = one.placed(frame, origin)
        points = points_on(one, noise=0.0)
        assert np.abs(placed.at(points @ frame.T + origin)).max() < 2e-3


def test_what_is_mostly_flat_is_a_sharp_block_if_it_can_be():
    """A nightstand's drawer, drawn rounded, was a roll; a screen had soft edges."""
    drawer = points_on(solid("box", (0.42, 0.1, 0.115, 0.08)))
    assert primitive_of(drawer, ERROR).form != "box"
    assert primitive_of(drawer, ERROR, BLOCK).form == "box"
    door = points_on(solid("box", (0.3, 0.4, 0.2, 0.09)))
    assert primitive_of(door, ERROR, BLOCK).lengths[3] > 0.05
    assert primitive_of(door, ERROR, BLOCK._replace(sharp=True)).lengths[3] == 0
    ball = points_on(solid("ellipsoid", (0.2, 0.3, 0.1)))
    assert primitive_of(ball, ERROR, BLOCK).form == "ellipsoid"  # it can not


@pytest.mark.parametrize("half", [(0.42, 0.1, 0.1), (0.15, 0.12, 0.12)])
def test_a_block_is_no_rod_though_a_rod_fits_better(half):
    """Of a rod hardly anything is flat: a square bar with round edges lay there as one."""
    bar = points_on(solid("box", (*half, 0.08)))
    plain, block = (primitive_of(bar, ERROR, faces) for faces in (ANY, BLOCK))
    assert block.form == "box"
    np.testing.assert_allclose(block.lengths[:3], half, atol=5e-3)
    assert plain.form != "box"
