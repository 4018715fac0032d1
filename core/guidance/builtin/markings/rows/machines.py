"""Machines, vehicles, devices."""

from functools import partial

from core.guidance.builtin.markings import fronts, machines, outlines
from core.guidance.builtin.markings.marking import Marking, Rows

MACHINES: Rows = {
    "phone booth": {
        "letters": Marking("sign", partial(outlines.laid, **machines.BOOTH_LETTERS)),
        "sign": Marking("body", partial(outlines.laid, **machines.BOOTH_SIGN)),
        "windows": Marking("body", partial(outlines.laid, **machines.BOOTH_WINDOWS)),
        "seams": Marking("body", partial(outlines.laid, **machines.BOOTH_SEAMS)),
    },
    "arcade machine": {
        "marquee": Marking("body", partial(outlines.laid, **machines.ARCADE_MARQUEE)),
        "pixels": Marking("screen", partial(outlines.laid, **machines.ARCADE_PIXELS)),
        "stripes": Marking("body", partial(outlines.laid, **machines.ARCADE_STRIPES)),
    },
    "slot machine": {
        "sevens": Marking("reels", machines.reel_sevens),
        "badges": Marking("cabinet", partial(outlines.laid, **machines.SLOT_BADGES)),
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
        "letters": Marking("screen", partial(outlines.laid, **machines.COMPUTER_LETTERS)),
        "vents": Marking("body", partial(outlines.laid, **machines.COMPUTER_VENTS)),
    },
    "game console": {
        "pixels": Marking("screen", partial(outlines.laid, **machines.CONSOLE_PIXELS)),
        "lamp": Marking("bezel", partial(outlines.laid, **machines.CONSOLE_LAMP)),
    },
    "keyboard": {
        "letters": Marking("keys", partial(outlines.laid, **machines.KEY_LETTERS), by="body"),
    },
    "calculator": {
        "digits": Marking(
            "display", partial(outlines.laid, **machines.CALCULATOR_DIGITS), by="body"
        ),
        "numbers": Marking(
            "keys", partial(outlines.laid, **machines.CALCULATOR_NUMBERS), by="body"
        ),
        "symbols": Marking(
            "accents", partial(outlines.laid, **machines.CALCULATOR_SYMBOLS), by="body"
        ),
    },
}
