"""Lands, ice, zones and craters of globes."""

import math

import torch
import torch.nn.functional as F

from core.guidance.builtin.markings.forms.spots import blobs
from core.guidance.builtin.markings.margins import Half, Margin, Points, Spans, any_of
from core.guidance.builtin.markings.stencils import land


def _upright(points: Points, lean: float) -> Points:
    """Places on a globe whose axis leans ``lean`` degrees to the side, turned upright."""
    c, s = math.cos(math.radians(lean)), math.sin(math.radians(lean))
    x, y, z = points.unbind(1)
    return torch.stack([c * x - s * z, y, s * x + c * z], 1)


def lands(points: Points, half: Half, lean: float = 0.0) -> Margin:
    """The land of the world."""
    return land(_upright(points, lean)) * half.mean()


def poles(points: Points, half: Half, lean: float = 0.0) -> Margin:
    """The ice at the poles, larger in the south."""
    north = F.normalize(_upright(points, lean), dim=1)[:, 2].clamp(-1, 1).asin()
    return torch.maximum(north - math.radians(76), -north - math.radians(66)) * half.mean()


def zones(points: Points, half: Half, spans: Spans, lean: float = 0.0) -> Margin:
    """Bands of a planet between latitudes in degrees."""
    north = F.normalize(_upright(points, lean), dim=1)[:, 2].clamp(-1, 1).asin()
    spans = [(math.radians(low), math.radians(high)) for low, high in spans]
    return any_of(*(torch.minimum(north - a, b - north) for a, b in spans)) * half.mean()


def craters(points: Points, half: Half) -> Margin:
    """The plains and craters of the moon."""
    on = F.normalize(points, dim=1)
    plains, rings = blobs(on, half, 0.8, (0.14, 0.34), 0.4), blobs(on, half, 0.3, (0.03, 0.09), 0.4)
    return any_of(plains, rings) * half.mean()


def storm(points: Points, half: Half, at: tuple[float, float], size: tuple[float, float]) -> Margin:
    """An oval on a globe: its middle to the right of the front and north, and its half sides,
    degrees."""
    x, y, z = F.normalize(points, dim=1).unbind(1)
    east = (torch.atan2(x, -y) - math.radians(at[0]) + math.pi).remainder(math.tau) - math.pi
    north = z.clamp(-1, 1).asin() - math.radians(at[1])
    wide, high = (math.radians(one) for one in size)
    away = torch.hypot(east * math.cos(math.radians(at[1])) / wide, north / high)
    steep = torch.hypot(
        east * math.cos(math.radians(at[1])) / wide**2, north / high**2
    ) / away.clamp_min(1e-6)
    return (1 - away) / steep.clamp_min(0.5 / wide) * half.mean()


def plains(points: Points, half: Half) -> Margin:
    """Dark ones of a planet, of any outline."""
    x, y, z = F.normalize(points, dim=1).unbind(1)
    high = (3.1 * x + 1.3 + 1.6 * (4 * z).sin()).sin() + (2.7 * y + 0.4 + (3 * x).sin()).sin()
    high = high + 0.6 * (7 * z + 3 * x + 1).sin() + 0.25 * (13 * y - 9 * z).sin()
    return (high - 0.75) * half.mean() / 5
