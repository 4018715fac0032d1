"""Γ, the spatially varying material (Eq. 6).

    (k_d, k_rm, k_n) = Γ(β(p); γ)

β is a hash grid of the point p, Γ a two-layer MLP with 32 hidden units ("Implementation Details").
"""

from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor


class Material(NamedTuple):
    """What the surface is made of at N points."""

    kd: Float[Tensor, "n 3"]  # base colour, linear Rec.709
    roughness: Float[Tensor, "n 1"]
    metallic: Float[Tensor, "n 1"]
    kn: Float[Tensor, "n 3"]  # unit normal in tangent space, (0, 0, 1) is flat


def specular_color(material: Material) -> Float[Tensor, "n 3"]:
    """k_s = (1 - m) 0.04 + m k_d, the paper's specular term (§4.3)."""
    return torch.lerp(torch.full_like(material.kd, 0.04), material.kd, material.metallic)
