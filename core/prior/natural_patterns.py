"""Patterns of materials and of nature in one colour, for the training pictures.

Like the patterns of two colours (``core.guidance.builtin.patterns``) they are in the object's space
or on its normals; lengths are in training units.
"""

import torch
from torch import Tensor

from core.guidance.builtin.patterns import PATTERNS, Pattern, Place


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
    "spines": spines,
    "thatch": thatch,
    "bricks": bricks,
}
