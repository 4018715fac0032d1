"""Small vector and colour formulas that several modules share."""

import torch
from jaxtyping import Float
from torch import Tensor

from core import kernels


def dot(x: Float[Tensor, "*b c"], y: Float[Tensor, "*b c"]) -> Float[Tensor, "*b 1"]:
    """Inner product over the last axis, which is kept."""
    return (x * y).sum(-1, keepdim=True)


def normalize(x: Float[Tensor, "*b c"], eps: float = 1e-12) -> Float[Tensor, "*b c"]:
    """``x`` at unit length; ``eps`` bounds the squared length, so that a zero stays zero."""
    if kernels.fit(x):
        return kernels.Normalize.apply(x, eps)
    return x * torch.rsqrt(dot(x, x).clamp(min=eps))


def linear_to_srgb(x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """IEC 61966-2-1 transfer function, for values in [0, 1]; above 1 it goes on, below 0 linear."""
    curved = 1.055 * x.clamp(min=0.0031308) ** (1 / 2.4) - 0.055
    return torch.where(x <= 0.0031308, 12.92 * x, curved)


def srgb_to_linear(x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """Inverse of :func:`linear_to_srgb`."""
    curved = ((x.clamp(min=0.04045) + 0.055) / 1.055) ** 2.4
    return torch.where(x <= 0.04045, x / 12.92, curved)
