"""Outlines and spans of the markings of animals."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line

TEDDY_MOUTH = {
    "front": (
        Line(((0, 0.3), (0, 0.21)), 0.011),
        Line(((0, 0.21), (0.05, 0.17), (0.11, 0.19)), 0.011, twice=True),
    ),
    "deep": 0.0,
}
TEDDY_PAWS = {"front": (Emblem((0.48, -0.745), 0.11, "paw print", twice=True),), "deep": 0.6}
TEDDY_STITCHES = {
    "front": (Cells((0, -0.36), (0.008, 0.24), (1, 7), (1, 0.5)),
              Cells((0, -0.36), (0.04, 0.24), (1, 7), (1, 0.16))),
    "deep": 0.0,
}  # fmt: skip
TEDDY_EARS = {"front": (Disc((0.41, 0.82), 0.125, twice=True),), "deep": -0.4}
