"""Stripes about an animal's trunk and legs, and folds of its skin."""

import math

from core.prior.solids import Solid, Vector, both, join, lathe, moved, tube, turned
from core.prior.things.shared.quadruped import Beast

BAND = 0.035  # height of a stripe above the surface


def hoop(b: Beast, at: float, half: float) -> Solid:
    """A stripe about the trunk at the fraction ``at`` of its length."""
    y = at * b.long
    profile = []
    for end in (y - half, y, y + half):
        # The trunk is as high as 0.95 of its width: the stripe goes about the wider circle.
        r = b.wide * math.sqrt(max(1 - (end / b.long) ** 2, 0.04))
        # Turned about x, what was up is to the front.
        profile.append((r + BAND, -end))
    return moved(turned(lathe(profile[::-1]), 0, 90), (0, 0, b.belly))


def cuff(start: Vector, end: Vector, at: float, half: float, radius: float) -> Solid:
    """A stripe about a round bar at the fraction ``at`` of its length."""
    length = math.dist(start, end)
    ends = (at - half / length, at + half / length)
    low, high = (tuple(s + (e - s) * t for s, e in zip(start, end, strict=True)) for t in ends)
    return tube((low[0], low[1], low[2]), (high[0], high[1], high[2]), radius + BAND)


def leg_stripes(b: Beast, *heights: float) -> Solid:
    """Stripes about each leg."""
    a, c, r = b.wide * 0.55, b.long * 0.66, b.foot * 1.08 + BAND
    bands = (tube((a, c, z - 0.065), (a, c, z + 0.065), r) for z in heights)
    return both(join(*bands), 0, 1)


def skin_fold(wide: float, long: float, z: float, at: float) -> Solid:
    """A fold of skin about the trunk at the fraction ``at`` of its length."""
    r = wide * math.sqrt(1 - at * at) + BAND
    return tube((0, at * long - 0.07, z), (0, at * long + 0.07, z), r, 0.02)
