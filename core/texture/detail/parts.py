"""The substance of each point: by its area, or, where the areas are not known, by its
colour, which is compared with what the parts were painted."""

from typing import NamedTuple, Protocol, runtime_checkable

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.guidance import Surface
from core.ops import lab, srgb_to_linear

# CIELAB. Parts nearer to each other in colour cannot be distinguished: both get the first's detail.
APART = 12.0
SPREAD = 6.0  # how fast a part's weight falls with the distance of the colour beyond the nearest's
ROUNDS = 3  # of moving each colour to the mean of the points that are nearest to it
KEPT = 0.3  # of a part's stated colour, so that it is not drawn away to another part's


@runtime_checkable
class Parts(Protocol):
    """The kinds of an object's surface, and where they are."""

    surfaces: tuple[Surface, ...]

    def weights(
        self, kd: Float[Tensor, "n 3"], area: Int[Tensor, " n"] | None
    ) -> Float[Tensor, "n k"]:
        """How much each surface is what is at points of the learnt colour ``kd`` (linear); a
        point's weights add up to 1."""
        ...


class ByArea(NamedTuple):
    """Each area has its surface."""

    surfaces: tuple[Surface, ...]

    def weights(
        self, kd: Float[Tensor, "n 3"], area: Int[Tensor, " n"] | None
    ) -> Float[Tensor, "n k"]:
        """See :class:`Parts`."""
        assert area is not None
        return torch.nn.functional.one_hot(area, len(self.surfaces)).to(kd)


class ByColor(NamedTuple):
    """Each surface is where the colour is the most like its own."""

    surfaces: tuple[Surface, ...]
    colors: Float[Tensor, "k 3"]  # CIELAB

    @classmethod
    def of(cls, surfaces: tuple[Surface, ...], kd: Float[Tensor, "n 3"]) -> "ByColor":
        """``kd``: linear, at points evenly over the surface."""
        stated = lab(srgb_to_linear(torch.tensor([s.color for s in surfaces])))
        kept = [
            i for i in range(len(surfaces)) if not i or _distance(stated[i], stated[:i]) > APART
        ]
        stated, colors, seen = stated[kept], stated[kept], lab(kd)
        for _ in range(ROUNDS):
            nearest = torch.cdist(seen, colors).argmin(1)
            count = torch.bincount(nearest, minlength=len(kept))[:, None]
            total = torch.zeros_like(colors).index_add_(0, nearest, seen)
            mean = KEPT * stated + (1 - KEPT) * total / count.clamp(min=1)
            colors = torch.where(count > 0, mean, stated)
        return cls(tuple(surfaces[i] for i in kept), colors)

    def weights(
        self, kd: Float[Tensor, "n 3"], area: Int[Tensor, " n"] | None
    ) -> Float[Tensor, "n k"]:
        """See :class:`Parts`."""
        del area
        distance = torch.cdist(lab(kd), self.colors)
        return torch.softmax(-distance / SPREAD * 2, 1)


def _distance(color: Float[Tensor, "3"], others: Float[Tensor, "k 3"]) -> float:
    return float((others - color).norm(dim=1).min())
