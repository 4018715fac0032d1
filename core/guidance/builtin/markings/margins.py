"""What all markings share: types, and the margins of simple forms.

A marking is given by its margin: how far inside it a place is, negative outside, in training units.
It is a function of places from the middle of the part with the marking, and of half that part's
extent.
"""

from collections.abc import Callable, Sequence

import torch
from jaxtyping import Float
from torch import Tensor

Points = Float[Tensor, "p 3"]
Half = Float[Tensor, " 3"]
Margin = Float[Tensor, " p"]
Pair = tuple[float, float]
Spans = Sequence[Pair]
Way = tuple[float, float, float]
UP = (0.0, 0.0, 1.0)
Marks = Callable[[Points, Half], Margin]


def all_of(*margins: Margin) -> Margin:
    """The intersection of markings."""
    return torch.stack(margins).amin(0)


def any_of(*margins: Margin) -> Margin:
    """The union of markings."""
    return torch.stack(margins).amax(0)


def in_front(points: Points) -> Margin:
    """The half that faces the front, -y."""
    return -points[:, 1]


def within(at: Float[Tensor, "p 2"], corners: Float[Tensor, "c 2"]) -> Margin:
    """The inside of a polygon."""
    following = corners.roll(-1, 0)
    (x, y), (u, v), (a, b) = at.T[:, :, None], corners.T, following.T
    crossed = ((v > y) != (b > y)) & (x < (a - u) * (y - v) / (b - v + 1e-12) + u)
    away = -strokes(at, torch.cat([corners, corners[:1]]), 0.0)
    return torch.where(crossed.sum(1) % 2 == 1, away, -away)


def strokes(at: Float[Tensor, "p 2"], places: Float[Tensor, "c 2"], wide: float) -> Margin:
    """Places within ``wide`` of a line from place to place."""
    way = places[1:] - places[:-1]
    off = at[:, None] - places[:-1]
    fraction = ((off * way).sum(2) / (way * way).sum(1).clamp_min(1e-12)).clamp(0, 1)
    return wide - (off - fraction[..., None] * way).norm(dim=2).amin(1)


def unit(points: Points, way: Way) -> Tensor:
    """A direction of length 1."""
    found = points.new_tensor(way)
    return found / found.norm()
