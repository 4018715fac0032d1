"""Furniture, ware, arms, food."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    decor,
    fronts,
    outlines,
)
from core.guidance.builtin.markings.marking import Marking, Rows

HOUSEHOLD: Rows = {
    "table": {"seams": Marking("top", partial(outlines.laid, **decor.TABLE_SEAMS), "wooden")},
    "desk": {
        "border": Marking("blotter", partial(outlines.laid, **decor.BLOTTER_EDGE)),
        "blotter": Marking("top", partial(outlines.laid, **decor.BLOTTER)),
    },
    "dresser": {"panels": Marking("drawers", decor.each_drawer)},
    "nightstand": {"panels": Marking("drawers", decor.each_drawer)},
    "bench": {
        "bolts": Marking("seat", partial(outlines.laid, **decor.BENCH_BOLTS)),
        "seams": Marking("seat", partial(outlines.laid, **decor.BENCH_SEAMS), "wooden"),
    },
    "office chair": {"seams": Marking("back", partial(outlines.laid, **decor.BACK_SEAMS))},
    "pillow": {"border": Marking("body", partial(outlines.laid, **decor.PILLOW_BORDER))},
    "window": {
        "slats": Marking("shutters", partial(outlines.laid, **decor.SLATS), paired=True),
    },
    "mug": {"bands": Marking("body", partial(fronts.belts, spans=decor.MUG_BANDS))},
    "bowl": {"bands": Marking("body", partial(fronts.belts, spans=decor.BOWL_BANDS))},
    "teapot": {
        "bands": Marking("body", partial(fronts.belts, spans=decor.TEAPOT_BANDS)),
    },
    "sword": {
        "fuller": Marking("blade", partial(outlines.laid, **decor.FULLER)),
        "wraps": Marking("grip", partial(fronts.belts, spans=decor.GRIP_WRAPS)),
    },
    "shield": {"quarters": Marking("plate", partial(outlines.laid, **decor.QUARTERS))},
    "helmet": {"breaths": Marking("shell", partial(outlines.laid, **decor.BREATHS))},
    "tombstone": {"letters": Marking("slab", decor.epitaph)},
    "umbrella": {"panels": Marking("canopy", partial(balls.sectors, count=8))},
    "tent": {"trim": Marking("canvas", decor.gable)},
    "bell": {"bands": Marking("body", partial(fronts.belts, spans=decor.BELL_BANDS))},
    "crown": {"borders": Marking("band", partial(fronts.belts, spans=decor.CROWN_BANDS))},
    "coin": {"beads": Marking("face", partial(decor.beads, radius=0.72, size=0.035, count=28))},
    "log": {"furrows": Marking("bark", decor.bark_lines)},
    "bread": {"scores": Marking("crust", partial(outlines.laid, **decor.LOAF_SCORES))},
    "flower": {
        "streaks": Marking("petals", partial(decor.rays, span=(0.3, 0.74), count=24, wide=0.03))
    },
    "chess rook": {"joints": Marking("body", decor.bricks)},
    "axe": {
        "edge": Marking("head", decor.cutting_edge),
        "wraps": Marking("handle", partial(fronts.belts, spans=decor.HANDLE_WRAPS)),
    },
    "curtain": {"hems": Marking("curtain", partial(fronts.belts, spans=decor.HEMS))},
    "gaming chair": {"badge": Marking("seat", partial(outlines.laid, **decor.CHAIR_BADGE))},
    "arrow": {"bands": Marking("shaft", partial(fronts.belts, spans=decor.ARROW_BANDS))},
    "counter": {"panels": Marking("body", partial(outlines.laid, **decor.COUNTER_PANELS))},
    "envelope": {
        "stamp": Marking("body", partial(outlines.laid, **decor.STAMP)),
        "address": Marking("body", partial(outlines.laid, **decor.ADDRESS)),
    },
}
