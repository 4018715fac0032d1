"""Outlines and spans of the markings of props and arms."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate, Poly

FULLER = {
    "front": (Plate((0, -0.22), (0.26, 0.78), 0.9),),
    "back": (Plate((0, -0.22), (0.26, 0.78), 0.9),),
    "deep": 0.0,
}
GRIP_WRAPS = tuple((-0.9 + 0.24 * k, -0.8 + 0.24 * k) for k in range(8))
QUARTERS = {
    "front": (Plate((-0.5, 0.55), (0.5, 0.45)), Plate((0.5, -0.45), (0.5, 0.55))),
    "back": (Line(((0, 1), (0, -1)), 0.012), Line(((-1, 0.1), (1, 0.1)), 0.012)),
    "deep": -1.0,
}
ARROW_BANDS = ((-0.6, -0.53), (-0.49, -0.46), (0.72, 0.8))
PISTOL_GROOVES = {
    side: (Cells((0.74 * flip, -0.06), (0.16, 0.7), (6, 1), (0.42, 1)),
           Line(((-0.9 * flip, -0.5), (0.5 * flip, -0.5)), 0.009))
    for side, flip in (("front", 1), ("back", -1))
}  # fmt: skip
PISTOL_PORT = {
    side: (Plate((0.16 * flip, 0.12), (0.14, 0.3), 0.2),)
    for side, flip in (("front", 1), ("back", -1))
}
PISTOL_RIDGES = {
    side: (*(Line(((-2, at + 2 * tilt), (2, at - 2 * tilt)), 0.009)
             for at in (-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75)
             for tilt in (0.36, -0.36)),)
    for side in ("front", "back")
}  # fmt: skip
CANNON_BANDS = ((-1.0, -0.9), (-0.5, -0.4), (0.0, 0.12), (0.5, 0.6))
BOMB_SKULL = {side: (Emblem((0, 0.06), 0.58, "skull"),) for side in ("front", "back")} | {
    "deep": 0.1
}
KEYHOLE = {
    "front": (Disc((0, 0.14), 0.28), Poly(((-0.12, 0.1), (0.12, 0.1), (0.2, -0.5), (-0.2, -0.5)))),
    "deep": 0.0,
}
RIVETS = {
    "front": tuple(Disc((0.55, at), 0.055, twice=True) for at in (-0.82, -0.52, -0.2)),
    "back": tuple(Disc((0.55, at), 0.055, twice=True) for at in (-0.82, -0.52, -0.2)),
    "deep": 0.7,
}
CRATE_NAILS = {
    side: tuple(
        Disc((u, v), 0.055)
        for u, v in ((0.88, 0.88), (0.88, -0.88), (-0.88, 0.88), (-0.88, -0.88),
                     (0.8, 0.0), (-0.8, 0.0), (0.0, 0.8), (0.0, -0.8))
    )
    for side in ("front", "back", "sides")
}  # fmt: skip
BOOK_BADGE = {"front": (Disc((0.06, 0), 0.5, 0.02), Emblem((0.06, 0), 0.38, "star")), "deep": 0.3}
BOOK_BORDER = {
    "front": (Plate((0.06, 0), (0.86, 0.88), 0.1, 0.024), Plate((0.06, 0), (0.72, 0.78), 0.3, 0.01),
              *(Disc((0.06 + 0.72 * u, 0.78 * v), 0.13) for u in (-1, 1) for v in (-1, 1))),
    "back": (Plate((-0.06, 0), (0.86, 0.88), 0.1, 0.024),),
    "deep": 0.3,
}  # fmt: skip
LIGHT_BORDER = {"front": (Plate((0, 0), (0.88, 0.95), 0.4, 0.02),), "deep": 0.2}
MAIL_SEAMS = {
    "front": (
        Plate((0, -0.35), (0.2, 0.045), 0.9),
        Disc((0, 0.12), 0.1),
        Plate((0, 0.38), (0.5, 0.06), 0.6),
    ),
    "deep": 0.0,
}
_GABLE = (
    Poly(((-0.66, -0.8), (0.66, -0.8), (0.0, 0.54))),
    *(Line(((at, -1), (at, 1)), 0.008, gap=True) for at in (-0.36, -0.12, 0.12, 0.36)),
)
WELL_GABLE = {"front": _GABLE, "back": _GABLE, "deep": 0.9}
SADDLE_FLOWERS = {
    "sides": (Emblem((0.0, -0.46), 0.44, "flower"), Emblem((0.0, 0.06), 0.3, "flower")),
    "aside": 0.6,
}
SADDLE_EDGE = {
    "sides": (Line(((-0.8, 0.2), (-0.66, -0.5), (-0.4, -0.84), (0.5, -0.84), (0.72, -0.5),
                    (0.86, 0.2)), 0.014),),
    "aside": 0.5,
}  # fmt: skip
_DOTS = tuple(
    Disc((0.5 * column + 0.25 * (row % 2) - 0.125, 0.42 * row - 0.3), 0.13)
    for row in (-1, 0, 1)
    for column in range(-2, 3)
)
GIFT_DOTS = {"front": _DOTS, "back": _DOTS, "sides": _DOTS, "deep": 0.9}
RUNES = {
    side: (Emblem((0.48, 0.0), 0.52, "lightning bolt", twice=True),) for side in ("front", "back")
} | {"deep": 0.6}
RIFLE_PORT = {
    side: (Plate((0.1 * flip, 0.3), (0.3, 0.2), 0.3), Disc((-0.66 * flip, 0.1), 0.2),
           Disc((0.72 * flip, 0.1), 0.2))
    for side, flip in (("front", 1), ("back", -1))
}  # fmt: skip
BUTT_BANDS = ((0.84, 2.0), (0.7, 0.75))
_LID = ((-0.61, -0.985), (-1.0, 0.41), (-0.66, 0.985), (0.66, 0.985), (1.0, 0.41), (0.61, -0.985))
COFFIN_NAILS = tuple((0.86 * x, 0.935 * z) for x, z in _LID)
COFFIN_SEAMS = {
    "back": (*(Line(((at, -1), (at, 1)), 0.012) for at in (-0.5, 0.0, 0.5)),
             *(Line(((-1, at), (1, at)), 0.012) for at in (-0.6, 0.42))),
    "deep": 0.3,
}  # fmt: skip
_SMALL_VEINS = (
    Line(((0, -0.3), (0.22, 0.1)), 0.009, twice=True),
    Line(((0, 0.06), (0.16, 0.4)), 0.009, twice=True),
    Line(((0.32, -0.5), (0.36, -0.06)), 0.009, twice=True),
    Line(((0.4, -0.4), (0.68, -0.36)), 0.009, twice=True),
)
SIDE_VEINS = {
    "front": _SMALL_VEINS,
    "back": (
        *_SMALL_VEINS,
        Line(((0, -1), (0, 0.72)), 0.016),
        Line(((0, -0.87), (0.74, 0.04)), 0.016, twice=True),
        Line(((0, -0.87), (0.4, -0.78)), 0.016, twice=True),
    ),
    "deep": 0.0,
}
