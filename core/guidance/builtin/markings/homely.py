"""Markings of the home: doors, seats, beds, baths, shelves; and of what is eaten, worn, wielded.

Most are outlines on a thing's sides (:mod:`core.guidance.builtin.markings.outlines`).
"""

import math
from collections.abc import Sequence

import torch
import torch.nn.functional as F

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    cells_around,
    chance,
    in_front,
    within,
)
from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Pair,
    Plate,
    Poly,
    laid,
)
from core.guidance.builtin.markings.stencils import lettering


def door_trim(points: Points, half: Half, room: float = 0.067) -> Margin:
    """A frame on each of a door's panels one above another, by one panel's box; ``room``: half of
    what is between two."""
    pitch = 2 * (half[2] + room)
    x, y, z = points.unbind(1)
    moved = torch.stack([x, y, z - (z / pitch).round() * pitch], 1)
    frame = Plate((0, 0), (0.74, 0.72), 0.08, 0.018)
    return laid(moved, half, front=(frame,), back=(frame,), deep=0.0)


def coil(points: Points, half: Half, reach: float, pitch: float = 0.036) -> Margin:
    """The turns of a rope about the middle of what lies along x; its reach in halves."""
    at = points[:, 0] / pitch
    turn = (0.4 - (at - at.round()).abs()) * pitch
    return all_of(turn, reach * half[0] - points[:, 0].abs())


def nailed(
    points: Points, half: Half, corners: Sequence[Pair], count: int, size: float, deep: float = 0.0
) -> Margin:
    """Round heads, ``count`` along each side of a polygon on the front, in halves; the radius in
    halves of the width."""
    ends = points.new_tensor(corners) * half[[0, 2]]
    share = (torch.arange(count).to(points) / count)[:, None, None]
    heads = (ends + share * (ends.roll(-1, 0) - ends)).reshape(-1, 2)
    away = torch.cdist(points[:, [0, 2]], heads).amin(1)
    return all_of(size * half[0] - away, -points[:, 1] - deep * half[1])


def pool_water(points: Points, half: Half, size: Pair, at: float, high: Pair) -> Margin:
    """What stands in a bowl: the half sides of an oval seen from above and how far back its middle
    is, and between which heights, in halves."""
    x, y, z = (points / half).unbind(1)
    away = torch.hypot(x / size[0], (y - at) / size[1])
    return all_of((1 - away) * size[0] * half[0], (z - high[0]) * half[2], (high[1] - z) * half[2])


def foam(points: Points, half: Half) -> Margin:
    """Heaps of it on the water, at both ends."""
    x, y, _ = points.unbind(1)
    heaps = ((-0.62, 0.1, 0.2), (-0.42, -0.25, 0.16), (-0.3, 0.3, 0.12), (-0.75, -0.2, 0.14),
             (-0.1, 0.05, 0.08), (0.1, -0.32, 0.1), (0.24, -0.18, 0.06),
             (0.2, 0.4, 0.09))  # fmt: skip
    return any_of(
        *(size * half[0] - torch.hypot(x - u * half[0], y - v * half[1]) for u, v, size in heaps)
    )


def carpet(points: Points, half: Half, wide: float = 0.6, back: float = 2.0) -> Margin:
    """A runner up the middle of a stair, not on what is farther back; in halves."""
    return all_of(wide * half[0] - points[:, 0].abs(), back * half[1] - points[:, 1])


def zigzags(points: Points, half: Half, at: float, count: int, high: float, wide: float) -> Margin:
    """A zigzag about a round wall between two level lines, its height in halves."""
    up = points[:, 2] - at * half[2]
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    rise = high * half[2] * (4 * (turn - turn.round()).abs() - 1)
    steep = 4 * high * half[2] * count / (math.tau * half[0])
    line = wide - (up - rise).abs() / torch.sqrt(1 + steep * steep)
    return any_of(line, 0.8 * wide - (up.abs() - 1.9 * high * half[2]).abs())


def quilt(points: Points, _half: Half, pitch: float, wide: float = 0.008) -> Margin:
    """Slanted seams that cross, as they are seen from above."""
    x, y = points[:, 0] / pitch, points[:, 1] / pitch
    one, other = (x + y) / 2, (x - y) / 2
    away = torch.minimum((one - one.round()).abs(), (other - other.round()).abs())
    return wide - away * (pitch * math.sqrt(2))


def mosaic(points: Points, half: Half, spans: Sequence[Pair], count: int) -> Margin:
    """Squares side by side all round, each three quarters of its room."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y) * (count / math.tau)
    across = (0.38 - (turn - turn.round()).abs()) * (math.tau / count) * torch.hypot(x, y)
    rows = (all_of(z - low * half[2], high * half[2] - z) for low, high in spans)
    return all_of(across, any_of(*rows))


def sprinkles(
    points: Points, _half: Half, pitch: float = 0.075, long: float = 0.03, wide: float = 0.013
) -> Margin:
    """Short strokes in all directions, one in most cells of a lattice; the same on every object."""
    margin = torch.full_like(points[:, 0], -pitch)
    for cell in cells_around(points, pitch):
        moved, way = (
            torch.stack([chance(cell, k + first) for k in range(3)], 1) - 0.5 for first in (0, 5)
        )
        off = points - (cell + 0.5 + 0.5 * moved) * pitch
        way = F.normalize(way, dim=1)
        along = (off * way).sum(1).clamp(-long, long)
        stroke = wide - (off - along[:, None] * way).norm(dim=1)
        margin = torch.where(chance(cell, 4) < 0.55, torch.maximum(margin, stroke), margin)
    return margin


def sauce(points: Points, half: Half, down: float = 0.72, count: int = 6) -> Margin:
    """What runs down from the top of a ball of ice in bows; how far, in halves of the width."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y)
    bows = 0.13 * (count * turn).cos() + 0.06 * (2 * turn + 1).sin()
    return 0.8 * (z - half[2] + (down + bows) * half[0])


def grill_marks(points: Points, half: Half, high: float, pitch: float = 0.2) -> Margin:
    """Slanted ones on the top of what lies on the bearer of the box, from ``high`` above that, in
    halves of its width."""
    phase = (points[:, 0] + points[:, 1]) / (pitch * math.sqrt(2))
    line = (0.13 - (phase - phase.round()).abs()) * pitch
    return all_of(line, points[:, 2] - half[2] - high * half[0])


def written_up(
    points: Points, half: Half, text: str, high: float, at: float, bold: float = 0.05
) -> Margin:
    """Letters on the front that are read upwards: how high, and where their middle is, in halves
    of the width and of the height."""
    size = high * half[0]
    place = torch.stack([points[:, 2] - at * half[2], -points[:, 0]], 1) / size
    return all_of((lettering(place, text) + bold) * size, in_front(points))


def studs(
    points: Points,
    half: Half,
    count: int,
    size: float,
    at: float = 0.0,
    axis: int = 2,
    out: float = 0.0,
) -> Margin:
    """Round heads in a ring about an axis, their place along it and how far ``out`` they begin in
    halves; the radius in training units."""
    one, other = (k for k in range(3) if k != axis)
    u, v = points[:, one] / half[one], points[:, other] / half[other]
    turn = torch.atan2(u, -v) * (count / math.tau)
    across = (turn - turn.round()) * (math.tau / count) * points[:, [one, other]].norm(dim=1)
    head = size - torch.hypot(across, points[:, axis] - at * half[axis])
    return all_of(head, (torch.hypot(u, v) - out) * half[one])


def through(points: Points, half: Half, corners: Sequence[Pair]) -> Margin:
    """A polygon seen from the front, on both sides alike, in halves."""
    return within(points[:, [0, 2]], points.new_tensor(corners) * half[[0, 2]])


def cross_quilt(points: Points, _half: Half, pitch: float, wide: float = 0.008) -> Margin:
    """Slanted seams that cross, as they are seen from the front."""
    return quilt(points[:, [0, 2, 1]], _half, pitch, wide)


def brim(points: Points, half: Half, low: float, high: float) -> Margin:
    """Between two ovals about a hat, in halves, not on its crown."""
    away = (points[:, :2] / half[:2]).norm(dim=1)
    return all_of(away - low, high - away) * torch.minimum(half[0], half[1])


def underside(points: Points, half: Half, high: float = 0.05) -> Margin:
    """The lowest of a cap, its share of the height."""
    return (2 * high - 1) * half[2] - points[:, 2]


def gills(points: Points, half: Half, count: int = 40, wide: float = 0.008) -> Margin:
    """Lines outwards on the underside of a cap, not on its border."""
    x, y = points[:, 0], points[:, 1]
    turn = torch.atan2(x, y) * (count / math.tau)
    away = torch.hypot(x, y)
    line = wide - (turn - turn.round()).abs() * (math.tau / count) * away
    return all_of(line, 0.94 * half[0] - away)


def snow(points: Points, half: Half, tiers: int = 4, step: float = 0.45) -> Margin:
    """On the edges of a fir's tiers, with a wavy border above."""
    x, y, z = points.unbind(1)
    wave = 0.03 * (torch.atan2(x, -y) * 9).cos()
    up = z / half[2] + 1
    tier = (up / step).floor().clamp(0, tiers - 1)
    return (0.17 + wave - (up - tier * step)) * half[2]


DOOR_LOCK = {
    "front": (Plate((0.8, -0.15), (0.12, 0.15), 0.4),),
    "back": (Plate((-0.8, -0.15), (0.12, 0.15), 0.4),),
}
DOOR_KEYHOLE = {
    "front": (Disc((0.8, -0.21), 0.05), Line(((0.8, -0.21), (0.8, -0.25)), 0.009)),
    "back": (Disc((-0.8, -0.21), 0.05), Line(((-0.8, -0.21), (-0.8, -0.25)), 0.009)),
}
DOOR_HINGES = {
    "front": tuple(Plate((-0.8, at), (0.22, 0.03), 0.9) for at in (-0.72, 0.74)),
    "back": tuple(Plate((0.8, at), (0.22, 0.03), 0.9) for at in (-0.72, 0.74)),
}
_GABLE = (
    Poly(((-0.66, -0.8), (0.66, -0.8), (0.0, 0.54))),
    *(Line(((at, -1), (at, 1)), 0.008, gap=True) for at in (-0.36, -0.12, 0.12, 0.36)),
)
WELL_GABLE = {"front": _GABLE, "back": _GABLE, "deep": 0.9}
MIRROR_GEMS = {
    "front": (Emblem((0, 0.93), 0.12, "diamond"), Emblem((0, -0.93), 0.12, "diamond"),
              Emblem((0.865, 0), 0.12, "diamond", twice=True)),
    "deep": -0.5,
}  # fmt: skip
MIRROR_BACK = {
    "back": (
        Plate((0, 0), (0.66, 0.78), 0.9),
        Plate((0, 0), (0.54, 0.68), 0.9, 0.012, gap=True),
    ),
    "deep": 0.3,
}
THRONE_BUTTONS = {
    "front": (*(Disc((0.44, at), 0.14, twice=True) for at in (0.7, 0.3)),
              *(Disc((0.0, at), 0.14) for at in (0.5, 0.1))),
    "deep": -1.2,
    "until": 0.95,
}  # fmt: skip
_THRONE = (Plate((0, -0.12), (0.66, 0.7), 0.05, 0.02), Emblem((0, 0.12), 0.42, "crown"))
THRONE_PANELS = {
    "back": _THRONE,
    "front": (Plate((0, -0.78), (0.62, 0.1), 0.2),),
    "sides": (Plate((0.0, -0.68), (0.6, 0.16), 0.1, 0.016),),
    "deep": 0.5,
}
THRONE_STEP = {
    "top": (Plate((0, 0), (0.9, 0.9), 0.05, 0.018),),
    "front": (Plate((0, 0), (0.92, 0.3), 0.2, 0.009),),
    "back": (Plate((0, 0), (0.92, 0.3), 0.2, 0.009),),
    "sides": (Plate((0, 0), (0.92, 0.3), 0.2, 0.009),),
}
_LID = ((-0.61, -0.985), (-1.0, 0.41), (-0.66, 0.985), (0.66, 0.985), (1.0, 0.41), (0.61, -0.985))
COFFIN_NAILS = tuple((0.86 * x, 0.935 * z) for x, z in _LID)
COFFIN_SEAMS = {
    "back": (*(Line(((at, -1), (at, 1)), 0.012) for at in (-0.5, 0.0, 0.5)),
             *(Line(((-1, at), (1, at)), 0.012) for at in (-0.6, 0.42))),
    "deep": 0.3,
}  # fmt: skip
TOILET_SEAMS = {
    side: (Line(((-1.2, 0.5), (1.2, 0.5)), 0.01), Plate((0, -0.26), (0.76, 0.52), 0.2, 0.011))
    for side in ("front", "back", "sides")
}
BATH_BANDS = ((0.16, 0.24), (-0.02, 0.02))
SINK_PANEL = {
    side: (Plate((0, 0.02), (0.84, 0.6), 0.3, 0.012),) for side in ("front", "back", "sides")
}
SINK_BANDS = ((-0.84, -0.78), (0.62, 0.68))
_SIGHTS = (
    *(Disc((at, 0.91), 0.028, twice=True) for at in (0.22, 0.46, 0.7)),
    *(Disc((at, -0.91), 0.028, twice=True) for at in (0.22, 0.46, 0.7)),
    *(Disc((0.945, at), 0.028, twice=True) for at in (-0.4, 0.0, 0.4)),
)
POOL_SIGHTS = {"top": _SIGHTS, "deep": 0.3}
POOL_LINES = {
    "top": (Line(((-0.5, -0.84), (-0.5, 0.84)), 0.009), Disc((0.5, 0), 0.03)),
    "deep": -2.0,
}
_SLATS = tuple(Line(((at, -1.2), (at, 1.2)), 0.009) for at in (-0.5, 0.0, 0.5))
CHAIR_SEAMS = {"top": _SLATS, "deep": 0.3}
OTTOMAN_NAILS = {
    side: (Cells((0, -0.78), (0.92, 0.09), (11, 1), (0.42, 1), 0.95),)
    for side in ("front", "back", "sides")
} | {"deep": 0.7}
COFFEE_SEAMS = {
    "top": tuple(Line(((-1.2, at), (1.2, at)), 0.009) for at in (-0.6, -0.2, 0.2, 0.6)),
    "deep": 0.2,
}
SHELF_VOLUMES, SHELF_TOMES = ((-0.648, -0.444),), ((-0.444, -0.1),)
SHELF_BANDS = ((1.5, 2.1), (3.9, 4.3))
VASE_STRIPES = ((-0.36, -0.18), (-0.08, -0.02), (0.86, 1.2))
THRONE_GEMS = {
    "front": (Emblem((0, -0.78), 0.16, "diamond"), Emblem((0, 0.9), 0.16, "diamond")),
    "deep": -1.2,
}
TOILET_HINGES = {"top": (Plate((0.42, 0.86), (0.14, 0.06), 0.6, twice=True),), "deep": 0.0}
CRIB_HEARTS = {
    "sides": (Emblem((0, 0.36), 0.4, "heart"),),
    "aside": 0.86,
}
CRIB_STARS = {
    "top": tuple(
        Emblem(at, 0.2, "star")
        for at in ((-0.7, -0.55), (-0.7, 0.55), (0.0, 0.0), (0.7, -0.55), (0.7, 0.55))
    ),
    "deep": 0.0,
}
BED_TRIM = ((-0.62, -0.4), (0.66, 0.82))
_STAIR = Line(((-0.52, -0.84), (0.84, -0.84), (0.84, 0.46), (-0.52, -0.84)), 0.016)
STAIR_PANELS = {
    "sides": (_STAIR,),
    "back": (Plate((0, 0), (0.8, 0.86), 0.05, 0.016),),
    "deep": 0.9,
}
STALL_APPLES = ((-0.31, 0.31),)
STALL_PANELS = {
    side: (Cells((0, -0.06), (0.94, 0.8), (many, 1), (0.82, 1.0), 0.1),
           Cells((0, -0.06), (0.94, 0.8), (many, 1), (0.6, 0.78), 0.1, gap=True))
    for side, many in (("front", 3), ("back", 3), ("sides", 1))
} | {"deep": 0.8}  # fmt: skip
_GABLE_SUN = (
    Cells((0, -0.72), (0.96, 0.16), (9, 1), (0.5, 1)),
    Disc((0, 0.02), 0.5, 0.011),
    Emblem((0, 0.02), 0.36, "sun"),
)
TEMPLE_FRIEZE = {
    "front": _GABLE_SUN,
    "back": _GABLE_SUN,
    "sides": (Cells((0, -0.72), (0.96, 0.16), (13, 1), (0.5, 1)),),
    "deep": 0.9,
}
POST_BANDS = ((0.5, 0.62), (-0.84, -0.7))
BASIN_TILES = ((-0.12, 0.36),)
BOWL_LINES = ((0.5, 0.66), (0.3, 0.38))
COLUMN_BANDS = ((-0.5, -0.42), (0.0, 0.06), (-0.36, -0.32))
PIER_PLAQUE = {"front": (Plate((0, 0.42), (0.5, 0.16), 0.3),), "deep": 0.8}
CAKE_CREAM = ((-0.6, -0.4),)
RIND_LABEL = {
    "back": (Disc((0, 0), 0.72), Disc((0, 0), 0.6, 0.012, gap=True),
             Emblem((0, 0.02), 0.36, "crown", gap=True)),
    "deep": 0.2,
}  # fmt: skip
BASIL = {
    "top": tuple(
        Emblem(at, 0.1, "leaf")
        for at in ((0.12, 0.14), (-0.36, 0.5), (0.48, -0.4), (-0.55, -0.26), (0.2, 0.66),
                   (-0.08, -0.62), (0.66, 0.3), (-0.2, -0.05), (-0.7, 0.2))
    ),
    "deep": -1.0,
}  # fmt: skip
WRAPPER_NAME = {"front": (Emblem((0, 0), 0.42, text="CHOCO"),), "deep": 0.0}
WRAPPER_BORDER = {
    "back": (Plate((0, 0), (0.84, 0.72), 0.1, 0.014), Emblem((0, 0), 0.4, "heart")),
    "sides": (Plate((0, 0), (0.66, 0.78), 0.1, 0.014),),
}
DISH_BANDS = ((0.42, 0.6),)
FERRULE_BANDS = ((-0.7, -0.4), (0.4, 0.7))
PENCIL_RINGS = ((-0.95, -0.91), (-0.89, -0.87))
CASE_LINES = ((-0.9, -0.8), (-0.74, -0.7))
MONOGRAM = {"front": (Emblem((0, 0), 0.4, "heart"),), "deep": 0.0}
TUBE_GROOVES = ((0.0, 0.06), (0.5, 0.56), (0.68, 0.72))
LABEL_FLOWER = {"front": (Emblem((0, 0), 0.56, "flower"),), "deep": -0.2}
LABEL_EDGE = {"front": (Plate((0, 0), (0.84, 0.84), 0.9, 0.01),), "deep": -0.2}
COLLAR_GROOVES = ((-0.4, -0.3), (0.0, 0.1), (0.4, 0.5))
BADGE_STAR = {"front": (Emblem((0, 0), 0.66, "star"),), "deep": 0.0}
SAW_NAME = {
    side: (Emblem((0.16 * sign, 0.12), 0.3, text="F3D"),
           Line(((-0.7 * sign, 0.06), (-0.36 * sign, 0.1)), 0.012))
    for side, sign in (("front", 1), ("back", -1))
}  # fmt: skip
KNIFE_EDGE = ((-1.3, -1.0), (-0.55, -1.0), (-0.5, -0.1), (-0.25, 0.4), (0.3, 0.9), (0.3, 1.2),
              (-1.3, 1.2))  # fmt: skip
HAMMER_RIDGES = tuple((-0.86 + 0.09 * k, -0.82 + 0.09 * k) for k in range(7))
HAMMER_BANDS = ((-0.94, -0.86), (-0.56, -0.48))
RUNES = {
    side: (Emblem((0.48, 0.0), 0.52, "lightning bolt", twice=True),) for side in ("front", "back")
} | {"deep": 0.6}
RIBBON_EDGES = {side: (Plate((0.84, 0), (0.07, 3), twice=True),) for side in ("front", "back")} | {
    "deep": -1.0
}
RING_GROOVES = ((-0.7, -0.54), (0.54, 0.7))
GLOVE_MOTIF = {
    "front": (Emblem((-0.12, -0.14), 0.42, "snowflake"),),
    "back": (Emblem((0.12, -0.14), 0.42, "snowflake"),),
    "deep": -1.0,
}
CUFF_RIBS = {
    side: (Cells((0, 0), (1.0, 1.2), (11, 1), (0.36, 1)),) for side in ("front", "back")
} | {"deep": 0.3}
FLAP_PIPING = {
    "front": (Line(((-0.86, 1.2), (-0.86, -0.42), (0, -0.78), (0.86, -0.42), (0.86, 1.2)), 0.014),),
    "deep": -1.0,
}
HAT_BUCKLE = {"front": (Plate((0, 0), (0.24, 0.74), 0.2, 0.022),), "deep": 0.3}
SHERIFF_STAR = {
    "front": (Emblem((0, 0.42), 0.36, "star"), Disc((0, 0.42), 0.1, gap=True)),
    "deep": 0.0,
    "until": 0.8,
}
BOXING_STAR = {
    "front": (Emblem((-0.16, 0.2), 0.36, "star"),),
    "back": (Emblem((0, 0.1), 0.36, "star"),),
    "deep": 0.2,
}
BAND_TEXT = {
    "front": (Emblem((0, 0), 0.7, text="BOX"),),
    "back": (Emblem((0, 0), 0.7, text="BOX"),),
    "deep": 0.3,
}
SKATE_STRIPES = {
    "sides": tuple(
        Poly(((at, -0.9), (at + 0.14, -0.9), (at + 0.44, 0.36), (at + 0.3, 0.36)))
        for at in (-0.42, -0.12)
    ),
    "aside": 0.2,
}
SKATE_STAR = {"sides": (Emblem((0.56, 0.3), 0.5, "star"),), "aside": 0.2}
SADDLE_FLOWERS = {
    "sides": (Emblem((0.0, -0.5), 0.3, "flower"), Emblem((0.0, 0.1), 0.2, "flower")),
    "aside": 0.6,
}
SADDLE_EDGE = {
    "sides": (Line(((-0.8, 0.2), (-0.66, -0.5), (-0.4, -0.84), (0.5, -0.84), (0.72, -0.5),
                    (0.86, 0.2)), 0.014),),
    "aside": 0.5,
}  # fmt: skip
TEDDY_MOUTH = {
    "front": (
        Line(((0, 0.3), (0, 0.21)), 0.011),
        Line(((0, 0.21), (0.05, 0.17), (0.11, 0.19)), 0.011, twice=True),
    ),
    "deep": 0.0,
}
TEDDY_EARS = {"front": (Disc((0.41, 0.82), 0.125, twice=True),), "deep": -0.4}
TEDDY_PAWS = {"front": (Emblem((0.48, -0.745), 0.11, "paw print", twice=True),), "deep": 0.6}
TEDDY_STITCHES = {
    "front": (Cells((0, -0.36), (0.008, 0.24), (1, 7), (1, 0.5)),
              Cells((0, -0.36), (0.04, 0.24), (1, 7), (1, 0.16))),
    "deep": 0.0,
    "until": 0.85,
}  # fmt: skip
BUCKET_BANDS = ((0.44, 0.6), (-0.62, -0.46))
TUB_BANDS = ((-0.5, -0.2),)
PIN_RING = {
    side: (Disc((0, 0), 0.72, 0.02), Emblem((0, 0), 0.44, "star")) for side in ("front", "back")
}
