"""Symbols and other solids of one idea."""

import math

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    blend,
    both,
    box,
    cut,
    join,
    moved,
    prism,
    taper,
    tube,
    turned,
)


def heart(draw: Draw) -> Parts:
    """Upright, its point below."""
    x, r, z, thick = draw(0.44, 0.5), draw(0.5, 0.55), draw(1.2, 1.35), draw(0.6, 0.8)
    half = taper((x, 0, z), (0.0, 0, 0.1), r, 0.1)
    middle = taper((0, 0, z - 0.3), (0, 0, 0.12), r * 0.85, 0.1)
    full = blend(0.15, both(half), middle)
    # Squeezed from front to back; a lower bound of the distance.
    return {"body": lambda p: full(p / p.new_tensor([1, thick, 1])) * thick}


def star(draw: Draw) -> Parts:
    """Upright, five points, plump or with ridges."""
    reach, waist = draw(1.05, 1.2), draw(0.42, 0.5)
    if draw.chance(0.5):
        point = taper((0.05, 0, 0), (reach - 0.1, 0, 0), waist * 0.9, 0.1)
    else:
        point = _ridged(reach, waist, draw(0.3, 0.42))
    return {"body": moved(turned(around(5, point, 90), 0, 90), (0, 0, 1.1))}


def _ridged(reach: float, waist: float, thick: float) -> Solid:
    """A star's point along x, with a ridge from the middle to its blunt tip."""
    c, s, rim = waist * math.cos(math.pi / 5), waist * math.sin(math.pi / 5), 0.09
    kite = prism([(0.0, 0.0), (c, -s), (reach - 0.2, 0.0), (c, s)], 2, 1)
    # The plane through the middle's top, the tip's rim and the rim of the notch beside it.
    along = (rim - thick) / reach
    across = (rim - thick - along * c) / s
    steep = math.hypot(1, along, across)

    def distance(p: Tensor) -> Tensor:
        top = thick + along * p[:, 0] + across * p[:, 1].abs()
        return torch.maximum(kite(p) - 0.06, (p[:, 2].abs() - top) / steep)

    return distance


def crescent_moon(draw: Draw) -> Parts:
    """Upright, open to the right."""
    edge, tip, hollow = draw(0.1, 0.13), math.radians(draw(42, 56)), draw(0.3, 0.42)
    c, s = math.cos(tip), math.sin(tip)
    # Both arcs go through the tips (c, ±s); the inner one's leftmost point is at -hollow.
    middle = (1 - hollow**2) / (2 * (c + hollow))
    radius, turn = middle + hollow, math.atan2(s, c - middle)
    outer = [tip + 2 * (math.pi - tip) * k / 24 for k in range(25)]
    inner = [2 * math.pi - turn - 2 * (math.pi - turn) * k / 18 for k in range(1, 18)]
    corners = [(math.cos(t), math.sin(t)) for t in outer]
    corners += [(middle + radius * math.cos(t), radius * math.sin(t)) for t in inner]
    thin = prism(corners, 1, draw(0.02, 0.1))
    return {"body": moved(turned(lambda p: thin(p) - edge, 1, draw(-25, 0)), (0, 0, 1.2))}


def gear(draw: Draw) -> Parts:
    """Upright, its axis to the front."""
    count, r, y = 8 + 2 * draw.which(3), draw(0.8, 0.88), draw(0.17, 0.26)
    low, top = 2 * r / count * draw(1.0, 1.1), 2 * r / count * draw(0.62, 0.75)
    tooth = prism([(r - 0.1, -low), (r + 0.22, -top), (r + 0.22, top), (r - 0.1, low)], 2, y)
    hub, hole = draw(0.34, 0.4), draw(0.17, 0.22)
    bore = tube((0, 0, -2), (0, 0, 2), hole)
    disc = cut(tube((0, 0, -y), (0, 0, y), r), bore)
    if draw.chance(0.5):
        windows = tube((r * 0.64, 0, -2), (r * 0.64, 0, 2), r * 0.17)
        disc = cut(disc, around(5 + draw.chance(0.5), windows, 90))
    hub_solid = cut(tube((0, 0, -y - 0.07), (0, 0, y + 0.07), hub, 0.02), bore)
    parts = {"body": disc, "teeth": around(count, tooth, 90), "hub": hub_solid}
    return {name: moved(turned(part, 0, 90), (0, 0, r + 0.22)) for name, part in parts.items()}


def dice(draw: Draw) -> Parts:
    """One, its spots proud of its faces by a hair; opposite faces add to seven."""
    half, r = 0.8, draw(0.15, 0.185)
    side = half * draw(0.46, 0.52)
    two, three = [(-1, 1), (1, -1)], [(-1, 1), (0, 0), (1, -1)]
    four = [*two, (-1, -1), (1, 1)]
    faces = [(1, -1, [(0, 0)]), (2, 1, two), (0, 1, three)]
    faces += [(0, -1, four), (2, -1, [*four, (0, 0)]), (1, 1, [*four, (-1, 0), (1, 0)])]
    spots = []
    for axis, sign, places in faces:
        for u, v in places:
            near, far = ([u * side, v * side] for _ in range(2))
            near.insert(axis, sign * (half - 0.1))
            far.insert(axis, sign * (half + 0.025))
            spots.append(tube((*near,), (*far,), r, 0.02))
    body = box((0, 0, 0), (half, half, half), draw(0.1, 0.22))
    return {"body": moved(body, (0, 0, half)), "pips": moved(join(*spots), (0, 0, half))}


SYMBOLS = {
    "heart": heart,
    "star": star,
    "crescent moon": crescent_moon,
    "gear": gear,
    "dice": dice,
}
