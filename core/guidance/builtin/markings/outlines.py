"""Markings given as lists of outlines on a thing's sides: rectangles, discs, lines, cells, emblems.

All places are in halves of the side, so that they fit any proportions; an outline with ``gap`` is
cut out of those before it.
"""

from collections.abc import Sequence
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    strokes,
    within,
)
from core.guidance.builtin.markings.shapes import shape_margin
from core.guidance.builtin.markings.stencils import lettering

At = Float[Tensor, "p 2"]
Sides = Float[Tensor, " 2"]


class Plate(NamedTuple):
    """A rectangle, or its outline."""

    at: Pair  # its middle
    size: Pair  # its half sides
    soft: float = 0.0  # the radius of its corners, of its shorter half side
    line: float = 0.0  # half the outline's width, training units; 0: all of it
    twice: bool = False  # at the left and at the right
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Margins at places on a side of half size ``half``."""
        size = half.new_tensor(self.size) * half
        round_ = self.soft * size.min()
        away = _from(at, self.at, half, self.twice).abs() - size + round_
        inside = round_ - away.clamp_min(0).norm(dim=1) - away.amax(1).clamp_max(0)
        return self.line - inside.abs() if self.line else inside


class Disc(NamedTuple):
    """A disc, or its outline; its radius in halves of the side's shorter extent."""

    at: Pair
    radius: float
    line: float = 0.0
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Margins at places on a side of half size ``half``."""
        away = self.radius * half.min() - _from(at, self.at, half, self.twice).norm(dim=1)
        return self.line - away.abs() if self.line else away


class Line(NamedTuple):
    """A line from place to place, half its width in training units."""

    places: tuple[Pair, ...]
    wide: float = 0.012
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Margins at places on a side of half size ``half``."""
        at = _from(at, (0.0, 0.0), half, self.twice)
        return strokes(at, half.new_tensor(self.places) * half, self.wide)


class Cells(NamedTuple):
    """Rectangles in rows and columns within one, each ``fraction`` of its room."""

    at: Pair
    size: Pair
    count: tuple[int, int]
    fraction: Pair = (0.6, 0.6)
    soft: float = 0.0
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Margins at places on a side of half size ``half``."""
        place = _from(at, self.at, half, self.twice)
        count = half.new_tensor(self.count)
        pitch = 2 * half.new_tensor(self.size) * half / count
        cell = torch.minimum((place / pitch + count / 2).floor().clamp_min(0), count - 1)
        middle = (cell + 0.5 - count / 2) * pitch
        size = half.new_tensor(self.fraction) * pitch / 2
        round_ = self.soft * size.min()
        away = (place - middle).abs() - size + round_
        return round_ - away.clamp_min(0).norm(dim=1) - away.amax(1).clamp_max(0)


class Emblem(NamedTuple):
    """A shape by name, or letters; half its height in halves of the side's shorter extent."""

    at: Pair
    size: float
    shape: str = ""
    text: str = ""
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Margins at places on a side of half size ``half``."""
        size = self.size * half.min()
        place = _from(at, self.at, half, self.twice) / size
        if self.shape:
            return shape_margin(place, self.shape) * size
        return (lettering(place / 2, self.text) + 0.04) * 2 * size


class Poly(NamedTuple):
    """A polygon by its corners."""

    corners: tuple[Pair, ...]
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Margins at places on a side of half size ``half``."""
        at = _from(at, (0.0, 0.0), half, self.twice)
        return within(at, half.new_tensor(self.corners) * half)


Outline = Plate | Disc | Line | Cells | Emblem | Poly


def _from(at: At, middle: Pair, half: Sides, twice: bool) -> At:
    """Places from a middle given in halves."""
    if twice:
        at = torch.stack([at[:, 0].abs(), at[:, 1]], 1)
    return at - half.new_tensor(middle) * half


def laid(
    points: Points,
    half: Half,
    front: Sequence[Outline] = (),
    back: Sequence[Outline] = (),
    sides: Sequence[Outline] = (),
    top: Sequence[Outline] = (),
    deep: float = 0.55,
    until: float = 9.0,
    aside: float | None = None,
) -> Margin:
    """Outlines on a box's sides.

    Each side is seen from outside; on the left and the right side the front is to the left.

    Args:
        deep: how far from the middle all outlines begin, in halves.
        until: how far from the middle they end, in halves.
        aside: ``deep`` for those on the sides.
    """
    x, y, z = points.unbind(1)
    each = (
        (front, (x, z), (0, 2), -y, half[1]),
        (back, (-x, z), (0, 2), y, half[1]),
        (sides, (y, z), (1, 2), x.abs(), half[0]),
        (top, (x, y), (0, 1), z, half[2]),
    )
    margins = []
    for outlines, place, axes, out, reach in each:
        if outlines:
            margin = _painted(torch.stack(place, 1), half[list(axes)], outlines)
            low = aside if outlines is sides and aside is not None else deep
            margins.append(all_of(margin, out - low * reach, until * reach - out))
    return any_of(*margins)


def _painted(at: At, half: Sides, outlines: Sequence[Outline]) -> Margin:
    """The union of outlines in order, without the gaps."""
    margin = torch.full_like(at[:, 0], -1.0)
    for outline in outlines:
        own = outline.margin(at, half)
        margin = torch.minimum(margin, -own) if outline.gap else torch.maximum(margin, own)
    return margin


NUMBER = "F3D"  # on number plates


def number_plate(up: float, wide: float = 0.27, high: float = 0.13) -> tuple[Outline, ...]:
    """A number plate without its number."""
    letters = Emblem((0, up), high * 0.62, text=NUMBER, gap=True)
    return Plate((0, up), (wide, high), 0.3), letters


def on_all_sides(*outlines: Outline) -> dict[str, tuple[Outline, ...]]:
    """The same outlines on all four walls."""
    return dict.fromkeys(("front", "back", "sides"), outlines)


def hazard(at: Pair, size: Pair, count: int) -> tuple[Outline, ...]:
    """A band without every other one of its slanted stripes."""
    (x, y), (u, v), step = at, size, 2 * size[0] / count
    gaps = (
        Poly(
            ((a, y - v), (a + step / 2, y - v), (a + step, y + v), (a + step / 2, y + v)), gap=True
        )
        for a in (x - u + k * step for k in range(count))
    )
    return (Plate(at, size), *gaps)


def slanted_bars(at: Pair, size: Pair, count: int) -> tuple[Outline, ...]:
    """Slanted bars in a row."""
    (x, y), (u, v), step = at, size, 2 * size[0] / count
    starts = (x - u + (k + 0.1) * step for k in range(count))
    return tuple(
        Poly(((a, y - v), (a + 0.45 * step, y - v), (a + 0.9 * step, y + v),
              (a + 0.45 * step, y + v)))
        for a in starts
    )  # fmt: skip


def sprite(rows: Sequence[str], at: Pair, pixel: Pair) -> tuple[Outline, ...]:
    """A picture of squares, one rectangle for each run in a row; ``pixel``: a square's half
    sides."""
    found = []
    for k, row in enumerate(rows):
        up = at[1] + (len(rows) - 1 - 2 * k) * pixel[1]
        begin = 0
        while (begin := row.find("X", begin)) >= 0:
            end = len(row[begin:]) - len(row[begin:].lstrip("X"))
            aside = at[0] + (2 * begin + end - len(row)) * pixel[0]
            found.append(Plate((aside, up), (end * pixel[0] * 1.02, pixel[1] * 1.02)))
            begin += end
    return tuple(found)
