"""Badges, emblems, arrows and other single shapes."""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
    strokes,
    within,
)
from core.guidance.builtin.markings.shapes import shape_margin

ARROW = ((-0.62, -0.62), (0.3, -0.62), (0.3, -0.84), (0.72, -0.46), (0.3, -0.08), (0.3, -0.3),
         (-0.44, -0.3))  # fmt: skip
# Of a violin's right sound hole, in halves of the body: from its upper end to its lower one.
F_HOLE = ((0.36, 0.04), (0.36, 0.1), (0.41, 0.14), (0.46, 0.09), (0.5, -0.1), (0.54, -0.27))
F_HOLE += ((0.59, -0.32), (0.65, -0.3), (0.66, -0.24))


def stamp(
    points: Points, half: Half, shape: str, size: float, at: tuple[float, float] = (0.0, 0.0)
) -> Margin:
    """A shape on the front: its ``size`` in halves of the width, its middle in halves of the
    part."""
    x, z = points[:, 0] - at[0] * half[0], points[:, 2] - at[1] * half[2]
    size = size * float(half[0])
    return all_of(shape_margin(torch.stack([x, z], 1) / size, shape) * size, in_front(points))


def badge(points: Points, half: Half, radius: float, shape: str) -> Margin:
    """A disc on the front without a shape; ``radius`` in halves of the width."""
    whole = stamp(points, half, "circle", radius / 0.9)
    return all_of(whole, -stamp(points, half, shape, 0.72 * radius))


def emblem(
    points: Points, half: Half, shape: str, size: float, at: tuple[float, float] = (0.0, 0.0)
) -> Margin:
    """A shape through a cloth: its ``size`` in halves of the height, its middle in halves of the
    cloth."""
    x, z = points[:, 0] - at[0] * half[0], points[:, 2] - at[1] * half[2]
    return shape_margin(torch.stack([x, z], 1) / (size * half[2]), shape) * size * half[2]


def kit_on_sides(points: Points, half: Half) -> Margin:
    """An ambulance's cross on both sides, and a stripe around it."""
    y, z = points[:, 1] - 0.38 * half[1], points[:, 2] - 0.14 * half[2]
    size = 0.58 * half[2]
    cross = shape_margin(torch.stack([y, z], 1) / size, "cross") * size
    stripe = 0.1 * half[2] - (points[:, 2] + 0.56 * half[2]).abs()
    return any_of(all_of(cross, points[:, 0].abs() - 0.6 * half[0]), stripe)


def scattered(
    points: Points,
    half: Half,
    shape: str,
    places: Sequence[tuple[float, float, float]],
    steep: float = 1.0,
) -> Margin:
    """Shapes around an upright axis.

    Args:
        places: for each shape the turn from the front in degrees, the height in halves and the size
            in halves of the width.
        steep: the slope's length over its rise.
    """
    x, y, z = points.unbind(1)
    turn, flat = torch.atan2(x, -y), torch.hypot(x, y)
    margins = []
    for angle, up, size in places:
        from_it = (turn - math.radians(angle) + math.pi).remainder(math.tau) - math.pi
        at = torch.stack([from_it * flat, (z - up * half[2]) * steep], 1)
        size = size * float(half[0])
        margins.append(shape_margin(at / size, shape) * size)
    return any_of(*margins)


def recycling(points: Points, half: Half, at: Sequence[Pair], size: float) -> Margin:
    """Three arrows in a triangle, each after the other, on the front and on the back; places in
    halves, the size in halves of the height."""
    size, arrow = size * float(half[2]), points.new_tensor(ARROW)
    margins = []
    for u, v in at:
        for sign in (1, -1):
            x, z = sign * (points[:, 0] - u * half[0]) / size, points[:, 2] / size - v
            out = -sign * points[:, 1] - 0.3 * half[1]
            for k in range(3):
                c, s = math.cos(k * math.tau / 3), math.sin(k * math.tau / 3)
                turned = torch.stack([c * x - s * z, s * x + c * z], 1)
                margins.append(all_of(within(turned, arrow) * size, out))
    return any_of(*margins)


def f_holes(points: Points, half: Half) -> Margin:
    """The two sound holes of a violin."""
    scale = points.new_tensor([half[0], half[2]])
    at = torch.stack([points[:, 0].abs(), points[:, 2]], 1)
    curve = points.new_tensor(F_HOLE) * scale
    ends = torch.cdist(at, curve[[0, -1]]).amin(1)
    return all_of(any_of(strokes(at, curve, 0.021), 0.036 - ends), in_front(points))


def spider_mark(points: Points, half: Half) -> Margin:
    """An hourglass on a spider's back."""
    along, side = points[:, 1] - 0.5 * half[1], points[:, 0].abs()
    wide = 0.03 + 0.5 * along.abs()
    return all_of((wide - side) * 0.85, 0.17 - along.abs(), points[:, 2])
