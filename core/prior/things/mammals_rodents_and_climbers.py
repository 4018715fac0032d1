"""Rodents, marsupials, a gorilla, a sloth, a hedgehog and a bat."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    egg,
    join,
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
)
from core.prior.things.shared.faces import cone, eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import sitting


def kangaroo(draw: Draw) -> Parts:
    """Upright on long feet and a thick tail; tall ears, short arms, a young one in the pouch."""
    wide, head, ear = draw(0.36, 0.43), draw(0.28, 0.32), draw(0.26, 0.36)
    hip, y, z = 0.62, -0.36, draw(1.68, 1.85)
    thigh = egg((wide * 0.9, 0.12, hip - 0.04), (0.22, 0.44, 0.42))
    foot = taper((wide * 0.95, 0.22, 0.13), (wide * 0.95, -0.62, 0.1), 0.16, 0.13)
    arm = limb([(0.26, -0.2, 1.22), (0.36, -0.42, 0.98), (0.3, -0.66, 1.06)], 0.13, 0.1)
    tail = limb([(0, 0.25, hip - 0.05), (0, 0.8, 0.3), (0, 1.4, draw(0.15, 0.22))], 0.34, 0.12)
    trunk = limb([(0, 0.12, hip), (0, -0.04, 1.05), (0, -0.2, 1.4), (0, y, z)], wide * 1.02, 0.2)
    face = taper((0, y, z), (0, y - 0.36, z - 0.12), head, 0.15)
    flap = taper(
        (head * 0.5, y + 0.08, z + head * 0.6), (head * 0.95, y + 0.12, z + head + ear), 0.15, 0.09
    )
    baby = (0, -wide - 0.06, hip + draw(0.42, 0.5))
    young = join(
        ball(baby, 0.18),
        both(taper((0.08, baby[1], baby[2] + 0.12), (0.14, baby[1], baby[2] + 0.3), 0.08, 0.075)),
    )
    return {
        "body": join(blend(0.15, trunk, tail), face, both(join(thigh, foot, arm, flap)), young),
        "belly": egg((0, -0.24, hip + 0.1), (wide * 0.78, wide * 0.88, 0.4)),
        "eyes": both(
            join(
                ball((head * 0.78, y - 0.12, z + 0.1), 0.085),
                ball((0.09, baby[1] - 0.14, baby[2] + 0.05), 0.07),
            )
        ),
        "nose": ball((0, y - 0.5, z - 0.1), 0.1),
    }


def koala(draw: Draw) -> Parts:
    """Sits: great round ears, a long black nose, a pale front."""
    wide, head = draw(0.46, 0.54), draw(0.48, 0.55)
    z = 0.98 + head * draw(0.76, 0.86)
    trunk, arms, legs = sitting(wide, z, head, draw(-0.02, 0.1))
    r, x, up = draw(0.29, 0.35), head * 1.18, z + head * 0.5
    y = -head * 0.86
    return {
        "body": join(trunk, arms, legs, both(egg((x, 0.02, up), (r, 0.16, r)))),
        "ears": both(egg((x + 0.02, -0.1, up - 0.02), (r * 0.68, 0.12, r * 0.68))),
        "belly": join(
            egg((0, -wide * 0.36, 0.56), (wide * 0.72, wide * 0.68, 0.5)),
            egg((0, y + 0.04, z - head * 0.46), (0.24, 0.16, 0.14)),
        ),
        "eyes": both(ball((head * 0.48, y + 0.02, z + 0.08), 0.085)),
        "nose": egg((0, y - 0.12, z - 0.08), (0.13, 0.11, draw(0.19, 0.23))),
    }


def sloth(draw: Draw) -> Parts:
    """It hangs below a branch by its long arms; dark marks at its eyes, a broad pale face."""
    wide, long, head = draw(0.38, 0.44), draw(0.5, 0.6), draw(0.38, 0.43)
    z, low, out = 1.6, 0.62, draw(1.1, 1.25)
    x, y, up = -long - 0.12, -0.14, low + 0.2
    face = y - head * 0.7

    def grip(side: float, root: float) -> Solid:
        return taper(
            (root, side * 0.3, low + 0.2), (root * 1.25, side * 0.24, z - 0.06), 0.18, 0.14
        )

    def claws(side: float, at: float) -> Solid:
        return join(
            *(
                capsule((at + u, side * 0.26, z - 0.1), (at + u, side * 0.1, z + 0.16), 0.085)
                for u in (-0.17, 0, 0.17)
            )
        )

    roots = (-long * 0.8, long * 0.8)
    marks = both(
        taper((head * 0.34, face - 0.04, 0.06), (head * 0.8, face + 0.12, -0.06), 0.13, 0.1)
    )
    return {
        "body": join(
            egg((0, 0, low), (long + 0.24, wide, wide)),
            ball((x, y, up), head),
            *(grip(side, root) for side in (-1, 1) for root in roots),
        ),
        "face": egg((x, face + 0.1, up), (head * 0.86, 0.26, head * 0.76)),
        "marks": moved(marks, (x, 0, up + 0.04)),
        "claws": join(*(claws(side, root * 1.25) for side in (-1, 1) for root in roots)),
        "branch": tube((-out, 0, z), (out, 0, z), 0.14, 0.04),
        "eyes": join(
            moved(both(ball((head * 0.38, face - 0.15, 0), 0.085)), (x, 0, up + 0.09)),
            egg((x, face - 0.14, up - 0.08), (0.13, 0.12, 0.085)),
        ),
    }


def gorilla(draw: Draw) -> Parts:
    """On its knuckles: mighty arms and shoulders, a silver back, a high crown, a heavy brow."""
    wide, head, arm = draw(0.54, 0.64), draw(0.36, 0.42), draw(0.24, 0.28)
    z, y = draw(1.2, 1.34), -0.62
    up = z + 0.3
    fist = (wide + 0.26, -0.66, 0.2)
    elbow = (wide + 0.32, -0.4, 0.66)
    reach = chain([((wide * 0.86, -0.36, z), arm + 0.08), (elbow, arm), (fist, arm * 0.84)])
    leg = chain([((0.34, 0.62, 0.7), 0.36), ((0.44, 0.42, 0.4), 0.27), ((0.44, 0.52, 0.16), 0.17)])
    face = y - head * 0.72
    return {
        "body": join(
            blend(
                0.2,
                egg((0, -0.2, z - 0.06), (wide, 0.54, 0.54)),
                egg((0, 0.5, z - 0.42), (wide * 0.86, 0.5, 0.48)),
            ),
            ball((0, y, up), head),
            egg((0, y + 0.12, up + head * 0.66), (head * 0.62, head * 0.78, head * 0.72)),
            both(join(reach, leg)),
            capsule(
                (-head * 0.62, face - 0.02, up + 0.13), (head * 0.62, face - 0.02, up + 0.13), 0.13
            ),
        ),
        "face": join(
            egg((0, face + 0.02, up - 0.16), (head * 0.68, 0.26, head * 0.56)),
            egg((0, face + 0.08, up + 0.02), (head * 0.84, 0.2, 0.2)),
            both(ball((head * 1.0, y + 0.06, up + 0.02), 0.12)),
            both(egg((fist[0] - 0.02, fist[1] - 0.1, 0.16), (0.2, 0.2, 0.16))),
            both(egg((0.44, 0.34, 0.11), (0.18, 0.34, 0.12))),
        ),
        "back": egg((0, 0.46, z - 0.3), (wide * 0.8, 0.5, 0.44)),
        "eyes": eyes(head * 0.36, face - 0.06, up + 0.01, 0.08),
        "nostrils": both(ball((0.1, face - 0.22, up - 0.1), 0.08)),
    }


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


def squirrel(draw: Draw) -> Parts:
    """Sits up with a nut, its bushy tail raised behind it."""
    wide, head = draw(0.36, 0.43), draw(0.34, 0.39)
    y, z, big = -0.14, draw(1.14, 1.26), draw(0.92, 1.1)
    tail = [((0, 0.3, 0.24), 0.16), ((0, 0.66, 0.44), 0.25 * big), ((0, 0.74, 0.86), 0.31 * big),
            ((0, 0.62, 1.34), 0.33 * big), ((0, 0.78, 1.66), 0.29 * big),
            ((0, 1.08, 1.66), 0.2 * big)]  # fmt: skip
    haunch = egg((wide * 0.8, 0.02, 0.34), (0.21, 0.36, 0.33))
    foot = taper((wide * 0.75, -0.1, 0.1), (wide * 0.8, -0.46, 0.1), 0.11, 0.1)
    arm = taper((wide * 0.72, -0.18, 0.78), (0.17, -wide - 0.2, 0.68), 0.12, 0.1)
    ear = taper(
        (head * 0.6, y + 0.06, z + head * 0.6), (head * 0.72, y + 0.08, z + head + 0.2), 0.13, 0.06
    )
    trunk = taper((0, 0.06, 0.4), (0, -0.06, 0.86), wide, wide * 0.78)
    face = taper((0, y, z), (0, y - head * 0.8, z - 0.1), head, 0.18)
    nut = (0, -wide - 0.3, 0.68)
    return {
        "body": join(blend(0.12, trunk, face), both(join(haunch, foot, arm, ear))),
        "tail": chain(tail),
        "belly": join(
            egg((0, -0.14, 0.56), (wide * 0.68, wide * 0.9, 0.36)),
            both(egg((0.1, y - head * 0.78, z - 0.17), (0.15, 0.16, 0.12))),
        ),
        "nut": join(
            egg(nut, (0.17, 0.16, 0.2)), tube((0, nut[1], 0.76), (0, nut[1], 0.9), 0.18, 0.05)
        ),
        "eyes": both(ball((head * 0.66, y - head * 0.6, z + 0.1), 0.09)),
        "nose": ball((0, y - head * 0.8 - 0.2, z - 0.08), 0.085),
    }


def hedgehog(draw: Draw) -> Parts:
    """A dome of spikes, a pointed pale face."""
    wide, long, high = draw(0.56, 0.64), draw(0.68, 0.78), draw(0.52, 0.6)
    z, reach = 0.61, draw(0.2, 0.27)
    y = -long * 0.72
    coat = egg((0, 0.06, z), (wide, long, high))
    spikes = []
    # Rows about the y axis, each a little up the dome from the one before it.
    for row, tilt in enumerate((-38, -10, 18, 46, 74)):
        c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
        turns = (0, 42, 84) if row % 2 else (21, 63, 100)
        for turn in turns:
            a = math.radians(turn)
            along = (wide * c * math.sin(a), 0.06 + long * s, z + high * c * math.cos(a))
            out = (c * math.sin(a), s + 0.35, c * math.cos(a))
            end = tuple(p + reach * q for p, q in zip(along, out, strict=True))
            spikes.append(taper(along, (end[0], end[1], end[2]), 0.13, 0.05))
    face = taper((0, y + 0.16, z - 0.06), (0, y - 0.42, z - 0.16), 0.42, 0.13)
    ear = egg((0.34, y - 0.06, z + 0.22), (0.14, 0.09, 0.15))
    feet = [egg((0.3, at, 0.09), (0.15, 0.21, 0.1)) for at in (-0.48, 0.36)]
    return {
        "spikes": join(coat, both(join(*spikes))),
        "body": join(face, egg((0, 0, z - 0.14), (wide * 0.9, long * 0.94, 0.33)), both(ear)),
        "feet": both(join(*feet)),
        "eyes": both(ball((0.2, y - 0.2, z + 0.12), 0.09)),
        "nose": ball((0, y - 0.54, z - 0.13), 0.115),
    }


def hamster(draw: Draw) -> Parts:
    """Round and sitting up: full cheeks, tiny ears, hands and feet, a seed between its paws."""
    wide, head = draw(0.66, 0.7), draw(0.56, 0.6)
    z = draw(1.22, 1.28)
    face = -0.14 - head * 0.9
    return {
        "body": join(
            blend(0.16, egg((0, 0.02, 0.68), (wide, wide * 0.94, 0.68)),
                  egg((0, -0.14, z), (head * 1.06, head * 0.9, head * 0.86))),
            both(taper((wide * 0.8, -0.16, 0.86), (0.2, -wide - 0.08, 0.78), 0.17, 0.13)),
            ball((0, wide * 0.94, 0.24), 0.13),
        ),
        "belly": join(
            egg((0, -0.16, 0.58), (wide * 0.74, wide * 0.84, 0.52)),
            both(egg((0.34, face + 0.2, z - 0.2), (0.34, 0.3, 0.28))),
            egg((0, face + 0.04, z - 0.12), (0.2, 0.18, 0.16)),
        ),
        "feet": join(
            both(egg((0.3, -0.46, 0.12), (0.18, 0.3, 0.14))),
            both(ball((0.17, -wide - 0.14, 0.78), 0.12)),
            both(egg((head * 0.72, -0.1, z + head * 0.78), (0.15, 0.1, 0.16))),
        ),
        "seed": egg((0, -wide - 0.24, 0.84), (0.13, 0.12, 0.19)),
        "eyes": eyes(0.3, face + 0.12, z + 0.12, 0.12),
        "nose": ball((0, face - 0.13, z - 0.04), 0.09),
    }  # fmt: skip


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


MAMMALS_RODENTS_AND_CLIMBERS = {
    "kangaroo": fitted(kangaroo),
    "koala": fitted(koala),
    "sloth": sloth,
    "gorilla": gorilla,
    "beaver": beaver,
    "squirrel": fitted(squirrel),
    "hedgehog": fitted(hedgehog),
    "hamster": hamster,
    "bat": bat,
}
