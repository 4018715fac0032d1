"""Household."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    FABRIC,
    GLASS,
    GOLD,
    STEEL,
    STONE,
    WAX,
    WOOD,
    Noun,
    Usual,
)

HOUSEHOLD = {
    "mug": Noun(
        "cup, coffee cup, coffee mug; teacup, beer mug",
        {"body": "*e0dbd1", "handle": "&e0dbd1"},
        Usual(0.1, CERAMIC, 0.4),
    ),
    "vase": Noun(
        "; urn",
        {"body": "*b8613d band"},
        Usual(0.3, CERAMIC, 0.3),
    ),
    "bottle": Noun(
        "; flask",
        {"body": "*1f6638 . glass", "cap": "+332b26"},
        Usual(0.3, GLASS, 0.25),
    ),
    "teapot": Noun(
        "tea pot",
        {"body": "*3c7fb0", "spout": "*3c7fb0", "handle": "&3c7fb0", "lid": "&e8e4da"},
        Usual(0.25, CERAMIC, 0.2),
    ),
    "bowl": Noun(
        "",
        {"body": "*d8d2c4", "foot": "&b9a98c"},
        Usual(0.16, CERAMIC, 0.5),
    ),
    "pan": Noun(
        "frying pan, skillet; saucepan, wok",
        {"body": "*33353a . metal", "handle": "+1c1a19"},
        Usual(0.45, STEEL, 0.3),
    ),
    "goblet": Noun(
        "chalice; wine glass, wineglass",
        {"cup": "*e0b84a . golden", "stem": "&c9a03c . golden"},
        Usual(0.18, STEEL, 0.15),
    ),
    "bucket": Noun(
        "pail",
        {"body": "*8f979e . metal", "handle": "+5c6268 . metal"},
        Usual(0.3, STEEL, 0.01),
    ),
    "candle": Noun(
        "; candlestick",
        {"wax": "*f0e6cc", "flame": "-ff9a1e", "holder": "+c79a3e . golden"},
        Usual(0.2, WAX),
    ),
    "crown": Noun(
        "; tiara",
        {"band": "*ffc757 . golden", "pearls": "+f4efe6", "gems": "-c21d2b"},
        Usual(0.2, GOLD, 0.05),
    ),
    "hat": Noun(
        "top hat",
        {"body": "*1c1c20", "ribbon": "+a01822"},
        Usual(0.3, FABRIC, 0.15),
    ),
    "bell": Noun(
        "church bell",
        {"body": "*e0ab48 . golden", "loop": "&b98530 . golden", "clapper": "-5a5a5e . metal"},
        Usual(0.4, COPPER, 0.25),
    ),
    "bust": Noun(
        "head bust, statue head",
        {"body": "*dcd6ca . stone", "hair": "&c2b9a8 . stone", "base": "-6e6961 . stone"},
        Usual(0.5, STONE),
    ),
    "trophy": Noun(
        "trophies",
        {"cup": "*ffc94f . golden", "handles": "&ffc94f . golden", "base": "-2a211c"},
        Usual(0.4, STEEL, 0.1),
    ),
    "bowling pin": Noun(
        "skittle, pin",
        {"body": "*f2f0ea collar"},
        Usual(0.38, WOOD),
    ),
}
