"""A bend about an axis that has an exact inverse: every polar angle around it gets another one.

A sector is turned as it is, another stays, and the two between them are spread or pressed
together, by a cubic with the slope 1 at its ends, so that the surface has no crease there.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

SLOPE = 0.4  # least slope of a cubic's chord: at 1/3 it is no longer monotone
SAMPLES = 65  # of each cubic


@dataclass(frozen=True)
class Fan:
    """A turn about an axis along x, where -y is forward; radians from there, upwards positive.

    ``below`` < ``low`` < ``high`` < ``above``: what is between ``low`` and ``high`` is turned by
    ``by``; below ``below`` and above ``above`` all stays.
    """

    axis: Float[Tensor, " 2"]  # y and z
    below: float
    low: float
    high: float
    above: float
    wanted: float

    def moved(self, by: Float[Tensor, " 3"]) -> "Fan":
        """The bend of what is moved by so much."""
        return replace(self, axis=self.axis + by[1:])

    @property
    def by(self) -> float:
        """The turn, as far as both sides have room for it."""
        room = 1 - SLOPE
        most, least = room * (self.above - self.high), room * (self.below - self.low)
        return float(np.clip(self.wanted, min(least, 0.0), max(most, 0.0)))

    def out(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points in their place after the bend."""
        before, after = self._angles
        return self._moved(points, before, after)

    def into(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """The inverse."""
        before, after = self._angles
        return self._moved(points, after, before)

    def turn_at(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """By how much the surroundings of bent points are turned."""
        before, after = self._angles
        angle = self._angle(points)
        return angle - _interpolated(angle, after, before)

    def _moved(self, points: Tensor, before: np.ndarray, after: np.ndarray) -> Tensor:
        angle = self._angle(points)
        by = _interpolated(angle, before, after) - angle
        cos, sin = by.cos(), by.sin()
        y, z = points[:, 1] - self.axis[0], points[:, 2] - self.axis[1]
        moved = torch.stack([points[:, 0], cos * y + sin * z, cos * z - sin * y], 1)
        return moved + torch.cat([torch.zeros(1), self.axis]).to(points)

    def _angle(self, points: Tensor) -> Tensor:
        return torch.atan2(points[:, 2] - self.axis[1], self.axis[0] - points[:, 1])

    @cached_property
    def _angles(self) -> tuple[np.ndarray, np.ndarray]:
        """Angles before and after, both increasing."""
        ends = [
            (-np.pi, -np.pi),
            (self.below, self.below),
            (self.low, self.low + self.by),
            (self.high, self.high + self.by),
            (self.above, self.above),
            (np.pi, np.pi),
        ]
        t = np.linspace(0, 1, SAMPLES)[:-1]
        before, after = [], []
        for (x0, y0), (x1, y1) in pairwise(ends):
            bump = t * (1 - t) * (1 - 2 * t)  # of the slopes, which are those of x
            before.append(x0 + t * (x1 - x0))
            after.append(y0 + t * t * (3 - 2 * t) * (y1 - y0) + bump * (x1 - x0))
        return np.append(np.concatenate(before), np.pi), np.append(np.concatenate(after), np.pi)


def _interpolated(angle: Tensor, before: np.ndarray, after: np.ndarray) -> Tensor:
    found = np.interp(angle.double().cpu().numpy(), before, after)
    return torch.from_numpy(found).to(angle)
