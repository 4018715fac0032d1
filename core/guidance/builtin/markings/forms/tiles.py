"""Tiles, bricks, mosaics and checks, and the joints between them."""

import math
from collections.abc import Sequence

import torch
import torch.nn.functional as F

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of
from core.guidance.builtin.markings.outlines import Pair


def tiles(
    points: Points,
    half: Half,
    pitch: tuple[float, float] = (0.13, 0.17),
    axis: int = 0,
    wide: float = 0.009,
    edge: float = 0.02,
) -> Margin:
    """The lines between a roof's: their height and width; the ridge is along the axis, and its
    ends, within ``edge`` of which there are none, are plain."""
    row = (points[:, 2] + half[2]) / pitch[0]
    level = (row - row.round()).abs() * pitch[0]
    place = points[:, axis] / pitch[1] + row.floor().remainder(2) / 2
    upright = (place - place.round()).abs() * pitch[1]
    line = any_of(wide - level, wide - upright)
    return all_of(line, half[axis] - edge - points[:, axis].abs())


def courses(
    points: Points,
    half: Half,
    pitch: tuple[float, float] = (0.11, 0.22),
    wide: float = 0.009,
) -> Margin:
    """The mortar between the bricks of four walls: their height and width."""
    x, y, z = points.unbind(1)
    row = (z + half[2]) / pitch[0]
    level = (row - row.round()).abs() * pitch[0]
    shift = row.floor().remainder(2) / 2
    facing = x.abs() * half[1] > y.abs() * half[0]
    place = facing * y / pitch[1] + ~facing * x / pitch[1] + shift
    return any_of(wide - level, wide - (place - place.round()).abs() * pitch[1])


def bricks(
    points: Points, half: Half, rows: int = 7, count: int = 10, wide: float = 0.013
) -> Margin:
    """The joints of a round wall."""
    x, y, z = points.unbind(1)
    pitch = 2 * half[2] / rows
    row = (z + half[2]) / pitch
    level = (row - row.round().clamp(1, rows - 1)).abs() * pitch
    turn = torch.atan2(x, -y) * (count / math.tau) + 0.5 * row.floor().remainder(2)
    upright = (turn - turn.round()).abs() * (math.tau / count) * torch.hypot(x, y)
    return wide - torch.minimum(level, upright)


def mosaic(points: Points, half: Half, spans: Sequence[Pair], count: int) -> Margin:
    """Squares side by side all round, each three quarters of its room."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y) * (count / math.tau)
    across = (0.38 - (turn - turn.round()).abs()) * (math.tau / count) * torch.hypot(x, y)
    rows = (all_of(z - low * half[2], high * half[2] - z) for low, high in spans)
    return all_of(across, any_of(*rows))


def mirror_gaps(points: Points, half: Half, rows: int = 18) -> Margin:
    """The lines between a mirror ball's tiles, which lie in rows."""
    x, y, z = F.normalize(points, dim=1).unbind(1)
    north = (z.clamp(-1, 1).asin() / math.pi + 0.5) * rows
    row = north.floor().clamp(0, rows - 1)
    middle = ((row + 0.5) / rows - 0.5) * math.pi
    count = (2 * rows * middle.cos()).round().clamp_min(3)
    east = (torch.atan2(y, x) / math.tau + 0.5) * count + 0.5 * row.remainder(2)
    up = (north - north.round()).abs() * (math.pi / rows)
    side = (east - east.round()).abs() * (math.tau / count) * middle.cos()
    return (0.012 - torch.minimum(up, side)) * half.mean()


def checks(points: Points, half: Half) -> Margin:
    """The dark ones of eight by eight squares, seen from above; a1 is one."""
    at = points[:, :2] / half[:2] * 4
    dark = at.floor().sum(1).remainder(2) == 0
    away = (at - at.round()).abs().amin(1) * (half[0] / 4)
    return torch.where(dark, away, -away)


def solar_cells(points: Points, half: Half, columns: int = 6, rows: int = 4) -> Margin:
    """Of a panel that leans back: squares without their corners, in rows."""
    slope = torch.stack([half[1], half[2]])
    along, long = (points[:, 1:] @ slope) / slope.norm(), slope.norm()
    upper = points[:, 2] * half[1] - points[:, 1] * half[2]
    margins = []
    for at, reach, count in ((points[:, 0], half[0], columns), (along, long, rows)):
        pitch = 2 * 0.97 * reach / count
        place = at / pitch + count / 2
        margins.append((0.5 - (place - place.floor() - 0.5).abs()) * pitch)
    corner = (margins[0] + margins[1] - 0.042) / math.sqrt(2)
    return all_of(margins[0] - 0.007, margins[1] - 0.007, corner, upper / slope.norm())
