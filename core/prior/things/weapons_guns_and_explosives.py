"""Guns, their ammunition, and explosives."""

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
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


def rifle(draw: Draw) -> Parts:
    """Upright, its muzzle to the left, with a magazine and a telescope."""
    z, long, high = 0.82, draw(1.46, 1.55), draw(0.17, 0.2)
    butt, y = draw(1.45, 1.55), draw(0.13, 0.15)
    stock = [(0.42, z + 0.1), (butt, z), (butt, z - draw(0.56, 0.64)), (butt - 0.2, z - 0.56)]
    stock += [(0.8, z - 0.22), (0.42, z - 0.2)]
    grip = [(0.3, z - 0.14), (0.58, z - 0.14), (0.72, z - 0.68), (0.44, z - 0.7)]
    store = [(-0.42, z - 0.1), (-0.08, z - 0.1), (-0.2, z - 0.76), (-0.52, z - 0.68)]
    guard = [(-0.06, z - 0.12), (-0.06, z - 0.42), (0.4, z - 0.42), (0.4, z - 0.12)]
    inner = [(0.06, z), (0.06, z - 0.31), (0.3, z - 0.31), (0.3, z)]
    eye, seen = z + high + 0.22, draw(0.34, 0.4)
    tele = join(
        tube((-seen, 0, eye), (seen, 0, eye), 0.11),
        tube((-seen - 0.16, 0, eye), (-seen + 0.1, 0, eye), 0.16, 0.02),
        tube((seen - 0.08, 0, eye), (seen + 0.1, 0, eye), 0.15, 0.02),
        both(box((0.2, 0, eye - 0.16), (0.1, 0.1, 0.16))),
    )
    return {
        "barrel": join(
            tube((-long, 0, z + 0.04), (0, 0, z + 0.04), 0.1),
            tube((-long - 0.04, 0, z + 0.04), (-long + 0.18, 0, z + 0.04), 0.14, 0.02),
        ),
        "body": join(
            box((0.02, 0, z), (0.46, y, high), 0.03), cut(prism(guard, 1, 0.1), prism(inner, 1, 1))
        ),
        "stock": join(
            prism(stock, 1, y),
            prism(grip, 1, y * 0.95),
            box((-0.58, 0, z - 0.02), (0.28, y * 1.05, 0.17), 0.03),
        ),
        "magazine": prism(store, 1, y * 0.85),
        "scope": tele,
        "trigger": taper((0.2, 0, z - 0.1), (0.17, 0, z - 0.28), 0.07, 0.07),
    }


def _guard(left: float, right: float, low: float, high: float) -> Solid:
    """The hoop about a trigger."""
    outer = [(left, high), (left + 0.08, low), (right, low), (right, high)]
    inner = [(left + 0.15, high + 0.1), (left + 0.19, low + 0.13), (right - 0.13, low + 0.13),
             (right - 0.13, high + 0.1)]  # fmt: skip
    return cut(prism(outer, 1, 0.09), prism(inner, 1, 1))


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


def revolver(draw: Draw) -> Parts:
    """Upright, its muzzle to the left: a fluted cylinder, a hammer behind it, a curved grip."""
    long, r, drum = draw(1.02, 1.18), draw(0.13, 0.15), draw(0.27, 0.31)
    z, half = draw(1.0, 1.1), draw(0.25, 0.29)
    muzzle, _low = -half - long, z - 0.06
    flute = tube((-1, drum + 0.05, 0), (half - 0.12, drum + 0.05, 0), 0.11)
    round_bar = tube((-half, 0, 0), (half, 0, 0), drum, 0.03)
    # Turned about its own axis, so that flutes lie at the sides.
    flutes = [turned(flute, 0, 60 * k + 30) for k in range(6)]
    lug = tube((muzzle + 0.3, 0, z - 0.1), (-half, 0, z - 0.1), 0.085)
    bore = tube((muzzle - 1, 0, z + 0.1), (muzzle + 0.25, 0, z + 0.1), 0.075)
    barrel = tube((muzzle, 0, z + 0.1), (-half - 0.05, 0, z + 0.1), r, 0.02)
    sight = box((muzzle + 0.13, 0, z + 0.1 + r + 0.04), (0.1, 0.07, 0.08), 0.02)
    y = 0.16
    back = half + 0.34
    frame = [(-half - 0.12, z + 0.34), (back - 0.06, z + 0.34), (back + 0.06, z + 0.02)]
    frame += [(back + 0.04, z - 0.36), (-half - 0.12, z - 0.42)]
    window = box((0, 0, z), (half + 0.02, 2, drum - 0.04))
    guard = ring((half - 0.14, 0, z - 0.56), 0.24, 0.08, axis=1)
    drop = draw(0.9, 1.02)
    butt = [(half + 0.02, z - 0.2), (back + 0.04, z - 0.1), (back + 0.14, z - 0.34)]
    butt += [(back + 0.28, z - drop * 0.72), (back + 0.5, z - drop), (back + 0.1, z - drop - 0.06)]
    butt += [(half + 0.16, z - drop * 0.66)]
    return {
        "barrel": cut(join(barrel, lug, sight), bore),
        "frame": join(cut(prism(frame, 1, y), window), guard),
        "cylinder": moved(cut(round_bar, *flutes), (0, 0, z)),
        "grip": prism(smooth_curve([*butt, butt[0]], 3)[:-1], 1, y + 0.05),
        "trigger": limb(
            [(half - 0.1, 0, z - 0.3), (half - 0.1, 0, z - 0.46), (half - 0.18, 0, z - 0.6)],
            0.085,
            0.085,
        ),
        "hammer": limb(
            [(back - 0.1, 0, z + 0.2), (back + 0.08, 0, z + 0.44), (back + 0.28, 0, z + 0.46)],
            0.1,
            0.085,
        ),
    }


def bullet(draw: Draw) -> Parts:
    """A cartridge that stands: a rim and a groove, a straight brass case, a pointed copper tip."""
    r, case, tip = draw(0.42, 0.45), draw(1.6, 1.7), draw(1.14, 1.24)
    neck, first = r * 0.86, 0.42
    curve = [(neck * (1 - (k / 12) ** 2.1), case + tip * k / 12) for k in range(12)]
    return {
        "case": lathe(
            [(r * 0.7, first - 0.12), (r, first), (r, case - 0.24), (r * 0.9, case - 0.02)], 0.01
        ),
        "tip": lathe([(neck, case - 0.1), *curve, (0.02, case + tip)], 0.01),
        "rim": join(
            lathe([(r - 0.02, 0.01), (r + 0.06, 0.06), (r + 0.06, 0.18), (r - 0.02, 0.22)], 0.01),
            tube((0, 0, 0.1), (0, 0, first), r * 0.74),
        ),
        "band": tube((0, 0, case - 0.16), (0, 0, case + 0.04), neck + 0.06, 0.03),
    }


def _leftward(profile: list[tuple[float, float]], at: Vector, rounding: float = 0.02) -> Solid:
    """The profile (radius, how far to the left of ``at``) turned about a level axis."""
    return moved(turned(lathe(profile, rounding), 1, -90), at)


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


def grenade(draw: Draw) -> Parts:
    """A pineapple grenade: rows of blocks, a fuse head, its lever down one side, a pin's ring."""
    r, high, rows = draw(0.66, 0.74), draw(1.55, 1.75), 4
    side = smooth_curve([(r * 0.5, 0.02), (r * 0.86, high * 0.2), (r, high * 0.45),
                         (r * 0.88, high * 0.74), (r * 0.46, high * 0.98)])  # fmt: skip
    shell = lathe(side, 0.07)
    gap, step = 0.065, high / rows
    slits = [box((0, 0, step * k), (2, 2, gap)) for k in range(1, rows)]
    grooves = around(8, box((r, 0, 0), (r * 0.8, gap, 4)), 22.5)
    top = high + 0.05
    head = join(
        tube((0, 0, top - 0.1), (0, 0, top + 0.16), 0.3, 0.03),
        tube((0, 0, top), (0, 0, top + 0.42), 0.21, 0.03),
        box((0.06, 0, top + 0.42), (0.3, 0.17, 0.12), 0.03),
    )
    out = r + 0.24
    strip = [(0.16, top + 0.5), (0.16, top + 0.66), (0.42, top + 0.62), (out, top + 0.02),
             (out + 0.06, high * 0.5), (out - 0.08, high * 0.32), (out - 0.16, high * 0.36),
             (out - 0.09, high * 0.5), (out - 0.14, top - 0.04), (0.36, top + 0.5)]  # fmt: skip
    loop, x = draw(0.25, 0.3), -0.2
    return {
        "body": lathe(side, 0.0),
        "blocks": cut(shell, *slits, grooves),
        "head": head,
        "lever": prism(strip, 1, 0.17),
        "ring": ring((x - loop - 0.14, 0, top + 0.26), loop, 0.08, axis=1),
        "pin": capsule((x - 0.12, 0, top + 0.34), (0.34, 0, top + 0.34), 0.09),
    }


def dynamite(draw: Draw) -> Parts:
    """Seven red sticks in a bundle, a black band about it, the fuses run together and burn."""
    r, high = draw(0.29, 0.31), draw(1.8, 1.95)
    out, hull = 2 * r, 3 * r
    stick = tube((0, 0, 0), (0, 0, high), r, 0.03)
    end = tube((0, 0, high - 0.03), (0, 0, high + 0.1), r - 0.06, 0.02)
    lead = limb([(out, 0, high + 0.05), (out * 0.75, 0, high + 0.32), (0.1, 0, high + 0.5)],
                0.085, 0.085)  # fmt: skip
    main = [(0, 0, high), (0, 0, high + 0.55), (0.14, 0, high + 0.78), (0.4, 0, high + 0.86),
            (0.56, 0, high + 1.02)]  # fmt: skip
    corners = [
        (hull * math.cos(a), hull * math.sin(a)) for a in (math.tau * k / 6 for k in range(6))
    ]
    wrap = grown(prism([(u * 0.66, v * 0.66) for u, v in corners], 2, draw(0.15, 0.17), high / 2),
                 r + 0.05)  # fmt: skip
    return {
        "sticks": join(stick, around(6, moved(stick, (out, 0, 0)))),
        "ends": join(end, around(6, moved(end, (out, 0, 0)))),
        "band": within(wrap, box((0, 0, high / 2), (2, 2, 0.26))),
        "fuses": join(around(6, lead), limb(main, 0.1, 0.09)),
        "spark": join(
            ball((0.58, 0, high + 1.06), 0.15),
            *(
                moved(turned(capsule((0, 0, 0), (0, 0, 0.26), 0.075), 1, a), (0.58, 0, high + 1.06))
                for a in (-60, 0, 60, 120, 180)
            ),
        ),
    }


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


WEAPONS_GUNS_AND_EXPLOSIVES = {
    "rifle": rifle,
    "shotgun": shotgun,
    "revolver": revolver,
    "bullet": bullet,
    "rocket launcher": rocket_launcher,
    "grenade": grenade,
    "dynamite": dynamite,
    "ray gun": ray_gun,
}
