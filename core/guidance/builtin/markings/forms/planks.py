"""Joints of planks, staves, boards, frets and keys; furrows of bark."""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front

LID = 0.7  # of a barrel's radius, of which a lid is at least


def planks(points: Points, half: Half, count: int, axis: int = 2, wide: float = 0.009) -> Margin:
    """Joints between ``count`` planks in a row along an axis; half a joint's width ``wide`` in
    training units, whatever the planks' size."""
    pitch = 2 * half[axis] / count
    at = points[:, axis] / pitch + count / 2
    return wide - (at - at.round().clamp(1, count - 1)).abs() * pitch


def frets(points: Points, half: Half, count: int = 13) -> Margin:
    """Frets of a guitar's neck below its head."""
    below = 0.62 * half[2] - points[:, 2]
    return all_of(planks(points, half, count, wide=0.007), below, in_front(points))


def staves(points: Points, half: Half, count: int = 14, wide: float = 0.01) -> Margin:
    """Joints between the staves of a barrel, straight across its lids."""
    x, y, _ = points.unbind(1)
    turn = torch.atan2(x, -y) * (count / math.tau)
    flat = torch.hypot(x, y)
    around = (turn - turn.round()).abs() * (math.tau / count) * flat
    across = planks(points, half, count // 2, 0, wide)
    return torch.where(flat < LID * half[0], across, wide - around)


def boarding(points: Points, half: Half, pitch: float = 0.1, wide: float = 0.008) -> Margin:
    """Upright joints between the boards of four walls."""
    x, y, _ = points.unbind(1)
    along = torch.where(x.abs() * half[1] > y.abs() * half[0], y, x) / pitch
    return wide - (along - along.floor() - 0.5).abs() * pitch


def bark_lines(points: Points, half: Half, count: int = 11, wide: float = 0.013) -> Margin:
    """Furrows along a log along x, in strokes."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(z, y) * (count / math.tau) + 0.12 * (x * 5).sin()
    row = turn.round()
    off = (turn - row).abs() * (math.tau / count) * torch.hypot(y, z)
    phase = x / 0.42 + 0.37 * row
    long = (0.34 - (phase - phase.round()).abs()) * 0.42
    return all_of(wide - off, long, 0.94 * half[0] - x.abs())


def black_keys(points: Points, half: Half, octaves: int = 2) -> Margin:
    """Black keys of a piano with its front at -y, and the gaps between the white ones."""
    pitch = 2 * half[0] / (7 * octaves)
    at = (points[:, 0] + half[0]) / pitch
    nearest = at.round()
    away = (at - nearest).abs() * pitch
    place = nearest.remainder(7)
    key = all_of(0.3 * pitch - away, points[:, 1] + 0.2 * half[1])
    return any_of(torch.where((place != 0) & (place != 3), key, -1.0), 0.005 - away)
