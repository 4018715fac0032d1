"""The tribe: children, and the folk of caves and tales."""

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
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    within,
)
from core.prior.things.characters import eyes
from core.prior.things.standing import Figure, hair


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


def troll(draw: Draw) -> Parts:
    """Hunched and heavy: a long drooping nose, big ears, tusks, wild hair, a club."""
    wide, head, leg = draw(0.62, 0.67), draw(0.43, 0.46), 0.5
    top = draw(1.42, 1.48)
    y, z = -0.52, top + 0.1
    face = y - head * 0.86
    hand = (wide + 0.52, -0.42, 0.56)
    nose = [((0, face + 0.02, z + 0.08), 0.18), ((0, face - 0.32, z), 0.19),
            ((0, face - 0.5, z - 0.28), 0.16)]  # fmt: skip
    arm = chain([((wide * 0.92, -0.06, top - 0.16), 0.27), ((wide + 0.46, 0.04, 0.98), 0.21),
                 (hand, 0.23)])  # fmt: skip
    shank = join(taper((wide * 0.5, 0.1, leg), (wide * 0.6, 0.06, 0.18), 0.29, 0.22),
                 egg((wide * 0.62, -0.14, 0.15), (0.28, 0.44, 0.17)))  # fmt: skip
    ear = chain([((head * 0.8, y + 0.06, z + 0.06), 0.14), ((head * 1.6, y + 0.12, z + 0.16), 0.17),
                 ((head * 2.15, y + 0.14, z + 0.3), 0.07)])  # fmt: skip
    tusk = limb([(0.25, face - 0.02, z - 0.34), (0.34, face - 0.08, z - 0.22),
                 (0.37, face - 0.06, z - 0.06)], 0.11, 0.07)  # fmt: skip
    x, front, grip = hand
    club = chain([((x, front, grip - 0.26), 0.12), ((x, front, grip + 0.3), 0.14),
                  ((x, front, grip + 0.8), 0.3), ((x, front, grip + 1.08), 0.29)])  # fmt: skip
    locks = [taper((u, y + v, z + w), (u * 2.3, y + v * 1.7, z + head + t), 0.2, 0.07)
             for u, v, w, t in ((0, -0.1, 0.3, 0.5), (0.2, 0.02, 0.28, 0.38),
                                (0.0, 0.24, 0.28, 0.34), (0.24, 0.3, 0.16, 0.06),
                                (0.0, 0.42, 0.08, -0.04))]  # fmt: skip
    flap = prism([(-0.3, leg + 0.16), (0.3, leg + 0.16), (0.24, 0.24), (0.0, 0.14), (-0.24, 0.24)],
                 1, 0.1, -0.5)  # fmt: skip
    return {
        "skin": join(
            blend(0.16, egg((0, 0.06, 0.86), (0.58, 0.58, 0.5)),
                  egg((0, 0, top - 0.2), (wide * 1.04, 0.5, 0.48))),
            blend(0.06, ball((0, y, z), head), egg((0, face + 0.12, z - 0.3), (0.4, 0.28, 0.2))),
            capsule((-0.28, face + 0.06, z + 0.28), (0.28, face + 0.06, z + 0.28), 0.1),
            both(join(arm, ear, shank)),
        ),
        "nose": chain(nose),
        "hair": both(join(*locks)),
        "tusks": both(tusk),
        "cloth": join(tube((0, 0.06, leg + 0.06), (0, 0.06, leg + 0.26), 0.62, 0.05), flap,
                      moved(flap, (0, 1.1, 0))),
        "club": club,
        "eyes": both(ball((0.26, face - 0.01, z + 0.13), 0.12)),
    }  # fmt: skip


def cyclops(draw: Draw) -> Parts:
    """A broad giant with a single huge eye under one horn, in a loincloth."""
    wide, head, leg = draw(0.66, 0.71), draw(0.54, 0.57), draw(0.58, 0.62)
    top = leg + draw(0.8, 0.86)
    z = top + head * 0.62
    hand = (wide + 0.44, -0.22, leg + 0.1)
    ball_at = (0, -head * 0.62, z + 0.1)
    lid = cut(ball(ball_at, 0.46), box((0, -1.4, z - 0.68), (1, 2, 1)))
    arm = chain([((wide * 0.92, 0, top - 0.16), 0.29), ((wide + 0.4, 0.02, leg + 0.44), 0.22),
                 (hand, 0.25)])  # fmt: skip
    shank = join(taper((wide * 0.52, 0, leg), (wide * 0.6, 0, 0.18), 0.3, 0.24),
                 egg((wide * 0.62, -0.14, 0.15), (0.28, 0.42, 0.17)))  # fmt: skip
    flap = prism([(-0.34, leg + 0.16), (0.34, leg + 0.16), (0.28, 0.3), (0.0, 0.18), (-0.28, 0.3)],
                 1, 0.1, 0.58)  # fmt: skip
    grin = z - head * 0.62
    horn = limb([(0, -head * 0.4, z + head * 0.72), (0, -head * 0.7, z + head + 0.12),
                 (0, -head * 0.72, z + head + 0.4)], 0.22, 0.07)  # fmt: skip
    fang = taper((0.17, -head * 0.86, grin - 0.02), (0.18, -head * 0.96, grin + 0.17), 0.09, 0.065)
    return {
        "skin": join(
            blend(0.14, egg((0, 0, leg + 0.26), (0.58, 0.54, 0.42)),
                  egg((0, -0.02, top - 0.28), (wide * 1.06, 0.52, 0.48))),
            blend(0.06, ball((0, 0, z), head), egg((0, -head * 0.34, grin), (0.46, 0.34, 0.26))),
            lid, both(join(arm, shank, taper((head * 0.9, 0, z), (head * 1.36, 0.06, z + 0.14),
                                             0.14, 0.08))),
        ),
        "cloth": join(
            tube((0, 0, leg), (0, 0, leg + 0.22), 0.62, 0.05), both(flap, 1),
            both(tube((wide + 0.42, -0.1, leg + 0.34), (wide + 0.44, -0.18, leg + 0.18), 0.3,
                      0.04)),
        ),
        "horn": join(horn, both(fang)),
        "mouth": capsule((-0.2, -head * 0.98, grin), (0.2, -head * 0.98, grin), 0.09),
        "whites": ball(ball_at, 0.4),
        "iris": ball((0, ball_at[1] - 0.22, ball_at[2]), 0.25),
        "pupils": ball((0, ball_at[1] - 0.38, ball_at[2]), 0.14),
    }  # fmt: skip


def dwarf(draw: Draw) -> Parts:
    """Short and stout: a braided beard to the belt, an iron helmet, an axe, heavy boots."""
    leg, wide, head = draw(0.4, 0.43), draw(0.52, 0.56), draw(0.43, 0.46)
    top = leg + draw(0.76, 0.8)
    f = Figure(leg, wide, top, head, (wide + 0.36, -0.3, leg + 0.28))
    r, w, z, (x, y, _) = f.head, f.wide, f.z, f.hand
    brow, belt = z + r * 0.46, leg + 0.08
    dome = cut(ball((0, 0.02, z + 0.04), r * 1.18), box((0, 0, brow - 1), (2, 2, 1)))
    ridge = cut(tube((-0.09, 0.02, z + 0.04), (0.09, 0.02, z + 0.04), r * 1.29, 0.03),
                box((0, 0, brow - 1), (2, 2, 1)))  # fmt: skip
    beard = blend(
        0.08,
        egg((0, -r * 0.62, z - r * 0.66), (r * 0.9, r * 0.6, r * 0.62)),
        taper((0, -w * 0.78, top - 0.1), (0, -w * 1.06, belt + 0.46), 0.34, 0.22),
    )
    plaits = both(taper((0.17, -w * 1.02, belt + 0.56), (0.19, -w * 1.12, belt + 0.1), 0.16, 0.13))
    knobs = both(ball((0.19, -w * 1.14, belt - 0.06), 0.16))
    blade = [(-0.1, 0.16), (-0.42, 0.4), (-0.52, 0.02), (-0.42, -0.36), (-0.1, -0.12)]
    wings = [*blade, *((-u, v) for u, v in reversed(blade))]
    axe = prism([(x + u, z + 0.06 + v) for u, v in smooth_curve(wings)], 1, 0.1, y)
    return {
        "tunic": join(
            lathe([(w * 1.06, leg - 0.1), (w * 1.0, belt + 0.1), (w * 1.02, top - 0.24),
                   (w * 0.6, top)], 0.04),
            both(taper((w * 0.86, 0, top - 0.22), f.hand, 0.25, 0.2)),
        ),
        "beard": join(beard, plaits,
                      both(taper((0.12, -r * 1.02, z - r * 0.36), (0.42, -r * 0.86, z - r * 0.62),
                                 0.15, 0.1)),
                      both(egg((r * 0.84, -0.02, z - r * 0.36), (0.18, 0.28, 0.38)))),
        "helmet": join(dome, tube((0, 0.02, brow - 0.06), (0, 0.02, brow + 0.12), r * 1.26, 0.04),
                       axe),
        "gold": join(
            box((0, -r * 1.2, brow + 0.02), (0.11, 0.12, 0.17), 0.04), ridge,
            knobs, both(ball((r * 1.18, 0.02, brow + 0.04), 0.14)),
        ),
        "skin": join(ball((0, 0, z), r), egg((0, -r * 1.04, z - r * 0.12), (0.15, 0.15, 0.12))),
        "boots": join(
            tube((0, 0, belt - 0.08), (0, 0, belt + 0.12), w * 1.12, 0.03),
            both(join(egg((w * 0.56, -0.14, 0.15), (0.25, 0.38, 0.17)),
                      tube((w * 0.54, 0, 0.06), (w * 0.54, 0, leg + 0.02), 0.23, 0.04),
                      ball(f.hand, 0.23))),
        ),
        "handle": tube((x, y, 0.14), (x, y, z + 0.34), 0.09, 0.02),
        "eyes": both(ball((r * 0.44, -r * 0.9, z + 0.04), 0.1)),
    }  # fmt: skip


def monster(draw: Draw) -> Parts:
    """A round furry fellow with horns, two big eyes, a wide toothy grin, waving arms."""
    wide, z = draw(0.8, 0.84), draw(1.16, 1.2)
    grin = z - 0.14
    shaggy = [around(9, taper((wide * k, 0, z + v), (wide * k * 1.08 + 0.08, 0, z + v - 0.22),
                              0.17, 0.06), turn)
              for k, v, turn in ((0.82, -0.4, 10), (0.95, 0.02, 30), (0.8, 0.46, 10))]  # fmt: skip
    tuft = [taper((u, 0, z + wide * 0.94), (u * 2.4, 0.02, z + wide + t), 0.15, 0.06)
            for u, t in ((0.0, 0.36), (0.14, 0.26))]  # fmt: skip
    smile = [(-0.5, grin + 0.12), (0.5, grin + 0.12), (0.42, grin - 0.16), (0.2, grin - 0.32),
             (-0.2, grin - 0.32), (-0.42, grin - 0.16)]  # fmt: skip
    mouth = within(ball((0, 0, z), wide + 0.06), prism(smile, 1, 1, -1.1))
    teeth = [prism([(u - 0.12, grin + 0.16), (u + 0.12, grin + 0.16), (u, grin - 0.15)], 1, 1, -1.1)
             for u in (0.13, 0.37)]  # fmt: skip
    horn = limb([(wide * 0.5, 0, z + wide * 0.72), (wide * 0.84, 0, z + wide * 1.02),
                 (wide * 0.86, -0.04, z + wide * 1.4)], 0.2, 0.07)  # fmt: skip
    hand = (wide + 0.5, -0.22, z + 0.32)
    return {
        "fur": join(
            ball((0, 0, z), wide), *shaggy, both(join(*tuft)),
            both(join(
                chain([((wide * 0.86, 0, z - 0.12), 0.2), ((wide + 0.36, -0.06, z - 0.12), 0.19),
                       (hand, 0.18)]),
                taper((0.36, 0, z - wide * 0.7), (0.38, -0.02, 0.24), 0.27, 0.24),
            )),
        ),
        "paws": join(
            both(egg((0.4, -0.16, 0.16), (0.3, 0.42, 0.18))),
            both(ball((hand[0], hand[1], hand[2] + 0.1), 0.23)),
        ),
        "horns": both(horn),
        "mouth": mouth,
        "teeth": within(ball((0, 0, z), wide + 0.13), both(join(*teeth))),
        "eyes": both(ball((0.25, -wide * 0.82, z + 0.4), 0.26)),
        "pupils": both(ball((0.22, -wide * 0.82 - 0.2, z + 0.4), 0.12)),
    }  # fmt: skip


TRIBE = {
    "girl": girl,
    "boy": boy,
    "baby": baby,
    "troll": troll,
    "cyclops": cyclops,
    "dwarf": dwarf,
    "monster": monster,
}
