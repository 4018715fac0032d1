"""Light from all around, in the form that Eq. 8 needs it: the split sum.

    L_s = ∫ D F G / (4 (ω·n)(ω_i·n)) L_i (ω_i·n) dω_i
        ≈ (albedo, by roughness and n·ω) x (L_i averaged over the lobe about the mirror direction)

("Real Shading in Unreal Engine 4", Karis 2013, as the paper uses it after Munkberg et al. 2022.)
Both factors are tables made once: :mod:`core.appearance.brdf` and, for each light, this.
"""

from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.brdf import ggx_d
from core.appearance.latlong import Levels, convolve, resample
from core.appearance.lights import load_light as load_light
from core.ops import dot

# Roughness of each level, the rows of its map, and the rows of the mirror's.
STEP = 0.1
ROWS = (256, 128, 64, 64, 64, 64, 64, 64, 64, 64)
MIRROR_ROWS = 512
IRRADIANCE_ROWS = 128


class Lobe(NamedTuple):
    """The light averaged over the specular lobe, for each kind of Fresnel term."""

    base: Float[Tensor, "p 3"]  # F = 1 - (1 - cos)^5
    schlick: Float[Tensor, "p 3"]  # F = (1 - cos)^5
    dielectric: Float[Tensor, "p 3"]


@dataclass(frozen=True)
class Environment:
    """One light, prefiltered. Linear radiance; directions in the world."""

    mirror: Levels  # as it came
    irradiance_map: Levels  # ∫ L cos / π
    specular_maps: Levels  # level k: roughness k * STEP, seen along the normal (n = v = r)

    @classmethod
    def of(cls, image: Float[Tensor, "h w 3"]) -> "Environment":
        """Prefilters a lat-long map of any size, on the map's device; about 2 s on one core."""
        device, image = image.device, image.detach().to("cpu", torch.float32)
        rows = min(MIRROR_ROWS, image.shape[0])
        small = resample(image, rows, min(2 * MIRROR_ROWS, image.shape[1]))
        sizes = sorted({IRRADIANCE_ROWS, *ROWS}, reverse=True)
        sized = {rows: resample(small, rows, 2 * rows) for rows in sizes}
        maps = [
            convolve(sized[rows], partial(ggx_kernel, roughness=STEP * (k + 1)))
            for k, rows in enumerate(ROWS)
        ]
        irradiance = convolve(sized[IRRADIANCE_ROWS], lambda cos: cos.clamp(min=0))
        levels = (Levels.of([small]), Levels.of([irradiance]), Levels.of([small, *maps]))
        return cls(*(each.to(device) for each in levels))

    def to(self, device: "torch.device | str") -> "Environment":
        """The same on ``device``."""
        return Environment(
            self.mirror.to(device), self.irradiance_map.to(device), self.specular_maps.to(device)
        )

    def rotated(self, azimuth: float) -> "Environment":
        """The light turned about the vertical by ``azimuth`` radians, counter-clockwise from above.

        Shares the maps, so it costs nothing.
        """
        return Environment(
            self.mirror.rotated(azimuth),
            self.irradiance_map.rotated(azimuth),
            self.specular_maps.rotated(azimuth),
        )

    def radiance(self, direction: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """L_i: what is seen looking along ``direction``."""
        return self.mirror.read(direction)

    def irradiance(self, normal: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """∫ L_i (ω_i·n) dω_i / π (Eq. 8): what a white diffuse surface sends out."""
        return self.irradiance_map.read(normal)

    def lobe(
        self,
        normal: Float[Tensor, "p 3"],
        view: Float[Tensor, "p 3"],
        roughness: Float[Tensor, "p 1"],
    ) -> Lobe:
        """The light averaged over the specular lobe; ``view`` points to the eye."""
        mirrored = 2 * dot(normal, view) * normal - view
        light = self.specular_maps.read(mirrored, roughness.squeeze(1) / STEP)
        return Lobe(light, light, light)


def ggx_kernel(cos: Float[Tensor, "*b"], roughness: float) -> Float[Tensor, "*b"]:
    """Weight of light at an angle from the mirror direction, where n = v = r (Karis 2013).

    Sampling D (n·h) makes the density of l D / 4, and light counts with n·l.
    """
    cos_h = torch.sqrt((1 + cos) / 2)
    return ggx_d(cos_h, torch.full_like(cos, roughness**2)) * cos.clamp(min=0)
