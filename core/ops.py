"""Small vector and colour formulas that several modules share."""

from collections.abc import Callable
from functools import cache
from typing import TypeVar

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor
from torch.utils.checkpoint import checkpoint

from core import kernels

Result = TypeVar("Result")


def recomputed(function: Callable[..., Result], *given: object) -> Result:
    """``function`` of ``given``, whose backward computes it again instead of keeping what it made.

    Nothing in it may be drawn at random.
    """
    if not torch.is_grad_enabled():
        return function(*given)
    return checkpoint(function, *given, use_reentrant=False, preserve_rng_state=False)


def places(*masks: Bool[Tensor, " _n"]) -> list[Int[Tensor, " _m"]]:
    """Where each mask is true, ascending; a GPU is waited for once for all of them."""
    if masks[0].device.type == "cpu":  # nothing to wait for, and counting takes time
        return [mask.nonzero().squeeze(1) for mask in masks]
    counts = torch.stack([mask.sum() for mask in masks]).tolist()
    pairs = zip(masks, counts, strict=True)
    return [mask.nonzero_static(size=count).squeeze(1) for mask, count in pairs]


@cache
def constant(values: tuple, device: torch.device, dtype: torch.dtype | None = None) -> Tensor:
    """The tensor of ``values``, which is sent to a GPU once: each sending waits for it."""
    return torch.tensor(values, device=device, dtype=dtype)


def dot(x: Float[Tensor, "*b c"], y: Float[Tensor, "*b c"]) -> Float[Tensor, "*b 1"]:
    """Inner product over the last axis, which is kept."""
    return (x * y).sum(-1, keepdim=True)


def normalize(x: Float[Tensor, "*b c"], eps: float = 1e-12) -> Float[Tensor, "*b c"]:
    """``x`` at unit length; ``eps`` bounds the squared length, so that a zero stays zero."""
    if kernels.supports(x):
        return kernels.Normalize.apply(x, eps)
    return x * torch.rsqrt(dot(x, x).clamp(min=eps))


def across(normal: Float[Tensor, "n 3"]) -> tuple[Tensor, Tensor]:
    """Two unit vectors across each normal and across each other.

    T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017.
    """
    x, y, z = normal.unbind(1)
    sign = torch.where(z < 0, -1.0, 1.0)
    a = -1 / (sign + z)
    b = x * y * a
    one = torch.stack([1 + sign * x * x * a, sign * b, -sign * x], 1)
    return one, torch.stack([b, sign + y * y * a, -y], 1)


def linear_to_srgb(x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """IEC 61966-2-1 transfer function, for values in [0, 1]; above 1 it goes on, below 0 linear."""
    curved = 1.055 * x.clamp(min=0.0031308) ** (1 / 2.4) - 0.055
    return torch.where(x <= 0.0031308, 12.92 * x, curved)


def srgb_to_linear(x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """Inverse of :func:`linear_to_srgb`."""
    curved = ((x.clamp(min=0.04045) + 0.055) / 1.055) ** 2.4
    return torch.where(x <= 0.04045, x / 12.92, curved)


def lab(linear: Float[Tensor, "*b 3"]) -> Float[Tensor, "*b 3"]:
    """CIE L*a*b* of linear Rec. 709, under D65."""
    to_xyz = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    xyz = linear @ linear.new_tensor(to_xyz).T / linear.new_tensor([0.9505, 1.0, 1.089])
    f = torch.where(xyz > 0.008856, xyz.clamp_min(0.008856) ** (1 / 3), 7.787 * xyz + 16 / 116)
    x, y, z = f.unbind(-1)
    return torch.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], -1)
