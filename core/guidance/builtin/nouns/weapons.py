"""Weapons, old, new and imagined, and armour."""

from core.guidance.builtin.nouns.noun import COPPER, LEATHER, PLASTIC, STEEL, WOOD, Noun, Usual

_STEEL = "*b4bac2 . metal"
_WOOD = "+6b4424 grain"
WEAPONS = {
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
        "maces, spiked mace, morning star, morningstar; flail",
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
    "club": Noun(
        "clubs, wooden club, caveman club, spiked club, war club, bludgeon, ogre club; cudgel, "
        "truncheon, nightstick",
        {
            "wood": "*8a5a30 grain",
            "grip": "+3a2418 . leather",
            "knob": "&6e4424 grain",
            "band": "-5a5f66 . metal",
            "spikes": "-b4bac2 . metal",
        },
        Usual(0.9, WOOD, 0.13),
    ),
    "war hammer": Noun(
        "war hammers, warhammer, warhammers, battle hammer, battlehammer, great hammer, "
        "greathammer, two-handed hammer, dwarven hammer, giant hammer; thor hammer, "
        "thor's hammer, hammer of thor",
        {
            "head": "*8b93a0 . metal",
            "bands": "+d8a83c . golden",
            "emblem": "+2f7fd0 . glass",
            "spike": "&c4cad2 . metal",
            "handle": "+7a4a24 grain",
            "grip": "+4a2a1c . leather",
            "pommel": "+d8a83c . golden",
            "runes": "-8fe3fa . paint",
        },
        Usual(1.2, STEEL, 0.03),
    ),
    "scythe": Noun(
        "scythes, reaper scythe, death scythe; sickle, grim reaper scythe, war scythe",
        {
            "blade": _STEEL,
            "shaft": _WOOD,
            "collar": "&5a5f66 . metal",
            "pegs": "+4a2c1a grain",
        },
        Usual(1.7, WOOD, 0.33),
        constructed=True,
    ),
    "trident": Noun(
        "tridents, poseidon trident, poseidon's trident, neptune trident, neptune's trident; "
        "fishing spear, triton spear",
        {
            "head": "*e2b13f . golden",
            "shaft": "&1f6f7d . paint",
            "grip": "-5a3620 . leather",
            "collar": "*e2b13f . golden",
            "gem": "+22c0c8 . glass",
        },
        Usual(1.8, STEEL, 0.025),
    ),
    "katana": Noun(
        "katanas, samurai sword, ninja sword, japanese sword, samurai blade; wakizashi, "
        "nodachi, ninjato",
        {
            "blade": "*98a1ab . metal",
            "edge": "*dfe5ea . metal",
            "guard": "+c79a3e . golden",
            "grip": "+26262e . fabric",
            "lozenges": "+efe6d2 . fabric",
            "pommel": "+c79a3e . golden",
        },
        Usual(1.0, STEEL, 0.05),
    ),
    "bow": Noun(
        "longbow, long bow, archery bow, recurve bow, bow weapon, hunting bow; "
        "bow and arrow, bow and arrows, bow arrow, short bow, shortbow, compound bow, elven bow",
        {
            "limbs": "*8a5528 grain",
            "grip": "&4a2a1a . leather",
            "bands": "+e0b048 . golden",
            "string": "-f0e8d4",
            "arrow": "-c9a468 grain",
            "feathers": "-c8322a",
        },
        Usual(1.5, WOOD, 0.19),
        constructed=True,
    ),
    "quiver": Noun(
        "quivers, quiver of arrows, arrow quiver, archer's quiver, archer quiver, "
        "quiver with arrows, arrows quiver, bundle of arrows",
        {
            "body": "*8a4e26 . leather",
            "rims": "+d3a03c . golden",
            "strap": "&5c3218 . leather",
            "shafts": "+d9b27c grain",
            "feathers": "+d4382e",
            "emblem": "+d3a03c . golden",
        },
        Usual(0.8, LEATHER, 0.2),
    ),
    "crossbow": Noun(
        "crossbows, cross bow; arbalest",
        {
            "stock": "*7a4a24 grain",
            "limbs": "+4a4d52 . metal",
            "string": "-e6dcc0",
            "bolt": "+c9a86a grain",
            "point": "-9aa0a6 . metal",
            "trigger": "-3a3c40 . metal",
        },
        Usual(0.8, WOOD),
        constructed=True,
    ),
    "catapult": Noun(
        "catapults, siege catapult; mangonel, onager, siege engine",
        {
            "frame": "*8a5a2e grain",
            "wheels": "+5a3a20 grain",
            "arm": "*9c6f3e grain",
            "cup": "&6b4424 grain",
            "stone": "-86867f . stone",
            "bands": "-4a4d52 . metal",
        },
        Usual(3.5, WOOD, 0.56),
        constructed=True,
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
        Usual(1.0, STEEL, 0.098),
        constructed=True,
    ),
    "shotgun": Noun(
        "shotguns, shot gun, pump shotgun, pump action shotgun, pump-action shotgun, hunting "
        "shotgun, boomstick; double barrel shotgun, double-barreled shotgun, sawed off shotgun, "
        "sawn-off shotgun, blunderbuss",
        {
            "barrel": "+3c4148 . metal",
            "body": "+5c636c . metal",
            "stock": "*8a4f26 grain",
            "pump": "*a3642f grain",
            "pad": "-26262c . rubber",
            "shells": "+d03a2c . plastic",
        },
        Usual(1.1, STEEL, 0.055),
        constructed=True,
    ),
    "revolver": Noun(
        "six shooter, sixshooter, magnum, cowboy gun, western revolver, cowboy revolver, "
        "revolvers; peacemaker, western gun, cap gun",
        {
            "barrel": "*6d737b . metal",
            "frame": "*484d54 . metal",
            "cylinder": "*868c94 . metal",
            "grip": "+6b3c1f grain",
            "trigger": "-c9a24a . golden",
            "hammer": "&474b51 . metal",
        },
        Usual(0.28, STEEL, 0.25),
    ),
    "bullet": Noun(
        "bullets, cartridge, cartridges, rifle bullet, pistol bullet, ammo, ammunition, bullet "
        "cartridge, bullet shell, rifle cartridge, gun bullet, silver bullet; shotgun shell, "
        "artillery shell, shell casing",
        {
            "case": "*d9ab4a . golden",
            "tip": "+c4703f . copper",
            "rim": "&b98a32 . golden",
            "band": "&b98a32 . golden",
        },
        Usual(0.057, COPPER, 0.8),
    ),
    "rocket launcher": Noun(
        "rocket launchers, bazooka, bazookas, rpg launcher, missile launcher, rocket propelled "
        "grenade, shoulder launcher; grenade launcher, panzerfaust, anti-tank launcher, "
        "anti-tank weapon",
        {
            "tube": "*5f7038 . paint",
            "bands": "+30343a . metal",
            "rocket": "+c23a28 . paint",
            "stripe": "+f0d04a . paint",
            "grips": "+3a2a20 . rubber",
            "rest": "+8a5a2e grain",
            "sight": "+30343a . metal",
        },
        Usual(1.2, STEEL, 0.02),
    ),
    "grenade": Noun(
        "hand grenade, pineapple grenade, frag grenade, fragmentation grenade, grenades, "
        "handgrenade; smoke grenade, flashbang, stun grenade",
        {
            "body": "&333d20 . paint",
            "blocks": "*5c6b36 . paint",
            "head": "-8b8a7a . metal",
            "lever": "&7a8550 . paint",
            "ring": "+d8b24a . golden",
            "pin": "-b4bac0 . metal",
        },
        Usual(0.12, STEEL, 0.22),
    ),
    "dynamite": Noun(
        "dynamites, tnt, stick of dynamite, sticks of dynamite, dynamite stick, dynamite sticks, "
        "bundle of dynamite, dynamite bundle, dynamite bomb, dynamite pack; explosives, "
        "firecracker, firecrackers",
        {
            "sticks": "*cf2418",
            "ends": "&f0d9b0",
            "band": "+27262b . rubber",
            "fuses": "-d9c79a . fabric",
            "spark": "-ffb52e",
        },
        Usual(0.3, WOOD, 0.8),
    ),
    "handcuffs": Noun(
        "handcuff, hand cuffs, police handcuffs, steel handcuffs, pair of handcuffs; "
        "shackles, manacles, shackle, manacle",
        {
            "rings": "*b7bec6 . metal",
            "cheeks": "&8f979f . metal",
            "locks": "*a4abb3 . metal",
            "chain": "+767d85 . metal",
            "keyholes": "-17181b",
        },
        Usual(0.24, STEEL, 0.3),
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
    "ray gun": Noun(
        "ray guns, raygun, rayguns, blaster, blasters, laser gun, laser pistol, space gun, alien "
        "gun, retro ray gun, sci-fi gun, sci-fi pistol, sci-fi blaster, space blaster, laser "
        "blaster, ray blaster; phaser, lasers, lazers, plasma gun, plasma pistol, freeze ray, "
        "shrink ray",
        {
            "body": "*d8382e . paint",
            "barrel": "+b4bcc6 . metal",
            "rings": "+f2b632 . paint",
            "tip": "-5fe06a . glass",
            "grip": "+3a3f4e . rubber",
            "trigger": "+b4bcc6 . metal",
            "fin": "+f2b632 . paint",
            "window": "-56c8ea . glass",
        },
        Usual(0.35, PLASTIC, 0.5),
    ),
}
