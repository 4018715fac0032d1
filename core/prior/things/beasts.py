"""More beasts, and figures that stand on two legs."""

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
    cut,
    egg,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.animals import Beast, fitted


def _steed(draw: Draw) -> tuple[Beast, Parts]:
    """A horse's body, mane and hooves."""
    b = Beast(draw, 0.36, 0.78, 0.75, 0.23, (0.3, 0.72))
    y, z = b.y, b.z
    crest = taper((0, -b.long * 0.45, b.belly + 0.3), (0, y + 0.18, z + 0.12), 0.13, 0.13)
    lock = taper((0, y + 0.18, z + 0.12), (0, y - 0.08, z + 0.26), 0.13, 0.09)
    back, up, out = b.long * 0.92, b.belly + 0.12, draw(0.25, 0.45)
    tail = join(
        taper((0, back, up), (0, back + out, up - 0.1), 0.11, 0.14),
        taper((0, back + out, up - 0.1), (0, back + out + 0.05, up - draw(0.6, 0.8)), 0.15, 0.08),
    )
    face = taper((0, y, z), (0, y - 0.48, z - 0.3), 0.21, 0.15)
    parts = {
        "body": join(b.trunk(0.19), face, b.ears(0.16, 0.1, 0.05)),
        "mane": join(crest, lock, tail),
        "hooves": b.feet(0.16),
        "eyes": both(ball((0.19, y - 0.12, z + 0.04), 0.08)),
    }
    return b, parts


def horse(draw: Draw) -> Parts:
    """A long face, a mane, a tail, hooves."""
    return _steed(draw)[1]


def unicorn(draw: Draw) -> Parts:
    """A horse with a horn."""
    b, parts = _steed(draw)
    start = (0, b.y - 0.1, b.z + 0.15)
    horn = taper(start, (0, b.y - 0.4, b.z + draw(0.7, 0.95)), 0.11, 0.04)
    return parts | {"horn": horn}


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


def corgi(draw: Draw) -> Parts:
    """Short legs, large ears, a white chest, white paws and a blaze."""
    b = Beast(draw, 0.38, 0.78, 0.2, 0.38, (0.1, 0.42))
    h, y, z = b.head, b.y, b.z
    ear = taper((h * 0.5, y + 0.04, z + h * 0.6), (h * 0.84, y + 0.04, z + h + 0.36), 0.25, 0.1)
    chest = egg((0, -b.long * 0.86, b.belly + 0.06), (b.wide * 0.66, 0.3, b.wide * 0.74))
    blaze = egg((0, y - h * 0.6, z + h * 0.3), (0.12, h * 0.44, h * 0.62))
    return {
        "body": join(b.trunk(0.3), both(ear), ball((0, b.long, b.belly + 0.15), 0.16)),
        "chest": join(chest, b.feet(0.14)),
        "muzzle": join(b.muzzle(0.12, 0.15), blaze),
        "eyes": b.eyes(),
        "nose": b.nose(0.24, 0.09),
    }


def dragon(draw: Draw) -> Parts:
    """Bat's wings, horns, spikes along its back, a tail with a tip."""
    b = Beast(draw, 0.44, 0.66, 0.42, 0.34, (0.1, 0.86))
    y, z, h, long = b.y, b.z, b.head, b.long
    back, span = b.belly + b.wide * 0.8, draw(1.45, 1.6)
    end, tip = (0, long + 0.4, 0.26), draw(0.36, 0.5)
    tail = join(
        taper((0, long * 0.6, b.belly), end, 0.32, 0.18),
        taper(end, (0, long + 0.76, tip), 0.18, 0.13),
    )
    wing = [(0, 0), (0.4, 0.95), (span * 0.68, 0.98), (span, 0.36), (span * 0.76, 0.4),
            (span * 0.66, -0.06), (span * 0.46, 0.14), (0.42, -0.34), (0.1, -0.24)]  # fmt: skip
    spikes = [
        prism([(t - 0.2, back - 0.1), (t + 0.24, back - 0.1), (t + 0.14, back + 0.28)], 0, 0.13)
        for t in (-long * 0.28, long * 0.18, long * 0.64)
    ]
    point = [(long + 0.9, tip - 0.24), (long + 1.1, tip + 0.34), (long + 0.54, tip + 0.26)]
    horn = taper((h * 0.42, y, z + h * 0.6), (h * 0.95, y + 0.4, z + h + 0.3), 0.17, 0.05)
    throat = taper((0, -long * 0.85, b.belly - 0.1), (0, y - 0.1, z - 0.24), 0.28, 0.17)
    return {
        "body": join(b.trunk(0.24), tail, b.muzzle(0.3, 0.22)),
        "belly": join(egg((0, -0.12, b.belly - 0.08), (b.wide * 0.8, long * 0.95, 0.42)), throat),
        "wings": both(moved(turned(prism(wing, 1, 0.13), 2, draw(24, 32)), (0.16, -0.1, back))),
        "horns": join(both(horn), *spikes, prism(point, 0, 0.13)),
        "eyes": both(ball((h * 0.55, y - h * 0.72, z + h * 0.36), 0.14)),
        "pupils": both(ball((h * 0.6, y - h * 0.72 - 0.09, z + h * 0.38), 0.085)),
    }


def dinosaur(draw: Draw) -> Parts:
    """T. rex: a huge head, tiny arms, a heavy tail."""
    hip, wide, head = draw(0.75, 0.95), draw(0.36, 0.46), draw(0.3, 0.38)
    y, z = draw(-0.75, -0.6), hip + draw(0.75, 0.9)
    leg = join(
        egg((wide * 0.8, 0.15, hip - 0.1), (0.22, 0.34, 0.38)),
        taper((wide * 0.85, 0.2, hip - 0.3), (wide * 0.85, 0.1, 0.14), 0.16, 0.14),
        box((wide * 0.85, -0.06, 0.1), (0.18, 0.3, 0.1), 0.06),
    )
    arm = join(
        taper((wide * 0.8, -0.5, hip + 0.15), (wide, -0.75, hip), 0.11, 0.09),
        taper((wide, -0.75, hip), (wide, -0.9, hip + 0.1), 0.09, 0.08),
    )
    tail = join(
        taper((0, 0.3, hip + 0.05), (0, 1.0, hip - 0.2), 0.36, 0.2),
        taper((0, 1.0, hip - 0.2), (0, 1.7, hip + draw(-0.3, 0.15)), 0.2, 0.08),
    )
    trunk = taper((0, 0.15, hip), (0, -0.45, hip + 0.25), wide, wide * 0.8)
    neck = taper((0, -0.4, hip + 0.25), (0, y + 0.1, z), wide * 0.75, head * 0.8)
    skull = box((0, y - 0.25, z + 0.08), (head * 0.85, 0.5, head * 0.7), 0.12)
    jaw = box((0, y - 0.18, z - 0.32), (head * 0.7, 0.42, 0.12), 0.06)
    teeth = box((0, y - 0.25, z - 0.16), (head * 0.72, 0.43, 0.1), 0.03)
    return {
        "body": join(blend(0.15, trunk, neck, tail), skull, jaw, both(leg), both(arm)),
        "belly": taper((0, 0.0, hip - 0.1), (0, -0.58, hip + 0.16), wide * 0.85, wide * 0.62),
        "teeth": teeth,
        "eyes": both(ball((head * 0.78, y - 0.2, z + 0.24), 0.1)),
    }


def _arms(x: float, z: float, down: float, out: float, thick: float, raised: bool) -> Solid:
    """A pair of arms; the right one raised if so."""
    low = both(taper((x, 0, z), (x + out, -0.05, z - down), thick, thick * 0.9))
    if not raised:
        return low
    high = taper((x, 0, z), (x + out + 0.15, -0.05, z + down * 0.7), thick, thick * 0.9)
    half = box((2, 0, z), (2, 4, 8))
    return join(cut(low, half), high)


def person(draw: Draw) -> Parts:
    """Stands, in shirt and trousers; short or long hair."""
    leg, wide, head = draw(0.88, 1.08), draw(0.28, 0.34), draw(0.28, 0.31)
    top, raised, x = leg + draw(0.74, 0.84), draw.chance(0.3), wide + 0.04
    out, down, z = draw(0.1, 0.24), 0.66, top + head * 1.1 + 0.05
    a, front = max(wide * 0.56, 0.17), -head * 0.92  # or the shoes would be one slab
    trunk = taper((0, 0, leg), (0, 0, top - 0.2), wide * 0.8, wide * 0.92)
    hem = box((0, 0, leg - 0.92), (2, 2, 1))
    hips = within(taper((0, 0, leg), (0, 0, top), wide * 0.81, wide * 0.85), hem)
    hand = egg((x + out, -0.06, top - 0.2 - down), (0.1, 0.12, 0.15))
    hands = both(hand)
    if raised:
        half = box((2, 0, top), (2, 4, 8))
        hands = join(
            cut(hands, half), egg((x + out + 0.15, -0.05, top - 0.1 + down * 0.7), (0.1, 0.1, 0.15))
        )
    skull = egg((0, 0, z), (head * 0.94, head, head * 1.12))
    face = egg((0, -head * 0.9, z - head * 0.22), (head * 0.86, head * 0.9, head * 0.82))
    cap = cut(
        egg((0, 0.04, z + 0.05), (head * 1.08, head * 1.12, head * 1.2)),
        face,
        box((0, -head, z - head * 0.1 - 1), (2, head, 1)),
        box((0, 0, z - head * 0.7 - 1), (2, 2, 1)),
    )
    fall = egg((0, 0.16, z - 0.16), (head * 1.06, 0.2, head * 1.3))
    neck = tube((0, 0, top - 0.1), (0, 0, z), 0.11)
    return {
        "shirt": join(cut(trunk, hem), _arms(x, top - 0.17, down, out, 0.12, raised)),
        "skin": join(skull, neck, hands, egg((0, front - 0.04, z - 0.06), (0.055, 0.08, 0.08))),
        "hair": join(cap, fall) if draw.chance(0.4) else cap,
        "trousers": join(hips, both(taper((a, 0, leg - 0.12), (a, 0, 0.14), 0.165, 0.12))),
        "shoes": both(box((a, -0.08, 0.08), (0.12, 0.24, 0.1), 0.07)),
        "eyes": both(egg((head * 0.4, front + 0.02, z + 0.03), (0.05, 0.06, 0.075))),
        "mouth": capsule(
            (-0.045, front + 0.08, z - head * 0.6), (0.045, front + 0.08, z - head * 0.6), 0.05
        ),
        "belt": tube((0, 0, leg), (0, 0, leg + 0.12), wide * 0.92, 0.02),
    }


def _heater(middle: Vector, wide: float, high: float) -> tuple[Solid, Solid]:
    """A shield with a flat top and a pointed foot, and the cross on its front."""
    curve = smooth_curve([(wide, 0.0), (wide * 0.8, -high * 0.4), (0.01, -high)])
    plate = prism(mirrored([(wide, high * 0.55), *curve]), 1, 0.1)
    cross = join(
        box((0, -0.09, -high * 0.16), (0.1, 0.08, high * 0.62)),
        box((0, -0.09, high * 0.12), (wide * 0.86, 0.08, 0.1)),
    )
    return moved(plate, middle), moved(cross, middle)


def _helm(head: float, z: float) -> tuple[Solid, Solid]:
    """A great helm with a dark slit across its front, a ridge below it and a brow above."""
    r = head
    pot = lathe([(r * 0.9, z - 0.4), (r, z - 0.05), (r, z + 0.3), (r * 0.62, z + 0.47)])
    ridge = box((0, -r, z - 0.2), (0.09, 0.09, 0.2))
    brow = tube((0, 0, z + 0.17), (0, 0, z + 0.31), r + 0.05)
    slit = tube((0, 0, z), (0, 0, z + 0.18), r + 0.02)
    return join(pot, ridge, brow), within(slit, box((0, -r, z), (r * 0.95, r * 0.85, 0.3)))


def knight(draw: Draw) -> Parts:
    """In plate armour and a great helm, with plume, shield and an upright sword."""
    leg, wide, head = draw(0.74, 0.88), draw(0.38, 0.44), draw(0.36, 0.4)
    top, x, a = leg + draw(0.74, 0.84), wide + 0.16, wide * 0.66
    z, hand = top + 0.36, (wide + 0.46, -0.42, top - 0.5)
    cuirass = lathe(
        [(wide * 1.12, leg - 0.22), (wide * 0.78, leg + 0.14), (wide * 0.8, leg + 0.2),
         (wide * 1.1, top - 0.28), (wide * 0.95, top - 0.1), (wide * 0.5, top)]
    )  # fmt: skip
    shoulder = lathe(
        [(0.31, top - 0.3), (0.3, top - 0.14), (0.2, top + 0.02), (0.06, top + 0.07)], 0, (x, 0)
    )
    limbs = [
        limb([(x, 0, top - 0.2), (x + 0.08, 0.02, top - 0.52), hand], 0.14, 0.14),
        taper((x + 0.14, -0.16, hand[2]), hand, 0.14, 0.19),
        tube((a, 0, 0.05), (a, 0, leg), 0.18),
        tube((a, 0, 0.3), (a, 0, 0.46), 0.22),
        box((a, -0.12, 0.12), (0.19, 0.33, 0.13), 0.05),
    ]
    helm, slit = _helm(head, z)
    plate, cross = _heater((-hand[0] - 0.02, hand[1] - 0.2, top - 0.46), 0.42, draw(0.7, 0.8))
    tip = draw(1.25, 1.45)
    half = [(0.12, -0.1), (0.12, tip - 0.24), (0.01, tip)]
    sword = join(
        prism([(hand[0] + u, hand[2] + v) for u, v in mirrored(half)], 1, 0.09, hand[1]),
        box((hand[0], hand[1], hand[2] + 0.26), (0.3, 0.1, 0.09)),
        ball((hand[0], hand[1], hand[2] - 0.28), 0.13),
    )
    c = z + 0.4
    feather = [
        *[(-0.24, c), (-0.3, c + 0.22), (-0.1, c + 0.42), (0.26, c + 0.44), (0.56, c + 0.2)],
        *[(0.72, c - 0.3), (0.66, c - 0.62), (0.5, c - 0.36), (0.36, c - 0.1), (0.1, c)],
    ]
    return {
        "armour": join(cuirass, both(join(shoulder, *limbs)), helm, cross),
        "visor": slit,
        "plume": prism(smooth_curve(feather), 0, 0.11),
        "shield": plate,
        "sword": sword,
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


BEASTS = {
    "horse": fitted(horse),
    "unicorn": fitted(unicorn),
    "deer": fitted(deer),
    "corgi": fitted(corgi),
    "dragon": fitted(dragon),
    "dinosaur": fitted(dinosaur),
    "person": fitted(person),
    "knight": fitted(knight),
    "monkey": fitted(monkey),
}
