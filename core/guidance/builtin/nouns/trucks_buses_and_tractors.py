"""Buses, trucks, machines of the building site and the farm, a tank and a rover."""

from core.guidance.builtin.nouns.noun import GLASS_LOOK, STEEL, TYRES_LOOK, Noun, Usual

TRUCKS_BUSES_AND_TRACTORS = {
    "school bus": Noun(
        "schoolbus, yellow school bus",
        {
            "body": "*f2b01c . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7f2d8",
            "stripe": "+1b1b1d . paint",
            "letters": "-1b1b1d . paint",
            "trim": "-1d1e21 . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(11.0, STEEL, 0.02),
        "bus",
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
            "hubs": "-c3c8cd . metal",
        },
        Usual(12.0, STEEL, 0.0052),
    ),
    "double decker bus": Noun(
        "double decker, london bus, double deck bus, doubledecker, double-decker bus; "
        "routemaster, tour bus, open top bus",
        {
            "body": "*c8191c . paint",
            "windows": "-2a3842 . glass",
            "wheels": TYRES_LOOK,
            "hubs": "-cfd3d7 . metal",
            "stripe": "+f3ead2 . paint",
            "lamps": "-f4efd8",
            "trim": "-222428 . plastic",
            "tail lamps": "-8f0c12 . plastic",
        },
        Usual(11.0, STEEL, 0.005),
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
    "pickup truck": Noun(
        "pickup, pick up truck, pick up, ute, pickup trucks; tow truck, flatbed truck, farm truck",
        {
            "body": "*2f6f9e . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "trim": "+c4c9ce . metal",
            "lamps": "-f7eec2",
            "bed": "-2e3134 . rubber",
            "seams": "-1c2126 . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(5.3, STEEL, 0.0155),
    ),
    "monster truck": Noun(
        "monster trucks, monstertruck, bigfoot truck, big wheel truck; stunt truck, mud truck, "
        "lifted truck, off road truck",
        {
            "body": "*7a2bb5 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "trim": "-d3d6d9 . metal",
            "chassis": "+8fd62a . paint",
            "lamps": "-fbf0b8",
            "flames": "+f6b21c . paint",
            "doors": "~471590 . paint",
        },
        Usual(5.5, STEEL, 0.02),
    ),
    "dump truck": Noun(
        "dumper truck, dumper, tipper, tipper truck, tipper lorry, dumptruck, dump trucks; "
        "mining truck, haul truck",
        {
            "body": "*f0a51a . paint",
            "bed": "&dd8f12 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "hubs": "-d3d6d9 . metal",
            "load": "-6b4a2e",
            "trim": "-2a2b2e",
        },
        Usual(8.0, STEEL, 0.023),
    ),
    "garbage truck": Noun(
        "garbage trucks, trash truck, rubbish truck, refuse truck, bin lorry, garbage lorry, "
        "rubbish lorry, refuse lorry, waste truck, dustcart, bin truck, waste collection truck; "
        "recycling truck, garbage collector",
        {
            "cargo": "*3f9b48 . paint",
            "cab": "+efece4 . paint",
            "hopper": "+8b9298 . metal",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "hubs": "-c9cdd1 . metal",
            "bags": "-2a2b30 . plastic",
            "lamps": "-f5a623 . plastic",
        },
        Usual(8.5, STEEL, 0.015),
    ),
    "cement mixer": Noun(
        "cement truck, cement mixer truck, concrete mixer, concrete mixer truck, concrete truck, "
        "mixer truck, cement lorry",
        {
            "cab": "*d9442b . paint",
            "drum": "+f1efe8 . paint",
            "stripes": "*d9442b . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "frame": "-7f868d . metal",
            "hubs": "-c3c8cd . metal",
        },
        Usual(8.5, STEEL, 0.025),
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
    "trailer": Noun(
        "trailers, caravan, caravans, camper trailer, camping trailer, travel trailer, "
        "camping caravan, travel trailers, touring caravan, holiday caravan; airstream, "
        "teardrop trailer, static caravan, trailer home",
        {
            "body": "*f2ecdc . paint",
            "stripe": "+35a89c . paint",
            "windows": "-34495a . glass",
            "door": "&d97b3a . paint",
            "wheels": TYRES_LOOK,
            "hubs": "-b9bfc4 . metal",
            "awning": "+d8392f . fabric",
            "stripes": "+f4f0e8 . fabric",
        },
        Usual(5.5, STEEL, 0.009),
    ),
    "bulldozer": Noun(
        "dozer, bulldozer truck, crawler dozer, bulldozers; snow plow, snow plough, snowplow",
        {
            "body": "*f2b01c . paint",
            "windows": GLASS_LOOK,
            "tracks": "-29292a",
            "wheels": "&c98d14 . paint",
            "blade": "+7d8389 . metal",
            "exhaust": "-3a3a3c . metal",
        },
        Usual(6.0, STEEL, 0.05),
    ),
    "excavator": Noun(
        "digger; backhoe, power shovel, steam shovel, front loader",
        {
            "body": "*f0ae18 . paint",
            "windows": GLASS_LOOK,
            "arm": "&f0ae18 . paint",
            "bucket": "+4a4c50 . metal",
            "tracks": "-29292a",
            "stripes": "-1c1c1e . paint",
            "vents": "-2b2c2e . plastic",
            "links": "-5a5c5e . metal",
        },
        Usual(8.0, STEEL, 0.06),
        constructed=True,
    ),
    "steamroller": Noun(
        "steam roller, road roller, roadroller, steamrollers; compactor, roller compactor",
        {
            "body": "*2f6b45 . paint",
            "rollers": "-83898f . metal",
            "hubs": "+c8321f . paint",
            "roof": "&27583a . paint",
            "chimney": "-2a2a2c",
            "bands": "+d8a63a . golden",
        },
        Usual(5.0, STEEL, 0.055),
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
            "hubs": "-c3c8cd . metal",
        },
        Usual(3.4, STEEL, 0.15),
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
            "grille": "-26282c . plastic",
            "lamps": "-fbf0b8",
        },
        Usual(4.0, STEEL, 0.039),
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
            "vents": "~414a2b",
        },
        Usual(8.0, STEEL, 0.24),
        constructed=True,
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
            "lines": "-a9bce2",
            "foil": "-d9a441 . golden",
        },
        Usual(3.0, STEEL, 0.03),
    ),
}
