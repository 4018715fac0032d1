"""Characters, and bodily things."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    FABRIC,
    FLESH,
    PLASTIC,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

CHARACTERS: dict[str, Noun] = {
    "goblin": Noun(
        "; hobgoblin, gremlin, kobold, bugbear, gollum",
        {
            "skin": "*6a9a3c",
            "tunic": "+6e4a2a . leather",
            "eyes": "-f4d43a",
            "pupils": "-16140f",
            "mouth": "-3a1814",
            "teeth": "-f0e8d0",
        },
        Usual(1.1, FLESH, 0.25),
    ),
    "golem": Noun(
        "rock golem; rock monster, stone giant, earth elemental",
        {
            "body": "*8d877c mottle stone",
            "head": "&9a9488 mottle stone",
            "limbs": "&837d73 mottle stone",
            "joints": "-4a4640 . stone",
            "eyes": "-58dcee",
            "moss": "-5f8a34",
        },
        Usual(2.8, STONE, 0.35),
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
    "skeleton": Noun(
        "human skeleton; lich, skeleton warrior",
        {
            "bone": "*e8dfc8",
            "chest": "-221c1a",
            "eyes": "-1a1512",
            "teeth": "-4a4238",
        },
        Usual(1.7, FLESH, 0.1),
    ),
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
    "demon": Noun(
        "devil; imp, satan, lucifer, fiend",
        {
            "skin": "*b3261e",
            "horns": "-2e2422",
            "wings": "&6e1418",
            "hooves": "+2a1c1c",
            "eyes": "-f6d030",
            "mouth": "-2a0c0c",
            "pupils": "-1a0c0c",
            "ribs": "&b3261e",
        },
        Usual(2.0, FLESH, 0.25),
    ),
    "gargoyle": Noun(
        "gargoyles, stone gargoyle, gothic gargoyle; temple guardian",
        {
            "body": "*8d8a84 . stone",
            "wings": "&85827c . stone",
            "head": "*8d8a84 . stone",
            "horns": "&7a7771 . stone",
            "base": "&6f6c66 . stone",
            "eyes": "-34322f . stone",
        },
        Usual(1.2, STONE),
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
        },
        Usual(0.4, WOOD, 0.8),
    ),
    "mech": Noun(
        (
            "battle mech, mech warrior, mecha, battle robot, war robot, combat robot, mech walker; "
            "gundam, giant robot, transformer, battlemech, war machine, fighting robot, exosuit"
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
    "yeti": Noun(
        "abominable snowman; bigfoot, sasquatch, snow monster",
        {
            "fur": "*e8eef4 . fabric",
            "face": "+6f8fb2",
            "eyes": "-14161c",
            "mouth": "-3a1c22",
            "teeth": "-f6f2e4",
        },
        Usual(2.6, FLESH, 0.35),
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
    "totem pole": Noun(
        "totem; tiki, tiki statue, tiki totem",
        {
            "wood": "*96602f grain",
            "wings": "+2a8a86",
            "bill": "-e8b42c",
            "mouth": "-b8281e",
            "eyes": "-f2ede0",
            "pupils": "-17130f",
        },
        Usual(4.0, WOOD, 0.8),
    ),
    "moai": Noun(
        (
            "easter island head, easter island statue, moai head, moai statue, easter island; "
            "stone head, tiki head"
        ),
        {
            "body": "*8c857a mottle stone",
            "eyes": "-3c3832 . stone",
            "base": "&6f695f mottle stone",
        },
        Usual(4.0, STONE, 0.9),
    ),
    "obelisk": Noun(
        "egyptian obelisk, cleopatra needle; monolith, washington monument, monument",
        {
            "body": "*c9ad82 mottle stone",
            "tip": "+e0b040 . golden",
            "base": "&b0946c mottle stone",
            "signs": "-7a5e40 . stone",
        },
        Usual(20.0, STONE),
    ),
    "mask": Noun(
        (
            "tribal mask, african mask, tiki mask, voodoo mask; face mask, "
            "theatre mask, theater mask, carnival mask, venetian mask, ritual mask"
        ),
        {
            "face": "*8a4a24 grain",
            "paint": "+f0e6d2",
            "eyes": "-17110d",
            "mouth": "-4a1712",
            "teeth": "-f4eedc",
            "feathers": "+c8402a",
        },
        Usual(0.5, WOOD, 0.4),
    ),
    "bone": Noun(
        "dog bone; dog treat, femur, dog biscuit",
        {"body": "*ece4d0"},
        Usual(0.18, CERAMIC, 0.6),
    ),
    "eyeball": Noun(
        "eye, human eye, eye ball",
        {
            "white": "*f3efe9 . plastic",
            "iris": "+3a82c4 . plastic",
            "pupil": "-0c0c10 . plastic",
            "nerve": "-c4525a",
            "glint": "-ffffff . plastic",
        },
        Usual(0.034, FLESH),
    ),
    "tooth": Noun(
        "molar, teeth, human tooth; wisdom tooth",
        {"crown": "*f6f2e8 . ceramic", "roots": "&e6d4a8"},
        Usual(0.022, CERAMIC, 0.9),
    ),
    "hand": Noun(
        "human hand, open hand; palm of hand, waving hand",
        {"skin": "*e6b08a", "cuff": "+2f5a9c . fabric", "nails": "-f3cdbb"},
        Usual(0.24, FLESH, 0.7),
    ),
    "brain": Noun(
        "human brain; cerebrum",
        {
            "folds": "*e6a0a4",
            "grooves": "-a8505c",
            "cerebellum": "&cc8088",
            "stem": "-e2b89a",
        },
        Usual(0.17, FLESH),
    ),
}
