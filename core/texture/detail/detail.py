"""The substances' detail on one object: what it does to the material that was learnt."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.guidance import Surface
from core.ops import across
from core.texture.detail.kinds import KINDS
from core.texture.detail.noise import Noise, Values
from core.texture.detail.parts import Parts
from core.texture.detail.place import Layer, Place
from core.texture.detail.weather import WEATHERS, laid

LEAST_REACH = 1e-3  # upwards, of weather that lies on the surface
LEAST = 0.02  # weight of a surface at a point, below which it is ignored
STEEPEST = 1.2  # slope of the relief: steeper ones would hide themselves
STEP = 0.5  # texels, over which a slope is measured
KD_RANGE = (0.002, 0.98)
ROUGHNESS_RANGE = (0.04, 1.0)
GAIN = (0.5, 2.0)  # bounds of what brings the mean colour back
# A colour is what one sees by light that came through several walls: one wall's is its root.
THIN = 0.6
DEEP = 1.7  # power of a colour that glows: what is bright is seen burnt out towards white


class Coat(NamedTuple):
    """The material at N points."""

    kd: Float[Tensor, "n 3"]  # linear
    roughness: Float[Tensor, "n 1"]
    metallic: Float[Tensor, "n 1"]
    # Of what is learnt alone these are not known.
    emission: Float[Tensor, "n 3"] | None = None  # linear
    transmission: Float[Tensor, "n 1"] | None = None


class Spots(NamedTuple):
    """N points of the surface."""

    point: Float[Tensor, "n 3"]  # in units of the object's longest side
    normal: Float[Tensor, "n 3"]  # unit
    lengths: Float[Tensor, "n 3"]  # see core.texture.detail.grain
    edge: Float[Tensor, "n 1"]  # how convex it is, there too
    area: Int[Tensor, " n"] | None = None  # where the areas are known

    def where(self, index: Int[Tensor, " m"]) -> "Spots":
        """Some of them."""
        return Spots(*(x if x is None else x[index] for x in self))


@dataclass(frozen=True)
class Detail:
    """The detail of all of an object's surfaces."""

    parts: Parts
    noise: Noise
    strength: float
    gains: Float[Tensor, "k 3"]  # of each surface's base colour, so that its mean stays
    grain: Float[Tensor, "v 4"] | None = None  # of the mesh's vertices: lengths, and edges
    # From where to where each surface reaches upwards, as the points' units.
    levels: tuple[tuple[float, float], ...] = ()

    @classmethod
    def of(cls, parts: Parts, noise: Noise, strength: float, at: Spots, coat: Coat) -> "Detail":
        """``at``, ``coat``: points evenly over the surface, and what was learnt there."""
        weights = parts.weights(coat.kd, at.area)
        levels = tuple(_reach(at.point[own > 0.5, 2]) for own in weights.T)
        plain = cls(parts, noise, strength, torch.ones(len(parts.surfaces), 3), levels=levels)
        gains = []
        for k, surface in enumerate(parts.surfaces):
            # By the points that are mostly this surface's; a part that is nowhere keeps 1.
            weight = weights[:, k : k + 1] * (weights[:, k : k + 1] > 0.5)
            wanted = coat.kd * torch.tensor(surface.factor)
            layer = plain._as_new(k, at)[1]  # what covers it is no part of its mean
            got, apart = _colored(coat.kd, layer, surface, strength), _column(layer.apart)
            missing = (weight * (wanted - apart * got)).sum(0)
            gain = missing / (weight * (1 - apart) * got).sum(0).clamp(min=1e-9)
            gains.append(torch.where(weight.sum() > 0, gain, torch.ones(3)).clamp(*GAIN))
        return cls(parts, noise, strength, torch.stack(gains), levels=levels)

    def __call__(self, at: Spots, coat: Coat) -> tuple[Coat, Float[Tensor, "n 3"]]:
        """The material with its detail, and the gradient of the relief along the surface."""
        weights = self.parts.weights(coat.kd, at.area)
        kd, roughness, metallic = torch.zeros_like(coat.kd), coat.roughness, coat.metallic
        slope, emission = torch.zeros_like(at.point), torch.zeros_like(coat.kd)
        transmission = torch.zeros_like(metallic)
        for k, surface in enumerate(self.parts.surfaces):
            here = (weights[:, k] > LEAST).nonzero().squeeze(1)
            if not len(here):
                continue
            spots, w = at.where(here), weights[here, k : k + 1]
            layer, gradient = self._relief(k, spots)
            gain = torch.lerp(self.gains[k], torch.ones(3), _column(layer.apart))
            color = gain * _colored(coat.kd[here], layer, surface, self.strength)
            more = self.strength * _column(layer.roughness) + surface.roughness
            metal = self.strength * _column(layer.metallic) + surface.metallic
            # A point known by its colour alone has a little of all; that does not glow.
            shown = (2 * w - 1).clamp(min=0) * (1 - self.strength * _column(layer.cover)).clamp(0)
            emission = emission.index_add(0, here, surface.glow * shown * color**DEEP)
            if surface.clear:
                clear = surface.clear * shown
                transmission = transmission.index_add(0, here, clear)
                color = color ** (1 - THIN * clear)
            kd = kd.index_add(0, here, w * color)
            roughness = roughness.index_add(0, here, w * more)
            metallic = metallic.index_add(0, here, w * metal)
            slope = slope.index_add(0, here, w * gradient)
        # What no surface was looked at for stays as it was learnt.
        left = 1 - (weights * (weights > LEAST)).sum(1, keepdim=True)
        kd = (kd + left * coat.kd).clamp(*KD_RANGE)
        rough, metal = roughness.clamp(*ROUGHNESS_RANGE), metallic.clamp(0, 1)
        made = Coat(kd, rough, metal, emission.clamp(0, 1), transmission.clamp(0, 1))
        return made, self.strength * slope

    @property
    def lights(self) -> bool:
        """Whether anything of it glows or is clear."""
        return lit(self.parts.surfaces)

    def _as_new(self, k: int, at: Spots) -> tuple[Place, Layer]:
        along, edge = at.lengths.argmax(1), at.edge[:, 0].numpy()
        low, high = self.levels[k] if self.levels else (-0.5, 0.5)
        rise = ((at.point[:, 2].numpy() - low) / max(high - low, LEAST_REACH)).clip(0, 1)
        place = Place(*(x.numpy() for x in (at.point, at.normal, along)), self.noise, edge, rise)
        return place, KINDS[self.parts.surfaces[k].kind](place)

    def _layer(self, k: int, at: Spots) -> Layer:
        place, layer = self._as_new(k, at)
        for name in self.parts.surfaces[k].weather:
            layer = laid(WEATHERS[name](place), layer)
        return layer

    def _relief(self, k: int, at: Spots) -> tuple[Layer, Float[Tensor, "n 3"]]:
        """The layer at the points, and its height's gradient: by one step along each of two
        directions across the normal (J. Blinn, "Simulation of Wrinkled Surfaces", 1978)."""
        step, count = STEP * self.noise.footprint, len(at.point)
        one, two = across(at.normal)
        points = torch.cat([at.point, at.point + step * one, at.point + step * two])
        # The part's direction and normal are the middle's, or a step over their border would jump.
        rest = (x.repeat(3, 1) for x in (at.normal, at.lengths, at.edge))
        layer = self._layer(k, Spots(points, *rest))
        height, h1, h2 = torch.from_numpy(layer.height).view(3, count, 1)
        gradient = ((h1 - height) * one + (h2 - height) * two) / step
        length = gradient.norm(dim=1, keepdim=True).clamp(min=1e-9)
        gradient = gradient * (STEEPEST / length).clamp(max=1)
        return Layer(*(x[:count] for x in layer)), gradient


def _reach(heights: Float[Tensor, " n"]) -> tuple[float, float]:
    """The least and the greatest; of nothing as of the whole object."""
    return (heights.min().item(), heights.max().item()) if len(heights) else (-0.5, 0.5)


def lit(surfaces: tuple[Surface, ...]) -> bool:
    """Whether any of them glows or is clear."""
    return any(surface.glow or surface.clear for surface in surfaces)


def renamed(surfaces: tuple[Surface, ...]) -> bool:
    """Whether any of them is of another colour or gloss than what the model was asked for."""
    return any(
        surface.factor != (1.0, 1.0, 1.0) or surface.roughness or surface.metallic
        for surface in surfaces
    )


def _column(values: Values) -> Float[Tensor, "n 1"]:
    return torch.from_numpy(np.asarray(values, np.float32))[:, None]


def _colored(
    kd: Float[Tensor, "n 3"], layer: Layer, surface: Surface, strength: float
) -> Float[Tensor, "n 3"]:
    """The learnt colour under a layer, before its mean is brought back."""
    ratio, over, cover = (torch.from_numpy(np.asarray(x)) for x in layer[:3])
    below = kd * torch.tensor(surface.factor) * ratio ** (strength * surface.depth)
    return torch.lerp(below, over, (strength * cover).clamp(max=1)[:, None])
