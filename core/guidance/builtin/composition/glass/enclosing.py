"""Things in a glass vessel, which is cut to them: whole, standing in it or floating."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.glass.vessel import vessel_of
from core.guidance.builtin.composition.glass.vessels import Shape, shape_for
from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.copies import copies_of
from core.guidance.builtin.composition.placing.placement import (
    Body,
    Placement,
    about_x,
    about_z,
    joined,
    laid_down,
)
from core.guidance.builtin.composition.placing.resting import cells_of, highest
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.stretch import training_size
from core.guidance.builtin.words.companions.glassware import FLOATING, VESSELS, lies_in
from core.guidance.builtin.words.companions.search import Relation
from core.guidance.builtin.words.tables.living import is_creature

CARRIED = ("wears", "holds", "bears")  # these are in the vessel with who has them
SOME = 1200  # points of a thing that have to fit
STEPS, LEVELS = 14, 28  # of the search for its size; heights that it is tried at
GAP = 0.015  # training units: from the glass
FILLED = {"standing": 0.94, "floating": 0.8}  # of the largest size that fits
SUNK = 0.006  # training units: what stands is so deep in the glass; a wall is thicker
DROP = 0.004  # training units: steps down
HEAP = 0.5  # times as high as wide: a vessel for it
PACKED = 0.9  # of the room: the boxes around the things in a heap
NEAR_WALL = 0.75  # of that: how near the middle of one is to a wall
LONGEST, SMALLER = 0.8, 0.9  # of the room's width; by how much smaller they are, if one has no room
ATTEMPTS = 16  # at smaller and smaller sizes
TILT, TRIES, CELLS = math.radians(30), 60, 40
TOUCHING = 0.008  # training units: things in a heap overlap
HOVERING = 0.42  # of the room's radius: the size of each of several


class Inside(NamedTuple):
    """What is in a vessel: indices of the things."""

    vessel: int
    contents: tuple[int, ...]


def inside_of(bodies: Sequence[Body], relations: Sequence[Relation]) -> Inside | None:
    """The vessel among the things, the first one or what that is in, and its contents; None without
    one."""
    nouns = [body.words.noun for body in bodies]
    if nouns[0] in VESSELS:
        contents = tuple(k for k, how in enumerate(relations, 1) if how == "bears")
        return Inside(0, contents) if contents else None
    held = [k for k, how in enumerate(relations, 1) if how == "in" and nouns[k] in VESSELS]
    if not held:
        return None
    more = (k for k, how in enumerate(relations, 1) if how in CARRIED)
    return Inside(held[0], (0, *more))


def enclosed(
    things: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation], inside: Inside
) -> tuple[list[Thing], list[Body], list[list[Placement]]]:
    """The things, their forms and the placements of their copies, at the training's size; the
    vessel is cut to the others."""
    each = [bodies[k] for k in inside.contents]
    heap = any(body.words.order == "heap" for body in each)
    heap |= len(each) > 1 and not inside.vessel
    several = heap and sum(body.words.count for body in each) > 1
    own = (
        [copies_of(body) for body in each]
        if several or not inside.vessel
        else arranged(each[0], [(relations[k - 1], bodies[k]) for k in inside.contents[1:]])
    )
    turn = _turned(each[0]) if not several else torch.eye(3)
    whole = joined([body.group(copies) for body, copies in zip(each, own, strict=True)])
    whole = whole.placed(Placement.of(1.0, turn))
    things, bodies = list(things), list(bodies)
    words, solid = bodies[inside.vessel].words, things[inside.vessel].solid
    assert solid is not None
    words = replace(words, size=words.size or bodies[0].words.size)
    wide, deep, high = whole.sides.tolist()
    lies = lies_in(words.noun, each[0].words.noun) and not several
    across = wide if lies else math.hypot(wide, deep)
    vessel = vessel_of(
        words, solid, shape_for(words.noun, HEAP if several else high / across, lies)
    )
    things[inside.vessel] = things[inside.vessel].with_solid(vessel)
    bodies[inside.vessel] = Body.of(words, vessel)
    if several and each[0].words.noun in FLOATING:
        found = _hovering(each, vessel.shape)
    elif several:
        found = _packed(each, vessel.shape)
    else:
        place = _within(whole, vessel.shape, each[0].words.noun in FLOATING)
        found = [
            [place.of_copy(Placement.of(1.0, turn)).of_copy(copy) for copy in copies]
            for copies in own
        ]
    places = [[Placement.of()] for _ in bodies]
    for k, copies in zip(inside.contents, found, strict=True):
        places[k] = copies
    return things, bodies, _around(bodies, places, relations, inside)


def _around(
    bodies: Sequence[Body],
    places: list[list[Placement]],
    relations: Sequence[Relation],
    inside: Inside,
) -> list[list[Placement]]:
    """The same with what is neither vessel nor content in its place, at the training's size."""
    rest = [k for k in range(len(bodies)) if k != inside.vessel and k not in inside.contents]
    if rest:
        others = [(relations[k - 1], bodies[k]) for k in rest]
        (vessel, *_), *found = arranged(bodies[inside.vessel], others)
        places = [[vessel.of_copy(one) for one in own] for own in places]
        for k, own in zip(rest, found, strict=True):
            places[k] = own
    pairs = zip(bodies, places, strict=True)
    verts = torch.cat([place.out(body.verts) for body, own in pairs for place in own])
    fit = training_size(verts)
    return [[place.then(*fit) for place in own] for own in places]


def _turned(body: Body) -> Float[Tensor, "3 3"]:
    """The rotation of a long thing, whose side is towards the front: a ship in a bottle."""
    wide, deep, _ = body.sides.tolist()
    along = deep > 1.3 * wide and not is_creature(body.words.noun)
    return about_z(-math.pi / 2) if along else torch.eye(3)


def _some(verts: Float[Tensor, "v 3"]) -> Float[Tensor, "n 3"]:
    return verts[:: max(len(verts) // SOME, 1)]


def _within(whole: Body, shape: Shape, floats: bool) -> Placement:
    """The placement in the room of a vessel, as large as it fits."""
    low, high = whole.box
    foot = torch.stack([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    points = _some(whole.verts) - foot
    levels = _levels(shape)
    spot = torch.tensor([*shape.middle, 0.0])

    def fits(scale: float, level: float) -> bool:
        return float(_out(shape, scale * points + spot, level).max()) < -GAP

    least, most = 0.0, 3.0
    for _ in range(STEPS):
        scale = (least + most) / 2
        least, most = (scale, most) if any(fits(scale, z) for z in levels) else (least, scale)
    scale = FILLED["floating" if floats else "standing"] * least
    good = [z for z in levels if fits(scale, z)] or [levels[LEVELS // 2]]
    level = (good[0] + good[-1]) / 2 if floats else good[0]
    while not floats and float(_out(shape, scale * points + spot, level).max()) < SUNK:
        level -= DROP
    up = torch.tensor([0.0, 0.0, level])
    return Placement(scale, spot + up - scale * foot, torch.eye(3))


def _levels(shape: Shape) -> list[float]:
    heights = shape.room.mesh(0.1)[0][:, 2]
    return torch.linspace(float(heights.min()), float(heights.max()), LEVELS).tolist()


def _out(shape: Shape, points: Float[Tensor, "n 3"], level: float) -> Float[Tensor, " n"]:
    return shape.free(points + torch.tensor([0.0, 0.0, level]))


def _pieces(bodies: Sequence[Body]) -> list[int]:
    """The thing of each of all copies, one of each in turn."""
    turns = [(n, k) for k, body in enumerate(bodies) for n in range(body.words.count)]
    return [k for _, k in sorted(turns)]


def _free_places(shape: Shape, count: int, gap: float) -> Float[Tensor, "n 3"]:
    """Random points of the room, farther than ``gap`` from its walls."""
    generator = torch.Generator().manual_seed(0)
    verts = shape.room.mesh(0.1)[0]
    low, high = verts.amin(0), verts.amax(0)
    points = low + torch.rand(count, 3, generator=generator) * (high - low)
    return points[shape.free(points) < -gap]


def _inner_radius(shape: Shape) -> float:
    """Of the largest ball in the room."""
    return -float(shape.free(_free_places(shape, 4000, 0.0)).min())


def _packed(bodies: Sequence[Body], shape: Shape) -> list[list[Placement]]:
    """A heap in the vessel, of things as large as they all fit."""
    room = _Room(shape)
    pieces = _pieces(bodies)
    boxes = sum(float(bodies[k].sides.prod()) / bodies[k].longest ** 3 for k in pieces)
    longest = min((PACKED * room.volume / boxes) ** (1 / 3), LONGEST * room.width)
    for _ in range(ATTEMPTS):
        found = _dropped(bodies, pieces, room, longest)
        if found is not None:
            return found
        longest *= SMALLER
    return _hovering(bodies, shape)


def _dropped(
    bodies: Sequence[Body], pieces: Sequence[int], room: "_Room", longest: float
) -> list[list[Placement]] | None:
    """Each of the pieces at its lowest place on those before it; None where one has no room."""
    generator = torch.Generator().manual_seed(0)
    found: list[list[Placement]] = [[] for _ in bodies]
    heights = room.floor
    for k in pieces:
        best, top = None, math.inf
        for _ in range(TRIES):
            place = _tumbled(bodies[k], longest / bodies[k].longest, room, generator)
            points = place.out(_some(bodies[k].verts))
            cell = cells_of(points, room.low[:2], room.sides[:2], CELLS)
            drop = float((heights[cell[:, 0], cell[:, 1]] - points[:, 2]).max()) - TOUCHING
            points[:, 2] += drop
            if math.isfinite(drop) and float(points[:, 2].max()) < top and room.has(points):
                best = place.moved(torch.tensor([0.0, 0.0, drop]))
                top = float(points[:, 2].max())
        if best is None:
            return None
        found[k].append(best)
        verts = best.out(bodies[k].verts)
        heights = torch.maximum(heights, highest(verts, room.low[:2], room.sides[:2], CELLS))
    return found


class _Room:
    """The room in a vessel, by its box and the height of its floor."""

    def __init__(self, shape: Shape) -> None:
        verts = shape.room.mesh(0.1)[0].float()
        self.shape, self.low, self.sides = shape, verts.amin(0), verts.amax(0) - verts.amin(0)
        middles = (torch.arange(CELLS) + 0.5) / CELLS
        nodes = torch.stack(torch.meshgrid(middles, middles, middles, indexing="ij"), -1)
        free = shape.free((self.low + nodes * self.sides).view(-1, 3)).view(*nodes.shape[:3]) < 0
        lowest = self.low[2] + (free.float().argmax(2) + 0.5) / CELLS * self.sides[2]
        self.floor = lowest.masked_fill(~free.any(2), math.inf)
        self.volume = float(self.sides.prod() * free.float().mean())
        self.width = float(self.sides[:2].min())

    def has(self, points: Float[Tensor, "n 3"]) -> bool:
        """Whether the points are in it, or a little in its wall."""
        return float(self.shape.free(points).max()) < SUNK


def _tumbled(body: Body, scale: float, room: _Room, generator: torch.Generator) -> Placement:
    """A thing that lies over a random place of the room, tilted by chance."""
    lean, about, before, x, y = torch.rand(5, generator=generator).tolist()
    turn = about_z(2 * math.pi * about) @ about_x(TILT * (2 * lean - 1))
    turn = turn @ about_z(2 * math.pi * before) @ laid_down(body, 1.5)
    at = room.low + torch.tensor([x, y, 0.0]) * room.sides
    return Placement(scale, at - scale * turn @ body.box.mean(0), turn)


def _hovering(bodies: Sequence[Body], shape: Shape) -> list[list[Placement]]:
    """Each as far as possible from the others and turned a little."""
    radius = HOVERING * _inner_radius(shape)
    places = _free_places(shape, 4000, NEAR_WALL * radius + GAP)
    found: list[list[Placement]] = [[] for _ in bodies]
    generator = torch.Generator().manual_seed(1)
    taken = places[:1]
    for k in _pieces(bodies):
        at = places[torch.cdist(places, taken).amin(1).argmax()] if any(found) else taken[0]
        taken = torch.cat([taken, at[None]])
        body, (turned,) = bodies[k], torch.rand(1, generator=generator).tolist()
        turn, middle = about_z(math.pi * (turned - 0.5)), body.box.mean(0)
        scale = radius / float((body.verts - middle).norm(dim=1).max())
        found[k].append(Placement(scale, at - scale * turn @ middle, turn))
    return found
