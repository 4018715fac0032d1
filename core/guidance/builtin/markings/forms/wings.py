"""Wing cases, and the cells and dots of wings."""

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    strokes,
    within,
)

Outline = tuple[tuple[float, float], ...]
# Of a butterfly's right wings, in their width and halves of their length: outlines, veins and dots.
FORE: Outline = ((0.0, -0.1), (0.2, -0.5), (0.4, -0.78), (0.62, -0.94), (0.84, -1.0), (0.97, -0.92),
              (1.0, -0.76), (0.95, -0.42), (0.85, -0.1), (0.7, 0.05), (0.4, 0.16),
              (0.0, 0.2))  # fmt: skip
HIND: Outline = ((0.0, 0.05), (0.4, 0.0), (0.68, 0.06), (0.76, 0.26), (0.75, 0.5), (0.68, 0.78),
              (0.55, 0.98), (0.38, 1.0), (0.22, 0.86), (0.1, 0.6), (0.0, 0.4))  # fmt: skip
VEINS: tuple[Outline, ...] = (
    ((0.04, 0.0), (0.26, -0.4), (0.5, -0.62), (0.8, -1.0)),
    ((0.04, 0.0), (0.3, -0.14), (0.52, -0.3), (0.62, -0.5), (0.5, -0.62)),
    ((0.62, -0.5), (1.0, -0.8)), ((0.52, -0.3), (1.0, -0.5)), ((0.3, -0.14), (0.9, -0.12)),
    ((0.04, 0.2), (0.34, 0.24), (0.48, 0.34), (0.4, 0.5), (0.2, 0.44), (0.04, 0.2)),
    ((0.48, 0.34), (0.8, 0.3)), ((0.46, 0.4), (0.74, 0.64)), ((0.4, 0.5), (0.56, 1.0)),
    ((0.3, 0.48), (0.36, 1.0)),
)  # fmt: skip
EDGE = 0.075  # of a wing, training units


def wing_cases(points: Points, half: Half) -> Margin:
    """Marks of a ladybird: three dots at either side, one in front, and the line between the
    wings."""
    at = torch.stack([points[:, 0].abs() / half[0], points[:, 1] / half[1]], 1)
    middles = at.new_tensor([(0.0, -0.72), (0.5, -0.4), (0.66, 0.18), (0.38, 0.58)])
    return any_of((0.19 - torch.cdist(at, middles).amin(1)) * half[0], 0.02 - points[:, 0].abs())


def _wings(points: Points, half: Half) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """For a butterfly with its front at -y: places on the wings of one side from their root on,
    their scale, and the margins of the fore and the hind wing."""
    scale = half[:2].to(points) * half.new_tensor([2.0, 1.0]).to(points)
    at = torch.stack([points[:, 0] + half[0].to(points), points[:, 1]], 1)
    fore, hind = (within(at, points.new_tensor(line) * scale) for line in (FORE, HIND))
    return at, scale, fore, hind


def wing_cells(points: Points, half: Half) -> Margin:
    """The cells between the veins of a butterfly's wings, inside their edges."""
    at, scale, fore, hind = _wings(points, half)
    veins = any_of(*(strokes(at, points.new_tensor(line) * scale, 0.011) for line in VEINS))
    return all_of(any_of(fore - EDGE, all_of(hind - EDGE, -0.015 - fore)), -veins)


def wing_dots(points: Points, half: Half, pitch: float = 0.09, size: float = 0.022) -> Margin:
    """A row of dots along the outer edges of a butterfly's wings."""
    at, scale, fore, hind = _wings(points, half)
    margins = []
    for line, first, last in ((FORE, 4, 9), (HIND, 2, 8)):
        corners = points.new_tensor(line[first : last + 1]) * scale
        middles = evenly(corners, pitch) * 0.93 + points.new_tensor([0.0, 0.01])
        margins.append(size - torch.cdist(at, middles).amin(1))
    return all_of(any_of(*margins), any_of(fore, hind))


def evenly(places: Float[Tensor, "c 2"], pitch: float) -> Float[Tensor, "n 2"]:
    """Places about ``pitch`` apart on a line from place to place."""
    way = places[1:] - places[:-1]
    long = way.norm(dim=1)
    count = max(round(float(long.sum()) / pitch), 1)
    fraction = (torch.arange(count, device=places.device) + 0.5) / count * long.sum()
    ends = long.cumsum(0)
    k = torch.searchsorted(ends, fraction).clamp_max(len(long) - 1)
    into = 1 - (ends[k] - fraction) / long[k]
    return places[k] + into[:, None] * way[k]
