"""People by their age, rank, time or trade, and a doll."""

from core.guidance.builtin.nouns.noun import FABRIC, FLESH, Noun, Usual

_CHILD_SKIN = "-e9b48f"
_CHILD_EYES = "-1c1718"
_SKIN = "-e0ac86"
_EYES = "-141414"
PEOPLE = {
    "girl": Noun(
        "girls, little girl, young girl; schoolgirl, school girl, daughter, teenage girl",
        {
            "dress": "*e0527e . fabric",
            "trim": "+f4ead8 . fabric",
            "skin": _CHILD_SKIN,
            "hair": "-7a4526",
            "bows": "+f2c230 . fabric",
            "shoes": "&a8304e . leather",
            "eyes": _CHILD_EYES,
            "mouth": "-b5524e",
        },
        Usual(1.2, FLESH, 0.13),
    ),
    "boy": Noun(
        "boys, little boy, young boy, child, children, kid, kids; schoolboy, school boy, son, "
        "teenager, teen",
        {
            "shirt": "*f0b62c . fabric",
            "stripe": "+f4ead8 . fabric",
            "shorts": "+3a62a8 . fabric",
            "cap": "&d0382c . fabric",
            "skin": _CHILD_SKIN,
            "hair": "-5c3520",
            "shoes": "-b03228 . rubber",
            "eyes": _CHILD_EYES,
        },
        Usual(1.2, FLESH, 0.2),
    ),
    "baby": Noun(
        "babies, infant, newborn, baby boy, baby girl; toddler, human baby",
        {
            "skin": "-f0bf9c",
            "diaper": "*f2f0ea . fabric",
            "hair": "-a8662e",
            "pacifier": "+4a9ad8 . plastic",
            "eyes": _CHILD_EYES,
            "glints": "-ffffff",
            "cheeks": "-ee9a88",
            "brows": "-a8662e",
        },
        Usual(0.6, FLESH, 0.22),
    ),
    "doll": Noun(
        "rag doll, ragdoll, baby doll, toy doll, dolls; voodoo doll, barbie, puppet, creepy "
        "doll, marionette, mannequin doll, action figure",
        {
            "dress": "*d8487a . fabric",
            "skin": "-f5d3b8 . ceramic",
            "hair": "-b8562a",
            "eyes": "-1d1a1c",
            "apron": "+fbf6ee . fabric",
            "shoes": "&a3254f . leather",
            "mouth": "-b03a3e",
            "cheeks": "-ee9a8c",
        },
        Usual(0.4, FABRIC, 0.5),
    ),
    "king": Noun(
        "monarch, emperor; old king, sultan, pharaoh",
        {
            "robe": "*a31f2a . fabric",
            "fur": "-f4f0e6 . fabric",
            "gold": "+e0b03a . golden",
            "skin": "-e2b08c",
            "beard": "-8a5a34",
            "eyes": "-16120e",
            "glints": "-ffffff",
            "spots": "-1c1a1c . fabric",
        },
        Usual(1.9, FLESH, 0.09),
    ),
    "queen": Noun(
        "queens; empress, evil queen, old queen, duchess, queen of hearts, ice queen",
        {
            "dress": "*8a1f3c . fabric",
            "trim": "+f6f0e4 . fabric",
            "gold": "-e6b43a . golden",
            "skin": _SKIN,
            "hair": "-5a3420",
            "eyes": _EYES,
            "glints": "-ffffff",
            "mouth": "-a82c34",
        },
        Usual(1.8, FLESH, 0.09),
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
    "police officer": Noun(
        "police officers, policeman, policemen, policewoman, cop, cops; security guard, constable, "
        "traffic cop",
        {
            "uniform": "*24356b . fabric",
            "cap": "&1e2c58 . fabric",
            "badge": "-ecc04a . golden",
            "skin": _SKIN,
            "belt": "-19191d . leather",
            "hair": "-4a2e1e",
            "mouth": "-a8524a",
            "pockets": "~172348 . fabric",
        },
        Usual(1.8, FLESH, 0.25),
    ),
    "firefighter": Noun(
        "firefighters, fire fighter, fireman, firemen, firewoman; fire chief, "
        "volunteer firefighter",
        {
            "coat": "*c9a05c . fabric",
            "bands": "+e6f03c . fabric",
            "helmet": "+c8201c . paint",
            "skin": _SKIN,
            "axe": "-c2c7cc . metal",
            "boots": "-26242a . rubber",
        },
        Usual(1.9, FLESH, 0.16),
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
}
