"""Markings of props, arms, and things of fantasy."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    boards,
    craft,
    decor,
    facades,
    fittings,
    fronts,
    homely,
    machines,
    outlines,
    prints,
    wares,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.outlines import Line

SKULL_TEETH = tuple(Line(((0.14 * k, -0.82), (0.14 * k, -0.44))) for k in range(-2, 3))
SKULL_CRACKS = (
    Line(((0.3, 0.95), (0.42, 0.74), (0.3, 0.62), (0.4, 0.44)), 0.016),
    Line(((0.42, 0.74), (0.56, 0.66)), 0.013),
)
SARCOPHAGUS_BANDS = ((-0.86, -0.68), (-0.5, -0.34), (-0.16, -0.02))
SCRIPT = [0.52 - 0.115 * k for k in range(7)]  # of a scroll
BAUBLE_BAND = partial(fronts.belt, low=-0.17, high=0.17)
BAUBLE_EDGES = partial(fronts.belts, spans=((0.17, 0.23), (-0.23, -0.17)))
BAUBLE_STARS = partial(
    prints.scattered, shape="star", steep=1.3, places=[(45 * k, 0.6, 0.2) for k in range(8)]
)
BAUBLE_DOTS = partial(
    prints.scattered,
    shape="circle",
    steep=1.2,
    places=[(22.5 * k + 11, -0.38 - 0.24 * (k % 2), 0.075) for k in range(16)]
    + [(45 * k + 22.5, 0.45, 0.06) for k in range(8)],
)
PROPS_AND_ARMS: Rows = {
    "sword": {
        "fuller": Marking("blade", partial(outlines.laid, **decor.FULLER)),
        "wraps": Marking("grip", partial(fronts.belts, spans=decor.GRIP_WRAPS)),
    },
    "shield": {"quarters": Marking("plate", partial(outlines.laid, **decor.QUARTERS))},
    "arrow": {"bands": Marking("shaft", partial(fronts.belts, spans=decor.ARROW_BANDS))},
    "pistol": {
        "grooves": Marking("barrel", partial(outlines.laid, **machines.PISTOL_GROOVES)),
        "port": Marking("barrel", partial(outlines.laid, **machines.PISTOL_PORT)),
        "ridges": Marking("grip", partial(outlines.laid, **machines.PISTOL_RIDGES)),
    },
    "cannon": {
        "bands": Marking("barrel", partial(fronts.belts, spans=craft.CANNON_BANDS, axis=1)),
    },
    "bomb": {
        "skull": Marking("body", partial(outlines.laid, **machines.BOMB_SKULL)),
    },
    "chest": {
        "keyhole": Marking("lock", partial(outlines.laid, **craft.KEYHOLE)),
        "rivets": Marking("bands", partial(outlines.laid, **craft.RIVETS)),
        "seams": Marking("body", partial(boards.planks, count=4), "wooden"),
    },
    "open chest": {
        "keyhole": Marking("lock", partial(outlines.laid, **craft.KEYHOLE)),
        "seams": Marking("body", partial(boards.planks, count=4), "wooden"),
    },
    "barrel": {"seams": Marking("body", boards.staves, "wooden")},
    "crate": {
        "nails": Marking("frame", partial(outlines.laid, **craft.CRATE_NAILS)),
        "seams": Marking("planks", partial(boards.planks, count=6), "wooden"),
    },
    "coin": {"beads": Marking("face", partial(decor.beads, radius=0.72, size=0.035, count=28))},
    "book": {
        "badge": Marking("cover", partial(outlines.laid, **fittings.BOOK_BADGE), by="pages"),
        "border": Marking("cover", partial(outlines.laid, **fittings.BOOK_BORDER), by="pages"),
        "lines": Marking("pages", partial(boards.planks, count=7, axis=1)),
    },
    "scroll": {"letters": Marking("paper", partial(prints.ruled, lines=SCRIPT, ends=(-0.52, 0.5)))},
    "skull": {
        "teeth": Marking("bone", partial(outlines.laid, front=SKULL_TEETH, deep=0.5)),
        "cracks": Marking("bone", partial(outlines.laid, front=SKULL_CRACKS, deep=0.2)),
    },
    "tombstone": {"letters": Marking("slab", decor.epitaph)},
    "sarcophagus": {
        "bands": Marking("body", partial(fronts.belts, spans=SARCOPHAGUS_BANDS)),
    },
    "traffic light": {
        "border": Marking("body", partial(outlines.laid, **fittings.LIGHT_BORDER)),
    },
    "stop sign": {"letters": Marking("plate", partial(fronts.lettered, text="STOP", high=0.4))},
    "mailbox": {
        "letters": Marking(
            "box", partial(fronts.on_sides, text="MAIL", high=0.3, at=(0.36, -0.12))
        ),
        "slots": Marking("door", partial(outlines.laid, **fittings.MAIL_SEAMS)),
    },
    "fence": {"nails": Marking("pickets", partial(homely.picket_nails, heights=(-0.5, 0.44)))},
    "well": {
        "boards": Marking("roof", partial(outlines.laid, **homely.WELL_GABLE)),
        "seams": Marking("roof", partial(facades.tiles, axis=1)),
        "rope": Marking("posts", partial(homely.coil, reach=0.4)),
    },
    "tent": {"trim": Marking("canvas", decor.gable)},
    "saddle": {
        "flowers": Marking("flaps", partial(outlines.laid, **wares.SADDLE_FLOWERS)),
        "stitches": Marking("skirt", partial(outlines.laid, **wares.SADDLE_EDGE)),
    },
    "engine": {
        "pleats": Marking("filter", partial(craft.flutes, count=26, share=0.4, high=0.9)),
    },
    "gift": {
        "dots": Marking("box", partial(outlines.laid, **fittings.GIFT_DOTS)),
    },
    "christmas bauble": {
        "band": Marking("ball", partial(balls.at_top, marks=BAUBLE_BAND)),
        "edges": Marking("ball", partial(balls.at_top, marks=BAUBLE_EDGES)),
        "stars": Marking("ball", partial(balls.at_top, marks=BAUBLE_STARS)),
        "dots": Marking("ball", partial(balls.at_top, marks=BAUBLE_DOTS)),
    },
    "basket": {"weave": Marking("body", boards.weave)},
    "umbrella": {"panels": Marking("canopy", partial(balls.sectors, count=8))},
    "poker chip": {"spots": Marking("rim", fronts.edge_spots)},
    "war hammer": {"runes": Marking("head", partial(outlines.laid, **wares.RUNES))},
    "rifle": {
        "port": Marking("body", partial(outlines.laid, **machines.RIFLE_PORT)),
        "bands": Marking("stock", partial(fronts.belts, spans=machines.BUTT_BANDS, axis=0)),
    },
    "ray gun": {
        "window": Marking("body", partial(balls.caps, wide=0.4, ways=((0, -1, 0.1), (0, 1, 0.1))))
    },
    "compass": {"marks": Marking("dial", partial(prints.rose, radius=0.9))},
    "coffin": {
        "nails": Marking(
            "lid", partial(homely.nailed, corners=homely.COFFIN_NAILS, count=5, size=0.055)
        ),
        "seams": Marking("edge", partial(outlines.laid, **homely.COFFIN_SEAMS)),
    },
    "feather": {"barbs": Marking("vane", partial(fronts.slanted, pitch=0.09))},
    "leaf": {"side veins": Marking("blade", partial(outlines.laid, **wares.SIDE_VEINS))},
    "hay bale": {"lines": Marking("straw", partial(boards.planks, count=18))},
}
