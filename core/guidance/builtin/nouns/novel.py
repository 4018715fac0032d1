"""Two clocks, an electric guitar, a house in a mushroom, a caterpillar, a pin for a map."""

from core.guidance.builtin.nouns.noun import FLESH, PLASTIC, STEEL, STONE, WOOD, Noun, Usual

NOVEL_INSTRUMENTS = {
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
        Usual(1.0, WOOD, 0.15),
    ),
}
NOVEL_HOMES = {
    "mushroom house": Noun(
        "mushroom houses, toadstool house, mushroom home, mushroom cottage; fairy house, "
        "gnome house, smurf house, pixie house, mushroom hut, toadstool cottage",
        {
            "stem": "&f1e6cc",
            "cap": "*c9241c",
            "dots": "+f8f4ea",
            "door": "-8a5228",
            "windows": "-ffd98a . glass",
            "chimney": "-8f5a48",
        },
        Usual(3.0, STONE, 0.15),
    ),
}
NOVEL_ANIMALS = {
    "caterpillar": Noun(
        "caterpillars; inchworm, larva, grub, maggot, silkworm, millipede",
        {
            "body": "*5aa935",
            "rings": "&9bd94f",
            "head": "+f0cf3c",
            "eyes": "-141414",
            "antennae": "+e2542f",
            "feet": "+e2542f",
        },
        Usual(0.05, FLESH, 0.6),
    ),
}
NOVEL_SMALL = {
    "map pin": Noun(
        "map pins, location pin, location marker, map marker, location icon, gps pin, place pin, "
        "pin icon, google maps pin, map pointer; geotag, drop pin, push pin, pushpin, thumbtack",
        {"body": "*e0322b . plastic", "disc": "+f7f5f0 . plastic", "star": "-e0322b"},
        Usual(0.3, PLASTIC, 0.3),
    ),
    "pocket watch": Noun(
        "pocket watches, pocketwatch, fob watch, watch on a chain; stopwatch, stop watch, "
        "pocket clock",
        {
            "case": "*d8a838 . golden",
            "face": "-f6f1e2",
            "hands": "-1c1c20",
            "rim": "&b98828 . golden",
            "crown": "&c8962e . golden",
            "chain": "+c9a550 . golden",
            "marks": "-1c1c20",
        },
        Usual(0.07, STEEL, 0.3),
    ),
}
NOVEL_CLOCKS = {
    "alarm clock": Noun(
        "alarm clocks, alarmclock, twin bell clock, bell clock, bedside clock; table clock, "
        "desk clock",
        {
            "body": "*d23a30 . paint",
            "face": "-f6f2e6",
            "hands": "-1a1a1c",
            "bells": "+dcb048 . golden",
            "rim": "&8f201b . paint",
            "feet": "-c9a043 . golden",
            "handle": "-c9a043 . golden",
            "marks": "-1a1a1c",
        },
        Usual(0.16, STEEL, 0.1),
    ),
}
