"""Markings of what is built of boards, or woven."""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, in_front

LID = 0.7  # of a barrel's radius, of which a lid is at least


def planks(points: Points, half: Half, count: int, axis: int = 2, wide: float = 0.009) -> Margin:
    """The seams between so many planks that follow one another along an axis; each is twice
    ``wide`` (training units), whatever the planks' size."""
    pitch = 2 * half[axis] / count
    at = points[:, axis] / pitch + count / 2
    return wide - (at - at.round().clamp(1, count - 1)).abs() * pitch


def frets(points: Points, half: Half, count: int = 13) -> Margin:
    """Of a guitar's neck, below its head."""
    below = 0.62 * half[2] - points[:, 2]
    return all_of(planks(points, half, count, wide=0.007), below, in_front(points))


def staves(points: Points, half: Half, count: int = 14, wide: float = 0.01) -> Margin:
    """The seams of a barrel, straight across its lids."""
    x, y, _ = points.unbind(1)
    turn = torch.atan2(x, -y) * (count / math.tau)
    flat = torch.hypot(x, y)
    around = (turn - turn.round()).abs() * (math.tau / count) * flat
    across = planks(points, half, count // 2, 0, wide)
    return torch.where(flat < LID * half[0], across, wide - around)


def boarding(points: Points, half: Half, pitch: float = 0.1, wide: float = 0.008) -> Margin:
    """The upright seams of boards on four walls."""
    x, y, _ = points.unbind(1)
    along = torch.where(x.abs() * half[1] > y.abs() * half[0], y, x) / pitch
    return wide - (along - along.floor() - 0.5).abs() * pitch


def weave(points: Points, half: Half, around: int = 24, rows: int = 9) -> Margin:
    """Every other strand of a basket, over and under."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y) * (around / math.tau)
    up = z / half[2] * (rows / 2)
    over = (turn.floor() + up.floor()).remainder(2) == 0
    side = (turn - turn.round()).abs() * (math.tau / around) * torch.hypot(x, y)
    away = torch.minimum(side, (up - up.round()).abs() * (2 * half[2] / rows))
    return torch.where(over, away, -away)
