"""Markings of vehicles: windows, seams, grilles, plates, lamps."""

from collections.abc import Sequence

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
    Outline,
    Pair,
    Plate,
    Poly,
    laid,
)


def links(points: Points, half: Half, count: int = 17) -> Margin:
    """Of a tank's tracks, along their upper and lower edges."""
    pitch = 2 * half[1] / count
    at = points[:, 1] / pitch
    gap = 0.3 * pitch - (at - at.round()).abs() * pitch
    return all_of(gap, points[:, 2].abs() - 0.52 * half[2])


NUMBER = "F3D"  # on number plates


def _plate(up: float, wide: float = 0.27, high: float = 0.13) -> tuple[Outline, ...]:
    """A number plate, its number left out."""
    letters = Emblem((0, up), high * 0.62, text=NUMBER, gap=True)
    return Plate((0, up), (wide, high), 0.3), letters


def race_number(points: Points, half: Half, text: str) -> Margin:
    """A disc on the nose, the number left out of it."""
    size = 0.22 if len(text) == 1 else 0.17
    return laid(points, half, top=(NOSE, Emblem(NOSE.at, size, text=text, gap=True)), deep=-0.2)


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
NOSE = Disc((0, -0.46), 0.32)  # of a race car, for its number
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
