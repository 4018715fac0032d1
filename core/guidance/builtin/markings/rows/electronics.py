"""Markings of computers, telephones, cameras and machines."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    craft,
    devices,
    fittings,
    fronts,
    machines,
    outlines,
    prints,
)
from core.guidance.builtin.markings.marking import Marking, Rows

ELECTRONICS: Rows = {
    "laptop": {
        "icons": Marking("screen", partial(outlines.laid, **fittings.LAPTOP_ICONS)),
        "badge": Marking("body", partial(outlines.laid, **fittings.LAPTOP_BADGE)),
    },
    "desktop computer": {
        "letters": Marking("screen", partial(outlines.laid, **devices.COMPUTER_LETTERS)),
        "vents": Marking("body", partial(outlines.laid, **devices.COMPUTER_VENTS)),
    },
    "computer tower": {
        "ports": Marking("body", partial(outlines.laid, **craft.TOWER_PORTS)),
    },
    "monitor": {
        "icons": Marking("screen", partial(outlines.laid, **fittings.LAPTOP_ICONS)),
        "slots": Marking("body", partial(outlines.laid, **fittings.TV_SLOTS)),
    },
    "keyboard": {
        "letters": Marking("keys", partial(outlines.laid, **devices.KEY_LETTERS), by="body"),
    },
    "computer mouse": {
        "grips": Marking("body", partial(outlines.laid, **devices.MOUSE_GRIPS)),
    },
    "printer": {
        "lines": Marking("paper", partial(outlines.laid, **craft.PRINTED)),
    },
    "calculator": {
        "digits": Marking(
            "display", partial(outlines.laid, **devices.CALCULATOR_DIGITS), by="body"
        ),
        "numbers": Marking("keys", partial(outlines.laid, **devices.CALCULATOR_NUMBERS), by="body"),
        "symbols": Marking(
            "accents", partial(outlines.laid, **devices.CALCULATOR_SYMBOLS), by="body"
        ),
    },
    "cash register": {
        "digits": Marking("display", partial(outlines.laid, **craft.DISPLAY_DIGITS)),
        "border": Marking("body", partial(outlines.laid, **craft.TILL_BORDER)),
    },
    "atm": {
        "letters": Marking("panels", partial(fronts.lettered, text="ATM", high=0.5, bold=0.06))
    },
    "game controller": {
        "logo": Marking("body", partial(outlines.laid, **devices.PAD_LOGO)),
        "grips": Marking("body", partial(outlines.laid, **devices.PAD_GRIPS)),
    },
    "game console": {
        "pixels": Marking("screen", partial(outlines.laid, **devices.CONSOLE_PIXELS)),
        "seams": Marking("body", partial(outlines.laid, **devices.CONSOLE_SEAMS)),
    },
    "arcade machine": {
        "marquee": Marking("body", partial(outlines.laid, **devices.ARCADE_MARQUEE)),
        "pixels": Marking("screen", partial(outlines.laid, **devices.ARCADE_PIXELS)),
        "stripes": Marking("body", partial(outlines.laid, **devices.ARCADE_STRIPES)),
    },
    "slot machine": {
        "sevens": Marking("reels", devices.reel_sevens),
        "badges": Marking("cabinet", partial(outlines.laid, **devices.SLOT_BADGES)),
    },
    "phone": {
        "icons": Marking("screen", prints.icons),
        "lenses": Marking("camera", partial(outlines.laid, **fittings.PHONE_LENSES)),
        "camera": Marking("body", partial(outlines.laid, **fittings.PHONE_CAMERA)),
    },
    "telephone": {
        "holes": Marking("dial", craft.dial_holes),
    },
    "camera": {
        "rings": Marking("lens", partial(fronts.belts, spans=fittings.LENS_RINGS, axis=1)),
        "screen": Marking("grip", partial(outlines.laid, **fittings.CAMERA_SCREEN)),
    },
    "security camera": {
        "letters": Marking(
            "hood", partial(fronts.on_sides, text="CCTV", high=0.24, at=(0.1, 0.12))
        ),
        "vents": Marking("body", partial(outlines.laid, **devices.CAMERA_VENTS)),
    },
    "television": {
        "glare": Marking("screen", fittings.glare),
        "slots": Marking("body", partial(outlines.laid, **fittings.TV_SLOTS)),
    },
    "projector": {
        "vents": Marking("body", partial(outlines.laid, **devices.PROJECTOR_VENTS)),
    },
    "satellite dish": {
        "seams": Marking("dish", machines.dish_seams),
    },
    "radio": {
        "slots": Marking("speaker", prints.slots),
        "marks": Marking("dial", partial(outlines.laid, **fittings.DIAL_MARKS)),
    },
    "record player": {
        "grooves": Marking("record", partial(fronts.rings, spans=craft.RECORD_GROOVES, axis=2)),
        "panels": Marking("case", partial(outlines.laid, **craft.CASE_PANELS)),
    },
    "speaker": {
        "caps": Marking("cones", partial(fittings.cone_rings, spans=((-1.0, 0.3),)), by="body"),
        "rings": Marking(
            "cones", partial(fittings.cone_rings, spans=((0.45, 0.53), (0.68, 0.76))), by="body"
        ),
    },
    "microphone": {"mesh": Marking("head", balls.mesh_gaps)},
    "headphones": {
        "badges": Marking("cups", partial(outlines.laid, **craft.CUP_BADGES), paired=True),
    },
    "flashlight": {
        "bulb": Marking("lens", partial(outlines.laid, **devices.BULB)),
        "flutes": Marking("head", partial(devices.lying_flutes, count=14)),
    },
    "battery": {
        "plus": Marking("top", partial(prints.stamp, shape="cross", size=0.4, at=(0, 0.2))),
        "bolt": Marking("body", partial(prints.stamp, shape="lightning bolt", size=0.7)),
    },
    "coffee machine": {
        "digits": Marking("panel", partial(outlines.laid, **craft.COFFEE_DIGITS)),
        "buttons": Marking("panel", partial(outlines.laid, **craft.COFFEE_BUTTONS)),
    },
    "clothes iron": {
        "stripes": Marking("body", partial(fronts.belts, spans=devices.IRON_STRIPES)),
        "panes": Marking("body", partial(outlines.laid, **devices.IRON_PANES)),
    },
    "vacuum cleaner": {
        "bands": Marking("cup", partial(fronts.belts, spans=devices.CUP_BANDS)),
        "vents": Marking("body", partial(outlines.laid, **devices.VACUUM_VENTS)),
    },
    "power drill": {
        "vents": Marking("body", partial(outlines.laid, **devices.DRILL_VENTS)),
        "letters": Marking("battery", partial(outlines.laid, **devices.BATTERY_LETTERS)),
    },
    "robot arm": {
        "stripes": Marking("base", machines.foot_stripes),
    },
    "drone": {
        "lamps": Marking("body", partial(outlines.laid, **craft.DRONE_LAMPS)),
        "seams": Marking("body", partial(outlines.laid, **craft.DRONE_SEAMS)),
    },
}
