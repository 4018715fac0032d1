"""Outlines and spans of the markings of buses, trucks and work vehicles."""

from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Plate,
    Poly,
    hazard,
    on_all_sides,
    slanted_bars,
)

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
SCHOOL_BUS_WINDOWS = BUS_WINDOWS | {
    "sides": (Cells((0, 0.32), (0.94, 0.3), (7, 1), (0.84, 1), 0.15),)
}
BUS_TAIL = {"back": (Plate((0.72, -0.52), (0.12, 0.11), 0.4, twice=True),)}
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
SCHOOL_BUS_TRIM = {
    "front": BUS_TRIM["front"][2:],
    "back": _BUS_BACK,
    "sides": BUS_TRIM["sides"][1:],
}
_DECK_ENDS = (Plate((0, -0.18), (0.78, 0.22), 0.2), Plate((0, 0.58), (0.78, 0.22), 0.2))
_DECKS = (
    Cells((-0.12, -0.18), (0.8, 0.22), (4, 1), (0.88, 1), 0.15),
    Cells((0, 0.58), (0.92, 0.22), (5, 1), (0.88, 1), 0.15),
)
DOUBLE_DECKER_WINDOWS = {
    "front": (*_DECK_ENDS, Line(((0, 0.8), (0, 0.3)), 0.012, gap=True)),
    "sides": (*_DECKS, Cells((0.84, -0.4), (0.1, 0.44), (2, 1), (0.7, 0.94), 0.3)),
    "back": (_DECK_ENDS[1],),
    "ends": (0.8, 0.8),
}
DOUBLE_DECKER_TAIL = {
    "back": (Plate((0.74, -0.6), (0.105, 0.085), 0.4, twice=True),),
    "deep": 0.3,
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
TRUCK_WINDOWS = {
    "front": (Plate((0, 0.36), (0.8, 0.36), 0.2),),
    "sides": (Plate((0, 0.36), (0.64, 0.36), 0.2),),
    "ends": (0.6, 0.6),
}
TRUCK_LAMPS = {"front": (Plate((0.74, -0.45), (0.14, 0.17), 0.5, twice=True),)}
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
PICKUP_WINDOWS = {
    "front": (Poly(((-0.8, 0.22), (-0.67, 0.86), (0.67, 0.86), (0.8, 0.22))),),
    "sides": (Poly(((-0.32, 0.22), (-0.14, 0.84), (0.07, 0.84), (0.11, 0.22))),),
    "back": (Poly(((-0.74, 0.26), (-0.64, 0.82), (0.64, 0.82), (0.74, 0.26))),),
    "ends": (0.06, 0.05),
    "until": 0.32,
}
PICKUP_TAIL = {"back": (Plate((0.85, -0.22), (0.085, 0.19), 0.3, twice=True),)}
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
MONSTER_DOORS = {
    "sides": (
        Plate((-0.06, 0.0), (0.17, 0.42), 0.2, 0.01),
        Plate((0.05, 0.02), (0.04, 0.04), 0.9),
    ),
    "aside": 0.7,
}
FLAMES = {
    "sides": (
        Poly(((-1.2, 0.2), (-0.55, 0.22), (-0.1, 0.02), (-0.42, -0.02), (0.16, -0.3),
              (-0.36, -0.3), (-0.1, -0.56), (-0.5, -0.5), (-0.6, -0.8), (-1.2, -0.8))),
    ),
    "aside": 0.84,
}  # fmt: skip
DUMPER_TRIM = {
    "front": (Cells((0, -0.36), (0.36, 0.26), (1, 4), (1, 0.46), 0.6),
              *hazard((0, -0.8), (1.1, 0.17), 9)),
    "sides": (Plate((-0.53, 0.08), (0.13, 0.84), 0.1, 0.01),
              Plate((-0.46, -0.1), (0.04, 0.05), 0.9)),
    "deep": 0.7,
    "aside": 0.5,
}  # fmt: skip
GARBAGE_WINDOWS = {
    "front": (
        Plate((0, 0.4), (0.8, 0.36), 0.25),
        Line(((0, 1), (0, 0)), 0.012, gap=True),
    ),
    "sides": (Plate((0.06, 0.4), (0.5, 0.36), 0.25),),
    "deep": 0.6,
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
DIGGER_STRIPES = {"back": slanted_bars((0, -0.28), (0.86, 0.24), 6), "deep": 0.8}
DIGGER_VENTS = {
    "sides": (Cells((0.5, -0.1), (0.28, 0.26), (1, 4), (1, 0.42), 0.8),),
    "aside": 0.7,
}
TRACTOR_GRILLE = {
    "front": (
        Plate((0, -0.1), (0.5, 0.62), 0.2),
        Cells((0, -0.1), (0.42, 0.52), (1, 5), (2, 0.3), gap=True),
    ),
    "sides": (Cells((-0.5, 0.1), (0.24, 0.26), (5, 1), (0.42, 1), 0.8),),
}
TRACTOR_LAMPS = {"front": (Disc((0.52, 0.72), 0.2, twice=True),)}
TANK_STAR = {"sides": (Emblem((-0.3, 0.2), 0.5, "star"),), "deep": 0.3}
TANK_VENTS = {
    "back": (Cells((0, 0.2), (0.5, 0.3), (1, 3), (1, 0.45), 0.5),),
    "top": (Cells((0, 0.72), (0.56, 0.16), (7, 1), (0.45, 1), 0.5),),
    "deep": 0.4,
}
ROVER_FOIL = on_all_sides(Cells((0, 0), (0.9, 0.8), (3, 1), (0.86, 1), 0.1)) | {"deep": 0.7}
