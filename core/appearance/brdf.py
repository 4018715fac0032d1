"""The reflectance: D, G and F of Eq. 8, and their integrals over the hemisphere.

GGX with height-correlated Smith shadowing, alpha = roughness^2 ("Microfacet Models for Refraction",
Walter et al. 2007; "Understanding the Masking-Shadowing Function", Heitz 2014), as in Blender's
Principled BSDF with the distribution GGX. Metal: Schlick's Fresnel with F0 = k_d. Dielectric: the
exact Fresnel term at an index of 1.5, whose F0 is the paper's 0.04.

``alpha`` is the width of the distribution here; in ``core/guidance`` the same letter is a noise
schedule.
"""

import math
from functools import cache
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor
from torch.nn.functional import grid_sample

# F0 = ((1.5 - 1) / (1.5 + 1))² = 0.04, the paper's k_s of a dielectric.
IOR = 1.5
# Keeps D's peak, 1 / (π alpha²), finite at roughness 0: here 3e7.
MIN_ALPHA = 1e-4


def ggx_d(cos_h: Float[Tensor, "*#b"], alpha: Float[Tensor, "*#b"]) -> Float[Tensor, "*#b"]:
    """D, the density of microfacet normals at the angle acos(``cos_h``) (Walter 2007, Eq. 33)."""
    # sin^2 + alpha^2 cos^2, written so that nothing cancels at small angles.
    spread = (1 - cos_h) * (1 + cos_h) + (alpha * cos_h).square()
    return (alpha / spread).square() / math.pi


def smith_lambda(cos: Float[Tensor, "*#b"], alpha: Float[Tensor, "*#b"]) -> Float[Tensor, "*#b"]:
    """Λ of the Smith shadowing function (Heitz 2014, Eq. 72)."""
    # At the horizon tan² is infinite, and its gradient not a number.
    squared = cos.square().clamp(min=1e-12)
    return (torch.sqrt(1 + alpha.square() * (1 - squared).clamp(min=0) / squared) - 1) / 2


def smith_g2(
    cos_v: Float[Tensor, "*#b"], cos_l: Float[Tensor, "*#b"], alpha: Float[Tensor, "*#b"]
) -> Float[Tensor, "*#b"]:
    """G, height-correlated: 1 / (1 + Λ(v) + Λ(l)) (Heitz 2014, Eq. 99)."""
    return 1 / (1 + smith_lambda(cos_v, alpha) + smith_lambda(cos_l, alpha))


def schlick_weight(cos: Float[Tensor, "*#b"]) -> Float[Tensor, "*#b"]:
    """(1 - cos)^5: Schlick's F is F0 + (1 - F0) times this ("An Inexpensive BRDF Model", 1994)."""
    return (1 - cos).clamp(0, 1) ** 5


def fresnel_dielectric(cos: Float[Tensor, "*#b"], ior: float = IOR) -> Float[Tensor, "*#b"]:
    """Unpolarised reflectance of a smooth dielectric from outside (Walter 2007, Eq. 22)."""
    # Seen from outside there is no total reflection: the root is always real.
    g = torch.sqrt(ior * ior - 1 + cos.square())
    ratio = (cos * (g + cos) - 1) / (cos * (g - cos) + 1)
    return 0.5 * ((g - cos) / (g + cos)).square() * (1 + ratio.square())


def brdf(
    cos_v: Float[Tensor, "*#b"],
    cos_l: Float[Tensor, "*#b"],
    cos_h: Float[Tensor, "*#b"],
    alpha: Float[Tensor, "*#b"],
) -> Float[Tensor, "*#b"]:
    """D G / (4 (ω·n)(ω_i·n)), the specular part of Eq. 8 at F = 1."""
    return ggx_d(cos_h, alpha) * smith_g2(cos_v, cos_l, alpha) / (4 * cos_v * cos_l)


class Albedo(NamedTuple):
    """The fraction of uniform light that the specular part reflects, by roughness and n·v."""

    total: Float[Tensor, "*b 1"]  # F = 1
    schlick: Float[Tensor, "*b 1"]  # F = (1 - cos)^5
    dielectric: Float[Tensor, "*b 1"]  # F of the dielectric


def hammersley(n: int) -> Float[Tensor, "{n} 2"]:
    """The first n points of an evenly spread sequence on the unit square."""
    index = torch.arange(n)
    # The van der Corput sequence: the index's binary digits, mirrored about the point.
    radical, scale, rest = torch.zeros(n), 0.5, index.clone()
    while bool((rest > 0).any()):
        radical += scale * (rest % 2)
        rest, scale = rest // 2, scale / 2
    # Half a spacing off the borders, where the sampled normals degenerate.
    return torch.stack([(index + 0.5) / n, radical + 0.5 / n], 1)


def visible_normals(
    cos_v: Float[Tensor, "*b 1"], alpha: Float[Tensor, "*b 1"], u: Float[Tensor, "n 2"]
) -> Float[Tensor, "*b n 3"]:
    """Microfacet normals as seen from v = (sin, 0, cos), one for each point of the unit square.

    Their density is D G1 (v·h) / cos_v ("Sampling Visible GGX Normals with Spherical Caps", Dupuy
    and Benyoub 2023).
    """
    # STRETCHED: the view, where the microfacets' ellipsoid is the unit hemisphere
    x, z = torch.sqrt((1 - cos_v.square()).clamp(min=0)) * alpha, cos_v
    length = torch.sqrt(x * x + z * z)
    x, z = x / length, z / length
    # SAMPLED: the cap of directions that the hemisphere reflects to this view, uniformly
    phi = 2 * math.pi * u[:, 0]
    cap = (1 - u[:, 1]) * (1 + z) - z
    sine = torch.sqrt((1 - cap * cap).clamp(min=0))
    # UNSTRETCHED: normals go with the inverse transpose; none is on the horizon or below it
    h = torch.stack(
        [(sine * phi.cos() + x) * alpha, sine * phi.sin() * alpha, (cap + z).clamp(min=1e-7)], -1
    )
    return h / h.norm(dim=-1, keepdim=True)


def directional_albedo(
    roughness: Float[Tensor, "*b 1"], cos_v: Float[Tensor, "*b 1"], samples: int = 1024
) -> Albedo:
    """∫ D F G / (4 (ω·n)(ω_i·n)) (ω_i·n) dω_i, by sampling visible normals."""
    alpha = roughness.square().clamp(min=MIN_ALPHA)
    h = visible_normals(cos_v, alpha, hammersley(samples).to(cos_v))
    # The view has no y here, so v·h needs none; of l = 2 (v·h) h - v only the height counts.
    cos_d = torch.sqrt((1 - cos_v.square()).clamp(min=0)) * h[..., 0] + cos_v * h[..., 2]
    cos_l = 2 * cos_d * h[..., 2] - cos_v
    # The density leaves G2 / G1 as the weight.
    weight = (1 + smith_lambda(cos_v, alpha)) * smith_g2(cos_v, cos_l, alpha) * (cos_l > 0)
    cos_d = cos_d.clamp(0, 1)
    return Albedo(
        weight.mean(-1, keepdim=True),
        (weight * schlick_weight(cos_d)).mean(-1, keepdim=True),
        (weight * fresnel_dielectric(cos_d)).mean(-1, keepdim=True),
    )


TABLE_ROUGHNESS, TABLE_COS = 32, 64


@cache
def albedo_table() -> Float[Tensor, "1 3 32 64"]:
    """The albedos over roughness (rows, 0 to 1) and sqrt(n·v) (columns, 0 to 1); about 1 s.

    The root spreads out the grazing angles, where the albedos change fastest.
    """
    roughness = torch.linspace(0, 1, TABLE_ROUGHNESS)[:, None, None].expand(-1, TABLE_COS, 1)
    root = torch.linspace(0, 1, TABLE_COS)[None, :, None].expand(TABLE_ROUGHNESS, -1, 1)
    albedo = directional_albedo(roughness, root.square().clamp(min=1e-4))
    return torch.cat(albedo, -1).permute(2, 0, 1)[None].contiguous()


@cache
def _albedo_table_on(device: torch.device, dtype: torch.dtype) -> Float[Tensor, "1 3 32 64"]:
    return albedo_table().to(device, dtype)  # sent once


def lookup_albedo(roughness: Float[Tensor, "p 1"], cos_v: Float[Tensor, "p 1"]) -> Albedo:
    """:func:`directional_albedo` from the table, bilinear, with gradient to both arguments."""
    table = _albedo_table_on(roughness.device, roughness.dtype)
    # The root has no finite slope at 0.
    root = torch.sqrt(cos_v.clamp(min=1e-4))
    place = torch.cat([root, roughness.clamp(0, 1)], 1) * 2 - 1
    # Corners aligned: the table's first and last entries are those of 0 and 1 themselves.
    found = grid_sample(table, place[None, None], align_corners=True, padding_mode="border")
    return Albedo(*found[0, :, 0].t().split(1, dim=1))
