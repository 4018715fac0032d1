"""Dinosaurs, a mammoth, a phoenix and a pegasus."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    blend,
    both,
    box,
    chain,
    egg,
    join,
    limb,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import bulk, four_legs, nails


def triceratops(draw: Draw) -> Parts:
    """Three horns, a beak, and a frill with studs about the neck."""
    wide, long, z, trunk = bulk(draw, 0.52, 0.78, 0.34)
    y, h, r = -long - 0.2, z + 0.12, draw(0.66, 0.78)
    tail = limb(
        [(0, long * 0.7, z), (0, long + 0.4, z - 0.16), (0, long + 0.85, z - 0.3)], 0.36, 0.1
    )
    skull = taper((0, y, h), (0, y - 0.44, h - 0.16), 0.36, 0.24)
    lean = -24.0
    studs = [
        ball((r * math.sin(math.radians(a)), 0, r * math.cos(math.radians(a))), 0.14)
        for a in (18, 53, 88)
    ]
    collar = join(tube((0, -0.1, 0), (0, 0.1, 0), r, 0.05), both(join(*studs)))
    long_horn, short = draw(0.6, 0.76), (0, y - 0.5, h + 0.02)
    brow = taper((0.2, y - 0.14, h + 0.22), (0.3, y - 0.5, h + 0.2 + long_horn), 0.14, 0.06)
    return {
        "body": join(trunk, skull, taper((0, -long * 0.6, z), (0, y, h), 0.4, 0.34), tail),
        "frill": tilted(collar, lean, (0, y + 0.18, h + 0.28)),
        "horns": join(both(brow), taper(short, (0, y - 0.68, h + 0.32), 0.14, 0.06)),
        "bill": taper((0, y - 0.52, h - 0.2), (0, y - 0.68, h - 0.36), 0.2, 0.08),
        "hooves": nails(wide, long),
        "eyes": both(ball((0.28, y - 0.24, h + 0.08), 0.085)),
    }


def _top(spine: list[tuple[Vector, float]], y: float) -> float:
    """How high the back is at ``y``, about."""
    for ((_, a, low), first), ((_, b, high), last) in pairwise(spine):
        if a <= y <= b:
            share = (y - a) / (b - a)
            return low + first + (high + last - low - first) * share
    return spine[-1][0][2]


def stegosaurus(draw: Draw) -> Parts:
    """A row of tall plates along an arched back, a small low head, four spikes at the tail."""
    wide, hip, tall = draw(0.4, 0.48), draw(0.88, 1.0), draw(0.42, 0.52)
    spine = [((0, -1.22, 0.62), 0.17), ((0, -0.78, 0.7), 0.26), ((0, -0.3, hip - 0.04), wide),
             ((0, 0.24, hip), wide), ((0, 0.85, 0.72), 0.28), ((0, 1.66, 0.74), 0.11)]  # fmt: skip
    legs = [
        taper((wide * 0.6, at, hip - 0.2), (wide * 0.66, at, 0.15), r, 0.17)
        for at, r in ((-0.34, 0.2), (0.32, 0.25))
    ]
    plates = []
    for at, size in ((-0.72, 0.62), (-0.32, 0.86), (0.12, 1.0), (0.56, 0.86), (0.98, 0.6)):
        root = _top(spine, at) - 0.1
        w, up = 0.25 * size, (tall + 0.18) * size
        leaf = [(at - w * 0.5, root), (at - w, root + up * 0.5), (at + 0.05, root + up + 0.08),
                (at + w, root + up * 0.5), (at + w * 0.5, root)]  # fmt: skip
        plates.append(prism(leaf, 0, 0.1))
    spikes = [
        taper((0.05, at, 0.76), (0.4, at + 0.12, 0.76 + up), 0.11, 0.055)
        for at, up in ((1.32, 0.3), (1.62, 0.26))
    ]
    a, b = 0.2 * 0.86, -1.22
    return {
        "body": join(chain(spine), taper((0, b, 0.62), (0, b - 0.28, 0.54), 0.21, 0.15),
                     both(join(*legs))),
        "belly": taper((0, -0.4, hip - 0.12), (0, 0.3, hip - 0.12), wide * 0.92, wide * 0.94),
        "plates": join(*plates),
        "spikes": both(join(*spikes)),
        "hooves": both(join(*(ball((wide * 0.66 + x, at - 0.13, 0.08), 0.1)
                              for at in (-0.34, 0.32) for x in (-0.1, 0.1)))),
        "eyes": both(ball((a, b - 0.1, 0.7), 0.085)),
    }  # fmt: skip


def brachiosaurus(draw: Draw) -> Parts:
    """A very long neck that rises to a small head, legs like pillars, a long tail."""
    wide, z, rise = draw(0.56, 0.6), draw(1.1, 1.15), draw(3.2, 3.34)
    y = -1.46
    neck = [((0, -0.7, z + 0.12), 0.46), ((0, -1.06, z + 0.66), 0.33),
            ((0, y + 0.1, rise - 0.7), 0.24), ((0, y, rise - 0.06), 0.21)]  # fmt: skip
    tail = [((0, 0.5, z), 0.44), ((0, 1.06, z - 0.2), 0.29), ((0, 1.5, z - 0.42), 0.2),
            ((0, 1.77, z - 0.4), 0.11)]  # fmt: skip
    a, b, mid = wide * 0.66, 0.52, -0.2
    leg = taper((a, b, z - 0.2), (a + 0.04, b, 0.2), 0.31, 0.26)
    spots = [(0.0, -0.2, z + wide - 0.08, 0.23), (0.32, -0.5, z + 0.36, 0.19),
             (0.34, 0.14, z + 0.34, 0.19), (0.0, 0.32, z + 0.44, 0.2),
             (0.0, -0.8, z + 0.68, 0.19), (0.0, 0.78, z + 0.16, 0.18),
             (0.0, y + 0.34, z + 1.3, 0.16)]  # fmt: skip
    nails = [ball((a + 0.04 + u, t * b - v, 0.12), 0.11) for t in (1, -1)
             for u, v in ((-0.14, 0.22), (0.04, 0.28), (0.2, 0.18))]  # fmt: skip
    return {
        "body": join(
            blend(0.2, egg((0, mid, z), (wide, 0.94, wide * 0.96)), chain(neck), chain(tail)),
            moved(both(leg, 0, 1), (0, mid, 0)),
            blend(0.08, egg((0, y - 0.06, rise), (0.3, 0.34, 0.28)),
                  taper((0, y - 0.2, rise - 0.08), (0, y - 0.5, rise - 0.12), 0.24, 0.2)),
        ),
        "belly": join(
            egg((0, mid - 0.04, z - 0.14), (wide * 0.86, 0.86, wide * 0.92)),
            chain([((0, -0.82, z), 0.4), ((0, -1.16, z + 0.6), 0.27),
                   ((0, y, rise - 0.66), 0.19)]),
        ),
        "spots": join(*(both(ball((u, v, w), s)) for u, v, w, s in spots)),
        "nails": moved(both(join(*nails)), (0, mid, 0)),
        "eyes": eyes(0.2, y - 0.22, rise + 0.1, 0.13),
    }  # fmt: skip


def velociraptor(draw: Draw) -> Parts:
    """Level on two legs: a long snout, a stiff tail, striped, raised sickle claws on its toes."""
    wide, z, long = draw(0.36, 0.39), draw(1.2, 1.26), draw(0.6, 0.66)
    y, up, a = -long - 0.44, z + 0.66, 0.4
    trunk = [((0, 0.5, z), wide * 0.86), ((0, -0.2, z + 0.04), wide), ((0, -long, z + 0.18), 0.3),
             ((0, y, up - 0.1), 0.27)]  # fmt: skip
    tail = [((0, 0.5, z + 0.02), wide * 0.84), ((0, 1.0, z + 0.06), 0.23),
            ((0, 1.8, z + 0.28), 0.1)]  # fmt: skip
    leg = chain([((a - 0.08, 0.22, z - 0.04), 0.35), ((a, -0.2, z - 0.54), 0.21),
                 ((a, 0.2, 0.42), 0.15), ((a, -0.02, 0.14), 0.14)])  # fmt: skip
    foot = join(*(taper((a, 0, 0.13), (a + u, -0.42, 0.12), 0.15, 0.12) for u in (0.04, 0.24)))
    sickle = limb([(a - 0.14, -0.1, 0.2), (a - 0.16, -0.34, 0.52), (a - 0.16, -0.6, 0.5),
                   (a - 0.16, -0.72, 0.32)], 0.14, 0.07)  # fmt: skip
    arm = chain([((0.24, -long, z + 0.02), 0.18), ((0.44, -long + 0.06, z - 0.2), 0.13),
                 ((0.42, -long - 0.3, z - 0.14), 0.12)])  # fmt: skip
    talons = join(*(taper((0.42 + u, -long - 0.34, z - 0.16), (0.4 + u * 2, -long - 0.5, z - 0.36),
                          0.1, 0.07) for u in (-0.08, 0.08)))  # fmt: skip
    snout = chain([((0, y - 0.1, up + 0.02), 0.27), ((0, y - 0.5, up - 0.02), 0.2),
                   ((0, y - 0.86, up - 0.04), 0.16)])  # fmt: skip
    chin = taper((0, y - 0.1, up - 0.24), (0, y - 0.7, up - 0.34), 0.16, 0.11)
    bands = [(1.36, 0.15, 0.17), (0.96, 0.06, 0.24), (0.56, 0.02, wide * 0.86),
             (0.14, 0.02, wide * 0.94), (-0.28, 0.06, wide * 0.96)]  # fmt: skip
    saddle = [within(tube((0, t - 0.09, z + v), (0, t + 0.09, z + v), s + 0.06, 0.03),
                     box((0, t, z + v + 0.58), (1, 1, 0.56))) for t, v, s in bands]  # fmt: skip
    crest = join(*(taper((0, y + u, up + 0.2), (0, y + u + 0.34, up + 0.26 + t), 0.15, 0.08)
                   for u, t in ((-0.04, 0.28), (0.14, 0.02))))  # fmt: skip
    return {
        "body": join(
            blend(0.1, chain(trunk), chain(tail)), egg((0, y, up), (0.31, 0.36, 0.31)),
            snout, both(join(leg, foot, arm)),
        ),
        "belly": join(
            chin,
            chain([((0, 0.4, z - 0.1), wide * 0.76), ((0, -0.3, z - 0.1), wide * 0.88),
                   ((0, -long - 0.08, z + 0.08), 0.26), ((0, y - 0.06, up - 0.26), 0.2)]),
        ),
        "stripes": join(*saddle, crest),
        "claws": both(join(sickle, talons)),
        "eyes": eyes(0.23, y - 0.17, up + 0.13, 0.12),
    }  # fmt: skip


def pterodactyl(draw: Draw) -> Parts:
    """Its leathery wings spread wide: a long pointed bill before, a long crest behind the head."""
    span, wide = draw(1.44, 1.5), draw(0.31, 0.34)
    long, back = draw(1.0, 1.08), draw(0.72, 0.78)
    y, up = -0.5, 2.02
    sail = [(0.0, -0.5), (span * 0.34, -0.74), (span * 0.6, -0.7), (span, 0.16),
            (span * 0.66, 0.06), (span * 0.44, 0.4), (0.24, 0.5), (0.0, 0.6)]  # fmt: skip
    bone = chain([((0.1, -0.46, 0.0), 0.17), ((span * 0.34, -0.72, 0.0), 0.14),
                  ((span * 0.6, -0.7, 0.0), 0.14), ((span * 0.98, 0.12, 0.0), 0.09)])  # fmt: skip
    fingers = join(*(taper((span * 0.58, -0.7, 0.0), (span * 0.58 + u, -0.96, 0.06), 0.12, 0.075)
                     for u in (-0.13, 0.13)))  # fmt: skip
    leg = chain([((0.15, 0.44, -0.02), 0.16), ((0.26, 0.82, 0.04), 0.12),
                 ((0.28, 1.0, 0.18), 0.12)])  # fmt: skip
    lift = draw(-68, -64)

    def posed(solid: Solid) -> Solid:
        """Upright, so that the wings are seen from the front."""
        return tilted(solid, lift, (0, 0, 1.2))

    return {
        "body": join(
            posed(join(egg((0, 0.04, 0), (wide, 0.68, wide)), both(join(bone, fingers, leg)))),
            taper((0, -0.12, 1.52), (0, y, up), 0.27, 0.22),
            egg((0, y, up), (0.28, 0.36, 0.28)),
        ),
        "wings": posed(both(prism(smooth_curve(sail, 3), 2, 0.08))),
        "belly": posed(egg((0, 0.02, -0.12), (wide * 0.8, 0.58, wide * 0.86))),
        "bill": join(taper((0, y - 0.22, up), (0, y - long, up - 0.04), 0.2, 0.075),
                     taper((0, y - 0.16, up - 0.14), (0, y - long * 0.8, up - 0.3), 0.14, 0.075)),
        "crest": chain([((0, y + 0.06, up + 0.14), 0.2), ((0, y + 0.42, up + 0.42), 0.17),
                        ((0, y + back, up + 0.76), 0.08)]),
        "eyes": eyes(0.23, y - 0.15, up + 0.1, 0.115),
    }  # fmt: skip


def mammoth(draw: Draw) -> Parts:
    """Shaggy, with a domed head, a humped back and huge tusks that curve up around its trunk."""
    wide, z, head = draw(0.6, 0.64), draw(1.16, 1.22), draw(0.52, 0.55)
    y, up = -0.76, z + 0.46
    a, b = wide * 0.6, 0.56
    locks = [taper((wide * k, t, z + 0.14), (wide * k + 0.16, t + 0.04, z - v), 0.26, 0.1)
             for k, t, v in ((0.78, -0.42, 0.62), (0.86, -0.06, 0.74), (0.84, 0.3, 0.66),
                             (0.66, 0.64, 0.72))]  # fmt: skip
    rump = taper((0, 0.78, z + 0.1), (0, 1.02, z - 0.56), 0.28, 0.11)
    trunk = chain([((0, y - 0.3, up - 0.2), 0.28), ((0, y - 0.56, up - 0.56), 0.24),
                   ((0, y - 0.64, up - 0.96), 0.19), ((0, y - 0.78, up - 1.2), 0.17),
                   ((0, y - 1.0, up - 1.18), 0.15)])  # fmt: skip
    path = [(0.3, 0.34, -0.34), (0.46, 0.54, -0.68), (0.6, 0.84, -0.94), (0.66, 1.18, -0.98),
            (0.62, 1.44, -0.8), (0.5, 1.56, -0.52), (0.36, 1.54, -0.26)]  # fmt: skip
    tusk = limb([(u, y - v, up + w) for u, v, w in path], 0.17, 0.09)
    cap = egg((0, y + 0.1, up + head * 0.7), (head * 0.8, head * 0.78, head * 0.7))
    fringe = [taper((u, y - head * 0.4, up + head * 0.86), (u * 1.7, y - head * 0.94, up + t),
                    0.17, 0.08) for u, t in ((0.0, 0.3), (0.2, 0.34))]  # fmt: skip
    hump = egg((0, 0.0, z + 0.42), (wide * 0.72, 0.56, 0.36))
    leg = taper((a, b, z - 0.3), (a, b, 0.2), 0.29, 0.26)
    nails = [ball((a + u, t * b - v, 0.13), 0.11) for t in (1, -1)
             for u, v in ((-0.14, 0.22), (0.1, 0.26))]  # fmt: skip
    return {
        "fur": join(
            blend(0.2, egg((0, 0.1, z), (wide, 0.9, wide * 0.96)),
                  egg((0, y, up), (head * 0.96, head * 0.9, head * 1.14))),
            trunk, both(leg, 0, 1),
        ),
        "hair": join(both(join(*locks, *fringe)), cap, hump, rump),
        "ears": both(moved(turned(egg((0, 0, 0), (0.28, 0.12, 0.32)), 2, -24),
                           (head * 1.06, y + 0.1, up - 0.06))),
        "tusks": both(tusk),
        "nails": both(join(*nails)),
        "eyes": eyes(head * 0.58, y - head * 0.74, up - 0.02, 0.13),
    }  # fmt: skip


def phoenix(draw: Draw) -> Parts:
    """Red and orange, its wings raised and spread, a crest of flames, a long tail of three."""
    wide, span, lift = draw(0.36, 0.4), draw(1.38, 1.46), draw(0.62, 0.68)
    z, y = 1.5, -0.12
    up, head = z + 0.78, draw(0.29, 0.31)
    high = z + 0.4 + lift
    wing = smooth_curve([(0.08, z + 0.42), (span * 0.4, z + 0.66), (span * 0.68, high - 0.02),
                         (span * 0.74, high - 0.42), (span * 0.5, z + 0.06),
                         (0.1, z - 0.2)])  # fmt: skip
    fringe = [(0.08, z + 0.3), (span * 0.5, z + 0.8), (span * 0.74, high + 0.42),
              (span * 0.8, high - 0.04), (span, high + 0.12), (span * 0.92, high - 0.36),
              (span * 1.08, z + 0.42), (span * 0.82, z + 0.3), (span * 0.86, z - 0.1),
              (span * 0.6, z), (span * 0.54, z - 0.42), (span * 0.3, z - 0.14),
              (0.1, z - 0.4)]  # fmt: skip
    side = [((0.1, 0.1, z - 0.4), 0.15), ((0.34, 0.3, z - 0.85), 0.18), ((0.5, 0.46, 0.34), 0.22),
            ((0.84, 0.52, 0.22), 0.14)]  # fmt: skip
    middle = [((0, 0.1, z - 0.4), 0.17), ((0, 0.42, z - 0.85), 0.2), ((0, 0.78, 0.34), 0.23)]
    flame = taper((0.88, 0.52, 0.24), (1.16, 0.54, 0.66), 0.2, 0.07)
    crest = [taper((0, y + v, up + 0.16), (0, y + 2 * v + 0.14, up + t), 0.14, 0.07)
             for v, t in ((-0.06, 0.66), (0.14, 0.56))]  # fmt: skip
    foot = join(
        taper((0.18, -0.1, z - 0.5), (0.2, -0.24, z - 0.82), 0.13, 0.09),
        ball((0.2, -0.28, z - 0.86), 0.13),
    )
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, wide * 0.94, 0.62)),
                  taper((0, 0, z + 0.3), (0, y, up), 0.24, 0.2), ball((0, y, up), head)),
        ),
        "wings": both(prism(wing, 1, 0.11, 0.1)),
        "tail": join(both(chain(side)), chain(middle)),
        "tips": join(
            both(join(prism(fringe, 1, 0.085, 0.2), flame)), *crest,
            taper((0, 0.8, 0.3), (0, 1.24, 0.6), 0.2, 0.07),
            egg((0, -0.16, z - 0.1), (wide * 0.66, 0.28, 0.42)),
        ),
        "bill": join(
            taper((0, y - head * 0.8, up), (0, y - head - 0.26, up - 0.12), 0.14, 0.07), both(foot)
        ),
        "eyes": eyes(head * 0.66, y - head * 0.66, up + 0.08, 0.09),
    }  # fmt: skip


def pegasus(draw: Draw) -> Parts:
    """A white horse with a golden mane, its feathered wings raised."""
    wide, long, head = draw(0.36, 0.39), draw(0.76, 0.82), draw(0.24, 0.26)
    z = draw(1.06, 1.12)
    y, up = -long - 0.22, z + 0.8
    feather = [(-0.1, -0.16), (0.34, -0.06), (0.72, 0.06), (1.08, 0.3), (0.96, 0.5),
               (1.12, 0.62), (0.96, 0.8), (1.04, 0.98), (0.8, 1.06), (0.8, 1.28), (0.5, 1.24),
               (0.2, 1.0), (-0.02, 0.6), (-0.24, 0.1)]  # fmt: skip
    shoulder = [(-0.16, -0.1), (0.3, 0.02), (0.62, 0.32), (0.56, 0.74), (0.2, 0.98), (-0.04, 0.6),
                (-0.26, 0.1)]  # fmt: skip
    at = (wide * 0.72, -0.26, z + 0.24)
    crest = chain([((0, -long * 0.5, z + 0.36), 0.15), ((0, y + 0.24, up - 0.06), 0.17),
                   ((0, y + 0.06, up + 0.26), 0.15), ((0, y - 0.2, up + 0.2), 0.1)])  # fmt: skip
    tail = chain([((0, long * 0.92, z + 0.14), 0.12), ((0, long + 0.3, z + 0.06), 0.17),
                  ((0, long + 0.42, z - 0.36), 0.18),
                  ((0, long + 0.36, z - 0.74), 0.08)])  # fmt: skip
    ear = taper((0.12, y + 0.08, up + 0.16), (0.17, y + 0.06, up + 0.42), 0.1, 0.06)
    a, b = wide * 0.58, long * 0.68
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, long, wide)),
                  taper((0, -long * 0.62, z + 0.06), (0, y + 0.04, up), 0.28, 0.21)),
            ball((0, y, up), head), taper((0, y, up), (0, y - 0.44, up - 0.26), 0.22, 0.16),
            four_legs(a, b, z - 0.06, 0.145), both(ear),
        ),
        "wings": both(moved(turned(prism(smooth_curve(shoulder), 0, 0.13), 1, 26), at)),
        "feathers": both(moved(turned(prism(feather, 0, 0.085), 1, 26), at)),
        "mane": join(crest, tail),
        "hooves": both(tube((a, b, 0.0), (a, b, 0.19), 0.185, 0.02), 0, 1),
        "eyes": eyes(0.2, y - 0.13, up + 0.05, 0.085),
    }  # fmt: skip


DINOSAURS_AND_MYTHICAL_BEASTS = {
    "triceratops": fitted(triceratops),
    "stegosaurus": fitted(stegosaurus),
    "brachiosaurus": fitted(brachiosaurus),
    "velociraptor": fitted(velociraptor),
    "pterodactyl": pterodactyl,
    "mammoth": fitted(mammoth),
    "phoenix": phoenix,
    "pegasus": fitted(pegasus),
}
