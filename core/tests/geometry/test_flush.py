"""Faces of boxes that are nearly in one plane are moved into it; others stay."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.geometry.parts.flush import ends_of, flush
from core.geometry.parts.primitives import Primitive

STILL = np.zeros(3)


def box(low, high, turn=STILL, rim=0.0):
    low, high = np.array(low, float), np.array(high, float)
    half = np.abs(Rotation.from_rotvec(turn).as_matrix()).T @ (high - low) / 2
    return Primitive("box", (low + high) / 2, turn, np.append(half, rim))


SEAT = box((-0.5, -0.5, 0.0), (0.5, 0.5, 0.1))


def test_the_sides_of_a_seat_and_its_back_are_one_plane():
    back = box((-0.51, 0.4, 0.1), (0.49, 0.502, 0.9))
    ball = Primitive("ellipsoid", STILL, STILL, np.full(3, 0.2))
    seat, between, moved, rest = flush([SEAT, None, back, ball])
    assert between is None and rest is ball
    for side, axis in ((0, 0), (1, 0), (1, 1)):
        assert ends_of(seat)[side, axis] == pytest.approx(ends_of(moved)[side, axis], abs=1e-12)
    # In the mean by the faces' areas, 0.1 and 0.08; what is alone stays.
    assert ends_of(seat)[0, 0] == pytest.approx((-0.5 * 0.1 - 0.51 * 0.0816) / 0.1816)
    assert ends_of(moved)[:, 2] == pytest.approx([0.1, 0.9])
    assert ends_of(moved)[0, 1] == pytest.approx(0.4)


def test_three_that_go_on_in_one_another_are_one():
    legs = [box((x, 0.2, -0.6), (x + 0.1, 0.49, 0.0)) for x in (-0.5, 0.4)]
    made = flush([SEAT, *legs])
    assert np.ptp([ends_of(one)[1, 1] for one in made]) < 1e-12


@pytest.mark.parametrize(
    "other",
    [
        box((-0.2, -0.51, 0.02), (0.2, -0.4, 0.08)),  # a pane on the front
        box((-0.53, 0.4, 0.1), (0.47, 0.54, 0.9)),  # a step that is meant
        box((-0.49, 0.3, -0.5), (0.49, 0.49, 0.0), rim=0.03),  # round edges
        box((-0.49, 0.3, -0.5), (0.49, 0.49, 0.0), turn=np.array([0.0, 0.02, 0.0])),  # turned
    ],
)
def test_others_stay(other):
    seat, same = flush([SEAT, other])
    np.testing.assert_allclose(same.center, other.center, atol=1e-12)
    np.testing.assert_allclose(same.lengths, other.lengths, atol=1e-12)
    np.testing.assert_allclose(ends_of(seat), ends_of(SEAT), atol=1e-12)


def test_a_box_on_its_side_is_one_too():
    turn = np.array([0.0, np.pi / 2, 0.0])
    back = box((-0.51, 0.4, 0.1), (0.49, 0.5, 0.9), turn)
    np.testing.assert_allclose(ends_of(back), [(-0.51, 0.4, 0.1), (0.49, 0.5, 0.9)])
    seat, moved = flush([SEAT, back])
    assert ends_of(seat)[0, 0] == pytest.approx(ends_of(moved)[0, 0], abs=1e-12)
    assert ends_of(moved)[0, 0] > -0.51


def test_none_are_none():
    assert flush([]) == [] and flush([None]) == [None]
