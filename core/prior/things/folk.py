"""People of tales and of the town: who flies on brooms, rules, helps, haunts and howls."""

import math

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
    tube,
    turned,
    within,
)
from core.prior.things.animals import fitted
from core.prior.things.characters import cone
from core.prior.things.standing import Figure, hair


def _figure(draw: Draw, hand: Vector) -> Figure:
    """Someone who stands; ``hand`` is counted from the side of the left shoulder."""
    leg, wide, head = draw(0.62, 0.67), draw(0.4, 0.43), draw(0.39, 0.42)
    top = leg + draw(0.74, 0.8)
    return Figure(leg, wide, top, head, (wide + hand[0], hand[1], top + hand[2]))


def witch(draw: Draw) -> Parts:
    """A tall bent hat with a wide brim, a long hooked nose, a broom that stands on its brush."""
    f = _figure(draw, (0.42, -0.26, -0.48))
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


def queen(draw: Draw) -> Parts:
    """A gown that widens to the ground, a high collar behind the head, a crown, a sceptre."""
    f = _figure(draw, (0.36, -0.32, -0.46))
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


def firefighter(draw: Draw) -> Parts:
    """A tan coat and trousers with bright bands, a red helmet with a brim and a crest, an axe."""
    f = _figure(draw, (0.34, -0.34, -0.52))
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


def police_officer(draw: Draw) -> Parts:
    """In navy with a peaked cap, a golden badge on the cap and the chest, a belt with pouches."""
    f = _figure(draw, (0.22, -0.1, -0.66))
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


def mummy(draw: Draw) -> Parts:
    """Wrapped in bandages that cross, its arms stretched forward; eyes in a dark gap."""
    f = _figure(draw, (0.0, 0.0, 0.0))
    r, w = f.head, f.wide
    reach, x, up = draw(0.84, 0.92), w * 0.98, f.top - 0.2
    hand = (x, -reach, up + 0.04)
    body = lathe([(w * 0.78, f.leg), (w * 0.8, f.leg + 0.2), (w * 1.04, f.top - 0.24),
                  (w * 0.6, f.top)], 0.05)  # fmt: skip

    def band(at: Vector, radius: float, tilt: float, axis: int = 1, half: float = 0.085) -> Solid:
        """A slanting ring about the vertical."""
        flat = tube((0, 0, -half), (0, 0, half), radius, 0.03)
        return moved(turned(flat, axis, tilt), at)

    arm_bands = [tube((x, -reach * k, up + 0.02), (x, -reach * k - 0.16, up + 0.04), 0.225, 0.02)
                 for k in (0.36, 0.76)]  # fmt: skip
    leg_bands = [band((w * 0.5, 0, v), 0.27, s) for v, s in ((0.26, 14), (0.58, -14))]
    gap = within(ball((0, 0, f.z), r * 1.03), box((0, -1, f.z + 0.04), (0.5, 0.86, 0.15)))
    tail = [(x, -reach + 0.04, up - 0.1), (x + 0.03, -reach + 0.04, up - 0.46)]
    return {
        "bandages": join(
            ball((0, 0, f.z), r), body, f.legs(0.03), f.shoes(0.2),
            both(join(taper((w * 0.86, 0, up), hand, 0.19, 0.16), ball(hand, 0.2))),
        ),
        "bands": join(
            band((0, 0, f.leg + 0.1), w * 0.94, 16),
            band((0, 0, f.leg + 0.4), w * 1.05, -16),
            band((0, 0, f.top - 0.1), w * 0.98, 14),
            band((0, 0, f.z + r * 0.62), r * 0.92, -14),
            band((0, 0, f.z - r * 0.5), r * 1.0, 12),
            both(join(*arm_bands, *leg_bands)),
            prism([(x - 0.12, tail[0][2]), (x + 0.12, tail[0][2]), (x + 0.14, up - 0.52),
                   (x - 0.1, up - 0.44)], 1, 0.08, -reach + 0.02),
        ),
        "gap": gap,
        "eyes": both(ball((r * 0.4, -r * 0.93, f.z + 0.04), 0.12)),
    }  # fmt: skip


def werewolf(draw: Draw) -> Parts:
    """An upright wolf with a man's broad chest, long clawed arms, in torn trousers."""
    wide, leg, head = draw(0.56, 0.61), draw(0.78, 0.84), draw(0.37, 0.4)
    top = leg + draw(0.72, 0.78)
    z, y = top + 0.26, -0.26
    hand = (wide + 0.44, -0.4, leg + 0.12)
    arm = chain([((wide * 0.92, 0, top - 0.16), 0.25), ((wide + 0.38, 0.08, leg + 0.42), 0.19),
                 (hand, 0.19)])  # fmt: skip
    thigh = (wide * 0.48, -0.06, leg)
    knee, heel = (wide * 0.58, -0.2, leg * 0.52), (wide * 0.58, 0.12, 0.3)
    paw = egg((wide * 0.6, -0.16, 0.13), (0.21, 0.34, 0.14))
    shank = join(taper(knee, heel, 0.2, 0.14), taper(heel, (wide * 0.6, -0.02, 0.14), 0.14, 0.14),
                 paw)  # fmt: skip
    x, front, low = hand
    claws = [taper((x + u, front - 0.12, low - 0.08), (x + u * 1.5, front - 0.22, low - 0.3), 0.09,
                   0.06) for u in (-0.14, 0.14)]  # fmt: skip
    toes = [taper((wide * 0.6 + u, -0.44, 0.1), (wide * 0.6 + u, -0.6, 0.07), 0.09, 0.065)
            for u in (-0.12, 0.12)]  # fmt: skip
    tears = around(6, prism([(-0.15, leg * 0.3), (0.15, leg * 0.3), (0, leg * 0.62)], 0, 1), 15)
    cuff = cut(lathe([(0.29, leg * 0.4), (0.3, leg * 0.8)], 0.03), tears)
    face = y - head * 0.8
    snout = prism([(face + 0.2, z + 0.14), (face - 0.16, z + 0.1), (face - 0.5, z + 0.02),
                   (face - 0.52, z - 0.14), (face - 0.1, z - 0.2), (face + 0.2, z - 0.2)],
                  0, 0.16)  # fmt: skip
    jaw = taper((0, face + 0.14, z - 0.3), (0, face - 0.34, z - 0.38), 0.15, 0.1)
    fang = taper((0.14, face - 0.4, z - 0.1), (0.14, face - 0.4, z - 0.3), 0.085, 0.05)
    ear = prism([(head * 0.22, z + head * 0.6), (head * 1.02, z + head * 0.3),
                 (head * 0.9, z + head + 0.18)], 1, 0.1, y + 0.06)  # fmt: skip
    ruff = both(
        taper((head * 0.6, y + 0.04, z - 0.1), (head * 1.35, y + 0.1, z - 0.32), 0.22, 0.08)
    )
    tail = limb([(0, 0.3, leg + 0.05), (0, 0.66, leg - 0.1), (0, 0.86, leg - 0.4)], 0.17, 0.1)
    torso = blend(0.14, taper((0, 0, leg + 0.1), (0, 0, leg + 0.3), 0.36, 0.4),
                  egg((0, 0, top - 0.3), (wide, 0.46, 0.42)))  # fmt: skip
    return {
        "fur": join(
            torso, ball((0, y, z), head), taper((0, 0.1, top - 0.2), (0, y, z), 0.42, head * 0.9),
            both(join(arm, shank, ear)), ruff, tail,
        ),
        "muzzle": join(snout, jaw, egg((0, -0.2, top - 0.36), (wide * 0.6, 0.34, 0.36))),
        "trousers": join(
            lathe([(0.42, leg - 0.16), (0.44, leg + 0.14)], 0.04),
            both(join(taper(thigh, (knee[0], knee[1], knee[2] + 0.12), 0.29, 0.26),
                      moved(cuff, (knee[0], knee[1] + 0.04, 0.06)))),
        ),
        "claws": both(join(*claws, *toes, fang)),
        "eyes": both(ball((head * 0.46, face + 0.04, z + 0.16), 0.1)),
        "nose": ball((0, face - 0.52, z + 0.02), 0.12),
    }  # fmt: skip


def grim_reaper(draw: Draw) -> Parts:
    """A skull in the hood of a long black robe, hands of bone, a scythe taller than itself."""
    wide, top, head = draw(0.62, 0.67), draw(1.4, 1.46), draw(0.36, 0.39)
    z, hood = top + 0.28, draw(0.58, 0.62)
    hand = (0.82, -0.4, top - 0.42)
    robe = lathe(smooth_curve([(wide, 0.02), (wide * 0.76, 0.7), (wide * 0.74, top - 0.24),
                               (0.3, top + 0.02)]), 0.03)  # fmt: skip
    cowl = join(
        ball((0, 0.06, z + 0.02), hood),
        taper((0, 0.06, z + 0.1), (0, 0.3, z + hood + 0.12), hood * 0.8, 0.1),
        taper((0, 0.02, z - 0.2), (0, 0, top - 0.16), hood * 0.86, 0.52),
    )
    hollow = egg((0, -hood * 0.86, z - 0.02), (hood * 0.72, hood * 0.86, hood * 0.86))
    sleeve = taper((0.42, 0, top - 0.2), (0.74, -0.3, top - 0.44), 0.2, 0.27)
    face = -0.22
    skull = join(
        ball((0, face, z + 0.04), head),
        box((0, face - head * 0.36, z - head * 0.78), (head * 0.56, head * 0.5, 0.17), 0.05),
    )
    sockets = both(egg((head * 0.42, face - head * 0.8, z + 0.02), (0.125, 0.14, 0.14)))
    nose = prism([(-0.1, z - 0.24), (0.1, z - 0.24), (0, z - 0.06)], 1, 0.1, face - head * 0.92)
    x, y = -hand[0], hand[1] - 0.1
    high = z + hood + 0.3
    outer = [(x - 0.1, high + 0.14), (x + 0.42, high + 0.2), (x + 0.9, high + 0.02),
             (x + 1.24, high - 0.46)]  # fmt: skip
    inner = [(x + 0.8, high - 0.2), (x + 0.38, high - 0.08), (x - 0.1, high - 0.14)]
    blade = [*smooth_curve(outer), *smooth_curve(inner)]
    return {
        "robe": join(robe, cut(cowl, hollow), both(sleeve)),
        "hood": ball((0, 0.1, z), hood * 0.86),
        "bone": join(skull, both(ball((hand[0] - 0.02, hand[1], hand[2] - 0.04), 0.19))),
        "eyes": join(sockets, nose),
        "handle": tube((x, y, 0.02), (x, y, high + 0.16), 0.095, 0.03),
        "blade": prism(blade, 1, 0.085, y),
    }


FOLK = {
    "witch": witch,
    "queen": queen,
    "firefighter": firefighter,
    "police officer": police_officer,
    "orc": fitted(orc),
    "mummy": mummy,
    "werewolf": fitted(werewolf),
    "grim reaper": fitted(grim_reaper),
}
