"""What all markings share.

A marking is given by its margin: how far inside it a place is, negative outside, in training units.
It is a function of places from the middle of what bears it, and of half of that part's extent.
"""

from collections.abc import Callable, Iterator

import torch
from jaxtyping import Float
from torch import Tensor

Points = Float[Tensor, "p 3"]
Half = Float[Tensor, " 3"]
Margin = Float[Tensor, " p"]
Marks = Callable[[Points, Half], Margin]


def all_of(*margins: Margin) -> Margin:
    """Inside all of them."""
    return torch.stack(margins).amin(0)


def any_of(*margins: Margin) -> Margin:
    """Inside one of them."""
    return torch.stack(margins).amax(0)


def in_front(points: Points) -> Margin:
    """On the half that faces the front, -y."""
    return -points[:, 1]


def within(at: Float[Tensor, "p 2"], corners: Float[Tensor, "c 2"]) -> Margin:
    """Inside a polygon."""
    following = corners.roll(-1, 0)
    (x, y), (u, v), (a, b) = at.T[:, :, None], corners.T, following.T
    crossed = ((v > y) != (b > y)) & (x < (a - u) * (y - v) / (b - v + 1e-12) + u)
    away = -strokes(at, torch.cat([corners, corners[:1]]), 0.0)
    return torch.where(crossed.sum(1) % 2 == 1, away, -away)


def strokes(at: Float[Tensor, "p 2"], places: Float[Tensor, "c 2"], wide: float) -> Margin:
    """Within ``wide`` of a line from place to place."""
    way = places[1:] - places[:-1]
    off = at[:, None] - places[:-1]
    share = ((off * way).sum(2) / (way * way).sum(1).clamp_min(1e-12)).clamp(0, 1)
    return wide - (off - share[..., None] * way).norm(dim=2).amin(1)


def chance(cell: Float[Tensor, "p 3"], which: int) -> Float[Tensor, " p"]:
    """A number in [0, 1) that depends on the cell alone; ``which`` of many."""
    mixed = cell @ cell.new_tensor([12.9898, 78.233, 37.719]) + 4.7 * which
    return (mixed.sin() * 43758.5453).remainder(1)


def cells_around(points: Points, pitch: float) -> Iterator[Float[Tensor, "p 3"]]:
    """The cells of a lattice next to each place's, and its own: 27, one by one."""
    own = (points / pitch).floor()
    for step in torch.cartesian_prod(*[torch.arange(-1, 2)] * 3).to(points):
        yield own + step


def blobs(
    points: Points, _half: Half, pitch: float, sizes: tuple[float, float], share: float
) -> Margin:
    """Round spots scattered about: on a lattice of ``pitch``, moved by up to a third of that, each
    there by chance; the same on every object."""
    margin = torch.full_like(points[:, 0], -pitch)
    for cell in cells_around(points, pitch):
        moved = torch.stack([chance(cell, k) for k in range(3)], 1) - 0.5
        middle = (cell + 0.5 + 0.66 * moved) * pitch
        size = sizes[0] + (sizes[1] - sizes[0]) * chance(cell, 3)
        spot = size - (points - middle).norm(dim=1)
        margin = torch.where(chance(cell, 4) < share, torch.maximum(margin, spot), margin)
    return margin
