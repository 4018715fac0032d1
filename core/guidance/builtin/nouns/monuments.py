"""Monuments and large structures, put together from simple solids."""

from core.guidance.builtin.nouns.noun import COPPER, PLANT, STEEL, STONE, WOOD, Noun, Usual

MONUMENTS: dict[str, Noun] = {
    "statue of liberty": Noun(
        "lady liberty, liberty statue",
        {
            "statue": "*6fae98 . copper",
            "flame": "-f0b93a . golden",
            "pedestal": "+b9a98c bricks stone",
        },
        Usual(93.0, COPPER, 0.05),
        constructed=True,
    ),
    "colosseum": Noun(
        "coliseum, roman colosseum, amphitheatre, amphitheater, roman amphitheatre",
        {
            "walls": "*d8c29a . stone",
            "stands": "&b79c74 . stone",
            "arena": "-e2cf9f",
            "base": "-a39a86 . stone",
        },
        Usual(189.0, STONE, 0.3),
        constructed=True,
    ),
    "leaning tower": Noun(
        "leaning towers",
        {
            "tower": "*ece4d2 . stone",
            "galleries": "&d3c8b0 . stone",
            "openings": "-4a4036",
            "base": "-b5ac98 . stone",
        },
        Usual(57.0, STONE, 0.3),
        constructed=True,
    ),
    "taj mahal": Noun(
        "tajmahal",
        {
            "walls": "*f4efe4 . stone",
            "domes": "*fbf8f0 . stone",
            "openings": "-6b6256",
            "finials": "-d8a83c . golden",
            "base": "+d9c9ae . stone",
        },
        Usual(95.0, STONE, 0.3),
        constructed=True,
    ),
    "big ben": Noun(
        "elizabeth tower, london clock tower",
        {
            "tower": "*cdb37a . stone",
            "roof": "+4f6257 . metal",
            "faces": "-f6f1e0",
            "hands": "-22231f",
            "gold": "-d8a83c . golden",
        },
        Usual(96.0, STONE, 0.3),
        constructed=True,
    ),
    "sphinx": Noun(
        "great sphinx, egyptian sphinx, sphinx of giza",
        {
            "body": "*d9b777 . stone",
            "headdress": "+d0a23e . stone",
            "bands": "+2f5fa8 . paint",
            "eyes": "-2a1e12",
            "base": "&b99a63 . stone",
        },
        Usual(73.0, STONE, 0.9),
        constructed=True,
    ),
    "suspension bridge": Noun(
        "golden gate bridge, suspension bridges, golden gate; brooklyn bridge, cable stayed bridge",
        {
            "towers": "*c2452d . paint",
            "cables": "*c2452d . paint",
            "deck": "&a63a26 . paint",
            "road": "-4a4b4e",
            "lines": "-f0d24a",
            "piers": "-9a968c . stone",
        },
        Usual(300.0, STEEL, 0.05),
        constructed=True,
    ),
    "tower bridge": Noun(
        "london bridge",
        {
            "towers": "*cbbd9c . stone",
            "roofs": "+4c5a63 . metal",
            "chains": "+4f8fc4 . paint",
            "deck": "-5a5d62",
            "windows": "-3a342c",
        },
        Usual(244.0, STONE, 0.3),
        constructed=True,
    ),
    "aqueduct": Noun(
        "roman aqueduct, aquaduct; viaduct, arched bridge",
        {"arches": "*cfb98e . stone", "courses": "&b39c72 . stone", "water": "-4fa3cf . glass"},
        Usual(60.0, STONE, 0.8),
        constructed=True,
    ),
    "stadium": Noun(
        "football stadium, soccer stadium, sports stadium, arena; baseball stadium, sports arena",
        {
            "walls": "*d5d8dc . stone",
            "stands": "+c23a2e . plastic",
            "roof": "&f2f3f4 . paint",
            "ribs": "-8d949b . metal",
            "pitch": "-4c9a3a",
            "lines": "-f6f6f0",
        },
        Usual(240.0, STONE, 0.1),
        constructed=True,
    ),
    "hedge maze": Noun(
        "maze, labyrinth, garden maze, hedge labyrinth",
        {"hedges": "*3f7d34", "path": "-d8c49a", "ground": "+6ea84f"},
        Usual(30.0, PLANT, 0.3),
        constructed=True,
    ),
    "train tracks": Noun(
        "train track, railway tracks, railway track, railroad tracks, railroad track, rail "
        "tracks, rails, railroad, railway",
        {
            "rails": "*8f959c . metal",
            "sleepers": "+5f4128 . wooden",
            "bed": "-8a857c . stone",
            "spikes": "-5a4a3e . metal",
        },
        Usual(7.0, STONE, 0.5),
        constructed=True,
    ),
    "ziggurat": Noun(
        "mesopotamian temple; step pyramid, stepped pyramid, mayan pyramid, aztec pyramid, "
        "mayan temple, aztec temple, chichen itza",
        {
            "tiers": "*cda66a . stone",
            "stairs": "&b58d55 . stone",
            "temple": "+a87c48 . stone",
            "ground": "-dcc79a",
        },
        Usual(64.0, STONE, 0.9),
        constructed=True,
    ),
    "water wheel": Noun(
        "waterwheel, mill wheel",
        {
            "rims": "*7a4f2a . wooden",
            "paddles": "&946437 . wooden",
            "spokes": "&6b4424 . wooden",
            "frame": "+8f8a80 . stone",
            "water": "-6fbfe0 . glass",
        },
        Usual(5.0, WOOD, 0.6),
        constructed=True,
    ),
    "oil rig": Noun(
        "oil platform, drilling rig, offshore platform; oil derrick, oil well",
        {
            "legs": "+d9a52a . paint",
            "deck": "*c9ccd0 . paint",
            "derrick": "&b3382c . paint",
            "crane": "+f0b62a . paint",
            "pad": "-4f6b58",
            "markings": "-f4f4ee",
            "flame": "-ff9a2a",
        },
        Usual(130.0, STEEL, 0.05),
        constructed=True,
    ),
}
