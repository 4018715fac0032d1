"""Random numbers for the families' proportions."""

import torch

from core.guidance.builtin.words.tables.part_tables import LEGS


class Draw:
    """Random numbers for proportions, from one generator; ``part_state`` is one of ``PARTS`` or "".

    ``choices``: the outcomes that were drawn from a few; they distinguish a family's objects.
    """

    def __init__(
        self, generator: torch.Generator, part_state: str = "", adjective: str = ""
    ) -> None:
        self.generator, self.part_state, self.adjective = generator, part_state, adjective
        self.choices: list[int] = []

    def formed(self, adjective: str) -> "Draw":
        """The same draw for an object with this adjective; both share one list of choices."""
        own = Draw(self.generator, self.part_state, adjective)
        own.choices = self.choices
        return own

    def __call__(self, low: float, high: float) -> float:
        """Uniform in [low, high)."""
        return low + (high - low) * torch.rand(1, generator=self.generator).item()

    def chance(self, probability: float) -> bool:
        """True with this probability."""
        return bool(self._chosen(self(0, 1) < probability))

    def which(self, count: int) -> int:
        """One of ``count`` variants, from 0."""
        return self._chosen(int(self(0, count)))

    def arranged(self, count: int = 3) -> "Draw":
        """One of ``count`` draws that are the same in every object, for an arrangement such as the
        tufts of a bush: if each object had its own, a network would learn their mean, a lump."""
        return Draw(torch.Generator().manual_seed(self.which(count)))

    def has(self, part: str, probability: float) -> bool:
        """Whether the object has ``part``: as the caption states, or by chance."""
        # Drawn in any case: the draws that follow do not depend on the caption.
        by_chance = self(0, 1) < probability
        stated = self.part_state in (part, f"no {part}")
        return bool(self._chosen(self.part_state == part if stated else by_chance))

    def shaped(self, adjective: str, probability: float) -> bool:
        """Whether the object has this form: as the caption states, or by chance."""
        by_chance = self(0, 1) < probability
        return bool(self._chosen(by_chance or self.adjective == adjective))

    def legs(self, *counts: int) -> int:
        """How many legs: as the caption states, or one of ``counts`` by chance."""
        by_chance = counts[int(self(0, len(counts)))]
        return self._chosen(LEGS.get(self.part_state, by_chance))

    def _chosen(self, choice: int) -> int:
        self.choices.append(int(choice))
        return choice
