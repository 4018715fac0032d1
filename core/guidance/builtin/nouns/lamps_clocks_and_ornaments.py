"""Lamps and candles, clocks, vases, ornaments of a shelf, and what stands beside them."""

from core.guidance.builtin.nouns.noun import (
    CARDBOARD,
    CERAMIC,
    COPPER,
    FABRIC,
    GLASS,
    GOLD,
    PLASTIC,
    STEEL,
    STONE,
    WAX,
    WOOD,
    Noun,
    Usual,
)

LAMPS_CLOCKS_AND_ORNAMENTS = {
    "candle": Noun(
        "; candlestick, candle holder, tea light, tealight",
        {"wax": "*f0e6cc", "flame": "-ff9a1e", "holder": "+c79a3e . golden"},
        Usual(0.2, WAX),
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
    "chandelier": Noun(
        "crystal chandelier",
        {
            "stem": "*d0a040 . golden",
            "arms": "*d0a040 . golden",
            "cups": "&c08f34 . golden",
            "candles": "-f2ead6",
            "flames": "-ffb02e",
            "drops": "-c9e6f0 . glass",
        },
        Usual(0.9, COPPER, 0.05),
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
    "wall sconce": Noun(
        "sconce, wall lamp, wall light, sconces, wall lantern, wall mounted lamp; wall fixture, "
        "wall candle holder, candle sconce, gas light",
        {
            "plate": "*b58a3c . golden",
            "arm": "*b58a3c . golden",
            "cup": "&8f6a2a . golden",
            "shade": "+f3e6c8",
            "bulb": "-ffe9a8 . glass",
        },
        Usual(0.4, STEEL, 0.03),
    ),
    "pendant lamp": Noun(
        "pendant light, hanging lamp, hanging light, pendant lamps, ceiling pendant, suspension "
        "lamp, ceiling lamp, ceiling light; industrial lamp, billiard lamp, kitchen lamp",
        {
            "rose": "&2b2c2f . metal",
            "cable": "-1f2022 . rubber",
            "cap": "+c9963f . golden",
            "shade": "*1f6b66 . paint",
            "bulb": "-ffe39a . glass",
        },
        Usual(0.8, STEEL, 0.008),
    ),
    "disco ball": Noun(
        "discoball, mirror ball, mirrorball, glitter ball, disco mirror ball",
        {"body": "*e3e7ec . metal", "gaps": "-54585f . metal"},
        Usual(0.4, GLASS, 0.05),
        "ball",
    ),
    "clock": Noun(
        "; wall clock",
        {
            "body": "*c0302a . paint",
            "face": "+f4f0e4",
            "hands": "-1a1a1c",
            "bells": "-d9ad45 . golden",
            "feet": "&8a211d",
            "marks": "-1a1a1c",
        },
        Usual(0.2, STEEL, 0.1),
    ),
    "alarm clock": Noun(
        "alarm clocks, alarmclock, twin bell clock, bell clock, bedside clock; table clock, "
        "desk clock",
        {
            "body": "*d23a30 . paint",
            "face": "-f6f2e6",
            "hands": "-1a1a1c",
            "bells": "+dcb048 . golden",
            "rim": "&8f201b . paint",
            "feet": "-c9a043 . golden",
            "handle": "-c9a043 . golden",
            "marks": "-1a1a1c",
        },
        Usual(0.16, STEEL, 0.1),
    ),
    "vase": Noun(
        "; urn, amphora, pottery",
        {"body": "*b8613d band"},
        Usual(0.3, CERAMIC, 0.12),
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
    "bust": Noun(
        "head bust, statue head; statue, sculpture, statuette, idol, effigy, mannequin head",
        {
            "body": "*dcd6ca . stone",
            "hair": "&c2b9a8 . stone",
            "base": "-6e6961 . stone",
            "face": "&d9d3c6 . stone",
        },
        Usual(0.5, STONE),
    ),
    "trophy": Noun(
        "trophies; trophy cup, world cup, prize cup, gold cup",
        {
            "cup": "*ffc94f . golden",
            "handles": "&ffc94f . golden",
            "base": "-2a211c",
            "plaque": "~ffc94f . golden",
            "star": "~c8862a . golden",
        },
        Usual(0.4, STEEL, 0.039),
    ),
    "bell": Noun(
        "church bell; handbell, cowbell",
        {
            "body": "*e0ab48 . golden",
            "loop": "&b98530 . golden",
            "clapper": "-5a5a5e . metal",
            "bands": "~8f5a14 . golden",
        },
        Usual(0.4, COPPER, 0.4),
    ),
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
    "glass dome": Noun(
        "cloche, bell jar, glass cloche, glass bell jar, glass bell, bell glass, display dome, "
        "domed glass, glass display dome",
        {"base": "*5b3420 grain", "glass": "-b9ddea . glass"},
        Usual(0.35, GLASS, 0.04),
        solid="snow globe",
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
    "picture frame": Noun(
        "photo frame, framed picture, painting; portrait, poster, mona lisa",
        {"frame": "*c9982f . golden", "picture": "-8fc3e6", "hills": "-4f8a45", "sun": "-f5cf3c"},
        Usual(0.6, WOOD, 0.16),
    ),
    "crown": Noun(
        "; tiara, coronet, diadem, flower crown",
        {
            "band": "*ffc757 . golden",
            "pearls": "+f4efe6",
            "gems": "-c21d2b",
            "borders": "~c48a24 . golden",
        },
        Usual(0.2, GOLD, 0.12),
    ),
    "hat": Noun(
        "top hat; clown hat, turban, bonnet, bowler hat, bowler, derby hat, fez, jester "
        "hat, leprechaun hat, graduation cap, graduation hat, mortarboard",
        {"body": "*1c1c20", "ribbon": "+a01822", "buckle": "-e0b84a . golden", "piping": "+a01822"},
        Usual(0.3, FABRIC, 0.15),
    ),
    "umbrella stand": Noun(
        "umbrella stands, umbrella holder, umbrella rack, cane stand, cane holder, walking stick "
        "stand; umbrella basket, walking stick holder",
        {
            "body": "*1f5560 . paint",
            "rim": "+c9a24a . golden",
            "base": "+c9a24a . golden",
            "umbrellas": "-b3262b . fabric",
            "handles": "-6a4124 grain",
        },
        Usual(0.95, STEEL, 0.013),
    ),
    "birdhouse": Noun(
        "bird house, bird box, nest box, nesting box, birdbox, wooden birdhouse",
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
    "cardboard box": Noun(
        "carton box, open cardboard box, open box, moving box, shipping box, "
        "delivery box, packing box, paper box; cardboard carton, shoe box, shoebox, amazon box, "
        "tissue box, box of chocolates, chocolate box",
        {
            "body": "*bf9159",
            "flaps": "*c99c64",
            "tape": "+ead9ae . plastic",
            "label": "-f6f3ea",
            "arrows": "-33251a",
        },
        Usual(0.45, CARDBOARD, 0.09),
    ),
    "bowling pin": Noun(
        "skittle, pin",
        {"body": "*f2f0ea collar"},
        Usual(0.38, WOOD, 0.48),
    ),
}
