"""Engines of war and of justice, put together from simple solids."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual

ENGINES_OF_WAR: dict[str, Noun] = {
    "trebuchet": Noun(
        "trebuchets; counterweight catapult",
        {
            "frame": "*8a5a2e grain",
            "arm": "&9c6f3e grain",
            "counterweight": "+6b4424 grain",
            "wheels": "&5a3a20 grain",
            "iron": "-4a4d52 . metal",
            "sling": "-c9b48a . fabric",
            "stone": "-86867f . stone",
        },
        Usual(8.0, WOOD, 0.25),
        constructed=True,
    ),
    "ballista": Noun(
        "ballistas, ballistae; scorpion siege engine, giant crossbow",
        {
            "frame": "*8a5a2e grain",
            "limbs": "&6b4424 grain",
            "ropes": "-d8c79e . fabric",
            "bolt": "+c9a86a grain",
            "iron": "-4a4d52 . metal",
        },
        Usual(2.5, WOOD, 0.3),
        constructed=True,
    ),
    "siege tower": Noun(
        "siege towers; assault tower",
        {
            "timber": "*8a5a2e grain",
            "ramp": "&9c6f3e grain",
            "hides": "+7a3a2c . leather",
            "wheels": "&5a3a20 grain",
            "iron": "-4a4d52 . metal",
            "banner": "+b3202e . fabric",
        },
        Usual(12.0, WOOD, 0.25),
        constructed=True,
    ),
    "battering ram": Noun(
        "battering rams, siege ram",
        {
            "frame": "*8a5a2e grain",
            "roof": "+6b4424 grain",
            "ram": "&7a4f2a grain",
            "head": "-4a4d52 . metal",
            "chains": "-7d838a . metal",
            "wheels": "&5a3a20 grain",
        },
        Usual(4.5, WOOD, 0.3),
        constructed=True,
    ),
    "chariot": Noun(
        "chariots, roman chariot, war chariot, egyptian chariot, greek chariot",
        {
            "body": "*a3261f . paint",
            "trim": "+d8a83c . golden",
            "wheels": "&7a4a24 grain",
            "pole": "-5a381c grain",
        },
        Usual(2.6, WOOD, 0.51),
        constructed=True,
    ),
    "guillotine": Noun(
        "guillotines",
        {
            "frame": "*7a4a2a grain",
            "blade": "-b9bfc6 . metal",
            "weight": "-4a4d52 . metal",
            "rope": "-d8c79e . fabric",
            "basket": "+b58d55 . fabric",
            "platform": "&5f3a20 grain",
        },
        Usual(3.5, WOOD, 0.6),
        constructed=True,
    ),
    "gallows": Noun(
        "hanging gallows, noose; gibbet, hangman",
        {
            "posts": "*6b4a2c grain",
            "deck": "&8a6238 grain",
            "steps": "&7a5430 grain",
            "rope": "-d8c79e . fabric",
        },
        Usual(4.0, WOOD, 0.5),
        constructed=True,
    ),
    "stocks": Noun(
        "pillory, medieval stocks",
        {"boards": "*9c6f3e grain", "posts": "&6b4a2c grain", "iron": "-3f4247 . metal"},
        Usual(1.7, WOOD, 0.9),
        constructed=True,
    ),
    "gatling gun": Noun(
        "gatling guns, gatling; minigun, maxim gun, heavy machine gun",
        {
            "barrels": "-4a4d52 . metal",
            "casing": "+c79a3e . golden",
            "carriage": "*7a4f2a grain",
            "wheels": "&5a3a20 grain",
        },
        Usual(1.9, STEEL, 0.26),
        constructed=True,
    ),
    "gun turret": Noun(
        "gun turrets, sentry gun, auto turret, sentry turret, defense turret; laser turret, "
        "cannon turret, anti aircraft gun",
        {
            "armour": "*6b7480 . paint",
            "guns": "-3a3d42 . metal",
            "base": "&4f5660 . metal",
            "bolts": "-8d949b . metal",
            "lamps": "-e0402a",
        },
        Usual(1.6, STEEL, 0.3),
        constructed=True,
    ),
}
