"""Box faces that were meant to be in one plane are moved into it: a seat's side and its back's."""

import itertools

import numpy as np
from jaxtyping import Float
from scipy.sparse.csgraph import connected_components

from core.geometry.parts.primitives import Primitive

STEP = 0.015  # training units, at most, between faces that are one plane
OVER = 0.5  # of the smaller face, its part upon the other: a pane on its wall stays
UPRIGHT = 1e-6  # of a cosine: along the coordinate axes


def flush(components: list[Primitive | None]) -> list[Primitive | None]:
    """The components; faces of sharp boxes along the axes that look to one side and are nearly in
    one plane are moved into their mean plane."""
    upright = {k: one for k, one in enumerate(components) if one is not None and is_upright(one)}
    ends = {k: ends_of(one) for k, one in upright.items()}
    made = {k: corners.copy() for k, corners in ends.items()}
    for side, axis in itertools.product(range(2), range(3)):
        across = [i for i in range(3) if i != axis]
        for group in groups(ends, side, axis):
            areas = [np.prod((ends[k][1] - ends[k][0])[across]) for k in group]
            place = np.average([ends[k][side, axis] for k in group], weights=areas)
            for k in group:
                made[k][side, axis] = place
    return [
        _between(upright[k], made[k]) if k in upright else one for k, one in enumerate(components)
    ]


def is_upright(one: Primitive) -> bool:
    """Whether it is a sharp box along the axes."""
    along = np.abs(one.frame).max(0) > 1 - UPRIGHT
    return bool(one.form == "box" and one.lengths[3] == 0 and along.all())


def ends_of(one: Primitive) -> Float[np.ndarray, "2 3"]:
    """The lower and the upper corner of an upright box."""
    half = np.abs(one.frame) @ one.lengths[:3]
    return np.stack([one.center - half, one.center + half])


def groups(ends: dict[int, Float[np.ndarray, "2 3"]], side: int, axis: int) -> list[list[int]]:
    """The boxes whose faces on one side of an axis lie in one plane, next to each other."""
    boxes, count = list(ends), len(ends)
    near = np.zeros((count, count), bool)
    for (i, a), (j, b) in itertools.combinations(enumerate(ends.values()), 2):
        step = abs(a[side, axis] - b[side, axis])
        near[i, j] = step < STEP and overlap(a, b, axis) < OVER
    label = connected_components(near, directed=False)[1] if boxes else []
    found: dict[int, list[int]] = {}
    for box, group in zip(boxes, label, strict=True):
        found.setdefault(int(group), []).append(box)
    return list(found.values())


def overlap(a: Float[np.ndarray, "2 3"], b: Float[np.ndarray, "2 3"], axis: int) -> float:
    """The fraction of the smaller of two faces across an axis that is upon the other."""
    others = [i for i in range(3) if i != axis]
    low, high = np.maximum(a[0], b[0])[others], np.minimum(a[1], b[1])[others]
    least = min(np.prod((x[1] - x[0])[others]) for x in (a, b))
    return float(np.prod((high - low).clip(min=0)) / max(least, 1e-12))


def _between(one: Primitive, ends: Float[np.ndarray, "2 3"]) -> Primitive:
    half = np.abs(one.frame).T @ (ends[1] - ends[0]) / 2
    return one._replace(center=ends.mean(0), lengths=np.append(half, one.lengths[3:]))
