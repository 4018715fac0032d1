"""Layers along several axes at once are found; what is none of them is not."""

import numpy as np
import pytest
import torch

from core.geometry.mesh import health
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.crossed import crossed
from core.geometry.parts.forms import Forms
from core.geometry.parts.layered import ends_fraction
from core.geometry.parts.primitives import along_axes, unpacked
from core.tests.geometry.test_layered import box, component_of, farthest


def fin(p, along, thin):
    """A plate that tapers upwards, on both sides of the middle."""
    slope = (np.abs(p[:, along]) + 0.6 * p[:, 2] - 0.4) / np.hypot(1, 0.6)
    return np.max([np.abs(p[:, thin]) - 0.06, slope, np.abs(p[:, 2]) - 0.5], axis=0)


def fins(p):
    return np.minimum(fin(p, 0, 1), fin(p, 1, 0))


def tail(p):
    """A flat board, and a fin on it."""
    board = box(p, (0.0, 0.0, -0.3), (0.7, 0.25, 0.06))
    slope = np.maximum(np.abs(p[:, 0]) - 0.06, (np.abs(p[:, 1]) + 0.4 * p[:, 2] - 0.2) / 1.08)
    return np.minimum(board, np.maximum(slope, np.abs(p[:, 2] - 0.1) - 0.4))


def ball(p):
    return np.linalg.norm(p, axis=1) - 0.6


@pytest.mark.parametrize("distance", [fins, tail])
def test_plates_across_one_another_are_found(distance) -> None:
    one = crossed(component_of(distance, wave=0.002))
    assert one is not None and one.form == "crossed"
    assert len(list(along_axes(one.lengths))) == 2
    assert all(len(unpacked(own)) == 1 for _, own in along_axes(one.lengths))
    assert farthest(one, distance) < 0.035
    found = health(*one.mesh(0.05))
    assert found["closed"] and found["manifold"] and found["components"] == 1
    assert ends_fraction(one) > 0.6  # its plates' sides


def test_a_thing_of_such_parts_is_put_together_of_them() -> None:
    def distances(points):
        return torch.from_numpy(fins(points.double().numpy())).float()[:, None]

    (component,) = KnownParts(distances, Forms((0.9,), ((0.0,), (0.0,), (0.0,)))).components
    assert component.primitive is not None and component.primitive.form == "crossed"


def test_its_distance_is_that_of_its_surface() -> None:
    one = crossed(component_of(fins))
    assert one is not None
    verts, _ = one.mesh(0.05)
    assert np.abs(one.at(verts.double().numpy())).max() < 1e-5
    points = np.random.default_rng(0).uniform(-0.6, 0.6, (4000, 3))
    points = points[np.abs(fins(points)) < 0.08]
    inside = fins(points) < 0
    assert 0.2 < inside.mean() < 0.8
    assert ((one.at(points) < 0) == inside).mean() > 0.95


def discs(p):
    """Six, one upon another: along one axis."""
    r = np.hypot(p[:, 0], p[:, 1])
    each = [
        np.maximum(r - (0.3 + 0.25 * (k % 2)), np.abs(p[:, 2] + 0.6 - 0.24 * k) - 0.121)
        for k in range(6)
    ]
    return np.min(each, axis=0)


@pytest.mark.parametrize("distance", [ball, lambda p: box(p), discs])
def test_what_is_no_plates_or_one_is_not(distance) -> None:
    assert crossed(component_of(distance)) is None
