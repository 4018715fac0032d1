"""A jerrycan, goggles, a spyglass, a pirate's hat, a briefcase."""

import math
from typing import TypeVar

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    tube,
    turned,
    within,
)

Number = TypeVar("Number", float, Tensor)
FLARE = 0.26  # of a tricorn's brim: how much wider it is a unit higher


def _flare(height: Number) -> Number:
    """How much wider a hat's brim is at this height."""
    return 1 + FLARE * height


def _flared(solid: Solid) -> Solid:
    """``solid``, of up to 1.2 from the axis and in height, widened by :func:`_flare`; a lower
    bound."""

    def distance(p: Tensor) -> Tensor:
        k = _flare(p[:, 2:].clamp(0, 1))
        return solid(torch.cat([p[:, :2] / k, p[:, 2:]], 1)) * 0.78

    return distance


def jerrycan(draw: Draw) -> Parts:
    """An upright can, an X on both faces, three bars to carry it by, its spout at a corner."""
    x, y, high, soft = draw(0.74, 0.82), draw(0.42, 0.46), draw(1.68, 1.84), 0.12
    slant, r, rise = draw(0.36, 0.42), 0.09, draw(0.26, 0.3)
    side = [(-x, 0), (x, 0), (x, high - slant), (x - slant, high), (-x + 0.14, high)]
    side += [(-x, high - 0.14)]
    middle, tall, wide = high * 0.48, high * 0.36, x * 0.68

    def outline(by: float) -> list[tuple[float, float]]:
        """The can's own, drawn in towards its middle."""
        k, m = 1 - by / x, 1 - by / (high / 2)
        return [(u * k, high / 2 + (v - high / 2) * m) for u, v in side]

    lean = math.degrees(math.atan2(wide, tall))
    bar = box((0, y, 0), (0.12, 0.12, math.hypot(wide, tall)), 0.05)
    cross = join(turned(bar, 1, lean), turned(bar, 1, -lean))
    left, right, top = -x + 0.2, x - slant - 0.02, high + rise
    half = (right - left) / 2
    path = [(-half, high - 0.08), (0.1 - half, top), (half - 0.1, top), (half, high - 0.08)]
    bow = limb([((left + right) / 2 + u, 0, v) for u, v in path], r, r)
    spout = (x - slant * 0.5, 0, high - slant * 0.5)

    def out(along: float) -> tuple[float, float, float]:
        return (spout[0] + along * 0.64, 0, spout[2] + along * 0.77)

    return {
        "body": join(
            grown(prism(outline(soft), 1, y - soft), soft), tube(out(-0.1), out(0.12), 0.17)
        ),
        "cross": both(moved(cross, (0, 0, middle)), 1),
        "handles": join(bow, both(moved(bow, (0, y - 0.08, 0)), 1)),
        "cap": tube(out(0.08), out(0.34), 0.23, 0.05),
        "seam": grown(prism(outline(0), 1, 0.06), 0.06),
    }


def goggles(draw: Draw) -> Parts:
    """An aviator's: two cups with thick rims, a bridge, a strap round an absent head."""
    r, deep, z = draw(0.43, 0.48), draw(0.2, 0.28), 0.56
    x, toe = r + draw(0.18, 0.2), draw(8, 13)
    wide, long, half = x + r + 0.06, draw(0.95, 1.1), draw(0.17, 0.2)
    front, turns = -long * 0.36, [k * math.tau / 40 for k in range(40)]

    def cup(solid: Solid) -> Solid:
        """What was turned about z, its top to the front, to where the right eye is."""
        return moved(turned(turned(solid, 0, 90), 2, toe), (x, front, z))

    def oval(by: float) -> list[tuple[float, float]]:
        return [((wide + by) * math.cos(t), (long + by) * math.sin(t)) for t in turns]

    hole, pane = (tube((0, 0, -1), (0, 0, 2), r - k) for k in (0.14, 0.09))
    body = cut(lathe([(r + 0.1, -0.22), (r + 0.08, -0.06), (r + 0.01, deep)], 0.02), hole)
    rim = cut(tube((0, 0, deep - 0.06), (0, 0, deep + 0.18), r + 0.1, 0.05), pane)
    band = cut(prism(oval(0), 2, half, z), prism(oval(-0.2), 2, 2, z))
    bar, at = (0.13, front - deep - 0.02, z + 0.08), front + 0.42
    buckle = box((wide - 0.1, at, z), (0.19, 0.13, half + 0.09), 0.04)
    return {
        "cups": both(cup(body)),
        "rims": join(both(cup(rim)), both(buckle)),
        "lenses": both(cup(egg((0, 0, deep - 0.02), (r - 0.04, r - 0.04, 0.15)))),
        "strap": cut(band, box((0, front - 0.92, z), (2, 1, 1)), both(cup(hole))),
        "bridge": capsule((-bar[0], *bar[1:]), bar, 0.13),
    }


def spyglass(draw: Draw) -> Parts:
    """It lies along x, drawn out, its lens to the left: a barrel and two narrower tubes."""
    r, long = draw(0.225, 0.255), draw(1.02, 1.16)
    mid, last = draw(0.54, 0.66), draw(0.46, 0.58)
    radii, up = (r, r - 0.055, r - 0.11), r + 0.09
    ends = (long, long + mid, long + mid + last)
    whole = ends[2] + 0.14

    def lying(solid: Solid) -> Solid:
        """What was turned about z, its foot to the left."""
        return moved(turned(solid, 1, 90), (-whole / 2, 0, up))

    def band(low: float, high: float, radius: float) -> Solid:
        return tube((0, 0, low), (0, 0, high), radius, 0.03)

    mouth = tube((0, 0, -1), (0, 0, 0.14), r - 0.04)
    return {
        "barrel": lying(lathe([(r + 0.02, 0.1), (r - 0.01, ends[0])])),
        "tubes": lying(
            join(
                tube((0, 0, 0.5), (0, 0, ends[1]), radii[1]),
                tube((0, 0, 1.0), (0, 0, ends[2]), radii[2]),
            )
        ),
        "bands": lying(
            join(
                cut(band(0, 0.26, r + 0.09), mouth),
                band(ends[0] - 0.1, ends[0] + 0.08, r + 0.08),
                band(ends[1] - 0.1, ends[1] + 0.08, radii[1] + 0.08),
            )
        ),
        "lens": lying(egg((0, 0, 0.17), (r, r, 0.13))),
        "eyepiece": lying(lathe([(radii[2] + 0.03, ends[2] - 0.1), (radii[2] + 0.1, whole)], 0.02)),
    }


def pirate_hat(draw: Draw) -> Parts:
    """A tricorn, a flap to the front: a dome in a brim folded up thrice, gold along it, a plume."""
    r, point, high = draw(0.5, 0.54), draw(1.08, 1.16), draw(0.74, 0.84)
    low, dome = draw(0.34, 0.4), draw(1.02, 1.12)
    s, c = math.sin(math.pi / 3) * point, math.cos(math.pi / 3) * point
    # Half a flap's edge: along it, out from the middle, up.
    edge = [
        (0.0, r + 0.03, high),
        (0.3, r, high * 0.95),
        (0.62, r - 0.03, high * 0.74),
        (s, c, low),
    ]
    line = smooth_curve([(v, u) for v, u, _ in edge])
    rise = smooth_curve([(v, w) for v, _, w in edge])
    flap = [*((-v, u) for v, u in reversed(line[1:])), *line[:-1]]
    turns = [(math.cos(a), math.sin(a)) for a in (math.radians(k) for k in (30, 150, 270))]
    plan = [(u * i - v * j, u * j + v * i) for i, j in turns for v, u in flap]
    wall = cut(grown(prism(plan, 2, 1, 1.08), 0.09), grown(prism(plan, 2, 1, 1.18), -0.1))
    under = mirrored([(1.4, -1), (1.4, low), *((v, w - 0.03) for v, w in reversed(rise))])
    roll = [
        (u * _flare(w), v * _flare(w), w)
        for (v, u), (_, w) in zip(line[::2], rise[::2], strict=True)
    ]
    roll = [*((u, -v, w) for u, v, w in reversed(roll[1:])), *roll]
    vane = [
        (0, 0),
        (-0.08, 0.3),
        (-0.02, 0.62),
        (0.2, 0.92),
        (0.56, 1.1),
        (0.96, 1.06),
        (1.2, 0.82),
    ]
    barbs = [(0.96, 0.86), (0.88, 0.66), (0.68, 0.74), (0.56, 0.46), (0.38, 0.54), (0.24, 0.2)]
    plume = [*smooth_curve(vane), *barbs, (0.14, 0)]
    return {
        "crown": join(tube((0, 0, 0.04), (0, 0, 0.5), r), egg((0, 0, 0.48), (r, r, dome - 0.48))),
        "brim": _flared(within(wall, around(3, prism(under, 0, 2), 30))),
        "trim": around(3, limb(roll, 0.11, 0.11), 30),
        "feather": moved(
            turned(grown(prism(plume, 1, 0.05), 0.06), 2, 30),
            (0.26, -0.2, high - 0.22),
        ),
    }


def briefcase(draw: Draw) -> Parts:
    """An upright case of two halves, a seam between them, guarded corners, two latches."""
    x, y, z = draw(0.94, 1.06), draw(0.31, 0.36), draw(0.62, 0.7)
    apart, grip, rise = x * draw(0.52, 0.6), draw(0.3, 0.36), draw(0.3, 0.36)
    corner = within(
        box((0, 0, 0), (x + 0.12, y + 0.1, z + 0.12), 0.1), both(ball((x, y, z), 0.29), 0, 1, 2)
    )
    hold = [(grip, z - 0.05), (grip, z + rise * 0.7), (grip - 0.12, z + rise)]
    path = [(u, 0, v) for u, v in [*hold, *((-u, v) for u, v in reversed(hold))]]
    latch = join(
        box((apart, -y - 0.02, z - 0.22), (0.14, 0.12, 0.18), 0.03),
        box((apart, -y - 0.14, z - 0.28), (0.1, 0.08, 0.08), 0.03),
    )
    parts = {
        "body": box((0, 0, 0), (x, y, z), 0.07),
        "seam": box((0, 0, 0), (x + 0.07, 0.1, z + 0.07), 0.04),
        "handle": join(
            limb(path, 0.1, 0.1), both(box((grip, 0, z + 0.06), (0.14, 0.15, 0.1), 0.03))
        ),
        "latches": both(latch),
        "corners": corner,
    }
    return {name: moved(solid, (0, 0, z + 0.1)) for name, solid in parts.items()}


TRAVEL = {
    "jerrycan": jerrycan,
    "goggles": goggles,
    "spyglass": spyglass,
    "pirate hat": pirate_hat,
    "briefcase": briefcase,
}
