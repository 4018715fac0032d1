"""Solids."""

from core.guidance.builtin.nouns.noun import PLASTIC, RUBBER, WOOD, Noun, Usual

SOLIDS = {
    "ball": Noun(
        "sphere, orb; globe, football, soccer ball, basketball, beach ball, planet",
        {"body": "*d9661f"},
        Usual(0.22, RUBBER, 0.07),
    ),
    "cube": Noun(
        "box, block; dice",
        {"body": "*9e998f"},
        Usual(0.3, WOOD),
    ),
    "torus": Noun(
        "donut, doughnut; ring, bagel",
        {"body": "*b87838 icing"},
        Usual(0.3, RUBBER, 0.3),
    ),
    "cylinder": Noun(
        "; column, pillar",
        {"body": "*597a99"},
        Usual(0.4, WOOD),
    ),
    "cone": Noun(
        "traffic cone",
        {"body": "*ed610f band"},
        Usual(0.5, PLASTIC, 0.061),
    ),
}
