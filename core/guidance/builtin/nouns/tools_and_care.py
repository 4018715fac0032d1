"""Hand tools, and things of a hospital and of a paint shop, put together from simple solids."""

from core.guidance.builtin.nouns.noun import FABRIC, STEEL, WOOD, Noun, Usual

TOOLS_AND_CARE: dict[str, Noun] = {
    "hospital bed": Noun(
        "hospital beds, gurney, patient bed, medical bed; stretcher, operating table, "
        "examination table",
        {
            "frame": "*c3c8cd . metal",
            "boards": "+e8e4d8 . plastic",
            "mattress": "-f2f2f0 . fabric",
            "pillow": "-fbfbf8 . fabric",
            "blanket": "+7fb5c9 . fabric",
            "wheels": "-1c1c1e . rubber",
            "drip bag": "-d5e9f2 . plastic",
        },
        Usual(2.1, STEEL, 0.031),
        constructed=True,
    ),
    "crutches": Noun(
        "crutch, pair of crutches, walking crutches",
        {
            "rails": "*b5834a . wooden",
            "pads": "-3a3d42 . rubber",
            "grips": "-3a3d42 . rubber",
            "feet": "-1c1c1e . rubber",
        },
        Usual(1.3, WOOD),
        constructed=True,
    ),
    "paint roller": Noun(
        "paint rollers, painting roller, decorating roller",
        {
            "roller": "*3f7fc8 . fabric",
            "wire": "-9aa1a8 . metal",
            "grip": "+d8352c . plastic",
            "coat": "*3f7fc8 . plastic",
        },
        Usual(0.4, FABRIC),
        constructed=True,
    ),
    "paint bucket": Noun(
        "paint can, paint tin, tin of paint, can of paint, paint pot, paint buckets, paint cans",
        {
            "tin": "-b9bfc6 . metal",
            "label": "+f4f4f2",
            "coat": "*3f7fc8 . plastic",
            "handle": "-8d949b . metal",
            "brush": "-c9975a . wooden",
        },
        Usual(0.2, STEEL, 0.25),
        constructed=True,
    ),
    "jackhammer": Noun(
        "jack hammer, pneumatic drill, jackhammers, demolition hammer",
        {
            "body": "*e0a82a . paint",
            "chisel": "-8d949b . metal",
            "bars": "-4a4f55 . metal",
            "grips": "-26262a . rubber",
            "hose": "-2c2f33 . rubber",
            "trigger": "-c4281e . plastic",
        },
        Usual(0.75, STEEL, 0.3),
        constructed=True,
    ),
    "chisel": Noun(
        "chisels, wood chisel, carving chisel; gouge",
        {
            "blade": "*aeb4ba . metal",
            "edge": "-dfe3e6 . metal",
            "grip": "+a8632c . wooden",
            "bands": "-c79a3e . golden",
        },
        Usual(0.28, STEEL, 0.5),
        constructed=True,
    ),
    "wood plane": Noun(
        "hand plane, carpenter plane, carpenters plane, block plane, jack plane, bench plane,"
        " wood planes",
        {
            "body": "*3f444a . metal",
            "handle": "+8a4f26 . wooden",
            "iron": "-b9bfc6 . metal",
            "shaving": "-e0b878 . wooden",
        },
        Usual(0.3, STEEL, 0.25),
        constructed=True,
    ),
    "workbench": Noun(
        "work bench, workbenches, carpenter bench, tool bench, workshop bench; drill press, lathe",
        {
            "top": "*a8713f grain",
            "legs": "&8a5a34 grain",
            "board": "+c9b48a . wooden",
            "vise": "-3f5a7a . metal",
            "tools": "-9aa1a8 . metal",
            "grips": "+c4281e . plastic",
        },
        Usual(2.0, WOOD, 0.5),
        constructed=True,
    ),
    "music stand": Noun(
        "music stands, sheet music stand, note stand, music holder; sheet music",
        {"stand": "*2c3035 . metal", "sheets": "-f8f6ec", "notes": "-1a1a1c"},
        Usual(1.3, STEEL, 0.027),
        constructed=True,
    ),
    "golf bag": Noun(
        "golf bags, golf bag with clubs, bag of golf clubs",
        {
            "bag": "*2f5f3f . leather",
            "trim": "+e8e4da . leather",
            "strap": "&24402c . leather",
            "shafts": "-b9bfc6 . metal",
            "irons": "-9aa1a8 . metal",
            "head covers": "+c4281e . fabric",
        },
        Usual(1.3, FABRIC, 0.7),
        constructed=True,
    ),
}
