"""Patterns that words may ask for, in the object's space: the same in every view.

A pattern takes the part's colour and the second colour (P, 3), sRGB, and gives the painted one.
Lengths are in training units; a pixel of the prior's pictures is 0.034.
"""

from collections.abc import Callable
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor


class Place(NamedTuple):
    """Where on the object."""

    point: Float[Tensor, "p 3"]
    normal: Float[Tensor, "p 3"]


Pattern = Callable[[Tensor, Tensor, Place], Tensor]


def where(mask: Tensor, color: Tensor, other: "Tensor | tuple[float, float, float]") -> Tensor:
    """``other`` (P, 3) or one colour under the mask (P,), ``color`` elsewhere."""
    return torch.where(mask[:, None], torch.as_tensor(other, dtype=color.dtype), color)


def striped(color: Tensor, second: Tensor, place: Place) -> Tensor:
    """Level stripes of six pixels."""
    return where((place.point[:, 2] * (torch.pi / 0.21)).sin() < 0, color, second)


def spotted(color: Tensor, second: Tensor, place: Place) -> Tensor:
    """Balls of the second colour on a body-centred lattice."""
    # Neighbours of the lattice are 0.36 apart, so balls of radius 0.14 do not touch.
    cell = 0.42
    first = place.point / cell
    other = first + 0.5
    far = [((p - p.round()) * cell).norm(dim=1) for p in (first, other)]
    return where(torch.minimum(*far) < 0.14, color, second)


def checkered(color: Tensor, second: Tensor, place: Place) -> Tensor:
    """Cubes of six pixels in turn."""
    # About half a cell off, so that no border lies in a plane of symmetry.
    cell = ((place.point + 0.1) / 0.21).floor().sum(1)
    return where(cell.remainder(2) == 1, color, second)


def two_tone(color: Tensor, second: Tensor, place: Place) -> Tensor:
    """The lower half in the second colour."""
    return where(place.point[:, 2] < 0, color, second)


PATTERNS: dict[str, Pattern] = {
    "striped": striped,
    "spotted": spotted,
    "checkered": checkered,
    "two-tone": two_tone,
}
