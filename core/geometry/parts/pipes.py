"""Bent pipes: smooth curves through nodes, each with a radius, with round ends.

A curve is a cubic Hermite spline whose tangents are those of the parabolas through three nodes
(Bessel's tangents: de Boor, "A Practical Guide to Splines", ch. IV).
"""

import itertools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.sweep import swept
from core.kernels import distances

BEND = 0.12  # radians, at most, between two segments of a curve
MOST_SPANS = 8  # segments between two nodes, at most

Nodes = Float[np.ndarray, "k 4"]  # x, y, z, radius


class Pipe(NamedTuple):
    """One curve; a closed one goes on from the last node to the first."""

    nodes: Nodes
    closed: bool = False

    @property
    def curve(self) -> Float[np.ndarray, "m 4"]:
        """The ends of the straight segments that it is made of; a closed one ends where it
        begins."""
        return weights_of(self.nodes[:, :3], self.closed) @ self.nodes


def packed_pipes(found: Sequence[Pipe]) -> Float[np.ndarray, " k"]:
    """For each pipe whether it is closed, the count of its nodes, and these."""
    each = [[float(pipe.closed), len(pipe.nodes), *pipe.nodes.ravel()] for pipe in found]
    return np.concatenate(each)


def unpacked_pipes(numbers: Float[np.ndarray, " k"]) -> list[Pipe]:
    """The pipes."""
    found, at = [], 0
    while at < len(numbers):
        end = at + 2 + 4 * int(numbers[at + 1])
        found.append(Pipe(numbers[at + 2 : end].reshape(-1, 4), bool(numbers[at])))
        at = end
    return found


def pipes(p: Float[np.ndarray, "n 3"], numbers: Float[np.ndarray, " k"]) -> Float[np.ndarray, " n"]:
    """The signed distance from the union of pipes, as ``packed_pipes`` has them; to first order
    where they taper."""
    curves = apart([pipe.curve for pipe in unpacked_pipes(numbers)])
    return distances.pipes(np.ascontiguousarray(p, dtype=float), curves)[0]


def apart(curves: Sequence[Float[np.ndarray, "_ k"]]) -> Float[np.ndarray, "m k"]:
    """Curves one after another, and between two of them a row that is not finite."""
    gap = np.full((1, curves[0].shape[1]), np.nan)
    return np.concatenate([rows for curve in curves for rows in (curve, gap)][:-1])


def weights_of(
    places: Float[np.ndarray, "k 3"], closed: bool, spans: int = 1
) -> Float[np.ndarray, "m k"]:
    """The curve's points, as weights of its nodes; so many ``spans`` between two, at least."""
    count = len(places)
    unit = np.eye(count)
    if count < 3:
        return unit
    ahead = np.roll(np.arange(count), -1)
    lengths = np.linalg.norm(places[ahead] - places, axis=1).clip(1e-6)
    slope = (unit[ahead] - unit) / lengths[:, None]
    behind = np.roll(np.arange(count), 1)
    tangent = (slope[behind] * lengths[:, None] + slope * lengths[behind, None]) / (
        lengths + lengths[behind]
    )[:, None]
    if not closed:  # a parabola through the first three, and the last
        tangent[0] = 2 * slope[0] - tangent[1]
        tangent[-1] = 2 * slope[-2] - tangent[-2]
    rows = []
    for k in range(count if closed else count - 1):
        bend = _angle(tangent[k] @ places, tangent[ahead[k]] @ places)
        steps = max(int(np.clip(np.ceil(bend / BEND), 1, MOST_SPANS)), spans)
        t = np.linspace(0, 1, steps + 1)[:-1, None]
        rows.append(
            (1 + 2 * t) * (1 - t) ** 2 * unit[k]
            + t**2 * (3 - 2 * t) * unit[ahead[k]]
            + lengths[k] * t * (1 - t) ** 2 * tangent[k]
            + lengths[k] * t**2 * (t - 1) * tangent[ahead[k]]
        )
    return np.concatenate([*rows, unit[:1] if closed else unit[-1:]])


def surface_of(
    pipe: Pipe, edge: float, around: int
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """A pipe's closed surface.

    Args:
        edge: segments are no longer.
        around: corners of a circle.
    """
    curve = _divided(pipe.curve, edge)
    return swept(curve[:-1] if pipe.closed else curve, pipe.closed, around)


def _divided(curve: Nodes, edge: float) -> Float[np.ndarray, "m 4"]:
    """The curve with no segment longer than ``edge``."""
    found = [curve[:1]]
    for start, end in itertools.pairwise(curve):
        length = np.linalg.norm(end[:3] - start[:3])
        count = max(int(np.ceil(length / edge)), 1) if np.isfinite(edge) else 1
        t = np.linspace(0, 1, count + 1)[1:, None]
        found.append(start + t * (end - start))
    return np.concatenate(found)


def _angle(a: np.ndarray, b: np.ndarray) -> float:
    cosine = a @ b / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-12)
    return float(np.arccos(np.clip(cosine, -1, 1)))
