"""Plain solids, and a heart, a star, a moon and a gear."""

from core.guidance.builtin.nouns.noun import PLASTIC, RUBBER, STEEL, WOOD, Noun, Usual

SOLIDS = {
    "ball": Noun(
        "sphere, orb; snowball, venus, neptune",
        {"body": "*d9661f"},
        Usual(0.22, RUBBER, 0.07),
    ),
    "cube": Noun(
        "box, block",
        {"body": "*9e998f"},
        Usual(0.3, WOOD),
    ),
    "torus": Noun(
        "; inner tube, bracelet, "
        "swim ring, swimming ring, pool ring, inflatable ring, pool float, rubber ring, "
        "rubber tube",
        {"body": "*e07a2c"},
        Usual(0.3, RUBBER, 0.3),
    ),
    "cylinder": Noun(
        "; pipe section, marshmallow",
        {"body": "*597a99"},
        Usual(0.4, WOOD),
    ),
    "cone": Noun(
        "",
        {"body": "*ed610f band"},
        Usual(0.5, PLASTIC, 0.061),
    ),
    "heart": Noun(
        "love heart; valentine, heart symbol, heart shape",
        {"body": "*d81f2e"},
        Usual(0.2, PLASTIC, 0.3),
    ),
    "star": Noun(
        "five pointed star; sheriff star, sheriff badge, star shape",
        {"body": "*f4bf26"},
        Usual(0.2, PLASTIC, 0.3),
    ),
    "crescent moon": Noun(
        "crescent, half moon; moon",
        {"body": "*f0d878"},
        Usual(0.2, PLASTIC, 0.3),
    ),
    "gear": Noun(
        "cog, cogwheel, cog wheel, gearwheel, gear wheel; sprocket",
        {"body": "*9298a0 . metal", "teeth": "&9298a0 . metal", "hub": "&7d838b . metal"},
        Usual(0.12, STEEL),
    ),
}
