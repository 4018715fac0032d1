"""Ropes and bars through points."""

import math

from core.prior.solids import Solid, Vector, capsule, chain, join, smooth_curve, taper


def smooth_bar(stops: list[tuple[float, float, float]], across: bool = False) -> Solid:
    """A smooth bar through the stops (y, z, radius), or (x, z, radius) if ``across``."""
    path = smooth_curve([(u, v) for u, v, _ in stops], 3)
    girth = smooth_curve([(r, 0.0) for *_, r in stops], 3)
    return chain(((u, 0.0, v) if across else (0.0, u, v), r)
                 for (u, v), (r, _) in zip(path, girth, strict=True))  # fmt: skip


def bent(points: list[tuple[float, float, float]], radii: list[float]) -> Solid:
    """A rope through the points, with a radius for each."""
    pairs = zip(points, points[1:], radii, radii[1:], strict=False)
    return join(*(taper(a, b, r, s) for a, b, r, s in pairs))


def arc(radius: float, first: float, last: float, steps: int) -> list[tuple[float, float, float]]:
    """Points on a circle about the origin in the plane y = 0, between two angles in degrees."""
    angles = [math.radians(first + (last - first) * k / steps) for k in range(steps + 1)]
    return [(radius * math.cos(a), 0.0, radius * math.sin(a)) for a in angles]


def rods(radius: float, *ends: tuple[Vector, Vector]) -> Solid:
    """Round bars of one radius, each between a pair of ends."""
    return join(*(capsule(a, b, radius) for a, b in ends))
