"""Trains, cycles, carts, sleds, and a parachute."""

from core.guidance.builtin.nouns.noun import (
    FABRIC,
    GLASS_LOOK,
    STEEL,
    TYRES_LOOK,
    WOOD,
    Noun,
    Usual,
)

TRAINS_CYCLES_AND_CARTS = {
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
        constructed=True,
    ),
    "tram": Noun(
        "tramcar, streetcar, trolley; railcar, subway, subway car, metro train",
        {
            "body": "*c9261f . paint",
            "windows": GLASS_LOOK,
            "stripe": "+f2ead2",
            "wheels": "-2a2a2c . metal",
            "roof": "-8b9095",
            "doors": "~8f1a15",
            "lamps": "-f7eec2",
            "sign": "+f2ead2",
        },
        Usual(15.0, STEEL, 0.0086),
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
    "bicycle": Noun(
        "bike, push bike, pushbike, cycle; mountain bike, road bike, bmx, ebike",
        {
            "frame": "*c9211e . paint",
            "wheels": TYRES_LOOK,
            "seat": "+2c211b . leather",
            "handlebar": "-9aa1a8 . metal",
            "pedals": "-55585c . metal",
        },
        Usual(1.75, STEEL, 0.067),
        constructed=True,
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
            "fins": "-4d5156 . metal",
        },
        Usual(2.1, STEEL, 0.14),
        constructed=True,
    ),
    "scooter": Noun(
        "motor scooter, vespa; moped, lambretta, scooty",
        {
            "body": "*6fb5a8 . paint",
            "wheels": TYRES_LOOK,
            "seat": "+5a3420 . leather",
            "handlebar": "-a9aeb4 . metal",
            "lamp": "-f7eec2",
            "grille": "-2c3a38",
            "trim": "+f2ead2",
            "tail lamps": "-c9261f",
        },
        Usual(1.8, STEEL, 0.048),
    ),
    "skateboard": Noun(
        "skate board; longboard",
        {"board": "*c9302a", "wheels": "+efe8d6", "trucks": "-8d9399 . metal"},
        Usual(0.8, WOOD, 0.29),
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
    "wagon": Noun(
        "cart, covered wagon, horse cart; hand cart, handcart",
        {
            "body": "*94602f grain",
            "wheels": "&6b4220 grain",
            "handle": "-5a381c",
            "cover": "+ece2cc . fabric",
            "seams": "~63401f grain",
        },
        Usual(3.5, WOOD),
        constructed=True,
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
        Usual(4.2, WOOD, 0.4),
        constructed=True,
    ),
    "sled": Noun(
        "sledge, toboggan; luge, bobsled",
        {"seat": "*a8713a grain", "runners": "+8c5628 grain"},
        Usual(1.1, WOOD, 0.19),
    ),
    "sleigh": Noun(
        "sleighs, santa sleigh, santa's sleigh, santas sleigh, christmas sleigh, santa claus "
        "sleigh, santa sled, santa's sled, horse sleigh, reindeer sleigh, one horse open sleigh; "
        "horse drawn sleigh, winter sleigh",
        {
            "body": "*c4231f . paint",
            "trim": "+e6b53a . golden",
            "seat": "+2f6b3c . fabric",
            "runners": "+d9a233 . golden",
            "sack": "+9a6a3c . fabric",
        },
        Usual(2.6, WOOD, 0.3),
    ),
    "snowmobile": Noun(
        "snow mobile, snow scooter, motor sled; skidoo, ski doo, snow machine, snow bike",
        {
            "hood": "*d6301f . paint",
            "saddle": "-232428 . leather",
            "track": "-1f2023 . rubber",
            "skis": "+f0b928 . paint",
            "windshield": "-a9cdd8 . glass",
            "handles": "-2b2d31 . rubber",
        },
        Usual(3.0, STEEL, 0.014),
    ),
    "parachute": Noun(
        "para chute, chute, supply drop, air drop, airdrop; paraglider",
        {
            "canopy": "*f2efe6 . fabric",
            "gores": "+d8332a . fabric",
            "lines": "-d9cfb6",
            "crate": "-b98246 grain",
            "straps": "-3a3d41 . fabric",
        },
        Usual(6.0, FABRIC, 0.02),
    ),
    "baby stroller": Noun(
        "stroller, pram, baby carriage, pushchair, perambulator, baby buggy, baby pram, buggy"
        " pram, strollers",
        {
            "body": "*2f4f86 . fabric",
            "hood": "*2f4f86 . fabric",
            "bedding": "+f2e6d6 . fabric",
            "frame": "-b9bec4 . metal",
            "grip": "-232326 . rubber",
            "tyres": "-1c1c1e . rubber",
        },
        Usual(1.1, FABRIC, 0.4),
        constructed=True,
    ),
}
