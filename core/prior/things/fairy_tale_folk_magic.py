"""Fairy tale folk with magic, wings, a tail or four legs."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
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
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.faces import eyes, moustache, pointed_beard
from core.prior.things.shared.figure import figure, figure_with_hand, hair
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.wings_and_claws import back_wing


def wizard(draw: Draw) -> Parts:
    """A long robe with wide sleeves, a tall brimmed hat, a long beard, a staff."""
    wide, top, hat = draw(0.5, 0.62), draw(1.25, 1.4), draw(0.85, 1.1)
    head, beard = draw(0.33, 0.38), draw(0.7, 0.88)
    z, brim, reach = top + head * 0.7, draw(0.56, 0.66), draw(0.62, 0.72)
    robe = lathe(smooth_curve([(wide, 0), (wide * 0.72, 0.5), (0.3, top)]), 0.03)
    hand = (reach, -0.28, top - 0.48)
    sleeve = taper((0.26, 0, top - 0.16), (reach - 0.06, -0.22, top - 0.44), 0.14, 0.21)
    y = -head * 0.9
    staff_top = z + hat * 0.55
    return {
        "robe": join(robe, both(sleeve)),
        "hat": join(
            tube((0, 0.04, z + 0.22), (0, 0.04, z + 0.36), brim, 0.06),
            lathe([(head, z + 0.3), (head * 0.45, z + hat * 0.62), (0.02, z + 0.26 + hat)], 0.05),
        ),
        "beard": join(
            moustache((0, y - 0.06, z - 0.14), 0.2),
            pointed_beard((0, y + 0.12, z - 0.14), head * 0.8, beard),
        ),
        "skin": join(
            ball((0, 0, z), head), ball((0, y - 0.08, z - 0.02), 0.12), both(ball(hand, 0.16))
        ),
        "staff": join(
            tube((reach, -0.34, 0), (reach, -0.34, staff_top), 0.09, 0.02),
            ball((reach, -0.34, staff_top + 0.06), 0.19),
        ),
        "eyes": eyes(0.17, y + 0.05, z + 0.06, 0.09),
    }


def witch(draw: Draw) -> Parts:
    """A tall bent hat with a wide brim, a long hooked nose, a broom that stands on its brush."""
    f = figure_with_hand(draw, (0.42, -0.26, -0.48))
    r, w, (x, y, z) = f.head, f.wide, f.hand
    brim, tall, wide = r * draw(1.68, 1.78), draw(0.86, 0.94), draw(0.62, 0.68)
    brow = f.z + r * 0.62
    side = [(wide, 0.42), (w * 1.05, f.leg + 0.14), (w * 0.84, f.leg + 0.34), (w * 0.6, f.top)]
    crown = [
        ((0, 0.03, brow + 0.04), r * 0.95),
        ((0, 0.06, brow + tall * 0.55), r * 0.5),
        ((0.14, 0.1, brow + tall * 0.85), 0.15),
        ((0.42, 0.12, brow + tall), 0.08),
    ]
    face = f.z - 0.02
    nose = [
        ((0, -r * 0.9, face + 0.04), 0.15),
        ((0, -r * 1.52, face), 0.12),
        ((0, -r * 1.62, face - 0.2), 0.085),
    ]
    chin = taper((0, -r * 0.6, f.z - r * 0.7), (0, -r * 1.06, f.z - r * 0.84), 0.16, 0.09)
    lock = taper((r * 0.92, 0.06, f.z + 0.1), (r * 1.25, 0.02, f.top - 0.22), 0.2, 0.13)
    foot = taper((w * 0.5, -0.06, 0.11), (w * 0.54, -0.5, 0.11), 0.15, 0.08)
    sleeve = taper((w * 0.7, 0, f.top - 0.18), (x - 0.05, y + 0.04, z + 0.02), 0.15, 0.24)
    brush = smooth_curve([(0.12, 0.02), (0.3, 0.03), (0.27, 0.34), (0.11, 0.6)])
    return {
        "dress": join(lathe(side, 0.04), both(sleeve)),
        "hat": join(
            chain(crown),
            lathe([(brim, brow + 0.02), (r * 1.0, brow + 0.12)], 0.05),
            both(join(foot, tube((w * 0.5, 0, 0.05), (w * 0.5, 0, 0.5), 0.18, 0.04))),
        ),
        "skin": join(ball((0, 0, f.z), r), chain(nose), chin, f.hands(0.16)),
        "hair": join(
            both(lock),
            egg((0, r * 0.5, f.z - 0.2), (r * 0.95, r * 0.62, r * 1.15)),
            tube((0, 0.03, brow + 0.1), (0, 0.03, brow + 0.28), r * 0.98, 0.02),
            tube((0, 0, f.leg + 0.2), (0, 0, f.leg + 0.38), w * 1.06, 0.03),
        ),
        "broom": join(
            lathe(brush, 0.03, (x, y - 0.1)),
            tube((x, y - 0.1, 0.5), (x, y - 0.1, f.z + 0.16), 0.09, 0.02),
        ),
        "eyes": both(ball((r * 0.42, -r * 0.88, f.z + 0.12), 0.1)),
    }


def fairy(draw: Draw) -> Parts:
    """In a wide dress, with four wings, a knot of hair, a wand with a star."""
    f = figure(draw)
    r, wing = f.head, draw(0.62, 0.76)
    hem = f.leg * 0.62
    skirt = lathe([(f.wide * draw(1.5, 1.8), hem), (f.wide * 0.66, f.leg + 0.26)], 0.05)
    bodice = taper((0, 0, f.leg + 0.2), (0, 0, f.top - 0.24), f.wide * 0.7, f.wide * 0.78)
    y = f.wide * 0.68
    upper = moved(
        turned(egg((wing * 0.8, 0, 0), (wing, 0.09, wing * 0.52)), 1, -32), (0.06, y, f.top - 0.3)
    )
    lower = moved(
        turned(egg((wing * 0.62, 0, 0), (wing * 0.76, 0.09, wing * 0.4)), 1, 26),
        (0.06, y, f.top - 0.4),
    )
    x, py, pz = f.hand
    star = [
        (0.0, 0.3),
        (0.085, 0.115),
        (0.285, 0.093),
        (0.135, -0.045),
        (0.176, -0.243),
        (0, -0.14),
    ]
    star = [*star, *((-a, b) for a, b in reversed(star[1:-1]))]
    tip = pz + 0.62
    wand = prism([(x + a, tip + 0.12 + b) for a, b in star], 1, 0.09, py)
    return {
        "dress": join(skirt, bodice),
        "skin": join(f.skull(), f.sleeves(-0.03), f.hands(0.15), f.legs(-0.04)),
        "wings": both(join(upper, lower)),
        "hair": join(hair(f, draw(0.5, 1.1)), ball((0, 0.08, f.z + r * 1.16), r * 0.42)),
        "wand": join(capsule((x, py, pz - 0.08), (x, py, tip), 0.065), wand, f.shoes(0.16)),
        "eyes": f.eyes(),
    }


def mermaid(draw: Draw) -> Parts:
    """Upright on her flukes: a scaled tail, long hair, a top of shells."""
    waist, hip, head = draw(0.21, 0.26), draw(0.34, 0.4), draw(0.35, 0.41)
    low, long, span = draw(0.3, 0.38), draw(0.75, 0.9), draw(0.56, 0.7)
    belt = low + long
    top, out = belt + draw(0.56, 0.66), draw(0.12, 0.22)
    z, y = top + head * 0.92, -head * 0.92
    tail = smooth_curve([(0.15, low - 0.12), (0.2, low + long * 0.24), (hip, low + long * 0.74),
                         (waist + 0.07, belt)])  # fmt: skip
    fluke = prism([(0, low + 0.08), (0.3, low - 0.02), (span, low + 0.06), (span + 0.06, low - 0.1),
                   (span * 0.72, 0.02), (0.2, 0), (0, 0.1)], 1, 0.13)  # fmt: skip
    hand = (hip + out, -0.14, belt - 0.02)
    elbow = (hip + out + 0.08, 0.02, belt + 0.24)
    arm = join(
        taper((0.26, 0, top - 0.12), elbow, 0.13, 0.11), taper(elbow, hand, 0.11, 0.1),
        ball(hand, 0.14),
    )  # fmt: skip
    cap = cut(ball((0, 0.04, z + 0.05), head * 1.12), box((0, -0.68, z - 0.18), (2, 0.56, 0.38)))
    locks = join(
        egg((0, 0.2, z - 0.34), (head * 1.2, 0.24, head * 1.7)),
        both(taper((head * 0.86, 0.02, z - 0.1), (head * 0.84, -0.06, top - 0.3), 0.18, 0.12)),
    )
    return {
        "tail": lathe(tail, 0.02),
        "fins": join(
            both(fluke), lathe([(waist + 0.1, belt - 0.07), (waist + 0.1, belt + 0.07)], 0.03)
        ),
        "skin": join(
            lathe(smooth_curve([(waist, belt - 0.05), (waist, belt + 0.2), (0.29, top - 0.2),
                                (0.12, top)]), 0.02),
            tube((0, 0, top - 0.06), (0, 0, z), 0.13),
            ball((0, 0, z), head),
            both(arm),
            ball((0, y - 0.03, z - 0.05), 0.085),
        ),
        "hair": join(cap, locks),
        "top": both(egg((0.145, -0.2, top - 0.24), (0.16, 0.16, 0.14))),
        "eyes": both(egg((head * 0.42, -head * 0.88, z + 0.03), (0.07, 0.07, 0.1))),
    }  # fmt: skip


def angel(draw: Draw) -> Parts:
    """A long robe, feathered wings, a halo, hands folded."""
    wide, top, head = draw(0.5, 0.6), draw(1.15, 1.3), draw(0.36, 0.42)
    z = top + head * 0.75
    halo, high = draw(0.3, 0.36), z + head + draw(0.18, 0.26)
    y = -head * 0.92
    sleeve = taper((0.3, 0, top - 0.16), (0.1, -0.4, top - 0.44), 0.15, 0.15)
    cap = cut(ball((0, 0.04, z + 0.05), head * 1.1), box((0, -0.66, z - 0.16), (2, 0.56, 0.36)))
    curls = egg((0, 0.14, z - 0.2), (head * 1.12, 0.26, head))
    feathers = [(0.42, 1.0, 0), (0.85, 1.25, 0), (1.15, 1.1, 0), (1.25, 0.62, 0.26),
                (1.02, 0.26, 0.26), (0.66, -0.06, 0.2)]  # fmt: skip
    return {
        "robe": join(
            lathe(smooth_curve([(wide, 0), (wide * 0.66, 0.55), (0.3, top)]), 0.03), both(sleeve)
        ),
        "wings": both(
            join(back_wing(draw, top - 0.6, feathers), box((0, 0.3, top - 0.3), (0.2, 0.12, 0.26)))
        ),
        "skin": join(ball((0, 0, z), head), egg((0, -0.46, top - 0.4), (0.13, 0.14, 0.19)),
                     ball((0, y - 0.04, z - 0.04), 0.085)),
        "hair": join(cap, curls),
        "halo": join(
            ring((0, 0, high), halo, 0.09), tube((0, halo, high), (0, halo * 0.7, z + 0.2), 0.085)
        ),
        "eyes": eyes(head * 0.42, -head * 0.86, z + 0.03, 0.085),
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


FAIRY_TALE_FOLK_MAGIC = {
    "wizard": fitted(wizard),
    "witch": witch,
    "fairy": fairy,
    "mermaid": fitted(mermaid),
    "angel": fitted(angel),
    "centaur": fitted(centaur),
}
