"""What stands in a study: an abacus, a molecule, a planet, a cassette, a record, a ruler."""

from core.guidance.builtin.nouns.noun import PLASTIC, STONE, WOOD, Noun, Usual

STUDY_SMALL = {
    "abacus": Noun(
        "abaci, abacuses, counting frame, bead frame; soroban, suanpan, bead maze",
        {
            "frame": "*9a6434 grain",
            "rods": "-c4c7ca . metal",
            "beads": "+d8322a . paint",
            "counters": "-f0b429 . paint",
            "pearls": "-2f6fc0 . paint",
        },
        Usual(0.3, WOOD, 0.5),
    ),
    "molecule": Noun(
        "molecules, water molecule, molecule model, molecular model, methane molecule, h2o, "
        "h2o molecule; atom, chemical compound, dna, protein, atoms",
        {
            "core": "*d42a24",
            "atoms": "+f2f2ee",
            "bonds": "-9a9da1",
        },
        Usual(0.2, PLASTIC, 0.3),
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
        "phonograph record, lp; cd, dvd, compact disc, compact disk, vinyl disk, blu ray, "
        "cd rom, music disc",
        {
            "disc": "*1a1a1c",
            "grooves": "~2c2c30",
            "label": "+d23a2a",
            "hole": "-d9d5cc",
        },
        Usual(0.3, PLASTIC, 0.08),
    ),
    "ruler": Noun(
        "rulers, wooden ruler, school ruler, straightedge, straight edge, "
        "measuring stick; yardstick, meter stick, metre stick",
        {"body": "*e0b56a grain", "marks": "-2a2622"},
        Usual(0.3, WOOD, 0.5),
    ),
}
STUDY_SPACE = {
    "planet": Noun(
        "saturn, ringed planet, gas giant, planets, planet saturn, alien planet; uranus, "
        "exoplanet, "
        "fantasy planet",
        {
            "globe": "*d9b27a",
            "bands": "~b98a52",
            "rings": "+e6d3a6",
        },
        Usual(0.5, STONE, 0.3),
    ),
}
