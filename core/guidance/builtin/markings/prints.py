"""Markings of what is printed, woven, painted: rugs, papers, rulers, boxes, pictures."""

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
    in_front,
    strokes,
)
from core.guidance.builtin.markings.shapes import shape_margin
from core.guidance.builtin.markings.stencils import lettering

INCHES = 12  # of a ruler
GLYPHS = ("sun", "leaf", "ring", "moon", "diamond", "crown", "arrow")  # of an obelisk, from below
LINES = [0.6 - 0.27 * k for k in range(6)]  # of a clipboard, in halves of the paper's height
# Of a violin's right sound hole, in halves of the body: from its upper end to its lower one.
F_HOLE = ((0.36, 0.04), (0.36, 0.1), (0.41, 0.14), (0.46, 0.09), (0.5, -0.1), (0.54, -0.27))
F_HOLE += ((0.59, -0.32), (0.65, -0.3), (0.66, -0.24))


def stamp(
    points: Points, half: Half, shape: str, size: float, at: tuple[float, float] = (0.0, 0.0)
) -> Margin:
    """A shape on the front: its ``size`` in halves of the width, its middle in halves."""
    x, z = points[:, 0] - at[0] * half[0], points[:, 2] - at[1] * half[2]
    size = size * float(half[0])
    return all_of(shape_margin(torch.stack([x, z], 1) / size, shape) * size, in_front(points))


def badge(points: Points, half: Half, radius: float, shape: str) -> Margin:
    """A disc on the front with a shape left out of it; ``radius`` in halves of the width."""
    whole = stamp(points, half, "circle", radius / 0.9)
    return all_of(whole, -stamp(points, half, shape, 0.72 * radius))


def kit_on_sides(points: Points, half: Half) -> Margin:
    """An ambulance's cross on both sides, and a stripe about it."""
    y, z = points[:, 1] - 0.38 * half[1], points[:, 2] - 0.14 * half[2]
    size = 0.58 * half[2]
    cross = shape_margin(torch.stack([y, z], 1) / size, "cross") * size
    stripe = 0.1 * half[2] - (points[:, 2] + 0.56 * half[2]).abs()
    return any_of(all_of(cross, points[:, 0].abs() - 0.6 * half[0]), stripe)


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


def popcorn_stripes(points: Points, half: Half, clear: float, narrow: float = 0.65) -> Margin:
    """Upright ones on a box that is as ``narrow`` below, not within ``clear`` of the middle of its
    front, in halves of the width."""
    across, wide = _on_four(points, half, narrow)
    phase = (across / wide + 1) * 2.25 - 0.75
    stripe = (0.25 - (phase - phase.round()).abs()) * wide / 2.25
    near = all_of(clear * half[0] - points[:, [0, 2]].norm(dim=1), in_front(points))
    return all_of(stripe, -near)


def _on_four(points: Points, half: Half, narrow: float, top: float = 1.0) -> tuple[Tensor, Tensor]:
    """Of what has four upright sides: how far from the middle of the nearest, and half its width,
    in halves of the width ``narrow`` below and ``top`` above."""
    x, y, z = points.unbind(1)
    share = ((z / half[2] + 1) / 2).clamp(0, 1)
    side = torch.where(x.abs() > y.abs(), x.sign() * y, -y.sign() * x)
    return side, (narrow + (top - narrow) * share) * half[0]


def glyphs(points: Points, half: Half) -> Margin:
    """Signs one above the other on the four sides of an obelisk."""
    across, wide = _on_four(points, half, 1.0, 0.66)
    pitch = 1.5 * float(half[2]) / len(GLYPHS)
    size = 0.4 * pitch
    margins = []
    for k, shape in enumerate(GLYPHS):
        up = points[:, 2] - (k - (len(GLYPHS) - 1) / 2) * pitch
        margins.append(shape_margin(torch.stack([across, up], 1) / size, shape) * size)
    return all_of(any_of(*margins), 0.9 * wide - across.abs())


def ruled(
    points: Points,
    half: Half,
    lines: Sequence[float] = LINES,
    ends: tuple[float, float] = (-0.42, 0.8),
) -> Margin:
    """The lines of a list, every other one shorter; where they are, and from where to where they
    go, in halves of the paper."""
    x, z = points[:, 0] / half[0], points[:, 2] / half[2]
    begin, margins = ends[0], []
    for k, at in enumerate(lines):
        end = ends[1] - 0.22 * (k % 2)
        wide = (end - begin) / 2 - (x - (end + begin) / 2).abs()
        margins.append(all_of(wide * half[0], 0.022 * half[2] - (z - at).abs() * half[2]))
    return all_of(any_of(*margins), in_front(points))


def ticked(points: Points, half: Half, done: int = 4) -> Margin:
    """The squares before them, ``done`` with a tick."""
    size = 0.1 * float(half[0])
    margins = []
    for k, at in enumerate(LINES):
        place = torch.stack([points[:, 0] + 0.64 * half[0], points[:, 2] - at * half[2]], 1) / size
        margins.append(0.13 - (place.abs().amax(1) - 0.9).abs())
        if k < done:
            margins.append(shape_margin(place / 1.15, "check mark") * 1.15)
    return all_of(any_of(*margins) * size, in_front(points))


def inches(points: Points, half: Half) -> Margin:
    """A ruler's, by quarters along its upper edge, with their numbers."""
    pitch = 2 * (half[0] - 0.03) / INCHES
    quarter = points[:, 0] / pitch * 4
    nearest = quarter.round().clamp(-2 * INCHES, 2 * INCHES)
    long = torch.where(
        nearest.remainder(4) == 0, 0.62, torch.where(nearest.remainder(2) == 0, 0.44, 0.28)
    )
    tick = all_of(
        0.006 - (quarter - nearest).abs() * pitch / 4, points[:, 2] - half[2] * (1 - long)
    )
    size = 0.5 * half[2]
    numbers = []
    for k in range(1, INCHES):
        x, z = points[:, 0] - (k - INCHES / 2) * pitch, points[:, 2] + 0.3 * half[2]
        numbers.append(lettering(torch.stack([x, z], 1) / size, str(k)) * size)
    return any_of(tick, all_of(any_of(*numbers), in_front(points)))


def rose(points: Points, half: Half, radius: float) -> Margin:
    """A compass's: the letters of the four winds, and strokes between them along its rim."""
    x, z, r = points[:, 0], points[:, 2], radius * half[0]
    part = torch.atan2(x, z) * (12 / math.pi)
    nearest, away = part.round(), points[:, [0, 2]].norm(dim=1)
    across = away * ((part - nearest) * (math.pi / 12)).sin().abs()
    wide = torch.where(nearest.remainder(3) == 0, 0.034, 0.018) * r
    wide = torch.where(nearest.remainder(6) == 0, -r, wide)  # a letter is there
    stroke = all_of(wide - across, away - 0.8 * r, 0.96 * r - away)
    letters, size = [], 0.24 * r
    for k, letter in enumerate("NESW"):
        u, v = 0.8 * r * math.sin(k * math.pi / 2), 0.8 * r * math.cos(k * math.pi / 2)
        place = torch.stack([x - u, z - v], 1) / size
        letters.append((lettering(place, letter) + 0.03) * size)
    return all_of(any_of(stroke, *letters), in_front(points))


def solar_cells(points: Points, half: Half, columns: int = 6, rows: int = 4) -> Margin:
    """Of a panel that leans back: squares without their corners, in rows."""
    slope = torch.stack([half[1], half[2]])
    along, long = (points[:, 1:] @ slope) / slope.norm(), slope.norm()
    upper = points[:, 2] * half[1] - points[:, 1] * half[2]
    margins = []
    for at, reach, count in ((points[:, 0], half[0], columns), (along, long, rows)):
        pitch = 2 * 0.97 * reach / count
        place = at / pitch + count / 2
        margins.append((0.5 - (place - place.floor() - 0.5).abs()) * pitch)
    corner = (margins[0] + margins[1] - 0.042) / math.sqrt(2)
    return all_of(margins[0] - 0.007, margins[1] - 0.007, corner, upper / slope.norm())


def oblong(points: Points, half: Half, at: float, size: tuple[float, float]) -> Margin:
    """A level one through the thing, its middle's height and its half sides in halves."""
    x, z = points[:, 0].abs(), (points[:, 2] - at * half[2]).abs()
    return all_of(size[0] * half[0] - x, size[1] * half[2] - z)


def reels(points: Points, half: Half) -> Margin:
    """A cassette's two, with three teeth each."""
    size = 0.15 * half[0]
    place = torch.stack([points[:, 0].abs() - 0.38 * half[0], points[:, 2] - 0.1 * half[2]], 1)
    place = place / size
    away, angle = place.norm(dim=1), torch.atan2(place[:, 1], place[:, 0])
    turn = angle * (6 / math.tau)
    tooth = 0.13 - (turn - turn.round()).abs() * (math.tau / 6) * away
    hub = torch.minimum(1 - away, away - 0.66)
    return any_of(hub, all_of(tooth, away - 0.42, 1 - away)) * size


def hills(points: Points, half: Half) -> Margin:
    """A painting's, from its lower edge to a line of peaks and slopes."""
    x = points[:, 0] / half[0]
    high = -0.2 + 0.26 * (3.4 * x + 2.3).cos() + 0.13 * (6.1 * x - 0.4).sin()
    return (0.85 * (high * half[2] - points[:, 2])).clamp(-1, 1)


def sun(points: Points, half: Half) -> Margin:
    """A painting's, at the upper right."""
    size = 0.22 * torch.minimum(half[0], half[2])
    at = torch.stack([points[:, 0] - 0.5 * half[0], points[:, 2] - 0.55 * half[2]], 1)
    return size - at.norm(dim=1)


def f_holes(points: Points, half: Half) -> Margin:
    """A violin's two."""
    scale = points.new_tensor([half[0], half[2]])
    at = torch.stack([points[:, 0].abs(), points[:, 2]], 1)
    curve = points.new_tensor(F_HOLE) * scale
    ends = torch.cdist(at, curve[[0, -1]]).amin(1)
    return all_of(any_of(strokes(at, curve, 0.021), 0.036 - ends), in_front(points))


def scale_marks(points: Points, half: Half) -> Margin:
    """A flask's: level strokes on its front, every other one longer."""
    margins = []
    for k, at in enumerate((-0.86, -0.68, -0.5, -0.32)):
        long, up = (0.36, 0.24)[k % 2] * half[0], (points[:, 2] - at * half[2]).abs()
        margins.append(all_of(long - points[:, 0].abs(), 0.014 - up))
    return all_of(any_of(*margins), in_front(points))


def scattered(
    points: Points,
    half: Half,
    shape: str,
    places: Sequence[tuple[float, float, float]],
    steep: float = 1.0,
) -> Margin:
    """Shapes about an upright axis: of each the turn from the front in degrees, the height in
    halves and the size in halves of the width; ``steep``: the surface's way over its rise."""
    x, y, z = points.unbind(1)
    turn, flat = torch.atan2(x, -y), torch.hypot(x, y)
    margins = []
    for angle, up, size in places:
        from_it = (turn - math.radians(angle) + math.pi).remainder(math.tau) - math.pi
        at = torch.stack([from_it * flat, (z - up * half[2]) * steep], 1)
        size = size * float(half[0])
        margins.append(shape_margin(at / size, shape) * size)
    return any_of(*margins)


def net_gaps(points: Points, half: Half, count: int = 13, string: float = 0.3) -> Margin:
    """Between the strings of a net that is seen from the front, ``count`` of them from side to
    side, each so wide a share of the pitch."""
    pitch = 2 * half[0] / count
    at = points[:, [0, 2]] / pitch
    away = (at - at.floor() - 0.5).abs().amax(1)
    return (0.5 - string / 2 - away) * pitch


def slots(points: Points, half: Half, count: int = 7, wide: float = 0.45) -> Margin:
    """Level ones in a round plate that is seen from the front."""
    x, z = points[:, 0] / half[0], points[:, 2] / half[2]
    row = z * (count + 2) / 2
    slot = (wide / 2 - (row - row.round()).abs()) * (2 * half[2] / (count + 2))
    inside = (0.82 - torch.hypot(x, row.round() * 2 / (count + 2))) * half[0]
    return all_of(slot, inside, in_front(points))


def icons(points: Points, half: Half, columns: int = 4) -> Margin:
    """Of a phone: rows of squares on the upper part of its front, and one below."""
    x, z = points[:, 0], points[:, 2]
    pitch = 1.76 * half[0] / columns
    at = torch.stack([x / pitch + columns / 2, (0.84 * half[2] - z) / pitch], 1)
    below = torch.stack([at[:, 0], (-0.7 * half[2] - z) / pitch], 1)
    rows = max(int(1.15 * float(half[2]) / float(pitch)), 1)
    both = []
    for place, count in ((at, rows), (below, 1)):
        cell = place.floor()
        square = 0.32 - (place - cell - 0.5).abs().amax(1)
        there = (cell >= 0).all(1) & (cell[:, 0] < columns) & (cell[:, 1] < count)
        both.append(torch.where(there, square, -0.18).mul(pitch))
    return all_of(any_of(*both), in_front(points))
