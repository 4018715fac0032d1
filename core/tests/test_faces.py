"""What a mesh's faces say of it."""

import math

import numpy as np
import pytest

from core.geometry.faces import bending
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
