"""What stands in a room at all times or at a feast, and what stands before its window."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    GLASS,
    PLANT,
    PLASTIC,
    STEEL,
    WOOD,
    Noun,
    Usual,
)

CARDBOARD = 700.0  # kg/m³

PARLOUR_THINGS = {
    "globe": Noun(
        "world globe, earth globe, desk globe, terrestrial globe, school globe; celestial globe, "
        "world map globe, antique globe",
        {
            "ocean": "*2f78c4 . plastic",
            "land": "+4f9a45 . plastic",
            "ice": "-f2f5f7 . plastic",
            "meridian": "&d0a040 . golden",
            "stand": "&6f4325 grain",
        },
        Usual(0.4, PLASTIC, 0.08),
    ),
    "snow globe": Noun(
        "snowglobe, snow dome, christmas globe, glass snow globe, winter globe",
        {
            "base": "*8a1f24 . paint",
            "glass": "-b9ddea . glass",
            "snow": "-fafcff",
            "firs": "+1f7a3a",
            "flakes": "-ffffff",
            "plaque": "+d8a83c . golden",
        },
        Usual(0.12, GLASS, 0.6),
    ),
    "desk lamp": Noun(
        "reading lamp, study lamp, architect lamp, anglepoise, anglepoise lamp, office lamp, "
        "work lamp, task lamp; bankers lamp, bedside lamp, table lamp lamp",
        {
            "base": "*c8382c . paint",
            "arms": "+b9bec4 . metal",
            "joints": "&33363a . plastic",
            "shade": "*c8382c . paint",
            "bulb": "-ffe9a8 . glass",
        },
        Usual(0.5, STEEL, 0.03),
    ),
    "candelabra": Noun(
        "candelabrum, candle stand, three armed candelabra, candelabras; "
        "menorah, candle tree, three candles",
        {
            "stem": "*d4a63a . golden",
            "arms": "*d4a63a . golden",
            "cups": "&c4952e . golden",
            "candles": "-f5eedc",
            "flames": "-ffae2a",
        },
        Usual(0.4, COPPER, 0.15),
    ),
    "flower pot": Noun(
        "flowerpot, plant pot, empty pot, clay pot, terracotta pot, flower pots, garden pot, "
        "empty flower pot, terra cotta pot; planter, plant tub, window box, pot",
        {
            "pot": "*bb6238",
            "rim": "*c46c42",
            "saucer": "&ad5730",
            "soil": "-3c281a",
        },
        Usual(0.25, CERAMIC, 0.15),
    ),
    "cardboard box": Noun(
        "carton box, open cardboard box, open box, moving box, shipping box, "
        "delivery box, packing box, paper box; cardboard carton, shoe box, shoebox, amazon box, "
        "pizza box, tissue box, box of chocolates, chocolate box, cereal box",
        {
            "body": "*bf9159",
            "flaps": "*c99c64",
            "tape": "+ead9ae . plastic",
            "label": "-f6f3ea",
            "arrows": "-33251a",
        },
        Usual(0.45, CARDBOARD, 0.09),
    ),
    "birdhouse": Noun(
        "bird house, bird box, nest box, nesting box, birdbox, wooden birdhouse; bird feeder, "
        "bird table",
        {
            "walls": "*c98f4e grain",
            "roof": "+a8382c . paint",
            "hole": "-1c130d",
            "rim": "&f1e6cf . paint",
            "perch": "-7d5230 grain",
            "post": "-7d5230 grain",
        },
        Usual(0.4, WOOD, 0.25),
    ),
}
PARLOUR_PLANTS = {
    "christmas tree": Noun(
        "xmas tree, decorated tree, decorated christmas tree, xmas fir, christmas fir, "
        "holiday tree; new year tree, yule tree",
        {
            "leaves": "*1f6b30",
            "trunk": "-5f3d21",
            "baubles": "+cf1f2b . glass",
            "beads": "+e8b93c . golden",
            "star": "-ffd23f . golden",
            "tub": "-8a2a24 . paint",
            "snow": "-f6fafc",
            "bands": "-e8b93c . golden",
        },
        Usual(2.0, PLANT, 0.02),
    ),
}
