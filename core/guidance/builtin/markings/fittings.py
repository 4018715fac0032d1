"""Markings of devices, furniture and what is in a house: panels, screens, buttons, seams."""

from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
)
from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Pair,
    Plate,
    Poly,
    laid,
)


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


def hoops(points: Points, _half: Half, pitch: float, wide: float = 0.014) -> Margin:
    """Level lines all around, one above another."""
    at = points[:, 2] / pitch
    return wide - (at - at.round()).abs() * pitch


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
