"""A house with flat roofs, a spiral staircase, a gate of bars, a bed with four posts."""

from core.guidance.builtin.nouns.noun import FABRIC, STEEL, STONE, Noun, Usual
from core.guidance.builtin.nouns.vehicles import GLASS_LOOK

RESIDENCE_BUILDINGS = {
    "modern house": Noun(
        "modern villa, contemporary house, flat roof house, flat roofed house, modernist house, "
        "bauhaus house; villa, modern mansion",
        {
            "walls": "*eeebe4 . paint",
            "roof": "+4a4d50",
            "windows": GLASS_LOOK,
            "frames": "-26282b . metal",
            "door": "-8a5a34 grain",
            "garage": "&a8794a grain",
            "mullions": "-26282b . metal",
            "slats": "-6e4f2c",
        },
        Usual(14.0, STONE, 0.15),
    ),
    "spiral staircase": Noun(
        "spiral stairs, spiral stair, winding stairs, winding staircase, helical staircase; "
        "spiral stairway, spiral steps",
        {
            "treads": "*9a6a3c grain",
            "pole": "+2b2d30 . metal",
            "posts": "+2b2d30 . metal",
            "rail": "+2b2d30 . metal",
        },
        Usual(3.2, STEEL, 0.07),
    ),
    "gate": Noun(
        "iron gate, garden gate, wrought iron gate, metal gate, gates, driveway gate, "
        "front gate; "
        "entrance gate, cemetery gate, graveyard gate, mansion gate, park gate",
        {
            "bars": "*26282b . metal",
            "tips": "-c9963f . golden",
            "piers": "+a89f90 . stone",
            "caps": "+cfc6b4 . stone",
            "plaque": "-c9963f . golden",
            "joints": "~7a7266",
        },
        Usual(3.6, STONE, 0.6),
    ),
}
RESIDENCE_FURNITURE = {
    "four-poster bed": Noun(
        "four poster bed, fourposter bed, canopy bed, poster bed, 4 poster bed, princess bed; "
        "royal bed",
        {
            "frame": "*5f3a20 grain",
            "mattress": "-efe9de . fabric",
            "blanket": "+7a2436 . fabric",
            "pillow": "-f4f0e6 . fabric",
            "canopy": "+8a2c40 . fabric",
            "curtains": "+8a2c40 . fabric",
            "trim": "-d9ad45 . golden",
            "quilting": "~5a1a2a . fabric",
        },
        Usual(2.2, FABRIC, 0.2),
    ),
}
