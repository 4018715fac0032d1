"""Markings of vehicles on land and on water."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    boards,
    bodywork,
    craft,
    fronts,
    machines,
    outlines,
    prints,
)
from core.guidance.builtin.markings.marking import Marking, Rows

AWNING = tuple((k / 3 - 1.15, k / 3 - 0.98) for k in range(7))
VEHICLES: Rows = {
    "school bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.SCHOOL_BUS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.BUS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.SCHOOL_BUS_TRIM)),
        "letters": Marking(
            "body", partial(fronts.on_sides, text="SCHOOL BUS", high=0.1, at=(0, 0.78))
        ),
        "stripe": Marking("body", partial(fronts.belt, low=-0.32, high=-0.2)),
    },
    "bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.BUS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.BUS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.BUS_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.27, high=-0.13)),
    },
    "double decker bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.DOUBLE_DECKER_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.DOUBLE_DECKER_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.DOUBLE_DECKER_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=0.13, high=0.25)),
    },
    "truck": {
        "windows": Marking("cab", partial(bodywork.windows, **bodywork.TRUCK_WINDOWS)),
        "lamps": Marking("cab", partial(outlines.laid, **bodywork.TRUCK_LAMPS)),
        "trim": Marking("cab", partial(outlines.laid, **bodywork.TRUCK_TRIM)),
        "seams": Marking("cargo", partial(outlines.laid, **bodywork.CARGO_SEAMS)),
    },
    "pickup truck": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.PICKUP_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.PICKUP_TAIL)),
        "seams": Marking("body", partial(outlines.laid, **bodywork.PICKUP_SEAMS)),
    },
    "monster truck": {
        "doors": Marking("body", partial(outlines.laid, **craft.MONSTER_DOORS)),
        "flames": Marking("body", partial(outlines.laid, **craft.FLAMES)),
    },
    "dump truck": {
        "trim": Marking("body", partial(outlines.laid, **machines.DUMPER_TRIM)),
    },
    "garbage truck": {
        "windows": Marking("cab", partial(outlines.laid, **craft.GARBAGE_WINDOWS)),
        "lamps": Marking("cab", partial(fronts.spots, at=(0.18, 0.2, 0.37), radius=0.075)),
    },
    "fire truck": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.FIRE_WINDOWS)),
        "lockers": Marking("body", partial(outlines.laid, **bodywork.FIRE_LOCKERS)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.FIRE_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.6, high=-0.44)),
    },
    "trailer": {"stripes": Marking("awning", partial(fronts.belts, spans=AWNING, axis=1))},
    "excavator": {
        "stripes": Marking("body", partial(outlines.laid, **craft.DIGGER_STRIPES)),
        "vents": Marking("body", partial(outlines.laid, **craft.DIGGER_VENTS)),
        "links": Marking("tracks", bodywork.links),
    },
    "tractor": {
        "grille": Marking("body", partial(outlines.laid, **craft.TRACTOR_GRILLE)),
        "lamps": Marking("body", partial(outlines.laid, **craft.TRACTOR_LAMPS)),
    },
    "tank": {
        "star": Marking("turret", partial(outlines.laid, **bodywork.TANK_STAR)),
        "links": Marking("tracks", bodywork.links),
        "vents": Marking("hull", partial(outlines.laid, **bodywork.TANK_VENTS)),
    },
    "rover": {
        "lines": Marking("panels", partial(machines.grid, pitch=(0.11, 0.12))),
        "foil": Marking("body", partial(outlines.laid, **machines.ROVER_FOIL)),
    },
    "police car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "letters": Marking(
            "doors", partial(fronts.on_sides, text="POLICE", high=0.12, at=(0.08, -0.12))
        ),
        "doors": Marking("body", fronts.doors),
    },
    "car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "number plates": Marking("body", partial(outlines.laid, **bodywork.CAR_PLATES)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.CAR_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.CAR_TRIM)),
    },
    "taxi": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.TAXI_TRIM)),
        "letters": Marking("sign", partial(fronts.lettered, text="TAXI", high=0.5, bold=0.06)),
    },
    "sports car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.SPORTS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.SPORTS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.SPORTS_TRIM)),
    },
    "race car": {
        "number": Marking("body", partial(bodywork.race_number, text="7")),
        "visor": Marking("helmet", partial(outlines.laid, **bodywork.VISOR)),
    },
    "jeep": {
        "grille": Marking("body", partial(outlines.laid, **machines.JEEP_GRILLE)),
    },
    "van": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.VAN_WINDOWS)),
        "number plates": Marking("body", partial(outlines.laid, **bodywork.VAN_PLATES)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.VAN_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.VAN_TRIM)),
    },
    "ambulance": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.AMBULANCE_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.VAN_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.AMBULANCE_TRIM)),
        "cross": Marking("body", prints.kit_on_sides),
    },
    "golf cart": {
        "lamps": Marking("body", partial(outlines.laid, **machines.CART_LAMPS)),
        "trim": Marking("body", partial(outlines.laid, **machines.CART_TRIM)),
    },
    "wheel": {
        "stripe": Marking("tyre", partial(outlines.laid, **machines.TYRE_STRIPE)),
    },
    "boat": {
        "anchor": Marking("sails", partial(outlines.laid, **craft.ANCHOR)),
        "stripe": Marking("hull", partial(craft.flank, low=0.4, high=0.66, out=0.84)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.3)),
    },
    "rowboat": {"seams": Marking("hull", partial(boards.planks, count=5), "wooden")},
    "sailboat": {
        "anchor": Marking("sails", partial(outlines.laid, **craft.ANCHOR)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.4)),
    },
    "yacht": {
        "portholes": Marking("hull", partial(outlines.laid, **craft.YACHT_PORTS)),
    },
    "jet ski": {
        "trim": Marking("cowl", partial(outlines.laid, **machines.SKI_TRIM)),
        "ribs": Marking("saddle", partial(fronts.belts, spans=machines.SADDLE_RIBS, axis=1)),
    },
    "pirate ship": {"seams": Marking("hull", partial(boards.planks, count=10), "wooden")},
    "cargo ship": {
        "ribs": Marking("containers", craft.container_ribs, by="hull"),
        "ridges": Marking("boxes", craft.container_ribs, by="hull"),
    },
    "cruise ship": {
        "portholes": Marking("hull", partial(outlines.laid, **craft.PORTHOLES)),
    },
    "submarine": {
        "windows": Marking("hull", partial(outlines.laid, **craft.SUB_PORTS)),
        "rims": Marking("hull", partial(outlines.laid, **craft.SUB_RIMS)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.3)),
    },
    "train": {
        "windows": Marking("cab", partial(bodywork.windows, **bodywork.TRAIN_WINDOWS)),
        "bands": Marking("boiler", partial(fronts.belts, spans=bodywork.BOILER_BANDS, axis=1)),
    },
    "tram": {
        "lamps": Marking("body", partial(outlines.laid, **machines.TRAM_LAMPS)),
        "sign": Marking("body", partial(outlines.laid, **machines.TRAM_SIGN)),
        "windows": Marking("body", partial(outlines.laid, **machines.TRAM_WINDOWS)),
        "doors": Marking("body", partial(outlines.laid, **machines.TRAM_DOORS)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.62, high=-0.28)),
    },
    "motorcycle": {
        "fins": Marking("engine", partial(outlines.laid, **craft.ENGINE_FINS)),
    },
    "scooter": {
        "grille": Marking("body", partial(outlines.laid, **machines.SCOOTER_GRILLE)),
        "trim": Marking("body", partial(outlines.laid, **machines.SCOOTER_TRIM)),
        "tail lamps": Marking("body", partial(outlines.laid, **machines.SCOOTER_TAIL)),
    },
    "wagon": {"seams": Marking("body", partial(boards.planks, count=4), "wooden")},
    "parachute": {"gores": Marking("canopy", partial(balls.sectors, count=6))},
}
