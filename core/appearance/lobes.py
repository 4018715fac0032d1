"""The split sum's second factor, close to exact: a few lobes fitted to the reflectance.

The textbook's single blurred map forgets that the lobe leans and stretches at grazing angles, is
cut at the horizon, and that its Fresnel term varies across it; against Cycles that costs up to
25 dB. Here the light is averaged over six round lobes in the plane of incidence and the cosine lobe
about the normal, whose places, widths and weights by roughness and n·v were fitted once
(:mod:`core.appearance.fit_lobes`). A lobe is what GGX reflects straight back, so its tail is GGX's.
All of it is smooth in the normal and the roughness.
"""

import math
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path

import torch
from jaxtyping import Float
from safetensors.torch import load_file
from torch import Tensor
from torch.nn.functional import grid_sample

from core.appearance.brdf import MIN_ALPHA
from core.appearance.latlong import Levels, convolve, resample
from core.appearance.specular import ggx_kernel
from core.ops import dot

FILE = Path(__file__).with_name("lobes.safetensors")
LOBES = 6
ROUGHNESS = (0.05, 1.0, 14)  # the table's rows: first, last, number
ROOT_COS = (0.12, 1.0, 20)  # its columns, of sqrt(n·v), which spreads out the grazing angles
# Level k is blurred by the lobe of alpha FINEST * 2**k; level 0 is the light as it came. Rows of
# the maps from level 1: a texel is about as wide as its lobe at most.
FINEST = 1 / 256
ROWS = (256, 256, 128, 128, 64, 64, 32, 32)


@cache
def lobe_table() -> Float[Tensor, "channels rows columns"]:
    """The fitted numbers."""
    return load_file(FILE)["lobes"]


def lookup_lobes(
    table: Float[Tensor, "channels rows columns"],
    roughness: Float[Tensor, "p 1"],
    cos_v: Float[Tensor, "p 1"],
) -> tuple[Float[Tensor, "p k"], Float[Tensor, "p k"], Float[Tensor, "p 3 k1"]]:
    """Offsets, log widths, and weights (of the cosine lobe last), bilinear in the table.

    The weights of a Fresnel term add up to 1.
    """
    # Below the first column the lobes of n·v = 0.0144 are read: the root's gradient stays finite.
    root = torch.sqrt(cos_v.clamp(ROOT_COS[0] ** 2, ROOT_COS[1]))
    places = [
        (x - first) / (last - first) * 2 - 1
        for x, (first, last, _) in ((root, ROOT_COS), (roughness, ROUGHNESS))
    ]
    found = grid_sample(
        table[None].to(roughness),
        torch.cat(places, 1)[None, None],
        align_corners=True,
        padding_mode="border",
    )[0, :, 0].t()
    # Channels: K offsets, K widths and 3 (K + 1) weights, 5 K + 3 in all.
    count = (len(table) - 3) // 5
    offset, log_width, weights = found.split([count, count, 3 * (count + 1)], 1)
    return offset, log_width, weights.unflatten(1, (3, count + 1))


@dataclass(frozen=True)
class FittedLobes:
    """The light, blurred level by level, and the lobes to read it by."""

    maps: Levels
    table: Float[Tensor, "channels rows columns"]

    @classmethod
    def of(cls, image: Float[Tensor, "h w 3"]) -> "FittedLobes":
        """Blurs a lat-long map."""
        blurred = [
            convolve(resample(image, n, 2 * n), partial(ggx_kernel, alpha=FINEST * 2 ** (k + 1)))
            for k, n in enumerate(ROWS)
        ]
        return cls(Levels.of([image, *blurred]), lobe_table())

    def to(self, device: "torch.device | str") -> "FittedLobes":
        """The same on ``device``."""
        return FittedLobes(self.maps.to(device), self.table.to(device))

    def rotated(self, azimuth: float) -> "FittedLobes":
        """Turned about the vertical, radians."""
        return FittedLobes(self.maps.rotated(azimuth), self.table)

    def blurred(self, direction: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """The light around a direction, by a lobe of alpha 1/16."""
        # log2 of (1 / 16) / FINEST.
        level = torch.full_like(direction[:, 0], -math.log2(16 * FINEST))
        return self.maps.read(direction, level)

    def average(
        self,
        normal: Float[Tensor, "p 3"],
        view: Float[Tensor, "p 3"],
        roughness: Float[Tensor, "p 1"],
        diffuse: Float[Tensor, "p 3"],
    ) -> Float[Tensor, "3 p 3"]:
        """The light averaged over the lobe with each Fresnel term.

        ``diffuse`` is the light averaged over the cosine lobe.
        """
        alpha = roughness.square().clamp(min=MIN_ALPHA)
        cos_v = dot(normal, view)
        # Offsets and widths are in units of alpha.
        offset, log_width, weights = lookup_lobes(self.table, roughness, cos_v)
        axes = lobe_axes(normal, view, alpha * offset)
        level = (log_width + alpha.log()) / math.log(2) - math.log2(FINEST)
        light = self.maps.read(axes.reshape(-1, 3), level.reshape(-1)).view_as(axes)
        light = torch.cat([light, diffuse[:, None]], 1)
        return torch.bmm(weights, light).transpose(0, 1)


def lobe_axes(
    normal: Float[Tensor, "p 3"], view: Float[Tensor, "p 3"], offset: Float[Tensor, "p k"]
) -> Float[Tensor, "p k 3"]:
    """The mirror direction, turned away from the normal by ``offset`` times sin(v).

    With c = n·v and t = v - c n, the lobe at angle θ + δ from the normal is
    n cos(θ + δ) - (t / |t|) sin(θ + δ); written so that nothing is divided by |t| = sin θ.
    """
    cos_v = dot(normal, view)
    side = view - cos_v * normal
    # An even function of sin θ throughout: the bound only keeps the root's gradient finite.
    sin_v = dot(side, side).clamp(min=1e-8).sqrt()
    delta = offset * sin_v
    ratio = offset * torch.sinc(delta / math.pi)  # sin δ / sin θ
    along_normal = cos_v * delta.cos() - sin_v.square() * ratio
    along_side = delta.cos() + cos_v * ratio
    return along_normal[..., None] * normal[:, None] - along_side[..., None] * side[:, None]
