"""How a shape differs from its noun's own objects where retrieval is blind: planes, edges, parts.

Melted clay of the right outline is retrieved; an artist sees at once that no edge is sharp and that
the wheels are gone. Each measure is taken of the mesh and of held-out objects of the noun, and
given as a ratio or a fraction of theirs. Shapes are as ``retrieval.normalised`` leaves them: about
the origin, their farthest point at ``NORMAL_RADIUS``; distances are in these units.
"""

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.ndimage import label
from scipy.spatial import KDTree
from torch import Tensor

from core.benchmarks.fit_scores import sampled
from core.geometry.mesh import NORMAL_RADIUS
from core.geometry.signed_distance import SolidMesh
from core.prior.draw import Draw
from core.prior.families import Shape, build, gradient, surface_points
from core.prior.retrieval import REFERENCES, SEED, chamfer, turns

POINTS = 8_000  # of a surface, evenly spread
LATTICE = 0.045  # spacing of the points from which a solid's are taken
REACH = 0.05  # within which normals are compared
PLANE_DEG = 10.0  # a plane: no normal within reach is farther off
EDGE_FRACTION = 0.1  # the sharpest of the surface, whose angle is the crease
LOST = 0.07  # a point of the family's farther away than this is missing
HEIGHTS = 16  # horizontal slices
SLICE = 72  # cells along a slice
SPECK = 4  # cells; a smaller component of a slice is noise
TURN_POINTS, TURNS = 384, 72  # for the search of the turn about the vertical

Points = Float[np.ndarray, "_ 3"]


@dataclass(frozen=True)
class Surface:
    """Points with their normals, and the components in each horizontal slice, from below."""

    points: Points
    normals: Points
    components: Int[np.ndarray, " _"]

    @classmethod
    def of_mesh(cls, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> "Surface":
        """That of an asset's mesh, +Z up."""
        low, high = verts.amin(0), verts.amax(0)
        verts = verts - (low + high) / 2
        verts = verts * (NORMAL_RADIUS / verts.norm(dim=1).max())
        points, normals = sampled(verts, faces)
        some = np.random.default_rng(0).permutation(len(points))[:POINTS]
        solid = SolidMesh(verts, faces)
        inside = solid.winding(_slices()) > 0.5
        return cls(points[some], normals[some], _components(inside.numpy()))

    @classmethod
    def of_solid(cls, shape: Shape) -> "Surface":
        """That of a family's object."""
        points = surface_points(shape.sdf, 2.4, int(4.8 / LATTICE))
        middle = (points.amin(0) + points.amax(0)) / 2
        scale = NORMAL_RADIUS / (points - middle).norm(dim=1).max()
        some = torch.from_numpy(np.random.default_rng(0).permutation(len(points))[:POINTS])
        points = points[some]
        normals = gradient(shape.sdf, points)
        inside = torch.cat([shape.sdf(at / scale + middle) < 0 for at in _slices().split(1 << 15)])
        placed = (points - middle) * scale
        return cls(placed.numpy(), normals.numpy(), _components(inside.numpy()))

    @cached_property
    def bends(self) -> Float[np.ndarray, " n"]:
        """At each point the largest angle between its normal and another within reach, degrees.

        Of several points: the ninth in ten, so that one askew face of a mesh is no
        edge.
        """
        pairs = KDTree(self.points).query_pairs(REACH, output_type="ndarray")
        each = np.arange(len(self.points))  # a point is near itself
        one, other = np.concatenate([pairs, pairs[:, ::-1], np.stack([each, each], 1)]).T
        cosine = np.einsum("nk,nk->n", self.normals[one], self.normals[other])
        cosine, count = cosine[np.lexsort((cosine, one))], np.bincount(one)
        # The first tenth of each point's, between the two that are next to it.
        at = 0.1 * (count - 1)
        first = np.cumsum(count) - count + at.astype(int)
        found = cosine[first] + at % 1 * (cosine[first + (at % 1 > 0)] - cosine[first])
        return np.degrees(np.arccos(np.clip(found, -1, 1)))

    @property
    def flat(self) -> float:
        """Fraction of the surface that is plane."""
        return float((self.bends < PLANE_DEG).mean())

    @property
    def crease(self) -> float:
        """Mean bend, degrees, of the sharpest tenth of the surface."""
        bends = np.sort(self.bends)
        return float(bends[-int(len(bends) * EDGE_FRACTION) :].mean())


def likeness(mesh: Surface, noun: str) -> dict[str, float]:
    """The measures of a mesh of the noun.

    crease: its crease over the family's mean; less than 1 is rounded.
    flat: its plane fraction over the family's mean; 1 too where the family has no planes.
    missing: the fraction of the nearest object's surface that the mesh lacks.
    usual_missing: what the family's objects lack of one another, the least for each, in the mean.
    pieces: the fraction of the horizontal slices with as many components as those of the most
        similar object, a slice higher or lower at the most: legs, wheels and spikes count here.
    """
    family = objects(noun)
    turned = [_facing(mesh, other) for other in family]
    lost = [_missing(points, other.points) for points, other in zip(turned, family, strict=True)]
    crease = float(np.mean([other.crease for other in family]))
    flat = float(np.mean([other.flat for other in family]))
    return {
        "crease": round(mesh.crease / crease, 3),
        "flat": round(mesh.flat / flat, 3) if flat > 0.05 else 1.0,
        "missing": round(min(lost), 3),
        "usual_missing": round(_usual_missing(noun), 3),
        "pieces": round(_like_slices(mesh, family), 3),
    }


@cache
def objects(noun: str, count: int = REFERENCES) -> tuple[Surface, ...]:
    """Held-out objects of the noun; the first are those of the retrieval."""
    draw = Draw(torch.Generator().manual_seed(SEED))
    shapes = [build(noun, "", draw, jitter=0.0) for _ in range(count)]
    return tuple(Surface.of_solid(shape) for shape in shapes)


@cache
def _usual_missing(noun: str) -> float:
    """The fraction that the noun's objects lack of one another, the least for each, in the mean."""
    family = objects(noun)
    lost = [min(_missing(_facing(b, a), a.points) for b in family if b is not a) for a in family]
    return float(np.mean(lost))


def _facing(mesh: Surface, other: Surface) -> Points:
    """The mesh's points, turned about the vertical as they are nearest to the other's."""
    some = torch.from_numpy(mesh.points[:TURN_POINTS]).float()
    ways = chamfer(turns(some, TURNS), torch.from_numpy(other.points[:TURN_POINTS]).float())
    best = int(ways.argmin())
    return turns(torch.from_numpy(mesh.points).float(), TURNS)[best].numpy()


def _missing(points: Points, wanted: Points) -> float:
    return float((KDTree(points).query(wanted)[0] > LOST).mean())


def _slices() -> Float[Tensor, "n 3"]:
    """Points of horizontal slices of the ball of radius ``NORMAL_RADIUS``, one after another."""
    side = torch.linspace(-1, 1, SLICE) * NORMAL_RADIUS
    height = (torch.arange(HEIGHTS) + 0.5) / HEIGHTS * 2 - 1
    z, y, x = torch.meshgrid(height * NORMAL_RADIUS, side, side, indexing="ij")
    return torch.stack([x, y, z], -1).reshape(-1, 3)


def _components(inside: np.ndarray) -> Int[np.ndarray, " _"]:
    counts = []
    for one in inside.reshape(HEIGHTS, SLICE, SLICE):
        components = np.asarray(label(one, np.ones((3, 3)))[0])  # pyright: ignore[reportIndexIssue]
        counts.append(int((np.bincount(components.ravel())[1:] >= SPECK).sum()))
    return np.array(counts)


def _like_slices(mesh: Surface, family: tuple[Surface, ...]) -> float:
    return max(
        _equal(mesh.components, np.roll(other.components, shift))
        for other in family
        for shift in (-1, 0, 1)
    )


def _equal(one: Int[np.ndarray, " _"], other: Int[np.ndarray, " _"]) -> float:
    there = (one > 0) | (other > 0)
    return float((one == other)[there].mean()) if there.any() else 0.0
