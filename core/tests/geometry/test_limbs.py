"""Limbs flow into one another, and their mesh is where their distance is zero."""

import numpy as np
import pytest
import torch

from core.geometry.mesh import health
from core.geometry.parts.limbs import CELLS
from core.geometry.parts.primitives import Primitive
from core.geometry.parts.slender import thinned
from core.guidance.builtin.constructed.shapes import capsule, limb, mirrored_limbs, smooth_union

SOFT = 0.03
TRUNK = limb([(0, -0.5, 0), (0, 0, 0.1), (0, 0.5, 0)], [0.15, 0.2, 0.15])
LEG = limb([(0.15, -0.3, 0), (0.2, -0.3, -0.3), (0.2, -0.35, -0.6)], [0.1, 0.07, 0.05])
BODY = smooth_union([TRUNK, *mirrored_limbs([LEG])], SOFT)
PLACES = np.random.default_rng(0).uniform(-1, 1, (500, 3))


def test_a_straight_limb_of_one_radius_is_a_capsule():
    one = smooth_union([limb([(0, 0, -0.4), (0, 0, 0.4)], 0.2)], SOFT)
    np.testing.assert_allclose(one.at(PLACES), capsule((0, 0, -0.4), (0, 0, 0.4), 0.2).at(PLACES))


def test_a_wide_limb_is_an_ellipse_across():
    one = smooth_union([limb([(0, -0.4, 0), (0, 0.4, 0)], 0.2, 1.5)], SOFT)
    on = np.array([(0.3, 0, 0), (0, 0, 0.2), (0.3 * 0.6, 0, 0.2 * 0.8)])
    np.testing.assert_allclose(one.at(on), 0, atol=1e-9)
    assert one.at(np.array([(0.25, 0.0, 0.0)]))[0] < 0 < one.at(np.array([(0.0, 0.0, 0.25)]))[0]


def test_limbs_that_meet_are_rounder_and_far_ones_are_by_themselves():
    first, second = (limb([(x, 0, -0.4), (x, 0, 0.4)], 0.1) for x in (-0.09, 0.09))
    alone = [smooth_union([one], SOFT).at(PLACES) for one in (first, second)]
    both = smooth_union([first, second], SOFT).at(PLACES)
    gain = np.minimum(*alone) - both
    assert gain.min() > 0 and gain.max() < SOFT * np.log(2) + 1e-9
    assert smooth_union([first, second], SOFT).at(np.zeros((1, 3)))[0] == pytest.approx(
        -0.01 - SOFT * np.log(2)
    )
    far = first + np.array([2.0, 0, 0, 0, 0])
    apart = smooth_union([first, far], SOFT).at(PLACES)
    near = smooth_union([first], SOFT).at(PLACES)
    assert np.allclose(apart[PLACES[:, 0] < 0], near[PLACES[:, 0] < 0], atol=1e-9)


def test_the_mesh_is_closed_and_on_its_own_distance():
    verts, faces = BODY.mesh(0.05)
    found = health(verts, faces)
    assert found["closed"] and found["manifold"] and found["components"] == 1
    assert found["genus"] == 0 and found["volume"] > 0
    off = BODY.distance(verts).abs()
    assert float(off.max()) < 4e-3 and float(off.mean()) < 4e-4
    assert float((verts.amax(0) - verts.amin(0)).max()) / CELLS[1] > 0.01  # coarser than this


def test_its_extent_is_known_without_a_mesh():
    fine, coarse = BODY.mesh(0.05)[0], BODY.mesh(np.inf)[0]
    for ends in (torch.amin, torch.amax):
        assert torch.allclose(ends(fine, 0), ends(coarse, 0), atol=SOFT)


def test_limbs_get_thinner_and_stay_as_long():
    made = thinned(BODY, 0.5)
    assert isinstance(made, Primitive)
    (before, _), (after, _) = BODY.mesh(0.05), made.mesh(0.05)
    wide, thin = ((v.amax(0) - v.amin(0)) for v in (before, after))
    assert thin[1] > 0.8 * wide[1] and made.distance(before).min() > -0.2
    assert health(*made.mesh(0.05))["volume"] < 0.4 * health(*BODY.mesh(0.05))["volume"]
