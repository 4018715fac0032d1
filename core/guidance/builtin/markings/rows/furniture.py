"""Markings of furniture."""

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
)
from core.guidance.builtin.markings.marking import Marking, Rows

FURNITURE: Rows = {
    "chair": {
        "seams": Marking("seat", partial(outlines.laid, **homely.CHAIR_SEAMS), "wooden"),
    },
    "armchair": {
        "buttons": Marking("back", partial(outlines.laid, **fittings.CHAIR_BUTTONS)),
        "piping": Marking("arms", partial(outlines.laid, **fittings.ARM_PIPING), paired=True),
    },
    "office chair": {"seams": Marking("back", partial(outlines.laid, **decor.BACK_SEAMS))},
    "gaming chair": {"badge": Marking("seat", partial(outlines.laid, **decor.CHAIR_BADGE))},
    "throne": {
        "buttons": Marking("cushion", partial(outlines.laid, **homely.THRONE_BUTTONS)),
        "gems": Marking("frame", partial(outlines.laid, **homely.THRONE_GEMS)),
        "panels": Marking("frame", partial(outlines.laid, **homely.THRONE_PANELS)),
        "border": Marking("step", partial(outlines.laid, **homely.THRONE_STEP)),
    },
    "sofa": {
        "buttons": Marking("back", partial(outlines.laid, **fittings.SOFA_BUTTONS)),
        "piping": Marking("arms", partial(outlines.laid, **fittings.ARM_PIPING), paired=True),
    },
    "stool": {
        "band": Marking("seat", partial(fronts.belt, low=-0.55, high=0.05)),
        "seams": Marking("seat", partial(outlines.laid, **homely.CHAIR_SEAMS), "wooden"),
    },
    "bench": {
        "bolts": Marking("seat", partial(outlines.laid, **decor.BENCH_BOLTS)),
        "seams": Marking("seat", partial(outlines.laid, **decor.BENCH_SEAMS), "wooden"),
    },
    "ottoman": {
        "nails": Marking("base", partial(outlines.laid, **homely.OTTOMAN_NAILS)),
        "piping": Marking("cushion", partial(fronts.belt, low=-0.5, high=-0.2)),
    },
    "bed": {
        "stripes": Marking(
            "blanket", partial(fronts.belts, spans=fittings.BLANKET_STRIPES, axis=1)
        ),
        "panels": Marking("frame", partial(outlines.laid, **fittings.BED_PANELS)),
    },
    "bunk bed": {"rungs": Marking("ladder", partial(boards.planks, count=6, wide=0.022))},
    "four-poster bed": {
        "trim": Marking("canopy", partial(fronts.belts, spans=homely.BED_TRIM)),
        "quilting": Marking("blanket", partial(homely.quilt, pitch=0.12)),
    },
    "crib": {
        "hearts": Marking("frame", partial(outlines.laid, **homely.CRIB_HEARTS)),
        "stars": Marking("blanket", partial(outlines.laid, **homely.CRIB_STARS)),
    },
    "pillow": {"border": Marking("body", partial(outlines.laid, **decor.PILLOW_BORDER))},
    "table": {"seams": Marking("top", partial(outlines.laid, **decor.TABLE_SEAMS), "wooden")},
    "desk": {
        "border": Marking("blotter", partial(outlines.laid, **decor.BLOTTER_EDGE)),
        "blotter": Marking("top", partial(outlines.laid, **decor.BLOTTER)),
    },
    "coffee table": {
        "seams": Marking("top", partial(outlines.laid, **homely.COFFEE_SEAMS), "wooden"),
    },
    "bookshelf": {
        "bands": Marking("books", partial(fronts.belts, spans=fittings.BOOK_BANDS), by="frame"),
        "labels": Marking("volumes", partial(fronts.belts, spans=fittings.BOOK_LABELS), by="frame"),
        "stripes": Marking("tomes", partial(fronts.belts, spans=fittings.BOOK_STRIPES), by="frame"),
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
    "cabinet": {
        "panels": Marking("doors", fittings.door_panels, paired=True),
    },
    "wardrobe": {
        "panels": Marking("doors", partial(outlines.laid, **fittings.WARDROBE_PANELS), by="body"),
    },
    "dresser": {"panels": Marking("drawers", decor.each_drawer)},
    "nightstand": {"panels": Marking("drawers", decor.each_drawer)},
    "mirror": {
        "gems": Marking("frame", partial(outlines.laid, **homely.MIRROR_GEMS)),
        "backing": Marking("frame", partial(outlines.laid, **homely.MIRROR_BACK)),
        "glare": Marking("glass", fittings.glare),
    },
    "lamp": {
        "bands": Marking("shade", partial(fronts.belts, spans=craft.SHADE_BANDS)),
        "pleats": Marking("shade", partial(craft.flutes, count=24, share=0.15, high=0.9)),
    },
    "fireplace": {"mortar": Marking("body", facades.courses)},
    "grandfather clock": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "piano": {
        "panels": Marking("body", partial(outlines.laid, **craft.PIANO_PANELS)),
    },
    "grand piano": {"black keys": Marking("keys", fronts.black_keys)},
}
