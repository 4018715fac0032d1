"""Castles, towers, temples, bridges, gates and stairs, mountains and an island."""

from core.guidance.builtin.nouns.noun import STEEL, STONE, WOOD, Noun, Usual

LANDMARKS = {
    "castle": Noun(
        "medieval castle; fortress, fort, citadel, stronghold, palace, gatehouse",
        {
            "walls": "*b3ab9c bricks stone",
            "roof": "+3f5f93",
            "door": "-5d3a1f",
            "windows": "-33302c",
            "frames": "-ddd6c6 . stone",
            "seams": "-38220f",
        },
        Usual(40.0, STONE, 0.92),
        constructed=True,
    ),
    "tower": Noun(
        "castle tower, watchtower; turret",
        {
            "walls": "*a29c90 bricks stone",
            "door": "+5d3a1f",
            "windows": "-33302c",
            "battlements": "&a29c90 bricks stone",
            "frames": "-e8e2d4 . stone",
            "seams": "-38220f",
        },
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
            "bars": "-2f3338 . metal",
            "windows": "-3f5a70 . glass",
            "frames": "-d9d4c8 . stone",
        },
        Usual(25.0, STONE, 0.3),
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
            "lattice": "-6b4424 grain",
        },
        Usual(16.0, STONE, 0.2),
        constructed=True,
    ),
    "temple": Noun(
        "greek temple, roman temple, ancient temple, parthenon; pantheon, acropolis, mausoleum, "
        "bank building, courthouse, museum",
        {
            "base": "&d5cdbb . stone",
            "columns": "*ece5d6 . stone",
            "walls": "*d9cfba . stone",
            "beam": "*ece5d6 . stone",
            "roof": "+b05a38",
            "door": "-4a3524",
            "frieze": "-2f5f96 . paint",
            "seams": "~7e3b22",
        },
        Usual(30.0, STONE, 0.3),
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
    "pyramid": Noun(
        "egyptian pyramid; pyramid of giza",
        {
            "body": "*dcb978 bricks stone",
            "top": "&ecd296 . stone",
            "door": "-4a3826",
            "stairs": "&c9a565 . stone",
        },
        Usual(40.0, STONE, 0.9),
    ),
    "column": Noun(
        "pillar, greek column, roman column, doric column, ionic column, corinthian column, "
        "roman pillar, greek pillar; pilaster, support column, plinth, bollard, mooring bollard",
        {
            "shaft": "*ebe5d8 . stone",
            "base": "&d9d1c0 . stone",
            "capital": "&e2dac9 . stone",
            "slab": "&cfc6b4 . stone",
            "rings": "&c6bca8 . stone",
            "ornament": "+d6c9a8 . stone",
        },
        Usual(4.0, STONE, 1.0),
    ),
    "arch": Noun(
        "archway; gateway, arc de triomphe, portal gate, moon gate",
        {"body": "*cbb894 bricks stone", "cornice": "&e0d2b4 . stone"},
        Usual(4.0, STONE),
    ),
    "gate": Noun(
        "iron gate, garden gate, wrought iron gate, metal gate, gates, driveway gate, "
        "front gate; "
        "entrance gate, cemetery gate, graveyard gate, mansion gate, park gate",
        {
            "bars": "*26282b . metal",
            "tips": "-c9963f . golden",
            "piers": "+a89f90 . stone",
            "caps": "+cfc6b4 . stone",
            "plaque": "-c9963f . golden",
            "joints": "~7a7266",
        },
        Usual(3.6, STONE, 0.6),
        constructed=True,
    ),
    "torii gate": Noun(
        "torii, torii gates, torii arch, japanese gate, japanese torii, japanese torii gate, "
        "shinto gate, shrine gate, japanese arch, japanese gates; japanese shrine gate, "
        "temple gate",
        {
            "pillars": "*d23a24 . paint",
            "lintel": "+2a2a30 . paint",
            "feet": "+8d8f8c . stone",
            "plaque": "+d9a83e . golden",
        },
        Usual(6.0, WOOD, 0.9),
    ),
    "wall": Noun(
        "walls; garden wall, castle wall, city wall, house wall",
        {
            "body": "*a8543c bricks",
            "piers": "*a8543c bricks",
            "cap": "+cfc7b8 . stone",
            "base": "-8f877b . stone",
            "joints": "~5a544b",
        },
        Usual(3.0, STONE),
    ),
    "bridge": Noun(
        "arch bridge, road bridge; footbridge, drawbridge, pier, jetty, wharf, boat dock, "
        "wooden dock, fishing dock, boardwalk",
        {
            "body": "*a9a196 bricks stone",
            "walls": "&bdb5a8 . stone",
            "road": "-6b6862 . stone",
            "posts": "&bdb5a8 . stone",
            "bands": "~8a8377",
            "joints": "~4c4944",
        },
        Usual(20.0, STONE, 0.5),
    ),
    "fountain": Noun(
        "water fountain, garden fountain",
        {
            "basin": "*c9c0b0 . stone",
            "column": "&bdb3a2 . stone",
            "bowl": "*c9c0b0 . stone",
            "water": "-6fbfe0 . glass",
            "tiles": "-3f8fb5 . paint",
            "lines": "~94897a",
            "bands": "~94897a",
        },
        Usual(3.0, STONE, 0.5),
    ),
    "gazebo": Noun(
        "pavilion, garden pavilion, garden gazebo; bandstand, summerhouse, summer house, rotunda",
        {
            "base": "-b9b2a4 . stone",
            "posts": "*f4f1e8",
            "rails": "*f4f1e8",
            "roof": "+4f7f86",
            "beam": "*f4f1e8",
            "finial": "-d8a83c . golden",
        },
        Usual(4.0, WOOD, 0.3),
    ),
    "staircase": Noun(
        "stairs, stair, stairway, flight of stairs, flight of steps, staircases, steps; "
        "stair case, doorstep, doorsteps",
        {
            "body": "*e9e2d4",
            "treads": "+8a5530 grain",
            "posts": "*e9e2d4",
            "rails": "+8a5530 grain",
            "knobs": "+8a5530 grain",
            "carpet": "-9a2430 . fabric",
            "runner": "-9a2430 . fabric",
            "panels": "~b9b1a2",
        },
        Usual(3.5, WOOD, 0.15),
    ),
    "spiral staircase": Noun(
        "spiral stairs, spiral stair, winding stairs, winding staircase, helical staircase; "
        "spiral stairway, spiral steps",
        {
            "treads": "*9a6a3c grain",
            "pole": "+2b2d30 . metal",
            "posts": "+2b2d30 . metal",
            "rail": "+2b2d30 . metal",
        },
        Usual(3.2, STEEL, 0.07),
        constructed=True,
    ),
    "sandcastle": Noun(
        "sandcastles, sand castle; castle of sand",
        {
            "towers": "*e4c684",
            "cones": "&d2ab66",
            "gate": "-8a6538",
            "heap": "&dcba76",
            "flag": "+d6322b . fabric",
        },
        Usual(0.6, STONE, 0.6),
    ),
    "island": Noun(
        "floating island, sky island, flying island; desert island, tropical island, "
        "palm island, treasure island",
        {
            "rock": "+7a6654 . stone",
            "grass": "*6fae3c",
            "trunk": "-8a5f38",
            "leaves": "&2f8a3c",
            "coconuts": "-5a3820",
            "stones": "-9a958c . stone",
        },
        Usual(12.0, STONE, 0.6),
    ),
    "mountain": Noun(
        "mountains, mountain peak, snowy mountain, snow mountain, mount everest, everest; hill, "
        "mount fuji, cliff, mountain range, hills, alps",
        {
            "rock": "*7a7672 mottle stone",
            "snow": "+f6f8fa",
            "peaks": "&8d8781 mottle stone",
            "ground": "-5f9a3e",
            "firs": "-24602f",
        },
        Usual(40.0, STONE, 0.2),
    ),
    "volcano": Noun(
        "erupting volcano, active volcano, vulcano",
        {
            "mountain": "*5d4a40 . stone",
            "lava": "+ff5a12",
            "smoke": "-b9b4ae",
            "rocks": "&4a3c35 . stone",
        },
        Usual(40, STONE),
    ),
}
