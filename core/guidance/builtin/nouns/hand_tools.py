"""Tools of the workshop, the garden, the desk and the kitchen, and optical instruments."""

from core.guidance.builtin.nouns.noun import PLASTIC, STEEL, WOOD, Noun, Usual

HAND_TOOLS = {
    "hammer": Noun(
        "claw hammer; mallet, sledgehammer, mjolnir, gavel",
        {
            "head": "*8e949b . metal",
            "handle": "+b07a40 grain",
            "claw": "*8e949b . metal",
            "grip": "-b8241f . rubber",
            "ridges": "~7c1613",
            "bands": "~5f656b",
        },
        Usual(0.33, 2500.0, 0.28),
    ),
    "axe": Noun(
        "ax; hatchet, battleaxe, tomahawk",
        {
            "head": "*9aa1a8 . metal",
            "handle": "+a26c38 grain",
            "edge": "-e6eaee . metal",
            "wraps": "-4a2c1a . leather",
        },
        Usual(0.8, 1500.0, 0.17),
    ),
    "pickaxe": Noun(
        "pick axe, pick; mattock, ice axe",
        {"head": "*868c93 . metal", "handle": "+9a6534 grain", "grip": "-4a2f1a"},
        Usual(0.9, 1800.0, 0.1),
    ),
    "shovel": Noun(
        "spade; trowel",
        {"blade": "*8c9299 . metal", "handle": "+a8713c grain", "grip": "-7a4d26 grain"},
        Usual(1.1, 1500.0, 0.2),
    ),
    "saw": Noun(
        "handsaw, hand saw; hacksaw, jigsaw",
        {
            "blade": "*b9bec4 . metal",
            "handle": "+a3622e grain",
            "rivets": "-d8b04a . golden",
            "letters": "-565d63",
        },
        Usual(0.55, 2500.0, 0.31),
        constructed=True,
    ),
    "chainsaw": Noun(
        "chain saw, power saw; circular saw",
        {
            "body": "*e8601a",
            "bar": "-c3c8cd . metal",
            "chain": "-4a4d52 . metal",
            "handles": "+242629 . rubber",
            "guard": "&242629",
            "cover": "-e9e6de",
        },
        Usual(0.8, PLASTIC, 0.45),
    ),
    "screwdriver": Noun(
        "screw driver",
        {"handle": "*d8322a", "shaft": "+b4b9bf . metal", "collar": "-2a2a2c"},
        Usual(0.22, 2500.0, 0.53),
    ),
    "wrench": Noun(
        "spanner; adjustable wrench, monkey wrench",
        {"head": "*a3a9b0 . metal", "handle": "&8f959c . metal"},
        Usual(0.25, STEEL, 0.93),
    ),
    "pliers": Noun(
        "pair of pliers, plier, needle nose pliers, combination pliers; pincers, wire "
        "cutters, wire cutter, tin snips",
        {
            "jaws": "*aab0b8 . metal",
            "handles": "+d5322b . rubber",
            "necks": "&8a919a . metal",
            "bolt": "-d3d7dc . metal",
            "teeth": "-50565e . metal",
            "ends": "+2a2d32 . rubber",
        },
        Usual(0.2, STEEL, 0.3),
    ),
    "anvil": Noun(
        "",
        {
            "body": "*4a4d52 . metal",
            "horn": "*4a4d52 . metal",
            "waist": "*4a4d52 . metal",
            "foot": "*4a4d52 . metal",
        },
        Usual(0.5, STEEL),
    ),
    "toolbox": Noun(
        "tool box, tool chest; lunch box, lunchbox",
        {
            "body": "*c32a22 . paint",
            "lid": "&a8221c . paint",
            "handle": "+2c2d30",
            "latches": "-c3c7cc . metal",
            "letters": "+f4f1e6 . paint",
        },
        Usual(0.45, STEEL, 0.036),
    ),
    "paintbrush": Noun(
        "paint brush, brush, artist's brush",
        {
            "bristles": "-c9a878",
            "ferrule": "-b9bec4 . metal",
            "handle": "*b5672e grain",
            "paint": "+2f6fc4 . paint",
        },
        Usual(0.25, WOOD, 0.8),
    ),
    "pencil": Noun(
        "; crayon, colored pencil, coloured pencil, marker, highlighter, chalk, felt tip",
        {
            "body": "*f2b61c",
            "wood": "-e3bd88",
            "lead": "-2a2a2e",
            "eraser": "+e88a92",
            "ferrule": "-b9bec4 . metal",
            "letters": "-2a2a2e",
            "rings": "-2a2a2e",
            "bands": "-3f7a52 . paint",
        },
        Usual(0.19, WOOD, 0.3),
    ),
    "scissors": Noun(
        "pair of scissors; shears, secateurs",
        {"blades": "+b9bec4 . metal", "handles": "*d2322a", "screw": "-70757b . metal"},
        Usual(0.2, 3500.0, 0.15),
    ),
    "stapler": Noun(
        "stapling machine; staple gun, hole punch",
        {
            "body": "*c9302a",
            "magazine": "-c2c7cc . metal",
            "base": "+2a2c30",
            "hinge": "&8f1f1b",
            "plate": "-c2c7cc . metal",
        },
        Usual(0.16, STEEL, 0.14),
    ),
    "broom": Noun(
        "broomstick, besom; sweeping brush, dustpan, squeegee",
        {"bristles": "*d3a94e", "band": "+b5342c", "handle": "-8f5c30 grain", "lines": "~9c7a34"},
        Usual(1.4, 300.0, 0.12),
    ),
    "watering can": Noun(
        "garden can",
        {
            "body": "*3f9a6a . paint",
            "spout": "*3f9a6a . paint",
            "handle": "&2f7a52 . paint",
            "rose": "+d8b04a . golden",
            "band": "-2a6a48 . paint",
        },
        Usual(0.4, STEEL, 0.05),
    ),
    "fire extinguisher": Noun(
        "extinguisher; oxygen tank, gas tank, propane tank, gas cylinder, gas bottle, scuba tank, "
        "air tank, oxygen bottle, diving bottle",
        {
            "body": "*cc1f1a . paint",
            "hose": "-222326 . rubber",
            "nozzle": "-222326",
            "lever": "+8c9299 . metal",
            "label": "-f2f0ea",
            "base": "-2c2d30 . rubber",
        },
        Usual(0.5, STEEL, 0.073),
    ),
    "knife": Noun(
        "kitchen knife, chef's knife; cleaver, butter knife, scalpel, razor blade, pocketknife, "
        "pocket knife, pen knife, penknife, box cutter",
        {
            "blade": "*c3c8cd . metal",
            "handle": "+2f2420",
            "rivets": "-d5d8dc . metal",
            "edge": "-eef1f3 . metal",
            "bolster": "-c3c8cd . metal",
        },
        Usual(0.32, 3500.0, 0.53),
    ),
    "fork": Noun(
        "table fork",
        {"head": "*c3c8cd . metal", "handle": "&b4b9bf . metal"},
        Usual(0.2, STEEL, 0.23),
    ),
    "spoon": Noun(
        "teaspoon, tablespoon",
        {"bowl": "*c3c8cd . metal", "handle": "&b4b9bf . metal"},
        Usual(0.18, STEEL, 0.26),
    ),
    "rolling pin": Noun(
        "",
        {"body": "*c99758 grain", "handles": "+9a5f2e grain", "collars": "-6b4020"},
        Usual(0.45, WOOD),
    ),
    "magnifying glass": Noun(
        "magnifier, magnifying lens; loupe, monocle",
        {
            "rim": "*c79a3e . golden",
            "glass": "-bfe0ea . glass",
            "handle": "+5a3420 grain",
            "collar": "*c79a3e . golden",
        },
        Usual(0.25, 2500.0, 0.3),
    ),
    "microscope": Noun(
        "",
        {
            "base": "*e8e9ea . paint",
            "arm": "*e8e9ea . paint",
            "stage": "-2a2c30",
            "tube": "&d3d6d9 . paint",
            "eyepiece": "-232528",
            "lenses": "+a3a9b0 . metal",
            "knobs": "-2f3236",
        },
        Usual(0.4, STEEL, 0.15),
        constructed=True,
    ),
    "telescope": Noun(
        "refractor telescope",
        {
            "tube": "*e6e8ea . paint",
            "bands": "+2d3136 . metal",
            "eyepiece": "&2d3136",
            "lens": "-3f6f9a . glass",
            "tripod": "-8a5a2e grain",
            "mount": "-4a4d52 . metal",
            "rings": "+e0b040 . golden",
            "stars": "+2f5fae",
        },
        Usual(1.5, STEEL, 0.012),
    ),
}
