"""Scales, plumage, wool and hide."""

import math

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    Way,
    all_of,
    any_of,
    strokes,
    unit,
)


def scallops(along: Tensor, across: Tensor, pitch: float, line: float) -> Margin:
    """Edges of scales in rows, which bulge along ``along``."""
    row, side = along / pitch * 2, across / pitch
    own = row.floor()
    shifted = side - 0.5 * own.remainder(2)
    away = torch.hypot((row - own) / 2, shifted - shifted.round())
    return line - (away - 0.5).abs() * pitch


def fish_scales(points: Points, half: Half, pitch: float = 0.26, line: float = 0.011) -> Margin:
    """Scales of a fish with its head at -y: rows of arcs that bulge to the tail, and the edge of
    its gills."""
    _, y, z = points.unbind(1)
    arcs = scallops(y, z, pitch, line)
    behind = y + 0.22 * half[1]
    from_it = torch.hypot(y + 0.8 * half[1], 0.8 * z)
    gills = all_of(1.5 * line - (from_it - 0.44 * half[1]).abs(), y + 0.75 * half[1])
    return any_of(all_of(arcs, behind), gills)


def tail_scales(points: Points, half: Half, count: int = 12, line: float = 0.01) -> Margin:
    """Scales of a mermaid's tail in rows, which hang down."""
    around = torch.atan2(points[:, 0], -points[:, 1]) / math.tau * count
    pitch = math.tau * float(half[0]) / count
    return scallops(-points[:, 2], around * pitch, pitch, line)


def plumage(
    points: Points,
    half: Half,
    way: Way = (0.0, 1.0, -0.35),
    short: Pair = (-0.62, 0.08),
    line: float = 0.013,
    count: int = 3,
    rows: int = 2,
) -> Margin:
    """Feathers of a wing at a side with its tip to ``way``: rows of short ones over the span
    ``short`` in halves, and long ones beyond it; ``count`` in a row."""
    out = unit(points, way)
    up = torch.linalg.cross(out.new_tensor((1.0, 0.0, 0.0)), out)
    reach, high = (half.to(out) * out).norm(), (half.to(out) * up).norm()
    along, across = points @ out, points @ up
    low, until = short[0] * reach, short[1] * reach
    gap = 2 * high / count
    deep = (until - low) / rows
    row = ((along - low) / deep).floor()
    side = across / gap + 0.5 * row
    side = (side - side.round()).abs()
    # An arc from one feather's edge to the other, as deep as the row.
    bulge = (1 - 4 * side.square()).clamp_min(0).sqrt() * 0.8 + 0.2
    arcs = line - ((along - low) / deep - row - bulge).abs() * deep * 0.7
    arcs = all_of(arcs, along - low, until - along + 0.5 * line)
    quills = across / gap + 0.5 * rows + 0.5
    quills = line - (quills - quills.round()).abs() * gap
    return any_of(arcs, all_of(quills, along - until + 0.3 * deep))


def chest_marks(points: Points, half: Half, pitch: float = 0.17, line: float = 0.014) -> Margin:
    """Marks on an owl's chest in rows, which point down, every other row shifted."""
    up = points[:, 2] / pitch * 1.4
    row = up.floor()
    side = points[:, 0] / pitch - 0.5 * row.remainder(2)
    side = (side - side.round()).abs()
    at = torch.stack([side, up - row], 1) * pitch
    mark = at.new_tensor([(0.0, 0.3), (0.26, 0.62)]) * pitch
    return all_of(strokes(at, mark, line), -points[:, 1], 0.5 * half[2] - points[:, 2])


def curls(points: Points, half: Half, pitch: float = 0.24, line: float = 0.013) -> Margin:
    """Locks of wool, seen from the side: spirals in rows."""
    along, up = points[:, 1] / pitch, points[:, 2] / pitch
    row = up.round()
    along = along - 0.5 * row.remainder(2)
    off = torch.stack([along - along.round(), up - row], 1) * pitch
    away, turn = off.norm(dim=1), torch.atan2(off[:, 1], off[:, 0]) / math.tau
    step = 0.19 * pitch
    phase = away / step + turn
    lines = line - (phase - phase.round()).abs() * step
    return all_of(lines, 0.42 * pitch - away, points[:, 0].abs() - 0.3 * half[0])


def hide(points: Points, half: Half, pitch: float = 0.12, line: float = 0.01) -> Margin:
    """Rows of plates along a crocodile's back, seen from above."""
    along, side = points[:, 1] / pitch, points[:, 0] / pitch
    lines = torch.minimum((along - along.round()).abs(), (side - side.floor() - 0.5).abs()) * pitch
    return all_of(line - lines, points[:, 1] + 0.1 * half[1], points[:, 2] - 0.1 * half[2])


def twist(points: Points, _half: Half, way: Way, pitch: float = 0.1, line: float = 0.014) -> Margin:
    """A thread around a horn that points to ``way``."""
    out = unit(points, way)
    right = torch.linalg.cross(out, out.new_tensor((1.0, 0.0, 0.0)))
    right = right / right.norm()
    turn = torch.atan2(points[:, 0], points @ right) / math.tau
    phase = points @ out / pitch + turn
    return line - (phase - phase.round()).abs() * pitch
