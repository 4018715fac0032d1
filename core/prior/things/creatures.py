"""Small creatures, and two that no one has seen."""

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
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.animals import fitted


def _lowered(solid: Solid, z: float, by: float = 0.76) -> Solid:
    """``solid`` made lower about the height ``z``; a lower bound of the distance."""
    return lambda p: (
        solid((p - p.new_tensor((0, 0, z))) / p.new_tensor((1, 1, by)) + p.new_tensor((0, 0, z)))
        * by
    )


def snake(draw: Draw) -> Parts:
    """Coiled in three rings, its neck raised in a bend, its forked tongue out."""
    thick, wide, up = draw(0.21, 0.23), draw(0.8, 0.88), draw(0.84, 0.96)
    rings = [ring((0, 0, thick * (1 + 1.5 * k)), wide - 0.2 * k, thick) for k in range(3)]
    z = thick * 4
    # The tail comes off the lowest ring and lies in a bend to the front.
    tail = [(wide * 0.5, wide * 0.86), (wide * 0.98, wide * 0.78), (wide + 0.36, wide * 0.3),
            (wide + 0.4, -wide * 0.2), (wide + 0.26, -wide * 0.6)]  # fmt: skip
    tip = limb([(x, y, thick - 0.04) for x, y in smooth_curve(tail)], thick, 0.1)
    neck = smooth_curve([(0.1, z - 0.1), (0.34, z + up * 0.34), (0.26, z + up * 0.68),
                         (0.04, z + up * 0.92), (-0.24, z + up)])  # fmt: skip
    top = z + up
    snout = chain([((0, -0.12, top + 0.02), thick), ((0, -0.3, top + 0.03), thick * 1.36),
                   ((0, -0.68, top - 0.04), thick * 0.84)])  # fmt: skip
    front = [(0, y - thick * 0.5, h - thick * 0.16) for y, h in neck[2:-2]]
    fork = capsule((0, -0.98, top - 0.1), (0.18, -1.2, top - 0.1), 0.09)
    return {
        "body": join(
            *rings,
            tube((0, 0, thick), (0, 0, z - thick), wide - 0.42),
            tip,
            limb([(0, y, h) for y, h in neck], thick * 1.1, thick * 0.95),
            _lowered(snout, top),
        ),
        "belly": limb(front, thick * 0.9, thick * 0.72),
        "eyes": both(ball((thick * 1.02, -0.46, top + thick * 0.62), 0.12)),
        "tongue": join(capsule((0, -0.7, top - 0.1), (0, -1.0, top - 0.1), 0.09), both(fork)),
    }


def frog(draw: Draw) -> Parts:
    """Squats: bulging eyes, a wide mouth, folded hind legs."""
    wide, high = draw(0.55, 0.65), draw(0.5, 0.62)
    z, y = high + 0.2, -0.42
    eye = (wide * 0.5, y - 0.12, z + 0.33)
    thigh = egg((wide * 0.8, 0.4, 0.32), (0.3, 0.46, 0.3))
    hind = join(
        thigh,
        taper((wide * 1.0, 0.6, 0.15), (wide * 1.15, 0.12, 0.12), 0.15, 0.12),
        egg((wide * 1.25, -0.02, 0.09), (0.22, 0.28, 0.1)),
    )
    fore = join(
        taper((wide * 0.68, -0.4, high * 0.75), (wide * 0.75, -0.6, 0.14), 0.17, 0.12),
        egg((wide * 0.8, -0.78, 0.09), (0.2, 0.24, 0.1)),
    )
    trunk = taper((0, 0.45, 0.36), (0, -0.2, high), 0.34, wide * 0.8)
    head = egg((0, y, z), (wide * 1.02, 0.48, 0.36))
    lips = cut(
        egg((0, y - 0.03, z - 0.03), (wide * 1.03, 0.49, 0.35)),
        box((0, 0, z + 0.96), (3, 3, 1.0)),
        box((0, 0, z - 1.14), (3, 3, 1.0)),
        box((0, 1, z), (3, 1.3, 3)),
    )
    return {
        "body": join(blend(0.15, trunk, head), both(join(hind, fore, ball(eye, 0.21)))),
        "belly": egg((0, -0.42, high * 0.78), (wide * 0.68, 0.4, high * 0.62)),
        "mouth": lips,
        "eyes": both(ball((eye[0] + 0.03, eye[1] - 0.1, eye[2] + 0.02), 0.165)),
        "pupils": both(egg((eye[0] + 0.05, eye[1] - 0.22, eye[2] + 0.03), (0.1, 0.08, 0.075))),
    }


def butterfly(draw: Draw) -> Parts:
    """Four wings with dark edges, raised a little, and two feelers; it leans forwards."""
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
        return both(moved(turned(flat, 1, -lift), (0.04, 0, 0)))

    feeler = limb([(0.08, -0.62, 0.06), (0.2, -0.85, 0.28), (0.34, -1.0, 0.42)], 0.08, 0.075)
    trunk = join(taper((0, -0.3, 0.03), (0, 0.7, -0.04), 0.17, 0.1), ball((0, -0.52, 0.04), 0.17))
    parts = {
        "wings": raised(0.1, spots),
        "edges": raised(0.075, [front, hind]),
        "body": join(trunk, both(feeler)),
        "eyes": both(ball((0.13, -0.6, 0.08), 0.08)),
    }
    lean = draw(8, 28)
    return {name: tilted(solid, lean, (0, 0, 0.6)) for name, solid in parts.items()}


def spider(draw: Draw) -> Parts:
    """A round abdomen, eight bent legs, several eyes."""
    rear, head, knee = draw(0.42, 0.55), draw(0.27, 0.33), draw(0.75, 1.0)
    z, out = draw(0.42, 0.52), draw(1.15, 1.3)
    y = -head - 0.14
    legs = []
    for angle in (-48, -17, 12, 40):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        steps = [(0.15, z), (out * 0.5, knee), (out * 0.85, knee * 0.6), (out * 1.05, 0.09)]
        legs.append(limb([(c * r, -0.26 + s * r, h) for r, h in steps], 0.11, 0.085))
    return {
        "body": join(
            egg((0, rear * 0.95 + 0.16, z + 0.18), (rear * 0.92, rear * 1.1, rear * 0.85)),
            egg((0, -0.22, z), (head, head * 1.25, head * 0.85)),
        ),
        "legs": both(join(*legs)),
        "eyes": both(
            join(ball((0.1, y - 0.18, z + 0.08), 0.09), ball((0.09, y - 0.05, z + 0.2), 0.075))
        ),
        "fangs": both(taper((0.1, y - 0.1, z - 0.08), (0.09, y - 0.22, z - 0.3), 0.1, 0.06)),
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


def snail(draw: Draw) -> Parts:
    """A shell that is a thick tube rolled up, on a soft body with a head and eyes on stalks."""
    size, up, tail = draw(0.88, 0.92), draw(0.9, 1.0), draw(1.7, 1.8)
    y, z, steps = 0.3, size + 0.5, 30
    coil = []
    for k in range(steps + 1):
        angle, far = math.radians(-115 + 24 * k), size * (1 - k / steps)
        at = (0.0, y + far * math.cos(angle), z + far * math.sin(angle))
        coil.append((at, 0.33 - 0.15 * k / steps))
    body = chain([((0, tail, 0.12), 0.1), ((0, 0.7, 0.3), 0.3), ((0, -0.8, 0.32), 0.32)])
    x, front = 0.34, -1.34
    return {
        "body": join(
            body,
            capsule((0, -0.8, 0.32), (0, -1.12, up), 0.32),
            both(capsule((0.15, -1.16, up), (x, front, up + 0.6), 0.11)),
        ),
        "shell": chain(coil),
        "eyes": both(ball((x, front, up + 0.66), 0.2)),
    }


def mouse(draw: Draw) -> Parts:
    """Large round ears, a pointed face, a long tail."""
    wide, long, ear = draw(0.4, 0.48), draw(0.52, 0.62), draw(0.29, 0.36)
    z, y = wide * 0.95, -long - 0.05
    face = taper((0, y + 0.1, z + 0.16), (0, y - 0.38, z - 0.02), 0.34, 0.12)
    x, top, turn = 0.28, z + 0.36 + ear * 0.6, draw.chance(0.5)
    # Trailing, or raised at its end.
    bend = [(long * 0.7, 0.2), (long + 0.3, 0.12), (long + 0.65, 0.13),
            (long + 0.85, 0.3), (long + 0.75, 0.6 if turn else 0.32)]  # fmt: skip
    tail = [(0, b, h) for b, h in smooth_curve(bend, 2)]
    fore = join(taper((wide * 0.5, -0.35, z * 0.6), (wide * 0.55, -0.5, 0.1), 0.14, 0.1))
    haunch = egg((wide * 0.72, 0.26, 0.33), (0.2, 0.32, 0.31))
    feet = [egg((wide * a, b, 0.08), (0.13, 0.2, 0.09)) for a, b in ((0.55, -0.58), (0.75, 0.08))]
    disc = tube((x, y + 0.2, top), (x, y + 0.36, top), ear, 0.06)
    trunk = blend(0.15, egg((0, 0, z), (wide, long, wide * 0.95)), face)
    return {
        "body": join(trunk, both(join(disc, haunch, fore))),
        "ears": both(tube((x, y + 0.15, top), (x, y + 0.3, top), ear * 0.7, 0.04)),
        "tail": limb(tail, 0.1, 0.075),
        "feet": both(join(*feet)),
        "eyes": both(ball((0.2, y - 0.08, z + 0.34), 0.09)),
        "nose": ball((0, y - 0.48, z - 0.02), 0.1),
    }


def ghost(draw: Draw) -> Parts:
    """A sheet that hovers, its hem in waves or drawn out to a tail."""
    wide, high = draw(0.48, 0.58), draw(1.2, 1.45)
    x, y, z = wide * 0.36, -wide * 0.88, high + 0.05
    arm = taper(
        (wide * 0.7, -0.1, high * 0.68),
        (wide + draw(0.2, 0.35), -0.3, high * draw(0.62, 0.85)),
        0.2,
        0.12,
    )
    if draw.chance(0.3):
        ends = [(0, 0, high), (0, 0.02, high * 0.5), (0.03, 0.12, 0.22),
                (0.1, 0.3, -0.04), (0.2, 0.55, -0.2)]  # fmt: skip
        hem = limb(ends, wide, 0.09)
    else:
        folds = around(8, egg((wide * 0.95, 0, 0.22), (0.24, 0.2, 0.27)))
        hem = blend(0.1, taper((0, 0, high), (0, 0, 0.55), wide, wide * 1.12), folds)
        hem = join(hem, tube((0, 0, 0.12), (0, 0, 0.7), wide * 1.05, 0.08))
    return {
        "body": blend(0.12, ball((0, 0, high), wide), hem, both(arm)),
        "eyes": both(egg((x, y, z), (0.12, 0.12, 0.17))),
        "mouth": egg((0, y - 0.02, z - 0.36), (0.12, 0.12, draw(0.1, 0.18))),
    }


def alien(draw: Draw) -> Parts:
    """Stands: a great head, slanted black eyes, a thin body; feelers or none."""
    head, leg = draw(0.42, 0.52), draw(0.5, 0.65)
    top, out = leg + draw(0.55, 0.7), draw(0.22, 0.4)
    z = top + head * 0.95
    skull = blend(
        0.2,
        egg((0, 0.06, z + 0.12), (head, head * 0.95, head * 0.85)),
        egg((0, -0.06, z - 0.2), (head * 0.58, head * 0.6, head * 0.62)),
    )
    arm = limb(
        [
            (0.22, 0, top - 0.16),
            (0.22 + out * 0.7, -0.02, top - 0.42),
            (0.25 + out, -0.12, leg - 0.02),
        ],
        0.11,
        0.085,
    )
    hand = ball((0.25 + out, -0.14, leg - 0.05), 0.14)
    eye = moved(
        turned(egg((0, 0, 0), (0.23, 0.1, 0.14)), 1, -draw(22, 38)),
        (head * 0.47, -head * 0.72, z + 0.02),
    )
    feeler = limb(
        [(head * 0.4, 0, z + head * 0.7), (head * 0.6, -0.02, z + head + 0.3)], 0.08, 0.075
    )
    tips = join(feeler, ball((head * 0.6, -0.02, z + head + 0.34), 0.12))
    skin = join(skull, taper((0, 0, top - 0.1), (0, 0, z - 0.3), 0.12, 0.12), both(hand))
    feet = egg((0.2, -0.1, 0.1), (0.15, 0.27, 0.11))
    return {
        "skin": join(skin, both(tips)) if draw.chance(0.5) else skin,
        "suit": join(
            taper((0, 0, leg), (0, 0, top - 0.14), 0.2, 0.25),
            both(arm),
            both(taper((0.15, 0, leg), (0.18, 0, 0.14), 0.14, 0.12)),
        ),
        "shoes": both(feet),
        "eyes": both(eye),
        "mouth": capsule((-0.07, -head * 0.58, z - 0.42), (0.07, -head * 0.58, z - 0.42), 0.07),
    }


CREATURES = {
    "snake": fitted(snake),
    "frog": fitted(frog),
    "butterfly": fitted(butterfly),
    "spider": fitted(spider),
    "bee": fitted(bee),
    "crab": fitted(crab),
    "snail": fitted(snail),
    "mouse": fitted(mouse),
    "ghost": fitted(ghost),
    "alien": fitted(alien),
}
