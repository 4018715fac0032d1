"""Markings of tools, toys and musical instruments."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    boards,
    bodywork,
    craft,
    creatures,
    decor,
    devices,
    fronts,
    outlines,
    prints,
    wares,
)
from core.guidance.builtin.markings.features import GLINTS, feathers, lines
from core.guidance.builtin.markings.marking import Marking, Rows

STICKERS = ("reds", "blues", "greens", "whites", "yellows", "oranges")
TOOLS_TOYS_AND_INSTRUMENTS: Rows = {
    "hammer": {
        "ridges": Marking("grip", partial(fronts.belts, spans=wares.HAMMER_RIDGES)),
        "grip": Marking("handle", partial(fronts.belt, low=-1.2, high=-0.16)),
        "bands": Marking("head", partial(fronts.belts, spans=wares.HAMMER_BANDS, axis=0)),
    },
    "axe": {
        "edge": Marking("head", decor.cutting_edge),
        "wraps": Marking("handle", partial(fronts.belts, spans=decor.HANDLE_WRAPS)),
    },
    "saw": {"letters": Marking("blade", partial(outlines.laid, **wares.SAW_NAME))},
    "toolbox": {
        "letters": Marking("body", partial(fronts.lettered, **craft.TOOLS)),
    },
    "pencil": {
        "letters": Marking("body", partial(wares.written_up, text="HB 2", high=0.95, at=0.4)),
        "rings": Marking("body", partial(fronts.belts, spans=wares.PENCIL_RINGS)),
        "bands": Marking("ferrule", partial(fronts.belts, spans=wares.FERRULE_BANDS)),
    },
    "broom": {"lines": Marking("bristles", partial(boards.staves, count=22, wide=0.006))},
    "knife": {
        "edge": Marking("blade", partial(wares.through, corners=wares.KNIFE_EDGE)),
        "bolster": Marking("handle", partial(fronts.belt, low=0.8, high=1.2)),
    },
    "telescope": {
        "rings": Marking("tube", partial(devices.hoops_along, spans=devices.TELESCOPE_RINGS)),
        "stars": Marking("tube", partial(outlines.laid, **devices.TELESCOPE_STARS)),
    },
    "robot": {
        "mouth": Marking("head", partial(outlines.laid, **bodywork.MOUTH)),
        "buttons": Marking("body", partial(outlines.laid, **bodywork.ROBOT_BUTTONS)),
    },
    "rocking horse": {
        **GLINTS,
        "mouth": lines("body", ((-9.0, -4.8), (-4.6, -4.8), (-3.4, -4.3)), side=True, wide=0.2),
    },
    "puzzle cube": {
        name: Marking("body", partial(balls.stickers, color=k)) for k, name in enumerate(STICKERS)
    },
    "rubber duck": {
        **feathers(way=(0.0, 1.0, 0.4), short=(-0.4, 0.1), rows=1),
        "glints": Marking("pupils", partial(creatures.glints, way=(0.1, -0.95, 0.35)), paired=True),
    },
    "dice": {"pips": Marking("body", balls.pips)},
    "chess rook": {"joints": Marking("body", decor.bricks)},
    "basketball hoop": {
        "square": Marking("board", partial(fronts.frame, at=-0.1, size=(0.62, 0.45), wide=0.07))
    },
    "tennis racket": {"gaps": Marking("strings", prints.net_gaps)},
    "guitar": {
        "frets": Marking("neck", boards.frets),
        "rosette": Marking("neck", craft.rosette),
        "pickguard": Marking("body", partial(outlines.laid, **craft.GUITAR_GUARD)),
    },
    **{
        noun: {"frets": Marking("neck", boards.frets)}
        for noun in ("ukulele", "banjo", "electric guitar")
    },
    "violin": {"holes": Marking("body", prints.f_holes)},
    "drum": {
        "badge": Marking("shell", partial(outlines.laid, **craft.DRUM_BADGE)),
        "cords": Marking("shell", partial(craft.zigzag, count=8, high=0.8, wide=0.016)),
    },
    "drum kit": {
        "star": Marking("badge", partial(outlines.laid, **wares.BADGE_STAR)),
        "rings": Marking("skins", partial(fronts.rim, low=0.8, high=0.88)),
    },
}
