"""People by rank or trade, and a superhero."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    cut,
    egg,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.faces import moustache
from core.prior.things.shared.figure import figure, figure_with_hand, hair


def _points(count: int, r: float, low: float, high: float) -> Solid:
    """A crown's points, each with a ball on it."""
    point = join(
        prism([(-0.15, low), (0.15, low), (0, high)], 0, 0.075, r), ball((r, 0, high), 0.095)
    )
    return around(count, point, 90)


def king(draw: Draw) -> Parts:
    """In a long robe with fur at its hem and shoulders, bearded, crowned, with a sceptre."""
    wide, head, tall = draw(0.56, 0.66), draw(0.34, 0.39), draw(0.3, 0.4)
    top, beard, out = draw(1.42, 1.58), draw(0.4, 0.54), draw(0.06, 0.16)
    z = top + head * 0.68
    face, brow = -head * 0.94, z + head * 0.5
    grip = (wide * 0.86 + out, -0.32, top - 0.5)
    robe = lathe(smooth_curve([(wide, 0.06), (wide * 0.78, 0.7), (wide * 0.74, top - 0.3),
                               (0.24, top)]), 0.03)  # fmt: skip
    sleeve = taper((wide * 0.66, 0, top - 0.2), grip, 0.2, 0.19)
    fur = join(
        tube((0, 0, 0.0), (0, 0, 0.2), wide + 0.08, 0.07),
        lathe([(wide * 0.86, top - 0.28), (head * 0.7, top + 0.02)], 0.08),
        box((0, -wide * 0.82, 0.62), (0.13, 0.16, 0.6), 0.05),
        both(ball((grip[0] - 0.02, grip[1] + 0.06, grip[2] + 0.03), 0.215)),
    )
    rod = (-grip[0], grip[1] - 0.06, 0.0)
    sceptre = join(
        tube((rod[0], rod[1], 0.4), (rod[0], rod[1], top + 0.26), 0.085),
        ball((rod[0], rod[1], top + 0.34), 0.19),
        tube((rod[0], rod[1], top + 0.08), (rod[0], rod[1], top + 0.2), 0.14, 0.02),
    )
    band = join(tube((0, 0, brow), (0, 0, brow + 0.2), head + 0.05, 0.02),
                _points(6, head, brow + 0.16, brow + 0.14 + tall))  # fmt: skip
    return {
        "robe": join(robe, both(sleeve)),
        "fur": fur,
        "gold": join(band, sceptre, tube((0, 0, 0.86), (0, 0, 1.0), wide * 0.78 + 0.06, 0.02)),
        "skin": join(
            ball((0, 0, z), head),
            ball((0, face - 0.05, z - 0.02), 0.1),
            both(ball((grip[0], grip[1] - 0.12, grip[2] - 0.02), 0.17)),
        ),
        "beard": join(
            egg((0, face + 0.1, z - 0.3), (head * 0.8, 0.24, beard)),
            moustache((0, face - 0.06, z - 0.14), 0.16),
            egg((0, 0.1, z - 0.06), (head * 1.06, head * 0.98, head * 0.9)),
        ),
        "eyes": both(egg((0.16, face + 0.03, z + 0.08), (0.07, 0.07, 0.1))),
    }


def queen(draw: Draw) -> Parts:
    """A gown that widens to the ground, a high collar behind the head, a crown, a sceptre."""
    f = figure_with_hand(draw, (0.36, -0.32, -0.46))
    r, w, (x, y, z) = f.head, f.wide, f.hand
    wide, tall = draw(0.9, 0.96), draw(0.34, 0.38)
    brow = f.z + r * 0.66
    side = smooth_curve(
        [(wide, 0.04), (wide * 0.84, 0.4), (w * 1.0, f.leg + 0.1), (w * 0.66, f.leg + 0.32)]
    )
    bodice = lathe([(w * 0.66, f.leg + 0.28), (w * 0.92, f.top - 0.22), (w * 0.6, f.top)], 0.03)
    panel = prism(
        [(-0.36, -0.1), (0.36, -0.1), (0.15, f.leg + 0.32), (-0.15, f.leg + 0.32)], 1, 1, -1.1
    )
    front = within(lathe([(a + 0.05, b) for a, b in side], 0.03), panel)
    fan = prism(
        [(-0.3, f.top - 0.16), (0.3, f.top - 0.16), (0.86, f.z + 0.3), (0.5, f.z + 0.46),
         (-0.5, f.z + 0.46), (-0.86, f.z + 0.3)], 1, 0.09, 0.26)  # fmt: skip
    point = join(
        prism([(-0.17, brow + 0.1), (0.17, brow + 0.1), (0, brow + tall)], 0, 0.08, r * 0.8),
        ball((r * 0.8, 0, brow + tall), 0.1),
    )
    rod = y - 0.08
    puff = ball((w * 0.86, 0, f.top - 0.2), 0.25)
    return {
        "dress": join(
            lathe(side, 0.03), bodice,
            both(join(puff, taper((w * 0.86, 0, f.top - 0.2), f.hand, 0.17, 0.15))),
        ),
        "trim": join(
            front, fan, tube((0, 0, 0), (0, 0, 0.18), wide + 0.08, 0.06),
            both(ball((x - 0.05, y + 0.05, z + 0.04), 0.2)),
        ),
        "gold": join(
            tube((0, 0, brow), (0, 0, brow + 0.18), r * 0.86, 0.02),
            around(5, point, 90),
            tube((-x, rod, z - 0.4), (-x, rod, f.z + 0.1), 0.085),
            ball((-x, rod, f.z + 0.22), 0.2),
            tube((0, 0, f.leg + 0.26), (0, 0, f.leg + 0.4), w * 0.78, 0.03),
        ),
        "skin": join(
            f.skull(), both(ball((x + 0.02, y - 0.08, z - 0.05), 0.17)),
            tube((0, 0, f.top - 0.2), (0, 0, f.z), 0.17),
        ),
        "hair": join(hair(f), both(ball((r * 0.98, 0.1, f.z - 0.06), 0.22))),
        "eyes": f.eyes(),
    }  # fmt: skip


def princess(draw: Draw) -> Parts:
    """A long dress like a bell with a light front and hem; long hair, a crown."""
    f = figure(draw)
    r, w, wide = f.head, f.wide, draw(0.82, 0.98)
    long, points = draw(1.0, 1.3), 5
    side = [(wide, 0.04), (wide * 0.86, 0.36), (w * 1.15, f.leg + 0.08), (w * 0.6, f.leg + 0.3)]
    bell = lathe(smooth_curve(side), 0.03)
    bodice = lathe(
        [(w * 0.6, f.leg + 0.26), (w * 0.84, f.top - 0.24), (w * 0.6, f.top - 0.1)], 0.03
    )
    panel = prism(
        [(-wide * 0.5, -0.1), (wide * 0.5, -0.1), (0.12, f.leg + 0.3), (-0.12, f.leg + 0.3)],
        1,
        1,
        -1.1,
    )
    front = within(lathe([(a + 0.04, b) for a, b in smooth_curve(side)], 0.03), panel)
    brow = f.z + r * 0.72
    point = prism([(-0.14, brow), (0.14, brow), (0, brow + 0.42)], 0, 0.075, r * 0.72)
    lock = taper((r * 0.9, -r * 0.1, f.z), (r * 1.0, -0.1, f.top - 0.36), 0.16, 0.13)
    return {
        "dress": join(bell, bodice, both(ball((w * 0.84, 0, f.top - 0.2), 0.24))),
        "trim": join(
            front,
            tube((0, 0, 0), (0, 0, 0.17), wide + 0.08, 0.05),
            tube((0, 0, f.leg + 0.24), (0, 0, f.leg + 0.38), w * 0.72, 0.03),
        ),
        "skin": join(
            f.skull(), f.sleeves(-0.04), f.hands(0.14), tube((0, 0, f.top - 0.3), (0, 0, f.z), 0.16)
        ),
        "hair": join(hair(f, long), both(lock)),
        "crown": join(
            tube((0, 0, brow - 0.04), (0, 0, brow + 0.16), r * 0.82, 0.02),
            around(points, point, 90),
        ),
        "eyes": f.eyes(),
    }


def police_officer(draw: Draw) -> Parts:
    """In navy with a peaked cap, a golden badge on the cap and the chest, a belt with pouches."""
    f = figure_with_hand(draw, (0.22, -0.1, -0.66))
    r, w = f.head, f.wide * 1.06
    f = f._replace(wide=w)
    brow, crown = f.z + r * 0.58, r * draw(1.28, 1.36)
    top = lathe([(r * 1.04, brow + 0.1), (crown, brow + 0.3), (crown * 0.9, brow + 0.4)], 0.04)
    peak = within(
        moved(turned(tube((0, 0, -0.065), (0, 0, 0.065), r * 1.0, 0.03), 0, 14),
              (0, -r * 0.38, brow + 0.03)),
        box((0, -2 - r * 0.3, brow), (2, 2, 1)),
    )  # fmt: skip
    star = [(0.2 * s * math.sin(k * math.pi / 5), 0.2 * s * math.cos(k * math.pi / 5))
            for k, s in enumerate((1.0, 0.55) * 5)]  # fmt: skip
    badge = prism([(w * 0.5 + u, f.top - 0.34 + v) for u, v in star], 1, 0.12, -w * 0.84)
    crest = prism([(u, brow + 0.24 + v) for u, v in star], 1, 0.1, -crown * 0.94)
    tie = prism([(-0.09, f.top), (0.09, f.top), (0.14, f.top - 0.4), (0, f.top - 0.54),
                 (-0.14, f.top - 0.4)], 1, 0.12, -w * 0.9)  # fmt: skip
    belt = f.leg + 0.06
    pouch = box((w * 0.78, -w * 0.62, belt + 0.04), (0.15, 0.16, 0.15), 0.03)
    return {
        "uniform": join(f.trunk(0.04), f.sleeves(0.03), f.legs(0.05)),
        "cap": join(top, tube((0, 0.02, brow - 0.04), (0, 0.02, brow + 0.16), r * 1.07, 0.02)),
        "badge": join(badge, crest, box((0, -w * 1.02, belt + 0.09), (0.14, 0.12, 0.1), 0.02)),
        "skin": join(f.skull(), f.hands(0.21)),
        "belt": join(
            tube((0, 0, belt), (0, 0, belt + 0.18), w * 1.04, 0.02), both(pouch), f.shoes(0.26),
            peak, tie, f.eyes(),
        ),
        "hair": cut(hair(f), box((0, 0, brow + 1), (2, 2, 1))),
    }  # fmt: skip


def firefighter(draw: Draw) -> Parts:
    """A tan coat and trousers with bright bands, a red helmet with a brim and a crest, an axe."""
    f = figure_with_hand(draw, (0.34, -0.34, -0.52))
    r, w, (x, y, _) = f.head, f.wide, f.hand
    hem, brow = draw(0.52, 0.56), f.z + r * 0.5
    coat = [(w * 1.16, hem), (w * 1.0, f.leg + 0.3), (w * 1.0, f.top - 0.2), (w * 0.66, f.top)]
    shoulder = (w * 0.84, 0, f.top - 0.2)
    elbow, wrist = (
        tuple(a + (b - a) * k for a, b in zip(shoulder, f.hand, strict=True)) for k in (0.68, 0.92)
    )
    leg = w * 0.54
    brim = lathe([(r * 1.2, brow), (r * 1.1, brow + 0.13)], 0.04)
    back = moved(lathe([(r * 1.26, brow - 0.02), (r * 1.12, brow + 0.12)], 0.04), (0, 0.22, 0))
    dome = cut(ball((0, 0.02, brow + 0.02), r * 1.12), box((0, 0, brow - 1), (2, 2, 1)))
    ridge = cut(tube((-0.1, 0.02, brow), (0.1, 0.02, brow), r * 1.34),
                box((0, 0, brow - 1), (2, 2, 1)))  # fmt: skip
    shield = prism(
        [(-0.2, brow + 0.46), (0.2, brow + 0.46), (0.22, brow + 0.16), (0, brow + 0.04),
         (-0.22, brow + 0.16)], 1, 0.09, -r * 1.05)  # fmt: skip
    head = f.z - 0.04
    blade = [(x, head + 0.12), (x + 0.4, head + 0.26), (x + 0.4, head - 0.26), (x, head - 0.12),
             (x - 0.16, head - 0.08), (x - 0.34, head), (x - 0.16, head + 0.08)]  # fmt: skip
    return {
        "coat": join(lathe(coat, 0.04), f.sleeves(0.06), f.legs(0.05)),
        "bands": join(
            tube((0, 0, hem + 0.02), (0, 0, hem + 0.18), w * 1.3, 0.03),
            both(tube(elbow, wrist, 0.25)),
            both(box((w * 0.5, -w * 0.8, f.top - 0.36), (0.09, 0.3, 0.26), 0.05)),
            both(tube((leg, 0, 0.3), (leg, 0, 0.44), 0.28, 0.03)),
            shield,
        ),
        "helmet": join(dome, ridge, brim, back),
        "skin": f.skull(),
        "axe": prism(blade, 1, 0.085, y),
        "boots": join(
            f.shoes(0.3),
            f.hands(0.23),
            tube((x, y, 0.56), (x, y, head + 0.22), 0.09),
            f.eyes(),
        ),
    }  # fmt: skip


def chef(draw: Draw) -> Parts:
    """A tall white hat that puffs out at its top, a coat, an apron, a moustache."""
    f = figure(draw)
    r, w, tall = f.head, f.wide * draw(1.05, 1.2), draw(0.62, 0.86)
    f = f._replace(wide=w)
    top, hem = f.z + r * 0.5 + tall, draw(0.3, 0.42)
    apron = lathe([(w * 1.2, hem), (w * 1.06, f.leg + 0.2), (w * 1.02, f.top - 0.42)], 0.04)
    region = prism(
        [
            (-w * 1.1, 0),
            (w * 1.1, 0),
            (w * 1.0, f.leg + 0.34),
            (w * 0.62, f.leg + 0.4),
            (w * 0.56, f.top),
            (-w * 0.56, f.top),
            (-w * 0.62, f.leg + 0.4),
            (-w * 1.0, f.leg + 0.34),
        ],
        1,
        1,
        -1,
    )
    knot = prism([(-0.3, f.top + 0.04), (0.3, f.top + 0.04), (0, f.top - 0.28)], 1, 0.12, -w * 0.92)
    return {
        "coat": join(
            f.trunk(0.05), f.sleeves(0.05), tube((0, 0, f.leg - 0.1), (0, 0, f.leg + 0.2), w)
        ),
        "hat": join(
            tube((0, 0, f.z + r * 0.42), (0, 0, top), r * 0.94, 0.03),
            around(7, ball((r * 0.8, 0, top), r * 0.52)),
            ball((0, 0, top + 0.06), r * 0.86),
        ),
        "apron": join(
            within(apron, region),
            tube((0, 0, f.leg + 0.2), (0, 0, f.leg + 0.34), w * 1.05),
            ring((0, 0, f.top + 0.04), r * 0.7, 0.1),
            knot,
        ),
        "skin": join(f.skull(), f.hands()),
        "hair": join(
            cut(hair(f), box((0, -r, f.z), (1, r * 0.9, 1))),
            moustache((0, -r * 1.0, f.z - r * 0.34), 0.2),
            f.eyes(),
        ),
        "trousers": join(f.legs(0.02), f.shoes()),
    }


def clown(draw: Draw) -> Parts:
    """Baggy, with tufts of hair at both sides, a ruff, a red nose, large shoes, a small hat."""
    f = figure(draw)
    r, belly = f.head, f.wide * draw(1.2, 1.45)
    baggy = egg((0, 0, (f.leg + f.top) / 2), (belly, belly * 0.86, (f.top - f.leg) * 0.66))
    tuft = draw(0.24, 0.3)
    hat = join(
        tube((0.1, 0, f.z + r * 0.86), (0.1, 0, f.z + r * 0.86 + 0.4), 0.22, 0.03),
        tube((0.1, 0, f.z + r * 0.82), (0.1, 0, f.z + r * 0.96), 0.38, 0.04),
    )
    x = f.wide * 0.5
    shoe = egg((x + 0.04, -0.26, 0.13), (0.24, 0.5, 0.16))
    buttons = join(*(ball((0, -belly * 0.84, f.leg + at), 0.11) for at in (0.22, 0.52)))
    return {
        "suit": join(baggy, f.sleeves(0.05), f.legs(0.07)),
        "ruff": ring((0, 0, f.top), r * 0.86, 0.15),
        "skin": join(ball((0, 0, f.z), r), f.hands()),
        "hair": both(
            join(
                ball((r * 0.98, 0.06, f.z + 0.12), tuft),
                ball((r * 0.9, 0.12, f.z - 0.16), tuft * 0.8),
            )
        ),
        "nose": join(ball(f.face(-0.06, 0.06), 0.15), both(shoe), buttons, hat),
        "eyes": f.eyes(),
    }


def astronaut(draw: Draw) -> Parts:
    """A white suit with a round helmet, a golden visor, a pack with tanks, a panel at the chest."""
    f = figure(draw)
    helmet, deep = f.head * draw(1.16, 1.28), f.wide + draw(0.2, 0.28)
    pack = box((0, deep, f.top - 0.32), (f.wide * 0.86, 0.24, draw(0.46, 0.54)), 0.06)
    cuffs = both(ball(f.hand, 0.2))
    y = -f.wide * 0.96
    return {
        "suit": join(f.trunk(0.06), f.sleeves(0.06), f.legs(0.06), ball((0, 0, f.z), helmet)),
        "visor": egg((0, -helmet * 0.42, f.z + 0.02), (helmet * 0.8, helmet * 0.72, helmet * 0.62)),
        "pack": join(
            pack, both(tube((0.22, deep + 0.1, f.top - 0.8), (0.22, deep + 0.1, f.z), 0.16, 0.05))
        ),
        "boots": join(f.shoes(0.34), cuffs),
        "panel": box((0, y, f.top - 0.4), (f.wide * 0.52, 0.16, 0.17), 0.03),
        "collar": ring((0, 0, f.top + 0.02), helmet * 0.74, 0.11),
    }


def superhero(draw: Draw) -> Parts:
    """Broad, the fists at the hips, in a cape, with a sign on the chest."""
    f = figure(draw)
    r, wide = f.head, f.wide * draw(1.12, 1.24)
    chest = lathe(
        smooth_curve(
            [
                (f.wide * 0.66, f.leg),
                (f.wide * 0.72, f.leg + 0.26),
                (wide, f.top - 0.3),
                (wide * 0.7, f.top),
            ]
        ),
        0.05,
    )
    shoulder, elbow = (wide * 0.94, 0, f.top - 0.2), (wide + 0.44, 0.06, f.leg + 0.42)
    hip = (f.wide * 0.86, -0.1, f.leg + 0.16)
    sweep = draw(0.16, 0.4)
    cape = [
        (f.wide * 0.82, f.top - 0.06),
        (wide * 1.45, 0.16),
        (-wide * 1.45, 0.16),
        (-f.wide * 0.82, f.top - 0.06),
    ]
    slab = turned(prism(cape, 1, 0.09), 0, math.degrees(sweep / f.top))
    sign = [(0, -0.2), (0.2, 0.02), (0.12, 0.14), (-0.12, 0.14), (-0.2, 0.02)]
    return {
        "suit": join(chest, f.legs(), both(limb([shoulder, elbow, hip], 0.19, 0.14))),
        "cape": join(
            moved(slab, (0, f.wide * 0.82 + sweep, 0)),
            ring((0, 0.02, f.top + 0.02), r * 0.62, 0.13),
        ),
        "skin": join(f.skull(), both(ball(hip, 0.17))),
        "hair": hair(f),
        "trim": join(
            f.shoes(f.leg * 0.6),
            tube((0, 0, f.leg - 0.02), (0, 0, f.leg + 0.16), f.wide * 0.86, 0.03),
            prism([(a, f.top - 0.24 + b) for a, b in sign], 1, 0.2, -wide + 0.1),
        ),
        "eyes": f.eyes(),
    }


PEOPLE_RANKS_AND_TRADES = {
    "king": king,
    "queen": queen,
    "princess": princess,
    "police officer": police_officer,
    "firefighter": firefighter,
    "chef": chef,
    "clown": clown,
    "astronaut": astronaut,
    "superhero": superhero,
}
