"""Markings of ware, lamps, clocks, fixtures and small things of a house."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    craft,
    decor,
    devices,
    fittings,
    fronts,
    homely,
    outlines,
    prints,
    wares,
)
from core.guidance.builtin.markings.marking import Marking, Rows

JUG_BANDS = ((-0.5, -0.06), (-0.02, 0.01), (-0.57, -0.54))
HOUSEHOLD: Rows = {
    "mug": {"bands": Marking("body", partial(fronts.belts, spans=decor.MUG_BANDS))},
    "bottle": {
        "badge": Marking("label", partial(outlines.laid, **fittings.LABEL_BADGE)),
        "bands": Marking("label", partial(fronts.belts, spans=fittings.BOTTLE_BANDS)),
        "label": Marking("body", partial(fronts.belt, low=-0.75, high=-0.12)),
    },
    "bowl": {"bands": Marking("body", partial(fronts.belts, spans=decor.BOWL_BANDS))},
    "teapot": {
        "bands": Marking("body", partial(fronts.belts, spans=decor.TEAPOT_BANDS)),
    },
    "kettle": {
        "lines": Marking("body", partial(fronts.belts, spans=devices.KETTLE_BANDS)),
    },
    "stove": {
        "racks": Marking("window", partial(outlines.laid, **fittings.OVEN_RACKS)),
        "coils": Marking("plates", partial(outlines.laid, **fittings.OVEN_COILS), by="body"),
        "seams": Marking("body", partial(outlines.laid, **fittings.OVEN_SEAMS)),
    },
    "refrigerator": {
        "magnets": Marking("doors", partial(outlines.laid, **fittings.FRIDGE_MAGNETS), by="body"),
        "note": Marking("doors", partial(outlines.laid, **fittings.FRIDGE_NOTE), by="body"),
        "coils": Marking("body", partial(outlines.laid, **fittings.FRIDGE_COILS)),
    },
    "microwave": {
        "digits": Marking("display", partial(outlines.laid, **fittings.MICROWAVE_DIGITS)),
        "display": Marking("body", partial(outlines.laid, **fittings.MICROWAVE_DISPLAY)),
        "buttons": Marking("body", partial(outlines.laid, **fittings.MICROWAVE_BUTTONS)),
        "mesh": Marking("window", partial(outlines.laid, **fittings.MICROWAVE_MESH)),
        "seams": Marking("body", partial(outlines.laid, **fittings.MICROWAVE_SEAMS)),
    },
    "blender": {
        "marks": Marking("jug", partial(outlines.laid, **devices.JUG_MARKS)),
        "trim": Marking("base", partial(fronts.belts, spans=devices.BLENDER_TRIM)),
    },
    "door": {
        "trim": Marking("panels", homely.door_trim),
        "keyhole": Marking("lock plate", partial(outlines.laid, **homely.DOOR_KEYHOLE)),
        "lock plate": Marking("door", partial(outlines.laid, **homely.DOOR_LOCK)),
        "hinges": Marking("door", partial(outlines.laid, **homely.DOOR_HINGES)),
    },
    "window": {
        "slats": Marking("shutters", partial(outlines.laid, **decor.SLATS), paired=True),
    },
    "toilet": {
        "water": Marking(
            "body", partial(homely.pool_water, size=(0.5, 0.43), at=-0.17, high=(0.2, 1.2))
        ),
        "seams": Marking("tank", partial(outlines.laid, **homely.TOILET_SEAMS)),
        "hinges": Marking("seat", partial(outlines.laid, **homely.TOILET_HINGES)),
    },
    "bathtub": {
        "foam": Marking("water", homely.foam),
        "bands": Marking("body", partial(fronts.belts, spans=homely.BATH_BANDS)),
    },
    "sink": {
        "drain": Marking(
            "basin", partial(homely.pool_water, size=(0.1, 0.13), at=-0.1, high=(-0.9, 1.2))
        ),
        "seams": Marking("basin", partial(outlines.laid, **homely.SINK_PANEL)),
        "bands": Marking("column", partial(fronts.belts, spans=homely.SINK_BANDS)),
    },
    "washing machine": {
        "lights": Marking("panel", partial(outlines.laid, **fittings.PANEL_LIGHTS)),
        "seams": Marking("body", partial(outlines.laid, **fittings.WASHER_SEAMS)),
    },
    "bucket": {
        "bands": Marking("body", partial(fronts.belts, spans=wares.BUCKET_BANDS)),
        "rivets": Marking("bands", partial(wares.studs, count=12, size=0.018, at=0.52)),
    },
    "trash can": {
        "flutes": Marking("body", partial(craft.flutes, count=14, share=0.34, high=0.84)),
    },
    "fan": {
        "buttons": Marking("stand", partial(outlines.laid, **devices.FAN_BUTTONS)),
        "badge": Marking("hub", partial(outlines.laid, **devices.FAN_BADGE)),
    },
    "safe": {
        "marks": Marking("dial", partial(fronts.hours, radius=1.0)),
        "rivets": Marking("body", partial(outlines.laid, **fittings.SAFE_RIVETS)),
    },
    "disco ball": {"gaps": Marking("body", balls.mirror_gaps)},
    "clock": {
        "face": Marking("body", partial(fronts.disc, radius=0.79)),
        "marks": Marking("face", partial(fronts.hours, radius=0.79)),
    },
    "alarm clock": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "trophy": {
        "plaque": Marking("base", partial(outlines.laid, **craft.PLAQUE)),
        "star": Marking("cup", partial(outlines.laid, **craft.CUP_STAR)),
    },
    "bell": {"bands": Marking("body", partial(fronts.belts, spans=decor.BELL_BANDS))},
    "globe": {
        "ice": Marking("ocean", partial(balls.poles, lean=23)),
        "land": Marking("ocean", partial(balls.lands, lean=23)),
    },
    **{
        noun: {"sun": Marking("picture", prints.sun), "hills": Marking("picture", prints.hills)}
        for noun in ("picture frame", "easel")
    },
    "crown": {"borders": Marking("band", partial(fronts.belts, spans=decor.CROWN_BANDS))},
    "hat": {
        "buckle": Marking("ribbon", partial(outlines.laid, **wares.HAT_BUCKLE)),
        "piping": Marking("body", partial(wares.brim, low=0.955, high=2.0)),
    },
    "remote control": {
        "seams": Marking("body", partial(outlines.laid, **craft.REMOTE_SEAMS)),
    },
    "perfume": {
        "monogram": Marking("label", partial(outlines.laid, **wares.LABEL_FLOWER)),
        "border": Marking("label", partial(outlines.laid, **wares.LABEL_EDGE)),
        "grooves": Marking("collar", partial(fronts.belts, spans=wares.COLLAR_GROOVES)),
    },
    "jug": {
        "band": Marking("body", partial(fronts.belts, spans=JUG_BANDS)),
        "collar": Marking("body", partial(fronts.belts, spans=((0.44, 0.53), (0.57, 0.59)))),
    },
    "plate": {"rim": Marking("body", fronts.plate_rings)},
    "paper cup": {"badge": Marking("sleeve", partial(prints.badge, radius=0.38, shape="leaf"))},
    "counter": {"panels": Marking("body", partial(outlines.laid, **decor.COUNTER_PANELS))},
    "rug": {
        "middle": Marking("border", prints.rug_middle),
        "lozenge": Marking("border", prints.rug_lozenge),
        "field": Marking("border", prints.rug_field),
    },
    "curtain": {"hems": Marking("curtain", partial(fronts.belts, spans=decor.HEMS))},
    "lipstick": {
        "monogram": Marking("case", partial(outlines.laid, **wares.MONOGRAM)),
        "lines": Marking("case", partial(fronts.belts, spans=wares.CASE_LINES)),
        "grooves": Marking("tube", partial(fronts.belts, spans=wares.TUBE_GROOVES)),
    },
    "ruler": {"marks": Marking("body", prints.inches)},
    "envelope": {
        "stamp": Marking("body", partial(outlines.laid, **decor.STAMP)),
        "address": Marking("body", partial(outlines.laid, **decor.ADDRESS)),
    },
    "clipboard": {
        "boxes": Marking("paper", prints.ticked),
        "lines": Marking("paper", prints.ruled),
    },
    "notice board": {
        "lines": Marking("paper", partial(fittings.hoops, pitch=0.058, wide=0.009)),
        "words": Marking("notes", partial(fittings.hoops, pitch=0.058, wide=0.009)),
    },
    "map pin": {"star": Marking("disc", partial(outlines.laid, **wares.PIN_RING))},
    "flask": {"marks": Marking("glass", prints.scale_marks)},
    "first aid kit": {
        "cross": Marking("body", partial(prints.stamp, shape="cross", size=0.42, at=(0.0, -0.1)))
    },
    "pocket watch": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "cassette": {
        "reels": Marking("window", prints.reels),
        "window": Marking("label", partial(prints.oblong, at=0.1, size=(0.62, 0.24))),
        "stripe": Marking("label", partial(prints.oblong, at=0.6, size=(2.0, 0.07))),
        "label": Marking("body", partial(prints.oblong, at=0.2, size=(0.86, 0.6))),
    },
    "vinyl record": {
        "hole": Marking("label", partial(fronts.rings, spans=((-1, 0.045),))),
        "label": Marking("disc", partial(fronts.rings, spans=((-1, 0.33),))),
        "grooves": Marking("disc", partial(fronts.rings, spans=craft.RECORD_GROOVES)),
    },
}
