"""Sundries: a wine glass, arms and charms, a rainbow, a slime and a chest that bites."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    FLESH,
    GLASS,
    PLASTIC,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

SUNDRY_WARE = {
    "wine glass": Noun(
        "wineglass, wine glasses, glass of wine, glass of red wine, glass of white wine, red wine "
        "glass, wine goblet, crystal wine glass, glasses of wine; champagne flute, champagne "
        "glass, glass of champagne, cocktail, martini, martini glass, cocktail glass, brandy "
        "glass",
        {
            "bowl": "-d8e8ec . glass",
            "liquid": "*9c1230",
            "stem": "-d8e8ec . glass",
            "foot": "-d8e8ec . glass",
        },
        Usual(0.21, GLASS, 0.2),
    ),
    "mop": Noun(
        "mops, floor mop, string mop, cleaning mop, wet mop; dust mop",
        {
            "handle": "+b98648 grain",
            "clamp": "+2f6fb8 . plastic",
            "strands": "*f1ede2 . fabric",
            "cap": "+2f6fb8 . plastic",
        },
        Usual(1.4, WOOD, 0.15),
    ),
}
SUNDRY_ARMS = {
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
    "magic wand": Noun(
        "magic wands, wand, wands, fairy wand, star wand, wizard wand, witch wand, magician wand, "
        "crystal wand, magical wand, enchanted wand, princess wand",
        {
            "shaft": "*4a2a6a . paint",
            "grip": "&37204f . leather",
            "bands": "+e8b93c . golden",
            "tip": "+ffd54a . plastic",
        },
        Usual(0.35, WOOD, 0.5),
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
    "crystal ball": Noun(
        "crystal balls, fortune teller ball, fortune teller's ball, magic crystal ball, fortune "
        "ball, scrying ball, seer's ball, magic orb, crystal orb, glowing orb, palantir, fortune "
        "telling ball; magic ball, scrying orb",
        {
            "ball": "*8a6be8 . glass",
            "stand": "+5b3420 grain",
            "claws": "+e0b03a . golden",
            "bands": "+e0b03a . golden",
            "glints": "-ffffff . plastic",
        },
        Usual(0.25, GLASS, 0.9),
    ),
}
SUNDRY_SMALL = {
    "stone cross": Noun(
        "stone crosses, celtic cross, celtic crosses, gothic cross, latin cross, high cross, "
        "grave cross, cemetery cross, graveyard cross, churchyard cross, christian cross, "
        "memorial cross, wayside cross, irish cross, cross monument, cross statue; crucifix, "
        "wooden cross, golden cross, holy cross, church cross",
        {
            "cross": "*b3b3ac . stone",
            "boss": "&d0cfc6 . stone",
            "base": "&8d8f87 . stone",
        },
        Usual(1.6, STONE, 0.8),
    ),
    "brick block": Noun(
        "brick blocks, single brick, loose brick, fired brick, house brick; "
        "cinder block, breeze block, paving brick, adobe brick",
        {"brick": "*b4492f", "holes": "-5e2115"},
        Usual(0.22, CERAMIC, 0.8),
    ),
    "rainbow arch": Noun(
        "rainbow arches, rainbow arc, rainbow with clouds, rainbow in the sky",
        {
            "red": "*e6352b . plastic",
            "orange": "*f58a1f . plastic",
            "yellow": "*fbd423 . plastic",
            "green": "*3fae49 . plastic",
            "blue": "*2f6fd6 . plastic",
            "clouds": "+f7fafc . fabric",
        },
        Usual(0.5, PLASTIC, 0.5),
    ),
}
SUNDRY_MONSTERS = {
    "slime": Noun(
        "slimes, slime monster, jelly monster, slime creature, jelly "
        "slime, blob monster, slime blob, game slime, rpg slime; ooze, goo monster, "
        "gelatinous cube, slime king",
        {
            "body": "*4fc23a . plastic",
            "drips": "*3aa62c . plastic",
            "eyes": "-fbfbf6",
            "pupils": "-14161a",
            "mouth": "-1d3a18",
            "glints": "-ffffff . plastic",
        },
        Usual(0.6, FLESH, 1.0),
    ),
    "mimic": Noun(
        "mimics, mimic chest, chest mimic, treasure chest mimic, treasure mimic, chest monster, "
        "monster chest, treasure chest monster, living chest, haunted chest; cursed chest",
        {
            "body": "*7a4a24 grain",
            "bands": "+d0a038 . golden",
            "teeth": "-f4ecd4",
            "tongue": "-d8426a",
            "eyes": "-fbf3c8",
            "mouth": "-43101c",
        },
        Usual(1.0, WOOD, 0.3),
    ),
}
