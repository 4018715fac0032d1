"""Patterns by words or by nature, in the object's space, so that they are the same in every view.

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

from core.guidance.builtin.words.tables.colors import RAINBOW, Color


class Place(NamedTuple):
    """A place on the object."""

    point: Float[Tensor, "p 3"]
    normal: Float[Tensor, "p 3"]


# The part's colour and the second colour (P, 3), sRGB, and the place: to the painted colour.
Pattern = Callable[[Tensor, Tensor, Place], Tensor]
Margin = Callable[[Float[Tensor, "p 3"]], Float[Tensor, " p"]]
Margins = Callable[[Float[Tensor, "p 3"]], Float[Tensor, "p c"]]  # of each of the colours
STRIPE, CELL, SPOT, CHECK, HOOP = 0.21, 0.42, 0.14, 0.21, 0.62
PLATE, PLATE_LINE = 0.4, 0.022  # across a plate; half the line between two
KEY, KEY_GAP, KEY_SHIFT = 0.105, 0.009, 0.3  # of a keyboard; half a gap; of a key, row by row
COIN, COIN_ROW, COIN_RIM = 0.1, 0.85, 0.014  # radius; of it between rows; of the dark rim
FAINT = 0.15  # of sRGB: largest difference of two colours that are hardly distinct
FEW = 3  # stripes: a lower part is flat, and they follow one another along it
LONG = 1.5  # times its height: least length of a flat part
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
    """Stripes of six pixels that follow one another along the axis: level ones along z."""
    return (points[:, axis] * (math.pi / STRIPE)).sin() * (-STRIPE / math.pi)


def spotted(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """Balls of the second colour on a body-centred lattice."""
    # Neighbours of the lattice are 0.36 apart, so that the balls do not touch.
    first = points / CELL
    far = [((p - p.round()) * CELL).norm(dim=1) for p in (first, first + 0.5)]
    return SPOT - torch.minimum(*far)


def checkered(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """Alternating cubes of six pixels."""
    # About half a cell off, so that no border is in a plane of symmetry.
    place = (points + 0.1) / CHECK
    side = (place - place.round()).abs().amin(1) * CHECK  # to the nearest border
    second = place.floor().sum(1).remainder(2) == 1
    return torch.where(second, side, -side)


def two_tone(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The lower half in the second colour."""
    return -points[:, 2]


def rainbow(points: Float[Tensor, "p 3"], axis: int = 2) -> Float[Tensor, "p 6"]:
    """How far inside each band of a rainbow a place is; the bands repeat along the axis from the
    top down."""
    count = len(RAINBOW_COLORS)
    middles = torch.arange(count).to(points) + 0.5
    away = (-points[:, axis, None] / BAND - middles + count / 2).remainder(count) - count / 2
    return (0.5 - away.abs()) * BAND


def hoops(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The rings of a lighthouse."""
    return (points[:, 2] * (math.tau / HOOP) + 0.6).sin() * (HOOP / math.tau)


def band(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """A band around the middle of a vase."""
    return 0.13 - (points[:, 2] + 0.08).abs()


def collar(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The two rings of a bowling pin."""
    middles = points.new_tensor([0.42, 0.24])
    return 0.05 - (points[:, 2, None] - middles).abs().amin(1)


def crossing(
    points: Float[Tensor, "p 3"], rise: float, lines: float, around: int = 4
) -> Float[Tensor, " p"]:
    """Two sets of lines that cross on a turned solid, such as a wafer's.

    Args:
        rise: their angle in radians per unit of height.
        lines: the cosine from which a place is on one.
        around: the number of lines in each set.
    """
    angle = torch.atan2(points[:, 1], points[:, 0]) * around
    height = points[:, 2] * rise
    nearest = torch.maximum((angle + height).cos(), (angle - height).cos())
    steep = (around / points[:, :2].norm(dim=1).clamp_min(1e-3)).hypot(
        points.new_tensor(float(rise))
    )
    return (nearest - lines) / (steep * math.sqrt(1 - lines**2))


def seams(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The lines of a basketball: two great circles, and a curve at either side."""
    x, _, z = points.abs().unbind(1)
    # Of a ball of radius .9: a round wall, as seen from the front, comes out of it at either side.
    side = (torch.hypot(x - 1.13, z) - 0.64).abs()
    return 0.03 - torch.minimum(side, torch.minimum(x, z))


def plates(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The lines between the plates of a turtle's shell: hexagons, seen from above, with a row along
    its back."""
    flat, pitch = points[:, :2], points.new_tensor([math.sqrt(3) * PLATE, PLATE])
    at = torch.stack([flat, flat + pitch / 2]) / pitch
    away = ((at - at.round()) * pitch).abs()  # of the two lattices that make the hexagons' middles
    x, y = away.unbind(2)
    side = PLATE / 2 - torch.maximum(y, x * math.sqrt(3) / 2 + y / 2).amin(0)
    return PLATE_LINE - side


def keys(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The gaps between the keys of a level keyboard: rows along x, each shifted a little."""
    across, row = points[:, 0] / KEY, points[:, 1] / KEY
    across = across + KEY_SHIFT * row.floor()
    side = torch.stack([across - across.round(), row - row.round()]).abs().amin(0) * KEY
    return KEY_GAP - side


def coins(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """The rims of coins in a heap, in rows across it from the front over its top to the back, each
    row on the one behind."""
    across, along = points[:, 0] / COIN, (points[:, 1] + points[:, 2]) / COIN
    within = torch.full_like(across, -1.0)  # how far inside the coin on top
    outside = torch.full_like(across, 1.0)  # and from the nearest coin on it
    front = ((along - 1) / COIN_ROW).ceil() - 1
    for row in (front, front + 1, front + 2, front + 3):
        aside = (across - COIN_ROW * row.remainder(2)) / (2 * COIN_ROW)
        aside = (aside - aside.round()) * 2 * COIN_ROW
        inside = 1 - torch.hypot(aside, along - COIN_ROW * row)
        outside = torch.where(within < 0, outside.minimum(inside.abs()), outside)
        within = torch.where(within < 0, inside, within)
    rim = COIN_RIM - within * COIN
    return torch.where(rim > 0, rim.minimum(within * COIN), rim.maximum(-outside * COIN))


MARGINS: dict[str, Margin] = {
    "striped": striped,
    "spotted": spotted,
    "checkered": checkered,
    "two-tone": two_tone,
}


class Natural(NamedTuple):
    """A pattern of two colours that parts have by nature, unless words state another."""

    margin: Margin
    second: Color | float  # or what the part's own colour is multiplied by


NATURAL: dict[str, Natural] = {
    "hoops": Natural(hoops, (0.76, 0.14, 0.12)),
    "band": Natural(band, (0.94, 0.93, 0.90)),
    "collar": Natural(collar, (0.76, 0.10, 0.10)),
    "dots": Natural(spotted, (0.95, 0.93, 0.88)),  # of a mushroom
    "scales": Natural(partial(crossing, rise=17, lines=0.87, around=8), 0.6),  # a pineapple's
    "waffle": Natural(partial(crossing, rise=14, lines=0.75), 0.65),
    "plates": Natural(plates, 0.5),  # a turtle's
    "seams": Natural(seams, (0.13, 0.10, 0.09)),  # a basketball's
    "keys": Natural(keys, (0.52, 0.54, 0.57)),  # the gaps between a keyboard's
    "coins": Natural(coins, 0.4),
}
# Natural patterns that belong to the thing's form and stay with any colour and material, unless
# another pattern is stated.
LINES = ("scales", "waffle", "plates", "seams", "keys", "coins")
MARGINS |= {name: natural.margin for name, natural in NATURAL.items()}


def natural_second(pattern: str, color: Color) -> Color | None:
    """The second colour of a natural pattern; None for any other pattern, and where it hardly
    differs from the part's own."""
    if pattern not in NATURAL:
        return None
    second = NATURAL[pattern].second
    if isinstance(second, float):
        red, green, blue = (second * x for x in color)
        return red, green, blue
    faint = max(abs(a - b) for a, b in zip(second, color, strict=True)) < FAINT
    return None if faint else second


class Laid(NamedTuple):
    """A pattern on one part; none without a name."""

    name: str = ""
    axis: int = 2  # along which stripes follow one another

    @property
    def colors(self) -> int:
        """The number of colours; 1 for a learnt pattern."""
        return len(RAINBOW_COLORS) if self.name == RAINBOW else 1 + (self.name in MARGINS)

    def margins(self) -> Margins | None:
        """How far inside each colour a place is; None with one colour."""
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
    """The axis along which stripes follow one another on a part of this extent: upwards, or on a
    flat part, such as an awning, a rug or a seat, along its longer side."""
    x, y, z = extent
    if z < FEW * STRIPE and max(x, y) > LONG * z:
        return 0 if x >= y else 1
    return 2


def painter(margin: Margin) -> Pattern:
    """The pattern of a margin."""
    return lambda color, second, place: where(margin(place.point) > 0, color, second)


PATTERNS: dict[str, Pattern] = {name: painter(margin) for name, margin in MARGINS.items()}
