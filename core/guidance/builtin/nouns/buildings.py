"""Buildings."""

from core.guidance.builtin.nouns.noun import STONE, Noun, Usual

BUILDINGS = {
    "house": Noun(
        "home; barn, shed, villa, mansion, farmhouse, garage, school",
        {
            "walls": "*e6d1a3",
            "roof": "+9e3321",
            "door": "-663d21",
            "windows": "-8cbfe6 . glass",
            "chimney": "-7a4233",
        },
        Usual(8.0, STONE, 0.15),
    ),
    "cottage": Noun(
        "; hut, cabin",
        {
            "walls": "*f0e6d0",
            "roof": "+8a5f2f thatch",
            "door": "-3f7a4f",
            "windows": "-8cbfe6 . glass",
            "chimney": "-8a5648",
        },
        Usual(7.0, STONE, 0.15),
    ),
    "tower": Noun(
        "castle tower; castle, fortress, skyscraper",
        {"walls": "*a29c90 bricks stone", "door": "+5d3a1f", "windows": "-33302c"},
        Usual(20.0, STONE, 0.3),
    ),
    "lighthouse": Noun(
        "light house",
        {
            "tower": "*f2f0ec hoops",
            "lantern": "-ffe08a",
            "roof": "+c0221d",
            "base": "-6e6a64",
            "door": "-7c3a22",
        },
        Usual(25.0, STONE, 0.3),
    ),
    "church": Noun(
        "; chapel",
        {"walls": "*efe9dc", "roof": "+545a66", "door": "-6b3f22", "windows": "-5f8fc4 . glass"},
        Usual(25.0, STONE, 0.1),
    ),
    "arch": Noun(
        "archway; gate",
        {"body": "*cbb894 bricks stone", "cornice": "&e0d2b4 . stone"},
        Usual(4.0, STONE),
    ),
}
