"""Things of the stage, of film, music and sewing, put together from simple solids."""

from core.guidance.builtin.nouns.noun import (
    COPPER,
    FABRIC,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

STAGE_AND_STUDIO: dict[str, Noun] = {
    "clapperboard": Noun(
        "clapper board, film slate, movie clapper, clapper, film clapper, movie slate, "
        "clapperboards, clapboard",
        {
            "board": "*22252a . plastic",
            "stripes": "+f4f4f0",
            "lines": "-e8e8e2",
            "hinge": "-b9bfc6 . metal",
        },
        Usual(0.3, WOOD, 0.8),
        constructed=True,
    ),
    "film reel": Noun(
        "movie reel, reel of film, film roll, film reels, cinema reel, film strip",
        {"reel": "*b3b9c0 . metal", "film": "-1c1c1f . plastic", "frames": "-c9b48a"},
        Usual(0.35, STEEL, 0.4),
        constructed=True,
    ),
    "spotlight": Noun(
        "stage light, spot light, stage lamp, studio light, film light, spotlights, "
        "floodlight, stage lights",
        {
            "body": "*2c3035 . metal",
            "lens": "-fff0b0",
            "barn doors": "&1f2226 . metal",
            "stand": "&3f444a . metal",
        },
        Usual(1.5, STEEL, 0.01),
        constructed=True,
    ),
    "tripod": Noun(
        "camera tripod, tripods, camera stand; monopod",
        {
            "legs": "*2c3035 . metal",
            "column": "&3f444a . metal",
            "head": "&26292e . plastic",
            "joints": "+8d949b . metal",
            "feet": "-1c1c1e . rubber",
        },
        Usual(1.5, STEEL, 0.018),
        constructed=True,
    ),
    "theatre stage": Noun(
        "stage, theater stage, puppet theatre, puppet theater, stage with curtains, theatre, "
        "theater, concert stage",
        {
            "floor": "&a8713f . wooden",
            "frame": "+c9973e . golden",
            "curtains": "*b3202c . fabric",
            "backdrop": "&6b1420 . fabric",
            "fringe": "-e0b84a . golden",
            "footlights": "-ffe6a0",
        },
        Usual(8.0, WOOD, 0.15),
        constructed=True,
    ),
    "podium": Noun(
        "winners podium, winner podium, victory podium, podiums, olympic podium, awards "
        "podium; pedestal podium",
        {
            "blocks": "*f2f2ee . paint",
            "tops": "+2f5fa8 . paint",
            "numbers": "-c9973e . golden",
            "base": "-4a4f55 . paint",
        },
        Usual(2.4, WOOD, 0.2),
        constructed=True,
    ),
    "lectern": Noun(
        "pulpit, speaker stand, lecterns, speech podium, rostrum",
        {
            "body": "*7a4a24 grain",
            "panel": "&5f381a grain",
            "emblem": "+d8a83c . golden",
            "papers": "-f6f4ea",
            "microphone": "-1f2124 . metal",
        },
        Usual(1.3, WOOD, 0.4),
        constructed=True,
    ),
    "palette": Noun(
        "paint palette, artist palette, painters palette, painter palette, palettes, color palette",
        {
            "board": "*c9975a . wooden",
            "brush": "-7a4a2a . wooden",
            "first paint": "-d8281e . plastic",
            "second paint": "-f4cc2a . plastic",
            "third paint": "-2f62c8 . plastic",
            "fourth paint": "-3f9a45 . plastic",
            "fifth paint": "-f6f6f2 . plastic",
        },
        Usual(0.35, WOOD),
        constructed=True,
    ),
    "metronome": Noun(
        "metronomes",
        {
            "case": "*7a3f1e grain",
            "base": "&5a2c14 grain",
            "pendulum": "-c3c8cd . metal",
            "scale": "-f2ead2",
            "marks": "-22201c",
        },
        Usual(0.23, WOOD, 0.5),
        constructed=True,
    ),
    "director chair": Noun(
        "directors chair, director's chair, film director chair, movie director chair; "
        "camping chair, folding chair",
        {
            "cloth": "*23262c . fabric",
            "frame": "+b5834a . wooden",
            "star": "-f2c63a",
            "bolts": "-9aa1a8 . metal",
        },
        Usual(0.95, WOOD, 0.5),
        constructed=True,
    ),
    "jackbox": Noun(
        "jack box, clown box, surprise box, pop up clown",
        {
            "box": "*2f62c8 . paint",
            "trim": "+f2c22e . paint",
            "stars": "-f2c22e . paint",
            "spring": "-b3b9c0 . metal",
            "face": "-f2c9a0",
            "suit": "+7a3fc0 . fabric",
            "nose": "-d8281e",
            "eyes": "-14100e",
        },
        Usual(0.35, WOOD, 0.4),
        constructed=True,
    ),
    "portal": Noun(
        "magic portal, stone portal, dimensional portal, stargate, teleporter, portals, warp "
        "gate; nether portal, teleport pad",
        {
            "frame": "*6b6f78 . stone",
            "surface": "-5a2fb0 . glass",
            "swirl": "+b07af0",
            "glow": "-7fe0f0",
        },
        Usual(3.0, STONE, 0.8),
        constructed=True,
    ),
    "cello": Noun(
        "cellos, violoncello; double bass, upright bass, contrabass, viola da gamba",
        {
            "body": "*9c4a1e . paint",
            "neck": "-2a1a12 . wooden",
            "strings": "-d8d4c8",
            "pegs": "-1f1510 . wooden",
            "sound holes": "-1c100a",
            "spike": "-8d949b . metal",
            "bow": "+7a4526 . wooden",
        },
        Usual(1.2, WOOD, 0.27),
        constructed=True,
    ),
    "tuba": Noun(
        "tubas, euphonium, sousaphone, baritone horn",
        {
            "body": "*e0b03c . golden",
            "valves": "&c8962a . golden",
            "buttons": "-f2efe6",
            "mouthpiece": "+c3c8cd . metal",
        },
        Usual(1.0, COPPER, 0.032),
        constructed=True,
    ),
    "french horn": Noun(
        "french horns, horn instrument, hunting horn, brass horn",
        {
            "body": "*e0b03c . golden",
            "valves": "&c8962a . golden",
            "keys": "-f2efe6",
            "mouthpiece": "+c3c8cd . metal",
        },
        Usual(0.6, COPPER, 0.085),
        constructed=True,
    ),
    "tambourine": Noun(
        "tambourines, timbrel",
        {
            "frame": "*c0873e . wooden",
            "skin": "-f2e8d4",
            "jingles": "+e0b84a . golden",
            "tacks": "-c79a3e . golden",
        },
        Usual(0.25, WOOD, 0.5),
        constructed=True,
    ),
    "musical triangle": Noun(
        "triangle instrument, triangle percussion, triangle musical instrument, music triangle",
        {"bar": "*b9bfc6 . metal", "beater": "&9aa1a8 . metal", "cord": "+b3202c . fabric"},
        Usual(0.25, STEEL),
        constructed=True,
    ),
    "tuning fork": Noun(
        "tuning forks",
        {"fork": "*b9bfc6 . metal", "box": "+a8713f . wooden"},
        Usual(0.2, STEEL, 0.5),
        constructed=True,
    ),
    "castanets": Noun(
        "castanet, pair of castanets",
        {"wood": "*8a3f1e . wooden", "cord": "+d8352c . fabric"},
        Usual(0.2, WOOD),
        constructed=True,
    ),
    "bongos": Noun(
        "bongo, bongo drums, bongo drum, pair of bongos; congas, conga drums",
        {
            "shells": "*a8532a . wooden",
            "skins": "-f2e8d4",
            "hoops": "+c3c8cd . metal",
            "rods": "-9aa1a8 . metal",
        },
        Usual(0.42, WOOD, 0.3),
        constructed=True,
    ),
    "spool of thread": Noun(
        "thread spool, reel of thread, cotton reel, bobbin, thread reel, sewing thread, "
        "spool, spools of thread",
        {
            "spool": "+c9975a . wooden",
            "thread": "*c92a3e . fabric",
            "hole": "-3a2414",
            "needle": "-b9bfc6 . metal",
        },
        Usual(0.06, WOOD, 0.8),
        constructed=True,
    ),
    "ball of yarn": Noun(
        "yarn ball, ball of wool, wool ball, balls of yarn, skein of yarn, knitting yarn",
        {"yarn": "*c94a6e . fabric", "needles": "+c9975a . wooden", "knobs": "-7a3f8f"},
        Usual(0.16, FABRIC, 0.6),
        constructed=True,
    ),
    "thimble": Noun(
        "thimbles, sewing thimble",
        {"body": "*b9bfc6 . metal", "dots": "&8d949b . metal", "band": "+d8a83c . golden"},
        Usual(0.022, STEEL, 0.5),
        constructed=True,
    ),
    "sewing needle": Noun(
        "needle, needle and thread, sewing needles, needles, darning needle",
        {"needle": "*b9bfc6 . metal", "thread": "+c92a3e . fabric"},
        Usual(0.06, STEEL),
        constructed=True,
    ),
    "ribbon": Noun(
        "ribbon bow, bow ribbon, gift bow, ribbons, satin bow",
        {"loops": "*d8283e . fabric", "tails": "&b81f34 . fabric", "knot": "&c4243a . fabric"},
        Usual(0.15, FABRIC, 0.3),
        constructed=True,
    ),
    "knot": Noun(
        "rope knot, trefoil knot, knots, celtic knot, tied knot; sailor knot, overhand knot",
        {"core": "&9c7a45 . fabric", "strands": "*c9a56a . fabric"},
        Usual(0.25, FABRIC),
        constructed=True,
    ),
    "rosary": Noun(
        "rosary beads, rosaries, prayer beads, prayer beads necklace; mala, mala beads",
        {
            "beads": "*6b2f22 . wooden",
            "large beads": "+d8a83c . golden",
            "chain": "-c79a3e . golden",
            "cross": "+d8a83c . golden",
        },
        Usual(0.35, WOOD),
        constructed=True,
    ),
}
