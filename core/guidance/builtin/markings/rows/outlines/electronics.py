"""Outlines and spans of the markings of electronics."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate, Poly, sprite

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
TOWER_PORTS = {
    "back": (
        Disc((0.4, 0.58), 0.4, 0.02),
        Disc((0.4, 0.58), 0.2, 0.015),
        Cells((-0.5, 0.58), (0.26, 0.24), (2, 3), (0.6, 0.55), 0.2),
        Cells((0, -0.06), (0.76, 0.22), (1, 4), (1, 0.36)),
        Plate((0, -0.66), (0.76, 0.2), 0.1, 0.014),
        Plate((-0.4, -0.66), (0.2, 0.1), 0.3),
    ),
}
TV_SLOTS = {
    "front": (Cells((0.76, -0.55), (0.15, 0.24), (1, 5), (1, 0.45), 0.9),),
    "back": (
        Cells((0, 0.25), (0.6, 0.4), (1, 6), (1, 0.4), 0.9),
        Plate((0, -0.55), (0.4, 0.14), 0.3, 0.012),
    ),
}
KEY_LETTERS = {
    "top": tuple(
        Emblem(((c + first - 2.5) * 0.308, row * 0.442), 0.088, text=letter)
        for letters, first, row in (("QWERT", 1, 1.5), ("ASDFG", 0, 0.5), ("ZXCVB", 0, -0.5))
        for c, letter in enumerate(letters)
    ),
    "deep": 0.2,
}
MOUSE_GRIPS = {
    "sides": (Cells((0.12, -0.12), (0.42, 0.34), (7, 1), (0.5, 1), 0.9),),
    "aside": 0.5,
}
PRINTED = {"front": (Cells((-0.1, 0.3), (0.62, 0.5), (1, 5), (1, 0.34), 0.5),), "deep": -9.0}
CALCULATOR_DIGITS = {"top": (Emblem((0.1, 0.61), 0.15, text="1234.5"),), "deep": -9.0}
_ROWS = (0.119, -0.187, -0.493, -0.8)  # of a calculator's keys, in halves of its length
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
DISPLAY_DIGITS = {"front": (Emblem((0, 0), 0.62, text="9.50"),), "deep": 0.2}
TILL_BORDER = {
    "sides": (Poly(((-0.6, -0.2), (0.05, 0.66), (0.76, 0.66), (0.76, -0.2))),
              Poly(((-0.5, -0.14), (0.08, 0.6), (0.7, 0.6), (0.7, -0.14)), gap=True)),
    "back": (Plate((0, 0.2), (0.7, 0.5), 0.1, 0.014),),
}  # fmt: skip
PAD_LOGO = {
    "front": (Disc((0, 0.64), 0.15), Emblem((0, 0.64), 0.11, "lightning bolt", gap=True)),
    "deep": -0.35,
}
PAD_GRIPS = {
    "front": (
        Poly(((0.3, -1.2), (1.3, -1.2), (1.3, 0.1), (0.84, 0.0), (0.52, -0.42)), twice=True),
    ),
    "deep": -9.0,
}
INVADER = ("..X..X..", "...XX...", "..XXXX..", ".XX..XX.", "XXXXXXXX", "X.XXXX.X", "X......X",
           "..X..X..")  # fmt: skip
SHIP = ("...XX...", "..XXXX..", "XXXXXXXX", "XXXXXXXX")
CONSOLE_PIXELS = {
    "front": (*sprite(INVADER, (0, 0.22), (0.085, 0.085)), *sprite(SHIP, (0, -0.7), (0.06, 0.05))),
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
PHONE_CAMERA = {"back": (Plate((-0.5, 0.68), (0.38, 0.24), 0.5),), "deep": 0.3}
LENS_RINGS = ((-0.94, -0.84), (-0.52, -0.4))
CAMERA_SCREEN = {"back": (Plate((-0.14, 0), (0.56, 0.76), 0.15),
                          Cells((0.72, 0), (0.14, 0.6), (1, 3), (0.8, 0.6), 0.9))}  # fmt: skip
CAMERA_VENTS = {
    "back": (Cells((0, 0.1), (0.5, 0.3), (1, 4), (1, 0.42), 0.8),
             Disc((0.74, -0.5), 0.09, twice=True)),
    "deep": 0.4,
}  # fmt: skip
PROJECTOR_VENTS = {
    "back": (Cells((0, 0.1), (0.56, 0.42), (1, 5), (1, 0.42), 0.8),),
    "sides": (Cells((0, 0), (0.6, 0.5), (1, 4), (1, 0.42), 0.8),),
    "front": (Disc((0.86, 0.72), 0.12, twice=True), Disc((0.86, -0.72), 0.12, twice=True)),
    "deep": 0.6,
}
DIAL_MARKS = {
    "front": (
        Cells((0, 0.25), (0.84, 0.32), (11, 1), (0.28, 1)),
        Plate((0, -0.35), (0.86, 0.08)),
        Plate((0.25, -0.02), (0.05, 0.8)),
    ),
}
RECORD_GROOVES = tuple((0.4 + 0.065 * k, 0.43 + 0.065 * k) for k in range(9))
CASE_PANELS = {
    side: (Plate((0, 0.46), (0.7, 0.3), 0.3, 0.014),) for side in ("front", "back", "sides")
}
CUP_BADGES = {"sides": (Disc((0, 0), 0.62, 0.03), Emblem((0, 0), 0.36, "lightning bolt")),
              "aside": 0.3}  # fmt: skip
BULB = {"front": (Disc((0, 0), 0.34), Disc((0, 0), 0.66, 0.016)), "deep": -0.5}
COFFEE_DIGITS = {"front": (Emblem((-0.4, 0), 0.5, text="7:30"),), "deep": -9.0}
COFFEE_BUTTONS = {
    "front": tuple(Disc((at, 0), 0.42) for at in (0.3, 0.56, 0.82)),
    "deep": -9.0,
}
IRON_STRIPES = ((-0.62, -0.46), (-0.38, -0.32))
IRON_PANES = {
    side: (Poly(((-0.62 * flip, -0.12), (0.0, 0.24), (0.3 * flip, 0.24), (0.3 * flip, -0.12))),)
    for side, flip in (("front", 1), ("back", -1))
} | {"deep": 0.1}  # fmt: skip
CUP_BANDS = ((-0.36, -0.28), (0.06, 0.14), (0.48, 0.56))
VACUUM_VENTS = {"back": (Cells((0, 0.1), (0.56, 0.3), (1, 6), (1, 0.4), 0.8),), "deep": -0.2}
DRILL_VENTS = {
    side: (Cells((0.56 * flip, 0), (0.28, 0.46), (5, 1), (0.45, 1), 0.8),)
    for side, flip in (("front", 1), ("back", -1))
}
BATTERY_LETTERS = {side: (Emblem((0, 0.0), 0.42, text="18 V"),) for side in ("front", "back")}
DRONE_LAMPS = {
    "front": (Plate((0.5, 0.1), (0.16, 0.1), 0.9, twice=True),),
    "back": (Plate((0.5, 0.1), (0.16, 0.1), 0.9, twice=True),),
    "deep": 0.3,
}
DRONE_SEAMS = {
    "top": (Plate((0, 0.1), (0.5, 0.5), 0.5, 0.012), Disc((0, -0.66), 0.09)),
    "deep": 0.2,
}
