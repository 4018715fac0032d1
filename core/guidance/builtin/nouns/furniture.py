"""Furniture."""

from core.guidance.builtin.nouns.noun import FABRIC, STEEL, WOOD, Noun, Usual

FURNITURE = {
    "table": Noun(
        "",
        {"top": "*8f5c30 grain", "legs": "&754a26 grain"},
        Usual(1.4, WOOD),
    ),
    "chair": Noun(
        "dining chair",
        {
            "seat": "&8f5c30 grain",
            "back": "*8f5c30 grain",
            "legs": "*754a26 grain",
            "arms": "*754a26 grain",
        },
        Usual(0.9, WOOD),
    ),
    "armchair": Noun(
        "; recliner",
        {"cushion": "&9e523d", "back": "*8a4230", "arms": "*8a4230"},
        Usual(1.0, FABRIC, 0.4),
    ),
    "sofa": Noun(
        "couch, settee; loveseat",
        {
            "cushion": "&7a8fa3 . fabric",
            "back": "*5f7891 . fabric",
            "arms": "*5f7891 . fabric",
            "base": "*54697f . fabric",
            "feet": "-4a2f1c",
        },
        Usual(2.0, FABRIC, 0.3),
    ),
    "stool": Noun(
        "; bar stool, barstool",
        {"seat": "&a06a38 grain", "legs": "*70472a grain"},
        Usual(0.6, WOOD),
    ),
    "bench": Noun(
        "park bench",
        {"seat": "*8f5c30 grain", "legs": "+3a3d40", "back": "*8f5c30 grain"},
        Usual(1.5, WOOD),
    ),
    "bed": Noun(
        "",
        {
            "blanket": "*3f6ea8",
            "mattress": "-ebe6dc",
            "pillow": "+f2efe8",
            "frame": "-7c4f2b grain",
        },
        Usual(2.1, FABRIC, 0.3),
    ),
    "bookshelf": Noun(
        "bookcase, bookshelves, book shelf",
        {"frame": "*8a5a30 grain", "books": "+b03a30 spines"},
        Usual(1.9, WOOD, 0.5),
    ),
    "lamp": Noun(
        "table lamp; lampshade",
        {"shade": "*eddbad", "pole": "-ffc757 . golden", "foot": "+403329"},
        Usual(0.5, STEEL, 0.02),
    ),
}
