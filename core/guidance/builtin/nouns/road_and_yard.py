"""What stands at a road, in a yard or a camp; parts of cars, a chain and horse tack."""

from core.guidance.builtin.nouns.noun import (
    COPPER,
    FABRIC,
    LEATHER,
    PLANT,
    PLASTIC,
    RUBBER,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

ROAD_AND_YARD = {
    "traffic light": Noun(
        "traffic lights, traffic signal, stoplight, stop light; railway signal, train signal",
        {
            "body": "*2b2d30 . paint",
            "reds": "-e0241c",
            "yellows": "-f7b81a",
            "greens": "-2fb54a",
            "hoods": "&1d1f21 . paint",
            "pole": "+6e7378 . metal",
            "base": "&55595e . metal",
            "border": "-f2c01c . paint",
        },
        Usual(2.8, STEEL, 0.016),
    ),
    "traffic cone": Noun(
        "road cone, safety cone, construction cone; pylon",
        {"body": "*f0640f", "stripes": "+f4f2ec", "base": "-242527 . rubber"},
        Usual(0.7, PLASTIC, 0.05),
    ),
    "stop sign": Noun(
        "stop signs, stopsign, traffic stop sign, road stop sign, octagonal sign",
        {
            "plate": "*c4201d . paint",
            "rim": "+f4f2ee . paint",
            "letters": "+f4f2ee . paint",
            "post": "-9aa0a5 . metal",
            "base": "-7d8083 . metal",
        },
        Usual(2.2, STEEL, 0.004),
    ),
    "signpost": Noun(
        "sign post, road sign; sign",
        {"boards": "*a5743e grain", "post": "&7a4a24 grain", "base": "-8a8a82 . stone"},
        Usual(2.0, WOOD, 0.11),
    ),
    "fire hydrant": Noun(
        "hydrant, fireplug, fire plug",
        {
            "body": "*c9211b . paint",
            "dome": "*c9211b . paint",
            "rings": "&a81a15 . paint",
            "outlets": "&c9211b . paint",
            "caps": "+d8d3c6 . metal",
        },
        Usual(0.8, STEEL, 0.12),
    ),
    "mailbox": Noun(
        "letterbox, letter box, post box, postbox; mail box",
        {
            "box": "*3f6ea8 . paint",
            "door": "&3f6ea8 . paint",
            "flag": "-c9211e",
            "post": "-7a4a24 grain",
            "letters": "-f4f1e8 . paint",
            "slots": "-1f2226",
        },
        Usual(1.3, STEEL, 0.0069),
    ),
    "fence": Noun(
        "picket fence; pig pen, pigpen, paling, railing, barricade, balustrade, barrier",
        {"pickets": "*f0eee6", "rails": "&e0ded4", "nails": "-6d7278 . metal"},
        Usual(1.8, WOOD, 0.3),
    ),
    "well": Noun(
        "water well, wishing well",
        {
            "wall": "*9a958a bricks stone",
            "roof": "+8a4a2e",
            "posts": "-6b4424 grain",
            "water": "-3f7fa8",
            "seams": "~5c2e1a grain",
            "boards": "-8a5c34 grain",
            "rope": "-e0c48a . fabric",
        },
        Usual(2.2, STONE, 0.5),
    ),
    "ladder": Noun(
        "; stepladder",
        {"rails": "*b98a52 grain", "rungs": "&a5743e grain"},
        Usual(2.4, WOOD, 0.056),
    ),
    "tent": Noun(
        "camping tent; marquee, teepee, tipi, big top, wigwam, yurt",
        {
            "canvas": "*d87f2a . fabric",
            "door": "-5a3a20",
            "poles": "+6e7276 . metal",
            "trim": "+f3e3c0 . fabric",
        },
        Usual(2.2, FABRIC, 0.013),
    ),
    "campfire": Noun(
        "camp fire, fire pit, bonfire; bonfire wood, camp site fire, fireside",
        {
            "flame": "-ff8c1a",
            "logs": "*6b4424 grain",
            "stones": "+86867f . stone",
            "ash": "-3a3632",
        },
        Usual(1.0, STONE, 0.6),
    ),
    "flag": Noun(
        "banner, flagpole, flag pole; pennant",
        {
            "cloth": "*c9211e . fabric",
            "pole": "-b0b4b8 . metal",
            "knob": "-e0b84a . golden",
            "base": "-6e6a64 . stone",
        },
        Usual(2.5, STEEL, 0.0051),
    ),
    "nest": Noun(
        "bird nest, bird's nest, birds nest, birdnest, nests, nest with eggs, nest of eggs, "
        "bird's nest with eggs, bird nest with eggs, songbird nest; robin nest, eagle nest, "
        "dragon nest, eyrie",
        {
            "bowl": "*7a5530",
            "twigs": "&9c7443",
            "straw": "&c9a765",
            "eggs": "-9ed3d6",
        },
        Usual(0.25, PLANT, 0.08),
    ),
    "padlock": Noun(
        "pad lock; lock, combination lock",
        {
            "body": "*d8a83c . golden",
            "shackle": "+b9bec4 . metal",
            "keyhole": "-1d1d1f",
        },
        Usual(0.08, COPPER, 0.4),
    ),
    "chain": Noun(
        "chain link, chain links, anchor chain; prison chain",
        {"links": "*8d9298 . metal", "rings": "&b4b9be . metal"},
        Usual(0.5, STEEL, 0.6),
    ),
    "horseshoe": Noun(
        "horse shoe, horseshoes, lucky horseshoe, horse's shoe; pony shoe",
        {
            "shoe": "*777c82 . metal",
            "grooves": "-34373b . metal",
            "nails": "-c9cdd1 . metal",
            "heels": "&6a6f75 . metal",
            "clip": "&8a8f95 . metal",
        },
        Usual(0.14, STEEL, 0.5),
    ),
    "saddle": Noun(
        "saddles, horse saddle, western saddle, cowboy saddle, riding saddle; english saddle, "
        "equestrian saddle, pony saddle, camel saddle",
        {
            "skirt": "&8a5128 . leather",
            "seat": "*7a4220 . leather",
            "horn": "&5c3318 . leather",
            "flaps": "*7a4220 . leather",
            "stirrups": "+b4b7ba . metal",
            "rivets": "-d0d3d6 . metal",
            "flowers": "-d8b070 . leather",
            "stitches": "~e6cfa0 . leather",
        },
        Usual(0.9, LEATHER, 0.22),
    ),
    "jerrycan": Noun(
        "jerrycans, jerry can, jerry cans, jerican, fuel can, gas can, petrol can, gasoline can, "
        "fuel canister, gas canister, can of gas, can of petrol; oil can, water canister, "
        "oil canister, gasoline canister",
        {
            "body": "*4b5a34 . paint",
            "cross": "&4b5a34 . paint",
            "handles": "&4b5a34 . paint",
            "cap": "+33373b . metal",
            "seam": "&3f4c2c . paint",
        },
        Usual(0.47, STEEL, 0.02),
    ),
    "tire": Noun(
        "tires, tyre, tyres, car tire, car tyre, car tires, car tyres, "
        "old tire, truck tire, tractor tire, spare tire; spare tyre, racing tire, race tire, "
        "winter tire, truck tyre, tractor tyre, mud tire",
        {
            "tyre": "*3a3c42 . rubber",
            "tread": "*26262c . rubber",
            "stripe": "+e6e2d8 . rubber",
        },
        Usual(0.65, RUBBER, 0.15),
    ),
    "engine": Noun(
        "engines, car engine, car engines, v8, v8 engine, v 8 engine, motor, motors, car motor, "
        "engine block, combustion engine, petrol engine, gasoline engine; v6 engine, v12 engine, "
        "truck engine, diesel engine, turbo engine, hot rod engine, outboard motor",
        {
            "block": "*6a727c . metal",
            "covers": "+d2342a . paint",
            "ribs": "+e8e4da . metal",
            "filter": "+f2ead8",
            "lid": "+c4cad0 . metal",
            "pulleys": "-2c2e34 . metal",
            "fan": "+f0b430 . paint",
            "pleats": "~b8a884 . paint",
        },
        Usual(0.8, STEEL, 0.34),
    ),
}
