"""Markings of clothes, shoes, hats, bags and jewellery."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import badges, bands, dials, planks, seams, stripes, studs
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import clothes as own

STARS = [(0, 0.0, 0.16), (48, -0.3, 0.09), (-42, 0.22, 0.08), (95, 0.05, 0.13), (-85, -0.2, 0.13)]
STARS += [(145, -0.25, 0.1), (-150, 0.1, 0.11), (180, 0.45, 0.06), (25, 0.48, 0.055)]  # a wizard's
CLOTHES: Rows = {
    "shirt": {
        "seams": Marking("body", seams.shirt_seams),
        "pocket": Marking(
            "body", partial(seams.pockets, at=(0.36, 0.16), size=(0.15, 0.17), both=False)
        ),
    },
    "trousers": {"seams": Marking("body", seams.trouser_seams)},
    "dress": {"pleats": Marking("skirt", seams.folds)},
    "jacket": {"seams": Marking("body", seams.jacket_seams)},
    "scarf": {"lines": Marking("wool", partial(bands.belts, spans=own.SCARF_LINES))},
    "necktie": {"stripes": Marking("blade", partial(stripes.slanted, pitch=0.3))},
    "glove": {
        "motif": Marking("body", partial(outlines.laid, **own.GLOVE_MOTIF), of="fabric"),
        "ribs": Marking("cuff", partial(outlines.laid, **own.CUFF_RIBS)),
    },
    "sock": {
        "toe": Marking("body", bands.sock_toe),
        "heel": Marking("body", bands.sock_heel),
        "stripes": Marking("body", partial(bands.belts, spans=((0.1, 0.26), (0.42, 0.58)))),
    },
    "sneaker": {"lines": Marking("sole", partial(bands.hoop, at=0.2, wide=0.16))},
    "boot": {"stitches": Marking("sole", partial(seams.dashes, at=0.5, wide=0.09))},
    "baseball cap": {
        "star": Marking("badge", partial(badges.stamp, shape="star", size=0.6, at=(0.0, 0.06))),
        "seams": Marking("cap", seams.cap_seams),
    },
    "cowboy hat": {
        "star": Marking("body", partial(outlines.laid, **own.SHERIFF_STAR)),
        "stitches": Marking("body", partial(bands.brim, low=0.88, high=0.93)),
        "studs": Marking("band", partial(studs.studs, count=26, size=0.016)),
    },
    "wizard hat": {"stars": Marking("body", partial(badges.scattered, shape="star", places=STARS))},
    "motorcycle helmet": {"vents": Marking("shell", partial(outlines.laid, **own.CHIN_VENTS))},
    "chef hat": {"pleats": Marking("band", partial(planks.staves, count=22, wide=0.008))},
    "helmet": {"breaths": Marking("shell", partial(outlines.laid, **own.BREATHS))},
    "backpack": {
        "badge": Marking("pocket", partial(outlines.laid, **own.POCKET_BADGE)),
        "zips": Marking("pocket", partial(outlines.laid, **own.POCKET_ZIPS)),
    },
    "handbag": {
        "piping": Marking("flap", partial(outlines.laid, **own.FLAP_PIPING)),
        "quilting": Marking("body", partial(seams.quilt, pitch=0.17, axes=(0, 2))),
    },
    "suitcase": {
        "stickers": Marking("body", partial(outlines.laid, **own.STICKERS)),
        "seam": Marking("body", partial(bands.belt, low=-0.05, high=0.05, axis=1)),
    },
    "briefcase": {
        "stitches": Marking("body", partial(outlines.laid, **own.STITCHED)),
    },
    "watch": {"marks": Marking("face", partial(dials.hours, radius=1.0))},
    "ring": {
        "stones": Marking("band", partial(studs.studs, count=20, size=0.05, axis=1, out=0.88)),
        "grooves": Marking("band", partial(bands.belts, spans=own.RING_GROOVES, axis=1)),
    },
    "medal": {
        "beads": Marking("medal", partial(studs.beads, radius=0.74, size=0.05, count=24)),
        "edges": Marking("ribbon", partial(outlines.laid, **own.RIBBON_EDGES)),
    },
}
