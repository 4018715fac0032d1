"""Goblins, orcs, demons and giants."""

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
    limb,
    moved,
    prism,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.faces import cone, eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.wings_and_claws import back_wing


def goblin(draw: Draw) -> Parts:
    """A wide head with long ears and a long nose; tusks; a short tunic."""
    head, leg, wide = draw(0.48, 0.56), draw(0.45, 0.58), draw(0.36, 0.44)
    ear, nose = draw(0.42, 0.56), draw(0.26, 0.36)
    top = leg + draw(0.66, 0.78)
    z = top + head * 0.62
    hand = (wide + 0.26, -0.12, leg + 0.02)
    arm = join(taper((wide * 0.7, 0, top - 0.16), hand, 0.14, 0.12), ball(hand, 0.17))
    legs = join(
        taper((0.2, 0, leg + 0.1), (0.22, 0, 0.14), 0.15, 0.13),
        egg((0.24, -0.13, 0.12), (0.19, 0.32, 0.13)),
    )
    ears = taper((head * 0.8, 0, z + 0.02), (head + ear, 0.1, z + ear * 0.6), 0.22, 0.06)
    skull = egg((0, 0, z), (head, head * 0.85, head * 0.8))
    y = -head * 0.74
    return {
        "skin": join(
            skull,
            both(join(ears, arm, legs)),
            taper((0, y - 0.02, z + 0.04), (0, y - nose, z - 0.06), 0.13, 0.09),
        ),
        "tunic": lathe([(wide + 0.1, leg - 0.06), (wide * 0.72, top - 0.05)], 0.04),
        "eyes": eyes(0.24, y + 0.02, z + 0.14, 0.15),
        "pupils": both(ball((0.23, y - 0.1, z + 0.14), 0.085)),
        "mouth": egg((0, y + 0.08, z - 0.22), (0.34, 0.16, 0.09)),
        "teeth": both(cone((0.25, y + 0.02, z - 0.28), 0.085, 0.19)),
    }


def orc(draw: Draw) -> Parts:
    """Broad and green, bent forward: a great jaw with two tusks, a spiked plate, a club."""
    wide, leg, head = draw(0.66, 0.72), draw(0.6, 0.65), draw(0.4, 0.43)
    top = leg + draw(0.78, 0.84)
    z, y = top + 0.2, -0.3
    hand = (wide + 0.42, -0.34, leg + 0.1)
    arm = chain([((wide * 0.92, 0, top - 0.16), 0.29), ((wide + 0.36, 0.06, leg + 0.42), 0.21),
                 (hand, 0.2)])  # fmt: skip
    shank = join(
        taper((wide * 0.46, 0, leg), (wide * 0.56, 0, 0.16), 0.26, 0.2),
        egg((wide * 0.58, -0.16, 0.13), (0.24, 0.38, 0.15)),
    )
    face = y - head * 0.86
    jaw = box((0, face + 0.08, z - 0.32), (0.39, 0.27, 0.17), 0.14)
    brow = capsule((-0.28, face + 0.06, z + 0.24), (0.28, face + 0.06, z + 0.24), 0.11)
    ear = taper((head * 0.86, y + 0.05, z + 0.06), (head * 1.6, y + 0.12, z + 0.28), 0.15, 0.07)
    tusk = limb([(0.27, face - 0.14, z - 0.28), (0.31, face - 0.2, z - 0.12),
                 (0.3, face - 0.17, z + 0.02)], 0.11, 0.07)  # fmt: skip
    x, front, grip = hand
    club = chain([((x, front, grip - 0.22), 0.1), ((x, front, grip + 0.3), 0.13),
                  ((x, front, grip + 0.74), 0.28), ((x, front, grip + 0.98), 0.26)])  # fmt: skip
    spikes = [moved(turned(cone((0, 0, 0.22), 0.12, 0.26), 1, turn), (x, front, grip + up))
              for turn, up in ((70, 0.66), (90, 0.98), (-80, 0.84))]  # fmt: skip
    shoulder = (-wide * 0.98, 0, top - 0.12)
    plate = cut(ball(shoulder, 0.4), box((0, 0, top - 1.22), (3, 3, 1)))
    thorns = [moved(turned(cone((0, 0, 0.3), 0.14, 0.32), 1, turn), shoulder)
              for turn in (-62, -10)]  # fmt: skip
    flap = prism([(-0.26, leg + 0.1), (0.26, leg + 0.1), (0.2, 0.22), (-0.2, 0.22)], 1, 0.09, -0.42)
    torso = egg((0, -0.02, top - 0.3), (wide * 1.08, 0.52, 0.48))
    slash = moved(turned(box((0, 0, 0), (0.11, 2, 0.7)), 1, -48), (-0.06, 0, top - 0.34))
    return {
        "skin": join(
            blend(0.14, taper((0, 0, leg), (0, 0, leg + 0.2), 0.42, 0.46),
                  egg((0, -0.02, top - 0.3), (wide * 1.02, 0.46, 0.42))),
            blend(0.06, ball((0, y, z), head), jaw, brow),
            ball((0, face - 0.06, z + 0.02), 0.13),
            both(join(arm, ear, shank)),
        ),
        "tusks": join(both(tusk), *spikes),
        "armour": join(plate, *thorns),
        "leather": join(
            tube((0, 0, leg - 0.06), (0, 0, leg + 0.16), 0.52, 0.04), both(flap, 1),
            within(torso, slash),
            both(tube((wide + 0.39, -0.14, leg + 0.28), (wide + 0.41, -0.28, leg + 0.16), 0.25)),
        ),
        "club": club,
        "eyes": both(ball((0.2, face + 0.02, z + 0.12), 0.1)),
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


def golem(draw: Draw) -> Parts:
    """Of blocks of stone: a broad chest, a small head, great fists; its eyes and core glow."""
    wide, leg, fist = draw(0.6, 0.72), draw(0.5, 0.64), draw(0.25, 0.31)
    top, deep = leg + draw(0.92, 1.06), draw(0.36, 0.44)
    head, x = draw(0.27, 0.33), wide + 0.2
    z = top + head * 0.7
    chest = [
        (wide * 0.62, leg + 0.22), (wide, top - 0.5), (wide, top - 0.1), (wide - 0.14, top),
    ]  # fmt: skip
    limbs = join(
        box((x, 0, top - 0.2), (0.25, 0.3, 0.26), 0.05),
        box((x + 0.05, -0.08, top - 0.92), (fist, fist, 0.34), 0.05),
        box((wide * 0.52, 0, leg * 0.5), (0.24, 0.27, leg * 0.5), 0.05),
    )
    joints = join(
        box((0, 0, leg + 0.12), (wide * 0.5, deep * 0.7, 0.22)),
        both(tube((x, -0.02, top - 0.7), (x, 0, top - 0.3), 0.16)),
        tube((0, 0, top - 0.1), (0, 0, z), head * 0.7),
    )
    moss = join(
        egg((x - 0.04, 0, top + 0.05), (0.28, 0.31, 0.11)),
        egg((wide * 0.52, -0.22, 0.08), (0.24, 0.14, 0.11)),
    )
    return {
        "body": prism([*chest, *((-u, v) for u, v in reversed(chest))], 1, deep),
        "head": box((0, -0.12, z), (head, head * 0.95, head * 0.85), 0.06),
        "limbs": both(limbs),
        "joints": joints,
        "eyes": join(
            both(box((head * 0.45, -0.12 - head * 0.95, z + 0.02), (0.085, 0.06, 0.07), 0.02)),
            prism([(0, leg + 0.36), (0.17, leg + 0.56), (0, leg + 0.76), (-0.17, leg + 0.56)], 1,
                  deep + 0.07),
        ),
        "moss": both(moss),
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


def demon(draw: Draw) -> Parts:
    """Red, with horns, bat wings, hooves and a tail that ends in a point."""
    leg, wide, head = draw(0.58, 0.7), draw(0.34, 0.42), draw(0.38, 0.45)
    top, horn, out = leg + draw(0.62, 0.74), draw(0.5, 0.68), draw(0.16, 0.3)
    z, x = top + head * 0.8, wide + 0.06
    hand = (x + out, -0.16, top - 0.62)
    arm = join(taper((x, 0, top - 0.14), hand, 0.16, 0.13), ball(hand, 0.17))
    tail = limb([(0, 0.2, leg), (0, 0.66, leg * 0.5), (0, 0.98, leg * 0.8), (0, 1.02, leg + 0.3)],
                0.12, 0.09)  # fmt: skip
    dart = lathe([(0.18, leg + 0.24), (0.02, leg + 0.62)], 0.04, (0, 1.02))
    curl = limb(
        [
            (head * 0.5, 0, z + head * 0.7),
            (head * 1.1, -0.02, z + head * 0.75 + horn * 0.3),
            (head * 0.9, -0.06, z + head * 0.7 + horn),
        ],
        0.16,
        0.05,
    )
    ribs = [(0.5, 1.05, 0), (0.95, 1.5, 0), (1.25, 0.75, 0.3), (1.0, 0.3, 0.3), (0.62, 0.0, 0.26)]
    y = -head * 0.92
    shank = taper((wide * 0.55, 0, leg + 0.05), (wide * 0.6, 0.02, 0.2), 0.2, 0.14)
    return {
        "skin": join(
            taper((0, 0, leg), (0, 0, top - 0.16), wide * 0.8, wide),
            ball((0, 0, z), head),
            both(join(arm, shank)),
            tail,
        ),
        "horns": both(curl),
        "wings": both(
            join(back_wing(draw, top - 0.55, ribs), box((0, 0.3, top - 0.25), (0.2, 0.12, 0.24)))
        ),
        "hooves": join(
            both(box((wide * 0.62, -0.06, 0.13), (0.19, 0.26, 0.13), 0.06)),
            dart,
            tube((0, 0, leg - 0.08), (0, 0, leg + 0.14), wide * 0.86 + 0.04, 0.04),
        ),
        "eyes": eyes(head * 0.42, y + 0.08, z + 0.08, 0.1),
        "mouth": capsule((-0.15, y + 0.06, z - 0.14), (0.15, y + 0.06, z - 0.14), 0.085),
    }


MONSTERS_GOBLINS_AND_GIANTS = {
    "goblin": fitted(goblin),
    "orc": fitted(orc),
    "troll": troll,
    "golem": fitted(golem),
    "cyclops": cyclops,
    "demon": fitted(demon),
}
