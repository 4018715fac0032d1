"""Plain solids, and a heart, a star, a moon and a gear."""

import math

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    cut,
    lathe,
    moved,
    prism,
    ring,
    taper,
    tube,
    turned,
)


def a_ball(_: Draw) -> Parts:
    return {"body": ball((0, 0, 0), 1.0)}


def cube(draw: Draw) -> Parts:
    return {"body": box((0, 0, 0), (1, 1, 1), draw(0.02, 0.15))}


def torus(draw: Draw) -> Parts:
    return {"body": ring((0, 0, 0), 1.0, draw(0.32, 0.45))}


def cylinder(draw: Draw) -> Parts:
    half = draw(1.0, 1.4)
    return {"body": tube((0, 0, -half), (0, 0, half), draw(0.75, 0.95), draw(0.02, 0.1))}


def cone(draw: Draw) -> Parts:
    radius, height = draw(0.85, 1.05), draw(1.7, 2.2)
    return {"body": lathe([(0, 0), (radius, 0), (0, height)], 0.04)}


def heart(draw: Draw) -> Parts:
    """Upright, its point below."""
    x, r, z, thick = draw(0.44, 0.5), draw(0.5, 0.55), draw(1.2, 1.35), draw(0.6, 0.8)
    half = taper((x, 0, z), (0.0, 0, 0.1), r, 0.1)
    middle = taper((0, 0, z - 0.3), (0, 0, 0.12), r * 0.85, 0.1)
    full = blend(0.15, both(half), middle)
    # Squeezed from front to back; a lower bound of the distance.
    return {"body": lambda p: full(p / p.new_tensor([1, thick, 1])) * thick}


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


def star(draw: Draw) -> Parts:
    """Upright, five points, plump or with ridges."""
    reach, waist = draw(1.05, 1.2), draw(0.42, 0.5)
    if draw.chance(0.5):
        point = taper((0.05, 0, 0), (reach - 0.1, 0, 0), waist * 0.9, 0.1)
    else:
        point = _ridged(reach, waist, draw(0.3, 0.42))
    return {"body": moved(turned(around(5, point, 90), 0, 90), (0, 0, 1.1))}


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


SOLIDS = {
    "ball": a_ball,
    "cube": cube,
    "torus": torus,
    "cylinder": cylinder,
    "cone": cone,
    "heart": heart,
    "star": star,
    "crescent moon": crescent_moon,
    "gear": gear,
}
