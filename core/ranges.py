"""The range of a setting, next to its type: ``steps: Annotated[int, Range(0, 100)]``.

Standard library only, and nothing of the core: every part may declare its settings with it.
"""

import math
from dataclasses import dataclass
from typing import Annotated, Any, get_args, get_origin


@dataclass(frozen=True)
class Range:
    """The numbers that a setting takes, both ends among them; of a tuple, each of its numbers."""

    low: float
    high: float
    rising: bool = False  # of a tuple: each number is at least the one before

    def allows(self, value: Any) -> bool:
        """Whether ``value`` is in range; infinities and NaN never are."""
        numbers = value if isinstance(value, tuple) else (value,)
        # No math.isfinite, which takes no integer beyond a float's range. False for NaN too.
        if not all(self.low <= n <= self.high for n in numbers):
            return False
        return not self.rising or list(numbers) == sorted(numbers)

    def __str__(self) -> str:
        return f"{_short(self.low)} to {_short(self.high)}{', rising' if self.rising else ''}"


class Squares(Range):
    """The square numbers among these, for layouts in rows and columns."""

    def allows(self, value: Any) -> bool:
        return super().allows(value) and math.isqrt(value) ** 2 == value

    def __str__(self) -> str:
        return f"a square number from {super().__str__()}"


def _short(number: float) -> str:
    return str(number) if isinstance(number, int) else f"{number:g}"


def range_of(kind: Any) -> Range | None:
    """The range in a field's type; None where it has none, such as a choice of words."""
    if get_origin(kind) is not Annotated:
        return None
    return next((extra for extra in get_args(kind)[1:] if isinstance(extra, Range)), None)


Pair = tuple[float, float]
Steps = Annotated[int, Range(0, 1_000_000)]  # or rounds; 0 leaves the phase out
Count = Annotated[int, Range(1, 100_000)]
Pixels = Annotated[int, Range(8, 2048)]  # side of a picture of a training
Fraction = Annotated[float, Range(0, 1)]
Fractions = Annotated[Pair, Range(0, 1)]  # at the first and at the last step
Interval = Annotated[Pair, Range(0, 1, rising=True)]
Rate = Annotated[float, Range(1e-9, 1)]  # of learning
Weight = Annotated[float, Range(0, 1e6)]  # of a term of the loss; 0 is off
Scale = Annotated[float, Range(0, 1000)]  # of classifier-free guidance
