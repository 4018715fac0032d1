"""Flowers in a bunch: fanned out from one point, with their heads at different heights."""

import math
from collections.abc import Sequence

import torch

from core.guidance.builtin.composition.placing.placement import Body, Placement, about_z, sized

GOLDEN = math.pi * (3 - math.sqrt(5))  # between places: evenly spread over a disc (Vogel 1979)
LEANING = (math.radians(18), math.radians(50))  # the outermost, at least and at most
RING = 7  # so many are one with a ring around it
APART = 0.9  # of a head's width: how far the outermost of five are from the middle
FIVE = 5
TOGETHER = 0.22  # of its length: where the stems cross
HIGHER = 0.2  # of its length: how much higher the middle one is than the outermost
UNEVEN = 0.07  # of its length and its size, either way: no two are alike
SIDEWAYS = math.radians(40)  # about its stem, towards the side that it leans to
LIKE = (0.75, 1.3)  # of the first one's length: sizes of the other kinds


def bunched(things: Sequence[Body]) -> list[list[Placement]]:
    """The copies of several kinds of flowers in one bunch, the kinds in turn from the middle on."""
    generator = torch.Generator().manual_seed(0)
    turns = [
        k for _, k in sorted((n, k) for k, t in enumerate(things) for n in range(t.words.count))
    ]
    total = len(turns)
    scales = [sized(thing, things[0], *LIKE) for thing in things]
    length = float(things[0].sides[2])
    wide = max(scale * _head(thing) for scale, thing in zip(scales, things, strict=True))
    off = APART * wide * math.sqrt(total / FIVE) / ((1 - TOGETHER) * length)
    most = min(max(math.atan(off), LEANING[0]), LEANING[1])
    point = torch.tensor([0.0, 0.0, float(things[0].box[0, 2]) + TOGETHER * length])
    found: list[list[Placement]] = [[] for _ in things]
    for place, kind in enumerate(turns):
        thing = things[kind]
        off, way = _place(place, total)
        jitter = [UNEVEN * (2 * float(torch.rand(1, generator=generator)) - 1) for _ in range(2)]
        # The nearer ones are lower, so that none hides another.
        up = HIGHER * (0.5 - 0.6 * off + 0.4 * off * math.sin(way)) + jitter[0]
        turn = _leaning(way, most * off) @ about_z(SIDEWAYS * off * math.cos(way))
        scale = scales[kind] * (1 + jitter[1])
        low = thing.box[0, 2] + (TOGETHER - up) * thing.sides[2]
        stem = torch.stack([*_foot(thing), low])
        at = Placement.of(scale, turn)
        found[kind].append(at.moved(point - at.out(stem[None])[0]))
    return found


def _place(place: int, total: int) -> tuple[float, float]:
    """How far off the middle one of them is, of the outermost, and its azimuth."""
    if total > RING:
        return math.sqrt(place / (total - 1)), GOLDEN * place + math.pi / 2
    ring = total if total < FIVE - 1 else total - 1  # around one in the middle
    if ring < total and place == 0:
        return 0.0, 0.0
    return 1.0, 2 * math.pi * (place - (total - ring) + 0.25) / ring - math.pi / 2


def _head(thing: Body) -> float:
    """The width of its upper half."""
    upper = thing.verts[thing.verts[:, 2] > thing.box.mean(0)[2]]
    return float((upper.amax(0) - upper.amin(0))[:2].max())


def _foot(thing: Body) -> tuple[torch.Tensor, torch.Tensor]:
    """The middle of a stem where it ends."""
    low = thing.verts[thing.verts[:, 2] < thing.box[0, 2] + 0.1 * thing.sides[2]]
    x, y = low[:, :2].mean(0)
    return x, y


def _leaning(way: float, angle: float) -> torch.Tensor:
    """The rotation that leans the vertical towards an azimuth."""
    to = about_z(way)
    c, s = math.cos(angle), math.sin(angle)
    return to @ torch.tensor([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]) @ to.T
