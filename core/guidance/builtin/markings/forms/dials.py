"""Marks of dials, compasses, rulers and flasks."""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front
from core.guidance.builtin.markings.stencils import lettering

INCHES = 12  # of a ruler


def hours(points: Points, half: Half, radius: float) -> Margin:
    """Twelve strokes along the rim of a dial, every third longer and bolder."""
    x, z, r = points[:, 0], points[:, 2], radius * half[0]
    hour = torch.atan2(x, z) * (6 / math.pi)
    nearest, away = hour.round(), points[:, [0, 2]].norm(dim=1)
    bold = nearest.remainder(3) == 0
    across = away * ((hour - nearest) * (math.pi / 6)).sin().abs()
    inner, wide = torch.where(bold, 0.7, 0.78) * r, torch.where(bold, 0.045, 0.026) * r
    return all_of(wide - across, away - inner, 0.9 * r - away, in_front(points))


def meter_marks(points: Points, half: Half, count: int = 7) -> Margin:
    """Strokes along the half-round window of a parking meter, given the box of its head."""
    x, z = points[:, 0], points[:, 2] - (half[2] - half[0])
    step = math.pi / (count + 1)
    turn = torch.atan2(x, z) / step
    nearest, away = turn.round().clamp(-(count // 2), count // 2), torch.hypot(x, z)
    across = away * ((turn - nearest) * step).sin().abs()
    reach = all_of(away - 0.46 * half[0], 0.64 * half[0] - away)
    return all_of(0.012 - across, reach, in_front(points), z)


def dial_holes(points: Points, half: Half, count: int = 10) -> Margin:
    """Finger holes of a dial that leans back, without the lowest on the right."""
    along = half[1:] / half[1:].norm()
    at = torch.stack([points[:, 0], points[:, 1:] @ along], 1)
    angles = [math.radians(-20 + 270 * k / (count - 1)) for k in range(count)]
    middles = 0.79 * half[0] * at.new_tensor([(math.cos(a), math.sin(a)) for a in angles])
    return 0.125 * half[0] - (at[:, None] - middles).norm(dim=2).amin(1)


def rose(points: Points, half: Half, radius: float) -> Margin:
    """A compass rose: the letters of the four winds, and strokes between them along the rim."""
    x, z, r = points[:, 0], points[:, 2], radius * half[0]
    part = torch.atan2(x, z) * (12 / math.pi)
    nearest, away = part.round(), points[:, [0, 2]].norm(dim=1)
    across = away * ((part - nearest) * (math.pi / 12)).sin().abs()
    wide = torch.where(nearest.remainder(3) == 0, 0.034, 0.018) * r
    wide = torch.where(nearest.remainder(6) == 0, -r, wide)  # a letter is there
    stroke = all_of(wide - across, away - 0.8 * r, 0.96 * r - away)
    letters, size = [], 0.24 * r
    for k, letter in enumerate("NESW"):
        u, v = 0.8 * r * math.sin(k * math.pi / 2), 0.8 * r * math.cos(k * math.pi / 2)
        place = torch.stack([x - u, z - v], 1) / size
        letters.append((lettering(place, letter) + 0.03) * size)
    return all_of(any_of(stroke, *letters), in_front(points))


def inches(points: Points, half: Half) -> Margin:
    """Marks of quarter inches along the upper edge of a ruler, with the numbers of the inches."""
    pitch = 2 * (half[0] - 0.03) / INCHES
    quarter = points[:, 0] / pitch * 4
    nearest = quarter.round().clamp(-2 * INCHES, 2 * INCHES)
    long = torch.where(
        nearest.remainder(4) == 0, 0.62, torch.where(nearest.remainder(2) == 0, 0.44, 0.28)
    )
    tick = all_of(
        0.006 - (quarter - nearest).abs() * pitch / 4, points[:, 2] - half[2] * (1 - long)
    )
    size = 0.5 * half[2]
    numbers = []
    for k in range(1, INCHES):
        x, z = points[:, 0] - (k - INCHES / 2) * pitch, points[:, 2] + 0.3 * half[2]
        numbers.append(lettering(torch.stack([x, z], 1) / size, str(k)) * size)
    return any_of(tick, all_of(any_of(*numbers), in_front(points)))


def scale_marks(points: Points, half: Half) -> Margin:
    """Level strokes on the front of a flask, every other one longer."""
    margins = []
    for k, at in enumerate((-0.86, -0.68, -0.5, -0.32)):
        long, up = (0.36, 0.24)[k % 2] * half[0], (points[:, 2] - at * half[2]).abs()
        margins.append(all_of(long - points[:, 0].abs(), 0.014 - up))
    return all_of(any_of(*margins), in_front(points))
