"""Rounded edges in the normal map: no real edge is as sharp as a mesh's, and by the light along
its edges a thing is seen to be made of something.

On a fillet the normal turns from one side's to the other's. Here it does so evenly over the radius
on each side of a convex edge, so that both sides have one normal on the edge itself, and
three in a corner. Concave edges are not rounded: there one component rests on another.
"""

from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree
from torch import Tensor

from core.ops import normalize

SHARP_DEG = 35.0  # between two faces' normals: what bends less is smooth
STEPS = 3  # samples of an edge in the length of the radius
NEAREST = 16  # samples that a place looks at
LONG = 8  # radii
OWN_SIDE = 0.85  # cosine between a place's normal and that of the side that it is on
MEETING = 3  # edges near one place, at most
SAME_SIDE = 0.9  # cosine between the other sides of two samples: they are of one edge
AREA = 1e-7  # a face below it has no normal that is to be trusted, training units squared


class Edges(NamedTuple):
    """The convex edges of a mesh."""

    ends: Float[np.ndarray, "e 2 3"]
    sides: Float[np.ndarray, "e 2 3"]  # unit normals of its two faces


def convex_edges(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], shortest: float = 0.0
) -> Edges:
    """Convex edges where two faces meet at more than SHARP_DEG, in lines that are at least as
    long as ``shortest``."""
    from trimesh.graph import face_adjacency

    pairs, ends = face_adjacency(faces, return_edges=True)
    corners = verts[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(length, 1e-30)[:, None]
    sides = normal[pairs]
    middle = corners.mean(1)[pairs]
    out = (sides[:, 0] * (middle[:, 1] - middle[:, 0])).sum(1) < 0
    sharp = (sides[:, 0] * sides[:, 1]).sum(1) < np.cos(np.radians(SHARP_DEG))
    kept = out & sharp & (length[pairs] > 2 * AREA).all(1)
    ends, sides = ends[kept], sides[kept]
    span = np.linalg.norm(verts[ends[:, 0]] - verts[ends[:, 1]], axis=1)
    joined = coo_array((np.ones(len(ends)), tuple(ends.T)), (len(verts), len(verts)))
    line = connected_components(joined, directed=False)[1][ends[:, 0]]
    long = np.bincount(line, span, len(verts))[line] >= shortest
    return Edges(verts[ends[long]], sides[long])


class RoundedEdges:
    """Normals near the edges of a mesh, as if these were rounded."""

    def __init__(
        self, verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], radius: float
    ) -> None:
        """``radius`` in the vertices' unit, over 0."""
        self.radius = radius
        ends, sides = convex_edges(verts, faces, LONG * radius)
        along = ends[:, 1] - ends[:, 0]
        length = np.linalg.norm(along, axis=1)
        count = np.maximum(np.ceil(STEPS * length / radius), 1).astype(np.int64)
        edge = np.repeat(np.arange(len(ends)), count)
        step = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count)
        part = (step + 0.5) / count[edge]
        self._at = torch.from_numpy(ends[edge, 0] + part[:, None] * along[edge])
        self._along = torch.from_numpy((along / np.maximum(length, 1e-30)[:, None])[edge])
        self._sides = torch.from_numpy(sides[edge])
        self._tree = KDTree(self._at.numpy()) if len(edge) else None

    def normals(
        self, points: Float[Tensor, "n 3"], normals: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n 3"]:
        """``normals``, unit, of ``points`` of the surface, turned towards the other sides of the
        edges within the radius."""
        if self._tree is None:
            return normals
        query, reach = points.double().numpy(), self.radius * (1 + 1 / STEPS)
        close = self._tree.query(query, distance_upper_bound=reach)[0] < reach
        if not close.any():
            return normals
        here = torch.from_numpy(np.flatnonzero(close))
        _, found = self._tree.query(query[close], NEAREST, distance_upper_bound=reach)
        own = normals[here].double()
        weight, other = self._sides_of(points[here].double(), own, torch.from_numpy(found))
        return normals.index_copy(0, here, normalize(_towards(own, weight, other)).to(normals))

    def _sides_of(
        self, points: Float[Tensor, "n 3"], normals: Float[Tensor, "n 3"], found: Int[Tensor, "n k"]
    ) -> tuple[Float[Tensor, "n k"], Float[Tensor, "n k 3"]]:
        """The weights of the samples ``found`` near each place, from 1 on the edge to 0 a
        radius away, and the normal of their other side; 0 where none was found, or where the place
        is on neither side."""
        known = found < len(self._at)
        found = torch.where(known, found, 0)
        off, along, sides = (
            points[:, None] - self._at[found],
            self._along[found],
            self._sides[found],
        )
        off = off - (off * along).sum(-1, keepdim=True) * along
        weight = (1 - off.norm(dim=-1) / self.radius).clamp(min=0)
        cosine, own = (sides * normals[:, None, None]).sum(-1).max(-1)
        other = sides.gather(2, (1 - own)[..., None, None].expand(-1, -1, 1, 3))[:, :, 0]
        return weight * (known & (cosine > OWN_SIDE)), other


def _towards(
    normals: Float[Tensor, "n 3"], weight: Float[Tensor, "n k"], other: Float[Tensor, "n k 3"]
) -> Float[Tensor, "n 3"]:
    """The sum of a place's normal and those of the other sides of its edges; of the samples of one
    edge the one that counts most."""
    total, rows = normals.clone(), torch.arange(len(normals))
    for _ in range(MEETING):
        most, which = weight.max(1)
        chosen = other[rows, which]
        total = total + most[:, None] * chosen
        same = (other * chosen[:, None]).sum(-1) > SAME_SIDE
        weight = torch.where(same, 0.0, weight)
    return total
