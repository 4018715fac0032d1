"""What stands at a street, on a playground, at a fair, in a port or a field."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual

STREET_AND_PLAYGROUND = {
    "street lamp": Noun(
        "streetlamp, street light, streetlight, lamp post, lamppost, lantern post, street lantern, "
        "light pole, lamp pole, light post; victorian lamp, park lamp, gaslight",
        {
            "post": "*26332e . metal",
            "base": "*26332e . metal",
            "rings": "+c9a03c . golden",
            "arms": "&26332e . metal",
            "lamp": "-ffe7a0 . glass",
            "cap": "&1d2824 . metal",
        },
        Usual(4.0, STEEL, 0.02),
    ),
    "bus stop": Noun(
        "bus shelter, busstop, bus station; tram stop, shelter, waiting shelter",
        {
            "roof": "*2f62ae . paint",
            "posts": "&7d848a . metal",
            "glass": "-b4d6de . glass",
            "bench": "+b98246 grain",
            "pole": "-f0c22e . paint",
            "sign": "-1f7a44 . paint",
            "letters": "-f6f2e8 . paint",
        },
        Usual(4.0, STEEL, 0.01),
    ),
    "phone booth": Noun(
        "telephone booth, phone box, telephone box, phonebooth, red telephone box, call box, "
        "telephone kiosk, london phone booth; police box, tardis, payphone, pay phone",
        {
            "body": "*c4161c . paint",
            "windows": "-b8d8e6 . glass",
            "sign": "-f4efe0",
            "roof": "*c4161c . paint",
            "handle": "-c9a24a . golden",
            "letters": "-1d1d20",
            "seams": "~8f0f14",
        },
        Usual(2.5, STEEL, 0.05),
    ),
    "parking meter": Noun(
        "parkmeter, parking clock, coin meter, parking machine; ticket meter",
        {
            "head": "*5a6a78 . paint",
            "window": "-dcecef . glass",
            "needle": "-cf2a20",
            "plate": "-c9cdd0 . metal",
            "slot": "-1d1e20",
            "post": "+9aa0a6 . metal",
            "marks": "-2a2f36",
            "badge": "-f1f1ea . paint",
        },
        Usual(1.5, STEEL, 0.25),
    ),
    "gas pump": Noun(
        "petrol pump, fuel pump, gasoline pump, gas pumps, vintage gas pump, retro gas pump, "
        "fuel dispenser; petrol bowser, diesel pump, charging station",
        {
            "body": "*cf2a22 . paint",
            "globe": "+f7f3e6 . glass",
            "face": "+f6efdc . paint",
            "trim": "-b9bec4 . metal",
            "hose": "-1d1e20 . rubber",
            "nozzle": "-3c4045 . metal",
            "marks": "-26282c",
            "star": "-cf2a22 . paint",
        },
        Usual(2.0, STEEL, 0.05),
    ),
    "vending machine": Noun(
        "soda machine, drink machine, snack machine, drinks machine, vendor machine, "
        "soda vending machine; coke machine, ticket machine, cigarette machine",
        {
            "body": "*c9201f . paint",
            "window": "-e4f1f6",
            "cans": "+2f9ad0",
            "shelves": "-8f979e . metal",
            "panel": "-d3d7da . metal",
            "flap": "-26282b",
            "letters": "-f6f3ea . paint",
            "stripes": "-f6f3ea . paint",
        },
        Usual(1.9, STEEL, 0.02),
    ),
    "market stall": Noun(
        "stall, food stand, food stall, fruit stand, fruit stall, market stand, market booth; "
        "kiosk, lemonade stand, farm stand, shop stand, vegetable stand, newsstand, "
        "hot dog stand, ice cream stand, flower stand, coffee stand, newspaper stand",
        {
            "counter": "-a06a38 grain",
            "awning": "*d1261f . fabric",
            "stripes": "+f6f0e2 . fabric",
            "posts": "-7c4f2a grain",
            "shelf": "-c08a4e grain",
            "fruit": "-f29a1c",
            "apples": "-8cbf3a",
            "panels": "-d9a860 grain",
        },
        Usual(2.6, WOOD, 0.2),
    ),
    "dumpster": Noun(
        "waste container, garbage container, trash container, garbage dumpster; "
        "skip, rubbish skip, waste skip, recycling container",
        {
            "body": "*2f7d46 . paint",
            "lid": "+2b2d30",
            "ribs": "&286c3c . paint",
            "pockets": "&286c3c . paint",
            "wheels": "-1c1c1e . rubber",
            "arrows": "-f1f1ea . paint",
        },
        Usual(1.9, STEEL, 0.02),
    ),
    "shipping container": Noun(
        "container, cargo container, freight container, sea container, intermodal container, "
        "storage container, cargo box",
        {
            "body": "*b8461f . paint",
            "ribs": "&cc5526 . paint",
            "frame": "&8f3416 . paint",
            "doors": "&c24d22 . paint",
            "bars": "-c3c8cc . metal",
            "ridges": "~cc5526 . paint",
            "letters": "-f3ede2 . paint",
        },
        Usual(6.1, STEEL, 0.008),
    ),
    "pallet": Noun(
        "euro pallet, europallet, shipping pallet, cargo pallet; transport pallet",
        {
            "boards": "*d3a468 grain",
            "blocks": "&b5854a grain",
            "skids": "*c4945a grain",
        },
        Usual(1.2, WOOD, 0.35),
    ),
    "crane": Noun(
        "tower crane, construction crane, building crane; harbor crane, harbour crane, "
        "mobile crane",
        {
            "mast": "*f2b418 . paint",
            "jib": "*f2b418 . paint",
            "ties": "-4a4e53 . metal",
            "cab": "+dfe8ee . paint",
            "weights": "-8b8982 . stone",
            "hook": "-3a3d41 . metal",
            "gaps": "-3a3d42",
            "holes": "-3a3d42",
        },
        Usual(40, STEEL, 0.002),
        constructed=True,
    ),
    "silo": Noun(
        "grain silo, farm silo, corn silo, grain bin; granary, storage silo, grain elevator",
        {
            "body": "*d6d4cb",
            "roof": "+b3352a . metal",
            "bands": "&a3a7a8 . metal",
            "ladder": "-6d7378 . metal",
            "door": "-7a2a22",
            "base": "-8f8b83 . stone",
        },
        Usual(18.0, STEEL, 0.02),
    ),
    "water tower": Noun(
        "water tank tower, watertower, water towers, elevated water tank; water tank, tank tower, "
        "reservoir tower",
        {
            "tank": "*a56f3f grain",
            "roof": "+7c3b2a . paint",
            "bands": "-5a5f65 . metal",
            "legs": "+6d5138 grain",
            "braces": "&866443 grain",
            "pipe": "-7d8389 . metal",
            "seams": "~6e4626",
            "ridges": "~5c2a1e",
        },
        Usual(16.0, WOOD, 0.11),
    ),
    "wind turbine": Noun(
        "windturbine, wind generator, wind power plant; wind wheel, turbine",
        {
            "tower": "*f0f2f1 . paint",
            "blades": "*f0f2f1 . paint",
            "hub": "&d3d8da . paint",
            "nacelle": "&d3d8da . paint",
            "bands": "+d8322a . paint",
            "base": "-8b8982 . stone",
        },
        Usual(40.0, STEEL, 0.005),
        constructed=True,
    ),
    "solar panel": Noun(
        "solarpanel, photovoltaic panel, solar cell, solar module; solar array, solar collector",
        {
            "cells": "*1c3f86 . glass",
            "lines": "-cfd8e0",
            "frame": "+c7ccd1 . metal",
            "post": "&6f757b . metal",
            "base": "&565b60 . metal",
            "box": "-e9ebec . plastic",
        },
        Usual(2.4, STEEL, 0.012),
    ),
    "seesaw": Noun(
        "see saw, teeter totter, teeterboard, teeter board",
        {
            "plank": "*e2b21f . paint",
            "seats": "+cf2f28 . paint",
            "handles": "-3c6fb8 . paint",
            "stand": "+3c6fb8 . paint",
            "axle": "-8d9399 . metal",
        },
        Usual(2.6, WOOD, 0.5),
    ),
    "swing": Noun(
        "swing set, swingset, swings, playground swing, garden swing, childrens swing; "
        "swing seat, porch swing, rope swing, tire swing",
        {
            "frame": "*3f8fce . paint",
            "ropes": "-c9b58a",
            "seats": "+d8332a . plastic",
        },
        Usual(2.6, STEEL, 0.04),
    ),
    "carousel": Noun(
        "carrousel, merry go round, merrygoround, roundabout ride, horse carousel; "
        "fairground ride, fair ride, amusement ride, carousel ride",
        {
            "floor": "-b5713c grain",
            "column": "+f2e6cf",
            "canopy": "*d0302c . fabric",
            "trim": "+f3c23a",
            "poles": "-d8a83c . golden",
            "horses": "+f6f2ea",
        },
        Usual(9.0, WOOD, 0.1),
        constructed=True,
    ),
    "ferris wheel": Noun(
        "ferriswheel, observation wheel; london eye, fun fair ride",
        {
            "rim": "*f4f1ea . paint",
            "spokes": "&d3d8dc . metal",
            "cabins": "+d8322a . paint",
            "roofs": "+f2bd2a . paint",
            "legs": "+2f62ae . paint",
            "base": "-7d7f84 . stone",
        },
        Usual(30.0, STEEL, 0.003),
        constructed=True,
    ),
}
