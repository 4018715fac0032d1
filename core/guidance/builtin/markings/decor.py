"""Markings of what stands about in a room or is made by hand: furniture, ware, arms, food.

Most are outlines on a thing's sides (:mod:`core.guidance.builtin.markings.bodywork`).
"""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, strokes
from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate, Poly, laid

ARCH = 0.86  # of a tombstone's half width, how far from the middle its border is


def each_drawer(points: Points, half: Half, room: float = 0.045) -> Margin:
    """A frame on each of the drawers in rows and columns, by one drawer's box; ``room``: half of
    what is between two."""
    pitch = 2 * (half[[0, 2]] + room)
    at = points[:, [0, 2]]
    at = at - (at / pitch).round() * pitch
    moved = torch.stack([at[:, 0], points[:, 1], at[:, 1]], 1)
    frame = Plate((0, 0), (0.84, 0.72), 0.15, 0.014)
    return laid(moved, half, front=(frame,), deep=0.0)


def arch(points: Points, half: Half, wide: float = 0.016) -> Margin:
    """The outline of a slab that is round above, on its front."""
    x, z, size = points[:, 0], points[:, 2], ARCH * half[0]
    up = z - (half[2] - half[0])
    away = torch.where(up > 0, torch.hypot(x, up), x.abs()) - size
    low = -0.68 * half[2] - z
    line = wide - torch.maximum(away, low).abs()
    return all_of(line, -points[:, 1] - 0.5 * half[1])


def epitaph(points: Points, half: Half) -> Margin:
    """A tombstone's: its letters and a border about all."""
    letters = laid(points, half, front=(Emblem((0, -0.5), 0.21, text="RIP"),), deep=0.5)
    return any_of(letters, arch(points, half))


def beads(points: Points, half: Half, radius: float, size: float, count: int) -> Margin:
    """A ring of dots on what is round and looks to the front, on both faces; radius and size in
    halves of the width."""
    x, z = points[:, 0], points[:, 2]
    turn = torch.atan2(x, z) * (count / math.tau)
    angle = (turn - turn.round()) * (math.tau / count)
    away = torch.hypot(x, z)
    off = torch.hypot(away * angle.sin(), away * angle.cos() - radius * half[0])
    return size * half[0] - off


def rays(points: Points, half: Half, span: tuple[float, float], count: int, wide: float) -> Margin:
    """Strokes from one radius to another about the middle of a front, pointed without."""
    x, z = points[:, 0], points[:, 2]
    away = torch.hypot(x, z) / half[0]
    turn = torch.atan2(x, z) * (count / math.tau)
    off = ((turn - turn.round()) * (math.tau / count)).abs() * torch.hypot(x, z)
    low, high = span
    slim = wide * ((high - away) / (high - low)).clamp(0, 1)
    return all_of(slim - off, (away - low) * half[0], (high - away) * half[0])


def bark_lines(points: Points, half: Half, count: int = 11, wide: float = 0.013) -> Margin:
    """Furrows along a log that lies along x, each in strokes."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(z, y) * (count / math.tau) + 0.12 * (x * 5).sin()
    row = turn.round()
    off = (turn - row).abs() * (math.tau / count) * torch.hypot(y, z)
    phase = x / 0.42 + 0.37 * row
    long = (0.34 - (phase - phase.round()).abs()) * 0.42
    return all_of(wide - off, long, 0.94 * half[0] - x.abs())


def gable(points: Points, half: Half, wide: float = 0.03) -> Margin:
    """A tent's hem: along its foot, and along the edges of its door in front."""
    x, _, z = points.unbind(1)
    foot = -0.86 * half[2] - z
    at = torch.stack([x.abs(), z], 1)
    edge = points.new_tensor([[0.44, -1.0], [0.0, 0.44]]) * half[[0, 2]]
    door = all_of(strokes(at, edge, wide), -points[:, 1] - 0.8 * half[1])
    return any_of(foot, door)


def bricks(
    points: Points, half: Half, rows: int = 7, count: int = 10, wide: float = 0.013
) -> Margin:
    """The joints of a round wall."""
    x, y, z = points.unbind(1)
    pitch = 2 * half[2] / rows
    row = (z + half[2]) / pitch
    level = (row - row.round().clamp(1, rows - 1)).abs() * pitch
    turn = torch.atan2(x, -y) * (count / math.tau) + 0.5 * row.floor().remainder(2)
    upright = (turn - turn.round()).abs() * (math.tau / count) * torch.hypot(x, y)
    return wide - torch.minimum(level, upright)


def cutting_edge(points: Points, half: Half, wide: float = 0.26) -> Margin:
    """Of an axe that cuts to the left, a little bent as its edge is."""
    bow = 0.1 * half[0] * (points[:, 2] / half[2]).square()
    return (wide - 1) * half[0] + bow - points[:, 0]


TABLE_SEAMS = {
    "top": (
        *(Line(((-0.84, at), (0.84, at)), 0.009) for at in (-0.6, -0.2, 0.2, 0.6)),
        *(Line(((at, -1.1), (at, 1.1)), 0.009) for at in (-0.84, 0.84)),
    ),
    "deep": 0.5,
}
BLOTTER = {"top": (Plate((-0.08, -0.12), (0.46, 0.62), 0.12),), "deep": 0.3}
BLOTTER_EDGE = {"top": (Plate((-0.08, -0.12), (0.43, 0.56), 0.12, 0.009),), "deep": 0.3}
BENCH_SEAMS = {
    "top": tuple(Line(((-1.1, at), (1.1, at)), 0.011) for at in (-0.5, 0.0, 0.5)),
    "sides": tuple(Line(((at, -1.1), (at, 1.1)), 0.011) for at in (-0.5, 0.0, 0.5)),
    "deep": 0.4,
}
BENCH_BOLTS = {
    "top": tuple(Disc((0.77, at), 0.1, twice=True) for at in (-0.75, -0.25, 0.25, 0.75)),
    "deep": 0.4,
}
BACK_SEAMS = {
    "front": (Plate((0, 0), (0.78, 0.84), 0.5, 0.014),
              *(Line(((-0.76, at), (0.76, at)), 0.012) for at in (-0.3, 0.3))),
    "back": (Plate((0, 0), (0.78, 0.84), 0.5, 0.014),),
    "deep": -1.0,
}  # fmt: skip
PILLOW_BORDER = {
    "top": (Plate((0, 0), (0.8, 0.76), 0.4, 0.018), Disc((0, 0), 0.4, 0.014)),
    "deep": -0.3,
}
MUG_BANDS = ((0.86, 1.3), (-0.74, -0.5), (-0.42, -0.37))
BOWL_BANDS = ((0.8, 1.3), (0.58, 0.66))
TEAPOT_BANDS = ((0.5, 0.56), (-0.42, -0.36), (-0.5, -0.47))
FULLER = {
    "front": (Plate((0, -0.22), (0.26, 0.78), 0.9),),
    "back": (Plate((0, -0.22), (0.26, 0.78), 0.9),),
    "deep": 0.0,
}
GRIP_WRAPS = tuple((-0.9 + 0.24 * k, -0.8 + 0.24 * k) for k in range(8))
QUARTERS = {
    "front": (Plate((-0.5, 0.55), (0.5, 0.45)), Plate((0.5, -0.45), (0.5, 0.55))),
    "back": (Line(((0, 1), (0, -1)), 0.012), Line(((-1, 0.1), (1, 0.1)), 0.012)),
    "deep": -1.0,
}
BELL_BANDS = ((-0.9, -0.76), (-0.68, -0.64), (0.34, 0.44), (0.5, 0.54))
LOAF_SCORES = {
    "top": tuple(
        Poly(((-0.7, at - 0.12), (0.0, at - 0.04), (0.7, at + 0.12), (0.0, at + 0.04)))
        for at in (-0.3, 0.1, 0.5)
    ),
    "deep": 0.0,
}
CROWN_BANDS = ((-1.2, -0.86), (-0.3, -0.2))
_SHUTTER = (Plate((0, 0), (0.72, 0.86), 0.1, 0.014), Cells((0, 0), (0.5, 0.76), (1, 9), (1, 0.4)))
SLATS = {"front": _SHUTTER, "back": _SHUTTER, "deep": 0.2}
BREATHS = {
    "front": (Cells((0.45, -0.42), (0.2, 0.2), (3, 3), (0.5, 0.5), 0.95, twice=True),),
    "deep": 0.0,
}
HANDLE_WRAPS = tuple((-0.88 + 0.12 * k, -0.8 + 0.12 * k) for k in range(5))
ARROW_BANDS = ((-0.6, -0.53), (-0.49, -0.46), (0.72, 0.8))
HEMS = ((-1.2, -0.84), (-0.78, -0.74))
CHAIR_BADGE = {
    "back": (Emblem((0, 0.42), 0.34, "lightning bolt"), Plate((0, -0.3), (0.4, 0.05), 0.9),
             Plate((0, -0.42), (0.3, 0.03), 0.9)),
    "deep": 0.55,
}  # fmt: skip
_COUNTER = (
    Cells((0, 0.12), (0.94, 0.62), (4, 1), (0.84, 1.0), 0.05),
    Cells((0, 0.12), (0.94, 0.62), (4, 1), (0.7, 0.84), 0.05, gap=True),
    Cells((0, 0.12), (0.94, 0.62), (4, 1), (0.62, 0.75), 0.05),
)
_COUNTER_END = (
    Plate((0, 0.12), (0.76, 0.62), 0.05),
    Plate((0, 0.12), (0.64, 0.52), 0.05, gap=True),
    Plate((0, 0.12), (0.56, 0.47), 0.05),
)
COUNTER_PANELS = {"front": _COUNTER, "back": _COUNTER, "sides": _COUNTER_END, "deep": 0.7}
STAMP = {
    "back": (Plate((0.76, 0.56), (0.14, 0.27), 0.1), Emblem((0.76, 0.56), 0.17, "heart", gap=True)),
    "deep": 0.2,
}
ADDRESS = {
    "back": (Plate((-0.02, 0.1), (0.4, 0.03)), Plate((-0.08, -0.16), (0.34, 0.03)),
             Plate((-0.16, -0.42), (0.26, 0.03)), Plate((-0.76, 0.74), (0.14, 0.03)),
             Plate((-0.78, 0.58), (0.12, 0.03))),
    "deep": 0.2,
}  # fmt: skip
