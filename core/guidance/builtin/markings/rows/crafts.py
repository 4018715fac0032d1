"""Craft, machines, instruments, boxes."""

from functools import partial

from core.guidance.builtin.markings import bodywork, craft, fronts, outlines
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.everyday import GROOVES

CRAFTS: Rows = {
    "airplane": {
        "windows": Marking("body", partial(craft.girt, **craft.PLANE_WINDOWS)),
        "doors": Marking("body", partial(outlines.laid, **craft.PLANE_DOORS)),
        "stripe": Marking("body", partial(craft.girt, **craft.PLANE_STRIPE)),
        "bands": Marking("tail", partial(fronts.belts, spans=craft.TAIL_BANDS)),
    },
    "helicopter": {
        "panes": Marking("body", partial(outlines.laid, **craft.HELICOPTER_PANES)),
        "doors": Marking("body", partial(outlines.laid, **craft.HELICOPTER_DOORS)),
        "bands": Marking("body", partial(fronts.belts, spans=craft.HELICOPTER_BANDS, axis=1)),
    },
    "fighter jet": {
        "stars": Marking("wings", partial(outlines.laid, **craft.JET_STARS)),
        "nose": Marking("body", partial(fronts.belts, spans=craft.JET_NOSE, axis=1)),
    },
    "rocket": {
        "bands": Marking("hull", partial(fronts.belts, spans=craft.ROCKET_BANDS)),
        "hatch": Marking("hull", partial(outlines.laid, **craft.ROCKET_HATCH)),
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
    "submarine": {
        "windows": Marking("hull", partial(outlines.laid, **craft.SUB_PORTS)),
        "rims": Marking("hull", partial(outlines.laid, **craft.SUB_RIMS)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.3)),
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
    "monster truck": {
        "doors": Marking("body", partial(outlines.laid, **craft.MONSTER_DOORS)),
        "flames": Marking("body", partial(outlines.laid, **craft.FLAMES)),
    },
    "boat": {
        "anchor": Marking("sails", partial(outlines.laid, **craft.ANCHOR)),
        "stripe": Marking("hull", partial(craft.flank, low=0.4, high=0.66, out=0.84)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.3)),
    },
    "sailboat": {
        "anchor": Marking("sails", partial(outlines.laid, **craft.ANCHOR)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.4)),
    },
    "cruise ship": {
        "portholes": Marking("hull", partial(outlines.laid, **craft.PORTHOLES)),
    },
    "yacht": {
        "portholes": Marking("hull", partial(outlines.laid, **craft.YACHT_PORTS)),
    },
    "cargo ship": {
        "ribs": Marking("containers", craft.container_ribs, by="hull"),
        "ridges": Marking("boxes", craft.container_ribs, by="hull"),
    },
    "tractor": {
        "grille": Marking("body", partial(outlines.laid, **craft.TRACTOR_GRILLE)),
        "lamps": Marking("body", partial(outlines.laid, **craft.TRACTOR_LAMPS)),
    },
    "excavator": {
        "stripes": Marking("body", partial(outlines.laid, **craft.DIGGER_STRIPES)),
        "vents": Marking("body", partial(outlines.laid, **craft.DIGGER_VENTS)),
        "links": Marking("tracks", bodywork.links),
    },
    "trash can": {
        "flutes": Marking("body", partial(craft.flutes, count=14, share=0.34, high=0.84)),
    },
    "record player": {
        "grooves": Marking("record", partial(fronts.rings, spans=GROOVES, axis=2)),
        "panels": Marking("case", partial(outlines.laid, **craft.CASE_PANELS)),
    },
    "cash register": {
        "digits": Marking("display", partial(outlines.laid, **craft.DISPLAY_DIGITS)),
        "border": Marking("body", partial(outlines.laid, **craft.TILL_BORDER)),
    },
    "printer": {
        "lines": Marking("paper", partial(outlines.laid, **craft.PRINTED)),
    },
    "drone": {
        "lamps": Marking("body", partial(outlines.laid, **craft.DRONE_LAMPS)),
        "seams": Marking("body", partial(outlines.laid, **craft.DRONE_SEAMS)),
    },
    "lamp": {
        "bands": Marking("shade", partial(fronts.belts, spans=craft.SHADE_BANDS)),
        "pleats": Marking("shade", partial(craft.flutes, count=24, share=0.15, high=0.9)),
    },
    "headphones": {
        "badges": Marking("cups", partial(outlines.laid, **craft.CUP_BADGES), paired=True),
    },
    "drum": {
        "badge": Marking("shell", partial(outlines.laid, **craft.DRUM_BADGE)),
        "cords": Marking("shell", partial(craft.zigzag, count=8, high=0.8, wide=0.016)),
    },
    "piano": {
        "panels": Marking("body", partial(outlines.laid, **craft.PIANO_PANELS)),
    },
    "trophy": {
        "plaque": Marking("base", partial(outlines.laid, **craft.PLAQUE)),
        "star": Marking("cup", partial(outlines.laid, **craft.CUP_STAR)),
    },
    "toolbox": {
        "letters": Marking("body", partial(fronts.lettered, **craft.TOOLS)),
    },
    "briefcase": {
        "stitches": Marking("body", partial(outlines.laid, **craft.STITCHED)),
    },
    "cannon": {
        "bands": Marking("barrel", partial(fronts.belts, spans=craft.CANNON_BANDS, axis=1)),
    },
    "gas pump": {
        "marks": Marking("face", partial(outlines.laid, **craft.PUMP_MARKS), by="body"),
        "star": Marking("globe", partial(outlines.laid, **craft.GLOBE_STAR)),
    },
    "coffee machine": {
        "digits": Marking("panel", partial(outlines.laid, **craft.COFFEE_DIGITS)),
        "buttons": Marking("panel", partial(outlines.laid, **craft.COFFEE_BUTTONS)),
    },
    "telephone": {
        "holes": Marking("dial", craft.dial_holes),
    },
    "space shuttle": {
        "edges": Marking("wings", partial(outlines.laid, **craft.SHUTTLE_EDGES)),
        "doors": Marking("body", partial(outlines.laid, **craft.SHUTTLE_DOORS)),
        "tiles": Marking("body", partial(fronts.belt, low=-2.0, high=-0.42)),
    },
    "computer tower": {
        "ports": Marking("body", partial(outlines.laid, **craft.TOWER_PORTS)),
    },
    "motorcycle": {
        "fins": Marking("engine", partial(outlines.laid, **craft.ENGINE_FINS)),
    },
    "remote control": {
        "seams": Marking("body", partial(outlines.laid, **craft.REMOTE_SEAMS)),
    },
}
