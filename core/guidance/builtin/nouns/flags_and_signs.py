"""Flags of countries and pirates, and signs of the road."""

from core.guidance.builtin.nouns.noun import STEEL, Noun, Usual

_POLE = {"pole": "-b0b4b8 . metal", "knob": "-e0b84a . golden", "base": "-6e6a64 . stone"}


def _flag(names: str, cloth: str, **markings: str) -> Noun:
    """A flag of its colours, by the names of its markings."""
    lies = {name: f"-{color} . fabric" for name, color in markings.items()}
    looks = {"cloth": f"*{cloth} . fabric"} | _POLE | lies
    return Noun(names, looks, Usual(2.5, STEEL, 0.0051), "flag")


FLAGS_AND_SIGNS = {
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
}  # fmt: skip
