"""Gifts, what is hung at feasts, and small pieces of games."""

from core.guidance.builtin.nouns.noun import GLASS, PLANT, PLASTIC, RUBBER, STEEL, WOOD, Noun, Usual

GIFTS_AND_DECORATIONS = {
    "gift": Noun(
        "gift box, present, wrapped present; parcel, package",
        {
            "box": "*c0262c",
            "lid": "*c0262c",
            "ribbon": "+f0c24a",
            "bow": "+f0c24a",
            "dots": "-f4efe4",
        },
        Usual(0.3, WOOD, 0.14),
    ),
    "balloon": Noun(
        "party balloon, toy balloon",
        {"body": "*d8262c . rubber", "knot": "&d8262c . rubber", "string": "-e8e4da"},
        Usual(0.4, RUBBER, 0.00045),
    ),
    "paper lantern": Noun(
        "paper lanterns, chinese lantern, japanese lantern, red lantern, asian lantern, chochin, "
        "paper lamp, silk lantern; sky lantern, lunar new year lantern, festival lantern, "
        "floating lantern, rice paper lamp",
        {
            "globe": "*d8281f",
            "ribs": "&b01a16",
            "caps": "+2a2226 . paint",
            "loop": "-e0ab3a . golden",
            "tassels": "+f0b63c",
        },
        Usual(0.6, PLANT, 0.01),
    ),
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
    "basket": Noun(
        "picnic basket; hamper, wickerwork",
        {"body": "*c39652", "handle": "&a5743e", "rim": "&a5743e", "weave": "~9a6c34"},
        Usual(0.4, PLANT, 0.1),
    ),
    "umbrella": Noun(
        "; parasol, sunshade",
        {
            "canopy": "*3056b8 . fabric",
            "stick": "-8a8f94 . metal",
            "handle": "+5a3a20",
            "panels": "~5f83e0 . fabric",
        },
        Usual(1.0, STEEL, 0.00085),
    ),
    "pawn": Noun(
        "chess pawn, chess piece; chessman",
        {"body": "*e6d4b0", "base": "&d8c49c", "collar": "&d8c49c"},
        Usual(0.048, WOOD),
    ),
    "poker chip": Noun(
        "casino chip, gambling chip, poker chips, casino chips",
        {"face": "*c4222b . plastic", "rim": "&c4222b . plastic", "spots": "+f6f4ee . plastic"},
        Usual(0.04, PLASTIC, 1.0),
        "coin",
    ),
    "gumball machine": Noun(
        "bubblegum machine, bubble gum machine, gum machine, gumball dispenser, gum ball "
        "machine, chewing gum machine; candy machine, sweet machine, candy dispenser",
        {
            "base": "*cf2027 . paint",
            "globe": "-cfe6ee . glass",
            "gumballs": "-e8392f . plastic",
            "sweets": "-2f7fdc . plastic",
            "candies": "-f7c928 . plastic",
            "knob": "-cfd4d9 . metal",
        },
        Usual(0.45, GLASS, 0.3),
    ),
}
