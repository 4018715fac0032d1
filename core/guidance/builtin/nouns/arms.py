"""Arms, and things of fantasy."""

from core.guidance.builtin.nouns.noun import (
    COPPER,
    GOLD,
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
        Usual(2.0, WOOD, 0.026),
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
        Usual(2.1, WOOD, 0.026),
    ),
    "mace": Noun(
        "maces, spiked mace, morning star, morningstar; flail, spiked club, warhammer, war hammer, "
        "cudgel",
        {
            "head": "*5a5f66 . metal",
            "spikes": "+b4bac2 . metal",
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
        "rifles; sniper rifle, assault rifle, hunting rifle, shotgun, musket, machine gun, "
        "machinegun, submachine gun, carbine, sniper, ak47, ak 47",
        {
            "barrel": "+33363a . metal",
            "body": "+45484d . metal",
            "stock": "*7a4a24 grain",
            "magazine": "+2b2d30 . metal",
            "scope": "+232528 . metal",
            "trigger": "-202225 . metal",
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
        "plate armor, plate armour, knight armor, knight armour, bulletproof vest",
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
        "crystals, crystal cluster, cluster of crystals, crystal formation; quartz, amethyst, "
        "mana crystal, magic crystal, geode, mineral, minerals, ore, crystal shard, crystal shards",
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
        "ingots, gold bar, gold ingot, gold bars, bar of gold, bullion, gold bullion; silver bar, "
        "silver ingot, iron ingot, metal bar, metal ingot",
        {"bar": "*f0bf3e . golden", "stamp": "&d8a230 . golden"},
        Usual(0.2, GOLD, 0.53),
    ),
}
