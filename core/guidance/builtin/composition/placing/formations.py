"""Copies of a thing in an order: crossed, back to back, face to face, in a circle."""

import math

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.placement import (
    Z_TO_X,
    Body,
    Placement,
    about_x,
    about_y,
    about_z,
)

TOUCHING = 0.02  # of a side: overlap of neighbours, so that they are one mesh
LEANING = math.radians(38)  # of crossed things, off the vertical
AT_CROSSING = 0.12  # of the height: the points whose thickness keeps crossed things apart
OVERLAP = 0.12  # of that thickness
ENDS = 0.25  # of the height: the ends that may stand out to one side
STANDS_OUT = 1.3  # times as far to one side as to the other
CLOSER = (
    1.0,
    0.95,
    0.9,
    0.85,
    0.8,
    0.75,
    0.7,
    0.65,
    0.6,
)  # times as far from the middle as their boxes touch
SOME = 3000  # points
QUARTER = math.pi / 2


def crossed(thing: Body) -> list[Placement]:
    """Two upright things in the form of an X, one in front of the other."""
    upright = _upright(thing)
    stood = thing.placed(Placement.of(1.0, upright))
    outward = math.pi if _stands_inward(stood) else 0.0
    found = []
    for side, turned in ((1.0, outward), (-1.0, outward + math.pi * _is_lopsided(stood))):
        turn = about_y(side * LEANING) @ about_z(turned) @ upright
        middle = Placement.of(1.0, turn).out(thing.box.mean(0)[None])[0]
        found.append(Placement.of(1.0, turn).moved(-middle))
    front, back = (place.out(thing.verts) for place in found)
    near = AT_CROSSING * float(stood.sides[2])
    behind, before = (each[each[:, [0, 2]].norm(dim=1) < near, 1] for each in (front, back))
    if not (len(behind) and len(before)):
        behind, before = front[:, 1], back[:, 1]
    thick = float(behind.amax() - before.amin())
    overlap = OVERLAP * float(behind.amax() - behind.amin())
    return [found[0], found[1].moved(torch.tensor([0.0, thick - overlap, 0.0]))]


def _upright(thing: Body) -> Float[Tensor, "3 3"]:
    """The rotation that makes a thing upright, and thin from the front to the back."""
    long = int(thing.sides.argmax())
    turn = {0: Z_TO_X.T, 1: about_x(-QUARTER), 2: torch.eye(3)}[long]
    wide, deep, _ = thing.placed(Placement.of(1.0, turn)).sides.tolist()
    return about_z(QUARTER) @ turn if wide < deep else turn


def _out_at(thing: Body) -> tuple[float, float, float]:
    """How far the ends of an upright thing stand out to its left and right, at the end that does
    so more; and 1 for its upper end, -1 for the lower."""
    x, z = thing.verts[:, 0], thing.verts[:, 2]
    low, high = thing.box[:, 2].tolist()
    part = ENDS * (high - low)
    middle = x[(z - (low + high) / 2).abs() < part]
    line = float(middle.median()) if len(middle) else float(thing.box.mean(0)[0])
    each = []
    for end, sign in ((x[z > high - part], 1.0), (x[z < low + part], -1.0)):
        left, right = line - float(end.amin()), float(end.amax()) - line
        each.append((abs(left - right), left, right, sign))
    _, left, right, sign = max(each)
    return left, right, sign


def _is_lopsided(thing: Body) -> bool:
    """Whether it stands out to one side, as an axe does with its head."""
    left, right, _ = _out_at(thing)
    return max(left, right) > STANDS_OUT * max(min(left, right), 1e-6)


def _stands_inward(thing: Body) -> bool:
    """Whether a lopsided thing that leans to the right has its head on the left."""
    left, right, sign = _out_at(thing)
    return _is_lopsided(thing) and sign * (right - left) < 0


def facing(thing: Body, away: bool) -> list[Placement]:
    """Two things that look at each other, or ``away`` from each other, back to back."""
    half = float(thing.sides[1]) * (1 - TOUCHING) / 2
    found = []
    for side in (-1.0, 1.0):
        turn = about_z(QUARTER * side * (1.0 if away else -1.0))
        middle = turn @ thing.box.mean(0)
        shift = torch.tensor([side * half, 0.0, 0.0]) - middle * torch.tensor([1.0, 1.0, 0.0])
        found.append(Placement.of(1.0, turn).moved(shift))
    return found


def circle(thing: Body, count: int) -> list[Placement]:
    """Things around a middle that they look at, as close as they touch their neighbours; with a gap
    towards the front."""
    wide, deep, _ = thing.sides.tolist()
    inner = wide / 2 / math.tan(math.pi / count) if count > 2 else 0.0
    radius = (inner + deep / 2) * (1 - TOUCHING)
    for closer in CLOSER:
        found = around(thing, count, closer * radius)
        if _gap(thing, found[0], found[1]) < TOUCHING * thing.longest:
            break
    return found


def around(thing: Body, count: int, radius: float) -> list[Placement]:
    """Copies on a circle around the origin, which they look at; with a gap towards the front."""
    found = []
    for k in range(count):
        angle = angle_of(k, count)
        turn = about_z(angle - QUARTER)  # what is at the back looks to the front
        at = torch.tensor([math.cos(angle), math.sin(angle), 0.0]) * radius
        middle = turn @ (thing.box.mean(0) * torch.tensor([1.0, 1.0, 0.0]))
        found.append(Placement.of(1.0, turn).moved(at - middle))
    return found


def angle_of(k: int, count: int) -> float:
    """The direction of one of so many places on a circle, of which none is in front."""
    return (k + 0.5) * 2 * math.pi / count - QUARTER


def _gap(thing: Body, first: Placement, second: Placement) -> float:
    """The distance between two copies, by some of their points."""
    some = thing.verts[:: max(len(thing.verts) // SOME, 1)]
    return float(torch.cdist(first.out(some), second.out(some)).min())
