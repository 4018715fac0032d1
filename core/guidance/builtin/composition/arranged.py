"""Where the things of a composition lie."""

from collections.abc import Callable, Sequence

import torch

from core.geometry.mesh import NORMAL_RADIUS
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


def arranged(first: Body, others: Sequence[tuple[Relation, Body]]) -> list[Placement]:
    """The placements of the first thing and of the others, which are all of the training's size."""
    stuck = any(relation == "in" and is_stuck(first, other) for relation, other in others)
    found = [Placement.of(1.0, POINT_DOWN if stuck else None)]
    there = first.placed(found[0])
    for relation, other in others:
        found.append(_PLACED[relation](other, there))
    bodies = [first, *(other for _, other in others)]
    verts = torch.cat([body.placed(at).verts for body, at in zip(bodies, found, strict=True)])
    center = (verts.amin(0) + verts.amax(0)) / 2
    scale = NORMAL_RADIUS / float((verts - center).norm(dim=1).max())
    return [place.then(scale, -center * scale) for place in found]


_PLACED: dict[Relation, Callable[[Body, Body], Placement]] = {
    "on": lambda other, first: under(first, other),
    "in": lambda other, first: (pierced if is_stuck(first, other) else around)(first, other),
    "wears": worn,
    "holds": held,
    "bears": upon,
}
