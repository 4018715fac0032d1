"""The split sum's second factor in its textbook form: one blurred map for each roughness.

"Real Shading in Unreal Engine 4", Karis 2013, as the paper uses it after Munkberg et al. 2022: the
lobe as it is when looked at along the normal (n = v = r), turned to the mirror direction.
"""

from dataclasses import dataclass
from functools import partial

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.brdf import ggx_d
from core.appearance.latlong import Levels, convolve, resample
from core.ops import dot

# Roughness from level to level; rows of the maps: a texel is at most half as wide as its lobe.
# Linear between the levels; the tenth is roughness 1.
STEP = 0.1
ROWS = (256, 128, 64, 64, 64, 64, 64, 64, 64, 64)


@dataclass(frozen=True)
class SplitSum:
    """Level k is the light blurred by the lobe of roughness k * STEP; level 0 as it came."""

    maps: Levels

    @classmethod
    def of(cls, image: Float[Tensor, "h w 3"]) -> "SplitSum":
        """Blurs a lat-long map."""
        blurred = [
            convolve(resample(image, n, 2 * n), partial(ggx_kernel, alpha=(STEP * (k + 1)) ** 2))
            for k, n in enumerate(ROWS)
        ]
        return cls(Levels.of([image, *blurred]))

    def to(self, device: "torch.device | str") -> "SplitSum":
        """The same on ``device``."""
        return SplitSum(self.maps.to(device))

    def rotated(self, azimuth: float) -> "SplitSum":
        """Turned about the vertical, radians."""
        return SplitSum(self.maps.rotated(azimuth))

    def blurred(self, direction: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """The light around a direction, by the lobe of alpha 1/16."""
        # Alpha 1/16 is roughness 1/4.
        return self.maps.read(direction, torch.full_like(direction[:, 0], 0.25 / STEP))

    def average(
        self,
        normal: Float[Tensor, "p 3"],
        view: Float[Tensor, "p 3"],
        roughness: Float[Tensor, "p 1"],
        diffuse: Float[Tensor, "p 3"],
    ) -> Float[Tensor, "3 p 3"]:
        """The light averaged over the lobe, the same for all Fresnel terms."""
        mirrored = 2 * dot(normal, view) * normal - view
        # Karis' simplification: no dependence on the view, so no stretched reflections at grazing
        # angles.
        light = self.maps.read(mirrored, roughness.squeeze(1) / STEP)
        return light.expand(3, *diffuse.shape)


def ggx_kernel(cos: Float[Tensor, "*b"], alpha: float) -> Float[Tensor, "*b"]:
    """Weight of light at an angle from the mirror direction, where n = v = r (Karis 2013).

    Sampling D (n·h) makes the density of l D / 4, and light counts with n·l.
    """
    cos_h = torch.sqrt((1 + cos) / 2)
    return ggx_d(cos_h, torch.full_like(cos, alpha)) * cos.clamp(min=0)
