"""Markings of balls and other sports equipment."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import badges, balls, bands, lettering, rings, tiles
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import sport as own

EIGHT = (0.25, -1.0, 0.45)  # where a billiard ball's number is
HOLES = ((-0.1, -0.75, 0.75), (0.14, -0.75, 0.8), (0.03, -0.95, 0.5))  # a bowling ball's
BOARD_BANDS = ((0.26, 0.42), (0.45, 0.475), (-0.42, -0.26), (-0.475, -0.45))  # a surfboard's
SPORT: Rows = {
    "yoga mat": {
        "flowers": Marking("mat", partial(outlines.laid, **own.MAT_FLOWER)),
        "border": Marking("mat", partial(outlines.laid, **own.MAT_BORDER)),
    },
    "soccer ball": {
        "patches": Marking("ball", balls.pentagons),
        "seams": Marking("ball", balls.football_seams),
    },
    "beach ball": {
        name: Marking("body", partial(balls.gores, number=2 * k))
        for k, name in enumerate(("reds", "yellows", "blues"))
    },
    "tennis ball": {"seam": Marking("body", balls.tennis_seam)},
    "baseball": {"stitches": Marking("body", balls.baseball_stitches)},
    "volleyball": {
        "seams": Marking("body", balls.volleyball_seams),
        "bands": Marking("body", balls.volleyball_bands),
    },
    "golf ball": {"dimples": Marking("body", balls.dimples)},
    "bowling ball": {"holes": Marking("body", partial(balls.caps, wide=0.1, ways=HOLES))},
    "billiard ball": {
        "disc": Marking("body", partial(balls.cap, wide=0.46, way=EIGHT)),
        "number": Marking("disc", partial(lettering.number_on, text="8", way=EIGHT, high=0.48)),
    },
    "target": {
        name: Marking("board", partial(rings.disc, radius=radius))
        for name, radius in (("golds", 0.19), ("reds", 0.39), ("blues", 0.59), ("blacks", 0.79))
    },
    "dartboard": {
        "reds": Marking("board", rings.dart_reds),
        "greens": Marking("board", rings.dart_greens),
        "sectors": Marking("board", rings.pale_sectors),
    },
    "pool table": {
        "sights": Marking("frame", partial(outlines.laid, **own.POOL_SIGHTS)),
        "lines": Marking("cloth", partial(outlines.laid, **own.POOL_LINES)),
    },
    "chessboard": {"checks": Marking("squares", tiles.checks)},
    "boxing glove": {
        "star": Marking("body", partial(outlines.laid, **own.BOXING_STAR)),
        "letters": Marking("band", partial(outlines.laid, **own.BAND_TEXT)),
    },
    "kettlebell": {
        "badge": Marking(
            "body", partial(balls.at_top, marks=partial(badges.badge, radius=0.42, shape="star"))
        )
    },
    "roller skate": {
        "star": Marking("body", partial(outlines.laid, **own.SKATE_STAR)),
        "stripes": Marking("body", partial(outlines.laid, **own.SKATE_STRIPES)),
    },
    "surfboard": {
        "stripe": Marking("board", partial(bands.bands, axis=0, low=-0.16, high=0.16)),
        "bands": Marking("board", partial(bands.belts, spans=BOARD_BANDS)),
    },
    "yo-yo": {
        "stars": Marking("faces", partial(badges.emblem, shape="star", size=0.54)),
        "faces": Marking("discs", partial(badges.emblem, shape="circle", size=0.74)),
    },
}
