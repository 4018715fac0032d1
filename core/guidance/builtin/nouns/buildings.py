"""Buildings."""

from core.guidance.builtin.nouns.noun import SNOW, STEEL, STONE, WOOD, Noun, Usual

BUILDINGS = {
    "house": Noun(
        "home; shed, farmhouse, garage, dollhouse, doll house, townhouse, doghouse, police "
        "station, fire station, kennel, outhouse, building, garden shed, bungalow, tiny house, "
        "cabin house, chicken coop, coop, hen house, henhouse, hutch",
        {
            "walls": "*e6d1a3",
            "roof": "+9e3321",
            "door": "-663d21",
            "windows": "-8cbfe6 . glass",
            "chimney": "-7a4233",
            "frames": "-f6f1e4 . paint",
            "panels": "~84553a",
            "seams": "~7c2418",
        },
        Usual(8.0, STONE, 0.15),
    ),
    "cottage": Noun(
        "; shack, gingerbread house, hobbit house, tavern, inn, saloon, chalet, bothy",
        {
            "walls": "*f0e6d0",
            "roof": "+8a5f2f thatch",
            "door": "-3f7a4f",
            "windows": "-8cbfe6 . glass",
            "chimney": "-8a5648",
            "frames": "-fbf8ef . paint",
            "panels": "~2f6a42",
            "shutters": "-3f7a4f",
        },
        Usual(7.0, STONE, 0.15),
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
    "church": Noun(
        "; chapel, cathedral, mosque, abbey, monastery, basilica",
        {
            "walls": "*efe9dc",
            "roof": "+545a66",
            "door": "-6b3f22",
            "windows": "-5f8fc4 . glass",
            "frames": "-b09c78 . paint",
            "panels": "~8a5834",
            "cross": "-d8a83c . golden",
            "seams": "~3a3f4a",
        },
        Usual(25.0, STONE, 0.1),
    ),
    "arch": Noun(
        "archway; gateway, portal, arc de triomphe, portal gate, moon gate",
        {"body": "*cbb894 bricks stone", "cornice": "&e0d2b4 . stone"},
        Usual(4.0, STONE),
    ),
    "bridge": Noun(
        "arch bridge, road bridge; footbridge, drawbridge, aqueduct, viaduct, pier, jetty, wharf, "
        "boat dock, wooden dock, fishing dock, boardwalk",
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
    ),
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
        Usual(40.0, STONE, 0.3),
    ),
    "fountain": Noun(
        "water fountain, garden fountain; bird bath, birdbath",
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
    "pyramid": Noun(
        "egyptian pyramid; step pyramid, mayan temple, aztec temple, ziggurat, pyramid of giza",
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
    "igloo": Noun(
        "iglu, snow house, ice house, eskimo house; ice hut, snow hut",
        {
            "dome": "*e4eef7 bricks",
            "tunnel": "*e4eef7 bricks",
            "arch": "&f6fafd",
            "door": "-2f4256",
        },
        Usual(4.0, SNOW, 0.5),
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
    "market stall": Noun(
        "stall, food stand, food stall, fruit stand, fruit stall, market stand, market booth; "
        "kiosk, lemonade stand, farm stand, shop stand, vegetable stand, newsstand",
        {
            "counter": "-a06a38 grain",
            "awning": "*d1261f . fabric",
            "stripes": "+f6f0e2 . fabric",
            "posts": "-7c4f2a grain",
            "shelf": "-c08a4e grain",
            "fruit": "-f29a1c",
            "apples": "-8cbf3a",
            "panels": "-d9a860 grain",
        },
        Usual(2.6, WOOD, 0.2),
    ),
    "phone booth": Noun(
        "telephone booth, phone box, telephone box, phonebooth, red telephone box, call box, "
        "telephone kiosk, london phone booth; police box, tardis, payphone, pay phone",
        {
            "body": "*c4161c . paint",
            "windows": "-b8d8e6 . glass",
            "sign": "-f4efe0",
            "roof": "*c4161c . paint",
            "handle": "-c9a24a . golden",
            "letters": "-1d1d20",
            "seams": "~8f0f14",
        },
        Usual(2.5, STEEL, 0.05),
    ),
    "vending machine": Noun(
        "soda machine, drink machine, snack machine, drinks machine, vendor machine, "
        "soda vending machine; coke machine, ticket machine, cigarette machine",
        {
            "body": "*c9201f . paint",
            "window": "-e4f1f6",
            "cans": "+2f9ad0",
            "shelves": "-8f979e . metal",
            "panel": "-d3d7da . metal",
            "flap": "-26282b",
            "letters": "-f6f3ea . paint",
            "stripes": "-f6f3ea . paint",
        },
        Usual(1.9, STEEL, 0.02),
    ),
    "dumpster": Noun(
        "waste container, garbage container, trash container, garbage dumpster; "
        "skip, rubbish skip, waste skip, recycling container",
        {
            "body": "*2f7d46 . paint",
            "lid": "+2b2d30",
            "ribs": "&286c3c . paint",
            "pockets": "&286c3c . paint",
            "wheels": "-1c1c1e . rubber",
            "arrows": "-f1f1ea . paint",
        },
        Usual(1.9, STEEL, 0.02),
    ),
    "shipping container": Noun(
        "container, cargo container, freight container, sea container, intermodal container, "
        "storage container, cargo box",
        {
            "body": "*b8461f . paint",
            "ribs": "&cc5526 . paint",
            "frame": "&8f3416 . paint",
            "doors": "&c24d22 . paint",
            "bars": "-c3c8cc . metal",
            "ridges": "~cc5526 . paint",
            "letters": "-f3ede2 . paint",
        },
        Usual(6.1, STEEL, 0.008),
    ),
    "greenhouse": Noun(
        "glasshouse, hothouse, hot house, orangery; conservatory, winter garden, polytunnel",
        {
            "glass": "-bfe3e0 . glass",
            "frame": "*f4f4ee . paint",
            "base": "+a8604a bricks",
            "door": "&7fb7a8 . paint",
            "plants": "-3f9a3a",
            "pots": "+b8623c",
        },
        Usual(5.0, STEEL, 0.02),
    ),
    "treehouse": Noun(
        "tree house, tree hut, tree cabin; tree fort, elf house",
        {
            "trunk": "-6b4628 . wooden",
            "leaves": "-4f9a35",
            "walls": "*c08a4e grain",
            "roof": "+a8432c",
            "floor": "&8f5f34 grain",
            "door": "-4a2f1c",
            "windows": "-8cbfe6 . glass",
            "frames": "-f0e6d0",
        },
        Usual(6.0, WOOD, 0.3),
    ),
    "gazebo": Noun(
        "pavilion, garden pavilion, garden gazebo; bandstand, summerhouse, summer house, "
        "pergola, rotunda, arbor",
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
    "silo": Noun(
        "grain silo, farm silo, corn silo, grain bin; granary, storage silo, grain elevator",
        {
            "body": "*d6d4cb",
            "roof": "+b3352a . metal",
            "bands": "&a3a7a8 . metal",
            "ladder": "-6d7378 . metal",
            "door": "-7a2a22",
            "base": "-8f8b83 . stone",
        },
        Usual(18.0, STEEL, 0.02),
    ),
}
