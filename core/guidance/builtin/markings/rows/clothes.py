"""Markings of clothes, shoes, hats, bags and jewellery."""

from functools import partial

from core.guidance.builtin.markings import (
    boards,
    craft,
    decor,
    figures,
    fittings,
    fronts,
    outlines,
    prints,
    wares,
)
from core.guidance.builtin.markings.marking import Marking, Rows

STARS = [(0, 0.0, 0.16), (48, -0.3, 0.09), (-42, 0.22, 0.08), (95, 0.05, 0.13), (-85, -0.2, 0.13)]
STARS += [(145, -0.25, 0.1), (-150, 0.1, 0.11), (180, 0.45, 0.06), (25, 0.48, 0.055)]  # a wizard's
CLOTHES: Rows = {
    "shirt": {
        "seams": Marking("body", figures.shirt_seams),
        "pocket": Marking(
            "body", partial(figures.pockets, at=(0.36, 0.16), size=(0.15, 0.17), both=False)
        ),
    },
    "trousers": {"seams": Marking("body", figures.trouser_seams)},
    "dress": {"pleats": Marking("skirt", figures.folds)},
    "jacket": {"seams": Marking("body", figures.jacket_seams)},
    "scarf": {"lines": Marking("wool", partial(fronts.belts, spans=wares.SCARF_LINES))},
    "necktie": {"stripes": Marking("blade", partial(fronts.slanted, pitch=0.3))},
    "glove": {
        "motif": Marking("body", partial(outlines.laid, **wares.GLOVE_MOTIF), of="fabric"),
        "ribs": Marking("cuff", partial(outlines.laid, **wares.CUFF_RIBS)),
    },
    "sock": {
        "toe": Marking("body", fronts.sock_toe),
        "heel": Marking("body", fronts.sock_heel),
        "stripes": Marking("body", partial(fronts.belts, spans=((0.1, 0.26), (0.42, 0.58)))),
    },
    "sneaker": {"lines": Marking("sole", partial(figures.hoop, at=0.2, wide=0.16))},
    "boot": {"stitches": Marking("sole", partial(figures.dashed, at=0.5, wide=0.09))},
    "baseball cap": {
        "star": Marking("badge", partial(prints.stamp, shape="star", size=0.6, at=(0.0, 0.06))),
        "seams": Marking("cap", figures.panels),
    },
    "cowboy hat": {
        "star": Marking("body", partial(outlines.laid, **wares.SHERIFF_STAR)),
        "stitches": Marking("body", partial(wares.brim, low=0.88, high=0.93)),
        "studs": Marking("band", partial(wares.studs, count=26, size=0.016)),
    },
    "wizard hat": {"stars": Marking("body", partial(prints.scattered, shape="star", places=STARS))},
    "motorcycle helmet": {"vents": Marking("shell", partial(outlines.laid, **wares.CHIN_VENTS))},
    "chef hat": {"pleats": Marking("band", partial(boards.staves, count=22, wide=0.008))},
    "helmet": {"breaths": Marking("shell", partial(outlines.laid, **decor.BREATHS))},
    "backpack": {
        "badge": Marking("pocket", partial(outlines.laid, **fittings.POCKET_BADGE)),
        "zips": Marking("pocket", partial(outlines.laid, **fittings.POCKET_ZIPS)),
    },
    "handbag": {
        "piping": Marking("flap", partial(outlines.laid, **wares.FLAP_PIPING)),
        "quilting": Marking("body", partial(wares.cross_quilt, pitch=0.17)),
    },
    "suitcase": {
        "stickers": Marking("body", partial(outlines.laid, **fittings.STICKERS)),
        "seam": Marking("body", partial(fronts.belt, low=-0.05, high=0.05, axis=1)),
    },
    "briefcase": {
        "stitches": Marking("body", partial(outlines.laid, **craft.STITCHED)),
    },
    "watch": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "ring": {
        "stones": Marking("band", partial(wares.studs, count=20, size=0.05, axis=1, out=0.88)),
        "grooves": Marking("band", partial(fronts.belts, spans=wares.RING_GROOVES, axis=1)),
    },
    "medal": {
        "beads": Marking("medal", partial(decor.beads, radius=0.74, size=0.05, count=24)),
        "edges": Marking("ribbon", partial(outlines.laid, **wares.RIBBON_EDGES)),
    },
}
