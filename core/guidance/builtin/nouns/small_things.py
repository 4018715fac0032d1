"""Small things of the household, and what hangs or lies in a room."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    FABRIC,
    GLASS,
    PLASTIC,
    STEEL,
    WAX,
    WOOD,
    Noun,
    Usual,
)

SMALL_THINGS = {
    "plate": Noun(
        "dish, dinner plate; saucer, platter, serving dish, side plate, dessert plate, paper "
        "plate, tray",
        {"body": "*f0eee6", "rim": "+2f5fa8"},
        Usual(0.26, CERAMIC, 0.22),
    ),
    "cutting board": Noun(
        "chopping board, chopping block; bread board, cheese board, wooden board",
        {"body": "*d3a061 grain", "bands": "+7a4a26 grain", "handle": "&d3a061 grain"},
        Usual(0.4, WOOD, 0.7),
    ),
    "salt shaker": Noun(
        "saltshaker, shaker, salt cellar; pepper shaker, salt and pepper, pepper mill, "
        "pepper pot, pepper grinder, spice jar, sugar shaker",
        {
            "body": "*bcd9de . glass",
            "salt": "-f4f4f0",
            "cap": "+b4bac0 . metal",
            "base": "&a9c8ce . glass",
            "holes": "-26282c",
        },
        Usual(0.09, GLASS, 0.33),
    ),
    "easel": Noun(
        "painter easel, artist easel, art easel, painting easel",
        {
            "legs": "*a5703a grain",
            "ledge": "&8f5d2e grain",
            "canvas": "+f6f1e4",
            "picture": "-8fc3e6",
            "hills": "-4f8a45",
            "sun": "-f5cf3c",
        },
        Usual(1.7, WOOD, 0.038),
    ),
    "flask": Noun(
        "laboratory flask, lab flask, erlenmeyer flask, erlenmeyer, conical flask, "
        "chemistry flask, science flask; beaker, test tube, round bottom flask, chemical "
        "flask, canteen",
        {
            "glass": "*c4e2e8 . glass",
            "liquid": "+2fb84f . glass",
            "rim": "&a9d0d8 . glass",
            "marks": "-f2f5f5",
        },
        Usual(0.18, GLASS, 0.053),
    ),
    "rug": Noun(
        "carpet, area rug, persian rug, persian carpet; floor mat, mat, doormat, magic carpet, "
        "flying carpet, oriental rug, oriental carpet, picnic blanket, picnic rug",
        {
            "border": "+1f2f5c",
            "field": "*a8242c",
            "lozenge": "~e0b45a",
            "middle": "-1f2f5c",
            "fringes": "-efe6d0",
        },
        Usual(2.4, FABRIC, 0.06),
    ),
    "curtain": Noun(
        "drapes, drape, window curtain; stage curtain, drapery, "
        "shower curtain, theater curtain, theatre curtain",
        {
            "curtain": "*b0242e . fabric",
            "rod": "+c9a03c . golden",
            "knobs": "&c9a03c . golden",
            "ties": "-e0b84a . golden",
            "hems": "+e0b84a . golden",
        },
        Usual(2.3, FABRIC, 0.025),
    ),
    "counter": Noun(
        "bar counter, kitchen counter, reception desk, shop counter, countertop, home bar, "
        "counter top; reception counter, kitchen island, front desk, checkout counter",
        {
            "body": "*6b3f20 grain",
            "top": "+d8d2c6 . stone",
            "panels": "~8f5a30 grain",
            "base": "-33221a",
            "rail": "-d2a63e . golden",
        },
        Usual(2.2, WOOD, 0.15),
    ),
    "coat rack": Noun(
        "coat stand, hat stand, coatrack, hatstand, coat hanger stand, hat rack, coat tree, "
        "clothes rack, clothes stand",
        {
            "pole": "*7a4524 grain",
            "legs": "*7a4524 grain",
            "hooks": "&8a5530 grain",
            "knobs": "+d2a63e . golden",
        },
        Usual(1.8, WOOD, 0.093),
    ),
    "hairbrush": Noun(
        "hair brush; comb, hair comb, dog brush, paddle brush",
        {"body": "*c23a6a", "cushion": "+f0d8e0", "bristles": "-2a2326", "handle": "*c23a6a"},
        Usual(0.23, PLASTIC, 0.22),
    ),
    "toothbrush": Noun(
        "tooth brush; electric toothbrush",
        {"handle": "*2f86d6", "grip": "+f2f4f6", "bristles": "-f4f6f8", "stripe": "&2f86d6"},
        Usual(0.19, PLASTIC, 0.74),
    ),
    "lipstick": Noun(
        "lip stick, tube of lipstick; lip balm, chapstick, lip gloss, mascara",
        {
            "case": "+1c1a1e . plastic",
            "tube": "-e0b440 . golden",
            "stick": "*c4142e . plastic",
            "band": "-e0b440 . golden",
            "monogram": "-e0b440 . golden",
            "lines": "-e0b440 . golden",
            "grooves": "~a8832e",
        },
        Usual(0.08, WAX, 0.63),
    ),
    "envelope": Noun(
        "mail envelope; letter, mail, sealed letter, love letter, invitation, postcard, "
        "greeting card",
        {
            "body": "*efe1c0",
            "sides": "&e2cda0",
            "bottom": "*f3e8cf",
            "flap": "&cfb27e",
            "seal": "+b01822",
            "stamp": "-b8433a . paint",
            "address": "-5a4a3a . paint",
        },
        Usual(0.22, 750.0, 0.023),
    ),
    "syringe": Noun(
        "injection, medical syringe; vaccine, hypodermic needle, hypodermic",
        {
            "barrel": "*dfe9ee . plastic",
            "liquid": "+39a8d8 . plastic",
            "plunger": "&c9d3da . plastic",
            "marks": "-23282e",
            "hub": "-e07a2a . plastic",
            "needle": "-b4bac0 . metal",
        },
        Usual(0.15, PLASTIC, 0.15),
    ),
    "magnet": Noun(
        "horseshoe magnet, horse shoe magnet",
        {"body": "*cc1f24 . paint", "poles": "+c3c8cd . metal", "bands": "-f2f2ef"},
        Usual(0.1, STEEL, 0.093),
    ),
    "screw": Noun(
        "wood screw; bolt, machine screw, wall screw",
        {
            "head": "*bfc4c9 . metal",
            "shaft": "*9aa0a6 . metal",
            "thread": "&b0b6bc . metal",
        },
        Usual(0.05, STEEL, 0.071),
    ),
    "rake": Noun(
        "garden rake, leaf rake; hoe, pitchfork, hay fork, gardening fork, garden fork",
        {
            "tines": "+3f7f4a . paint",
            "bar": "+3f7f4a . paint",
            "socket": "&2f5f38 . paint",
            "handle": "*b98246 grain",
            "grip": "-26282b . rubber",
        },
        Usual(1.5, WOOD, 0.069),
    ),
    "maracas": Noun(
        "maraca, pair of maracas; rattle, rumba shaker",
        {
            "heads": "*d8262a . paint",
            "bands": "+f6c52e . paint",
            "tops": "-2f9a58 . paint",
            "handles": "-c08a4a grain",
            "knobs": "-c08a4a grain",
        },
        Usual(0.28, WOOD, 0.15),
    ),
    "megaphone": Noun(
        "bullhorn, bull horn, loudhailer; loudspeaker horn, horn speaker, cheer megaphone",
        {
            "horn": "*f1f1ee . plastic",
            "rim": "+d02a24 . plastic",
            "body": "+d02a24 . plastic",
            "cap": "-34373b . plastic",
            "handle": "-2b2d31 . plastic",
            "trigger": "-e9b52c . plastic",
        },
        Usual(0.35, PLASTIC, 0.087),
    ),
    "hammock": Noun(
        "garden hammock, hammock stand; hanging bed",
        {
            "cloth": "*f2ead6 . fabric",
            "stripes": "+2c86b8 . fabric",
            "bars": "-b98246 grain",
            "ropes": "-e0d2b0",
            "posts": "&8a5a2e grain",
            "base": "&8a5a2e grain",
        },
        Usual(3.2, WOOD, 0.05),
    ),
    "gong": Noun(
        "temple gong, chinese gong; tam tam, cymbal, cymbals",
        {
            "disc": "*c98f35 . golden",
            "rim": "*a8702a . golden",
            "boss": "&e0b050 . golden",
            "ropes": "-e8dcc0",
            "frame": "+a3261f . paint",
            "feet": "-2a1c16",
        },
        Usual(1.6, COPPER, 0.025),
    ),
    "pipe": Noun(
        "water pipe, pipe fitting, pipeline; plumbing, drain pipe, "
        "sewer pipe, gas pipe, plumbing pipe, pvc pipe, tube",
        {
            "pipe": "*5f7f94 . paint",
            "flanges": "&4a6678 . paint",
            "bolts": "-c3c8cd . metal",
            "bands": "+d8a02a . paint",
        },
        Usual(0.5, STEEL, 0.13),
    ),
}
