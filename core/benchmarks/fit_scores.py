"""How near a mesh comes to a solid whose distance function is known: planes, edges, what is gone.

Distances are in training units, angles in degrees.
"""

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import drop_floaters, face_areas, health
from core.geometry.tet_grid import tet_grid
from core.prior.families import Shape, gradient, surface_points

SPACING = 0.02  # of the lattice that finds the true surface's points
MESH_POINTS = 60_000
NEIGHBOURS = 40
EDGE_REACH, EDGE_DEG = 0.04, 45.0  # an edge: normals this far apart within this distance
FLAT_REACH, FLAT_DEG = 0.09, 8.0  # a plane: none farther apart than that
LOST = 0.06  # a true point farther than this from the mesh is missing from it
CREASE_REACH = 0.035  # about a point of an edge, where the angle across it is measured
CREASE_POINTS = 400
CREASE_QUANTILE = 0.03  # of the cosines of all pairs: the angle across, but for outliers
CURVE_REACH = 0.15  # about a point, where a ball's curvature is measured
TRUTH_RESOLUTION = 96  # of the lattice that the solid's holes and components are counted on

Points = Float[np.ndarray, "_ 3"]
Normed = tuple[KDTree, Points]  # points to search in, and their normals


@dataclass(frozen=True)
class Truth:
    """A solid's surface as points with normals, and where it is an edge or a plane."""

    points: Points
    normals: Points
    edge: Bool[np.ndarray, " n"]
    flat: Bool[np.ndarray, " n"]
    genus: int
    components: int

    @classmethod
    def of(cls, shape: Shape) -> "Truth":
        """The truth of a family's object."""
        points = surface_points(shape.sdf, 2.0, int(4.0 / SPACING))
        normals = gradient(shape.sdf, points).numpy()
        p = points.numpy()
        distance, near = KDTree(p).query(p, NEIGHBOURS)
        cosines = np.einsum("nkc,nc->nk", normals[near], normals)

        def furthest(reach: float) -> np.ndarray:
            return np.where(distance < reach, cosines, 1.0).min(1)

        edge = furthest(EDGE_REACH) < np.cos(np.radians(EDGE_DEG))
        flat = furthest(FLAT_REACH) > np.cos(np.radians(FLAT_DEG))
        return cls(p, normals, edge, flat, *_topology(shape))


def _topology(shape: Shape) -> tuple[int, int]:
    """Genus and components of the solid, counted on a fine lattice."""
    grid = tet_grid(TRUTH_RESOLUTION)
    sdf = torch.cat([shape.sdf(part) for part in grid.tet_verts.split(1 << 17)])
    report = health(*drop_floaters(*marching_tets(grid.tet_verts, sdf, grid)))
    genus, components = report["genus"], report["components"]
    assert isinstance(genus, int) and isinstance(components, int)
    return genus, components


def scores(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], truth: Truth
) -> dict[str, object]:
    """Measures of the mesh.

    chamfer: mean distance of the two surfaces' points, both ways, × 1000.
    flat, edge: mean angle to the true normal on planes and at edges.
    crease: the angle across edges over the true one; 1 is right, less is rounded.
    missing: fraction of the true surface that the mesh lacks; extra: of the mesh that is not there.
    genus, components, closed, degenerate_faces: of the mesh; true_genus, true_components.
    """
    p, n = sampled(verts, faces)
    tree, true_tree = KDTree(p), KDTree(truth.points)
    (lost, near), (added, _) = tree.query(truth.points), true_tree.query(p)
    angle = _degrees((n[near] * truth.normals).sum(1))
    met = lost < LOST
    report = health(verts, faces)
    names = ("genus", "components", "closed", "degenerate_faces", "faces")
    return {
        "chamfer": round(500 * float(lost.mean() + added.mean()), 2),
        "flat": _mean(angle[truth.flat & met]),
        "edge": _mean(angle[truth.edge & met]),
        "crease": _crease((tree, n), (true_tree, truth.normals), truth.points[truth.edge & met]),
        "missing": round(float(1 - met.mean()), 4),
        "extra": round(float((added > LOST).mean()), 4),
        **{name: report[name] for name in names},
        "true_genus": truth.genus,
        "true_components": truth.components,
    }


def sampled(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> tuple[Points, Points]:
    """Points spread evenly over a mesh, always the same ones, and their faces' normals."""
    generator = torch.Generator().manual_seed(0)
    areas = face_areas(verts, faces)
    chosen = torch.multinomial(areas, MESH_POINTS, True, generator=generator)
    s, t = torch.rand(2, MESH_POINTS, 1, generator=generator)
    s = s.sqrt()
    a, b, c = verts[faces[chosen]].unbind(1)
    points = (1 - s) * a + s * (1 - t) * b + s * t * c
    normals = torch.nn.functional.normalize(torch.linalg.cross(b - a, c - a), dim=1, eps=1e-20)
    return points.numpy(), normals.numpy()


def curvature_error(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], radius: float) -> float:
    """Mean relative difference of a ball's curvature from 1 / ``radius``.

    By least squares of normals against points about each of them: n - n₀ = κ (p - p₀).
    """
    p, n = sampled(verts, faces)
    at = np.random.default_rng(0).permutation(len(p))[:CREASE_POINTS]
    found = []
    for near in KDTree(p).query_ball_point(p[at], CURVE_REACH):
        dp, dn = p[near] - p[near].mean(0), n[near] - n[near].mean(0)
        found.append((dp * dn).sum() / (dp * dp).sum())
    return float(np.abs(np.array(found) * radius - 1).mean())


def _crease(mesh: Normed, truth: Normed, at: Points) -> float | None:
    """Mean of the mesh's angle across the edges over the true one."""
    if not len(at):
        return None
    at = at[np.random.default_rng(0).permutation(len(at))[:CREASE_POINTS]]
    ratio = _across(*mesh, at) / np.maximum(_across(*truth, at), 1.0)
    return round(float(np.nanmean(ratio)), 3)


def _across(tree: KDTree, normals: Points, at: Points) -> Float[np.ndarray, " _"]:
    """The largest angle between normals about each point; NaN where there are too few."""
    chance, most = np.random.default_rng(0), 60
    found = []
    for near in tree.query_ball_point(at, CREASE_REACH):
        some = near if len(near) <= most else chance.choice(near, most, replace=False)
        n = normals[some]
        found.append(np.quantile(n @ n.T, CREASE_QUANTILE) if len(some) > 5 else np.nan)
    return _degrees(np.array(found))


def _degrees(cosine: np.ndarray) -> np.ndarray:
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


def _mean(values: Float[np.ndarray, " _"]) -> float | None:
    return round(float(values.mean()), 2) if len(values) else None
