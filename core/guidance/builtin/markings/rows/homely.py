"""What is of the home, and what is eaten, worn or wielded."""

from functools import partial

from core.guidance.builtin.markings import (
    boards,
    craft,
    decor,
    facades,
    fittings,
    fronts,
    homely,
    outlines,
    wares,
)
from core.guidance.builtin.markings.margins import blobs
from core.guidance.builtin.markings.marking import Marking, Rows

HOMELY: Rows = {
    "door": {
        "trim": Marking("panels", homely.door_trim),
        "keyhole": Marking("lock plate", partial(outlines.laid, **homely.DOOR_KEYHOLE)),
        "lock plate": Marking("door", partial(outlines.laid, **homely.DOOR_LOCK)),
        "hinges": Marking("door", partial(outlines.laid, **homely.DOOR_HINGES)),
    },
    "well": {
        "boards": Marking("roof", partial(outlines.laid, **homely.WELL_GABLE)),
        "seams": Marking("roof", partial(facades.tiles, axis=1)),
        "rope": Marking("posts", partial(homely.coil, reach=0.4)),
    },
    "mirror": {
        "gems": Marking("frame", partial(outlines.laid, **homely.MIRROR_GEMS)),
        "backing": Marking("frame", partial(outlines.laid, **homely.MIRROR_BACK)),
        "glare": Marking("glass", fittings.glare),
    },
    "throne": {
        "buttons": Marking("cushion", partial(outlines.laid, **homely.THRONE_BUTTONS)),
        "gems": Marking("frame", partial(outlines.laid, **homely.THRONE_GEMS)),
        "panels": Marking("frame", partial(outlines.laid, **homely.THRONE_PANELS)),
        "border": Marking("step", partial(outlines.laid, **homely.THRONE_STEP)),
    },
    "coffin": {
        "nails": Marking(
            "lid", partial(homely.nailed, corners=homely.COFFIN_NAILS, count=5, size=0.055)
        ),
        "seams": Marking("edge", partial(outlines.laid, **homely.COFFIN_SEAMS)),
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
    "pool table": {
        "sights": Marking("frame", partial(outlines.laid, **homely.POOL_SIGHTS)),
        "lines": Marking("cloth", partial(outlines.laid, **homely.POOL_LINES)),
    },
    "chair": {
        "seams": Marking("seat", partial(outlines.laid, **homely.CHAIR_SEAMS), "wooden"),
    },
    "stool": {
        "band": Marking("seat", partial(fronts.belt, low=-0.55, high=0.05)),
        "seams": Marking("seat", partial(outlines.laid, **homely.CHAIR_SEAMS), "wooden"),
    },
    "ottoman": {
        "nails": Marking("base", partial(outlines.laid, **homely.OTTOMAN_NAILS)),
        "piping": Marking("cushion", partial(fronts.belt, low=-0.5, high=-0.2)),
    },
    "coffee table": {
        "seams": Marking("top", partial(outlines.laid, **homely.COFFEE_SEAMS), "wooden"),
    },
    "shelf": {
        "bands": Marking("books", partial(fronts.belts, spans=homely.SHELF_BANDS), by="board"),
        "volumes": Marking(
            "books", partial(fronts.belts, spans=homely.SHELF_VOLUMES, axis=0), by="board"
        ),
        "tomes": Marking(
            "books", partial(fronts.belts, spans=homely.SHELF_TOMES, axis=0), by="board"
        ),
        "stripes": Marking("vase", partial(fronts.belts, spans=homely.VASE_STRIPES)),
    },
    "four-poster bed": {
        "trim": Marking("canopy", partial(fronts.belts, spans=homely.BED_TRIM)),
        "quilting": Marking("blanket", partial(homely.quilt, pitch=0.12)),
    },
    "crib": {
        "hearts": Marking("frame", partial(outlines.laid, **homely.CRIB_HEARTS)),
        "stars": Marking("blanket", partial(outlines.laid, **homely.CRIB_STARS)),
    },
    "staircase": {
        "carpet": Marking("treads", partial(homely.carpet, wide=0.56)),
        "runner": Marking("body", partial(homely.carpet, wide=0.58, back=0.97)),
        "panels": Marking("body", partial(outlines.laid, **homely.STAIR_PANELS)),
    },
    "market stall": {
        "apples": Marking(
            "fruit", partial(fronts.belts, spans=homely.STALL_APPLES, axis=0), by="shelf"
        ),
        "panels": Marking("counter", partial(outlines.laid, **homely.STALL_PANELS)),
    },
    "temple": {
        "frieze": Marking("beam", partial(outlines.laid, **homely.TEMPLE_FRIEZE)),
        "seams": Marking("roof", partial(facades.tiles, axis=1, pitch=(0.07, 0.12), wide=0.005)),
    },
    "bridge": {
        "bands": Marking("posts", partial(fronts.belts, spans=homely.POST_BANDS)),
        "joints": Marking("road", partial(boards.planks, count=16, axis=0, wide=0.01)),
    },
    "fountain": {
        "tiles": Marking("basin", partial(homely.mosaic, spans=homely.BASIN_TILES, count=36)),
        "lines": Marking("bowl", partial(fronts.belts, spans=homely.BOWL_LINES)),
        "bands": Marking("column", partial(fronts.belts, spans=homely.COLUMN_BANDS)),
    },
    "hut": {
        "zigzags": Marking(
            "walls", partial(homely.zigzags, at=0.0, count=16, high=0.13, wide=0.022)
        ),
    },
    "gate": {
        "plaque": Marking("piers", partial(outlines.laid, **homely.PIER_PLAQUE), paired=True),
        "joints": Marking("piers", partial(facades.courses, pitch=(0.16, 0.26)), paired=True),
    },
    "wall": {"joints": Marking("base", partial(boards.planks, count=9, axis=0, wide=0.011))},
    "fence": {"nails": Marking("pickets", partial(homely.picket_nails, heights=(-0.5, 0.44)))},
    "cake": {
        "sprinkles": Marking("icing", wares.sprinkles),
        "cream": Marking("body", partial(fronts.belts, spans=wares.CAKE_CREAM)),
    },
    "cookie": {
        "dimples": Marking("body", partial(blobs, pitch=0.16, sizes=(0.016, 0.034), share=0.6)),
    },
    "cheese": {"label": Marking("rind", partial(outlines.laid, **wares.RIND_LABEL))},
    "pizza": {
        "specks": Marking("salami", partial(blobs, pitch=0.07, sizes=(0.009, 0.017), share=0.55)),
        "basil": Marking("cheese", partial(outlines.laid, **wares.BASIL)),
        "spots": Marking("cheese", partial(blobs, pitch=0.18, sizes=(0.02, 0.05), share=0.4)),
    },
    "sandwich": {
        "grill marks": Marking("bread", partial(wares.grill_marks, high=0.29), by="cheese"),
    },
    "ice cream": {
        "sprinkles": Marking("sauce", partial(wares.sprinkles, pitch=0.085)),
        "sauce": Marking("scoop", wares.sauce),
    },
    "chocolate bar": {
        "letters": Marking("label", partial(outlines.laid, **wares.WRAPPER_NAME)),
        "border": Marking("wrapper", partial(outlines.laid, **wares.WRAPPER_BORDER)),
    },
    "pie": {
        "bands": Marking("dish", partial(fronts.belts, spans=wares.DISH_BANDS)),
        "flutes": Marking("dish", partial(craft.flutes, count=28, share=0.2, high=0.9)),
    },
    "mushroom": {
        "gills": Marking("underside", wares.gills),
        "underside": Marking("cap", wares.underside),
    },
    "pencil": {
        "letters": Marking("body", partial(wares.written_up, text="HB 2", high=0.95, at=0.4)),
        "rings": Marking("body", partial(fronts.belts, spans=wares.PENCIL_RINGS)),
        "bands": Marking("ferrule", partial(fronts.belts, spans=wares.FERRULE_BANDS)),
    },
    "lipstick": {
        "monogram": Marking("case", partial(outlines.laid, **wares.MONOGRAM)),
        "lines": Marking("case", partial(fronts.belts, spans=wares.CASE_LINES)),
        "grooves": Marking("tube", partial(fronts.belts, spans=wares.TUBE_GROOVES)),
    },
    "perfume": {
        "monogram": Marking("label", partial(outlines.laid, **wares.LABEL_FLOWER)),
        "border": Marking("label", partial(outlines.laid, **wares.LABEL_EDGE)),
        "grooves": Marking("collar", partial(fronts.belts, spans=wares.COLLAR_GROOVES)),
    },
    "drum kit": {
        "star": Marking("badge", partial(outlines.laid, **wares.BADGE_STAR)),
        "rings": Marking("skins", partial(fronts.rim, low=0.8, high=0.88)),
    },
    "saw": {"letters": Marking("blade", partial(outlines.laid, **wares.SAW_NAME))},
    "knife": {
        "edge": Marking("blade", partial(wares.through, corners=wares.KNIFE_EDGE)),
        "bolster": Marking("handle", partial(fronts.belt, low=0.8, high=1.2)),
    },
    "hammer": {
        "ridges": Marking("grip", partial(fronts.belts, spans=wares.HAMMER_RIDGES)),
        "grip": Marking("handle", partial(fronts.belt, low=-1.2, high=-0.16)),
        "bands": Marking("head", partial(fronts.belts, spans=wares.HAMMER_BANDS, axis=0)),
    },
    "war hammer": {"runes": Marking("head", partial(outlines.laid, **wares.RUNES))},
    "medal": {
        "beads": Marking("medal", partial(decor.beads, radius=0.74, size=0.05, count=24)),
        "edges": Marking("ribbon", partial(outlines.laid, **wares.RIBBON_EDGES)),
    },
    "ring": {
        "stones": Marking("band", partial(wares.studs, count=20, size=0.05, axis=1, out=0.88)),
        "grooves": Marking("band", partial(fronts.belts, spans=wares.RING_GROOVES, axis=1)),
    },
    "glove": {
        "motif": Marking("body", partial(outlines.laid, **wares.GLOVE_MOTIF)),
        "ribs": Marking("cuff", partial(outlines.laid, **wares.CUFF_RIBS)),
    },
    "handbag": {
        "piping": Marking("flap", partial(outlines.laid, **wares.FLAP_PIPING)),
        "quilting": Marking("body", partial(wares.cross_quilt, pitch=0.17)),
    },
    "hat": {
        "buckle": Marking("ribbon", partial(outlines.laid, **wares.HAT_BUCKLE)),
        "piping": Marking("body", partial(wares.brim, low=0.955, high=2.0)),
    },
    "cowboy hat": {
        "star": Marking("body", partial(outlines.laid, **wares.SHERIFF_STAR)),
        "stitches": Marking("body", partial(wares.brim, low=0.88, high=0.93)),
        "studs": Marking("band", partial(wares.studs, count=26, size=0.016)),
    },
    "boxing glove": {
        "star": Marking("body", partial(outlines.laid, **wares.BOXING_STAR)),
        "letters": Marking("band", partial(outlines.laid, **wares.BAND_TEXT)),
    },
    "roller skate": {
        "star": Marking("body", partial(outlines.laid, **wares.SKATE_STAR)),
        "stripes": Marking("body", partial(outlines.laid, **wares.SKATE_STRIPES)),
    },
    "scarf": {"lines": Marking("wool", partial(fronts.belts, spans=wares.SCARF_LINES))},
    "saddle": {
        "flowers": Marking("flaps", partial(outlines.laid, **wares.SADDLE_FLOWERS)),
        "stitches": Marking("skirt", partial(outlines.laid, **wares.SADDLE_EDGE)),
    },
    "teddy bear": {
        "mouth": Marking("muzzle", partial(outlines.laid, **wares.TEDDY_MOUTH), by="body"),
        "paws": Marking("muzzle", partial(outlines.laid, **wares.TEDDY_PAWS), by="body"),
        "stitches": Marking("muzzle", partial(outlines.laid, **wares.TEDDY_STITCHES), by="body"),
        "inner ears": Marking("body", partial(outlines.laid, **wares.TEDDY_EARS)),
    },
    "bucket": {
        "bands": Marking("body", partial(fronts.belts, spans=wares.BUCKET_BANDS)),
        "rivets": Marking("bands", partial(wares.studs, count=12, size=0.018, at=0.52)),
    },
    "map pin": {"star": Marking("disc", partial(outlines.laid, **wares.PIN_RING))},
    "christmas tree": {
        "snow": Marking("leaves", wares.snow),
        "bands": Marking("tub", partial(fronts.belts, spans=wares.TUB_BANDS)),
    },
    "leaf": {"side veins": Marking("blade", partial(outlines.laid, **wares.SIDE_VEINS))},
}
