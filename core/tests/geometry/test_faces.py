"""Properties of a mesh's faces."""

import math

import numpy as np
import pytest

from core.geometry.faces import agree, agreeing, bending, outward
from core.geometry.union import ball, rounded_box


def numbers(mesh):
    verts, faces = mesh
    return verts.double().numpy(), faces.numpy()


def test_bending_is_the_integral_of_the_mean_curvature():
    # 4 pi r of a ball; of a box a quarter turn at each edge, its half.
    sphere = numbers(ball(np.array([0.5] * 3), np.inf, 96))
    assert bending(*sphere) == pytest.approx(4 * math.pi * 0.5, rel=0.01)
    sides = (0.2, 0.4, 0.6)
    for edge in (np.inf, 0.05):  # however its planes are cut up
        box = numbers(rounded_box(np.array(sides) / 2, 0.0, edge, 8))
        assert bending(*box) == pytest.approx(4 * sum(sides) * math.pi / 4)


def test_a_ragged_plane_bends_more():
    verts, faces = numbers(rounded_box(np.array([0.5, 0.5, 0.1]), 0.0, 0.05, 8))
    ragged = verts + 0.01 * np.random.default_rng(0).standard_normal(verts.shape)
    assert bending(ragged, faces) > 2 * bending(verts, faces)


def test_faces_are_turned_to_where_most_of_their_patch_looks():
    verts, faces = numbers(ball(np.array([0.5] * 3), np.inf, 24))
    for flip in (faces[:, 0] == faces[0, 0], np.random.default_rng(0).random(len(faces)) < 0.3):
        mixed = np.where(flip[:, None], faces[:, ::-1], faces)
        assert agree(faces) and not agree(mixed)
        turned, patch = agreeing(verts, mixed)
        assert np.array_equal(np.sort(turned, 1), np.sort(faces, 1))
        assert agree(turned) and outward(verts, turned) and not patch.any()


def test_a_back_is_seen_of_what_is_open_or_inside_out():
    verts, faces = numbers(ball(np.array([0.5] * 3), np.inf, 24))
    both = np.concatenate([verts, verts + np.array([3, 0, 0])])
    card = np.array([[0, 1, 2], [2, 1, 0]])
    assert outward(verts, faces)
    assert not outward(verts, faces[:, ::-1])
    assert not outward(verts, faces[1:])
    assert outward(both, np.concatenate([faces, faces + len(verts)]))
    assert not outward(both, np.concatenate([faces, faces[:, ::-1] + len(verts)]))
    for sheet in (card, card[:, ::-1]):  # a sheet is its own back
        assert outward(np.eye(3) / 3, sheet)
