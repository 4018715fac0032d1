"""What sport is done with."""

from core.guidance.builtin.nouns.noun import FABRIC, LEATHER, PLASTIC, STEEL, WOOD, Noun, Usual

SPORT = {
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
        "bar bell, weight bar; weightlifting bar, weight set, bench press",
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
    "roller skate": Noun(
        "rollerskate, skate, quad skate; inline skate, rollerblade, ice skate",
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
}
