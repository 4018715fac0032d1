"""Patterns that words may ask for, in the object's space: the same in every view.

Most have two colours, and are given by their margin: how far inside the second colour a place is,
about in training units, negative in the first. A pixel of the prior's pictures is 0.034.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.colors import RAINBOW


class Place(NamedTuple):
    """Where on the object."""

    point: Float[Tensor, "p 3"]
    normal: Float[Tensor, "p 3"]


# The part's colour and the second colour (P, 3), sRGB, and where: to what is painted.
Pattern = Callable[[Tensor, Tensor, Place], Tensor]
Margin = Callable[[Float[Tensor, "p 3"]], Float[Tensor, " p"]]
Margins = Callable[[Float[Tensor, "p 3"]], Float[Tensor, "p c"]]  # of each of the colours
STRIPE, CELL, SPOT, CHECK = 0.21, 0.42, 0.14, 0.21
FEW = 3  # stripes, of which a part that is flatter lies: they follow one another along it
LONG = 1.5  # times its height, what lies is at least
ALONG = frozenset(("striped", RAINBOW))  # patterns whose colours follow one another
BAND = 0.15  # of a rainbow
RAINBOW_COLORS = (
    *((0.86, 0.10, 0.12), (0.95, 0.47, 0.07), (0.97, 0.83, 0.12)),
    *((0.20, 0.68, 0.25), (0.12, 0.38, 0.82), (0.50, 0.20, 0.66)),
)


def where(mask: Tensor, color: Tensor, other: "Tensor | tuple[float, float, float]") -> Tensor:
    """``other`` (P, 3) or one colour under the mask (P,), ``color`` elsewhere."""
    return torch.where(mask[:, None], torch.as_tensor(other, dtype=color.dtype), color)


def striped(points: Float[Tensor, "p 3"], axis: int = 2) -> Float[Tensor, " p"]:
    """Stripes of six pixels, which follow one another along the axis: level ones of z."""
    return (points[:, axis] * (math.pi / STRIPE)).sin() * (-STRIPE / math.pi)


def spotted(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """Balls of the second colour on a body-centred lattice."""
    # Neighbours of the lattice are 0.36 apart, so that the balls do not touch.
    first = points / CELL
    far = [((p - p.round()) * CELL).norm(dim=1) for p in (first, first + 0.5)]
    return SPOT - torch.minimum(*far)


def checkered(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """Cubes of six pixels in turn."""
    # About half a cell off, so that no border lies in a plane of symmetry.
    place = (points + 0.1) / CHECK
    side = (place - place.round()).abs().amin(1) * CHECK  # to the nearest border
    second = place.floor().sum(1).remainder(2) == 1
    return torch.where(second, side, -side)


def two_tone(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The lower half in the second colour."""
    return -points[:, 2]


def rainbow(points: Float[Tensor, "p 3"], axis: int = 2) -> Float[Tensor, "p 6"]:
    """How far inside each band of a rainbow: they follow one another along the axis, over and over,
    from the top down."""
    count = len(RAINBOW_COLORS)
    middles = torch.arange(count).to(points) + 0.5
    away = (-points[:, axis, None] / BAND - middles + count / 2).remainder(count) - count / 2
    return (0.5 - away.abs()) * BAND


MARGINS: dict[str, Margin] = {
    "striped": striped,
    "spotted": spotted,
    "checkered": checkered,
    "two-tone": two_tone,
}


class Laid(NamedTuple):
    """A pattern as it is laid on one part; without a name none."""

    name: str = ""
    axis: int = 2  # that stripes follow one another along

    @property
    def colors(self) -> int:
        """How many; one of what the words cannot ask for."""
        return len(RAINBOW_COLORS) if self.name == RAINBOW else 1 + (self.name in MARGINS)

    def margins(self) -> Margins | None:
        """How far inside each colour a place is; None of one colour."""
        if self.name == RAINBOW:
            return partial(rainbow, axis=self.axis)
        margin = MARGINS.get(self.name)
        if self.name == "striped":
            margin = partial(striped, axis=self.axis)
        return margin and partial(_of_two, margin)


def _of_two(margin: Margin, points: Float[Tensor, "p 3"]) -> Float[Tensor, "p 2"]:
    second = margin(points)
    return torch.stack([-second, second], 1)


def axis_of(extent: "Sequence[float] | np.ndarray") -> int:
    """The axis that stripes follow one another along on a part of this extent: upwards, or where it
    lies, as an awning, a rug or a seat, along the longer of its sides."""
    x, y, z = extent
    if z < FEW * STRIPE and max(x, y) > LONG * z:
        return 0 if x >= y else 1
    return 2


def painter(margin: Margin) -> Pattern:
    """The pattern that a margin stands for."""
    return lambda color, second, place: where(margin(place.point) > 0, color, second)


PATTERNS: dict[str, Pattern] = {name: painter(margin) for name, margin in MARGINS.items()}
