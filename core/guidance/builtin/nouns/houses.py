"""Houses, huts, shops and other buildings that people live and work in."""

from core.guidance.builtin.nouns.noun import GLASS_LOOK, SNOW, STEEL, STONE, WOOD, Noun, Usual

HOUSES = {
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
    "hut": Noun(
        "huts, mud hut, mud huts, straw hut, thatched hut, african hut, round hut, grass hut, "
        "tribal hut, village hut, roundhouse; tiki hut, jungle hut, beach hut, "
        "native hut",
        {
            "walls": "*dfae7a",
            "roof": "+d8b04c thatch",
            "door": "-4a2e1c",
            "frame": "+6e4222 grain",
            "windows": "-33241a",
            "base": "&9a6a48 . stone",
            "band": "+7d4f2a . fabric",
            "zigzags": "-f3e4c4 . paint",
        },
        Usual(5.0, STONE, 0.15),
    ),
    "log cabin": Noun(
        "log cabins, cabin, log house, wooden cabin; log hut, hunting lodge, woodcutters hut, "
        "longhouse, viking longhouse",
        {
            "logs": "*96602f . wooden",
            "roof": "+4c3a30",
            "chimney": "-85817a . stone",
            "door": "-5a351d . wooden",
            "window": "-9fd0ea . glass",
            "frame": "+f0e6d0 . wooden",
            "gable": "*8a5a2e . wooden",
            "mullions": "-f0e6d0 . wooden",
        },
        Usual(8.0, WOOD, 0.2),
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
        constructed=True,
    ),
    "mushroom house": Noun(
        "mushroom houses, toadstool house, mushroom home, mushroom cottage; fairy house, "
        "gnome house, smurf house, pixie house, mushroom hut, toadstool cottage",
        {
            "stem": "&f1e6cc",
            "cap": "*c9241c",
            "dots": "+f8f4ea",
            "door": "-8a5228",
            "windows": "-ffd98a . glass",
            "chimney": "-8f5a48",
        },
        Usual(3.0, STONE, 0.15),
    ),
    "modern house": Noun(
        "modern villa, contemporary house, flat roof house, flat roofed house, modernist house, "
        "bauhaus house; villa, modern mansion",
        {
            "walls": "*eeebe4 . paint",
            "roof": "+4a4d50",
            "windows": GLASS_LOOK,
            "frames": "-26282b . metal",
            "door": "-8a5a34 grain",
            "garage": "&a8794a grain",
            "mullions": "-26282b . metal",
            "slats": "-6e4f2c",
        },
        Usual(14.0, STONE, 0.15),
    ),
    "mansion": Noun(
        "mansions, manor, manor house, manors, country house, stately home, grand house, "
        "estate house, luxury mansion, victorian mansion, plantation house; "
        "chateau, embassy, town hall",
        {
            "walls": "*e6c887",
            "roof": "+4f6276",
            "columns": "+f4f0e8 . stone",
            "windows": "-6fa3cc . glass",
            "door": "-6b3a22",
            "chimney": "-9c5440",
        },
        Usual(30.0, STONE, 0.12),
    ),
    "skyscraper": Noun(
        "skyscrapers, high rise, highrise; office building, office tower, apartment building, "
        "apartment block, empire state building, tower block, hotel, apartment",
        {
            "walls": "*d3c5a6",
            "windows": "-2f5f8c . glass",
            "base": "&8d8578 . stone",
            "door": "-2a2c30 . metal",
            "spire": "-c3c8cd . metal",
            "mullions": "-d3c5a6",
        },
        Usual(150.0, STONE, 0.12),
        constructed=True,
    ),
    "barn": Noun(
        "barns, red barn, farm barn; stable, horse stable, cow shed",
        {
            "walls": "*a62a22",
            "roof": "+5d5a58",
            "trim": "+f4f1ea",
            "door": "~84211b",
            "hay": "-e0b54c",
            "seams": "~7d1d17",
            "windows": "-bfd8e4 . glass",
        },
        Usual(14.0, WOOD, 0.04),
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
    "shop": Noun(
        "store, shop building, shop front, shopfront, storefront, store front, corner shop; "
        "cafe, café, coffee shop, coffee house, restaurant, diner, bakery, bistro, grocery, "
        "grocery store, grocery shop, supermarket, pharmacy, boutique, candy shop, candy store, "
        "flower shop, toy shop, toy store, bookshop, bookstore, barber shop, ice cream shop, "
        "pizzeria, bar building, convenience store, market building, butcher shop, bookstore "
        "building, hair salon, laundromat, post office",
        {
            "walls": "*e9d3a2 . stone",
            "awning": "-f6f2e8 . fabric",
            "stripes": "+d02f2a . fabric",
            "window": "-9fd0e0 . glass",
            "door": "&7a4524 grain",
            "sign": "+2f7a4c . paint",
            "letters": "-f6f2e8 . paint",
            "frames": "-5f3a22",
        },
        Usual(7.0, STONE, 0.15),
    ),
    "school": Noun(
        "schools, school house, schoolhouse, school building, elementary school, high school, "
        "primary school, schoolhouses; college, university, academy, kindergarten",
        {
            "walls": "*b5482f bricks",
            "roof": "+51606f",
            "trim": "+f1ebdc . paint",
            "windows": "-8cc4e6 . glass",
            "door": "-2f6fc4 . paint",
            "bell": "-e3b23c . golden",
            "hands": "-2a2b30 . metal",
            "frames": "-f6f2e6 . paint",
        },
        Usual(30.0, STONE, 0.12),
    ),
    "hospital": Noun(
        "hospitals, hospital building, infirmary; clinic, medical center, medical centre, "
        "health center, doctor's office, emergency room",
        {
            "walls": "*f2efe8 . paint",
            "roof": "+7fa6b8",
            "windows": "-4a90c4 . glass",
            "cross": "+d8261f . plastic",
            "canopy": "+c8453a . paint",
            "door": "-2f5f80 . glass",
            "frames": "-7fa6b8 . paint",
        },
        Usual(40.0, STONE, 0.12),
    ),
    "factory": Noun(
        "factory building, industrial building, industrial plant; warehouse, power plant, "
        "power station, mill building, workshop, sawmill, steel mill, refinery, nuclear "
        "plant, factory hall, manufacturing plant",
        {
            "hall": "*a5482f . stone",
            "roof": "&6a7077 . metal",
            "chimneys": "+b8b2a6 . stone",
            "bands": "-c9302a . paint",
            "windows": "-f2d98a . glass",
            "gate": "-3f5566 . paint",
            "frames": "-4a3a34 . metal",
            "slats": "-293b49 . paint",
        },
        Usual(40.0, STONE, 0.03),
    ),
    "gas station": Noun(
        "petrol station, filling station, fuel station, service station, gasoline station; "
        "truck stop",
        {
            "roof": "-f4f5f3 . paint",
            "band": "*d42823 . paint",
            "posts": "-a8adb2 . metal",
            "pumps": "*d42823 . paint",
            "screens": "+f2f5f5 . paint",
            "hoses": "-1f2023 . rubber",
            "letters": "-f6f2e8 . paint",
        },
        Usual(12.0, STEEL, 0.006),
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
        constructed=True,
    ),
}
