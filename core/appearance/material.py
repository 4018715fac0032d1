"""Γ, the spatially varying material (Eq. 6).

    (k_d, k_rm, k_n) = Γ(β(p); γ)

β is a hash grid of the point p, Γ a two-layer MLP with 32 hidden units ("Implementation Details").
"""

import itertools
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from core.appearance.material_ranges import LocalRanges, RangesHere
from core.config import AppearanceConfig
from core.hash_grid import HashGrid
from core.ops import constant, linear_to_srgb, normalize, srgb_to_linear


class Material(NamedTuple):
    """The material at N points."""

    kd: Float[Tensor, "n 3"]  # base colour, linear Rec.709
    roughness: Float[Tensor, "n 1"]
    metallic: Float[Tensor, "n 1"]
    kn: Float[Tensor, "n 3"]  # unit normal in tangent space, (0, 0, 1) is flat


def specular_color(material: Material) -> Float[Tensor, "n 3"]:
    """k_s = (1 - m) 0.04 + m k_d, the paper's specular term (§4.3)."""
    return torch.lerp(torch.full_like(material.kd, 0.04), material.kd, material.metallic)


class MaterialNet(nn.Module):
    """Γ over its hash grid β: points to :class:`Material`, by sigmoids to the config's ranges, or
    to those of each place.

    The released code's ninth output is not used by its shading and is left out.
    """

    start: Tensor

    def __init__(
        self,
        config: AppearanceConfig,
        generator: torch.Generator,
        local: LocalRanges | None = None,
    ) -> None:
        super().__init__()
        self.config, self.local = config, local
        self.encoding = HashGrid(
            log2_size=config.log2_hash_size, finest=config.finest, generator=generator
        )
        # Eight outputs: kd, roughness, metallic, and kn's x, y and z.
        widths = [self.encoding.width] + [config.hidden] * (config.layers - 1) + [8]
        self.layers = nn.ModuleList(
            nn.Linear(i, o, bias=False) for i, o in itertools.pairwise(widths)
        )
        for layer in self.layers:
            nn.init.kaiming_uniform_(layer.weight, nonlinearity="relu", generator=generator)
        # The grid's features start within 1e-4 and no layer has a bias, so the output starts near 0
        # and these values are the first material.
        start = torch.full((8,), 0.5)
        start[4] = config.metallic_start
        # Of the config and not learnt: not in the checkpoints.
        self.register_buffer("start", start.logit(), persistent=False)

    def raw(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """The MLP's output before the sigmoids."""
        x = self.encoding(points)
        for layer in self.layers[:-1]:
            x = torch.relu(layer(x))
        return self.layers[-1](x) + self.start

    def forward(
        self,
        points: Float[Tensor, "n 3"],
        uv: Float[Tensor, "n 2"] | None = None,
        area: Int[Tensor, " n"] | None = None,
    ) -> Material:
        """The material at ``points``, training units; ``uv`` is not used. ``area``: the area
        whose ranges apply, where known."""
        del uv
        here = self.local(points, area) if self.local else None
        return to_ranges(self.raw(points), self.config, here)


def to_ranges(
    raw: Float[Tensor, "n 8"], config: AppearanceConfig, here: RangesHere | None = None
) -> Material:
    """Sigmoids of ``raw`` over the ranges, the config's or those ``here``; kn's x and y reach
    ``bump``, its z is positive.

    kd's runs over linear light, as the paper's does, or over sRGB: in linear light the darks, which
    the eye distinguishes, are in the sigmoid's flat end.
    """
    fraction = raw.sigmoid()
    least, most = constant(config.kd_range, raw.device, raw.dtype)
    here = here or RangesHere(config.roughness_range, config.metallic_range, (least, most))
    rough, metal, color = here
    kd = fraction[:, 0:3]
    if config.kd_curve == "srgb":
        # The bounds stay linear ones under both curves.
        kd = srgb_to_linear(_between(kd, tuple(map(linear_to_srgb, color))))
    else:
        kd = _between(kd, color)
    roughness, metallic = _between(fraction[:, 3:4], rough), _between(fraction[:, 4:5], metal)
    # 0 at the start, so flat; z stays above 0, so that no normal points into the surface.
    tilt = (2 * fraction[:, 5:7] - 1) * config.bump
    kn = normalize(torch.cat([tilt, fraction[:, 7:8].clamp(min=1e-3)], -1))
    return Material(kd, roughness, metallic, kn)


def _between(fraction: Tensor, bounds: tuple[float, float] | tuple[Tensor, Tensor]) -> Tensor:
    return bounds[0] + (bounds[1] - bounds[0]) * fraction
