"""The best known wild animals of the sea and of the air."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
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
)
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.wings_and_claws import bird_claws


def bird(draw: Draw) -> Parts:
    """A songbird on two legs, its wings folded or raised."""
    wide, leg, head = draw(0.34, 0.42), draw(0.3, 0.45), draw(0.27, 0.32)
    z, raised = leg + wide * 0.85, draw.chance(0.3)
    hy, hz = -0.48, z + draw(0.42, 0.52)
    trunk = taper((0, 0.3, z - 0.03), (0, -0.18, z + 0.05), wide * 0.72, wide)
    fan = [(-0.1, -0.3), (0.1, -0.3), (0.2, 0.55), (0, 0.62), (-0.2, 0.55)]
    tail = tilted(prism(fan, 2, 0.075), draw(-12, 20), (0, 0.75, z + 0.03))
    folded = tilted(egg((0, 0, 0), (0.13, 0.56, 0.25)), -8, (wide * 0.9, 0.22, z + 0.08))
    vane = [(0, -0.3), (0.4, -0.42), (0.85, -0.3), (1.05, 0.0), (0.75, 0.12), (0.4, 0.36), (0, 0.3)]
    spread = moved(
        turned(prism(smooth_curve(vane), 2, 0.08), 1, -draw(25, 50)), (wide * 0.5, 0, z + 0.15)
    )
    shank = taper((0.2, 0.05, z - wide * 0.4), (0.2, 0.02, 0.09), 0.1, 0.075)
    return {
        "body": join(blend(0.15, trunk, ball((0, hy, hz), head)), tail),
        "belly": egg((0, -0.27, z - 0.02), (wide * 0.82, wide * 0.95, wide * 0.9)),
        "wings": both(spread if raised else folded),
        "bill": taper(
            (0, hy - head * 0.8, hz - 0.02), (0, hy - head - 0.24, hz - 0.07), 0.12, 0.05
        ),
        "legs": both(join(shank, bird_claws(0.2, 0, 0.075, 0.2, 0.075))),
        "eyes": both(ball((head * 0.66, hy - head * 0.62, hz + head * 0.3), 0.08)),
    }


def owl(draw: Draw) -> Parts:
    """Sits upright: a face of two discs, tufts, folded wings."""
    wide, high = draw(0.48, 0.58), draw(0.62, 0.75)
    head, z = wide * draw(0.84, 0.96), high * 1.62
    y, x = -head * 0.78, head * 0.46
    tuft = taper(
        (head * 0.55, -0.05, z + head * 0.6),
        (head * 0.95, 0.0, z + head * draw(1.1, 1.4)),
        0.17,
        0.06,
    )
    tail = box((0, wide * 0.75, 0.2), (0.22, 0.22, 0.12), 0.06)
    trunk = blend(0.15, egg((0, 0, high), (wide, wide * 0.85, high * 0.95)), ball((0, 0, z), head))
    wing = egg((wide * 0.9, 0.08, high * 0.95), (0.16, wide * 0.62, high * 0.72))
    belly = egg((0, -0.14, high * 0.85), (wide * 0.72, wide * 0.85, high * 0.72))
    bill = taper((0, y - 0.1, z - head * 0.12), (0, y - 0.22, z - head * 0.5), 0.11, 0.06)
    foot = join(
        taper((0.25, -0.1, 0.4), (0.28, -0.28, 0.14), 0.16, 0.14),
        egg((0.28, -0.36, 0.14), (0.2, 0.32, 0.14)),
    )
    return {
        "body": join(trunk, both(tuft), tail),
        "belly": join(belly, both(tube((x, y - 0.12, z), (x, y + 0.2, z), head * 0.5, 0.05))),
        "wings": both(wing),
        "eyes": both(tube((x, y - 0.2, z), (x, y, z), head * 0.34, 0.05)),
        "pupils": both(ball((x, y - 0.18, z), head * 0.19)),
        "bill": join(bill, both(foot)),
    }


def penguin(draw: Draw) -> Parts:
    """Stands upright, a white front, flippers at its sides."""
    wide, high, head = draw(0.46, 0.56), draw(0.7, 0.85), draw(0.34, 0.4)
    z, out = high * 1.95, draw(0.1, 0.42)
    y = -head * 0.5
    trunk = blend(0.2, egg((0, 0, high), (wide, wide * 0.88, high * 0.96)), ball((0, 0, z), head))
    wing = taper((wide * 0.72, 0, high * 1.42), (wide + out, 0.0, high * 0.72), 0.15, 0.1)
    cheek = egg((head * 0.4, y, z - 0.04), (head * 0.46, head * 0.52, head * 0.56))
    return {
        "body": join(trunk, taper((0, wide * 0.6, 0.25), (0, wide + 0.1, 0.1), 0.16, 0.09)),
        "belly": join(
            egg((0, -0.13, high * 0.93), (wide * 0.82, wide * 0.86, high * 0.84)), both(cheek)
        ),
        "wings": both(wing),
        "bill": taper(
            (0, -head * 0.8, z - 0.06), (0, -head - draw(0.16, 0.28), z - 0.12), 0.13, 0.06
        ),
        "feet": both(egg((wide * 0.5, -wide * 0.55, 0.09), (0.22, 0.34, 0.11))),
        "eyes": both(ball((head * 0.42, -head * 0.86, z + head * 0.2), 0.08)),
    }


def _fluke(wide: float, long: float, half: float) -> Solid:
    """A whale's tail fin, flat, from the origin to the back."""
    side = [(0, -0.15), (0.14, -0.12), (wide * 0.6, long * 0.2), (wide, long * 0.75),
            (wide * 0.98, long), (wide * 0.5, long * 0.8), (0.0, long * 0.5)]  # fmt: skip
    return both(prism([*side, (-0.05, long * 0.5), (-0.05, -0.15)], 2, half))


def whale(draw: Draw) -> Parts:
    """A huge head, a pale belly, a raised fluke."""
    wide, high, rise = draw(0.56, 0.68), draw(0.5, 0.6), draw(0.35, 0.75)
    z = high
    trunk = blend(
        0.35,
        egg((0, -0.45, z), (wide, 0.95, high)),
        taper((0, 0.1, z), (0, 0.85, z + rise * 0.3), high * 0.72, 0.25),
        taper((0, 0.85, z + rise * 0.3), (0, 1.25, z + rise), 0.25, 0.14),
    )
    fin = [(0, -0.2), (0.3, -0.1), (0.75, 0.35), (0.5, 0.35), (0, 0.15)]
    flipper = moved(turned(prism(fin, 2, 0.085), 1, draw(15, 40)), (wide * 0.7, -0.45, z - 0.22))
    fluke = tilted(_fluke(draw(0.6, 0.8), 0.5, 0.09), draw(20, 50), (0, 1.25, z + rise))
    return {
        "body": trunk,
        "belly": egg((0, -0.52, z - 0.13), (wide * 0.93, 0.92, high * 0.8)),
        "fins": join(both(flipper), fluke),
        "eyes": both(ball((wide * 0.8, -0.98, z + 0.12), 0.09)),
    }


def dolphin(draw: Draw) -> Parts:
    """Leaps in an arch: a beak, a curved dorsal fin, flippers, level flukes."""
    wide, bend, half = draw(0.36, 0.4), draw(0.36, 0.44), 0.1
    z = 1.0

    def spine(y: float, down: float = 0.0) -> Vector:
        """On the back's arch, or below it at a right angle."""
        slope = -2 * bend * (y + 0.15)
        norm = math.hypot(1, slope)
        return (0, y + down * slope / norm, z - bend * (y + 0.15) ** 2 - down / norm)

    def along(girth: list[tuple[float, float]], share: float, down: float) -> Solid:
        return chain(
            (spine(y, down * r * wide), r * wide * share) for y, r in smooth_curve(girth, 3)
        )

    girth = [(-0.86, 0.6), (-0.68, 0.8), (-0.32, 1.0), (0.06, 0.94), (0.5, 0.66), (0.9, 0.37),
             (1.2, 0.27)]  # fmt: skip
    beak = taper(spine(-0.86, 0.08), spine(-1.28, 0.13), 0.17, 0.1)
    top = spine(0.06)[2]
    fin = smooth_curve([(-0.2, top), (-0.04, top + wide + 0.14), (0.2, top + wide + 0.32),
                        (0.42, top + wide + 0.34)])  # fmt: skip
    fin += smooth_curve([(0.46, top + wide + 0.28), (0.32, top + wide + 0.14), (0.36, top)])
    vane = [(0, -0.2), (0.26, -0.18), (0.56, 0.06), (0.7, 0.36), (0.62, 0.42), (0.34, 0.26),
            (0, 0.18)]  # fmt: skip
    _, y, low = spine(-0.46, wide * 0.5)
    flipper = moved(turned(prism(smooth_curve(vane), 2, half), 1, 36), (wide * 0.6, y, low))
    slope = -math.degrees(math.atan(2 * bend * 1.35))
    tail = [(0, -0.24), (0.18, -0.12), (0.44, 0.06), (0.64, 0.36), (0.6, 0.46), (0.34, 0.34),
            (0.1, 0.28), (0, 0.22)]  # fmt: skip
    fluke = tilted(prism(mirrored(tail), 2, half), slope + 12, spine(1.24))
    return {
        "body": join(along(girth, 1.0, 0.0), beak, prism(fin, 0, half), both(flipper), fluke),
        "belly": along([(y, r) for y, r in girth[:-1]], 0.96, 0.24),
        "eyes": both(ball((wide * 0.66, *spine(-0.76, -0.05)[1:]), 0.11)),
    }


def shark(draw: Draw) -> Parts:
    """A pointed snout, fins, a tall tail, teeth."""
    wide, z, half = draw(0.36, 0.44), 0.62, 0.09
    high = wide * draw(1.0, 1.12)
    trunk = blend(
        0.2,
        egg((0, -0.2, z), (wide, 0.85, high)),
        taper((0, -0.55, z), (0, -1.12, z + 0.1), wide * 0.78, 0.17),
        taper((0, 0.2, z), (0, 1.0, z + 0.08), wide * 0.75, 0.13),
    )
    back, top = draw(-0.3, -0.1), z + high
    dorsal = [(0, z), (0.4, top + draw(0.38, 0.5)), (0.52, top + 0.36), (0.5, top), (0.62, z)]
    caudal = [(0.9, z - 0.05), (1.3, z + 0.72), (1.46, z + 0.7), (1.25, z + 0.12),
              (1.36, z - 0.3), (1.22, z - 0.34)]  # fmt: skip
    fin = [(0, -0.25), (0.3, -0.15), (0.72, 0.25), (0.7, 0.38), (0.3, 0.22), (0, 0.25)]
    side = moved(turned(prism(fin, 2, half), 1, draw(15, 35)), (wide * 0.6, -0.3, z - 0.12))
    rear = moved(
        turned(prism([(0.6 * x, 0.6 * y) for x, y in fin], 2, half), 1, 35), (0.12, 0.5, z - 0.05)
    )
    upright = prism([(back + y, h) for y, h in dorsal], 0, half)
    low = taper((0, 0.1, z - 0.15), (0, 0.85, z + 0.03), wide * 0.72, 0.13)
    teeth = [
        taper((x, y, z - 0.07), (x, y, z - 0.18), 0.07, 0.03)
        for x, y in ((0.08, -1.17), (0.2, -1.1))
    ]
    return {
        "body": join(trunk, upright, prism(caudal, 0, half), both(join(side, rear))),
        "belly": join(egg((0, -0.25, z - 0.13), (wide * 0.95, 0.8, high * 0.92)), low),
        "mouth": egg((0, -1.0, z - 0.12), (0.28, 0.27, 0.15)),
        "teeth": both(join(*teeth)),
        "eyes": both(ball((wide * 0.68, -0.82, z + 0.14), 0.085)),
    }


def fish(draw: Draw) -> Parts:
    """Its head to the front, its tail to the back."""
    thick, long, high = draw(0.28, 0.34), draw(0.88, 1.0), draw(0.48, 0.6)
    spread, up = draw(0.46, 0.58), draw(0.24, 0.34)
    # Forked, its root within the body.
    tail = [(long - 0.3, 0.1), (long + 0.26, spread), (long + 0.62, spread + 0.1),
            (long + 0.36, 0.0)]  # fmt: skip
    tail += [(b, -c) for b, c in reversed(tail[:3])]
    back = [(-0.45, high * 0.75), (-0.2, high + up), (0.3, high + up * 0.8), (0.62, high * 0.5)]
    below = [(0.05, -high * 0.8), (0.3, -high - up * 0.7), (0.55, -high * 0.55)]
    fin = turned(egg((0, 0.26, 0), (0.11, 0.36, 0.2)), 2, 38)
    at = (thick * 0.72, -long * 0.6, high * 0.24)
    body = egg((0, 0, 0), (thick, long, high))
    return {
        "body": body,
        "fins": join(
            prism(tail, 0, 0.085),
            prism(back, 0, 0.085),
            prism(below, 0, 0.085),
            both(moved(fin, (thick * 0.85, -0.2, -high * 0.25))),
        ),
        "eyes": both(ball((at[0] + 0.06, at[1] - 0.04, at[2]), 0.075)),
        "whites": both(ball(at, 0.13)),
        "lips": both(capsule((0, -long, -high * 0.18), (0.1, -long + 0.06, -high * 0.24), 0.085)),
    }


def octopus(draw: Draw) -> Parts:
    """A bulb of a head on eight arms with curled tips."""
    wide, high, reach = draw(0.5, 0.6), draw(0.55, 0.75), draw(0.95, 1.15)
    curl, z = draw(0.2, 0.32), 0.5
    arm = [
        *((0.2, z), (0.55, 0.34), (reach * 0.75, 0.16), (reach + 0.05, 0.17)),
        *((reach + 0.24, 0.3 + curl * 0.5), (reach + 0.1, 0.36 + curl), (reach - 0.1, 0.3 + curl)),
    ]
    cups = [
        ball((x, 0, h), 0.08)
        for x, h in ((reach + 0.06, 0.29), (reach + 0.09, 0.42 + curl * 0.5), (reach - 0.12, 0.26))
    ]
    dome = egg((0, 0.12, z + high * 0.95), (wide, wide * 1.05, high))
    x, y = wide * 0.5, -wide * 0.62
    return {
        "body": join(
            blend(0.15, dome, ball((0, 0, z + 0.02), 0.42)),
            around(8, limb([(x, 0, h) for x, h in smooth_curve(arm, 2)], 0.21, 0.09), 22.5),
        ),
        "suckers": around(8, join(*cups), 22.5),
        "eyes": both(ball((x, y, z + high * 0.62), 0.16)),
        "pupils": both(ball((x + 0.01, y - 0.11, z + high * 0.62), 0.09)),
    }


def crab(draw: Draw) -> Parts:
    """A broad shell, two great claws, eyes on stalks, six legs."""
    wide, z, big = draw(0.66, 0.78), 0.5, draw(1.1, 1.35)
    legs = []
    for y, back in ((-0.12, -0.08), (0.12, 0.15), (0.32, 0.4)):
        knee = (wide + 0.26, y + back, z + 0.14)
        legs.append(
            limb([(wide * 0.7, y, z - 0.05), knee, (wide + 0.45, y + back * 1.5, 0.08)], 0.12, 0.08)
        )
    x, y, h = wide + 0.12, -0.72, z + draw(0.2, 0.42)

    def claw(*stops: Vector) -> list[Vector]:
        return [(x + a * big, y + b * big, h + c * big) for a, b, c in stops]

    arm = limb([(wide * 0.7, -0.2, z), (wide + 0.2, -0.42, z + 0.02), (x, y, h)], 0.14, 0.15)
    outer = limb(claw((0.08, 0, 0.1), (0.24, -0.04, 0.34), (0.12, -0.1, 0.6)), 0.15 * big, 0.075)
    inner = limb(
        claw((-0.08, 0, 0.1), (-0.2, -0.04, 0.26), (-0.16, -0.08, 0.48)), 0.12 * big, 0.075
    )
    palm = egg((x, y, h + 0.06), (0.24 * big, 0.2 * big, 0.24 * big))
    return {
        "body": join(
            egg((0, 0, z), (wide, 0.52, 0.36)),
            both(taper((0.2, -0.32, z + 0.15), (0.23, -0.46, z + 0.5), 0.1, 0.09)),
        ),
        "claws": both(join(arm, palm, outer, inner)),
        "legs": both(join(*legs)),
        "belly": egg((0, -0.05, z - 0.12), (wide * 0.88, 0.48, 0.29)),
        "eyes": both(ball((0.23, -0.48, z + 0.56), 0.14)),
    }


def turtle(draw: Draw) -> Parts:
    """A shell, its head to the front."""
    wide, long, dome = draw(0.75, 0.85), draw(0.85, 0.95), draw(0.6, 0.72)
    shell = cut(egg((0, 0, 0.28), (wide, long, dome)), box((0, 0, -0.75), (2, 2, 1)))
    z, y = draw(0.5, 0.6), -long - draw(0.25, 0.35)
    leg = taper((wide * 0.55, long * 0.6, 0.3), (wide * 0.98, long * 0.85, 0.14), 0.19, 0.16)
    return {
        "shell": shell,
        "body": join(
            egg((0, 0, 0.27), (wide * 1.08, long * 1.06, 0.13)),
            both(leg, 0, 1),
            taper((0, -long * 0.8, 0.32), (0, y, z), 0.2, 0.27),
            taper((0, long, 0.26), (0, long + 0.3, 0.16), 0.12, 0.05),
        ),
        "eyes": both(ball((0.17, y - 0.2, z + 0.1), 0.08)),
    }


def bee(draw: Draw) -> Parts:
    """A plump striped body, small wings, a sting; in flight."""
    wide, long = draw(0.42, 0.52), draw(0.62, 0.75)
    z, head = 0.75, draw(0.3, 0.36)
    y = -long - head * 0.3

    def hoop(at: float) -> Solid:
        r = wide * math.sqrt(1 - at * at)
        return tube((0, at * long - 0.08, z), (0, at * long + 0.08, z), r + 0.05, 0.04)

    vane = [(0, -0.1), (0.3, -0.3), (0.7, -0.34), (0.95, -0.1), (0.75, 0.18),
            (0.35, 0.22), (0, 0.12)]  # fmt: skip
    wing = moved(
        turned(prism(smooth_curve(vane, 3), 2, 0.075), 1, -draw(25, 55)),
        (0.08, 0.0, z + wide * 0.85),
    )
    rear = smooth_curve([(0.7 * a, 0.7 * b) for a, b in vane], 2)
    small = moved(turned(prism(rear, 2, 0.075), 1, -20), (0.08, 0.3, z + wide * 0.8))
    feeler = limb(
        [
            (0.1, y - 0.1, z + head * 0.7),
            (0.18, y - 0.28, z + head + 0.2),
            (0.22, y - 0.46, z + head + 0.2),
        ],
        0.08,
        0.075,
    )
    leg = [
        taper((0.15, b, z - wide * 0.75), (0.28, b + 0.02, z - wide - 0.16), 0.08, 0.075)
        for b in (-0.3, -0.02, 0.26)
    ]
    return {
        "body": egg((0, 0, z), (wide, long, wide)),
        "stripes": join(
            hoop(-0.3),
            hoop(0.14),
            hoop(0.58),
            taper((0, long * 0.85, z), (0, long + 0.2, z - 0.02), 0.13, 0.04),
        ),
        "head": join(ball((0, y, z), head), both(join(feeler, *leg))),
        "wings": both(join(wing, small)),
        "eyes": both(egg((head * 0.55, y - head * 0.68, z + 0.08), (0.12, 0.1, 0.15))),
    }


def butterfly(draw: Draw) -> Parts:
    """Four wings with dark edges, raised a little, and two feelers."""
    span, lift, low = draw(1.0, 1.2), draw(15, 35), draw(0.65, 0.85)
    front = [(0.0, -0.1), (0.4, -0.62), (span * 0.8, -0.85), (span, -0.72),
             (span * 0.92, -0.3), (span * 0.7, 0.02), (0.0, 0.14)]  # fmt: skip
    hind = [(0.0, 0.0), (span * 0.68, 0.0), (span * low, 0.35), (span * 0.55, 0.76),
            (0.25, 0.66), (0.0, 0.3)]  # fmt: skip
    spots = [
        [(x * 0.8 + 0.09, y * 0.8 + move) for x, y in wing]
        for wing, move in ((front, -0.07), (hind, 0.07))
    ]

    def raised(half: float, wings: list[list[tuple[float, float]]]) -> Solid:
        flat = join(*(prism(smooth_curve(wing, 3), 2, half) for wing in wings))
        return both(moved(turned(flat, 1, -lift), (0.1, 0, 0)))

    feeler = capsule((0.06, -0.56, 0.1), (0.32, -0.98, 0.42), 0.075)
    trunk = join(egg((0, 0.12, 0), (0.17, 0.66, 0.17)), ball((0, -0.54, 0.04), 0.18))
    return {
        "wings": raised(0.1, spots),
        "edges": raised(0.075, [front, hind]),
        "body": join(trunk, both(feeler)),
        "eyes": both(ball((0.13, -0.6, 0.08), 0.08)),
    }


COMMON_WILD_ANIMALS_SEA_AND_AIR = {
    "bird": fitted(bird),
    "owl": fitted(owl),
    "penguin": fitted(penguin),
    "whale": fitted(whale),
    "dolphin": fitted(dolphin),
    "shark": fitted(shark),
    "fish": fish,
    "octopus": fitted(octopus),
    "crab": fitted(crab),
    "turtle": turtle,
    "bee": fitted(bee),
    "butterfly": fitted(butterfly),
}
