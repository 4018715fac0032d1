"""Markings of what is built: door seams, grilles, plates, panels, screens, buttons.

They are given as lists of outlines on a thing's sides, all places in halves of the side, so that
they go with any proportions; one that is a gap is left out of what stands before it.
"""

from collections.abc import Sequence
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
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
Pair = tuple[float, float]


class Plate(NamedTuple):
    """A rectangle, or its outline."""

    at: Pair  # its middle
    size: Pair  # its half sides
    soft: float = 0.0  # the radius of its corners, of its shorter half side
    line: float = 0.0  # half the outline's width, training units; 0: all of it
    twice: bool = False  # at the left and at the right
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Of places on the side, which is so large."""
        size = half.new_tensor(self.size) * half
        round_ = self.soft * size.min()
        away = _from(at, self.at, half, self.twice).abs() - size + round_
        inside = round_ - away.clamp_min(0).norm(dim=1) - away.amax(1).clamp_max(0)
        return self.line - inside.abs() if self.line else inside


class Disc(NamedTuple):
    """A disc, or its outline; its radius in halves of the side's shorter way."""

    at: Pair
    radius: float
    line: float = 0.0
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Of places on the side, which is so large."""
        away = self.radius * half.min() - _from(at, self.at, half, self.twice).norm(dim=1)
        return self.line - away.abs() if self.line else away


class Line(NamedTuple):
    """From place to place, half its width in training units."""

    places: tuple[Pair, ...]
    wide: float = 0.012
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Of places on the side, which is so large."""
        at = _from(at, (0.0, 0.0), half, self.twice)
        return strokes(at, half.new_tensor(self.places) * half, self.wide)


class Cells(NamedTuple):
    """Rectangles in rows and columns within one, each so large a share of its room."""

    at: Pair
    size: Pair
    count: tuple[int, int]
    share: Pair = (0.6, 0.6)
    soft: float = 0.0
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Of places on the side, which is so large."""
        place = _from(at, self.at, half, self.twice)
        count = half.new_tensor(self.count)
        pitch = 2 * half.new_tensor(self.size) * half / count
        cell = torch.minimum((place / pitch + count / 2).floor().clamp_min(0), count - 1)
        middle = (cell + 0.5 - count / 2) * pitch
        size = half.new_tensor(self.share) * pitch / 2
        round_ = self.soft * size.min()
        away = (place - middle).abs() - size + round_
        return round_ - away.clamp_min(0).norm(dim=1) - away.amax(1).clamp_max(0)


class Emblem(NamedTuple):
    """A shape by name, or letters; half its height in halves of the side's shorter way."""

    at: Pair
    size: float
    shape: str = ""
    text: str = ""
    twice: bool = False
    gap: bool = False

    def margin(self, at: At, half: Sides) -> Margin:
        """Of places on the side, which is so large."""
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
        """Of places on the side, which is so large."""
        at = _from(at, (0.0, 0.0), half, self.twice)
        return within(at, half.new_tensor(self.corners) * half)


Outline = Plate | Disc | Line | Cells | Emblem | Poly


def _from(at: At, middle: Pair, half: Sides, twice: bool) -> At:
    """Places from a middle that is given in halves."""
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
    """Outlines on a box's sides, as each is looked at but that on the left and the right side the
    front is to the left; all are from ``deep`` to ``until`` halves from the middle,
    those on the sides from ``aside``."""
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
    """One after the other."""
    margin = torch.full_like(at[:, 0], -1.0)
    for outline in outlines:
        own = outline.margin(at, half)
        margin = torch.minimum(margin, -own) if outline.gap else torch.maximum(margin, own)
    return margin


def glare(points: Points, half: Half, at: float = -0.35) -> Margin:
    """Two slanted bands of light on a screen, a broad one and a narrow one, the middle of both so
    far aside in halves of its width."""
    wide = torch.minimum(half[0], half[2])
    along = (points[:, 0] - at * half[0] - 0.55 * points[:, 2]) / 1.141
    bands = any_of(0.17 * wide - along.abs(), 0.055 * wide - (along - 0.32 * wide).abs())
    return all_of(bands, 0.86 * half[2] - points[:, 2].abs(), 0.9 * half[0] - points[:, 0].abs())


def cone_rings(points: Points, half: Half, spans: Sequence[Pair], out: float = 0.35) -> Margin:
    """Of a loudspeaker's cones, by its box: between radii in those of the cones."""
    x, y, z = points.unbind(1)
    margins = []
    for radius, up in ((0.7, half[0] - half[2]), (0.43, half[2] - 0.763 * half[0])):
        away, size = torch.hypot(x, z - up), radius * half[0]
        margins += [all_of(high * size - away, away - low * size) for low, high in spans]
    return all_of(any_of(*margins), -y - out * half[1])


def links(points: Points, half: Half, count: int = 17) -> Margin:
    """Of a tank's tracks, along their upper and lower edges."""
    pitch = 2 * half[1] / count
    at = points[:, 1] / pitch
    gap = 0.3 * pitch - (at - at.round()).abs() * pitch
    return all_of(gap, points[:, 2].abs() - 0.52 * half[2])


def wave(points: Points, half: Half, high: float = 0.2, wide: float = 0.2) -> Margin:
    """A band about a can that rises and falls twice; its rise and half its width in halves."""
    x, y, z = points.unbind(1)
    rise = high * half[2]
    away = z - rise * (2 * torch.atan2(x, -y)).sin()
    return (wide * half[2] - away.abs()) / torch.hypot(2 * rise / half[0], half.new_tensor(1.0))


def door_panels(points: Points, half: Half, room: float = 0.05, wide: float = 0.018) -> Margin:
    """A frame on each of the doors side by side, by one door's box; ``room``: half of what is
    between two."""
    pitch = 2 * (half[0] + room)
    x = points[:, 0] - (points[:, 0] / pitch).round() * pitch
    moved = torch.cat([x[:, None], points[:, 1:]], 1)
    frame = Plate((0, 0), (0.66, 0.76), 0.12, wide)
    return laid(moved, half, front=(frame,), deep=0.2)


NUMBER = "F3D"  # on number plates


def _plate(up: float, wide: float = 0.27, high: float = 0.13) -> tuple[Outline, ...]:
    """A number plate, its number left out."""
    letters = Emblem((0, up), high * 0.62, text=NUMBER, gap=True)
    return Plate((0, up), (wide, high), 0.3), letters


def windows(
    points: Points,
    half: Half,
    front: Sequence[Outline],
    sides: Sequence[Outline] = (),
    back: Sequence[Outline] = (),
    ends: Pair = (0.1, 0.1),
    until: float = 9.0,
) -> Margin:
    """A vehicle's panes; how far from the middle those of both ends begin, in halves."""
    margins = [laid(points, half, front=front, deep=ends[0])]
    if sides:
        margins.append(laid(points, half, sides=sides, deep=0.55))
    if back:
        margins.append(laid(points, half, back=back, deep=ends[1], until=until))
    return any_of(*margins)


def hoops(points: Points, _half: Half, pitch: float, wide: float = 0.014) -> Margin:
    """Level lines all around, one above another."""
    at = points[:, 2] / pitch
    return wide - (at - at.round()).abs() * pitch


CAR_WINDOWS = {
    "front": (Plate((0, 0.5), (0.63, 0.33), 0.2),),
    "back": (Plate((0, 0.52), (0.6, 0.3), 0.2),),
    "sides": (
        Poly(((-0.18, 0.2), (0.03, 0.82), (0.19, 0.82), (0.19, 0.2))),
        Poly(((0.26, 0.2), (0.26, 0.82), (0.44, 0.82), (0.62, 0.2))),
    ),
}
CAR_PLATES = {"front": _plate(-0.8), "back": _plate(-0.34)}
_BUMPER = Plate((0, -0.84), (1.2, 0.16))
_CAR_FRONT = (
    Plate((0, -0.44), (0.42, 0.15), 0.5),
    Cells((0, -0.44), (0.36, 0.1), (5, 1), (0.22, 2), gap=True),
    _BUMPER,
)
_CAR_BACK = (
    Plate((0.7, -0.2), (0.24, 0.17), 0.4, twice=True),
    Plate((0, -0.34), (0.3, 0.17), 0.3),
    _BUMPER,
)
_CAR_SIDES = (
    Plate((-1, -0.84), (0.1, 0.16)),
    Plate((1, -0.84), (0.1, 0.16)),
    Plate((0, -0.94), (0.34, 0.06)),
    Plate((-0.03, -0.4), (0.27, 0.43), 0.3, 0.011),
    Plate((0.13, -0.1), (0.06, 0.045), 0.9),
)
CAR_TRIM = {"front": _CAR_FRONT, "back": _CAR_BACK, "sides": _CAR_SIDES, "aside": 0.9}
CAR_TAIL = {"back": (Plate((0.7, -0.2), (0.19, 0.12), 0.4, twice=True),)}
_CHECKS = tuple(
    Cells((0.045 * row, -0.28 - 0.09 * row), (1.035, 0.045), (23, 1), (0.5, 1.0)) for row in (0, 1)
)
TAXI_TRIM = CAR_TRIM | {
    "sides": (*_CHECKS, *_CAR_SIDES),
    "back": (
        Plate((0.7, -0.2), (0.2, 0.13), 0.4, 0.014, twice=True),
        *_plate(-0.34, 0.3, 0.15),
        _BUMPER,
    ),
}
VAN_WINDOWS = {
    "front": (Plate((0, 0.47), (0.84, 0.35), 0.2),),
    "sides": (
        Poly(((-0.61, 0.12), (-0.47, 0.78), (-0.15, 0.78), (-0.15, 0.12))),
        Plate((0.17, 0.45), (0.24, 0.33), 0.15),
    ),
    "back": (Plate((0.45, 0.45), (0.34, 0.33), 0.2, twice=True),),
    "ends": (0.35, 0.8),
}
_VAN_FRONT = (
    Plate((0, -0.37), (0.42, 0.13), 0.3),
    Cells((0, -0.37), (0.38, 0.11), (1, 3), (2, 0.25), gap=True),
    Plate((0, -0.67), (0.33, 0.16), 0.3),
    Plate((0, -0.88), (1.2, 0.12)),
)
_VAN_BACK = (
    Line(((0, 0.9), (0, -0.76)), 0.011),
    Plate((0.1, -0.08), (0.035, 0.09), 0.5, twice=True),
    Plate((0, -0.45), (0.34, 0.15), 0.3),
    Plate((0.86, -0.28), (0.1, 0.3), 0.4, twice=True),
    Plate((0, -0.88), (1.2, 0.12)),
)
_VAN_SIDES = (
    Plate((-1, -0.88), (0.12, 0.12)),
    Plate((1, -0.88), (0.12, 0.12)),
    Plate((0, -0.95), (0.4, 0.05)),
    Poly(((-0.66, 0.02), (-0.52, 0.88), (-0.1, 0.88), (-0.1, -0.84), (-0.38, -0.84), (-0.42, -0.5),
          (-0.54, -0.34), (-0.66, -0.32))),
    Poly(((-0.64, 0.02), (-0.508, 0.84), (-0.12, 0.84), (-0.12, -0.8), (-0.36, -0.8),
          (-0.4, -0.48), (-0.53, -0.3), (-0.64, -0.28)), gap=True),
    Plate((-0.17, -0.06), (0.045, 0.035), 0.9),
)  # fmt: skip
_SLIDING = (
    Plate((0.17, 0.02), (0.28, 0.84), 0.1, 0.011),
    Plate((-0.04, -0.06), (0.045, 0.035), 0.9),
    Line(((0.46, -0.06), (0.94, -0.06)), 0.01),
)
VAN_TRIM = {"front": _VAN_FRONT, "back": _VAN_BACK, "sides": (*_VAN_SIDES, *_SLIDING)}
VAN_TAIL = {"back": (Plate((0.86, -0.28), (0.07, 0.25), 0.4, twice=True),)}
VAN_PLATES = {"front": _plate(-0.67, 0.28, 0.115), "back": _plate(-0.45, 0.27, 0.11)}
AMBULANCE_WINDOWS = VAN_WINDOWS | {"sides": VAN_WINDOWS["sides"][:1]}
AMBULANCE_TRIM = {  # it has no number plates
    "front": (*_VAN_FRONT[:2], *_VAN_FRONT[3:]),
    "back": (*_VAN_BACK[:2], *_VAN_BACK[3:]),
    "sides": _VAN_SIDES,
}
_BUS_SIDES = (
    Cells((-0.52, 0.32), (0.42, 0.36), (3, 1), (0.86, 1), 0.15),
    Cells((0.58, 0.32), (0.37, 0.36), (3, 1), (0.86, 1), 0.15),
)
_BUS_DOOR = Cells((0.05, -0.08), (0.12, 0.76), (2, 1), (0.7, 0.94), 0.3)
BUS_WINDOWS = {
    "front": (
        Plate((0, 0.26), (0.84, 0.42), 0.15),
        Line(((0, 0.8), (0, -0.3)), 0.012, gap=True),
    ),
    "sides": (*_BUS_SIDES, _BUS_DOOR),
    "back": (Plate((0, 0.34), (0.62, 0.34), 0.2),),
    "ends": (0.8, 0.8),
}
_BUS_BACK = (
    Plate((0.72, -0.52), (0.16, 0.16), 0.4, twice=True),
    Cells((0, -0.3), (0.5, 0.16), (1, 4), (1, 0.45)),
    Plate((0, -0.9), (1.2, 0.1)),
)
BUS_TRIM = {
    "front": (
        Plate((0, 0.81), (0.6, 0.1), 0.5),
        Emblem((0, 0.81), 0.075, text="CITY", gap=True),
        Cells((0, -0.55), (0.34, 0.14), (1, 3), (1, 0.5)),
        Plate((0, -0.9), (1.2, 0.1)),
    ),
    "back": _BUS_BACK,
    "sides": (
        Plate((0.05, -0.08), (0.135, 0.8), 0.1),
        Plate((-1, -0.9), (0.16, 0.1)),
        Plate((1, -0.9), (0.16, 0.1)),
    ),
}
BUS_TAIL = {"back": (Plate((0.72, -0.52), (0.12, 0.11), 0.4, twice=True),)}
_DECKS = (
    Cells((-0.12, -0.18), (0.8, 0.22), (4, 1), (0.88, 1), 0.15),
    Cells((0, 0.58), (0.92, 0.22), (5, 1), (0.88, 1), 0.15),
)
_DECK_ENDS = (Plate((0, -0.18), (0.78, 0.22), 0.2), Plate((0, 0.58), (0.78, 0.22), 0.2))
DOUBLE_DECKER_WINDOWS = {
    "front": (*_DECK_ENDS, Line(((0, 0.8), (0, 0.3)), 0.012, gap=True)),
    "sides": (*_DECKS, Cells((0.84, -0.4), (0.1, 0.44), (2, 1), (0.7, 0.94), 0.3)),
    "back": (_DECK_ENDS[1],),
    "ends": (0.8, 0.8),
}
DOUBLE_DECKER_TRIM = {
    "front": (
        Plate((0, 0.19), (0.62, 0.1), 0.3),
        Emblem((0, 0.19), 0.095, text="CITY", gap=True),
        Plate((0, -0.93), (1.2, 0.07)),
    ),
    "sides": (Plate((0.84, -0.4), (0.115, 0.47), 0.1),),
    "back": (
        Plate((0.74, -0.6), (0.14, 0.12), 0.4, twice=True),
        Cells((0, -0.42), (0.5, 0.14), (1, 4), (1, 0.45)),
        Plate((0, -0.93), (1.2, 0.07)),
    ),
}
DOUBLE_DECKER_TAIL = {
    "back": (Plate((0.74, -0.6), (0.105, 0.085), 0.4, twice=True),),
    "deep": 0.3,
}
SCHOOL_BUS_TRIM = {
    "front": BUS_TRIM["front"][2:],
    "back": _BUS_BACK,
    "sides": BUS_TRIM["sides"][1:],
}
SCHOOL_BUS_WINDOWS = BUS_WINDOWS | {
    "sides": (Cells((0, 0.32), (0.94, 0.3), (7, 1), (0.84, 1), 0.15),)
}
TRUCK_WINDOWS = {
    "front": (Plate((0, 0.36), (0.8, 0.36), 0.2),),
    "sides": (Plate((0, 0.36), (0.64, 0.36), 0.2),),
    "ends": (0.6, 0.6),
}
TRUCK_TRIM = {
    "front": (
        Plate((0, -0.45), (0.5, 0.3), 0.2),
        Cells((0, -0.45), (0.44, 0.25), (1, 4), (2, 0.25), gap=True),
        Plate((0, -0.93), (1.2, 0.1)),
    ),
    "sides": (
        Plate((0, 0.02), (0.76, 0.84), 0.12, 0.011),
        Plate((0.5, -0.16), (0.16, 0.045), 0.9),
    ),
}
TRUCK_LAMPS = {"front": (Plate((0.74, -0.45), (0.14, 0.17), 0.5, twice=True),)}
CARGO_SEAMS = {
    "front": (),
    "sides": (Cells((0, 0), (0.94, 0.86), (9, 1), (0.18, 1), 0.9),),
    "back": (
        Plate((0, 0), (0.9, 0.9), 0.08, 0.012),
        Line(((0, 0.9), (0, -0.9)), 0.012),
        Line(((0.22, 0.86), (0.22, -0.86)), 0.012, twice=True),
        Plate((0.3, -0.2), (0.12, 0.05), 0.5, twice=True),
        *(Plate((0.84, at), (0.1, 0.04), twice=True) for at in (-0.62, 0.0, 0.62)),
    ),
    "deep": 0.9,
}
FIRE_WINDOWS = {
    "front": (
        Plate((0, 0.06), (0.84, 0.34), 0.15),
        Line(((0, 0.5), (0, -0.4)), 0.012, gap=True),
    ),
    "sides": (Plate((-0.71, 0.06), (0.17, 0.32), 0.2),),
    "ends": (0.8, 0.8),
}
_SHUTTERS = Cells((0.33, -0.02), (0.6, 0.4), (3, 1), (0.86, 1))
FIRE_LOCKERS = {
    "sides": (_SHUTTERS, Cells((0.33, -0.02), (0.6, 0.4), (1, 6), (2, 0.22), gap=True)),
    "back": (
        Plate((0, 0.0), (0.62, 0.36)),
        Cells((0, 0.0), (0.62, 0.36), (1, 5), (2, 0.22), gap=True),
    ),
}
FIRE_TRIM = {
    "front": (
        Plate((0, -0.36), (1.2, 0.045)),
        Cells((0, -0.62), (0.4, 0.16), (6, 1), (0.5, 1), 0.9),
        Plate((0, -0.93), (1.2, 0.1)),
    ),
    "sides": (
        Plate((0.33, -0.02), (0.62, 0.44), 0.06),
        Plate((-0.71, -0.02), (0.21, 0.56), 0.1, 0.011),
        Plate((-0.57, -0.36), (0.05, 0.035), 0.9),
    ),
    "back": (Plate((0, 0.0), (0.66, 0.4), 0.05), Plate((0, -0.93), (1.2, 0.1))),
}
SPORTS_WINDOWS = {
    "front": (Plate((0, 0.6), (0.62, 0.26), 0.2),),
    "sides": (Poly(((-0.14, 0.3), (0.04, 0.82), (0.33, 0.82), (0.44, 0.3))),),
    "back": (Plate((0, 0.6), (0.56, 0.26), 0.2),),
    "ends": (-0.1, 0.3),
}
SPORTS_TRIM = {
    "front": (Plate((0, -0.62), (0.5, 0.12), 0.3),),
    "sides": (
        Plate((0.02, -0.39), (0.27, 0.45), 0.2, 0.011),
        Plate((0.2, -0.04), (0.06, 0.05), 0.9),
        Poly(((0.14, -0.62), (0.31, -0.1), (0.31, -0.55), (0.26, -0.62))),
        Plate((0, -0.94), (0.32, 0.06)),
    ),
    "back": (
        Plate((0, 0.1), (0.92, 0.13), 0.5),
        Plate((0, -0.66), (0.7, 0.2), 0.2),
        Cells((0, -0.66), (0.62, 0.2), (5, 1), (0.16, 2), gap=True),
    ),
    "top": (Plate((0.3, -0.5), (0.1, 0.06), 0.5, twice=True),),
    "deep": 0.0,
    "aside": 0.9,
}
SPORTS_TAIL = {"back": (Plate((0.62, 0.1), (0.24, 0.075), 0.8, twice=True),)}
PICKUP_WINDOWS = {
    "front": (Plate((0, 0.52), (0.66, 0.32), 0.2),),
    "sides": (Poly(((-0.26, 0.2), (-0.09, 0.82), (0.15, 0.82), (0.17, 0.2))),),
    "back": (Plate((0, 0.52), (0.62, 0.3), 0.2),),
    "ends": (0.06, 0.05),
    "until": 0.32,
}
PICKUP_SEAMS = {
    "front": (
        Plate((0, -0.3), (0.96, 0.2), 0.3),
        Cells((0, -0.3), (0.46, 0.15), (1, 3), (2, 0.3), gap=True),
    ),
    "sides": (
        Plate((-0.02, -0.4), (0.24, 0.48), 0.2, 0.011),
        Plate((0.14, -0.06), (0.06, 0.035), 0.9),
    ),
    "aside": 0.8,
    "back": (
        Plate((0, -0.32), (0.68, 0.32), 0.15, 0.012),
        Plate((0, -0.16), (0.16, 0.05), 0.8),
        Plate((0.85, -0.22), (0.12, 0.24), 0.3, twice=True),
    ),
}
PICKUP_TAIL = {"back": (Plate((0.85, -0.22), (0.085, 0.19), 0.3, twice=True),)}
MOUTH = {
    "front": (
        Plate((0, -0.48), (0.62, 0.26), 0.5),
        Cells((0, -0.48), (0.52, 0.16), (5, 1), (0.6, 1), 0.3, gap=True),
    ),
    "sides": (Disc((0, 0.05), 0.34, 0.03), Disc((0, 0.05), 0.14)),
}
ROBOT_BUTTONS = {
    "front": (
        Plate((0, 0.16), (0.66, 0.5), 0.25, 0.016),
        *(Disc((at, 0.4), 0.13) for at in (-0.4, 0.0, 0.4)),
        Cells((0, -0.06), (0.52, 0.16), (6, 1), (0.5, 1), 0.4),
    ),
    "back": (Cells((0, 0.1), (0.5, 0.3), (1, 4), (1, 0.35), 0.9),),
}
RACE_NUMBER = {
    "top": (Disc((0, -0.46), 0.32), Emblem((0, -0.46), 0.22, text="7", gap=True)),
    "deep": -0.2,
}
VISOR = {"front": (Plate((0, 0.12), (0.72, 0.3), 0.9),), "deep": 0.1}
TRAIN_WINDOWS = {
    "front": (Plate((0.45, 0.28), (0.2, 0.17), 0.4, twice=True),),
    "sides": (Plate((0, 0.18), (0.42, 0.25), 0.3),),
    "back": (Plate((0.3, 0.2), (0.22, 0.24), 0.3, twice=True),),
    "ends": (0.4, 0.4),
}
BOILER_BANDS = ((-0.94, -0.87), (-0.52, -0.46), (-0.1, -0.04), (0.3, 0.36), (0.66, 0.72))
TANK_STAR = {"sides": (Emblem((-0.3, 0.2), 0.5, "star"),), "deep": 0.3}
TANK_VENTS = {
    "back": (Cells((0, 0.2), (0.5, 0.3), (1, 3), (1, 0.45), 0.5),),
    "top": (Cells((0, 0.72), (0.56, 0.16), (7, 1), (0.45, 1), 0.5),),
    "deep": 0.4,
}
BOOK_BORDER = {
    "front": (Plate((0.06, 0), (0.86, 0.88), 0.1, 0.024), Plate((0.06, 0), (0.72, 0.78), 0.3, 0.01),
              *(Disc((0.06 + 0.72 * u, 0.78 * v), 0.13) for u in (-1, 1) for v in (-1, 1))),
    "back": (Plate((-0.06, 0), (0.86, 0.88), 0.1, 0.024),),
    "deep": 0.3,
}  # fmt: skip
BOOK_BADGE = {"front": (Disc((0.06, 0), 0.5, 0.02), Emblem((0.06, 0), 0.38, "star")), "deep": 0.3}
PHONE_CAMERA = {"back": (Plate((-0.5, 0.68), (0.38, 0.24), 0.5),), "deep": 0.3}
PHONE_LENSES = {
    "back": (
        Disc((-0.64, 0.79), 0.17),
        Disc((-0.64, 0.57), 0.17),
        Disc((-0.64, 0.79), 0.09, 0.01, gap=True),
        Disc((-0.64, 0.57), 0.09, 0.01, gap=True),
        Disc((-0.3, 0.68), 0.09),
    ),
    "deep": 0.3,
}
TV_SLOTS = {
    "front": (Cells((0.76, -0.55), (0.15, 0.24), (1, 5), (1, 0.45), 0.9),),
    "back": (
        Cells((0, 0.25), (0.6, 0.4), (1, 6), (1, 0.4), 0.9),
        Plate((0, -0.55), (0.4, 0.14), 0.3, 0.012),
    ),
}
LAPTOP_ICONS = {
    "front": (
        Plate((0.12, 0.1), (0.56, 0.56), 0.08),
        Cells((-0.3, 0.56), (0.1, 0.05), (3, 1), (0.6, 0.6), 0.9, gap=True),
        Plate((0.12, 0.46), (0.56, 0.02), gap=True),
        Cells((0.12, 0.0), (0.44, 0.36), (1, 4), (1, 0.4), 0.5, gap=True),
        Cells((-0.76, 0.1), (0.13, 0.6), (1, 4), (0.8, 0.55), 0.3),
        Plate((0, -0.82), (0.5, 0.06), 0.5),
    ),
    "deep": -9.0,
}
LAPTOP_BADGE = {"back": (Disc((0, 0.1), 0.2),), "deep": -0.2}
LENS_RINGS = ((-0.94, -0.84), (-0.52, -0.4))
CAMERA_SCREEN = {"back": (Plate((-0.14, 0), (0.56, 0.76), 0.15),
                          Cells((0.72, 0), (0.14, 0.6), (1, 3), (0.8, 0.6), 0.9))}  # fmt: skip
DIAL_MARKS = {
    "front": (
        Cells((0, 0.25), (0.84, 0.32), (11, 1), (0.28, 1)),
        Plate((0, -0.35), (0.86, 0.08)),
        Plate((0.25, -0.02), (0.05, 0.8)),
    ),
}
FRIDGE_NOTE = {
    "front": (
        Plate((0.55, 0.5), (0.25, 0.14)),
        Cells((0.55, 0.48), (0.18, 0.08), (1, 3), (1, 0.28), gap=True),
    ),
    "deep": 0.4,
}
FRIDGE_MAGNETS = {
    "front": (
        Disc((0.55, 0.63), 0.09),
        Emblem((0.34, 0.8), 0.13, "heart"),
        Emblem((-0.5, 0.78), 0.14, "star"),
    ),
    "deep": 0.4,
}
FRIDGE_COILS = {
    "back": (Cells((0, 0.2), (0.72, 0.6), (1, 10), (1, 0.3)), Plate((0, -0.76), (0.8, 0.16), 0.1)),
    "deep": 0.8,
}
WASHER_SEAMS = {
    "front": (
        Line(((-0.95, 0.6), (0.95, 0.6)), 0.012),
        Plate((0.62, -0.86), (0.22, 0.07), 0.3, 0.012),
    ),
    "back": (
        Plate((0, 0.05), (0.7, 0.68), 0.12, 0.014),
        Cells((0, 0.5), (0.4, 0.12), (7, 1), (0.4, 1), 0.9),
        Disc((0.4, -0.82), 0.09, twice=True),
    ),
    "deep": 0.5,
}
PANEL_LIGHTS = {
    "front": (
        Plate((-0.4, 0.0), (0.4, 0.5), 0.2),
        Cells((0.5, 0), (0.38, 0.4), (3, 1), (0.6, 1), 0.9),
    ),
    "deep": 0.3,
}
OVEN_SEAMS = {
    "front": (
        Plate((0, -0.28), (0.9, 0.42), 0.08, 0.013),
        Plate((0, -0.85), (0.9, 0.12), 0.2, 0.013),
        Plate((0, -0.81), (0.3, 0.03), 0.9),
    ),
    "back": (Cells((0, -0.5), (0.6, 0.16), (1, 3), (1, 0.4), 0.9),),
}
OVEN_RACKS = {
    "front": (
        Plate((0, 0), (0.84, 0.72), 0.2, 0.013),
        Cells((0, -0.05), (0.78, 0.5), (1, 2), (1, 0.13)),
    ),
    "deep": 0.3,
}
OVEN_COILS = {
    "top": tuple(
        Disc((0.48, at), r, 0.014, twice=True) for at in (-0.44, 0.4) for r in (0.1, 0.22)
    ),
    "deep": 0.3,
}
MICROWAVE_DISPLAY = {"front": (Plate((0.8, 0.55), (0.14, 0.16), 0.3),)}
MICROWAVE_DIGITS = {"front": (Emblem((0.8, 0.55), 0.06, text="12:00"),)}
MICROWAVE_BUTTONS = {
    "front": (Cells((0.8, -0.1), (0.15, 0.4), (3, 4), (0.7, 0.68), 0.4),
              Plate((0.8, -0.72), (0.14, 0.11), 0.4)),
}  # fmt: skip
MICROWAVE_SEAMS = {
    "front": (Line(((0.6, -1), (0.6, 1)), 0.012), Plate((-0.24, 0), (0.56, 0.64), 0.1, 0.011)),
    "back": (Cells((0, 0.2), (0.6, 0.4), (9, 1), (0.35, 1), 0.9),),
    "sides": (Cells((0.1, 0.3), (0.5, 0.3), (6, 1), (0.35, 1), 0.9),),
    "deep": 0.92,
}
MICROWAVE_MESH = {"front": (Plate((0, 0), (0.86, 0.78), 0.2, 0.013),), "deep": 0.3}
VENDING_STRIPES = {
    "sides": (
        Poly(((-1, -0.5), (1, -0.05), (1, 0.12), (-1, -0.33))),
        Poly(((-1, -0.68), (1, -0.23), (1, -0.15), (-1, -0.6))),
    ),
    "back": (
        Cells((0, -0.6), (0.6, 0.2), (1, 5), (1, 0.4), 0.9),
        Plate((0, 0.2), (0.7, 0.5), 0.1, 0.014),
    ),
    "deep": 0.9,
}
SAFE_RIVETS = {
    "front": tuple(
        Disc(at, 0.045, twice=True)
        for at in ((0.9, 0.9), (0.9, 0.3), (0.9, -0.3), (0.9, -0.9), (0.32, 0.9), (0.32, -0.9))
    ),
    "sides": (Plate((0, 0), (0.8, 0.8), 0.1, 0.016),),
    "back": (Plate((0, 0), (0.8, 0.8), 0.1, 0.016),),
    "deep": 0.2,
}
WARDROBE_PANELS = {
    "front": (
        Plate((0.52, 0.44), (0.28, 0.4), 0.15, 0.018, twice=True),
        Plate((0.52, -0.24), (0.28, 0.16), 0.15, 0.018, twice=True),
        Plate((0.52, -0.66), (0.28, 0.1), 0.15, 0.018, twice=True),
    ),
    "deep": 0.9,
}
_SHELVES = tuple(-1 + 2 * (0.054 + 0.315 * k) for k in range(3))
BOOK_BANDS = tuple((at + b, at + b + 0.028) for at in _SHELVES for b in (0.045, 0.2))
BOOK_LABELS = tuple((at + 0.12, at + 0.21) for at in _SHELVES)
BOOK_STRIPES = tuple((at + b, at + b + 0.03) for at in _SHELVES for b in (0.06, 0.19))
BLANKET_STRIPES = ((0.74, 1.2), (0.52, 0.6), (-0.3, -0.14), (-0.52, -0.44), (-0.06, 0.02))
BED_PANELS = {
    "front": (Cells((0, -0.42), (0.88, 0.34), (4, 1), (0.8, 1), 0.1),),
    "back": (Cells((0, 0.1), (0.88, 0.66), (4, 1), (0.8, 1), 0.1),),
    "deep": 0.9,
}
SOFA_BUTTONS = {
    "front": tuple(Disc((0.36 * k, 0.52), 0.12) for k in range(-2, 3)),
    "deep": 0.2,
}
CHAIR_BUTTONS = {
    "front": tuple(Disc((0.44 * k, 0.36 + 0.28 * (k % 2)), 0.075) for k in (-1, 0, 1)),
    "deep": 0.2,
}
ARM_PIPING = {"front": (Plate((0, 0.1), (0.66, 0.74), 0.9, 0.014),), "deep": 0.5}
BOTTLE_BANDS = ((-0.7, -0.665), (-0.205, -0.17))
LABEL_BADGE = {"front": (Emblem((0, -0.435), 0.42, "leaf"),), "deep": 0.1}
CAN_BADGE = {"front": (Emblem((0, 0.1), 0.36, "star"),), "deep": 0.2}
STICKERS = {
    "front": (
        Emblem((-0.06, 0.3), 0.24, "star"),
        Disc((0.16, -0.28), 0.22),
        Emblem((0.16, -0.28), 0.15, "heart", gap=True),
        Plate((-0.18, -0.5), (0.1, 0.16), 0.2),
    ),
    "back": (Disc((0, 0), 0.34), Emblem((0, 0), 0.24, "sun", gap=True)),
    "deep": 0.6,
}
POCKET_ZIPS = {
    "front": (Line(((-0.74, -0.7), (-0.74, 0.42), (-0.6, 0.56), (0.6, 0.56), (0.74, 0.42),
                    (0.74, -0.7)), 0.014),),
    "deep": 0.0,
}  # fmt: skip
POCKET_BADGE = {"front": (Emblem((0, -0.16), 0.42, "star"),), "deep": 0.2}
LIGHT_BORDER = {"front": (Plate((0, 0), (0.88, 0.95), 0.4, 0.02),), "deep": 0.2}
MAIL_SEAMS = {
    "front": (
        Plate((0, -0.35), (0.2, 0.045), 0.9),
        Disc((0, 0.12), 0.1),
        Plate((0, 0.38), (0.5, 0.06), 0.6),
    ),
    "deep": 0.0,
}
_DOTS = tuple(
    Disc((0.5 * column + 0.25 * (row % 2) - 0.125, 0.42 * row - 0.3), 0.13)
    for row in (-1, 0, 1)
    for column in range(-2, 3)
)
GIFT_DOTS = {"front": _DOTS, "back": _DOTS, "sides": _DOTS, "deep": 0.9}
