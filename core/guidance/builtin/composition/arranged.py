"""Where the things of a composition lie."""

from collections.abc import Callable, Sequence

import torch

from core.geometry.mesh import NORMAL_RADIUS
from core.guidance.builtin.composition.copies import copies_of
from core.guidance.builtin.composition.holding import held
from core.guidance.builtin.composition.placement import Body, Placement
from core.guidance.builtin.composition.resting import (
    POINT_DOWN,
    around,
    is_stuck,
    pierced,
    under,
    upon,
)
from core.guidance.builtin.composition.wearing import worn
from core.guidance.builtin.words.companions import Relation


def arranged(first: Body, others: Sequence[tuple[Relation, Body]]) -> list[list[Placement]]:
    """The placements of each copy of the first thing, and of each of the others, which are all of
    the training's size."""
    things = [first, *(other for _, other in others)]
    copies = [copies_of(thing) for thing in things]
    groups = [
        thing.group(places) if len(places) > 1 else thing
        for thing, places in zip(things, copies, strict=True)
    ]
    pairs = [(relation, group) for (relation, _), group in zip(others, groups[1:], strict=True)]
    stuck = any(relation == "in" and is_stuck(first, other) for relation, other in pairs)
    found = [Placement.of(1.0, POINT_DOWN if stuck else None)]
    there = groups[0].placed(found[0])
    for relation, group in pairs:
        found.append(_PLACED[relation](group, there))
    verts = torch.cat([group.placed(at).verts for group, at in zip(groups, found, strict=True)])
    center = (verts.amin(0) + verts.amax(0)) / 2
    scale = NORMAL_RADIUS / float((verts - center).norm(dim=1).max())
    whole = [place.then(scale, -center * scale) for place in found]
    return [[at.of_copy(one) for one in each] for at, each in zip(whole, copies, strict=True)]


_PLACED: dict[Relation, Callable[[Body, Body], Placement]] = {
    "on": lambda other, first: under(first, other),
    "in": lambda other, first: (pierced if is_stuck(first, other) else around)(first, other),
    "wears": worn,
    "holds": held,
    "bears": upon,
}
