"""Hats, masks and glasses; bags; watches, rings and medals."""

from core.guidance.builtin.nouns.noun import (
    FABRIC,
    GOLD,
    LEATHER,
    PLASTIC,
    RUBBER,
    STEEL,
    Noun,
    Usual,
)

HATS_BAGS_AND_JEWELLERY = {
    "baseball cap": Noun(
        "cap, ball cap; visor, trucker hat, trucker cap, snapback, flat cap, newsboy cap, "
        "peaked cap, police cap, police hat, deerstalker",
        {
            "cap": "*2a56a8 . fabric",
            "brim": "+c9302a . fabric",
            "button": "-c9302a",
            "badge": "-f4f2ec",
            "seams": "~1c3c7c . fabric",
            "star": "-c9302a",
        },
        Usual(0.28, FABRIC, 0.3),
    ),
    "beanie": Noun(
        "beanie hat, knitted hat, knit hat, knitted cap, bobble hat, wool hat, woolly hat, "
        "winter hat, woollen hat, woolen hat, pom pom hat, wool cap, winter cap, knit cap; "
        "toque, ski hat, watch cap, stocking cap, beret, sailor hat, sailor cap, ushanka, "
        "skullcap, skull cap",
        {
            "cap": "*24607e . fabric",
            "ribs": "*2f7496 . fabric",
            "brim": "&1d4f69 . fabric",
            "ridges": "&2a6a89 . fabric",
            "pompom": "+f7f0e2 . fabric",
        },
        Usual(0.26, FABRIC, 0.15),
    ),
    "cowboy hat": Noun(
        "stetson; sombrero, fedora, straw hat, sun hat, panama hat, sheriff hat, bucket "
        "hat, sunhat, fedora hat, trilby, safari hat, pith helmet",
        {
            "body": "*9a6a3c . fabric",
            "band": "+4a2a16",
            "buckle": "-d5d8dc . metal",
            "star": "-e8b93c . golden",
            "stitches": "~5c3a1c",
            "studs": "-d5d8dc . metal",
        },
        Usual(0.4, FABRIC, 0.2),
    ),
    "wizard hat": Noun(
        "witch hat, wizard's hat, witch's hat, magic hat; party hat, birthday hat, "
        "sorcerer hat, mage hat, halloween hat, dunce cap",
        {
            "body": "*3a2f86 . fabric",
            "ribbon": "+1f1a4a",
            "stars": "-f4cf3a",
            "buckle": "-e0b84a . golden",
        },
        Usual(0.45, FABRIC, 0.053),
    ),
    "pirate hat": Noun(
        "pirate hats, tricorn, tricorne, captain hat, tricorn hat, tricorne hat, three cornered "
        "hat, pirate captain hat, captain hook hat, tricorns; bicorne, bicorn, musketeer hat, "
        "admiral hat, colonial hat",
        {
            "crown": "*211f22 . fabric",
            "brim": "*211f22 . fabric",
            "trim": "+d9b25a . golden",
            "feather": "-f0ebe0 . fabric",
        },
        Usual(0.42, FABRIC, 0.12),
    ),
    "helmet": Noun(
        "knight helmet, knight's helmet, medieval helmet; army helmet, military helmet, "
        "roman helmet, spartan helmet, samurai helmet, diving helmet, gladiator helmet",
        {
            "shell": "*9aa1a9 . metal",
            "visor": "-17191d . glass",
            "crest": "+b8231f",
            "rim": "&6e747b . metal",
            "breaths": "-2a2d31",
        },
        Usual(0.33, PLASTIC, 0.087),
    ),
    "viking helmet": Noun(
        "horned helmet, viking helm, viking's helmet, viking hat; barbarian helmet, norse helmet",
        {
            "shell": "*8d949b . metal",
            "bands": "&b08a45 . golden",
            "horns": "-eadfc6",
            "sockets": "&b08a45 . golden",
            "rivets": "-5d6368 . metal",
        },
        Usual(0.4, STEEL, 0.05),
    ),
    "motorcycle helmet": Noun(
        "motorbike helmet, motorcyclist helmet, racing helmet, crash helmet, biker helmet; bike "
        "helmet, bicycle helmet, football helmet, space helmet, astronaut helmet, pilot helmet",
        {
            "shell": "*c22a26 . paint",
            "visor": "-1b2026 . glass",
            "trim": "-17181a . rubber",
            "stripe": "+f2efe8 . paint",
            "hinges": "-3a3d42 . metal",
            "vents": "-17181a",
        },
        Usual(0.34, PLASTIC, 0.08),
    ),
    "hard hat": Noun(
        "hardhat, construction helmet, safety helmet, construction hat, builder helmet, builder's "
        "hat, hard hats; miner helmet, mining helmet, firefighter helmet, fireman helmet, fire "
        "helmet, firefighter hat",
        {
            "shell": "*f2b81d . paint",
            "ridges": "*f2b81d . paint",
            "brim": "*eab017 . paint",
            "badge": "+f4f2ec . paint",
        },
        Usual(0.32, PLASTIC, 0.1),
    ),
    "santa hat": Noun(
        "santa claus hat, santa's hat, christmas hat, xmas hat, father christmas hat; elf hat, "
        "gnome hat, nightcap, night cap, sleeping cap",
        {"cap": "*b81d22 . fabric", "brim": "+f6f3ec . fabric", "pompom": "+f6f3ec . fabric"},
        Usual(0.34, FABRIC, 0.06),
    ),
    "chef hat": Noun(
        "chef's hat, chef cap, cook hat, cook's hat, baker hat, toque blanche, chef's cap",
        {"band": "*f4f1ea . fabric", "top": "*f8f6f1 . fabric", "pleats": "~d9d4c8 . fabric"},
        Usual(0.3, FABRIC, 0.04),
    ),
    "gas mask": Noun(
        "gasmask, respirator, gas masks, respirator mask; dust mask, hazmat mask, military gas "
        "mask, breathing mask",
        {
            "mask": "*3f4636 . rubber",
            "lenses": "-8fb8bd . glass",
            "rims": "+9a9c98 . metal",
            "filters": "&59624a . paint",
            "caps": "-2a2c2b . metal",
            "straps": "-6b5a3c . fabric",
        },
        Usual(0.35, RUBBER, 0.055),
    ),
    "goggles": Noun(
        "goggle, aviator goggles, flight goggles, flying goggles, pilot goggles, steampunk "
        "goggles, welding goggles; safety goggles, swimming goggles, swim goggles, lab goggles, "
        "ski goggles, snow goggles, motorcycle goggles, night vision goggles",
        {
            "cups": "*6b3f22 . leather",
            "rims": "+c79a3e . golden",
            "lenses": "-3f6f6a . glass",
            "strap": "&5a3820 . leather",
            "bridge": "&c79a3e . golden",
        },
        Usual(0.19, LEATHER, 0.2),
    ),
    "sunglasses": Noun(
        "shades, sun glasses; glasses, spectacles, eyeglasses, eye glasses, aviators, reading "
        "glasses, 3d glasses",
        {"frame": "*1f1f22", "glasses": "-2d3b46 . glass", "arms": "&1f1f22"},
        Usual(0.16, PLASTIC, 0.16),
    ),
    "backpack": Noun(
        "rucksack, school bag, schoolbag, knapsack, back pack; schoolbag bag",
        {
            "body": "*2f6f9e . fabric",
            "pocket": "&265a82 . fabric",
            "flap": "+e0a52e . fabric",
            "straps": "-33363c . fabric",
            "handle": "-33363c . fabric",
            "buckles": "-c7cacf . metal",
            "badge": "-f4f1e8 . fabric",
            "zips": "-c7cacf . metal",
        },
        Usual(0.5, FABRIC, 0.12),
    ),
    "handbag": Noun(
        "purse, hand bag, bag; tote bag, clutch, wallet, satchel, messenger bag, shoulder bag",
        {
            "body": "*a8452e",
            "flap": "&8c3725",
            "handle": "+5a2a1c",
            "clasp": "-e0b84a . golden",
            "piping": "-e0b84a . golden",
            "quilting": "~7a2e1c",
        },
        Usual(0.32, LEATHER, 0.2),
    ),
    "suitcase": Noun(
        "travel case, luggage, trolley case; carry on, travel bag, travel trunk",
        {
            "body": "*a5683a",
            "bands": "+4a2c18",
            "handle": "-2c2420",
            "feet": "-26221f",
            "locks": "-d8b04a . golden",
            "stickers": "-e8d9a8",
            "seam": "-3a2213 . leather",
        },
        Usual(0.7, LEATHER, 0.081),
    ),
    "briefcase": Noun(
        "briefcases, brief case, attache case, attaché case, attache, business briefcase; "
        "lawyer briefcase, document case, laptop case",
        {
            "body": "*6b3f22 . leather",
            "seam": "&4a2a17 . leather",
            "handle": "&4a2a17 . leather",
            "latches": "-e0b84a . golden",
            "corners": "+4a2a17 . leather",
            "stitches": "-d9a55c . fabric",
        },
        Usual(0.45, LEATHER, 0.15),
    ),
    "watch": Noun(
        "wristwatch, wrist watch; smartwatch, rolex",
        {
            "strap": "*5a3520",
            "case": "+d8b04a . golden",
            "face": "-f2efe6",
            "hands": "-1c1c20",
            "marks": "-1c1c20",
        },
        Usual(0.08, STEEL, 0.21),
    ),
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
    "medal": Noun(
        "medallion; badge, rosette",
        {
            "medal": "*e8b93c . golden",
            "ribbon": "+2450a0 . fabric",
            "stripe": "-f2f0ea . fabric",
            "star": "&c8922a . golden",
            "rim": "&c8922a . golden",
            "beads": "&c8922a . golden",
            "edges": "-f2f0ea . fabric",
        },
        Usual(0.14, GOLD, 0.043),
    ),
}
