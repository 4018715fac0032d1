"""Stripes of coats, peels, cloth, boxes and canopies."""

import math

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front


def zebra_stripes(points: Points, half: Half, pitch: float) -> Margin:
    """Stripes of a zebra: around the trunk and the neck, level on the legs."""
    x, y, z = points[:, 0].abs(), points[:, 1], points[:, 2]
    leg = ((-0.2 - z / half[2]) * 6).clamp(0, 1)
    slant = 0.35 * z.clamp_min(0)
    wave = 0.025 * (9 * z + 5 * x).sin() + 0.015 * (21 * z).sin()
    across = torch.lerp(y + slant + wave, 1.1 * z, leg)
    return ((across * (math.tau / pitch)).sin() - 0.1) * (pitch / math.tau)


def tiger_stripes(points: Points, half: Half, pitch: float) -> Margin:
    """Stripes of a tiger: from the back downwards ever thinner, every other one shorter; rings on
    the legs."""
    y, z = points[:, 1], points[:, 2]
    high = z / half[2]
    along = y + 0.03 * (8 * z).sin() + 0.02 * (17 * z + 3 * y).sin()
    row = (along / pitch).round()
    end = torch.where(row.remainder(2) == 0, -0.25, 0.1)
    wide = pitch * 0.26 * ((high - end) / (0.75 - end)).clamp(0, 1).sqrt()
    upper = wide - (along - row * pitch).abs()
    ring = 0.022 - ((z / pitch) - (z / pitch).round()).abs() * pitch
    legs = torch.where(high < -0.45, ring, -pitch)
    return torch.where(wide > 0, upper, any_of(upper - 0.01, legs))


def back_stripes(
    points: Points, half: Half, pitch: float = 0.16, fraction: float = 0.3, fall: float = 0.45
) -> Margin:
    """Stripes across a back that falls to the tail, behind the neck, every other one shorter."""
    along = points[:, 1] / pitch
    above = points[:, 2] / half[2] + fall * points[:, 1] / half[1]
    every = along.round().remainder(2)
    wide = fraction * pitch * ((above + 0.3) / 0.6 - 0.4 * every).clamp(0, 1).sqrt()
    found = torch.where(wide > 0, wide - (along - along.round()).abs() * pitch, -0.02)
    return all_of(found, points[:, 1] + 0.12 * half[1])


def fish_bands(points: Points, half: Half, wide: float) -> Margin:
    """Three bands around a clownfish."""
    y = points[:, 1] / half[1]
    away = torch.stack([(y - at).abs() for at in (-0.42, 0.12, 0.72)]).amin(0)
    return wide - away * half[1]


def snake_bands(points: Points, half: Half, count: int = 12, fraction: float = 0.16) -> Margin:
    """Slanted bands around the rings of a coiled snake, none on its neck inside."""
    away = points[:, :2].norm(dim=1)
    turn = torch.atan2(points[:, 0], points[:, 1]) / math.tau * count - 4 * points[:, 2]
    step = math.tau / count * away
    bands = (fraction - (turn - turn.round()).abs()) * step / (1 + (4 * step).square()).sqrt()
    return all_of(bands, away - 0.42 * half[0])


def melon_stripes(points: Points, half: Half) -> Margin:
    """Jagged dark stripes of a melon along x."""
    x, y, z = (points / half).unbind(1)
    angle = torch.atan2(z, y)
    jagged = 0.35 * (7 * x + 2 * angle.sin()).sin() + 0.25 * (19 * x + 5 * angle).sin()
    count = 9
    inside = (count * angle + 1.6 * jagged).sin() + 0.25 * (31 * x + 11 * angle).sin() - 0.25
    return inside * points[:, 1:].norm(dim=1) / count


def slanted(points: Points, _half: Half, pitch: float) -> Margin:
    """Stripes of a necktie, a third of ``pitch`` wide."""
    phase = (points[:, 2] + 0.8 * points[:, 0]) / pitch
    return (0.17 - (phase - phase.round()).abs()) * (pitch / math.hypot(1, 0.8))


def popcorn_stripes(points: Points, half: Half, clear: float, narrow: float = 0.65) -> Margin:
    """Upright stripes on a box ``narrow`` as wide below, not within ``clear`` of the middle of its
    front, in halves of the width."""
    across, wide = on_four_sides(points, half, narrow)
    phase = (across / wide + 1) * 2.25 - 0.75
    stripe = (0.25 - (phase - phase.round()).abs()) * wide / 2.25
    near = all_of(clear * half[0] - points[:, [0, 2]].norm(dim=1), in_front(points))
    return all_of(stripe, -near)


def on_four_sides(
    points: Points, half: Half, narrow: float, top: float = 1.0
) -> tuple[Tensor, Tensor]:
    """For a part with four upright sides: places from the middle of the nearest side, and half its
    width, which is ``narrow`` below and ``top`` above in halves of the width."""
    x, y, z = points.unbind(1)
    fraction = ((z / half[2] + 1) / 2).clamp(0, 1)
    side = torch.where(x.abs() > y.abs(), x.sign() * y, -y.sign() * x)
    return side, (narrow + (top - narrow) * fraction) * half[0]


def foot_stripes(points: Points, half: Half, count: int = 14) -> Margin:
    """Slanted stripes around a round foot, below a third of the height."""
    x, y, z = points.unbind(1)
    away = torch.hypot(x, y)
    turn = (torch.atan2(x, -y) + 0.8 * z / half[0]) * (count / math.tau)
    across = (0.25 - (turn - turn.round()).abs()) * (math.tau / count) * away
    return all_of(across, -0.52 * half[2] - z, away - 0.8 * half[0])


def sectors(points: Points, _half: Half, count: int) -> Margin:
    """Every other one of ``count`` sectors of a canopy, from the top to the rim."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    away = (turn - turn.round()).abs() * (math.tau / count)
    return math.pi / (2 * count) * points[:, :2].norm(dim=1) - away * points[:, :2].norm(dim=1)


def edge_spots(points: Points, half: Half, count: int = 6) -> Margin:
    """Spots on the edge of a poker chip."""
    turn = torch.atan2(points[:, 2], points[:, 0]) * (count / math.tau)
    return (0.22 - (turn - turn.round()).abs()) * (math.tau / count) * half[0]
