"""Insects, and the scorpion."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    join,
    limb,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.animals import fitted


def _legs(count: int, x: float, y: float, z: float, knee: float, out: float) -> Solid:
    """Pairs of bent legs, spread about ``y``."""
    legs = []
    for k in range(count):
        angle = math.radians(-46 + 92 * k / (count - 1))
        c, s = math.cos(angle), math.sin(angle)
        steps = [(x, z), (out * 0.55, knee), (out, 0.1)]
        at = y + 0.16 * (k - (count - 1) / 2)
        legs.append(limb([(c * r, at + s * (r - x), h) for r, h in steps], 0.11, 0.09))
    return both(join(*legs))


def scorpion(draw: Draw) -> Parts:
    """Two claws to the front, a tail of beads that arches over the back to its sting."""
    wide, high, claw = draw(0.36, 0.44), draw(1.2, 1.4), draw(0.9, 1.1)
    z, beads = 0.36, []
    for k in range(6):
        a = math.radians(-62 + 37 * k)
        beads.append(
            ((0, 0.72 + 0.52 * math.cos(a), high * 0.53 + high * 0.42 * math.sin(a)), 0.19)
        )
    end = beads[-1][0]
    x, y = wide + 0.36, -0.98
    arm = limb([(wide * 0.6, -0.42, z), (x, -0.6, z + 0.04), (x - 0.06, y, z + 0.04)], 0.13, 0.13)
    palm = egg((x - 0.08, y - 0.12, z + 0.05), (0.22 * claw, 0.26 * claw, 0.18))
    px, pz = x - 0.08, z + 0.05
    fingers = [
        limb([(px + 0.14 * s, y - 0.24, pz), (px + 0.24 * s * claw, y - 0.46, pz),
              (px + 0.1 * s, y - 0.24 - 0.44 * claw, pz)], 0.12, 0.08)
        for s in (-1, 1)
    ]  # fmt: skip
    plates = [
        egg((0, at, z), (wide * s, 0.26, 0.26 * s))
        for at, s in ((-0.1, 1.0), (0.22, 0.94), (0.52, 0.8))
    ]
    return {
        "body": join(egg((0, -0.44, z), (wide, 0.34, 0.27)), *plates),
        "claws": both(join(arm, palm, *fingers)),
        "legs": _legs(4, 0.2, 0.0, z - 0.02, 0.52, 0.96),
        "tail": join(chain([((0, 0.6, z), 0.22), beads[0]]), *(ball(at, r) for at, r in beads),
                     chain([(at, 0.12) for at, _ in beads])),
        "tip": chain([((0, end[1] - 0.1, end[2] + 0.02), 0.17),
                      ((0, end[1] - 0.36, end[2] - 0.1), 0.1),
                      ((0, end[1] - 0.44, end[2] - 0.3), 0.06)]),
        "eyes": both(ball((0.13, -0.66, z + 0.2), 0.085)),
    }  # fmt: skip


def ant(draw: Draw) -> Parts:
    """Three segments, bent feelers, six legs."""
    rear, head, z = draw(0.42, 0.5), draw(0.4, 0.46), draw(0.48, 0.56)
    y, h = -0.84, z + 0.12
    feeler = limb(
        [(0.16, y - 0.16, h + 0.26), (0.3, y - 0.2, h + 0.68), (0.44, y - 0.56, h + 0.74)],
        0.09,
        0.09,
    )
    jaw = limb(
        [(0.2, y - 0.3, h - 0.18), (0.24, y - 0.52, h - 0.22), (0.12, y - 0.62, h - 0.24)],
        0.1,
        0.08,
    )
    middle = egg((0, -0.12, z), (0.27, 0.38, 0.27))
    waist = tube((0, 0.1, z), (0, 0.4, z + 0.04), 0.12)
    return {
        "body": join(
            egg((0, 0.46 + rear, z + 0.12), (rear, rear * 1.34, rear * 0.95)), middle, waist,
            ball((0, 0.28, z + 0.04), 0.16), egg((0, y, h), (head, head * 0.94, head * 0.88)),
            taper((0, -0.3, z), (0, y, h), 0.14, 0.14),
        ),
        "legs": _legs(3, 0.14, -0.1, z, draw(0.62, 0.74), 0.94),
        "antennae": both(feeler),
        "jaws": both(jaw),
        "eyes": both(egg((head * 0.76, y - head * 0.5, h + 0.1), (0.12, 0.13, 0.15))),
    }  # fmt: skip


def ladybug(draw: Draw) -> Parts:
    """A red dome with black dots and a seam, a black head with white cheeks, short feelers."""
    wide, long, high = draw(0.68, 0.76), draw(0.76, 0.86), draw(0.6, 0.7)
    z = 0.24
    below = box((0, 0, z - 1), (2, 2, 1))
    dots = []
    for out, at in ((0.56, -0.42), (0.68, 0.16), (0.42, 0.62), (0.3, 0.1)):
        up = math.sqrt(1 - out * out - at * at)
        dots.append(ball((wide * out * 0.93, 0.08 + long * at * 0.93, z + high * up * 0.93), 0.17))
    seam = cut(
        egg((0, 0.08, z), (wide + 0.03, long + 0.03, high + 0.03)),
        below, box((1.075, 0, 0), (1, 3, 3)), box((-1.075, 0, 0), (1, 3, 3)),
    )  # fmt: skip
    y = -long + 0.08
    feeler = limb([(0.14, y - 0.1, z + 0.3), (0.34, y - 0.34, z + 0.62)], 0.085, 0.085)
    legs = [
        taper((wide * 0.7, at, 0.2), (wide + 0.16, at * 1.2, 0.09), 0.13, 0.1)
        for at in (-0.4, 0.1, 0.58)
    ]
    return {
        "shell": cut(egg((0, 0.08, z), (wide, long, high)), below),
        "patches": join(both(join(*dots)), seam),
        "head": join(
            egg((0, y, z + 0.13), (0.46, 0.32, 0.32)), both(feeler),
            both(ball((0.36, y - 0.36, z + 0.64), 0.115)),
            egg((0, 0.08, z - 0.04), (wide * 0.93, long * 0.95, 0.13)),
        ),
        "legs": both(join(*legs)),
        "eyes": both(ball((0.27, y - 0.2, z + 0.14), 0.12)),
    }  # fmt: skip


def dragonfly(draw: Draw) -> Parts:
    """A long slim banded tail, four rounded wings held well apart, two huge eyes, six legs."""
    long, span, z = draw(1.4, 1.5), draw(1.28, 1.38), 0.56
    vane = [(0, -0.1), (0.4, -0.17), (span - 0.24, -0.24), (span, 0), (span - 0.24, 0.24),
            (0.4, 0.17), (0, 0.1)]  # fmt: skip
    wing = turned(prism(smooth_curve(vane, 3), 2, 0.085), 1, -8)
    pairs = (moved(turned(wing, 2, turn), (0.06, at, z + 0.16)) for at, turn in
             ((-0.36, -12), (-0.02, 26)))  # fmt: skip
    bands = (tube((0, at - 0.08, z), (0, at + 0.08, z), 0.215, 0.03) for at in
             (0.2 + long * share for share in (0.3, 0.56, 0.82)))  # fmt: skip
    legs = (taper((0.14, at * 0.7 - 0.16, z - 0.1), (0.42, at - 0.2, 0.11), 0.12, 0.11)
            for at in (-0.5, 0.0, 0.5))  # fmt: skip
    return {
        "body": join(
            capsule((0, 0.1, z), (0, 0.2 + long, z), 0.14),
            egg((0, -0.2, z), (0.3, 0.48, 0.3)),
            ball((0, -0.74, z), 0.24),
        ),
        "stripes": join(*bands),
        "wings": both(join(*pairs)),
        "legs": both(join(*legs)),
        "eyes": both(ball((0.23, -0.86, z + 0.08), 0.25)),
    }


INSECTS = {
    "scorpion": fitted(scorpion),
    "ant": fitted(ant),
    "ladybug": fitted(ladybug),
    "dragonfly": fitted(dragonfly),
}
