"""Animals of legends, of the north and of the home."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

_EYES = "-14100e"

MENAGERIE = {
    "phoenix": Noun(
        "phoenixes, fire bird, firebird; baby phoenix",
        {
            "body": "*c92a1c",
            "wings": "&e2581e",
            "tail": "&d83a1c",
            "tips": "+f8b62c",
            "bill": "-8a4a1c",
            "eyes": "-1a120c",
            "glints": "-ffffff",
            "feathers": "~a3341a",
        },
        Usual(1.2, FLESH, 0.04),
    ),
    "pegasus": Noun(
        "winged horse, flying horse, pegasi; baby pegasus",
        {
            "body": "*f4f1ec",
            "wings": "&dfe3ec",
            "feathers": "&f3f1ee",
            "mane": "+e6c46a",
            "hooves": "-a8803c",
            "eyes": "-1c2c4a",
        },
        Usual(2.6, FLESH, 0.3),
    ),
    "hamster": Noun(
        "hamsters; gerbil, guinea pig, baby hamster",
        {
            "body": "*e0a35a",
            "belly": "+fbf1e0",
            "feet": "+f0a8a0",
            "seed": "-4a3a2c",
            "eyes": _EYES,
            "nose": "-d9747a",
        },
        Usual(0.12, FLESH, 0.6),
    ),
    "otter": Noun(
        "otters, river otter; sea otter, mink, weasel, baby otter",
        {
            "body": "*6b4a33",
            "chest": "+e2c9a2",
            "feet": "&48311f",
            "eyes": _EYES,
            "nose": "-201a1a",
        },
        Usual(0.9, FLESH, 0.2),
    ),
    "moose": Noun(
        "bull moose; moose calf",
        {
            "body": "*5b3d2a",
            "antlers": "-d9bd8c",
            "muzzle": "&7d5a40",
            "legs": "+a38a70",
            "hooves": "-231b17",
            "eyes": _EYES,
        },
        Usual(2.8, FLESH, 0.3),
    ),
    "walrus": Noun(
        "walruses; walrus calf, baby walrus",
        {
            "body": "*8c6048",
            "muzzle": "+d8b090",
            "tusks": "-f4eedc",
            "fins": "&6b4636",
            "eyes": _EYES,
            "nose": "-2a1c1a",
        },
        Usual(3.0, FLESH, 0.3),
    ),
    "toucan": Noun(
        "toucans, toco toucan; hornbill, toucanet",
        {
            "body": "*1f1e23",
            "throat": "+f6f1e2",
            "bill": "+f2861c",
            "tip": "-17151a",
            "skin": "-3f86c8",
            "eyes": "-0e0b0c",
        },
        Usual(0.55, FLESH, 0.05),
    ),
    "pug": Noun(
        "pugs, pug dog, pug puppy; french bulldog, bulldog, boston terrier, pekingese",
        {
            "body": "*dbb686",
            "mask": "-3a2f2c",
            "ears": "+2b2322",
            "folds": "&b08a5e",
            "eyes": "-0f0b0a",
            "nose": "-141112",
        },
        Usual(0.45, FLESH, 0.6),
    ),
    "poodle": Noun(
        "poodles, french poodle; poodle puppy, bichon, bichon frise, labradoodle",
        {
            "pompoms": "*f6f1ea",
            "body": "&e2bfae",
            "collar": "+c8283c . leather",
            "eyes": _EYES,
            "nose": "-191517",
        },
        Usual(0.6, FLESH, 0.3),
    ),
}
