"""Vehicles."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual

VEHICLES = {
    "car": Noun(
        "automobile; sports car, race car",
        {
            "body": "*c9211e . paint",
            "windows": "-26323c . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7eec2",
        },
        Usual(4.2, STEEL, 0.022),
    ),
    "bus": Noun(
        "coach; school bus",
        {
            "body": "*f0b41a . paint",
            "windows": "-2a3842 . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7f2d8",
        },
        Usual(12.0, STEEL, 0.019),
    ),
    "truck": Noun(
        "lorry, lorries",
        {
            "cargo": "+e4e6e8",
            "cab": "*2a62b0 . paint",
            "windows": "-26323c . glass",
            "chassis": "-2b2b2e",
            "wheels": "-1c1c1e . rubber",
        },
        Usual(7.0, STEEL, 0.03),
    ),
    "airplane": Noun(
        "plane, aeroplane, aircraft",
        {
            "body": "*e8eaed . paint",
            "wings": "&c7ccd2 . paint",
            "windows": "-25303a . glass",
            "engines": "-3d6fb3",
        },
        Usual(12.0, STEEL, 0.015),
    ),
    "boat": Noun(
        "sailboat, sailing boat; ship, yacht, rowboat, rowing boat, fishing boat",
        {"hull": "*a3552a", "sails": "+f3efe4", "mast": "-7c4f2b"},
        Usual(8.0, WOOD, 0.3),
    ),
    "train": Noun(
        "locomotive, steam engine, steam train",
        {
            "boiler": "*1f5d3a . paint",
            "cab": "+b3271f",
            "chimney": "-232326",
            "frame": "-2e2e31",
            "wheels": "-9c2a22",
        },
        Usual(12.0, STEEL, 0.1),
    ),
    "rocket": Noun(
        "rocket ship, space rocket; spaceship",
        {"hull": "*e6e6e8", "nose": "+cc1a14", "fins": "+cc1a14", "nozzle": "-4d4d52 . metal"},
        Usual(20.0, STEEL, 0.03),
    ),
}
