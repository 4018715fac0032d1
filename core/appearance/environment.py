"""Light from all around, in the form that Eqs. 7 and 8 need it: the split sum.

    L_s = ∫ D F G / (4 (ω·n)(ω_i·n)) L_i (ω_i·n) dω_i
        ≈ (albedo, by roughness and n·ω) x (L_i averaged over the lobe)

Both factors are tables made once: :mod:`core.appearance.brdf`, and for each light this. For the
second factor there are two models: the textbook's (:mod:`core.appearance.specular`), and fitted
lobes that match Cycles (:mod:`core.appearance.lobes`), with the sun and other small bright lights
shaded on their own (:mod:`core.appearance.lamps`).
"""

from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.lamps import Lamps, split_lamps
from core.appearance.latlong import Levels, convolve, resample
from core.appearance.lights import load_light as load_light
from core.appearance.lobes import FittedLobes
from core.appearance.specular import SplitSum
from core.config import ShadingModel

# Larger maps are averaged down to this, smaller ones are kept.
MIRROR_ROWS = 512
# A texel of 1.4 degrees is far narrower than the cosine lobe; the convolution's cost grows with the
# cube of the rows.
IRRADIANCE_ROWS = 128


class Incoming(NamedTuple):
    """The light averaged over the lobes of the reflectance; without the lamps."""

    diffuse: Float[Tensor, "p 3"]  # cosine about the normal
    base: Float[Tensor, "p 3"]  # specular, F = 1 - (1 - cos)^5
    schlick: Float[Tensor, "p 3"]  # specular, F = (1 - cos)^5
    dielectric: Float[Tensor, "p 3"]  # specular, F of the dielectric


@dataclass(frozen=True)
class Environment:
    """One light, prefiltered. Linear radiance; directions in the world."""

    mirror: Levels  # as it came
    irradiance_map: Levels  # ∫ L cos / π of what is no lamp's
    specular: FittedLobes | SplitSum
    lamps: Lamps
    diffuse_only: bool = False  # the ablation without a specular layer

    @classmethod
    def of(cls, image: Float[Tensor, "h w 3"], model: ShadingModel = "lobes") -> "Environment":
        """Prefilters a lat-long map of any size, on the map's device; 1 to 2 s on one core.

        ``model``: fitted lobes, which look as in Cycles, or the paper's split sum, which is faster
        to shade; or diffuse, whose split sum only :meth:`around` reads.
        """
        # The convolutions make their tensors on the CPU.
        device, image = image.device, image.detach().to("cpu", torch.float32)
        rows = min(MIRROR_ROWS, image.shape[0])
        image = resample(image, rows, min(2 * MIRROR_ROWS, image.shape[1]))
        # The split sum is the paper's, with the suns in its maps.
        rest, lamps = split_lamps(image) if model == "lobes" else (image, Lamps.none())
        # The lamps' irradiance is added exactly in ``irradiance``: their light must not be in the
        # map too.
        small = resample(rest, IRRADIANCE_ROWS, 2 * IRRADIANCE_ROWS)
        irradiance = convolve(small, lambda cos: cos.clamp(min=0))
        specular = FittedLobes.of(rest) if model == "lobes" else SplitSum.of(rest)
        maps = Levels.of([image]), Levels.of([irradiance])
        return cls(*maps, specular, lamps, model == "diffuse").to(device)

    def to(self, device: "torch.device | str") -> "Environment":
        """The same on ``device``."""
        return Environment(
            self.mirror.to(device),
            self.irradiance_map.to(device),
            self.specular.to(device),
            self.lamps.to(device),
            self.diffuse_only,
        )

    def rotated(self, azimuth: float) -> "Environment":
        """The light turned about the vertical by ``azimuth`` radians, counter-clockwise from above.

        Shares the maps, so it costs nothing.
        """
        return Environment(
            self.mirror.rotated(azimuth),
            self.irradiance_map.rotated(azimuth),
            self.specular.rotated(azimuth),
            self.lamps.rotated(azimuth),
            self.diffuse_only,
        )

    def radiance(self, direction: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """L_i: what is seen looking along ``direction``."""
        return self.mirror.read(direction)

    def around(self, direction: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """L_i of what is no lamp's, blurred by about 0.1 radians."""
        return self.specular.blurred(direction)

    def irradiance(self, normal: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """∫ L_i (ω_i·n) dω_i / π (Eq. 8): what a white diffuse surface sends out."""
        return self.irradiance_map.read(normal) + self.lamps.irradiance(normal)

    def incoming(
        self,
        normal: Float[Tensor, "p 3"],
        view: Float[Tensor, "p 3"],
        roughness: Float[Tensor, "p 1"],
    ) -> Incoming:
        """The light as the surface averages it; ``view`` points to the eye."""
        diffuse = self.irradiance_map.read(normal)
        return Incoming(diffuse, *self.specular.average(normal, view, roughness, diffuse))
