"""Outlines and spans of the markings of food and plants."""

from core.guidance.builtin.markings.outlines import Disc, Emblem, Plate, Poly

BASIL = {
    "top": tuple(
        Emblem(at, 0.1, "leaf")
        for at in ((0.12, 0.14), (-0.36, 0.5), (0.48, -0.4), (-0.55, -0.26), (0.2, 0.66),
                   (-0.08, -0.62), (0.66, 0.3), (-0.2, -0.05), (-0.7, 0.2))
    ),
    "deep": 0.4,
}  # fmt: skip
RIND_LABEL = {
    "back": (Disc((0, 0), 0.72), Disc((0, 0), 0.6, 0.012, gap=True),
             Emblem((0, 0.02), 0.36, "crown", gap=True)),
    "deep": 0.2,
}  # fmt: skip
CAN_BADGE = {"front": (Emblem((0, 0.1), 0.36, "star"),), "deep": 0.2}
LOAF_SCORES = {
    "top": tuple(
        Poly(((-0.7, at - 0.12), (0.0, at - 0.04), (0.7, at + 0.12), (0.0, at + 0.04)))
        for at in (-0.3, 0.1, 0.5)
    ),
    "deep": 0.0,
}
CAKE_CREAM = ((-0.6, -0.4),)
DISH_BANDS = ((0.42, 0.6),)
WRAPPER_NAME = {"front": (Emblem((0, 0), 0.42, text="CHOCO"),), "deep": 0.0}
WRAPPER_BORDER = {
    "back": (Plate((0, 0), (0.84, 0.72), 0.1, 0.014), Emblem((0, 0), 0.4, "heart")),
    "sides": (Plate((0, 0), (0.66, 0.78), 0.1, 0.014),),
}
TUB_BANDS = ((-0.5, -0.2),)
