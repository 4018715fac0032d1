"""People of stories and of the screen; and a ring for a finger."""

from core.guidance.builtin.nouns.noun import FLESH, GOLD, Noun, Usual

_SKIN, _EYES = "-e0ac86", "-141414"

PEOPLE = {
    "astronaut": Noun(
        "spaceman, cosmonaut, spacewoman, space suit, spacesuit; taikonaut, space explorer, "
        "space marine, hazmat suit, diving suit, deep sea diver, wetsuit",
        {
            "suit": "*e8e8e4",
            "visor": "-d9a441 . golden",
            "pack": "&b9bdc2",
            "boots": "+6f757c",
            "panel": "+3a6fb0",
            "collar": "&9aa0a6 . metal",
            "glare": "-fff4d8",
            "buttons": "-e04030",
        },
        Usual(1.8, FLESH, 0.3),
    ),
    "pirate": Noun(
        "buccaneer, corsair, pirate captain; captain hook, sea captain, privateer",
        {
            "coat": "*8f2420 . fabric",
            "hat": "+23211f . fabric",
            "skin": _SKIN,
            "beard": "-3a2418",
            "boots": "-3b2a1e . leather",
            "patch": "-16161a",
            "skull": "-f2eee4",
            "buttons": "-e0b040 . golden",
        },
        Usual(1.8, FLESH, 0.3),
    ),
    "zombie": Noun(
        "the undead, walking dead; ghoul, frankenstein",
        {
            "skin": "*7fa066",
            "shirt": "+8a4a3c . fabric",
            "trousers": "-3d4656 . fabric",
            "hair": "-2e2a22",
            "eyes": "-f2efd8",
            "mouth": "-3a1416",
            "pupils": "-1c1718",
            "stitches": "-2e3a26",
        },
        Usual(1.75, FLESH, 0.3),
    ),
    "ninja": Noun(
        "ninjas, shinobi; assassin, rogue, thief, burglar",
        {
            "suit": "*26272d . fabric",
            "skin": _SKIN,
            "eyes": _EYES,
            "sash": "+b3262a . fabric",
            "sword": "-4a3626",
            "hilt": "-c9a24a",
            "glints": "-ffffff",
            "folds": "+4a4c58 . fabric",
        },
        Usual(1.75, FLESH, 0.3),
    ),
    "vampire": Noun(
        "dracula, count dracula; nosferatu",
        {
            "cape": "*221c26 . fabric",
            "vest": "+9c1f26 . fabric",
            "skin": "-e3dcd2",
            "hair": "-17151a",
            "fangs": "-f6f4ee",
            "eyes": "-8e1616",
            "pupils": "-140808",
            "buttons": "-e0b03a . golden",
        },
        Usual(1.8, FLESH, 0.3),
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
    "superhero": Noun(
        "super hero, hero, caped crusader; heroine, superheroine, superman, batman, spiderman, "
        "supergirl, wonder woman, captain america",
        {
            "suit": "*2452a6",
            "cape": "+c0262a . fabric",
            "skin": _SKIN,
            "hair": "-2a1d16",
            "trim": "&d8a92c",
            "eyes": _EYES,
            "mouth": "-8a3a36",
            "star": "-c0262a",
        },
        Usual(1.9, FLESH, 0.3),
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
    "clown": Noun(
        "circus clown; jester, mime, harlequin, joker",
        {
            "suit": "*e6b32c . fabric",
            "ruff": "+f2f2ee . fabric",
            "skin": "-f0d8c6",
            "hair": "-d9541e",
            "nose": "+cc2027",
            "eyes": _EYES,
            "mouth": "-c8202a",
            "dots": "+3a7ac0 . fabric",
        },
        Usual(1.75, FLESH, 0.3),
    ),
    "samurai": Noun(
        "samurais, samurai warrior; shogun, ronin, samurai armor, samurai armour, daimyo",
        {
            "armour": "*a3241f . paint",
            "helmet": "&2b2a30 . paint",
            "crest": "+e0b03a . golden",
            "clothes": "-2a2e44 . fabric",
            "skin": _SKIN,
            "katana": "-ccd1d6 . metal",
            "laces": "~6e1512",
        },
        Usual(1.8, FLESH, 0.2),
    ),
    "viking": Noun(
        "vikings, viking warrior, norseman; barbarian, norse warrior, berserker",
        {
            "tunic": "*3f648c . fabric",
            "fur": "+5f432c",
            "helmet": "-a9aeb4 . metal",
            "horns": "-eadfc4",
            "beard": "-b5602a",
            "skin": _SKIN,
            "quarters": "+e8e0cc",
        },
        Usual(1.85, FLESH, 0.17),
    ),
    "princess": Noun(
        "princesses; cinderella, rapunzel",
        {
            "dress": "*e37fb0 . fabric",
            "trim": "+f8e6ee . fabric",
            "skin": _SKIN,
            "hair": "-6e3f20",
            "crown": "-ecbd45 . golden",
            "eyes": _EYES,
            "glints": "-ffffff",
            "mouth": "-b8484e",
        },
        Usual(1.65, FLESH, 0.09),
    ),
    "chef": Noun(
        "chefs, cook, master chef; baker, pizza chef, pastry chef",
        {
            "coat": "*f1f0ec",
            "hat": "&f6f5f1",
            "apron": "+b5302b . fabric",
            "skin": _SKIN,
            "hair": "-2e1f17",
            "trousers": "-3b3f48 . fabric",
            "pocket": "~8f2420 . fabric",
            "pleats": "~cfcdc6",
        },
        Usual(1.8, FLESH, 0.27),
    ),
    "soldier": Noun(
        "soldiers, infantryman; trooper, stormtrooper, storm trooper, marine, army man, commando, "
        "army soldier",
        {
            "uniform": "*66703f . fabric",
            "helmet": "&4a5430 . paint",
            "pack": "+7d6a45 . fabric",
            "boots": "-2c231d . leather",
            "skin": _SKIN,
            "rifle": "-26272a . metal",
            "patches": "~3d4526 . fabric",
            "mouth": "-a8524a",
        },
        Usual(1.8, FLESH, 0.14),
    ),
    "cowboy": Noun(
        "cowboys, gunslinger; cowgirl, sheriff, rancher, outlaw",
        {
            "shirt": "*c9ab78 . fabric",
            "vest": "+5b3823 . leather",
            "hat": "+8f6237",
            "scarf": "+b82c2a . fabric",
            "jeans": "-33527e . fabric",
            "skin": _SKIN,
            "mouth": "-8a3a36",
            "star": "-e8c04a . golden",
        },
        Usual(1.85, FLESH, 0.16),
    ),
}
JEWELLERY = {
    "ring": Noun(
        "finger ring, diamond ring, engagement ring; wedding ring, signet ring, magic ring, gold "
        "ring",
        {
            "band": "*e0b04a . golden",
            "setting": "&e0b04a . golden",
            "gem": "-7fd0e8 . glass",
            "stones": "-eaf6fb . glass",
            "grooves": "~9c7424",
        },
        Usual(0.028, GOLD, 0.25),
    ),
}
