"""The undead."""

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
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.figure import figure, figure_with_hand, hair
from core.prior.things.shared.fitted import fitted


def vampire(draw: Draw) -> Parts:
    """A long cape with a high collar that stands open over a red vest; fangs."""
    f = figure(draw)
    wide, r = f.wide * draw(1.5, 1.75), f.head
    gap = [(-0.3, -0.1), (0.3, -0.1), (0.2, f.top - 0.05), (-0.2, f.top - 0.05)]
    cape = lathe([(wide, 0.05), (f.wide * 1.12, f.leg + 0.3), (f.wide * 0.72, f.top)], 0.06)
    front = prism(gap, 1, 1.0, -1.0)
    collar = cut(
        lathe([(f.wide * 0.7, f.top - 0.1), (r * 1.5, f.z + r * 0.5)], 0.06),
        lathe([(f.wide * 0.7 - 0.14, f.top - 0.3), (r * 1.5 - 0.12, f.z + r * 0.8)]),
        box((0, -2, f.z), (3, 2 - r * 0.1, 2)),
    )
    fangs = both(
        taper((0.1, -r * 0.9, f.z - r * 0.38), (0.1, -r * 0.94, f.z - r * 0.38 - 0.13), 0.065, 0.03)
    )
    inside = lathe([(wide * 0.8, 0.08), (f.wide * 0.86, f.leg + 0.3), (f.wide * 0.56, f.top)], 0.02)
    widow = [(r * 0.86, f.z - r * 1.4), (r * 0.86, f.z + r * 0.34), (r * 0.42, f.z + r * 0.64)]
    face = [*widow, (0, f.z + r * 0.26), *((-u, v) for u, v in reversed(widow))]
    return {
        "cape": join(cut(cape, front), collar, f.sleeves()),
        "vest": inside,
        "skin": join(
            f.skull(),
            f.hands(),
            both(taper((r * 0.9, 0, f.z), (r * 1.2, 0.02, f.z + 0.16), 0.1, 0.06)),
        ),
        "hair": cut(ball((0, 0.03, f.z + 0.04), r * 1.12), prism(face, 1, r, -r)),
        "fangs": fangs,
        "eyes": f.eyes(),
    }


def zombie(draw: Draw) -> Parts:
    """Its arms stretched forward, a torn shirt, round eyes of two sizes, an open mouth."""
    f = figure(draw)
    reach, rise = draw(0.72, 0.9), draw(-0.16, 0.06)
    x, shoulder = f.wide * 0.92, (f.wide * 0.92, 0, f.top - 0.22)
    hand = (x, -reach, f.top - 0.22 + rise)
    elbow = tuple(a + (b - a) * 0.45 for a, b in zip(shoulder, hand, strict=True))
    tears = around(
        5, prism([(-0.16, f.leg - 0.1), (0.16, f.leg - 0.1), (0, f.leg + 0.2)], 0, 2), 10
    )
    shirt = cut(
        join(f.trunk(0.05), tube((0, 0, f.leg - 0.04), (0, 0, f.leg + 0.3), f.wide * 0.86)), tears
    )
    small, large = draw(0.09, 0.1), draw(0.13, 0.15)
    e = f.head * 0.42
    return {
        "skin": join(
            f.skull(),
            both(join(taper(shoulder, hand, 0.14, 0.12), ball(hand, 0.18))),
            f.trunk(),
            f.shoes(0.3),
        ),
        "shirt": join(shirt, both(taper(shoulder, elbow, 0.2, 0.2))),
        "trousers": f.legs(0.04),
        "hair": cut(hair(f), box((0, -f.head, f.z + f.head), (0.1, 1, f.head * 0.6))),
        "eyes": join(
            ball((-e, -f.head * 0.86, f.z + 0.1), large),
            ball((e, -f.head * 0.88, f.z + 0.1), small),
        ),
        "mouth": egg(f.face(-0.42, -0.12), (0.2, 0.12, 0.1)),
    }


def mummy(draw: Draw) -> Parts:
    """Wrapped in bandages that cross, its arms stretched forward; eyes in a dark gap."""
    f = figure_with_hand(draw, (0.0, 0.0, 0.0))
    r, w = f.head, f.wide
    reach, x, up = draw(0.84, 0.92), w * 0.98, f.top - 0.2
    hand = (x, -reach, up + 0.04)
    body = lathe([(w * 0.78, f.leg), (w * 0.8, f.leg + 0.2), (w * 1.04, f.top - 0.24),
                  (w * 0.6, f.top)], 0.05)  # fmt: skip

    def band(at: Vector, radius: float, tilt: float, axis: int = 1, half: float = 0.085) -> Solid:
        """A slanting ring about the vertical."""
        flat = tube((0, 0, -half), (0, 0, half), radius, 0.03)
        return moved(turned(flat, axis, tilt), at)

    arm_bands = [tube((x, -reach * k, up + 0.02), (x, -reach * k - 0.16, up + 0.04), 0.225, 0.02)
                 for k in (0.36, 0.76)]  # fmt: skip
    leg_bands = [band((w * 0.5, 0, v), 0.27, s) for v, s in ((0.26, 14), (0.58, -14))]
    gap = within(ball((0, 0, f.z), r * 1.03), box((0, -1, f.z + 0.04), (0.5, 0.86, 0.15)))
    tail = [(x, -reach + 0.04, up - 0.1), (x + 0.03, -reach + 0.04, up - 0.46)]
    return {
        "bandages": join(
            ball((0, 0, f.z), r), body, f.legs(0.03), f.shoes(0.2),
            both(join(taper((w * 0.86, 0, up), hand, 0.19, 0.16), ball(hand, 0.2))),
        ),
        "bands": join(
            band((0, 0, f.leg + 0.1), w * 0.94, 16),
            band((0, 0, f.leg + 0.4), w * 1.05, -16),
            band((0, 0, f.top - 0.1), w * 0.98, 14),
            band((0, 0, f.z + r * 0.62), r * 0.92, -14),
            band((0, 0, f.z - r * 0.5), r * 1.0, 12),
            both(join(*arm_bands, *leg_bands)),
            prism([(x - 0.12, tail[0][2]), (x + 0.12, tail[0][2]), (x + 0.14, up - 0.52),
                   (x - 0.1, up - 0.44)], 1, 0.08, -reach + 0.02),
        ),
        "gap": gap,
        "eyes": both(ball((r * 0.4, -r * 0.93, f.z + 0.04), 0.12)),
    }  # fmt: skip


def skeleton(draw: Draw) -> Parts:
    """A large skull on few thick bones, the chest dark between the ribs."""
    head, leg, wide = draw(0.44, 0.52), draw(0.72, 0.82), draw(0.36, 0.42)
    top, out = leg + draw(0.96, 1.06), draw(0.2, 0.3)
    z, x = top + head * 1.02, wide + 0.12
    elbow, hand = (x + out * 0.6, 0, top - 0.42), (x + out, -0.16, leg)
    side = join(
        capsule((0, 0, top - 0.06), (x, 0, top - 0.06), 0.12),
        capsule((x, 0, top - 0.06), elbow, 0.11),
        capsule(elbow, hand, 0.11),
        ball(hand, 0.17),
        capsule((0.22, 0, leg), (0.22, 0, 0.12), 0.12),
        capsule((0.22, 0, 0.12), (0.22, -0.3, 0.12), 0.13),
    )
    return {
        "bone": join(
            ball((0, 0, z), head),
            box((0, -head * 0.42, z - head * 0.8), (head * 0.5, head * 0.42, 0.2)),
            tube((0, 0, leg), (0, 0, z), 0.14),
            both(side),
            *(ring((0, 0, top - 0.34 * k), wide - 0.06 * k, 0.11) for k in (1, 2)),
            capsule((-0.2, 0, leg), (0.2, 0, leg), 0.19),
        ),
        "chest": lathe([(wide - 0.14, leg + 0.14), (wide - 0.02, top - 0.08)]),
        "eyes": join(
            both(ball((head * 0.42, -head * 0.76, z + 0.02), head * 0.28)),
            prism([(-0.11, z - 0.3), (0.11, z - 0.3), (0, z - 0.1)], 1, 0.1, -head * 0.9),
        ),
    }


def grim_reaper(draw: Draw) -> Parts:
    """A skull in the hood of a long black robe, hands of bone, a scythe taller than itself."""
    wide, top, head = draw(0.62, 0.67), draw(1.4, 1.46), draw(0.36, 0.39)
    z, hood = top + 0.28, draw(0.58, 0.62)
    hand = (0.82, -0.4, top - 0.42)
    robe = lathe(smooth_curve([(wide, 0.02), (wide * 0.76, 0.7), (wide * 0.74, top - 0.24),
                               (0.3, top + 0.02)]), 0.03)  # fmt: skip
    cowl = join(
        ball((0, 0.06, z + 0.02), hood),
        taper((0, 0.06, z + 0.1), (0, 0.3, z + hood + 0.12), hood * 0.8, 0.1),
        taper((0, 0.02, z - 0.2), (0, 0, top - 0.16), hood * 0.86, 0.52),
    )
    hollow = egg((0, -hood * 0.86, z - 0.02), (hood * 0.72, hood * 0.86, hood * 0.86))
    sleeve = taper((0.42, 0, top - 0.2), (0.74, -0.3, top - 0.44), 0.2, 0.27)
    face = -0.22
    skull = join(
        ball((0, face, z + 0.04), head),
        box((0, face - head * 0.36, z - head * 0.78), (head * 0.56, head * 0.5, 0.17), 0.05),
    )
    sockets = both(egg((head * 0.42, face - head * 0.8, z + 0.02), (0.125, 0.14, 0.14)))
    nose = prism([(-0.1, z - 0.24), (0.1, z - 0.24), (0, z - 0.06)], 1, 0.1, face - head * 0.92)
    x, y = -hand[0], hand[1] - 0.1
    high = z + hood + 0.3
    outer = [(x - 0.1, high + 0.14), (x + 0.42, high + 0.2), (x + 0.9, high + 0.02),
             (x + 1.24, high - 0.46)]  # fmt: skip
    inner = [(x + 0.8, high - 0.2), (x + 0.38, high - 0.08), (x - 0.1, high - 0.14)]
    blade = [*smooth_curve(outer), *smooth_curve(inner)]
    return {
        "robe": join(robe, cut(cowl, hollow), both(sleeve)),
        "hood": ball((0, 0.1, z), hood * 0.86),
        "bone": join(skull, both(ball((hand[0] - 0.02, hand[1], hand[2] - 0.04), 0.19))),
        "eyes": join(sockets, nose),
        "handle": tube((x, y, 0.02), (x, y, high + 0.16), 0.095, 0.03),
        "blade": prism(blade, 1, 0.085, y),
    }


MONSTERS_UNDEAD = {
    "vampire": vampire,
    "zombie": zombie,
    "mummy": mummy,
    "skeleton": fitted(skeleton),
    "grim reaper": fitted(grim_reaper),
}
