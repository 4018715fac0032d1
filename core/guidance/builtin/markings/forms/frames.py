"""Rectangles, polygons, frames and borders."""

from collections.abc import Sequence

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    in_front,
    within,
)
from core.guidance.builtin.markings.outlines import Pair, Plate, laid

ARCH = 0.86  # of a tombstone's half width, how far from the middle its border is


def bar(points: Points, half: Half, size: tuple[float, float]) -> Margin:
    """A level one across the middle of the front, in halves of the width."""
    x, z = points[:, 0].abs(), points[:, 2].abs()
    return all_of(size[0] * half[0] - x, size[1] * half[0] - z, in_front(points))


def oblong(points: Points, half: Half, at: float, size: tuple[float, float]) -> Margin:
    """A level one through the thing, its middle's height and its half sides in halves."""
    x, z = points[:, 0].abs(), (points[:, 2] - at * half[2]).abs()
    return all_of(size[0] * half[0] - x, size[1] * half[2] - z)


def polygon(points: Points, half: Half, corners: Sequence[Pair]) -> Margin:
    """A polygon seen from the front, on both sides alike, in halves."""
    return within(points[:, [0, 2]], points.new_tensor(corners) * half[[0, 2]])


def frame(points: Points, half: Half, at: float, size: tuple[float, float], wide: float) -> Margin:
    """The outline of a rectangle on the front: its middle's height, its half sides and half the
    line's width, all in halves of the board's height."""
    x, z = points[:, 0].abs() / half[2], (points[:, 2] / half[2] - at).abs()
    away = torch.maximum(x - size[0], z - size[1]).abs()
    return all_of((wide - away) * half[2], in_front(points))


def car_doors(points: Points, half: Half) -> Margin:
    """A car's, on both sides, below the windows."""
    x, y, z = points.unbind(1)
    wide = 0.42 * half[1] - (y - 0.08 * half[1]).abs()
    return all_of(wide, 0.12 * half[2] - z, x.abs() - 0.6 * half[0])


def door_trim(points: Points, half: Half, room: float = 0.067) -> Margin:
    """A frame on each of a door's panels one above another, by one panel's box; ``room``: half of
    what is between two."""
    pitch = 2 * (half[2] + room)
    x, y, z = points.unbind(1)
    moved = torch.stack([x, y, z - (z / pitch).round() * pitch], 1)
    frame = Plate((0, 0), (0.74, 0.72), 0.08, 0.018)
    return laid(moved, half, front=(frame,), back=(frame,), deep=0.0)


def each_drawer(points: Points, half: Half, room: float = 0.045) -> Margin:
    """A frame on each of the drawers in rows and columns, by one drawer's box; ``room``: half of
    what is between two."""
    pitch = 2 * (half[[0, 2]] + room)
    at = points[:, [0, 2]]
    at = at - (at / pitch).round() * pitch
    moved = torch.stack([at[:, 0], points[:, 1], at[:, 1]], 1)
    frame = Plate((0, 0), (0.84, 0.72), 0.15, 0.014)
    return laid(moved, half, front=(frame,), deep=0.0)


def door_panels(points: Points, half: Half, room: float = 0.05, wide: float = 0.018) -> Margin:
    """A frame on each of the doors side by side, by one door's box; ``room``: half of what is
    between two."""
    pitch = 2 * (half[0] + room)
    x = points[:, 0] - (points[:, 0] / pitch).round() * pitch
    moved = torch.cat([x[:, None], points[:, 1:]], 1)
    frame = Plate((0, 0), (0.66, 0.76), 0.12, wide)
    return laid(moved, half, front=(frame,), deep=0.2)


def arch(points: Points, half: Half, wide: float = 0.016) -> Margin:
    """The outline of a slab that is round above, on its front."""
    x, z, size = points[:, 0], points[:, 2], ARCH * half[0]
    up = z - (half[2] - half[0])
    away = torch.where(up > 0, torch.hypot(x, up), x.abs()) - size
    low = -0.68 * half[2] - z
    line = wide - torch.maximum(away, low).abs()
    return all_of(line, -points[:, 1] - 0.5 * half[1])


def _edge(points: Points, half: Half) -> tuple[Tensor, float]:
    """Of a rug that lies: how far from its nearest edge, and how wide its border is."""
    return (half[:2] - points[:, :2].abs()).amin(1), 0.27 * float(half[1])


def rug_field(points: Points, half: Half) -> Margin:
    """What is within a rug's border."""
    edge, wide = _edge(points, half)
    return edge - wide


def _lozenge(points: Points, half: Half, share: float) -> Margin:
    """In the middle of a rug's field, as large a ``share`` of it."""
    _, wide = _edge(points, half)
    inner = half[:2] - wide
    away = (points[:, :2].abs() / inner).sum(1)
    return (share - away) / float((1 / inner).norm())


def rug_lozenge(points: Points, half: Half) -> Margin:
    """The one in the middle with a line about it, the field's corners, and a line along the
    border."""
    edge, wide = _edge(points, half)
    line = 0.012 - (_lozenge(points, half, 0.86)).abs()
    corner = all_of(-_lozenge(points, half, 1.42), edge - 1.12 * wide)
    along = 0.07 * wide - (edge - 0.5 * wide).abs()
    return any_of(_lozenge(points, half, 0.74), line, corner, along)


def rug_middle(points: Points, half: Half) -> Margin:
    """The inmost of a rug, and a lozenge in each corner of its field."""
    edge, wide = _edge(points, half)
    corner = all_of(-_lozenge(points, half, 1.66), edge - 1.3 * wide)
    ring = 0.01 - _lozenge(points, half, 0.56).abs()
    return any_of(_lozenge(points, half, 0.36), ring, corner)
