"""Markings of craft, machines, instruments and boxes; the outlines are those of ``bodywork``."""

import math
from collections.abc import Sequence
from typing import Any

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front
from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Outline,
    Pair,
    Plate,
    Poly,
    laid,
)


def girt(points: Points, half: Half, about: Sequence[Outline], **sides: Any) -> Margin:
    """What goes all round a hull, given as it is seen from the side, and what is on its sides."""
    found = laid(points, half, sides=about, aside=-9.0)
    return any_of(found, laid(points, half, **sides)) if sides else found


def flank(points: Points, half: Half, low: float, high: float, out: float) -> Margin:
    """A belt about an open boat, not within it: beyond ``out`` of its rim."""
    away = (points[:, :2] / half[:2]).norm(dim=1)
    middle, wide = (low + high) / 2 * half[2], (high - low) / 2 * half[2]
    return all_of(wide - (points[:, 2] - middle).abs(), (away - out) * half[0])


def spokes(points: Points, half: Half, count: int, wide: float, reach: Pair) -> Margin:
    """Level lines outwards from the middle, seen from above; ``reach``: from where to where, in
    halves."""
    x, y = points[:, 0], points[:, 1]
    away, step = torch.hypot(x, y), math.tau / count
    turn = torch.atan2(x, y) / step + 0.5
    across = away * ((turn - turn.round()) * step).sin().abs()
    return all_of(wide - across, away - reach[0] * half[0], reach[1] * half[0] - away)


def lattice(points: Points, half: Half, count: Pair, room: float, wide: float) -> Margin:
    """Lines across the panels side by side, by one panel's box; ``room``: half of what is between
    two, ``count``: of the cells of one."""
    pitch = 2 * (half[0] + room)
    x = points[:, 0] - (points[:, 0] / pitch).round() * pitch
    many = half.new_tensor(count)
    cell = 2 * half[[0, 2]] / many
    at = (torch.stack([x, points[:, 2]], 1) + half[[0, 2]]) / cell
    line = torch.minimum(at.round().clamp_min(1), many - 1)
    return wide - ((at - line).abs() * cell).amin(1)


def rosette(points: Points, half: Half) -> Margin:
    """A ring about a guitar's sound hole, which is at the lower end of its neck."""
    away = torch.hypot(points[:, 0], points[:, 2] + half[2] - half[0]) / half[0]
    return all_of((0.09 - (away - 0.8).abs()) * half[0], in_front(points))


def container_ribs(points: Points, half: Half, pitch: float = 0.052, aside: float = 0.7) -> Margin:
    """Upright lines on the outer sides of a ship's containers, by its hull."""
    at = points[:, 1] / pitch
    line = 0.01 - (at - at.round()).abs() * pitch
    return all_of(line, points[:, 0].abs() - aside * half[0])


def flutes(points: Points, half: Half, count: int, share: float, high: float) -> Margin:
    """Upright bands all round, so large a share of the way; ``high``: in halves."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    arc = points[:, :2].norm(dim=1) * (math.tau / count)
    across = (share / 2 - (turn - turn.round()).abs()) * arc
    return all_of(across, high * half[2] - points[:, 2].abs())


def zigzag(points: Points, half: Half, count: int, high: float, wide: float) -> Margin:
    """A drum's cords, up and down all round."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    rise = high * half[2] * (4 * (turn - turn.round()).abs() - 1)
    steep = 4 * high * half[2] * count / (math.tau * half[0])
    return wide - (points[:, 2] - rise).abs() / torch.sqrt(1 + steep * steep)


def dial_holes(points: Points, half: Half, count: int = 10) -> Margin:
    """Of a dial that leans back, the lowest on the right left out."""
    along = half[1:] / half[1:].norm()
    at = torch.stack([points[:, 0], points[:, 1:] @ along], 1)
    angles = [math.radians(-20 + 270 * k / (count - 1)) for k in range(count)]
    middles = 0.79 * half[0] * at.new_tensor([(math.cos(a), math.sin(a)) for a in angles])
    return 0.125 * half[0] - (at[:, None] - middles).norm(dim=2).amin(1)


def _hazard(at: Pair, size: Pair, count: int) -> tuple[Outline, ...]:
    """Slanted bars side by side."""
    (x, y), (u, v), step = at, size, 2 * size[0] / count
    starts = (x - u + (k + 0.1) * step for k in range(count))
    return tuple(
        Poly(((a, y - v), (a + 0.45 * step, y - v), (a + 0.9 * step, y + v),
              (a + 0.45 * step, y + v)))
        for a in starts
    )  # fmt: skip


PLANE_WINDOWS = {
    "about": (Poly(((-0.86, 0.22), (-0.74, 1.2), (-0.6, 1.2), (-0.68, 0.22))),),
    "sides": (Cells((0.02, 0.24), (0.55, 0.13), (9, 1), (0.5, 1), 1.0),),
    "front": (),
}
PLANE_STRIPE = {"about": (Poly(((-1.1, -0.3), (-0.5, -0.12), (0.6, -0.12), (1.1, 0.9), (1.1, 0.3),
                                (0.7, -0.42), (-0.5, -0.42), (-1.1, -0.5))),)}  # fmt: skip
PLANE_DOORS = {"sides": (Plate((-0.6, 0.12), (0.035, 0.34), 0.5, 0.008),
                         Plate((0.64, 0.2), (0.03, 0.3), 0.5, 0.008))}  # fmt: skip
TAIL_BANDS = ((0.42, 0.82), (0.28, 0.34))
HELICOPTER_PANES = {"sides": (Plate((-0.06, 0.16), (0.12, 0.24), 0.4),), "aside": 0.3}
HELICOPTER_DOORS = {
    "sides": (
        Plate((-0.06, -0.08), (0.17, 0.56), 0.35, 0.011),
        Plate((0.05, -0.2), (0.035, 0.04), 0.9),
    ),
    "aside": 0.3,
}
HELICOPTER_BANDS = ((0.42, 0.5), (0.55, 0.58))
JET_STARS = {
    "top": (
        Disc((0.56, 0.2), 0.27, twice=True),
        Emblem((0.56, 0.2), 0.23, "star", twice=True, gap=True),
    ),
    "deep": -9.0,
}
JET_NOSE = ((-1.2, -0.74),)
ROCKET_BANDS = ((-0.42, -0.22), (-0.14, -0.08))
ROCKET_HATCH = {
    "back": (
        Plate((0, 0.42), (0.46, 0.36), 0.5, 0.016),
        Disc((0, 0.52), 0.17),
        Plate((0.24, 0.3), (0.05, 0.06), 0.5),
    ),
    "deep": 0.3,
}
SHIP_STRIPES = {
    "top": (
        Plate((0.84, 0), (0.05, 3), twice=True),
        Plate((0.7, 0), (0.025, 3), twice=True),
    ),
    "deep": -9.0,
}
SHIP_NOSE = ((-1.2, -0.72), (-0.66, -0.63))
SUB_PORTS = {"sides": tuple(Disc((at, 0.12), 0.25) for at in (-0.5, -0.1, 0.3)), "aside": 0.2}
SUB_RIMS = {"sides": tuple(Disc((at, 0.12), 0.36) for at in (-0.5, -0.1, 0.3)), "aside": 0.2}
FOIL = {
    side: (
        Plate((0, 0), (0.84, 0.84), 0.1, 0.012),
        Line(((-0.84, -0.84), (0.84, 0.84)), 0.01),
        Line(((-0.84, 0.84), (0.84, -0.84)), 0.01),
    )
    for side in ("front", "back", "sides")
}
FLAMES = {
    "sides": (
        Poly(((-1.2, 0.2), (-0.55, 0.22), (-0.1, 0.02), (-0.42, -0.02), (0.16, -0.3),
              (-0.36, -0.3), (-0.1, -0.56), (-0.5, -0.5), (-0.6, -0.8), (-1.2, -0.8))),
    ),
    "aside": 0.84,
}  # fmt: skip
MONSTER_DOORS = {
    "sides": (
        Plate((-0.06, 0.0), (0.17, 0.42), 0.2, 0.01),
        Plate((0.05, 0.02), (0.04, 0.04), 0.9),
    ),
    "aside": 0.7,
}
ANCHOR = {"sides": (Emblem((-0.3, -0.42), 0.42, "anchor"),), "aside": -9.0}
PORTHOLES = {"sides": (Cells((0.06, 0.1), (0.6, 0.15), (9, 1), (0.5, 1), 1.0),), "aside": 0.5}
YACHT_PORTS = {"sides": (Cells((0.16, 0.26), (0.56, 0.13), (6, 1), (0.5, 1), 1.0),), "aside": 0.4}
TRACTOR_GRILLE = {
    "front": (
        Plate((0, -0.1), (0.5, 0.62), 0.2),
        Cells((0, -0.1), (0.42, 0.52), (1, 5), (2, 0.3), gap=True),
    ),
    "sides": (Cells((-0.5, 0.1), (0.24, 0.26), (5, 1), (0.42, 1), 0.8),),
}
TRACTOR_LAMPS = {"front": (Disc((0.52, 0.72), 0.2, twice=True),)}
DIGGER_STRIPES = {"back": _hazard((0, -0.28), (0.86, 0.24), 6), "deep": 0.8}
DIGGER_VENTS = {
    "sides": (Cells((0.5, -0.1), (0.28, 0.26), (1, 4), (1, 0.42), 0.8),),
    "aside": 0.7,
}
DISPLAY_DIGITS = {"front": (Emblem((0, 0), 0.62, text="9.50"),), "deep": 0.2}
TILL_BORDER = {
    "sides": (Poly(((-0.6, -0.2), (0.05, 0.66), (0.76, 0.66), (0.76, -0.2))),
              Poly(((-0.5, -0.14), (0.08, 0.6), (0.7, 0.6), (0.7, -0.14)), gap=True)),
    "back": (Plate((0, 0.2), (0.7, 0.5), 0.1, 0.014),),
}  # fmt: skip
CASE_PANELS = {
    side: (Plate((0, 0.46), (0.7, 0.3), 0.3, 0.014),) for side in ("front", "back", "sides")
}
RECORD_GROOVES = tuple((0.4 + 0.065 * k, 0.43 + 0.065 * k) for k in range(9))
PRINTED = {"front": (Cells((-0.1, 0.3), (0.62, 0.5), (1, 5), (1, 0.34), 0.5),), "deep": -9.0}
SHADE_BANDS = ((-1.1, -0.86), (0.86, 1.1))
PUMP_MARKS = {
    "front": (
        Plate((0, -0.46), (0.46, 0.1), 0.3),
        Emblem((0, -0.46), 0.12, text="0.00", gap=True),
        Plate((0, -0.66), (0.4, 0.03), 0.5),
        *(
            Disc((0.46 * math.sin(a), 0.32 + 0.25 * math.cos(a)), 0.055)
            for a in (math.tau * k / 12 for k in range(12))
        ),
    ),
    "deep": 0.0,
}
GLOBE_STAR = {"front": (Emblem((0, 0), 0.55, "star"),), "back": (Emblem((0, 0), 0.55, "star"),)}
COFFEE_DIGITS = {"front": (Emblem((-0.4, 0), 0.5, text="7:30"),), "deep": -9.0}
COFFEE_BUTTONS = {
    "front": tuple(Disc((at, 0), 0.42) for at in (0.3, 0.56, 0.82)),
    "deep": -9.0,
}
GUITAR_GUARD = {
    "front": (Poly(((0.22, -0.07), (0.45, 0.11), (0.64, -0.03), (0.73, -0.26), (0.59, -0.44),
                    (0.39, -0.4), (0.27, -0.24))),),
    "deep": 0.0,
}  # fmt: skip
RIVETS = {
    "front": tuple(Disc((0.55, at), 0.055, twice=True) for at in (-0.82, -0.52, -0.2)),
    "back": tuple(Disc((0.55, at), 0.055, twice=True) for at in (-0.82, -0.52, -0.2)),
    "deep": 0.7,
}
GARBAGE_WINDOWS = {
    "front": (
        Plate((0, 0.4), (0.8, 0.36), 0.25),
        Line(((0, 1), (0, 0)), 0.012, gap=True),
    ),
    "sides": (Plate((0.06, 0.4), (0.5, 0.36), 0.25),),
    "deep": 0.6,
}
CUP_BADGES = {"sides": (Disc((0, 0), 0.62, 0.03), Emblem((0, 0), 0.36, "lightning bolt")),
              "aside": 0.3}  # fmt: skip
DRUM_BADGE = {"front": (Disc((0, 0), 0.5), Emblem((0, 0), 0.36, "star", gap=True)), "deep": 0.3}
PIANO_PANELS = {
    "front": (
        Plate((0.45, 0.62), (0.36, 0.2), 0.12, 0.014, twice=True),
        Plate((0, -0.5), (0.72, 0.3), 0.12, 0.014),
    ),
    "back": (Plate((0, 0), (0.8, 0.8), 0.1, 0.016), Line(((0, 0.8), (0, -0.8)), 0.014)),
    "deep": -0.3,
}
PLAQUE = {
    "front": (Plate((0, -0.1), (0.6, 0.36), 0.3), Emblem((0, -0.1), 0.26, text="No 1", gap=True)),
    "deep": 0.2,
}
CUP_STAR = {"front": (Emblem((0, 0.36), 0.4, "star"),), "deep": 0.2}
TOOLS = {"text": "TOOLS", "high": 0.22, "bold": 0.06, "at": -0.42}
KEYHOLE = {
    "front": (Disc((0, 0.14), 0.28), Poly(((-0.12, 0.1), (0.12, 0.1), (0.2, -0.5), (-0.2, -0.5)))),
    "deep": 0.0,
}
CRATE_NAILS = {
    side: tuple(
        Disc((u, v), 0.055)
        for u, v in ((0.88, 0.88), (0.88, -0.88), (-0.88, 0.88), (-0.88, -0.88),
                     (0.8, 0.0), (-0.8, 0.0), (0.0, 0.8), (0.0, -0.8))
    )
    for side in ("front", "back", "sides")
}  # fmt: skip
STITCHED = {side: (Plate((0, 0.0), (0.86, 0.82), 0.3, 0.01),) for side in ("front", "back")}
CANNON_BANDS = ((-1.0, -0.9), (-0.5, -0.4), (0.0, 0.12), (0.5, 0.6))
DRONE_LAMPS = {
    "front": (Plate((0.5, 0.1), (0.16, 0.1), 0.9, twice=True),),
    "back": (Plate((0.5, 0.1), (0.16, 0.1), 0.9, twice=True),),
    "deep": 0.3,
}
DRONE_SEAMS = {
    "top": (Plate((0, 0.1), (0.5, 0.5), 0.5, 0.012), Disc((0, -0.66), 0.09)),
    "deep": 0.2,
}
SHUTTLE_DOORS = {
    "top": (Plate((0, 0.12), (0.72, 0.6), 0.1, 0.01), Line(((0, -0.48), (0, 0.72)), 0.01)),
    "deep": 0.1,
}
SHUTTLE_EDGES = {
    "top": (
        Poly(((0.0, -1.1), (0.46, -0.66), (1.1, 0.42), (1.1, 0.78), (0.44, -0.32), (0.0, -0.75)),
             twice=True),
    ),
    "deep": -9.0,
}  # fmt: skip
TOWER_PORTS = {
    "back": (
        Disc((0.4, 0.58), 0.4, 0.02),
        Disc((0.4, 0.58), 0.2, 0.015),
        Cells((-0.5, 0.58), (0.26, 0.24), (2, 3), (0.6, 0.55), 0.2),
        Cells((0, -0.06), (0.76, 0.22), (1, 4), (1, 0.36)),
        Plate((0, -0.66), (0.76, 0.2), 0.1, 0.014),
        Plate((-0.4, -0.66), (0.2, 0.1), 0.3),
    ),
}
ENGINE_FINS = {"sides": (Cells((0, 0.4), (0.28, 0.44), (1, 4), (1, 0.4), 0.8),), "aside": 0.45}
REMOTE_SEAMS = {
    "back": (
        Plate((0, -0.4), (0.74, 0.44), 0.2, 0.011),
        Cells((0, -0.06), (0.3, 0.05), (1, 3), (1, 0.4), 0.9),
    ),
    "deep": 0.2,
}
