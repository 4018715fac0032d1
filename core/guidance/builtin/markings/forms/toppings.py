"""Sauce, snow, foam, water and other covers."""

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Pair, Points, all_of, any_of


def sauce(points: Points, half: Half, down: float = 0.72, count: int = 6) -> Margin:
    """Sauce that runs down in bows from the top of a ball of ice; how far, in halves of the
    width."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y)
    bows = 0.13 * (count * turn).cos() + 0.06 * (2 * turn + 1).sin()
    return 0.8 * (z - half[2] + (down + bows) * half[0])


def snow(points: Points, half: Half, tiers: int = 4, step: float = 0.45) -> Margin:
    """Snow on the edges of a fir's tiers, with a wavy border above."""
    x, y, z = points.unbind(1)
    wave = 0.03 * (torch.atan2(x, -y) * 9).cos()
    up = z / half[2] + 1
    tier = (up / step).floor().clamp(0, tiers - 1)
    return (0.17 + wave - (up - tier * step)) * half[2]


def foam(points: Points, half: Half) -> Margin:
    """Heaps of foam on water, at both ends."""
    x, y, _ = points.unbind(1)
    heaps = ((-0.62, 0.1, 0.2), (-0.42, -0.25, 0.16), (-0.3, 0.3, 0.12), (-0.75, -0.2, 0.14),
             (-0.1, 0.05, 0.08), (0.1, -0.32, 0.1), (0.24, -0.18, 0.06),
             (0.2, 0.4, 0.09))  # fmt: skip
    return any_of(
        *(size * half[0] - torch.hypot(x - u * half[0], y - v * half[1]) for u, v, size in heaps)
    )


def pool_water(points: Points, half: Half, size: Pair, at: float, high: Pair) -> Margin:
    """Water in a bowl: an oval seen from above, its half sides, its middle to the back, and its
    span of heights, in halves."""
    x, y, z = (points / half).unbind(1)
    away = torch.hypot(x / size[0], (y - at) / size[1])
    return all_of((1 - away) * size[0] * half[0], (z - high[0]) * half[2], (high[1] - z) * half[2])


def underside(points: Points, half: Half, high: float = 0.05) -> Margin:
    """The lowest part of a cap, ``high`` of its height."""
    return (2 * high - 1) * half[2] - points[:, 2]
