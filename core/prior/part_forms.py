"""Forms of the families' parts: how much of each part's surface is flat, how much is the same all
around an axis, and how small its components are."""

import json
import math
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.revolved import axis
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.part_forms import TABLE
from core.guidance.builtin.part_map import PARTS
from core.io.job import write_text
from core.prior.data import NOUNS
from core.prior.draw import Draw
from core.prior.families import Shape, build, gradient, surface_points

OBJECTS, FEW_OBJECTS = 6, 3  # objects of a noun
POINTS = 3000  # points on an object
STEPS = (0.04, 0.12)  # training units between the places whose normals are compared
FLAT_DEG = 2.5  # between normals at the first step
CURVED_DEG = (3.0, 25.0)  # between normals at the second step; more is an edge
TURNS_DEG = (37.0, 101.0, 164.0, 229.0, 311.0)
ON = 0.012  # training units: the distance within which a point is on a surface
CELL = 2 * EXTENT / 64  # training units, in the lattice that objects are drawn on
APART = 0.07  # training units between the nearest surface points of two components of a part
SEED = 9_000_000


def part_forms(noun: str, objects: int = OBJECTS) -> Float[Tensor, "4 p"]:
    """Fractions of the surface of each of the noun's parts; 0 for a part never seen.

    First the flat fraction, then the fractions that are the same all around an axis of their
    component along x, along y and along z.
    """
    draw = Draw(torch.Generator().manual_seed(SEED + NOUNS.index(noun)))
    found, seen = torch.zeros(4, PARTS), torch.zeros(PARTS)
    for _ in range(objects):
        shape = build(noun, "", draw)
        points = _surface(shape, draw.generator)
        part = shape.part(points)
        axes = axes_of(shape, points, part)
        around = [is_round(shape, points, part, axes[along], along) for along in range(3)]
        found.index_add_(1, part, torch.stack([is_flat(shape, points), *around]).float())
        seen.index_add_(0, part, torch.ones(len(part)))
    return found / seen.clamp_min(1)


def is_round(
    shape: Shape,
    points: Float[Tensor, "n 3"],
    part: Int[Tensor, " n"],
    on_axis: Float[Tensor, "*n 3"],
    along: int,
) -> Bool[Tensor, " n"]:
    """Whether a point stays on its part's surface when it is turned about the line through
    ``on_axis`` along one of x, y, z."""
    first, second = (along + 1) % 3, (along + 2) % 3
    hits = torch.zeros(len(points))
    off = points - on_axis
    for degrees in TURNS_DEG:
        turn = torch.tensor(math.radians(degrees))
        c, s = turn.cos(), turn.sin()
        turned = off.clone()
        turned[:, first] = c * off[:, first] - s * off[:, second]
        turned[:, second] = s * off[:, first] + c * off[:, second]
        distance = shape.distances(turned + on_axis).gather(1, part[:, None])[:, 0]
        hits += distance.abs() < ON
    return hits >= len(TURNS_DEG) - 1  # a handle may be in the way


def axes_of(
    shape: Shape, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]
) -> Float[Tensor, "3 n 3"]:
    """For each point, a point on each axis (along x, y and z) of its part's component there."""
    found = torch.zeros(3, len(points), 3)
    for k in part.unique().tolist():
        solid = partial(_distance_to, shape, k)
        own, tree, component = components_of(shape, k)
        normal = gradient(solid, own)
        mine = torch.nonzero(part == k)[:, 0]
        of = component[tree.query(points[mine].numpy())[1]]
        for each in np.unique(of):
            some = component == each
            for along in range(3):
                aside = [(along + 1) % 3, (along + 2) % 3]
                turned = [*aside, along]
                cells = own.numpy()[some][:, turned] / CELL
                at = CELL * axis(cells, normal.numpy()[some][:, turned])
                here = mine[torch.from_numpy(of == each)]
                found[along, here[:, None], torch.tensor(aside)] = torch.from_numpy(at).float()
    return found


def components_of(shape: Shape, part: int) -> tuple[Tensor, KDTree, Int[np.ndarray, " n"]]:
    """Points of a part's surface, a tree of them, and the component that each belongs to."""
    own = surface_points(partial(_distance_to, shape, part), 2 * EXTENT / 1.5)
    tree = KDTree(own.numpy())
    pairs = tree.query_pairs(APART, output_type="ndarray")
    graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(len(own), len(own)))
    return own, tree, connected_components(graph, directed=False)[1]


def least_components(noun: str, objects: int = FEW_OBJECTS) -> list[float]:
    """For each of the noun's parts the area of its least component, as a fraction of its largest
    component's; 0 for a part never seen."""
    draw = Draw(torch.Generator().manual_seed(SEED + NOUNS.index(noun)))
    found = np.full(PARTS, np.inf)
    for _ in range(objects):
        shape = build(noun, "", draw)
        for part in range(shape.distances(torch.zeros(1, 3)).shape[1]):
            counts = np.bincount(components_of(shape, part)[2])
            if len(counts):
                found[part] = min(found[part], counts.min() / counts.max())
    return np.where(np.isfinite(found), found, 0.0).round(3).tolist()


def _distance_to(shape: Shape, part: int, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
    return shape.distances(points)[:, part]


def is_flat(shape: Shape, points: Float[Tensor, "n 3"]) -> Bool[Tensor, " n"]:
    """Whether the normal is constant along at least two of four directions from each point, and
    curves along at most one: an edge turns it at once, a ball or a cylinder little by little."""
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


def write_forms(path: Path = TABLE, nouns: Sequence[str] = NOUNS) -> None:
    """Measure ``nouns`` and write the table; it keeps the entries of the other nouns."""
    table = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    for noun in nouns:
        flat, *around = ([round(x, 2) for x in row] for row in part_forms(noun).tolist())
        table[noun] = {"flat": flat, "round": around, "least": least_components(noun)}
    lines = [f"{json.dumps(noun)}: {json.dumps(table[noun])}" for noun in NOUNS if noun in table]
    write_text(path, "{\n" + ",\n".join(lines) + "\n}\n")
