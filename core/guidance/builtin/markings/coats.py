"""Markings of animals' coats and of skins and peels."""

import math

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    cells_around,
    chance,
    in_front,
    strokes,
    within,
)

Line = tuple[tuple[float, float], ...]
# Of a butterfly's right wings, in halves of all four: their outlines, veins and dots.
FORE: Line = ((0.0, -0.1), (0.2, -0.5), (0.4, -0.78), (0.62, -0.94), (0.84, -1.0), (0.97, -0.92),
              (1.0, -0.76), (0.95, -0.42), (0.85, -0.1), (0.7, 0.05), (0.4, 0.16),
              (0.0, 0.2))  # fmt: skip
HIND: Line = ((0.0, 0.05), (0.4, 0.0), (0.68, 0.06), (0.76, 0.26), (0.75, 0.5), (0.68, 0.78),
              (0.55, 0.98), (0.38, 1.0), (0.22, 0.86), (0.1, 0.6), (0.0, 0.4))  # fmt: skip
VEINS: tuple[Line, ...] = (
    ((0.04, 0.0), (0.26, -0.4), (0.5, -0.62), (0.8, -1.0)),
    ((0.04, 0.0), (0.3, -0.14), (0.52, -0.3), (0.62, -0.5), (0.5, -0.62)),
    ((0.62, -0.5), (1.0, -0.8)), ((0.52, -0.3), (1.0, -0.5)), ((0.3, -0.14), (0.9, -0.12)),
    ((0.04, 0.2), (0.34, 0.24), (0.48, 0.34), (0.4, 0.5), (0.2, 0.44), (0.04, 0.2)),
    ((0.48, 0.34), (0.8, 0.3)), ((0.46, 0.4), (0.74, 0.64)), ((0.4, 0.5), (0.56, 1.0)),
    ((0.3, 0.48), (0.36, 1.0)),
)  # fmt: skip
EDGE = 0.075  # of a wing, training units


def patches(points: Points, _half: Half, pitch: float, line: float) -> Margin:
    """A giraffe's: the cells of a random set of points (Worley 1996), without a ``line`` between
    them."""
    away = []
    for cell in cells_around(points, pitch):
        moved = torch.stack([chance(cell, k) for k in range(3)], 1) - 0.5
        away.append((points - (cell + 0.5 + 0.7 * moved) * pitch).norm(dim=1))
    first, second = torch.stack(away, 1).topk(2, 1, largest=False).values.T
    return (second - first) / 2 - line / 2


def hoops(points: Points, half: Half, pitch: float) -> Margin:
    """A zebra's stripes: about the trunk and the neck, level on the legs."""
    x, y, z = points[:, 0].abs(), points[:, 1], points[:, 2]
    leg = ((-0.2 - z / half[2]) * 6).clamp(0, 1)
    slant = 0.35 * z.clamp_min(0)
    wave = 0.025 * (9 * z + 5 * x).sin() + 0.015 * (21 * z).sin()
    across = torch.lerp(y + slant + wave, 1.1 * z, leg)
    return ((across * (math.tau / pitch)).sin() - 0.1) * (pitch / math.tau)


def flames(points: Points, half: Half, pitch: float) -> Margin:
    """A tiger's stripes: from the back downwards ever thinner, every other one shorter; rings on
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


def ridge(points: Points, half: Half, wide: float) -> Margin:
    """A stripe along the back, ``wide`` in halves of the width."""
    return all_of(wide * half[0] - points[:, 0].abs(), points[:, 2] + points[:, 1] * 0.5)


def fish_bands(points: Points, half: Half, wide: float) -> Margin:
    """Three bands about a clownfish."""
    y = points[:, 1] / half[1]
    away = torch.stack([(y - at).abs() for at in (-0.42, 0.12, 0.72)]).amin(0)
    return wide - away * half[1]


def melon(points: Points, half: Half) -> Margin:
    """The jagged dark stripes of a melon that lies along x."""
    x, y, z = (points / half).unbind(1)
    angle = torch.atan2(z, y)
    jagged = 0.35 * (7 * x + 2 * angle.sin()).sin() + 0.25 * (19 * x + 5 * angle).sin()
    count = 9
    inside = (count * angle + 1.6 * jagged).sin() + 0.25 * (31 * x + 11 * angle).sin() - 0.25
    return inside * points[:, 1:].norm(dim=1) / count


def strawberry_seeds(points: Points, half: Half, rows: float = 6.0, count: int = 11) -> Margin:
    """In rows about it, each shifted against the next; longer than wide."""
    up = points[:, 2] / half[2] * rows
    row = up.round()
    turn = torch.atan2(points[:, 1], points[:, 0]) * (count / math.tau) + 0.5 * row.remainder(2)
    side = (turn - turn.round()).abs() * (math.tau / count) * points[:, :2].norm(dim=1)
    return 0.026 - torch.hypot(side * 1.4, (up - row) * half[2] / rows)


def seeds(points: Points, half: Half, count: int = 36, up: int = 2, size: float = 0.04) -> Margin:
    """On what is round about the axis ``up``, each pointing away from it: on a bun's top, or with
    ``up`` 1 on a flower's front."""
    sides = [axis for axis in range(3) if axis != up]
    at = points[:, sides] / half[sides].mean()
    number = torch.arange(count) + 0.5
    reach, turn = 0.8 * (number / count).sqrt(), number * (math.pi * (3 - math.sqrt(5)))
    ways = torch.stack([turn.cos(), turn.sin()], 1).to(at)
    off = at[:, None] - ways * reach.to(at)[:, None]
    along = (off * ways).sum(2)
    across = off[..., 0] * ways[:, 1] - off[..., 1] * ways[:, 0]
    seed = size - torch.hypot(along / 1.7, across).amin(1)
    here = points[:, 2] - 0.3 * half[2] if up == 2 else in_front(points)
    return all_of(seed * half[sides].mean(), here)


def wing_cases(points: Points, half: Half) -> Margin:
    """A ladybird's: three dots at either side, one in front, and the line between the wings."""
    at = torch.stack([points[:, 0].abs() / half[0], points[:, 1] / half[1]], 1)
    middles = at.new_tensor([(0.0, -0.72), (0.5, -0.4), (0.66, 0.18), (0.38, 0.58)])
    return any_of((0.19 - torch.cdist(at, middles).amin(1)) * half[0], 0.02 - points[:, 0].abs())


def _wings(points: Points, half: Half) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """Of a butterfly whose front is at -y: places on its right wings, what these are scaled with,
    and the margins of the fore and the hind one."""
    scale = half[:2].to(points)
    at = torch.stack([points[:, 0].abs(), points[:, 1]], 1)
    fore, hind = (within(at, points.new_tensor(line) * scale) for line in (FORE, HIND))
    return at, scale, fore, hind


def wing_cells(points: Points, half: Half) -> Margin:
    """What is between the veins of a butterfly's wings, and within their edges."""
    at, scale, fore, hind = _wings(points, half)
    veins = any_of(*(strokes(at, points.new_tensor(line) * scale, 0.011) for line in VEINS))
    return all_of(any_of(fore - EDGE, all_of(hind - EDGE, -0.015 - fore)), -veins)


def wing_dots(points: Points, half: Half, pitch: float = 0.09, size: float = 0.022) -> Margin:
    """In a row along the outer edges of a butterfly's wings."""
    at, scale, fore, hind = _wings(points, half)
    margins = []
    for line, first, last in ((FORE, 4, 9), (HIND, 2, 8)):
        corners = points.new_tensor(line[first : last + 1]) * scale
        middles = evenly(corners, pitch) * 0.93 + points.new_tensor([0.0, 0.01])
        margins.append(size - torch.cdist(at, middles).amin(1))
    return all_of(any_of(*margins), any_of(fore, hind))


def evenly(places: Float[Tensor, "c 2"], pitch: float) -> Float[Tensor, "n 2"]:
    """Places about ``pitch`` apart on a line from place to place."""
    way = places[1:] - places[:-1]
    long = way.norm(dim=1)
    count = max(round(float(long.sum()) / pitch), 1)
    share = (torch.arange(count, device=places.device) + 0.5) / count * long.sum()
    ends = long.cumsum(0)
    k = torch.searchsorted(ends, share).clamp_max(len(long) - 1)
    into = 1 - (ends[k] - share) / long[k]
    return places[k] + into[:, None] * way[k]
