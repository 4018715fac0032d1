"""The outline of a flat field: closed loops, lines where it was straight, corners, curves."""

import numpy as np
import pytest

from core.geometry.parts.outline import area, contours, even, level, line_of, outline

ERROR, STEP = 0.04, 0.0125
SIDE = np.arange(-0.8, 0.8, STEP)
X, Y = np.meshgrid(SIDE, SIDE, indexing="ij")
LOW = SIDE[[0, 0]]


def rectangle(x, y, half, rim=0.0):
    """Signed distance; its corners rounded by ``rim``."""
    q = np.stack([np.abs(x) - half[0], np.abs(y) - half[1]]) + rim
    return np.hypot(*q.clip(min=0)) + q.max(0).clip(max=0) - rim


def wave(size):
    """As a network errs."""
    return size * (np.sin(19 * X + 1) + np.sin(23 * Y))


def loops_of(field):
    return outline(field, LOW, STEP, ERROR)


def test_contours_run_around_what_is_inside_and_around_holes_the_other_way():
    ring = np.abs(np.hypot(X, Y) - 0.5) - 0.2
    loops = [loop * STEP + LOW for loop in contours(ring)]
    outer, inner = sorted(loops, key=area, reverse=True)
    assert area(outer) == pytest.approx(np.pi * 0.7**2, rel=2e-3)
    assert area(inner) == pytest.approx(-np.pi * 0.3**2, rel=2e-3)
    for loop, radius in ((outer, 0.7), (inner, 0.3)):
        assert np.abs(np.hypot(*loop.T) - radius).max() < 3e-4
        steps = np.hypot(*(np.roll(loop, -1, 0) - loop).T)
        assert steps.max() < 1.5 * STEP  # each point follows the one next to it


@pytest.mark.parametrize("turn", [0.0, 0.35])
def test_a_rounded_wavy_rectangle_has_four_lines_and_their_corners(turn):
    x, y = X * np.cos(turn) + Y * np.sin(turn), Y * np.cos(turn) - X * np.sin(turn)
    (loop,) = loops_of(rectangle(x, y, (0.5, 0.3), 0.05) + wave(0.002))
    assert len(loop) == 4 and area(loop) == pytest.approx(0.6, rel=0.02)
    a, b = loop[:, 0], loop[:, 1]
    local = np.abs(
        np.stack([a * np.cos(turn) + b * np.sin(turn), b * np.cos(turn) - a * np.sin(turn)])
    )
    assert np.abs(local.T - (0.5, 0.3)).max() < 0.01
    if not turn:  # sides that are nearly along an axis are along it
        ways = np.abs(np.roll(loop, -1, 0) - loop)
        assert (ways.min(1) < 1e-12).all()


def test_a_circle_stays_round():
    (loop,) = loops_of(np.hypot(X, Y) - 0.45 + wave(0.001))
    assert len(loop) > 30
    middles = (loop + np.roll(loop, -1, 0)) / 2
    assert np.abs(np.hypot(*loop.T) - 0.45).max() < 6e-3
    assert np.abs(np.hypot(*middles.T) - 0.45).max() < 8e-3


def test_an_arch_has_both():
    field = np.maximum(rectangle(X, Y, (0.6, 0.5)), 0.3 - np.hypot(X, Y + 0.5))
    (loop,) = loops_of(field)
    corners = [(-0.6, -0.5), (-0.3, -0.5), (0.3, -0.5), (0.6, -0.5), (0.6, 0.5), (-0.6, 0.5)]
    off = np.linalg.norm(loop[None] - np.array(corners)[:, None], axis=2)
    assert (off.min(1) < 0.015).all()
    curve = loop[(np.abs(loop[:, 0]) < 0.29) & (loop[:, 1] > -0.49)]
    assert len(curve) > 8
    assert np.abs(np.hypot(curve[:, 0], curve[:, 1] + 0.5) - 0.3).max() < 6e-3


def test_a_narrow_board_ends_flat():
    (loop,) = loops_of(rectangle(X, Y, (0.5, 0.04), 0.04))  # as round as it can be
    assert len(loop) == 4
    assert np.abs(np.abs(loop) - (0.5, 0.04)).max() < 6e-3


def test_a_line_is_that_of_its_middle_not_of_its_rounded_ends():
    x = np.linspace(0, 0.6, 49)
    side = np.stack([x, -6 * (0.06 - x).clip(min=0) ** 2], 1)
    line = line_of(side, ERROR)
    assert line is not None and abs(line.place[1]) < 1e-9


def test_specks_are_none():
    field = np.minimum(np.hypot(X, Y) - 0.3, np.hypot(X - 0.6, Y) - 0.02)
    assert len(loops_of(field)) == 1


def test_what_is_nearly_the_same_on_both_sides_is_so():
    field = rectangle(X, Y, (0.5, 0.3))
    uneven = field + 0.01 * X
    made = even(uneven, ERROR)
    assert np.allclose(made, np.flip(made, 0)) and not np.allclose(uneven, np.flip(uneven, 0))
    other = field + 0.5 * X
    assert np.array_equal(even(other, ERROR)[::-1], even(other, ERROR)) is False


def test_lines_that_nearly_go_on_in_one_another_are_one():
    low = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.0, 0.5)])
    high = np.array([(0.008, 0.6), (0.99, 0.6), (0.99, 1.0), (0.008, 1.0)])
    far = np.array([(0.2, 2.0), (0.7, 2.0), (0.7, 3.0), (0.2, 3.0)])
    before = far.copy()
    level([low, high, far], ERROR)
    assert low[0, 0] == high[0, 0] and low[1, 0] == high[1, 0]
    assert low[0, 0] == pytest.approx((0.5 * 0.0 + 0.4 * 0.008) / 0.9)  # by their lengths
    assert np.array_equal(far, before)
