"""The best known wild animals on land."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
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
    ring,
    smooth_curve,
    taper,
    tube,
)
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import Beast


def wolf(draw: Draw) -> Parts:
    """Pointed ears, a bushy tail that hangs."""
    b = Beast(draw, 0.38, 0.8, 0.55, 0.34, (0.28, 0.4))
    return {
        "body": join(b.trunk(0.28), b.ears(0.2, 0.14, 0.04)),
        "muzzle": b.muzzle(0.2, 0.14),
        "eyes": b.eyes(),
        "nose": b.nose(0.3, 0.09),
        "tail": b.tail(0.3, draw(-0.5, -0.3), 0.13, 0.15),
    }


def fox(draw: Draw) -> Parts:
    """Large ears, a thick tail with a tip."""
    b = Beast(draw, 0.3, 0.66, 0.42, 0.33, (0.22, 0.36))
    y, z = b.long * 0.85, b.belly + 0.1
    up = draw(-0.05, 0.3)
    return {
        "body": join(
            b.trunk(0.2),
            b.ears(0.24, 0.16, 0.04),
            taper((0, y - 0.1, z), (0, y + 0.45, z + up), 0.11, 0.21),
        ),
        "tail tip": taper((0, y + 0.5, z + up), (0, y + 0.8, z + up * 1.4), 0.2, 0.07),
        "muzzle": b.muzzle(0.18, 0.11),
        "eyes": b.eyes(),
        "nose": b.nose(0.26, 0.085),
    }


def bear(draw: Draw) -> Parts:
    """Heavy, with round ears."""
    b = Beast(draw, 0.55, 0.85, 0.35, 0.4, (0.2, 0.25))
    ear = ball((b.head * 0.72, b.y, b.z + b.head * 0.75), 0.15)
    return {
        "body": join(b.trunk(0.38), both(ear), ball((0, b.long, b.belly + 0.1), 0.14)),
        "muzzle": b.muzzle(0.08, 0.18),
        "eyes": b.eyes(),
        "nose": b.nose(0.22, 0.11),
    }


def deer(draw: Draw) -> Parts:
    """Slender, with branched antlers and a white tail."""
    b = Beast(draw, 0.34, 0.68, 0.8, 0.24, (0.3, 0.66))
    h, y, z = b.head, b.y, b.z
    high = draw(0.6, 0.85)
    beam = [
        (0.14, y + 0.05, z + h * 0.7),
        (0.34, y + 0.2, z + h + high * 0.4),
        (0.4, y + 0.05, z + h + high),
    ]
    tines = [
        taper(
            (0.24, y + 0.14, z + h + high * 0.2), (0.3, y - 0.22, z + h + high * 0.38), 0.085, 0.07
        ),
        taper(
            (0.36, y + 0.16, z + h + high * 0.55),
            (0.66, y + 0.18, z + h + high * 0.85),
            0.085,
            0.07,
        ),
    ]
    ear = taper((h * 0.7, y + 0.06, z + h * 0.4), (h + 0.24, y + 0.1, z + h * 0.65), 0.11, 0.07)
    return {
        "body": join(b.trunk(0.17), both(ear)),
        "antlers": both(join(limb(beam, 0.1, 0.075), *tines)),
        "muzzle": b.muzzle(0.16, 0.13),
        "belly": join(
            egg((0, -0.08, b.belly - 0.08), (b.wide * 0.85, b.long * 0.88, b.wide * 0.85)),
            taper((0, b.long * 0.9, b.belly + 0.12), (0, b.long + 0.14, b.belly + 0.06), 0.13, 0.1),
        ),
        "hooves": b.feet(0.14),
        "eyes": both(ball((h * 0.66, y - h * 0.62, z + h * 0.36), 0.08)),
        "nose": b.nose(0.24, 0.09),
    }


def lion(draw: Draw) -> Parts:
    """A mane, a tail with a tuft."""
    b = Beast(draw, 0.4, 0.8, 0.45, 0.36, (0.25, 0.36))
    y, z, up = b.long * 0.85, b.belly + 0.12, draw(-0.2, 0.3)
    mane = egg((0, b.y + 0.2, b.z - 0.02), (0.6, 0.34, draw(0.58, 0.66)))
    return {
        "body": join(b.trunk(0.28), b.tail(0.5, up)),
        "mane": join(mane, ball((0, y + 0.52, z + up), 0.16)),
        "muzzle": b.muzzle(0.02, 0.18),
        "eyes": b.eyes(),
        "nose": b.nose(0.18, 0.1),
    }


def elephant(draw: Draw) -> Parts:
    """A trunk, big ears, tusks."""
    b = Beast(draw, 0.58, 0.82, 0.45, 0.42, (0.15, 0.3))
    y, z, h = b.y, b.z, b.head
    nose = (0, y - h - 0.22, z - 0.5)
    tusk = taper((0.2, y - h * 0.7, z - 0.2), (0.26, y - h - 0.35, z - 0.22), 0.1, 0.07)
    return {
        "body": join(
            b.trunk(0.36),
            taper((0, y - h * 0.6, z - 0.05), nose, 0.2, 0.14),
            taper(nose, (0, nose[1] - draw(0, 0.2), 0.2), 0.14, 0.11),
            b.tail(0.15, -0.4),
        ),
        "ears": both(egg((h + 0.22, y + 0.15, z), (0.4, 0.11, draw(0.42, 0.52)))),
        "tusks": both(tusk),
        "eyes": b.eyes(),
    }


def giraffe(draw: Draw) -> Parts:
    """A very long neck, two horns."""
    b = Beast(draw, 0.34, 0.58, 0.8, 0.22, (0.2, 1.3))
    return {
        "body": join(b.trunk(0.15), b.tail(0.12, -0.4)),
        "muzzle": b.muzzle(0.2, 0.14),
        "horns": b.ears(0.16, 0.09, 0.1),
        "eyes": both(ball((b.head * 0.75, b.y - 0.12, b.z + 0.08), 0.08)),
    }


def monkey(draw: Draw) -> Parts:
    """Sits; round ears at the sides, a curled tail."""
    wide, head = draw(0.36, 0.46), draw(0.36, 0.43)
    z = 0.75 + draw(0.42, 0.58)
    reach, r = draw(0.65, 0.85), draw(0.26, 0.34)
    arm = taper((wide * 0.7, -0.1, 0.95), (wide + 0.1, -reach, 0.3), 0.14, 0.12)
    leg = join(
        taper((wide * 0.6, 0, 0.25), (wide + 0.2, -0.5, 0.35), 0.2, 0.15),
        taper((wide + 0.2, -0.5, 0.35), (wide + 0.15, -0.75, 0.1), 0.14, 0.13),
    )
    tail = join(
        taper((0, 0.25, 0.2), (0, 0.75, 0.3), 0.12, 0.11),
        ring((0, 0.75, 0.3 + r), r, 0.1, 0),
    )
    trunk = taper((0, 0, 0.35), (0, -0.03, 0.85), wide, wide * 0.8)
    face = join(
        egg((0, -head * 0.68, z - 0.13), (head * 0.62, 0.24, 0.2)),
        both(egg((head * 0.32, -head * 0.68, z + 0.12), (0.19, 0.16, 0.18))),
        both(tube((head + 0.1, -0.12, z + 0.04), (head + 0.1, 0, z + 0.04), 0.12, 0.03)),
        egg((0, -wide * 0.55, 0.6), (wide * 0.62, wide * 0.5, 0.34)),
    )
    ear = tube((head + 0.1, -0.08, z + 0.04), (head + 0.1, 0.08, z + 0.04), 0.2, 0.05)
    return {
        "body": join(trunk, ball((0, 0, z), head), both(join(arm, leg, ear)), tail),
        "face": face,
        "eyes": both(ball((head * 0.32, -head * 1.02, z + 0.1), 0.075)),
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


COMMON_WILD_ANIMALS_LAND = {
    "wolf": fitted(wolf),
    "fox": fitted(fox),
    "bear": fitted(bear),
    "deer": fitted(deer),
    "lion": fitted(lion),
    "elephant": fitted(elephant),
    "giraffe": fitted(giraffe),
    "monkey": fitted(monkey),
    "frog": fitted(frog),
    "snake": fitted(snake),
    "snail": fitted(snail),
    "spider": fitted(spider),
}
