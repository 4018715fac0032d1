"""Markings of the home: doors, seats, beds, baths, shelves, and of what is built about it.

Most are outlines on a thing's sides (:mod:`core.guidance.builtin.markings.outlines`).
"""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    in_front,
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


def picket_nails(
    points: Points, half: Half, heights: Pair, pitch: float = 0.086, size: float = 0.015
) -> Margin:
    """Two side by side at each rail's height, by one picket's box; so many pitches lie between two
    pickets, however many there are."""
    x = points[:, 0] / pitch - 0.5
    aside = (x - x.round()) * pitch
    away = (torch.hypot(aside, points[:, 2] - at * half[2]) for at in heights)
    return all_of(any_of(*(size - one for one in away)), in_front(points))


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
    "deep": 0.3,
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
SHELF_VOLUMES, SHELF_TOMES = ((-0.648, -0.43),), ((-0.47, -0.1),)
SHELF_BANDS = ((0.6, 1.6), (3.9, 4.3))
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
