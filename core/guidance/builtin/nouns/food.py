"""Food; fruit and vegetables are among it."""

from core.guidance.builtin.nouns.noun import PLANT, Noun, Usual

FOOD = {
    "hamburger": Noun(
        "burger, cheeseburger",
        {"bun": "*cf8a3c", "lettuce": "+5fae34", "patty": "-5a3019", "cheese": "-f5b52a"},
        Usual(0.12, 500.0),
    ),
    "ice cream": Noun(
        "icecream, ice cream cone; gelato",
        {"scoop": "*f6c6cc", "cone": "+c98a45 waffle", "cherry": "-b8121f"},
        Usual(0.18, 600.0),
    ),
    "pineapple": Noun(
        "",
        {"body": "*dd9a26 scales", "leaves": "+3c7d33"},
        Usual(0.3, PLANT),
    ),
    "apple": Noun(
        "",
        {"body": "*c4201f", "stalk": "-523219", "leaf": "+4d9a35"},
        Usual(0.08, 800.0),
    ),
    "carrot": Noun(
        "",
        {"body": "*ee7415", "leaves": "+3f9433"},
        Usual(0.2, 1000.0),
    ),
    "cupcake": Noun(
        "cup cake; muffin",
        {"icing": "*f3a9c4", "cup": "+8a5a3a", "cherry": "-b8121f"},
        Usual(0.08, 400.0),
    ),
    "pumpkin": Noun(
        "",
        {"body": "*e27414", "stalk": "+5c6b2c"},
        Usual(0.35, PLANT, 0.6),
    ),
    "banana": Noun(
        "bananas; plantain",
        {"peel": "*f4cf2e", "ends": "+5a4422"},
        Usual(0.19, PLANT),
    ),
    "pear": Noun(
        "",
        {"body": "*b7c23a", "stalk": "-523219", "leaf": "+4d9a35"},
        Usual(0.12, PLANT),
    ),
    "strawberry": Noun(
        "strawberries; raspberry, berry",
        {"body": "*d3182a", "leaves": "+4a9636", "seeds": "-f0d27a"},
        Usual(0.05, PLANT),
    ),
    "cherry": Noun(
        "cherries",
        {"fruits": "*b40f22", "stalks": "-6d7a2e", "leaf": "+4d9a35"},
        Usual(0.08, PLANT),
    ),
    "lemon": Noun(
        "; lime fruit, citrus",
        {"body": "*f4d92b", "leaf": "+4a9636"},
        Usual(0.1, PLANT),
    ),
    "watermelon": Noun(
        "water melon; melon, watermelon slice",
        {"rind": "+2f7d36", "flesh": "*e2343f", "seeds": "-1f1512"},
        Usual(0.3, PLANT),
    ),
    "grapes": Noun(
        "grape, bunch of grapes",
        {"grapes": "*5f2a78", "stalk": "-6a4a28", "leaf": "+4f9238"},
        Usual(0.18, PLANT, 0.8),
    ),
    "avocado": Noun(
        "; guacamole",
        {"skin": "+2f4a24", "flesh": "*c9d46a", "stone": "-7a4a22"},
        Usual(0.11, PLANT),
    ),
    "corn": Noun(
        "maize, corn cob, corncob, corn on the cob",
        {"kernels": "*f2c52e", "husk": "+6fa23c"},
        Usual(0.25, PLANT),
    ),
    "broccoli": Noun(
        "; cauliflower",
        {"florets": "*2f7a30", "stem": "+8fb860"},
        Usual(0.18, PLANT, 0.6),
    ),
    "eggplant": Noun(
        "aubergine",
        {"body": "*3f1d4f", "cap": "+5a8a3a"},
        Usual(0.22, PLANT),
    ),
    "pepper": Noun(
        "bell pepper, paprika, capsicum; chili, chilli",
        {"body": "*cf1f1a", "stalk": "+4f8a32"},
        Usual(0.12, PLANT, 0.4),
    ),
    "onion": Noun(
        "; garlic, shallot",
        {"body": "*c98a45", "roots": "-e3d3b0"},
        Usual(0.09, PLANT),
    ),
    "peach": Noun(
        "; nectarine, apricot, plum",
        {"body": "*f2a065", "stalk": "-5c3a1e", "leaf": "+4d9a35"},
        Usual(0.08, PLANT),
    ),
}
