"""Outlines and spans of the markings of clothes."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate

SCARF_LINES = ((0.78, 0.84), (0.5, 0.56), (0.2, 0.26))
GLOVE_MOTIF = {
    "front": (Emblem((-0.12, -0.14), 0.42, "snowflake"),),
    "back": (Emblem((0.12, -0.14), 0.42, "snowflake"),),
    "deep": -1.0,
}
CUFF_RIBS = {
    side: (Cells((0, 0), (1.0, 1.2), (11, 1), (0.36, 1)),) for side in ("front", "back")
} | {"deep": 0.3}
SHERIFF_STAR = {
    "front": (Emblem((0, 0.34), 0.26, "star"),),
    "deep": 0.0,
}
CHIN_VENTS = {
    "front": (
        Cells((0, -0.62), (0.22, 0.1), (1, 2), (1, 0.5), 0.9),
        Plate((0.42, -0.58), (0.09, 0.07), 0.8, twice=True),
    ),
    "deep": -1.0,
}
BREATHS = {
    "front": (Cells((0.45, -0.42), (0.2, 0.2), (3, 3), (0.5, 0.5), 0.95, twice=True),),
    "deep": 0.0,
}
POCKET_BADGE = {"front": (Emblem((0, -0.16), 0.42, "star"),), "deep": 0.2}
POCKET_ZIPS = {
    "front": (Line(((-0.74, -0.7), (-0.74, 0.42), (-0.6, 0.56), (0.6, 0.56), (0.74, 0.42),
                    (0.74, -0.7)), 0.014),),
    "deep": 0.0,
}  # fmt: skip
FLAP_PIPING = {
    "front": (Line(((-0.86, 1.2), (-0.86, -0.42), (0, -0.78), (0.86, -0.42), (0.86, 1.2)), 0.014),),
    "deep": -1.0,
}
STICKERS = {
    "front": (
        Emblem((-0.06, 0.3), 0.24, "star"),
        Disc((0.16, -0.28), 0.22),
        Emblem((0.16, -0.28), 0.15, "heart", gap=True),
        Plate((-0.18, -0.5), (0.1, 0.16), 0.2),
    ),
    "back": (Disc((0, 0), 0.34), Emblem((0, 0), 0.24, "sun", gap=True)),
    "deep": 0.6,
}
STITCHED = {side: (Plate((0, 0.0), (0.86, 0.82), 0.3, 0.01),) for side in ("front", "back")}
RING_GROOVES = ((-0.7, -0.54), (0.54, 0.7))
RIBBON_EDGES = {side: (Plate((0.84, 0), (0.07, 3), twice=True),) for side in ("front", "back")} | {
    "deep": -1.0
}
