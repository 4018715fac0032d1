"""Markings of vehicles and of what stands in the street: panes, letters, grilles, stripes.

Most are outlines on a thing's sides (:mod:`core.guidance.builtin.markings.bodywork`).
"""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, within
from core.guidance.builtin.markings.outlines import (
    Cells,
    Disc,
    Emblem,
    Line,
    Outline,
    Pair,
    Plate,
    Poly,
)
from core.guidance.builtin.markings.stencils import lettering

ARROW = ((-0.62, -0.62), (0.3, -0.62), (0.3, -0.84), (0.72, -0.46), (0.3, -0.08), (0.3, -0.3),
         (-0.44, -0.3))  # fmt: skip


def on_four(*outlines: Outline) -> dict[str, tuple[Outline, ...]]:
    """The same on all four walls."""
    return dict.fromkeys(("front", "back", "sides"), outlines)


def truss(
    points: Points, half: Half, along: int, count: int, room: Pair, bar: float = 0.016
) -> Margin:
    """What is open between the slanted bars of a beam, seen from its sides, in so many bays along
    an axis; ``room``: from where to where across, in halves."""
    across = 3 - along  # y and z are 1 and 2
    pitch = 2 * 0.92 * half[along] / count
    low, high = room[0] * half[across], room[1] * half[across]
    at, up = points[:, along] / pitch + count / 2, points[:, across]
    turn = (at - at.floor() - 0.5).abs() * 2  # 1 between two bays, 0 in the middle of one
    rise = low + turn * (high - low)
    off = (up - rise).abs() / torch.sqrt(1 + (2 * (high - low) / pitch).square())
    inside = all_of(up - low, high - up, 0.92 * half[along] - points[:, along].abs())
    return all_of(inside, off - bar)


def grid(points: Points, _half: Half, pitch: Pair, wide: float = 0.008) -> Margin:
    """Lines along and across what lies, from its middle, ``pitch`` in training units."""
    at = points[:, :2] / points.new_tensor(pitch) + 0.5
    away = (at - at.round()).abs() * points.new_tensor(pitch)
    return wide - away.amin(1)


def hazard(at: Pair, size: Pair, count: int) -> tuple[Outline, ...]:
    """A band of slanted stripes, every other one left out."""
    (x, y), (u, v), step = at, size, 2 * size[0] / count
    gaps = (
        Poly(
            ((a, y - v), (a + step / 2, y - v), (a + step, y + v), (a + step / 2, y + v)), gap=True
        )
        for a in (x - u + k * step for k in range(count))
    )
    return (Plate(at, size), *gaps)


def leaning(points: Points, degrees: float) -> Points:
    """Places on what looks up to the front, as if it looked straight up."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y, z = points.unbind(1)
    return torch.stack([x, c * y - s * z, s * y + c * z], 1)


def dish_seams(points: Points, half: Half, lean: float = 44.0, count: int = 8) -> Margin:
    """Of a dish that looks up to the front: lines outwards, and a ring."""
    x, y, _ = leaning(points, -lean).unbind(1)
    away, step = torch.hypot(x, y), math.tau / count
    turn = torch.atan2(x, y) / step + 0.5
    across = away * ((turn - turn.round()) * step).sin().abs()
    spoke = all_of(0.012 - across, away - 0.3 * half[0], 0.96 * half[0] - away)
    ring = 0.012 - torch.minimum((away - 0.3 * half[0]).abs(), (away - 0.64 * half[0]).abs())
    return any_of(spoke, ring)


def rib_letters(points: Points, half: Half, text: str = "CARGO") -> Margin:
    """A letter on each of the ribs on both sides of a container, by its body."""
    pitch, size = 0.392 * half[1], 0.2 * half[1]
    along, up = points[:, 1] * points[:, 0].sign(), points[:, 2]
    margins = []
    for k, letter in enumerate(text):
        away = along - (k - (len(text) - 1) / 2) * pitch
        margins.append(lettering(torch.stack([away, up], 1) / size, letter) + 0.05)
    return all_of(any_of(*margins) * size, points[:, 0].abs() - 0.7 * half[0])


def recycling(points: Points, half: Half, at: Sequence[Pair], size: float) -> Margin:
    """Three arrows that follow one another in a triangle, on the front and on the back; places in
    halves, the size in halves of the height."""
    size, arrow = size * float(half[2]), points.new_tensor(ARROW)
    margins = []
    for u, v in at:
        for sign in (1, -1):
            x, z = sign * (points[:, 0] - u * half[0]) / size, points[:, 2] / size - v
            out = -sign * points[:, 1] - 0.3 * half[1]
            for k in range(3):
                c, s = math.cos(k * math.tau / 3), math.sin(k * math.tau / 3)
                turned = torch.stack([c * x - s * z, s * x + c * z], 1)
                margins.append(all_of(within(turned, arrow) * size, out))
    return any_of(*margins)


def foot_stripes(points: Points, half: Half, count: int = 14) -> Margin:
    """Slanted ones about the disc that something stands on, below a third of its height."""
    x, y, z = points.unbind(1)
    away = torch.hypot(x, y)
    turn = (torch.atan2(x, -y) + 0.8 * z / half[0]) * (count / math.tau)
    across = (0.25 - (turn - turn.round()).abs()) * (math.tau / count) * away
    return all_of(across, -0.52 * half[2] - z, away - 0.8 * half[0])


BOOTH_LETTERS = on_four(Emblem((0, 0.837), 0.085, text="TELEPHONE")) | {"deep": 0.6}
BOOTH_SIGN = on_four(Plate((0, 0.837), (0.76, 0.1), 0.2)) | {"deep": 0.6}
BOOTH_WINDOWS = on_four(Cells((0, 0.03), (0.68, 0.66), (3, 5), (0.84, 0.84))) | {"deep": 0.6}
BOOTH_SEAMS = on_four(Plate((0, 0.0), (0.79, 0.71), 0.06, 0.01)) | {"deep": 0.6}
JEEP_GRILLE = {
    "front": (Cells((0, 0.12), (0.34, 0.5), (7, 1), (0.52, 1), 0.9),
              Plate((0, -0.82), (0.8, 0.1), 0.5)),
    "deep": 0.7,
}  # fmt: skip
TRAM_WINDOWS = {
    "front": (Plate((0, 0.27), (0.76, 0.38), 0.2),),
    "back": (Plate((0, 0.27), (0.76, 0.38), 0.2),),
    "sides": (Cells((0, 0.28), (0.62, 0.36), (5, 1), (0.86, 1), 0.2),
              Plate((0.79, 0.12), (0.075, 0.52), 0.2, twice=True)),
    "deep": 0.7,
}  # fmt: skip
TRAM_DOORS = {
    "sides": (Plate((0.79, -0.08), (0.115, 0.8), 0.1, 0.011, twice=True),
              Line(((0.79, -0.42), (0.79, -0.88)), 0.009, twice=True)),
    "deep": 0.7,
}  # fmt: skip
TRAM_LAMPS = {side: (Disc((0.62, -0.76), 0.15, twice=True),) for side in ("front", "back")} | {
    "deep": 0.2
}
TRAM_SIGN = {
    side: (Plate((0, 0.82), (0.6, 0.14), 0.4), Emblem((0, 0.82), 0.1, text="TRAM", gap=True))
    for side in ("front", "back")
}
DUMPER_TRIM = {
    "front": (Cells((0, -0.36), (0.36, 0.26), (1, 4), (1, 0.46), 0.6),
              *hazard((0, -0.8), (1.1, 0.17), 9)),
    "sides": (Plate((-0.53, 0.08), (0.13, 0.84), 0.1, 0.01),
              Plate((-0.46, -0.1), (0.04, 0.05), 0.9)),
    "deep": 0.7,
    "aside": 0.5,
}  # fmt: skip
CART_LAMPS = {"front": (Disc((0.66, 0.16), 0.27, twice=True),), "deep": 0.4}
CART_TRIM = {
    "front": (Disc((0.66, 0.16), 0.37, twice=True),
              Cells((0, 0.16), (0.38, 0.24), (1, 3), (1, 0.46), 0.8),
              Plate((0, -0.74), (1.2, 0.24))),
    "back": (Plate((0, -0.74), (1.2, 0.24)),),
    "sides": (Plate((0.0, -0.84), (0.36, 0.16)), Plate((-1, -0.74), (0.1, 0.24)),
              Plate((1, -0.74), (0.1, 0.24))),
    "deep": 0.3,
    "aside": 0.6,
}  # fmt: skip
SCOOTER_TRIM = {
    "sides": (Plate((0.62, -0.02), (0.25, 0.3), 0.95),),
    "front": (Plate((0, 0.3), (0.9, 0.66), 0.4, 0.026),),
    "aside": 0.3,
    "deep": 0.05,
}
SCOOTER_GRILLE = {"front": (Cells((0, 0.3), (0.4, 0.16), (1, 4), (1, 0.46), 0.8),), "deep": 0.05}
SCOOTER_TAIL = {"back": (Disc((0, 0.0), 0.3),), "deep": 0.7}
SKI_TRIM = {
    "sides": (Poly(((-0.86, -0.5), (-0.4, 0.5), (-0.18, 0.5), (-0.5, -0.1), (-0.2, -0.2),
                    (-0.26, -0.5))),),
    "top": (Poly(((-0.5, -0.35), (0.0, -0.75), (0.5, -0.35), (0.5, -0.52), (0.0, -0.95),
                  (-0.5, -0.52))),),
    "aside": 0.5,
    "deep": -0.6,
}  # fmt: skip
SADDLE_RIBS = tuple((at, at + 0.07) for at in (-0.75, -0.55, -0.35, 0.15, 0.35, 0.55, 0.75))
ROVER_FOIL = on_four(Cells((0, 0), (0.9, 0.8), (3, 1), (0.86, 1), 0.1)) | {"deep": 0.7}
CONTAINER_RIDGES = {
    "top": (Cells((0, 0), (0.78, 0.9), (1, 13), (1, 0.46)),),
    "back": (Cells((0, 0), (0.8, 0.76), (7, 1), (0.46, 1)),),
    "deep": 0.8,
}
BALLOON_BELTS = ((-2.0, -0.84), (0.02, 0.26))
PISTOL_GROOVES = {
    side: (Cells((0.74 * flip, -0.06), (0.16, 0.7), (6, 1), (0.42, 1)),
           Line(((-0.9 * flip, -0.5), (0.5 * flip, -0.5)), 0.009))
    for side, flip in (("front", 1), ("back", -1))
}  # fmt: skip
PISTOL_PORT = {
    side: (Plate((0.16 * flip, 0.12), (0.14, 0.3), 0.2),)
    for side, flip in (("front", 1), ("back", -1))
}
PISTOL_RIDGES = {
    side: (*(Line(((-2, at + 2 * tilt), (2, at - 2 * tilt)), 0.009)
             for at in (-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75)
             for tilt in (0.36, -0.36)),)
    for side in ("front", "back")
}  # fmt: skip
BOMB_SKULL = {side: (Emblem((0, 0.06), 0.58, "skull"),) for side in ("front", "back")} | {
    "deep": 0.1
}
TYRE_STRIPE = {side: (Disc((0, 0), 0.812, 0.02),) for side in ("front", "back")}
RIFLE_PORT = {
    side: (Plate((0.1 * flip, 0.3), (0.3, 0.2), 0.3), Disc((-0.66 * flip, 0.1), 0.2),
           Disc((0.72 * flip, 0.1), 0.2))
    for side, flip in (("front", 1), ("back", -1))
}  # fmt: skip
BUTT_BANDS = ((0.84, 2.0), (0.7, 0.75))
