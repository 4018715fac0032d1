"""A person, a knight, an alien, a ghost, plain toys, and three creatures of tales."""

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
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import Beast, steed


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


def teddy(draw: Draw) -> Parts:
    """A teddy bear, sitting."""
    wide, head = draw(0.5, 0.58), draw(0.44, 0.5)
    z = draw(1.28, 1.38)
    arm = taper((wide * 0.75, -0.05, 0.92), (wide + 0.3, draw(-0.4, -0.2), 0.62), 0.18, 0.2)
    leg = taper((0.26, -0.25, 0.24), (draw(0.42, 0.5), -0.82, 0.24), 0.22, 0.23)
    face = -head - 0.02
    front, knot = -head * 0.84, z - head * 0.86
    return {
        "body": join(
            egg((0, 0, 0.62), (wide, wide * 0.9, 0.6)),
            egg((0, -0.02, z), (head * 1.06, head, head)),
            both(ball((head * 0.8, 0, z + head * 0.75), 0.2)),
            both(arm),
            both(leg),
        ),
        "muzzle": join(
            egg((0, face + 0.1, z - 0.12), (0.22, 0.2, 0.17)),
            egg((0, -wide * 0.9 + 0.26, 0.6), (wide * 0.66, 0.3, 0.4)),
            both(tube((0.46, -0.96, 0.24), (0.46, -1.06, 0.24), 0.14, 0.03)),
        ),
        "eyes": join(
            both(ball((0.19, face + 0.09, z + 0.12), 0.075)),
            egg((0, face - 0.08, z - 0.05), (0.1, 0.08, 0.075)),
        ),
        "bow tie": join(
            both(moved(prism([(0.03, 0.0), (0.3, 0.17), (0.3, -0.17)], 1, 0.1), (0, front, knot))),
            ball((0, front - 0.04, knot), 0.11),
        ),
    }


def snowman(draw: Draw) -> Parts:
    low, middle, head = draw(0.66, 0.74), draw(0.47, 0.53), draw(0.35, 0.4)
    z1 = low + (low + middle) * draw(0.72, 0.8)
    z2 = z1 + (middle + head) * draw(0.74, 0.82)
    face = -head
    brim = z2 + head * 0.75
    eyes = both(ball((0.15, face * 0.85, z2 + 0.13), 0.085))
    buttons = (ball((0, -middle * 0.97, z1 + d), 0.1) for d in (-0.24, 0.04))
    nose = taper((0, face * 0.85, z2), (0, face - draw(0.3, 0.42), z2 - 0.04), 0.13, 0.06)
    hat = join(
        tube((0, 0, brim - 0.05), (0, 0, brim + 0.07), head * 1.12, 0.03),
        tube((0, 0, brim), (0, 0, brim + draw(0.4, 0.5)), head * 0.72, 0.03),
    )
    neck = (z1 * head + z2 * middle) / (head + middle)
    arm = join(
        capsule((middle * 0.8, 0, z1 + 0.1), (middle + 0.62, -0.08, z1 + 0.5), 0.075),
        capsule((middle + 0.36, -0.05, z1 + 0.33), (middle + 0.66, -0.06, z1 + 0.2), 0.065),
    )
    parts = {
        "body": join(ball((0, 0, low), low), ball((0, 0, z1), middle), ball((0, 0, z2), head)),
        "nose": nose,
        "buttons": join(eyes, *buttons),
        "arms": both(arm),
        "scarf": join(
            ring((0, 0, neck), head * 0.82, 0.13),
            box((head * 0.55, -middle * 0.84, neck - 0.26), (0.12, 0.1, 0.28), 0.05),
        ),
    }
    return parts | {"hat": hat} if draw.has("hat", 0.9) else parts


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


def unicorn(draw: Draw) -> Parts:
    """A horse with a horn."""
    b, parts = steed(draw)
    start = (0, b.y - 0.1, b.z + 0.15)
    horn = taper(start, (0, b.y - 0.4, b.z + draw(0.7, 0.95)), 0.11, 0.04)
    return parts | {"horn": horn}


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


FIGURES = {
    "person": fitted(person),
    "knight": fitted(knight),
    "teddy bear": teddy,
    "snowman": snowman,
    "ghost": fitted(ghost),
    "alien": fitted(alien),
    "unicorn": fitted(unicorn),
    "dragon": fitted(dragon),
    "dinosaur": fitted(dinosaur),
}
