"""Markings of what is built of boards, woven, or printed in rows."""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front


def staves(points: Points, half: Half, count: int = 14, wide: float = 0.01) -> Margin:
    """The seams of a barrel, straight across its lids; each is twice ``wide``, in training units as
    are those that follow."""
    x, y, _ = points.unbind(1)
    turn = torch.atan2(x, -y) * (count / math.tau)
    flat = torch.hypot(x, y)
    around = (turn - turn.round()).abs() * (math.tau / count) * flat
    on_lid = flat < 0.8 * half[0]
    return torch.where(on_lid, planks(points, half, count // 2, 0, wide), wide - around)


def planks(points: Points, half: Half, count: int, axis: int = 2, wide: float = 0.009) -> Margin:
    """The seams between so many planks that follow one another along an axis."""
    pitch = 2 * half[axis] / count
    at = points[:, axis] / pitch + count / 2
    return wide - (at - at.round().clamp(1, count - 1)).abs() * pitch


def frets(points: Points, half: Half, count: int = 13) -> Margin:
    """Of a guitar's neck, below its head."""
    below = 0.62 * half[2] - points[:, 2]
    return all_of(planks(points, half, count, wide=0.007), below, in_front(points))


def year_rings(points: Points, half: Half, count: int = 6, wide: float = 0.009) -> Margin:
    """Of a trunk that was cut, seen from above."""
    pitch = half[0] / count
    away = points[:, :2].norm(dim=1) / pitch
    return wide - (away - away.round().clamp(1, count - 1)).abs() * pitch


def boarding(points: Points, half: Half, pitch: float = 0.1, wide: float = 0.008) -> Margin:
    """The upright seams of boards on four walls."""
    x, y, _ = points.unbind(1)
    along = torch.where(x.abs() * half[1] > y.abs() * half[0], y, x) / pitch
    return wide - (along - along.floor() - 0.5).abs() * pitch


def weave(points: Points, half: Half, around: int = 24, rows: int = 9) -> Margin:
    """Every other strand of a basket, over and under."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y) * (around / math.tau)
    up = z / half[2] * (rows / 2)
    over = (turn.floor() + up.floor()).remainder(2) == 0
    side = (turn - turn.round()).abs() * (math.tau / around) * torch.hypot(x, y)
    away = torch.minimum(side, (up - up.round()).abs() * (2 * half[2] / rows))
    return torch.where(over, away, -away)


def diamonds(
    points: Points, half: Half, around: int = 9, rows: int = 5, wide: float = 0.012
) -> Margin:
    """The lines between the lozenges of a pineapple."""
    x, y, z = points.unbind(1)
    flat = torch.hypot(x, y)
    turn, up = torch.atan2(x, -y) * (around / math.tau), z / half[2] * (rows / 2)
    # Of one step across both families of lines: its length along the surface.
    slope = torch.hypot(around / (math.tau * flat.clamp_min(0.05)), rows / (2 * half[2]))
    lines = torch.stack([turn + up, turn - up])
    return wide - (lines - lines.round()).abs().amin(0) / slope


def net_gaps(points: Points, half: Half, count: int = 13, string: float = 0.3) -> Margin:
    """Between the strings of a net that is seen from the front, ``count`` of them from side to
    side, each so wide a share of the pitch."""
    pitch = 2 * half[0] / count
    at = points[:, [0, 2]] / pitch
    away = (at - at.floor() - 0.5).abs().amax(1)
    return (0.5 - string / 2 - away) * pitch


def slots(points: Points, half: Half, count: int = 7, wide: float = 0.45) -> Margin:
    """Level ones in a round plate that is seen from the front."""
    x, z = points[:, 0] / half[0], points[:, 2] / half[2]
    row = z * (count + 2) / 2
    slot = (wide / 2 - (row - row.round()).abs()) * (2 * half[2] / (count + 2))
    inside = (0.82 - torch.hypot(x, row.round() * 2 / (count + 2))) * half[0]
    return all_of(slot, inside, in_front(points))


def seeds(points: Points, half: Half, count: int = 36, up: int = 2, size: float = 0.04) -> Margin:
    """On what is round about the axis ``up``, each pointing away from it: on a bun's top, or with
    ``up`` 1 on a flower's front."""
    sides = [axis for axis in range(3) if axis != up]
    at = points[:, sides] / half[sides].mean()
    number = torch.arange(count) + 0.5
    reach, turn = 0.8 * (number / count).sqrt(), number * (math.pi * (3 - math.sqrt(5)))
    ways = torch.stack([turn.cos(), turn.sin()], 1).to(at)
    off = at[:, None] - ways * reach.to(at)[:, None]
    along = (off * ways).sum(2)
    across = off[..., 0] * ways[:, 1] - off[..., 1] * ways[:, 0]
    seed = size - torch.hypot(along / 1.7, across).amin(1)
    here = points[:, 2] - 0.3 * half[2] if up == 2 else in_front(points)
    return all_of(seed * half[sides].mean(), here)


def icons(points: Points, half: Half, columns: int = 4) -> Margin:
    """Of a phone: rows of squares on the upper part of its front, and one below."""
    x, z = points[:, 0], points[:, 2]
    pitch = 1.76 * half[0] / columns
    at = torch.stack([x / pitch + columns / 2, (0.84 * half[2] - z) / pitch], 1)
    below = torch.stack([at[:, 0], (-0.7 * half[2] - z) / pitch], 1)
    rows = max(int(1.15 * float(half[2]) / float(pitch)), 1)
    both = []
    for place, count in ((at, rows), (below, 1)):
        cell = place.floor()
        square = 0.32 - (place - cell - 0.5).abs().amax(1)
        there = (cell >= 0).all(1) & (cell[:, 0] < columns) & (cell[:, 1] < count)
        both.append(torch.where(there, square, -0.18).mul(pitch))
    return all_of(any_of(*both), in_front(points))


def written(points: Points, half: Half, rows: int = 7) -> Margin:
    """Lines of writing in the upper part of the front, of uneven length."""
    x, z = points[:, 0] / half[0], points[:, 2] / half[2]
    row = ((0.52 - z) * (rows / 0.8)).round().clamp(0, rows - 1)
    end = 0.5 - 0.16 * (row * 2.4).sin().clamp_min(0)
    line = 0.016 - (z - 0.52 + row * (0.8 / rows)).abs()
    long = torch.minimum(x + 0.52, end - x)
    return all_of(line * half[2], long * half[0], in_front(points))
