"""Solids that are cut out of others: balls, what is beyond a plane, a wedge, a rough break."""

from collections.abc import Callable, Sequence
from functools import reduce
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.union import ball, common, hull, less, union

FAR = 4.0  # training units: how far a half-space goes
SEGMENTS = 64  # around a ball

Vector = Float[np.ndarray, " 3"]


class Tool(NamedTuple):
    """A closed mesh, and signed distances from it that are negative inside."""

    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    distance: Callable[[Float[Tensor, "n 3"]], Float[Tensor, " n"]]


def capsule(start: Vector, end: Vector, radius: float) -> Tool:
    """All within ``radius`` of a line."""
    verts, _ = ball(np.full(3, radius), np.inf, SEGMENTS)
    round_end = verts.double().numpy()
    ends = [round_end + start, round_end + end] if np.any(start != end) else [round_end + start]
    first, way = torch.from_numpy(start), torch.from_numpy(end - start)

    def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        off, along = points - first.to(points), way.to(points)
        fraction = (off @ along / along.square().sum().clamp_min(1e-12)).clamp(0, 1)
        return (off - fraction[:, None] * along).norm(dim=1) - radius

    return Tool(*hull(np.concatenate(ends), np.inf), at)


def beyond(normal: Vector, offset: float) -> Tool:
    """All points p with normal @ p > offset, for a normal of length 1."""
    across, up = frame_across(normal)
    flat = [offset * normal + FAR * (i * across + j * up) for i in (-1, 1) for j in (-1, 1)]
    verts, faces = hull(np.array([*flat, *(one + FAR * normal for one in flat)]), np.inf)
    along = torch.from_numpy(normal)
    return Tool(verts, faces, lambda points: offset - points @ along.to(points))


def outside(center: Vector, radii: Vector) -> Tool:
    """All outside an ellipsoid; exact distances near a ball."""
    verts, faces = ball(radii, np.inf, SEGMENTS)
    verts = verts + torch.from_numpy(center).to(verts)
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * FAR
    middle, sizes = torch.from_numpy(center), torch.from_numpy(radii)

    def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        return (1 - ((points - middle.to(points)) / sizes.to(points)).norm(dim=1)) * radii.min()

    return Tool(*less(hull(corners, np.inf), (verts, faces)), at)


def larger(
    mesh: tuple[Tensor, Tensor],
    distance: Callable[[Float[Tensor, "n 3"]], Float[Tensor, " n"]],
    center: Vector,
    scale: Vector,
    shift: Vector,
) -> Tool:
    """A closed mesh scaled along x, y and z about a center, then moved; ``distance``: from the mesh
    as it is."""
    ends = [torch.from_numpy(one) for one in (center, scale, shift)]

    def moved(points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        middle, sizes, by = (one.to(points) for one in ends)
        return (points - middle) * sizes + middle + by

    def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        middle, sizes, by = (one.to(points) for one in ends)
        return distance((points - middle - by) / sizes + middle) * float(scale.min())

    return Tool(moved(mesh[0]), mesh[1], at)


def rough(
    normal: Vector,
    offset: float,
    heights: Float[np.ndarray, "k k"],
    reach: float,
    shift: Sequence[float] = (0.0, 0.0),
) -> Tool:
    """As :func:`beyond`, of a surface in flat triangles.

    Args:
        heights: above the plane, at the nodes of a square lattice; farther off as at its rim.
        reach: half of the lattice's side, along two directions across the normal.
        shift: the lattice's middle along these.
    """
    across, up = frame_across(normal)
    count = len(heights)
    side = np.concatenate([[-FAR], np.linspace(-reach, reach, count), [FAR]])
    heights_out = np.pad(heights, 1, mode="edge")
    u, v = (x.ravel() for x in np.meshgrid(side, side, indexing="ij"))
    flat = (u[:, None] + shift[0]) * across + (v[:, None] + shift[1]) * up
    low = flat + (offset + heights_out.ravel()[:, None]) * normal
    top = flat + (offset + FAR) * normal
    faces = _closed_lattice(count + 2)
    table = torch.from_numpy(heights).float()[None, None]
    ways = torch.from_numpy(np.stack([across, up, normal], 1))
    cell = 2 * reach / (count - 1)
    steep = 1 + float(np.abs(np.diff(heights, axis=0)).mean() / cell) ** 2

    def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        x, y, height = (points @ ways.to(points)).T
        known = table.to(points)[0, 0]
        pairs = zip((x, y), shift, strict=True)
        p, q = (((z - by + reach) / cell).clamp(0, count - 1 - 1e-4) for z, by in pairs)
        i, j = p.long(), q.long()
        s, t = p - i, q - j
        here, both = known[i, j], known[i + 1, j + 1]
        # Each square is two triangles, along its diagonal.
        first = here + s * (known[i + 1, j] - here) + t * (both - known[i + 1, j])
        second = here + t * (known[i, j + 1] - here) + s * (both - known[i, j + 1])
        return (offset + torch.where(s > t, first, second) - height) / steep**0.5

    verts = torch.from_numpy(np.concatenate([low, top])).float()
    return Tool(verts, torch.from_numpy(faces), at)


def _closed_lattice(count: int) -> Int[np.ndarray, "f 3"]:
    """The faces between two square lattices of nodes, the lower one's first, and their walls."""
    node = np.arange(count * count).reshape(count, count)
    a, b, c, d = node[:-1, :-1], node[1:, :-1], node[1:, 1:], node[:-1, 1:]
    up = np.concatenate([np.stack(three, -1).reshape(-1, 3) for three in ((a, b, c), (a, c, d))])
    rim = np.concatenate([node[:, 0], node[-1, 1:], node[-2::-1, -1], node[0, -2::-1]])
    one, other, top = rim[:-1], rim[1:], count * count
    wall = np.concatenate(
        [
            np.stack([one, one + top, other], 1),
            np.stack([other, one + top, other + top], 1),
        ]
    )
    return np.concatenate([up[:, ::-1], up + top, wall[:, ::-1]])


def joined(tools: Sequence[Tool]) -> Tool:
    """All that is inside any of several."""
    meshes = [(one.verts, one.faces) for one in tools]
    return Tool(
        *union(meshes, 0.0),
        lambda points: torch.stack([one.distance(points) for one in tools]).amin(0),
    )


def both(tools: Sequence[Tool]) -> Tool:
    """All that is inside each of several."""
    verts, faces = reduce(common, [(one.verts, one.faces) for one in tools])
    return Tool(
        verts,
        faces,
        lambda points: torch.stack([one.distance(points) for one in tools]).amax(0),
    )


def frame_across(normal: Vector) -> tuple[Vector, Vector]:
    """Two directions across a third one, the second one as far up as it can be; the three of them
    right-handed: first x second = normal."""
    near_up = np.array([0.0, 0.0, 1.0]) if abs(normal[2]) < 0.9 else np.array([0.0, 1.0, 0.0])
    across = np.cross(near_up, normal)
    across /= np.linalg.norm(across)
    return across, np.cross(normal, across)
