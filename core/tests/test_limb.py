"""Balls swept along a curve, and pieces that are such."""

import itertools

import numpy as np
import pytest
import torch

from core.geometry.assembly import Forms, KnownParts
from core.geometry.limb import limb, middle_way, paired, spaced, swept
from core.geometry.mesh import health, signed_volume
from core.geometry.pieces import drawn_at, places_of
from core.geometry.sphere_sweep import bends, distance, samples, tube

HORN = np.array(
    [(-0.5, 0.1, 0.5, 0.06), (-0.35, 0, 0, 0.1), (0.1, 0, -0.2, 0.13), (0.5, 0.1, 0.1, 0.15)]
)
FORMS = Forms((0.0,), ((0.0,),) * 3)


def horns(points, both=False):
    """The horn as a network draws it; or half as large, and with its mirror image."""
    p = points.double().numpy()
    waves = 0.004 * np.sin(40 * p).sum(1)
    stops = HORN
    if both:
        p, stops = np.abs(p) * (1, 0, 0) + p * (0, 1, 1), 0.5 * HORN + (0.5, 0, 0, 0)
    return torch.from_numpy(distance(p, samples(stops)) + waves).float()[:, None]


def test_the_distance_is_the_nearest_hulls():
    balls = samples(HORN)
    points = np.random.default_rng(0).uniform(-0.6, 0.6, (600, 3))
    found = distance(points, balls)
    share = np.linspace(0, 1, 40)[:, None]
    between = np.concatenate([a + share * (b - a) for a, b in itertools.pairwise(balls)])
    least = (np.linalg.norm(points[:, None] - between[:, :3], axis=2) - between[:, 3]).min(1)
    outside = least > 0
    np.testing.assert_allclose(found[outside], least[outside], atol=2e-4)
    assert (found[~outside] <= 0).all()
    assert outside.any() and not outside.all()


def test_the_curve_goes_through_its_stops_without_a_kink():
    balls = samples(HORN, 20)
    np.testing.assert_allclose(balls[::20], HORN, atol=1e-12)
    ahead = np.diff(balls[:, :3], axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    assert (ahead[1:] * ahead[:-1]).sum(1).min() > np.cos(np.radians(8))
    straight = HORN[:2]
    assert samples(straight) is straight


def test_what_bends_more_tightly_than_it_is_thick_folds():
    assert bends(samples(HORN)).max() < 0.6
    hairpin = np.array([(0, 0, 0, 0.2), (0.5, 0, 0, 0.2), (0.5, 0.1, 0, 0.2), (0, 0.1, 0, 0.2)])
    assert bends(samples(hairpin)).max() > 1


@pytest.mark.parametrize("segments", [24, 40])
def test_the_surface_is_closed_and_where_the_distance_says(segments):
    balls = samples(HORN, 24)
    verts, faces = (torch.from_numpy(x) for x in tube(balls, segments))
    found = health(verts, faces)
    assert found["closed"] and found["manifold"] and found["oriented"] and found["genus"] == 0
    assert signed_volume(verts, faces) > 0
    assert np.abs(distance(verts.numpy(), balls)).max() < 2e-3


def piece_of(distances):
    (place,) = places_of(distances, 1)
    return drawn_at(distances, place)


def test_the_middle_way_goes_from_end_to_end():
    piece = piece_of(horns)
    stops = spaced(middle_way(piece.lattice), 4)
    stops = stops if stops[0, 0] < stops[-1, 0] else stops[::-1]
    assert np.abs(stops[:, :3] - HORN[:, :3]).max() < 0.15
    assert np.abs(stops[1:, 3] / HORN[1:, 3] - 1).max() < 0.35


def test_a_horn_is_found_without_its_waves():
    piece = piece_of(horns)
    one = limb(piece)
    verts, _ = one.mesh(piece.cell)
    made, drawn = (distance(v.double().numpy(), samples(HORN)) for v in (verts, piece.verts))
    assert np.abs(made).mean() < np.abs(drawn).mean()
    assert made.std() < 0.5 * drawn.std()
    (known,) = KnownParts(horns, FORMS).pieces
    assert known.primitive.form == "limb"


@pytest.mark.parametrize("radii", [(0.5, 0.5, 0.4), (0.5, 0.14, 0.5)])
def test_what_is_no_rod_is_none(radii):
    def egg(points):
        return ((points / torch.tensor(radii)).norm(dim=1, keepdim=True) - 1) * min(radii)

    assert limb(piece_of(egg)) is None


def test_a_pair_is_each_others_mirror_image():
    left, right = KnownParts(lambda p: horns(p, both=True), FORMS).pieces
    stops = [piece.primitive.lengths.reshape(-1, 4) for piece in (left, right)]
    np.testing.assert_array_equal(stops[0] * (-1, 1, 1, 1), stops[1])
    # What fits the other less well stays.
    other = left._replace(primitive=swept(stops[0] + 0.1))
    assert paired([other, right])[1] is right
