"""Fruit and vegetables."""

from core.guidance.builtin.nouns.noun import PLANT, Noun, Usual

FRUIT_AND_VEGETABLES = {
    "apple": Noun(
        "; pomegranate",
        {"body": "*c4201f", "stalk": "-523219", "leaf": "+4d9a35"},
        Usual(0.08, 800.0),
    ),
    "pear": Noun(
        "; papaya",
        {"body": "*b7c23a", "stalk": "-523219", "leaf": "+4d9a35"},
        Usual(0.12, PLANT, 0.75),
    ),
    "banana": Noun(
        "bananas; plantain",
        {"peel": "*f4cf2e", "ends": "+5a4422"},
        Usual(0.19, PLANT, 0.72),
    ),
    "orange fruit": Noun(
        "oranges, orange slice, sliced orange, fresh orange, ripe orange; tangerine, mandarin, "
        "clementine, grapefruit, citrus fruit, satsuma",
        {
            "body": "*f0861a",
            "pith": "-f8ecd0",
            "flesh": "+f59a22",
            "stalk": "-5c6b2c",
            "leaf": "-4d9a35",
        },
        Usual(0.14, PLANT, 0.69),
    ),
    "lemon": Noun(
        "; lime fruit, citrus, citron",
        {"body": "*f4d92b", "leaf": "+4a9636"},
        Usual(0.1, PLANT),
    ),
    "peach": Noun(
        "; nectarine, apricot, plum, mango, lychee",
        {"body": "*f2a065", "stalk": "-5c3a1e", "leaf": "+4d9a35"},
        Usual(0.08, PLANT, 0.75),
    ),
    "cherry": Noun(
        "cherries",
        {"fruits": "*b40f22", "stalks": "-6d7a2e", "leaf": "+4d9a35"},
        Usual(0.08, PLANT, 0.31),
    ),
    "strawberry": Noun(
        "strawberries; raspberry, berry, blackberry",
        {"body": "*d3182a", "leaves": "+4a9636", "seeds": "-f0d27a"},
        Usual(0.05, PLANT),
    ),
    "grapes": Noun(
        "grape, bunch of grapes; blueberry, blueberries",
        {"grapes": "*5f2a78", "stalk": "-6a4a28", "leaf": "+4f9238"},
        Usual(0.18, PLANT, 0.8),
    ),
    "kiwi": Noun(
        "kiwis, kiwi fruit, kiwifruit, kiwi fruits, half kiwi, halved kiwi, sliced kiwi, kiwi "
        "half, cut kiwi, green kiwi, kiwi slice; golden kiwi",
        {
            "skin": "*7c5a34",
            "flesh": "-86bf2e",
            "middle": "-eef0c4",
            "seeds": "-1c1a17",
            "tips": "&4e371f",
        },
        Usual(0.09, PLANT),
    ),
    "pineapple": Noun(
        "",
        {"body": "*dd9a26 scales", "leaves": "+3c7d33"},
        Usual(0.3, PLANT, 0.46),
    ),
    "coconut": Noun(
        "coco nut; coconut shell, half coconut",
        {"shell": "*6b4526", "flesh": "+f7f4ec", "water": "-b9d9e4 . glass", "eyes": "-2a1a10"},
        Usual(0.22, PLANT, 0.8),
    ),
    "watermelon": Noun(
        "water melon; melon, cantaloupe, honeydew",
        {"rind": "+2f7d36", "flesh": "*e2343f", "seeds": "-1f1512", "stripes": "-1c4a24"},
        Usual(0.3, PLANT),
    ),
    "avocado": Noun(
        "; guacamole",
        {"skin": "+2f4a24", "flesh": "*c9d46a", "stone": "-7a4a22"},
        Usual(0.11, PLANT),
    ),
    "tomato": Noun(
        "; cherry tomato, persimmon",
        {"body": "*d4261c", "leaves": "+3f8a32", "stalk": "-4f7a34"},
        Usual(0.08, PLANT, 0.69),
    ),
    "carrot": Noun(
        "",
        {"body": "*ee7415", "leaves": "+3f9433"},
        Usual(0.2, 1000.0, 0.5),
    ),
    "corn": Noun(
        "maize, corn cob, corncob, corn on the cob",
        {"kernels": "*f2c52e", "husk": "+6fa23c"},
        Usual(0.25, PLANT, 0.19),
    ),
    "pumpkin": Noun(
        "; gourd, squash",
        {"body": "*e27414", "stalk": "+5c6b2c"},
        Usual(0.35, PLANT, 0.6),
    ),
    "broccoli": Noun(
        "brocolli, brocoli, broccolli; cauliflower",
        {"florets": "*2f7a30", "stem": "+8fb860"},
        Usual(0.18, PLANT, 0.6),
    ),
    "eggplant": Noun(
        "aubergine",
        {"body": "*3f1d4f", "cap": "+5a8a3a"},
        Usual(0.22, PLANT, 0.57),
    ),
    "pepper": Noun(
        "bell pepper, paprika, capsicum",
        {"body": "*cf1f1a", "stalk": "+4f8a32"},
        Usual(0.12, PLANT, 0.4),
    ),
    "chili pepper": Noun(
        "chili, chilli, chile, chilies, chillies, chilli pepper, chile pepper, hot pepper, red "
        "chili, chili peppers, red chili pepper, red hot chili pepper; jalapeno, cayenne, cayenne "
        "pepper, tabasco pepper, habanero",
        {"body": "*d41f1c", "cap": "+4f9a34", "stem": "+3d7a2a"},
        Usual(0.12, PLANT, 0.4),
    ),
    "onion": Noun(
        "; shallot, turnip, radish, beet, beetroot",
        {"body": "*c98a45", "roots": "-e3d3b0"},
        Usual(0.09, PLANT),
    ),
    "garlic": Noun(
        "garlics, garlic bulb, bulb of garlic, head of garlic, garlic head, garlic bulbs, garlic "
        "clove, clove of garlic, garlic cloves; fennel bulb",
        {
            "cloves": "*f3ecdc",
            "grooves": "&a98aa6",
            "neck": "&e6d9b8",
            "roots": "-b89a6a",
        },
        Usual(0.065, PLANT),
    ),
}
