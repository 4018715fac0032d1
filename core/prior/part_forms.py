"""How much of each part's surface is flat, and how much the same all around, by the families."""

import json
import math
from pathlib import Path

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.part_forms import TABLE
from core.guidance.builtin.part_map import PARTS
from core.io.job import write_text
from core.prior.data import NOUNS
from core.prior.draw import Draw
from core.prior.families import Shape, build, gradient, surface_points

OBJECTS = 6  # of a noun
POINTS = 3000  # of an object
STEPS = (0.04, 0.12)  # training units between the places whose normals are compared
FLAT_DEG = 2.5  # between them at the first
CURVED_DEG = (3.0, 25.0)  # at the second; more is an edge
TURNS_DEG = (37.0, 101.0, 164.0, 229.0, 311.0)
ON = 0.012  # training units off a surface that is still on it
SEED = 9_000_000


def part_forms(noun: str, objects: int = OBJECTS) -> Float[Tensor, "2 p"]:
    """The flat fraction of the surface of each of the noun's parts, and the fraction that is the
    same all around; 0 of a part never seen."""
    draw = Draw(torch.Generator().manual_seed(SEED + NOUNS.index(noun)))
    found, seen = torch.zeros(2, PARTS), torch.zeros(PARTS)
    for _ in range(objects):
        shape = build(noun, "", draw)
        points = _surface(shape, draw.generator)
        part = shape.part(points)
        kinds = torch.stack([is_flat(shape, points), is_round(shape, points, part)])
        found.index_add_(1, part, kinds.float())
        seen.index_add_(0, part, torch.ones(len(part)))
    return found / seen.clamp_min(1)


def is_round(
    shape: Shape, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]
) -> Bool[Tensor, " n"]:
    """Whether a point stays on its part's surface when it is turned about the family's axis."""
    axis = -torch.tensor(shape.center[:2]) * torch.tensor(shape.scale[:2])
    hits = torch.zeros(len(points))
    for degrees in TURNS_DEG:
        turn = torch.tensor(math.radians(degrees))
        c, s = turn.cos(), turn.sin()
        x, y = (points[:, :2] - axis).T
        turned = torch.stack([c * x - s * y + axis[0], s * x + c * y + axis[1], points[:, 2]], 1)
        off = shape.distances(turned).gather(1, part[:, None])[:, 0]
        hits += off.abs() < ON
    return hits >= len(TURNS_DEG) - 1  # a handle may be in the way


def is_flat(shape: Shape, points: Float[Tensor, "n 3"]) -> Bool[Tensor, " n"]:
    """Whether the normal stays along half of four ways from each point, and curves along no more
    than one: an edge turns it at once, a ball or a cylinder by and by."""
    normal = gradient(shape.sdf, points)
    aside = torch.eye(3)[normal.abs().argmin(1)]
    u = torch.nn.functional.normalize(torch.linalg.cross(normal, aside), dim=1)
    v = torch.linalg.cross(normal, u)
    near, far = (_bends(shape, points, normal, (u, v), step) for step in STEPS)
    curved = (far > CURVED_DEG[0]) & (far < CURVED_DEG[1])
    return ((near < FLAT_DEG).sum(0) >= 2) & (curved.sum(0) <= 1)


def _bends(
    shape: Shape, points: Tensor, normal: Tensor, axes: tuple[Tensor, Tensor], step: float
) -> Float[Tensor, "4 n"]:
    """Degrees between the normals of each point and of four places around it."""
    u, v = axes
    found = []
    # Turned from the axes, along which a cylinder's normal would stay.
    for way in (u + v, u - v, -u - v, v - u):
        place = points + step * way / 2**0.5
        place = place - shape.sdf(place)[:, None] * gradient(shape.sdf, place)
        found.append((gradient(shape.sdf, place) * normal).sum(1).clamp(-1, 1).acos())
    return torch.rad2deg(torch.stack(found))


def _surface(shape: Shape, generator: torch.Generator) -> Float[Tensor, "n 3"]:
    points = surface_points(shape.sdf, 2 * EXTENT / 1.5)
    return points[torch.randint(len(points), (POINTS,), generator=generator)]


def write_forms(path: Path = TABLE) -> None:
    """The table of all nouns."""
    table = {}
    for noun in NOUNS:
        flat, around = ([round(x, 2) for x in row] for row in part_forms(noun).tolist())
        table[noun] = {"flat": flat, "round": around}
    lines = [f"{json.dumps(noun)}: {json.dumps(row)}" for noun, row in table.items()]
    write_text(path, "{\n" + ",\n".join(lines) + "\n}\n")
