"""Outlines and spans of the markings of furniture."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate

_SLATS = tuple(Line(((at, -1.2), (at, 1.2)), 0.009) for at in (-0.5, 0.0, 0.5))
CHAIR_SEAMS = {"top": _SLATS, "deep": 0.3}
CHAIR_BUTTONS = {
    "front": tuple(Disc((0.44 * k, 0.36 + 0.28 * (k % 2)), 0.075) for k in (-1, 0, 1)),
    "deep": 0.2,
}
ARM_PIPING = {"front": (Plate((0, 0.1), (0.66, 0.74), 0.9, 0.014),), "deep": 0.5}
BACK_SEAMS = {
    "front": (Plate((0, 0), (0.78, 0.84), 0.5, 0.014),
              *(Line(((-0.76, at), (0.76, at)), 0.012) for at in (-0.3, 0.3))),
    "back": (Plate((0, 0), (0.78, 0.84), 0.5, 0.014),),
    "deep": -1.0,
}  # fmt: skip
CHAIR_BADGE = {
    "back": (Emblem((0, 0.42), 0.34, "lightning bolt"), Plate((0, -0.3), (0.4, 0.05), 0.9),
             Plate((0, -0.42), (0.3, 0.03), 0.9)),
    "deep": 0.55,
}  # fmt: skip
THRONE_BUTTONS = {
    "front": (*(Disc((0.44, at), 0.14, twice=True) for at in (0.7, 0.3)),
              *(Disc((0.0, at), 0.14) for at in (0.5, 0.1))),
    "deep": -1.2,
    "until": 0.95,
}  # fmt: skip
THRONE_GEMS = {
    "front": (Emblem((0, -0.78), 0.16, "diamond"), Emblem((0, 0.9), 0.16, "diamond")),
    "deep": -1.2,
}
_THRONE = (Plate((0, -0.12), (0.66, 0.7), 0.05, 0.02), Emblem((0, 0.12), 0.42, "crown"))
THRONE_PANELS = {
    "back": _THRONE,
    "front": (Plate((0, -0.78), (0.62, 0.1), 0.2),),
    "sides": (Plate((0.0, -0.68), (0.6, 0.16), 0.1, 0.016),),
    "deep": 0.5,
}
THRONE_STEP = {
    "top": (Plate((0, 0), (0.9, 0.9), 0.05, 0.018),),
    "front": (Plate((0, 0), (0.92, 0.3), 0.2, 0.009),),
    "back": (Plate((0, 0), (0.92, 0.3), 0.2, 0.009),),
    "sides": (Plate((0, 0), (0.92, 0.3), 0.2, 0.009),),
}
SOFA_BUTTONS = {
    "front": tuple(Disc((0.36 * k, 0.52), 0.12) for k in range(-2, 3)),
    "deep": 0.2,
}
BENCH_BOLTS = {
    "top": tuple(Disc((0.77, at), 0.1, twice=True) for at in (-0.75, -0.25, 0.25, 0.75)),
    "deep": 0.4,
}
BENCH_SEAMS = {
    "top": tuple(Line(((-1.1, at), (1.1, at)), 0.011) for at in (-0.5, 0.0, 0.5)),
    "sides": tuple(Line(((at, -1.1), (at, 1.1)), 0.011) for at in (-0.5, 0.0, 0.5)),
    "deep": 0.4,
}
OTTOMAN_NAILS = {
    side: (Cells((0, -0.78), (0.92, 0.09), (11, 1), (0.42, 1), 0.95),)
    for side in ("front", "back", "sides")
} | {"deep": 0.7}
BLANKET_STRIPES = ((0.74, 1.2), (0.52, 0.6), (-0.3, -0.14), (-0.52, -0.44), (-0.06, 0.02))
BED_PANELS = {
    "front": (Cells((0, -0.42), (0.88, 0.34), (4, 1), (0.8, 1), 0.1),),
    "back": (Cells((0, 0.1), (0.88, 0.66), (4, 1), (0.8, 1), 0.1),),
    "deep": 0.9,
}
BED_TRIM = ((-0.62, -0.4), (0.66, 0.82))
CRIB_HEARTS = {
    "sides": (Emblem((0, 0.36), 0.4, "heart"),),
    "aside": 0.86,
}
CRIB_STARS = {
    "top": tuple(
        Emblem(at, 0.2, "star")
        for at in ((-0.7, -0.55), (-0.7, 0.55), (0.0, 0.0), (0.7, -0.55), (0.7, 0.55))
    ),
    "deep": 0.0,
}
PILLOW_BORDER = {
    "top": (Plate((0, 0), (0.8, 0.76), 0.4, 0.018), Disc((0, 0), 0.4, 0.014)),
    "deep": -0.3,
}
TABLE_SEAMS = {
    "top": (
        *(Line(((-0.84, at), (0.84, at)), 0.009) for at in (-0.6, -0.2, 0.2, 0.6)),
        *(Line(((at, -1.1), (at, 1.1)), 0.009) for at in (-0.84, 0.84)),
    ),
    "deep": 0.5,
}
BLOTTER_EDGE = {"top": (Plate((-0.08, -0.12), (0.43, 0.56), 0.12, 0.009),), "deep": 0.3}
BLOTTER = {"top": (Plate((-0.08, -0.12), (0.46, 0.62), 0.12),), "deep": 0.3}
COFFEE_SEAMS = {
    "top": tuple(Line(((-1.2, at), (1.2, at)), 0.009) for at in (-0.6, -0.2, 0.2, 0.6)),
    "deep": 0.2,
}
_SHELVES = tuple(-1 + 2 * (0.054 + 0.315 * k) for k in range(3))
BOOK_BANDS = tuple((at + b, at + b + 0.028) for at in _SHELVES for b in (0.045, 0.2))
BOOK_LABELS = tuple((at + 0.12, at + 0.21) for at in _SHELVES)
BOOK_STRIPES = tuple((at + b, at + b + 0.03) for at in _SHELVES for b in (0.06, 0.19))
SHELF_BANDS = ((0.6, 1.6), (3.9, 4.3))
SHELF_VOLUMES, SHELF_TOMES = ((-0.648, -0.43),), ((-0.47, -0.1),)
VASE_STRIPES = ((-0.36, -0.18), (-0.08, -0.02), (0.86, 1.2))
WARDROBE_PANELS = {
    "front": (
        Plate((0.52, 0.44), (0.28, 0.4), 0.15, 0.018, twice=True),
        Plate((0.52, -0.24), (0.28, 0.16), 0.15, 0.018, twice=True),
        Plate((0.52, -0.66), (0.28, 0.1), 0.15, 0.018, twice=True),
    ),
    "deep": 0.9,
}
MIRROR_GEMS = {
    "front": (Emblem((0, 0.93), 0.12, "diamond"), Emblem((0, -0.93), 0.12, "diamond"),
              Emblem((0.865, 0), 0.12, "diamond", twice=True)),
    "deep": -0.5,
}  # fmt: skip
MIRROR_BACK = {
    "back": (
        Plate((0, 0), (0.66, 0.78), 0.9),
        Plate((0, 0), (0.54, 0.68), 0.9, 0.012, gap=True),
    ),
    "deep": 0.3,
}
SHADE_BANDS = ((-1.1, -0.86), (0.86, 1.1))
PIANO_PANELS = {
    "front": (
        Plate((0.45, 0.62), (0.36, 0.2), 0.12, 0.014, twice=True),
        Plate((0, -0.5), (0.72, 0.3), 0.12, 0.014),
    ),
    "back": (Plate((0, 0), (0.8, 0.8), 0.1, 0.016), Line(((0, 0.8), (0, -0.8)), 0.014)),
    "deep": -0.3,
}
CABINET_DOOR = {"front": (Plate((0, 0), (0.66, 0.76), 0.12, 0.018),), "deep": 0.2}
DRAWER = {"front": (Plate((0, 0), (0.84, 0.72), 0.15, 0.014),), "deep": 0.0}
LOCKER_VENTS = {
    "front": (
        Cells((0.5, 0.62), (0.24, 0.13), (1, 5), (1, 0.42), 0.9, twice=True),
        Cells((0.5, -0.2), (0.24, 0.09), (1, 3), (1, 0.42), 0.9, twice=True),
    ),
    "deep": 0.8,
}
LOCKER_PLATE = {"front": (Plate((0.5, 0.3), (0.14, 0.055), 0.2, twice=True),), "deep": 0.8}
