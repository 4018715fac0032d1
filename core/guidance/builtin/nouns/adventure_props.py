"""Treasure, weapons, potions and what else is found in an adventure."""

from core.guidance.builtin.nouns.noun import CERAMIC, GLASS, GOLD, STEEL, STONE, WOOD, Noun, Usual

_GRIP = "-4a2c1a"
ADVENTURE_PROPS = {
    "sword": Noun(
        "longsword, broadsword, knight sword; sabre, saber, rapier, claymore, cutlass, "
        "scimitar, excalibur, greatsword, machete",
        {
            "blade": "*b4bac2 . metal",
            "guard": "+c79a3e . golden",
            "grip": _GRIP,
            "pommel": "+c79a3e . golden",
            "fuller": "~7d848d . metal",
            "wraps": "-c79a3e . golden",
        },
        Usual(1.1, STEEL, 0.045),
    ),
    "dagger": Noun(
        "; dirk, bayonet, kris, letter opener",
        {
            "blade": "*b4bac2 . metal",
            "guard": "+8a7a4a . metal",
            "grip": _GRIP,
            "pommel": "+8a7a4a . metal",
        },
        Usual(0.35, STEEL, 0.097),
    ),
    "shield": Noun(
        "knight shield; buckler",
        {
            "plate": "*b02a24",
            "rim": "+9aa0a6 . metal",
            "emblem": "+e0b84a . golden",
            "quarters": "~7c1a16 . paint",
        },
        Usual(0.9, WOOD, 0.19),
    ),
    "arrow": Noun(
        "; crossbow bolt, dart, arrowhead",
        {
            "head": "*8f979e . metal",
            "shaft": "&b98a52 grain",
            "feathers": "+e8e4da",
            "bands": "+b8322a . paint",
        },
        Usual(0.75, WOOD, 0.058),
    ),
    "pistol": Noun(
        "handgun, hand gun; gun, firearm, toy gun, water gun, glock, desert eagle, flintlock, uzi",
        {
            "barrel": "*4a4d52 . metal",
            "frame": "&33363a . metal",
            "grip": "+3a2a20",
            "trigger": "-202225 . metal",
            "grooves": "~1c1d20 . metal",
            "port": "-16171a . metal",
            "ridges": "~1c130d . rubber",
        },
        Usual(0.2, STEEL, 0.4),
    ),
    "cannon": Noun(
        "; howitzer, mortar, artillery, artillery gun",
        {
            "barrel": "*3a3c40 . metal",
            "carriage": "+7a4a24 grain",
            "wheels": "-5a3a20 grain",
            "bands": "-c79a3e . golden",
        },
        Usual(2.2, STEEL, 0.5),
        constructed=True,
    ),
    "bomb": Noun(
        "; sea mine, naval mine, bob omb, cannonball, cannon ball",
        {
            "body": "*232427",
            "cap": "&3a3c40 . metal",
            "fuse": "-c9b48a",
            "spark": "-ff9a1e",
            "skull": "-f4f2ea . paint",
        },
        Usual(0.2, STEEL, 0.5),
    ),
    "staff": Noun(
        "wizard staff, magic staff; sceptre, scepter, magic stick, walking stick, cane, "
        "walking cane, shepherd's crook, crook",
        {"shaft": "*6b4424 grain", "crystal": "+58c8f0 . glass", "fork": "&5a3a20 grain"},
        Usual(1.8, WOOD, 0.096),
    ),
    "torch": Noun(
        "burning torch, flaming torch",
        {"handle": "*6b4424 grain", "flame": "-ff9a1e", "basket": "+3a3c40 . metal"},
        Usual(0.6, WOOD, 0.38),
    ),
    "lantern": Noun(
        "oil lantern, oil lamp; hurricane lamp, gas lamp",
        {
            "frame": "*3a3c40 . metal",
            "glass": "-ffd98a . glass",
            "roof": "*3a3c40 . metal",
            "handle": "&4a4c50 . metal",
        },
        Usual(0.35, STEEL, 0.035),
    ),
    "chest": Noun(
        "treasure chest; trunk, coffer, loot box, blanket box, toy box, toy chest, jewelry box, "
        "jewellery box, music box, trinket box, keepsake box, memory box, treasure box",
        {
            "body": "*7a4a24 grain",
            "lid": "*7a4a24 grain",
            "bands": "+4a4d52 . metal",
            "lock": "-d8a83c . golden",
            "seams": "~41260f grain",
            "keyhole": "-1c1208",
            "rivets": "-9ea3a8 . metal",
        },
        Usual(0.8, WOOD, 0.3),
    ),
    "open chest": Noun(
        "open treasure chest, opened chest, opened treasure chest, overflowing chest, overflowing "
        "treasure chest, open pirate chest, open chests, chest of gold, chest of coins; "
        "open coffer, open trunk, open loot box",
        {
            "body": "*7a4a24 grain",
            "lid": "*7a4a24 grain",
            "bands": "+4a4d52 . metal",
            "lock": "-d8a83c . golden",
            "coins": "-f0bd3a coins golden",
            "seams": "~41260f grain",
            "keyhole": "-1c1208",
        },
        Usual(0.9, WOOD, 0.5),
    ),
    "barrel": Noun(
        "wine barrel, cask, keg; vat",
        {"body": "*8a5a2e grain", "hoops": "+55585c . metal", "seams": "~4a2e16 grain"},
        Usual(0.9, WOOD, 0.25),
    ),
    "crate": Noun(
        "shipping crate, supply crate; packing case, care package, wooden box, "
        "storage box, storage bin, storage crate, lobster trap, lobster pot",
        {
            "planks": "*b98a52 grain",
            "frame": "&9c6f3e grain",
            "braces": "&9c6f3e grain",
            "seams": "~6e4c28 grain",
            "nails": "-3f4246 . metal",
        },
        Usual(0.6, WOOD, 0.12),
    ),
    "coin": Noun(
        "pirate coin; token",
        {
            "face": "*f0c24a . golden",
            "rim": "&d8a83c . golden",
            "emblem": "&d8a83c . golden",
            "beads": "~c58f26 . golden",
        },
        Usual(0.03, GOLD, 0.52),
    ),
    "gem": Noun(
        "gemstone, jewel; diamond, emerald stone, sapphire, crystal gem, ruby, sapphire "
        "stone, topaz, opal, precious stone",
        {"stone": "*2f8ad8 . glass"},
        Usual(0.05, STONE),
    ),
    "key": Noun(
        "old key, door key; skeleton key",
        {"bow": "*d8a83c . golden", "shaft": "*d8a83c . golden", "teeth": "&d8a83c . golden"},
        Usual(0.1, STEEL, 0.4),
    ),
    "potion": Noun(
        "potion bottle, magic potion, flask of potion, health potion, healing potion, mana "
        "potion, stamina potion, love potion, poison potion, potion of health, potion of healing; "
        "elixir, vial, poison bottle, mana bottle, alchemy bottle, poison",
        {"flask": "*8a3fc0 . glass", "cork": "-b98a52", "rim": "&a070d0 . glass"},
        Usual(0.2, GLASS, 0.095),
    ),
    "cauldron": Noun(
        "witch cauldron, kettle pot; crucible",
        {
            "pot": "*2e3033 . metal",
            "brew": "+5ac23a",
            "feet": "&2e3033 . metal",
            "handles": "&3a3c40 . metal",
        },
        Usual(0.6, STEEL, 0.16),
    ),
    "book": Noun(
        "spellbook, old book; bible, tome, grimoire, dictionary, novel, textbook, necronomicon, "
        "encyclopedia, magazine, paperback, comic book, calendar, manual",
        {
            "cover": "*7a1f24",
            "pages": "-f0e6cc",
            "bands": "+d8a83c . golden",
            "badge": "+e0b04a . golden",
            "border": "+d8a83c . golden",
            "lines": "-bfa983",
        },
        Usual(0.26, WOOD, 0.47),
    ),
    "scroll": Noun(
        "parchment scroll; parchment, map scroll, papyrus",
        {"paper": "*e6d4a8", "rods": "+6b4424 grain", "seal": "-a8241f", "letters": "-4a3722"},
        Usual(0.35, WOOD, 0.16),
    ),
    "hourglass": Noun(
        "hour glass, sand glass; egg timer",
        {"glass": "-e8cf96 . glass", "frame": "*7a4a24 grain"},
        Usual(0.25, WOOD, 0.2),
    ),
    "skull": Noun(
        "human skull; cranium",
        {
            "bone": "*e6dcc4",
            "eyes": "-1a1512",
            "teeth": "-3a3228",
            "cracks": "~8f8468",
        },
        Usual(0.22, CERAMIC, 0.14),
    ),
    "tombstone": Noun(
        "gravestone, headstone, grave stone; grave, grave marker",
        {
            "slab": "*8f9290 . stone",
            "base": "&7a7d7b . stone",
            "cross": "&a5a8a6 . stone",
            "letters": "-43474a . stone",
        },
        Usual(1.0, STONE, 0.48),
    ),
    "sarcophagus": Noun(
        "sarcophaguses, sarcophagi, egyptian sarcophagus, pharaoh sarcophagus, mummy coffin, "
        "egyptian coffin, pharaoh coffin, mummy case, pharaoh's coffin, "
        "mummy sarcophagus, egyptian tomb",
        {
            "body": "*e0aa36 . golden",
            "headdress": "+2450a4 . paint",
            "stripes": "*e8b844 . golden",
            "face": "-d89a5c . paint",
            "eyes": "-26262c",
            "arms": "&b8702c . copper",
            "crooks": "+2450a4 . paint",
            "bands": "+1f9c9c . paint",
        },
        Usual(2.1, STONE, 0.3),
    ),
    "ship wheel": Noun(
        "ship's wheel, ships wheel, helm, boat wheel, ship steering wheel, ship's helm, "
        "ship helm, boat steering wheel, pirate ship wheel; captain's wheel, captain wheel, "
        "nautical wheel",
        {
            "rim": "*8a4f28 grain",
            "spokes": "&a5683a grain",
            "handles": "*7a4220 grain",
            "hub": "&6b3a1c grain",
            "cap": "+e0b04a . golden",
            "pegs": "+e0b04a . golden",
        },
        Usual(1.1, WOOD, 0.7),
    ),
}
