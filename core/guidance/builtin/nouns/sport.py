"""Balls and other things that sport and games are done with."""

from core.guidance.builtin.nouns.noun import (
    FABRIC,
    GLASS,
    LEATHER,
    PLASTIC,
    RUBBER,
    STEEL,
    WOOD,
    Noun,
    Usual,
)

SPORT = {
    "soccer ball": Noun(
        "football, soccerball, foot ball, association football; futsal ball",
        {
            "ball": "*f4f3ee . plastic",
            "patches": "+1d1e22 . plastic",
            "seams": "-b9bab8 . plastic",
        },
        Usual(0.22, RUBBER, 0.07),
    ),
    "basketball": Noun(
        "basket ball; netball",
        {"ball": "*dd6a20 seams rubber"},
        Usual(0.24, RUBBER, 0.075),
    ),
    "american football": Noun(
        "gridiron ball, gridiron football, nfl ball, nfl football, american foot ball; "
        "rugby ball, canadian football",
        {
            "ball": "*8a4420 . leather",
            "stripes": "+f5f1e6 . leather",
            "laces": "-f5f1e6 . fabric",
            "seam": "&5f2c14 . leather",
        },
        Usual(0.28, LEATHER, 0.11),
    ),
    "beach ball": Noun(
        "beachball; inflatable ball, pool toy ball",
        {
            "body": "*f6f5f1 . plastic",
            "reds": "+d92b2b . plastic",
            "yellows": "-f5c924 . plastic",
            "blues": "-2477c9 . plastic",
        },
        Usual(0.4, PLASTIC, 0.004),
        "ball",
    ),
    "tennis ball": Noun(
        "; padel ball, pickleball",
        {"body": "*c8dc3a . fabric", "seam": "+f1f2ec . rubber"},
        Usual(0.067, RUBBER, 0.32),
        "ball",
    ),
    "baseball": Noun(
        "base ball, hardball; softball, cricket ball",
        {"body": "*f3f0e8 . plastic", "stitches": "+c4232a . fabric"},
        Usual(0.074, LEATHER, 0.76),
        "ball",
    ),
    "volleyball": Noun(
        "volley ball; water polo ball, handball",
        {"body": "*f4d23a . plastic", "bands": "+2a57a8 . leather", "seams": "-3c3d40 . leather"},
        Usual(0.21, RUBBER, 0.05),
        "ball",
    ),
    "golf ball": Noun(
        "golfball",
        {"body": "*f6f6f3 . plastic", "dimples": "-dcdcd8 . plastic"},
        Usual(0.043, RUBBER, 0.95),
        "ball",
    ),
    "bowling ball": Noun(
        "",
        {"body": "*1b2f63 . plastic", "holes": "-0b0b0d . plastic"},
        Usual(0.22, RUBBER, 0.95),
        "ball",
    ),
    "billiard ball": Noun(
        "billiards ball, pool ball, 8 ball, eight ball, 8ball, snooker ball, magic 8 ball",
        {"body": "*17171a . plastic", "disc": "+f6f3ea . plastic", "number": "-17171a . plastic"},
        Usual(0.057, GLASS, 0.68),
        "ball",
    ),
    "target": Noun(
        "archery target, shooting target, target board, bow target",
        {
            "board": "*f4f2ec",
            "blacks": "-1d1d1f",
            "blues": "-2b7fc4",
            "reds": "+d8262c",
            "golds": "-f6d02f",
        },
        Usual(0.8, WOOD, 0.25),
        "dartboard",
    ),
    "dartboard": Noun(
        "dart board, darts board, bristle board, darts game; darts target, bullseye, bull's eye",
        {
            "board": "*1f2023 . rubber",
            "sectors": "+f1e3bd . fabric",
            "reds": "-cf2620",
            "greens": "-12803f",
            "darts": "-c79a3e . golden",
            "flights": "-2a66c4 . plastic",
        },
        Usual(0.45, WOOD, 0.5),
    ),
    "pool table": Noun(
        "billiard table, billiards table, snooker table, pooltable; billiards, snooker, "
        "bumper pool table",
        {
            "frame": "*6b3718 grain",
            "cloth": "+17804a . fabric",
            "pockets": "-17171a . leather",
            "balls": "-cf2620 . plastic",
            "cue ball": "-f6f2e4 . plastic",
            "cue": "-dcae6a grain",
            "sights": "-f6f2e4",
            "lines": "-f0f4ea",
        },
        Usual(2.6, WOOD, 0.25),
    ),
    "chessboard": Noun(
        "chess board, checker board, draughtboard, chess set; checkers, "
        "draughts, board game, chess game, game board",
        {
            "frame": "*8e552a grain",
            "squares": "&f0e0bc grain",
            "checks": "+3a2012 grain",
            "pieces": "-f4ead2",
            "rivals": "-26201e",
        },
        Usual(0.45, WOOD, 0.35),
    ),
    "soccer goal": Noun(
        "football goal, goalpost, goal post, goal posts, goalposts, goal, goal net, soccer net, "
        "football net; hockey goal, handball goal",
        {
            "posts": "*f6f6f2 . paint",
            "net": "-b9c6cf . fabric",
            "base": "&5d656d . paint",
        },
        Usual(7.5, STEEL, 0.0006),
    ),
    "golf club": Noun(
        "golfclub, golf driver; golf iron, golf putter, putter",
        {
            "shaft": "&c2c7cc . metal",
            "grip": "-222326 . rubber",
            "head": "*b3242c . paint",
            "neck": "-2b2d31",
            "face": "+dfe2e5 . metal",
        },
        Usual(1.15, STEEL, 0.013),
    ),
    "hockey stick": Noun(
        "ice hockey stick; field hockey stick, lacrosse stick",
        {
            "shaft": "*d9a75e grain",
            "blade": "*d9a75e grain",
            "grip": "-26272b . fabric",
            "tape": "+26272b . fabric",
            "band": "-c8281f . paint",
        },
        Usual(1.5, WOOD, 0.13),
    ),
    "boxing glove": Noun(
        "boxer glove; mma glove, punching glove",
        {
            "body": "*c4201d . leather",
            "thumb": "*c4201d . leather",
            "cuff": "&a01916 . leather",
            "band": "+f4f1ea",
            "star": "-f6c431",
            "letters": "-a01916",
        },
        Usual(0.3, FABRIC, 0.16),
    ),
    "kettlebell": Noun(
        "kettle bell, girya",
        {
            "body": "*2c2e33",
            "handle": "&b4b9bf . metal",
            "badge": "+d8342c",
            "base": "&1d1e21 . rubber",
        },
        Usual(0.28, STEEL, 0.5),
    ),
    "barbell": Noun(
        "bar bell, weight bar; weightlifting bar, weight set",
        {
            "weights": "*c8281f . rubber",
            "plates": "+2456a8 . rubber",
            "bar": "-c2c7cc . metal",
            "collars": "-8e949b . metal",
        },
        Usual(2.0, STEEL, 0.054),
    ),
    "treadmill": Noun(
        "running machine, tread mill; exercise machine, walking pad",
        {
            "body": "*3a3d43",
            "belt": "-17181a . rubber",
            "posts": "&b2b7bd . metal",
            "handles": "+d8342c . rubber",
            "console": "*3a3d43",
            "screen": "-3fa7c9 . glass",
        },
        Usual(1.8, STEEL, 0.028),
    ),
    "roller skate": Noun(
        "rollerskate, skate, quad skate; inline skate, rollerblade",
        {
            "body": "*f2f0ea . leather",
            "sole": "-3a3d43",
            "wheels": "+ef5f8f . rubber",
            "hubs": "-f4d25a",
            "stop": "&ef5f8f . rubber",
            "laces": "-ef5f8f",
            "stripes": "-ef5f8f",
            "star": "-f4b93a",
        },
        Usual(0.32, LEATHER, 0.27),
    ),
    "skis": Noun(
        "ski, pair of skis, snow skis, downhill skis, alpine skis, skis and poles, skis with "
        "poles, ski set; cross country skis, ski poles, water skis, skiing equipment",
        {
            "skis": "*d8322c . paint",
            "stripes": "+f6d048 . paint",
            "bindings": "-2e3036 . plastic",
            "strap": "+2c6fbc . fabric",
            "poles": "-b4bcc4 . metal",
            "grips": "-2e3036 . rubber",
        },
        Usual(1.7, PLASTIC, 0.1),
    ),
    "surfboard": Noun(
        "surf board, surfing board; snowboard, wakeboard, bodyboard, boogie board, "
        "paddle board, paddleboard, sup board",
        {
            "board": "*34b0c4 . paint",
            "stripe": "+f6f2e6 . paint",
            "bands": "~f2702e . paint",
            "fins": "-26303a",
        },
        Usual(2.1, PLASTIC, 0.011),
    ),
    "fishing rod": Noun(
        "fishing pole, fishingrod, fishing-rod, angling rod, rod and reel, fly rod; "
        "fly fishing rod, spinning rod, angler's rod",
        {
            "rod": "*2d5f86 . paint",
            "handle": "+c08c55 grain",
            "reel": "-9aa2aa . metal",
            "line": "-eceae2",
            "float": "-f6f3ea . plastic",
            "tip": "&d42a24 . plastic",
        },
        Usual(2.1, PLASTIC, 0.0012),
    ),
    "oar": Noun(
        "oars, boat oar, rowing oar, paddle, boat paddle, canoe paddle, rowboat oar; kayak "
        "paddle, scull",
        {
            "shaft": "*b98046 grain",
            "blade": "*c58d50 grain",
            "stripe": "+c62f28 . paint",
            "grip": "&7c4a24 grain",
            "sleeve": "-3a2a22 . leather",
            "collar": "-d0a24a . golden",
        },
        Usual(1.9, WOOD, 0.17),
    ),
    "yoga mat": Noun(
        "yogamat, exercise mat, gym mat, fitness mat, pilates mat, yoga mats; sleeping mat",
        {"mat": "*7a4fa3 . rubber", "flowers": "+cfb4e6 . rubber", "border": "~5a3a7a . rubber"},
        Usual(1.8, RUBBER, 0.007),
        "bench",
    ),
    "hockey puck": Noun(
        "ice hockey puck, puck, hockey pucks",
        {"body": "*1d1d1f . rubber", "grip": "~2f2f33 . rubber", "badge": "+e9e6dd . paint"},
        Usual(0.076, RUBBER, 1.0),
        "desk lamp",
    ),
    "kite": Noun(
        "diamond kite, flying kite, paper kite; stunt kite, toy kite",
        {
            "sail": "*d8302a . fabric",
            "keel": "+f4c52c . fabric",
            "spars": "-7a4c28 grain",
            "tail": "-f2efe6 . fabric",
            "bows": "&2f76c4 . fabric",
        },
        Usual(1.4, FABRIC, 0.015),
    ),
    "yo-yo": Noun(
        "yoyo; toy yo yo, spinning yo yo",
        {
            "discs": "*d42a28 . plastic",
            "faces": "+f6f2e4 . plastic",
            "stars": "~2a62b8 . plastic",
            "axle": "-b4bac0 . metal",
            "string": "-efe9da . fabric",
        },
        Usual(0.12, PLASTIC, 0.5),
    ),
    "slingshot": Noun(
        "sling shot, hand catapult; wrist rocket",
        {
            "fork": "*8a5a2e grain",
            "grip": "+b5522a . leather",
            "bands": "-c9a05a . rubber",
            "pouch": "&5a341e . leather",
            "stone": "-85837e mottle stone",
            "ties": "-e4d8bc",
        },
        Usual(0.22, WOOD, 0.6),
    ),
    "boomerang": Noun(
        "boomarang, throwing stick",
        {
            "body": "*a8662e grain",
            "bands": "+c9302a . paint",
            "stripes": "&f3ecd8 . paint",
            "dot": "+c9302a . paint",
        },
        Usual(0.4, WOOD, 0.5),
    ),
}
