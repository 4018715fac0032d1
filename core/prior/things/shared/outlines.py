"""Flat outlines: the corners of a strip, of a dome's profile and of a rounded rectangle."""

import math

from core.prior.solids import Point


def dome_of(radius: float, low: float, high: float, steps: int = 14) -> list[Point]:
    """The profile of a quarter ellipse, from its rim to its top."""
    angles = [math.pi / 2 * k / steps for k in range(steps + 1)]
    return [(radius * math.cos(a), low + (high - low) * math.sin(a)) for a in angles]


def rounded(x: float, y: float, r: float, steps: int = 5) -> list[Point]:
    """A rectangle of half sizes x, y with round corners of radius r."""
    quarters = ((1, 1, 0), (-1, 1, 90), (-1, -1, 180), (1, -1, 270))
    return [
        (
            sx * (x - r) + r * math.cos(math.radians(first + 90 * k / steps)),
            sy * (y - r) + r * math.sin(math.radians(first + 90 * k / steps)),
        )
        for sx, sy, first in quarters
        for k in range(steps + 1)
    ]


def strip(a: Point, b: Point, half: float) -> list[Point]:
    """The corners of a straight strip from a to b."""
    u, v = b[0] - a[0], b[1] - a[1]
    u, v = -v * half / math.hypot(u, v), u * half / math.hypot(u, v)
    return [(a[0] + u, a[1] + v), (b[0] + u, b[1] + v), (b[0] - u, b[1] - v), (a[0] - u, a[1] - v)]
