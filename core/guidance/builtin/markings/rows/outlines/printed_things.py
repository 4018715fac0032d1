"""Outlines of what is printed on boards, cards and packs."""

import itertools
from functools import partial

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

BLACKBOARD_WRITING = {
    "front": (
        Emblem((-0.46, 0.52), 0.2, text="ABC"),
        Emblem((0.46, 0.52), 0.13, text="2+3=5"),
        Line(((-0.86, 0.14), (-0.16, 0.16)), 0.014),
        Emblem((-0.5, -0.16), 0.19, text="xyz"),
        Line(((-0.86, -0.5), (-0.2, -0.48)), 0.01),
    )
}
BLACKBOARD_DRAWING = {
    "front": (
        Plate((0.42, -0.52), (0.2, 0.28), line=0.012),
        Line(((0.16, -0.22), (0.42, 0.08), (0.68, -0.22)), 0.012),
        Plate((0.42, -0.65), (0.06, 0.15), line=0.01),
        Emblem((0.8, 0.08), 0.19, "sun"),
        Line(((0.12, -0.8), (0.9, -0.8)), 0.012),
    )
}
BLACKBOARD_SMEARS = {
    "front": (
        Plate((-0.2, -0.78), (0.6, 0.12), 0.9),
        Plate((0.1, 0.84), (0.5, 0.07), 0.9),
        Plate((-0.3, 0.14), (0.3, 0.08), 0.9),
    )
}
WHITEBOARD_WRITING = {
    "front": (
        Emblem((-0.48, 0.6), 0.135, text="IDEAS"),
        Line(((-0.84, 0.3), (-0.14, 0.31)), 0.014),
        *(Disc((-0.8, up), 0.05) for up in (0.06, -0.24, -0.54)),
        *(Line(((-0.68, up), (right, up + 0.01)), 0.014)
          for up, right in ((0.06, -0.1), (-0.24, -0.24), (-0.54, -0.14))),
    )
}  # fmt: skip
WHITEBOARD_GRAPH = {
    "front": (
        Line(((0.14, 0.6), (0.14, -0.6), (0.86, -0.6)), 0.014),
        Line(((0.2, -0.4), (0.38, -0.08), (0.52, -0.2), (0.82, 0.42)), 0.018),
        Line(((0.67, 0.38), (0.82, 0.42), (0.8, 0.16)), 0.016),
    )
}
WHITEBOARD_NOTES = {"front": (Plate((0.4, 0.66), (0.1, 0.14)), Plate((0.68, 0.7), (0.1, 0.14)))}
BILLBOARD_LETTERS = {
    "front": (Emblem((0.3, 0.5), 0.21, text="FRESH"), Emblem((0.3, -0.5), 0.21, text="JUICE")),
}
BILLBOARD_SUN = {"front": (Emblem((-0.58, 0.0), 0.52, "sun"),)}
BILLBOARD_BORDER = {"front": (Plate((0, 0), (0.94, 0.9), line=0.022),), "deep": 0.0}
STREET_LETTERS = {
    "front": (Emblem((0, 0.44), 0.22, text="MAIN"), Emblem((0, -0.44), 0.22, text="STREET"))
}
# The end of the pole that comes through a board is as the board is.
ON_BOARD = partial(laid, front=(Plate((0, 0), (0.6, 0.6)),), deep=0.7)
STREET_BORDER = {"front": (Plate((0, 0), (0.92, 0.87), 0.25, 0.018),), "deep": 0.0}
POSTER_LETTERS = {
    "front": (
        Emblem((0, 0.76), 0.136, text="WANTED"),
        Emblem((0, 0.56), 0.072, text="DEAD OR ALIVE"),
        Emblem((0, -0.5), 0.1, text="REWARD"),
        Emblem((0, -0.75), 0.17, text="$5,000"),
    )
}
POSTER_PICTURE = {"front": (Plate((0, 0.06), (0.66, 0.38)),)}
POSTER_FACE = {
    "front": (
        Disc((0, 0.06), 0.3),
        Plate((0, -0.24), (0.44, 0.07), 0.5),
        Disc((-0.12, 0.1), 0.05, gap=True),
        Disc((0.12, 0.1), 0.05, gap=True),
        Line(((-0.14, -0.02), (0.14, -0.02)), 0.012, gap=True),
    )
}
POSTER_HAT = {
    "front": (
        Plate((0, 0.19), (0.5, 0.035), 0.9),
        Poly(((-0.26, 0.2), (0.26, 0.2), (0.2, 0.38), (0.0, 0.34), (-0.2, 0.38))),
    )
}
POSTER_BORDER = {"front": (Plate((0, 0), (0.92, 0.95), line=0.012),), "deep": 0.0}
NEWS_LETTERS = {
    "front": (
        Emblem((0, 0.83), 0.116, text="THE NEWS"),
        Line(((-0.88, 0.7), (0.88, 0.7)), 0.008),
        Emblem((0, 0.55), 0.116, text="BIG STORY"),
    )
}
NEWS_PICTURE = {"front": (Plate((-0.4, 0.14), (0.46, 0.24)),)}
NEWS_HILLS = {
    "front": (
        Poly(((-0.86, -0.1), (-0.62, 0.2), (-0.44, 0.02), (-0.24, 0.28), (0.06, -0.1))),
        Disc((-0.66, 0.27), 0.09),
    )
}
NEWS_LINES = {
    "front": (
        Cells((0.48, 0.14), (0.38, 0.25), (1, 8), (1, 0.45)),
        Cells((-0.45, -0.56), (0.41, 0.36), (1, 11), (1, 0.45)),
        Cells((0.48, -0.56), (0.38, 0.36), (1, 11), (1, 0.45)),
    ),
    "back": (
        Cells((-0.45, 0.0), (0.41, 0.9), (1, 27), (1, 0.45)),
        Cells((0.46, 0.0), (0.4, 0.9), (1, 27), (1, 0.45)),
    ),
}


def dashes(places: tuple[Pair, ...], share: float, wide: float) -> tuple[Outline, ...]:
    """A stroke from each place on the way to the next one."""
    return tuple(
        Line(((x, y), (x + share * (u - x), y + share * (v - y))), wide)
        for (x, y), (u, v) in itertools.pairwise(places)
    )


_WAY = ((-0.7, -0.5), (-0.56, -0.42), (-0.44, -0.28), (-0.34, -0.1), (-0.2, 0.04), (-0.04, 0.08),
        (0.1, 0.0), (0.2, -0.14), (0.33, -0.24), (0.46, -0.2))  # fmt: skip
MAP_PATH = {"front": dashes(_WAY, 0.6, 0.018)}
MAP_CROSS = {
    "front": (
        Line(((0.5, -0.3), (0.64, -0.04)), 0.026),
        Line(((0.5, -0.04), (0.64, -0.3)), 0.026),
    )
}
_MAIN = ((-0.84, -0.56), (-0.62, -0.74), (-0.3, -0.6), (0.02, -0.66), (0.3, -0.52), (0.62, -0.6),
         (0.84, -0.34), (0.78, -0.02), (0.56, 0.16), (0.36, 0.1), (0.14, 0.34), (-0.14, 0.42),
         (-0.36, 0.3), (-0.42, 0.06), (-0.66, -0.1), (-0.86, -0.3))  # fmt: skip
_SMALL = ((-0.82, 0.4), (-0.66, 0.3), (-0.52, 0.42), (-0.56, 0.64), (-0.74, 0.7), (-0.84, 0.58))


def _grown(corners: tuple[Pair, ...], share: float) -> tuple[Pair, ...]:
    """Farther from their middle."""
    x, y = (sum(one) / len(corners) for one in zip(*corners, strict=True))
    return tuple((x + share * (u - x), y + share * (v - y)) for u, v in corners)


MAP_ISLANDS = {"front": (Poly(_MAIN), Poly(_SMALL))}
MAP_SHORES = {"front": (Poly(_grown(_MAIN, 1.06)), Poly(_grown(_SMALL, 1.16)))}
MAP_MOUNTAINS = {
    "front": tuple(
        Poly(((x - 0.07, y), (x + 0.07, y), (x, y + 0.2)))
        for x, y in ((-0.12, 0.14), (-0.02, 0.12), (0.3, -0.46), (-0.5, -0.52), (-0.68, 0.42))
    )
}
MAP_COMPASS = {
    "front": (
        Disc((0.66, 0.56), 0.2, 0.012),
        Poly(((0.66, 0.86), (0.69, 0.6), (0.86, 0.56), (0.69, 0.52), (0.66, 0.26), (0.63, 0.52),
              (0.46, 0.56), (0.63, 0.6))),
    )
}  # fmt: skip
CARD_CORNER = (Emblem((-0.72, 0.6), 0.13, "heart"), Emblem((-0.72, 0.8), 0.17, text="A"))
CARD_HEART = (Emblem((0, 0), 0.5, "heart"),)
CARD_BACK = {"back": (Plate((0, 0), (0.84, 0.91), 0.15),)}
CARD_LATTICE = {
    "back": (
        Plate((0, 0), (0.74, 0.855), 0.1, 0.008),
        *(Line(((-1.6 + at, -1), (1.6 + at, 1)), 0.007) for at in
          (-1.6, -1.2, -0.8, -0.4, 0.0, 0.4, 0.8, 1.2, 1.6)),
        *(Line(((-1.6 + at, 1), (1.6 + at, -1)), 0.007) for at in
          (-1.6, -1.2, -0.8, -0.4, 0.0, 0.4, 0.8, 1.2, 1.6)),
    )
}  # fmt: skip
TAROT_SUN = {
    "front": (Emblem((0, 0.14), 0.62, "sun"), Disc((0, 0.14), 0.36, 0.012, gap=True)),
    "back": (Emblem((0, 0), 0.5, "moon"),),
}
_STARS = ((-0.62, 0.72), (0.62, 0.72), (0.0, 0.8), (-0.66, -0.4), (0.66, -0.4), (0.0, -0.44))
TAROT_STARS = {
    "front": tuple(Emblem(at, 0.09, "star") for at in _STARS),
    "back": tuple(Emblem((x, y * 0.9), 0.1, "star") for x, y in _STARS),
}
TAROT_BANNER = {"front": (Plate((0, -0.74), (0.72, 0.1)),)}
TAROT_LETTERS = {"front": (Emblem((0, -0.74), 0.1, text="THE SUN"),)}
TAROT_BORDER = {
    side: (Plate((0, 0), (0.9, 0.94), line=0.02), Plate((0, 0), (0.8, 0.885), line=0.007))
    for side in ("front", "back")
}
PASSPORT_LETTERS = {
    "front": (Emblem((0, 0.72), 0.1, text="PASSPORT"), Plate((0, -0.72), (0.16, 0.06), 0.5, 0.012),
              Line(((-0.3, -0.72), (0.3, -0.72)), 0.008))
}  # fmt: skip
PASSPORT_EMBLEM = {
    "front": (Disc((0, 0.02), 0.46, 0.016), Emblem((0, 0.02), 0.32, "crown"),
              Disc((0, 0.02), 0.53, 0.007))
}  # fmt: skip
CREDIT_CHIP = {"front": (Plate((-0.62, 0.2), (0.15, 0.2), 0.3),)}
CREDIT_LINES = {
    "front": (
        Plate((-0.62, 0.2), (0.06, 0.1), 0.2, 0.006),
        Line(((-0.77, 0.2), (-0.68, 0.2)), 0.006),
        Line(((-0.56, 0.2), (-0.47, 0.2)), 0.006),
        Line(((-0.62, 0.3), (-0.62, 0.4)), 0.006),
        Line(((-0.62, 0.1), (-0.62, 0.0)), 0.006),
    )
}
CREDIT_DIGITS = {
    "front": (
        Emblem((0, -0.22), 0.093, text="1234 5678 9012 3456"),
        Emblem((-0.46, -0.68), 0.076, text="A. BLENDER"),
    )
}
CREDIT_REDS = {"front": (Disc((0.58, -0.64), 0.2),)}
CREDIT_ORANGES = {"front": (Disc((0.76, -0.64), 0.2),)}
CREDIT_BAND = {"back": (Plate((0, 0.5), (1.1, 0.19)),)}
CREDIT_WAVES = {"front": (Disc((1.0, 1.5), 1.5), Disc((1.0, 1.7), 1.3, gap=True))}
PLATE_LETTERS = {"front": (Emblem((0, -0.08), 0.225, text="F3D 123"),)}
PLATE_BORDER = {"front": (Plate((0, 0), (0.93, 0.89), 0.2, 0.022),), "deep": 0.0}
PLATE_BOLTS = {
    "front": (Disc((0.6, 0.68), 0.075, twice=True), Disc((0.6, -0.68), 0.075, twice=True))
}
PLATE_SUN = {"front": (Emblem((0, 0.62), 0.16, "star"),)}
CIRCUIT_CHIPS = {
    "front": (
        Plate((-0.28, 0.12), (0.2, 0.3)),
        Plate((0.46, -0.2), (0.26, 0.13)),
        Plate((0.62, 0.5), (0.12, 0.18)),
        Plate((-0.76, -0.4), (0.1, 0.2)),
    )
}
CIRCUIT_PINS = {
    "front": (
        Cells((-0.28, 0.12), (0.26, 0.28), (1, 7), (1, 0.5)),
        Cells((-0.28, 0.12), (0.18, 0.39), (7, 1), (0.5, 1)),
        Cells((0.46, -0.2), (0.24, 0.22), (9, 1), (0.5, 1)),
        Cells((0.62, 0.5), (0.17, 0.16), (1, 4), (1, 0.5)),
        Cells((-0.76, -0.4), (0.15, 0.18), (1, 4), (1, 0.5)),
    )
}
CIRCUIT_CAPACITORS = {
    "front": (
        Disc((0.14, 0.6), 0.12),
        Disc((0.3, 0.6), 0.12),
        Disc((-0.72, 0.56), 0.15),
        Disc((0.14, -0.5), 0.09),
    )
}
_TRACES = (
    ((-0.06, 0.3), (0.06, 0.2), (0.42, 0.2), (0.48, 0.42)),
    ((-0.06, 0.12), (0.1, -0.02), (0.3, -0.02)),
    ((-0.06, 0.0), (0.04, -0.14), (0.18, -0.14)),
    ((-0.5, 0.24), (-0.62, 0.34), (-0.62, 0.82), (-0.2, 0.82)),
    ((-0.5, 0.0), (-0.6, -0.1), (-0.6, -0.26)),
    ((-0.4, -0.28), (-0.4, -0.5), (-0.46, -0.58), (-0.46, -0.84)),
    ((-0.28, -0.28), (-0.28, -0.84)),
    ((-0.16, -0.28), (-0.16, -0.46), (-0.08, -0.56), (-0.08, -0.84)),
    ((0.34, -0.44), (0.34, -0.6), (0.2, -0.72), (0.2, -0.84)),
    ((0.54, -0.44), (0.54, -0.84)),
    ((0.82, 0.5), (0.9, 0.4), (0.9, -0.4), (0.74, -0.6)),
    ((-0.9, 0.84), (-0.9, -0.1), (-0.82, -0.18)),
)
CIRCUIT_LINES = {
    "front": (
        *(Line(way, 0.009) for way in _TRACES),
        *(Disc(way[-1], 0.032) for way in _TRACES),
        *(Disc((0.92, up), 0.06, 0.014, twice=True) for up in (0.86, -0.8)),
    ),
    "back": tuple(Line(tuple((-x, y) for x, y in way), 0.009) for way in _TRACES),
}  # fmt: skip
CIRCUIT_CONTACTS = {
    side: (Cells((0, -0.93), (0.62, 0.1), (16, 1), (0.6, 1)),) for side in ("front", "back")
} | {"deep": 0.1}
_FIVE = ((-0.45, 0.78), (0.45, 0.78), (0.0, 0.5), (-0.45, 0.22), (0.45, 0.22))
_THREE = ((-0.45, -0.22), (0.0, -0.5), (0.45, -0.78))
DOMINO_PIPS = {"front": tuple(Disc(at, 0.17) for at in (*_FIVE, *_THREE)), "deep": 0.3}
DOMINO_LINE = {"front": (Plate((0, 0), (0.78, 0.014), 0.9),), "deep": 0.3}
_FOUR = tuple((x, y) for x in (-0.45, 0.45) for y in (-0.58, 0.58))
MAHJONG_GREENS = {
    "front": (*(Disc(at, 0.24, 0.03) for at in _FOUR), *(Disc(at, 0.07) for at in _FOUR))
}
MAHJONG_REDS = {
    "front": (
        Disc((0, 0), 0.27, 0.035),
        Disc((0, 0), 0.12),
        *(Disc(at, 0.13, 0.015) for at in _FOUR),
    )
}
_RUNES = (
    (((-0.5, -1), (-0.5, 1)), ((-0.5, 0.9), (0.5, 0.4)), ((-0.5, 0.2), (0.5, -0.3))),
    (((-0.5, -1), (-0.5, 1), (0.4, 0.5), (-0.5, 0.0), (0.5, -1)),),
    (((0, -1), (0, 1)), ((-0.5, 0.4), (0, 1), (0.5, 0.4))),
    (((-0.5, 1), (0.5, 0.3), (-0.5, -0.3), (0.5, -1)),),
    (((-0.5, -1), (-0.5, 1), (0.5, 0.2)), ((0.5, 1), (0.5, -1))),
    (((-0.5, -1), (0.5, 1)), ((0.5, -1), (-0.5, 1))),
    (((0, -1), (0, 1)), ((-0.5, 0.5), (0.5, -0.1))),
    (((-0.5, 1), (-0.5, -1)), ((-0.5, 0.5), (0.45, 0.0), (-0.5, -0.5))),
)


def runes(columns: int, rows: int, at: Pair, pitch: Pair, size: Pair) -> tuple[Outline, ...]:
    """Signs in rows, the middle of all at a place; ``size``: of each half its sides."""
    found: list[Outline] = []
    for row in range(rows):
        for column in range(columns):
            x = at[0] + (column - (columns - 1) / 2) * pitch[0]
            y = at[1] + ((rows - 1) / 2 - row) * pitch[1]
            for way in _RUNES[(3 * row + column * 2 + row * column) % len(_RUNES)]:
                places = tuple((x + u * size[0], y + v * size[1]) for u, v in way)
                found.append(Line(places, 0.016))
    return tuple(found)


TABLET_RUNES = {"front": runes(4, 5, (0, -0.12), (0.36, 0.27), (0.22, 0.1)), "deep": 0.3}
TABLET_CRACKS = {
    "front": (
        Line(((0.98, 0.34), (0.82, 0.24), (0.86, 0.12), (0.72, 0.02)), 0.014),
        Line(((-1, -0.72), (-0.84, -0.66), (-0.78, -0.78), (-0.62, -0.74)), 0.014),
    ),
    "back": (Line(((-0.98, 0.34), (-0.5, 0.2), (-0.3, 0.3), (0.1, 0.0), (0.2, -0.3)), 0.014),),
    "deep": 0.3,
}
FLOPPY_SHUTTER = {"top": (Plate((0.08, 0.7), (0.46, 0.28), 0.05),)}
FLOPPY_SLOTS = {"top": (Plate((0.26, 0.7), (0.13, 0.2), 0.1),)}
FLOPPY_LABEL = {"top": (Plate((0, -0.4), (0.72, 0.54), 0.08),)}
FLOPPY_STRIPE = {"top": (Plate((0, 0.07), (0.72, 0.07), 0.08),)}
FLOPPY_LINES = {
    "top": tuple(Line(((-0.6, up), (0.6, up)), 0.009) for up in (-0.16, -0.36, -0.56, -0.76))
}
PIZZA_CRUST = {"top": (Disc((0, 0.16), 0.62),)}
PIZZA_CHEESE = {"top": (Disc((0, 0.16), 0.53),)}
PIZZA_SALAMI = {
    "top": tuple(
        Disc((x, 0.16 + y), 0.1)
        for x, y in ((0.0, 0.05), (0.3, 0.14), (-0.28, 0.2), (0.12, -0.28), (-0.24, -0.16),
                     (0.02, 0.36), (0.36, -0.14))
    )
}  # fmt: skip
PIZZA_LETTERS = {"top": (Emblem((0, -0.7), 0.19, text="PIZZA"),)}
PIZZA_BORDER = {"top": (Plate((0, 0), (0.93, 0.93), 0.08, 0.018),), "deep": 0.0}
PIZZA_SEAMS = {
    side: (Line(((-1.1, 0.3), (1.1, 0.3)), 0.011),) for side in ("front", "sides", "back")
}
CEREAL_BOWL = (
    Poly(((-0.62, -0.36), (0.62, -0.36), (0.5, -0.58), (0.3, -0.72), (-0.3, -0.72), (-0.5, -0.58))),
)
CEREAL_MILK = (Plate((0, -0.33), (0.62, 0.07), 1.0),)
_LOOPS = ((-0.42, -0.28), (-0.2, -0.22), (0.04, -0.27), (0.26, -0.21), (0.46, -0.29),
          (-0.06, -0.12), (0.2, -0.02), (-0.3, -0.04), (0.02, 0.1))  # fmt: skip
CEREAL_RINGS = tuple(Disc(at, 0.1, 0.026) for at in _LOOPS)
CEREAL_LETTERS = (Emblem((0, 0.62), 0.165, text="LOOPS"), Emblem((0, 0.4), 0.08, text="CRUNCHY!"))
CEREAL_BURST = (
    Poly(tuple(
        (0.0 + (0.96 if k % 2 == 0 else 0.82) * x, 0.54 + (0.42 if k % 2 == 0 else 0.34) * y)
        for k, (x, y) in enumerate(
            ((1, 0), (0.97, 0.26), (0.87, 0.5), (0.71, 0.71), (0.5, 0.87), (0.26, 0.97), (0, 1),
             (-0.26, 0.97), (-0.5, 0.87), (-0.71, 0.71), (-0.87, 0.5), (-0.97, 0.26), (-1, 0),
             (-0.97, -0.26), (-0.87, -0.5), (-0.71, -0.71), (-0.5, -0.87), (-0.26, -0.97),
             (0, -1), (0.26, -0.97), (0.5, -0.87), (0.71, -0.71), (0.87, -0.5), (0.97, -0.26)))
    )),
)  # fmt: skip
CEREAL_TABLE = (Plate((0, -0.86), (1.1, 0.16)),)
