"""The union of closed meshes as one closed mesh; the only file that imports manifold3d.

Its result is a manifold however the meshes lie to each other (Smith, "Towards robust inexact
geometric computation", 2009).
"""

from collections.abc import Sequence

import manifold3d
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.struts import MOST_STRUTS
from core.geometry.struts import strut as best_strut

ROUND = 16  # segments of a strut's ends


def union(
    meshes: Sequence[tuple[Tensor, Tensor]], strut: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """All of ``meshes`` (vertices, faces), closed and facing outwards, as one; what does not touch
    is joined.

    Args:
        strut: radius of the capsules between pieces that do not touch; 0 leaves them apart.
    """
    whole = manifold3d.Manifold.batch_boolean([_solid(*m) for m in meshes], manifold3d.OpType.Add)
    for _ in range(MOST_STRUTS if strut else 0):
        pieces = sorted(whole.decompose(), key=lambda piece: piece.volume())
        if len(pieces) < 2:
            break
        ends = best_strut(_verts(pieces[0]), np.concatenate([*map(_verts, pieces[1:])]))
        whole = whole + _capsule(*ends, strut)
    made = whole.to_mesh()
    verts, faces = made.vert_properties[:, :3], made.tri_verts.astype(np.int64)
    first, _ = meshes[0]
    return torch.from_numpy(np.array(verts)).to(first), torch.from_numpy(faces).to(first.device)


def box(
    low: Float[np.ndarray, " 3"], high: Float[np.ndarray, " 3"], edge: float
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """A box between two corners, its edges no longer than ``edge``."""
    whole = manifold3d.Manifold.cube([float(side) for side in high - low])
    made = whole.translate([float(at) for at in low]).refine_to_length(edge).to_mesh()
    faces = torch.from_numpy(made.tri_verts.astype(np.int64))
    return torch.from_numpy(np.array(made.vert_properties[:, :3])), faces


def is_solid(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> bool:
    """Whether a mesh can be united with others: closed, manifold and oriented."""
    return not _solid(verts, faces).is_empty()


def _solid(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> manifold3d.Manifold:
    """As manifold3d has it; nothing, where it is no closed mesh."""
    places, corners = verts.detach().cpu().numpy(), faces.cpu().numpy()
    mesh = manifold3d.Mesh(places.astype(np.float32), corners.astype(np.uint32))
    return manifold3d.Manifold(mesh)


def _verts(solid: manifold3d.Manifold) -> Float[np.ndarray, "v 3"]:
    return np.asarray(solid.to_mesh().vert_properties, np.float64)[:, :3]


def _capsule(
    start: Float[np.ndarray, " 3"], end: Float[np.ndarray, " 3"], radius: float
) -> manifold3d.Manifold:
    """All points within ``radius`` of a segment."""
    ball = manifold3d.Manifold.sphere(radius, ROUND)
    ends = [ball.translate([float(x) for x in at]) for at in (start, end)]
    return manifold3d.Manifold.batch_hull(ends)
