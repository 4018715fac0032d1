"""Plants."""

from core.guidance.builtin.nouns.noun import PLANT, Noun, Usual

PLANTS = {
    "mushroom": Noun(
        "toadstool",
        {"cap": "*cc1a12 dots", "stem": "+e6d9bd"},
        Usual(0.1, PLANT, 0.7),
    ),
    "tree": Noun(
        "fir, pine, conifer, fir tree, pine tree; christmas tree",
        {"leaves": "*216b29", "trunk": "+613d21"},
        Usual(6.0, PLANT, 0.05),
    ),
    "cactus": Noun(
        "cacti",
        {"body": "*3f8a45", "pot": "+b8623b"},
        Usual(0.4, PLANT),
    ),
    "flower": Noun(
        "daisy, potted flower",
        {"petals": "*f2f0e6", "heart": "+f2b81d", "stalk": "-3e8a36", "pot": "-b8623b"},
        Usual(0.4, PLANT, 0.3),
    ),
    "palm": Noun(
        "palm tree",
        {"leaves": "*3f9038", "trunk": "+94683c", "nuts": "-5a3820"},
        Usual(8.0, PLANT, 0.3),
    ),
}
