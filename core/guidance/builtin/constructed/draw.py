"""Random proportions of a constructed thing, by the object's seed."""

import numpy as np


class Draw:
    """Random numbers from one generator."""

    def __init__(self, seed: int) -> None:
        self._generator = np.random.default_rng(seed)

    def __call__(self, low: float, high: float) -> float:
        """Uniform in [low, high)."""
        return float(self._generator.uniform(low, high))

    def chance(self, probability: float) -> bool:
        """True with this probability."""
        return bool(self._generator.random() < probability)

    def which(self, count: int) -> int:
        """One of ``count`` variants, from 0."""
        return int(self._generator.integers(count))
