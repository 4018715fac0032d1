"""What stands at a street, in a yard, on a playground and at a fair."""

from core.guidance.builtin.nouns.noun import STEEL, STONE, WOOD, Noun, Usual

STREET = {
    "ferris wheel": Noun(
        "ferriswheel, observation wheel; london eye, fun fair ride",
        {
            "rim": "*f4f1ea . paint",
            "spokes": "&d3d8dc . metal",
            "cabins": "+d8322a . paint",
            "roofs": "+f2bd2a . paint",
            "legs": "+2f62ae . paint",
            "base": "-7d7f84 . stone",
        },
        Usual(30.0, STEEL, 0.003),
    ),
    "parking meter": Noun(
        "parkmeter, parking clock, coin meter, parking machine; ticket meter",
        {
            "head": "*5a6a78 . paint",
            "window": "-dcecef . glass",
            "needle": "-cf2a20",
            "plate": "-c9cdd0 . metal",
            "slot": "-1d1e20",
            "post": "+9aa0a6 . metal",
            "marks": "-2a2f36",
            "badge": "-f1f1ea . paint",
        },
        Usual(1.5, STEEL, 0.25),
    ),
    "crane": Noun(
        "tower crane, construction crane, building crane; harbor crane, harbour crane, "
        "mobile crane",
        {
            "mast": "*f2b418 . paint",
            "jib": "*f2b418 . paint",
            "ties": "-4a4e53 . metal",
            "cab": "+dfe8ee . paint",
            "weights": "-8b8982 . stone",
            "hook": "-3a3d41 . metal",
            "gaps": "-3a3d42",
            "holes": "-3a3d42",
        },
        Usual(40, STEEL, 0.002),
    ),
    "seesaw": Noun(
        "see saw, teeter totter, teeterboard, teeter board",
        {
            "plank": "*e2b21f . paint",
            "seats": "+cf2f28 . paint",
            "handles": "-3c6fb8 . paint",
            "stand": "+3c6fb8 . paint",
            "axle": "-8d9399 . metal",
        },
        Usual(2.6, WOOD, 0.5),
    ),
    "swing": Noun(
        "swing set, swingset, swings, playground swing, garden swing, childrens swing; "
        "swing seat, porch swing, rope swing, tire swing",
        {
            "frame": "*3f8fce . paint",
            "ropes": "-c9b58a",
            "seats": "+d8332a . plastic",
        },
        Usual(2.6, STEEL, 0.04),
    ),
    "pallet": Noun(
        "euro pallet, europallet, shipping pallet, cargo pallet; transport pallet",
        {
            "boards": "*d3a468 grain",
            "blocks": "&b5854a grain",
            "skids": "*c4945a grain",
        },
        Usual(1.2, WOOD, 0.35),
    ),
    "carousel": Noun(
        "carrousel, merry go round, merrygoround, roundabout ride, horse carousel; "
        "fairground ride, fair ride, amusement ride, carousel ride",
        {
            "floor": "-b5713c grain",
            "column": "+f2e6cf",
            "canopy": "*d0302c . fabric",
            "trim": "+f3c23a",
            "poles": "-d8a83c . golden",
            "horses": "+f6f2ea",
        },
        Usual(9.0, WOOD, 0.1),
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
    "log cabin": Noun(
        "log cabins, cabin, log house, wooden cabin; log hut, hunting lodge, woodcutters hut",
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
}
