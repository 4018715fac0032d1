"""Vehicles on land, on water and in the air."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual

GLASS_LOOK, TYRES_LOOK, _LAMPS = "-26323c . glass", "-1c1c1e . rubber", "+f7eec2"

VEHICLES = {
    "car": Noun(
        "automobile; sedan, hatchback, convertible, station wagon, hearse, tesla, bmw, audi, "
        "mercedes, volkswagen, mini cooper",
        {
            "body": "*c9211e . paint",
            "windows": "-26323c . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7eec2",
            "hubs": "+d8dadd . metal",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
            "number plates": "-f2f1ea . paint",
        },
        Usual(4.2, STEEL, 0.0215),
    ),
    "bus": Noun(
        "coach",
        {
            "body": "*f0b41a . paint",
            "windows": "-2a3842 . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7f2d8",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
            "stripe": "-f4f1e6 . paint",
        },
        Usual(12.0, STEEL, 0.0052),
    ),
    "truck": Noun(
        "lorry, lorries; semi",
        {
            "cargo": "&e4e6e8",
            "cab": "*2a62b0 . paint",
            "windows": "-26323c . glass",
            "chassis": "-2b2b2e",
            "wheels": "-1c1c1e . rubber",
            "trim": "-26282c . plastic",
            "lamps": "-f7eec2",
            "seams": "-9ba1a8",
        },
        Usual(7.0, STEEL, 0.016),
    ),
    "boat": Noun(
        "; fishing boat, houseboat",
        {"hull": "*a3552a", "sails": "+f3efe4", "mast": "-7c4f2b"},
        Usual(8.0, WOOD, 0.3),
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
        },
        Usual(9.0, WOOD, 0.1),
    ),
    "train": Noun(
        "locomotive, steam engine, steam train; railway engine, train engine",
        {
            "boiler": "*1f5d3a . paint",
            "cab": "&b3271f",
            "chimney": "-232326",
            "frame": "-2e2e31",
            "wheels": "-9c2a22",
            "windows": "-9fc4d8 . glass",
            "lamp": "+e8c860 . golden",
            "bands": "+e2b648 . golden",
        },
        Usual(12.0, STEEL, 0.047),
    ),
    "bicycle": Noun(
        "bike, push bike, pushbike, cycle; mountain bike, road bike, bmx, ebike, penny farthing",
        {
            "frame": "*c9211e . paint",
            "wheels": TYRES_LOOK,
            "seat": "+2c211b . leather",
            "handlebar": "-9aa1a8 . metal",
            "pedals": "-55585c . metal",
        },
        Usual(1.75, STEEL, 0.015),
    ),
    "motorcycle": Noun(
        "motorbike, motor bike, motor cycle; chopper, dirt bike, harley, harley davidson, "
        "sport bike, superbike, hover bike, hoverbike",
        {
            "body": "*b3201c . paint",
            "wheels": TYRES_LOOK,
            "engine": "-8a9096 . metal",
            "seat": "+1f1b19 . leather",
            "handlebar": "-a9aeb4 . metal",
            "lamp": "-f7eec2",
        },
        Usual(2.1, STEEL, 0.06),
    ),
    "scooter": Noun(
        "motor scooter, vespa; moped, lambretta, scooty",
        {
            "body": "*6fb5a8 . paint",
            "wheels": TYRES_LOOK,
            "seat": "+5a3420 . leather",
            "handlebar": "-a9aeb4 . metal",
            "lamp": "-f7eec2",
        },
        Usual(1.8, STEEL, 0.048),
    ),
    "tank": Noun(
        "army tank, battle tank; panzer",
        {
            "hull": "*5f6b3c",
            "turret": "*5f6b3c",
            "gun": "&4d5732",
            "tracks": "-2b2b2a",
            "wheels": "-474d35",
            "star": "-efece0 . paint",
            "links": "-4a4b4a . metal",
            "vents": "&414a2b",
        },
        Usual(8.0, STEEL, 0.1),
    ),
    "van": Noun(
        "minivan, delivery van; minibus, ice cream truck",
        {
            "body": "*e8eaec . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": _LAMPS,
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
            "number plates": "-f2f1ea . paint",
        },
        Usual(5.2, STEEL, 0.0082),
    ),
    "ambulance": Noun(
        "ambulance car; emergency vehicle",
        {
            "body": "*f2f2ef . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "cross": "+cf1f1f",
            "light": "-2a5fd0",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(6.0, STEEL, 0.0093),
    ),
    "taxi": Noun(
        "cab, taxicab, taxi cab",
        {
            "body": "*f2bd12 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "hubs": "+d8dadd . metal",
            "sign": "+f4f2ea",
            "letters": "-17171a",
            "trim": "-26282c . plastic",
        },
        Usual(4.5, STEEL, 0.017),
    ),
    "fire truck": Noun(
        "fire engine, firetruck; fire brigade truck",
        {
            "body": "*c4161a . paint",
            "ladder": "+c9cdd2 . metal",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lockers": "-b9bec4 . metal",
            "light": "-2a5fd0",
            "stripe": "+f4f1e6 . paint",
            "trim": "-26282c . plastic",
        },
        Usual(9.0, STEEL, 0.018),
    ),
    "jeep": Noun(
        "; off road car, off roader, suv, army car, land rover, range rover, humvee, "
        "hummer, off road vehicle, dune buggy, buggy",
        {
            "body": "*5d6b3e . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "seats": "-3a3026",
            "roof": "+3f4a2c",
        },
        Usual(3.6, STEEL, 0.025),
    ),
    "tractor": Noun(
        "farm tractor; agricultural tractor, lawn tractor",
        {
            "body": "*2f8f3a . paint",
            "cab": "&2f8f3a . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "rims": "+f0c21a",
            "exhaust": "-3a3a3c . metal",
        },
        Usual(4.0, STEEL, 0.039),
    ),
    "excavator": Noun(
        "digger; backhoe, power shovel, steam shovel, front loader",
        {
            "body": "*f0ae18 . paint",
            "windows": GLASS_LOOK,
            "arm": "&f0ae18 . paint",
            "bucket": "+4a4c50 . metal",
            "tracks": "-29292a",
        },
        Usual(8.0, STEEL, 0.04),
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
        },
        Usual(30.0, STEEL, 0.012),
    ),
    "canoe": Noun(
        "; kayak, dugout, gondola, paddle boat",
        {"hull": "*a5562a", "seats": "&c89a5c grain", "paddle": "+d8b078 grain"},
        Usual(5.0, WOOD, 0.012),
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
            "seams": "&432510 grain",
        },
        Usual(30.0, WOOD, 0.1),
    ),
    "wagon": Noun(
        "cart, covered wagon, horse cart; hand cart, handcart, chariot, pram, stroller, pushchair, "
        "baby carriage, baby stroller, "
        "buggy pram",
        {
            "body": "*94602f grain",
            "wheels": "&6b4220 grain",
            "handle": "-5a381c",
            "cover": "+ece2cc . fabric",
            "seams": "&63401f grain",
        },
        Usual(3.5, WOOD, 0.25),
    ),
    "wheelbarrow": Noun(
        "wheel barrow, barrow",
        {
            "tray": "*3f7f46 . paint",
            "wheel": TYRES_LOOK,
            "frame": "+8a9096 . metal",
            "handles": "-1f1f20 . rubber",
        },
        Usual(1.4, STEEL, 0.02),
    ),
    "skateboard": Noun(
        "skate board; longboard",
        {"board": "*c9302a", "wheels": "+efe8d6", "trucks": "-8d9399 . metal"},
        Usual(0.8, WOOD, 0.29),
    ),
    "sled": Noun(
        "sledge, toboggan; luge, bobsled",
        {"seat": "*a8713a grain", "runners": "+8c5628 grain"},
        Usual(1.1, WOOD, 0.19),
    ),
    "tram": Noun(
        "tramcar, streetcar, trolley; railcar, subway, subway car, metro train",
        {
            "body": "*c9261f . paint",
            "windows": GLASS_LOOK,
            "stripe": "+f2ead2",
            "wheels": "-2a2a2c . metal",
            "roof": "-8b9095",
        },
        Usual(15.0, STEEL, 0.0086),
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
        Usual(20.0, WOOD, 0.1),
    ),
    "rover": Noun(
        "mars rover, moon rover, space rover, lunar rover, planetary rover, exploration rover, "
        "martian rover; moon buggy, lunar vehicle, space robot",
        {
            "body": "*e3e2dc",
            "panels": "+2c4a94",
            "wheels": "-3a3c40 . metal",
            "arms": "-8d9399 . metal",
            "mast": "*e3e2dc",
            "eyes": "-1b2230 . glass",
        },
        Usual(3.0, STEEL, 0.03),
    ),
    "forklift": Noun(
        "fork lift, forklift truck, fork truck, fork lift truck, lift truck; pallet truck, "
        "stacker, warehouse truck",
        {
            "body": "*f0b01a . paint",
            "cage": "+35383c . metal",
            "mast": "-4a4e53 . metal",
            "forks": "-70767c . metal",
            "wheels": TYRES_LOOK,
            "seat": "-1f1f21 . leather",
        },
        Usual(3.4, STEEL, 0.15),
    ),
    "wheelchair": Noun(
        "wheel chair",
        {
            "wheels": TYRES_LOOK,
            "spokes": "-c3c8cc . metal",
            "seat": "*23489c . fabric",
            "frame": "+8d949b . metal",
            "armrests": "-26282b . rubber",
            "footrests": "-26282b . rubber",
        },
        Usual(1.1, STEEL, 0.015),
    ),
    "camper": Noun(
        "camper van, campervan, motorhome, motor home, mobile home, rv, recreational vehicle, "
        "camping van, motor caravan; winnebago",
        {
            "body": "*f3efe4 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "stripe": "+e0762a . paint",
            "door": "-c9ccc8 . paint",
            "lamps": "-f7eec2",
        },
        Usual(6.5, STEEL, 0.012),
    ),
}
