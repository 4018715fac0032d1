"""Rectangles, polygons, frames and borders."""

from collections.abc import Sequence
from typing import Any

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
    within,
)
from core.guidance.builtin.markings.outlines import laid

ARCH = 0.86  # of a tombstone's half width, how far from the middle its border is


def bar(points: Points, half: Half, size: tuple[float, float]) -> Margin:
    """A level bar across the middle of the front, in halves of the width."""
    x, z = points[:, 0].abs(), points[:, 2].abs()
    return all_of(size[0] * half[0] - x, size[1] * half[0] - z, in_front(points))


def oblong(points: Points, half: Half, at: float, size: tuple[float, float]) -> Margin:
    """A level rectangle through a part: the height of its middle and its half sides in halves."""
    x, z = points[:, 0].abs(), (points[:, 2] - at * half[2]).abs()
    return all_of(size[0] * half[0] - x, size[1] * half[2] - z)


def polygon(points: Points, half: Half, corners: Sequence[Pair]) -> Margin:
    """A polygon through a part, seen from the front, in halves."""
    return within(points[:, [0, 2]], points.new_tensor(corners) * half[[0, 2]])


def frame(points: Points, half: Half, at: float, size: tuple[float, float], wide: float) -> Margin:
    """The outline of a rectangle on the front: the height of its middle, its half sides and half
    the line's width in halves of the height."""
    x, z = points[:, 0].abs() / half[2], (points[:, 2] / half[2] - at).abs()
    away = torch.maximum(x - size[0], z - size[1]).abs()
    return all_of((wide - away) * half[2], in_front(points))


def car_doors(points: Points, half: Half) -> Margin:
    """The doors of a car on both sides, below the windows."""
    x, y, z = points.unbind(1)
    wide = 0.42 * half[1] - (y - 0.08 * half[1]).abs()
    return all_of(wide, 0.12 * half[2] - z, x.abs() - 0.6 * half[0])


def repeated(points: Points, half: Half, axes: Sequence[int], room: float, **sides: Any) -> Margin:
    """Outlines on each of several equal boxes in rows along ``axes``, given the box of one.

    Args:
        room: half of the gap between two boxes, training units.
        sides: as of :func:`outlines.laid`.
    """
    return laid(nearest(points, half, axes, room), half, **sides)


def nearest(points: Points, half: Half, axes: Sequence[int], room: float) -> Points:
    """Places from the middle of the nearest of several equal boxes in rows along ``axes``."""
    moved = points.clone()
    for axis in axes:
        pitch = 2 * (half[axis] + room)
        moved[:, axis] = points[:, axis] - (points[:, axis] / pitch).round() * pitch
    return moved


def arch(points: Points, half: Half, wide: float = 0.016) -> Margin:
    """The outline of a slab with a round top, on its front."""
    x, z, size = points[:, 0], points[:, 2], ARCH * half[0]
    up = z - (half[2] - half[0])
    away = torch.where(up > 0, torch.hypot(x, up), x.abs()) - size
    low = -0.68 * half[2] - z
    line = wide - torch.maximum(away, low).abs()
    return all_of(line, -points[:, 1] - 0.5 * half[1])


def _edge(points: Points, half: Half) -> tuple[Tensor, float]:
    """For a rug: distances from its nearest edge, and the width of its border."""
    return (half[:2] - points[:, :2].abs()).amin(1), 0.27 * float(half[1])


def rug_field(points: Points, half: Half) -> Margin:
    """The field inside a rug's border."""
    edge, wide = _edge(points, half)
    return edge - wide


def _lozenge(points: Points, half: Half, fraction: float) -> Margin:
    """A lozenge in the middle of a rug's field, ``fraction`` as large."""
    _, wide = _edge(points, half)
    inner = half[:2] - wide
    away = (points[:, :2].abs() / inner).sum(1)
    return (fraction - away) / float((1 / inner).norm())


def rug_lozenge(points: Points, half: Half) -> Margin:
    """The lozenge in the middle of a rug with a line around it, the corners of its field, and a
    line along the border."""
    edge, wide = _edge(points, half)
    line = 0.012 - (_lozenge(points, half, 0.86)).abs()
    corner = all_of(-_lozenge(points, half, 1.42), edge - 1.12 * wide)
    along = 0.07 * wide - (edge - 0.5 * wide).abs()
    return any_of(_lozenge(points, half, 0.74), line, corner, along)


def rug_middle(points: Points, half: Half) -> Margin:
    """The innermost part of a rug, and a lozenge in each corner of its field."""
    edge, wide = _edge(points, half)
    corner = all_of(-_lozenge(points, half, 1.66), edge - 1.3 * wide)
    ring = 0.01 - _lozenge(points, half, 0.56).abs()
    return any_of(_lozenge(points, half, 0.36), ring, corner)
