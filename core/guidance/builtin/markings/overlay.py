"""An area that is drawn over others: a lid over an eye, a colour of a picture."""

from collections.abc import Callable
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import Margin
from core.guidance.builtin.palette import Painted


class Overlay(NamedTuple):
    """A painted area over some of the areas before it."""

    margin: Callable[[Float[Tensor, "n 3"]], Margin]
    over: tuple[int, ...]  # the areas below
    on: int  # the part below
    paint: Painted

    def __call__(
        self, distances: Float[Tensor, "n p"], points: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n q"]:
        """The areas' distances, and its own as the last."""
        margin, found = self.margin(points), distances.clone()
        below = found[:, self.over]
        found[:, self.over] = torch.maximum(below, margin[:, None])
        return torch.cat([found, torch.maximum(below.amin(1), -margin)[:, None]], 1)
