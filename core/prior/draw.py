"""Random numbers for the families, and what a caption says of an object's parts."""

import torch

# Parts that a thing may have or lack, as a caption may say; "no hat" is told like "hat". Of the
# legs a caption says how many.
CHOICES = ("armrests", "backrest", "handle", "cap", "hat", "chimney")
LEGS = {"one leg": 1, "three legs": 3, "four legs": 4}
PARTS = (*(said for choice in CHOICES for said in (choice, f"no {choice}")), *LEGS)
# What a caption may say of each noun's parts.
OPTIONS: dict[str, tuple[str, ...]] = {
    "chair": ("armrests", "no armrests"),
    "table": ("one leg", "four legs"),
    "stool": ("one leg", "three legs", "four legs"),
    "bench": ("backrest", "no backrest"),
    "mug": ("handle", "no handle"),
    "bucket": ("handle", "no handle"),
    "candle": ("handle", "no handle"),
    "bottle": ("cap", "no cap"),
    "snowman": ("hat", "no hat"),
    "house": ("chimney", "no chimney"),
    "cottage": ("chimney", "no chimney"),
}


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
