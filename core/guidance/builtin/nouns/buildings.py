"""Buildings."""

from core.guidance.builtin.nouns.noun import STONE, WOOD, Noun, Usual

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
        "castle tower, watchtower; skyscraper, turret",
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
    "bridge": Noun(
        "arch bridge, road bridge; footbridge, drawbridge, aqueduct, viaduct",
        {
            "body": "*a9a196 bricks stone",
            "walls": "&bdb5a8 . stone",
            "road": "-6b6862 . stone",
            "posts": "&bdb5a8 . stone",
        },
        Usual(20.0, STONE, 0.5),
    ),
    "windmill": Noun(
        "wind mill, dutch windmill, old mill; mill",
        {
            "walls": "*efe6d2",
            "roof": "+6b3f28 thatch",
            "sails": "+e4dac2 . fabric",
            "spars": "-6b4424 grain",
            "base": "-9a8f82 bricks stone",
            "door": "-3f7a4f",
            "windows": "-8cbfe6 . glass",
        },
        Usual(16.0, STONE, 0.2),
    ),
    "castle": Noun(
        "medieval castle; fortress, fort, citadel, stronghold, palace",
        {
            "walls": "*b3ab9c bricks stone",
            "roof": "+3f5f93",
            "door": "-5d3a1f",
            "windows": "-33302c",
        },
        Usual(40.0, STONE, 0.3),
    ),
    "fountain": Noun(
        "water fountain, garden fountain; bird bath, birdbath",
        {
            "basin": "*c9c0b0 . stone",
            "column": "&bdb3a2 . stone",
            "bowl": "*c9c0b0 . stone",
            "water": "-6fbfe0 . glass",
        },
        Usual(3.0, STONE, 0.5),
    ),
    "pyramid": Noun(
        "egyptian pyramid; step pyramid, mayan temple, aztec temple, ziggurat",
        {
            "body": "*dcb978 bricks stone",
            "top": "&ecd296 . stone",
            "door": "-4a3826",
            "stairs": "&c9a565 . stone",
        },
        Usual(40.0, STONE, 0.9),
    ),
    "pagoda": Noun(
        "japanese temple; chinese temple, buddhist temple, japanese house, shinto shrine, shrine",
        {
            "walls": "*b5321f . paint",
            "roof": "+2f4a48",
            "spire": "-d8a83c . golden",
            "base": "-9a958a . stone",
            "door": "-4a2a18",
            "windows": "-f2e6c8",
        },
        Usual(20.0, WOOD, 0.2),
    ),
}
