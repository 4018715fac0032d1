"""Markings of what is flat or upright: dials, boards, signs, bottles, cars."""

import math
from collections.abc import Sequence

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front
from core.guidance.builtin.markings.stencils import lettering

SECTORS = 20  # of a dartboard


def disc(points: Points, half: Half, radius: float) -> Margin:
    """Within ``radius``, in halves of the width, of the middle of the front."""
    return all_of(radius * half[0] - points[:, [0, 2]].norm(dim=1), in_front(points))


def hours(points: Points, half: Half, radius: float) -> Margin:
    """Twelve strokes along the rim of a dial, every third longer and bolder."""
    x, z, r = points[:, 0], points[:, 2], radius * half[0]
    hour = torch.atan2(x, z) * (6 / math.pi)
    nearest, away = hour.round(), points[:, [0, 2]].norm(dim=1)
    bold = nearest.remainder(3) == 0
    across = away * ((hour - nearest) * (math.pi / 6)).sin().abs()
    inner, wide = torch.where(bold, 0.7, 0.78) * r, torch.where(bold, 0.045, 0.026) * r
    return all_of(wide - across, away - inner, 0.9 * r - away, in_front(points))


def rim(points: Points, half: Half, low: float, high: float) -> Margin:
    """Between two radii on the front, in halves of the width."""
    away = points[:, [0, 2]].norm(dim=1)
    return all_of(high * half[0] - away, away - low * half[0], in_front(points))


def bar(points: Points, half: Half, size: tuple[float, float]) -> Margin:
    """A level one across the middle of the front, in halves of the width."""
    x, z = points[:, 0].abs(), points[:, 2].abs()
    return all_of(size[0] * half[0] - x, size[1] * half[0] - z, in_front(points))


def _darts(points: Points, half: Half) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """Of a dartboard: the distance from its middle, the margins of the sectors of one kind and of
    the two rings, and the radius within which all lies."""
    r = 0.79 * half[0]
    away = points[:, [0, 2]].norm(dim=1)
    angle = torch.atan2(points[:, 0], points[:, 2]) * (SECTORS / 2)
    sectors = angle.cos() * away * (2 / SECTORS)
    both = any_of(*(0.045 * r - (away - at * r).abs() for at in (0.955, 0.6)))
    return away, sectors, both, r


def pale_sectors(points: Points, half: Half) -> Margin:
    """Every other sector of a dartboard."""
    away, sectors, _, r = _darts(points, half)
    return all_of(-sectors, r - away, in_front(points))


def dart_reds(points: Points, half: Half) -> Margin:
    """Its rings on the dark sectors, and the bull's eye."""
    away, sectors, both, r = _darts(points, half)
    return all_of(any_of(all_of(sectors, both), 0.065 * r - away), in_front(points))


def dart_greens(points: Points, half: Half) -> Margin:
    """Its rings on the pale ones, and the ring about the bull's eye."""
    away, sectors, both, r = _darts(points, half)
    bull = 0.035 * r - (away - 0.1 * r).abs()
    return all_of(any_of(all_of(-sectors, both), bull), in_front(points))


def spiral(points: Points, half: Half) -> Margin:
    """A lollipop's, on both sides, from the middle outwards."""
    pitch = 0.52 * half[0]
    turn = torch.atan2(points[:, 2], points[:, 0]) / math.tau
    phase = points[:, [0, 2]].norm(dim=1) / pitch + turn
    return (0.24 - (phase - phase.round()).abs()) * pitch


def frame(points: Points, half: Half, at: float, size: tuple[float, float], wide: float) -> Margin:
    """The outline of a rectangle on the front: its middle's height, its half sides and half the
    line's width, all in halves of the board's height."""
    x, z = points[:, 0].abs() / half[2], (points[:, 2] / half[2] - at).abs()
    away = torch.maximum(x - size[0], z - size[1]).abs()
    return all_of((wide - away) * half[2], in_front(points))


def lettered(
    points: Points, half: Half, text: str, high: float, bold: float = 0.03, at: float = 0.0
) -> Margin:
    """Letters across the front, ``high`` in halves of its width, their middle ``at`` a height in
    halves; ``bold``: how much farther out their strokes go than the font's, of their height."""
    size = high * half[0]
    place = torch.stack([points[:, 0], points[:, 2] - at * half[2]], 1) / size
    return all_of((lettering(place, text) + bold) * size, in_front(points))


def on_sides(points: Points, half: Half, text: str, high: float, at: tuple[float, float]) -> Margin:
    """Letters on both sides of what looks to the front: ``high`` and ``at`` (back and up) in halves
    of its length and height."""
    size, right = high * half[1], points[:, 0].sign()
    y, z = points[:, 1] - at[0] * half[1], points[:, 2] - at[1] * half[2]
    letters = (lettering(torch.stack([right * y, z], 1) / size, text) + 0.05) * size
    return all_of(letters, points[:, 0].abs() - 0.6 * half[0])


def doors(points: Points, half: Half) -> Margin:
    """A car's, on both sides, below the windows."""
    x, y, z = points.unbind(1)
    wide = 0.42 * half[1] - (y - 0.08 * half[1]).abs()
    return all_of(wide, 0.12 * half[2] - z, x.abs() - 0.6 * half[0])


def checks(points: Points, half: Half) -> Margin:
    """The dark ones of eight by eight squares, seen from above; a1 is one."""
    at = points[:, :2] / half[:2] * 4
    dark = at.floor().sum(1).remainder(2) == 0
    away = (at - at.round()).abs().amin(1) * (half[0] / 4)
    return torch.where(dark, away, -away)


def black_keys(points: Points, half: Half, octaves: int = 2) -> Margin:
    """Of a piano, the front at -y, and the gaps between the white ones."""
    pitch = 2 * half[0] / (7 * octaves)
    at = (points[:, 0] + half[0]) / pitch
    nearest = at.round()
    away = (at - nearest).abs() * pitch
    place = nearest.remainder(7)
    key = all_of(0.3 * pitch - away, points[:, 1] + 0.2 * half[1])
    return any_of(torch.where((place != 0) & (place != 3), key, -1.0), 0.005 - away)


def belt(points: Points, half: Half, low: float, high: float, axis: int = 2) -> Margin:
    """A label about a bottle, from height to height, in halves of its own; along another axis a
    stripe."""
    middle, wide = (low + high) / 2 * half[axis], (high - low) / 2 * half[axis]
    return wide - (points[:, axis] - middle).abs()


def belts(
    points: Points, half: Half, spans: Sequence[tuple[float, float]], axis: int = 2
) -> Margin:
    """The same of several."""
    return any_of(*(belt(points, half, low, high, axis) for low, high in spans))


def rings(
    points: Points, half: Half, spans: Sequence[tuple[float, float]], axis: int = 1
) -> Margin:
    """Between radii about the middle of both its faces, in halves of the width; the faces look
    along the axis."""
    away = points[:, [side for side in range(3) if side != axis]].norm(dim=1)
    pairs = ((low * half[0], high * half[0]) for low, high in spans)
    return any_of(*(all_of(high - away, away - low) for low, high in pairs))


def plate_rings(points: Points, half: Half) -> Margin:
    """Along a plate's edge, with a line beside it; and one about its well, from above."""
    away = points[:, :2].norm(dim=1) / half[0]
    well = all_of((0.025 - (away - 0.68).abs()) * half[0], points[:, 2])
    return any_of((away - 0.91) * half[0], (0.012 - (away - 0.86).abs()) * half[0], well)


def sock_heel(points: Points, half: Half) -> Margin:
    """Of a sock whose toe is to the front."""
    middle = points.new_tensor([0.0, float(half[1] - half[0]), float(1.05 * half[0] - half[2])])
    from_it = points - middle
    return all_of(1.08 * half[0] - from_it.norm(dim=1), from_it[:, 1])


def sock_toe(points: Points, half: Half) -> Margin:
    """The foremost part of it."""
    return 0.8 * half[0] - points[:, 1] - half[1]


def slanted(points: Points, _half: Half, pitch: float) -> Margin:
    """A necktie's stripes, one of ``pitch`` in three."""
    phase = (points[:, 2] + 0.8 * points[:, 0]) / pitch
    return (0.17 - (phase - phase.round()).abs()) * (pitch / math.hypot(1, 0.8))


def edge_spots(points: Points, half: Half, count: int = 6) -> Margin:
    """A poker chip's."""
    turn = torch.atan2(points[:, 2], points[:, 0]) * (count / math.tau)
    return (0.22 - (turn - turn.round()).abs()) * (math.tau / count) * half[0]


def spots(points: Points, half: Half, at: tuple[float, float, float], radius: float) -> Margin:
    """Two on a front, as eyes: how far aside, ahead and below the top, in training units."""
    aside, ahead, below = at
    x, y, z = points.unbind(1)
    off = torch.stack([x.abs() - aside, y + ahead, half[2] - z - below], 1)
    return radius - off.norm(dim=1)
