"""A brood: farm birds and beasts, creatures of water and branch, breakfast, a fern, a willow."""

from core.guidance.builtin.nouns.noun import FLESH, PLANT, WOOD, Noun, Usual

_EYES = "-14100e"

BROOD = {
    "goose": Noun(
        "geese, farm goose, domestic goose; gander, gosling, canada goose, snow goose",
        {
            "body": "*f4f0e8",
            "wings": "&d9d6cc",
            "bill": "+f08a1e",
            "feet": "+e87a18",
            "eyes": _EYES,
            "feathers": "~a29e90",
            "glints": "-ffffff",
        },
        Usual(0.9, FLESH, 0.08),
    ),
    "bull": Noun(
        "bulls, angry bull, raging bull, spanish bull; ox, oxen, bullock, longhorn, buffalo, "
        "bison, yak",
        {
            "body": "*74401f",
            "muzzle": "+d8a888",
            "horns": "-f0e4c8",
            "ring": "-e8b23a . golden",
            "hair": "&3a2118",
            "hooves": "-2b2320",
            "eyes": _EYES,
        },
        Usual(2.4, FLESH, 0.75),
    ),
    "turkey": Noun(
        "turkeys, turkey bird, wild turkey, live turkey, tom turkey; gobbler, grouse",
        {
            "body": "*4f3222",
            "wings": "&7a4e2e",
            "tail": "&a4572a",
            "tips": "+f0dcb2",
            "head": "-8fb0c8",
            "wattle": "-d2261e",
            "bill": "-eaa83a",
            "eyes": _EYES,
        },
        Usual(1.0, FLESH, 0.07),
    ),
    "donkey": Noun(
        "donkeys, burro, gray donkey; mule, mules, baby donkey, foal donkey",
        {
            "body": "*8b8a90",
            "mane": "+38343a",
            "muzzle": "+ebe3d6",
            "hooves": "-2f2b2c",
            "nostrils": "-4a4044",
            "eyes": _EYES,
            "glints": "-ffffff",
            "ears": "-d8b0a6",
        },
        Usual(1.6, FLESH, 0.6),
    ),
}
ODDITIES = {
    "orca": Noun(
        "orcas, killer whale, killer whales, orca whale; baby orca",
        {
            "body": "*292a32",
            "belly": "+f4f0e8",
            "patches": "+f4f0e8",
            "eyes": "-14100e",
        },
        Usual(6.0, FLESH, 0.3),
    ),
    "beetle": Noun(
        "beetles, stag beetle, stag beetles; scarab, scarabs, scarab beetle, rhinoceros beetle, "
        "hercules beetle, dung beetle, bug",
        {
            "shell": "*1f9a68 . plastic",
            "seam": "&14583f",
            "head": "+b8722e . plastic",
            "jaws": "-6e2a1c",
            "legs": "-3a2620",
            "eyes": "-16120f",
        },
        Usual(0.06, FLESH, 0.4),
    ),
    "chameleon": Noun(
        "chameleons, veiled chameleon, panther chameleon; baby chameleon",
        {
            "body": "*62b83a",
            "crest": "+f0c03c",
            "stripes": "+2a8f86",
            "eyes": "-f0b848",
            "pupils": "-14100e",
            "branch": "-7a5030",
        },
        Usual(0.4, FLESH, 0.07),
    ),
    "axolotl": Noun(
        "axolotls, mexican axolotl, baby axolotl; mudpuppy",
        {
            "body": "*f6b4c0",
            "fin": "&f9d3d6",
            "gills": "+e0466e",
            "mouth": "-a03a54",
            "cheeks": "-ef7f98",
            "eyes": _EYES,
        },
        Usual(0.25, FLESH, 0.5),
    ),
    "pufferfish": Noun(
        "puffer fish, blowfish, blow fish, puffer, fugu, balloonfish; porcupinefish, porcupine "
        "fish",
        {
            "body": "*e9b23a",
            "belly": "&f5ead0",
            "spikes": "+9a5a24",
            "fins": "&e07a28",
            "mouth": "+e58674",
            "whites": "-f4f0e8",
            "eyes": _EYES,
        },
        Usual(0.3, FLESH, 0.3),
    ),
}
LARDER_FOOD = {
    "muffin": Noun(
        "muffins, blueberry muffin, blueberry muffins; chocolate chip muffin, chocolate muffin, "
        "banana muffin",
        {
            "top": "*dd9a48",
            "cup": "+f6e3b8",
            "berries": "+3a3f86",
        },
        Usual(0.09, 500.0),
    ),
    "bacon": Noun(
        "bacon strip, bacon strips, strip of bacon, strips of bacon, rasher, rashers, bacon "
        "rasher, bacon rashers, slice of bacon, bacon slice, crispy bacon; pancetta, turkey bacon",
        {"meat": "*a83224", "fat": "+f3d0a6"},
        Usual(0.22, FLESH, 0.4),
    ),
}
LARDER_VEGETABLES = {
    "chili pepper": Noun(
        "chili, chilli, chile, chilies, chillies, chilli pepper, chile pepper, hot pepper, red "
        "chili, chili peppers, red chili pepper, red hot chili pepper; jalapeno, cayenne, cayenne "
        "pepper, tabasco pepper, habanero",
        {"body": "*d41f1c", "cap": "+4f9a34", "stem": "+3d7a2a"},
        Usual(0.12, PLANT, 0.4),
    ),
}
LARDER_PLANTS = {
    "fern": Noun(
        "ferns, fern plant, forest fern, bracken, fern fronds; fern leaf, maidenhair fern",
        {"fronds": "*3f9a38", "ribs": "&8fc24e", "soil": "-4a3222"},
        Usual(0.8, PLANT, 0.1),
    ),
    "willow tree": Noun(
        "willow, willows, weeping willow, willow trees, weeping willow tree",
        {"leaves": "*7fa83e", "strands": "&a4c455", "trunk": "+6a4a30"},
        Usual(9.0, WOOD, 0.01),
    ),
}
