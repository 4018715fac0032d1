"""Props of games and stories."""

from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    FABRIC,
    GLASS,
    GOLD,
    PLANT,
    PLASTIC,
    RUBBER,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

_GRIP = "-4a2c1a"
PROPS = {
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
        "; dirk, throwing knife, kunai, bayonet, kris, letter opener",
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
    "barrel": Noun(
        "wine barrel, cask, keg; oil drum, vat, oil barrel",
        {"body": "*8a5a2e grain", "hoops": "+55585c . metal", "seams": "~4a2e16 grain"},
        Usual(0.9, WOOD, 0.25),
    ),
    "crate": Noun(
        "shipping crate, supply crate; packing case, ammo box, care package, ammo crate, wooden "
        "box, storage box, storage bin, storage crate, lobster trap, lobster pot",
        {
            "planks": "*b98a52 grain",
            "frame": "&9c6f3e grain",
            "braces": "&9c6f3e grain",
            "seams": "~6e4c28 grain",
            "nails": "-3f4246 . metal",
        },
        Usual(0.6, WOOD, 0.12),
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
    "potion": Noun(
        "potion bottle, magic potion, flask of potion; elixir, vial, poison bottle, mana "
        "bottle, alchemy bottle, poison",
        {"flask": "*8a3fc0 . glass", "cork": "-b98a52", "rim": "&a070d0 . glass"},
        Usual(0.2, GLASS, 0.095),
    ),
    "key": Noun(
        "old key, door key; skeleton key",
        {"bow": "*d8a83c . golden", "shaft": "*d8a83c . golden", "teeth": "&d8a83c . golden"},
        Usual(0.1, STEEL, 0.4),
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
    "gem": Noun(
        "gemstone, jewel; diamond, emerald stone, sapphire, crystal gem, ruby, sapphire "
        "stone, topaz, opal, precious stone",
        {"stone": "*2f8ad8 . glass"},
        Usual(0.05, STONE),
    ),
    "staff": Noun(
        "wizard staff, magic staff; sceptre, scepter, magic stick, walking "
        "stick, cane, walking cane, shepherd's crook, crook, crutch",
        {"shaft": "*6b4424 grain", "crystal": "+58c8f0 . glass", "fork": "&5a3a20 grain"},
        Usual(1.8, WOOD, 0.096),
    ),
    "torch": Noun(
        "burning torch, flaming torch",
        {"handle": "*6b4424 grain", "flame": "-ff9a1e", "basket": "+3a3c40 . metal"},
        Usual(0.6, WOOD, 0.38),
    ),
    "book": Noun(
        "spellbook, old book; bible, tome, grimoire, dictionary, novel, textbook, necronomicon, "
        "encyclopedia, magazine, newspaper, passport, paperback, comic book, calendar, manual",
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
        "parchment scroll; parchment, map scroll, map, treasure map, papyrus",
        {"paper": "*e6d4a8", "rods": "+6b4424 grain", "seal": "-a8241f", "letters": "-4a3722"},
        Usual(0.35, WOOD, 0.16),
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
    "cannon": Noun(
        "; howitzer, mortar, artillery, artillery gun",
        {
            "barrel": "*3a3c40 . metal",
            "carriage": "+7a4a24 grain",
            "wheels": "-5a3a20 grain",
            "bands": "-c79a3e . golden",
        },
        Usual(2.2, STEEL, 0.5),
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
    "hourglass": Noun(
        "hour glass, sand glass; egg timer",
        {"glass": "-e8cf96 . glass", "frame": "*7a4a24 grain"},
        Usual(0.25, WOOD, 0.2),
    ),
    "well": Noun(
        "water well, wishing well",
        {
            "wall": "*9a958a bricks stone",
            "roof": "+8a4a2e",
            "posts": "-6b4424 grain",
            "water": "-3f7fa8",
            "seams": "~5c2e1a grain",
            "boards": "-8a5c34 grain",
            "rope": "-e0c48a . fabric",
        },
        Usual(2.2, STONE, 0.5),
    ),
    "tent": Noun(
        "camping tent; marquee, teepee, tipi, big top, wigwam, yurt",
        {
            "canvas": "*d87f2a . fabric",
            "door": "-5a3a20",
            "poles": "+6e7276 . metal",
            "trim": "+f3e3c0 . fabric",
        },
        Usual(2.2, FABRIC, 0.013),
    ),
    "campfire": Noun(
        "camp fire, fire pit, bonfire; bonfire wood, camp site fire, fireside",
        {
            "flame": "-ff8c1a",
            "logs": "*6b4424 grain",
            "stones": "+86867f . stone",
            "ash": "-3a3632",
        },
        Usual(1.0, STONE, 0.6),
    ),
    "signpost": Noun(
        "sign post, road sign; sign, billboard",
        {"boards": "*a5743e grain", "post": "&7a4a24 grain", "base": "-8a8a82 . stone"},
        Usual(2.0, WOOD, 0.11),
    ),
    "ladder": Noun(
        "; stepladder",
        {"rails": "*b98a52 grain", "rungs": "&a5743e grain"},
        Usual(2.4, WOOD, 0.056),
    ),
    "fence": Noun(
        "picket fence; pig pen, pigpen, paling, railing, barricade, balustrade, barrier",
        {"pickets": "*f0eee6", "rails": "&e0ded4", "nails": "-6d7278 . metal"},
        Usual(1.8, WOOD, 0.3),
    ),
    "mailbox": Noun(
        "letterbox, letter box, post box, postbox; mail box",
        {
            "box": "*3f6ea8 . paint",
            "door": "&3f6ea8 . paint",
            "flag": "-c9211e",
            "post": "-7a4a24 grain",
            "letters": "-f4f1e8 . paint",
            "slots": "-1f2226",
        },
        Usual(1.3, STEEL, 0.0069),
    ),
    "gift": Noun(
        "gift box, present, wrapped present; parcel, package",
        {
            "box": "*c0262c",
            "lid": "*c0262c",
            "ribbon": "+f0c24a",
            "bow": "+f0c24a",
            "dots": "-f4efe4",
        },
        Usual(0.3, WOOD, 0.14),
    ),
    "basket": Noun(
        "picnic basket; hamper, wickerwork",
        {"body": "*c39652", "handle": "&a5743e", "rim": "&a5743e", "weave": "~9a6c34"},
        Usual(0.4, PLANT, 0.1),
    ),
    "balloon": Noun(
        "party balloon, toy balloon",
        {"body": "*d8262c . rubber", "knot": "&d8262c . rubber", "string": "-e8e4da"},
        Usual(0.4, RUBBER, 0.00045),
    ),
    "umbrella": Noun(
        "; parasol, sunshade",
        {
            "canopy": "*3056b8 . fabric",
            "stick": "-8a8f94 . metal",
            "handle": "+5a3a20",
            "panels": "~5f83e0 . fabric",
        },
        Usual(1.0, STEEL, 0.00085),
    ),
    "pawn": Noun(
        "chess pawn, chess piece; chessman",
        {"body": "*e6d4b0", "base": "&d8c49c", "collar": "&d8c49c"},
        Usual(0.048, WOOD),
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
    "flag": Noun(
        "banner, flagpole, flag pole; pennant",
        {
            "cloth": "*c9211e . fabric",
            "pole": "-b0b4b8 . metal",
            "knob": "-e0b84a . golden",
            "base": "-6e6a64 . stone",
        },
        Usual(2.5, STEEL, 0.0051),
    ),
    "traffic light": Noun(
        "traffic lights, traffic signal, stoplight, stop light; railway signal, train signal",
        {
            "body": "*2b2d30 . paint",
            "reds": "-e0241c",
            "yellows": "-f7b81a",
            "greens": "-2fb54a",
            "hoods": "&1d1f21 . paint",
            "pole": "+6e7378 . metal",
            "base": "&55595e . metal",
            "border": "-f2c01c . paint",
        },
        Usual(2.8, STEEL, 0.016),
    ),
    "fire hydrant": Noun(
        "hydrant, fireplug, fire plug",
        {
            "body": "*c9211b . paint",
            "dome": "*c9211b . paint",
            "rings": "&a81a15 . paint",
            "outlets": "&c9211b . paint",
            "caps": "+d8d3c6 . metal",
        },
        Usual(0.8, STEEL, 0.12),
    ),
    "traffic cone": Noun(
        "road cone, safety cone, construction cone; pylon",
        {"body": "*f0640f", "stripes": "+f4f2ec", "base": "-242527 . rubber"},
        Usual(0.7, PLASTIC, 0.05),
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
    "padlock": Noun(
        "pad lock; lock, combination lock",
        {
            "body": "*d8a83c . golden",
            "shackle": "+b9bec4 . metal",
            "keyhole": "-1d1d1f",
        },
        Usual(0.08, COPPER, 0.4),
    ),
}
