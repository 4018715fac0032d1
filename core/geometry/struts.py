"""Connected components of a surface that belong to one thing, joined by struts.

A mast or a stem, thin in the pictures of a small prior, is the first thing to get lost; what it
carried would fall down in a physics simulation. Not in the paper; ours.
"""

import numpy as np
import torch
from jaxtyping import Float
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.mesh import component_labels, face_areas, signed_volume
from core.geometry.sdf_net import Surface, surface
from core.geometry.tet_grid import TetGrid

STRUT_CELLS = 1.5  # radius of a strut, cells of the lattice
MOST_STRUTS = 8  # rubble of more components than these join is left in components
# A gap is even where it is no more than so much wider than at its narrowest, times and training
# units, and long from so many training units and widths on.
EVEN, SLACK, LONG, LONGER = 1.2, 0.02, 0.5, 8.0
ASKED = 500  # vertices that show how far off the others may be
POSTS = (0.12, 0.88)  # of its length, where the two struts are
OFFSET_WEIGHT = (
    0.25  # of the distance to the line of the centroids, what counts as length of a strut
)


Strut = tuple[Float[np.ndarray, " 3"], Float[np.ndarray, " 3"]]  # its ends


def joined_by_struts(drawn: Surface, grid: TetGrid, keep_ratio: float) -> Surface:
    """``drawn`` with struts from each component to the rest of it, the smallest component first.

    A strut is a capsule: the lattice's values become the smaller of their own and its distance.
    Components below ``keep_ratio`` of the largest one's area, and walls of voids, are left alone. A
    surface in one component comes back as it is.
    """
    for _ in range(MOST_STRUTS):
        components = _components(drawn, keep_ratio)
        if len(components) < 2:
            break
        sdf = drawn.sdf
        for ends in struts(components[0], np.concatenate(components[1:])):
            ends = torch.from_numpy(np.stack(ends)).to(drawn.positions)
            sdf = torch.minimum(sdf, capsule(drawn.positions, ends, STRUT_CELLS * grid.cell))
        drawn = surface(sdf, drawn.positions, grid)
    return drawn


def struts(component: Float[np.ndarray, "m 3"], rest: Float[np.ndarray, "n 3"]) -> list[Strut]:
    """The best struts between two clouds of vertices, a pair where the gap between them is long and
    even, as between a seat and its back.

    Else the shortest; where many are about as short, as between a sail and its deck, the one next
    to the line between the centroids.
    """
    start, along = component.mean(0), rest.mean(0) - component.mean(0)
    along = along / max(float(np.linalg.norm(along)), 1e-9)
    tree, within = KDTree(rest), np.inf
    # For each vertex of the component its shortest strut; what some of them show to be too far off
    # is not looked at.
    for some in (component[:: -(-len(component) // ASKED)], component):
        distance, nearest = map(np.asarray, tree.query(some, distance_upper_bound=within))
        component = some[near := np.isfinite(distance)]
        distance, nearest = distance[near], nearest[near]
        middle = (component + rest[nearest]) / 2
        offset = np.linalg.norm(np.cross(middle - start, along), axis=1)
        length = distance + OFFSET_WEIGHT * offset
        gap = float(distance.min())
        within = 1.001 * max(EVEN * gap + SLACK, float(length.min()))
    best = [int(length.argmin())]
    even = np.flatnonzero(distance <= EVEN * gap + SLACK)
    center = component[even].mean(0)
    place = (component[even] - center) @ np.linalg.svd(
        component[even] - center, full_matrices=False
    )[2][0]
    low, high = float(place.min()), float(place.max())
    if high - low > max(LONG, LONGER * gap):
        ends = (np.abs(place - (low + fraction * (high - low))) for fraction in POSTS)
        best = [int(even[end.argmin()]) for end in ends]
    return [(component[one], rest[nearest[one]]) for one in best]


def capsule(
    points: Float[Tensor, "n 3"], ends: Float[Tensor, "2 3"], radius: float
) -> Float[Tensor, " n"]:
    """Distance to a segment's surroundings, negative within ``radius`` of it."""
    way = ends[1] - ends[0]
    # Both ends in one point are a ball, not 0 / 0.
    fraction = ((points - ends[0]) @ way / way.square().sum().clamp_min(1e-12)).clamp(0, 1)
    return (points - ends[0] - fraction[:, None] * way).norm(dim=1) - radius


def _components(drawn: Surface, keep_ratio: float) -> list[Float[np.ndarray, "v 3"]]:
    """Vertices of the solid components, the smallest area first."""
    verts, faces = drawn.verts.detach(), drawn.faces
    count, of_face = component_labels(faces, len(verts))
    found = []
    for k in range(count):
        own = faces[torch.from_numpy(of_face == k).to(faces.device)]
        area = float(face_areas(verts, own).sum())
        if signed_volume(verts, own) > 0:
            found.append((area, verts[own.unique()].cpu().numpy()))
    found.sort(key=lambda component: component[0])
    return [points for area, points in found if area >= keep_ratio * found[-1][0]]
