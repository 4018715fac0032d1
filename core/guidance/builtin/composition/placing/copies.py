"""Several copies of a thing: in a row, a heap or a stack, or as a bunch of flowers."""

import math
from collections.abc import Sequence

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.bunches import GOLDEN, bunched
from core.guidance.builtin.composition.placing.formations import circle, crossed, facing
from core.guidance.builtin.composition.placing.placement import (
    Body,
    Placement,
    about_z,
    laid_down,
    sized,
)
from core.guidance.builtin.composition.placing.resting import cells_of, highest
from core.guidance.builtin.words.companions.known_as import FLOWERS

TOUCHING = 0.02  # of a side: overlap of neighbours, so that they are one mesh
LYING = 1.5  # times as high as wide: laid down in a heap from here on
TRIES = 40  # places for each of a heap
SPREAD = 0.42  # a heap's radius: times a thing's width and the square root of their number
MIXED = (0.4, 1.8)  # of the first thing's longest side: sizes of the others in a mixed heap
INWARDS = 0.15  # cost of a unit off a heap's middle, in heights
SOME = 1500  # vertices that are dropped
CELLS = 48  # of a heap's height map, along a side
TURNED = math.radians(65)  # about the vertical, at most: faces look forward


def copies_of(thing: Body) -> list[Placement]:
    """The placements of all copies, in the stated order."""
    count = thing.words.count
    if count == 1:
        return [Placement.of()]
    order = thing.words.order
    if order == "stack":
        return _stack(thing, count)
    if order == "crossed" and count == 2:
        return crossed(thing)
    if order in ("face to face", "back to back") and count == 2:
        return facing(thing, away=order == "back to back")
    if order == "circle":
        return circle(thing, count)
    if order == "heap":
        return bunched([thing])[0] if thing.words.noun in FLOWERS else _heap(thing, count)
    return _row(thing, count)


def _row(thing: Body, count: int) -> list[Placement]:
    step = torch.tensor([float(thing.sides[0]) * (1 - TOUCHING), 0.0, 0.0])
    return [Placement.of().moved(step * (k - (count - 1) / 2)) for k in range(count)]


def _stack(thing: Body, count: int) -> list[Placement]:
    """Each on the one below, as deep in it as possible: plates, cups."""
    return _piled([thing] * count, math.inf, 0.0)


def _heap(thing: Body, count: int) -> list[Placement]:
    return _piled([thing] * count, LYING, SPREAD * _width(thing) * math.sqrt(count))


def mixed_heap(things: Sequence[Body]) -> list[list[Placement]]:
    """Several copies of several things in one heap, at their sizes relative to the first thing."""
    scales = [Placement.of(sized(thing, things[0], *MIXED)) for thing in things]
    each = [thing.placed(scale) for thing, scale in zip(things, scales, strict=True)]
    # One of each in turn.
    turns = [
        k for _, k in sorted((n, k) for k, t in enumerate(things) for n in range(t.words.count))
    ]
    wide = sum(_width(each[k]) for k in turns) / len(turns)
    piled = _piled([each[k] for k in turns], LYING, SPREAD * wide * math.sqrt(len(turns)))
    found: list[list[Placement]] = [[] for _ in things]
    for k, place in zip(turns, piled, strict=True):
        found[k].append(place.of_copy(scales[k]))
    return found


def _width(thing: Body) -> float:
    return float((thing.verts @ laid_down(thing, LYING).T).amax(0)[:2].max()) * 2


def _piled(things: Sequence[Body], high: float, radius: float) -> list[Placement]:
    """Each at its lowest place on those before it; longer than ``high`` times its width, it is laid
    down."""
    generator = torch.Generator().manual_seed(0)
    side = 2 * (radius + max(thing.longest for thing in things))
    heights = torch.zeros(CELLS, CELLS)  # the ground
    found: list[Placement] = []
    for thing in things:
        place, verts = _lowest(thing, laid_down(thing, high), heights, radius, side, generator)
        found.append(place)
        heights = torch.maximum(heights, highest(verts, *square_of(side), CELLS))
    return found


def _lowest(
    thing: Body,
    laid: Float[Tensor, "3 3"],
    heights: Float[Tensor, "c c"],
    radius: float,
    side: float,
    generator: torch.Generator,
) -> tuple[Placement, Float[Tensor, "v 3"]]:
    """The next thing's place, and its points there."""
    best, cost = None, math.inf
    begin = 2 * math.pi * float(torch.rand(1, generator=generator))
    for k in range(TRIES if radius else 1):
        turn = about_z(TURNED * (2 * float(torch.rand(1, generator=generator)) - 1)) @ laid
        far, angle = radius * math.sqrt((k + 0.5) / TRIES), begin + GOLDEN * k
        verts = thing.verts @ turn.T
        verts = verts + torch.tensor([far * math.cos(angle), far * math.sin(angle), 0.0])
        some = verts[:: max(len(verts) // SOME, 1)]
        cell = cells_of(some, *square_of(side), CELLS)
        drop = float((heights[cell[:, 0], cell[:, 1]] - some[:, 2]).max())
        drop -= TOUCHING * float(thing.sides.min())
        top = float(some[:, 2].max()) + drop + INWARDS * far
        if top < cost:
            shift = torch.tensor([far * math.cos(angle), far * math.sin(angle), drop])
            best, cost = Placement.of(1.0, turn).moved(shift), top
    assert best is not None
    return best, best.out(thing.verts)


def square_of(side: float) -> tuple[Float[Tensor, " 2"], Float[Tensor, " 2"]]:
    """The lowest corner and the sides of a square around the origin."""
    return torch.full((2,), -side / 2), torch.full((2,), side)
