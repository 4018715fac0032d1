"""Tiles, bricks, mosaics and checks, and the joints between them."""

import math
from collections.abc import Sequence

import torch
import torch.nn.functional as F

from core.guidance.builtin.markings.forms.bands import bands
from core.guidance.builtin.markings.margins import Half, Margin, Pair, Points, all_of, any_of


def tiles(
    points: Points,
    half: Half,
    pitch: tuple[float, float] = (0.13, 0.17),
    axis: int = 0,
    wide: float = 0.009,
    edge: float = 0.02,
) -> Margin:
    """Lines between the tiles of a roof: their height and width; the ridge is along ``axis``, and
    both ends are plain within ``edge``."""
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
    """Mortar between the bricks of four walls: their height and width."""
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
    """Joints of a round wall."""
    x, y, z = points.unbind(1)
    pitch = 2 * half[2] / rows
    row = (z + half[2]) / pitch
    level = (row - row.round().clamp(1, rows - 1)).abs() * pitch
    turn = torch.atan2(x, -y) * (count / math.tau) + 0.5 * row.floor().remainder(2)
    upright = (turn - turn.round()).abs() * (math.tau / count) * torch.hypot(x, y)
    return wide - torch.minimum(level, upright)


def mosaic(points: Points, half: Half, spans: Sequence[Pair], count: int) -> Margin:
    """Squares all around, each three quarters of its room."""
    x, y, _ = points.unbind(1)
    turn = torch.atan2(x, -y) * (count / math.tau)
    across = (0.38 - (turn - turn.round()).abs()) * (math.tau / count) * torch.hypot(x, y)
    rows = (bands(points, half, 2, low, high) for low, high in spans)
    return all_of(across, any_of(*rows))


def mirror_gaps(points: Points, half: Half, rows: int = 18) -> Margin:
    """Lines between the rows of tiles of a mirror ball."""
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
    """Dark squares of eight by eight, seen from above; a1 is dark."""
    at = points[:, :2] / half[:2] * 4
    dark = at.floor().sum(1).remainder(2) == 0
    away = (at - at.round()).abs().amin(1) * (half[0] / 4)
    return torch.where(dark, away, -away)


def solar_cells(points: Points, half: Half, columns: int = 6, rows: int = 4) -> Margin:
    """Squares without corners in rows on a panel that leans back."""
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
