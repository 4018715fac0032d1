"""Machines, vehicles, devices."""

from functools import partial

from core.guidance.builtin.markings import balls, boards, craft, devices, fronts, machines, outlines
from core.guidance.builtin.markings.marking import Marking, Rows

MACHINES: Rows = {
    "phone booth": {
        "letters": Marking("sign", partial(outlines.laid, **machines.BOOTH_LETTERS)),
        "sign": Marking("body", partial(outlines.laid, **machines.BOOTH_SIGN)),
        "windows": Marking("body", partial(outlines.laid, **machines.BOOTH_WINDOWS)),
        "seams": Marking("body", partial(outlines.laid, **machines.BOOTH_SEAMS)),
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
    "jeep": {
        "grille": Marking("body", partial(outlines.laid, **machines.JEEP_GRILLE)),
        "stars": Marking("body", partial(outlines.laid, **machines.JEEP_STARS)),
    },
    "dump truck": {
        "trim": Marking("body", partial(outlines.laid, **machines.DUMPER_TRIM)),
    },
    "crane": {
        "gaps": Marking("mast", partial(machines.truss, along=2, count=4, room=(-0.7, 0.7))),
        "holes": Marking("jib", partial(machines.truss, along=1, count=7, room=(-0.2, 0.7))),
    },
    "golf cart": {
        "lamps": Marking("body", partial(outlines.laid, **machines.CART_LAMPS)),
        "trim": Marking("body", partial(outlines.laid, **machines.CART_TRIM)),
    },
    "scooter": {
        "grille": Marking("body", partial(outlines.laid, **machines.SCOOTER_GRILLE)),
        "trim": Marking("body", partial(outlines.laid, **machines.SCOOTER_TRIM)),
        "tail lamps": Marking("body", partial(outlines.laid, **machines.SCOOTER_TAIL)),
    },
    "jet ski": {
        "trim": Marking("cowl", partial(outlines.laid, **machines.SKI_TRIM)),
        "ribs": Marking("saddle", partial(fronts.belts, spans=machines.SADDLE_RIBS, axis=1)),
    },
    "rover": {
        "lines": Marking("panels", partial(machines.grid, pitch=(0.11, 0.12))),
        "foil": Marking("body", partial(outlines.laid, **machines.ROVER_FOIL)),
    },
    "tram": {
        "lamps": Marking("body", partial(outlines.laid, **machines.TRAM_LAMPS)),
        "sign": Marking("body", partial(outlines.laid, **machines.TRAM_SIGN)),
        "windows": Marking("body", partial(outlines.laid, **machines.TRAM_WINDOWS)),
        "doors": Marking("body", partial(outlines.laid, **machines.TRAM_DOORS)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.62, high=-0.28)),
    },
    "desktop computer": {
        "letters": Marking("screen", partial(outlines.laid, **devices.COMPUTER_LETTERS)),
        "vents": Marking("body", partial(outlines.laid, **devices.COMPUTER_VENTS)),
    },
    "game console": {
        "pixels": Marking("screen", partial(outlines.laid, **devices.CONSOLE_PIXELS)),
        "seams": Marking("body", partial(outlines.laid, **devices.CONSOLE_SEAMS)),
    },
    "keyboard": {
        "letters": Marking("keys", partial(outlines.laid, **devices.KEY_LETTERS), by="body"),
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
    "engine": {
        "pleats": Marking("filter", partial(craft.flutes, count=26, share=0.4, high=0.9)),
    },
    "game controller": {
        "logo": Marking("body", partial(outlines.laid, **devices.PAD_LOGO)),
        "grips": Marking("body", partial(outlines.laid, **devices.PAD_GRIPS)),
    },
    "projector": {
        "vents": Marking("body", partial(outlines.laid, **devices.PROJECTOR_VENTS)),
    },
    "vacuum cleaner": {
        "bands": Marking("cup", partial(fronts.belts, spans=devices.CUP_BANDS)),
        "vents": Marking("body", partial(outlines.laid, **devices.VACUUM_VENTS)),
    },
    "blender": {
        "marks": Marking("jug", partial(outlines.laid, **devices.JUG_MARKS)),
        "trim": Marking("base", partial(fronts.belts, spans=devices.BLENDER_TRIM)),
    },
    "power drill": {
        "vents": Marking("body", partial(outlines.laid, **devices.DRILL_VENTS)),
        "letters": Marking("battery", partial(outlines.laid, **devices.BATTERY_LETTERS)),
    },
    "clothes iron": {
        "stripes": Marking("body", partial(fronts.belts, spans=devices.IRON_STRIPES)),
        "panes": Marking("body", partial(outlines.laid, **devices.IRON_PANES)),
    },
    "kettle": {
        "bands": Marking("body", partial(fronts.belts, spans=devices.KETTLE_BANDS)),
        "dots": Marking(
            "body", partial(devices.dots_about, rows=(-0.52, -0.14, 0.24), count=11, radius=0.1)
        ),
    },
    "fan": {
        "buttons": Marking("stand", partial(outlines.laid, **devices.FAN_BUTTONS)),
        "badge": Marking("hub", partial(outlines.laid, **devices.FAN_BADGE)),
    },
    "security camera": {
        "letters": Marking(
            "hood", partial(fronts.on_sides, text="CCTV", high=0.24, at=(0.1, 0.12))
        ),
        "vents": Marking("body", partial(outlines.laid, **devices.CAMERA_VENTS)),
    },
    "telescope": {
        "rings": Marking("tube", partial(devices.hoops_along, spans=devices.TELESCOPE_RINGS)),
        "stars": Marking("tube", partial(outlines.laid, **devices.TELESCOPE_STARS)),
    },
    "parking meter": {
        "marks": Marking("window", devices.meter_marks, by="head"),
        "badge": Marking("head", partial(outlines.laid, **devices.METER_BADGE)),
    },
    "shipping container": {
        "letters": Marking("ribs", machines.rib_letters, by="body"),
        "ridges": Marking("body", partial(outlines.laid, **machines.CONTAINER_RIDGES)),
    },
    "dumpster": {
        "arrows": Marking(
            "body", partial(machines.recycling, at=((-0.31, -0.05), (0.31, -0.05)), size=0.5)
        ),
    },
    "flashlight": {
        "bulb": Marking("lens", partial(outlines.laid, **devices.BULB)),
        "flutes": Marking("head", partial(devices.lying_flutes, count=14)),
    },
    "water tower": {
        "seams": Marking("tank", partial(boards.staves, count=18)),
        "ridges": Marking("roof", partial(craft.spokes, count=12, wide=0.014, reach=(0.12, 2.0))),
    },
    "hot air balloon": {
        "belts": Marking("balloon", partial(fronts.belts, spans=machines.BALLOON_BELTS)),
        "panels": Marking("balloon", partial(balls.sectors, count=7)),
        "weave": Marking("basket", partial(boards.weave, around=20, rows=6)),
    },
    "bomb": {
        "skull": Marking("body", partial(outlines.laid, **machines.BOMB_SKULL)),
    },
    "pistol": {
        "grooves": Marking("barrel", partial(outlines.laid, **machines.PISTOL_GROOVES)),
        "port": Marking("barrel", partial(outlines.laid, **machines.PISTOL_PORT)),
        "ridges": Marking("grip", partial(outlines.laid, **machines.PISTOL_RIDGES)),
    },
    "wheel": {
        "stripe": Marking("tyre", partial(outlines.laid, **machines.TYRE_STRIPE)),
    },
    "robot arm": {
        "stripes": Marking("base", machines.foot_stripes),
    },
    "satellite dish": {
        "seams": Marking("dish", machines.dish_seams),
    },
    "computer mouse": {
        "grips": Marking("body", partial(outlines.laid, **devices.MOUSE_GRIPS)),
    },
    "rifle": {
        "port": Marking("body", partial(outlines.laid, **machines.RIFLE_PORT)),
        "bands": Marking("stock", partial(fronts.belts, spans=machines.BUTT_BANDS, axis=0)),
    },
}
