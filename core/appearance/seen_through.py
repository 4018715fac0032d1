"""Pictures of an asset with glass: what is behind it is seen through it, in the glass's colour.

One layer deep and without refraction, for a look while one works; Cycles has all of it.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.shaded import (
    EmissionSource,
    MaterialSource,
    UvMesh,
    render_shaded,
    surface_at,
)
from core.camera import Cameras
from core.ops import dot, linear_to_srgb, normalize
from core.render.antialias import antialias
from core.render.rasterizer import rasterize, scatter

# How clear the surface is at P points, 0 to 1 (P,1), by their uv.
TransmissionSource = Callable[[Tensor], Tensor]

CLEAR = 0.5  # of the least transmission of a face of glass
THROUGH = 0.85  # of the light from behind clear glass: what passes where one looks straight at it
GROUND = 0.9  # sRGB: that of the core's pictures
RIM, STEEP = 0.75, 3  # by how much less at its rim; Schlick's form, less steep than his 5


class Picture(NamedTuple):
    """An asset as it is lit, over nothing."""

    srgb: Float[Tensor, "b h w 3"]  # over black, weighted by coverage
    o: Float[Tensor, "b h w 1"]  # coverage; glass covers what it hides


def render_clear(
    mesh: UvMesh,
    source: MaterialSource,
    transmission: TransmissionSource | None,
    cameras: Cameras,
    size: int,
    environment: Environment,
    emission: EmissionSource | None = None,
) -> Picture:
    """:func:`render_shaded`, with what is behind glass; all is opaque without ``transmission``."""
    given = (cameras, size, environment)
    front = render_shaded(mesh, source, *given, emission=emission)
    if transmission is None:
        return Picture(front.srgb, front.o)
    rest = ~glass_faces(mesh, transmission)
    opaque = replace(mesh.mesh, faces=mesh.faces[rest], face_uvs=mesh.face_uvs[rest])
    seen = _clearness(mesh, source, transmission, cameras, size)
    through, tint = seen.split([1, 3], -1)
    behind = Picture(torch.zeros_like(front.srgb), torch.zeros_like(front.o))
    if len(opaque.faces):
        shaded = render_shaded(UvMesh.of(opaque), source, *given, emission=emission)
        behind = Picture(shaded.srgb, shaded.o)
    # Where nothing is behind it, what all channels let through shows any ground, and what the
    # others let through in addition a light one.
    least = tint.amin(-1, keepdim=True)
    bare = GROUND * (tint - least) * (1 - behind.o)
    mixed = (1 - through) * front.srgb + tint * behind.srgb + bare
    return Picture(mixed, front.o - least * (1 - behind.o))


def glass_faces(mesh: UvMesh, transmission: TransmissionSource) -> Bool[Tensor, " f"]:
    """The faces that are mostly clear."""
    corners = torch.cat([mesh.uv[mesh.face_uvs], mesh.uv[mesh.face_uvs].mean(1, keepdim=True)], 1)
    return transmission(corners.view(-1, 2)).view(len(mesh.faces), -1).mean(1) > CLEAR


def _clearness(
    mesh: UvMesh,
    source: MaterialSource,
    transmission: TransmissionSource,
    cameras: Cameras,
    size: int,
) -> Float[Tensor, "b h w 4"]:
    """How much of what is behind passes at each pixel, and the same times the glass's colour; both
    of sRGB, in which pictures are put over one another."""
    fragments = rasterize(mesh.verts, mesh.faces, cameras.mvp, size, size, cull=mesh.closed)
    surface = surface_at(mesh, fragments, cameras)
    facing = dot(normalize(surface.normal), surface.to_eye).abs()
    passes = THROUGH * (1 - RIM * (1 - facing.clamp(0, 1)) ** STEEP)
    through = passes * transmission(surface.uv)
    tint = linear_to_srgb(source(surface.points, surface.uv).kd)
    values = torch.cat([through, through * tint], -1)
    return antialias(scatter(values, fragments), fragments, mesh.faces, mesh.edges)
