"""Pictures of a mesh with a material under a light: x = {L(p, ω)} of §4.3."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import Material
from core.appearance.shade import CHUNK, lifted, perturb, shade
from core.camera import Cameras
from core.geometry.faces import outward
from core.geometry.mesh import Mesh
from core.geometry.tangents import corner_tangents, shading_normals
from core.ops import dot, linear_to_srgb, normalize, recomputed
from core.render.antialias import EdgeTable, antialias, edge_table
from core.render.rasterizer import Fragments, interpolate, rasterize, scatter

# The material at P points of the surface, known by position (P,3) and uv (P,2).
MaterialSource = Callable[[Tensor, Tensor], Material]
# The light that leaves P points by themselves (P,3), linear, by their uv.
EmissionSource = Callable[[Tensor], Tensor]


@dataclass(frozen=True, eq=False)
class UvMesh:
    """A mesh with everything that its shading needs; made once, its shape is final."""

    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    uv: Float[Tensor, "u 2"]
    face_uvs: Int[Tensor, "f 3"]
    normals: Float[Tensor, "f 3 3"]  # by corner
    tangents: Float[Tensor, "f 3 4"]  # MikkTSpace, by corner
    edges: EdgeTable
    closed: bool  # and facing outward: nothing of its inside can be seen
    flat: bool = False  # see Mesh

    @classmethod
    def of(cls, mesh: Mesh) -> "UvMesh":
        """Derive normals, tangents and edges."""
        normals = shading_normals(mesh).corners
        edges = edge_table(mesh.faces)
        tangents = corner_tangents(mesh, normals)
        # Back faces need no drawing then. An inside-out mesh would show its far side without them.
        closed = outward(mesh.verts.detach().cpu().double().numpy(), mesh.faces.cpu().numpy())
        derived = (normals, tangents, edges, closed)
        return cls(mesh.verts, mesh.faces, *mesh.atlas, *derived, mesh.flat)

    @property
    def mesh(self) -> Mesh:
        """The mesh alone."""
        return Mesh(self.verts, self.faces, self.uv, self.face_uvs, flat=self.flat)

    def to(self, device: "torch.device | str") -> "UvMesh":
        """The same mesh on ``device``."""
        parts = (self.verts, self.faces, self.uv, self.face_uvs)
        return UvMesh.of(Mesh(*(x.to(device) for x in parts), flat=self.flat))


class Shaded(NamedTuple):
    """The result of :func:`render_shaded`."""

    srgb: Float[Tensor, "b h w 3"]  # over black, weighted by coverage
    o: Float[Tensor, "b h w 1"]  # coverage
    n: Float[Tensor, "b h w 3"]  # the shape's own normals, object frame, weighted by coverage
    p: Float[Tensor, "b h w 3"]  # what is seen, training units, weighted by coverage
    points: Float[Tensor, "p 3"]  # of the covered pixels
    material: Material  # there
    view: Int[Tensor, " p"]  # the picture each is in, in order


class SurfacePoints(NamedTuple):
    """The surface at the covered pixels."""

    points: Float[Tensor, "p 3"]
    uv: Float[Tensor, "p 2"]
    normal: Float[Tensor, "p 3"]  # as interpolated, on the face's front
    tangent: Float[Tensor, "p 4"]
    to_eye: Float[Tensor, "p 3"]  # unit
    side: Float[Tensor, "p 1"]  # 1 where the face is seen from the front, -1 from behind
    front: Float[Tensor, "p 3"]  # the face's own unit normal, on its front

    def shading_normal(self, kn: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """``kn`` in the world, towards the eye's side: perturbed on the front, then turned round.

        In this order, as Cycles does: a bump in front is a dent behind.
        """
        normal = self.side * perturb(self.normal, self.tangent, kn)
        return lifted(normal, self.to_eye, self.side * self.front)


def surface_at(mesh: UvMesh, fragments: Fragments, cameras: Cameras) -> SurfacePoints:
    """Interpolate the mesh's attributes at the covered pixels."""
    points = interpolate(mesh.verts, fragments)
    normal = interpolate(mesh.normals, fragments)
    uv = interpolate(mesh.uv[mesh.face_uvs], fragments)
    tangent = interpolate(mesh.tangents, fragments)
    to_eye = normalize(cameras.eye[fragments.view] - points)
    a, b, c = mesh.verts[fragments.corners].unbind(1)
    # The squared length is that of twice the face's area: on fine meshes below the usual bound.
    front = normalize(torch.linalg.cross(b - a, c - a), 1e-30)
    side = torch.ones_like(to_eye[:, :1])
    # Of a closed mesh that faces outward every pixel sees a front: its back faces are culled.
    if not mesh.closed:
        side = torch.where(dot(front, to_eye) < 0, -side, side)
    return SurfacePoints(points, uv, normal, tangent, to_eye, side, front)


def render_shaded(
    mesh: UvMesh,
    source: MaterialSource,
    cameras: Cameras,
    size: int,
    environment: Environment,
    occlusion: Float[Tensor, "v s"] | None = None,
    emission: EmissionSource | None = None,
) -> Shaded:
    """Render the mesh (Eqs. 7, 8), antialiased; gradients flow into the material.

    All of it is opaque. ``occlusion``: what it hides from itself, by vertex
    (:meth:`VertexVisibility.occlusion`); ``emission``: of what glows.
    """
    fragments = rasterize(mesh.verts, mesh.faces, cameras.mvp, size, size, cull=mesh.closed)
    surface = surface_at(mesh, fragments, cameras)
    material = material_at(source, surface)
    normal = surface.shading_normal(material.kn)
    color = shade(
        normal,
        surface.to_eye,
        *material[:3],
        environment,
        None if occlusion is None else interpolate(occlusion, fragments),
    )
    if emission:
        color = color + emission(surface.uv)
    srgb = linear_to_srgb(saturate(color))
    # One buffer of ten channels: a single pass of antialiasing for all of them.
    smooth = surface.side * normalize(surface.normal)
    values = torch.cat([srgb, smooth, surface.points, torch.ones_like(srgb[:, :1])], -1)
    picture = antialias(scatter(values, fragments), fragments, mesh.faces, mesh.edges)
    srgb, n, p, o = picture.split([3, 3, 3, 1], -1)
    return Shaded(srgb, o, n, p, surface.points, material, fragments.view)


def material_at(source: MaterialSource, surface: SurfacePoints) -> Material:
    """The material at the covered pixels; where they are many, the backward computes it again.

    A hash grid keeps 1.5 kB of indices and weights for each point.
    """
    if len(surface.points) <= CHUNK:
        return source(surface.points, surface.uv)
    both = zip(surface.points.split(CHUNK), surface.uv.split(CHUNK), strict=True)
    parts = [recomputed(source, points, uv) for points, uv in both]
    return Material(*(torch.cat(part) for part in zip(*parts, strict=True)))


def saturate(x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """``x`` cut to [0, 1], as a screen does; the gradient passes, so that glare can be reduced."""
    return x + (x.clamp(0, 1) - x).detach()
