"""Markings of computers, telephones, cameras and machines."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    dials,
    lattices,
    lettering,
    lines,
    pictures,
    rings,
    stripes,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import electronics as own

ELECTRONICS: Rows = {
    "laptop": {
        "icons": Marking("screen", partial(outlines.laid, **own.LAPTOP_ICONS)),
        "badge": Marking("body", partial(outlines.laid, **own.LAPTOP_BADGE)),
    },
    "desktop computer": {
        "letters": Marking("screen", partial(outlines.laid, **own.COMPUTER_LETTERS)),
        "vents": Marking("body", partial(outlines.laid, **own.COMPUTER_VENTS)),
    },
    "computer tower": {
        "ports": Marking("body", partial(outlines.laid, **own.TOWER_PORTS)),
    },
    "monitor": {
        "icons": Marking("screen", partial(outlines.laid, **own.LAPTOP_ICONS)),
        "slots": Marking("body", partial(outlines.laid, **own.TV_SLOTS)),
    },
    "keyboard": {
        "letters": Marking("keys", partial(outlines.laid, **own.KEY_LETTERS), by="body"),
    },
    "computer mouse": {
        "grips": Marking("body", partial(outlines.laid, **own.MOUSE_GRIPS)),
    },
    "printer": {
        "lines": Marking("paper", partial(outlines.laid, **own.PRINTED)),
    },
    "calculator": {
        "digits": Marking("display", partial(outlines.laid, **own.CALCULATOR_DIGITS), by="body"),
        "numbers": Marking("keys", partial(outlines.laid, **own.CALCULATOR_NUMBERS), by="body"),
        "symbols": Marking("accents", partial(outlines.laid, **own.CALCULATOR_SYMBOLS), by="body"),
    },
    "cash register": {
        "digits": Marking("display", partial(outlines.laid, **own.DISPLAY_DIGITS)),
        "border": Marking("body", partial(outlines.laid, **own.TILL_BORDER)),
    },
    "atm": {
        "letters": Marking("panels", partial(lettering.lettered, text="ATM", high=0.5, bold=0.06))
    },
    "game controller": {
        "logo": Marking("body", partial(outlines.laid, **own.PAD_LOGO)),
        "grips": Marking("body", partial(outlines.laid, **own.PAD_GRIPS)),
    },
    "game console": {
        "pixels": Marking("screen", partial(outlines.laid, **own.CONSOLE_PIXELS)),
        "seams": Marking("body", partial(outlines.laid, **own.CONSOLE_SEAMS)),
    },
    "arcade machine": {
        "marquee": Marking("body", partial(outlines.laid, **own.ARCADE_MARQUEE)),
        "pixels": Marking("screen", partial(outlines.laid, **own.ARCADE_PIXELS)),
        "stripes": Marking("body", partial(outlines.laid, **own.ARCADE_STRIPES)),
    },
    "slot machine": {
        "sevens": Marking("reels", lettering.reel_sevens),
        "badges": Marking("cabinet", partial(outlines.laid, **own.SLOT_BADGES)),
    },
    "phone": {
        "icons": Marking("screen", pictures.icons),
        "lenses": Marking("camera", partial(outlines.laid, **own.PHONE_LENSES)),
        "camera": Marking("body", partial(outlines.laid, **own.PHONE_CAMERA)),
    },
    "telephone": {
        "holes": Marking("dial", dials.dial_holes),
    },
    "camera": {
        "rings": Marking("lens", partial(bands.belts, spans=own.LENS_RINGS, axis=1)),
        "screen": Marking("grip", partial(outlines.laid, **own.CAMERA_SCREEN)),
    },
    "security camera": {
        "letters": Marking(
            "hood", partial(lettering.on_sides, text="CCTV", high=0.24, at=(0.1, 0.12))
        ),
        "vents": Marking("body", partial(outlines.laid, **own.CAMERA_VENTS)),
    },
    "television": {
        "glare": Marking("screen", pictures.glare),
        "slots": Marking("body", partial(outlines.laid, **own.TV_SLOTS)),
    },
    "projector": {
        "vents": Marking("body", partial(outlines.laid, **own.PROJECTOR_VENTS)),
    },
    "satellite dish": {
        "seams": Marking("dish", rings.dish_seams),
    },
    "radio": {
        "slots": Marking("speaker", lattices.slots),
        "marks": Marking("dial", partial(outlines.laid, **own.DIAL_MARKS)),
    },
    "record player": {
        "grooves": Marking("record", partial(rings.rings, spans=own.RECORD_GROOVES, axis=2)),
        "panels": Marking("case", partial(outlines.laid, **own.CASE_PANELS)),
    },
    "speaker": {
        "caps": Marking("cones", partial(rings.cone_rings, spans=((-1.0, 0.3),)), by="body"),
        "rings": Marking(
            "cones", partial(rings.cone_rings, spans=((0.45, 0.53), (0.68, 0.76))), by="body"
        ),
    },
    "microphone": {"mesh": Marking("head", lattices.mesh_gaps)},
    "headphones": {
        "badges": Marking("cups", partial(outlines.laid, **own.CUP_BADGES), paired=True),
    },
    "flashlight": {
        "bulb": Marking("lens", partial(outlines.laid, **own.BULB)),
        "flutes": Marking("head", partial(lines.lying_flutes, count=14)),
    },
    "battery": {
        "plus": Marking("top", partial(badges.stamp, shape="cross", size=0.4, at=(0, 0.2))),
        "bolt": Marking("body", partial(badges.stamp, shape="lightning bolt", size=0.7)),
    },
    "coffee machine": {
        "digits": Marking("panel", partial(outlines.laid, **own.COFFEE_DIGITS)),
        "buttons": Marking("panel", partial(outlines.laid, **own.COFFEE_BUTTONS)),
    },
    "clothes iron": {
        "stripes": Marking("body", partial(bands.belts, spans=own.IRON_STRIPES)),
        "panes": Marking("body", partial(outlines.laid, **own.IRON_PANES)),
    },
    "vacuum cleaner": {
        "bands": Marking("cup", partial(bands.belts, spans=own.CUP_BANDS)),
        "vents": Marking("body", partial(outlines.laid, **own.VACUUM_VENTS)),
    },
    "power drill": {
        "vents": Marking("body", partial(outlines.laid, **own.DRILL_VENTS)),
        "letters": Marking("battery", partial(outlines.laid, **own.BATTERY_LETTERS)),
    },
    "robot arm": {
        "stripes": Marking("base", stripes.foot_stripes),
    },
    "drone": {
        "lamps": Marking("body", partial(outlines.laid, **own.DRONE_LAMPS)),
        "seams": Marking("body", partial(outlines.laid, **own.DRONE_SEAMS)),
    },
}
