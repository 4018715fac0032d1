"""Markings of props, arms, and things of fantasy."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    balls,
    bands,
    dials,
    lattices,
    lettering,
    lines,
    planks,
    stripes,
    studs,
    tiles,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.outlines import Line
from core.guidance.builtin.markings.rows.outlines import props_and_arms as own

SKULL_TEETH = tuple(Line(((0.14 * k, -0.82), (0.14 * k, -0.44))) for k in range(-2, 3))
SKULL_CRACKS = (
    Line(((0.3, 0.95), (0.42, 0.74), (0.3, 0.62), (0.4, 0.44)), 0.016),
    Line(((0.42, 0.74), (0.56, 0.66)), 0.013),
)
SARCOPHAGUS_BANDS = ((-0.86, -0.68), (-0.5, -0.34), (-0.16, -0.02))
SCRIPT = [0.52 - 0.115 * k for k in range(7)]  # of a scroll
BAUBLE_BAND = partial(bands.belt, low=-0.17, high=0.17)
BAUBLE_EDGES = partial(bands.belts, spans=((0.17, 0.23), (-0.23, -0.17)))
BAUBLE_STARS = partial(
    badges.scattered, shape="star", steep=1.3, places=[(45 * k, 0.6, 0.2) for k in range(8)]
)
BAUBLE_DOTS = partial(
    badges.scattered,
    shape="circle",
    steep=1.2,
    places=[(22.5 * k + 11, -0.38 - 0.24 * (k % 2), 0.075) for k in range(16)]
    + [(45 * k + 22.5, 0.45, 0.06) for k in range(8)],
)
PROPS_AND_ARMS: Rows = {
    "sword": {
        "fuller": Marking("blade", partial(outlines.laid, **own.FULLER)),
        "wraps": Marking("grip", partial(bands.belts, spans=own.GRIP_WRAPS)),
    },
    "shield": {"quarters": Marking("plate", partial(outlines.laid, **own.QUARTERS))},
    "arrow": {"bands": Marking("shaft", partial(bands.belts, spans=own.ARROW_BANDS))},
    "pistol": {
        "grooves": Marking("barrel", partial(outlines.laid, **own.PISTOL_GROOVES)),
        "port": Marking("barrel", partial(outlines.laid, **own.PISTOL_PORT)),
        "ridges": Marking("grip", partial(outlines.laid, **own.PISTOL_RIDGES)),
    },
    "cannon": {
        "bands": Marking("barrel", partial(bands.belts, spans=own.CANNON_BANDS, axis=1)),
    },
    "bomb": {
        "skull": Marking("body", partial(outlines.laid, **own.BOMB_SKULL)),
    },
    "chest": {
        "keyhole": Marking("lock", partial(outlines.laid, **own.KEYHOLE)),
        "rivets": Marking("bands", partial(outlines.laid, **own.RIVETS)),
        "seams": Marking("body", partial(planks.planks, count=4), "wooden"),
    },
    "open chest": {
        "keyhole": Marking("lock", partial(outlines.laid, **own.KEYHOLE)),
        "seams": Marking("body", partial(planks.planks, count=4), "wooden"),
    },
    "barrel": {"seams": Marking("body", planks.staves, "wooden")},
    "crate": {
        "nails": Marking("frame", partial(outlines.laid, **own.CRATE_NAILS)),
        "seams": Marking("planks", partial(planks.planks, count=6), "wooden"),
    },
    "coin": {"beads": Marking("face", partial(studs.beads, radius=0.72, size=0.035, count=28))},
    "book": {
        "badge": Marking("cover", partial(outlines.laid, **own.BOOK_BADGE), by="pages"),
        "border": Marking("cover", partial(outlines.laid, **own.BOOK_BORDER), by="pages"),
        "lines": Marking("pages", partial(planks.planks, count=7, axis=1)),
    },
    "scroll": {"letters": Marking("paper", partial(lines.ruled, lines=SCRIPT, ends=(-0.52, 0.5)))},
    "skull": {
        "teeth": Marking("bone", partial(outlines.laid, front=SKULL_TEETH, deep=0.5)),
        "cracks": Marking("bone", partial(outlines.laid, front=SKULL_CRACKS, deep=0.2)),
    },
    "tombstone": {"letters": Marking("slab", lettering.epitaph)},
    "sarcophagus": {
        "bands": Marking("body", partial(bands.belts, spans=SARCOPHAGUS_BANDS)),
    },
    "traffic light": {
        "border": Marking("body", partial(outlines.laid, **own.LIGHT_BORDER)),
    },
    "stop sign": {"letters": Marking("plate", partial(lettering.lettered, text="STOP", high=0.4))},
    "mailbox": {
        "letters": Marking(
            "box", partial(lettering.on_sides, text="MAIL", high=0.3, at=(0.36, -0.12))
        ),
        "slots": Marking("door", partial(outlines.laid, **own.MAIL_SEAMS)),
    },
    "fence": {"nails": Marking("pickets", partial(studs.picket_nails, heights=(-0.5, 0.44)))},
    "well": {
        "boards": Marking("roof", partial(outlines.laid, **own.WELL_GABLE)),
        "seams": Marking("roof", partial(tiles.tiles, axis=1)),
        "rope": Marking("posts", partial(lines.coil, reach=0.4)),
    },
    "tent": {"trim": Marking("canvas", bands.tent_hems)},
    "saddle": {
        "flowers": Marking("flaps", partial(outlines.laid, **own.SADDLE_FLOWERS)),
        "stitches": Marking("skirt", partial(outlines.laid, **own.SADDLE_EDGE)),
    },
    "engine": {
        "pleats": Marking("filter", partial(lines.flutes, count=26, fraction=0.4, high=0.9)),
    },
    "gift": {
        "dots": Marking("box", partial(outlines.laid, **own.GIFT_DOTS)),
    },
    "christmas bauble": {
        "band": Marking("ball", partial(balls.at_top, marks=BAUBLE_BAND)),
        "edges": Marking("ball", partial(balls.at_top, marks=BAUBLE_EDGES)),
        "stars": Marking("ball", partial(balls.at_top, marks=BAUBLE_STARS)),
        "dots": Marking("ball", partial(balls.at_top, marks=BAUBLE_DOTS)),
    },
    "basket": {"weave": Marking("body", lattices.weave)},
    "umbrella": {"panels": Marking("canopy", partial(stripes.sectors, count=8))},
    "poker chip": {"spots": Marking("rim", stripes.edge_spots)},
    "war hammer": {"runes": Marking("head", partial(outlines.laid, **own.RUNES))},
    "rifle": {
        "port": Marking("body", partial(outlines.laid, **own.RIFLE_PORT)),
        "bands": Marking("stock", partial(bands.belts, spans=own.BUTT_BANDS, axis=0)),
    },
    "ray gun": {
        "window": Marking("body", partial(balls.caps, wide=0.4, ways=((0, -1, 0.1), (0, 1, 0.1))))
    },
    "compass": {"marks": Marking("dial", partial(dials.rose, radius=0.9))},
    "coffin": {
        "nails": Marking(
            "lid", partial(studs.nailed, corners=own.COFFIN_NAILS, count=5, size=0.055)
        ),
        "seams": Marking("edge", partial(outlines.laid, **own.COFFIN_SEAMS)),
    },
    "feather": {"barbs": Marking("vane", partial(stripes.slanted, pitch=0.09))},
    "leaf": {"side veins": Marking("blade", partial(outlines.laid, **own.SIDE_VEINS))},
    "hay bale": {"lines": Marking("straw", partial(planks.planks, count=18))},
}
