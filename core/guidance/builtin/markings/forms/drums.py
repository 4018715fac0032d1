"""Rims, stripes and drips of drums and other upright cylinders, and what is on round plates."""

import math
from collections.abc import Sequence

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of

DRIPS = ((-2.7, 0.5, 0.2), (-1.9, 0.24, 0.16), (-1.1, 0.66, 0.2), (-0.3, 0.3, 0.17),
         (0.4, 0.56, 0.22), (1.2, 0.2, 0.15), (1.8, 0.72, 0.19), (2.6, 0.36, 0.18))  # fmt: skip


def _around(points: Points) -> tuple[Tensor, Tensor]:
    """The turn from the front, and how far from the axis."""
    x, y, _ = points.unbind(1)
    return torch.atan2(x, -y), torch.hypot(x, y)


def rims(points: Points, half: Half, wide: float = 0.05, within: float = 0.9) -> Margin:
    """The rims of both ends, on the lids as far in as ``within``; in halves."""
    _, away = _around(points)
    up = points[:, 2].abs()
    lid = any_of(away - within * half[0], 0.985 * half[2] - up)
    return all_of(up - (1 - wide) * half[2], lid)


def slanted_belt(points: Points, half: Half, at: float, wide: float, count: int) -> Margin:
    """Slanted stripes all round, between two heights; its middle and half its width in halves."""
    turn, away = _around(points)
    up = points[:, 2] - at * half[2]
    pitch = math.tau / count
    phase = turn / pitch + up / (pitch * half[0])
    stripe = (0.25 - (phase - phase.round()).abs()) * pitch * half[0] * 0.71
    return all_of(stripe, wide * half[2] - up.abs(), away - 0.8 * half[0])


def drips(points: Points, half: Half, lid: float = 0.86, low: float = 0.9) -> Margin:
    """Liquid that has run over: a pool on the lid and ``DRIPS`` down the wall."""
    turn, away = _around(points)
    up = points[:, 2] - low * half[2]
    margins = [up]
    for angle, long, wide in DRIPS:
        off = ((turn - angle + math.pi).remainder(math.tau) - math.pi) * half[0]
        end = (-up - long * half[2]).clamp_min(0)
        margins.append(all_of(wide * half[0] * 0.5 - torch.hypot(off, end), away - 0.7 * half[0]))
    pool = any_of(lid * half[0] - away, 0.98 * half[2] - points[:, 2])
    return all_of(any_of(*margins), pool)


def ribs(points: Points, half: Half, count: int, low: float = -2.0, high: float = 0.6) -> Margin:
    """Upright ribs around a wall, between two heights in halves."""
    turn, away = _around(points)
    pitch = math.tau / count
    phase = turn / pitch
    rib = (0.25 - (phase - phase.round()).abs()) * pitch * half[0]
    up = points[:, 2]
    return all_of(rib, away - 0.85 * half[0], high * half[2] - up, up - low * half[2])


def knurls(points: Points, half: Half, count: int, wide: float = 0.012) -> Margin:
    """Lines that cross one another about a wall."""
    turn, away = _around(points)
    pitch = math.tau / count
    margins = []
    for sign in (1, -1):
        phase = turn / pitch + sign * points[:, 2] / (pitch * half[0])
        margins.append(wide - (phase - phase.round()).abs() * pitch * half[0] * 0.71)
    return all_of(any_of(*margins), away - 0.92 * half[0], 0.7 * half[2] - points[:, 2].abs())


def top_squares(points: Points, half: Half, pitch: float, size: float, within: float) -> Margin:
    """Squares in a lattice, as far out as ``within``, seen from above; in halves."""
    _, away = _around(points)
    at = points[:, :2] / (pitch * half[0])
    inside = (size / 2 - (at - at.round()).abs().amax(1)) * pitch * half[0]
    return all_of(inside, within * half[0] - away, points[:, 2])


def wedges(points: Points, half: Half, at: Sequence[float], wide: float, low: float) -> Margin:
    """Rays of light on both faces of a disc that looks to the front: where each is, half its width
    (degrees), and from which radius on, in halves."""
    x, z = points[:, 0], points[:, 2]
    turn, away = torch.atan2(x, z), torch.hypot(x, z)
    margins = []
    for angle in at:
        off = (turn - math.radians(angle) + math.pi).remainder(math.tau) - math.pi
        margins.append((math.radians(wide) - off.abs()).clamp(-1.5, 1.5).sin() * away)
    return all_of(any_of(*margins), away - low * half[0], 0.95 * half[0] - away)
