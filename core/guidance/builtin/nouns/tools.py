"""Tools and Toys."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual

TOOLS_AND_TOYS = {
    "hammer": Noun(
        "",
        {"head": "*8e949b . metal", "handle": "+b07a40 grain"},
        Usual(0.33, 2500.0),
    ),
    "axe": Noun(
        "ax; hatchet",
        {"head": "*9aa1a8 . metal", "handle": "+a26c38 grain"},
        Usual(0.8, 1500.0),
    ),
    "anvil": Noun(
        "",
        {"body": "*4a4d52 . metal"},
        Usual(0.5, STEEL),
    ),
    "dumbbell": Noun(
        "; barbell",
        {"weights": "*242426", "bar": "+bdbfc4 . metal"},
        Usual(0.4, STEEL),
    ),
    "guitar": Noun(
        "",
        {"body": "*c4772e . paint", "neck": "+5c3519", "hole": "-1d1410", "bridge": "-3c2416"},
        Usual(1.0, WOOD, 0.2),
    ),
    "drum": Noun(
        "snare drum",
        {
            "shell": "*b71f24 . paint",
            "hoops": "+e0b84a . golden",
            "skin": "-f2ece0",
            "sticks": "-b98a52",
        },
        Usual(0.4, WOOD, 0.2),
    ),
    "robot": Noun(
        "toy robot",
        {
            "body": "*8f9aa5 . metal",
            "head": "*8f9aa5 . metal",
            "limbs": "&5b6b7c . metal",
            "eyes": "-49d0e0",
            "aerial": "-d63a2a",
        },
        Usual(0.3, STEEL, 0.15),
    ),
}
