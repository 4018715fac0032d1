"""Bread, cakes, sweets, ice cream and other snacks."""

from core.guidance.builtin.nouns.noun import FLESH, PAPER, PLANT, SNOW, Noun, Usual

BREAD_AND_SWEETS = {
    "bread": Noun(
        "loaf, loaf of bread, bread loaf; toast, baguette, sourdough, bun, bread roll, brioche",
        {"crust": "*b8742e", "crumb": "+f1dcae", "scores": "~e9bb78"},
        Usual(0.28, 300.0, 0.39),
    ),
    "croissant": Noun(
        "; pastry, danish",
        {"crust": "*d1913f", "folds": "&a8662a"},
        Usual(0.16, 300.0),
    ),
    "pretzel": Noun(
        "; bretzel",
        {"dough": "*9a5322", "salt": "+f4efe4"},
        Usual(0.16, 400.0),
    ),
    "cake": Noun(
        "birthday cake; torte, wedding cake, cheesecake, pudding, brownie, lasagna",
        {
            "icing": "*f6b7c8",
            "body": "+8a5430",
            "topping": "-c2182b",
            "plate": "-ece9e2",
            "candles": "+fbf3e0",
            "flames": "-ff9a1e",
            "sprinkles": "-ffd84a",
            "cream": "-f6e6c8",
        },
        Usual(0.28, 450.0),
    ),
    "cupcake": Noun(
        "cup cake; fairy cake",
        {"icing": "*f3a9c4", "cup": "+8a5a3a", "cherry": "-b8121f"},
        Usual(0.08, 400.0),
    ),
    "muffin": Noun(
        "muffins, blueberry muffin, blueberry muffins; chocolate chip muffin, chocolate muffin, "
        "banana muffin",
        {
            "top": "*dd9a48",
            "cup": "+f6e3b8",
            "berries": "+3a3f86",
        },
        Usual(0.09, 500.0),
    ),
    "pie": Noun(
        "apple pie, cherry pie; tart, quiche",
        {
            "crust": "*d49a4e",
            "filling": "+a8222a",
            "dish": "-d8d4cc",
            "bands": "-3f6fa8 . paint",
            "flutes": "~b3ada0",
        },
        Usual(0.28, 700.0),
    ),
    "pancakes": Noun(
        "pancake, stack of pancakes; crepe, crepes, tortilla",
        {"pancakes": "*d99a48", "syrup": "+7a3c12", "butter": "-f8e58a", "plate": "-eceae4"},
        Usual(0.22, 600.0, 0.45),
    ),
    "waffle": Noun(
        "belgian waffle",
        {"body": "&c07a2c", "ridges": "*dd9e48", "syrup": "+7a3c12", "butter": "-f8e58a"},
        Usual(0.15, 500.0, 0.32),
    ),
    "cinnamon roll": Noun(
        "cinnamon rolls, cinnamon bun, cinnamon buns, cinnabon, cinnamon swirl, iced bun, sticky "
        "bun, glazed cinnamon roll; danish pastry, raisin swirl, swirl bun",
        {"bun": "*d7974a", "cinnamon": "-6e3314", "icing": "+fbf6ea"},
        Usual(0.11, FLESH, 0.4),
    ),
    "donut": Noun(
        "doughnut, iced donut, frosted donut, glazed donut, iced doughnut, glazed doughnut, "
        "frosted doughnut, ring doughnut, sprinkled donut, pink donut; bagel, donut ring",
        {
            "dough": "-d89a4c",
            "icing": "*f27fae",
            "sprinkles": "+ffd84a",
            "strands": "-4fc3e0",
            "drops": "-fbf6ee",
        },
        Usual(0.1, 450.0, 0.7),
    ),
    "cookie": Noun(
        "chocolate chip cookie; biscuit, oreo, macaron, cracker",
        {"body": "*cc9248", "chips": "+43230f", "dimples": "~a06c2e"},
        Usual(0.08, 500.0),
    ),
    "gingerbread man": Noun(
        "gingerbread, gingerbread cookie, gingerbread boy, ginger bread man; gingerbread woman, "
        "gingerbread figure, christmas cookie",
        {
            "body": "*a5622a",
            "icing": "+fbf4e8",
            "eyes": "-fbf4e8",
            "buttons": "-cf2430",
            "bow": "+2f8f46",
        },
        Usual(0.15, 650.0, 0.4),
    ),
    "candy cane": Noun(
        "candycane, christmas candy cane, candy stick",
        {"candy": "*f6f2ee", "stripes": "+d01c28"},
        Usual(0.15, 1300.0, 0.2),
    ),
    "lollipop": Noun(
        "lolly, lollypop; candy, candy pop, chupa chup",
        {"candy": "*e23a5e", "swirl": "+f8f2ee", "stick": "-f1ece2"},
        Usual(0.18, 1200.0, 0.2),
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
    "ice cream": Noun(
        "icecream, ice cream cone; gelato, gelato cone, soft serve, snow cone, sorbet, "
        "waffle cone, sugar cone",
        {
            "scoop": "*f6c6cc",
            "cone": "+c98a45 waffle",
            "cherry": "-b8121f",
            "sauce": "-5a2f1c",
            "sprinkles": "-fff3d6",
        },
        Usual(0.18, 600.0, 0.63),
    ),
    "popsicle": Noun(
        "ice lolly, ice pop, ice cream bar; popsicle stick, creamsicle",
        {"ice": "*e8364a", "top": "+f6b02f", "stick": "-d9b382 grain"},
        Usual(0.18, SNOW, 0.54),
    ),
    "sundae": Noun(
        "ice cream sundae, ice cream cup; parfait, milkshake, knickerbocker glory, "
        "banana split, frozen yogurt, ice cream bowl",
        {
            "glass": "&c4e2e8 . glass",
            "scoops": "*f7e3c4",
            "sauce": "+4a2413",
            "cherry": "-c4142a",
            "wafer": "-d19a50 waffle",
        },
        Usual(0.2, FLESH, 0.43),
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
    "watermelon slice": Noun(
        "slice of watermelon, water melon slice, sliced watermelon, piece of watermelon, "
        "watermelon wedge; melon slice, slice of melon",
        {"flesh": "*e5383c", "pith": "-e6f0c2", "rind": "-2f7d36", "seeds": "-231712"},
        Usual(0.25, PLANT),
    ),
}
