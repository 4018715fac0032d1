"""How well a uv map serves its surface: what it fills of the square, and how it stretches."""

import math

import torch
from jaxtyping import Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from torch import Tensor

from core.geometry.mesh import Mesh


def uv_health(mesh: Mesh) -> dict[str, float | int]:
    """A UV map's report for asset.json, in plain Python numbers.

    uv_fill (the islands' area in the unit square), uv_islands,
    uv_stretch (the L² stretch of Sander et al., "Texture Mapping Progressive Meshes", 2001, §3:
    root mean square over the surface of how far a texel reaches, against even texels without
    shear; 1 is the best), uv_flat (faces with an area on the surface and none in the map; they are
    left out of the stretch).
    """
    uv, face_uvs = mesh.atlas
    p, t = mesh.verts[mesh.faces].double().cpu(), uv[face_uvs].double().cpu()
    corner, texel = p[:, 1:] - p[:, :1], t[:, 1:] - t[:, :1]
    on_surface = torch.linalg.cross(corner[:, 0], corner[:, 1]).norm(dim=1) / 2
    in_map = torch.linalg.det(texel).abs() / 2
    flat = (in_map <= 1e-14) & (on_surface > 0)
    sound = in_map > 1e-14
    # J maps the plane of uv to the surface: its columns are where a step in u and in v leads.
    jacobian = torch.linalg.solve(texel[sound], corner[sound]).transpose(1, 2)
    squared = jacobian.square().sum((1, 2)) / 2  # (Γ² + γ²) / 2, of its singular values
    area = on_surface[sound]
    # Times the map's area: with it the stretch does not depend on the map's scale.
    total = float((squared * area).sum() * in_map.sum())
    whole = float(area.sum())
    return {
        "uv_fill": round(float(in_map.sum()), 4),
        "uv_islands": island_count(face_uvs, len(uv)),
        "uv_stretch": round(math.sqrt(total) / whole, 4) if whole else 0.0,
        "uv_flat": int(flat.sum()),
    }


def island_count(face_uvs: Int[Tensor, "f 3"], uv_count: int) -> int:
    """Components of the map that hang together by a common uv index; unused indices are none."""
    start, end = face_uvs.cpu().reshape(-1).numpy(), face_uvs.roll(1, 1).cpu().reshape(-1).numpy()
    graph = coo_array((start * 0 + 1, (start, end)), shape=(uv_count, uv_count))
    labels = connected_components(graph, directed=False)[1]
    return len(set(labels[start].tolist()))
