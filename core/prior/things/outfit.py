"""Outfit: arms of adventurers, skis, a sarcophagus."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
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
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


def _leftward(profile: list[tuple[float, float]], at: Vector, rounding: float = 0.02) -> Solid:
    """The profile (radius, how far to the left of ``at``) turned about a level axis."""
    return moved(turned(lathe(profile, rounding), 1, -90), at)


def _guard(left: float, right: float, low: float, high: float) -> Solid:
    """The hoop about a trigger."""
    outer = [(left, high), (left + 0.08, low), (right, low), (right, high)]
    inner = [(left + 0.15, high + 0.1), (left + 0.19, low + 0.13), (right - 0.13, low + 0.13),
             (right - 0.13, high + 0.1)]  # fmt: skip
    return cut(prism(outer, 1, 0.09), prism(inner, 1, 1))


def ray_gun(draw: Draw) -> Parts:
    """A bulbous body, rings that shrink along the barrel to a glowing ball, a grip and a fin."""
    z, r, wide = 1.36, draw(0.5, 0.54), draw(0.42, 0.46)
    grip = [(0.3, z - 0.2), (0.86, z - 0.2), (1.12, 0.1), (1.06, 0.02), (0.6, 0.02), (0.54, 0.1)]
    fin = [(0.1, z + 0.3), (0.5, z + 0.62), (1.16, z + 0.98), (1.26, z + 0.94), (1.1, z + 0.5),
           (0.92, z + 0.1), (0.3, z)]  # fmt: skip
    hoops = ((-0.36, 0.42), (-0.68, 0.35), (-1.0, 0.28))
    return {
        "body": join(
            egg((0.4, 0, z), (0.82, wide, r)),
            _leftward([(0.34, 0), (0.3, 0.2), (0.2, 0.5)], (0.1, 0, z)),
        ),
        "barrel": _leftward([(0.2, 0), (0.13, 1.15)], (-0.1, 0, z)),
        "rings": join(*(tube((x - 0.07, 0, z), (x + 0.07, 0, z), e, 0.04) for x, e in hoops)),
        "tip": ball((-1.36, 0, z), draw(0.2, 0.22)),
        "grip": grown(prism(grip, 1, 0.17), 0.03),
        "trigger": join(
            ring((0.2, 0, z - 0.56), 0.28, 0.085, 1),
            taper((0.26, 0, z - 0.36), (0.2, 0, z - 0.6), 0.09, 0.08),
        ),
        "fin": grown(prism(fin, 1, 0.07), 0.02),
        "window": both(egg((0.4, wide - 0.06, z + 0.05), (0.3, 0.16, 0.24)), 1),
    }


def rocket_launcher(draw: Draw) -> Parts:
    """A thick tube flared behind, the cone of a rocket before it; two grips, a sight, a rest."""
    z, r = 1.0, draw(0.27, 0.29)
    bell = [(r, -0.1), (r + 0.02, 0.2), (0.5, 0.52), (0.5, 0.6)]
    hole = [(r - 0.08, 0.1), (0.38, 0.56), (0.38, 1.2)]
    cone = [(0.16, -0.2), (0.18, 0.0), (0.46, 0.26), (0.46, 0.36), (0.3, 0.72), (0.1, 0.98)]
    rear = cut(lathe(bell, 0.01), lathe(hole))
    grips = [grown(prism([(x, z - 0.1), (x + 0.22, z - 0.1), (x + 0.34, 0.16), (x + 0.1, 0.16)],
                         1, 0.1), 0.03) for x in (-0.42, 0.3)]  # fmt: skip
    return {
        "tube": join(
            tube((-0.66, 0, z), (1.06, 0, z), r, 0.02), moved(turned(rear, 1, 90), (1.0, 0, z))
        ),
        "bands": join(
            *(tube((x - 0.1, 0, z), (x + 0.1, 0, z), r + 0.07, 0.03) for x in (-0.6, 0.08, 0.92))
        ),
        "rocket": _leftward(cone, (-0.55, 0, z)),
        "stripe": _leftward([(0.51, 0.25), (0.51, 0.39)], (-0.55, 0, z)),
        "grips": join(*grips),
        "rest": box((0.62, 0, z + 0.02), (0.2, r + 0.08, r + 0.08), 0.06),
        "sight": join(
            box((-0.16, 0, z + r + 0.1), (0.1, 0.1, 0.16), 0.02),
            tube((-0.42, 0, z + r + 0.3), (0.12, 0, z + r + 0.3), 0.17, 0.04),
        ),
    }


def shotgun(draw: Draw) -> Parts:
    """A thick barrel over its magazine, a ribbed wooden pump, a wooden stock, red shells held at
    its side."""
    z, r, y = 1.0, draw(0.14, 0.155), draw(0.17, 0.19)
    low = z - 0.29
    stock = [(0.5, z + 0.12), (0.86, z + 0.04), (1.48, z - 0.06), (1.5, z - 0.66), (1.36, z - 0.68),
             (0.94, z - 0.4), (0.7, z - 0.62), (0.5, z - 0.56)]  # fmt: skip
    ribs = [box((-1.02 + 0.4 * k, 0, low), (0.08, y + 0.09, 0.25), 0.05) for k in range(3)]
    shells = [capsule((x, y, z - 0.2), (x, y, z + 0.02), 0.085) for x in (-0.02, 0.22, 0.46)]
    return {
        "barrel": join(
            tube((-1.56, 0, z), (0, 0, z), r, 0.02),
            tube((-1.26, 0, low), (0, 0, low), 0.11, 0.03),
            box((-1.2, 0, z - 0.12), (0.09, 0.1, 0.22), 0.02),
            ball((-1.46, 0, z + r + 0.02), 0.09),
        ),
        "body": join(
            box((0.2, 0, z - 0.14), (0.46, y, 0.32), 0.05), _guard(0.08, 0.62, z - 0.8, z - 0.3)
        ),
        "stock": grown(prism(stock, 1, y - 0.05), 0.03),
        "pump": join(box((-0.62, 0, low), (0.5, y + 0.03, 0.2), 0.06), *ribs),
        "pad": box((1.53, 0, z - 0.36), (0.07, y + 0.04, 0.38), 0.04),
        "shells": both(join(*shells), 1),
    }


def war_hammer(draw: Draw) -> Parts:
    """A huge block for a head, metal bands about both its ends, a spike on top, a long handle."""
    z, x, half = 2.22, draw(0.8, 0.85), draw(0.4, 0.43)
    r = draw(0.12, 0.13)
    face = moved(turned(lathe([(half + 0.06, 0), (half + 0.06, 0.2)], 0.02), 1, 90), (x, 0, z))
    gem = box((0, 0, 0), (0.19, 0.13, 0.19), 0.04)
    end = box((x, 0, z), (0.15, half + 0.09, half + 0.09), 0.05)
    return {
        "head": join(
            box((0, 0, z), (x + 0.05, half, half), 0.06),
            both(within(face, box((x, 0, z), (0.24, half - 0.06, half - 0.06)))),
        ),
        "bands": join(both(end), box((0, 0, z), (0.17, half + 0.06, half + 0.06), 0.04)),
        "emblem": both(moved(turned(gem, 1, 45), (0, half + 0.06, z)), 1),
        "spike": lathe([(0.26, z + half - 0.02), (0.24, z + half + 0.16), (0.06, z + half + 0.52)]),
        "handle": tube((0, 0, 0.1), (0, 0, z), r, 0.02),
        "grip": join(*(tube((0, 0, v), (0, 0, v + 0.15), r + 0.06, 0.05)
                       for v in (0.18, 0.33, 0.48, 0.63, 0.78))),
        "pommel": join(
            egg((0, 0, 0.08), (0.26, 0.26, 0.18)),
            lathe([(0.16, z - half - 0.34), (0.3, z - half - 0.1), (0.3, z - half + 0.1)], 0.01),
        ),
    }  # fmt: skip


def quiver(draw: Draw) -> Parts:
    """A slender leather tube that leans, with rims, an emblem and a strap at its back; five
    arrows with big feathers stand out of it."""
    r, high, lean = draw(0.42, 0.45), draw(1.66, 1.74), 12
    foot = r * 0.72
    vane = grown(prism(mirrored([(0.03, 0), (0.18, 0.18), (0.18, 0.68), (0.03, 0.54)]), 1, 0.04),
                 0.02)  # fmt: skip
    cross = moved(join(vane, turned(vane, 2, 90)), (0, 0, 0.42))
    shaft = tube((0, 0, -0.5), (0, 0, 1.06), 0.085, 0.03)

    def leaning(solid: Solid) -> Solid:
        """What is made upright on the z axis."""
        return moved(turned(solid, 1, lean), (-0.3, 0, 0.1))

    def stuck(solid: Solid) -> Solid:
        """What is of an arrow, of all five."""
        side = moved(turned(solid, 1, 26), (0.22, 0, high - 0.2))
        return leaning(join(moved(solid, (0, 0, high + 0.2)), around(4, side, 45)))

    path = [(r - 0.06, high - 0.1), (r + 0.22, high - 0.36), (r + 0.26, high * 0.5),
            (r + 0.12, 0.42), (foot - 0.02, 0.2)]  # fmt: skip
    outline = smooth_curve(path)
    strap = [*outline, *((u - 0.15, v) for u, v in reversed(outline))]
    gem = turned(box((0, 0, 0), (0.17, 0.14, 0.17), 0.04), 1, 45)
    return {
        "body": leaning(lathe([(foot * 0.7, 0), (foot, 0.14), (r, high - 0.05)], 0.02)),
        "rims": leaning(join(
            tube((0, 0, high - 0.22), (0, 0, high + 0.04), r + 0.08, 0.05),
            lathe([(foot * 0.6, -0.06), (foot + 0.07, 0.04), (foot + 0.1, 0.34)], 0.02),
        )),
        "strap": leaning(prism(strap, 0, 0.14)),
        "shafts": stuck(shaft),
        "feathers": stuck(cross),
        "emblem": leaning(moved(gem, (0, -r * 0.88, high * 0.54))),
    }  # fmt: skip


def skis(draw: Draw) -> Parts:
    """A pair of skis that stands, tips curled forward, bound by a strap; two poles crossed behind
    them."""
    x, wide, high, deep = 0.34, draw(0.2, 0.215), draw(2.96, 3.04), 0.085
    # Along the middle of a ski: y, z, and how far it leans forward.
    stops = [(0, 0, 0), (0, high - 0.74, 4), (-0.07, high - 0.46, 22), (-0.22, high - 0.2, 40),
             (-0.46, high, 56)]  # fmt: skip
    turns = [(y, z, math.cos(math.radians(a)), math.sin(math.radians(a))) for y, z, a in stops]
    back = smooth_curve([(y + deep * c, z + deep * s) for y, z, c, s in turns])
    front = smooth_curve([(y - deep * c, z - deep * s) for y, z, c, s in turns])
    outline = mirrored([(wide * 0.8, -0.1), (wide, 0.2), (wide * 0.84, high * 0.45),
                        (wide * 1.08, high - 0.52), (wide * 0.8, high - 0.2),
                        (wide * 0.4, high), (0.03, high + 0.1)])  # fmt: skip
    ski = within(prism([*back, *reversed(front)], 0, 1), prism(outline, 1, 2))
    toe, heel = (box((x, -0.16, v), (wide - 0.04, 0.14, e), 0.05)
                 for v, e in ((1.5, 0.11), (1.02, 0.14)))  # fmt: skip
    plate = box((x, -0.09, 1.26), (wide - 0.08, 0.08, 0.3), 0.03)
    marks = [box((x, -deep + 0.01, v), (wide * 0.5, 0.08, e), 0.03)
             for v, e in ((0.42, 0.26), (2.16, 0.16))]  # fmt: skip

    def pole(t: float, side: int) -> Vector:
        """A part of the way up the pole that leans to a side."""
        return side * 0.86 * (2 * t - 1), 0.13, 0.06 + 2.3 * t

    return {
        "skis": both(moved(ski, (x, 0, 0))),
        "stripes": both(join(*marks)),
        "bindings": both(join(toe, heel, plate)),
        "strap": box((0, 0, 1.82), (x + wide + 0.04, deep + 0.06, 0.09), 0.03),
        "poles": join(*(capsule(pole(0, s), pole(1, s), 0.08) for s in (-1, 1))),
        "grips": join(
            *(capsule(pole(0.86, s), pole(1, s), 0.13) for s in (-1, 1)),
            *(egg(pole(0.1, s), (0.22, 0.22, 0.1)) for s in (-1, 1)),
        ),
    }


def sarcophagus(draw: Draw) -> Parts:
    """Upright, in the shape of a mummy: a striped headdress, a face, crossed arms with crooks,
    bands of gold and blue."""
    wide, deep, high = draw(0.68, 0.72), draw(0.3, 0.33), 2.14
    z, r, y = 2.56, draw(0.36, 0.38), -deep - 0.04
    half = [(0.44, 0), (0.44, 0.26), (0.34, 0.4), (0.5, 1.0), (wide, 1.6), (wide, 1.84),
            (wide - 0.2, high - 0.06), (0.24, high)]  # fmt: skip
    body = grown(prism(mirrored(half), 1, deep - 0.1), 0.08)
    hood = mirrored([(r + 0.26, 1.96), (r + 0.3, 2.14), (r + 0.14, z + 0.16), (r - 0.08, z + 0.38),
                     (0.14, z + 0.46)])  # fmt: skip
    cloth = grown(prism(hood, 1, deep - 0.07), 0.08)
    bands = [within(grown(body, 0.06), box((0, 0, v), (2, 2, e)))
             for v, e in ((0.14, 0.14), (0.56, 0.1), (0.94, 0.1))]  # fmt: skip
    folds = [within(grown(cloth, 0.05), box((0, 0, v), (2, 2, 0.075)))
             for v in (2.02, 2.32, 2.62, 2.94)]  # fmt: skip
    arm = [(wide - 0.02, y + 0.08, 1.66), (wide - 0.1, y, 1.34), (-0.16, y - 0.05, 1.66)]
    crook = [(0.14, y - 0.14, 1.36), (0.32, y - 0.16, 1.84), (0.42, y - 0.14, 2.02),
             (0.6, y - 0.12, 2.02), (0.66, y - 0.1, 1.86)]  # fmt: skip
    return {
        "body": body,
        "headdress": cloth,
        "stripes": join(*folds, egg((0, -deep - 0.08, z + 0.36), (0.11, 0.14, 0.17))),
        "face": egg((0, -deep + 0.02, z - 0.02), (r, 0.26, r + 0.06)),
        "eyes": both(egg((0.15, -deep - 0.2, z + 0.04), (0.115, 0.1, 0.09))),
        "arms": both(limb(arm, 0.13, 0.13)),
        "crooks": join(
            both(limb(crook, 0.085, 0.085)),
            taper((0, y - 0.12, z - 0.34), (0, y - 0.16, z - 0.62), 0.09, 0.12),
        ),
        "bands": join(*bands),
    }


OUTFIT = {
    "ray gun": ray_gun,
    "rocket launcher": rocket_launcher,
    "shotgun": shotgun,
    "war hammer": war_hammer,
    "quiver": quiver,
    "skis": skis,
    "sarcophagus": sarcophagus,
}
