"""Markings of tableware, lamps, clocks, fixtures and small household things."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    dials,
    drums,
    frames,
    globes,
    lines,
    pictures,
    rings,
    studs,
    tiles,
    toppings,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import electronics
from core.guidance.builtin.markings.rows.outlines import household as own

JUG_BANDS = ((-0.5, -0.06), (-0.02, 0.01), (-0.57, -0.54))
HOUSEHOLD: Rows = {
    "mug": {"bands": Marking("body", partial(bands.belts, spans=own.MUG_BANDS))},
    "bottle": {
        "badge": Marking("label", partial(outlines.laid, **own.LABEL_BADGE)),
        "bands": Marking("label", partial(bands.belts, spans=own.BOTTLE_BANDS)),
        "label": Marking("body", partial(bands.belt, low=-0.75, high=-0.12)),
    },
    "bowl": {"bands": Marking("body", partial(bands.belts, spans=own.BOWL_BANDS))},
    "teapot": {
        "bands": Marking("body", partial(bands.belts, spans=own.TEAPOT_BANDS)),
    },
    "kettle": {
        "lines": Marking("body", partial(bands.belts, spans=own.KETTLE_BANDS)),
    },
    "stove": {
        "racks": Marking("window", partial(outlines.laid, **own.OVEN_RACKS)),
        "coils": Marking("plates", partial(outlines.laid, **own.OVEN_COILS), by="body"),
        "seams": Marking("body", partial(outlines.laid, **own.OVEN_SEAMS)),
    },
    "refrigerator": {
        "magnets": Marking("doors", partial(outlines.laid, **own.FRIDGE_MAGNETS), by="body"),
        "note": Marking("doors", partial(outlines.laid, **own.FRIDGE_NOTE), by="body"),
        "coils": Marking("body", partial(outlines.laid, **own.FRIDGE_COILS)),
    },
    "microwave": {
        "digits": Marking("display", partial(outlines.laid, **own.MICROWAVE_DIGITS)),
        "display": Marking("body", partial(outlines.laid, **own.MICROWAVE_DISPLAY)),
        "buttons": Marking("body", partial(outlines.laid, **own.MICROWAVE_BUTTONS)),
        "mesh": Marking("window", partial(outlines.laid, **own.MICROWAVE_MESH)),
        "seams": Marking("body", partial(outlines.laid, **own.MICROWAVE_SEAMS)),
    },
    "blender": {
        "marks": Marking("jug", partial(outlines.laid, **own.JUG_MARKS)),
        "trim": Marking("base", partial(bands.belts, spans=own.BLENDER_TRIM)),
    },
    "sci-fi door": {
        "lights": Marking("frame", partial(outlines.laid, **own.SCIFI_LIGHTS)),
        "stripes": Marking("frame", partial(outlines.laid, **own.SCIFI_STRIPES)),
        "seam": Marking("door", partial(outlines.laid, **own.SCIFI_SEAM)),
        "lines": Marking("panels", partial(outlines.laid, **own.SCIFI_LINES)),
    },
    "door": {
        "trim": Marking("panels", partial(frames.repeated, axes=(2,), room=0.067, **own.DOOR_TRIM)),
        "keyhole": Marking("lock plate", partial(outlines.laid, **own.DOOR_KEYHOLE)),
        "lock plate": Marking("door", partial(outlines.laid, **own.DOOR_LOCK)),
        "hinges": Marking("door", partial(outlines.laid, **own.DOOR_HINGES)),
    },
    "window": {
        "slats": Marking("shutters", partial(outlines.laid, **own.SLATS), paired=True),
    },
    "toilet": {
        "water": Marking(
            "body", partial(toppings.pool_water, size=(0.5, 0.43), at=-0.17, high=(0.2, 1.2))
        ),
        "seams": Marking("tank", partial(outlines.laid, **own.TOILET_SEAMS)),
        "hinges": Marking("seat", partial(outlines.laid, **own.TOILET_HINGES)),
    },
    "bathtub": {
        "foam": Marking("water", toppings.foam),
        "bands": Marking("body", partial(bands.belts, spans=own.BATH_BANDS)),
    },
    "sink": {
        "drain": Marking(
            "basin", partial(toppings.pool_water, size=(0.1, 0.13), at=-0.1, high=(-0.9, 1.2))
        ),
        "seams": Marking("basin", partial(outlines.laid, **own.SINK_PANEL)),
        "bands": Marking("column", partial(bands.belts, spans=own.SINK_BANDS)),
    },
    "washing machine": {
        "lights": Marking("panel", partial(outlines.laid, **own.PANEL_LIGHTS)),
        "seams": Marking("body", partial(outlines.laid, **own.WASHER_SEAMS)),
    },
    "bucket": {
        "bands": Marking("body", partial(bands.belts, spans=own.BUCKET_BANDS)),
        "rivets": Marking("bands", partial(studs.studs, count=12, size=0.018, at=0.52)),
    },
    "trash can": {
        "flutes": Marking("body", partial(lines.flutes, count=14, fraction=0.34, high=0.84)),
    },
    "fan": {
        "buttons": Marking("stand", partial(outlines.laid, **own.FAN_BUTTONS)),
        "badge": Marking("hub", partial(outlines.laid, **own.FAN_BADGE)),
    },
    "safe": {
        "marks": Marking("dial", partial(dials.hours, radius=1.0)),
        "rivets": Marking("body", partial(outlines.laid, **own.SAFE_RIVETS)),
    },
    "disco ball": {"gaps": Marking("body", tiles.mirror_gaps)},
    "clock": {
        "face": Marking("body", partial(rings.disc, radius=0.79)),
        "marks": Marking("face", partial(dials.hours, radius=0.79)),
    },
    "alarm clock": {"marks": Marking("face", partial(dials.hours, radius=1.0))},
    "trophy": {
        "plaque": Marking("base", partial(outlines.laid, **own.PLAQUE)),
        "star": Marking("cup", partial(outlines.laid, **own.CUP_STAR)),
    },
    "bell": {"bands": Marking("body", partial(bands.belts, spans=own.BELL_BANDS))},
    "globe": {
        "ice": Marking("ocean", partial(globes.poles, lean=23)),
        "land": Marking("ocean", partial(globes.lands, lean=23)),
    },
    **{
        noun: {"sun": Marking("picture", pictures.sun), "hills": Marking("picture", pictures.hills)}
        for noun in ("picture frame", "easel")
    },
    "crown": {"borders": Marking("band", partial(bands.belts, spans=own.CROWN_BANDS))},
    "hat": {
        "buckle": Marking("ribbon", partial(outlines.laid, **own.HAT_BUCKLE)),
        "piping": Marking("body", partial(bands.brim, low=0.955, high=2.0)),
    },
    "remote control": {
        "seams": Marking("body", partial(outlines.laid, **own.REMOTE_SEAMS)),
    },
    "perfume": {
        "monogram": Marking("label", partial(outlines.laid, **own.LABEL_FLOWER)),
        "border": Marking("label", partial(outlines.laid, **own.LABEL_EDGE)),
        "grooves": Marking("collar", partial(bands.belts, spans=own.COLLAR_GROOVES)),
    },
    "jug": {
        "band": Marking("body", partial(bands.belts, spans=JUG_BANDS)),
        "collar": Marking("body", partial(bands.belts, spans=((0.44, 0.53), (0.57, 0.59)))),
    },
    "plate": {"rim": Marking("body", rings.plate_rings)},
    "paper cup": {"badge": Marking("sleeve", partial(badges.badge, radius=0.38, shape="leaf"))},
    "counter": {"panels": Marking("body", partial(outlines.laid, **own.COUNTER_PANELS))},
    "rug": {
        "middle": Marking("border", frames.rug_middle),
        "lozenge": Marking("border", frames.rug_lozenge),
        "field": Marking("border", frames.rug_field),
    },
    "curtain": {"hems": Marking("curtain", partial(bands.belts, spans=own.HEMS))},
    "lipstick": {
        "monogram": Marking("case", partial(outlines.laid, **own.MONOGRAM)),
        "lines": Marking("case", partial(bands.belts, spans=own.CASE_LINES)),
        "grooves": Marking("tube", partial(bands.belts, spans=own.TUBE_GROOVES)),
    },
    "ruler": {"marks": Marking("body", dials.inches)},
    "envelope": {
        "stamp": Marking("body", partial(outlines.laid, **own.STAMP)),
        "address": Marking("body", partial(outlines.laid, **own.ADDRESS)),
    },
    "clipboard": {
        "boxes": Marking("paper", lines.ticked),
        "lines": Marking("paper", lines.ruled),
    },
    "notice board": {
        "lines": Marking("paper", partial(lines.levels, pitch=0.058, wide=0.009)),
        "words": Marking("notes", partial(lines.levels, pitch=0.058, wide=0.009)),
    },
    "map pin": {"star": Marking("disc", partial(outlines.laid, **own.PIN_RING))},
    "flask": {"marks": Marking("glass", dials.scale_marks)},
    "first aid kit": {
        "cross": Marking("body", partial(badges.stamp, shape="cross", size=0.42, at=(0.0, -0.1)))
    },
    "pocket watch": {"marks": Marking("face", partial(dials.hours, radius=1.0))},
    "cassette": {
        "reels": Marking("window", pictures.reels),
        "window": Marking("label", partial(frames.oblong, at=0.1, size=(0.62, 0.24))),
        "stripe": Marking("label", partial(frames.oblong, at=0.6, size=(2.0, 0.07))),
        "label": Marking("body", partial(frames.oblong, at=0.2, size=(0.86, 0.6))),
    },
    "compact disc": {
        "hole": Marking("disc", partial(rings.rings, spans=((-1, 0.1),))),
        "hub": Marking("disc", partial(rings.rings, spans=((0.1, 0.28),))),
        "greens": Marking("disc", partial(drums.wedges, at=(62, 242), wide=9, low=0.32)),
        "rays": Marking("disc", partial(drums.wedges, at=(40, 220), wide=14, low=0.32)),
    },
    "vinyl record": {
        "hole": Marking("label", partial(rings.rings, spans=((-1, 0.045),))),
        "label": Marking("disc", partial(rings.rings, spans=((-1, 0.33),))),
        "grooves": Marking("disc", partial(rings.rings, spans=electronics.RECORD_GROOVES)),
    },
}
