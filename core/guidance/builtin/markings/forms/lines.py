"""Parallel lines: ribs, grooves, flutes, turns of rope, ruled paper."""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.forms.faces import FRONT, Curve
from core.guidance.builtin.markings.margins import (
    UP,
    Half,
    Margin,
    Pair,
    Points,
    Way,
    all_of,
    any_of,
    in_front,
    strokes,
    unit,
)
from core.guidance.builtin.markings.shapes import shape_margin


def levels(points: Points, _half: Half, pitch: float, wide: float = 0.014, axis: int = 2) -> Margin:
    """Lines across an axis all around, ``pitch`` apart; half their width ``wide``."""
    at = points[:, axis] / pitch
    return wide - (at - at.round()).abs() * pitch


def bars(
    points: Points,
    half: Half,
    way: Way = UP,
    pitch: float = 0.1,
    wide: float = 0.011,
    span: Pair = (-9.0, 9.0),
) -> Margin:
    """Lines across a direction, such as between the plates of a belly; ``span`` in halves along
    it."""
    out = unit(points, way)
    along, reach = points @ out, (half.to(out) * out).norm()
    away = along / pitch
    lines = wide - (away - away.floor() - 0.5).abs() * pitch
    return all_of(lines, along - span[0] * reach, span[1] * reach - along)


def drawn_lines(
    points: Points,
    half: Half,
    curves: Sequence[Curve],
    wide: float = 0.016,
    axes: tuple[int, int] = FRONT,
) -> Margin:
    """Lines on both faces of a flat part, such as a wing's bones or quills; in halves."""
    at, sides = points[:, list(axes)], half[list(axes)]
    return any_of(*(strokes(at, at.new_tensor(curve) * sides, wide) for curve in curves))


def container_ribs(points: Points, half: Half, pitch: float = 0.052, aside: float = 0.7) -> Margin:
    """Upright lines on the outer sides of a ship's containers, given the box of its hull."""
    lines = levels(points, half, pitch, 0.01, 1)
    return all_of(lines, points[:, 0].abs() - aside * half[0])


def links(points: Points, half: Half, count: int = 17) -> Margin:
    """Links along the upper and lower edges of a tank's tracks."""
    pitch = 2 * half[1] / count
    at = points[:, 1] / pitch
    gap = 0.3 * pitch - (at - at.round()).abs() * pitch
    return all_of(gap, points[:, 2].abs() - 0.52 * half[2])


def coil(points: Points, half: Half, reach: float, pitch: float = 0.036) -> Margin:
    """Turns of a rope around the middle of a part along x; their reach in halves."""
    at = points[:, 0] / pitch
    turn = (0.4 - (at - at.round()).abs()) * pitch
    return all_of(turn, reach * half[0] - points[:, 0].abs())


def flutes(points: Points, half: Half, count: int, fraction: float, high: float) -> Margin:
    """Upright bands all around, ``fraction`` of the way; ``high`` in halves."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    arc = points[:, :2].norm(dim=1) * (math.tau / count)
    across = (fraction / 2 - (turn - turn.round()).abs()) * arc
    return all_of(across, high * half[2] - points[:, 2].abs())


def lying_flutes(points: Points, half: Half, count: int) -> Margin:
    """Grooves along the head of a torch that points to the front."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, z) * (count / math.tau)
    away = torch.hypot(x, z)
    across = 0.02 - (turn - turn.round()).abs() * (math.tau / count) * away
    return all_of(across, y + 0.5 * half[1], 0.9 * half[1] - y, away - 0.7 * half[0])


def gills(points: Points, half: Half, count: int = 40, wide: float = 0.008) -> Margin:
    """Lines outwards on the underside of a cap, not on its border."""
    x, y = points[:, 0], points[:, 1]
    turn = torch.atan2(x, y) * (count / math.tau)
    away = torch.hypot(x, y)
    line = wide - (turn - turn.round()).abs() * (math.tau / count) * away
    return all_of(line, 0.94 * half[0] - away)


def throat(points: Points, half: Half, count: int = 9, line: float = 0.013) -> Margin:
    """Grooves along a whale around its lower side, from the front to its middle."""
    turn = torch.atan2(points[:, 0], -points[:, 2] + 0.3 * half[2])
    step = math.pi / count
    away = (turn / step - (turn / step).round()).abs() * step
    reach = points[:, [0, 2]].norm(dim=1)
    return all_of(line - away * reach, 0.3 * half[1] - points[:, 1])


def grill_marks(points: Points, half: Half, high: float, pitch: float = 0.2) -> Margin:
    """Slanted lines on food that is on another part, given the box of that part: places more than
    ``high`` above its middle, in halves of its width."""
    phase = (points[:, 0] + points[:, 1]) / (pitch * math.sqrt(2))
    line = (0.13 - (phase - phase.round()).abs()) * pitch
    return all_of(line, points[:, 2] - high * half[0])


LINES = [0.6 - 0.27 * k for k in range(6)]  # of a clipboard, in halves of the paper's height


def ruled(
    points: Points,
    half: Half,
    lines: Sequence[float] = LINES,
    ends: tuple[float, float] = (-0.42, 0.8),
) -> Margin:
    """Lines of a list, every other one shorter; their heights and ends in halves of the paper."""
    x, z = points[:, 0] / half[0], points[:, 2] / half[2]
    begin, margins = ends[0], []
    for k, at in enumerate(lines):
        end = ends[1] - 0.22 * (k % 2)
        wide = (end - begin) / 2 - (x - (end + begin) / 2).abs()
        margins.append(all_of(wide * half[0], 0.022 * half[2] - (z - at).abs() * half[2]))
    return all_of(any_of(*margins), in_front(points))


def ticked(points: Points, half: Half, done: int = 4) -> Margin:
    """Squares in front of the lines of a list, ``done`` of them ticked."""
    size = 0.1 * float(half[0])
    margins = []
    for k, at in enumerate(LINES):
        place = torch.stack([points[:, 0] + 0.64 * half[0], points[:, 2] - at * half[2]], 1) / size
        margins.append(0.13 - (place.abs().amax(1) - 0.9).abs())
        if k < done:
            margins.append(shape_margin(place / 1.15, "check mark") * 1.15)
    return all_of(any_of(*margins) * size, in_front(points))
