"""Flowers, green plants and vegetables."""

import math

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.ropes import bent


def _arched(solid: Solid, at: float, low: float, radius: float) -> Solid:
    """``solid``, which lies along +X, bent up and over to the half circle of ``radius`` about
    (``at``, ``low``) in x and z; it begins at the axis' side."""

    def distance(p: Tensor) -> Tensor:
        u, v = p[:, 0] - at, p[:, 2] - low
        angle = torch.atan2(v, -u)
        angle = torch.where(angle < -math.pi / 2, angle + math.tau, angle)
        out = (u * u + v * v).sqrt() - radius
        return solid(torch.stack([angle * radius, p[:, 1], out], 1)) * 0.8

    return distance


def fern(draw: Draw) -> Parts:
    """A clump of arching fronds, each a row of bold leaflets along a rib, out of dark soil."""
    long, wide, radius = draw(2.0, 2.1), draw(0.38, 0.41), draw(0.76, 0.8)
    side = [(0.0, 0.1), (0.4, 0.1)]
    for k, out in enumerate((0.66, 0.92, 1.0, 0.94, 0.8, 0.6)):
        start = 0.4 + 0.26 * k
        side += [(start + 0.08, wide * out), (start + 0.2, wide * out * 0.94),
                 (start + 0.15, 0.1), (start + 0.26, 0.1)]  # fmt: skip
    outline = [*side, (long * 1.04, 0.0), *((u, -v) for u, v in reversed(side))]
    leaf = grown(prism(outline, 2, 0.05), 0.025)
    rib = taper((0, 0, 0.05), (long * 0.94, 0, 0.05), 0.105, 0.075)

    def clump(frond: Solid) -> Solid:
        """Six fronds that bow outwards about four that rise."""
        high = _arched(frond, radius * 0.86, 0.62, radius * 0.82)
        return join(around(6, _arched(frond, radius + 0.08, 0.06, radius), 30), around(4, high, 45))

    return {
        "fronds": clump(leaf),
        "ribs": join(clump(rib), taper((0, 0, 0.2), (0, 0, 0.7), 0.24, 0.15)),
        "soil": within(egg((0, 0, 0.0), (0.56, 0.56, 0.36)), box((0, 0, 1), (2, 2, 1.1))),
    }


def _planter(draw: Draw) -> Parts:
    wide, high = draw(0.48, 0.58), draw(0.5, 0.62)
    hull = lathe([(wide * 0.72, 0), (wide * 0.95, high)], 0.02)
    rim = tube((0, 0, high - 0.14), (0, 0, high + 0.04), wide * 1.1, 0.04)
    return {"pot": join(hull, rim)}


def cactus(draw: Draw) -> Parts:
    """A column with two arms, in a pot."""
    trunk, arm, top = draw(0.24, 0.3), draw(0.15, 0.18), draw(1.7, 2.0)

    def branch(side: float, low: float, reach: float, tip: float):
        elbow = (side * reach, 0.0, low)
        return join(capsule((0, 0, low), elbow, arm), capsule(elbow, (elbow[0], 0, tip), arm))

    z, reach = 0.75, trunk + arm + draw(0.2, 0.28)
    arms = [branch(1, z + draw(0, 0.2), reach, z + draw(0.55, 0.75))]
    arms.append(branch(-1, z + draw(0.25, 0.5), reach, z + draw(0.8, 1.0)))
    parts = {"body": join(capsule((0, 0, 0.2), (0, 0, top), trunk), *arms)}
    return parts | _planter(draw)


def _pot(wide: float, high: float) -> Solid:
    hull = lathe([(wide * 0.7, 0), (wide * 0.94, high)], 0.02)
    return join(hull, tube((0, 0, high - 0.16), (0, 0, high + 0.04), wide * 1.08, 0.04))


def potted_plant(draw: Draw) -> Parts:
    """Broad leaves that arch out of a pot."""
    wide, high = draw(0.5, 0.6), draw(0.65, 0.8)
    rise, out = draw(1.0, 1.25), draw(0.62, 0.78)

    def leaf(length: float, reach: float, fat: float) -> Solid:
        return join(
            taper((0.02, 0, high - 0.1), (reach * 0.45, 0, high + length * 0.7), 0.09, fat),
            taper((reach * 0.45, 0, high + length * 0.7), (reach, 0, high + length), fat, 0.07),
        )

    leaves = [
        around(5, leaf(rise * 0.65, out + 0.15, 0.2), 18),
        around(4, leaf(rise, out * 0.7, 0.2), 45),
        taper((0, 0, high), (0.05, 0, high + rise * 1.15), 0.16, 0.08),
    ]
    return {
        "leaves": join(*leaves),
        "pot": _pot(wide, high),
        "soil": tube((0, 0, high - 0.1), (0, 0, high + 0.07), wide * 0.85, 0.02),
    }


def flower(draw: Draw) -> Parts:
    """A single blossom that looks to the front: clear petals about a disc, a stalk, two leaves."""
    z, petal, count = draw(1.6, 1.75), draw(0.36, 0.42), 6 + 2 * draw.chance(0.5)
    heart, y, lean = draw(0.25, 0.29), -0.2, draw(12, 20)
    half = petal * (0.62 if count == 6 else 0.48)
    tongue = [(heart * 0.6, half * 0.45), (heart + petal * 0.5, half), (heart + petal, half * 0.92)]
    tongue += [(heart + petal * 1.3, half * 0.5), (heart + petal * 1.42, 0)]
    side = smooth_curve(tongue, 3)
    outline = [*side, *((u, -v) for u, v in reversed(side[:-1]))]
    blossom = around(count, turned(prism(outline, 2, 0.085), 1, -8), 90)
    blade = smooth_curve([(0, 0), (0.26, 0.19), (0.5, 0.17), (0.8, 0)], 3)
    blade = prism([*blade, *((u, -v) for u, v in reversed(blade[1:-1]))], 2, 0.08)

    def turned_up(solid: Solid) -> Solid:
        return moved(turned(solid, 0, 90 - lean), (0, y, z))

    return {
        "petals": turned_up(blossom),
        "heart": turned_up(egg((0, 0, 0.06), (heart, heart, 0.16))),
        "stalk": join(
            capsule((0, 0.04, 0.09), (0, 0, z - 0.3), 0.09),
            capsule((0, 0, z - 0.3), (0, y + 0.06, z), 0.09),
            both(moved(turned(blade, 1, -38), (0.02, 0.04, draw(0.3, 0.42)))),
        ),
    }


def sunflower(draw: Draw) -> Parts:
    """A great head that looks to the front, on a stalk with leaves."""
    z, heart, count = draw(1.9, 2.2), draw(0.36, 0.44), 11 + 2 * draw.chance(0.5)
    y, reach = -0.22, draw(0.72, 0.84)
    petal = taper((heart * 0.8, 0, 0), (reach, 0, 0), 0.14, 0.08)
    blossom = around(count, petal, 90)
    leaf = turned(egg((0.4, 0, 0), (0.42, 0.22, 0.09)), 1, -draw(20, 40))
    low, mid = draw(0.55, 0.7), draw(0.9, 1.1)
    return {
        "petals": moved(turned(blossom, 0, 90), (0, y, z)),
        "heart": egg((0, y - 0.06, z), (heart, 0.2, heart)),
        "stalk": join(
            capsule((0, 0.02, 0), (0, 0.02, z - 0.1), 0.11),
            capsule((0, 0.02, z - 0.1), (0, y + 0.06, z), 0.12),
            moved(leaf, (0, 0, low)),
            moved(turned(leaf, 2, 180), (0, 0, mid)),
        ),
    }


def rose(draw: Draw) -> Parts:
    """Petals wound about each other, on a stalk with two leaves."""
    z, size = draw(1.55, 1.8), draw(0.46, 0.54)

    def cup(radius: float, low: float, high: float) -> Solid:
        shape = [(0.08, low), (radius * 0.85, low + 0.12), (radius, (low + high) / 2 + 0.05)]
        return lathe(smooth_curve([*shape, (radius * 0.88, high)], 3))

    def petals(count: int, radius: float, low: float, high: float, first: float) -> Solid:
        # Balls pressed flat to the cup, each cut open above.
        outer = egg((radius * 0.72, 0, 0), (radius * 0.42, radius * 0.72, (high - low) / 2))
        return moved(around(count, turned(outer, 1, 14), first), (0, 0, (low + high) / 2))

    head = join(
        petals(5, size, z - 0.35, z + 0.3, 18),
        petals(4, size * 0.75, z - 0.1, z + 0.48, 45),
        petals(3, size * 0.5, z + 0.0, z + 0.62, 90),
        cup(size * 0.6, z - 0.38, z + 0.35),
    )
    leaf = turned(egg((0.36, 0, 0), (0.4, 0.22, 0.09)), 1, -draw(20, 40))
    sepal = taper((0.08, 0, z - 0.38), (size * 0.75, 0, z - 0.3), 0.11, 0.07)
    low = draw(0.4, 0.6)
    return {
        "petals": head,
        "stalk": join(
            capsule((0, 0, 0), (0, 0, z - 0.3), 0.1),
            around(5, sepal),
            moved(leaf, (0, 0, low)),
            moved(turned(leaf, 2, 180), (0, 0, low + draw(0.2, 0.35))),
        ),
    }


def tulip(draw: Draw) -> Parts:
    """A cup of six petals on a stalk, two long leaves from the ground."""
    z, wide, high = draw(1.45, 1.7), draw(0.36, 0.44), draw(0.75, 0.9)
    petal = join(
        taper((0.1, 0, z), (wide * 0.72, 0, z + high * 0.42), 0.16, 0.26),
        taper((wide * 0.72, 0, z + high * 0.42), (wide * 0.85, 0, z + high), 0.26, 0.06),
    )
    inner = taper((0, 0, z + 0.1), (0, 0, z + high * 0.7), 0.2, 0.2)
    out = draw(0.45, 0.65)
    leaf = bent([(0.06, 0, 0.1), (0.3, 0, 0.55), (out, 0, draw(1.1, 1.35))], [0.12, 0.17, 0.06])
    return {
        "petals": join(around(3, petal, 90), around(3, petal, 30), inner),
        "stalk": join(
            capsule((0, 0, 0), (0, 0, z + 0.05), 0.11), around(2 + draw.chance(0.5), leaf)
        ),
    }


def lily_pad(draw: Draw) -> Parts:
    """A flat round leaf with a notch to the front and a raised rim, a pink lotus in bloom on it."""
    r, rim, notch = draw(1.36, 1.44), draw(0.26, 0.29), draw(15, 17)
    slope = math.tan(math.radians(notch))
    wedge = prism([(0, -0.4), (2 * slope, -2.4), (-2 * slope, -2.4)], 2, 1)
    leaf = lathe([(r - 0.06, 0), (r, 0.1), (r, rim), (r - 0.14, rim), (r - 0.2, 0.16)], 0.02)
    vein = capsule((0.3, 0, 0.14), (r - 0.24, 0, 0.16), 0.08)
    y = 0.26

    def petal(long: float, wide: float, lean: float) -> Solid:
        """It stands at +X, leaning outwards."""
        leaf = egg((0, 0, long), (0.11, wide, long))
        return moved(turned(leaf, 1, lean), (0.12, 0, 0.22))

    bloom = join(
        around(8, petal(0.4, 0.21, 66), 22.5), around(6, petal(0.42, 0.2, 34)),
    )  # fmt: skip
    return {
        "leaf": cut(leaf, wedge),
        "veins": around(7, vein, -90 + 180 / 7),
        "petals": moved(bloom, (0, y, 0)),
        "heart": egg((0, y, 0.42), (0.2, 0.2, 0.22)),
    }


def _surface(solid: Solid, start: Vector, way: Vector) -> float:
    """How far from ``start``, within, the solid's surface is along the unit vector ``way``."""
    steps = torch.arange(0, 1.5, 0.01)[:, None]
    points = torch.tensor(start) + steps * torch.tensor(way)
    return float(steps[(solid(points) < 0).sum() - 1])


def potato(draw: Draw) -> Parts:
    """A lump, thicker at one end, with a few dark eyes in it."""
    long, r, s = draw(0.55, 0.75), draw(0.52, 0.6), draw(0.42, 0.54)
    bump, z = draw(0.08, 0.2), 0.62
    body = blend(
        0.3,
        egg((-long * 0.6, 0, z), (0.62, r, r * 0.92)),
        egg((long * 0.7, 0, z - 0.04), (0.6, s, s * 0.95)),
        egg((-0.05, -bump, z + bump), (0.62, 0.42, 0.4)),
        egg((0.1, bump, z - 0.12), (0.7, 0.42, 0.4)),
    )
    marks = []
    for x, angle in ((-0.75, 60), (-0.35, 20), (0.1, 55), (0.55, 28), (0.8, 70), (0.3, 120),
                     (-0.5, 130)):  # fmt: skip
        a = math.radians(angle)
        dy, dz = -math.cos(a), math.sin(a)
        reach = _surface(body, (x, 0, z), (0, dy, dz))
        marks.append(egg((x, dy * (reach - 0.04), z + dz * (reach - 0.04)), (0.15, 0.085, 0.085)))
    return {"body": body, "spots": join(*marks)}


def cucumber(draw: Draw) -> Parts:
    """It lies, one end cut off, pale stripes along it; a thick slice leans on its front."""
    long, r = draw(1.24, 1.32), draw(0.42, 0.45)
    big, x, end = r + 0.04, draw(-0.3, -0.2), draw(0.96, 1.02)
    at = (x, -r - 0.2, big - 0.04)
    stripes = [(-math.cos(a) * (r - 0.05), r + math.sin(a) * (r - 0.05))
               for a in map(math.radians, (15, 70, 125))]  # fmt: skip
    seed = egg((0.21, 0, 0.04), (0.115, 0.07, 0.09))

    def faces(solid: Solid) -> Solid:
        """``solid``, of a face that looks up, at the end and on the slice."""
        return join(moved(turned(solid, 0, 72), at), moved(turned(solid, 1, 90), (end, 0, r)))

    return {
        "rind": join(
            capsule((-long + r, 0, r), (end - r, 0, r), r),
            tube((end - r, 0, r), (end, 0, r), r),
            moved(turned(tube((0, 0, -0.26), (0, 0, 0), big, 0.02), 0, 72), at),
        ),
        "stripes": join(*(capsule((-long + r, v, w), (end - 0.22, v, w), 0.12)
                          for v, w in stripes)),
        "flesh": faces(tube((0, 0, -0.1), (0, 0, 0.06), r - 0.07)),
        "seeds": faces(around(5, seed, 90)),
        "stem": tube((-long - 0.1, 0, r), (-long + 0.1, 0, r), 0.11, 0.04),
    }  # fmt: skip


def lettuce(draw: Draw) -> Parts:
    """A round heart in a ring of leaves and one of open ones of three lobes, with pale ribs."""
    r, lean, size = draw(0.5, 0.53), draw(28, 31), draw(0.64, 0.68)
    wide = size * 0.7
    hollow = egg((-0.2, 0, 0.06), (0.32, wide - 0.04, size))
    lobe = cut(egg((0, 0, 0), (0.32, wide, size)), hollow)
    leaf = join(lobe, both(turned(lobe, 0, -44), 1))

    def put(solid: Solid, first: float, degrees: float, out: float, z: float) -> Solid:
        return around(5, moved(turned(solid, 1, degrees), (out, 0, z)), first)

    return {
        "head": egg((0, 0, 0.94), (r, r, r)),
        "leaves": join(
            put(leaf, 18, lean, 0.7, 0.62),
            egg((0, 0, 0.5), (0.56, 0.56, 0.38)),
        ),
        "frills": put(egg((0, 0, 0), (0.26, 0.46, 0.54)), 54, 18, 0.46, 0.8),
        "ribs": put(egg((0.22, 0, 0.1), (0.14, 0.11, 0.38)), 18, lean, 0.7, 0.62),
        "stalk": tube((0, 0, 0), (0, 0, 0.3), 0.32, 0.06),
    }


PLANTS_FLOWERS_AND_VEGETABLES = {
    "fern": fern,
    "cactus": cactus,
    "potted plant": potted_plant,
    "flower": flower,
    "sunflower": sunflower,
    "rose": rose,
    "tulip": tulip,
    "lily pad": lily_pad,
    "potato": potato,
    "cucumber": cucumber,
    "lettuce": lettuce,
}
