"""Bands, belts and zigzags around a part, and its edges."""

import math
from collections.abc import Sequence
from typing import Any

import torch

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    strokes,
)
from core.guidance.builtin.markings.outlines import Outline, laid


def bands(points: Points, half: Half, axis: int, low: float, high: float) -> Margin:
    """A band between two places along an axis, in halves."""
    at = points[:, axis]
    return all_of(at - low * half[axis], high * half[axis] - at)


def belt(points: Points, half: Half, low: float, high: float, axis: int = 2) -> Margin:
    """A band across an axis, in halves: a bottle's label, a stripe."""
    middle, wide = (low + high) / 2 * half[axis], (high - low) / 2 * half[axis]
    return wide - (points[:, axis] - middle).abs()


def belts(
    points: Points, half: Half, spans: Sequence[tuple[float, float]], axis: int = 2
) -> Margin:
    """Several bands across an axis."""
    return any_of(*(belt(points, half, low, high, axis) for low, high in spans))


def flank(points: Points, half: Half, low: float, high: float, out: float) -> Margin:
    """A belt around an open boat, not inside it: beyond ``out`` of its rim."""
    away = (points[:, :2] / half[:2]).norm(dim=1)
    return all_of(belt(points, half, low, high), (away - out) * half[0])


def girt(points: Points, half: Half, about: Sequence[Outline], **sides: Any) -> Margin:
    """Outlines seen from the side that go all around a hull, and outlines on its sides."""
    found = laid(points, half, sides=about, aside=-9.0)
    return any_of(found, laid(points, half, **sides)) if sides else found


def hoop(points: Points, half: Half, at: float, wide: float, within: float = 2.0) -> Margin:
    """A band around a trunk, not on parts next to it: the height of its middle and half its width
    in halves; ``within`` in halves of the width."""
    band = wide * half[2] - (points[:, 2] - at * half[2]).abs()
    return all_of(band, within * half[0] - points[:, 0].abs())


def hoops_along(points: Points, half: Half, spans: Sequence[Pair]) -> Margin:
    """Bands around a tube that goes up to the front, from corner to corner of its box; in
    halves."""
    long = torch.hypot(half[1], half[2])
    at = (points[:, 2] * half[2] - points[:, 1] * half[1]) / long.square()
    return any_of(*(torch.minimum(at - low, high - at) for low, high in spans)) * long


def ridge(points: Points, half: Half, wide: float) -> Margin:
    """A stripe along the back, ``wide`` in halves of the width."""
    return all_of(wide * half[0] - points[:, 0].abs(), points[:, 2] + points[:, 1] * 0.5)


def carpet(points: Points, half: Half, wide: float = 0.6, back: float = 2.0) -> Margin:
    """A runner up the middle of a stair, not farther back than ``back``; in halves."""
    return all_of(wide * half[0] - points[:, 0].abs(), back * half[1] - points[:, 1])


def wave(points: Points, half: Half, high: float = 0.2, wide: float = 0.2) -> Margin:
    """A band around a can that rises and falls twice; its rise and half its width in halves."""
    x, y, z = points.unbind(1)
    rise = high * half[2]
    away = z - rise * (2 * torch.atan2(x, -y)).sin()
    return (wide * half[2] - away.abs()) / torch.hypot(2 * rise / half[0], half.new_tensor(1.0))


def zigzag(
    points: Points, half: Half, count: int, high: float, wide: float, at: float = 0.0
) -> Margin:
    """A line up and down around an upright axis: ``count`` teeth; half its height and the height
    ``at`` of its middle in halves, half its width in training units."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    rise = high * half[2] * (4 * (turn - turn.round()).abs() - 1)
    steep = 4 * high * half[2] * count / (math.tau * half[0])
    up = points[:, 2] - at * half[2]
    return wide - (up - rise).abs() / torch.sqrt(1 + steep * steep)


def bordered_zigzag(
    points: Points, half: Half, at: float, count: int, high: float, wide: float
) -> Margin:
    """A zigzag between two level lines."""
    borders = 0.8 * wide - ((points[:, 2] - at * half[2]).abs() - 1.9 * high * half[2]).abs()
    return any_of(zigzag(points, half, count, high, wide, at), borders)


def egg_bands(points: Points, half: Half) -> Margin:
    """Two zigzags around an Easter egg."""
    turn = torch.atan2(points[:, 1], points[:, 0]) * (12 / math.tau)
    tooth = (turn - turn.round()).abs() * 2  # from 0 to 1 and back
    margins = [
        0.055 * half[2] - (points[:, 2] - (at + 0.13 * tooth) * half[2]).abs()
        for at in (-0.38, 0.2)
    ]
    return 0.8 * any_of(*margins)  # they are steeper than level bands


def brim(points: Points, half: Half, low: float, high: float) -> Margin:
    """A ring between two ovals around a hat in halves, not on its crown."""
    away = (points[:, :2] / half[:2]).norm(dim=1)
    return all_of(away - low, high - away) * torch.minimum(half[0], half[1])


def sock_heel(points: Points, half: Half) -> Margin:
    """The heel of a sock whose toe is to the front."""
    middle = points.new_tensor([0.0, float(half[1] - half[0]), float(1.05 * half[0] - half[2])])
    from_it = points - middle
    return all_of(1.08 * half[0] - from_it.norm(dim=1), from_it[:, 1])


def sock_toe(points: Points, half: Half) -> Margin:
    """The toe of a sock to the front."""
    return 0.8 * half[0] - points[:, 1] - half[1]


def cutting_edge(points: Points, half: Half, wide: float = 0.26) -> Margin:
    """The slightly curved edge of an axe that cuts to the left."""
    bow = 0.1 * half[0] * (points[:, 2] / half[2]).square()
    return (wide - 1) * half[0] + bow - points[:, 0]


def tent_hems(points: Points, half: Half, wide: float = 0.03) -> Margin:
    """Hems of a tent: along its foot, and along the edges of its door in front."""
    x, _, z = points.unbind(1)
    foot = -0.86 * half[2] - z
    at = torch.stack([x.abs(), z], 1)
    edge = points.new_tensor([[0.44, -1.0], [0.0, 0.44]]) * half[[0, 2]]
    door = all_of(strokes(at, edge, wide), -points[:, 1] - 0.8 * half[1])
    return any_of(foot, door)
