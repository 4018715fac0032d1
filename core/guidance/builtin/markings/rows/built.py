"""What is built: vehicles, machines, furniture."""

from functools import partial

from core.guidance.builtin.markings import boards, bodywork, fittings, fronts, outlines
from core.guidance.builtin.markings.marking import Marking, Rows

BUILT: Rows = {
    "car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "number plates": Marking("body", partial(outlines.laid, **bodywork.CAR_PLATES)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.CAR_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.CAR_TRIM)),
    },
    "van": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.VAN_WINDOWS)),
        "number plates": Marking("body", partial(outlines.laid, **bodywork.VAN_PLATES)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.VAN_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.VAN_TRIM)),
    },
    "bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.BUS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.BUS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.BUS_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.27, high=-0.13)),
    },
    "truck": {
        "windows": Marking("cab", partial(bodywork.windows, **bodywork.TRUCK_WINDOWS)),
        "lamps": Marking("cab", partial(outlines.laid, **bodywork.TRUCK_LAMPS)),
        "trim": Marking("cab", partial(outlines.laid, **bodywork.TRUCK_TRIM)),
        "seams": Marking("cargo", partial(outlines.laid, **bodywork.CARGO_SEAMS)),
    },
    "sports car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.SPORTS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.SPORTS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.SPORTS_TRIM)),
    },
    "pickup truck": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.PICKUP_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.PICKUP_TAIL)),
        "seams": Marking("body", partial(outlines.laid, **bodywork.PICKUP_SEAMS)),
    },
    "robot": {
        "mouth": Marking("head", partial(outlines.laid, **bodywork.MOUTH)),
        "buttons": Marking("body", partial(outlines.laid, **bodywork.ROBOT_BUTTONS)),
    },
    "race car": {
        "number": Marking("body", partial(bodywork.race_number, text="7")),
        "visor": Marking("helmet", partial(outlines.laid, **bodywork.VISOR)),
    },
    "train": {
        "windows": Marking("cab", partial(bodywork.windows, **bodywork.TRAIN_WINDOWS)),
        "bands": Marking("boiler", partial(fronts.belts, spans=bodywork.BOILER_BANDS, axis=1)),
    },
    "tank": {
        "star": Marking("turret", partial(outlines.laid, **bodywork.TANK_STAR)),
        "links": Marking("tracks", bodywork.links),
        "vents": Marking("hull", partial(outlines.laid, **bodywork.TANK_VENTS)),
    },
    "book": {
        "badge": Marking("cover", partial(outlines.laid, **fittings.BOOK_BADGE), by="pages"),
        "border": Marking("cover", partial(outlines.laid, **fittings.BOOK_BORDER), by="pages"),
        "lines": Marking("pages", partial(boards.planks, count=7, axis=1)),
    },
    "television": {
        "glare": Marking("screen", fittings.glare),
        "slots": Marking("body", partial(outlines.laid, **fittings.TV_SLOTS)),
    },
    "laptop": {
        "icons": Marking("screen", partial(outlines.laid, **fittings.LAPTOP_ICONS)),
        "badge": Marking("body", partial(outlines.laid, **fittings.LAPTOP_BADGE)),
    },
    "monitor": {
        "icons": Marking("screen", partial(outlines.laid, **fittings.LAPTOP_ICONS)),
        "slots": Marking("body", partial(outlines.laid, **fittings.TV_SLOTS)),
    },
    "speaker": {
        "caps": Marking("cones", partial(fittings.cone_rings, spans=((-1.0, 0.3),)), by="body"),
        "rings": Marking(
            "cones", partial(fittings.cone_rings, spans=((0.45, 0.53), (0.68, 0.76))), by="body"
        ),
    },
    "camera": {
        "rings": Marking("lens", partial(fronts.belts, spans=fittings.LENS_RINGS, axis=1)),
        "screen": Marking("grip", partial(outlines.laid, **fittings.CAMERA_SCREEN)),
    },
    "refrigerator": {
        "magnets": Marking("doors", partial(outlines.laid, **fittings.FRIDGE_MAGNETS), by="body"),
        "note": Marking("doors", partial(outlines.laid, **fittings.FRIDGE_NOTE), by="body"),
        "coils": Marking("body", partial(outlines.laid, **fittings.FRIDGE_COILS)),
    },
    "washing machine": {
        "lights": Marking("panel", partial(outlines.laid, **fittings.PANEL_LIGHTS)),
        "seams": Marking("body", partial(outlines.laid, **fittings.WASHER_SEAMS)),
    },
    "stove": {
        "racks": Marking("window", partial(outlines.laid, **fittings.OVEN_RACKS)),
        "coils": Marking("plates", partial(outlines.laid, **fittings.OVEN_COILS), by="body"),
        "seams": Marking("body", partial(outlines.laid, **fittings.OVEN_SEAMS)),
    },
    "microwave": {
        "digits": Marking("display", partial(outlines.laid, **fittings.MICROWAVE_DIGITS)),
        "display": Marking("body", partial(outlines.laid, **fittings.MICROWAVE_DISPLAY)),
        "buttons": Marking("body", partial(outlines.laid, **fittings.MICROWAVE_BUTTONS)),
        "mesh": Marking("window", partial(outlines.laid, **fittings.MICROWAVE_MESH)),
        "seams": Marking("body", partial(outlines.laid, **fittings.MICROWAVE_SEAMS)),
    },
    "vending machine": {
        "letters": Marking("body", partial(fronts.on_sides, text="DRINKS", high=0.34, at=(0, 0.5))),
        "stripes": Marking("body", partial(outlines.laid, **fittings.VENDING_STRIPES)),
    },
    "safe": {
        "marks": Marking("dial", partial(fronts.hours, radius=1.0)),
        "rivets": Marking("body", partial(outlines.laid, **fittings.SAFE_RIVETS)),
    },
    "cabinet": {
        "panels": Marking("doors", fittings.door_panels, paired=True),
    },
    "wardrobe": {
        "panels": Marking("doors", partial(outlines.laid, **fittings.WARDROBE_PANELS), by="body"),
    },
    "bookshelf": {
        "bands": Marking("books", partial(fronts.belts, spans=fittings.BOOK_BANDS), by="frame"),
        "labels": Marking("volumes", partial(fronts.belts, spans=fittings.BOOK_LABELS), by="frame"),
        "stripes": Marking("tomes", partial(fronts.belts, spans=fittings.BOOK_STRIPES), by="frame"),
    },
    "bed": {
        "stripes": Marking(
            "blanket", partial(fronts.belts, spans=fittings.BLANKET_STRIPES, axis=1)
        ),
        "panels": Marking("frame", partial(outlines.laid, **fittings.BED_PANELS)),
    },
    "sofa": {
        "buttons": Marking("back", partial(outlines.laid, **fittings.SOFA_BUTTONS)),
        "piping": Marking("arms", partial(outlines.laid, **fittings.ARM_PIPING), paired=True),
    },
    "armchair": {
        "buttons": Marking("back", partial(outlines.laid, **fittings.CHAIR_BUTTONS)),
        "piping": Marking("arms", partial(outlines.laid, **fittings.ARM_PIPING), paired=True),
    },
    "can": {
        "badge": Marking("label", partial(outlines.laid, **fittings.CAN_BADGE)),
        "wave": Marking("label", partial(fittings.wave, high=0.16, wide=0.5)),
    },
    "bottle": {
        "badge": Marking("label", partial(outlines.laid, **fittings.LABEL_BADGE)),
        "bands": Marking("label", partial(fronts.belts, spans=fittings.BOTTLE_BANDS)),
        "label": Marking("body", partial(fronts.belt, low=-0.75, high=-0.12)),
    },
    "suitcase": {
        "stickers": Marking("body", partial(outlines.laid, **fittings.STICKERS)),
        "seam": Marking("body", partial(fronts.belt, low=-0.05, high=0.05, axis=1)),
    },
    "backpack": {
        "badge": Marking("pocket", partial(outlines.laid, **fittings.POCKET_BADGE)),
        "zips": Marking("pocket", partial(outlines.laid, **fittings.POCKET_ZIPS)),
    },
    "traffic light": {
        "border": Marking("body", partial(outlines.laid, **fittings.LIGHT_BORDER)),
    },
    "mailbox": {
        "letters": Marking(
            "box", partial(fronts.on_sides, text="MAIL", high=0.3, at=(0.36, -0.12))
        ),
        "slots": Marking("door", partial(outlines.laid, **fittings.MAIL_SEAMS)),
    },
    "notice board": {
        "lines": Marking("paper", partial(fittings.hoops, pitch=0.058, wide=0.009)),
        "words": Marking("notes", partial(fittings.hoops, pitch=0.058, wide=0.009)),
    },
    "gift": {
        "dots": Marking("box", partial(outlines.laid, **fittings.GIFT_DOTS)),
    },
}
