"""Equipment and provisions: machines, what hangs on walls, clothes, a doll, and two dishes."""

from core.guidance.builtin.nouns.noun import (
    FABRIC,
    FLESH,
    GLASS,
    PLANT,
    PLASTIC,
    RUBBER,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

EQUIPMENT_DEVICES = {
    "computer mouse": Noun(
        "pc mouse, optical mouse, wired mouse, desktop mouse, computer mice; gaming mouse, "
        "wireless mouse",
        {
            "body": "*e9ebee . plastic",
            "buttons": "&bcc4d0 . plastic",
            "wheel": "-26292e . rubber",
            "base": "-5a626e . plastic",
            "cable": "-2d3036 . rubber",
            "logo": "+3a6fd0 . plastic",
            "grips": "-5a626e . rubber",
        },
        Usual(0.2, PLASTIC, 0.25),
    ),
    "vr headset": Noun(
        "vr goggles, virtual reality headset, virtual reality goggles, vr glasses, vr, "
        "vr helmet, virtual reality glasses; ar headset, mixed reality headset, "
        "augmented reality headset",
        {
            "visor": "*eceef1 . plastic",
            "foam": "-26282c . fabric",
            "straps": "&c3c8d0 . fabric",
            "plate": "-1b1f28 . glass",
            "cameras": "+2f8fe0 . glass",
            "pads": "-33373d . rubber",
        },
        Usual(0.3, PLASTIC, 0.12),
    ),
    "server rack": Noun(
        "server, data rack, servers, rack of servers, computer server, server cabinet; "
        "data center, data centre, mainframe, supercomputer, network rack",
        {
            "cabinet": "*2b2f36 . metal",
            "units": "&6a717b . metal",
            "drives": "-1c1f24 . plastic",
            "lights": "+45e07a . plastic",
            "lamps": "+36a8ff . plastic",
            "vents": "&484e57 . metal",
        },
        Usual(2.0, STEEL, 0.06),
    ),
    "atm": Noun(
        "cash machine, cashpoint, cash point, atm machine, automated teller machine, "
        "cash dispenser; bank machine",
        {
            "body": "*d9dde2 . metal",
            "screen": "-1f6fb2 . glass",
            "keys": "-3a3f47 . plastic",
            "panels": "+1d4f9c . plastic",
            "letters": "-ffffff . plastic",
            "notes": "-6fae6a",
        },
        Usual(1.8, STEEL, 0.07),
    ),
    "satellite dish": Noun(
        "radar dish, dish antenna, radar, parabolic antenna, satellite antenna, sat dish, "
        "tv dish; antenna, aerial, radar station, radar antenna, tv antenna, radio telescope",
        {
            "dish": "*d3d9de . paint",
            "rim": "&f1f3f4 . paint",
            "receiver": "+c8372d . plastic",
            "arms": "-4d545d . metal",
            "mast": "-7b828b . metal",
            "foot": "-5c636c . metal",
            "seams": "~8f979f",
        },
        Usual(1.4, STEEL, 0.08),
    ),
}
EQUIPMENT_PROPS = {
    "gumball machine": Noun(
        "bubblegum machine, bubble gum machine, gum machine, gumball dispenser, gum ball "
        "machine, chewing gum machine; candy machine, sweet machine, candy dispenser",
        {
            "base": "*cf2027 . paint",
            "globe": "-cfe6ee . glass",
            "gumballs": "-e8392f . plastic",
            "sweets": "-2f7fdc . plastic",
            "candies": "-f7c928 . plastic",
            "knob": "-cfd4d9 . metal",
        },
        Usual(0.45, GLASS, 0.3),
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
EQUIPMENT_SMALL = {
    "stethoscope": Noun(
        "doctor's stethoscope, doctor stethoscope, medical stethoscope, stethoscopes",
        {
            "tube": "*1f5f8f . rubber",
            "ear tubes": "-c9ced4 . metal",
            "tips": "+23262b . rubber",
            "chest piece": "-b4bac2 . metal",
            "disc": "+f1efe8 . plastic",
            "collars": "&174a70 . rubber",
        },
        Usual(0.6, RUBBER, 0.15),
    ),
    "clipboard": Noun(
        "clip board, clip boards, clipboards; checklist, check list, to do list, questionnaire, "
        "menu",
        {
            "board": "*a8703c grain",
            "paper": "-fbfaf4",
            "lines": "-5f7590",
            "boxes": "+2fa35a",
            "clip": "-b9c0c8 . metal",
            "bar": "-8e959e . metal",
        },
        Usual(0.32, WOOD, 0.35),
    ),
    "notice board": Noun(
        "noticeboard, bulletin board, cork board, corkboard, pinboard, pin board; memo board, "
        "message board, quest board, job board, evidence board",
        {
            "frame": "*8a5630 grain",
            "cork": "-c99a5f mottle",
            "paper": "-fbfaf4",
            "notes": "+f7d84a",
            "cards": "+7cc3e8",
            "pins": "-d5342c . plastic",
            "lines": "-8f98a3",
            "words": "-8a6d1f",
        },
        Usual(1.0, WOOD, 0.3),
    ),
    "first aid kit": Noun(
        "medical kit, first aid box, medkit, med kit, medic kit, medical box, medical case, "
        "first aid case, firstaid kit; health pack, first aid bag, doctor's bag, doctor bag, "
        "medical bag",
        {
            "body": "*d3252b . plastic",
            "cross": "+fbfbf8 . plastic",
            "handle": "-2b2e33 . plastic",
            "latches": "-c3c8ce . metal",
            "band": "&a3191f . plastic",
            "feet": "-2b2e33 . rubber",
        },
        Usual(0.35, PLASTIC, 0.15),
    ),
}
EQUIPMENT_BUILDINGS = {
    "column": Noun(
        "pillar, greek column, roman column, doric column, ionic column, corinthian column, "
        "roman pillar, greek pillar; pilaster, support column, plinth, bollard, mooring bollard",
        {
            "shaft": "*ebe5d8 . stone",
            "base": "&d9d1c0 . stone",
            "capital": "&e2dac9 . stone",
            "slab": "&cfc6b4 . stone",
            "rings": "&c6bca8 . stone",
            "ornament": "+d6c9a8 . stone",
        },
        Usual(4.0, STONE, 1.0),
    ),
}
EQUIPMENT_TOOLS = {
    "pliers": Noun(
        "pair of pliers, plier, needle nose pliers, combination pliers; tongs, pincers, wire "
        "cutters, wire cutter, tin snips",
        {
            "jaws": "*aab0b8 . metal",
            "handles": "+d5322b . rubber",
            "necks": "&8a919a . metal",
            "bolt": "-d3d7dc . metal",
            "teeth": "-50565e . metal",
            "ends": "+2a2d32 . rubber",
        },
        Usual(0.2, STEEL, 0.3),
    ),
}
EQUIPMENT_CLOTHES = {
    "jacket": Noun(
        "coat, hoodie, jackets, zip hoodie, bomber jacket, biker jacket, winter jacket, hooded "
        "jacket; jean jacket, parka, raincoat, blazer, cardigan, anorak, overcoat, trench coat, "
        "winter coat, tracksuit top, varsity jacket, suit, tuxedo, suit jacket, lab coat, robe, "
        "bathrobe, life jacket",
        {
            "body": "*8a4f2d . leather",
            "shirt": "+ece6d8 . fabric",
            "collar": "&4f2b19 . leather",
            "cuffs": "&4f2b19 . leather",
            "pockets": "&6b3a22 . leather",
            "zip": "-d3b25a . golden",
            "seams": "~5f361f . leather",
        },
        Usual(0.75, FABRIC, 0.06),
    ),
    "sandal": Noun(
        "flip flop, slipper, sandals, flip flops, slippers, thong sandal, beach sandal, "
        "flipflop, flipflops; slide sandal, birkenstock, beach slipper",
        {
            "sole": "&7a5230 . rubber",
            "footbed": "*d9b07a . leather",
            "straps": "+b8432e . leather",
            "edges": "-f0e4cc . rubber",
            "buckles": "-e0b84a . golden",
        },
        Usual(0.28, RUBBER, 0.2),
    ),
    "necktie": Noun(
        "tie, neck tie, neckties, business tie; cravat, school tie",
        {
            "blade": "*1f3f86 . fabric",
            "knot": "&18326c . fabric",
            "stripes": "+d8b04a . fabric",
            "tail": "&16305f . fabric",
            "loop": "&1a3874 . fabric",
        },
        Usual(0.6, FABRIC, 0.3),
    ),
}
EQUIPMENT_DOLLS = {
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
}
EQUIPMENT_FOOD = {
    "roast chicken": Noun(
        "roast turkey, roasted turkey, roasted chicken, cooked turkey, cooked chicken, whole "
        "roast chicken, thanksgiving turkey, baked chicken; christmas turkey, roast duck, "
        "rotisserie chicken, roast goose",
        {
            "meat": "*b9662a",
            "drumsticks": "&a35222",
            "bones": "-f4ead6",
            "platter": "+eef0f2 . ceramic",
            "leaves": "-5f9a36",
            "tomatoes": "-d5362a",
        },
        Usual(0.4, FLESH, 0.7),
    ),
    "salad": Noun(
        "bowl of salad, green salad, mixed salad, garden salad, side salad; "
        "greek salad, caesar salad, vegetable bowl",
        {
            "bowl": "+f1ece2 . ceramic",
            "leaves": "*6fae3a",
            "tomato": "-d9362a",
            "cucumber": "-d8ebb0",
            "rind": "-2f6b33",
            "onion": "-a5468a",
        },
        Usual(0.26, PLANT, 0.4),
    ),
}
