"""What one plays, rides and shoots with out of doors, and two machines of games."""

from core.guidance.builtin.nouns.noun import FABRIC, PLASTIC, STEEL, WOOD, Noun, Usual

GAMES = {
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
}
SHOTS = {
    "bow": Noun(
        "longbow, long bow, archery bow, recurve bow, bow weapon, hunting bow; "
        "bow and arrow, bow and arrows, bow arrow, short bow, shortbow, compound bow, elven bow",
        {
            "limbs": "*8a5528 grain",
            "grip": "&4a2a1a . leather",
            "bands": "+e0b048 . golden",
            "string": "-f0e8d4",
            "arrow": "-c9a468 grain",
            "feathers": "-c8322a",
        },
        Usual(1.5, WOOD, 0.035),
    ),
}
RIDES = {
    "go-kart": Noun(
        "gokart, go cart, kart, racing kart, race kart; quad, quad bike, quadbike, atv, "
        "all terrain vehicle, soapbox, soapbox car, pedal car, go kart racer",
        {
            "body": "*d42823 . paint",
            "frame": "&3d4147 . metal",
            "wheels": "-1c1c1e . rubber",
            "hubs": "+d8dadd . metal",
            "seat": "-232428 . leather",
            "engine": "-6b7076 . metal",
        },
        Usual(1.9, STEEL, 0.03),
    ),
    "jet ski": Noun(
        "jetski, water scooter, personal watercraft; wave runner, waverunner, sea scooter",
        {
            "hull": "*f2f3f0 . paint",
            "cowl": "+1f6fc4 . paint",
            "saddle": "-232428 . leather",
            "bumper": "-2b2d31 . rubber",
            "handles": "-2b2d31 . rubber",
            "stripes": "+1f6fc4 . paint",
            "trim": "-f2f3f0 . paint",
            "ribs": "~34363b",
        },
        Usual(3.2, PLASTIC, 0.09),
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
}
GADGETS = {
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
    "slot machine": Noun(
        "one armed bandit, fruit machine, gambling machine, casino machine; pokie, pachinko, "
        "lottery machine",
        {
            "cabinet": "*b81f2a . paint",
            "sign": "&7d1420 . paint",
            "trim": "+e2b23e . golden",
            "reels": "-f6f3ea",
            "sevens": "-d01f26 . paint",
            "knob": "-e8402e . plastic",
            "badges": "+e2b23e . golden",
        },
        Usual(1.6, STEEL, 0.02),
    ),
    "game console": Noun(
        "handheld console, handheld game console, handheld game, gameboy, game boy, gaming console,"
        " portable console; retro handheld, nintendo, video game console, handheld",
        {
            "body": "*cfcdc4 . plastic",
            "bezel": "&5b5c68 . plastic",
            "screen": "-9bb02c . glass",
            "cross": "-26262b . plastic",
            "buttons": "+a3244e . plastic",
            "keys": "-7d7d84 . rubber",
            "pixels": "-33401a",
            "seams": "~8c8a82",
        },
        Usual(0.15, PLASTIC, 0.35),
    ),
}
