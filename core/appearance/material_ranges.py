"""Bounds of roughness, metallic and colour: of the whole object, or of each place."""

from collections.abc import Sequence
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from core.geometry.tet_grid import EXTENT

Color = tuple[float, float, float]  # linear Rec.709


class MaterialRanges(NamedTuple):
    """Bounds within which the appearance training looks for a material."""

    roughness: tuple[float, float]
    metallic: tuple[float, float]
    color: tuple[Color, Color] | None = None  # least and greatest kd; None: the config's


class RangesHere(NamedTuple):
    """The bounds at N points, each the least and the greatest."""

    roughness: tuple[Float[Tensor, "n 1"], Float[Tensor, "n 1"]]
    metallic: tuple[Float[Tensor, "n 1"], Float[Tensor, "n 1"]]
    color: tuple[Float[Tensor, "n 3"], Float[Tensor, "n 3"]]


class LocalRanges(nn.Module):
    """Each area's own ranges, by the area of the nearest node of a lattice over the cube."""

    areas: Tensor
    bounds: Tensor

    def __init__(
        self,
        areas: Int[Tensor, "k k k"],
        ranges: Sequence[MaterialRanges],
        color: tuple[float, float],
    ) -> None:
        """``areas``: of each node, by x, y and z, an index into ``ranges``; ``color``: the bounds
        of all kd, and of what has none of its own."""
        super().__init__()
        grey = ([color[0]] * 3, [color[1]] * 3)
        colors = [one.color or grey for one in ranges]
        rows = [
            (*one.roughness, *one.metallic, *least, *most)
            for one, (least, most) in zip(ranges, colors, strict=True)
        ]
        bounds = torch.tensor(rows)
        bounds[:, 4:].clamp_(*color)
        # Of the prompt and not learnt: not in the checkpoints.
        self.register_buffer("areas", areas, persistent=False)
        self.register_buffer("bounds", bounds, persistent=False)

    def forward(
        self, points: Float[Tensor, "n 3"], area: Int[Tensor, " n"] | None = None
    ) -> RangesHere:
        """The ranges at ``points``, training units; ``area`` where it is known."""
        if area is None:
            last = len(self.areas) - 1
            at = ((points / EXTENT + 1) * (last / 2)).round().long().clamp(0, last)
            area = self.areas[at[:, 0], at[:, 1], at[:, 2]]
        a, b, c, d, low, high = self.bounds[area].split([1, 1, 1, 1, 3, 3], 1)
        return RangesHere((a, b), (c, d), (low, high))
