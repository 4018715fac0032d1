"""Markings of food, fruit, vegetables and plants."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    lines,
    planks,
    rings,
    spots,
    stripes,
    toppings,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import food_and_plants as own

YEARS = tuple((k / 6 - 0.018, k / 6 + 0.018) for k in range(1, 6))  # of a stump
FOOD_AND_PLANTS: Rows = {
    "hamburger": {"seeds": Marking("bun", spots.seeds)},
    "sandwich": {
        "grill marks": Marking("bread", partial(lines.grill_marks, high=0.29), by="cheese"),
    },
    "pizza": {
        "specks": Marking(
            "salami", partial(spots.blobs, pitch=0.07, sizes=(0.009, 0.017), fraction=0.55)
        ),
        "basil": Marking("cheese", partial(outlines.laid, **own.BASIL)),
        "spots": Marking(
            "cheese", partial(spots.blobs, pitch=0.18, sizes=(0.02, 0.05), fraction=0.4)
        ),
    },
    "easter egg": {
        "stripes": Marking("shell", bands.egg_bands),
        "dots": Marking("shell", spots.egg_dots),
    },
    "cheese": {"label": Marking("rind", partial(outlines.laid, **own.RIND_LABEL))},
    "can": {
        "badge": Marking("label", partial(outlines.laid, **own.CAN_BADGE)),
        "wave": Marking("label", partial(bands.wave, high=0.16, wide=0.5)),
    },
    "jar": {"label": Marking("body", partial(bands.belt, low=-0.55, high=0.3))},
    "bread": {"scores": Marking("crust", partial(outlines.laid, **own.LOAF_SCORES))},
    "cake": {
        "sprinkles": Marking("icing", spots.sprinkles),
        "cream": Marking("body", partial(bands.belts, spans=own.CAKE_CREAM)),
    },
    "pie": {
        "bands": Marking("dish", partial(bands.belts, spans=own.DISH_BANDS)),
        "flutes": Marking("dish", partial(lines.flutes, count=28, fraction=0.2, high=0.9)),
    },
    "cookie": {
        "dimples": Marking(
            "body", partial(spots.blobs, pitch=0.16, sizes=(0.016, 0.034), fraction=0.6)
        ),
    },
    "lollipop": {"swirl": Marking("candy", rings.spiral)},
    "chocolate bar": {
        "letters": Marking("label", partial(outlines.laid, **own.WRAPPER_NAME)),
        "border": Marking("wrapper", partial(outlines.laid, **own.WRAPPER_BORDER)),
    },
    "ice cream": {
        "sprinkles": Marking("sauce", partial(spots.sprinkles, pitch=0.085)),
        "sauce": Marking("scoop", toppings.sauce),
    },
    "popcorn": {
        "badge": Marking("box", partial(badges.badge, radius=0.42, shape="star")),
        "stripes": Marking("box", partial(stripes.popcorn_stripes, clear=0.48)),
    },
    "strawberry": {"seeds": Marking("body", spots.strawberry_seeds)},
    "watermelon": {"stripes": Marking("rind", stripes.melon_stripes)},
    "christmas tree": {
        "snow": Marking("leaves", toppings.snow),
        "bands": Marking("tub", partial(bands.belts, spans=own.TUB_BANDS)),
    },
    "cactus": {
        "spines": Marking(
            "body", partial(spots.blobs, pitch=0.09, sizes=(0.012, 0.015), fraction=0.95)
        )
    },
    "flower": {
        "streaks": Marking("petals", partial(rings.rays, span=(0.3, 0.74), count=24, wide=0.03))
    },
    "sunflower": {"seeds": Marking("heart", partial(spots.seeds, count=60, up=1, size=0.045))},
    "mushroom": {
        "gills": Marking("underside", lines.gills),
        "underside": Marking("cap", toppings.underside),
    },
    "stump": {"rings": Marking("wood", partial(rings.rings, spans=YEARS, axis=2))},
    "log": {"furrows": Marking("bark", planks.bark_lines)},
}
