"""Markings of what is eaten, worn or wielded: cakes, ices, tools, hats, gloves, toys."""

import math
from collections.abc import Sequence

import torch
import torch.nn.functional as F

from core.guidance.builtin.markings.homely import quilt
from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
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
)
from core.guidance.builtin.markings.stencils import lettering


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
    """Slanted ones on the top of what lies on the bearer of the box, from ``high`` above the middle
    of that, in halves of its width."""
    phase = (points[:, 0] + points[:, 1]) / (pitch * math.sqrt(2))
    line = (0.13 - (phase - phase.round()).abs()) * pitch
    return all_of(line, points[:, 2] - high * half[0])


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
    "deep": 0.4,
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
CHIN_VENTS = {
    "front": (
        Cells((0, -0.62), (0.22, 0.1), (1, 2), (1, 0.5), 0.9),
        Plate((0.42, -0.58), (0.09, 0.07), 0.8, twice=True),
    ),
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
    "front": (Emblem((0, 0.34), 0.26, "star"),),
    "deep": 0.0,
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
SKATE_STAR = {"sides": (Emblem((0.44, 0.3), 0.36, "star"),), "aside": 0.45}
SADDLE_FLOWERS = {
    "sides": (Emblem((0.0, -0.46), 0.44, "flower"), Emblem((0.0, 0.06), 0.3, "flower")),
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
}  # fmt: skip
BUCKET_BANDS = ((0.44, 0.6), (-0.62, -0.46))
TUB_BANDS = ((-0.5, -0.2),)
PIN_RING = {
    side: (Disc((0, 0), 0.72, 0.02), Emblem((0, 0), 0.44, "star")) for side in ("front", "back")
}
SCARF_LINES = ((0.78, 0.84), (0.5, 0.56), (0.2, 0.26))
_SMALL_VEINS = (
    Line(((0, -0.3), (0.22, 0.1)), 0.009, twice=True),
    Line(((0, 0.06), (0.16, 0.4)), 0.009, twice=True),
    Line(((0.32, -0.5), (0.36, -0.06)), 0.009, twice=True),
    Line(((0.4, -0.4), (0.68, -0.36)), 0.009, twice=True),
)
SIDE_VEINS = {
    "front": _SMALL_VEINS,
    "back": (
        *_SMALL_VEINS,
        Line(((0, -1), (0, 0.72)), 0.016),
        Line(((0, -0.87), (0.74, 0.04)), 0.016, twice=True),
        Line(((0, -0.87), (0.4, -0.78)), 0.016, twice=True),
    ),
    "deep": 0.0,
}
