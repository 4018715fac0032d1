"""Markings of vehicles on land and on water."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    faces,
    frames,
    lattices,
    lettering,
    lines,
    panes,
    planks,
    rings,
    stripes,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import buses_and_trucks
from core.guidance.builtin.markings.rows.outlines import vehicles as own

AWNING = tuple((k / 3 - 1.15, k / 3 - 0.98) for k in range(7))
HUBS = Marking("wheels", rings.hub, every=True)
VEHICLES: Rows = {
    "school bus": {
        "windows": Marking(
            "body", partial(panes.vehicle_windows, **buses_and_trucks.SCHOOL_BUS_WINDOWS)
        ),
        "tail lamps": Marking("body", partial(outlines.laid, **buses_and_trucks.BUS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **buses_and_trucks.SCHOOL_BUS_TRIM)),
        "letters": Marking(
            "body", partial(lettering.on_sides, text="SCHOOL BUS", high=0.1, at=(0, 0.78))
        ),
        "stripe": Marking("body", partial(bands.belt, low=-0.32, high=-0.2)),
    },
    "bus": {
        "hubs": HUBS,
        "windows": Marking("body", partial(panes.vehicle_windows, **buses_and_trucks.BUS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **buses_and_trucks.BUS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **buses_and_trucks.BUS_TRIM)),
        "stripe": Marking("body", partial(bands.belt, low=-0.27, high=-0.13)),
    },
    "double decker bus": {
        "windows": Marking(
            "body", partial(panes.vehicle_windows, **buses_and_trucks.DOUBLE_DECKER_WINDOWS)
        ),
        "tail lamps": Marking(
            "body", partial(outlines.laid, **buses_and_trucks.DOUBLE_DECKER_TAIL)
        ),
        "trim": Marking("body", partial(outlines.laid, **buses_and_trucks.DOUBLE_DECKER_TRIM)),
        "stripe": Marking("body", partial(bands.belt, low=0.13, high=0.25)),
    },
    "truck": {
        "windows": Marking("cab", partial(panes.vehicle_windows, **buses_and_trucks.TRUCK_WINDOWS)),
        "lamps": Marking("cab", partial(outlines.laid, **buses_and_trucks.TRUCK_LAMPS)),
        "trim": Marking("cab", partial(outlines.laid, **buses_and_trucks.TRUCK_TRIM)),
        "seams": Marking("cargo", partial(outlines.laid, **buses_and_trucks.CARGO_SEAMS)),
    },
    "pickup truck": {
        "windows": Marking(
            "body", partial(panes.vehicle_windows, **buses_and_trucks.PICKUP_WINDOWS)
        ),
        "tail lamps": Marking("body", partial(outlines.laid, **buses_and_trucks.PICKUP_TAIL)),
        "seams": Marking("body", partial(outlines.laid, **buses_and_trucks.PICKUP_SEAMS)),
    },
    "monster truck": {
        "doors": Marking("body", partial(outlines.laid, **buses_and_trucks.MONSTER_DOORS)),
        "flames": Marking("body", partial(outlines.laid, **buses_and_trucks.FLAMES)),
    },
    "dump truck": {
        "trim": Marking("body", partial(outlines.laid, **buses_and_trucks.DUMPER_TRIM)),
    },
    "garbage truck": {
        "windows": Marking("cab", partial(outlines.laid, **buses_and_trucks.GARBAGE_WINDOWS)),
        "lamps": Marking("cab", partial(faces.round_eyes, at=(0.18, 0.2, 0.37), radius=0.075)),
    },
    "fire truck": {
        "windows": Marking("body", partial(panes.vehicle_windows, **buses_and_trucks.FIRE_WINDOWS)),
        "lockers": Marking("body", partial(outlines.laid, **buses_and_trucks.FIRE_LOCKERS)),
        "trim": Marking("body", partial(outlines.laid, **buses_and_trucks.FIRE_TRIM)),
        "stripe": Marking("body", partial(bands.belt, low=-0.6, high=-0.44)),
    },
    "trailer": {"stripes": Marking("awning", partial(bands.belts, spans=AWNING, axis=1))},
    "excavator": {
        "stripes": Marking("body", partial(outlines.laid, **buses_and_trucks.DIGGER_STRIPES)),
        "vents": Marking("body", partial(outlines.laid, **buses_and_trucks.DIGGER_VENTS)),
        "links": Marking("tracks", lines.links),
    },
    "tractor": {
        "grille": Marking("body", partial(outlines.laid, **buses_and_trucks.TRACTOR_GRILLE)),
        "lamps": Marking("body", partial(outlines.laid, **buses_and_trucks.TRACTOR_LAMPS)),
    },
    "tank": {
        "star": Marking("turret", partial(outlines.laid, **buses_and_trucks.TANK_STAR)),
        "links": Marking("tracks", lines.links),
        "vents": Marking("hull", partial(outlines.laid, **buses_and_trucks.TANK_VENTS)),
    },
    "rover": {
        "lines": Marking("panels", partial(lattices.grid, pitch=(0.11, 0.12))),
        "foil": Marking("body", partial(outlines.laid, **buses_and_trucks.ROVER_FOIL)),
    },
    "police car": {
        "windows": Marking("body", partial(panes.vehicle_windows, **own.CAR_WINDOWS)),
        "letters": Marking(
            "doors", partial(lettering.on_sides, text="POLICE", high=0.12, at=(0.08, -0.12))
        ),
        "doors": Marking("body", frames.car_doors),
    },
    "car": {
        "windows": Marking("body", partial(panes.vehicle_windows, **own.CAR_WINDOWS)),
        "number plates": Marking("body", partial(outlines.laid, **own.CAR_PLATES)),
        "tail lamps": Marking("body", partial(outlines.laid, **own.CAR_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **own.CAR_TRIM)),
    },
    "taxi": {
        "windows": Marking("body", partial(panes.vehicle_windows, **own.CAR_WINDOWS)),
        "trim": Marking("body", partial(outlines.laid, **own.TAXI_TRIM)),
        "letters": Marking("sign", partial(lettering.lettered, text="TAXI", high=0.5, bold=0.06)),
    },
    "sports car": {
        "windows": Marking("body", partial(panes.vehicle_windows, **own.SPORTS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **own.SPORTS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **own.SPORTS_TRIM)),
    },
    "race car": {
        "number": Marking("body", partial(lettering.race_number, disc=own.NOSE, text="7")),
        "visor": Marking("helmet", partial(outlines.laid, **own.VISOR)),
    },
    "jeep": {
        "hubs": HUBS,
        "windows": Marking("roof", partial(panes.vehicle_windows, **own.JEEP_WINDOWS)),
        "grille": Marking("body", partial(outlines.laid, **own.JEEP_GRILLE)),
    },
    "van": {
        "hubs": HUBS,
        "windows": Marking("body", partial(panes.vehicle_windows, **own.VAN_WINDOWS)),
        "number plates": Marking("body", partial(outlines.laid, **own.VAN_PLATES)),
        "tail lamps": Marking("body", partial(outlines.laid, **own.VAN_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **own.VAN_TRIM)),
    },
    "ambulance": {
        "windows": Marking("body", partial(panes.vehicle_windows, **own.AMBULANCE_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **own.VAN_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **own.AMBULANCE_TRIM)),
        "cross": Marking("body", badges.kit_on_sides),
    },
    "camper": {"hubs": HUBS},
    "cement mixer": {"hubs": HUBS},
    "forklift": {"hubs": HUBS},
    "golf cart": {
        "lamps": Marking("body", partial(outlines.laid, **own.CART_LAMPS)),
        "trim": Marking("body", partial(outlines.laid, **own.CART_TRIM)),
    },
    "wheel": {
        "stripe": Marking("tyre", partial(outlines.laid, **own.TYRE_STRIPE)),
    },
    "boat": {
        "anchor": Marking("sails", partial(outlines.laid, **own.ANCHOR)),
        "stripe": Marking("hull", partial(bands.flank, low=0.4, high=0.66, out=0.84)),
        "keel": Marking("hull", partial(bands.belt, low=-2.0, high=-0.3)),
    },
    "rowboat": {"seams": Marking("hull", partial(planks.planks, count=5), "wooden")},
    "sailboat": {
        "anchor": Marking("sails", partial(outlines.laid, **own.ANCHOR)),
        "keel": Marking("hull", partial(bands.belt, low=-2.0, high=-0.4)),
    },
    "yacht": {
        "portholes": Marking("hull", partial(outlines.laid, **own.YACHT_PORTS)),
    },
    "jet ski": {
        "trim": Marking("cowl", partial(outlines.laid, **own.SKI_TRIM)),
        "ribs": Marking("saddle", partial(bands.belts, spans=own.SADDLE_RIBS, axis=1)),
    },
    "pirate ship": {"seams": Marking("hull", partial(planks.planks, count=10), "wooden")},
    "cargo ship": {
        "ribs": Marking("containers", lines.container_ribs, by="hull"),
        "ridges": Marking("boxes", lines.container_ribs, by="hull"),
    },
    "cruise ship": {
        "portholes": Marking("hull", partial(outlines.laid, **own.PORTHOLES)),
    },
    "submarine": {
        "windows": Marking("hull", partial(outlines.laid, **own.SUB_PORTS)),
        "rims": Marking("hull", partial(outlines.laid, **own.SUB_RIMS)),
        "keel": Marking("hull", partial(bands.belt, low=-2.0, high=-0.3)),
    },
    "train": {
        "windows": Marking("cab", partial(panes.vehicle_windows, **own.TRAIN_WINDOWS)),
        "bands": Marking("boiler", partial(bands.belts, spans=own.BOILER_BANDS, axis=1)),
    },
    "tram": {
        "lamps": Marking("body", partial(outlines.laid, **own.TRAM_LAMPS)),
        "sign": Marking("body", partial(outlines.laid, **own.TRAM_SIGN)),
        "windows": Marking("body", partial(outlines.laid, **own.TRAM_WINDOWS)),
        "doors": Marking("body", partial(outlines.laid, **own.TRAM_DOORS)),
        "stripe": Marking("body", partial(bands.belt, low=-0.62, high=-0.28)),
    },
    "motorcycle": {
        "fins": Marking("engine", partial(outlines.laid, **own.ENGINE_FINS)),
    },
    "scooter": {
        "grille": Marking("body", partial(outlines.laid, **own.SCOOTER_GRILLE)),
        "trim": Marking("body", partial(outlines.laid, **own.SCOOTER_TRIM)),
        "tail lamps": Marking("body", partial(outlines.laid, **own.SCOOTER_TAIL)),
    },
    "wagon": {"seams": Marking("body", partial(planks.planks, count=4), "wooden")},
    "parachute": {"gores": Marking("canopy", partial(stripes.sectors, count=6))},
}
