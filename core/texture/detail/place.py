"""A pattern's input and output: places of the surface, and the material's change there."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int

from core.texture.detail.noise import Noise, Points, Values


@dataclass(frozen=True)
class Place:
    """N points of an object whose longest side is about 1 (:func:`core.texture.detail.scale`)."""

    point: Points
    normal: Points  # unit, of the shape without detail
    along: Int[np.ndarray, " n"]  # the axis, 0 to 2, along which the part there is longest
    noise: Noise
    # How convex the shape is there, about in [-1, 1]: above 0 on an edge, below 0 in a corner.
    edge: Values | float = 0.0
    # How high it is in all that is of its kind, from 0 at its foot to 1.
    rise: Values | float = 0.5

    @property
    def grained(self) -> Points:
        """The points in a part's own axes, its length first; parts are cut from different places
        of the solid, so that two boards never go on in one another."""
        order = (self.along[:, None] + np.arange(3)) % 3
        turned = np.take_along_axis(self.point, order, 1)
        return turned + np.array([0.0, 1.7, 3.1], np.float32)[self.along][:, None]

    @property
    def faced(self) -> Points:
        """How much each axis is the one that the surface faces; the three add up to 1."""
        weight = np.abs(self.normal) ** 8
        return weight / np.maximum(weight.sum(1, keepdims=True), 1e-12)


class Layer(NamedTuple):
    """A material's detail at N points. Where there is none, all but ``ratio`` is 0, and that 1."""

    ratio: Float[np.ndarray, "n 3"]  # the base colour's factor, linear
    over: Float[np.ndarray, "n 3"]  # another substance's base colour, linear,
    cover: Values  # and how much of the surface it takes, in [0, 1]
    roughness: Values  # added
    metallic: Values  # added
    height: Values  # over the surface, in the points' units
    # How much of the colour is no part of the material's mean, in [0, 1]: such as bare metal, that
    # has to stay grey while the rust around it makes up for it.
    apart: Values

    @classmethod
    def of(cls, tone: Values, dark: tuple[float, float, float], **more: np.ndarray) -> "Layer":
        """By a tone: ``dark`` is the colour's factor where it is 1, and 1 / ``dark`` where -1."""
        zero = np.zeros(len(tone), np.float32)
        ratio = np.array(dark, np.float32) ** tone[:, None]
        fields = {"over": np.zeros_like(ratio), "cover": zero, "roughness": zero}
        fields |= {"metallic": zero, "height": zero, "apart": zero}
        return cls(ratio, **(fields | more))
