"""Lattices, nets, meshes, trusses, weaves and slots."""

import math

import torch

from core.guidance.builtin.markings.forms.frames import nearest
from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
)


def weave(points: Points, half: Half, around: int = 24, rows: int = 9) -> Margin:
    """Every other strand of a basket, over and under."""
    x, y, z = points.unbind(1)
    turn = torch.atan2(x, -y) * (around / math.tau)
    up = z / half[2] * (rows / 2)
    over = (turn.floor() + up.floor()).remainder(2) == 0
    side = (turn - turn.round()).abs() * (math.tau / around) * torch.hypot(x, y)
    away = torch.minimum(side, (up - up.round()).abs() * (2 * half[2] / rows))
    return torch.where(over, away, -away)


def mesh_gaps(points: Points, half: Half, count: int = 9, wire: float = 0.4) -> Margin:
    """Gaps between the wires of a mesh around a ball: squares on the six sides of a cube."""
    size, order = points.abs().sort(1, descending=True)
    sides = torch.stack([(order[:, 0] + 1) % 3, (order[:, 0] + 2) % 3], 1)
    angles = torch.atan2(points.gather(1, sides), size[:, :1])
    at = angles * (count / (math.pi / 2)) + count / 2
    away = (at - at.floor() - 0.5).abs().amax(1)
    return (0.5 - wire / 2 - away) * (half.mean() * math.pi / (2 * count))


def net_gaps(points: Points, half: Half, count: int = 13, string: float = 0.3) -> Margin:
    """Gaps between the strings of a net, seen from the front: ``count`` from side to side;
    ``string``: a string's fraction of the pitch."""
    pitch = 2 * half[0] / count
    at = points[:, [0, 2]] / pitch
    away = (at - at.floor() - 0.5).abs().amax(1)
    return (0.5 - string / 2 - away) * pitch


def diagonals(points: Points, _half: Half, pitch: float = 0.1, wide: float = 0.012) -> Margin:
    """Diagonal lines in both directions, seen from the front, such as a mill's sails have."""
    x, z = points[:, 0], points[:, 2]
    found = []
    for along in ((x + z) / math.sqrt(2), (x - z) / math.sqrt(2)):
        at = along / pitch
        found.append(wide - (at - at.round()).abs() * pitch)
    return any_of(*found)


def cell_lines(points: Points, half: Half, count: Pair, room: float, wide: float) -> Margin:
    """Lines between the cells of panels in a row, given the box of one panel; ``room``: half the
    gap between two panels, ``count``: cells of one panel."""
    at = nearest(points, half, (0,), room)[:, [0, 2]]
    many = half.new_tensor(count)
    cell = 2 * half[[0, 2]] / many
    at = (at + half[[0, 2]]) / cell
    line = torch.minimum(at.round().clamp_min(1), many - 1)
    return wide - ((at - line).abs() * cell).amin(1)


def grid(points: Points, _half: Half, pitch: Pair, wide: float = 0.008) -> Margin:
    """Lines along and across a level part, from its middle; ``pitch`` in training units."""
    at = points[:, :2] / points.new_tensor(pitch) + 0.5
    away = (at - at.round()).abs() * points.new_tensor(pitch)
    return wide - away.amin(1)


def truss(
    points: Points, half: Half, along: int, count: int, room: Pair, bar: float = 0.016
) -> Margin:
    """Openings between the slanted bars of a beam, seen from its sides: ``count`` bays along an
    axis; ``room``: the span across it, in halves."""
    across = 3 - along  # y and z are 1 and 2
    pitch = 2 * 0.92 * half[along] / count
    low, high = room[0] * half[across], room[1] * half[across]
    at, up = points[:, along] / pitch + count / 2, points[:, across]
    turn = (at - at.floor() - 0.5).abs() * 2  # 1 between two bays, 0 in the middle of one
    rise = low + turn * (high - low)
    off = (up - rise).abs() / torch.sqrt(1 + (2 * (high - low) / pitch).square())
    inside = all_of(up - low, high - up, 0.92 * half[along] - points[:, along].abs())
    return all_of(inside, off - bar)


def slots(points: Points, half: Half, count: int = 7, wide: float = 0.45) -> Margin:
    """Level slots in a round plate, seen from the front."""
    x, z = points[:, 0] / half[0], points[:, 2] / half[2]
    row = z * (count + 2) / 2
    slot = (wide / 2 - (row - row.round()).abs()) * (2 * half[2] / (count + 2))
    inside = (0.82 - torch.hypot(x, row.round() * 2 / (count + 2))) * half[0]
    return all_of(slot, inside, in_front(points))
