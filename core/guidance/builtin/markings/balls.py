"""Markings of balls, cubes and eggs."""

import math
from collections.abc import Sequence
from functools import cache

import torch
import torch.nn.functional as F
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Marks,
    Points,
    all_of,
    any_of,
    blobs,
)
from core.guidance.builtin.markings.stencils import land, lettering

PHI = (1 + math.sqrt(5)) / 2
PENTAGON, HEXAGON = 2.3274, 2.2673  # of a truncated icosahedron: how far its faces are, edges of 1
APART = 0.29  # how fast two of its faces part, of its radius
SEAM = 0.012  # half a seam's width
Vector = tuple[float, float, float]


def facing(points: Points, normals: Sequence[Sequence[float]]) -> Float[Tensor, "p n"]:
    """The cosine between each place and each normal."""
    way = F.normalize(points, dim=1)
    return way @ F.normalize(way.new_tensor(normals), dim=1).T


@cache
def _football() -> tuple[list[list[float]], list[list[float]]]:
    """The middles of a truncated icosahedron's pentagons and hexagons, a pentagon a little above
    the front."""
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
    """The twelve dark ones of a football."""
    five, six = _football()
    dark, light = facing(points, five).amax(1) / PENTAGON, facing(points, six).amax(1) / HEXAGON
    return (dark - light) * (half.mean() * PENTAGON / (2 * APART))


def football_seams(points: Points, half: Half) -> Margin:
    """The lines between a football's hexagons."""
    _, six = _football()
    first, second = (facing(points, six) / HEXAGON).topk(2, 1).values.T
    return SEAM - (first - second) * (half.mean() * HEXAGON / (2 * APART))


def mesh_gaps(points: Points, half: Half, count: int = 9, wire: float = 0.4) -> Margin:
    """Between the wires of a mesh about a ball, in squares on the six sides of a cube about it."""
    size, order = points.abs().sort(1, descending=True)
    sides = torch.stack([(order[:, 0] + 1) % 3, (order[:, 0] + 2) % 3], 1)
    angles = torch.atan2(points.gather(1, sides), size[:, :1])
    at = angles * (count / (math.pi / 2)) + count / 2
    away = (at - at.floor() - 0.5).abs().amax(1)
    return (0.5 - wire / 2 - away) * (half.mean() * math.pi / (2 * count))


def gores(points: Points, half: Half, number: int) -> Margin:
    """One of a beach ball's six, from cap to cap about an axis that leans to the front."""
    c, s = math.cos(0.6), math.sin(0.6)
    x, y, z = F.normalize(points, dim=1).unbind(1)
    x, y, z = x, c * y - s * z, s * y + c * z
    angle = torch.atan2(x, -y) - number * math.tau / 6
    angle = (angle + math.pi).remainder(math.tau) - math.pi
    flat = torch.hypot(x, y)
    cap = z.abs().clamp(max=1).acos() - 0.16
    return all_of((math.pi / 6 - angle.abs()) * flat, cap) * half.mean()


def _seam(points: Points) -> tuple[Tensor, Tensor]:
    """Of a tennis ball's curve, z = 1.3 (x² - y²): the way to it, signed, in radii; and the angle
    about the vertical."""
    x, y, z = F.normalize(points, dim=1).roll(1, 1).unbind(1)
    value = z - 1.3 * (x * x - y * y)
    slope = torch.stack([-2.6 * x, 2.6 * y, torch.ones_like(x)], 1)
    way = torch.stack([x, y, z], 1)
    slope = slope - (slope * way).sum(1, keepdim=True) * way
    return value / slope.norm(dim=1).clamp_min(0.2), torch.atan2(y, x)


def sectors(points: Points, _half: Half, count: int) -> Margin:
    """Every other one of a canopy's, ``count`` of them, from the top to the rim."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    away = (turn - turn.round()).abs() * (math.tau / count)
    return math.pi / (2 * count) * points[:, :2].norm(dim=1) - away * points[:, :2].norm(dim=1)


def at_top(points: Points, half: Half, marks: Marks) -> Margin:
    """What is on the ball that the upper end of something is, of the same width."""
    up = torch.stack([half[0] * 0, half[0] * 0, half[2] - half[0]])
    return marks(points - up, half[0].expand(3))


def tennis_seam(points: Points, half: Half) -> Margin:
    """The curve about a tennis ball."""
    return (0.05 - _seam(points)[0].abs()) * half.mean()


def stitches(points: Points, half: Half) -> Margin:
    """A baseball's: the same curve, and strokes across it that lean to both sides."""
    away, angle = _seam(points)
    way = angle * (72 / math.tau) + 5.0 * away.abs()
    stroke = (0.24 - (way - way.round()).abs()) * (math.tau / 72)
    return any_of(0.012 - away.abs(), all_of(0.1 - away.abs(), stroke)) * half.mean()


def _panels(points: Points) -> tuple[Tensor, Tensor]:
    """Of a volleyball, whose faces are a cube's with three bands each: the angle from the middle of
    the band, and from the face's border."""
    size, order = points.abs().sort(1, descending=True)
    axis = order[:, 0]
    across = points.gather(1, ((axis + 1) % 3)[:, None])[:, 0]
    return torch.atan2(across.abs(), size[:, 0]), torch.atan2(size[:, 0] - size[:, 1], size[:, 0])


def volleyball_bands(points: Points, half: Half) -> Margin:
    """The middle ones."""
    band, border = _panels(points)
    return all_of(math.pi / 12 - band, border) * half.mean()


def volleyball_seams(points: Points, half: Half) -> Margin:
    """The lines between all."""
    band, border = _panels(points)
    return SEAM - torch.minimum((band - math.pi / 12).abs(), border) * half.mean()


def cap(points: Points, half: Half, wide: float, way: Vector = (0.0, -1.0, 0.0)) -> Margin:
    """What of a ball is within ``wide`` radians of a direction."""
    return (wide - facing(points, [way])[:, 0].clamp(-1, 1).acos()) * half.mean()


def caps(points: Points, half: Half, wide: float, ways: Sequence[Vector]) -> Margin:
    """The same of several directions."""
    return any_of(*(cap(points, half, wide, way) for way in ways))


def dimples(points: Points, half: Half, count: int = 180, wide: float = 0.075) -> Margin:
    """Spots that are spread evenly: a spiral with the golden angle (Vogel 1979)."""
    k = torch.arange(count).to(points)
    z, angle = 1 - (2 * k + 1) / count, k * (math.pi * (3 - math.sqrt(5)))
    flat = (1 - z * z).sqrt()
    ways = torch.stack([flat * angle.cos(), flat * angle.sin(), z], 1)
    nearest = (F.normalize(points, dim=1) @ ways.T).amax(1)
    return (wide - nearest.clamp(-1, 1).acos()) * half.mean()


def mirror_gaps(points: Points, half: Half, rows: int = 18) -> Margin:
    """The lines between a mirror ball's tiles, which lie in rows."""
    x, y, z = F.normalize(points, dim=1).unbind(1)
    north = (z.clamp(-1, 1).asin() / math.pi + 0.5) * rows
    row = north.floor().clamp(0, rows - 1)
    middle = ((row + 0.5) / rows - 0.5) * math.pi
    count = (2 * rows * middle.cos()).round().clamp_min(3)
    east = (torch.atan2(y, x) / math.tau + 0.5) * count + 0.5 * row.remainder(2)
    up = (north - north.round()).abs() * (math.pi / rows)
    side = (east - east.round()).abs() * (math.tau / count) * middle.cos()
    return (0.012 - torch.minimum(up, side)) * half.mean()


def number_on(points: Points, half: Half, text: str, way: Vector, high: float) -> Margin:
    """Letters on a ball about a direction, ``high`` in radii; upright."""
    ahead = F.normalize(points.new_tensor(way), dim=0)
    right = F.normalize(torch.linalg.cross(points.new_tensor([0.0, 0, 1]), -ahead), dim=0)
    up = torch.linalg.cross(-ahead, right)
    on = F.normalize(points, dim=1)
    at = torch.stack([on @ right, on @ up], 1) / high
    return all_of((lettering(at, text) + 0.04) * high, on @ ahead) * half.mean()


Spans = Sequence[tuple[float, float]]


def _upright(points: Points, lean: float) -> Points:
    """Places on a globe whose axis leans by so many degrees to the side."""
    c, s = math.cos(math.radians(lean)), math.sin(math.radians(lean))
    x, y, z = points.unbind(1)
    return torch.stack([c * x - s * z, y, s * x + c * z], 1)


def lands(points: Points, half: Half, lean: float = 0.0) -> Margin:
    """The world's."""
    return land(_upright(points, lean)) * half.mean()


def poles(points: Points, half: Half, lean: float = 0.0) -> Margin:
    """The ice at the world's ends, farther out in the south."""
    north = F.normalize(_upright(points, lean), dim=1)[:, 2].clamp(-1, 1).asin()
    return torch.maximum(north - math.radians(76), -north - math.radians(66)) * half.mean()


def zones(points: Points, half: Half, spans: Spans, lean: float = 0.0) -> Margin:
    """A planet's, between latitudes in degrees."""
    north = F.normalize(_upright(points, lean), dim=1)[:, 2].clamp(-1, 1).asin()
    spans = [(math.radians(low), math.radians(high)) for low, high in spans]
    return any_of(*(torch.minimum(north - a, b - north) for a, b in spans)) * half.mean()


def craters(points: Points, half: Half) -> Margin:
    """The moon's plains and craters."""
    on = F.normalize(points, dim=1)
    plains, rings = blobs(on, half, 0.8, (0.14, 0.34), 0.4), blobs(on, half, 0.3, (0.03, 0.09), 0.4)
    return any_of(plains, rings) * half.mean()


PIPS: dict[int, list[tuple[float, float]]] = {
    1: [(0, 0)],
    2: [(-1, 1), (1, -1)],
    3: [(-1, 1), (0, 0), (1, -1)],
    4: [(-1, -1), (-1, 1), (1, -1), (1, 1)],
    5: [(-1, -1), (-1, 1), (1, -1), (1, 1), (0, 0)],
    6: [(-1, -1), (-1, 0), (-1, 1), (1, -1), (1, 0), (1, 1)],
}
FACES = {(1, -1): 1, (2, 1): 2, (0, 1): 3, (0, -1): 4, (2, -1): 5, (1, 1): 6}  # axis, side: number


def _on_faces(points: Points, half: Half) -> list[tuple[int, int, Tensor, Tensor]]:
    """Of a cube's six faces the axis, the side, which places are nearest to it, and where these lie
    on it, in halves of the cube."""
    at = points / half
    axis = at.abs().argmax(1)
    found = []
    for k in range(3):
        for side in (-1, 1):
            here = (axis == k) & (at[:, k] * side > 0)
            found.append((k, side, here, at[here][:, [i for i in range(3) if i != k]]))
    return found


def pips(points: Points, half: Half) -> Margin:
    """A die's; opposite faces add to seven."""
    margin = torch.full_like(points[:, 0], -1.0)
    for axis, side, here, at in _on_faces(points, half):
        middles = at.new_tensor(PIPS[FACES[axis, side]]) * 0.48
        margin[here] = (0.17 - torch.cdist(at, middles).amin(1)) * half.mean()
    return margin


@cache
def _scrambled() -> Int[Tensor, "6 3 3"]:
    """A puzzle cube's colours by face, row and column: nine of each, the middles in place."""
    others = torch.arange(6).repeat_interleave(8)[torch.randperm(48, generator=_generator())]
    faces = torch.empty(6, 9, dtype=torch.long)
    faces[:, 4] = torch.arange(6)
    faces[:, [0, 1, 2, 3, 5, 6, 7, 8]] = others.view(6, 8)
    return faces.view(6, 3, 3)


def _generator() -> torch.Generator:
    return torch.Generator().manual_seed(3)


def stickers(points: Points, half: Half, color: int) -> Margin:
    """Those of one of a puzzle cube's six colours, as it lies when somebody has turned it."""
    margin = torch.full_like(points[:, 0], -1.0)
    for axis, side, here, at in _on_faces(points, half):
        cell = (at * 1.5).round().clamp(-1, 1)
        inside = 0.285 - (at - cell * 0.645).abs().amax(1)
        row, column = (cell + 1).long().T
        own = _scrambled().to(row.device)[2 * axis + (side > 0)][row, column]
        margin[here] = torch.where(own == color, inside, -inside.abs() - 0.01) * half.mean()
    return margin


def egg_bands(points: Points, half: Half) -> Margin:
    """Two zigzags about an easter egg."""
    turn = torch.atan2(points[:, 1], points[:, 0]) * (12 / math.tau)
    tooth = (turn - turn.round()).abs() * 2  # from 0 to 1 and back
    margins = [
        0.055 * half[2] - (points[:, 2] - (at + 0.13 * tooth) * half[2]).abs()
        for at in (-0.38, 0.2)
    ]
    return 0.8 * any_of(*margins)  # they are steeper than level bands


def egg_dots(points: Points, half: Half) -> Margin:
    """Rows of dots above, between and below them."""
    angle, flat = torch.atan2(points[:, 1], points[:, 0]), points[:, :2].norm(dim=1)
    turn = angle * (10 / math.tau)
    margins = []
    for at in (-0.62, 0.02, 0.58):
        side = (turn - turn.round()).abs() * (math.tau / 10) * flat
        margins.append(0.085 * half[2] - torch.hypot(side, points[:, 2] - at * half[2]))
    return any_of(*margins)
