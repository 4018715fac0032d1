"""Reptiles, insects and a scorpion."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    grown,
    join,
    limb,
    mirrored,
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


def _spike(at: Vector, high: float, lean: float = 0.0) -> Solid:
    """A pyramid that stands on ``at``, turned about x by ``lean`` degrees, its tip to the back."""
    side = prism([(-0.15, -0.12), (0.15, -0.12), (0.11, high)], 0, 0.14)
    front = prism([(-0.15, -0.12), (0.15, -0.12), (0.04, high), (-0.04, high)], 1, 0.3)
    return tilted(within(side, front), lean, at)


def crocodile(draw: Draw) -> Parts:
    """Long and low: a flat snout full of teeth, two rows of scutes, splayed legs, a long tail."""
    wide, snout, bend = draw(0.38, 0.45), draw(0.76, 0.88), draw(0.2, 0.34)
    z, y = 0.4, -0.62
    trunk = blend(0.1, egg((0, 0, z), (wide, 0.86, 0.27)), egg((0, y, z + 0.04), (0.3, 0.36, 0.22)))
    tail = chain(
        [((0, 0.4, z), 0.26), ((0, 0.95, z - 0.06), 0.22), ((bend * 0.3, 1.4, 0.24), 0.16),
         ((bend, 1.9, 0.2), 0.1)]
    )  # fmt: skip
    half = [(0.27, 0.2), (0.21, -snout * 0.55), (0.25, -snout * 0.8), (0.17, -snout)]
    upper, lower = (
        tilted(prism([(s * u, s * v) for u, v in mirrored(half)], 2, 0.1), lean, (0, y - 0.1, at))
        for s, lean, at in ((1, -10, z + 0.13), (0.92, 4, z - 0.14))
    )
    saw = [(-snout * (0.16 + 0.1 * k), -0.06 - 0.2 * (k % 2)) for k in range(9)]
    teeth = tilted(prism(saw, 0, 0.09, 0.12), -10, (0, y - 0.1, z + 0.13))
    legs, nose = [], (0.1, y - 0.06 - snout * 0.88, z + 0.13 + snout * 0.16 + 0.1)
    for at, back in ((-0.5, 0.06), (0.52, 0.14)):
        x = wide + 0.26
        legs.append(limb([(wide * 0.6, at, z), (x, at + back, z - 0.1), (x, at, 0.1)], 0.18, 0.13))
        paw = [(-0.1, 0.1), (0.1, 0.1), (0.22, -0.2), (0.1, -0.16), (0, -0.3), (-0.1, -0.16),
               (-0.22, -0.2)]  # fmt: skip
        legs.append(moved(grown(prism(paw, 2, 0.05), 0.05), (x, at, 0.09)))
    bumps = join(ball((0.19, y - 0.06, z + 0.24), 0.16), ball(nose, 0.1))
    scutes = [_spike((0.17, at, z + 0.2 - 0.12 * at * at), 0.17) for at in (-0.32, 0.08, 0.48)]
    fins = [
        _spike((bend * s, at, up), 0.2)
        for at, up, s in ((0.88, z + 0.16, 0.04), (1.26, 0.42, 0.22), (1.62, 0.34, 0.62))
    ]
    return {
        "body": join(trunk, tail, upper, both(join(*legs, bumps))),
        "belly": join(lower, egg((0, 0, z - 0.08), (wide * 0.92, 0.84, 0.27))),
        "crest": join(both(join(*scutes)), *fins),
        "teeth": both(teeth),
        "eyes": both(ball((0.24, y - 0.14, z + 0.27), 0.11)),
    }


def lizard(draw: Draw) -> Parts:
    """Low on splayed legs with round toes; a broad head, big eyes, a long raised tail."""
    wide, long, up = draw(0.3, 0.36), draw(0.52, 0.6), draw(0.3, 0.6)
    z, y = 0.4, -long - 0.36
    trunk = blend(
        0.12,
        egg((0, 0, z), (wide, long + 0.1, 0.27)),
        limb([(0, long * 0.6, z), (0, long + 0.3, z - 0.1), (0, long + 0.68, z - 0.18),
              (0, long + 1.0, z - 0.02), (0, long + 1.2, z + up)], 0.25, 0.1),
        taper((0, -long * 0.6, z), (0, y, z + 0.14), 0.24, 0.27),
    )  # fmt: skip
    snout = egg((0, y - 0.2, z + 0.1), (0.3, 0.36, 0.2))
    legs, toes = [], []
    for at, ahead in ((-0.36, -0.24), (0.4, 0.14)):
        x, b = wide + 0.36, at + ahead
        legs.append(limb([(wide * 0.6, at, z), (x - 0.05, at + 0.04, z), (x, b, 0.1)], 0.14, 0.11))
        toes += [ball((x + a, b + c, 0.09), 0.11) for a, c in ((-0.12, -0.14), (0.07, -0.18),
                                                              (0.2, -0.03))]  # fmt: skip
    ridge = [
        taper((0, at, h), (0, at + 0.06, h + 0.14), 0.12, 0.06)
        for at, h in ((y + 0.2, z + 0.32), (-long * 0.55, z + 0.22), (-0.02, z + 0.26),
                      (long * 0.55, z + 0.22), (long + 0.1, z + 0.12))
    ]  # fmt: skip
    eye = (0.24, y - 0.06, z + 0.3)
    return {
        "body": join(trunk, snout, both(join(*legs))),
        "belly": egg((0, -0.02, z - 0.07), (wide * 0.9, long + 0.08, 0.25)),
        "crest": join(*ridge),
        "feet": both(join(*toes)),
        "eyes": both(ball(eye, 0.15)),
        "pupils": both(ball((eye[0] + 0.08, eye[1] - 0.06, eye[2] + 0.03), 0.1)),
    }


def chameleon(draw: Draw) -> Parts:
    """On a branch: a high flat body with a crest, a helmet, turning eyes, a tail in a spiral."""
    wide, long, high = draw(0.34, 0.37), draw(0.76, 0.82), draw(0.5, 0.54)
    z, y = 1.0, -0.98
    up, r = 1.16, draw(0.5, 0.54)
    core = (long + 0.34, z - 0.36)
    coil = [(0, long * 0.6, z + 0.06)]
    for k in range(15):
        turn, out = math.radians(100 - 30 * k), r - 0.026 * k
        coil.append((0, core[0] + out * math.cos(turn), core[1] + out * math.sin(turn)))
    leg = [
        limb([(wide * 0.7, at, z - 0.16), (wide + 0.2, at + lean, z - 0.34),
              (0.22, at + lean * 0.5, 0.36)], 0.14, 0.12)
        for at, lean in ((-0.46, 0.1), (0.42, -0.06))
    ]  # fmt: skip
    spine = [(0, -long * 0.46, z + high * 0.9), (0, -long * 0.1, z + high * 1.02),
             (0, long * 0.3, z + high * 0.94), (0, long * 0.64, z + high * 0.68)]  # fmt: skip
    return {
        "body": join(
            blend(0.12, egg((0, 0, z), (wide, long, high)),
                  egg((0, y + 0.16, up), (0.3, 0.42, 0.3))),
            taper((0, y, up - 0.02), (0, y - 0.4, up - 0.1), 0.24, 0.14),
            taper((0, y + 0.12, up + 0.12), (0, y + 0.46, up + 0.56), 0.27, 0.12),
            limb(coil, 0.19, 0.11), both(join(*leg)),
        ),
        "crest": join(*(egg(at, (0.1, 0.17, 0.16)) for at in spine)),
        "stripes": both(join(*(
            moved(turned(egg((0, 0, 0), (0.1, 0.1, 0.34)), 0, 12), (wide * out, at, z + 0.06))
            for at, out in ((-0.34, 0.9), (0.02, 0.97), (0.38, 0.88))
        ))),
        "eyes": both(ball((0.28, y - 0.02, up + 0.08), 0.2)),
        "pupils": both(ball((0.41, y - 0.12, up + 0.1), 0.125)),
        "branch": join(tube((0, -1.3, 0.18), (0, 1.1, 0.18), 0.2, 0.06),
                       taper((0, 0.2, 0.2), (-0.5, -0.2, 0.2), 0.15, 0.12)),
    }  # fmt: skip


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


def caterpillar(draw: Draw) -> Parts:
    """A row of balls, its head raised to the front, or its back in an arch."""
    r, step, foot, head = draw(0.4, 0.43), draw(0.47, 0.5), 0.14, draw(0.44, 0.48)
    heights = (0.42, 0.08, 0.0, 0.04, 0.16) if draw.chance(0.5) else (0.06, 0.34, 0.52, 0.34, 0.0)
    spots = [(step * (k - 1.5), foot + r + rise) for k, rise in enumerate(heights)]
    y, z = spots[0][0] - 0.42, spots[0][1] + 0.3
    beads = [ball((0, v, w), r) for v, w in spots]
    low = [(v, w) for v, w in spots if w < r + 0.25]
    feet = [capsule((0.2, v, w - 0.2), (0.26, v, w - r), 0.14) for v, w in low]
    feeler = [(0.16, y, z + head * 0.7), (0.24, y - 0.02, z + head + 0.22)]
    return {
        "body": join(*beads[1::2]),
        "rings": join(*beads[::2]),
        "head": ball((0, y, z), head),
        "eyes": both(ball((0.19, y - head * 0.82, z + 0.12), 0.14)),
        "antennae": both(join(limb(feeler, 0.1, 0.1), ball(feeler[-1], 0.16))),
        "feet": both(join(*feet)),
    }


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


def beetle(draw: Draw) -> Parts:
    """A stag beetle: two shiny wing covers with a seam, six bent legs, jaws like antlers."""
    wide, long, high = draw(0.74, 0.78), draw(0.9, 0.96), draw(0.7, 0.74)
    z = 0.36
    y = -long * 0.62
    cover = within(egg((0.06, 0.3, z), (wide, long, high)), box((1.0, 0, z + 0.96), (1, 3, 1)))
    jaw = limb([(0.22, y - 0.6, z - 0.02), (0.56, y - 0.92, z + 0.1), (0.58, y - 1.22, z + 0.36),
                (0.26, y - 1.38, z + 0.6)], 0.17, 0.11)  # fmt: skip
    tooth = taper((0.57, y - 1.06, z + 0.22), (0.28, y - 1.12, z + 0.3), 0.14, 0.1)
    legs = [
        limb([(wide * 0.7, at, z - 0.06), (wide + 0.2, at + lean, z + 0.06),
              (wide + 0.38, at + lean * 1.7, 0.11)], 0.15, 0.115)
        for at, lean in ((-0.5, -0.26), (0.2, 0.06), (0.74, 0.3))
    ]  # fmt: skip
    return {
        "shell": both(cover),
        "seam": within(egg((0, 0.3, z), (wide + 0.05, long + 0.05, high + 0.05)),
                       box((0, 0, z + 1), (0.07, 3, 1.1))),
        "head": join(
            egg((0, y, z + 0.08), (wide * 0.94, 0.46, 0.5)),
            egg((0, y - 0.44, z + 0.08), (0.5, 0.34, 0.34)),
            egg((0, 0.3, z - 0.04), (wide * 0.94, long * 0.94, 0.2)),
        ),
        "jaws": both(join(jaw, tooth)),
        "legs": both(join(*legs)),
        "eyes": eyes(0.34, y - 0.6, z + 0.32, 0.14),
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


REPTILES_AND_INSECTS = {
    "crocodile": fitted(crocodile),
    "lizard": fitted(lizard),
    "chameleon": fitted(chameleon),
    "scorpion": fitted(scorpion),
    "caterpillar": caterpillar,
    "ant": fitted(ant),
    "beetle": fitted(beetle),
    "ladybug": fitted(ladybug),
    "dragonfly": fitted(dragonfly),
}
