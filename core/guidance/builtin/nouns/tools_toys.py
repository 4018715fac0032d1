"""Tools, instruments, toys and games."""

from core.guidance.builtin.nouns.noun import PLASTIC, STEEL, WOOD, Noun, Usual

TOOLS_AND_TOYS = {
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
    "dumbbell": Noun(
        "dumb bell; gym weight",
        {"weights": "*242426", "bar": "+bdbfc4 . metal"},
        Usual(0.4, STEEL, 0.33),
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
    "robot": Noun(
        "toy robot; droid, android, cyborg, automaton, robot toy, bot, terminator",
        {
            "body": "*8f9aa5 . metal",
            "head": "*8f9aa5 . metal",
            "limbs": "&5b6b7c . metal",
            "eyes": "-49d0e0",
            "aerial": "-d63a2a",
            "joints": "-3f4750 . metal",
            "mouth": "-2a2f37 . plastic",
            "buttons": "-d63a2a . plastic",
        },
        Usual(0.3, STEEL, 0.15),
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
    "shovel": Noun(
        "spade; trowel",
        {"blade": "*8c9299 . metal", "handle": "+a8713c grain", "grip": "-7a4d26 grain"},
        Usual(1.1, 1500.0, 0.2),
    ),
    "pickaxe": Noun(
        "pick axe, pick; mattock, ice axe",
        {"head": "*868c93 . metal", "handle": "+9a6534 grain", "grip": "-4a2f1a"},
        Usual(0.9, 1800.0, 0.1),
    ),
    "saw": Noun(
        "handsaw, hand saw; hacksaw, jigsaw",
        {
            "blade": "*b9bec4 . metal",
            "handle": "+a3622e grain",
            "rivets": "-d8b04a . golden",
            "letters": "-565d63",
        },
        Usual(0.55, 2500.0, 0.062),
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
    "broom": Noun(
        "broomstick, besom; sweeping brush, dustpan, squeegee",
        {"bristles": "*d3a94e", "band": "+b5342c", "handle": "-8f5c30 grain", "lines": "~9c7a34"},
        Usual(1.4, 300.0, 0.12),
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
        "teaspoon, tablespoon; ladle, chopsticks",
        {"bowl": "*c3c8cd . metal", "handle": "&b4b9bf . metal"},
        Usual(0.18, STEEL, 0.26),
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
    "rolling pin": Noun(
        "",
        {"body": "*c99758 grain", "handles": "+9a5f2e grain", "collars": "-6b4020"},
        Usual(0.45, WOOD),
    ),
    "rocking horse": Noun(
        "toy horse; hobby horse",
        {
            "body": "*c08a50 grain",
            "mane": "+4a2c18",
            "tail": "-4a2c18",
            "saddle": "-b5281f",
            "rockers": "&9a5f2e grain",
            "eyes": "-151212",
            "glints": "-ffffff",
            "mouth": "-5a3417",
        },
        Usual(0.9, WOOD, 0.6),
    ),
    "spinning top": Noun(
        "toy top; dreidel, whirligig",
        {
            "body": "*d8322a . paint",
            "stripe": "+f4c22c . paint",
            "stem": "-c99758",
            "tip": "-8c9299 . metal",
        },
        Usual(0.08, WOOD),
    ),
    "lego brick": Noun(
        "lego, toy brick, building brick; building block",
        {"body": "*d21f1a", "studs": "&d21f1a"},
        Usual(0.03, PLASTIC, 0.4),
    ),
    "puzzle cube": Noun(
        "rubiks cube, rubik's cube, rubik cube, magic cube",
        {
            "body": "*17181a",
            "reds": "-c9211e",
            "blues": "-1f56b5",
            "greens": "-1f9a4a",
            "whites": "-f2f2f0",
            "yellows": "-f4d02a",
            "oranges": "-e8741a",
        },
        Usual(0.057, PLASTIC, 0.5),
    ),
    "basketball hoop": Noun(
        "basketball net, basketball basket, basketball goal",
        {
            "board": "*f2f2ef",
            "ring": "+e8601a . paint",
            "net": "-e6e6e2 . fabric",
            "pole": "-2f3237 . metal",
            "square": "-c9211e",
        },
        Usual(3.6, STEEL, 0.0096),
    ),
    "slide": Noun(
        "playground slide, kids slide; water slide",
        {
            "slide": "*f2b61c",
            "sides": "+d8322a",
            "ladder": "-2f6fc4 . paint",
            "rails": "-2f6fc4 . paint",
        },
        Usual(2.6, PLASTIC, 0.071),
    ),
    "trampoline": Noun(
        "",
        {
            "mat": "-232427 . fabric",
            "pad": "*2f6fc4 . fabric",
            "legs": "+a3a9b0 . metal",
            "rail": "-a3a9b0 . metal",
        },
        Usual(3.0, STEEL, 0.0041),
    ),
    "chess knight": Noun(
        "knight chess piece, chess horse, knight piece; horse head",
        {
            "body": "*e3cda4 . paint",
            "mane": "&cdb283 . paint",
            "base": "&e3cda4 . paint",
            "eyes": "-2a1f16",
        },
        Usual(0.062, WOOD),
    ),
    "chess rook": Noun(
        "rook, chess castle, chess tower, chess rook piece",
        {
            "body": "*2f2823 . paint",
            "top": "*2f2823 . paint",
            "base": "&2f2823 . paint",
            "ring": "+8a6a3c . paint",
            "joints": "~6b5a4c . paint",
        },
        Usual(0.053, WOOD),
    ),
    "chess king": Noun(
        "king chess piece, king piece; chess queen, chess bishop",
        {
            "body": "*e3cda4 . paint",
            "cross": "+d8b04a . golden",
            "base": "&cdb283 . paint",
            "rings": "&cdb283 . paint",
        },
        Usual(0.095, WOOD),
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
    ),
    "baseball bat": Noun(
        "; cricket bat, wooden club, caveman club, club",
        {"body": "*d0a05a grain", "grip": "+2a2624 . leather", "knob": "&c08f4a grain"},
        Usual(0.85, WOOD, 0.19),
    ),
    "tennis racket": Noun(
        "tennis racquet, racket, racquet; badminton racket, squash racket, ping pong "
        "paddle, table tennis paddle, table tennis bat",
        {
            "frame": "*d2281f . paint",
            "strings": "-f0eee2",
            "grip": "+26272a . leather",
            "gaps": "-4a4d50",
        },
        Usual(0.69, PLASTIC, 0.058),
    ),
    "dice": Noun(
        "die, game die, gaming dice, d6; d20",
        {"body": "*f2efe6", "pips": "+1b1b1d"},
        Usual(0.02, PLASTIC),
    ),
}
