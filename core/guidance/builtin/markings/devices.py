"""Markings of devices: screens, keys, vents, gauges.

Most are outlines on a thing's sides (:mod:`core.guidance.builtin.markings.bodywork`).
"""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front
from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Outline,
    Pair,
    Plate,
    Poly,
)
from core.guidance.builtin.markings.stencils import lettering

INVADER = ("..X..X..", "...XX...", "..XXXX..", ".XX..XX.", "XXXXXXXX", "X.XXXX.X", "X......X",
           "..X..X..")  # fmt: skip
SHIP = ("...XX...", "..XXXX..", "XXXXXXXX", "XXXXXXXX")


def sprite(rows: Sequence[str], at: Pair, pixel: Pair) -> tuple[Outline, ...]:
    """A picture of squares, the runs of each row as one; ``pixel``: its half sides."""
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


def reel_sevens(points: Points, half: Half) -> Margin:
    """A seven on each of three reels side by side, by the box of all or of one."""
    pitch = float(half[0]) / (1.42 if half[0] > 0.9 * half[2] else 0.42)
    x = points[:, 0] / pitch
    size = 0.62 * pitch
    place = torch.stack([(x - x.round()) * pitch, points[:, 2]], 1) / size
    return all_of((lettering(place, "7") + 0.05) * size, in_front(points))


def meter_marks(points: Points, half: Half, count: int = 7) -> Margin:
    """Strokes along the half round window of a parking meter, by its head."""
    x, z = points[:, 0], points[:, 2] - (half[2] - half[0])
    step = math.pi / (count + 1)
    turn = torch.atan2(x, z) / step
    nearest, away = turn.round().clamp(-(count // 2), count // 2), torch.hypot(x, z)
    across = away * ((turn - nearest) * step).sin().abs()
    reach = all_of(away - 0.46 * half[0], 0.64 * half[0] - away)
    return all_of(0.012 - across, reach, in_front(points), z)


def lying_flutes(points: Points, half: Half, count: int) -> Margin:
    """Grooves along the head of a torch, which looks to the front."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, z) * (count / math.tau)
    away = torch.hypot(x, z)
    across = 0.02 - (turn - turn.round()).abs() * (math.tau / count) * away
    return all_of(across, y + 0.5 * half[1], 0.9 * half[1] - y, away - 0.7 * half[0])


def hoops_along(points: Points, half: Half, spans: Sequence[Pair]) -> Margin:
    """About a tube that goes up to the front, from corner to corner of its box; in halves."""
    long = torch.hypot(half[1], half[2])
    at = (points[:, 2] * half[2] - points[:, 1] * half[1]) / long.square()
    return any_of(*(torch.minimum(at - low, high - at) for low, high in spans)) * long


ARCADE_MARQUEE = {
    "front": (
        Plate((0, 0.82), (0.92, 0.13), 0.2),
        Emblem((0, 0.82), 0.15, text="ARCADE", gap=True),
    ),
    "deep": 0.1,
}
ARCADE_PIXELS = {
    "front": (
        *(one for at in (-0.45, 0.45) for one in sprite(INVADER, (at, 0.34), (0.05, 0.066))),
        *sprite(SHIP, (-0.4, -0.7), (0.04, 0.05)),
        Plate((-0.4, -0.38), (0.028, 0.08)),
    ),
    "deep": -9.0,
}
ARCADE_STRIPES = {
    "sides": (
        Poly(((-1.1, -1.1), (-0.55, -1.1), (1.1, 0.62), (1.1, 0.92))),
        Poly(((-0.35, -1.1), (-0.1, -1.1), (1.1, 0.22), (1.1, 0.46))),
    ),
    "back": (
        Plate((0, -0.3), (0.6, 0.5), 0.1, 0.014),
        Cells((0, 0.6), (0.5, 0.16), (1, 4), (1, 0.4), 0.8),
    ),
    "aside": 0.93,
    "deep": 0.7,
}
SLOT_BADGES = {
    "sides": (Plate((0, 0.05), (0.72, 0.84), 0.1, 0.022), Emblem((0, 0.1), 0.62, "diamond"),
              Emblem((0, 0.1), 0.3, "diamond", gap=True)),
    "back": (Plate((0, 0), (0.76, 0.84), 0.1, 0.022), Emblem((0, 0.1), 0.5, "diamond"),
             Emblem((0, 0.1), 0.26, "diamond", gap=True)),
    "deep": 0.7,
}  # fmt: skip
COMPUTER_LETTERS = {
    "front": (Emblem((-0.14, 0.5), 0.18, text="HELLO !"), Emblem((-0.62, 0.0), 0.17, text=">"),
              Plate((-0.34, 0.0), (0.11, 0.16))),
    "deep": -9.0,
}  # fmt: skip
COMPUTER_VENTS = {
    "sides": (Cells((-0.3, 0.66), (0.22, 0.2), (1, 4), (1, 0.42), 0.8),),
    "back": (Cells((0, 0.3), (0.44, 0.34), (1, 6), (1, 0.42), 0.8),
             Cells((0, -0.8), (0.7, 0.1), (5, 1), (0.6, 1), 0.3)),
    "deep": 0.3,
    "aside": 0.4,
}  # fmt: skip
CONSOLE_PIXELS = {
    "front": (*sprite(INVADER, (0, 0.22), (0.085, 0.085)), *sprite(SHIP, (0, -0.7), (0.06, 0.05))),
    "deep": -9.0,
}
KEY_LETTERS = {
    "top": tuple(
        Emblem(((c + first - 2.5) * 0.308, row * 0.442), 0.088, text=letter)
        for letters, first, row in (("QWERT", 1, 1.5), ("ASDFG", 0, 0.5), ("ZXCVB", 0, -0.5))
        for c, letter in enumerate(letters)
    ),
    "deep": 0.2,
}
_ROWS = (0.119, -0.187, -0.493, -0.8)  # of a calculator's keys, in halves of its length
CALCULATOR_DIGITS = {"top": (Emblem((0.1, 0.61), 0.15, text="1234.5"),), "deep": -9.0}
CALCULATOR_NUMBERS = {
    "top": tuple(
        Emblem((x, y), 0.11, text=text)
        for y, pair in zip(_ROWS, ("78", "45", "12", "0."), strict=True)
        for x, text in zip((-0.62, 0.0), pair, strict=True)
    ),
    "deep": -9.0,
}
CALCULATOR_SYMBOLS = {
    "top": tuple(Emblem((0.62, y), 0.11, text=text) for y, text in zip(_ROWS, "+-x=", strict=True)),
    "deep": -9.0,
}
CONSOLE_SEAMS = {
    "front": (Line(((-1.1, 0.93), (1.1, 0.93)), 0.01), Line(((-0.76, 1.1), (-0.76, 0.93)), 0.01),
              Line(((0.76, 1.1), (0.76, 0.93)), 0.01)),
    "back": (Plate((0, -0.42), (0.56, 0.36), 0.15, 0.011),
             Cells((0, -0.16), (0.2, 0.05), (1, 3), (1, 0.4), 0.9),
             Cells((0, 0.5), (0.6, 0.16), (1, 4), (1, 0.34), 0.9)),
    "deep": 0.3,
}  # fmt: skip
PAD_GRIPS = {
    "front": (
        Poly(((0.3, -1.2), (1.3, -1.2), (1.3, 0.1), (0.84, 0.0), (0.52, -0.42)), twice=True),
    ),
    "deep": -9.0,
}
PAD_LOGO = {
    "front": (Disc((0, 0.64), 0.15), Emblem((0, 0.64), 0.11, "lightning bolt", gap=True)),
    "deep": -0.35,
}
PROJECTOR_VENTS = {
    "back": (Cells((0, 0.1), (0.56, 0.42), (1, 5), (1, 0.42), 0.8),),
    "sides": (Cells((0, 0), (0.6, 0.5), (1, 4), (1, 0.42), 0.8),),
    "front": (Disc((0.86, 0.72), 0.12, twice=True), Disc((0.86, -0.72), 0.12, twice=True)),
    "deep": 0.6,
}
CUP_BANDS = ((-0.36, -0.28), (0.06, 0.14), (0.48, 0.56))
VACUUM_VENTS = {"back": (Cells((0, 0.1), (0.56, 0.3), (1, 6), (1, 0.4), 0.8),), "deep": -0.2}
JUG_MARKS = {
    "front": tuple(
        Line(((-0.34, at), (-0.02 + 0.16 * (k % 2), at)), 0.013)
        for k, at in enumerate((-0.6, -0.36, -0.12, 0.12, 0.36, 0.6))
    ),
    "deep": 0.1,
}
BLENDER_TRIM = ((-2.0, -0.76),)
DRILL_VENTS = {
    side: (Cells((0.56 * flip, 0), (0.28, 0.46), (5, 1), (0.45, 1), 0.8),)
    for side, flip in (("front", 1), ("back", -1))
}
BATTERY_LETTERS = {side: (Emblem((0, 0.0), 0.42, text="18 V"),) for side in ("front", "back")}
IRON_STRIPES = ((-0.62, -0.46), (-0.38, -0.32))
IRON_PANES = {
    side: (Poly(((-0.62 * flip, -0.12), (0.0, 0.24), (0.3 * flip, 0.24), (0.3 * flip, -0.12))),)
    for side, flip in (("front", 1), ("back", -1))
} | {"deep": 0.1}  # fmt: skip
KETTLE_BANDS = ((-2.0, -0.84), (0.62, 0.72))
FAN_BUTTONS = {
    "top": (Disc((-0.36, -0.62), 0.1), Disc((0, -0.72), 0.1), Disc((0.36, -0.62), 0.1)),
    "deep": -9.0,
    "until": -0.5,
}
FAN_BADGE = {"front": (Disc((0, 0), 0.6),), "deep": 0.3}
CAMERA_VENTS = {
    "back": (Cells((0, 0.1), (0.5, 0.3), (1, 4), (1, 0.42), 0.8),
             Disc((0.74, -0.5), 0.09, twice=True)),
    "deep": 0.4,
}  # fmt: skip
TELESCOPE_RINGS = ((0.16, 0.2), (0.24, 0.26), (0.74, 0.78))
TELESCOPE_STARS = {"sides": (Emblem((-0.44, 0.42), 0.2, "star"),), "aside": 0.2}
METER_BADGE = {
    "back": (Disc((0, 0.25), 0.62), Emblem((0, 0.25), 0.4, text="P", gap=True)),
    "sides": (Plate((0, -0.3), (0.6, 0.5), 0.2, 0.012),),
    "deep": 0.5,
}
BULB = {"front": (Disc((0, 0), 0.34), Disc((0, 0), 0.66, 0.016)), "deep": -0.5}
MOUSE_GRIPS = {
    "sides": (Cells((0.12, -0.12), (0.42, 0.34), (7, 1), (0.5, 1), 0.9),),
    "aside": 0.5,
}
