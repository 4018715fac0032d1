"""Markings of what flies in the air or in space, and of planets."""

from functools import partial

from core.guidance.builtin.markings import balls, boards, craft, fronts, machines, outlines
from core.guidance.builtin.markings.marking import Marking, Rows

ZONES = ((-58, -46), (-30, -12), (4, 9), (18, 34), (52, 61))  # a ringed planet's, degrees
AIRCRAFT_AND_SPACE: Rows = {
    "airplane": {
        "windows": Marking("body", partial(craft.girt, **craft.PLANE_WINDOWS)),
        "doors": Marking("body", partial(outlines.laid, **craft.PLANE_DOORS)),
        "stripe": Marking("body", partial(craft.girt, **craft.PLANE_STRIPE)),
        "bands": Marking("tail", partial(fronts.belts, spans=craft.TAIL_BANDS)),
    },
    "fighter jet": {
        "stars": Marking("wings", partial(outlines.laid, **craft.JET_STARS)),
        "nose": Marking("body", partial(fronts.belts, spans=craft.JET_NOSE, axis=1)),
    },
    "helicopter": {
        "panes": Marking("body", partial(outlines.laid, **craft.HELICOPTER_PANES)),
        "doors": Marking("body", partial(outlines.laid, **craft.HELICOPTER_DOORS)),
        "bands": Marking("body", partial(fronts.belts, spans=craft.HELICOPTER_BANDS, axis=1)),
    },
    "hot air balloon": {
        "belts": Marking("balloon", partial(fronts.belts, spans=machines.BALLOON_BELTS)),
        "panels": Marking("balloon", partial(balls.sectors, count=7)),
        "weave": Marking("basket", partial(boards.weave, around=20, rows=6)),
    },
    "rocket": {
        "bands": Marking("hull", partial(fronts.belts, spans=craft.ROCKET_BANDS)),
        "hatch": Marking("hull", partial(outlines.laid, **craft.ROCKET_HATCH)),
    },
    "space shuttle": {
        "edges": Marking("wings", partial(outlines.laid, **craft.SHUTTLE_EDGES)),
        "doors": Marking("body", partial(outlines.laid, **craft.SHUTTLE_DOORS)),
        "tiles": Marking("body", partial(fronts.belt, low=-2.0, high=-0.42)),
    },
    "spaceship": {
        "nose": Marking("hull", partial(fronts.belts, spans=craft.SHIP_NOSE, axis=1)),
        "stripes": Marking("wings", partial(outlines.laid, **craft.SHIP_STRIPES)),
    },
    "ufo": {
        "band": Marking("body", partial(fronts.belt, low=-0.2, high=0.08)),
        "seams": Marking("body", partial(craft.spokes, count=12, wide=0.011, reach=(0.3, 2.0))),
        "frames": Marking("dome", partial(craft.spokes, count=6, wide=0.014, reach=(-1.0, 2.0))),
    },
    "satellite": {
        "lines": Marking(
            "panels",
            partial(craft.lattice, count=(2, 4), room=0.02, wide=0.009),
            paired=True,
        ),
        "seams": Marking("body", partial(outlines.laid, **craft.FOIL)),
    },
    "space station": {
        "lines": Marking(
            "panels",
            partial(craft.lattice, count=(2, 5), room=0.02, wide=0.008),
            paired=True,
        ),
    },
    "planet": {"bands": Marking("globe", partial(balls.zones, lean=23, spans=ZONES))},
    "earth": {"ice": Marking("body", balls.poles), "land": Marking("body", balls.lands)},
    "full moon": {"craters": Marking("body", balls.craters)},
}
