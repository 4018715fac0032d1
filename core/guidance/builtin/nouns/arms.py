"""Arms, and things of fantasy."""

from core.guidance.builtin.nouns.noun import (
    COPPER,
    FABRIC,
    GOLD,
    PLANT,
    PLASTIC,
    SNOW,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

_STEEL, _WOOD = "*b4bac2 . metal", "+6b4424 grain"
ARMS = {
    "spear": Noun(
        "spears; pike, lance, javelin, harpoon, assegai",
        {"head": _STEEL, "shaft": _WOOD, "binding": "+a8241f", "butt": "&8a8f96 . metal"},
        Usual(2.0, WOOD, 0.21),
    ),
    "halberd": Noun(
        "halberds; poleaxe, pole axe, polearm, pole arm, glaive, partisan, voulge, bardiche",
        {
            "head": _STEEL,
            "point": _STEEL,
            "socket": "+6e7379 . metal",
            "shaft": _WOOD,
            "butt": "&6e7379 . metal",
        },
        Usual(2.1, WOOD, 0.16),
    ),
    "mace": Noun(
        "maces, spiked mace, morning star, morningstar; flail, spiked club, cudgel",
        {
            "head": "*5a5f66 . metal",
            "spikes": "&b4bac2 . metal",
            "shaft": _WOOD,
            "collar": "&8a8f96 . metal",
            "grip": "-3a2418 . leather",
            "pommel": "&5a5f66 . metal",
        },
        Usual(0.75, STEEL, 0.0075),
    ),
    "scythe": Noun(
        "scythes, reaper scythe, death scythe; sickle, grim reaper scythe, war scythe",
        {
            "blade": _STEEL,
            "shaft": _WOOD,
            "collar": "&5a5f66 . metal",
            "pegs": "+4a2c1a grain",
        },
        Usual(1.7, WOOD, 0.045),
    ),
    "crossbow": Noun(
        "crossbows, cross bow; arbalest, ballista",
        {
            "stock": "*7a4a24 grain",
            "limbs": "+4a4d52 . metal",
            "string": "-e6dcc0",
            "bolt": "+c9a86a grain",
            "point": "-9aa0a6 . metal",
            "trigger": "-3a3c40 . metal",
        },
        Usual(0.8, WOOD, 0.22),
    ),
    "rifle": Noun(
        "rifles; sniper rifle, assault rifle, hunting rifle, musket, machine gun, machinegun, "
        "submachine gun, carbine, sniper, ak47, ak 47",
        {
            "barrel": "+33363a . metal",
            "body": "+45484d . metal",
            "stock": "*7a4a24 grain",
            "magazine": "+2b2d30 . metal",
            "scope": "+232528 . metal",
            "trigger": "-202225 . metal",
            "port": "-1a1b1e . metal",
            "bands": "-2a1a10 . rubber",
        },
        Usual(1.0, STEEL, 0.0105),
    ),
    "catapult": Noun(
        "catapults, siege catapult; trebuchet, mangonel, onager, siege engine",
        {
            "frame": "*8a5a2e grain",
            "wheels": "+5a3a20 grain",
            "arm": "*9c6f3e grain",
            "cup": "&6b4424 grain",
            "stone": "-86867f . stone",
            "bands": "-4a4d52 . metal",
        },
        Usual(3.5, WOOD, 0.25),
    ),
    "chestplate": Noun(
        "chest plate, breastplate, breast plate, cuirass; armor, armour, body armor, body armour, "
        "plate armor, plate armour, knight armor, knight armour, bulletproof vest, chain mail, "
        "chainmail",
        {
            "plate": _STEEL,
            "muscles": _STEEL,
            "pauldrons": "*a2a9b2 . metal",
            "belt": "+5a3a20 . leather",
            "crest": "+c79a3e . golden",
            "lining": "-2a2523",
        },
        Usual(0.6, STEEL, 0.008),
    ),
    "lightsaber": Noun(
        "light saber, lightsabre, light sabre, lightsabers, laser sword, energy sword; beam sword, "
        "plasma sword, glow stick, glowstick",
        {
            "blade": "*4fb8ff . plastic",
            "hilt": "+b0b5bb . metal",
            "grips": "-232427 . rubber",
            "emitter": "+8a8f96 . metal",
            "pommel": "+8a8f96 . metal",
            "button": "-d8241f",
        },
        Usual(1.2, STEEL, 0.005),
    ),
    "jetpack": Noun(
        "jet pack, jetpacks, jet packs, rocket pack; rocket backpack",
        {
            "tanks": "*c8ccd0 . metal",
            "noses": "+d0302a . paint",
            "pack": "+45494f . metal",
            "nozzles": "-5a5e64 . metal",
            "flames": "-ff9a1e",
            "straps": "-5a3a20 . leather",
        },
        Usual(1.1, STEEL, 0.018),
    ),
    "crystal": Noun(
        "crystals, crystal cluster, cluster of crystals, crystal formation; amethyst, mana "
        "crystal, magic crystal, geode, mineral, minerals, ore, crystal shard, crystal shards",
        {"crystals": "*8a5ae0 . glass", "shards": "&a884f0 . glass", "rock": "-5e5a5c . stone"},
        Usual(0.3, STONE),
    ),
    "compass": Noun(
        "compasses, magnetic compass, pocket compass; compass rose",
        {
            "case": "*c9983a . golden",
            "dial": "-f0e6cc",
            "needle": "-d0241f",
            "tail": "-2b3440",
            "marks": "-3a3026",
            "loop": "&c9983a . golden",
        },
        Usual(0.08, COPPER, 0.2),
    ),
    "ingot": Noun(
        "ingots, gold bar, gold bars, bar of gold, bullion, gold bullion; silver bar, metal bar",
        {"bar": "*f0bf3e . golden", "stamp": "&d8a230 . golden"},
        Usual(0.2, GOLD, 0.53),
    ),
    "brazier": Noun(
        "braziers, fire bowl, firebowl, fire basket; fire pot, fire cauldron, sacrificial fire",
        {
            "bowl": "*3a3c40 . metal",
            "rim": "&4a4d52 . metal",
            "legs": "&3a3c40 . metal",
            "embers": "-c8341a",
            "flame": "-ff8c1a",
            "tongues": "-ffc23a",
        },
        Usual(1.1, STEEL, 0.02),
    ),
    "necklace": Noun(
        "necklaces, jewelled necklace; amulet, pendant, talisman, locket, choker, pearl necklace",
        {
            "chain": "*c9983a . golden",
            "beads": "*e8b93c . golden",
            "setting": "&e8b93c . golden",
            "stone": "+b0182c . glass",
            "bail": "&c9983a . golden",
        },
        Usual(0.25, GOLD, 0.02),
    ),
    "feather": Noun(
        "feathers, bird feather; quill, quill pen, plume, eagle feather",
        {"vane": "*eceae2", "tip": "+4a3a30", "shaft": "-d8c49c", "barbs": "~c9c6b8"},
        Usual(0.25, PLANT, 0.02),
    ),
    "sack": Noun(
        "sacks, burlap sack; flour sack, money bag, moneybag, burlap bag, bag of money, bag of "
        "gold, coin bag, sack of flour, sack of potatoes, grain sack, sandbag, pouch, coin "
        "pouch, loot bag, sleeping bag, bag of chips, crisp packet, chip bag, potato bag, "
        "trash bag, garbage bag, bin bag, rubbish bag, punching bag, boxing bag, plastic bag, "
        "paper bag",
        {
            "body": "*b99563 . fabric",
            "mouth": "&b99563 . fabric",
            "rope": "-6b4a28",
            "patch": "+8a6238 . fabric",
        },
        Usual(0.8, FABRIC, 0.5),
    ),
    "coffin": Noun(
        "coffins, casket; vampire coffin",
        {
            "body": "*5a3a20 grain",
            "lid": "*6b4424 grain",
            "panel": "&7a4f2a grain",
            "cross": "+d8a83c . golden",
            "handles": "+c79a3e . golden",
            "edge": "&5a3a20 grain",
            "nails": "-d8a83c . golden",
            "seams": "~2c1b0e grain",
        },
        Usual(2.1, WOOD, 0.04),
    ),
    "anchor": Noun(
        "anchors, ship anchor, boat anchor; ship's anchor, grapnel",
        {
            "shank": "*3f474f . metal",
            "arms": "*3f474f . metal",
            "flukes": "&4c555e . metal",
            "stock": "&4c555e . metal",
            "ring": "+6a737c . metal",
        },
        Usual(1.2, STEEL, 0.1),
    ),
    "hay bale": Noun(
        "hay bales, haybale, haybales, bale of hay, straw bale, bale of straw, hay; haystack, "
        "hay stack, bale",
        {"straw": "*d8b04a thatch", "twine": "-8a4a2e", "stalks": "&e6c468", "lines": "~b08c36"},
        Usual(1.0, PLANT, 0.08),
    ),
    "beehive": Noun(
        "bee hive, beehives, bee hives, skep, hive; wasp nest, apiary, honey hive",
        {
            "coils": "*d8a03a",
            "bands": "&e8b850",
            "knob": "&d8a03a",
            "rim": "&a86f24",
            "entrance": "-2a1a0e",
            "board": "+7a4f2a grain",
        },
        Usual(0.55, PLANT, 0.1),
    ),
    "cloud": Noun(
        "clouds, fluffy cloud; rain cloud, raincloud, storm cloud, thundercloud",
        {"middle": "*f4f6f8", "puffs": "*eef1f5", "ends": "*e6ebf1"},
        Usual(2.0, SNOW, 0.01),
    ),
    "sun": Noun(
        "suns, sunshine, sun symbol; sun rays, summer sun",
        {"disc": "*ffc91f", "rays": "*f79a1a", "glints": "*ffb52a"},
        Usual(1.0, PLASTIC, 0.2),
    ),
    "leaf": Noun(
        "leaves, maple leaf, maple leaves; autumn leaf, autumn leaves, fall leaf, oak leaf",
        {"blade": "*cf4a1e", "veins": "&f0a03c", "stalk": "-8a4a22", "side veins": "~8f2d0e"},
        Usual(0.15, PLANT, 0.02),
    ),
    "snowflake": Noun(
        "snowflakes, snow flake, snow flakes, ice crystal; snow crystal",
        {"arms": "*bfe4f7 . glass", "branches": "*d6effb . glass", "middle": "&9fd4f0 . glass"},
        Usual(0.3, PLASTIC, 0.3),
    ),
}
