"""Animals with spots, wings, long necks or flat tails, and two figures of tales."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
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
    lathe,
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
from core.prior.things.animals import fitted
from core.prior.things.characters import cone, eyes, moustache

SPOT = 0.13  # the radius of a ball of which a cap stands out as a spot


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


def bat(draw: Draw) -> Parts:
    """In the air, its scalloped wings spread: a round body, great ears, two fangs."""
    wide, span, up, ear = draw(0.45, 0.49), draw(1.36, 1.46), draw(0.34, 0.46), draw(0.52, 0.62)
    z, y = 1.0, 0.12
    wrist, tip = (span * 0.6, z + 0.26 + up), (span, z + up * 0.6 - 0.02)
    low = ((span * 0.76, z - 0.5), (span * 0.46, z - 0.62), (0.2, z - 0.42))
    skin = [(0.1, z + 0.24), wrist, tip]
    for (a, b), (c, d) in pairwise((tip, *low)):
        # Between two points the edge is a bow, hollow below.
        skin += smooth_curve([(a, b), ((a + c) / 2 - 0.02, (b + d) / 2 + 0.16), (c, d)])[1:]
    bones = join(
        limb([(wide * 0.6, y, z + 0.16), (wrist[0], y, wrist[1]), (tip[0], y, tip[1])], 0.13, 0.1),
        *(taper((wrist[0], y, wrist[1]), (u, y, v + 0.04), 0.13, 0.1) for u, v in low[:2]),
    )
    flap = [(0.02, 0.0), (0.06, 0.3), (0.34, ear), (0.54, 0.3), (0.5, 0.0)]
    inner = [(0.14, 0.0), (0.17, 0.24), (0.33, ear - 0.16), (0.43, 0.24), (0.4, 0.0)]
    face = -wide * 0.94
    return {
        "body": join(
            ball((0, 0, z), wide),
            both(moved(prism(smooth_curve(flap), 1, 0.12), (0, -0.06, z + wide * 0.72))),
            both(capsule((0.2, -0.04, z - wide + 0.1), (0.22, -0.1, z - wide - 0.12), 0.13)),
            ball((0, face - 0.02, z - 0.02), 0.12),
        ),
        "wings": both(prism(skin, 1, 0.1, y)),
        "arms": both(bones),
        "ears": both(moved(prism(smooth_curve(inner), 1, 0.1), (0, -0.18, z + wide * 0.72))),
        "eyes": eyes(0.22, face + 0.02, z + 0.16, 0.15),
        "teeth": both(cone((0.14, face + 0.06, z - 0.14), 0.11, -0.26)),
    }


def ostrich(draw: Draw) -> Parts:
    """A great ball of feathers on long bare legs, a long bare neck, a flat bill."""
    leg, wide, up = draw(1.0, 1.2), draw(0.48, 0.56), draw(0.95, 1.15)
    z = leg + 0.34
    y, top = -0.72, z + up + 0.2
    neck = [(0, -0.42, z + 0.12), (0, -0.68, z + 0.34), (0, -0.66, z + up * 0.66), (0, y, top)]
    shank = join(
        taper((0.24, 0.04, z - 0.12), (0.24, 0.1, leg * 0.54), 0.19, 0.12),
        taper((0.24, 0.1, leg * 0.54), (0.24, 0.0, 0.1), 0.12, 0.1),
        taper((0.22, 0.0, 0.1), (0.2, -0.36, 0.1), 0.12, 0.1),
        taper((0.26, 0.0, 0.1), (0.4, -0.2, 0.1), 0.11, 0.095),
    )
    wing = tilted(egg((0, 0, 0), (0.16, 0.5, 0.34)), 10, (wide * 0.86, 0.1, z + 0.08))
    frill = [
        egg((wide * 0.84, v, z - 0.14 + v * 0.16), (0.17, 0.16, 0.19)) for v in (0.06, 0.34, 0.58)
    ]
    plume = [
        taper((x, 0.56, z + 0.16), (x * 2.2, 0.56 + a, z + 0.16 + v), 0.2, 0.15)
        for x, a, v in ((0.0, 0.3, 0.36), (0.14, 0.42, 0.16))
    ]
    return {
        "body": join(egg((0, 0.08, z), (wide, 0.7, 0.46)), both(wing)),
        "plumes": join(
            both(join(*frill, *plume)), tube((0, -0.44, z + 0.1), (0, -0.56, z + 0.22), 0.26, 0.08)
        ),
        "skin": join(
            limb(neck, 0.19, 0.13),
            egg((0, y - 0.04, top + 0.04), (0.22, 0.26, 0.2)),
            both(shank),
        ),
        "bill": egg((0, y - 0.32, top + 0.02), (0.17, 0.24, 0.09)),
        "hair": egg((0, y + 0.05, top + 0.17), (0.15, 0.18, 0.12)),
        "eyes": eyes(0.18, y - 0.12, top + 0.12, 0.1),
    }  # fmt: skip


def beaver(draw: Draw) -> Parts:
    """Sits up, its broad flat tail raised behind it; two great teeth, small round ears."""
    wide, head, long = draw(0.5, 0.54), draw(0.45, 0.48), draw(1.2, 1.3)
    z, flat, lift = draw(1.32, 1.38), draw(0.58, 0.62), draw(48, 52)
    half = [(0.2, 0), (flat * 0.9, long * 0.34), (flat, long * 0.66), (flat * 0.6, long * 0.96)]
    lines = (box((0, long * s, 0.0), (flat * 0.66, 0.075, 0.17)) for s in (0.36, 0.6, 0.84))
    face, root = -0.12 - head, (0, wide * 0.6, 0.24)
    return {
        "body": join(
            taper((0, 0, wide), (0, -0.02, 0.9), wide, 0.42),
            ball((0, -0.12, z), head),
            both(ball((head * 0.78, -0.04, z + head * 0.7), 0.17)),
            both(capsule((wide * 0.84, -0.06, 0.9), (0.26, -wide - 0.02, 0.62), 0.15)),
            both(ball((wide * 0.8, -0.12, 0.3), 0.3)),
        ),
        "belly": join(
            egg((0, -0.26, 0.58), (0.36, 0.36, 0.46)),
            both(ball((0.16, face + 0.04, z - 0.14), 0.22)),
        ),
        "tail": tilted(prism(smooth_curve(mirrored(half)), 2, 0.1), lift, root),
        "lines": join(
            both(capsule((wide * 0.74, -0.32, 0.14), (wide * 0.74, -0.7, 0.14), 0.16)),
            tilted(join(*lines), lift, root),
        ),
        "teeth": both(box((0.085, face - 0.04, z - 0.38), (0.125, 0.1, 0.16), 0.06)),
        "eyes": join(
            eyes(head * 0.5, face + head * 0.18, z + 0.19, 0.11),
            ball((0, face - 0.17, z + 0.0), 0.13),
        ),
    }


def seahorse(draw: Draw) -> Parts:
    """Upright, its snout a pipe, a crest, rings about its belly, its tail rolled up."""
    big, snout, crest = draw(0.92, 1.08), draw(0.42, 0.54), draw(0.16, 0.26)
    y, z = -0.28, 2.3
    spine = [((0.0, y, z), 0.3), ((0.0, 0.0, z - 0.2), 0.25), ((0.0, 0.08, z - 0.48), 0.25),
             ((0.0, -0.06, z - 0.84), 0.36 * big), ((0.0, -0.04, z - 1.12), 0.37 * big),
             ((0.0, 0.14, z - 1.44), 0.27), ((0.0, 0.22, z - 1.74), 0.21),
             *(((0.0, -0.14 + 0.36 * (1 - k * 0.03) * math.cos(t), z - 1.86 - 0.36 * math.sin(t)),
                0.17 - 0.008 * k) for k, t in ((k, 0.3 + 0.62 * k) for k in range(8)))]  # fmt: skip
    bands = []
    for at in (3, 4, 5, 6):
        (_, a, b), r = spine[at]
        turn = (8, -10, -22, -14)[at - 3]
        bands.append(moved(turned(tube((0, 0, -0.06), (0, 0, 0.06), r + 0.045, 0.02), 0, turn),
                           (0, a, b)))  # fmt: skip
    thorns = [
        taper((0, a + r * 0.6, b), (0, a + r + 0.14, b + 0.06), 0.13, 0.07)
        for (_, a, b), r in spine[1:7:1]
    ]
    comb = [taper((0, y + v, z + 0.2), (0, y + v * 2, z + 0.34 + crest * s), 0.13, 0.08)
            for v, s in ((-0.02, 0.6), (0.1, 1.0), (0.2, 0.5))]  # fmt: skip
    fan = [(0.1, z - 0.8), (0.62, z - 0.66), (0.7, z - 0.98), (0.58, z - 1.28), (0.1, z - 1.3)]
    return {
        "body": join(
            chain(spine),
            taper((0, y - 0.1, z - 0.06), (0, y - 0.2 - snout, z - 0.24), 0.17, 0.12),
        ),
        "belly": egg((0, -0.22, z - 0.94), (0.26, 0.26 * big, 0.42)),
        "bands": join(
            *bands,
            moved(turned(tube((0, 0, -0.08), (0, 0, 0.08), 0.17, 0.03), 0, 112),
                  (0, y - 0.2 - snout, z - 0.24)),
        ),
        "crest": join(*comb, *thorns),
        "fins": join(
            prism(fan, 0, 0.085), both(egg((0.28, y + 0.2, z - 0.1), (0.09, 0.15, 0.2)))
        ),
        "eyes": eyes(0.22, y - 0.1, z + 0.06, 0.125),
    }  # fmt: skip


def centaur(draw: Draw) -> Parts:
    """A horse whose neck is a man down to his belt; a beard, long hair, a tail."""
    wide, long, leg = draw(0.36, 0.42), draw(0.72, 0.84), draw(0.78, 0.92)
    chest, head, out = draw(0.36, 0.42), draw(0.29, 0.34), draw(0.1, 0.24)
    z, y = leg + 0.2, -long * 0.74
    belt = z + 0.34
    top = belt + draw(0.6, 0.7)
    crown = top + head * 0.9
    a, c = wide * 0.56, long * 0.66
    legs = taper((a, c, z - 0.1), (a, c, 0.14), 0.17, 0.135)
    hand = (chest + out + 0.02, y - 0.34, belt + 0.12)
    elbow = (chest + out + 0.08, y + 0.06, belt + 0.2)
    arm = join(
        taper((chest * 0.9, y, top - 0.14), elbow, 0.17, 0.13), taper(elbow, hand, 0.13, 0.11),
        ball(hand, 0.15),
    )  # fmt: skip
    wrist = hand[0] + 0.03
    cuff = tube((wrist, y - 0.1, belt + 0.16), (wrist, y - 0.24, belt + 0.13), 0.155, 0.02)
    back = long * 0.92
    tail = [((0.0, back, z + 0.12), 0.13), ((0.0, back + 0.26, z + 0.06), 0.17),
            ((0.0, back + 0.36, z - 0.3), 0.17), ((0.0, back + 0.34, z - 0.62), 0.09)]  # fmt: skip
    face = y - head * 0.94
    locks = cut(ball((0, y + 0.06, crown + 0.05), head * 1.14),
                box((0, y - 0.62, crown - 0.2), (2, 0.58, 0.4)))  # fmt: skip
    return {
        "coat": join(
            blend(0.14, egg((0, 0, z), (wide, long, wide)),
                  taper((0, y * 0.8, z), (0, y, belt), wide * 0.86, 0.3)),
            both(legs, 0, 1),
        ),
        "skin": join(
            blend(0.1, taper((0, y, belt), (0, y, top - 0.24), 0.27, 0.3),
                  egg((0, y, top - 0.22), (chest, 0.27, 0.26))),
            tube((0, y, top - 0.1), (0, y, crown), 0.14),
            ball((0, y, crown), head),
            both(arm),
            ball((0, face - 0.03, crown - 0.03), 0.085),
        ),
        "hair": join(
            locks,
            egg((0, y + 0.2, crown - 0.24), (head * 0.9, 0.2, head * 1.3)),
            egg((0, face + 0.08, crown - 0.26), (head * 0.7, 0.2, 0.26)),
            moustache((0, face - 0.06, crown - 0.14), 0.12),
            chain(tail),
        ),
        "belt": join(
            tube((0, y, belt - 0.1), (0, y, belt + 0.08), 0.36, 0.03),
            both(cuff),
        ),
        "hooves": both(lathe([(0.21, 0.0), (0.16, 0.2)], 0.01, (a, c)), 0, 1),
        "eyes": eyes(head * 0.42, face + 0.03, crown + 0.07, 0.1),
    }  # fmt: skip


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


WILDLIFE = {
    "leopard": fitted(leopard),
    "bat": bat,
    "ostrich": fitted(ostrich),
    "beaver": beaver,
    "seahorse": seahorse,
    "centaur": fitted(centaur),
    "king": king,
}
