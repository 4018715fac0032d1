"""Edges of paper, cards that are alike from both ends, and numbers of lockers."""

from collections.abc import Sequence

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of
from core.guidance.builtin.markings.outlines import Emblem, Outline, laid


def burnt_edges(points: Points, half: Half, wide: float = 0.055) -> Margin:
    """Of old paper that looks to the front: wavy, on all of its sides."""
    x, z = points[:, 0], points[:, 2]
    away = torch.minimum(half[0] - x.abs(), half[2] - z.abs())
    along = x + z
    wave = (9 * along).sin() + 0.7 * (23 * along + 1).sin() + 0.5 * (14 * (x - z)).sin()
    return 0.9 * (wide + 0.3 * wide * wave - away)


def both_ways(
    points: Points, half: Half, front: Sequence[Outline], once: Sequence[Outline] = ()
) -> Margin:
    """Outlines on a front, and the same upside down; and some as they are."""
    turned = points * points.new_tensor([-1.0, 1.0, -1.0])
    found = any_of(laid(points, half, front=front), laid(turned, half, front=front))
    return any_of(found, laid(points, half, front=once)) if once else found


def page_edges(points: Points, half: Half) -> Margin:
    """What is seen of the pages between two covers, on all sides but the left."""
    x, y, z = points.unbind(1)
    ends = any_of(x - 0.95 * half[0], z.abs() - 0.97 * half[2])
    return all_of(0.6 * half[1] - y.abs(), ends, x + 0.88 * half[0])


def locker_numbers(points: Points, half: Half, text: str = "12") -> Margin:
    """On both doors, by the body's box."""
    numbers = tuple(Emblem((side, 0.3), 0.075, text=text) for side in (-0.5, 0.5))
    return laid(points, half, front=numbers, deep=0.8)
