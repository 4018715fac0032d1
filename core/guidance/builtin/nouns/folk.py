"""People of tales and of the town: who flies on brooms, rules, helps, haunts and howls."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

_SKIN, _EYES = "-e0ac86", "-141414"

FOLK = {
    "witch": Noun(
        "witches, wicked witch; halloween witch, sorceress, hag, enchantress",
        {
            "dress": "*5a3590 . fabric",
            "hat": "&2b2733 . fabric",
            "skin": "-8fbf5a",
            "hair": "+e27a26",
            "broom": "-b58548 . wooden",
            "eyes": _EYES,
            "glints": "-ffffff",
            "mouth": "-3d2a2c",
        },
        Usual(1.9, FLESH, 0.2),
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
    "orc": Noun(
        "orcs, ork, orks; orc warrior, half orc, orc chief, uruk hai, ogre",
        {
            "skin": "*5f9440",
            "tusks": "-f0e6c8",
            "armour": "+777c84 . metal",
            "leather": "+5e3a24 . leather",
            "club": "-8a6038 . wooden",
            "eyes": "-f0c23a",
        },
        Usual(2.0, FLESH, 0.25),
    ),
    "mummy": Noun(
        "mummies, egyptian mummy; mummified pharaoh, undead pharaoh",
        {
            "bandages": "*e6dab6 . fabric",
            "bands": "&b39c6c . fabric",
            "gap": "-2a2019",
            "eyes": "-f2c832",
            "folds": "~b8a878 . fabric",
        },
        Usual(1.75, FLESH, 0.3),
    ),
    "werewolf": Noun(
        "werewolves, wolfman, wolf man, lycan; wolf monster, gnoll",
        {
            "fur": "*5e5650",
            "muzzle": "+b5a48e",
            "trousers": "+3b4f7d . fabric",
            "claws": "-f2ead2",
            "eyes": "-f2c22e",
            "nose": "-171517",
        },
        Usual(2.1, FLESH, 0.2),
    ),
    "grim reaper": Noun(
        "reaper, the reaper, angel of death; soul reaper, ringwraith, dementor",
        {
            "robe": "*2e2c34 . fabric",
            "hood": "-0f0e12 . fabric",
            "bone": "-efe6cf",
            "eyes": "-120f10",
            "handle": "-6d4a2c . wooden",
            "blade": "-c4cad0 . metal",
        },
        Usual(2.2, FLESH, 0.12),
    ),
}
