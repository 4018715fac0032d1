"""Markings of creatures: what is about their eyes, feathers, scales, the bones of wings."""

import math
from collections.abc import Sequence

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    blobs,
    strokes,
)

Pair = tuple[float, float]
Way = tuple[float, float, float]
Curve = tuple[Pair, ...]
ALONG, UP, FRONT = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0, 2)
SIDE = (1, 2)


def _way(points: Points, way: Way) -> Tensor:
    """As long as one."""
    found = points.new_tensor(way)
    return found / found.norm()


def _one(points: Points, half: Half) -> tuple[Points, Half]:
    """Of two eyes that are one piece, so that the box is wide, places from the right one's middle,
    and half of that."""
    aside = half[0] - half[2]
    if aside < 0.7 * half[2]:
        return points, half
    return points - torch.stack([aside, 0 * aside, 0 * aside]), half[[2, 1, 2]]


def on_eye(points: Points, half: Half, spots: Sequence[tuple[Way, Pair]]) -> Margin:
    """Ovals on an eyeball: which way each looks from its middle, and its half width and height in
    the eyeball's radii."""
    points, half = _one(points, half)
    at = points / half
    at = at / at.norm(dim=1, keepdim=True).clamp_min(1e-6)
    found = []
    for way, (wide, high) in spots:
        out = _way(points, way)
        right = torch.linalg.cross(out, out.new_tensor(UP))
        right = right / right.norm().clamp_min(1e-6)
        up = torch.linalg.cross(right, out)
        across, along = at @ right, at @ up
        off = torch.hypot(across / wide, along / high)
        steep = torch.hypot(across / wide**2, along / high**2)
        inside = (1 - off) * (off + 1e-4) / (steep + 1e-4 / min(wide, high))
        found.append(torch.minimum(inside, at @ out))
    return any_of(*found) * half.mean()


def glints(points: Points, half: Half, way: Way = (0.3, -0.75, 0.6), large: float = 0.3) -> Margin:
    """The light in an eye: a large one and a small one, opposite."""
    small = (way[0] + 0.35, way[1], way[2] - 0.85)
    return on_eye(points, half, ((way, (large, large)), (small, (large / 2, large / 2))))


def by_eyes(
    points: Points,
    half: Half,
    curves: Sequence[Curve],
    wide: float,
    axes: tuple[int, int] = FRONT,
    until: float = 99.0,
) -> Margin:
    """Lines on a face, seen from the front or with ``SIDE`` from the side: mouths and brows; all in
    radii of an eye, from its middle, and no farther back than ``until``."""
    points, half = _one(points, half)
    size = half.mean()
    at = points[:, list(axes)] / size
    lines = any_of(*(strokes(at, at.new_tensor(curve), wide) for curve in curves))
    return all_of(lines * size, until * size - points[:, 1])


def about_eyes(points: Points, half: Half, middles: Sequence[Way], sizes: Way) -> Margin:
    """What is in ellipsoids, as nostrils, cheeks and the insides of ears; in radii of an eye, from
    its middle."""
    points, half = _one(points, half)
    size, sides = half.mean(), points.new_tensor(sizes)
    found = []
    for middle in middles:
        off = (points / size - points.new_tensor(middle)) / sides
        found.append((1 - off.norm(dim=1)) * sides.min())
    return any_of(*found) * size


def bars(
    points: Points,
    half: Half,
    way: Way = UP,
    pitch: float = 0.1,
    wide: float = 0.011,
    span: Pair = (-9.0, 9.0),
) -> Margin:
    """Lines across a way, as between plates of a belly, from where to where in halves of that."""
    out = _way(points, way)
    along, reach = points @ out, (half.to(out) * out).norm()
    away = along / pitch
    lines = wide - (away - away.floor() - 0.5).abs() * pitch
    return all_of(lines, along - span[0] * reach, span[1] * reach - along)


def scallops(along: Tensor, across: Tensor, pitch: float, line: float) -> Margin:
    """The edges of scales in rows, that bulge the way they lie."""
    row, side = along / pitch * 2, across / pitch
    own = row.floor()
    shifted = side - 0.5 * own.remainder(2)
    away = torch.hypot((row - own) / 2, shifted - shifted.round())
    return line - (away - 0.5).abs() * pitch


def plumage(
    points: Points,
    half: Half,
    way: Way = (0.0, 1.0, -0.35),
    short: Pair = (-0.62, 0.08),
    line: float = 0.013,
    count: int = 3,
    rows: int = 2,
) -> Margin:
    """Of a wing at a side, its tip to ``way``: rows of short feathers from where to where, in
    halves, and long ones beyond; ``count`` of each side by side."""
    out = _way(points, way)
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


def drawn(
    points: Points,
    half: Half,
    curves: Sequence[Curve],
    wide: float = 0.016,
    axes: tuple[int, int] = FRONT,
) -> Margin:
    """Lines on both faces of what is flat, as a wing's bones or quills; in halves."""
    at, sides = points[:, list(axes)], half[list(axes)]
    return any_of(*(strokes(at, at.new_tensor(curve) * sides, wide) for curve in curves))


def curls(points: Points, half: Half, pitch: float = 0.24, line: float = 0.013) -> Margin:
    """Locks of wool: spirals in rows, as seen from the side."""
    along, up = points[:, 1] / pitch, points[:, 2] / pitch
    row = up.round()
    along = along - 0.5 * row.remainder(2)
    off = torch.stack([along - along.round(), up - row], 1) * pitch
    away, turn = off.norm(dim=1), torch.atan2(off[:, 1], off[:, 0]) / math.tau
    step = 0.19 * pitch
    phase = away / step + turn
    lines = line - (phase - phase.round()).abs() * step
    return all_of(lines, 0.42 * pitch - away, points[:, 0].abs() - 0.3 * half[0])


def dapples(points: Points, half: Half, pitch: float = 0.115) -> Margin:
    """A fawn's: spots along its back and flanks."""
    spots = blobs(points, half, pitch, (0.02, 0.03), 0.9)
    return all_of(spots, points[:, 2] + 0.1 * half[2], points[:, 1] + 0.35 * half[1])


def stripes(
    points: Points, half: Half, pitch: float = 0.16, share: float = 0.3, fall: float = 0.45
) -> Margin:
    """Across a back that falls to the tail, behind the neck, every other one shorter."""
    along = points[:, 1] / pitch
    above = points[:, 2] / half[2] + fall * points[:, 1] / half[1]
    every = along.round().remainder(2)
    wide = share * pitch * ((above + 0.3) / 0.6 - 0.4 * every).clamp(0, 1).sqrt()
    found = torch.where(wide > 0, wide - (along - along.round()).abs() * pitch, -0.02)
    return all_of(found, points[:, 1] + 0.12 * half[1])


def coils(points: Points, half: Half, count: int = 12, share: float = 0.16) -> Margin:
    """A coiled snake's: slanted bands about the rings, none on the neck within."""
    away = points[:, :2].norm(dim=1)
    turn = torch.atan2(points[:, 0], points[:, 1]) / math.tau * count - 4 * points[:, 2]
    step = math.tau / count * away
    bands = (share - (turn - turn.round()).abs()) * step / (1 + (4 * step).square()).sqrt()
    return all_of(bands, away - 0.42 * half[0])


def tail_scales(points: Points, half: Half, count: int = 12, line: float = 0.01) -> Margin:
    """A mermaid's, in rows about her tail, that hang down."""
    around = torch.atan2(points[:, 0], -points[:, 1]) / math.tau * count
    pitch = math.tau * float(half[0]) / count
    return scallops(-points[:, 2], around * pitch, pitch, line)


def whorl(points: Points, _half: Half, pitch: float = 0.16, line: float = 0.016) -> Margin:
    """A snail shell's, on both sides."""
    away = points[:, 1:].norm(dim=1)
    turn = torch.atan2(points[:, 2], points[:, 1]) / math.tau
    phase = away / pitch - turn
    return line - (phase - phase.round()).abs() * pitch


def twist(points: Points, _half: Half, way: Way, pitch: float = 0.1, line: float = 0.014) -> Margin:
    """A thread about a horn that points to ``way``."""
    out = _way(points, way)
    right = torch.linalg.cross(out, out.new_tensor((1.0, 0.0, 0.0)))
    right = right / right.norm()
    turn = torch.atan2(points[:, 0], points @ right) / math.tau
    phase = points @ out / pitch + turn
    return line - (phase - phase.round()).abs() * pitch


def chest(points: Points, half: Half, pitch: float = 0.17, line: float = 0.014) -> Margin:
    """An owl's: rows of marks that point down, every other row shifted."""
    up = points[:, 2] / pitch * 1.4
    row = up.floor()
    side = points[:, 0] / pitch - 0.5 * row.remainder(2)
    side = (side - side.round()).abs()
    at = torch.stack([side, up - row], 1) * pitch
    mark = at.new_tensor([(0.0, 0.3), (0.26, 0.62)]) * pitch
    return all_of(strokes(at, mark, line), -points[:, 1], 0.5 * half[2] - points[:, 2])


def hide(points: Points, half: Half, pitch: float = 0.12, line: float = 0.01) -> Margin:
    """A crocodile's, seen from above: rows of plates along its back."""
    along, side = points[:, 1] / pitch, points[:, 0] / pitch
    lines = torch.minimum((along - along.round()).abs(), (side - side.floor() - 0.5).abs()) * pitch
    return all_of(line - lines, points[:, 1] + 0.1 * half[1], points[:, 2] - 0.1 * half[2])


def throat(points: Points, half: Half, count: int = 9, line: float = 0.013) -> Margin:
    """A whale's: grooves along it, about its lower side, as far back as its middle."""
    turn = torch.atan2(points[:, 0], -points[:, 2] + 0.3 * half[2])
    step = math.pi / count
    away = (turn / step - (turn / step).round()).abs() * step
    reach = points[:, [0, 2]].norm(dim=1)
    return all_of(line - away * reach, 0.3 * half[1] - points[:, 1])


def spider_mark(points: Points, half: Half) -> Margin:
    """An hourglass on its back."""
    along, side = points[:, 1] - 0.5 * half[1], points[:, 0].abs()
    wide = 0.03 + 0.5 * along.abs()
    return all_of((wide - side) * 0.85, 0.17 - along.abs(), points[:, 2])
