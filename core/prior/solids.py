"""Signed distances of simple solids; negative inside, in the units of the points.

Formulas: Inigo Quilez, "Distance functions" and "2D distance functions" (iquilezles.org). A solid
is a function of points ``(N, 3)``; each of these is exact outside or, where the docstring states
it, a lower bound of the distance: sphere tracing needs one of the two.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from functools import reduce
from itertools import pairwise

import torch
from jaxtyping import Float
from torch import Tensor

Solid = Callable[[Float[Tensor, "n 3"]], Float[Tensor, " n"]]
Parts = dict[str, Solid]
Vector = tuple[float, float, float]
Point = tuple[float, float]


def _norm(*parts: Tensor) -> Tensor:
    return _sum(part * part for part in parts).sqrt()


def _sum(terms: Iterable[Tensor]) -> Tensor:
    return reduce(torch.add, terms)


def ball(center: Vector, radius: float) -> Solid:
    """A sphere."""
    x, y, z = center
    return lambda p: _norm(p[:, 0] - x, p[:, 1] - y, p[:, 2] - z) - radius


def ellipsoid(center: Vector, radii: Vector) -> Solid:
    """An ellipsoid; first-order estimate of the distance, exact at the surface."""

    def distance(p: Tensor) -> Tensor:
        scaled = (p - p.new_tensor(center)) / p.new_tensor(radii)
        # k0 - 1 over the length of its gradient, k1 / k0 (Quilez).
        k0 = scaled.norm(dim=1)
        k1 = (scaled / p.new_tensor(radii)).norm(dim=1).clamp_min(1e-9)
        return k0 * (k0 - 1) / k1

    return distance


def box(center: Vector, half: Vector, rounding: float = 0.0) -> Solid:
    """A box of half sizes ``half`` with edges rounded inwards by ``rounding``."""

    def distance(p: Tensor) -> Tensor:
        # Folded to one octant. Outside, the distance to the nearest corner, edge or face; inside,
        # to the nearest face.
        q = [(p[:, i] - center[i]).abs() - (half[i] - rounding) for i in range(3)]
        outside = _norm(*(side.clamp_min(0) for side in q))
        return outside + torch.maximum(q[0], torch.maximum(q[1], q[2])).clamp_max(0) - rounding

    return distance


def tube(start: Vector, end: Vector, radius: float, rounding: float = 0.0) -> Solid:
    """A cylinder from ``start`` to ``end`` with flat ends, their rims rounded inwards."""
    length = math.dist(start, end)
    axis = [(e - s) / length for s, e in zip(start, end, strict=True)]
    middle = [(e + s) / 2 for s, e in zip(start, end, strict=True)]

    def distance(p: Tensor) -> Tensor:
        q = [p[:, i] - middle[i] for i in range(3)]
        along = _sum(q[i] * axis[i] for i in range(3))
        across = _norm(*(q[i] - along * axis[i] for i in range(3)))
        # A box in two coordinates: across the axis and along it.
        a = across - (radius - rounding)
        b = along.abs() - (length / 2 - rounding)
        return _norm(a.clamp_min(0), b.clamp_min(0)) + torch.maximum(a, b).clamp_max(0) - rounding

    return distance


def capsule(start: Vector, end: Vector, radius: float) -> Solid:
    """All points within ``radius`` of a segment."""
    axis = [e - s for s, e in zip(start, end, strict=True)]
    square = sum(a * a for a in axis)

    def distance(p: Tensor) -> Tensor:
        q = [p[:, i] - start[i] for i in range(3)]
        # The nearest point of the segment, as a fraction of its length.
        h = (_sum(q[i] * axis[i] for i in range(3)) / square).clamp(0, 1)
        return _norm(*(q[i] - h * axis[i] for i in range(3))) - radius

    return distance


def ring(center: Vector, major: float, minor: float, axis: int = 2) -> Solid:
    """A torus about the coordinate axis ``axis``."""
    i, j = (k for k in range(3) if k != axis)

    def distance(p: Tensor) -> Tensor:
        # The distance to the circle, in the half plane through the axis and the point.
        across = _norm(p[:, i] - center[i], p[:, j] - center[j]) - major
        return _norm(across, p[:, axis] - center[axis]) - minor

    return distance


def polygon(u: Tensor, v: Tensor, corners: list[tuple[float, float]]) -> Tensor:
    """Exact signed distance of the points (u, v) to a simple polygon."""
    # Squares are compared, and one root is taken at the end.
    nearest = torch.full_like(u, math.inf)
    inside = torch.zeros_like(u, dtype=torch.bool)
    ax, ay = corners[-1]
    wx, wy, above = u - ax, v - ay, v >= ay
    for bx, by in corners:
        ex, ey = bx - ax, by - ay
        # An edge of no length is a point: the bound keeps h finite.
        squared = max(ex * ex + ey * ey, 1e-12)
        h = torch.add(wx * (ex / squared), wy, alpha=ey / squared).clamp_(0, 1)
        dx, dy = torch.add(wx, h, alpha=-ex), torch.add(wy, h, alpha=-ey)
        nearest = torch.minimum(nearest, dx.square_().addcmul_(dy, dy))
        # Inside by the even-odd rule: how often a level ray crosses the edges. Level edges never
        # do.
        above_a, above = above, v >= by
        if ay != by:
            left = torch.add(wy * ex, wx, alpha=-ey)
            inside ^= (above_a ^ above) & (left > 0 if ey > 0 else left <= 0)
        ax, ay, wx, wy = bx, by, u - bx, v - by
    distance = nearest.sqrt()
    return torch.where(inside, -distance, distance)


def lathe(
    profile: list[tuple[float, float]],
    rounding: float = 0.0,
    center: tuple[float, float] = (0.0, 0.0),
) -> Solid:
    """The profile (radius, height), from bottom to top, turned about the vertical through center.

    It is closed with flat ends at its first and last height; ``rounding`` grows it. The closing
    edge runs beyond the axis, so that it is never the nearest one.
    """
    # On the other side of the axis, as far as the profile is wide.
    beyond = -max(r for r, _ in profile)
    corners = [*profile, (beyond, profile[-1][1]), (beyond, profile[0][1])]

    def distance(p: Tensor) -> Tensor:
        across = _norm(p[:, 0] - center[0], p[:, 1] - center[1])
        return polygon(across, p[:, 2], corners) - rounding

    return distance


def prism(corners: list[tuple[float, float]], axis: int, half: float, middle: float = 0.0) -> Solid:
    """A polygon in the other two coordinates (in their order), extruded along ``axis``."""
    i, j = (k for k in range(3) if k != axis)

    def distance(p: Tensor) -> Tensor:
        a = polygon(p[:, i], p[:, j], corners)
        b = (p[:, axis] - middle).abs() - half
        return _norm(a.clamp_min(0), b.clamp_min(0)) + torch.maximum(a, b).clamp_max(0)

    return distance


def outlined(side: list[tuple[float, float]], half: list[tuple[float, float]]) -> Solid:
    """A solid with the outline ``side`` (y, z) seen from the side and ``half``, mirrored, seen from
    above; a lower bound of the distance."""
    return within(prism(side, 0, 2), prism(mirrored(half), 2, 4))


def lozenge_blade(
    low: float, high: float, wide: float, thick: float, tip: float, slim: float
) -> Solid:
    """A blade with a lozenge as its section, half ``wide`` along x and half ``thick`` along y at
    its base, ``slim`` times that where its point of length ``tip`` starts; a lower bound of the
    distance."""
    slope, steep = (slim - 1) / (high - tip - low), slim / tip

    def distance(p: Tensor) -> Tensor:
        across, z = p[:, 0].abs() / wide + p[:, 1].abs() / thick, p[:, 2]
        side = (across - 1 - slope * (z - low)) / math.hypot(1 / wide, 1 / thick, slope)
        point = (across - steep * (high - z)) / math.hypot(1 / wide, 1 / thick, steep)
        return torch.maximum(torch.maximum(side, point), low - z)

    return distance


def cut(solid: Solid, *holes: Solid) -> Solid:
    """``solid`` without the holes; a lower bound of the distance."""

    def distance(p: Tensor) -> Tensor:
        result = solid(p)
        for hole in holes:
            # Exact for neither at the rim, where the nearest point of one is within the other.
            result = torch.maximum(result, -hole(p))
        return result

    return distance


def within(solid: Solid, region: Solid) -> Solid:
    """The intersection of ``solid`` and ``region``; a lower bound of the distance."""
    return cut(solid, lambda p: -region(p))


def grown(solid: Solid, by: float) -> Solid:
    """``solid`` with its surface moved outwards."""
    return lambda p: solid(p) - by


def flattened(solid: Solid, along_y: float) -> Solid:
    """``solid`` scaled along y by the factor ``along_y``, below 1; a lower bound of the
    distance."""
    return lambda p: solid(p * p.new_tensor([1, 1 / along_y, 1])) * along_y


def join(*solids: Solid) -> Solid:
    """The union; exact outside."""

    def distance(p: Tensor) -> Tensor:
        result = solids[0](p)
        for solid in solids[1:]:
            result = torch.minimum(result, solid(p))
        return result

    return distance


def taper(start: Vector, end: Vector, first: float, last: float) -> Solid:
    """The hull of a ball of radius ``first`` at ``start`` and one of ``last`` at ``end``; exact."""
    along = [e - s for s, e in zip(start, end, strict=True)]
    square, shrink = sum(a * a for a in along), first - last
    # Quilez's round cone; its lengths are multiplied by |along|² until the end, so that the axis
    # needs no root.
    slope = square - shrink * shrink

    def distance(p: Tensor) -> Tensor:
        q = [p[:, i] - start[i] for i in range(3)]
        y = _sum(q[i] * along[i] for i in range(3))
        z = y - square
        across = _sum((q[i] * square - along[i] * y) ** 2 for i in range(3))
        y2, z2 = y * y * square, z * z * square
        # Three regions: the first ball's, the side's and the last ball's.
        k = math.copysign(shrink * shrink, shrink) * across
        side = ((across * slope / square).sqrt() + y * shrink) / square - first
        at_first = (across + y2).sqrt() / square - first
        at_last = (across + z2).sqrt() / square - last
        inner = torch.where(z.sign() * slope * z2 > k, at_last, side)
        return torch.where(y.sign() * slope * y2 < k, at_first, inner)

    return distance


def chain(stops: Iterable[tuple[Vector, float]]) -> Solid:
    """The hulls of each two successive balls; a ball is given by its centre and its radius."""
    return join(*(taper(a, b, first, last) for (a, first), (b, last) in pairwise(stops)))


def limb(points: Sequence[Vector], first: float, last: float) -> Solid:
    """A round bar through the points, its radius from ``first`` to ``last``."""
    count = len(points) - 1
    return chain((at, first + (last - first) * k / count) for k, at in enumerate(points))


def egg(center: Vector, radii: Vector) -> Solid:
    """An ellipsoid; a lower bound of the distance."""
    # |p / r| grows by at most 1 / smallest a unit, so times ``smallest`` it is no more than a
    # distance.
    smallest = min(radii)

    def distance(p: Tensor) -> Tensor:
        return (_norm(*((p[:, i] - center[i]) / radii[i] for i in range(3))) - 1) * smallest

    return distance


def blend(width: float, *solids: Solid) -> Solid:
    """The union with its creases filled over ``width`` (Quilez's polynomial minimum); a lower
    bound."""

    def distance(p: Tensor) -> Tensor:
        result = solids[0](p)
        for solid in solids[1:]:
            other = solid(p)
            # Only where the distances differ by less than ``width``: by a quarter of it at the
            # crease.
            h = (0.5 + 0.5 * (other - result) / width).clamp(0, 1)
            result = other + (result - other) * h - width * h * (1 - h)
        return result

    return distance


def moved(solid: Solid, by: Vector) -> Solid:
    """``solid`` moved by the vector ``by``."""
    return lambda p: solid(p - p.new_tensor(by))


def turned(solid: Solid, axis: int, degrees: float) -> Solid:
    """``solid`` turned about a coordinate axis, counter-clockwise seen from its tip."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3

    def distance(p: Tensor) -> Tensor:
        q = list(p.unbind(1))
        # The point turns backwards, which turns the solid forwards.
        q[i], q[j] = c * p[:, i] + s * p[:, j], c * p[:, j] - s * p[:, i]
        return solid(torch.stack(q, 1))

    return distance


def tilted(solid: Solid, degrees: float, at: Vector) -> Solid:
    """``solid``, made about the origin, with its front lowered, then moved to ``at``."""
    return moved(turned(solid, 0, degrees), at)


def both(solid: Solid, *axes: int) -> Solid:
    """``solid``, made on the positive side of the axes (x if none are given), mirrored at each."""
    folded = axes or (0,)

    def distance(p: Tensor) -> Tensor:
        # The mirrored half is the solid seen from the mirrored point.
        q = [p[:, i].abs() if i in folded else p[:, i] for i in range(3)]
        return solid(torch.stack(q, 1))

    return distance


def around(count: int, solid: Solid, first_deg: float = 0.0) -> Solid:
    """``count`` copies about +Z of ``solid``, which is at +X and is symmetric in y."""
    step = 2 * math.pi / count

    def distance(p: Tensor) -> Tensor:
        angle = torch.atan2(p[:, 1], p[:, 0]) - math.radians(first_deg)
        # Into the sector of the nearest copy: by its symmetry no other copy is nearer.
        angle = angle - (angle / step).round() * step
        radius = _norm(p[:, 0], p[:, 1])
        return solid(torch.stack([radius * angle.cos(), radius * angle.sin(), p[:, 2]], 1))

    return distance


def mirrored(half: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The outline whose side x >= 0 is ``half``."""
    return [*half, *((-u, v) for u, v in reversed(half))]


def smooth_curve(points: list[tuple[float, float]], steps: int = 4) -> list[tuple[float, float]]:
    """A Catmull-Rom curve through the points, with ``steps`` segments between two of them."""
    # Each end twice: Catmull-Rom needs a neighbour on either side.
    padded = [points[0], *points, points[-1]]
    curve = []
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:], strict=False):
        for k in range(steps):
            t = k / steps
            curve.append(tuple(_catmull_rom(t, *(q[i] for q in (a, b, c, d))) for i in (0, 1)))
    return [*curve, points[-1]]


def _catmull_rom(t: float, a: float, b: float, c: float, d: float) -> float:
    slope, bend, twist = c - a, 2 * a - 5 * b + 4 * c - d, 3 * b - a - 3 * c + d
    return b + 0.5 * t * (slope + t * (bend + t * twist))
