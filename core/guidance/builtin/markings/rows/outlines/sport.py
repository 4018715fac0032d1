"""Outlines and spans of the markings of sport."""

from core.guidance.builtin.markings.outlines import Disc, Emblem, Line, Plate, Poly

_SIGHTS = (
    *(Disc((at, 0.91), 0.028, twice=True) for at in (0.22, 0.46, 0.7)),
    *(Disc((at, -0.91), 0.028, twice=True) for at in (0.22, 0.46, 0.7)),
    *(Disc((0.945, at), 0.028, twice=True) for at in (-0.4, 0.0, 0.4)),
)
POOL_SIGHTS = {"top": _SIGHTS, "deep": 0.3}
POOL_LINES = {
    "top": (Line(((-0.5, -0.84), (-0.5, 0.84)), 0.009), Disc((0.5, 0), 0.03)),
    "deep": -2.0,
}
BOXING_STAR = {
    "front": (Emblem((-0.16, 0.2), 0.36, "star"),),
    "back": (Emblem((0, 0.1), 0.36, "star"),),
    "deep": 0.2,
}
BAND_TEXT = {
    "front": (Emblem((0, 0), 0.7, text="BOX"),),
    "back": (Emblem((0, 0), 0.7, text="BOX"),),
    "deep": 0.3,
}
SKATE_STAR = {"sides": (Emblem((0.44, 0.3), 0.36, "star"),), "aside": 0.45}
SKATE_STRIPES = {
    "sides": tuple(
        Poly(((at, -0.9), (at + 0.14, -0.9), (at + 0.44, 0.36), (at + 0.3, 0.36)))
        for at in (-0.42, -0.12)
    ),
    "aside": 0.2,
}
MAT_FLOWER = {
    "top": (Emblem((0, 0), 0.62, "flower"), Disc((0.62, 0), 0.16, twice=True),
            Disc((0.36, 0), 0.1, twice=True)),
    "deep": 0.0,
}  # fmt: skip
MAT_BORDER = {"top": (Plate((0, 0), (0.95, 0.86), line=0.012),), "deep": 0.0}
