"""Markings of buildings and street furniture: windows, frames, doors, roofs, panels."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    dials,
    lattices,
    lettering,
    panes,
    planks,
    rings,
    tiles,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import buildings as own


def _glazed(
    openings: tuple[panes.Opening, ...],
    grid: tuple[int, int] = (2, 2),
    on: str = "walls",
    name: str = "windows",
    frame: float = panes.FRAME,
    sill: float = panes.SILL,
) -> dict[str, Marking]:
    """Windows in frames."""
    return {
        "frames": Marking(name, partial(panes.frames, openings=openings, grid=grid)),
        name: Marking(on, partial(panes.windows, openings=openings, frame=frame, sill=sill)),
    }


def _openings(
    face: str,
    us: tuple[float, ...],
    vs: tuple[float, ...],
    size: tuple[float, float],
    head: str = "",
    depth: float = 0.7,
) -> tuple[panes.Opening, ...]:
    """Equal windows in rows."""
    return tuple(panes.Opening(face, (u, v), size, head, depth) for v in vs for u in us)


HOUSE_WINDOWS = (
    *_openings("front", (-0.61, 0.61), (0.14,), (0.19, 0.38)),
    *_openings("back", (-0.5, 0.5), (0.14,), (0.19, 0.38)),
    *_openings("sides", (-0.42, 0.42), (0.14,), (0.22, 0.38)),
)
COTTAGE_FRONT = _openings("front", (-0.63, 0.63), (-0.44,), (0.17, 0.25))
COTTAGE_WINDOWS = (
    *COTTAGE_FRONT,
    *_openings("front", (0.0,), (0.2,), (0.15, 0.17), "arched"),
    *_openings("back", (-0.4, 0.4), (-0.44,), (0.17, 0.25)),
    *_openings("back", (0.0,), (0.2,), (0.15, 0.17), "arched"),
    *_openings("sides", (-0.42, 0.42), (-0.56,), (0.17, 0.2)),
)
CHURCH_WINDOWS = (
    *_openings("front", (0.0,), (0.13,), (0.25, 0.25), "round"),
    *_openings("sides", (-0.23, 0.13, 0.49), (-0.56,), (0.075, 0.2), "arched"),
    *_openings("back", (0.0,), (-0.55,), (0.2, 0.2), "arched"),
)
TOWER_WINDOWS = tuple(
    one
    for face in ("front", "back", "sides")
    for one in _openings(face, (0.0,), (0.28,), (0.12, 0.2), "arched", 0.5)
)
LIGHT_WINDOWS = tuple(
    one
    for face in ("front", "back", "sides")
    for one in _openings(face, (0.0,), (0.0, 0.55), (0.16, 0.09), "arched", 0.3)
)
CASTLE_WINDOWS = tuple(
    one
    for face in ("front", "back", "sides")
    for one in (
        *_openings(face, (-0.71, 0.71), (-0.24,), (0.07, 0.14), "arched"),
        *_openings(face, (0.0,), (0.52,), (0.08, 0.12), "arched", 0.2),
    )
)
MILL_WINDOWS = (
    *_openings("sides", (0.0,), (0.2,), (0.19, 0.15), "", 0.4),
    *_openings("front", (0.0,), (0.2,), (0.19, 0.15), "", 0.4),
    *_openings("back", (0.0,), (-0.35, 0.2), (0.19, 0.15), "", 0.4),
)
FACTORY_WINDOWS = (
    *_openings("front", (-0.667, 0.0, 0.667), (0.16,), (0.23, 0.27)),
    *_openings("sides", (-0.58, 0.1), (0.0,), (0.25, 0.27)),
)
FACTORY_GATES = (
    panes.Opening("front", (0.0, -0.68), (0.22, 0.36)),
    panes.Opening("front", (0.667, -0.72), (0.11, 0.32)),
)
SHOP_WINDOWS = (
    *_openings("front", (0.0,), (-0.43,), (0.86, 0.33)),
    *_openings("sides", (0.0,), (-0.4,), (0.62, 0.26)),
    *_openings("sides", (-0.4, 0.4), (0.42,), (0.2, 0.2)),
    *_openings("back", (-0.45, 0.45), (0.42, -0.4), (0.2, 0.2)),
)
SCHOOL_WINDOWS = (
    *_openings("front", (-0.81, -0.51, 0.51, 0.81), (-0.54, -0.06), (0.1, 0.15), "", 0.5),
    *_openings("back", (-0.81, -0.51, -0.17, 0.17, 0.51, 0.81), (-0.54, -0.06), (0.1, 0.15)),
    *_openings("sides", (-0.45, 0.1, 0.62), (-0.54, -0.06), (0.15, 0.15)),
)
HOSPITAL_WINDOWS = (
    *_openings("front", (-0.77, 0.77), (-0.62, -0.24), (0.13, 0.12), "", 0.5),
    *_openings("front", (-0.36, 0.0, 0.36), (-0.05,), (0.11, 0.1)),
    *_openings("front", (-0.38, 0.38), (-0.62,), (0.1, 0.13)),
    *_openings("back", (-0.77, 0.77), (-0.62, -0.24), (0.13, 0.12), "", 0.5),
    *_openings("back", (-0.33, 0.0, 0.33), (-0.62, -0.24), (0.11, 0.12)),
    *_openings("sides", (-0.28, 0.38), (-0.62, -0.24), (0.22, 0.12)),
    *_openings("sides", (-0.44, 0.44), (0.34, 0.7), (0.27, 0.11), "", 0.3),
)
TREE_WINDOWS = (
    *_openings("front", (0.44,), (0.1,), (0.26, 0.42)),
    *_openings("sides", (0.0,), (0.1,), (0.36, 0.42)),
    *_openings("back", (-0.45,), (0.1,), (0.26, 0.42)),
)
MODERN_DOOR = _openings("front", (0.0,), (-0.22,), (0.115, 0.78))
WHOLE_FRONT = _openings("front", (0.0,), (0.0,), (1.0, 1.0), "", 0.0)
BUILDINGS: Rows = {
    "house": {
        "panels": Marking("door", panes.door_panels),
        **_glazed(HOUSE_WINDOWS),
        "seams": Marking("roof", tiles.tiles),
    },
    "cottage": {
        "panels": Marking("door", panes.door_panels),
        **_glazed(COTTAGE_WINDOWS),
        "shutters": Marking("walls", partial(panes.shutters, openings=COTTAGE_FRONT, wide=0.5)),
    },
    "hut": {
        "zigzags": Marking(
            "walls", partial(bands.bordered_zigzag, at=0.0, count=16, high=0.13, wide=0.022)
        ),
    },
    "log cabin": {"mullions": Marking("window", partial(panes.frames, openings=WHOLE_FRONT))},
    "treehouse": _glazed(TREE_WINDOWS),
    "modern house": {
        "mullions": Marking("windows", partial(planks.boarding, pitch=0.28, wide=0.014)),
        "slats": Marking("garage", partial(planks.planks, count=5, wide=0.012)),
        "door": Marking("walls", partial(panes.panes, openings=MODERN_DOOR, grid=(1, 1))),
    },
    "skyscraper": {
        "mullions": Marking("windows", partial(planks.boarding, pitch=0.11, wide=0.014))
    },
    "barn": {
        "trim": Marking("walls", panes.barn_trim),
        "door": Marking("walls", panes.barn_door),
        "hay": Marking("walls", partial(panes.panes, openings=(panes.LOFT,), grid=(1, 1))),
        "windows": Marking("walls", partial(panes.panes, openings=panes.BARN_WINDOWS)),
        "seams": Marking("walls", planks.boarding, "wooden"),
    },
    "shop": {
        "letters": Marking("sign", partial(lettering.lettered, text="OPEN", high=0.3)),
        "frames": Marking("window", partial(panes.frames, openings=SHOP_WINDOWS)),
        "window": Marking("walls", partial(panes.windows, openings=SHOP_WINDOWS)),
    },
    "school": _glazed(SCHOOL_WINDOWS, (1, 2), frame=0.016, sill=0.014),
    "hospital": _glazed(HOSPITAL_WINDOWS, (2, 1), frame=0.018, sill=0.014),
    "factory": {
        "slats": Marking("gate", partial(planks.planks, count=9, wide=0.01)),
        "gate": Marking("hall", partial(panes.windows, openings=FACTORY_GATES, sill=0.0)),
        **_glazed(FACTORY_WINDOWS, (4, 2), "hall"),
    },
    "gas station": {
        "letters": Marking("band", partial(lettering.lettered, text="GAS", high=0.085, bold=0.06))
    },
    "church": {
        "panels": Marking("door", partial(panes.door_panels, rows=((-0.84, 0.84),))),
        "cross": Marking("walls", partial(badges.stamp, shape="cross", size=0.24, at=(0.0, 0.62))),
        **_glazed(CHURCH_WINDOWS),
        "seams": Marking("roof", partial(tiles.tiles, axis=1)),
    },
    "castle": {
        "seams": Marking("door", partial(planks.planks, count=5, axis=0, wide=0.012)),
        **_glazed(CASTLE_WINDOWS, (1, 1)),
    },
    "tower": {
        "seams": Marking("door", partial(planks.planks, count=5, axis=0, wide=0.012)),
        **_glazed(TOWER_WINDOWS, (1, 1), frame=0.035),
    },
    "lighthouse": {
        "bars": Marking("lantern", partial(planks.staves, count=8, wide=0.016)),
        **_glazed(LIGHT_WINDOWS, (1, 2), "tower"),
    },
    "windmill": {
        "windows": Marking("walls", partial(panes.panes, openings=MILL_WINDOWS)),
        "lattice": Marking("sails", lattices.diagonals),
    },
    "temple": {
        "frieze": Marking("beam", partial(outlines.laid, **own.TEMPLE_FRIEZE)),
        "seams": Marking("roof", partial(tiles.tiles, axis=1, pitch=(0.07, 0.12), wide=0.005)),
    },
    "gate": {
        "plaque": Marking("piers", partial(outlines.laid, **own.PIER_PLAQUE), paired=True),
        "joints": Marking("piers", partial(tiles.courses, pitch=(0.16, 0.26)), paired=True),
    },
    "wall": {"joints": Marking("base", partial(planks.planks, count=9, axis=0, wide=0.011))},
    "bridge": {
        "bands": Marking("posts", partial(bands.belts, spans=own.POST_BANDS)),
        "joints": Marking("road", partial(planks.planks, count=16, axis=0, wide=0.01)),
    },
    "fountain": {
        "tiles": Marking("basin", partial(tiles.mosaic, spans=own.BASIN_TILES, count=36)),
        "lines": Marking("bowl", partial(bands.belts, spans=own.BOWL_LINES)),
        "bands": Marking("column", partial(bands.belts, spans=own.COLUMN_BANDS)),
    },
    "staircase": {
        "carpet": Marking("treads", partial(bands.carpet, wide=0.56), of="wooden"),
        "runner": Marking("body", partial(bands.carpet, wide=0.58, back=0.97), of="wooden"),
        "panels": Marking("body", partial(outlines.laid, **own.STAIR_PANELS)),
    },
    "bus stop": {
        "letters": Marking("sign", partial(lettering.lettered, text="BUS", high=0.5, bold=0.06))
    },
    "phone booth": {
        "letters": Marking("sign", partial(outlines.laid, **own.BOOTH_LETTERS)),
        "sign": Marking("body", partial(outlines.laid, **own.BOOTH_SIGN)),
        "windows": Marking("body", partial(outlines.laid, **own.BOOTH_WINDOWS)),
        "seams": Marking("body", partial(outlines.laid, **own.BOOTH_SEAMS)),
    },
    "parking meter": {
        "marks": Marking("window", dials.meter_marks, by="head"),
        "badge": Marking("head", partial(outlines.laid, **own.METER_BADGE)),
    },
    "gas pump": {
        "marks": Marking("face", partial(outlines.laid, **own.PUMP_MARKS), by="body"),
        "star": Marking("globe", partial(outlines.laid, **own.GLOBE_STAR)),
    },
    "vending machine": {
        "letters": Marking(
            "body", partial(lettering.on_sides, text="DRINKS", high=0.34, at=(0, 0.5))
        ),
        "stripes": Marking("body", partial(outlines.laid, **own.VENDING_STRIPES)),
    },
    "market stall": {
        "apples": Marking(
            "fruit", partial(bands.belts, spans=own.STALL_APPLES, axis=0), by="shelf"
        ),
        "panels": Marking("counter", partial(outlines.laid, **own.STALL_PANELS)),
    },
    "dumpster": {
        "arrows": Marking(
            "body", partial(badges.recycling, at=((-0.31, -0.05), (0.31, -0.05)), size=0.5)
        ),
    },
    "shipping container": {
        "letters": Marking("ribs", lettering.rib_letters, by="body"),
        "ridges": Marking("body", partial(outlines.laid, **own.CONTAINER_RIDGES)),
    },
    "crane": {
        "gaps": Marking("mast", partial(lattices.truss, along=2, count=4, room=(-0.7, 0.7))),
        "holes": Marking("jib", partial(lattices.truss, along=1, count=7, room=(-0.2, 0.7))),
    },
    "water tower": {
        "seams": Marking("tank", partial(planks.staves, count=18)),
        "ridges": Marking("roof", partial(rings.spokes, count=12, wide=0.014, reach=(0.12, 2.0))),
    },
    "solar panel": {"cells": Marking("lines", tiles.solar_cells)},
}
