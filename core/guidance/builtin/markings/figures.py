"""Markings of people and animals: faces, and what is sewn on clothes."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import torch
from torch import Tensor

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    all_of,
    any_of,
    in_front,
    strokes,
)

At = tuple[float, float]


class Face(NamedTuple):
    """The front of a round head that ends at the top of what bears the marking."""

    share: float = 1.0  # the head's radius in halves of the bearer's width
    radius: float = 0.0  # the same in training units, where the bearer's width is not the head's
    axis: int = 0  # 2: in halves of its height

    def places(self, points: Points, half: Half) -> tuple[Tensor, float]:
        """To the right of the head's middle and above it, in radii; and the radius."""
        size = self.radius or self.share * float(half[self.axis])
        up = points[:, 2] - float(half[2]) + size
        return torch.stack([points[:, 0], up], 1) / size, size


HEAD = Face()


def ovals(
    points: Points, half: Half, at: At, size: At, face: Face = HEAD, both: bool = True
) -> Margin:
    """Two on a face, alike on both sides, or only that at ``at``; all in head radii."""
    place, radius = face.places(points, half)
    middles = [at, (-at[0], at[1])] if both else [at]
    found = []
    for middle in middles:
        off = (place - place.new_tensor(middle)) / place.new_tensor(size)
        found.append((1 - off.norm(dim=1)) * min(size))
    return all_of(any_of(*found) * radius, in_front(points))


def glints(
    points: Points, half: Half, at: At, size: At, face: Face = HEAD, large: float = 0.42
) -> Margin:
    """The light in two eyes, at the upper left of each: a ``large`` one and a small one."""
    place, radius = face.places(points, half)
    found = []
    for side in (-1, 1):
        for across, up, share in ((-0.3, 0.36, large), (0.28, -0.42, large / 2)):
            middle = (side * at[0] + across * size[0], at[1] + up * size[1])
            away = (place - place.new_tensor(middle)).norm(dim=1)
            found.append(share * size[0] - away)
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
    """A line that is bent up at its ends: its middle's height, half its width and half the line's,
    in head radii; ``deep``: how far the ends are above the middle, in half widths."""
    place, radius = face.places(points, half)
    steps = [k / 4 for k in range(-4, 5)]
    curve = place.new_tensor([(wide * k, at + deep * wide * k * k) for k in steps])
    return all_of(strokes(place, curve, line) * radius, in_front(points))


def dots(
    points: Points, half: Half, places: Sequence[At], size: float, both: bool = False
) -> Margin:
    """Round ones on a front, as buttons: of each how far to the right and up, in halves; the size
    in halves of the width; ``both``: the same on the left."""
    x = points[:, 0].abs() if both else points[:, 0]
    middles = points.new_tensor(places) * half[[0, 2]]
    away = torch.cdist(torch.stack([x, points[:, 2]], 1), middles).amin(1)
    return all_of(size * half[0] - away, in_front(points))


def buckle(points: Points, half: Half, below: float, wide: float, hole: At) -> Margin:
    """On the front of a belt, as high as that is: how far its middle is below the top of what the
    belt is of, half its width and the half sides of its hole, in training units."""
    x, up = points[:, 0].abs(), (points[:, 2] - half[2] + below).abs()
    within = all_of(hole[0] - x, hole[1] - up)
    return all_of(wide - x, 2 * wide - up, -within, in_front(points))


def pockets(
    points: Points, half: Half, at: At, size: At, line: float = 0.014, both: bool = True
) -> Margin:
    """The seams of patch pockets on a front, each with a flap; in halves, half the line's width in
    training units."""
    x = points[:, 0].abs() if both else points[:, 0]
    across, up = x - at[0] * half[0], points[:, 2] - at[1] * half[2]
    wide, high = size[0] * half[0], size[1] * half[2]
    edge = line - torch.maximum(across.abs() - wide, up.abs() - high).abs()
    # A flap's lower edge comes to a point.
    flap = line - (up - 0.35 * high + (0.35 - 0.35 * across.abs() / wide) * high).abs()
    return all_of(any_of(edge, all_of(flap, wide - across.abs())), in_front(points))


def upright(
    points: Points, half: Half, across: Sequence[float], low: float, high: float, line: float
) -> Margin:
    """Lines down a front, as seams and plackets; how far to the right, and from where to where, in
    halves, half a line's width in training units."""
    off = torch.stack([(points[:, 0] - at * half[0]).abs() for at in across]).amin(0)
    z = points[:, 2]
    return all_of(line - off, z - low * half[2], high * half[2] - z, in_front(points))


def wrapped(points: Points, half: Half, at: At, wide: float, line: float = 0.018) -> Margin:
    """The two edges of a jacket that is crossed over the chest: a V from the shoulders to ``at``,
    the height of its lower end and of its upper ones in halves; ``wide``: how far apart these are,
    in halves of the width."""
    x, z = points[:, 0].abs(), points[:, 2]
    low, high = at[0] * float(half[2]), at[1] * float(half[2])
    reach = wide * float(half[0])
    steep = math.hypot(high - low, reach)
    away = (x * (high - low) - (z - low) * reach).abs() / steep
    return all_of(line - away, z - low + 0.01, high - z, in_front(points))


def hoop(points: Points, half: Half, at: float, wide: float, within: float = 2.0) -> Margin:
    """A band about a trunk, not on what is beside it: its middle's height and half its width in
    halves, ``within`` halves of the width."""
    band = wide * half[2] - (points[:, 2] - at * half[2]).abs()
    return all_of(band, within * half[0] - points[:, 0].abs())


MUZZLE = ((0.0, -0.36), (0.0, -0.56), (0.2, -0.72), (0.42, -0.7), (0.58, -0.5))


def muzzle_mouth(points: Points, half: Half, line: float = 0.08) -> Margin:
    """The mouth of a beast below its nose: a line down that parts to both sides; half the line's
    width in halves of the muzzle's."""
    at = torch.stack([points[:, 0].abs(), points[:, 2]], 1) / half[0]
    return all_of(strokes(at, at.new_tensor(MUZZLE), line) * half[0], in_front(points))


def patches(points: Points, half: Half, at: At, size: At, both: bool = True) -> Margin:
    """Ovals on a front, in halves of it."""
    x = points[:, 0].abs() if both else points[:, 0]
    wide, high = size[0] * float(half[0]), size[1] * float(half[2])
    off = torch.hypot((x - at[0] * half[0]) / wide, (points[:, 2] - at[1] * half[2]) / high)
    return all_of((1 - off) * min(wide, high), in_front(points))


def scales(points: Points, half: Half, pitch: float = 0.26, line: float = 0.011) -> Margin:
    """A fish's, as rows of arcs that bulge to its tail, and the edge of its gills; its head is at
    -y."""
    _, y, z = points.unbind(1)
    along, up = y / pitch * 2, z / pitch
    column = along.floor()
    row = up - 0.5 * column.remainder(2)
    away = torch.hypot((along - column) / 2, row - row.round())
    arcs = line - (away - 0.5).abs() * pitch
    behind = y + 0.22 * half[1]
    from_it = torch.hypot(y + 0.8 * half[1], 0.8 * z)
    gills = all_of(1.5 * line - (from_it - 0.44 * half[1]).abs(), y + 0.75 * half[1])
    return any_of(all_of(arcs, behind), gills)


def panels(points: Points, _half: Half, count: int = 6, line: float = 0.012) -> Margin:
    """The seams of a cap that meet at its top."""
    turn = torch.atan2(points[:, 0], -points[:, 1]) * (count / math.tau)
    away = (turn - turn.round()).abs() * (math.tau / count)
    return line - away.sin() * points[:, :2].norm(dim=1)


def folds(points: Points, half: Half, count: int = 14, line: float = 0.012) -> Margin:
    """Of a skirt, from a little below its waist to its hem, the wider the lower."""
    below = ((half[2] - points[:, 2]) / (2 * half[2])).clamp(0, 1)
    return panels(points, half, count, line) - 2 * line * (1 - below)


def shirt_seams(points: Points, half: Half, wide: float = 0.13, line: float = 0.013) -> Margin:
    """The edges of a shirt's placket, and the seam above its hem."""
    edges = upright(points, half, (-wide, wide), -0.86, 0.62, line)
    hem = line - (points[:, 2] + 0.86 * half[2]).abs()
    return any_of(edges, hem)


def trouser_seams(points: Points, half: Half, line: float = 0.013) -> Margin:
    """The fly in front, and seams down the outer sides of both legs."""
    fly = upright(points, half, (0.0,), 0.3, 0.9, line)
    x, y, z = points[:, 0].abs(), points[:, 1], points[:, 2]
    curve = (torch.hypot(points[:, 0], z - 0.62 * half[2]) - 0.2 * half[0]).abs()
    curve = all_of(line - curve, 0.5 * half[2] + 0.12 * half[2] - z, points[:, 0], in_front(points))
    stitch = all_of(
        line - (points[:, 0] - 0.2 * half[0]).abs(), z - 0.62 * half[2], in_front(points)
    )
    sides = all_of(1.2 * line - y.abs(), x - 0.5 * half[0])
    return any_of(fly, curve, stitch, sides)


def dashed(
    points: Points, half: Half, at: float, wide: float, pitch: float = 0.09, gap: float = 0.35
) -> Margin:
    """Stitches about a shoe's sole: their height and half their width in halves, a ``gap``'s share
    of the pitch."""
    step = (points[:, 1] + points[:, 0]) / pitch
    dash = ((1 - gap) / 2 - (step - step.round()).abs()) * pitch
    return all_of(hoop(points, half, at, wide), dash)


def jacket_seams(points: Points, half: Half, line: float = 0.013) -> Margin:
    """The yoke's edge below both shoulders, and seams down the sides of the front."""
    yoke = all_of(
        line - (points[:, 2] - 0.42 * half[2] - 0.1 * points[:, 0].abs()).abs(),
        0.52 * half[0] - points[:, 0].abs(),
    )
    return any_of(yoke, upright(points, half, (-0.32, 0.32), -0.8, 0.42, line))
