"""What hauls, races, floats and flies; a pump and a tower beside the road."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual
from core.guidance.builtin.nouns.vehicles import GLASS_LOOK, TYRES_LOOK

HAULAGE = {
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
        },
        Usual(8.5, STEEL, 0.025),
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
    "minecart": Noun(
        "mine cart, ore cart, mining cart, mine car, minecarts, mine wagon; coal cart, rail cart",
        {
            "box": "*8d5c30 grain",
            "bands": "+5f646a . metal",
            "ore": "-e2ac2c . golden",
            "wheels": "-2f3236 . metal",
            "rails": "-8b9096 . metal",
            "sleepers": "-5d3b20 grain",
        },
        Usual(1.6, WOOD, 0.8),
    ),
    "stagecoach": Noun(
        "stage coach, carriage, horse carriage, horse drawn carriage, royal carriage, "
        "stagecoaches; mail coach, buggy carriage, hansom cab",
        {
            "body": "*8f2420 . paint",
            "roof": "&4a1a18 . paint",
            "windows": "-f0d9a0",
            "wheels": "+e0ac38 . paint",
            "frame": "+c48f2c . paint",
            "luggage": "-6b4326 . leather",
        },
        Usual(4.2, WOOD, 0.19),
    ),
    "race car": Noun(
        "racing car, racecar, formula one car, formula 1 car, f1 car, formula one, formula 1, "
        "f1 racing car, race cars; indy car, drag racer, rally car",
        {
            "body": "*c81f1c . paint",
            "wings": "+f3f4f4 . paint",
            "wheels": TYRES_LOOK,
            "hubs": "-a4aab0 . metal",
            "cockpit": "-1d1e20",
            "helmet": "+f2c52a . paint",
            "visor": "-1b1d22 . glass",
            "number": "-f4f3ee . paint",
        },
        Usual(5.2, STEEL, 0.012),
    ),
    "sports car": Noun(
        "sportscar, supercar, super car, coupe, coupé, sports cars; hypercar, ferrari, porsche, "
        "lamborghini, muscle car, roadster, lambo, bugatti, mclaren, corvette, mustang",
        {
            "body": "*f2b20f . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "hubs": "-c3c8cd . metal",
            "lamps": "-fbf4d6",
            "spoiler": "+202225",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(4.5, STEEL, 0.0205),
    ),
    "golf cart": Noun(
        "golf buggy, golfcart, golf car, golf carts; buggy cart, electric cart",
        {
            "body": "*f0f0ea . paint",
            "roof": "+2c7a4b . paint",
            "seat": "-c9a173 . leather",
            "posts": "-4b5056 . metal",
            "wheels": TYRES_LOOK,
            "bags": "+2c7a4b . fabric",
            "lamps": "-f7eec2",
            "trim": "-33363b",
        },
        Usual(2.4, STEEL, 0.028),
    ),
    "tricycle": Noun(
        "trike, three wheeler, tricycles, child's tricycle, kids tricycle; big wheel trike",
        {
            "frame": "*d2231f . paint",
            "wheels": TYRES_LOOK,
            "hubs": "+f4f2ea . paint",
            "seat": "+f2c02a . plastic",
            "handlebar": "-aab0b6 . metal",
            "pedals": "+2468b8 . plastic",
        },
        Usual(0.75, STEEL, 0.047),
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
    "cargo ship": Noun(
        "container ship, freighter, cargo vessel, containership, cargo boat, cargo ships, freight "
        "ship; oil tanker, tanker ship, bulk carrier, merchant ship, ship, ferry, tugboat, "
        "steamboat, battleship, warship, aircraft carrier",
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
        Usual(150.0, STEEL, 0.0044),
    ),
    "rowboat": Noun(
        "rowing boat, row boat, rowboats, rowing boats; skiff, jolly boat, punt, lifeboat, "
        "motorboat, speedboat, dory",
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
}
ROADSIDE_MARKS = {
    "gas pump": Noun(
        "petrol pump, fuel pump, gasoline pump, gas pumps, vintage gas pump, retro gas pump, "
        "fuel dispenser; petrol bowser, diesel pump, charging station",
        {
            "body": "*cf2a22 . paint",
            "globe": "+f7f3e6 . glass",
            "face": "+f6efdc . paint",
            "trim": "-b9bec4 . metal",
            "hose": "-1d1e20 . rubber",
            "nozzle": "-3c4045 . metal",
            "marks": "-26282c",
            "star": "-cf2a22 . paint",
        },
        Usual(2.0, STEEL, 0.05),
    ),
    "water tower": Noun(
        "water tank tower, watertower, water towers, elevated water tank; water tank, tank tower, "
        "reservoir tower",
        {
            "tank": "*a56f3f grain",
            "roof": "+7c3b2a . paint",
            "bands": "-5a5f65 . metal",
            "legs": "+6d5138 grain",
            "braces": "&866443 grain",
            "pipe": "-7d8389 . metal",
            "seams": "~6e4626",
            "ridges": "~5c2a1e",
        },
        Usual(16.0, WOOD, 0.11),
    ),
}
