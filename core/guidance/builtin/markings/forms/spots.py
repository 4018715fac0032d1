"""Spots, cells, seeds and sprinkles."""

import math
from collections.abc import Iterator

import torch
import torch.nn.functional as F
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
)


def chance(cell: Float[Tensor, "p 3"], which: int) -> Float[Tensor, " p"]:
    """A number in [0, 1) that depends on the cell alone; ``which`` of many."""
    mixed = cell @ cell.new_tensor([12.9898, 78.233, 37.719]) + 4.7 * which
    return (mixed.sin() * 43758.5453).remainder(1)


def cells_around(points: Points, pitch: float) -> Iterator[Float[Tensor, "p 3"]]:
    """The 27 cells of a lattice around each place, one by one."""
    own = (points / pitch).floor()
    for step in torch.cartesian_prod(*[torch.arange(-1, 2)] * 3).to(points):
        yield own + step


def blobs(
    points: Points, _half: Half, pitch: float, sizes: tuple[float, float], fraction: float
) -> Margin:
    """Round spots on a lattice of ``pitch``, each moved by up to a third of it and there with a
    chance of ``fraction``; the same on every object."""
    margin = torch.full_like(points[:, 0], -pitch)
    for cell in cells_around(points, pitch):
        moved = torch.stack([chance(cell, k) for k in range(3)], 1) - 0.5
        middle = (cell + 0.5 + 0.66 * moved) * pitch
        size = sizes[0] + (sizes[1] - sizes[0]) * chance(cell, 3)
        spot = size - (points - middle).norm(dim=1)
        margin = torch.where(chance(cell, 4) < fraction, torch.maximum(margin, spot), margin)
    return margin


def cells(points: Points, _half: Half, pitch: float, line: float) -> Margin:
    """Cells of a random set of points (Worley 1996) without a ``line`` between them, as on a
    giraffe."""
    away = []
    for cell in cells_around(points, pitch):
        moved = torch.stack([chance(cell, k) for k in range(3)], 1) - 0.5
        away.append((points - (cell + 0.5 + 0.7 * moved) * pitch).norm(dim=1))
    first, second = torch.stack(away, 1).topk(2, 1, largest=False).values.T
    return (second - first) / 2 - line / 2


def dapples(points: Points, half: Half, pitch: float = 0.115) -> Margin:
    """Spots along the back and flanks of a fawn."""
    spots = blobs(points, half, pitch, (0.02, 0.03), 0.9)
    return all_of(spots, points[:, 2] + 0.1 * half[2], points[:, 1] + 0.35 * half[1])


def ovals(points: Points, half: Half, at: Pair, size: Pair, both: bool = True) -> Margin:
    """Ovals on a front, in halves of it."""
    x = points[:, 0].abs() if both else points[:, 0]
    wide, high = size[0] * float(half[0]), size[1] * float(half[2])
    off = torch.hypot((x - at[0] * half[0]) / wide, (points[:, 2] - at[1] * half[2]) / high)
    return all_of((1 - off) * min(wide, high), in_front(points))


def egg_dots(points: Points, half: Half) -> Margin:
    """Three rows of dots around an egg."""
    angle, flat = torch.atan2(points[:, 1], points[:, 0]), points[:, :2].norm(dim=1)
    turn = angle * (10 / math.tau)
    margins = []
    for at in (-0.62, 0.02, 0.58):
        side = (turn - turn.round()).abs() * (math.tau / 10) * flat
        margins.append(0.085 * half[2] - torch.hypot(side, points[:, 2] - at * half[2]))
    return any_of(*margins)


def strawberry_seeds(points: Points, half: Half, rows: float = 6.0, count: int = 11) -> Margin:
    """Rows of seeds around a strawberry, every other one shifted; longer than wide."""
    up = points[:, 2] / half[2] * rows
    row = up.round()
    turn = torch.atan2(points[:, 1], points[:, 0]) * (count / math.tau) + 0.5 * row.remainder(2)
    side = (turn - turn.round()).abs() * (math.tau / count) * points[:, :2].norm(dim=1)
    return 0.026 - torch.hypot(side * 1.4, (up - row) * half[2] / rows)


def seeds(points: Points, half: Half, count: int = 36, up: int = 2, size: float = 0.04) -> Margin:
    """Seeds on a round part, each pointing away from the axis ``up``: on the top of a bun, or with
    ``up`` 1 on the front of a flower."""
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
