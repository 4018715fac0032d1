"""Writing things, books, and instruments of schools, laboratories, doctors and travellers."""

from core.guidance.builtin.nouns.noun import (
    COPPER,
    GLASS,
    PAPER,
    PLASTIC,
    RUBBER,
    STEEL,
    WOOD,
    Noun,
    Usual,
)

SCHOOL_AND_LABORATORY = {
    "pen": Noun(
        "pens, fountain pen, fountain pens, ink pen, ballpoint pen, ballpoint, ball pen, biro, "
        "writing pen, nib pen; ballpoint pens, gel pen, rollerball, calligraphy pen, dip pen, "
        "stylus",
        {
            "body": "*1f4fa8 . paint",
            "grip": "+26262c . plastic",
            "nib": "+e8bc4a . golden",
            "hole": "-33291c",
            "bands": "+e8bc4a . golden",
            "clip": "+e8bc4a . golden",
        },
        Usual(0.14, PLASTIC, 0.4),
    ),
    "notebook": Noun(
        "notebooks, note book, spiral notebook, spiral notebooks, notepad, note pad, sketchbook, "
        "sketch book, exercise book, school notebook, ring notebook, ring-bound notebook, sketch "
        "pad, writing pad; journal, planner, diary, steno pad",
        {
            "cover": "*2c8fb8",
            "pages": "-f4f0e4",
            "rings": "-8f979f . metal",
            "label": "-f4ecd4",
            "band": "+e2543a . fabric",
        },
        Usual(0.24, WOOD, 0.6),
    ),
    "ruler": Noun(
        "rulers, wooden ruler, school ruler, straightedge, straight edge, "
        "measuring stick; yardstick, meter stick, metre stick",
        {"body": "*e0b56a grain", "marks": "-2a2622"},
        Usual(0.3, WOOD, 0.5),
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
    "clipboard": Noun(
        "clip board, clip boards, clipboards; checklist, check list, to do list, questionnaire, "
        "menu",
        {
            "board": "*a8703c grain",
            "paper": "-fbfaf4",
            "lines": "-5f7590",
            "boxes": "+2fa35a",
            "clip": "-b9c0c8 . metal",
            "bar": "-8e959e . metal",
        },
        Usual(0.32, WOOD, 0.35),
    ),
    "notice board": Noun(
        "noticeboard, bulletin board, cork board, corkboard, pinboard, pin board; memo board, "
        "message board, quest board, job board, evidence board",
        {
            "frame": "*8a5630 grain",
            "cork": "-c99a5f mottle",
            "paper": "-fbfaf4",
            "notes": "+f7d84a",
            "cards": "+7cc3e8",
            "pins": "-d5342c . plastic",
            "lines": "-8f98a3",
            "words": "-8a6d1f",
        },
        Usual(1.0, WOOD, 0.3),
    ),
    "map pin": Noun(
        "map pins, location pin, location marker, map marker, location icon, gps pin, place pin, "
        "pin icon, google maps pin, map pointer; geotag, drop pin, push pin, pushpin, thumbtack",
        {"body": "*e0322b . plastic", "disc": "+f7f5f0 . plastic", "star": "-e0322b"},
        Usual(0.3, PLASTIC, 0.3),
    ),
    "stack of books": Noun(
        "pile of books, book stack, book pile, stacked books, books, stacks of books, "
        "piles of books; heap of books, book collection",
        {
            "books": "*9a2a2c",
            "tomes": "&2f5a8a",
            "volumes": "&3f7a4c",
            "pages": "-f2e8cf",
            "bands": "+d8a83c . golden",
        },
        Usual(0.26, PAPER, 0.7),
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
    "abacus": Noun(
        "abaci, abacuses, counting frame, bead frame; soroban, suanpan, bead maze",
        {
            "frame": "*9a6434 grain",
            "rods": "-c4c7ca . metal",
            "beads": "+d8322a . paint",
            "counters": "-f0b429 . paint",
            "pearls": "-2f6fc0 . paint",
        },
        Usual(0.3, WOOD, 0.5),
    ),
    "molecule": Noun(
        "molecules, water molecule, molecule model, molecular model, methane molecule, h2o, "
        "h2o molecule; chemical compound, protein",
        {
            "core": "*d42a24",
            "atoms": "+f2f2ee",
            "bonds": "-9a9da1",
        },
        Usual(0.2, PLASTIC, 0.3),
    ),
    "magnet": Noun(
        "horseshoe magnet, horse shoe magnet",
        {"body": "*cc1f24 . paint", "poles": "+c3c8cd . metal", "bands": "-f2f2ef"},
        Usual(0.1, STEEL, 0.093),
    ),
    "flask": Noun(
        "laboratory flask, lab flask, erlenmeyer flask, erlenmeyer, conical flask, chemistry "
        "flask, science flask; round bottom flask, chemical flask, canteen",
        {
            "glass": "*c4e2e8 . glass",
            "liquid": "+2fb84f . glass",
            "rim": "&a9d0d8 . glass",
            "marks": "-f2f5f5",
        },
        Usual(0.18, GLASS, 0.053),
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
    "stethoscope": Noun(
        "doctor's stethoscope, doctor stethoscope, medical stethoscope, stethoscopes",
        {
            "tube": "*1f5f8f . rubber",
            "ear tubes": "-c9ced4 . metal",
            "tips": "+23262b . rubber",
            "chest piece": "-b4bac2 . metal",
            "disc": "+f1efe8 . plastic",
            "collars": "&174a70 . rubber",
        },
        Usual(0.6, RUBBER, 0.15),
    ),
    "first aid kit": Noun(
        "medical kit, first aid box, medkit, med kit, medic kit, medical box, medical case, "
        "first aid case, firstaid kit; health pack, first aid bag, doctor's bag, doctor bag, "
        "medical bag",
        {
            "body": "*d3252b . plastic",
            "cross": "+fbfbf8 . plastic",
            "handle": "-2b2e33 . plastic",
            "latches": "-c3c8ce . metal",
            "band": "&a3191f . plastic",
            "feet": "-2b2e33 . rubber",
        },
        Usual(0.35, PLASTIC, 0.15),
    ),
    "binoculars": Noun(
        "binocular, field glasses, pair of binoculars, field glass; opera glasses, "
        "night vision binoculars",
        {
            "barrels": "*2f3a35 . rubber",
            "rims": "&1f2422",
            "lenses": "-7a4fae . glass",
            "eyepieces": "-151718 . rubber",
            "bridge": "&3d4844",
            "wheel": "+b4b9bf . metal",
        },
        Usual(0.18, PLASTIC, 0.6),
    ),
    "spyglass": Noun(
        "spyglasses, spy glass, hand telescope, handheld telescope, pocket telescope, pirate "
        "telescope, captain telescope, ship telescope, nautical telescope, naval telescope, "
        "sailor telescope; monocular, kaleidoscope",
        {
            "barrel": "*6a4124 . leather",
            "tubes": "&d9a94a . golden",
            "bands": "+d9a94a . golden",
            "lens": "-7fb0c8 . glass",
            "eyepiece": "-2a211c",
        },
        Usual(0.5, COPPER, 0.024),
    ),
    "pocket watch": Noun(
        "pocket watches, pocketwatch, fob watch, watch on a chain; stopwatch, stop watch, "
        "pocket clock",
        {
            "case": "*d8a838 . golden",
            "face": "-f6f1e2",
            "hands": "-1c1c20",
            "rim": "&b98828 . golden",
            "crown": "&c8962e . golden",
            "chain": "+c9a550 . golden",
            "marks": "-1c1c20",
        },
        Usual(0.07, STEEL, 0.3),
    ),
}
