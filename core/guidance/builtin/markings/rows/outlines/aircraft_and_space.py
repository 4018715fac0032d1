"""Outlines and spans of the markings of aircraft and space."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate, Poly

PLANE_WINDOWS = {
    "about": (Poly(((-0.86, 0.22), (-0.74, 1.2), (-0.6, 1.2), (-0.68, 0.22))),),
    "sides": (Cells((0.02, 0.24), (0.55, 0.13), (9, 1), (0.5, 1), 1.0),),
    "front": (),
}
PLANE_STRIPE = {"about": (Poly(((-1.1, -0.3), (-0.5, -0.12), (0.6, -0.12), (1.1, 0.9), (1.1, 0.3),
                                (0.7, -0.42), (-0.5, -0.42), (-1.1, -0.5))),)}  # fmt: skip
TAIL_BANDS = ((0.42, 0.82), (0.28, 0.34))
JET_STARS = {
    "top": (
        Disc((0.56, 0.2), 0.27, twice=True),
        Emblem((0.56, 0.2), 0.23, "star", twice=True, gap=True),
    ),
    "deep": -9.0,
}
JET_NOSE = ((-1.2, -0.74),)
HELICOPTER_PANES = {"sides": (Plate((-0.06, 0.16), (0.12, 0.24), 0.4),), "aside": 0.3}
HELICOPTER_DOORS = {
    "sides": (
        Plate((-0.06, -0.08), (0.17, 0.56), 0.35, 0.011),
        Plate((0.05, -0.2), (0.035, 0.04), 0.9),
    ),
    "aside": 0.3,
}
HELICOPTER_BANDS = ((0.42, 0.5), (0.55, 0.58))
BALLOON_BELTS = ((-2.0, -0.84), (0.02, 0.26))
ROCKET_BANDS = ((-0.42, -0.22), (-0.14, -0.08))
ROCKET_HATCH = {
    "back": (
        Plate((0, 0.42), (0.46, 0.36), 0.5, 0.016),
        Disc((0, 0.52), 0.17),
        Plate((0.24, 0.3), (0.05, 0.06), 0.5),
    ),
    "deep": 0.3,
}
SHUTTLE_EDGES = {
    "top": (
        Poly(((0.0, -1.1), (0.46, -0.66), (1.1, 0.42), (1.1, 0.78), (0.44, -0.32), (0.0, -0.75)),
             twice=True),
    ),
    "deep": -9.0,
}  # fmt: skip
SHUTTLE_DOORS = {
    "top": (Plate((0, 0.12), (0.72, 0.6), 0.1, 0.01), Line(((0, -0.48), (0, 0.72)), 0.01)),
    "deep": 0.1,
}
SHIP_NOSE = ((-1.2, -0.72), (-0.66, -0.63))
SHIP_STRIPES = {
    "top": (
        Plate((0.84, 0), (0.05, 3), twice=True),
        Plate((0.7, 0), (0.025, 3), twice=True),
    ),
    "deep": -9.0,
}
FOIL = {
    side: (
        Plate((0, 0), (0.84, 0.84), 0.1, 0.012),
        Line(((-0.84, -0.84), (0.84, 0.84)), 0.01),
        Line(((-0.84, 0.84), (0.84, -0.84)), 0.01),
    )
    for side in ("front", "back", "sides")
}
