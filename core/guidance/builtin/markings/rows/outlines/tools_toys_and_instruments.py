"""Outlines and spans of the markings of tools toys and instruments."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate, Poly

HAMMER_RIDGES = tuple((-0.86 + 0.09 * k, -0.82 + 0.09 * k) for k in range(7))
HAMMER_BANDS = ((-0.94, -0.86), (-0.56, -0.48))
HANDLE_WRAPS = tuple((-0.88 + 0.12 * k, -0.8 + 0.12 * k) for k in range(5))
SAW_NAME = {
    side: (Emblem((0.16 * sign, 0.12), 0.3, text="F3D"),
           Line(((-0.7 * sign, 0.06), (-0.36 * sign, 0.1)), 0.012))
    for side, sign in (("front", 1), ("back", -1))
}  # fmt: skip
TOOLS = {"text": "TOOLS", "high": 0.22, "bold": 0.06, "at": -0.42}
PENCIL_RINGS = ((-0.95, -0.91), (-0.89, -0.87))
FERRULE_BANDS = ((-0.7, -0.4), (0.4, 0.7))
KNIFE_EDGE = ((-1.3, -1.0), (-0.55, -1.0), (-0.5, -0.1), (-0.25, 0.4), (0.3, 0.9), (0.3, 1.2),
              (-1.3, 1.2))  # fmt: skip
TELESCOPE_RINGS = ((0.16, 0.2), (0.24, 0.26), (0.74, 0.78))
TELESCOPE_STARS = {"sides": (Emblem((-0.44, 0.42), 0.2, "star"),), "aside": 0.2}
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
GUITAR_GUARD = {
    "front": (Poly(((0.22, -0.07), (0.45, 0.11), (0.64, -0.03), (0.73, -0.26), (0.59, -0.44),
                    (0.39, -0.4), (0.27, -0.24))),),
    "deep": 0.0,
}  # fmt: skip
DRUM_BADGE = {"front": (Disc((0, 0), 0.5), Emblem((0, 0), 0.36, "star", gap=True)), "deep": 0.3}
BADGE_STAR = {"front": (Emblem((0, 0), 0.66, "star"),), "deep": 0.0}
