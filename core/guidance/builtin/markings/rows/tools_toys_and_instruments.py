"""Markings of tools, toys and musical instruments."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    cubes,
    faces,
    frames,
    lattices,
    lettering,
    planks,
    rings,
    tiles,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.creature_parts import GLINTS, face_lines, feathers
from core.guidance.builtin.markings.rows.outlines import tools_toys_and_instruments as own

STICKERS = ("reds", "blues", "greens", "whites", "yellows", "oranges")
TOOLS_TOYS_AND_INSTRUMENTS: Rows = {
    "hammer": {
        "ridges": Marking("grip", partial(bands.belts, spans=own.HAMMER_RIDGES)),
        "grip": Marking("handle", partial(bands.belt, low=-1.2, high=-0.16)),
        "bands": Marking("head", partial(bands.belts, spans=own.HAMMER_BANDS, axis=0)),
    },
    "axe": {
        "edge": Marking("head", bands.cutting_edge),
        "wraps": Marking("handle", partial(bands.belts, spans=own.HANDLE_WRAPS)),
    },
    "saw": {"letters": Marking("blade", partial(outlines.laid, **own.SAW_NAME))},
    "toolbox": {
        "letters": Marking("body", partial(lettering.lettered, **own.TOOLS)),
    },
    "pencil": {
        "letters": Marking("body", partial(lettering.written_up, text="HB 2", high=0.95, at=0.4)),
        "rings": Marking("body", partial(bands.belts, spans=own.PENCIL_RINGS)),
        "bands": Marking("ferrule", partial(bands.belts, spans=own.FERRULE_BANDS)),
    },
    "broom": {"lines": Marking("bristles", partial(planks.staves, count=22, wide=0.006))},
    "knife": {
        "edge": Marking("blade", partial(frames.polygon, corners=own.KNIFE_EDGE)),
        "bolster": Marking("handle", partial(bands.belt, low=0.8, high=1.2)),
    },
    "telescope": {
        "rings": Marking("tube", partial(bands.hoops_along, spans=own.TELESCOPE_RINGS)),
        "stars": Marking("tube", partial(outlines.laid, **own.TELESCOPE_STARS)),
    },
    "robot": {
        "mouth": Marking("head", partial(outlines.laid, **own.MOUTH)),
        "buttons": Marking("body", partial(outlines.laid, **own.ROBOT_BUTTONS)),
    },
    "rocking horse": {
        **GLINTS,
        "mouth": face_lines(
            "body", ((-9.0, -4.8), (-4.6, -4.8), (-3.4, -4.3)), side=True, wide=0.2
        ),
    },
    "puzzle cube": {
        name: Marking("body", partial(cubes.stickers, color=k)) for k, name in enumerate(STICKERS)
    },
    "rubber duck": {
        **feathers(way=(0.0, 1.0, 0.4), short=(-0.4, 0.1), rows=1),
        "glints": Marking("pupils", partial(faces.eye_glints, way=(0.1, -0.95, 0.35)), paired=True),
    },
    "dice": {"pips": Marking("body", cubes.pips)},
    "chess rook": {"joints": Marking("body", tiles.bricks)},
    "basketball hoop": {
        "square": Marking("board", partial(frames.frame, at=-0.1, size=(0.62, 0.45), wide=0.07))
    },
    "tennis racket": {"gaps": Marking("strings", lattices.net_gaps)},
    "guitar": {
        "frets": Marking("neck", planks.frets),
        "rosette": Marking("neck", rings.rosette),
        "pickguard": Marking("body", partial(outlines.laid, **own.GUITAR_GUARD)),
    },
    **{
        noun: {"frets": Marking("neck", planks.frets)}
        for noun in ("ukulele", "banjo", "electric guitar")
    },
    "violin": {"holes": Marking("body", badges.f_holes)},
    "drum": {
        "badge": Marking("shell", partial(outlines.laid, **own.DRUM_BADGE)),
        "cords": Marking("shell", partial(bands.zigzag, count=8, high=0.8, wide=0.016)),
    },
    "drum kit": {
        "star": Marking("badge", partial(outlines.laid, **own.BADGE_STAR)),
        "rings": Marking("skins", partial(rings.rim, low=0.8, high=0.88)),
    },
}
