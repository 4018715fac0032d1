"""Food."""

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
}
