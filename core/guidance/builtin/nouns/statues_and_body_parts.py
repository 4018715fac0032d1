"""Statues and masks, and parts of the body."""

from core.guidance.builtin.nouns.noun import CERAMIC, FLESH, STONE, WOOD, Noun, Usual

STATUES_AND_BODY_PARTS = {
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
