"""Children and a doll."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
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
    tilted,
    tube,
    within,
)
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.figure import Figure, hair


def _child(draw: Draw) -> Figure:
    """Someone small, a quarter of whom is head."""
    leg, wide, head = draw(0.66, 0.7), draw(0.33, 0.35), draw(0.5, 0.53)
    top = leg + draw(0.62, 0.66)
    return Figure(leg, wide, top, head, (wide + 0.34, -0.12, top - 0.4))


def _bare(f: Figure) -> Solid:
    """A child's head with nose and ears, its arms and legs."""
    shoulder = (f.wide * 0.8, 0, f.top - 0.17)
    return join(
        ball((0, 0, f.z), f.head),
        ball(f.face(-0.12, 0.02), 0.09),
        both(ball((f.head * 0.98, -0.02, f.z - 0.06), 0.13)),
        both(join(taper(shoulder, f.hand, 0.13, 0.12), ball(f.hand, 0.16))),
        both(taper((0.24, 0, f.leg + 0.1), (0.26, 0, 0.14), 0.15, 0.13)),
        tube((0, 0, f.top - 0.1), (0, 0, f.z), 0.16),
    )


def _shoes() -> Solid:
    """A child's, wide apart."""
    return both(join(egg((0.27, -0.1, 0.13), (0.19, 0.31, 0.15)), ball((0.26, 0.02, 0.15), 0.17)))


def _child_eyes(f: Figure) -> Solid:
    """Upright ovals, large and low in the face."""
    r = f.head
    return both(egg((r * 0.4, -r * 0.9, f.z + 0.02), (0.085, 0.08, 0.125)))


def girl(draw: Draw) -> Parts:
    """A child in a dress that flares, her hair in two pigtails with bows."""
    f = _child(draw)
    r, w, z = f.head, f.wide, f.z
    wide, hem = draw(0.58, 0.62), f.leg - 0.03
    side = [(wide, hem), (wide * 0.84, f.leg + 0.12), (w * 0.86, f.leg + 0.34),
            (w * 0.96, f.top - 0.2), (w * 0.6, f.top)]  # fmt: skip
    tail = [((r * 0.95, 0.08, z + r * 0.34), 0.14), ((r * 1.46, 0.08, z + r * 0.2), 0.21),
            ((r * 1.68, 0.06, z - r * 0.3), 0.23), ((r * 1.6, 0.04, z - r * 0.72), 0.17),
            ((r * 1.44, 0.0, z - r * 1.04), 0.08)]  # fmt: skip
    loop = taper((r * 1.16, -0.04, z + r * 0.46), (r * 1.3, -0.1, z + r * 0.84), 0.09, 0.15)
    loops = join(loop, taper((r * 1.16, -0.04, z + r * 0.46), (r * 1.12, -0.3, z + r * 0.2),
                             0.09, 0.14))  # fmt: skip
    return {
        "dress": join(
            lathe(smooth_curve(side), 0.03), both(ball((w * 0.88, 0, f.top - 0.17), 0.2))
        ),
        "trim": join(
            lathe([(wide + 0.05, hem - 0.06), (wide + 0.02, hem + 0.07)], 0.04),
            both(egg((0.15, -w * 0.7, f.top - 0.08), (0.17, 0.17, 0.11))),
            tube((0, 0, f.leg + 0.27), (0, 0, f.leg + 0.4), w * 0.86 + 0.09, 0.03),
        ),
        "skin": _bare(f),
        "hair": join(hair(f), both(chain(tail))),
        "bows": both(join(ball((r * 1.14, -0.02, z + r * 0.44), 0.15), loops)),
        "shoes": _shoes(),
        "eyes": _child_eyes(f),
    }


def boy(draw: Draw) -> Parts:
    """A child in a cap, a T-shirt with a broad stripe, shorts and trainers."""
    f = _child(draw)
    r, w, z = f.head, f.wide, f.z
    brim = z + r * draw(0.38, 0.43)
    dome = cut(ball((0, 0.02, z + 0.06), r * 1.16), box((0, 0, brim - 1), (2, 2, 1)))
    peak = within(
        tilted(tube((0, 0, -0.065), (0, 0, 0.065), r * 0.8, 0.03), 6, (0, -r * 0.74, brim + 0.06)),
        box((0, -2 - r * 0.5, brim), (2, 2, 1)),
    )
    shoulder = (w * 0.8, 0, f.top - 0.17)
    x, y, hand = f.hand
    elbow = ((shoulder[0] + x) / 2, y / 2, (shoulder[2] + hand) / 2)
    chest = f.leg + 0.3
    return {
        "shirt": join(
            lathe([(w * 1.0, f.leg + 0.1), (w * 1.0, f.top - 0.22), (w * 0.56, f.top)], 0.04),
            both(taper(shoulder, elbow, 0.2, 0.19)),
        ),
        "stripe": tube((0, 0, chest - 0.08), (0, 0, chest + 0.08), w + 0.09, 0.03),
        "shorts": join(
            tube((0, 0, f.leg - 0.06), (0, 0, f.leg + 0.16), w * 1.04, 0.05),
            both(tube((0.25, 0, f.leg + 0.06), (0.28, 0, 0.45), 0.215, 0.04)),
        ),
        "cap": join(dome, peak, ball((0, 0.02, z + 0.06 + r * 1.16), 0.09)),
        "skin": _bare(f),
        "hair": cut(hair(f), box((0, 0, brim + 1.05), (2, 2, 1))),
        "shoes": _shoes(),
        "eyes": _child_eyes(f),
    }


def baby(draw: Draw) -> Parts:
    """It sits in its diaper, legs forward: a great head, one curl of hair, a pacifier."""
    head, z = draw(0.66, 0.7), draw(1.42, 1.48)
    wide = draw(0.44, 0.48)
    y = -0.08
    mouth = (0, y - head * 0.88, z - head * 0.42)
    leg = chain([((0.3, -0.2, 0.26), 0.24), ((0.58, -0.6, 0.24), 0.2), ((0.56, -0.8, 0.2), 0.16)])
    hand = (wide + 0.34, -0.36, 0.66)
    curl = [((0, y, z + head * 0.88), 0.17), ((0, y - 0.02, z + head + 0.16), 0.14),
            ((0, y - 0.2, z + head + 0.26), 0.11),
            ((0, y - 0.34, z + head + 0.16), 0.08)]  # fmt: skip
    return {
        "skin": join(
            egg((0, 0.02, 0.62), (wide, wide * 0.92, 0.56)),
            egg((0, y, z), (head * 1.06, head * 0.98, head * 0.96)),
            ball((0, y - head * 0.98, z - 0.08), 0.1),
            both(join(
                ball((head * 1.03, y + 0.04, z - 0.08), 0.17),
                leg, egg((0.58, -0.9, 0.28), (0.17, 0.15, 0.24)),
                taper((wide * 0.8, -0.06, 0.92), hand, 0.17, 0.14), ball(hand, 0.17),
            )),
        ),
        "diaper": cut(egg((0, 0.02, 0.36), (0.62, 0.58, 0.46)), box((0, 0, 1.56), (2, 2, 1)),
                      box((0, 0, -1), (2, 2, 1))),
        "hair": chain(curl),
        "pacifier": join(
            tube(mouth, (0, mouth[1] - 0.14, mouth[2]), 0.2, 0.05),
            ball((0, mouth[1] - 0.18, mouth[2]), 0.12),
        ),
        "eyes": eyes(head * 0.46, y - head * 0.84, z + 0.04, 0.12),
    }  # fmt: skip


def doll(draw: Draw) -> Parts:
    """A great head with plaits or curls, button eyes, a bell of a dress, short arms and legs."""
    r, leg, wide = draw(0.5, 0.58), draw(0.64, 0.76), draw(0.54, 0.64)
    plaits, waist = draw.chance(0.5), leg + draw(0.42, 0.52)
    top = waist + 0.3
    z, x = top + r * 0.84, draw(0.2, 0.24)
    skirt = smooth_curve([(wide, leg - 0.1), (wide * 0.76, leg + 0.14), (0.26, waist), (0.24, top)])
    hand = (wide + draw(0.06, 0.2), -0.1, waist - 0.02)
    sleeve = taper((0.2, 0, top - 0.1), (0.42, -0.03, waist + 0.12), 0.16, 0.2)
    face = egg((0, -r * 0.72, z - r * 0.14), (r * 0.86, r * 0.8, r * 0.72))
    cap = cut(ball((0, 0.03, z + 0.04), r * 1.1), face)
    if plaits:
        beads = [
            ((r * (1.06 + 0.14 * k), 0.04, z - 0.06 - 0.24 * k), 0.2 - 0.025 * k) for k in range(4)
        ]
        locks = join(*(ball(at, size) for at, size in beads))
        tie = (r * 1.02, 0.0, z + 0.1)
    else:
        locks = join(
            *(
                egg((r * c, r * s, z - 0.3), (0.19, 0.19, 0.36))
                for c, s in ((0.92, -0.1), (0.86, 0.4), (0.34, 0.86))
            )
        )
        tie = (r * 0.56, -r * 0.42, z + r * 0.86)
    u, _, w = tie
    bow = prism([(0.02, 0.0), (0.24, 0.17), (0.24, -0.17)], 1, 0.09)
    knot = moved(join(both(bow), ball((0, 0, 0), 0.11)), (0, 0, 0))
    ribbon = moved(knot, (u, tie[1] - 0.1, w))
    cheek = ball((0, -r * 0.98, z - r * 0.2), 0.075)
    bib = within(
        lathe([(v + 0.05, h) for v, h in skirt]),
        join(box((0, -1, leg), (wide * 0.5, 1, 0.5)), box((0, -1, top - 0.2), (0.17, 1, 0.24))),
    )
    eye = egg((r * 0.36, -r * 0.88, z + 0.04), (0.11, 0.12, 0.13))
    hem = ring((0, 0, leg - 0.07), wide - 0.01, 0.085)
    foot = egg((x, -0.1, 0.11), (0.17, 0.27, 0.13))
    return {
        "dress": join(lathe(skirt, 0.02), both(sleeve)),
        "skin": join(
            ball((0, 0, z), r),
            both(taper((0.4, -0.03, waist + 0.14), hand, 0.12, 0.13)),
            both(capsule((x, 0, leg), (x, 0, 0.16), 0.13)),
            cheek,
        ),
        "hair": join(cap, both(locks)),
        "eyes": both(eye),
        "apron": join(bib, hem, ring((0, 0, top), 0.22, 0.09)),
        "shoes": join(both(foot), both(ribbon)),
    }


PEOPLE_CHILDREN = {
    "girl": girl,
    "boy": boy,
    "baby": baby,
    "doll": doll,
}
