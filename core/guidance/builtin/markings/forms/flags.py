"""Cantons, stars, crosses and lozenges of flags, whose cloth hangs along x from the pole."""

import math

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of
from core.guidance.builtin.markings.shapes import shape_margin

UNION = 0.4  # of the width, of a canton


def stripes(points: Points, half: Half) -> Margin:
    """The six white stripes of thirteen."""
    pitch = 2 * half[2] / 13
    row = (points[:, 2] + half[2]) / pitch
    inside = 0.5 - (row - row.floor() - 0.5).abs()
    return torch.where(row.floor().remainder(2) == 1, inside, -inside) * pitch


def canton(points: Points, half: Half) -> Margin:
    """The upper corner at the pole, as high as seven stripes."""
    right = (2 * UNION - 1) * half[0]
    return all_of(right - points[:, 0], points[:, 2] + half[2] - 12 * half[2] / 13)


def stars(points: Points, half: Half) -> Margin:
    """Five rows of six stars on the canton."""
    wide, high = 2 * UNION * half[0] / 6, (14 / 13) * half[2] / 5
    x, z = (points[:, 0] + half[0]) / wide, (half[2] - points[:, 2]) / high
    side = 0.3 * min(float(wide), float(high))
    away = torch.stack(
        [(x - x.floor() - 0.5) * wide / side, (0.5 - z + z.floor()) * high / side], 1
    )
    return all_of(shape_margin(away, "star") * side, canton(points, half))


def _saltire(points: Points, half: Half) -> Tensor:
    """Distances from the nearer diagonal."""
    x, z = points[:, 0].abs() / half[0], points[:, 2].abs() / half[2]
    return (x - z).abs() / math.hypot(1 / float(half[0]), 1 / float(half[2]))


def crosses(points: Points, half: Half, upright: float, saltire: float) -> Margin:
    """An upright cross and a diagonal one; half their widths in halves of the height."""
    straight = torch.minimum(points[:, 0].abs(), points[:, 2].abs())
    return any_of(upright * half[2] - straight, saltire * half[2] - _saltire(points, half))


def nordic(points: Points, half: Half, wide: float) -> Margin:
    """A cross whose upright is nearer to the pole."""
    away = torch.minimum((points[:, 0] + 0.28 * half[0]).abs(), points[:, 2].abs())
    return wide * half[2] - away


def lozenge(points: Points, half: Half) -> Margin:
    """A lozenge nearly as large as the cloth."""
    away = points[:, 0].abs() / half[0] + points[:, 2].abs() / half[2]
    return (0.85 - away) / math.hypot(1 / float(half[0]), 1 / float(half[2]))


def outer(points: Points, half: Half) -> Margin:
    """The quarters at both ends."""
    return points[:, 0].abs() - 0.5 * half[0]
