"""Wild cats, breeds of dogs, a panda, a raccoon and an otter."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    capsule,
    chain,
    egg,
    join,
    limb,
    moved,
    prism,
    ring,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import Beast, four_legs, sitting
from core.prior.things.shared.stripes import cuff, hoop, leg_stripes


def tiger(draw: Draw) -> Parts:
    """Stripes about the trunk, the legs and the tail, white cheeks, round ears."""
    b = Beast(draw, 0.42, 0.82, 0.42, 0.4, (0.2, 0.34))
    h, y, z = b.head, b.y, b.z
    rump, low, tip = b.long * 0.85, b.belly + 0.12, draw(0.3, 0.5)
    bend = (0, rump + 0.38, low - 0.02)
    tail = limb([(0, rump, low), bend, (0, rump + 0.62, low + tip)], 0.11, 0.11)
    rings = [cuff(bend, (0, rump + 0.62, low + tip), at, 0.065, 0.11) for at in (0.35, 0.9)]
    w, front, top = h * 0.3, y - h * 0.5, z + h * 0.8
    brow = capsule((-w, front, top), (w, front, top), 0.075)
    cheek = egg((h * 0.62, y - h * 0.42, z - h * 0.42), (0.2, 0.2, 0.19))
    ear = ball((h * 0.72, y + 0.05, z + h * 0.78), 0.15)
    return {
        "body": join(b.trunk(0.3), tail, both(ear)),
        "stripes": join(
            *(hoop(b, at, 0.065) for at in (-0.36, 0.0, 0.36, 0.72)),
            leg_stripes(b, b.belly * 0.42),
            *rings,
            brow,
        ),
        "muzzle": join(
            both(join(cheek, egg((0.12, y - h * 0.9, z - 0.14), (0.18, 0.17, 0.15)))),
            egg((0, -0.05, b.belly - 0.13), (b.wide * 0.78, b.long * 0.8, b.wide * 0.8)),
        ),
        "eyes": b.eyes(),
        "nose": egg((0, y - h * 0.9 - 0.16, z - 0.04), (0.11, 0.09, 0.08)),
    }


def _spot(wide: float, z: float, y: float, turn_deg: float) -> Solid:
    """A flat cap on a round trunk of radius ``wide`` along y, so far from its top."""
    turn, far = math.radians(turn_deg), wide - 0.12
    return ball((far * math.sin(turn), y, z + far * math.cos(turn)), 0.17)


def leopard(draw: Draw) -> Parts:
    """Large flat spots on a slender body; a big head with round ears, a long raised tail."""
    wide, long, leg = draw(0.32, 0.38), draw(0.62, 0.74), draw(0.5, 0.62)
    z, head = leg + wide * 0.7, draw(0.36, 0.42)
    y, up = -long - 0.3, z + draw(0.32, 0.42)
    rump, tip = (0, long + wide * 0.6, z + 0.1), (0, long + 0.86, z + draw(0.5, 0.7))
    bend = (0, long + 0.66, z)
    spots = [_spot(wide, z, at * long, turn) for at, turn in
             ((-0.8, 84), (-0.4, 30), (0, 84), (0.4, 30), (0.8, 84))]  # fmt: skip
    return {
        "body": join(
            capsule((0, -long, z), (0, long, z), wide),
            capsule((0, -long, z), (0, y, up), 0.26),
            ball((0, y, up), head),
            both(ball((head * 0.72, y, up + head * 0.76), 0.15)),
            both(capsule((wide * 0.6, long, z), (wide * 0.6, long, 0.15), 0.15), 0, 1),
            limb([rump, bend, tip], 0.12, 0.12),
        ),
        "spots": join(
            both(join(*spots, ball((head * 0.5, y, up + head * 0.76), 0.13))), ball(tip, 0.17)
        ),
        "muzzle": join(
            ball((0, y - head * 0.86, up - head * 0.3), 0.2),
            capsule((0, -long, z - 0.08), (0, long, z - 0.08), wide - 0.03),
        ),
        "eyes": both(ball((head * 0.44, y - head * 0.8, up + head * 0.24), 0.085)),
        "nose": ball((0, y - head * 0.86 - 0.18, up - head * 0.22), 0.085),
    }


def panda(draw: Draw) -> Parts:
    """Sits: black limbs and ears, black patches about the eyes."""
    wide, head = draw(0.54, 0.64), draw(0.48, 0.55)
    z = 1.0 + head * draw(0.8, 0.9)
    trunk, arms, legs = sitting(wide, z, head, draw(-0.02, 0.1))
    x, y = head * 0.46, -head * 0.84
    ear = ball((head * 0.86, 0, z + head * 0.8), draw(0.18, 0.22))
    yoke = egg((0, 0.02, 0.86), (wide * 0.96, wide * 0.88, 0.2))
    patch = moved(turned(egg((0, 0, 0), (0.15, 0.12, 0.2)), 1, 28), (x, y, z + 0.02))
    return {
        "body": trunk,
        "limbs": join(arms, legs, both(ear), yoke),
        "patches": both(patch),
        "eyes": both(ball((x * 0.92, y - 0.065, z + 0.05), 0.08)),
        "muzzle": egg((0, -head * 0.86, z - head * 0.36), (0.22, 0.16, 0.15)),
        "nose": egg((0, -head * 0.86 - 0.14, z - head * 0.28), (0.11, 0.08, 0.08)),
    }


def pug(draw: Draw) -> Parts:
    """Stout on short legs: a flat dark face under folds, dark ears that hang, a curled tail."""
    wide, long, leg = draw(0.46, 0.49), draw(0.62, 0.67), draw(0.5, 0.54)
    z, head = leg + 0.16, draw(0.49, 0.52)
    y, up = -long - 0.1, z + 0.56
    face = y - head * 0.86
    flap = prism([(head * 0.42, up + head * 0.9), (head * 1.0, up + head * 0.66),
                  (head * 1.22, up - 0.1), (head * 0.68, up + head * 0.34)],
                 1, 0.14, y - 0.1)  # fmt: skip
    back = long + 0.04
    curl = moved(ring((0, 0, 0), 0.2, 0.12, 0), (0, back - 0.06, z + wide * 0.72 + 0.06))
    folds = [capsule((-u, face + v, up + w), (u, face + v, up + w), 0.085)
             for u, v, w in ((0.14, 0.03, 0.22), (0.14, 0.2, 0.44))]  # fmt: skip
    a, b = wide * 0.6, long * 0.66
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, long + 0.06, wide * 0.94)),
                  egg((0, -long * 0.6, z + 0.06), (wide * 0.96, 0.4, wide)),
                  egg((0, y, up), (head * 1.04, head * 0.9, head * 0.92))),
            four_legs(a, b, z - 0.1, 0.17),
            both(egg((a, -b - 0.08, 0.12), (0.19, 0.24, 0.13))),
            curl,
        ),
        "mask": join(
            egg((0, face + 0.02, up - 0.16), (0.38, 0.24, 0.29)),
            both(egg((0.17, face - 0.02, up - 0.22), (0.21, 0.2, 0.19))),
        ),
        "ears": both(flap),
        "folds": join(*folds),
        "eyes": eyes(0.32, face + 0.08, up + 0.16, 0.14),
        "nose": egg((0, face - 0.2, up - 0.04), (0.13, 0.1, 0.1)),
    }  # fmt: skip


def poodle(draw: Draw) -> Parts:
    """Shorn but for great pompoms: on its head, its ears, chest, legs, hips and the tail's end."""
    wide, long, leg = draw(0.26, 0.28), draw(0.58, 0.62), draw(0.86, 0.92)
    z = leg + 0.18
    y, up, head = -long - 0.16, z + 0.84, draw(0.25, 0.27)
    a, b = wide * 0.8, long * 0.8
    tail = (0, long + 0.3, z + 0.66)
    return {
        "pompoms": join(
            ball((0, y + 0.08, up + 0.36), 0.4),
            both(ball((0.4, y + 0.1, up - 0.14), 0.25)),
            ball((0, -long * 0.62, z + 0.1), 0.5),
            both(ball((a * 0.9, long * 0.72, z + 0.1), 0.29)),
            both(ball((a, b, 0.36), 0.24), 0, 1),
            ball(tail, 0.27),
        ),
        "body": join(
            capsule((0, -long * 0.6, z), (0, long * 0.8, z), wide),
            taper((0, -long * 0.8, z + 0.2), (0, y, up), 0.2, 0.17),
            ball((0, y, up), head),
            four_legs(a, b, z - 0.06, 0.13),
            both(egg((a, b - 0.08, 0.1), (0.15, 0.2, 0.11)), 0),
            both(egg((a, -b - 0.08, 0.1), (0.15, 0.2, 0.11)), 0),
            taper((0, long * 0.9, z + 0.1), tail, 0.12, 0.1),
            taper((0, y - 0.1, up - 0.02), (0, y - 0.56, up - 0.1), 0.17, 0.12),
        ),
        "collar": tube((0, y + 0.06, up - 0.38), (0, y + 0.02, up - 0.24), 0.24, 0.03),
        "eyes": eyes(0.16, y - head * 0.84, up + 0.08, 0.09),
        "nose": ball((0, y - 0.66, up - 0.04), 0.11),
    }


def raccoon(draw: Draw) -> Parts:
    """A dark mask, a ringed bushy tail, pointed ears."""
    b = Beast(draw, 0.38, 0.6, 0.24, 0.38, (0.12, 0.36))
    h, y, z = b.head, b.y, b.z
    start = (0, b.long * 0.8, b.belly + 0.1)
    tip = (0, b.long + 0.7, b.belly + draw(0.4, 0.62))
    front, brow = y - h * 0.62, z + h * 0.16
    mask = moved(turned(egg((0, 0, 0), (h * 0.5, h * 0.46, 0.17)), 1, 18), (h * 0.42, front, brow))
    face = [
        taper((0, y - h * 0.5, z - 0.1), (0, y - h - 0.1, z - 0.14), 0.21, 0.14),
        both(egg((h * 0.62, y - h * 0.42, z - h * 0.36), (0.2, 0.19, 0.16))),
        both(egg((h * 0.46, y - h * 0.56, z + h * 0.62), (0.16, 0.12, 0.09))),
    ]
    ear = taper((h * 0.62, y + 0.05, z + h * 0.62), (h * 0.86, y + 0.04, z + h + 0.14), 0.17, 0.07)
    return {
        "body": join(b.trunk(0.26), taper(start, tip, 0.16, 0.2), both(ear)),
        "mask": both(mask),
        "muzzle": join(*face),
        "stripes": join(
            *(cuff(start, tip, at, 0.08, 0.165 + 0.04 * at) for at in (0.32, 0.66)),
            ball((0, tip[1] + 0.07, tip[2] + 0.03), 0.2),
            b.feet(0.14),
        ),
        "eyes": both(ball((h * 0.44, y - h * 0.98, brow + 0.02), 0.08)),
        "nose": ball((0, y - h - 0.24, z - 0.1), 0.1),
    }


def otter(draw: Draw) -> Parts:
    """Long and upright: a flat broad head with a pale face, a pale chest, a thick tail."""
    wide, head = draw(0.4, 0.43), draw(0.4, 0.43)
    z, y = draw(1.86, 1.94), -0.16
    face = y - head * 0.86
    tail = [((0, 0.2, 0.3), 0.3), ((0, 0.7, 0.2), 0.24), ((0, 1.2, 0.15), 0.18),
            ((0, 1.56, 0.12), 0.1)]  # fmt: skip
    return {
        "body": join(
            blend(0.16, taper((0, 0.06, 0.46), (0, -0.02, 1.3), wide, wide * 0.76),
                  egg((0, y, z), (head * 1.1, head * 0.94, head * 0.84))),
            both(taper((wide * 0.78, -0.06, 1.2), (0.2, -wide - 0.2, 0.98), 0.15, 0.13)),
            both(ball((head * 0.92, y + 0.1, z + head * 0.56), 0.14)),
            both(ball((wide * 0.74, -0.06, 0.3), 0.28)),
            chain(tail),
        ),
        "chest": join(
            taper((0, -0.1, 0.52), (0, -0.14, 1.36), wide * 0.84, wide * 0.62),
            egg((0, y - 0.1, z - 0.16), (head * 1.0, head * 0.88, head * 0.62)),
            both(egg((0.15, face - 0.04, z - 0.12), (0.2, 0.17, 0.16))),
        ),
        "feet": join(
            both(egg((wide * 0.8, -0.42, 0.1), (0.22, 0.36, 0.11))),
            both(ball((0.17, -wide - 0.24, 0.98), 0.15)),
        ),
        "eyes": eyes(head * 0.56, face + 0.08, z + 0.14, 0.095),
        "nose": egg((0, face - 0.14, z + 0.02), (0.15, 0.11, 0.11)),
    }  # fmt: skip


MAMMALS_CATS_DOGS_AND_BEARS = {
    "tiger": fitted(tiger),
    "leopard": fitted(leopard),
    "panda": fitted(panda),
    "pug": pug,
    "poodle": fitted(poodle),
    "raccoon": fitted(raccoon),
    "otter": fitted(otter),
}
