"""How much of each part's surface is flat, by the families: where planes may be looked for."""

import json
from pathlib import Path

import torch
from jaxtyping import Bool, Float
from torch import Tensor

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.flatness import TABLE
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
SEED = 9_000_000


def part_flatness(noun: str, objects: int = OBJECTS) -> Float[Tensor, " p"]:
    """The flat fraction of the surface of each of the noun's parts; 0 of one never seen."""
    draw = Draw(torch.Generator().manual_seed(SEED + NOUNS.index(noun)))
    flat, seen = torch.zeros(PARTS), torch.zeros(PARTS)
    for _ in range(objects):
        shape = build(noun, "", draw)
        points = _surface(shape, draw.generator)
        part = shape.part(points)
        flat.index_add_(0, part, is_flat(shape, points).float())
        seen.index_add_(0, part, torch.ones(len(part)))
    return flat / seen.clamp_min(1)


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


def write_flatness(path: Path = TABLE) -> None:
    """The table of all nouns."""
    table = {noun: [round(x, 2) for x in part_flatness(noun).tolist()] for noun in NOUNS}
    lines = [f"{json.dumps(noun)}: {json.dumps(row)}" for noun, row in table.items()]
    write_text(path, "{\n" + ",\n".join(lines) + "\n}\n")
