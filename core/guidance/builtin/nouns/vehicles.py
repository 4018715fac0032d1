"""Vehicles on land, on water and in the air."""

from core.guidance.builtin.nouns.noun import FABRIC, PLASTIC, STEEL, WOOD, Noun, Usual

_GLASS, _TYRES, _LAMPS = "-26323c . glass", "-1c1c1e . rubber", "+f7eec2"

VEHICLES = {
    "car": Noun(
        "automobile; sports car, race car, sedan, coupe, hatchback, limousine, limo, "
        "convertible, racecar, sportscar, supercar, go kart, kart, station wagon",
        {
            "body": "*c9211e . paint",
            "windows": "-26323c . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7eec2",
        },
        Usual(4.2, STEEL, 0.015),
    ),
    "bus": Noun(
        "coach; school bus, double decker",
        {
            "body": "*f0b41a . paint",
            "windows": "-2a3842 . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7f2d8",
        },
        Usual(12.0, STEEL, 0.0052),
    ),
    "truck": Noun(
        "lorry, lorries; semi",
        {
            "cargo": "+e4e6e8",
            "cab": "*2a62b0 . paint",
            "windows": "-26323c . glass",
            "chassis": "-2b2b2e",
            "wheels": "-1c1c1e . rubber",
        },
        Usual(7.0, STEEL, 0.016),
    ),
    "airplane": Noun(
        "plane, aeroplane, aircraft; jet, airliner, jumbo jet, bomber, private jet",
        {
            "body": "*e8eaed . paint",
            "wings": "&c7ccd2 . paint",
            "windows": "-25303a . glass",
            "engines": "-3d6fb3",
        },
        Usual(12.0, STEEL, 0.0062),
    ),
    "boat": Noun(
        "sailboat, sailing boat; ship, yacht, rowboat, rowing boat, fishing boat, "
        "speedboat, motorboat, lifeboat, tugboat, ferry, steamboat, battleship, warship, "
        "catamaran, dinghy, raft, ocean liner, titanic, aircraft carrier",
        {"hull": "*a3552a", "sails": "+f3efe4", "mast": "-7c4f2b"},
        Usual(8.0, WOOD, 0.3),
    ),
    "train": Noun(
        "locomotive, steam engine, steam train; railway engine, train engine, subway",
        {
            "boiler": "*1f5d3a . paint",
            "cab": "+b3271f",
            "chimney": "-232326",
            "frame": "-2e2e31",
            "wheels": "-9c2a22",
        },
        Usual(12.0, STEEL, 0.051),
    ),
    "rocket": Noun(
        "rocket ship, space rocket; missile, firework, rocketship, torpedo",
        {"hull": "*e6e6e8", "nose": "+cc1a14", "fins": "+cc1a14", "nozzle": "-4d4d52 . metal"},
        Usual(20.0, STEEL, 0.0029),
    ),
    "bicycle": Noun(
        "bike, push bike, pushbike, cycle; mountain bike, road bike, bmx, tricycle, "
        "ebike, penny farthing",
        {
            "frame": "*c9211e . paint",
            "wheels": _TYRES,
            "seat": "+2c211b . leather",
            "handlebar": "-9aa1a8 . metal",
            "pedals": "-55585c . metal",
        },
        Usual(1.75, STEEL, 0.015),
    ),
    "motorcycle": Noun(
        "motorbike, motor bike, motor cycle; chopper, dirt bike, harley, harley davidson,"
        " sport bike, superbike, quad bike, quadbike",
        {
            "body": "*b3201c . paint",
            "wheels": _TYRES,
            "engine": "-8a9096 . metal",
            "seat": "+1f1b19 . leather",
            "handlebar": "-a9aeb4 . metal",
            "lamp": "-f7eec2",
        },
        Usual(2.1, STEEL, 0.06),
    ),
    "scooter": Noun(
        "motor scooter, vespa; moped, lambretta",
        {
            "body": "*6fb5a8 . paint",
            "wheels": _TYRES,
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
        },
        Usual(8.0, STEEL, 0.1),
    ),
    "helicopter": Noun(
        "chopper helicopter, heli",
        {
            "body": "*c9241e . paint",
            "windows": _GLASS,
            "rotor": "+3a3d40",
            "skids": "-55595e . metal",
            "tail rotor": "-3a3d40",
        },
        Usual(11.0, STEEL, 0.0042),
    ),
    "van": Noun(
        "minivan, delivery van; minibus, ice cream truck",
        {"body": "*e8eaec . paint", "windows": _GLASS, "wheels": _TYRES, "lamps": _LAMPS},
        Usual(5.2, STEEL, 0.0082),
    ),
    "ambulance": Noun(
        "ambulance car; emergency vehicle",
        {
            "body": "*f2f2ef . paint",
            "windows": _GLASS,
            "wheels": _TYRES,
            "lamps": "-f7eec2",
            "cross": "+cf1f1f",
            "light": "-2a5fd0",
        },
        Usual(6.0, STEEL, 0.0093),
    ),
    "taxi": Noun(
        "cab, taxicab, taxi cab",
        {
            "body": "*f2bd12 . paint",
            "windows": _GLASS,
            "wheels": _TYRES,
            "lamps": "-f7eec2",
            "sign": "+f4f2ea",
        },
        Usual(4.5, STEEL, 0.015),
    ),
    "fire truck": Noun(
        "fire engine, firetruck; fire brigade truck",
        {
            "body": "*c4161a . paint",
            "ladder": "+c9cdd2 . metal",
            "windows": _GLASS,
            "wheels": _TYRES,
            "lockers": "-b9bec4 . metal",
            "light": "-2a5fd0",
        },
        Usual(9.0, STEEL, 0.018),
    ),
    "jeep": Noun(
        "; off road car, off roader, suv, army car, land rover, range rover, humvee, "
        "hummer, off road vehicle, dune buggy, buggy",
        {
            "body": "*5d6b3e . paint",
            "windows": _GLASS,
            "wheels": _TYRES,
            "lamps": "-f7eec2",
            "seats": "-3a3026",
            "roof": "+3f4a2c",
        },
        Usual(3.6, STEEL, 0.025),
    ),
    "tractor": Noun(
        "farm tractor; agricultural tractor",
        {
            "body": "*2f8f3a . paint",
            "cab": "&2f8f3a . paint",
            "windows": _GLASS,
            "wheels": _TYRES,
            "rims": "+f0c21a",
            "exhaust": "-3a3a3c . metal",
        },
        Usual(4.0, STEEL, 0.039),
    ),
    "excavator": Noun(
        "digger; backhoe, bulldozer, power shovel, steam shovel, front loader, bulldozer truck",
        {
            "body": "*f0ae18 . paint",
            "windows": _GLASS,
            "arm": "&f0ae18 . paint",
            "bucket": "+4a4c50 . metal",
            "tracks": "-29292a",
        },
        Usual(8.0, STEEL, 0.04),
    ),
    "submarine": Noun(
        "sub, u boat, submarine boat; yellow submarine",
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
    "hot air balloon": Noun(
        "hot-air balloon, air balloon; montgolfier",
        {"balloon": "*d6322a hoops", "basket": "+9a6a38", "ropes": "-6b5334"},
        Usual(25.0, FABRIC, 0.00069),
    ),
    "ufo": Noun(
        "flying saucer; alien ship, alien spaceship, mothership",
        {
            "body": "*a5adb5 . metal",
            "dome": "+6fd0c8 . glass",
            "lights": "-f5d63a",
            "legs": "-70777e . metal",
        },
        Usual(12.0, STEEL, 0.0064),
    ),
    "spaceship": Noun(
        "space ship, spacecraft, starship; star fighter, starfighter, fighter jet, jet "
        "fighter, x wing, spacefighter, alien fighter, space fighter, tie fighter, "
        "fighter plane, stealth bomber",
        {
            "hull": "*d5d9de . paint",
            "wings": "*d5d9de . paint",
            "cockpit": "-22303c . glass",
            "guns": "+b3231f",
            "engines": "-55595f . metal",
            "flames": "-4fc3f0",
        },
        Usual(12.0, STEEL, 0.02),
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
        },
        Usual(30.0, WOOD, 0.1),
    ),
    "wagon": Noun(
        "cart, covered wagon, horse cart; carriage, hand cart, handcart, shopping "
        "trolley, minecart, stagecoach, chariot, pram, stroller, pushchair, buggy pram",
        {
            "body": "*94602f grain",
            "wheels": "&6b4220 grain",
            "handle": "-5a381c",
            "cover": "+ece2cc . fabric",
        },
        Usual(3.5, WOOD, 0.25),
    ),
    "wheelbarrow": Noun(
        "wheel barrow, barrow",
        {
            "tray": "*3f7f46 . paint",
            "wheel": _TYRES,
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
        "sledge, toboggan, sleigh; luge, bobsled",
        {"seat": "*a8713a grain", "runners": "+8c5628 grain"},
        Usual(1.1, WOOD, 0.19),
    ),
    "tram": Noun(
        "tramcar, streetcar, trolley; railcar, subway car, metro train",
        {
            "body": "*c9261f . paint",
            "windows": _GLASS,
            "stripe": "+f2ead2",
            "wheels": "-2a2a2c . metal",
            "roof": "-8b9095",
        },
        Usual(15.0, STEEL, 0.0086),
    ),
    "space shuttle": Noun(
        "shuttle, orbiter; space plane",
        {
            "body": "*eceef0",
            "wings": "&e2e4e7",
            "nose": "+2b2b2e",
            "windows": "-1e262d . glass",
            "engines": "-6d7278 . metal",
        },
        Usual(37.0, STEEL, 0.0028),
    ),
    "satellite": Noun(
        "space satellite, communications satellite; space probe, space station, sputnik, "
        "space telescope, hubble",
        {
            "body": "*d8a83c . golden",
            "panels": "+24408c",
            "arms": "-a0a5ab . metal",
            "dish": "-e4e6e8",
            "aerial": "-b0b5ba . metal",
        },
        Usual(6.0, PLASTIC, 0.2),
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
    "biplane": Noun(
        "bi plane, double decker plane; propeller plane, prop plane, propeller airplane, "
        "propeller aircraft, stunt plane, crop duster, old plane, warplane, seaplane, glider",
        {
            "body": "*c4201c . paint",
            "wings": "+f0c22a . paint",
            "struts": "-6b4526",
            "engine": "-5a5f65 . metal",
            "propeller": "-8a5a30",
            "wheels": _TYRES,
        },
        Usual(8.0, STEEL, 0.01),
    ),
    "blimp": Noun(
        "airship, air ship, zeppelin, dirigible",
        {
            "balloon": "*d9dde2 . paint",
            "band": "+c4281f . paint",
            "fins": "+c4281f . paint",
            "cabin": "-4a5058 . paint",
            "windows": "-8fd0ee . glass",
            "engines": "-3a3d42 . metal",
        },
        Usual(40, FABRIC, 0.005),
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
            "wheels": _TYRES,
            "seat": "-1f1f21 . leather",
        },
        Usual(3.4, STEEL, 0.15),
    ),
    "wheelchair": Noun(
        "wheel chair",
        {
            "wheels": _TYRES,
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
        "camping van, motor caravan; caravan, camper trailer, travel trailer, winnebago",
        {
            "body": "*f3efe4 . paint",
            "windows": _GLASS,
            "wheels": _TYRES,
            "stripe": "+e0762a . paint",
            "door": "-c9ccc8 . paint",
            "lamps": "-f7eec2",
        },
        Usual(6.5, STEEL, 0.012),
    ),
}
