"""Limbs that flow into one another: the smooth union of round curves, as bodies of animals are."""

from collections.abc import Sequence

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.mesh import drop_floaters, polished
from core.geometry.parts.pipes import apart, weights_of
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, tet_grid
from core.kernels import distances

OF_RADIUS, CELL = 0.35, (0.01, 0.022)  # a cell: of the median radius; training units
CELLS = (22, 84)  # along its longest side
SPANS = 10  # between two nodes: radii are curves too
LEAST_PIECE = 0.02  # of the largest component's area: a tip that is thinner than a cell
MARGIN = 1.04  # of its longest half side
POLISH = 3  # rounds
STEPS = 2  # of Newton's method, from the lattice's surface to the exact one
FARTHEST = 0.5  # cells: a step's most
LEAST_SLOPE = 0.3  # of a distance

Limb = Float[np.ndarray, "_ 5"]  # x, y, z, radius, how many times as wide along x
Numbers = Float[np.ndarray, " _"]


def packed_limbs(limbs: Sequence[Limb], softness: float) -> Numbers:
    """The softness of the union, and for each limb the count of its nodes, and these."""
    each = [[len(nodes), *np.asarray(nodes, float).ravel()] for nodes in limbs]
    return np.concatenate([[softness], *each])


def unpacked_limbs(numbers: Numbers) -> tuple[list[Limb], float]:
    """The limbs, and the softness."""
    found, at = [], 1
    while at < len(numbers):
        end = at + 1 + 5 * int(numbers[at])
        found.append(numbers[at + 1 : end].reshape(-1, 5))
        at = end
    return found, float(numbers[0])


def limbs(p: Float[np.ndarray, "n 3"], numbers: Numbers) -> Float[np.ndarray, " n"]:
    """The signed distance from the limbs, as ``packed_limbs`` has them; to first order."""
    found, softness = unpacked_limbs(numbers)
    curves = apart([_curve(nodes) for nodes in found])
    return distances.smooth_union(np.ascontiguousarray(p, dtype=float), curves, softness)


def limbs_mesh(numbers: Numbers, edge: float) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The closed surface of limbs; where ``edge`` is infinite, of balls on their curves: about as
    far out."""
    found, softness = unpacked_limbs(numbers)
    curves = np.concatenate([_curve(nodes) for nodes in found])
    if not np.isfinite(edge):
        return _extent(curves)
    reach = curves[:, 3:4] * np.maximum(curves[:, 4:], 1.0) + softness
    low, high = (curves[:, :3] - reach).min(0), (curves[:, :3] + reach).max(0)
    half = MARGIN * float((high - low).max()) / 2
    cell = float(np.clip(OF_RADIUS * np.median(curves[:, 3]), *CELL))
    grid = tet_grid(int(np.clip(2 * half / cell, *CELLS)))
    nodes = grid.tet_verts.double() * (half / EXTENT) + torch.from_numpy((low + high) / 2)
    cell = 2 * half / grid.resolution
    values = np.full(len(nodes), float(half))
    box = ((nodes.numpy() > low - cell) & (nodes.numpy() < high + cell)).all(1)
    values[box] = limbs(nodes.numpy()[box], numbers)
    verts, faces, *_ = surface(torch.from_numpy(values).float(), nodes.float(), grid)
    verts, faces = drop_floaters(verts, faces, LEAST_PIECE)
    verts = torch.from_numpy(_settled(verts.double().numpy(), numbers, cell))
    return polished(verts, faces, POLISH).float(), faces


def _extent(curves: Limb) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """An octahedron about each point."""
    ways = np.concatenate([np.eye(3), -np.eye(3)])
    reach = curves[:, None, 3:4] * np.stack([curves[:, 4], *[np.ones(len(curves))] * 2], 1)[:, None]
    verts = (curves[:, None, :3] + reach * ways).reshape(-1, 3)
    corners = [
        (x, y, z) if (x < 3) ^ (y < 3) ^ (z < 3) else (x, z, y)
        for x in (0, 3)
        for y in (1, 4)
        for z in (2, 5)
    ]
    starts = 6 * np.arange(len(curves))[:, None, None]
    faces = (starts + np.array(corners)).reshape(-1, 3)
    return torch.from_numpy(verts).float(), torch.from_numpy(faces)


def _settled(verts: Float[np.ndarray, "v 3"], numbers: Numbers, cell: float) -> np.ndarray:
    """Vertices near the surface on it."""
    step = 1e-3 * cell
    for _ in range(STEPS):
        off = limbs(verts, numbers)
        ahead = [limbs(verts + step * way, numbers) for way in np.eye(3)]
        slope = (np.stack(ahead, 1) - off[:, None]) / step
        by = off / np.maximum((slope**2).sum(1), LEAST_SLOPE**2)
        move = by[:, None] * slope
        size = np.linalg.norm(move, axis=1, keepdims=True)
        verts = verts - move * np.minimum(1, FARTHEST * cell / np.maximum(size, 1e-12))
    return verts


def _curve(nodes: Limb) -> Limb:
    return weights_of(nodes[:, :3], False, SPANS) @ nodes
