"""Outlines and spans of the markings of buildings."""

import math

from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Plate,
    Poly,
    on_all_sides,
)

_GABLE_SUN = (
    Cells((0, -0.72), (0.96, 0.16), (9, 1), (0.5, 1)),
    Disc((0, 0.02), 0.5, 0.011),
    Emblem((0, 0.02), 0.36, "sun"),
)
TEMPLE_FRIEZE = {
    "front": _GABLE_SUN,
    "back": _GABLE_SUN,
    "sides": (Cells((0, -0.72), (0.96, 0.16), (13, 1), (0.5, 1)),),
    "deep": 0.9,
}
PIER_PLAQUE = {"front": (Plate((0, 0.42), (0.5, 0.16), 0.3),), "deep": 0.8}
POST_BANDS = ((0.5, 0.62), (-0.84, -0.7))
BASIN_TILES = ((-0.12, 0.36),)
BOWL_LINES = ((0.5, 0.66), (0.3, 0.38))
COLUMN_BANDS = ((-0.5, -0.42), (0.0, 0.06), (-0.36, -0.32))
_STAIR = Line(((-0.52, -0.84), (0.84, -0.84), (0.84, 0.46), (-0.52, -0.84)), 0.016)
STAIR_PANELS = {
    "sides": (_STAIR,),
    "back": (Plate((0, 0), (0.8, 0.86), 0.05, 0.016),),
    "deep": 0.9,
}
BOOTH_LETTERS = on_all_sides(Emblem((0, 0.837), 0.085, text="TELEPHONE")) | {"deep": 0.6}
BOOTH_SIGN = on_all_sides(Plate((0, 0.837), (0.76, 0.1), 0.2)) | {"deep": 0.6}
BOOTH_WINDOWS = on_all_sides(Cells((0, 0.03), (0.68, 0.66), (3, 5), (0.84, 0.84))) | {"deep": 0.6}
BOOTH_SEAMS = on_all_sides(Plate((0, 0.0), (0.79, 0.71), 0.06, 0.01)) | {"deep": 0.6}
METER_BADGE = {
    "back": (Disc((0, 0.25), 0.62), Emblem((0, 0.25), 0.4, text="P", gap=True)),
    "sides": (Plate((0, -0.3), (0.6, 0.5), 0.2, 0.012),),
    "deep": 0.5,
}
PUMP_MARKS = {
    "front": (
        Plate((0, -0.46), (0.46, 0.1), 0.3),
        Emblem((0, -0.46), 0.12, text="0.00", gap=True),
        Plate((0, -0.66), (0.4, 0.03), 0.5),
        *(
            Disc((0.46 * math.sin(a), 0.32 + 0.25 * math.cos(a)), 0.055)
            for a in (math.tau * k / 12 for k in range(12))
        ),
    ),
    "deep": 0.0,
}
GLOBE_STAR = {"front": (Emblem((0, 0), 0.55, "star"),), "back": (Emblem((0, 0), 0.55, "star"),)}
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
STALL_APPLES = ((-0.31, 0.31),)
STALL_PANELS = {
    side: (Cells((0, -0.06), (0.94, 0.8), (many, 1), (0.82, 1.0), 0.1),
           Cells((0, -0.06), (0.94, 0.8), (many, 1), (0.6, 0.78), 0.1, gap=True))
    for side, many in (("front", 3), ("back", 3), ("sides", 1))
} | {"deep": 0.8}  # fmt: skip
CONTAINER_RIDGES = {
    "top": (Cells((0, 0), (0.78, 0.9), (1, 13), (1, 0.46)),),
    "back": (Cells((0, 0), (0.8, 0.76), (7, 1), (0.46, 1)),),
    "deep": 0.8,
}
