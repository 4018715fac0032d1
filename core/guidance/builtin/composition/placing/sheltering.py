"""Placements of things under another: a cat under a table, presents under a Christmas tree."""

import math
from collections.abc import Sequence

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.placement import Body, Placement, sized

SIZES = (0.2, 0.85)  # of the roof's longest side: least and most
FRONT, TURN = -math.pi / 2, math.radians(50)  # where the first is, and from one to the next
ASIDE = tuple(math.radians(x) for x in (0, 25, -25, 50, -50, 80, -80))  # where else one may be
STEPS, FARTHEST = 24, 1.6  # of the way from the axis outwards; times half the roof's width
SMALLER = (1.0, 0.85, 0.7)  # to fit below the roof
TALL = 0.25  # of the roof's height: what is lower is made no smaller
BELOW = 1.1  # of half the roof's width: what stands nearer to its axis is below it
SUNK = 0.02  # training units: overlap with what it touches
SLID = 0.35  # of the roof's width: as far as something goes to what it touches


def sheltered(thing: Body, roof: Body, there: Body, count: int) -> list[Placement]:
    """The placements of things on the ground under ``roof``: as near to its axis as they fit beside
    what is ``there``, at its front and then on both sides, each touching what is next to it."""
    scale = sized(thing, roof, *SIZES)
    tall = scale * float(thing.sides[2]) > TALL * float(roof.sides[2])
    for smaller in SMALLER if tall else SMALLER[:1]:
        places, inside = _all_placed(thing, roof, there, count, scale * smaller)
        if inside:
            return places
    return _all_placed(thing, roof, there, count, scale)[0]


def _all_placed(
    thing: Body, roof: Body, other: Body, count: int, scale: float
) -> tuple[list[Placement], bool]:
    """The placements at a size, and whether all are below the roof."""
    found, inside, obstacles = [], True, [other.verts]
    for k in range(count):
        angle = FRONT + TURN * math.ceil(k / 2) * (-1) ** k
        place = Placement.of(scale)
        there = thing.placed(place)
        ways = (_nearest_free(there.box, roof, obstacles, angle + aside) for aside in ASIDE)
        shift, away = min(ways, key=lambda one: one[1])
        place = place.moved(shift)
        place = place.moved(_to_touch(thing.placed(place).box, roof, obstacles))
        obstacles.append(thing.placed(place).verts)
        found.append(place)
        inside &= away <= BELOW
    return found, inside


def _nearest_free(
    box: Float[Tensor, "2 3"], roof: Body, obstacles: Sequence[Tensor], angle: float
) -> tuple[Float[Tensor, " 3"], float]:
    """The shift of a box to the free place nearest to the roof's axis, that way; how far from the
    axis it is there, in halves of the roof's width."""
    middle, half = roof.box.mean(0), roof.sides / 2
    way = torch.tensor([math.cos(angle), math.sin(angle)])
    start = torch.cat([middle[:2] - box.mean(0)[:2], (roof.box - box)[0, 2:]])
    shift, away = start, 0.0
    for step in range(STEPS + 1):
        away = FARTHEST * step / STEPS
        shift = start + torch.cat([away * way * half[:2], torch.zeros(1)])
        if not _hits(box + shift, obstacles):
            break
    return shift, away


def _hits(box: Float[Tensor, "2 3"], obstacles: Sequence[Tensor]) -> bool:
    """Whether there is anything in a box."""
    low, high = box[0] + SUNK, box[1] - SUNK
    return any(bool(((verts > low) & (verts < high)).all(1).any()) for verts in obstacles)


def _to_touch(
    box: Float[Tensor, "2 3"], roof: Body, obstacles: Sequence[Tensor]
) -> Float[Tensor, " 3"]:
    """The shortest way on the ground to the nearest obstacle beside a box; none where nothing is
    near."""
    verts = torch.cat(list(obstacles))
    verts = verts[(verts[:, 2] > box[0, 2] + SUNK) & (verts[:, 2] < box[1, 2] - SUNK)]
    off = (verts - box.mean(0))[:, :2]
    gap = (off.abs() - (box[1] - box[0])[:2] / 2).clamp_min(0)
    away = gap.norm(dim=1)
    if not len(away) or float(away.min()) > SLID * float(roof.sides[:2].max()):
        return torch.zeros(3)
    k = away.argmin()
    shift = off[k].sign() * (gap[k] + SUNK) * (gap[k] > 0)
    return torch.cat([shift, torch.zeros(1)])
