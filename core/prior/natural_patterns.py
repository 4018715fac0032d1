"""Patterns that parts have by nature, or by a material word: the training pictures show them.

As those that words ask for (``core.guidance.builtin.patterns``), in the object's space or on its
normals; lengths are in training units.
"""

import torch
from torch import Tensor

from core.guidance.builtin.patterns import PATTERNS, Pattern, Place, where

CREAM = (0.94, 0.93, 0.90)


def grain(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """Wood: dark veins along the height, and across level boards."""
    x, y, z = place.point.unbind(1)
    veins = (19 * x + 7 * y + 1.5 * (3 * z + 2 * y).sin()).sin()
    return color * (1 + 0.17 * veins)[:, None]


def mottle(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """Stone and leather: soft blotches."""
    x, y, z = place.point.unbind(1)
    blotch = (11 * x + 2 * (7 * y).sin()).sin() * (12 * z + 2 * (8 * x).sin()).sin()
    return color * (1 + 0.2 * blotch * (10 * y + 1).cos())[:, None]


def rust(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """Rust: flakes of a brighter orange and of a darker brown."""
    x, y, z = place.point.unbind(1)
    flake = (9 * x + 3 * (5 * z).sin()).sin() + (8 * z + 3 * (6 * y).sin()).sin()
    bright = color * color.new_tensor([1.5, 1.4, 1.1])
    return torch.where((flake > 0.5)[:, None], bright, color * (1 - 0.25 * (flake < -0.7))[:, None])


def icing(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A doughnut's pink upper side, with a wavy edge."""
    angle = torch.atan2(place.point[:, 1], place.point[:, 0])
    return where(place.normal[:, 2] > 0.12 + 0.22 * (6 * angle).sin(), color, (0.95, 0.55, 0.70))


def band(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A light band about the middle."""
    return where((place.point[:, 2] + 0.08).abs() < 0.13, color, CREAM)


def hoops(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A lighthouse's red rings."""
    rings = (place.point[:, 2] * (2 * torch.pi / 0.62) + 0.6).sin() > 0
    return where(rings, color, (0.76, 0.14, 0.12))


def collar(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A bowling pin's two red rings."""
    z = place.point[:, 2]
    rings = ((z - 0.42).abs() < 0.05) | ((z - 0.24).abs() < 0.05)
    return where(rings, color, (0.76, 0.10, 0.10))


def dots(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """White spots where the normal points to one of a few directions; none below."""
    turns = torch.arange(6) * (torch.pi / 3)
    low = torch.stack([turns.cos() * 0.8, turns.sin() * 0.8, torch.full((6,), 0.6)], 1)
    axes = torch.cat([torch.tensor([[0.0, 0.0, 1.0]]), low]).to(color)
    return where((place.normal @ axes.T).amax(1) > 0.965, color, (0.95, 0.93, 0.88))


def _lattice(place: Place, turns: int, rise: float) -> Tensor:
    """How near a point of a turned solid is to two crossing sets of lines: 1 on a line."""
    angle = torch.atan2(place.point[:, 1], place.point[:, 0]) * turns
    height = place.point[:, 2] * rise
    return torch.maximum((angle + height).cos(), (angle - height).cos())


def scales(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A pineapple's: darker crossing lines."""
    return color * (1 - 0.4 * (_lattice(place, 4, 10) > 0.8))[:, None]


def waffle(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A wafer's: darker crossing lines."""
    return color * (1 - 0.35 * (_lattice(place, 4, 14) > 0.75))[:, None]


def plates(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """A turtle's shell: lines between its plates."""
    x, y, _ = (place.normal * 4.2).unbind(1)
    lines = torch.maximum((1.5 * x).cos().abs(), (1.5 * y + 0.8 * x).cos().abs())
    return color * (1.15 - 0.5 * (lines > 0.9))[:, None]


def spines(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """Books: upright strips of several colours."""
    strip = (place.point[:, 0] / 0.1).floor()
    row = (place.point[:, 2] / 0.4).floor()
    books = [[0.70, 0.20, 0.17], [0.16, 0.36, 0.58], [0.85, 0.66, 0.22], [0.22, 0.46, 0.28]]
    which = (strip + 2 * row).remainder(4).long()
    return color.new_tensor(books)[which] * (color.mean(1, keepdim=True) / 0.36)


def thatch(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """Straw, in layers."""
    layer = (place.point[:, 2] * 32).sin()
    return color * (1 + 0.18 * layer)[:, None]


def bricks(color: Tensor, _: Tensor, place: Place) -> Tensor:
    """Courses of masonry, every other one darker, with joints."""
    x, y, z = place.point.unbind(1)
    course = (z / 0.16).floor()
    stone = ((x + y) / 0.3 + 0.5 * course).floor()
    shade = ((course * 3 + stone * 5).remainder(4) - 1.5) * 0.09
    return color * (1 + shade)[:, None]


ALL_PATTERNS: dict[str, Pattern] = {
    **PATTERNS,
    "grain": grain,
    "mottle": mottle,
    "rust": rust,
    "icing": icing,
    "band": band,
    "hoops": hoops,
    "collar": collar,
    "dots": dots,
    "scales": scales,
    "waffle": waffle,
    "plates": plates,
    "spines": spines,
    "thatch": thatch,
    "bricks": bricks,
}
