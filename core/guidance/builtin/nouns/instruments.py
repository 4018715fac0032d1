"""Musical instruments."""

from core.guidance.builtin.nouns.noun import COPPER, STEEL, WOOD, Noun, Usual

INSTRUMENTS = {
    "guitar": Noun(
        "",
        {
            "body": "*c4772e . paint",
            "neck": "+5c3519",
            "hole": "-1d1410",
            "bridge": "-3c2416",
            "pegs": "-e8dcc0",
            "frets": "-c9ccd0 . metal",
            "rosette": "-e8c98a",
            "pickguard": "-3c1d0e . plastic",
        },
        Usual(1.0, WOOD, 0.23),
        constructed=True,
    ),
    "electric guitar": Noun(
        "electric guitars, e-guitar, e guitar, rock guitar, lead guitar; bass guitar, "
        "electric bass, stratocaster, telecaster, les paul",
        {
            "body": "*c8231f . paint",
            "neck": "+8a5a2c",
            "pickguard": "+f3efe4 . plastic",
            "pickups": "-1b1b1e . plastic",
            "bridge": "-c4c9ce . metal",
            "knobs": "-d9b24a . golden",
            "frets": "-c9ccd0 . metal",
        },
        Usual(1.0, WOOD, 0.66),
        constructed=True,
    ),
    "banjo": Noun(
        "; mandolin, lute",
        {
            "body": "*9a5f2e grain",
            "skin": "-f2ece0",
            "neck": "+4a2c18 grain",
            "bridge": "-d3b27a",
            "pegs": "-d8d5cc",
            "frets": "-c9ccd0 . metal",
        },
        Usual(0.95, WOOD, 0.3),
    ),
    "ukulele": Noun(
        "uke",
        {
            "body": "*c98a45 grain",
            "neck": "+5c3519 grain",
            "hole": "-1d1410",
            "bridge": "-3c2416",
            "pegs": "-e6e2d8",
            "frets": "-c9ccd0 . metal",
        },
        Usual(0.55, WOOD, 0.17),
    ),
    "violin": Noun(
        "fiddle; viola, hurdy gurdy",
        {
            "body": "*b0531e grain",
            "neck": "-241a16",
            "holes": "-1d1410",
            "bridge": "-e0c08a",
            "pegs": "-241a16",
            "chinrest": "+33231b",
        },
        Usual(0.6, WOOD, 0.26),
        constructed=True,
    ),
    "harp": Noun(
        "concert harp, celtic harp; lyre, zither",
        {
            "body": "*a5622c grain",
            "neck": "*a5622c grain",
            "pillar": "+e0b04a . golden",
            "strings": "-efe6d2",
            "base": "&7d4820 grain",
            "crown": "+e0b04a . golden",
        },
        Usual(1.8, WOOD, 0.69),
        constructed=True,
    ),
    "trumpet": Noun(
        "; bugle, cornet, trombone, flugelhorn",
        {
            "body": "*e8b93c . golden",
            "valves": "&c8962a . golden",
            "buttons": "-f2efe6",
            "mouthpiece": "+c3c8cd . metal",
        },
        Usual(0.5, COPPER, 0.17),
        constructed=True,
    ),
    "saxophone": Noun(
        "sax; clarinet, oboe, bassoon",
        {"body": "*e0ab38 . golden", "keys": "&c08a24 . golden", "mouthpiece": "-1f1f22"},
        Usual(0.7, COPPER, 0.036),
        constructed=True,
    ),
    "flute": Noun(
        "concert flute, transverse flute, western flute; piccolo, fife, recorder, tin whistle, "
        "penny whistle, pan flute, ocarina, didgeridoo, kazoo",
        {
            "body": "*c9ced4 . metal",
            "keys": "+dfae45 . golden",
            "rods": "&969da5 . metal",
            "rings": "+dfae45 . golden",
            "mouthpiece": "&b3b9c0 . metal",
            "hole": "-1d1a18",
        },
        Usual(0.67, STEEL, 0.13),
    ),
    "harmonica": Noun(
        "mouth organ, mouthorgan, blues harp, french harp, mouth harp, harmonicas; "
        "chromatic harmonica, melodica",
        {
            "comb": "*a8322a . paint",
            "plates": "&c9ced4 . metal",
            "holes": "-1b1817",
            "screws": "-d8a944 . golden",
            "badge": "+d8a944 . golden",
        },
        Usual(0.1, STEEL, 0.18),
    ),
    "whistle": Noun(
        "referee whistle, referee's whistle, pea whistle, sports whistle, police whistle; "
        "coach whistle, emergency whistle, dog whistle",
        {
            "body": "*c3c8cd . metal",
            "mouthpiece": "-1f2023 . rubber",
            "sides": "+d23228 . paint",
            "pea": "-d9a766",
            "ring": "&9aa1a8 . metal",
        },
        Usual(0.05, STEEL, 0.2),
    ),
    "accordion": Noun(
        "piano accordion, squeezebox, squeeze box; concertina, bandoneon, harmonium",
        {
            "body": "*b01f2a . paint",
            "bellows": "-1f1f22",
            "folds": "+e6dcc4",
            "keys": "-f7f4ea",
            "buttons": "-f2ead8",
            "grille": "-dfb74e . golden",
        },
        Usual(0.5, WOOD, 0.3),
    ),
    "xylophone": Noun(
        "glockenspiel; marimba",
        {
            "frame": "*9a5f2e grain",
            "bars": "+d8322a . paint",
            "slats": "-2f7fc8 . paint",
            "mallet": "-c99758",
            "tip": "-f2c32a",
        },
        Usual(0.5, WOOD, 0.5),
    ),
    "drum": Noun(
        "snare drum; taiko, timpani, conga, djembe, bass drum, snare",
        {
            "shell": "*b71f24 . paint",
            "hoops": "+e0b84a . golden",
            "skin": "-f2ece0",
            "sticks": "-b98a52",
            "badge": "+f2ece0",
            "cords": "+f2ece0",
        },
        Usual(0.4, WOOD, 0.2),
    ),
    "drum kit": Noun(
        "drum set, drumkit, drumset, drums, set of drums, drum kits; trap set, percussion set",
        {
            "shells": "*b51f26 . paint",
            "skins": "-f3efe4",
            "hoops": "+c3c8cd . metal",
            "cymbals": "-e2b043 . golden",
            "stands": "-7d838a . metal",
            "badge": "+1e1f23 . paint",
            "star": "-f2c14a . golden",
            "rings": "-b51f26 . paint",
        },
        Usual(1.9, WOOD, 0.035),
    ),
}
