"""Eyes, glints, mouths and other features of faces."""

from collections.abc import Sequence
from typing import NamedTuple

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    UP,
    Half,
    Margin,
    Pair,
    Points,
    Way,
    all_of,
    any_of,
    in_front,
    strokes,
    unit,
)


class Face(NamedTuple):
    """The front of a round head whose top is that of the part with the marking."""

    fraction: float = 1.0  # the head's radius in halves of the bearer's width
    radius: float = 0.0  # the same in training units, where the bearer's width is not the head's
    axis: int = 0  # 2: in halves of its height

    def places(self, points: Points, half: Half) -> tuple[Tensor, float]:
        """Positions to the right of the head's middle and above it, in radii; and the radius."""
        size = self.radius or self.fraction * float(half[self.axis])
        up = points[:, 2] - float(half[2]) + size
        return torch.stack([points[:, 0], up], 1) / size, size


HEAD = Face()


def ovals(
    points: Points, half: Half, at: Pair, size: Pair, face: Face = HEAD, both: bool = True
) -> Margin:
    """Two ovals on a face, mirrored, or only the one at ``at``; all in head radii."""
    place, radius = face.places(points, half)
    middles = [at, (-at[0], at[1])] if both else [at]
    found = []
    for middle in middles:
        off = (place - place.new_tensor(middle)) / place.new_tensor(size)
        found.append((1 - off.norm(dim=1)) * min(size))
    return all_of(any_of(*found) * radius, in_front(points))


def face_glints(
    points: Points, half: Half, at: Pair, size: Pair, face: Face = HEAD, large: float = 0.42
) -> Margin:
    """Reflections in two eyes, at the upper left of each: a ``large`` one and a small one."""
    place, radius = face.places(points, half)
    found = []
    for side in (-1, 1):
        for across, up, fraction in ((-0.3, 0.36, large), (0.28, -0.42, large / 2)):
            middle = (side * at[0] + across * size[0], at[1] + up * size[1])
            away = (place - place.new_tensor(middle)).norm(dim=1)
            found.append(fraction * size[0] - away)
    return all_of(any_of(*found) * radius, in_front(points))


def smile(
    points: Points,
    half: Half,
    at: float,
    wide: float,
    face: Face = HEAD,
    deep: float = 0.35,
    line: float = 0.055,
) -> Margin:
    """A line with raised ends.

    Args:
        at: the height of its middle, head radii.
        wide: half its width, head radii.
        deep: the height of its ends above the middle, in halves of its width.
        line: half the line's width, head radii.
    """
    place, radius = face.places(points, half)
    steps = [k / 4 for k in range(-4, 5)]
    curve = place.new_tensor([(wide * k, at + deep * wide * k * k) for k in steps])
    return all_of(strokes(place, curve, line) * radius, in_front(points))


MUZZLE = ((0.0, -0.36), (0.0, -0.56), (0.2, -0.72), (0.42, -0.7), (0.58, -0.5))


def muzzle_mouth(points: Points, half: Half, line: float = 0.08) -> Margin:
    """An animal's mouth below its nose: a line down that divides to both sides; half the line's
    width in halves of the muzzle's."""
    at = torch.stack([points[:, 0].abs(), points[:, 2]], 1) / half[0]
    return all_of(strokes(at, at.new_tensor(MUZZLE), line) * half[0], in_front(points))


Curve = tuple[Pair, ...]
FRONT = (0, 2)
SIDE = (1, 2)


def _right_eye(points: Points, half: Half) -> tuple[Points, Half]:
    """Places from the middle of the right eye, and half its box, where two eyes are one component
    and their common box is wide."""
    aside = half[0] - half[2]
    if aside < 0.7 * half[2]:
        return points, half
    return points - torch.stack([aside, 0 * aside, 0 * aside]), half[[2, 1, 2]]


def on_eye(points: Points, half: Half, spots: Sequence[tuple[Way, Pair]]) -> Margin:
    """Ovals on an eyeball.

    Args:
        spots: for each oval its direction from the eyeball's middle, and half its width and
            height in the eyeball's radii.
    """
    points, half = _right_eye(points, half)
    at = points / half
    at = at / at.norm(dim=1, keepdim=True).clamp_min(1e-6)
    found = []
    for way, (wide, high) in spots:
        out = unit(points, way)
        right = torch.linalg.cross(out, out.new_tensor(UP))
        right = right / right.norm().clamp_min(1e-6)
        up = torch.linalg.cross(right, out)
        across, along = at @ right, at @ up
        off = torch.hypot(across / wide, along / high)
        steep = torch.hypot(across / wide**2, along / high**2)
        inside = (1 - off) * (off + 1e-4) / (steep + 1e-4 / min(wide, high))
        found.append(torch.minimum(inside, at @ out))
    return any_of(*found) * half.mean()


def eye_glints(
    points: Points, half: Half, way: Way = (0.3, -0.75, 0.6), large: float = 0.3
) -> Margin:
    """Reflections in an eye: a large one and a small one opposite."""
    small = (way[0] + 0.35, way[1], way[2] - 0.85)
    return on_eye(points, half, ((way, (large, large)), (small, (large / 2, large / 2))))


def by_eyes(
    points: Points,
    half: Half,
    curves: Sequence[Curve],
    wide: float,
    axes: tuple[int, int] = FRONT,
    until: float = 99.0,
) -> Margin:
    """Lines on a face, such as mouths and brows, seen from the front or with ``SIDE`` from the
    side: in radii of an eye from its middle, no farther back than ``until``."""
    points, half = _right_eye(points, half)
    size = half.mean()
    at = points[:, list(axes)] / size
    lines = any_of(*(strokes(at, at.new_tensor(curve), wide) for curve in curves))
    return all_of(lines * size, until * size - points[:, 1])


def about_eyes(points: Points, half: Half, middles: Sequence[Way], sizes: Way) -> Margin:
    """Ellipsoids on a face, such as nostrils, cheeks and the insides of ears: in radii of an eye
    from its middle."""
    points, half = _right_eye(points, half)
    size, sides = half.mean(), points.new_tensor(sizes)
    found = []
    for middle in middles:
        off = (points / size - points.new_tensor(middle)) / sides
        found.append((1 - off.norm(dim=1)) * sides.min())
    return any_of(*found) * size


def round_eyes(points: Points, half: Half, at: tuple[float, float, float], radius: float) -> Margin:
    """Two balls on a front, such as eyes: distances to the side, ahead and below the top in
    training units."""
    aside, ahead, below = at
    x, y, z = points.unbind(1)
    off = torch.stack([x.abs() - aside, y + ahead, half[2] - z - below], 1)
    return radius - off.norm(dim=1)
