"""Reptiles, insects and a scorpion."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

REPTILES_AND_INSECTS = {
    "crocodile": Noun(
        "alligator, gator; caiman, baby crocodile",
        {
            "body": "*5c7d34",
            "belly": "+d8cf94",
            "crest": "&3f5a24",
            "teeth": "-f6f2e2",
            "eyes": "-f0c42c",
            "pupils": "-16120e",
            "grooves": "~3f5a24",
        },
        Usual(4.0, FLESH, 0.295),
    ),
    "lizard": Noun(
        "; gecko, geckos, iguana, salamander, newt, skink, komodo dragon, monitor lizard, bearded "
        "dragon",
        {
            "body": "*58a83a",
            "belly": "+e9e08e",
            "crest": "+e8862a",
            "feet": "&3f8a36",
            "eyes": "-f2c230",
            "pupils": "-111111",
            "spots": "~2a6a1e",
            "glints": "-ffffff",
        },
        Usual(0.3, FLESH, 0.2),
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
    "scorpion": Noun(
        "; emperor scorpion",
        {
            "body": "*a5521f",
            "claws": "&bc6526",
            "legs": "&8a431a",
            "tail": "&a5521f",
            "tip": "-2c1c16",
            "eyes": "-111111",
        },
        Usual(0.12, FLESH, 0.2),
    ),
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
    "ant": Noun(
        "; fire ant, queen ant, termite",
        {
            "body": "*a8482a",
            "legs": "&6e2c1a",
            "antennae": "&6e2c1a",
            "jaws": "-2a1612",
            "eyes": "-111111",
            "glints": "-ffffff",
            "bands": "~6e2c1a",
        },
        Usual(0.02, FLESH, 0.2),
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
    "ladybug": Noun(
        "lady bug, ladybird, lady bird, ladybird beetle",
        {
            "shell": "*d3231e",
            "patches": "+1a1618",
            "head": "+1f1b1d",
            "legs": "-1f1b1d",
            "eyes": "-f4f2ec",
        },
        Usual(0.02, FLESH, 0.4),
    ),
    "dragonfly": Noun(
        "dragon fly, dragonflies; damselfly, damselflies",
        {
            "body": "*2a8f8c",
            "stripes": "+1c3f56",
            "wings": "+c8e6f0",
            "legs": "-22303a",
            "eyes": "-c2402e",
        },
        Usual(0.08, FLESH, 0.043),
    ),
}
