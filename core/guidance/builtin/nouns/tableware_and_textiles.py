"""Tableware, cloths of a room, toiletries, a counter, a grill and a coat rack."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    FABRIC,
    GLASS,
    PAPER,
    PLASTIC,
    STEEL,
    WAX,
    WOOD,
    Noun,
    Usual,
)

TABLEWARE_AND_TEXTILES = {
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
    "paper cup": Noun(
        "takeaway cup, coffee to go, takeaway coffee, to go cup, disposable cup, take away cup, "
        "paper coffee cup, takeaway coffee cup, disposable coffee cup, takeout cup, to go coffee, "
        "takeout coffee; coffee, coffee paper cup, latte, "
        "cappuccino, espresso, tea, soda cup, plastic cup, yogurt, yoghurt",
        {
            "cup": "*f4efe6",
            "sleeve": "+9a6a3e",
            "lid": "&f7f5f0 . plastic",
            "rim": "&e9e2d4",
            "spout": "-2a211c . plastic",
            "badge": "-2f6b4a",
        },
        Usual(0.16, PAPER, 0.02),
    ),
    "bubble tea": Noun(
        "bubble teas, boba, boba tea, pearl milk tea, milk tea, boba milk tea, bubble milk tea, "
        "tapioca tea, cup of bubble tea, cup of boba, cup of milk tea; cup of iced coffee, cup of "
        "iced tea, iced coffee, iced tea, ice tea, smoothie, frappuccino, soft drink, lemonade, "
        "iced latte, juice, slushie",
        {
            "tea": "*cf9f6e . plastic",
            "pearls": "-2b1a14 . plastic",
            "lid": "-eef1f2 . plastic",
            "straw": "+e0527a . plastic",
            "rim": "-eef1f2 . plastic",
        },
        Usual(0.22, PLASTIC, 0.5),
    ),
    "grill": Noun(
        "barbecue, bbq, barbeque, barbecue grill, bbq grill, kettle grill, charcoal grill, "
        "barbecue set; gas grill, smoker grill, barbecue smoker",
        {
            "bowl": "*26282c . paint",
            "lid": "*26282c . paint",
            "legs": "-aab0b6 . metal",
            "grate": "-8a9098 . metal",
            "food": "-9a4a26",
            "handles": "+3a2a22",
        },
        Usual(1.3, STEEL, 0.012),
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
    "towel": Noun(
        "bath towel, folded towel, hand towel, rolled towel, stack of towels, pile of towels; "
        "beach towel, blanket, folded blanket, throw blanket, bed sheet, handkerchief, napkin, "
        "quilt, duvet, tablecloth",
        {
            "towels": "*4fa3b8 . fabric",
            "folds": "&3b869a . fabric",
            "bands": "+f2ede0 . fabric",
            "roll": "*6fb9cb . fabric",
        },
        Usual(0.4, FABRIC, 0.2),
    ),
    "toilet paper": Noun(
        "toilet roll, toilet paper roll, loo roll, toilet tissue; "
        "paper roll, kitchen roll, paper towel, paper towels, roll of paper, tissue roll",
        {
            "roll": "*f5f3ee",
            "sheet": "*faf8f4",
            "core": "-a9763f",
            "line": "-b9c4d2",
            "dots": "+a9cdea",
        },
        Usual(0.14, PAPER, 0.18),
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
}
