"""Seams, pockets, folds and stitches of clothes and cushions."""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.forms.bands import hoop
from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
)


def upright(
    points: Points, half: Half, across: Sequence[float], low: float, high: float, line: float
) -> Margin:
    """Lines down a front, such as seams and plackets: places to the right and both ends in halves,
    half a line's width in training units."""
    off = torch.stack([(points[:, 0] - at * half[0]).abs() for at in across]).amin(0)
    z = points[:, 2]
    return all_of(line - off, z - low * half[2], high * half[2] - z, in_front(points))


def wrapped(points: Points, half: Half, at: Pair, wide: float, line: float = 0.018) -> Margin:
    """The two edges of a jacket crossed over the chest, a V.

    Args:
        at: the heights of its lower and of its upper ends in halves.
        wide: how far apart the upper ends are, in halves of the width.
    """
    x, z = points[:, 0].abs(), points[:, 2]
    low, high = at[0] * float(half[2]), at[1] * float(half[2])
    reach = wide * float(half[0])
    steep = math.hypot(high - low, reach)
    away = (x * (high - low) - (z - low) * reach).abs() / steep
    return all_of(line - away, z - low + 0.01, high - z, in_front(points))


def buckle(points: Points, half: Half, below: float, wide: float, hole: Pair) -> Margin:
    """A buckle on the front of a belt: its middle below the top of the part, half its width and the
    half sides of its hole, in training units."""
    x, up = points[:, 0].abs(), (points[:, 2] - half[2] + below).abs()
    within = all_of(hole[0] - x, hole[1] - up)
    return all_of(wide - x, 2 * wide - up, -within, in_front(points))


def pockets(
    points: Points, half: Half, at: Pair, size: Pair, line: float = 0.014, both: bool = True
) -> Margin:
    """Seams of patch pockets on a front, each with a flap: in halves; half the line's width in
    training units."""
    x = points[:, 0].abs() if both else points[:, 0]
    across, up = x - at[0] * half[0], points[:, 2] - at[1] * half[2]
    wide, high = size[0] * half[0], size[1] * half[2]
    edge = line - torch.maximum(across.abs() - wide, up.abs() - high).abs()
    # A flap's lower edge comes to a point.
    flap = line - (up - 0.35 * high + (0.35 - 0.35 * across.abs() / wide) * high).abs()
    return all_of(any_of(edge, all_of(flap, wide - across.abs())), in_front(points))


def cap_seams(points: Points, _half: Half, count: int = 6, line: float = 0.012) -> Margin:
    """Seams of a cap that meet at its top."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    away = (turn - turn.round()).abs() * (math.tau / count)
    return line - away.sin() * points[:, :2].norm(dim=1)


def folds(points: Points, half: Half, count: int = 14, line: float = 0.012) -> Margin:
    """Folds of a skirt from a little below its waist to its hem, wider downwards."""
    below = ((half[2] - points[:, 2]) / (2 * half[2])).clamp(0, 1)
    return cap_seams(points, half, count, line) - 2 * line * (1 - below)


def shirt_seams(points: Points, half: Half, wide: float = 0.13, line: float = 0.013) -> Margin:
    """The edges of a shirt's placket, and the seam above its hem."""
    edges = upright(points, half, (-wide, wide), -0.86, 0.62, line)
    hem = line - (points[:, 2] + 0.86 * half[2]).abs()
    return any_of(edges, hem)


def trouser_seams(points: Points, half: Half, line: float = 0.013) -> Margin:
    """The fly in front, and seams down the outer sides of both legs."""
    fly = upright(points, half, (0.0,), 0.3, 0.9, line)
    x, y, z = points[:, 0].abs(), points[:, 1], points[:, 2]
    curve = (torch.hypot(points[:, 0], z - 0.62 * half[2]) - 0.2 * half[0]).abs()
    curve = all_of(line - curve, 0.5 * half[2] + 0.12 * half[2] - z, points[:, 0], in_front(points))
    stitch = all_of(
        line - (points[:, 0] - 0.2 * half[0]).abs(), z - 0.62 * half[2], in_front(points)
    )
    sides = all_of(1.2 * line - y.abs(), x - 0.5 * half[0])
    return any_of(fly, curve, stitch, sides)


def jacket_seams(points: Points, half: Half, line: float = 0.013) -> Margin:
    """The yoke's edge below both shoulders, and seams down the sides of the front."""
    yoke = all_of(
        line - (points[:, 2] - 0.42 * half[2] - 0.1 * points[:, 0].abs()).abs(),
        0.52 * half[0] - points[:, 0].abs(),
    )
    return any_of(yoke, upright(points, half, (-0.32, 0.32), -0.8, 0.42, line))


def dashes(
    points: Points, half: Half, at: float, wide: float, pitch: float = 0.09, gap: float = 0.35
) -> Margin:
    """Stitches around a shoe's sole: their height and half their width in halves; ``gap``: a gap's
    fraction of the pitch."""
    step = (points[:, 1] + points[:, 0]) / pitch
    dash = ((1 - gap) / 2 - (step - step.round()).abs()) * pitch
    return all_of(hoop(points, half, at, wide), dash)


def quilt(
    points: Points,
    _half: Half,
    pitch: float,
    wide: float = 0.008,
    axes: tuple[int, int] = (0, 1),
) -> Margin:
    """Slanted seams that cross, seen from above, or along the axis that is not in ``axes``."""
    x, y = points[:, axes[0]] / pitch, points[:, axes[1]] / pitch
    one, other = (x + y) / 2, (x - y) / 2
    away = torch.minimum((one - one.round()).abs(), (other - other.round()).abs())
    return wide - away * (pitch * math.sqrt(2))
