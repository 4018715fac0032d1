"""Wild birds and swimmers, and what has scales, spikes or plates."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
    blend,
    both,
    capsule,
    chain,
    egg,
    grown,
    join,
    lathe,
    limb,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.animals import fitted
from core.prior.things.wild_animals import bulk, nails


def jellyfish(draw: Draw) -> Parts:
    """A bell with a scalloped rim, long tentacles, thick arms in the middle."""
    wide, high, long = draw(0.68, 0.8), draw(0.58, 0.72), draw(0.85, 1.1)
    z, count = long + 0.35, 8
    profile = [(wide, z), (wide * 0.97, z + high * 0.35), (wide * 0.8, z + high * 0.68),
               (wide * 0.45, z + high * 0.93), (0.0, z + high)]  # fmt: skip
    wave = 0.07
    down = smooth_curve([(0, z), (wave, z - long * 0.33), (-wave, z - long * 0.68), (0, 0.1)], 2)
    r = wide * 0.8
    tentacle = limb([(r + x, 0, h) for x, h in down], 0.1, 0.085)
    frill = [(0.17, z), (0.24, z - long * 0.25), (0.13, z - long * 0.5), (0.2, z - long * 0.72)]
    arm = limb([(x, 0, h) for x, h in frill], 0.16, 0.1)
    spot = ball((wide * 0.72, 0, z + high * 0.52), 0.17)
    return {
        "body": lathe(smooth_curve(profile, 5)),
        "rim": around(count, egg((wide * 0.88, 0, z), (0.19, wide * 0.37, 0.13)), 180 / count),
        "tentacles": around(count, tentacle),
        "arms": join(around(4, arm, 45), tube((0, 0, z - 0.15), (0, 0, z + 0.1), 0.24)),
        "patches": around(6, spot),
    }


def flamingo(draw: Draw) -> Parts:
    """On two long legs; the neck a bow, the bill bent down with a dark end."""
    leg, wide, up = draw(0.86, 1.02), draw(0.33, 0.39), draw(0.78, 0.92)
    z = leg + 0.26
    top = z + up
    bow = smooth_curve(
        [(-0.4, z + 0.1), (-0.76, z + 0.22), (-0.72, z + up * 0.6), (-0.5, top - 0.06),
         (-0.66, top + 0.16)], 3
    )  # fmt: skip
    y, h = -0.7, top + 0.16
    trunk = blend(
        0.12,
        egg((0, 0, z), (wide, 0.56, 0.33)),
        taper((0, 0.3, z + 0.02), (0, 0.74, z - 0.02), 0.22, 0.1),
        limb([(0, a, b) for a, b in bow], 0.17, 0.11),
    )
    wing = tilted(egg((0, 0, 0), (0.13, 0.56, 0.26)), -6, (wide * 0.86, 0.2, z + 0.07))
    shank = taper((0.17, 0.04, z - 0.2), (0.17, 0.04, 0.08), 0.09, 0.085)
    web = prism(
        [(0.08, 0.1), (0.26, 0.1), (0.36, -0.32), (0.17, -0.26), (-0.02, -0.32)], 2, 0.07, 0.07
    )
    return {
        "body": join(trunk, ball((0, y, h), 0.21)),
        "wings": both(wing),
        "legs": both(join(shank, web, ball((0.17, 0.04, leg * 0.5), 0.125))),
        "bill": taper((0, y - 0.14, h - 0.01), (0, y - 0.36, h - 0.12), 0.13, 0.11),
        "tip": taper((0, y - 0.38, h - 0.14), (0, y - 0.42, h - 0.32), 0.115, 0.07),
        "eyes": both(ball((0.15, y - 0.09, h + 0.07), 0.08)),
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


def seal(draw: Draw) -> Parts:
    """Lies with its chest raised on its flippers, a pale front, the tail's two fins apart."""
    wide, up = draw(0.38, 0.46), draw(0.78, 0.94)
    y, head = -0.68, draw(0.29, 0.34)
    trunk = chain(
        [((0, 1.3, 0.16), 0.13), ((0, 0.75, 0.27), 0.26), ((0, 0.1, 0.42), wide),
         ((0, -0.36, 0.56), wide * 0.92), ((0, y + 0.08, up + 0.06), 0.3)]
    )  # fmt: skip
    fore = tilted(egg((0, 0, 0), (0.44, 0.2, 0.09)), -6, (0, 0, 0))
    flipper = moved(turned(turned(fore, 1, 24), 2, 18), (wide + 0.22, -0.36, 0.2))
    fan = [(0, 1.2), (0.2, 1.25), (0.46, 1.62), (0.3, 1.74), (0.1, 1.5), (0, 1.42)]
    pad = egg((0.11, y - head * 0.9, up + 0.1), (0.15, 0.15, 0.12))
    return {
        "body": join(trunk, ball((0, y, up + 0.2), head)),
        "belly": taper((0, -0.2, 0.38), (0, y + 0.02, up - 0.1), wide * 0.92, 0.26),
        "fins": join(both(flipper), both(prism(fan, 2, 0.09, 0.16))),
        "muzzle": both(pad),
        "eyes": both(ball((head * 0.56, y - head * 0.72, up + 0.3), 0.09)),
        "nose": egg((0, y - head * 0.9 - 0.12, up + 0.18), (0.1, 0.08, 0.075)),
    }


def lizard(draw: Draw) -> Parts:
    """Low on splayed legs with round toes; a broad head, big eyes, a long raised tail."""
    wide, long, up = draw(0.3, 0.36), draw(0.52, 0.6), draw(0.3, 0.6)
    z, y = 0.4, -long - 0.36
    trunk = blend(
        0.12,
        egg((0, 0, z), (wide, long + 0.1, 0.27)),
        limb([(0, long * 0.6, z), (0, long + 0.3, z - 0.1), (0, long + 0.68, z - 0.18),
              (0, long + 1.0, z - 0.02), (0, long + 1.2, z + up)], 0.25, 0.1),
        taper((0, -long * 0.6, z), (0, y, z + 0.14), 0.24, 0.27),
    )  # fmt: skip
    snout = egg((0, y - 0.2, z + 0.1), (0.3, 0.36, 0.2))
    legs, toes = [], []
    for at, ahead in ((-0.36, -0.24), (0.4, 0.14)):
        x, b = wide + 0.36, at + ahead
        legs.append(limb([(wide * 0.6, at, z), (x - 0.05, at + 0.04, z), (x, b, 0.1)], 0.14, 0.11))
        toes += [ball((x + a, b + c, 0.09), 0.11) for a, c in ((-0.12, -0.14), (0.07, -0.18),
                                                              (0.2, -0.03))]  # fmt: skip
    ridge = [
        taper((0, at, h), (0, at + 0.06, h + 0.14), 0.12, 0.06)
        for at, h in ((y + 0.2, z + 0.32), (-long * 0.55, z + 0.22), (-0.02, z + 0.26),
                      (long * 0.55, z + 0.22), (long + 0.1, z + 0.12))
    ]  # fmt: skip
    eye = (0.24, y - 0.06, z + 0.3)
    return {
        "body": join(trunk, snout, both(join(*legs))),
        "belly": egg((0, -0.02, z - 0.07), (wide * 0.9, long + 0.08, 0.25)),
        "crest": join(*ridge),
        "feet": both(join(*toes)),
        "eyes": both(ball(eye, 0.15)),
        "pupils": both(ball((eye[0] + 0.08, eye[1] - 0.06, eye[2] + 0.03), 0.1)),
    }


def stingray(draw: Draw) -> Parts:
    """Flat, its fins a rounded diamond, dots on its back, a long tail with a sting."""
    span, long, raised = draw(1.14, 1.22), draw(0.76, 0.82), draw(4, 7)
    z, at = 0.24, -0.74
    edge = [(0, at - long), (0.3, at - long * 0.88), (span * 0.62, at - long * 0.3),
            (span, at + 0.16), (span * 0.6, at + long * 0.66), (0.22, at + long),
            (0, at + long + 0.06)]  # fmt: skip
    fin = grown(turned(prism(smooth_curve(edge, 6), 2, 0.02), 1, -raised), 0.08)
    rise = math.tan(math.radians(raised))
    dots = [
        tube((x, y, z), (x, y, z + x * rise + 0.18), 0.13)
        for x, y in ((0.5, at + 0.32), (0.72, at))
    ]
    return {
        "body": join(
            both(moved(fin, (0, 0, z))),
            egg((0, at, z + 0.02), (0.36, 0.66, 0.26)),
            both(ball((0.24, at - 0.42, z + 0.14), 0.15)),
            taper((0, at + 0.5, z + 0.02), (0, 1.8, z + 0.24), 0.16, 0.07),
        ),
        "belly": egg((0, at, z - 0.06), (0.72, 0.6, 0.18)),
        "patches": both(join(*dots)),
        "horn": taper((0, 0.42, z + 0.1), (0, 0.8, z + 0.36), 0.1, 0.07),
        "eyes": both(ball((0.3, at - 0.48, z + 0.2), 0.12)),
    }


def peacock(draw: Draw) -> Parts:
    """The fan of its tail spread behind it, an eye on each feather; a crown of three."""
    leg, wide, reach = draw(0.36, 0.46), draw(0.3, 0.35), draw(1.08, 1.24)
    z, y = leg + 0.28, 0.3
    top = z + draw(0.68, 0.8)
    low, count = z - 0.05, 9
    turns = [math.radians(2 + 176 * k / (count - 1)) for k in range(count)]
    rim = [(reach * math.cos(a), low + reach * math.sin(a)) for a in turns]
    inner = [
        (reach * 0.66 * math.cos(a), low + reach * 0.66 * math.sin(a))
        for a in (math.radians(13 + 154 * k / 6) for k in range(7))
    ]

    def discs(at: list[tuple[float, float]], radius: float, front: float) -> Solid:
        return join(*(tube((x, front, h), (x, y + 0.1, h), radius) for x, h in at))

    neck = limb([(0, -0.2, z + 0.08), (0, -0.42, z + 0.34), (0, -0.4, top)], 0.24, 0.13)
    trunk = blend(0.12, egg((0, 0, z), (wide, 0.48, 0.3)), neck)
    crown = [capsule((0, -0.36, top + 0.12), (x, -0.34, top + 0.4), 0.07) for x in (-0.16, 0, 0.16)]
    tips = [ball((x, -0.34, top + 0.42), 0.1) for x in (-0.2, 0, 0.2)]
    shank = taper((0.15, 0.02, z - 0.16), (0.15, 0, 0.09), 0.1, 0.085)
    toes = [capsule((0.15, 0.06, 0.08), (x, -0.26, 0.08), 0.085) for x in (0.04, 0.28)]
    return {
        "body": join(trunk, ball((0, -0.42, top), 0.19), *crown, *tips),
        "tail": join(prism([*rim, (0, low - 0.25)], 1, 0.1, y), discs(rim, 0.24, y - 0.1),
                     taper((0, 0.2, z), (0, y, low + 0.1), 0.24, 0.22)),
        "patches": join(discs(rim, 0.17, y - 0.15), discs(inner, 0.15, y - 0.15)),
        "pupils": join(discs(rim, 0.09, y - 0.2), discs(inner, 0.08, y - 0.2)),
        "bill": join(taper((0, -0.56, top - 0.02), (0, -0.74, top - 0.07), 0.1, 0.06),
                     both(join(shank, *toes))),
        "eyes": both(ball((0.13, -0.53, top + 0.06), 0.08)),
    }  # fmt: skip


def swan(draw: Draw) -> Parts:
    """Swims: a neck like an S, raised wings, an orange bill with a black root."""
    wide, long, up = draw(0.48, 0.56), draw(0.76, 0.88), draw(1.02, 1.22)
    z, y = 0.4, -long + 0.06
    top = z + up
    bow = smooth_curve(
        [(y + 0.2, z + 0.08), (y - 0.12, z + 0.3), (y + 0.06, z + up * 0.52), (y + 0.1, top - 0.12),
         (y - 0.1, top + 0.06)], 3
    )  # fmt: skip
    trunk = blend(
        0.14,
        egg((0, 0, z), (wide, long, 0.4)),
        taper((0, long * 0.6, z + 0.06), (0, long + 0.2, z + 0.34), 0.26, 0.1),
        limb([(0, a, b) for a, b in bow], 0.21, 0.13),
    )
    h, x = top + 0.06, y - 0.14
    feathers = [
        tilted(
            egg((0, 0, 0), (0.13, 0.62 * s, 0.27 * s)),
            -t,
            (wide * 0.86, 0.2 + 0.18 * k, z + 0.16 + 0.14 * k),
        )
        for k, (s, t) in enumerate(((1.0, 10), (0.84, 22)))
    ]
    return {
        "body": join(trunk, egg((0, x, h), (0.18, 0.24, 0.18))),
        "wings": both(join(*feathers)),
        "face": join(egg((0, x - 0.22, h), (0.13, 0.1, 0.13)), ball((0, x - 0.28, h + 0.09), 0.09)),
        "bill": taper((0, x - 0.28, h - 0.03), (0, x - 0.52, h - 0.1), 0.12, 0.085),
        "eyes": both(ball((0.14, x - 0.02, h + 0.07), 0.075)),
    }


def triceratops(draw: Draw) -> Parts:
    """Three horns, a beak, and a frill with studs about the neck."""
    wide, long, z, trunk = bulk(draw, 0.52, 0.78, 0.34)
    y, h, r = -long - 0.2, z + 0.12, draw(0.66, 0.78)
    tail = limb(
        [(0, long * 0.7, z), (0, long + 0.4, z - 0.16), (0, long + 0.85, z - 0.3)], 0.36, 0.1
    )
    skull = taper((0, y, h), (0, y - 0.44, h - 0.16), 0.36, 0.24)
    lean = -24.0
    studs = [
        ball((r * math.sin(math.radians(a)), 0, r * math.cos(math.radians(a))), 0.14)
        for a in (18, 53, 88)
    ]
    collar = join(tube((0, -0.1, 0), (0, 0.1, 0), r, 0.05), both(join(*studs)))
    long_horn, short = draw(0.6, 0.76), (0, y - 0.5, h + 0.02)
    brow = taper((0.2, y - 0.14, h + 0.22), (0.3, y - 0.5, h + 0.2 + long_horn), 0.14, 0.06)
    return {
        "body": join(trunk, skull, taper((0, -long * 0.6, z), (0, y, h), 0.4, 0.34), tail),
        "frill": tilted(collar, lean, (0, y + 0.18, h + 0.28)),
        "horns": join(both(brow), taper(short, (0, y - 0.68, h + 0.32), 0.14, 0.06)),
        "bill": taper((0, y - 0.52, h - 0.2), (0, y - 0.68, h - 0.36), 0.2, 0.08),
        "hooves": nails(wide, long),
        "eyes": both(ball((0.28, y - 0.24, h + 0.08), 0.085)),
    }


def stegosaurus(draw: Draw) -> Parts:
    """A row of tall plates along an arched back, a small low head, four spikes at the tail."""
    wide, hip, tall = draw(0.4, 0.48), draw(0.88, 1.0), draw(0.42, 0.52)
    spine = [((0, -1.22, 0.62), 0.17), ((0, -0.78, 0.7), 0.26), ((0, -0.3, hip - 0.04), wide),
             ((0, 0.24, hip), wide), ((0, 0.85, 0.72), 0.28), ((0, 1.66, 0.74), 0.11)]  # fmt: skip
    legs = [
        taper((wide * 0.6, at, hip - 0.2), (wide * 0.66, at, 0.15), r, 0.17)
        for at, r in ((-0.34, 0.2), (0.32, 0.25))
    ]
    plates = []
    for at, size in ((-0.72, 0.62), (-0.32, 0.86), (0.12, 1.0), (0.56, 0.86), (0.98, 0.6)):
        root = _top(spine, at) - 0.1
        w, up = 0.25 * size, (tall + 0.18) * size
        leaf = [(at - w * 0.5, root), (at - w, root + up * 0.5), (at + 0.05, root + up + 0.08),
                (at + w, root + up * 0.5), (at + w * 0.5, root)]  # fmt: skip
        plates.append(prism(leaf, 0, 0.1))
    spikes = [
        taper((0.05, at, 0.76), (0.4, at + 0.12, 0.76 + up), 0.11, 0.055)
        for at, up in ((1.32, 0.3), (1.62, 0.26))
    ]
    a, b = 0.2 * 0.86, -1.22
    return {
        "body": join(chain(spine), taper((0, b, 0.62), (0, b - 0.28, 0.54), 0.21, 0.15),
                     both(join(*legs))),
        "belly": taper((0, -0.4, hip - 0.12), (0, 0.3, hip - 0.12), wide * 0.92, wide * 0.94),
        "plates": join(*plates),
        "spikes": both(join(*spikes)),
        "hooves": both(join(*(ball((wide * 0.66 + x, at - 0.13, 0.08), 0.1)
                              for at in (-0.34, 0.32) for x in (-0.1, 0.1)))),
        "eyes": both(ball((a, b - 0.1, 0.7), 0.085)),
    }  # fmt: skip


def _top(spine: list[tuple[Vector, float]], y: float) -> float:
    """How high the back is at ``y``, about."""
    for ((_, a, low), first), ((_, b, high), last) in pairwise(spine):
        if a <= y <= b:
            share = (y - a) / (b - a)
            return low + first + (high + last - low - first) * share
    return spine[-1][0][2]


WILD_CREATURES = {
    "jellyfish": fitted(jellyfish),
    "flamingo": fitted(flamingo),
    "hedgehog": fitted(hedgehog),
    "seal": fitted(seal),
    "lizard": fitted(lizard),
    "stingray": fitted(stingray),
    "peacock": fitted(peacock),
    "swan": fitted(swan),
    "triceratops": fitted(triceratops),
    "stegosaurus": fitted(stegosaurus),
}
