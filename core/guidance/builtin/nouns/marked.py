"""Things that are another one's solid with markings of their own (``markings``): no network has
seen them, and none needs to."""

from core.guidance.builtin.nouns.noun import (
    FLESH,
    GLASS,
    LEATHER,
    PLASTIC,
    RUBBER,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)
from core.guidance.builtin.nouns.vehicles import GLASS_LOOK, TYRES_LOOK

MARKED_CLOTHES = {
    "dog collar": Noun(
        "dog collars, collar, pet collar, cat collar",
        {
            "strap": "*a5252c . leather",
            "buckle": "+d9ab48 . golden",
            "keeper": "&8a1e24 . leather",
            "holes": "-1c120c",
        },
        Usual(0.14, LEATHER, 0.15),
        "belt",
    ),
}
MARKED_SPORT = {
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
}
MARKED_HOUSEHOLD = {
    "disco ball": Noun(
        "discoball, mirror ball, mirrorball, glitter ball, disco mirror ball",
        {"body": "*e3e7ec . metal", "gaps": "-54585f . metal"},
        Usual(0.4, GLASS, 0.05),
        "ball",
    ),
}
MARKED_PROPS = {
    "poker chip": Noun(
        "casino chip, gambling chip, poker chips, casino chips",
        {"face": "*c4222b . plastic", "rim": "&c4222b . plastic", "spots": "+f6f4ee . plastic"},
        Usual(0.04, PLASTIC, 1.0),
        "coin",
    ),
}
_POLE = {"pole": "-b0b4b8 . metal", "knob": "-e0b84a . golden", "base": "-6e6a64 . stone"}


def _flag(names: str, cloth: str, **markings: str) -> Noun:
    """A flag of its colours, by the names of its markings."""
    lies = {name: f"-{color} . fabric" for name, color in markings.items()}
    looks = {"cloth": f"*{cloth} . fabric"} | _POLE | lies
    return Noun(names, looks, Usual(2.5, STEEL, 0.0051), "flag")


MARKED_FLAGS = {
    "american flag": _flag(
        "us flag, usa flag, stars and stripes, united states flag, flag of america",
        "b3202e", canton="2a3560", stripes="f4f3ef", stars="f4f3ef",
    ),
    "british flag": _flag(
        "union jack, uk flag, union flag", "1f2f6b", reds="c4202f", whites="f4f3ef"
    ),
    "french flag": _flag("flag of france, france flag", "f4f3ef", blues="22397f", reds="cf2b33"),
    "italian flag": _flag("flag of italy, italy flag", "f4f3ef", greens="1f8a4a", reds="cb2b36"),
    "german flag": _flag("flag of germany", "cc2222", blacks="18181a", golds="f0c22c"),
    "japanese flag": _flag("flag of japan, japan flag", "f6f5f2", disc="bf1f34"),
    "brazilian flag": _flag(
        "flag of brazil, brazil flag", "22944a", lozenge="f6d62e", disc="23408f"
    ),
    "swedish flag": _flag("flag of sweden, sweden flag", "1f5c9e", cross="f4c92f"),
    "swiss flag": _flag("flag of switzerland, switzerland flag", "cf2430", cross="f6f5f2"),
    "canadian flag": _flag("flag of canada, canada flag", "f5f4f1", leaf="d0242e", reds="d0242e"),
    "irish flag": _flag("flag of ireland", "f5f4f1", greens="219a58", oranges="f08a35"),
    "belgian flag": _flag("flag of belgium", "f4d33a", blacks="18181a", reds="d8323a"),
    "dutch flag": _flag("flag of the netherlands", "f5f4f1", reds="b02532", blues="254a8c"),
    "spanish flag": _flag("flag of spain, spain flag", "b8202a", yellows="f3c42c"),
    "indian flag": _flag(
        "flag of india, india flag", "f5f4f1", wheel="1f2f7a", oranges="f29a3a", greens="1f8a3a"
    ),
    "chinese flag": _flag("flag of china, china flag", "d8261f", star="f8dc2c"),
    "turkish flag": _flag("flag of turkey, turkey flag", "d81f2a", star="f6f5f2", moon="f6f5f2"),
    "danish flag": _flag("flag of denmark, denmark flag", "c8202e", cross="f5f4f1"),
    "finnish flag": _flag("flag of finland, finland flag", "f5f4f1", cross="1f4a8c"),
    "ukrainian flag": _flag("flag of ukraine, ukraine flag", "2a62b4", yellows="f6d33a"),
    "polish flag": _flag("flag of poland, poland flag", "f4f3ef", reds="cd2740"),
    "pirate flag": _flag("jolly roger", "161618", skull="f2f0ea"),
}  # fmt: skip
MARKED_SIGNS = {
    "speed limit sign": Noun(
        "speed sign, speed limit road sign",
        {
            "plate": "*f3f3f1 . paint",
            "ring": "+c81f2a . paint",
            "post": "-9aa0a5 . metal",
            "number": "-17171a . paint",
        },
        Usual(2.2, STEEL, 0.02),
        "lollipop",
    ),
    "no entry sign": Noun(
        "do not enter sign, wrong way sign",
        {"plate": "*c81f2a . paint", "bar": "+f5f5f3 . paint", "post": "-9aa0a5 . metal"},
        Usual(2.2, STEEL, 0.02),
        "lollipop",
    ),
}
MARKED_FOOD = {
    "easter egg": Noun(
        "painted egg, decorated egg",
        {"shell": "*8cc7ea . paint", "stripes": "+f6d348 . paint", "dots": "-ee7fb0 . paint"},
        Usual(0.06, FLESH, 0.9),
        "egg",
    ),
}
MARKED_ANIMALS = {
    "clownfish": Noun(
        "clown fish, nemo, anemonefish",
        {
            "body": "*ef7a1c",
            "fins": "&ef8a2c",
            "eyes": "-111114",
            "whites": "-f4f2ec",
            "lips": "&d8601a",
            "bands": "+f7f5f0",
            "edges": "-1b1a1c",
        },
        Usual(0.1, FLESH),
        "fish",
    ),
    "koi": Noun(
        "koi fish, koi carp, nishikigoi",
        {
            "body": "*f3efe8",
            "fins": "&efe6da",
            "eyes": "-111114",
            "whites": "-f4f2ec",
            "lips": "&efd9c8",
            "patches": "+e0561c",
        },
        Usual(0.6, FLESH),
        "fish",
    ),
    "dalmatian": Noun(
        "dalmatian dog, dalmatian puppy",
        {
            "body": "*f3f1ec",
            "ears": "-1d1c1e",
            "muzzle": "&f3f1ec",
            "eyes": "-111111",
            "nose": "-1a1818",
            "spots": "+1d1c1e",
        },
        Usual(0.8, FLESH),
        "dog",
    ),
    "skunk": Noun(
        "; badger, polecat",
        {
            "body": "*1d1c1f",
            "tail": "+f1efe9",
            "belly": "&29282b",
            "stripe": "+f1efe9",
            "eyes": "-0c0c0e",
            "nose": "-0f0d0e",
        },
        Usual(0.6, FLESH),
        "squirrel",
    ),
}
MARKED_VEHICLES = {
    "school bus": Noun(
        "schoolbus, yellow school bus",
        {
            "body": "*f2b01c . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7f2d8",
            "stripe": "+1b1b1d . paint",
            "letters": "-1b1b1d . paint",
            "trim": "-1d1e21 . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(11.0, STEEL, 0.02),
        "bus",
    ),
    "police car": Noun(
        "cop car, police cruiser, squad car, patrol car; sheriff car, police vehicle",
        {
            "body": "*17181c . paint",
            "windows": "-6d8aa0 . glass",
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "hubs": "-d8dadd . metal",
            "siren": "-1f5fd0 . plastic",
            "doors": "+f4f5f6 . paint",
            "letters": "-16264f . paint",
        },
        Usual(4.8, STEEL, 0.017),
        "taxi",
    ),
}
MARKED_SPACE = {
    "earth": Noun(
        "planet earth, blue marble, earth planet",
        {"body": "*2766b5 . plastic", "land": "+4d8f45 . plastic", "ice": "-f4f7f9 . plastic"},
        Usual(0.4, STONE, 0.03),
        "ball",
    ),
    "full moon": Noun(
        "moon globe, lunar globe, moon ball",
        {"body": "*d2d0c9 . stone", "craters": "-a6a49f . stone"},
        Usual(0.4, STONE, 0.03),
        "ball",
    ),
}
