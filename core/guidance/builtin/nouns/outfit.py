"""Outfits: arms of the comics, what goes on a trip, a chair to play in and a motor."""

from core.guidance.builtin.nouns.noun import (
    LEATHER,
    PLASTIC,
    RUBBER,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

OUTFIT_ARMS = {
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
        Usual(1.1, STEEL, 0.02),
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
}
OUTFIT_SPORT = {
    "skis": Noun(
        "ski, pair of skis, snow skis, downhill skis, alpine skis, skis and poles, skis with "
        "poles, ski set; cross country skis, ski poles, water skis, skiing equipment",
        {
            "skis": "*d8322c . paint",
            "stripes": "+f6d048 . paint",
            "bindings": "-2e3036 . plastic",
            "strap": "+2c6fbc . fabric",
            "poles": "-b4bcc4 . metal",
            "grips": "-2e3036 . rubber",
        },
        Usual(1.7, PLASTIC, 0.1),
    ),
}
OUTFIT_PROPS = {
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
    "tire": Noun(
        "tires, tyre, tyres, car tire, car tyre, car tires, car tyres, "
        "old tire, truck tire, tractor tire, spare tire; spare tyre, racing tire, race tire, "
        "winter tire, truck tyre, tractor tyre, mud tire",
        {
            "tyre": "*3a3c42 . rubber",
            "tread": "*26262c . rubber",
            "stripe": "+e6e2d8 . rubber",
        },
        Usual(0.65, RUBBER, 0.15),
    ),
    "engine": Noun(
        "engines, car engine, car engines, v8, v8 engine, v 8 engine, motor, motors, car motor, "
        "engine block, combustion engine, petrol engine, gasoline engine; v6 engine, v12 engine, "
        "truck engine, diesel engine, turbo engine, hot rod engine, outboard motor",
        {
            "block": "*6a727c . metal",
            "covers": "+d2342a . paint",
            "ribs": "+e8e4da . metal",
            "filter": "+f2ead8",
            "lid": "+c4cad0 . metal",
            "pulleys": "-2c2e34 . metal",
            "fan": "+f0b430 . paint",
            "pleats": "~b8a884 . paint",
        },
        Usual(0.8, STEEL, 0.34),
    ),
}
WORKSHOP_FURNITURE = {
    "gaming chair": Noun(
        "gaming chairs, gamer chair, gamers chair, racing chair, gamer's chair, streamer chair, "
        "esports chair, gaming seat; racing seat, bucket seat",
        {
            "seat": "*2e3038 . leather",
            "stripes": "+e0342c . leather",
            "pillows": "+e0342c . leather",
            "arms": "-4a4d55 . plastic",
            "base": "-5c6068 . metal",
            "wheels": "-26262c . rubber",
            "badge": "+e0342c . leather",
        },
        Usual(1.3, PLASTIC, 0.1),
    ),
    "picnic table": Noun(
        "picnic tables, picnic bench, picnic benches, park table, garden table with benches, "
        "table with benches, beer garden table, outdoor table; camping "
        "table, trestle table, beer table",
        {
            "top": "*c58a4c grain",
            "benches": "*b87a3e grain",
            "legs": "&7c4e28 grain",
        },
        Usual(1.8, WOOD, 0.5),
    ),
}
WORKSHOP_SMALL = {
    "pen": Noun(
        "pens, fountain pen, fountain pens, ink pen, ballpoint pen, ballpoint, ball pen, biro, "
        "writing pen, nib pen; ballpoint pens, gel pen, rollerball, calligraphy pen, dip pen, "
        "stylus",
        {
            "body": "*1f4fa8 . paint",
            "grip": "+26262c . plastic",
            "nib": "+e8bc4a . golden",
            "hole": "-33291c",
            "bands": "+e8bc4a . golden",
            "clip": "+e8bc4a . golden",
        },
        Usual(0.14, PLASTIC, 0.4),
    ),
    "notebook": Noun(
        "notebooks, note book, spiral notebook, spiral notebooks, notepad, note pad, sketchbook, "
        "sketch book, exercise book, school notebook, ring notebook, ring-bound notebook, sketch "
        "pad, writing pad; journal, planner, diary, steno pad",
        {
            "cover": "*2c8fb8",
            "pages": "-f4f0e4",
            "rings": "-8f979f . metal",
            "label": "-f4ecd4",
            "band": "+e2543a . fabric",
        },
        Usual(0.24, WOOD, 0.6),
    ),
}
WORKSHOP_DEVICES = {
    "boombox": Noun(
        "boomboxes, boom box, boom boxes, ghetto blaster, ghettoblaster, cassette player, tape "
        "player, radio cassette player, radio cassette, cassette recorder, tape recorder, retro "
        "stereo, portable stereo; stereo, cd player, music box player",
        {
            "body": "*d8434e . plastic",
            "rims": "+d4d8dc . metal",
            "speakers": "-2c2e34 . rubber",
            "deck": "-40444f . plastic",
            "reels": "-f4f0e8 . plastic",
            "buttons": "+f6c63c . plastic",
            "handle": "+d4d8dc . metal",
        },
        Usual(0.6, PLASTIC, 0.25),
    ),
}
