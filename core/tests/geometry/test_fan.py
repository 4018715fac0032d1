"""A bend about an axis: exact both ways, rigid where it should be."""

import math

import pytest
import torch

from core.geometry.fan import SLOPE, Fan

AXIS = torch.tensor([-0.1, 0.2])


def fan(by: float, **ends: float) -> Fan:
    edges = {"below": -1.4, "low": -0.3, "high": 1.2, "above": 2.9} | ends
    return Fan(AXIS, wanted=by, **edges)


def around(angle: float, far: float, x: float = 0.3) -> torch.Tensor:
    y, z = AXIS.tolist()
    return torch.tensor([[x, y - far * math.cos(angle), z + far * math.sin(angle)]])


@pytest.mark.parametrize("by", [-0.6, -0.2, 0.0, 0.5, 1.0])
def test_each_point_is_found_again(by):
    points = torch.rand(2000, 3, generator=torch.Generator().manual_seed(0)) * 2 - 1
    bend = fan(by)
    assert bend.by == pytest.approx(by)
    torch.testing.assert_close(bend.into(bend.out(points)), points, atol=2e-5, rtol=0)
    torch.testing.assert_close(bend.out(bend.into(points)), points, atol=2e-5, rtol=0)
    moved = (bend.out(points) - points).norm(dim=1) > 1e-4
    assert bool(moved.any()) == (by != 0)


@pytest.mark.parametrize(("angle", "by"), [(-0.3, 0.5), (0.4, 0.5), (1.2, 0.5), (0.4, -0.6)])
def test_the_sector_is_turned_upwards_from_the_front(angle, by):
    torch.testing.assert_close(fan(by).out(around(angle, 0.7)), around(angle + by, 0.7))


@pytest.mark.parametrize("angle", [-3.1, -2.0, -1.4, 2.9, 3.1])
def test_what_is_behind_stays(angle):
    torch.testing.assert_close(fan(0.7).out(around(angle, 0.7)), around(angle, 0.7))


def test_it_turns_no_farther_than_there_is_room():
    assert fan(9.0).by == pytest.approx((1 - SLOPE) * (2.9 - 1.2))
    assert fan(-9.0).by == pytest.approx((1 - SLOPE) * (-1.4 + 0.3))
    angles = torch.linspace(-3.1, 3.1, 400).tolist()
    for bend in (fan(9.0), fan(-9.0)):
        out = torch.cat([bend.out(around(angle, 0.5)) for angle in angles])
        found = torch.atan2(out[:, 2] - AXIS[1], AXIS[0] - out[:, 1])
        assert (found.diff() > 0).all()  # nothing is folded over


def test_the_turn_of_a_place_is_that_of_its_surroundings():
    bend, at = fan(0.5), around(2.0, 0.7)
    there = bend.out(at)
    by = float(bend.turn_at(there)[0])
    assert 0 < by < 0.5
    torch.testing.assert_close(there, around(2.0 + by, 0.7))
    assert float(bend.turn_at(around(0.9, 0.3))[0]) == pytest.approx(0.5)


def test_it_has_no_crease():
    """The slope is 1 at both ends of what is spread or pressed together."""
    bend, step = fan(0.6), 1e-2
    for edge in (-1.4, -0.3, 1.2, 2.9):
        ends = [bend.out(around(edge + side * step, 0.7)) for side in (-1, 1)]
        before, after = (
            float(torch.atan2(end[0, 2] - AXIS[1], AXIS[0] - end[0, 1])) for end in ends
        )
        assert (after - before) / (2 * step) == pytest.approx(1.0, abs=0.06)


def test_it_goes_with_what_is_moved():
    by = torch.tensor([0.5, -0.2, 0.3])
    points = torch.rand(50, 3, generator=torch.Generator().manual_seed(1)) * 2 - 1
    there = fan(0.5).moved(by).out(points + by)
    torch.testing.assert_close(there, fan(0.5).out(points) + by)
