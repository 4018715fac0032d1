"""Folk of fairy tales, and figures that resemble people."""

from core.guidance.builtin.nouns.noun import FABRIC, FLESH, PLASTIC, STEEL, WOOD, Noun, Usual

_EYES = "-141414"
_SKIN = "-e0ac86"
FAIRY_TALE_FOLK = {
    "wizard": Noun(
        (
            "mage; sorcerer, warlock, magician, enchanter, druid, "
            "merlin, gandalf, dumbledore, shaman, necromancer"
        ),
        {
            "robe": "*3a3f96 . fabric",
            "hat": "&2f3380 . fabric",
            "beard": "-e9e6df",
            "skin": "-e2b08c",
            "staff": "-7a4f2c grain",
            "eyes": "-16141a",
            "glints": "-ffffff",
            "stars": "+f0c845",
        },
        Usual(2.0, FLESH, 0.3),
    ),
    "witch": Noun(
        "witches, wicked witch; halloween witch, sorceress, hag, enchantress",
        {
            "dress": "*5a3590 . fabric",
            "hat": "&2b2733 . fabric",
            "skin": "-8fbf5a",
            "hair": "+e27a26",
            "broom": "-b58548 . wooden",
            "eyes": _EYES,
            "glints": "-ffffff",
            "mouth": "-3d2a2c",
        },
        Usual(1.9, FLESH, 0.2),
    ),
    "fairy": Noun(
        "pixie, tooth fairy; fairy godmother, sprite, nymph, tinkerbell, tinker bell",
        {
            "dress": "*e58fb8 . fabric",
            "skin": _SKIN,
            "wings": "+bfe4ee",
            "hair": "-e2b64c",
            "wand": "-e8c14a . golden",
            "eyes": _EYES,
            "glints": "-ffffff",
            "mouth": "-b8484e",
        },
        Usual(0.3, FLESH, 0.3),
    ),
    "elf": Noun(
        "christmas elf, elves, santas helper; santa's helper, wood elf, leprechaun",
        {
            "tunic": "*2f8a3c . fabric",
            "hat": "&2f8a3c . fabric",
            "skin": _SKIN,
            "trim": "+d33a2f . fabric",
            "shoes": "+8a5a32",
            "eyes": _EYES,
            "glints": "-ffffff",
            "mouth": "-a8524a",
        },
        Usual(1.2, FLESH, 0.3),
    ),
    "dwarf": Noun(
        "dwarves, dwarfs, fantasy dwarf, dwarf warrior; dwarven warrior, dwarf miner, dwarf king, "
        "dwarf smith, duergar",
        {
            "tunic": "*8e2f2a . fabric",
            "beard": "-d97a28",
            "helmet": "-9aa2aa . metal",
            "gold": "+e0b040 . golden",
            "skin": "-e3a680",
            "boots": "&4a3222 . leather",
            "handle": "-9a6c3e . wooden",
            "eyes": "-1c1718",
        },
        Usual(1.3, FLESH, 0.25),
    ),
    "gnome": Noun(
        "garden gnome, lawn gnome; tomte",
        {
            "coat": "*2f5fa8",
            "hat": "+c62f2a",
            "beard": "-eeeae2",
            "skin": "-e6b08c",
            "boots": "-4a2e1c",
            "eyes": "-161412",
        },
        Usual(0.4, PLASTIC, 0.5),
    ),
    "mermaid": Noun(
        "; merman, siren, little mermaid, sea nymph",
        {
            "tail": "*1fa08e",
            "fins": "&5cc8a8",
            "skin": "-ecb894",
            "hair": "-b8321e",
            "top": "+8a4cb4",
            "eyes": "-1a2430",
            "scales": "~14705f",
            "mouth": "-b0484e",
        },
        Usual(1.8, FLESH, 0.3),
    ),
    "angel": Noun(
        "guardian angel; cherub, archangel, seraph",
        {
            "robe": "*dfe6f2 . fabric",
            "wings": "+f6f4ee",
            "skin": "-e8b896",
            "hair": "-d9a94a",
            "halo": "-f2c23a . golden",
            "eyes": "-2a2a3a",
            "glints": "-ffffff",
            "mouth": "-b5524e",
        },
        Usual(1.8, FLESH, 0.3),
    ),
    "santa claus": Noun(
        (
            "santa, father christmas, saint nicholas, st nicholas, st nick, saint nick, "
            "kris kringle, santa clause"
        ),
        {
            "coat": "*c4201f . fabric",
            "trim": "+f2efe9 . fabric",
            "beard": "-f4f2ee",
            "skin": "-e8b090",
            "boots": "-1e1c1c . leather",
            "eyes": "-16141a",
            "buckle": "-e6b43a . golden",
            "glints": "-ffffff",
        },
        Usual(1.8, FLESH, 0.4),
    ),
    "scarecrow": Noun(
        "; straw man",
        {
            "shirt": "*b0452c . fabric",
            "sack": "+d8b680 . fabric",
            "straw": "-e2c052",
            "hat": "+6e4a2c . fabric",
            "post": "-7e5a38 grain",
            "eyes": "-241c16",
        },
        Usual(1.9, FABRIC, 0.3),
    ),
    "nutcracker": Noun(
        "nutcracker soldier; toy soldier, wooden soldier, tin soldier",
        {
            "coat": "*b91f24 . plastic",
            "hat": "-1f1c1e . plastic",
            "trousers": "+2f4f9c . plastic",
            "skin": "-eab892",
            "hair": "-f4f2ec",
            "trim": "-e0a838 . golden",
            "eyes": "-17120f",
            "moustache": "-17120f",
        },
        Usual(0.4, WOOD, 0.8),
    ),
    "centaur": Noun(
        "; centaur warrior, centaur archer, female centaur",
        {
            "coat": "*7a4a2a",
            "skin": "-d9a47c",
            "hair": "+3a241a",
            "belt": "+b8862e . golden",
            "hooves": "-2e2622",
            "eyes": "-14100e",
        },
        Usual(2.3, FLESH, 0.5),
    ),
    "mech": Noun(
        (
            "battle mech, mech warrior, mecha, battle robot, war robot, combat robot, mech walker; "
            "gundam, giant robot, transformer, battlemech, war machine, fighting robot, exosuit, "
            "mech suit"
        ),
        {
            "armour": "*d8dce2 . paint",
            "joints": "-33363c . metal",
            "chest": "+2c52a8 . paint",
            "visor": "-58e0f0",
            "crest": "-e8b42c . paint",
            "cannons": "&5c626c . metal",
        },
        Usual(8.0, STEEL, 0.1),
    ),
}
