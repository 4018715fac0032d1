"""Studs, nails, beads and buttons."""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
)


def studs(
    points: Points,
    half: Half,
    count: int,
    size: float,
    at: float = 0.0,
    axis: int = 2,
    out: float = 0.0,
) -> Margin:
    """Round heads in a ring around an axis.

    Args:
        size: their radius, training units.
        at: their place along the axis in halves.
        out: how far from the axis they begin, in halves.
    """
    one, other = (k for k in range(3) if k != axis)
    u, v = points[:, one] / half[one], points[:, other] / half[other]
    turn = torch.atan2(u, -v) * (count / math.tau)
    across = (turn - turn.round()) * (math.tau / count) * points[:, [one, other]].norm(dim=1)
    head = size - torch.hypot(across, points[:, axis] - at * half[axis])
    return all_of(head, (torch.hypot(u, v) - out) * half[one])


def nailed(
    points: Points, half: Half, corners: Sequence[Pair], count: int, size: float, deep: float = 0.0
) -> Margin:
    """Round heads, ``count`` along each side of a polygon on the front in halves; the radius in
    halves of the width."""
    ends = points.new_tensor(corners) * half[[0, 2]]
    fraction = (torch.arange(count).to(points) / count)[:, None, None]
    heads = (ends + fraction * (ends.roll(-1, 0) - ends)).reshape(-1, 2)
    away = torch.cdist(points[:, [0, 2]], heads).amin(1)
    return all_of(size * half[0] - away, -points[:, 1] - deep * half[1])


def picket_nails(
    points: Points, half: Half, heights: Pair, pitch: float = 0.086, size: float = 0.015
) -> Margin:
    """Two nails next to each other at each rail's height, given the box of a picket; the gap
    between pickets is a multiple of ``pitch``."""
    x = points[:, 0] / pitch - 0.5
    aside = (x - x.round()) * pitch
    away = (torch.hypot(aside, points[:, 2] - at * half[2]) for at in heights)
    return all_of(any_of(*(size - one for one in away)), in_front(points))


def beads(
    points: Points, half: Half, radius: float, size: float, count: int, axis: int = 1
) -> Margin:
    """A ring of dots on both faces of a round part across an axis; radius and size in halves of
    the width."""
    x, z = points[:, [side for side in range(3) if side != axis]].unbind(1)
    turn = torch.atan2(x, z) * (count / math.tau)
    angle = (turn - turn.round()) * (math.tau / count)
    away = torch.hypot(x, z)
    off = torch.hypot(away * angle.sin(), away * angle.cos() - radius * half[0])
    return size * half[0] - off


def dots(
    points: Points, half: Half, places: Sequence[Pair], size: float, both: bool = False
) -> Margin:
    """Dots on a front, such as buttons: places in halves, the size in halves of the width;
    ``both``: also mirrored to the left."""
    x = points[:, 0].abs() if both else points[:, 0]
    middles = points.new_tensor(places) * half[[0, 2]]
    away = torch.cdist(torch.stack([x, points[:, 2]], 1), middles).amin(1)
    return all_of(size * half[0] - away, in_front(points))
