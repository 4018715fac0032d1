"""What stands at a road or by it, what is fixed in a yard, and a battery."""

from core.guidance.builtin.nouns.noun import RUBBER, STEEL, STONE, Noun, Usual

ROADSIDE = {
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
    "factory": Noun(
        "factory building, industrial building, industrial plant; warehouse, power plant, power "
        "station, mill building, workshop, sawmill, steel mill, refinery, nuclear plant, "
        "factory hall, manufacturing plant, oil rig",
        {
            "hall": "*a5482f . stone",
            "roof": "&6a7077 . metal",
            "chimneys": "+b8b2a6 . stone",
            "bands": "-c9302a . paint",
            "windows": "-f2d98a . glass",
            "gate": "-3f5566 . paint",
            "frames": "-4a3a34 . metal",
            "slats": "-293b49 . paint",
        },
        Usual(40.0, STONE, 0.03),
    ),
    "shop": Noun(
        "store, shop building, shop front, shopfront, storefront, store front, corner shop; "
        "cafe, café, coffee shop, coffee house, restaurant, diner, bakery, bistro, grocery, "
        "grocery store, grocery shop, supermarket, pharmacy, boutique, candy shop, candy store, "
        "flower shop, toy shop, toy store, bookshop, bookstore, barber shop, ice cream shop, "
        "pizzeria, bar building, convenience store, market building, butcher shop, bookstore "
        "building, hair salon, laundromat, post office",
        {
            "walls": "*e9d3a2 . stone",
            "awning": "-f6f2e8 . fabric",
            "stripes": "+d02f2a . fabric",
            "window": "-9fd0e0 . glass",
            "door": "&7a4524 grain",
            "sign": "+2f7a4c . paint",
            "letters": "-f6f2e8 . paint",
            "frames": "-5f3a22",
        },
        Usual(7.0, STONE, 0.15),
    ),
    "gas station": Noun(
        "petrol station, filling station, fuel station, service station, gasoline station; "
        "truck stop",
        {
            "roof": "-f4f5f3 . paint",
            "band": "*d42823 . paint",
            "posts": "-a8adb2 . metal",
            "pumps": "*d42823 . paint",
            "screens": "+f2f5f5 . paint",
            "hoses": "-1f2023 . rubber",
            "letters": "-f6f2e8 . paint",
        },
        Usual(12.0, STEEL, 0.006),
    ),
    "mountain": Noun(
        "mountains, mountain peak, snowy mountain, snow mountain, mount everest, everest; hill, "
        "mount fuji, cliff, mountain range, hills, alps",
        {
            "rock": "*7a7672 mottle stone",
            "snow": "+f6f8fa",
            "peaks": "&8d8781 mottle stone",
            "ground": "-5f9a3e",
            "firs": "-24602f",
        },
        Usual(40.0, STONE, 0.2),
    ),
}
HARDWARE = {
    "chain": Noun(
        "chain link, chain links, anchor chain; prison chain",
        {"links": "*8d9298 . metal", "rings": "&b4b9be . metal"},
        Usual(0.5, STEEL, 0.6),
    ),
}
PARTS_OF_CARS = {
    "wheel": Noun(
        "car wheel, wheel with tire; truck wheel, cart wheel, wagon wheel, wheel rim, alloy "
        "wheel, spare wheel, bicycle wheel, bike wheel, tractor wheel, train wheel, monster truck "
        "wheel",
        {
            "tyre": "+1f1f22 . rubber",
            "treads": "+161618 . rubber",
            "rim": "*c9ced3 . metal",
            "spokes": "*b4bac0 . metal",
            "hub": "&8d949b . metal",
            "nuts": "-4a4e53 . metal",
            "stripe": "+f2efe6",
        },
        Usual(0.65, RUBBER, 0.4),
    ),
}
MACHINES = {
    "robot arm": Noun(
        "robotic arm, industrial robot, robot manipulator, mechanical arm; welding robot, "
        "robot gripper, robot hand",
        {
            "arms": "*f08a1c . paint",
            "joints": "&3d4147 . paint",
            "base": "*f08a1c . paint",
            "turntable": "-2b2d31 . metal",
            "gripper": "-9aa0a6 . metal",
            "caps": "+f2f3f0 . paint",
            "stripes": "&2b2d31 . paint",
        },
        Usual(1.8, STEEL, 0.09),
    ),
    "battery": Noun(
        "aa battery, aaa battery, battery cell, electric battery; car battery, accumulator, "
        "power bank, lithium battery, rechargeable battery, battery pack, power cell, energy cell",
        {
            "body": "*232428 . paint",
            "top": "+c98436 . copper",
            "nub": "-c7ccd1 . metal",
            "base": "-c7ccd1 . metal",
            "plus": "-f4f4f0 . paint",
            "bolt": "+f2c52c . paint",
        },
        Usual(0.05, STEEL, 0.1),
    ),
}
