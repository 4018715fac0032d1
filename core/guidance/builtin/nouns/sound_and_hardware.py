"""Records and what sounds; hardware, rope and pipes; bricks, a stone cross and a rainbow."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    FABRIC,
    PLASTIC,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

SOUND_AND_HARDWARE = {
    "maracas": Noun(
        "maraca, pair of maracas; rattle, rumba shaker",
        {
            "heads": "*d8262a . paint",
            "bands": "+f6c52e . paint",
            "tops": "-2f9a58 . paint",
            "handles": "-c08a4a grain",
            "knobs": "-c08a4a grain",
        },
        Usual(0.28, WOOD, 0.15),
    ),
    "gong": Noun(
        "temple gong, chinese gong; tam tam, cymbal, cymbals",
        {
            "disc": "*c98f35 . golden",
            "rim": "*a8702a . golden",
            "boss": "&e0b050 . golden",
            "ropes": "-e8dcc0",
            "frame": "+a3261f . paint",
            "feet": "-2a1c16",
        },
        Usual(1.6, COPPER, 0.025),
    ),
    "megaphone": Noun(
        "bullhorn, bull horn, loudhailer; loudspeaker horn, horn speaker, cheer megaphone",
        {
            "horn": "*f1f1ee . plastic",
            "rim": "+d02a24 . plastic",
            "body": "+d02a24 . plastic",
            "cap": "-34373b . plastic",
            "handle": "-2b2d31 . plastic",
            "trigger": "-e9b52c . plastic",
        },
        Usual(0.35, PLASTIC, 0.087),
    ),
    "cassette": Noun(
        "cassette tape, audio cassette, music cassette, mixtape, cassettes, tape cassette, "
        "compact cassette; vhs tape, vhs, video tape, videotape, vhs cassette, game cartridge",
        {
            "body": "*2b2d31",
            "label": "~f1e6c8",
            "window": "-3a3d42",
            "reels": "-f4f4f0",
            "stripe": "+e0562a",
        },
        Usual(0.1, PLASTIC, 0.4),
    ),
    "vinyl record": Noun(
        "vinyl disc, lp record, gramophone record, music record, vinyl records, vinyl album, "
        "phonograph record, lp; vinyl disk, music disc",
        {
            "disc": "*1a1a1c",
            "grooves": "~2c2c30",
            "label": "+d23a2a",
            "hole": "-d9d5cc",
        },
        Usual(0.3, PLASTIC, 0.08),
    ),
    "compact disc": Noun(
        "cd, dvd, compact disk, blu ray, cd rom, blu-ray disc, cds, dvds, dvd disc, cd disc",
        {
            "disc": "*dfe4ea . metal",
            "rays": "-b79be0 . metal",
            "hole": "-2a2c30",
            "greens": "-8fe0b0 . metal",
            "hub": "-eef1f4 . plastic",
        },
        Usual(0.12, PLASTIC, 0.14),
        "vinyl record",
    ),
    "screw": Noun(
        "wood screw; machine screw, wall screw",
        {
            "head": "*bfc4c9 . metal",
            "shaft": "*9aa0a6 . metal",
            "thread": "&b0b6bc . metal",
        },
        Usual(0.05, STEEL, 0.071),
    ),
    "pipe": Noun(
        "pipe fitting, pipeline; plumbing, drain pipe, sewer pipe, gas pipe, plumbing pipe, "
        "pvc pipe, tube",
        {
            "pipe": "*5f7f94 . paint",
            "flanges": "&4a6678 . paint",
            "bolts": "-c3c8cd . metal",
            "bands": "+d8a02a . paint",
        },
        Usual(0.5, STEEL, 0.13),
    ),
    "rope": Noun(
        "coil of rope, rope coil, coiled rope, roll of rope; jump rope, skipping rope, "
        "climbing rope, garden hose, fire hose, hose, thread",
        {
            "coil": "*c9a468",
            "strands": "*b38c50",
            "ties": "+7a5230",
            "end": "&8a5f36",
        },
        Usual(0.4, FABRIC, 0.9),
    ),
    "rake": Noun(
        "garden rake, leaf rake; hoe, pitchfork, hay fork, gardening fork, garden fork",
        {
            "tines": "+3f7f4a . paint",
            "bar": "+3f7f4a . paint",
            "socket": "&2f5f38 . paint",
            "handle": "*b98246 grain",
            "grip": "-26282b . rubber",
        },
        Usual(1.5, WOOD, 0.069),
    ),
    "brick block": Noun(
        "brick blocks, single brick, loose brick, fired brick, house brick; "
        "cinder block, breeze block, paving brick, adobe brick",
        {"brick": "*b4492f", "holes": "-5e2115"},
        Usual(0.22, CERAMIC, 0.8),
    ),
    "rainbow arch": Noun(
        "rainbow arches, rainbow arc, rainbow with clouds, rainbow in the sky",
        {
            "red": "*e6352b . plastic",
            "orange": "*f58a1f . plastic",
            "yellow": "*fbd423 . plastic",
            "green": "*3fae49 . plastic",
            "blue": "*2f6fd6 . plastic",
            "clouds": "+f7fafc . fabric",
        },
        Usual(0.5, PLASTIC, 0.5),
    ),
    "stone cross": Noun(
        "stone crosses, celtic cross, celtic crosses, gothic cross, latin cross, high cross, "
        "grave cross, cemetery cross, graveyard cross, churchyard cross, christian cross, "
        "memorial cross, wayside cross, irish cross, cross monument, cross statue; crucifix, "
        "wooden cross, golden cross, holy cross, church cross",
        {
            "cross": "*b3b3ac . stone",
            "boss": "&d0cfc6 . stone",
            "base": "&8d8f87 . stone",
        },
        Usual(1.6, STONE, 0.8),
    ),
}
