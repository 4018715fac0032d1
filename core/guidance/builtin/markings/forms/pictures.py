"""What pictures, screens and cassettes show."""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of


def hills(points: Points, half: Half) -> Margin:
    """A painting's, from its lower edge to a line of peaks and slopes."""
    x = points[:, 0] / half[0]
    high = -0.2 + 0.26 * (3.4 * x + 2.3).cos() + 0.13 * (6.1 * x - 0.4).sin()
    return (0.85 * (high * half[2] - points[:, 2])).clamp(-1, 1)


def sun(points: Points, half: Half) -> Margin:
    """A painting's, at the upper right."""
    size = 0.22 * torch.minimum(half[0], half[2])
    at = torch.stack([points[:, 0] - 0.5 * half[0], points[:, 2] - 0.55 * half[2]], 1)
    return size - at.norm(dim=1)


def glare(points: Points, half: Half, at: float = -0.35) -> Margin:
    """Two slanted bands of light on a screen, a broad one and a narrow one, the middle of both so
    far aside in halves of its width."""
    wide = torch.minimum(half[0], half[2])
    along = (points[:, 0] - at * half[0] - 0.55 * points[:, 2]) / 1.141
    bands = any_of(0.17 * wide - along.abs(), 0.055 * wide - (along - 0.32 * wide).abs())
    return all_of(bands, 0.86 * half[2] - points[:, 2].abs(), 0.9 * half[0] - points[:, 0].abs())


def reels(points: Points, half: Half) -> Margin:
    """A cassette's two, with three teeth each."""
    size = 0.15 * half[0]
    place = torch.stack([points[:, 0].abs() - 0.38 * half[0], points[:, 2] - 0.1 * half[2]], 1)
    place = place / size
    away, angle = place.norm(dim=1), torch.atan2(place[:, 1], place[:, 0])
    turn = angle * (6 / math.tau)
    tooth = 0.13 - (turn - turn.round()).abs() * (math.tau / 6) * away
    hub = torch.minimum(1 - away, away - 0.66)
    return any_of(hub, all_of(tooth, away - 0.42, 1 - away)) * size
