"""Panels, seams, caps and dimples of balls."""

import math
from collections.abc import Sequence
from functools import cache

import torch
import torch.nn.functional as F
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import Half, Margin, Marks, Points, Way, all_of, any_of

PHI = (1 + math.sqrt(5)) / 2
PENTAGON, HEXAGON = 2.3274, 2.2673  # of a truncated icosahedron: how far its faces are, edges of 1
APART = 0.29  # how fast two of its faces part, of its radius
SEAM = 0.012  # half a seam's width


def facing(points: Points, normals: Sequence[Sequence[float]]) -> Float[Tensor, "p n"]:
    """Cosines between the directions of places and ``normals``."""
    way = F.normalize(points, dim=1)
    return way @ F.normalize(way.new_tensor(normals), dim=1).T


@cache
def _football() -> tuple[list[list[float]], list[list[float]]]:
    """Middles of the pentagons and of the hexagons of a truncated icosahedron, with a pentagon a
    little above the front."""
    even = [(0.0, a, b * PHI) for a in (1, -1) for b in (1, -1)]
    corners = torch.tensor([p[k:] + p[:k] for p in even for k in range(3)])
    near = (corners @ corners.T) > 1  # neighbours have PHI
    faces = [
        (corners[i] + corners[j] + corners[k]).tolist()
        for i in range(12)
        for j in range(i)
        for k in range(j)
        if near[i, j] and near[j, k] and near[i, k]
    ]
    tilt, turn = math.radians(42.0), math.radians(14.0)
    c, s, d, e = math.cos(tilt), math.sin(tilt), math.cos(turn), math.sin(turn)
    about = torch.tensor([[1, 0, 0], [0, c, -s], [0, s, c]])
    about = torch.tensor([[d, -e, 0], [e, d, 0], [0, 0, 1]]) @ about
    return (corners @ about.T).tolist(), (torch.tensor(faces) @ about.T).tolist()


def pentagons(points: Points, half: Half) -> Margin:
    """The twelve dark pentagons of a football."""
    five, six = _football()
    dark, light = facing(points, five).amax(1) / PENTAGON, facing(points, six).amax(1) / HEXAGON
    return (dark - light) * (half.mean() * PENTAGON / (2 * APART))


def football_seams(points: Points, half: Half) -> Margin:
    """The lines between a football's hexagons."""
    _, six = _football()
    first, second = (facing(points, six) / HEXAGON).topk(2, 1).values.T
    return SEAM - (first - second) * (half.mean() * HEXAGON / (2 * APART))


def gores(points: Points, half: Half, number: int) -> Margin:
    """One of the six gores of a beach ball, from cap to cap about an axis that leans to the
    front."""
    c, s = math.cos(0.6), math.sin(0.6)
    x, y, z = F.normalize(points, dim=1).unbind(1)
    x, y, z = x, c * y - s * z, s * y + c * z
    angle = torch.atan2(x, -y) - number * math.tau / 6
    angle = (angle + math.pi).remainder(math.tau) - math.pi
    flat = torch.hypot(x, y)
    cap = z.abs().clamp(max=1).acos() - 0.16
    return all_of((math.pi / 6 - angle.abs()) * flat, cap) * half.mean()


def _tennis_curve(points: Points) -> tuple[Tensor, Tensor]:
    """Signed distances in radii from the curve of a tennis ball, z = 1.3 (x² - y²), and angles
    about the vertical."""
    x, y, z = F.normalize(points, dim=1).roll(1, 1).unbind(1)
    value = z - 1.3 * (x * x - y * y)
    slope = torch.stack([-2.6 * x, 2.6 * y, torch.ones_like(x)], 1)
    way = torch.stack([x, y, z], 1)
    slope = slope - (slope * way).sum(1, keepdim=True) * way
    return value / slope.norm(dim=1).clamp_min(0.2), torch.atan2(y, x)


def tennis_seam(points: Points, half: Half) -> Margin:
    """The curve around a tennis ball."""
    return (0.05 - _tennis_curve(points)[0].abs()) * half.mean()


def baseball_stitches(points: Points, half: Half) -> Margin:
    """A baseball's seam, the curve of a tennis ball, with strokes across it that lean to both
    sides."""
    away, angle = _tennis_curve(points)
    way = angle * (72 / math.tau) + 5.0 * away.abs()
    stroke = (0.24 - (way - way.round()).abs()) * (math.tau / 72)
    return any_of(0.012 - away.abs(), all_of(0.1 - away.abs(), stroke)) * half.mean()


def _volleyball_angles(points: Points) -> tuple[Tensor, Tensor]:
    """Angles from the middle of a volleyball's band and from the border of its face; its six faces
    are a cube's, with three bands each."""
    size, order = points.abs().sort(1, descending=True)
    axis = order[:, 0]
    across = points.gather(1, ((axis + 1) % 3)[:, None])[:, 0]
    return torch.atan2(across.abs(), size[:, 0]), torch.atan2(size[:, 0] - size[:, 1], size[:, 0])


def volleyball_bands(points: Points, half: Half) -> Margin:
    """The middle band of each face of a volleyball."""
    band, border = _volleyball_angles(points)
    return all_of(math.pi / 12 - band, border) * half.mean()


def volleyball_seams(points: Points, half: Half) -> Margin:
    """The lines between the bands and the faces of a volleyball."""
    band, border = _volleyball_angles(points)
    return SEAM - torch.minimum((band - math.pi / 12).abs(), border) * half.mean()


def cap(points: Points, half: Half, wide: float, way: Way = (0.0, -1.0, 0.0)) -> Margin:
    """The part of a ball within ``wide`` radians of a direction."""
    return (wide - facing(points, [way])[:, 0].clamp(-1, 1).acos()) * half.mean()


def caps(points: Points, half: Half, wide: float, ways: Sequence[Way]) -> Margin:
    """The same for several directions."""
    return any_of(*(cap(points, half, wide, way) for way in ways))


def dimples(points: Points, half: Half, count: int = 180, wide: float = 0.075) -> Margin:
    """Spots spread evenly over a ball: a spiral with the golden angle (Vogel 1979)."""
    k = torch.arange(count).to(points)
    z, angle = 1 - (2 * k + 1) / count, k * (math.pi * (3 - math.sqrt(5)))
    flat = (1 - z * z).sqrt()
    ways = torch.stack([flat * angle.cos(), flat * angle.sin(), z], 1)
    nearest = (F.normalize(points, dim=1) @ ways.T).amax(1)
    return (wide - nearest.clamp(-1, 1).acos()) * half.mean()


def at_top(points: Points, half: Half, marks: Marks) -> Margin:
    """A ball's marking on a part with a ball of the same width at its upper end."""
    up = torch.stack([half[0] * 0, half[0] * 0, half[2] - half[0]])
    return marks(points - up, half[0].expand(3))
