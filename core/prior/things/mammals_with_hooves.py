"""Less common mammals with hooves, and a hippo."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    blend,
    both,
    box,
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
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import Beast, bulk, four_legs, nails
from core.prior.things.shared.stripes import cuff, hoop, leg_stripes, skin_fold


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
            *(hoop(b, at, 0.07) for at in (-0.38, -0.02, 0.34, 0.7)),
            *(cuff(*neck, at, 0.07, r) for at, r in ((0.5, 0.225), (0.82, 0.205))),
            leg_stripes(b, b.belly * 0.38, b.belly * 0.62),
            cuff((0, y, z), snout, 0.42, 0.06, 0.195),
        ),
        "mane": join(crest, tuft),
        "muzzle": taper((0, y - 0.38, z - 0.25), (0, y - 0.52, z - 0.34), 0.175, 0.17),
        "hooves": b.feet(0.15),
        "eyes": both(ball((0.2, y - 0.08, z + 0.08), 0.08)),
    }  # fmt: skip


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
    fold = [skin_fold(wide, long, z, at) for at in (-0.42, 0.42)]
    return {
        "body": join(trunk, neck, taper((0, y, h), snout, 0.33, 0.24), both(ear), tail),
        "horns": join(*horns),
        "plates": join(*fold),
        "hooves": nails(wide, long),
        "eyes": both(ball((0.28, y - 0.18, h + 0.1), 0.085)),
    }


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


def llama(draw: Draw) -> Parts:
    """Woolly, a long upright neck, ears like bananas, a bright blanket on its back."""
    wide, long, leg = draw(0.4, 0.47), draw(0.6, 0.7), draw(0.62, 0.76)
    z, tall, head = leg + 0.3, draw(0.95, 1.15), 0.27
    y, up = -long - 0.16, z + tall
    shank = taper((wide * 0.5, long * 0.72, z), (wide * 0.5, long * 0.72, 0.2), 0.24, 0.15)
    tufts = [egg((0, v * long, z + 0.04), (wide, 0.36, 0.42)) for v in (-0.8, -0.25, 0.3, 0.85)]
    neck = [
        ((0.0, -long * 0.8, z + 0.1), 0.34),
        ((0.0, y + 0.02, z + 0.5), 0.25),
        ((0.0, y, up), 0.24),
    ]
    ear = chain(
        [
            ((0.15, y + 0.04, up + 0.16), 0.1),
            ((0.2, y + 0.06, up + 0.38), 0.1),
            ((0.13, y + 0.02, up + 0.56), 0.08),
        ]
    )
    back = tube((0, -long * 0.42, z + 0.02), (0, long * 0.5, z + 0.02), wide + 0.08)
    return {
        "wool": join(
            *tufts,
            chain(neck),
            ball((0, y + 0.02, up + 0.1), head),
            both(
                taper((wide * 0.5, long * 0.72, z), (wide * 0.5, long * 0.72, z - 0.3), 0.28, 0.2),
                0,
                1,
            ),
            taper((0, long + 0.2, z + 0.16), (0, long + 0.4, z + 0.2), 0.18, 0.14),
        ),
        "face": join(
            both(ear),
            taper((0, y - 0.1, up + 0.06), (0, y - 0.4, up - 0.02), 0.22, 0.16),
            both(shank, 0, 1),
        ),
        "blanket": cut(back, box((0, 0, z - 1.1), (2, 2, 1))),
        "fringe": both(box((wide + 0.02, long * 0.04, z - 0.12), (0.09, long * 0.46, 0.1))),
        "hooves": join(
            both(
                tube((wide * 0.5, long * 0.72, 0), (wide * 0.5, long * 0.72, 0.17), 0.17, 0.03),
                0,
                1,
            ),
            egg((0, y - 0.54, up + 0.03), (0.1, 0.09, 0.08)),
        ),
        "eyes": eyes(0.21, y - 0.15, up + 0.16, 0.085),
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


def moose(draw: Draw) -> Parts:
    """Huge antlers like open hands, a humped back, a long drooping muzzle, a bell at the throat."""
    wide, long, leg = draw(0.42, 0.45), draw(0.78, 0.84), draw(0.84, 0.9)
    z = leg + 0.3
    y, up = -long - 0.3, z + 0.36
    palm = [(0.04, -0.1), (0.4, -0.02), (0.8, 0.08), (1.26, 0.3), (1.3, 0.66), (1.1, 0.5),
            (1.04, 0.92), (0.84, 0.6), (0.68, 0.96), (0.58, 0.52), (0.34, 0.74), (0.34, 0.26),
            (0.04, 0.12)]  # fmt: skip
    plate = moved(turned(prism(palm, 1, 0.09), 0, 14), (0, y + 0.2, up + 0.2))
    ear = taper((0.22, y + 0.1, up + 0.14), (0.5, y + 0.14, up + 0.1), 0.13, 0.08)
    a, b = wide * 0.54, long * 0.66
    snout = chain([((0, y, up), 0.27), ((0, y - 0.42, up - 0.16), 0.22),
                   ((0, y - 0.68, up - 0.34), 0.24)])  # fmt: skip
    return {
        "body": join(
            blend(0.16, egg((0, 0, z), (wide, long, wide * 0.98)),
                  egg((0, -long * 0.5, z + 0.26), (wide * 0.84, 0.44, 0.42)),
                  taper((0, -long * 0.6, z + 0.1), (0, y, up), 0.34, 0.27)),
            both(ear),
            limb([(0, y + 0.06, up - 0.2), (0, y + 0.02, up - 0.6)], 0.16, 0.1),
            ball((0, long, z + 0.16), 0.13),
        ),
        "antlers": both(plate),
        "muzzle": snout,
        "legs": four_legs(a, b, z - 0.12, 0.15),
        "hooves": join(
            both(tube((a, b, 0.0), (a, b, 0.17), 0.19, 0.02), 0, 1),
            both(ball((0.13, y - 0.84, up - 0.28), 0.085)),
        ),
        "eyes": eyes(0.24, y - 0.12, up + 0.12, 0.095),
    }  # fmt: skip


MAMMALS_WITH_HOOVES = {
    "zebra": fitted(zebra),
    "rhino": fitted(rhino),
    "hippo": fitted(hippo),
    "camel": fitted(camel),
    "llama": fitted(llama),
    "goat": fitted(goat),
    "moose": fitted(moose),
}
