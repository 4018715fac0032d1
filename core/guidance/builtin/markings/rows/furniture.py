"""Markings of furniture."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    bands,
    dials,
    frames,
    lines,
    papers,
    pictures,
    planks,
    seams,
    tiles,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import furniture as own

FURNITURE: Rows = {
    "chair": {
        "seams": Marking("seat", partial(outlines.laid, **own.CHAIR_SEAMS), "wooden"),
    },
    "armchair": {
        "buttons": Marking("back", partial(outlines.laid, **own.CHAIR_BUTTONS)),
        "piping": Marking("arms", partial(outlines.laid, **own.ARM_PIPING), paired=True),
    },
    "office chair": {"seams": Marking("back", partial(outlines.laid, **own.BACK_SEAMS))},
    "gaming chair": {"badge": Marking("seat", partial(outlines.laid, **own.CHAIR_BADGE))},
    "throne": {
        "buttons": Marking("cushion", partial(outlines.laid, **own.THRONE_BUTTONS)),
        "gems": Marking("frame", partial(outlines.laid, **own.THRONE_GEMS)),
        "panels": Marking("frame", partial(outlines.laid, **own.THRONE_PANELS)),
        "border": Marking("step", partial(outlines.laid, **own.THRONE_STEP)),
    },
    "sofa": {
        "buttons": Marking("back", partial(outlines.laid, **own.SOFA_BUTTONS)),
        "piping": Marking("arms", partial(outlines.laid, **own.ARM_PIPING), paired=True),
    },
    "stool": {
        "band": Marking("seat", partial(bands.belt, low=-0.55, high=0.05)),
        "seams": Marking("seat", partial(outlines.laid, **own.CHAIR_SEAMS), "wooden"),
    },
    "bench": {
        "bolts": Marking("seat", partial(outlines.laid, **own.BENCH_BOLTS)),
        "seams": Marking("seat", partial(outlines.laid, **own.BENCH_SEAMS), "wooden"),
    },
    "ottoman": {
        "nails": Marking("base", partial(outlines.laid, **own.OTTOMAN_NAILS)),
        "piping": Marking("cushion", partial(bands.belt, low=-0.5, high=-0.2)),
    },
    "bed": {
        "stripes": Marking("blanket", partial(bands.belts, spans=own.BLANKET_STRIPES, axis=1)),
        "panels": Marking("frame", partial(outlines.laid, **own.BED_PANELS)),
    },
    "bunk bed": {"rungs": Marking("ladder", partial(planks.planks, count=6, wide=0.022))},
    "four-poster bed": {
        "trim": Marking("canopy", partial(bands.belts, spans=own.BED_TRIM)),
        "quilting": Marking("blanket", partial(seams.quilt, pitch=0.12)),
    },
    "crib": {
        "hearts": Marking("frame", partial(outlines.laid, **own.CRIB_HEARTS)),
        "stars": Marking("blanket", partial(outlines.laid, **own.CRIB_STARS)),
    },
    "pillow": {"border": Marking("body", partial(outlines.laid, **own.PILLOW_BORDER))},
    "table": {"seams": Marking("top", partial(outlines.laid, **own.TABLE_SEAMS), "wooden")},
    "desk": {
        "border": Marking("blotter", partial(outlines.laid, **own.BLOTTER_EDGE)),
        "blotter": Marking("top", partial(outlines.laid, **own.BLOTTER)),
    },
    "coffee table": {
        "seams": Marking("top", partial(outlines.laid, **own.COFFEE_SEAMS), "wooden"),
    },
    "bookshelf": {
        "bands": Marking("books", partial(bands.belts, spans=own.BOOK_BANDS), by="frame"),
        "labels": Marking("volumes", partial(bands.belts, spans=own.BOOK_LABELS), by="frame"),
        "stripes": Marking("tomes", partial(bands.belts, spans=own.BOOK_STRIPES), by="frame"),
    },
    "shelf": {
        "bands": Marking("books", partial(bands.belts, spans=own.SHELF_BANDS), by="board"),
        "volumes": Marking(
            "books", partial(bands.belts, spans=own.SHELF_VOLUMES, axis=0), by="board"
        ),
        "tomes": Marking("books", partial(bands.belts, spans=own.SHELF_TOMES, axis=0), by="board"),
        "stripes": Marking("vase", partial(bands.belts, spans=own.VASE_STRIPES)),
    },
    "cabinet": {
        "panels": Marking(
            "doors", partial(frames.repeated, axes=(0,), room=0.05, **own.CABINET_DOOR), paired=True
        ),
    },
    "wardrobe": {
        "panels": Marking("doors", partial(outlines.laid, **own.WARDROBE_PANELS), by="body"),
    },
    "school locker": {
        "vents": Marking("doors", partial(outlines.laid, **own.LOCKER_VENTS), by="body"),
        "number": Marking("plate", papers.locker_numbers, by="body"),
        "plate": Marking("doors", partial(outlines.laid, **own.LOCKER_PLATE), by="body"),
    },
    **{
        noun: {
            "panels": Marking(
                "drawers", partial(frames.repeated, axes=(0, 2), room=0.045, **own.DRAWER)
            )
        }
        for noun in ("dresser", "nightstand")
    },
    "mirror": {
        "gems": Marking("frame", partial(outlines.laid, **own.MIRROR_GEMS)),
        "backing": Marking("frame", partial(outlines.laid, **own.MIRROR_BACK)),
        "glare": Marking("glass", pictures.glare),
    },
    "lamp": {
        "bands": Marking("shade", partial(bands.belts, spans=own.SHADE_BANDS)),
        "pleats": Marking("shade", partial(lines.flutes, count=24, fraction=0.15, high=0.9)),
    },
    "fireplace": {"mortar": Marking("body", tiles.courses)},
    "grandfather clock": {"marks": Marking("face", partial(dials.hours, radius=1.0))},
    "piano": {
        "panels": Marking("body", partial(outlines.laid, **own.PIANO_PANELS)),
    },
    "grand piano": {"black keys": Marking("keys", planks.black_keys)},
}
