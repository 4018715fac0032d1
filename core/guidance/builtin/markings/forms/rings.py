"""Discs, rings, spirals and rays."""

import math
from collections.abc import Sequence

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
)

SECTORS = 20  # of a dartboard
HOLE, HOLES = 0.11, 0.6  # of a hub: their radius, and their distance from its middle in its radius


def disc(points: Points, half: Half, radius: float) -> Margin:
    """A disc in the middle of the front; ``radius`` in halves of the width."""
    return all_of(radius * half[0] - points[:, [0, 2]].norm(dim=1), in_front(points))


def rim(points: Points, half: Half, low: float, high: float) -> Margin:
    """A ring on the front, radii in halves of the width."""
    return all_of(rings(points, half, ((low, high),)), in_front(points))


def rings(
    points: Points, half: Half, spans: Sequence[tuple[float, float]], axis: int = 1
) -> Margin:
    """Rings around the middle of both faces across an axis, radii in halves of the width."""
    away = points[:, [side for side in range(3) if side != axis]].norm(dim=1)
    pairs = ((low * half[0], high * half[0]) for low, high in spans)
    return any_of(*(all_of(high - away, away - low) for low, high in pairs))


def plate_rings(points: Points, half: Half) -> Margin:
    """A plate's edge, a line next to it, and from above a line around its well."""
    away = points[:, :2].norm(dim=1) / half[0]
    well = all_of((0.025 - (away - 0.68).abs()) * half[0], points[:, 2])
    return any_of((away - 0.91) * half[0], (0.012 - (away - 0.86).abs()) * half[0], well)


def cone_rings(points: Points, half: Half, spans: Sequence[Pair], out: float = 0.35) -> Margin:
    """Rings on the cones of a loudspeaker, given its box; radii in those of the cones."""
    x, y, z = points.unbind(1)
    margins = []
    for radius, up in ((0.7, half[0] - half[2]), (0.43, half[2] - 0.763 * half[0])):
        away, size = torch.hypot(x, z - up), radius * half[0]
        margins += [all_of(high * size - away, away - low * size) for low, high in spans]
    return all_of(any_of(*margins), -y - out * half[1])


def rosette(points: Points, half: Half) -> Margin:
    """A ring around a guitar's sound hole, which is at the lower end of its neck."""
    away = torch.hypot(points[:, 0], points[:, 2] + half[2] - half[0]) / half[0]
    return all_of((0.09 - (away - 0.8).abs()) * half[0], in_front(points))


def _darts(points: Points, half: Half) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """For a dartboard: distances from its middle, the margins of every other sector and of the two
    rings, and the radius of the whole."""
    r = 0.79 * half[0]
    away = points[:, [0, 2]].norm(dim=1)
    angle = torch.atan2(points[:, 0], points[:, 2]) * (SECTORS / 2)
    sectors = angle.cos() * away * (2 / SECTORS)
    both = any_of(*(0.045 * r - (away - at * r).abs() for at in (0.955, 0.6)))
    return away, sectors, both, r


def pale_sectors(points: Points, half: Half) -> Margin:
    """Every other sector of a dartboard."""
    away, sectors, _, r = _darts(points, half)
    return all_of(-sectors, r - away, in_front(points))


def dart_reds(points: Points, half: Half) -> Margin:
    """The rings on the dark sectors of a dartboard, and the bull's eye."""
    away, sectors, both, r = _darts(points, half)
    return all_of(any_of(all_of(sectors, both), 0.065 * r - away), in_front(points))


def dart_greens(points: Points, half: Half) -> Margin:
    """The rings on the pale sectors of a dartboard, and the ring around the bull's eye."""
    away, sectors, both, r = _darts(points, half)
    bull = 0.035 * r - (away - 0.1 * r).abs()
    return all_of(any_of(all_of(-sectors, both), bull), in_front(points))


def spiral(points: Points, half: Half) -> Margin:
    """The spiral of a lollipop on both sides."""
    pitch = 0.52 * half[0]
    turn = torch.atan2(points[:, 2], points[:, 0]) / math.tau
    phase = points[:, [0, 2]].norm(dim=1) / pitch + turn
    return (0.24 - (phase - phase.round()).abs()) * pitch


def whorl(points: Points, _half: Half, pitch: float = 0.16, line: float = 0.016) -> Margin:
    """The spiral of a snail shell on both sides."""
    away = points[:, 1:].norm(dim=1)
    turn = torch.atan2(points[:, 2], points[:, 1]) / math.tau
    phase = away / pitch - turn
    return line - (phase - phase.round()).abs() * pitch


def spokes(points: Points, half: Half, count: int, wide: float, reach: Pair) -> Margin:
    """Lines outwards from the middle, seen from above; ``reach``: their ends in halves."""
    x, y = points[:, 0], points[:, 1]
    away, step = torch.hypot(x, y), math.tau / count
    turn = torch.atan2(x, y) / step + 0.5
    across = away * ((turn - turn.round()) * step).sin().abs()
    return all_of(wide - across, away - reach[0] * half[0], reach[1] * half[0] - away)


def rays(points: Points, half: Half, span: tuple[float, float], count: int, wide: float) -> Margin:
    """Strokes between two radii around the middle of a front, pointed outwards."""
    x, z = points[:, 0], points[:, 2]
    away = torch.hypot(x, z) / half[0]
    turn = torch.atan2(x, z) * (count / math.tau)
    off = ((turn - turn.round()) * (math.tau / count)).abs() * torch.hypot(x, z)
    low, high = span
    slim = wide * ((high - away) / (high - low)).clamp(0, 1)
    return all_of(slim - off, (away - low) * half[0], (high - away) * half[0])


def leaning(points: Points, degrees: float) -> Points:
    """Places on a part that faces up and to the front, turned so that it faces up."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y, z = points.unbind(1)
    return torch.stack([x, c * y - s * z, s * y + c * z], 1)


def dish_seams(points: Points, half: Half, lean: float = 44.0, count: int = 8) -> Margin:
    """Lines outwards and a ring on a dish that faces up and to the front."""
    points = leaning(points, -lean)
    away = torch.hypot(points[:, 0], points[:, 1])
    ring = 0.012 - torch.minimum((away - 0.3 * half[0]).abs(), (away - 0.64 * half[0]).abs())
    return any_of(spokes(points, half, count, 0.012, (0.3, 0.96)), ring)


def hub(points: Points, half: Half, radius: float = 0.6, holes: int = 5) -> Margin:
    """A hub cap on both faces of a wheel, with holes in a ring; ``radius`` in the wheel's."""
    axle = int(half.argmin())
    across = [k for k in range(3) if k != axle]
    size = float(half[across].min())
    u, v = points[:, across[0]], points[:, across[1]]
    far = torch.hypot(u, v)
    turn = torch.atan2(v, u) * (holes / math.tau)
    aside = (turn - turn.round()) * (math.tau / holes) * far
    hole = HOLE * size - torch.hypot(aside, far - HOLES * radius * size)
    return all_of(radius * size - far, -hole, points[:, axle].abs() - half[axle] / 2)
