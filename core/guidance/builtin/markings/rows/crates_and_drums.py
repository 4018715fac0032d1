"""Markings of crates, drums, and round plates of iron."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import bands, drums, planks, rings, studs
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import crates_and_drums as own

CRATES_AND_DRUMS: Rows = {
    "sci-fi crate": {
        "lights": Marking("panels", partial(outlines.laid, **own.CRATE_LIGHTS)),
        "vents": Marking("panels", partial(outlines.laid, **own.CRATE_VENTS)),
        "stripes": Marking("frame", partial(outlines.laid, **own.CRATE_STRIPES)),
        "bolts": Marking("frame", partial(outlines.laid, **own.CRATE_BOLTS)),
    },
    "ammo crate": {
        "letters": Marking("planks", partial(outlines.laid, **own.AMMO_LETTERS)),
        "star": Marking("planks", partial(outlines.laid, **own.AMMO_STAR)),
        "clasps": Marking("frame", partial(outlines.laid, **own.AMMO_CLASPS)),
        "bolts": Marking("frame", partial(outlines.laid, **own.AMMO_BOLTS)),
        "seams": Marking("planks", partial(planks.planks, count=6), "wooden"),
    },
    "oil drum": {
        "letters": Marking("body", partial(outlines.laid, **own.DRUM_LETTERS)),
        "bung": Marking("body", partial(outlines.laid, **own.DRUM_BUNG)),
        "rims": Marking("body", drums.rims),
        "bands": Marking("body", partial(bands.belts, spans=own.DRUM_BANDS)),
    },
    "toxic barrel": {
        "goo": Marking("body", drums.drips),
        "sign": Marking("body", partial(outlines.laid, **own.TOXIC_SIGN)),
        "bung": Marking("body", partial(outlines.laid, **own.DRUM_BUNG)),
        "rims": Marking("body", drums.rims),
        "stripes": Marking("body", partial(drums.slanted_belt, at=-0.72, wide=0.14, count=12)),
        "bands": Marking("body", partial(bands.belts, spans=((-0.52, -0.46), (0.44, 0.5)))),
    },
    "manhole cover": {
        "holes": Marking("body", partial(outlines.laid, **own.MANHOLE_HOLES)),
        "rings": Marking("body", partial(rings.rings, spans=((0.8, 0.92),), axis=2)),
        "studs": Marking("body", partial(drums.top_squares, pitch=0.22, size=0.6, within=0.74)),
    },
    "landmine": {
        "light": Marking("plate", partial(outlines.laid, **own.MINE_LIGHT)),
        "stripes": Marking("plate", partial(rings.rings, spans=((0.34, 0.4),), axis=2)),
        "plate": Marking("body", partial(outlines.laid, **own.MINE_PLATE)),
        "bolts": Marking("body", partial(studs.beads, radius=0.74, size=0.06, count=8, axis=2)),
        "ribs": Marking("body", partial(drums.ribs, count=24)),
    },
    "hockey puck": {
        "badge": Marking("body", partial(outlines.laid, **own.PUCK_BADGE)),
        "grip": Marking("body", partial(drums.knurls, count=40)),
    },
}
