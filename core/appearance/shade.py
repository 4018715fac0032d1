"""The light that leaves the surface: Eqs. 7 and 8.

    L(p, ω) = L_d(p) + L_s(p, ω)

Where the paper's formulas leave room, this is Blender's Principled BSDF (distribution GGX), so that
the asset looks there as it did in training: the diffuse part gives up what the specular layer over
it reflects, and the dielectric has the exact Fresnel term, not Schlick's.
"""

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.brdf import lookup_albedo
from core.appearance.environment import Environment, Incoming
from core.appearance.occlusion import occluded
from core.ops import dot, normalize, recomputed

# Below this n·v, which smooth normals reach at the rim, the view counts as grazing.
MIN_COS = 1e-3
# Points at a time: it bounds the memory of the lookups, and nothing else depends on it. Where there
# are more, the backward computes each part again: 24 views of 512² would else keep gigabytes.
CHUNK = 1 << 17


def shade(
    normal: Float[Tensor, "p 3"],
    view: Float[Tensor, "p 3"],
    kd: Float[Tensor, "p 3"],
    roughness: Float[Tensor, "p 1"],
    metallic: Float[Tensor, "p 1"],
    environment: Environment,
    occlusion: Float[Tensor, "p s"] | None = None,
) -> Float[Tensor, "p 3"]:
    """Linear radiance towards the eye at P points.

    ``normal`` and ``view`` (from the surface to the eye) are unit vectors in the world; ``kd`` is
    linear. ``occlusion``: what the object hides (:mod:`core.appearance.occlusion`); None: nothing.
    Gradients to everything but the light.
    """
    given = [normal, view, kd, roughness, metallic]
    given += [] if occlusion is None else [occlusion]
    if len(normal) <= CHUNK:
        return shade_chunk(environment, *given)
    parts = zip(*(x.split(CHUNK) for x in given), strict=True)
    return torch.cat([recomputed(shade_chunk, environment, *part) for part in parts])


def shade_chunk(
    environment: Environment,
    normal: Float[Tensor, "p 3"],
    view: Float[Tensor, "p 3"],
    kd: Float[Tensor, "p 3"],
    roughness: Float[Tensor, "p 1"],
    metallic: Float[Tensor, "p 1"],
    occlusion: Float[Tensor, "p s"] | None = None,
) -> Float[Tensor, "p 3"]:
    """:func:`shade` in one component."""
    # LIGHT: of the map and of the lamps, each averaged over the reflectance
    cos_v = dot(normal, view).clamp(MIN_COS, 1)
    albedo = lookup_albedo(roughness, cos_v)
    light = environment.incoming(normal, view, roughness)
    lamp = environment.lamps.reflected(normal, view, cos_v, roughness)
    arriving = light.diffuse + environment.lamps.irradiance(normal)
    # OCCLUSION: the object takes the place of the light that it hides
    if occlusion is not None:
        change, open_ = occluded(occlusion, normal, view, kd, roughness)
        arriving, lamp = arriving * change, lamp * open_
        own = (1 - open_) * kd * arriving  # the object, where the mirror shows it
        light = Incoming(light.diffuse, *(open_ * x + own for x in light[1:]))
    # The paper's ablation: L_d alone, and nothing above it that takes light away.
    if environment.diffuse_only:
        return kd * arriving
    # Eq. 8 with Schlick's F = F0 + (1 - F0)(1 - cos)^5 and F0 = kd.
    base = (albedo.total - albedo.schlick) * light.base + lamp[0]
    metal = kd * base + albedo.schlick * light.schlick + lamp[1]
    coat = albedo.dielectric * light.dielectric + lamp[2]
    # Eq. 7. The light that the dielectric layer reflects does not reach the base below it.
    passed = 1 - albedo.dielectric / albedo.total.clamp(min=1e-3)
    diffuse = kd * passed * arriving
    return metallic * metal + (1 - metallic) * (diffuse + coat)


def perturb(
    normal: Float[Tensor, "p 3"], tangent: Float[Tensor, "p 4"], kn: Float[Tensor, "p 3"]
) -> Float[Tensor, "p 3"]:
    """The shading normal: ``kn`` from tangent space to the space of ``normal`` (MikkTSpace).

    ``normal`` and ``tangent`` as interpolated, not made unit again: the bitangent is
    tangent[3] (n x t), as Blender and the normal map's baker compute it. kn = (0, 0, 1) is flat.
    """
    bitangent = tangent[:, 3:] * torch.linalg.cross(normal, tangent[:, :3])
    x, y, z = kn.split(1, dim=1)
    return normalize(x * tangent[:, :3] + y * bitangent + z * normal)


def lifted(
    normal: Float[Tensor, "p 3"], view: Float[Tensor, "p 3"], front: Float[Tensor, "p 3"]
) -> Float[Tensor, "p 3"]:
    """``normal`` turned towards the face's own, ``front``, until the mirror direction leaves it.

    Without it a normal map mirrors the object's inside. As Blender does it: the least turn
    after which the mirror direction is 0.01 (or 0.9 of the view's height) above the face. All unit.
    """
    height = dot(view, front)
    least = torch.minimum(0.9 * height, torch.full_like(height, 0.01))
    mirrored = 2 * dot(normal, view) * dot(normal, front) - height
    side = normalize(normal - dot(normal, front) * front)
    # With n = x side + z front and z² = t, the mirror direction's height is `least` where
    # a t² - b t + c / 4 = 0.
    across = dot(view, side)
    a = (across.square() + height.square()).clamp(min=1e-12)
    b = a + height * least
    root = (b.square() - a * (least + height).square()).clamp(min=1e-12).sqrt()
    # The bounds keep the roots' gradients finite.
    z2 = ((b + torch.where(across < 0, root, -root)) / (2 * a)).clamp(1e-6, 1 - 1e-6)
    turned = (1 - z2).sqrt() * side + z2.sqrt() * front
    return torch.where(mirrored < least, turned, normal)
