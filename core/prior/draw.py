"""Random numbers for the families' proportions."""

import torch

from core.guidance.builtin.words import LEGS


class Draw:
    """Random numbers for proportions, from one generator; ``said`` is a word of ``PARTS`` or ""."""

    def __init__(self, generator: torch.Generator, said: str = "", adjective: str = "") -> None:
        self.generator, self.said, self.adjective = generator, said, adjective

    def __call__(self, low: float, high: float) -> float:
        """Uniform in [low, high)."""
        return low + (high - low) * torch.rand(1, generator=self.generator).item()

    def chance(self, probability: float) -> bool:
        """True with this probability."""
        return self(0, 1) < probability

    def has(self, part: str, probability: float) -> bool:
        """Whether the thing has ``part``: as it was said, or by chance."""
        by_chance = self.chance(probability)
        return by_chance if self.said not in (part, f"no {part}") else self.said == part

    def legs(self, *counts: int) -> int:
        """How many legs: as it was said, or one of ``counts`` by chance."""
        by_chance = counts[int(self(0, len(counts)))]
        return LEGS.get(self.said, by_chance)
