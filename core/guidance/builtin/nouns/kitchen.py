"""A kitchen's vessels, pans and appliances."""

from core.guidance.builtin.nouns.noun import CERAMIC, GLASS, PLASTIC, STEEL, Noun, Usual

KITCHEN = {
    "mug": Noun(
        "cup, coffee cup, coffee mug; beer mug, stein, tankard, beer, pint of beer, glass of beer",
        {"body": "*e0dbd1", "handle": "&e0dbd1", "bands": "~5f87ab"},
        Usual(0.1, CERAMIC, 0.98),
    ),
    "teacup": Noun(
        "tea cup, cup and saucer, cup of tea, cup with saucer, teacup and saucer, tea cups; "
        "espresso cup, cup of coffee, hot chocolate",
        {
            "cup": "*f3efe6 . ceramic",
            "saucer": "*f3efe6 . ceramic",
            "tea": "-9c4f1c",
            "rim": "+d8a83c . golden",
            "handle": "&f3efe6 . ceramic",
        },
        Usual(0.15, CERAMIC, 0.4),
    ),
    "wine glass": Noun(
        "wineglass, wine glasses, glass of wine, glass of red wine, glass of white wine, red wine "
        "glass, wine goblet, crystal wine glass, glasses of wine; champagne flute, champagne "
        "glass, glass of champagne, cocktail, martini, martini glass, cocktail glass, brandy "
        "glass",
        {
            "bowl": "-d8e8ec . glass",
            "liquid": "*9c1230",
            "stem": "-d8e8ec . glass",
            "foot": "-d8e8ec . glass",
        },
        Usual(0.21, GLASS, 0.2),
    ),
    "goblet": Noun(
        "chalice; glass of water, glass of milk, wine cup, holy grail, drinking glass, tumbler, "
        "pint glass, beer glass, shot glass, whiskey glass, whisky glass, glass of juice, glass of "
        "lemonade",
        {"cup": "*e0b84a . golden", "stem": "&c9a03c . golden"},
        Usual(0.18, STEEL, 0.15),
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
    "bowl": Noun(
        "; fishbowl, fish bowl, goldfish bowl, salad bowl, mixing bowl, fruit bowl",
        {"body": "*d8d2c4", "foot": "&b9a98c", "bands": "~4f7ea6"},
        Usual(0.16, CERAMIC, 0.5),
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
    "kettle": Noun(
        "tea kettle, teakettle; electric kettle",
        {
            "body": "*b8322c . paint",
            "spout": "*b8322c . paint",
            "handle": "+241f1d",
            "lid": "&a02a25 . paint",
            "lines": "+f2e6cf . paint",
        },
        Usual(0.25, STEEL, 0.04),
    ),
    "pan": Noun(
        "frying pan, skillet; saucepan, wok",
        {"body": "*33353a . metal", "handle": "+1c1a19"},
        Usual(0.45, STEEL, 0.13),
    ),
    "cooking pot": Noun(
        "saucepot, stockpot, stock pot, soup pot, casserole, casserole dish; "
        "stew pot, pressure cooker, dutch oven, crock pot, saucepan with lid",
        {
            "body": "*c43a2c . paint",
            "rim": "-c3c8cd . metal",
            "handles": "+26272a . plastic",
            "lid": "*c43a2c . paint",
            "knob": "+26272a . plastic",
        },
        Usual(0.34, STEEL, 0.04),
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
    "refrigerator": Noun(
        "fridge; freezer, minifridge",
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
    "blender": Noun(
        "kitchen blender; food processor, juicer, smoothie maker",
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
}
