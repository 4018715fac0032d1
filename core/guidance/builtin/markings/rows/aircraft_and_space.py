"""Markings of aircraft, spacecraft and planets."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import bands, globes, lattices, rings, stripes
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import aircraft_and_space as own

ZONES = ((-58, -46), (-30, -12), (4, 9), (18, 34), (52, 61))  # a ringed planet's, degrees
JUPITER_BANDS = ((-62, -54), (-34, -14), (7, 19), (29, 33), (44, 50), (66, 90), (-90, -70))
JUPITER_ZONES = ((-46, -36), (-10, 4), (21, 27), (52, 58))
AIRCRAFT_AND_SPACE: Rows = {
    "airplane": {
        "windows": Marking("body", partial(bands.girt, **own.PLANE_WINDOWS)),
        "intakes": Marking("engines", partial(rings.disc, radius=0.78), every=True),
        "stripe": Marking("body", partial(bands.girt, **own.PLANE_STRIPE)),
        "bands": Marking("tail", partial(bands.belts, spans=own.TAIL_BANDS)),
    },
    "fighter jet": {
        "stars": Marking("wings", partial(outlines.laid, **own.JET_STARS)),
        "nose": Marking("body", partial(bands.belts, spans=own.JET_NOSE, axis=1)),
    },
    "helicopter": {
        "panes": Marking("body", partial(outlines.laid, **own.HELICOPTER_PANES)),
        "doors": Marking("body", partial(outlines.laid, **own.HELICOPTER_DOORS)),
        "bands": Marking("body", partial(bands.belts, spans=own.HELICOPTER_BANDS, axis=1)),
    },
    "hot air balloon": {
        "belts": Marking("balloon", partial(bands.belts, spans=own.BALLOON_BELTS)),
        "panels": Marking("balloon", partial(stripes.sectors, count=7)),
        "weave": Marking("basket", partial(lattices.weave, around=20, rows=6)),
    },
    "rocket": {
        "bands": Marking("hull", partial(bands.belts, spans=own.ROCKET_BANDS)),
        "hatch": Marking("hull", partial(outlines.laid, **own.ROCKET_HATCH)),
    },
    "space shuttle": {
        "edges": Marking("wings", partial(outlines.laid, **own.SHUTTLE_EDGES)),
        "doors": Marking("body", partial(outlines.laid, **own.SHUTTLE_DOORS)),
        "tiles": Marking("body", partial(bands.belt, low=-2.0, high=-0.42)),
    },
    "spaceship": {
        "nose": Marking("hull", partial(bands.belts, spans=own.SHIP_NOSE, axis=1)),
        "stripes": Marking("wings", partial(outlines.laid, **own.SHIP_STRIPES)),
    },
    "ufo": {
        "band": Marking("body", partial(bands.belt, low=-0.2, high=0.08)),
        "seams": Marking("body", partial(rings.spokes, count=12, wide=0.011, reach=(0.3, 2.0))),
        "frames": Marking("dome", partial(rings.spokes, count=6, wide=0.014, reach=(-1.0, 2.0))),
    },
    "satellite": {
        "lines": Marking(
            "panels",
            partial(lattices.cell_lines, count=(2, 4), room=0.02, wide=0.009),
            paired=True,
        ),
        "seams": Marking("body", partial(outlines.laid, **own.FOIL)),
    },
    "space station": {
        "lines": Marking(
            "panels",
            partial(lattices.cell_lines, count=(2, 5), room=0.02, wide=0.008),
            paired=True,
        ),
    },
    "planet": {"bands": Marking("globe", partial(globes.zones, lean=23, spans=ZONES))},
    "earth": {"ice": Marking("body", globes.poles), "land": Marking("body", globes.lands)},
    "jupiter": {
        "whorl": Marking("storm", partial(globes.storm, at=(24, -17), size=(9, 5))),
        "storm": Marking("body", partial(globes.storm, at=(24, -17), size=(19, 11))),
        "bands": Marking("body", partial(globes.zones, spans=JUPITER_BANDS, lean=3)),
        "zones": Marking("body", partial(globes.zones, spans=JUPITER_ZONES, lean=3)),
    },
    "mars": {
        "ice": Marking("body", partial(globes.poles, lean=18)),
        "craters": Marking("body", globes.craters),
        "plains": Marking("body", globes.plains),
    },
    "full moon": {"craters": Marking("body", globes.craters)},
}
