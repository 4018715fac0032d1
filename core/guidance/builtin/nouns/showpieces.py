"""A grand piano, a stop sign, an open chest of gold, a saddle, an umbrella stand, a PC's tower."""

from core.guidance.builtin.nouns.noun import LEATHER, STEEL, WOOD, Noun, Usual

SHOWPIECE_FURNITURE = {
    "grand piano": Noun(
        "grand pianos, concert piano, concert grand piano; baby grand piano, baby grand, concert "
        "grand, harpsichord, fortepiano",
        {
            "body": "*1d1b1c . paint",
            "keys": "-f6f2e8",
            "black keys": "-121212",
            "lid": "*1d1b1c . paint",
            "strings": "-d9a441 . golden",
            "legs": "&1d1b1c . paint",
        },
        Usual(1.9, WOOD, 0.5),
    ),
}
SHOWPIECE_PROPS = {
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
    "open chest": Noun(
        "open treasure chest, opened chest, opened treasure chest, overflowing chest, overflowing "
        "treasure chest, open pirate chest, open chests, chest of gold, chest of coins; "
        "open coffer, open trunk, open loot box",
        {
            "body": "*7a4a24 grain",
            "lid": "*7a4a24 grain",
            "bands": "+4a4d52 . metal",
            "lock": "-d8a83c . golden",
            "coins": "-f0bd3a coins golden",
            "seams": "~41260f grain",
            "keyhole": "-1c1208",
        },
        Usual(0.9, WOOD, 0.5),
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
}
SHOWPIECE_HOUSEHOLD = {
    "umbrella stand": Noun(
        "umbrella stands, umbrella holder, umbrella rack, cane stand, cane holder, walking stick "
        "stand; umbrella basket, walking stick holder",
        {
            "body": "*1f5560 . paint",
            "rim": "+c9a24a . golden",
            "base": "+c9a24a . golden",
            "umbrellas": "-b3262b . fabric",
            "handles": "-6a4124 grain",
        },
        Usual(0.95, STEEL, 0.013),
    ),
}
SHOWPIECE_DEVICES = {
    "computer tower": Noun(
        "computer towers, pc tower, gaming pc tower, tower pc, tower computer, desktop tower, "
        "gaming tower, gaming pc, gaming computer, gaming rig, gaming desktop, pc case, computer "
        "case, custom pc, rgb "
        "pc, pc build; gaming desktop computer, tower server, water cooled pc",
        {
            "body": "*26282c . paint",
            "window": "-33506b . glass",
            "fans": "-17181a . plastic",
            "lights": "+35d6f0 . plastic",
            "buttons": "&45494f . plastic",
            "feet": "-151617 . rubber",
            "ports": "-8a9096 . metal",
        },
        Usual(0.48, STEEL, 0.025),
    ),
}
