"""The normal map and the mask: (n, o) = g_n(psi, c), Eq. 4."""

from typing import Literal

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import Cameras
from core.ops import constant, dot, normalize
from core.render.antialias import EdgeTable, antialias, edge_table
from core.render.rasterizer import Fragments, Points, interpolate, rasterize, scatter, take


def face_normals(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, "f 3"]:
    """Outward normals, as long as twice the face's area."""
    a, b, c = take(verts, faces).unbind(1)
    return torch.linalg.cross(b - a, c - a)


def vertex_normals(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, "v 3"]:
    """Unit normals: the mean of the faces around a vertex, weighted by area.

    (0, 0, 1), without gradient, where no face has an area.
    """
    # Not at unit length: their lengths are the weights.
    around = face_normals(verts, faces)[:, None].expand(-1, 3, -1).reshape(-1, 3)
    total = torch.zeros_like(verts).index_add(0, faces.reshape(-1), around)
    # Far below any real area, so that fine meshes keep unit normals; above it all is finite.
    sound = dot(total, total) > 1e-24
    up = constant((0.0, 0.0, 1.0), total.device, total.dtype)
    return normalize(torch.where(sound, total, up), eps=1e-30)


def render_normals(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    cameras: Cameras,
    size: int,
    frame: Literal["object", "camera"] = "object",
    edges: EdgeTable | None = None,
    cull: bool = True,
) -> tuple[Float[Tensor, "b {size} {size} 3"], Float[Tensor, "b {size} {size} 1"]]:
    """Square pictures of the smooth normal n and the coverage o, both antialiased (Eq. 4).

    n is multiplied by o, so the background is 0. ``frame`` is the normals' axes: the world's (which
    are the object's), or the camera's (x right, y up, z towards the camera). ``edges`` saves
    making the table when the same faces are drawn again. ``cull=False`` for open surfaces.
    """
    smooth = vertex_normals(verts, faces)

    def values(points: Fragments | Points) -> Float[Tensor, "p 4"]:
        normal = normalize(interpolate(smooth, points))
        # The coverage is a fourth channel: one antialias makes both.
        return torch.cat([normal, torch.ones_like(normal[:, :1])], 1)

    fragments = rasterize(verts, faces, cameras.mvp, size, size, cull)
    edges = edge_table(faces) if edges is None else edges
    image = scatter(values(fragments), fragments)
    image = antialias(image, fragments, faces, edges, rim=values)
    n, o = image[..., :3], image[..., 3:]
    if frame == "camera":
        n = torch.einsum("bij,bhwj->bhwi", cameras.rotation.to(n.dtype), n)
    return n, o
