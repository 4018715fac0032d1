"""Landscapes of pictures, glare and icons of screens, reels of cassettes."""

import math

import torch

from core.guidance.builtin.markings.margins import Half, Margin, Points, all_of, any_of, in_front


def hills(points: Points, half: Half) -> Margin:
    """Hills of a painting, from its lower edge to a line of peaks and slopes."""
    x = points[:, 0] / half[0]
    high = -0.2 + 0.26 * (3.4 * x + 2.3).cos() + 0.13 * (6.1 * x - 0.4).sin()
    return (0.85 * (high * half[2] - points[:, 2])).clamp(-1, 1)


def sun(points: Points, half: Half) -> Margin:
    """The sun at the upper right of a painting."""
    size = 0.22 * torch.minimum(half[0], half[2])
    at = torch.stack([points[:, 0] - 0.5 * half[0], points[:, 2] - 0.55 * half[2]], 1)
    return size - at.norm(dim=1)


def glare(points: Points, half: Half, at: float = -0.35) -> Margin:
    """Two slanted bands of light on a screen, a broad one and a narrow one; ``at``: their middle to
    the side in halves of the width."""
    wide = torch.minimum(half[0], half[2])
    along = (points[:, 0] - at * half[0] - 0.55 * points[:, 2]) / 1.141
    bands = any_of(0.17 * wide - along.abs(), 0.055 * wide - (along - 0.32 * wide).abs())
    return all_of(bands, 0.86 * half[2] - points[:, 2].abs(), 0.9 * half[0] - points[:, 0].abs())


def reels(points: Points, half: Half) -> Margin:
    """The two reels of a cassette, with three teeth each."""
    size = 0.15 * half[0]
    place = torch.stack([points[:, 0].abs() - 0.38 * half[0], points[:, 2] - 0.1 * half[2]], 1)
    place = place / size
    away, angle = place.norm(dim=1), torch.atan2(place[:, 1], place[:, 0])
    turn = angle * (6 / math.tau)
    tooth = 0.13 - (turn - turn.round()).abs() * (math.tau / 6) * away
    hub = torch.minimum(1 - away, away - 0.66)
    return any_of(hub, all_of(tooth, away - 0.42, 1 - away)) * size


def icons(points: Points, half: Half, columns: int = 4) -> Margin:
    """Rows of squares on the upper part of a phone's front, and one row below."""
    x, z = points[:, 0], points[:, 2]
    pitch = 1.76 * half[0] / columns
    at = torch.stack([x / pitch + columns / 2, (0.84 * half[2] - z) / pitch], 1)
    below = torch.stack([at[:, 0], (-0.7 * half[2] - z) / pitch], 1)
    rows = max(int(1.15 * float(half[2]) / float(pitch)), 1)
    both = []
    for place, count in ((at, rows), (below, 1)):
        cell = place.floor()
        square = 0.32 - (place - cell - 0.5).abs().amax(1)
        there = (cell >= 0).all(1) & (cell[:, 0] < columns) & (cell[:, 1] < count)
        both.append(torch.where(there, square, -0.18).mul(pitch))
    return all_of(any_of(*both), in_front(points))
