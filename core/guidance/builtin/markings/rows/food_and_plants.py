"""Markings of food, fruit, vegetables and plants."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    coats,
    craft,
    decor,
    fittings,
    fronts,
    outlines,
    prints,
    wares,
)
from core.guidance.builtin.markings.margins import blobs
from core.guidance.builtin.markings.marking import Marking, Rows

YEARS = tuple((k / 6 - 0.018, k / 6 + 0.018) for k in range(1, 6))  # of a stump
FOOD_AND_PLANTS: Rows = {
    "hamburger": {"seeds": Marking("bun", coats.seeds)},
    "sandwich": {
        "grill marks": Marking("bread", partial(wares.grill_marks, high=0.29), by="cheese"),
    },
    "pizza": {
        "specks": Marking("salami", partial(blobs, pitch=0.07, sizes=(0.009, 0.017), share=0.55)),
        "basil": Marking("cheese", partial(outlines.laid, **wares.BASIL)),
        "spots": Marking("cheese", partial(blobs, pitch=0.18, sizes=(0.02, 0.05), share=0.4)),
    },
    "easter egg": {
        "stripes": Marking("shell", balls.egg_bands),
        "dots": Marking("shell", balls.egg_dots),
    },
    "cheese": {"label": Marking("rind", partial(outlines.laid, **wares.RIND_LABEL))},
    "can": {
        "badge": Marking("label", partial(outlines.laid, **fittings.CAN_BADGE)),
        "wave": Marking("label", partial(fittings.wave, high=0.16, wide=0.5)),
    },
    "jar": {"label": Marking("body", partial(fronts.belt, low=-0.55, high=0.3))},
    "bread": {"scores": Marking("crust", partial(outlines.laid, **decor.LOAF_SCORES))},
    "cake": {
        "sprinkles": Marking("icing", wares.sprinkles),
        "cream": Marking("body", partial(fronts.belts, spans=wares.CAKE_CREAM)),
    },
    "pie": {
        "bands": Marking("dish", partial(fronts.belts, spans=wares.DISH_BANDS)),
        "flutes": Marking("dish", partial(craft.flutes, count=28, share=0.2, high=0.9)),
    },
    "cookie": {
        "dimples": Marking("body", partial(blobs, pitch=0.16, sizes=(0.016, 0.034), share=0.6)),
    },
    "lollipop": {"swirl": Marking("candy", fronts.spiral)},
    "chocolate bar": {
        "letters": Marking("label", partial(outlines.laid, **wares.WRAPPER_NAME)),
        "border": Marking("wrapper", partial(outlines.laid, **wares.WRAPPER_BORDER)),
    },
    "ice cream": {
        "sprinkles": Marking("sauce", partial(wares.sprinkles, pitch=0.085)),
        "sauce": Marking("scoop", wares.sauce),
    },
    "popcorn": {
        "badge": Marking("box", partial(prints.badge, radius=0.42, shape="star")),
        "stripes": Marking("box", partial(prints.popcorn_stripes, clear=0.48)),
    },
    "strawberry": {"seeds": Marking("body", coats.strawberry_seeds)},
    "watermelon": {"stripes": Marking("rind", coats.melon)},
    "christmas tree": {
        "snow": Marking("leaves", wares.snow),
        "bands": Marking("tub", partial(fronts.belts, spans=wares.TUB_BANDS)),
    },
    "cactus": {
        "spines": Marking("body", partial(blobs, pitch=0.09, sizes=(0.012, 0.015), share=0.95))
    },
    "flower": {
        "streaks": Marking("petals", partial(decor.rays, span=(0.3, 0.74), count=24, wide=0.03))
    },
    "sunflower": {"seeds": Marking("heart", partial(coats.seeds, count=60, up=1, size=0.045))},
    "mushroom": {
        "gills": Marking("underside", wares.gills),
        "underside": Marking("cap", wares.underside),
    },
    "stump": {"rings": Marking("wood", partial(fronts.rings, spans=YEARS, axis=2))},
    "log": {"furrows": Marking("bark", decor.bark_lines)},
}
