"""Wild and woolly mammals on four legs."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    blend,
    both,
    capsule,
    chain,
    egg,
    join,
    lathe,
    limb,
    moved,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.animals import Beast, fitted

BAND = 0.035  # how far a stripe stands out


def _hoop(b: Beast, at: float, half: float) -> Solid:
    """A stripe about the trunk at the share ``at`` of its length."""
    y = at * b.long
    profile = []
    for end in (y - half, y, y + half):
        # The trunk is as high as 0.95 of its width: the stripe goes about the wider circle.
        r = b.wide * math.sqrt(max(1 - (end / b.long) ** 2, 0.04))
        # Turned about x, what was up is to the front.
        profile.append((r + BAND, -end))
    return moved(turned(lathe(profile[::-1]), 0, 90), (0, 0, b.belly))


def _cuff(start: Vector, end: Vector, at: float, half: float, radius: float) -> Solid:
    """A stripe about a round bar at the share ``at`` of its length."""
    length = math.dist(start, end)
    ends = (at - half / length, at + half / length)
    low, high = (
        tuple(s + (e - s) * share for s, e in zip(start, end, strict=True)) for share in ends
    )
    return tube((low[0], low[1], low[2]), (high[0], high[1], high[2]), radius + BAND)


def _leg_stripes(b: Beast, *heights: float) -> Solid:
    """Stripes about each leg."""
    a, c, r = b.wide * 0.55, b.long * 0.66, b.foot * 1.08 + BAND
    bands = (tube((a, c, z - 0.065), (a, c, z + 0.065), r) for z in heights)
    return both(join(*bands), 0, 1)


def tiger(draw: Draw) -> Parts:
    """Stripes about the trunk, the legs and the tail, white cheeks, round ears."""
    b = Beast(draw, 0.42, 0.82, 0.42, 0.4, (0.2, 0.34))
    h, y, z = b.head, b.y, b.z
    rump, low, tip = b.long * 0.85, b.belly + 0.12, draw(0.3, 0.5)
    bend = (0, rump + 0.38, low - 0.02)
    tail = limb([(0, rump, low), bend, (0, rump + 0.62, low + tip)], 0.11, 0.11)
    rings = [_cuff(bend, (0, rump + 0.62, low + tip), at, 0.065, 0.11) for at in (0.35, 0.9)]
    w, front, top = h * 0.3, y - h * 0.5, z + h * 0.8
    brow = capsule((-w, front, top), (w, front, top), 0.075)
    cheek = egg((h * 0.62, y - h * 0.42, z - h * 0.42), (0.2, 0.2, 0.19))
    ear = ball((h * 0.72, y + 0.05, z + h * 0.78), 0.15)
    return {
        "body": join(b.trunk(0.3), tail, both(ear)),
        "stripes": join(
            *(_hoop(b, at, 0.065) for at in (-0.36, 0.0, 0.36, 0.72)),
            _leg_stripes(b, b.belly * 0.42),
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


def zebra(draw: Draw) -> Parts:
    """A sturdy horse in stripes, its mane upright."""
    b = Beast(draw, 0.4, 0.76, 0.62, 0.24, (0.28, 0.64))
    y, z = b.y, b.z
    neck = ((0.0, -b.long * 0.6, b.belly), (0.0, y, z))
    snout = (0.0, y - 0.46, z - 0.3)
    crest = taper((0, -b.long * 0.36, b.belly + 0.46), (0, y + 0.12, z + 0.3), 0.12, 0.13)
    back, up, out = b.long * 0.94, b.belly + 0.1, draw(0.18, 0.3)
    tail = taper((0, back, up), (0, back + out, up - 0.4), 0.1, 0.09)
    tuft = taper((0, back + out, up - 0.4), (0, back + out + 0.04, up - 0.66), 0.13, 0.08)
    return {
        "body": join(b.trunk(0.2), taper((0, y, z), snout, 0.22, 0.16), b.ears(0.18, 0.1, 0.06),
                     tail),
        "stripes": join(
            *(_hoop(b, at, 0.07) for at in (-0.38, -0.02, 0.34, 0.7)),
            *(_cuff(*neck, at, 0.07, r) for at, r in ((0.5, 0.225), (0.82, 0.205))),
            _leg_stripes(b, b.belly * 0.38, b.belly * 0.62),
            _cuff((0, y, z), snout, 0.42, 0.06, 0.195),
        ),
        "mane": join(crest, tuft),
        "muzzle": taper((0, y - 0.38, z - 0.25), (0, y - 0.52, z - 0.34), 0.175, 0.17),
        "hooves": b.feet(0.15),
        "eyes": both(ball((0.2, y - 0.08, z + 0.08), 0.08)),
    }  # fmt: skip


def _sitting(wide: float, z: float, head: float, arm: float) -> tuple[Solid, Solid, Solid]:
    """Trunk with head, arms, and legs of a plump beast that sits."""
    trunk = join(
        egg((0, 0, 0.58), (wide, wide * 0.92, 0.6)), egg((0, 0, z), (head * 1.1, head, head))
    )
    reach = taper((wide * 0.78, -0.1, 0.88), (wide * 0.86, -wide - arm, 0.5), 0.19, 0.17)
    leg = join(
        taper((wide * 0.6, -0.1, 0.24), (wide * 0.88, -wide - 0.2, 0.2), 0.24, 0.2),
        egg((wide * 0.9, -wide - 0.28, 0.28), (0.21, 0.16, 0.27)),
    )
    return trunk, both(reach), both(leg)


def panda(draw: Draw) -> Parts:
    """Sits: black limbs and ears, black patches about the eyes."""
    wide, head = draw(0.54, 0.64), draw(0.48, 0.55)
    z = 1.0 + head * draw(0.8, 0.9)
    trunk, arms, legs = _sitting(wide, z, head, draw(-0.02, 0.1))
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


def koala(draw: Draw) -> Parts:
    """Sits: great round ears, a long black nose, a pale front."""
    wide, head = draw(0.46, 0.54), draw(0.48, 0.55)
    z = 0.98 + head * draw(0.76, 0.86)
    trunk, arms, legs = _sitting(wide, z, head, draw(-0.02, 0.1))
    r, x, up = draw(0.29, 0.35), head * 1.18, z + head * 0.5
    y = -head * 0.86
    return {
        "body": join(trunk, arms, legs, both(egg((x, 0.02, up), (r, 0.16, r)))),
        "ears": both(egg((x + 0.02, -0.1, up - 0.02), (r * 0.68, 0.12, r * 0.68))),
        "belly": join(
            egg((0, -wide * 0.36, 0.56), (wide * 0.72, wide * 0.68, 0.5)),
            egg((0, y + 0.04, z - head * 0.46), (0.24, 0.16, 0.14)),
        ),
        "eyes": both(ball((head * 0.48, y + 0.02, z + 0.08), 0.085)),
        "nose": egg((0, y - 0.12, z - 0.08), (0.13, 0.11, draw(0.19, 0.23))),
    }


def goat(draw: Draw) -> Parts:
    """Horns that sweep back, a beard, hooves."""
    b = Beast(draw, 0.38, 0.64, 0.5, 0.25, (0.24, 0.52))
    h, y, z = b.head, b.y, b.z
    sweep = draw(0.9, 1.2)
    bow = smooth_curve([(0, 0), (0.08, 0.34), (0.32, 0.52), (0.6, 0.4)], 3)
    horn = [
        (0.12 + 0.02 * k, y + back * sweep, z + 0.16 + up * sweep)
        for k, (back, up) in enumerate(bow)
    ]
    snout = (0, y - 0.4, z - 0.2)
    ear = taper((h * 0.7, y + 0.02, z + 0.04), (h + 0.26, y + 0.06, z - 0.08), 0.1, 0.08)
    back, up = b.long * 0.9, b.belly + 0.16
    tail = taper((0, back, up), (0, back + 0.18, up + 0.24), 0.12, 0.08)
    return {
        "body": join(b.trunk(0.19), taper((0, y, z), snout, 0.24, 0.15), both(ear), tail),
        "horns": both(limb(horn, 0.12, 0.075)),
        "beard": taper((0, y - 0.3, z - 0.32), (0, y - 0.28, z - draw(0.6, 0.72)), 0.13, 0.06),
        "hooves": b.feet(0.16),
        "eyes": both(ball((0.2, y - 0.12, z + 0.08), 0.08)),
        "nose": egg((0, y - 0.53, z - 0.19), (0.1, 0.08, 0.08)),
    }


def camel(draw: Draw) -> Parts:
    """Two humps, a neck that dips and rises, long legs."""
    b = Beast(draw, 0.4, 0.74, 0.72, 0.24, (0.5, 0.62))
    y, z, top = b.y, b.z, b.belly + b.wide * 0.7
    neck = [(0, -b.long * 0.7, b.belly + 0.02), (0, y + 0.24, b.belly - 0.02),
            (0, y + 0.04, b.belly + 0.3), (0, y, z)]  # fmt: skip
    ear = taper((0.15, y + 0.1, z + 0.15), (0.22, y + 0.16, z + 0.3), 0.09, 0.07)
    up, apart = draw(0.36, 0.48), b.long * draw(0.44, 0.5)
    humps = [taper((0, s * apart, top), (0, s * apart, top + up), 0.29, 0.13) for s in (-1, 1)]
    a, c = b.wide * 0.55, b.long * 0.66
    knee = both(ball((a, c, b.belly * 0.45), b.foot * 1.3), 0, 1)
    return {
        "body": join(
            egg((0, 0, b.belly), (b.wide, b.long * 1.02, b.wide * 0.95)),
            both(taper((a, c, b.belly - 0.1), (a, c, b.foot), b.foot * 1.15, b.foot), 0, 1),
            limb(neck, 0.24, 0.17),
            taper((0, y, z), (0, y - 0.4, z - 0.1), 0.22, 0.15),
            both(ear),
            knee,
            b.tail(0.12, -0.5, 0.09, 0.1),
        ),
        "humps": join(*humps, ball((0, y + 0.06, z + 0.17), 0.15)),
        "muzzle": egg((0, y - 0.46, z - 0.12), (0.17, 0.17, 0.15)),
        "hooves": b.feet(0.15),
        "eyes": both(ball((0.19, y - 0.1, z + 0.08), 0.08)),
    }


def bulk(draw: Draw, wide: float, long: float, leg: float) -> tuple[float, float, float, Solid]:
    """Half the width and the length of a heavy beast, its middle's height, trunk and legs."""
    wide, long = wide * draw(0.92, 1.08), long * draw(0.92, 1.08)
    z = leg * draw(0.9, 1.1) + wide * 0.9
    a, c, r = wide * 0.56, long * 0.6, wide * 0.34
    legs = both(tube((a, c, 0), (a, c, z), r, 0.03), 0, 1)
    return wide, long, z, join(egg((0, 0, z), (wide, long, wide * 0.95)), legs)


def nails(wide: float, long: float) -> Solid:
    """Three toes at the front of each foot."""
    a, c, r = wide * 0.56, long * 0.6, wide * 0.34
    toes = [
        ball((a + r * out, s * c - r * 0.86, 0.07), 0.1) for s in (-1, 1) for out in (-0.5, 0.5)
    ]
    return both(join(*toes))


def rhino(draw: Draw) -> Parts:
    """A great horn on the nose and a small one behind it; a low head."""
    wide, long, z, trunk = bulk(draw, 0.56, 0.86, 0.36)
    y, h = -long - 0.24, z + draw(0.0, 0.1)
    snout = (0, y - 0.5, h - 0.2)
    neck = taper((0, -long * 0.6, z + 0.05), (0, y, h), 0.46, 0.32)
    ear = taper((0.22, y + 0.1, h + 0.24), (0.3, y + 0.08, h + 0.48), 0.12, 0.08)
    tall = draw(0.5, 0.66)
    horns = [
        taper((0, y - 0.54, h - 0.06), (0, y - 0.72, h + tall), 0.18, 0.06),
        taper((0, y - 0.22, h + 0.14), (0, y - 0.26, h + 0.14 + tall * 0.56), 0.15, 0.06),
    ]
    tail = taper((0, long * 0.92, z + 0.2), (0, long + 0.14, z - 0.25), 0.1, 0.1)
    fold = [_fold(wide, long, z, at) for at in (-0.42, 0.42)]
    return {
        "body": join(trunk, neck, taper((0, y, h), snout, 0.33, 0.24), both(ear), tail),
        "horns": join(*horns),
        "plates": join(*fold),
        "hooves": nails(wide, long),
        "eyes": both(ball((0.28, y - 0.18, h + 0.1), 0.085)),
    }


def _fold(wide: float, long: float, z: float, at: float) -> Solid:
    """A fold of skin about the trunk at the share ``at`` of its length."""
    r = wide * math.sqrt(1 - at * at) + BAND
    return tube((0, at * long - 0.07, z), (0, at * long + 0.07, z), r, 0.02)


def hippo(draw: Draw) -> Parts:
    """A barrel on short legs; a vast muzzle with nostrils and two teeth, tiny ears."""
    wide, long, z, trunk = bulk(draw, 0.62, 0.84, 0.22)
    y, h, jaw = -long - 0.12, z + draw(0.08, 0.18), draw(0.42, 0.48)
    neck = taper((0, -long * 0.5, z), (0, y, h), 0.52, 0.4)
    front = y - 0.5
    ear = ball((0.3, y + 0.1, h + 0.4), 0.13)
    brow = ball((0.24, y - 0.14, h + 0.32), 0.15)
    tooth = tube(
        (jaw * 0.55, front - 0.24, h - 0.4), (jaw * 0.55, front - 0.24, h - 0.16), 0.09, 0.02
    )
    tail = taper((0, long * 0.94, z + 0.2), (0, long + 0.1, z - 0.1), 0.1, 0.08)
    lips = [
        egg((0, front, h - 0.12), (jaw, 0.36, 0.29)),
        egg((0, front + 0.06, h - 0.36), (jaw * 0.86, 0.34, 0.16)),
    ]
    return {
        "body": join(trunk, neck, both(join(ear, brow)), tail),
        "muzzle": join(*lips),
        "nostrils": both(ball((jaw * 0.4, front - 0.2, h + 0.12), 0.085)),
        "teeth": both(tooth),
        "hooves": nails(wide, long),
        "eyes": both(ball((0.27, y - 0.26, h + 0.35), 0.085)),
    }


def kangaroo(draw: Draw) -> Parts:
    """Upright on long feet and a thick tail; tall ears, short arms, a young one in the pouch."""
    wide, head, ear = draw(0.36, 0.43), draw(0.28, 0.32), draw(0.26, 0.36)
    hip, y, z = 0.62, -0.36, draw(1.68, 1.85)
    thigh = egg((wide * 0.9, 0.12, hip - 0.04), (0.22, 0.44, 0.42))
    foot = taper((wide * 0.95, 0.22, 0.13), (wide * 0.95, -0.62, 0.1), 0.16, 0.13)
    arm = limb([(0.26, -0.2, 1.22), (0.36, -0.42, 0.98), (0.3, -0.66, 1.06)], 0.13, 0.1)
    tail = limb([(0, 0.25, hip - 0.05), (0, 0.8, 0.3), (0, 1.4, draw(0.15, 0.22))], 0.34, 0.12)
    trunk = limb([(0, 0.12, hip), (0, -0.04, 1.05), (0, -0.2, 1.4), (0, y, z)], wide * 1.02, 0.2)
    face = taper((0, y, z), (0, y - 0.36, z - 0.12), head, 0.15)
    flap = taper(
        (head * 0.5, y + 0.08, z + head * 0.6), (head * 0.95, y + 0.12, z + head + ear), 0.15, 0.09
    )
    baby = (0, -wide - 0.06, hip + draw(0.42, 0.5))
    young = join(
        ball(baby, 0.18),
        both(taper((0.08, baby[1], baby[2] + 0.12), (0.14, baby[1], baby[2] + 0.3), 0.08, 0.075)),
    )
    return {
        "body": join(blend(0.15, trunk, tail), face, both(join(thigh, foot, arm, flap)), young),
        "belly": egg((0, -0.24, hip + 0.1), (wide * 0.78, wide * 0.88, 0.4)),
        "eyes": both(
            join(
                ball((head * 0.78, y - 0.12, z + 0.1), 0.085),
                ball((0.09, baby[1] - 0.14, baby[2] + 0.05), 0.07),
            )
        ),
        "nose": ball((0, y - 0.5, z - 0.1), 0.1),
    }


def squirrel(draw: Draw) -> Parts:
    """Sits up with a nut, its bushy tail raised behind it."""
    wide, head = draw(0.36, 0.43), draw(0.34, 0.39)
    y, z, big = -0.14, draw(1.14, 1.26), draw(0.92, 1.1)
    tail = [((0, 0.3, 0.24), 0.16), ((0, 0.66, 0.44), 0.25 * big), ((0, 0.74, 0.86), 0.31 * big),
            ((0, 0.62, 1.34), 0.33 * big), ((0, 0.78, 1.66), 0.29 * big),
            ((0, 1.08, 1.66), 0.2 * big)]  # fmt: skip
    haunch = egg((wide * 0.8, 0.02, 0.34), (0.21, 0.36, 0.33))
    foot = taper((wide * 0.75, -0.1, 0.1), (wide * 0.8, -0.46, 0.1), 0.11, 0.1)
    arm = taper((wide * 0.72, -0.18, 0.78), (0.17, -wide - 0.2, 0.68), 0.12, 0.1)
    ear = taper(
        (head * 0.6, y + 0.06, z + head * 0.6), (head * 0.72, y + 0.08, z + head + 0.2), 0.13, 0.06
    )
    trunk = taper((0, 0.06, 0.4), (0, -0.06, 0.86), wide, wide * 0.78)
    face = taper((0, y, z), (0, y - head * 0.8, z - 0.1), head, 0.18)
    nut = (0, -wide - 0.3, 0.68)
    return {
        "body": join(blend(0.12, trunk, face), both(join(haunch, foot, arm, ear))),
        "tail": chain(tail),
        "belly": join(
            egg((0, -0.14, 0.56), (wide * 0.68, wide * 0.9, 0.36)),
            both(egg((0.1, y - head * 0.78, z - 0.17), (0.15, 0.16, 0.12))),
        ),
        "nut": join(
            egg(nut, (0.17, 0.16, 0.2)), tube((0, nut[1], 0.76), (0, nut[1], 0.9), 0.18, 0.05)
        ),
        "eyes": both(ball((head * 0.66, y - head * 0.6, z + 0.1), 0.09)),
        "nose": ball((0, y - head * 0.8 - 0.2, z - 0.08), 0.085),
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
            *(_cuff(start, tip, at, 0.08, 0.165 + 0.04 * at) for at in (0.32, 0.66)),
            ball((0, tip[1] + 0.07, tip[2] + 0.03), 0.2),
            b.feet(0.14),
        ),
        "eyes": both(ball((h * 0.44, y - h * 0.98, brow + 0.02), 0.08)),
        "nose": ball((0, y - h - 0.24, z - 0.1), 0.1),
    }


WILD_ANIMALS = {
    "tiger": fitted(tiger),
    "panda": fitted(panda),
    "zebra": fitted(zebra),
    "goat": fitted(goat),
    "camel": fitted(camel),
    "rhino": fitted(rhino),
    "hippo": fitted(hippo),
    "kangaroo": fitted(kangaroo),
    "koala": fitted(koala),
    "squirrel": fitted(squirrel),
    "raccoon": fitted(raccoon),
}
