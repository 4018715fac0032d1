"""Everyday food and things: of a market, a kitchen, a bath and a yard."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    FABRIC,
    LEATHER,
    PLANT,
    PLASTIC,
    STEEL,
    WOOD,
    Noun,
    Usual,
)

PAPER = 750.0  # kg/m³

EVERYDAY_FOOD = {
    "ramen": Noun(
        "noodles, noodle, ramen bowl, bowl of ramen, ramen noodles, bowl of noodles, noodle "
        "bowl; noodle soup, bowl of soup, chicken noodle soup, udon, pho, instant noodles, "
        "spaghetti, soup, stew, pasta, pad thai, curry, chili con carne",
        {
            "bowl": "*b3231f . ceramic",
            "broth": "-b9702c",
            "noodles": "-f0d488",
            "whites": "-f7f3e8",
            "yolks": "-f2a21e",
            "chopsticks": "+3a211a grain",
        },
        Usual(0.22, CERAMIC, 0.2),
    ),
    "popcorn": Noun(
        "pop corn, popcorn box, box of popcorn, popcorn bucket, bucket of popcorn, "
        "bag of popcorn; movie snack",
        {
            "box": "+f6f2ea",
            "stripes": "*d0221f",
            "popcorn": "-fbf0cc",
            "butter": "-f4c63c",
            "badge": "~b51a18",
        },
        Usual(0.22, PAPER, 0.05),
    ),
    "chocolate bar": Noun(
        "bar of chocolate, choc bar, piece of chocolate; candy bar, milk chocolate bar, "
        "milk chocolate",
        {
            "chocolate": "-5a2f1a",
            "squares": "-6b3920",
            "foil": "-d0d4d9 . metal",
            "wrapper": "*8a1f2c",
            "label": "+f1dfb4",
            "bands": "+d8a83c . golden",
            "letters": "-5a2f1a",
            "border": "+d8a83c . golden",
        },
        Usual(0.16, 1300.0, 0.2),
    ),
}
EVERYDAY_PLANTS = {
    "potato": Noun(
        "spud, raw potato; sweet potato, yam, baked potato, new potato, ginger root",
        {"body": "*c69a5c", "spots": "-7a5530"},
        Usual(0.11, PLANT, 0.6),
    ),
    "cucumber": Noun(
        "; pickle, gherkin, zucchini, courgette, pickled cucumber",
        {
            "rind": "*2f7a35",
            "stripes": "&6fae4c",
            "flesh": "-c3e08e",
            "seeds": "-faf6da",
            "stem": "-5f8f3c",
        },
        Usual(0.26, PLANT, 0.3),
    ),
    "lettuce": Noun(
        "head of lettuce, lettuce head; cabbage, salad head, iceberg lettuce, head of cabbage, "
        "kale, bok choy, brussels sprout, artichoke, spinach, celery",
        {
            "head": "&a6d268",
            "leaves": "*58a83a",
            "frills": "&86c650",
            "ribs": "-dcebb4",
            "stalk": "-eef0cc",
        },
        Usual(0.25, PLANT, 0.2),
    ),
    "pinecone": Noun(
        "pine cone, fir cone; cedar cone, spruce cone, conifer cone, larch cone",
        {"core": "*5a3820", "scales": "*7a4c2a", "tips": "+b98a58", "stem": "-4a2f1c"},
        Usual(0.1, WOOD, 0.2),
    ),
    "bamboo plant": Noun(
        "bamboo stalk, bamboo stem, bamboo tree, bamboo cane; bamboo shoot, bamboo forest, "
        "bamboo grove, lucky bamboo, sugar cane, sugarcane",
        {
            "stalks": "*6fa83c",
            "rings": "+b9cc6c",
            "leaves": "&3f8a35",
            "ground": "-6a4a2e",
        },
        Usual(3.0, PLANT, 0.012),
    ),
}
EVERYDAY_CLOTHES = {
    "sock": Noun(
        "socks, pair of socks, stocking; christmas stocking, stockings, christmas sock, "
        "ankle sock, football sock",
        {
            "body": "*c4262c . fabric",
            "cuff": "+f4efe4 . fabric",
            "heel": "+f4efe4 . fabric",
            "toe": "+f4efe4 . fabric",
            "stripes": "+f4efe4 . fabric",
        },
        Usual(0.4, FABRIC, 0.025),
    ),
    "belt": Noun(
        "belts, leather belt, waist belt; utility belt, champion belt, gun belt, buckle belt",
        {
            "strap": "*6b4226 . leather",
            "buckle": "+d9ab48 . golden",
            "keeper": "&5a3620 . leather",
            "holes": "-1c120c",
        },
        Usual(0.35, LEATHER, 0.15),
    ),
    "scarf": Noun(
        "scarves, winter scarf, wool scarf, woolen scarf, knitted scarf; shawl, neckerchief, "
        "bandana, bandanna, headscarf",
        {
            "wool": "*bd2a2e . fabric",
            "stripes": "+f4efe4 . fabric",
            "fringes": "+f4efe4 . fabric",
            "knot": "&a82428 . fabric",
            "lines": "+f4efe4 . fabric",
        },
        Usual(0.6, FABRIC, 0.03),
    ),
}
EVERYDAY_THINGS = {
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
    "rope": Noun(
        "coil of rope, rope coil, coiled rope, roll of rope; lasso, lariat, jump rope, skipping "
        "rope, climbing rope, garden hose, fire hose, hose, thread, ball of yarn",
        {
            "coil": "*c9a468",
            "strands": "*b38c50",
            "ties": "+7a5230",
            "end": "&8a5f36",
        },
        Usual(0.4, FABRIC, 0.9),
    ),
}
EVERYDAY_RELICS = {
    "drinking horn": Noun(
        "viking horn, ale horn, mead horn, viking drinking horn; horn, war horn, powder horn, "
        "hunting horn, blowing horn, battle horn",
        {
            "horn": "*cdb48a",
            "rim": "+d8a83c . golden",
            "foam": "-f8f0dc",
            "tip": "+d8a83c . golden",
            "strap": "&6b4528 . leather",
            "stand": "-5f3c22 grain",
        },
        Usual(0.35, LEATHER, 0.15),
    ),
}
