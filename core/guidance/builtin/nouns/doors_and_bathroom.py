"""Doors and windows, a bathroom, what a house is cleaned and aired with, and a safe."""

from core.guidance.builtin.nouns.noun import CERAMIC, PLASTIC, STEEL, WOOD, Noun, Usual

DOORS_AND_BATHROOM = {
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
    "sci-fi door": Noun(
        "scifi door, futuristic door, spaceship door, space door, sci-fi gate, bulkhead door, "
        "blast door; airlock, cyberpunk door",
        {
            "door": "*5b656f . metal",
            "panels": "&748090 . metal",
            "frame": "+2b3037 . metal",
            "lights": "-37dff0",
            "seam": "-14171b",
            "stripes": "-e9b02c . paint",
            "lines": "~3b434c . metal",
        },
        Usual(2.4, STEEL, 0.02),
        "door",
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
        "bath tub, tub, bath",
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
    "mop": Noun(
        "mops, floor mop, string mop, cleaning mop, wet mop; dust mop",
        {
            "handle": "+b98648 grain",
            "clamp": "+2f6fb8 . plastic",
            "strands": "*f1ede2 . fabric",
            "cap": "+2f6fb8 . plastic",
        },
        Usual(1.4, WOOD, 0.15),
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
}
