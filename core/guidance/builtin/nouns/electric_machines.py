"""Machines, lights and tools that run on electricity."""

from core.guidance.builtin.nouns.noun import GLASS, PLASTIC, STEEL, Noun, Usual

ELECTRIC_MACHINES = {
    "light bulb": Noun(
        "lightbulb, bulb",
        {"bulb": "*f7e08a . glass", "cap": "+a6abb1 . metal", "tip": "-2a2a2c"},
        Usual(0.11, GLASS, 0.08),
    ),
    "flashlight": Noun(
        "flash light, pocket lamp, torch light, hand torch, electric torch; torchlight, headlamp",
        {
            "body": "*2f3338 . metal",
            "head": "*2f3338 . metal",
            "lens": "-fff0b0 . glass",
            "rings": "+e9b52c . rubber",
            "cap": "&8d949b . metal",
            "button": "-d8322a . rubber",
            "bulb": "-fffdf0",
            "flutes": "~17191c",
        },
        Usual(0.2, STEEL, 0.07),
    ),
    "battery": Noun(
        "aa battery, aaa battery, battery cell, electric battery; car battery, accumulator, "
        "power bank, lithium battery, rechargeable battery, battery pack, power cell, energy cell",
        {
            "body": "*232428 . paint",
            "top": "+c98436 . copper",
            "nub": "-c7ccd1 . metal",
            "base": "-c7ccd1 . metal",
            "plus": "-f4f4f0 . paint",
            "bolt": "+f2c52c . paint",
        },
        Usual(0.05, STEEL, 0.1),
    ),
    "coffee machine": Noun(
        "coffee maker, coffeemaker, coffee brewer, filter coffee machine, drip coffee maker; "
        "espresso machine, espresso maker",
        {
            "body": "*b8322c",
            "jug": "-4a2414 . glass",
            "collar": "+24252a",
            "handle": "+24252a",
            "plate": "-b9bec4 . metal",
            "panel": "-d7dade . metal",
            "digits": "-1d1f22",
            "buttons": "-e4a02c",
        },
        Usual(0.35, PLASTIC, 0.11),
    ),
    "clothes iron": Noun(
        "steam iron, flat iron, flatiron, clothing iron, electric iron, ironing iron, laundry iron",
        {
            "body": "*2f7fc4",
            "sole": "-c9ced4 . metal",
            "handle": "+eef0f2",
            "dial": "-e4572e",
            "button": "-e4572e",
            "stripes": "+eef0f2",
            "panes": "-a9d6ec . glass",
        },
        Usual(0.28, PLASTIC, 0.57),
    ),
    "hair dryer": Noun(
        "hairdryer, hair drier, hairdrier, blow dryer, blowdryer; heat gun, hair straightener, "
        "curling iron",
        {
            "body": "*e0527f",
            "nozzle": "+2b2c31",
            "grip": "*e0527f",
            "grille": "-b9bec4 . metal",
            "buttons": "-f4f1ea",
            "ring": "-c9ced3 . metal",
        },
        Usual(0.27, PLASTIC, 0.27),
    ),
    "vacuum cleaner": Noun(
        "vacuum, hoover, vacuum machine, upright vacuum; dust buster, carpet cleaner, robot "
        "vacuum, roomba, shop vac",
        {
            "body": "*6b3fa0",
            "cup": "-a9d6dc . glass",
            "base": "+f0b429",
            "pole": "-b7bbc1 . metal",
            "grip": "+2b2c31",
            "wheels": "-2b2c31 . rubber",
            "bands": "-5b3a86",
            "vents": "-2b2c31",
        },
        Usual(1.1, PLASTIC, 0.077),
    ),
    "sewing machine": Noun(
        "; embroidery machine, overlocker",
        {
            "body": "*1f2b33 . paint",
            "base": "+8a5128 grain",
            "wheel": "-c9ced4 . metal",
            "needle": "-d4d8dc . metal",
            "spool": "-d23a4e",
            "band": "-e3bb4c . golden",
        },
        Usual(0.42, STEEL, 0.23),
        constructed=True,
    ),
    "lawn mower": Noun(
        "lawnmower, mower, grass mower, grass cutter",
        {
            "deck": "*c8281f . paint",
            "engine": "+2d2f33",
            "wheels": "-222326 . rubber",
            "hubs": "-e6c22f",
            "handle": "-3c3f45 . metal",
            "bag": "-4d5157 . fabric",
        },
        Usual(1.5, STEEL, 0.013),
    ),
    "power drill": Noun(
        "drill, electric drill, cordless drill, hand drill, drill machine, drilling machine; "
        "screwdriver drill, power tool, impact driver",
        {
            "body": "*f2b01e",
            "chuck": "-3a3c41 . metal",
            "bit": "-b4b9bf . metal",
            "grip": "+26272b . rubber",
            "battery": "&2f3136",
            "trigger": "-c7281f",
            "vents": "-2a2b2e",
            "letters": "-f4d26a",
        },
        Usual(0.25, 2500.0, 0.6),
    ),
    "robot arm": Noun(
        "robotic arm, industrial robot, robot manipulator, mechanical arm; welding robot, "
        "robot gripper, robot hand",
        {
            "arms": "*f08a1c . paint",
            "joints": "&3d4147 . paint",
            "base": "*f08a1c . paint",
            "turntable": "-2b2d31 . metal",
            "gripper": "-9aa0a6 . metal",
            "caps": "+f2f3f0 . paint",
            "stripes": "&2b2d31 . paint",
        },
        Usual(1.8, STEEL, 0.09),
    ),
    "drone": Noun(
        "quadcopter, quadrocopter; quad copter, uav",
        {
            "body": "*e6e8ea",
            "arms": "*c9cdd2",
            "rotors": "+2d2f33",
            "camera": "-17181a . glass",
            "legs": "-4a4d52",
            "lamps": "-49d06a",
            "seams": "~9aa0a6",
        },
        Usual(0.4, PLASTIC, 0.15),
    ),
}
