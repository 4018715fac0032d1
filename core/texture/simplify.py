"""Fewer faces before the unwrap: edge collapse by quadric error.

Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997, as libigl has it.
Every collapse is tested to leave a manifold, so a closed mesh stays closed, with the genus and
the pieces that it had, and collapses that would push the surface through itself are refused.
"""

import igl
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError


def simplify(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], max_faces: int
) -> tuple[Float[Tensor, "v2 3"], Int[Tensor, "f2 3"]]:
    """The same surface with ``max_faces`` faces or fewer; within the budget it is left untouched.

    More faces than asked for come back only where no edge is left that may collapse: a closed
    piece keeps at least 4 faces.

    Raises UserError for a mesh where three faces share an edge: it has no collapse that is safe.
    """
    if len(faces) <= max_faces:
        return verts, faces
    used, compact = np.unique(faces.cpu().numpy(), return_inverse=True)
    points = verts.detach().cpu().double().numpy()[used]
    collapsed = igl.qslim(points, compact.reshape(-1, 3), max_m=max_faces, block_intersections=True)
    new_verts, new_faces = (np.ascontiguousarray(part) for part in collapsed[:2])
    if not len(new_faces):
        raise UserError(
            f"The mesh has {len(faces):,} faces and cannot be brought to {max_faces:,}: "
            "somewhere three faces share an edge.",
            "Repair it (Blender: Select > All by Trait > Non Manifold), or raise --max-faces.",
        )
    return torch.from_numpy(new_verts).to(verts), torch.from_numpy(new_faces).to(faces)
