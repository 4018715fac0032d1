"""Tables, shelves and cabinets; lamps, a mirror, a fireplace, a clock and pianos."""

from core.guidance.builtin.nouns.noun import STEEL, STONE, WOOD, Noun, Usual

TABLES_CABINETS_AND_LAMPS = {
    "table": Noun(
        "dining table, dinner table; kitchen table, altar, farmhouse table",
        {"top": "*8f5c30 grain", "legs": "&754a26 grain", "seams": "~5e3a1c grain"},
        Usual(1.4, WOOD, 0.24),
    ),
    "desk": Noun(
        "writing desk, office desk, computer desk; school desk, vanity, vanity table, "
        "drafting table",
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
    "coffee table": Noun(
        "low table; side table, tea table",
        {
            "top": "*96602f grain",
            "legs": "*70472a grain",
            "shelf": "&85552b grain",
            "seams": "~6a4220 grain",
        },
        Usual(1.1, WOOD, 0.29),
    ),
    "picnic table": Noun(
        "picnic tables, picnic bench, picnic benches, park table, garden table with benches, "
        "table with benches, beer garden table, outdoor table; camping "
        "table, trestle table, beer table",
        {
            "top": "*c58a4c grain",
            "benches": "*b87a3e grain",
            "legs": "&7c4e28 grain",
        },
        Usual(1.8, WOOD, 0.5),
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
    "shelf": Noun(
        "wall shelf, shelves; spice rack, shelving unit, shelving",
        {
            "board": "*9a6534 grain",
            "brackets": "&6f4626 grain",
            "books": "-b03a30",
            "vase": "-3f86a8",
            "volumes": "-2f6b4a",
            "tomes": "-2d4f8f",
            "bands": "-e0b84a . golden",
            "stripes": "-f4efe0",
        },
        Usual(0.9, WOOD, 0.42),
    ),
    "cabinet": Noun(
        "sideboard, cupboard; credenza, kitchen cabinet, filing cabinet, shoe rack, tv stand, "
        "buffet, display case, display cabinet, vitrine",
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
    "school locker": Noun(
        "locker, lockers, school lockers, gym locker, metal locker, steel locker",
        {
            "body": "*3f6f9e . paint",
            "doors": "*4a80b4 . paint",
            "handles": "-c3c8cd . metal",
            "feet": "-2a2d31 . metal",
            "vents": "-1c2a38 . metal",
            "plate": "-e8ebee . metal",
            "number": "-1d1f23",
        },
        Usual(1.8, STEEL, 0.004),
        "wardrobe",
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
    "mirror": Noun(
        "looking glass, standing mirror; magic mirror",
        {
            "frame": "*d3a640 . golden",
            "glass": "-c6dbe6 . glass",
            "stand": "+6d4425 grain",
            "gems": "-b01f3a . glass",
            "glare": "-eef6fa . glass",
            "backing": "+6d4425 grain",
        },
        Usual(1.6, WOOD, 0.17),
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
    "grand piano": Noun(
        "grand pianos, concert piano, concert grand piano; baby grand piano, baby grand, concert "
        "grand, harpsichord, fortepiano",
        {
            "body": "*1d1b1c . paint",
            "keys": "-f6f2e8",
            "black keys": "-121212",
            "lid": "*1d1b1c . paint",
            "strings": "-d9a441 . golden",
            "legs": "&1d1b1c . paint",
        },
        Usual(1.9, WOOD, 0.5),
    ),
}
