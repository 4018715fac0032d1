"""Parts of vehicles: a slanted pane, a ship's hull."""

import math

from core.prior.solids import (
    Point,
    Solid,
    box,
    grown,
    mirrored,
    outlined,
    prism,
    smooth_curve,
    within,
)


def ship_hull(x: float, y: float, deck: float, bow: float) -> Solid:
    """A hull with a pointed raking bow, ``bow`` higher than its deck, and a straight stern."""
    plan = smooth_curve([(x * 0.86, y), (x, y * 0.5), (x, -y * 0.3), (x * 0.66, -y * 0.72),
                         (0.04, -y - 0.1)])  # fmt: skip
    side = [(y, deck), (y * 0.95, 0), (-y * 0.76, 0), (-y - 0.08, deck + bow),
            (-y * 0.4, deck + bow * 0.5), (y * 0.2, deck)]  # fmt: skip
    return outlined(side, plan)


def pane(low: Point, high: Point, out: int, half: float) -> Solid:
    """A pane on a cabin's slanted end, between its lower and its upper edge (y, z).

    ``out``: the side of y that it faces, 1 or -1.
    """
    (a, b), (c, d) = low, high
    length = math.hypot(c - a, d - b)
    across = (out * (d - b) / length * 0.06, abs(c - a) / length * 0.06)
    ends = [(a + (c - a) * t, b + (d - b) * t) for t in (0.3, 0.84)]
    corners = [(u + s * across[0], v + s * across[1]) for s in (1, -1) for u, v in ends[::s]]
    return prism(corners, 0, half)


def greenhouse(
    x: float, belt: float, roof: float, ys: tuple[float, float, float, float]
) -> tuple[Solid, Solid]:
    """A car's cabin of planes that all lean in, from below its belt to its roof, and a band of
    glass around it; ``ys``: where its outline starts at the belt, where its roof starts and ends,
    and where it is at the belt again."""
    front, first, last, back = ys
    sill, rise = belt - 0.1, 0.1 / (roof - belt)
    ends = (front - rise * (first - front), back + rise * (back - last))
    line = [(ends[0], sill), (first, roof), (last, roof), (ends[1], sill)]
    across = [(x * (0.94 + 0.2 * rise), sill), (x * 0.74, roof)]
    cabin = within(prism(line, 0, 2), prism(mirrored(across), 1, 3))
    band = box((0, 0, (belt + roof) / 2), (2, 3, (roof - belt) * 0.34))
    return cabin, within(grown(cabin, 0.04), band)
