"""Small bright lights, a sun or a lamp, taken out of the map and shaded by Eq. 8 itself.

A sun of a few texels holds up to half of a map's light. Averaged over fitted lobes, its highlight
would show how each lobe ends; as a source in one direction it has the reflectance's own shape, and
costs less than one lobe. A source of some width is one of no width seen in a rougher surface.
"""

import math
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.brdf import (
    MIN_ALPHA,
    fresnel_dielectric,
    ggx_d,
    schlick_weight,
    smith_g2,
)
from core.appearance.latlong import directions, solid_angles
from core.ops import dot, normalize

LUMINANCE = (0.2126, 0.7152, 0.0722)  # Rec.709
BRIGHT = 40.0  # times the mean luminance: what is above is a lamp's
WIDEST = 0.02  # radians: standard deviation of a lamp along its longer side; wider ones are cut
MOST = 16  # lamps; the weakest stay in the map
LEAST = 2e-4  # of all light: what a lamp must have


@dataclass(frozen=True)
class Lamps:
    """L lights of one direction each."""

    direction: Float[Tensor, "l 3"]  # towards the lamp, unit
    power: Float[Tensor, "l 3"]  # radiance times solid angle
    width: Float[Tensor, " l"]  # standard deviation along one axis, radians

    @classmethod
    def none(cls) -> "Lamps":
        """No lamp."""
        return cls(torch.zeros(0, 3), torch.zeros(0, 3), torch.zeros(0))

    def to(self, device: "torch.device | str") -> "Lamps":
        """The same on ``device``."""
        return Lamps(self.direction.to(device), self.power.to(device), self.width.to(device))

    def rotated(self, azimuth: float) -> "Lamps":
        """Turned about the vertical, radians."""
        x, y, z = self.direction.unbind(1)
        c, s = math.cos(azimuth), math.sin(azimuth)
        return Lamps(torch.stack([c * x - s * y, s * x + c * y, z], 1), self.power, self.width)

    def irradiance(self, normal: Float[Tensor, "p 3"]) -> Float[Tensor, "p 3"]:
        """∫ L_i (ω_i·n) dω_i / π."""
        cosine = (normal @ self.direction.t().to(normal)).clamp(min=0)
        return cosine @ self.power.to(normal) / math.pi

    def reflected(
        self,
        normal: Float[Tensor, "p 3"],
        view: Float[Tensor, "p 3"],
        cos_v: Float[Tensor, "p 1"],
        roughness: Float[Tensor, "p 1"],
    ) -> Float[Tensor, "3 p 3"]:
        """Eq. 8's specular part with F = 1 - (1 - cos)^5, (1 - cos)^5, and the dielectric's.

        ``cos_v`` is n·ω, kept from zero.
        """
        alpha = roughness.square().clamp(min=MIN_ALPHA)
        # One lamp after another: memory does not grow with their number.
        total = normal.new_zeros(3, *normal.shape)
        for direction, power, width in zip(self.direction, self.power, self.width, strict=True):
            light = direction.to(normal)
            half = normalize(view + light)
            cos_l, cos_d = normal @ light[:, None], dot(half, view).clamp(0, 1)
            # Of slopes: a Gaussian light of this width moves the half vector by half of it.
            wide = torch.sqrt(alpha.square() + width.to(normal).square() / 2)
            # D alone is widened: G hardly changes over a lamp's width.
            d = ggx_d(dot(normal, half).clamp(0, 1), wide)
            g = smith_g2(cos_v, cos_l.clamp(min=1e-5), alpha)
            weight = d * g / (4 * cos_v) * (cos_l > 0)
            schlick = schlick_weight(cos_d)
            kinds = torch.stack([1 - schlick, schlick, fresnel_dielectric(cos_d)])
            total = total + kinds * weight * power.to(normal)
        return total


def split_lamps(image: Float[Tensor, "h w 3"]) -> tuple[Float[Tensor, "h w 3"], Lamps]:
    """A lat-long map without its lamps, and the lamps. Together they are the map's light."""
    height, width, _ = image.shape
    luminance = image @ torch.tensor(LUMINANCE)
    area = solid_angles(height, width)
    # BRIGHT TEXELS: what is above the bound is a lamp's, the rest of the texel stays in the map
    mean = float((luminance * area).sum() / (4 * math.pi))
    kept = (BRIGHT * mean / luminance.clamp(min=1e-12)).clamp(max=1)[..., None]
    bright = (kept[..., 0] < 1).reshape(-1).nonzero().squeeze(1)
    if not len(bright):
        return image, Lamps.none()
    power = ((image * (1 - kept)) * area[:, None]).reshape(-1, 3)[bright]
    axis = directions(height, width).view(-1, 3)[bright]
    fraction = power @ torch.tensor(LUMINANCE) / (4 * math.pi * mean)

    # CLUSTERS: the strongest, since each costs a pass of Eq. 8 over all points
    clusters = [p for p in cut(axis, fraction) if float(fraction[p].sum()) > LEAST]
    clusters = sorted(clusters, key=lambda p: -float(fraction[p].sum()))[:MOST]
    if not clusters:
        return image, Lamps.none()
    # THE REST: weak clusters go back to the map, so that no light is lost
    rest, texel = image.reshape(-1, 3).clone(), math.pi / height
    taken = bright[torch.cat(clusters)]
    rest[taken] = (image * kept).reshape(-1, 3)[taken]
    middles, widths = zip(*(middle_of(axis[p], fraction[p]) for p in clusters), strict=True)
    lamps = Lamps(
        torch.stack(middles),
        torch.stack([power[p].sum(0) for p in clusters]),
        # Reading between texels blurs by 1/6 of a texel's square.
        torch.stack([(w.square().sum() / 2 + texel**2 / 6).sqrt() for w in widths]),
    )
    return rest.view(image.shape), lamps


def cut(axis: Float[Tensor, "n 3"], fraction: Float[Tensor, " n"]) -> list[Int[Tensor, " m"]]:
    """The texels in clusters, none wider than WIDEST: halved across their longest side until so."""
    todo, clusters = [torch.arange(len(axis))], []
    while todo:
        cluster = todo.pop()
        # Widths are ascending; the last is that along the cluster's longest side.
        middle, widths = middle_of(axis[cluster], fraction[cluster])
        if float(widths[-1]) <= WIDEST:
            clusters.append(cluster)
            continue
        away = axis[cluster] - middle
        # Halved at the mean along the first principal axis.
        spread = (fraction[cluster, None] * away).t() @ away
        side = away @ torch.linalg.eigh(spread).eigenvectors[:, -1]
        side = side - (side * fraction[cluster]).sum() / fraction[cluster].sum()
        todo += [cluster[side > 0], cluster[side <= 0]]
    return clusters


def middle_of(
    axis: Float[Tensor, "n 3"], fraction: Float[Tensor, " n"]
) -> tuple[Float[Tensor, "3"], Float[Tensor, "3"]]:
    """The mean direction, and the standard deviations about it, ascending; weighted."""
    weight = fraction[:, None] / fraction.sum()
    middle = normalize((weight * axis).sum(0))
    away = axis - middle
    spread = torch.linalg.eigvalsh((weight * away).t() @ away)
    return middle, spread.clamp(min=0).sqrt()
