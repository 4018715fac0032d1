"""Furniture."""

from core.guidance.builtin.nouns.noun import FABRIC, PLASTIC, STEEL, STONE, WOOD, Noun, Usual

FURNITURE = {
    "table": Noun(
        "dining table, dinner table; kitchen table, altar, farmhouse table",
        {"top": "*8f5c30 grain", "legs": "&754a26 grain", "seams": "~5e3a1c grain"},
        Usual(1.4, WOOD, 0.24),
    ),
    "chair": Noun(
        "dining chair",
        {
            "seat": "&8f5c30 grain",
            "back": "*8f5c30 grain",
            "legs": "*754a26 grain",
            "arms": "*754a26 grain",
        },
        Usual(0.9, WOOD, 0.27),
    ),
    "armchair": Noun(
        "; recliner, easy chair, club chair, wing chair, wingback chair, lounge chair, egg "
        "chair, accent chair, reading chair",
        {
            "cushion": "&9e523d",
            "back": "*8a4230",
            "arms": "*8a4230",
            "legs": "-4a2f1c grain",
            "buttons": "~5f2a1d . fabric",
            "piping": "~5f2a1d . fabric",
        },
        Usual(1.0, FABRIC, 0.4),
    ),
    "sofa": Noun(
        "couch, settee; loveseat, sectional, futon, divan, chaise longue, chaise lounge, day "
        "bed, daybed",
        {
            "cushion": "&7a8fa3 . fabric",
            "back": "*5f7891 . fabric",
            "arms": "*5f7891 . fabric",
            "base": "*54697f . fabric",
            "feet": "-4a2f1c",
            "buttons": "~44586c . fabric",
            "piping": "~44586c . fabric",
        },
        Usual(2.0, FABRIC, 0.3),
    ),
    "stool": Noun(
        "; bar stool, barstool",
        {"seat": "&a06a38 grain", "legs": "*70472a grain"},
        Usual(0.6, WOOD, 0.21),
    ),
    "bench": Noun(
        "park bench; pew, church pew",
        {
            "seat": "*8f5c30 grain",
            "legs": "+3a3d40",
            "back": "*8f5c30 grain",
            "bolts": "-3a3d40 . metal",
            "seams": "~5a371a grain",
        },
        Usual(1.5, WOOD, 0.33),
    ),
    "bed": Noun(
        "; mattress, gurney, stretcher, hospital bed",
        {
            "blanket": "+3f6ea8",
            "mattress": "-ebe6dc",
            "pillow": "+f2efe8",
            "frame": "*7c4f2b grain",
            "stripes": "-eef0f2 . fabric",
            "panels": "~633d1f grain",
        },
        Usual(2.1, FABRIC, 0.3),
    ),
    "bookshelf": Noun(
        "bookcase, bookshelves, book shelf; book case, library shelf",
        {
            "frame": "*8a5a30 grain",
            "books": "-b03a30",
            "volumes": "-2f6a4a",
            "tomes": "-2b4a86",
            "bands": "-e3c56a . golden",
            "labels": "-e9dcb8",
            "stripes": "-d9a94a . golden",
        },
        Usual(1.9, WOOD, 0.12),
    ),
    "lamp": Noun(
        "table lamp; lampshade, night light",
        {
            "shade": "*eddbad",
            "pole": "-ffc757 . golden",
            "foot": "+403329",
            "bands": "+c99a4a . fabric",
            "pleats": "~c9b07c . fabric",
        },
        Usual(0.5, STEEL, 0.02),
    ),
    "desk": Noun(
        "writing desk, office desk, computer desk; workbench, school desk, vanity, vanity "
        "table, drafting table",
        {
            "top": "*a06a38 grain",
            "body": "*8f5c30 grain",
            "drawers": "&a9733f grain",
            "handles": "+d0b060 . golden",
            "blotter": "-2c5a48 . leather",
            "border": "-d0b060 . golden",
        },
        Usual(1.4, WOOD, 0.2),
    ),
    "office chair": Noun(
        "swivel chair, desk chair, computer chair",
        {
            "seat": "*2f3b4a . fabric",
            "back": "*2f3b4a . fabric",
            "base": "+8a9096 . metal",
            "wheels": "-1c1c1e . rubber",
            "arms": "-26282b",
            "seams": "~6d8096 . fabric",
        },
        Usual(1.1, PLASTIC, 0.15),
    ),
    "rocking chair": Noun(
        "rocker",
        {
            "seat": "*9a6534 grain",
            "back": "*8a582c grain",
            "legs": "*754a26 grain",
            "rockers": "&6a4222 grain",
            "arms": "*754a26 grain",
        },
        Usual(1.1, WOOD, 0.3),
    ),
    "throne": Noun(
        "royal chair, king's chair",
        {
            "cushion": "*a5161f . fabric",
            "frame": "+d9a93c . golden",
            "knobs": "-f0c95a . golden",
            "step": "-7a1620",
        },
        Usual(1.8, WOOD, 0.21),
    ),
    "wardrobe": Noun(
        "closet, armoire, clothes cupboard; linen cupboard, armoir",
        {
            "body": "*84532b grain",
            "doors": "*9a6636 grain",
            "handles": "+d0b060 . golden",
            "feet": "&5c3a1e grain",
            "top": "*7a4b26 grain",
            "panels": "~5a3818 grain",
        },
        Usual(2.0, WOOD, 0.06),
    ),
    "dresser": Noun(
        "chest of drawers, drawers; bureau, tallboy",
        {
            "body": "*8a572c grain",
            "drawers": "*a06c3a grain",
            "handles": "+d0b060 . golden",
            "legs": "&5c3a1e grain",
            "top": "*7f4f28 grain",
            "panels": "~6e4620 grain",
        },
        Usual(1.1, WOOD, 0.25),
    ),
    "nightstand": Noun(
        "night stand, bedside table, night table; end table",
        {
            "body": "*8f5f35 grain",
            "drawers": "*a87542 grain",
            "handles": "+d8d4c8 . metal",
            "legs": "&5f3d20 grain",
            "top": "*835530 grain",
            "panels": "~744a24 grain",
        },
        Usual(0.6, WOOD, 0.25),
    ),
    "bunk bed": Noun(
        "bunk beds, bunkbed; loft bed",
        {
            "blanket": "+c23b34",
            "mattress": "-ebe6dc",
            "pillow": "+f2efe8",
            "frame": "*a8733e grain",
            "ladder": "&dcae6a grain",
            "rungs": "~7d5428 grain",
        },
        Usual(2.0, WOOD, 0.065),
    ),
    "coffee table": Noun(
        "low table; side table, tea table",
        {"top": "*96602f grain", "legs": "*70472a grain", "shelf": "&85552b grain"},
        Usual(1.1, WOOD, 0.29),
    ),
    "cabinet": Noun(
        "sideboard, cupboard; credenza, kitchen cabinet, filing cabinet, shoe rack, tv stand, "
        "buffet, locker, school locker, display case, display cabinet, vitrine",
        {
            "body": "*7f5029 grain",
            "doors": "*a06c3a grain",
            "handles": "+d8c48a . golden",
            "legs": "&5a391e grain",
            "top": "*75481f grain",
            "panels": "~5a3818 grain",
        },
        Usual(1.3, WOOD, 0.11),
    ),
    "mirror": Noun(
        "looking glass, standing mirror; magic mirror",
        {"frame": "*d3a640 . golden", "glass": "-c6dbe6 . glass", "stand": "+6d4425 grain"},
        Usual(1.6, WOOD, 0.17),
    ),
    "floor lamp": Noun(
        "standing lamp, standard lamp",
        {"shade": "*f0dfb4", "pole": "-3c3a38 . metal", "foot": "+2f2b28"},
        Usual(1.6, STEEL, 0.01),
    ),
    "fireplace": Noun(
        "hearth, chimneypiece; open fire",
        {
            "body": "*9c4a36",
            "mantel": "+6d4425 grain",
            "fire": "-ff8a1a",
            "logs": "-4a2f1c",
            "hearth": "-7b7873 . stone",
            "mortar": "-cdb8a4 . stone",
        },
        Usual(1.5, STONE),
    ),
    "piano": Noun(
        "upright piano; pianoforte, synthesizer",
        {
            "body": "*1d1b1c . paint",
            "keys": "-f6f2e8",
            "black keys": "-121212",
            "legs": "&1d1b1c . paint",
            "lid": "&1d1b1c . paint",
            "panels": "-c99a3c . golden",
        },
        Usual(1.5, WOOD, 0.4),
    ),
    "ottoman": Noun(
        "footstool, pouf, pouffe; hassock",
        {
            "cushion": "*2f7f7a . fabric",
            "base": "*2a716d . fabric",
            "feet": "-4a2f1c grain",
            "button": "+e0b84a . golden",
        },
        Usual(0.6, FABRIC, 0.5),
    ),
    "crib": Noun(
        "cot, baby bed; cradle, playpen, bassinet",
        {"frame": "*efe9dc", "mattress": "-dfe6ea", "pillow": "+f6f3ec", "blanket": "+8fb7d8"},
        Usual(1.3, WOOD, 0.15),
    ),
    "grandfather clock": Noun(
        "longcase clock, pendulum clock; cuckoo clock",
        {
            "body": "*6f4222 grain",
            "face": "+f2e8cc",
            "hands": "-1a1614",
            "glass": "-2a1a10",
            "pendulum": "-e0b84a . golden",
            "marks": "-1a1614",
        },
        Usual(2.1, WOOD, 0.1),
    ),
    "beanbag": Noun(
        "bean bag, beanbag chair, bean bag chair",
        {"body": "*d0542f . fabric", "loop": "&b34425 . fabric"},
        Usual(0.9, FABRIC, 0.1),
    ),
    "shelf": Noun(
        "wall shelf, shelves; spice rack, shelving unit, shelving",
        {
            "board": "*9a6534 grain",
            "brackets": "&6f4626 grain",
            "books": "-b03a30",
            "vase": "-3f86a8",
        },
        Usual(0.9, WOOD, 0.42),
    ),
    "pillow": Noun(
        "cushion, throw pillow; sofa cushion",
        {
            "body": "*c9545e . fabric",
            "button": "+e8c24a . fabric",
            "tassels": "+e8c24a . fabric",
            "border": "+e8c24a . fabric",
        },
        Usual(0.5, FABRIC, 0.19),
    ),
}
