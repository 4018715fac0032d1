"""Noise in the object's space, without what a texture cannot show.

Octaves finer than the texels fade out before they alias ("clamping": A. Norton, A. P. Rockwood and
P. T. Skolmoski, "Clamping: A Method of Antialiasing Textured Surfaces by Bandwidth Limiting in
Object Space", SIGGRAPH 1982).
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from core.kernels import noise as kernels

Points = Float[np.ndarray, "n 3"]
Values = Float[np.ndarray, " n"]
Frequency = float | tuple[float, float, float]  # waves a unit, the same or one for each axis

# Texels to a wave: none is left of a wave of 2, Nyquist's bound; all of one of 4.
GONE, WHOLE = 2.0, 4.0


@dataclass(frozen=True)
class Noise:
    """Fields of one object's surface; each ``salt`` is another field."""

    seed: int
    footprint: float  # side of a texel, in the points' units

    def seen(self, frequency: float) -> float:
        """The fraction in [0, 1] of a wave's height that the texels can show."""
        texels = 1 / max(frequency * self.footprint, 1e-9)
        return float(np.clip((texels - GONE) / (WHOLE - GONE), 0, 1))

    def shown(self, wave: float) -> float:
        """The length of a wave, or of the shortest that the texels show whole: for what a material
        cannot be without, such as a weave."""
        return max(wave, 1.05 * WHOLE * self.footprint)

    def waves(self, points: Points, frequency: Frequency, salt: int, octaves: int = 1) -> Values:
        """Gradient noise, about in [-1, 1]; each further octave has half the length and height."""
        scale = _scale(frequency)
        weights = [self.seen(float(scale.max()) * 2**o) * 0.5**o for o in range(octaves)]
        return kernels.gradient(
            np.ascontiguousarray(points, np.float32),
            scale,
            np.array(weights, np.float32),
            self._seed(salt),
        )

    def cells(
        self, points: Points, frequency: Frequency, salt: int, jitter: float = 1.0
    ) -> tuple[Values, Values, Values]:
        """Cellular noise: the distance to the nearest feature point in cells, how much farther the
        second one is (0 on the border between two), and the cell's own number in [0, 1)."""
        found = kernels.cells(
            np.ascontiguousarray(points, np.float32),
            _scale(frequency),
            np.float32(jitter),
            self._seed(salt),
        )
        return found[:, 0], found[:, 1] - found[:, 0], found[:, 2]

    def _seed(self, salt: int) -> int:
        # Octaves take the seeds after this one, so salts are far apart.
        return (self.seed * 1013 + salt * 64) % 2**31


def _scale(frequency: Frequency) -> Float[np.ndarray, " 3"]:
    return np.array(np.broadcast_to(frequency, 3), np.float32)


def smoothstep(low: float, high: float, x: Values) -> Values:
    """0 below ``low``, 1 above ``high``, smooth between; falling where ``low`` is above."""
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)
