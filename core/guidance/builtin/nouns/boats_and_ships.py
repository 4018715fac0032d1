"""Boats, ships and what else moves on or in water."""

from core.guidance.builtin.nouns.noun import GLASS_LOOK, PLASTIC, STEEL, WOOD, Noun, Usual

BOATS_AND_SHIPS = {
    "boat": Noun(
        "; fishing boat, houseboat",
        {
            "hull": "*a3552a",
            "sails": "+f3efe4",
            "mast": "-7c4f2b",
            "anchor": "-24508c",
            "stripe": "+f3efe4 . paint",
            "keel": "+2f4f78 . paint",
        },
        Usual(8.0, WOOD, 0.3),
    ),
    "rowboat": Noun(
        "rowing boat, row boat, rowboats, rowing boats; skiff, jolly boat, punt, lifeboat, dory",
        {
            "hull": "*2f6f8f . paint",
            "rim": "&f2ead8 . paint",
            "benches": "+b98247 grain",
            "floor": "+9a6a36 grain",
            "oars": "+d2a466 grain",
            "blades": "+c8352a . paint",
            "seams": "~1d475c . paint",
        },
        Usual(3.6, WOOD, 0.09),
    ),
    "canoe": Noun(
        "; kayak, dugout, gondola, paddle boat",
        {"hull": "*a5562a", "seats": "&c89a5c grain", "paddle": "+d8b078 grain"},
        Usual(5.0, WOOD, 0.012),
    ),
    "raft": Noun(
        "log raft, rafts; life raft, castaway raft",
        {
            "logs": "*8a5a30 grain",
            "ends": "&dcb27a",
            "ropes": "+d9c49a . fabric",
            "mast": "&6b4424 grain",
            "sail": "+f1e8d2 . fabric",
            "flag": "+c8322a . fabric",
        },
        Usual(3.0, WOOD, 0.6),
    ),
    "sailboat": Noun(
        "sailing boat, sail boat, sailboats; sailing yacht, catamaran, dinghy",
        {
            "hull": "*b3281f",
            "deck": "-c89a5e . wooden",
            "mast": "-8a5a32",
            "sails": "+f8f5ec",
            "stripe": "+f4f1ea",
            "flag": "+f0b428",
            "anchor": "-24508c",
            "keel": "+2c3f5e . paint",
        },
        Usual(9.0, WOOD, 0.35),
        constructed=True,
    ),
    "yacht": Noun(
        "yachts, motor yacht, motor yachts, luxury yacht, super yacht, superyacht, mega yacht, "
        "megayacht, motoryacht, private yacht; cabin cruiser, motor cruiser, pleasure boat",
        {
            "hull": "*f1eee6 . paint",
            "keel": "+1f5fa8 . paint",
            "deck": "+b97a42 . wooden",
            "cabin": "&e9e6dd . paint",
            "windows": GLASS_LOOK,
            "mast": "+c3c8cd . paint",
            "portholes": "-25303a . glass",
        },
        Usual(35.0, STEEL, 0.006),
    ),
    "speedboat": Noun(
        "speed boat, speedboats, motorboat, motor boat, motorboats, powerboat, power boat; "
        "runabout, ski boat, racing boat, police boat, patrol boat",
        {
            "hull": "*f2efe8 . paint",
            "stripe": "+c4262a . paint",
            "windscreen": "-9fc3cf . glass",
            "seats": "-c9a877 . leather",
            "motor": "-1d1f22 . paint",
            "rails": "-cfd3d6 . metal",
        },
        Usual(6.0, PLASTIC, 0.12),
    ),
    "jet ski": Noun(
        "jetski, water scooter, personal watercraft; wave runner, waverunner, sea scooter",
        {
            "hull": "*f2f3f0 . paint",
            "cowl": "+1f6fc4 . paint",
            "saddle": "-232428 . leather",
            "bumper": "-2b2d31 . rubber",
            "handles": "-2b2d31 . rubber",
            "stripes": "+1f6fc4 . paint",
            "trim": "-f2f3f0 . paint",
            "ribs": "~34363b",
        },
        Usual(3.2, PLASTIC, 0.09),
    ),
    "pirate ship": Noun(
        "pirate boat; galleon, sailing ship, caravel, tall ship, sail ship, frigate, "
        "schooner, tallship",
        {
            "hull": "*70421f grain",
            "sails": "+efe6d2",
            "masts": "-4f3018",
            "flag": "-161616",
            "windows": "-2a1c10",
            "seams": "~432510 grain",
        },
        Usual(30.0, WOOD, 0.31),
        constructed=True,
    ),
    "longship": Noun(
        "viking ship, viking longship, viking boat, long ship, longboat, drakkar; dragon boat",
        {
            "hull": "*7d4d26 grain",
            "prows": "&5f3819 grain",
            "mast": "-4f3018",
            "sail": "+efe6d2 . fabric",
            "stripes": "+b3261e . fabric",
            "shields": "+d9a53a",
        },
        Usual(20.0, WOOD, 0.21),
        constructed=True,
    ),
    "cargo ship": Noun(
        "container ship, freighter, cargo vessel, containership, cargo boat, cargo ships, "
        "freight ship; oil tanker, tanker ship, bulk carrier, merchant ship, ship, ferry, "
        "battleship, warship, aircraft carrier",
        {
            "hull": "*25436b . paint",
            "keel": "+b02a22 . paint",
            "containers": "+e07a28 . paint",
            "boxes": "+2f9a8c . paint",
            "bridge": "-f1f2f0 . paint",
            "windows": "-26323c . glass",
            "ribs": "~a8530f . paint",
            "ridges": "~1c675d . paint",
        },
        Usual(150.0, STEEL, 0.021),
        constructed=True,
    ),
    "cruise ship": Noun(
        "cruise ships, cruise liner, cruise liners, ocean liner, ocean liners, cruiseship, "
        "passenger ship, passenger liner; titanic, passenger ferry, steamship, cruise boat",
        {
            "hull": "*1f3f78 . paint",
            "keel": "+b3302a . paint",
            "decks": "+f3f0e8 . paint",
            "windows": "-3f7fae . glass",
            "funnel": "+d8392b . paint",
            "rim": "-2a2b30 . paint",
            "lifeboats": "+f08a24 . plastic",
            "portholes": "-ffe6a3 . glass",
        },
        Usual(300.0, STEEL, 0.0097),
        constructed=True,
    ),
    "submarine": Noun(
        "sub, u boat, submarine boat",
        {
            "hull": "*f0c01c . paint",
            "tower": "*f0c01c . paint",
            "windows": "-2f4a60 . glass",
            "periscope": "-7d8389 . metal",
            "fins": "+c9241e",
            "screw": "-c79a3e . golden",
            "rims": "-b9bec4 . metal",
            "keel": "+c9241e . paint",
        },
        Usual(30.0, STEEL, 0.012),
    ),
}
