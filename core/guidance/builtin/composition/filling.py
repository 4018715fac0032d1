"""What fills an open vessel up to some way below its rim: a level liquid, or a heap."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import torch
from jaxtyping import Float

from core.geometry.init_shape import sample_surface
from core.geometry.parts.primitives import Primitive, packed
from core.guidance.builtin.composition.glass.vessels import UPRIGHT
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.placing.resting import OVER_THE_RIM
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.constructed.solid import ConstructedSolid
from core.guidance.builtin.palette import looks
from core.guidance.builtin.stretch import training_size
from core.guidance.builtin.words.companions.search import Relation

SAMPLES, SECTORS = 80_000, 72
OUTSIDE = (*OVER_THE_RIM, "stem", "foot", "wheel", "wheels", "frame", "column", "cover")
LEVEL, HEAP_LEVEL = 0.9, 0.9  # of the vessel's height
SLICE = 0.03  # of its height: what counts as at that level
INTO_WALL = 0.5  # of a wall: so far into it the filling goes
HALF = 0.025  # training units: half a liquid's thickness
SEEN = 0.6  # of the sectors: with a wall, at least
OPEN = 0.35  # of the width: in the middle there is nothing above the level
HEAPED, WIDE = 0.5, 0.92  # of half its width: how high and how wide a heap is


def filled(
    things: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation]
) -> tuple[list[Thing], list[Body], list[bool]]:
    """The things with what fills the first as solids of its form, and whether each other one fits:
    a vessel that is closed, or of which the wall is not found, cannot be filled."""
    things, bodies, fits = list(things), list(bodies), []
    for k, how in enumerate(relations, 1):
        found = _filling(things[k], bodies[k], bodies[0]) if how == "fills" else None
        fits.append(how != "fills" or found is not None)
        if found is not None:
            things[k], bodies[k] = found
    return things, bodies, fits


def _filling(thing: Thing, body: Body, vessel: Body) -> tuple[Thing, Body] | None:
    heaped = body.words.noun == "ball"
    outline = _outline(vessel, HEAP_LEVEL if heaped else LEVEL)
    if outline is None or thing.solid is None:
        return None
    loop, level = outline
    low, high = loop.min(0), loop.max(0)
    middle, half = (low + high) / 2, (high - low) / 2
    top = HEAPED * float(half.min()) if heaped else HALF
    ends = torch.tensor([[*low, level - HALF], [*high, level + top]]).float()
    scale, shift = training_size(ends)
    moved = shift.double().numpy()
    disc = packed([(-scale * HALF, scale * HALF, [scale * (loop - middle)])])
    center = scale * np.array([*middle, level]) + moved
    solids = [Primitive("layers", center, UPRIGHT, disc)]
    if heaped:
        lengths = scale * np.array([*(WIDE * half), top])
        solids.append(Primitive("ellipsoid", center, UPRIGHT, lengths))
    names = tuple(looks(body.words.noun))
    exact = {"solids": {names[0]: solids}, "names": names}
    solid = ConstructedSolid(thing.solid.net, thing.solid.triplane, **exact)
    place = Placement.of().then(scale, shift).inverted()
    return thing.with_solid(solid), replace(Body.of(body.words, solid), rests=place)


def _outline(vessel: Body, at: float) -> tuple[Float[np.ndarray, "s 2"], float] | None:
    """The outline in the middle of a vessel's wall at a level, counter-clockwise, and the level;
    None where there is no wall around a hollow."""
    body = vessel.bare(*OUTSIDE)
    if not len(body.faces):
        return None
    points = sample_surface(body.verts, body.faces, SAMPLES, torch.Generator().manual_seed(0))
    found = points.double().numpy()
    low, high = found.min(0), found.max(0)
    level = float(low[2] + at * (high[2] - low[2]))
    near = found[np.abs(found[:, 2] - level) < SLICE * (high[2] - low[2])]
    middle = (low[:2] + high[:2]) / 2
    off = near[:, :2] - middle
    angle, radius = np.arctan2(off[:, 1], off[:, 0]), np.linalg.norm(off, axis=1)
    sector = ((angle / math.tau + 0.5) * SECTORS).astype(int).clip(0, SECTORS - 1)
    wall = np.full(SECTORS, np.nan)
    for k in np.unique(sector):
        inner, outer = np.quantile(radius[sector == k], (0.02, 0.98))
        wall[k] = inner + INTO_WALL * (outer - inner)
    known = np.flatnonzero(~np.isnan(wall))
    inside = np.linalg.norm(found[:, :2] - middle, axis=1) < OPEN * np.nanmin(wall, initial=np.inf)
    if len(known) < SEEN * SECTORS or (found[inside, 2] > level).any() or not inside.any():
        return None
    wall = np.interp(np.arange(SECTORS), known, wall[known], period=SECTORS)
    turn = (np.arange(SECTORS) + 0.5) / SECTORS * math.tau - math.pi
    return middle + wall[:, None] * np.stack([np.cos(turn), np.sin(turn)], 1), level
