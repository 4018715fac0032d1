"""Outlines and spans of the markings of cars, vans, boats, trains and scooters."""

from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Plate,
    Poly,
    number_plate,
)


def _shield(low: float, high: float, below: float, above: float) -> Poly:
    """A pane across a cabin's end: its heights, and its half widths there."""
    return Poly(((-below, low), (-above, high), (above, high), (below, low)))


CAR_WINDOWS = {
    "front": (_shield(0.2, 0.87, 0.8, 0.66),),
    "back": (_shield(0.22, 0.85, 0.76, 0.62),),
    "sides": (
        Poly(((-0.3, 0.2), (-0.085, 0.85), (0.15, 0.85), (0.15, 0.2))),
        Poly(((0.21, 0.2), (0.21, 0.85), (0.42, 0.85), (0.63, 0.2))),
    ),
    "ends": (0.05, 0.42),
}
CAR_PLATES = {"front": number_plate(-0.8), "back": number_plate(-0.34)}
CAR_TAIL = {"back": (Plate((0.62, -0.2), (0.19, 0.11), 0.4, twice=True),)}
_BUMPER = Plate((0, -0.84), (1.2, 0.16))
_CAR_FRONT = (
    Plate((0, -0.4), (0.3, 0.15), 0.4),
    Cells((0, -0.4), (0.26, 0.11), (1, 3), (2, 0.45), gap=True),
    _BUMPER,
)
_CAR_BACK = (
    Plate((0.62, -0.2), (0.22, 0.15), 0.4, twice=True),
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
CAR_TRIM = {"front": _CAR_FRONT, "back": _CAR_BACK, "sides": _CAR_SIDES, "aside": 0.72}
_CHECKS = tuple(
    Cells((0.045 * row, -0.28 - 0.09 * row), (1.035, 0.045), (23, 1), (0.5, 1.0)) for row in (0, 1)
)
TAXI_TRIM = CAR_TRIM | {
    "sides": (*_CHECKS, *_CAR_SIDES),
    "back": (
        Plate((0.62, -0.2), (0.2, 0.13), 0.4, 0.014, twice=True),
        *number_plate(-0.34, 0.3, 0.15),
        _BUMPER,
    ),
}
SPORTS_WINDOWS = {
    "front": (_shield(0.3, 0.88, 0.76, 0.62),),
    "sides": (Poly(((-0.22, 0.32), (0.0, 0.84), (0.3, 0.84), (0.48, 0.32))),),
    "back": (_shield(0.34, 0.86, 0.72, 0.6),),
    "ends": (-0.02, 0.28),
}
SPORTS_TAIL = {"back": (Plate((0.62, 0.1), (0.24, 0.075), 0.8, twice=True),)}
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
NOSE = Disc((0, -0.46), 0.32)  # of a race car, for its number
VISOR = {"front": (Plate((0, 0.12), (0.72, 0.3), 0.9),), "deep": 0.1}
JEEP_WINDOWS = {
    "front": (Plate((0, 0.14), (0.8, 0.56), 0.2),),
    "sides": (
        Poly(((-0.87, -0.42), (-0.76, 0.68), (-0.3, 0.68), (-0.3, -0.42))),
        Plate((0.06, 0.13), (0.28, 0.55), 0.15),
        Plate((0.66, 0.13), (0.22, 0.55), 0.15),
    ),
    "back": (Plate((0, 0.14), (0.74, 0.52), 0.2),),
    "ends": (0.7, 0.8),
}
JEEP_GRILLE = {
    "front": (Cells((0, 0.3), (0.36, 0.4), (7, 1), (0.5, 1), 0.9),),
    "deep": 0.7,
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
VAN_PLATES = {"front": number_plate(-0.67, 0.28, 0.115), "back": number_plate(-0.45, 0.27, 0.11)}
VAN_TAIL = {"back": (Plate((0.86, -0.28), (0.07, 0.25), 0.4, twice=True),)}
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
AMBULANCE_WINDOWS = VAN_WINDOWS | {"sides": VAN_WINDOWS["sides"][:1]}
AMBULANCE_TRIM = {  # it has no number plates
    "front": (*_VAN_FRONT[:2], *_VAN_FRONT[3:]),
    "back": (*_VAN_BACK[:2], *_VAN_BACK[3:]),
    "sides": _VAN_SIDES,
}
CART_LAMPS = {"front": (Disc((0.66, 0.16), 0.27, twice=True),), "deep": 0.4}
CART_TRIM = {
    "front": (Disc((0.66, 0.16), 0.37, twice=True),
              Cells((0, 0.16), (0.38, 0.24), (1, 3), (1, 0.46), 0.8),
              Plate((0, -0.74), (1.2, 0.24))),
    "back": (Plate((0, -0.74), (1.2, 0.24)),),
    "sides": (Plate((0.0, -0.84), (0.36, 0.16)), Plate((-1, -0.74), (0.1, 0.24)),
              Plate((1, -0.74), (0.1, 0.24))),
    "deep": 0.3,
    "aside": 0.6,
}  # fmt: skip
TYRE_STRIPE = {side: (Disc((0, 0), 0.812, 0.02),) for side in ("front", "back")}
ANCHOR = {"sides": (Emblem((-0.3, -0.42), 0.42, "anchor"),), "aside": -9.0}
YACHT_PORTS = {"sides": (Cells((0.16, 0.26), (0.56, 0.13), (6, 1), (0.5, 1), 1.0),), "aside": 0.4}
SKI_TRIM = {
    "sides": (Poly(((-0.86, -0.5), (-0.4, 0.5), (-0.18, 0.5), (-0.5, -0.1), (-0.2, -0.2),
                    (-0.26, -0.5))),),
    "top": (Poly(((-0.5, -0.35), (0.0, -0.75), (0.5, -0.35), (0.5, -0.52), (0.0, -0.95),
                  (-0.5, -0.52))),),
    "aside": 0.5,
    "deep": -0.6,
}  # fmt: skip
SADDLE_RIBS = tuple((at, at + 0.07) for at in (-0.75, -0.55, -0.35, 0.15, 0.35, 0.55, 0.75))
PORTHOLES = {"sides": (Cells((0.06, 0.1), (0.6, 0.15), (9, 1), (0.5, 1), 1.0),), "aside": 0.5}
SUB_PORTS = {"sides": tuple(Disc((at, 0.12), 0.25) for at in (-0.5, -0.1, 0.3)), "aside": 0.2}
SUB_RIMS = {"sides": tuple(Disc((at, 0.12), 0.36) for at in (-0.5, -0.1, 0.3)), "aside": 0.2}
TRAIN_WINDOWS = {
    "front": (Plate((0.45, 0.28), (0.2, 0.17), 0.4, twice=True),),
    "sides": (Plate((0, 0.18), (0.42, 0.25), 0.3),),
    "back": (Plate((0.3, 0.2), (0.22, 0.24), 0.3, twice=True),),
    "ends": (0.4, 0.4),
}
BOILER_BANDS = ((-0.94, -0.87), (-0.52, -0.46), (-0.1, -0.04), (0.3, 0.36), (0.66, 0.72))
TRAM_LAMPS = {side: (Disc((0.62, -0.76), 0.15, twice=True),) for side in ("front", "back")} | {
    "deep": 0.2
}
TRAM_SIGN = {
    side: (Plate((0, 0.82), (0.6, 0.14), 0.4), Emblem((0, 0.82), 0.1, text="TRAM", gap=True))
    for side in ("front", "back")
}
TRAM_WINDOWS = {
    "front": (Plate((0, 0.27), (0.76, 0.38), 0.2),),
    "back": (Plate((0, 0.27), (0.76, 0.38), 0.2),),
    "sides": (Cells((0, 0.28), (0.62, 0.36), (5, 1), (0.86, 1), 0.2),
              Plate((0.79, 0.12), (0.075, 0.52), 0.2, twice=True)),
    "deep": 0.7,
}  # fmt: skip
TRAM_DOORS = {
    "sides": (Plate((0.79, -0.08), (0.115, 0.8), 0.1, 0.011, twice=True),
              Line(((0.79, -0.42), (0.79, -0.88)), 0.009, twice=True)),
    "deep": 0.7,
}  # fmt: skip
ENGINE_FINS = {"sides": (Cells((0, 0.4), (0.28, 0.44), (1, 4), (1, 0.4), 0.8),), "aside": 0.45}
SCOOTER_GRILLE = {"front": (Cells((0, 0.3), (0.4, 0.16), (1, 4), (1, 0.46), 0.8),), "deep": 0.05}
SCOOTER_TRIM = {
    "sides": (Plate((0.62, -0.02), (0.25, 0.3), 0.95),),
    "front": (Plate((0, 0.3), (0.9, 0.66), 0.4, 0.026),),
    "aside": 0.3,
    "deep": 0.05,
}
SCOOTER_TAIL = {"back": (Disc((0, 0.0), 0.3),), "deep": 0.7}
