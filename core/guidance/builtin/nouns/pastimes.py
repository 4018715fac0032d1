"""Pastimes: what one plays, fishes, rows and makes music with; old arms; what is hung at feasts."""

from core.guidance.builtin.nouns.noun import (
    GLASS,
    LEATHER,
    PLANT,
    PLASTIC,
    RUBBER,
    STEEL,
    WOOD,
    Noun,
    Usual,
)

PASTIME_SPORT = {
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
}
PASTIME_TOOLS = {
    "drum kit": Noun(
        "drum set, drumkit, drumset, drums, set of drums, drum kits; trap set, percussion set",
        {
            "shells": "*b51f26 . paint",
            "skins": "-f3efe4",
            "hoops": "+c3c8cd . metal",
            "cymbals": "-e2b043 . golden",
            "stands": "-7d838a . metal",
            "badge": "+1e1f23 . paint",
            "star": "-f2c14a . golden",
            "rings": "-b51f26 . paint",
        },
        Usual(1.9, WOOD, 0.035),
    ),
    "flute": Noun(
        "concert flute, transverse flute, western flute; piccolo, fife, recorder, tin whistle, "
        "penny whistle, pan flute, ocarina, didgeridoo, kazoo",
        {
            "body": "*c9ced4 . metal",
            "keys": "+dfae45 . golden",
            "rods": "&969da5 . metal",
            "rings": "+dfae45 . golden",
            "mouthpiece": "&b3b9c0 . metal",
            "hole": "-1d1a18",
        },
        Usual(0.67, STEEL, 0.13),
    ),
    "harmonica": Noun(
        "mouth organ, mouthorgan, blues harp, french harp, mouth harp, harmonicas; "
        "chromatic harmonica, melodica",
        {
            "comb": "*a8322a . paint",
            "plates": "&c9ced4 . metal",
            "holes": "-1b1817",
            "screws": "-d8a944 . golden",
            "badge": "+d8a944 . golden",
        },
        Usual(0.1, STEEL, 0.18),
    ),
    "whistle": Noun(
        "referee whistle, referee's whistle, pea whistle, sports whistle, police whistle; "
        "coach whistle, emergency whistle, dog whistle",
        {
            "body": "*c3c8cd . metal",
            "mouthpiece": "-1f2023 . rubber",
            "sides": "+d23228 . paint",
            "pea": "-d9a766",
            "ring": "&9aa1a8 . metal",
        },
        Usual(0.05, STEEL, 0.2),
    ),
}
PASTIME_ARMS = {
    "grenade": Noun(
        "hand grenade, pineapple grenade, frag grenade, fragmentation grenade, grenades, "
        "handgrenade; smoke grenade, flashbang, stun grenade",
        {
            "body": "&333d20 . paint",
            "blocks": "*5c6b36 . paint",
            "head": "-8b8a7a . metal",
            "lever": "&7a8550 . paint",
            "ring": "+d8b24a . golden",
            "pin": "-b4bac0 . metal",
        },
        Usual(0.12, STEEL, 0.22),
    ),
    "trident": Noun(
        "tridents, poseidon trident, poseidon's trident, neptune trident, neptune's trident; "
        "fishing spear, triton spear",
        {
            "head": "*e2b13f . golden",
            "shaft": "&1f6f7d . paint",
            "grip": "-5a3620 . leather",
            "collar": "*e2b13f . golden",
            "gem": "+22c0c8 . glass",
        },
        Usual(1.8, STEEL, 0.025),
    ),
}
PASTIME_PROPS = {
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
}
PASTIME_FEASTS = {
    "jack-o-lantern": Noun(
        "jack-o'-lantern, jack o'lantern, jackolantern, carved pumpkin, halloween pumpkin, "
        "pumpkin lantern, pumpkin face, scary pumpkin; pumpkin head, turnip lantern",
        {
            "body": "*e8761a",
            "stalk": "+5e6e2e",
            "eyes": "-ffc832",
            "nose": "-ffc832",
            "mouth": "-ffc832",
        },
        Usual(0.35, PLANT, 0.3),
    ),
    "christmas bauble": Noun(
        "bauble, christmas ornament, christmas ball, xmas bauble, xmas ornament, tree ornament, "
        "christmas tree ornament, christmas tree ball, christmas decoration, baubles; "
        "tree decoration, holiday ornament, glass ornament",
        {
            "ball": "*c41d2c . glass",
            "band": "~8e1220 . glass",
            "edges": "+e9bd4c . golden",
            "stars": "+f6d36b . golden",
            "dots": "-f7f3ea . paint",
            "cap": "+d9a93f . golden",
        },
        Usual(0.09, GLASS, 0.03),
    ),
    "wreath": Noun(
        "christmas wreath, xmas wreath, door wreath, holly wreath, advent wreath, wreaths; "
        "garland, laurel wreath, flower wreath",
        {
            "leaves": "*2a6a35",
            "tips": "&4c9a4a",
            "berries": "-d3222a",
            "baubles": "+e6b844 . golden",
            "bow": "+c81f2b . fabric",
            "knot": "+a01620 . fabric",
        },
        Usual(0.5, PLANT, 0.12),
    ),
}
