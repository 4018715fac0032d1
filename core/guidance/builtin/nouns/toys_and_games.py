"""Toys, things of a playground, and pieces of games and sports."""

from core.guidance.builtin.nouns.noun import CERAMIC, PLASTIC, RUBBER, STEEL, WOOD, Noun, Usual

TOYS_AND_GAMES = {
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
        "toy top; dreidel",
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
    "rubber duck": Noun(
        "bath duck, rubber ducky, rubber duckie, toy duck, bath toy, plastic duck, squeaky duck; "
        "bathtub duck, pool duck",
        {
            "body": "*f8cf1d . plastic",
            "wings": "*f2c112 . plastic",
            "bill": "+f07a16 . plastic",
            "eyes": "-fbfaf5 . plastic",
            "pupils": "-16130f",
            "feathers": "~c98f0a",
            "glints": "-ffffff",
        },
        Usual(0.1, RUBBER, 0.25),
    ),
    "piggy bank": Noun(
        "piggybank, money box, moneybox, pig bank, coin bank, piggy money box; savings box, "
        "penny bank",
        {
            "body": "*ee9aae . ceramic",
            "snout": "&f3b3c2 . ceramic",
            "ears": "&e5839b . ceramic",
            "eyes": "-241a1c . ceramic",
            "slot": "-3a1f28",
            "coin": "+f0bd3a . golden",
        },
        Usual(0.2, CERAMIC, 0.15),
    ),
    "dice": Noun(
        "die, game die, gaming dice, d6; d20",
        {"body": "*f2efe6", "pips": "+1b1b1d"},
        Usual(0.02, PLASTIC),
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
    "baseball bat": Noun(
        "; cricket bat",
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
    "dumbbell": Noun(
        "dumb bell; gym weight",
        {"weights": "*242426", "bar": "+bdbfc4 . metal"},
        Usual(0.4, STEEL, 0.33),
    ),
}
