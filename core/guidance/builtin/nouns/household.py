"""Household."""

from core.guidance.builtin.nouns.noun import (
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

HOUSEHOLD = {
    "mug": Noun(
        "cup, coffee cup, coffee mug; beer mug, stein, tankard, beer, pint of beer, glass of beer",
        {"body": "*e0dbd1", "handle": "&e0dbd1", "bands": "~5f87ab"},
        Usual(0.1, CERAMIC, 0.98),
    ),
    "vase": Noun(
        "; urn, amphora, pottery",
        {"body": "*b8613d band"},
        Usual(0.3, CERAMIC, 0.12),
    ),
    "bottle": Noun(
        "; thermos, soap dispenser, bottle of wine, bottle of beer, bottle of water, bottle of "
        "milk, milk bottle, beer bottle, decanter, shampoo, shampoo bottle, olive oil, vinegar, "
        "vodka, wine bottle, "
        "champagne bottle, bottle of champagne, whiskey, whisky, rum, hot sauce, ketchup, "
        "mustard bottle, syrup, detergent, medicine bottle, water bottle, lotion bottle",
        {
            "body": "*1f6638 . glass",
            "cap": "+332b26",
            "label": "-f2ead6",
            "bands": "-b58a2e . golden",
            "badge": "-2f6b3c",
        },
        Usual(0.3, GLASS, 0.12),
    ),
    "teapot": Noun(
        "tea pot; tea set",
        {
            "body": "*3c7fb0",
            "spout": "*3c7fb0",
            "handle": "&3c7fb0",
            "lid": "&e8e4da",
            "bands": "+f4efe4",
        },
        Usual(0.25, CERAMIC, 0.2),
    ),
    "bowl": Noun(
        "; fishbowl, fish bowl, goldfish bowl, ashtray, salad bowl, mixing bowl, fruit bowl",
        {"body": "*d8d2c4", "foot": "&b9a98c", "bands": "~4f7ea6"},
        Usual(0.16, CERAMIC, 0.5),
    ),
    "pan": Noun(
        "frying pan, skillet; saucepan, wok",
        {"body": "*33353a . metal", "handle": "+1c1a19"},
        Usual(0.45, STEEL, 0.13),
    ),
    "goblet": Noun(
        "chalice; glass of water, glass of milk, wine cup, holy grail, drinking glass, tumbler, "
        "pint glass, beer glass, shot glass, whiskey glass, whisky glass, glass of juice, glass of "
        "lemonade",
        {"cup": "*e0b84a . golden", "stem": "&c9a03c . golden"},
        Usual(0.18, STEEL, 0.15),
    ),
    "bucket": Noun(
        "pail",
        {
            "body": "*8f979e . metal",
            "handle": "+5c6268 . metal",
            "bands": "&5c6268 . metal",
            "rivets": "-c9ced2 . metal",
        },
        Usual(0.3, STEEL, 0.045),
    ),
    "candle": Noun(
        "; candlestick, candle holder, tea light, tealight",
        {"wax": "*f0e6cc", "flame": "-ff9a1e", "holder": "+c79a3e . golden"},
        Usual(0.2, WAX),
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
        "top hat; elf hat, clown hat, turban, bonnet, bowler hat, bowler, derby hat, fez, jester "
        "hat, leprechaun hat, graduation cap, graduation hat, mortarboard",
        {"body": "*1c1c20", "ribbon": "+a01822", "buckle": "-e0b84a . golden", "piping": "+a01822"},
        Usual(0.3, FABRIC, 0.15),
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
    "bowling pin": Noun(
        "skittle, pin",
        {"body": "*f2f0ea collar"},
        Usual(0.38, WOOD, 0.48),
    ),
    "door": Noun(
        "front door, house door, house front door; mansion door, mansion front door, cabin door, "
        "cottage door, hut door, shop door, shed door, tavern door, castle gate, "
        "castle door, portcullis, shoji screen, shoji, barn door, church door, garage door, "
        "dungeon door, cell door, cellar door, prison door",
        {
            "door": "*8f5a2e grain",
            "panels": "&9f6837 grain",
            "frame": "+e6e0d2",
            "handle": "-d9ad45 . golden",
            "trim": "~7a4a22 grain",
            "lock plate": "-d9ad45 . golden",
            "keyhole": "-1d1712",
            "hinges": "-d9ad45 . golden",
        },
        Usual(2.0, WOOD, 0.072),
    ),
    "window": Noun(
        "house window; sash window, window frame, skylight",
        {
            "frame": "*ece8de",
            "glass": "-9cc4dd . glass",
            "sill": "&d8d2c4",
            "shutters": "+3f7a52",
            "slats": "~2a5639",
        },
        Usual(1.2, WOOD, 0.3),
    ),
    "refrigerator": Noun(
        "fridge, icebox; freezer, ice box, minifridge",
        {
            "body": "*dfe3e6 . paint",
            "doors": "*e8ebee . paint",
            "handles": "+8f979e . metal",
            "feet": "-2a2a2c",
            "magnets": "+d8322e . plastic",
            "note": "-f7df7a",
            "coils": "-3a3e43 . metal",
        },
        Usual(1.8, STEEL, 0.0043),
    ),
    "stove": Noun(
        "oven, cooker, kitchen stove; range, hot plate",
        {
            "body": "*e4e4e2 . paint",
            "window": "-1e2226 . glass",
            "plates": "-26262a",
            "knobs": "+3a3c40",
            "handle": "&a8aeb4 . metal",
            "racks": "-6d747b . metal",
            "coils": "-c2482a",
            "seams": "~8d8f90",
        },
        Usual(0.9, STEEL, 0.018),
    ),
    "safe": Noun(
        "strongbox, strong box, money safe, bank safe; vault, bank vault, cash box",
        {
            "body": "*4a5a55 . paint",
            "door": "&5d6f69 . paint",
            "dial": "-d9dcdf . metal",
            "handle": "+d8b24c . golden",
            "hinges": "-9aa0a6 . metal",
            "feet": "-2b2d31",
            "marks": "-23262a",
            "rivets": "-8b979a . metal",
        },
        Usual(0.6, STEEL, 0.056),
    ),
    "washing machine": Noun(
        "washer, laundry machine; dryer, tumble dryer, dishwasher",
        {
            "body": "*eceef0 . paint",
            "door": "+9aa1a8 . metal",
            "glass": "-2b3a46 . glass",
            "panel": "-3c4248",
            "knob": "&c4c9ce",
            "lights": "-5fd0a8",
            "seams": "~9aa0a6",
        },
        Usual(0.85, STEEL, 0.019),
    ),
    "toilet": Noun(
        "loo, lavatory, toilet bowl; commode, bidet, urinal, toilet seat",
        {
            "body": "*eff0ee",
            "seat": "&e2e3e0",
            "lid": "&e8e9e6",
            "tank": "*eff0ee",
            "button": "-a8aeb4 . metal",
            "water": "-8fc9e6 . glass",
            "seams": "~c4c8ca",
            "hinges": "-a8aeb4 . metal",
        },
        Usual(0.75, CERAMIC, 0.15),
    ),
    "bathtub": Noun(
        "bath tub, tub, bath; jacuzzi",
        {
            "body": "*f0f0ee",
            "water": "-7cc0de . glass",
            "tap": "+c9a03c . golden",
            "feet": "&c9a03c . golden",
            "rim": "*f4f4f2",
            "foam": "-ffffff",
            "bands": "&c9a03c . golden",
        },
        Usual(1.7, STEEL, 0.03),
    ),
    "sink": Noun(
        "washbasin, wash basin, basin; bathroom sink, kitchen sink",
        {
            "basin": "*eff0ee",
            "column": "&e6e7e4",
            "tap": "+aab1b8 . metal",
            "handles": "+aab1b8 . metal",
            "drain": "-6d747b . metal",
            "seams": "~bfc4c6",
            "bands": "&c3cbd0",
        },
        Usual(0.9, CERAMIC, 0.12),
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
    "fan": Noun(
        "electric fan, standing fan; ventilator, desk fan, ceiling fan, exhaust fan",
        {
            "blades": "+5aa0c8",
            "cage": "*d8dcdf",
            "hub": "-3a3e44",
            "stand": "&c2c8cc",
            "buttons": "-e4572e",
            "badge": "+5aa0c8",
        },
        Usual(1.1, PLASTIC, 0.16),
    ),
    "picture frame": Noun(
        "photo frame, framed picture, painting; portrait, poster, "
        "whiteboard, blackboard, chalkboard, mona lisa",
        {"frame": "*c9982f . golden", "picture": "-8fc3e6", "hills": "-4f8a45", "sun": "-f5cf3c"},
        Usual(0.6, WOOD, 0.16),
    ),
    "trash can": Noun(
        "garbage can, trashcan, dustbin, trash bin, garbage bin, waste bin; recycling "
        "bin, rubbish bin, litter bin, wheelie bin, trash bag bin, garbage pail, bin, "
        "recycle bin",
        {
            "body": "*7e868c . metal",
            "lid": "&929aa0 . metal",
            "handles": "+5c6268 . metal",
            "flutes": "~565d62 . metal",
        },
        Usual(0.9, STEEL, 0.0044),
    ),
    "toaster": Noun(
        "",
        {
            "body": "*bfc5ca . metal",
            "bread": "-c98b45",
            "base": "-2a2a2c",
            "lever": "+2a2a2c",
            "knob": "+2a2a2c",
        },
        Usual(0.3, STEEL, 0.04),
    ),
    "kettle": Noun(
        "tea kettle, teakettle; electric kettle",
        {
            "body": "*b8322c . paint",
            "spout": "*b8322c . paint",
            "handle": "+241f1d",
            "lid": "&a02a25 . paint",
            "bands": "+f2e6cf . paint",
            "dots": "+f2e6cf . paint",
        },
        Usual(0.25, STEEL, 0.04),
    ),
    "microwave": Noun(
        "microwave oven; toaster oven",
        {
            "body": "*d4d7d9 . paint",
            "window": "-1c2024 . glass",
            "handle": "+8f969c . metal",
            "buttons": "~9aa0a6",
            "display": "-14251d . glass",
            "digits": "-63e6a4",
            "mesh": "-5a6066 . metal",
            "seams": "~8f9499",
        },
        Usual(0.5, STEEL, 0.047),
    ),
    "blender": Noun(
        "kitchen blender; mixer, food processor, juicer, smoothie maker",
        {
            "base": "*c9261f . paint",
            "jug": "-bfdde4 . glass",
            "handle": "&2a2b2e",
            "lid": "+2a2b2e",
            "collar": "&2a2b2e",
            "knob": "-c3c8cd . metal",
            "marks": "-f4f8fa",
            "trim": "-2a2b2e",
        },
        Usual(0.4, PLASTIC, 0.35),
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
}
