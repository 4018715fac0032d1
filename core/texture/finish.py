"""The last hand on each texel: the fine surface's normals, and the materials' detail."""

from dataclasses import replace

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.shade import perturb
from core.appearance.shaded import UvMesh
from core.guidance.guidance import Areas, Surface
from core.ops import dot, normalize
from core.texture.bake import MaterialAt
from core.texture.detail.detail import Coat, Detail, Spots, lit, renamed
from core.texture.detail.grain import convexity, lengths
from core.texture.detail.noise import Noise
from core.texture.detail.parts import ByArea, ByColor
from core.texture.detail.survey import spread
from core.texture.fine_surface import FineSurface, turned
from core.texture.texels import footprint

CHUNK = 1 << 17  # texels at once
STEP = 0.5  # texels, over which the slope of raised areas is measured
SURVEYED = 1 << 14  # points of the surface, for the parts' colours and their means
LEAST_Z = 0.05  # of a normal in tangent space: none points into the surface


class Finish:
    """The last change of a texel's material, from the surface's attributes there.

    Some of the ``areas`` may be raised above the surface.
    """

    def __init__(
        self,
        mesh: UvMesh,
        fine: FineSurface | None = None,
        detail: Detail | None = None,
        areas: Areas | None = None,
    ) -> None:
        self.fine, self.detail, self.areas = fine, detail, areas
        self.lights = bool(detail and detail.lights)
        self.scale = 1 / float((mesh.verts.amax(0) - mesh.verts.amin(0)).max())
        # By corner: the point, the normal, the tangent with its sign, the parts' lengths and edges.
        grain = detail.grain if detail else None
        grain = mesh.verts.new_zeros(len(mesh.verts), 4) if grain is None else grain
        corners = (mesh.verts[mesh.faces], mesh.normals, mesh.tangents, grain[mesh.faces])
        self.attributes = torch.cat(corners, -1)

    def __call__(
        self,
        attributes: Float[Tensor, "t 14"],
        values: Float[Tensor, "t 8"],
        area: Int[Tensor, " t"] | None = None,
    ) -> Float[Tensor, "t w"]:
        """``values``: kd, roughness, metallic and kn, the means of each texel; then emission and
        transmission too, where some of the detail ``lights``. ``area``: the areas that
        the detail distinguishes."""
        texels = attributes.split(CHUNK)
        known = [None] * len(texels) if area is None else area.split(CHUNK)
        parts = zip(texels, values.split(CHUNK), known, strict=True)
        return torch.cat([self._finished(*part) for part in parts])

    def _finished(
        self,
        attributes: Float[Tensor, "t 14"],
        values: Float[Tensor, "t 8"],
        area: Int[Tensor, " t"] | None,
    ) -> Float[Tensor, "t w"]:
        point, normal, tangent, length, edge = attributes.split([3, 3, 4, 3, 1], 1)
        coat = Coat(*values[:, :5].split([3, 1, 1], 1))
        # What was learnt, in the object's frame, on the coarse surface.
        shape = normalize(normal)
        bumpy = perturb(normal, tangent, values[:, 5:])
        if self.fine:
            fine = self.fine.normals(point, shape)
            shape, bumpy = fine, turned(bumpy, shape, fine)
        if self.detail:
            coat, slope = self.detail(Spots(point * self.scale, shape, length, edge, area), coat)
            if self.areas and area is not None:
                step = STEP * self.detail.noise.footprint / self.scale
                rise = self.areas.slope(point, shape, area, step)
                slope = slope + self.detail.strength * rise
            # The relief's gradient across the normal that is there already.
            bumpy = normalize(bumpy - (slope - dot(slope, bumpy) * bumpy))
        learnt, light = coat[:3], coat[3:] if self.lights else ()
        return torch.cat([*learnt, in_tangent_space(bumpy, normal, tangent), *light], 1)


def detail_of(
    mesh: UvMesh,
    material: MaterialAt,
    surfaces: tuple[Surface, ...],
    areas: Areas | None = None,
    *,
    strength: float,
    size: int,
    seed: int,
) -> Detail | None:
    """The detail of the ``areas``, or where they are not known of ``surfaces``, on ``mesh``, whose
    learnt material is ``material``; None where there is none to make."""
    each = tuple(one.surface for one in areas.each) if areas else surfaces
    if not surfaces or (strength == 0 and not (lit(each) or renamed(each))):
        return None
    finish = Finish(mesh)
    face, bary = spread(mesh.verts, mesh.faces, SURVEYED)
    at = torch.einsum("nk,nkc->nc", bary, finish.attributes[face])
    area = areas.of(at[:, :3]) if areas else None
    learnt = material(at[:, :3], *([] if area is None else [area]))
    own = (mesh.verts, mesh.faces)
    grain = torch.cat([lengths(*own), convexity(*own)], 1)
    long, edge = torch.einsum("nk,nkc->nc", bary, grain[mesh.faces[face]]).split([3, 1], 1)
    spots = Spots(at[:, :3] * finish.scale, normalize(at[:, 3:6]), long, edge, area)
    noise = Noise(seed, footprint(mesh.mesh, size) * finish.scale)
    coat = Coat(learnt.kd, learnt.roughness, learnt.metallic)
    parts = ByArea(each) if areas else ByColor.of(surfaces, coat.kd)
    return replace(Detail.of(parts, noise, strength, spots, coat), grain=grain)


def in_tangent_space(
    world: Float[Tensor, "t 3"], normal: Float[Tensor, "t 3"], tangent: Float[Tensor, "t 4"]
) -> Float[Tensor, "t 3"]:
    """The inverse of :func:`core.appearance.shade.perturb`, up to what would point inside."""
    t = tangent[:, :3]
    b = tangent[:, 3:].sign() * torch.linalg.cross(normal, t)
    # Cramer's rule for x t + y b + z n = world, up to a length.
    volume = dot(t, torch.linalg.cross(b, normal))
    x = dot(world, torch.linalg.cross(b, normal))
    y = dot(world, torch.linalg.cross(normal, t))
    z = dot(world, torch.linalg.cross(t, b))
    kn = torch.cat([x, y, z], 1) * volume.sign()
    kn = kn / kn.norm(dim=1, keepdim=True).clamp(min=1e-20)
    kn = normalize(torch.cat([kn[:, :2], kn[:, 2:].clamp(min=LEAST_Z)], 1))
    # Where the tangents cancel there is no frame: flat.
    return torch.where(volume.abs() > 1e-12, kn, torch.tensor([0.0, 0.0, 1.0]).to(kn))
