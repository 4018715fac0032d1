"""Animals of legends, of the north and of the home."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    capsule,
    chain,
    egg,
    join,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.animals import fitted
from core.prior.things.characters import eyes


def _legs(wide: float, long: float, high: float, thick: float) -> Solid:
    """Four, from the height ``high`` to the ground."""
    return both(taper((wide, long, high), (wide, long, thick), thick * 1.15, thick), 0, 1)


def phoenix(draw: Draw) -> Parts:
    """Red and orange, its wings raised and spread, a crest of flames, a long tail of three."""
    wide, span, lift = draw(0.36, 0.4), draw(1.38, 1.46), draw(0.62, 0.68)
    z, y = 1.5, -0.12
    up, head = z + 0.78, draw(0.29, 0.31)
    high = z + 0.4 + lift
    wing = smooth_curve([(0.08, z + 0.42), (span * 0.4, z + 0.66), (span * 0.68, high - 0.02),
                         (span * 0.74, high - 0.42), (span * 0.5, z + 0.06),
                         (0.1, z - 0.2)])  # fmt: skip
    fringe = [(0.08, z + 0.3), (span * 0.5, z + 0.8), (span * 0.74, high + 0.42),
              (span * 0.8, high - 0.04), (span, high + 0.12), (span * 0.92, high - 0.36),
              (span * 1.08, z + 0.42), (span * 0.82, z + 0.3), (span * 0.86, z - 0.1),
              (span * 0.6, z), (span * 0.54, z - 0.42), (span * 0.3, z - 0.14),
              (0.1, z - 0.4)]  # fmt: skip
    side = [((0.1, 0.1, z - 0.4), 0.15), ((0.34, 0.3, z - 0.85), 0.18), ((0.5, 0.46, 0.34), 0.22),
            ((0.84, 0.52, 0.22), 0.14)]  # fmt: skip
    middle = [((0, 0.1, z - 0.4), 0.17), ((0, 0.42, z - 0.85), 0.2), ((0, 0.78, 0.34), 0.23)]
    flame = taper((0.88, 0.52, 0.24), (1.16, 0.54, 0.66), 0.2, 0.07)
    crest = [taper((0, y + v, up + 0.16), (0, y + 2 * v + 0.14, up + t), 0.14, 0.07)
             for v, t in ((-0.06, 0.66), (0.14, 0.56))]  # fmt: skip
    foot = join(
        taper((0.18, -0.1, z - 0.5), (0.2, -0.24, z - 0.82), 0.13, 0.09),
        ball((0.2, -0.28, z - 0.86), 0.13),
    )
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, wide * 0.94, 0.62)),
                  taper((0, 0, z + 0.3), (0, y, up), 0.24, 0.2), ball((0, y, up), head)),
        ),
        "wings": both(prism(wing, 1, 0.11, 0.1)),
        "tail": join(both(chain(side)), chain(middle)),
        "tips": join(
            both(join(prism(fringe, 1, 0.085, 0.2), flame)), *crest,
            taper((0, 0.8, 0.3), (0, 1.24, 0.6), 0.2, 0.07),
            egg((0, -0.16, z - 0.1), (wide * 0.66, 0.28, 0.42)),
        ),
        "bill": join(
            taper((0, y - head * 0.8, up), (0, y - head - 0.26, up - 0.12), 0.14, 0.07), both(foot)
        ),
        "eyes": eyes(head * 0.66, y - head * 0.66, up + 0.08, 0.09),
    }  # fmt: skip


def pegasus(draw: Draw) -> Parts:
    """A white horse with a golden mane, its feathered wings raised."""
    wide, long, head = draw(0.36, 0.39), draw(0.76, 0.82), draw(0.24, 0.26)
    z = draw(1.06, 1.12)
    y, up = -long - 0.22, z + 0.8
    feather = [(-0.1, -0.16), (0.34, -0.06), (0.72, 0.06), (1.08, 0.3), (0.96, 0.5),
               (1.12, 0.62), (0.96, 0.8), (1.04, 0.98), (0.8, 1.06), (0.8, 1.28), (0.5, 1.24),
               (0.2, 1.0), (-0.02, 0.6), (-0.24, 0.1)]  # fmt: skip
    shoulder = [(-0.16, -0.1), (0.3, 0.02), (0.62, 0.32), (0.56, 0.74), (0.2, 0.98), (-0.04, 0.6),
                (-0.26, 0.1)]  # fmt: skip
    at = (wide * 0.72, -0.26, z + 0.24)
    crest = chain([((0, -long * 0.5, z + 0.36), 0.15), ((0, y + 0.24, up - 0.06), 0.17),
                   ((0, y + 0.06, up + 0.26), 0.15), ((0, y - 0.2, up + 0.2), 0.1)])  # fmt: skip
    tail = chain([((0, long * 0.92, z + 0.14), 0.12), ((0, long + 0.3, z + 0.06), 0.17),
                  ((0, long + 0.42, z - 0.36), 0.18),
                  ((0, long + 0.36, z - 0.74), 0.08)])  # fmt: skip
    ear = taper((0.12, y + 0.08, up + 0.16), (0.17, y + 0.06, up + 0.42), 0.1, 0.06)
    a, b = wide * 0.58, long * 0.68
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, long, wide)),
                  taper((0, -long * 0.62, z + 0.06), (0, y + 0.04, up), 0.28, 0.21)),
            ball((0, y, up), head), taper((0, y, up), (0, y - 0.44, up - 0.26), 0.22, 0.16),
            _legs(a, b, z - 0.06, 0.145), both(ear),
        ),
        "wings": both(moved(turned(prism(smooth_curve(shoulder), 0, 0.13), 1, 26), at)),
        "feathers": both(moved(turned(prism(feather, 0, 0.085), 1, 26), at)),
        "mane": join(crest, tail),
        "hooves": both(tube((a, b, 0.0), (a, b, 0.19), 0.185, 0.02), 0, 1),
        "eyes": eyes(0.2, y - 0.13, up + 0.05, 0.085),
    }  # fmt: skip


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


def otter(draw: Draw) -> Parts:
    """Long and upright: a flat broad head with a pale face, a pale chest, a thick tail."""
    wide, head = draw(0.4, 0.43), draw(0.4, 0.43)
    z, y = draw(1.86, 1.94), -0.16
    face = y - head * 0.86
    tail = [((0, 0.2, 0.3), 0.3), ((0, 0.7, 0.2), 0.24), ((0, 1.2, 0.15), 0.18),
            ((0, 1.56, 0.12), 0.1)]  # fmt: skip
    return {
        "body": join(
            blend(0.16, taper((0, 0.06, 0.46), (0, -0.02, 1.3), wide, wide * 0.76),
                  egg((0, y, z), (head * 1.1, head * 0.94, head * 0.84))),
            both(taper((wide * 0.78, -0.06, 1.2), (0.2, -wide - 0.2, 0.98), 0.15, 0.13)),
            both(ball((head * 0.92, y + 0.1, z + head * 0.56), 0.14)),
            both(ball((wide * 0.74, -0.06, 0.3), 0.28)),
            chain(tail),
        ),
        "chest": join(
            taper((0, -0.1, 0.52), (0, -0.14, 1.36), wide * 0.84, wide * 0.62),
            egg((0, y - 0.1, z - 0.16), (head * 1.0, head * 0.88, head * 0.62)),
            both(egg((0.15, face - 0.04, z - 0.12), (0.2, 0.17, 0.16))),
        ),
        "feet": join(
            both(egg((wide * 0.8, -0.42, 0.1), (0.22, 0.36, 0.11))),
            both(ball((0.17, -wide - 0.24, 0.98), 0.15)),
        ),
        "eyes": eyes(head * 0.56, face + 0.08, z + 0.14, 0.095),
        "nose": egg((0, face - 0.14, z + 0.02), (0.15, 0.11, 0.11)),
    }  # fmt: skip


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
        "legs": _legs(a, b, z - 0.12, 0.15),
        "hooves": join(
            both(tube((a, b, 0.0), (a, b, 0.17), 0.19, 0.02), 0, 1),
            both(ball((0.13, y - 0.84, up - 0.28), 0.085)),
        ),
        "eyes": eyes(0.24, y - 0.12, up + 0.12, 0.095),
    }  # fmt: skip


def walrus(draw: Draw) -> Parts:
    """A heavy body that rests on its flippers; two long tusks under broad whisker pads."""
    wide, head = draw(0.6, 0.64), draw(0.43, 0.46)
    y, up = -0.74, draw(1.08, 1.14)
    trunk = [((0, 1.34, 0.22), 0.2), ((0, 0.8, 0.42), 0.4), ((0, 0.1, 0.6), wide),
             ((0, -0.36, 0.72), wide * 0.98), ((0, y + 0.2, up - 0.04), 0.52)]  # fmt: skip
    face = y - head * 0.84
    fore = moved(turned(turned(egg((0, 0, 0), (0.46, 0.26, 0.12)), 1, 18), 2, 24),
                 (wide + 0.26, -0.5, 0.2))  # fmt: skip
    fin = moved(turned(egg((0, 0.2, 0), (0.2, 0.4, 0.13)), 2, -34), (0.1, 1.36, 0.18))
    tusk = limb([(0.17, face - 0.14, up - 0.08), (0.2, face - 0.24, up - 0.46),
                 (0.19, face - 0.2, up - 0.86)], 0.12, 0.08)  # fmt: skip
    return {
        "body": join(blend(0.12, chain(trunk), ball((0, y, up + 0.14), head))),
        "muzzle": both(egg((0.21, face - 0.05, up + 0.02), (0.29, 0.25, 0.25))),
        "tusks": both(tusk),
        "fins": join(both(fore), both(fin)),
        "eyes": eyes(head * 0.6, y - head * 0.72, up + 0.38, 0.1),
        "nose": egg((0, face - 0.16, up + 0.18), (0.14, 0.1, 0.1)),
    }


def toucan(draw: Draw) -> Parts:
    """Black with a white throat and a huge orange bill that curves to a black tip."""
    wide, head, long = draw(0.42, 0.45), draw(0.38, 0.4), draw(0.94, 1.0)
    z, y = 0.98, -0.16
    up = z + 0.72
    bill = [((0, y - head * 0.6, up + 0.04), 0.29), ((0, y - head - 0.32, up + 0.08), 0.27),
            ((0, y - head - long * 0.66, up - 0.04), 0.21)]  # fmt: skip
    tip = [((0, y - head - long * 0.66, up - 0.04), 0.222), ((0, y - head - long, up - 0.26), 0.1)]
    wing = moved(turned(egg((0, 0, 0), (0.15, 0.34, 0.58)), 0, 22), (wide * 0.9, 0.12, z - 0.02))
    tail = prism([(-0.14, 0.0), (0.14, 0.0), (0.24, 0.84), (-0.24, 0.84)], 2, 0.1)
    toes = join(*(capsule((0.2, -0.08, 0.1), (0.2 + u, -0.42, 0.1), 0.1) for u in (-0.12, 0.12)))
    return {
        "body": join(
            blend(0.12, egg((0, 0, z), (wide, wide * 0.94, 0.66)), ball((0, y, up), head)),
            both(wing), tilted(tail, -44, (0, 0.2, z - 0.34)),
        ),
        "throat": join(
            egg((0, -0.2, z + 0.4), (wide * 0.72, wide * 0.72, 0.4)),
            both(egg((head * 0.5, y - head * 0.4, up - 0.02),
                     (head * 0.5, head * 0.56, head * 0.6))),
        ),
        "bill": chain(bill),
        "tip": chain(tip),
        "skin": join(
            both(ball((head * 0.66, y - head * 0.5, up + 0.12), 0.17)),
            both(join(taper((0.2, -0.04, z - 0.5), (0.2, -0.08, 0.1), 0.13, 0.1), toes)),
        ),
        "eyes": eyes(head * 0.66 + 0.1, y - head * 0.5 - 0.08, up + 0.14, 0.1),
    }  # fmt: skip


def pug(draw: Draw) -> Parts:
    """Stout on short legs: a flat dark face under folds, dark ears that hang, a curled tail."""
    wide, long, leg = draw(0.46, 0.49), draw(0.62, 0.67), draw(0.5, 0.54)
    z, head = leg + 0.16, draw(0.49, 0.52)
    y, up = -long - 0.1, z + 0.56
    face = y - head * 0.86
    flap = prism([(head * 0.42, up + head * 0.9), (head * 1.0, up + head * 0.66),
                  (head * 1.22, up - 0.1), (head * 0.68, up + head * 0.34)],
                 1, 0.14, y - 0.1)  # fmt: skip
    back = long + 0.04
    curl = moved(ring((0, 0, 0), 0.2, 0.12, 0), (0, back - 0.06, z + wide * 0.72 + 0.06))
    folds = [capsule((-u, face + v, up + w), (u, face + v, up + w), 0.085)
             for u, v, w in ((0.14, 0.03, 0.22), (0.14, 0.2, 0.44))]  # fmt: skip
    a, b = wide * 0.6, long * 0.66
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, long + 0.06, wide * 0.94)),
                  egg((0, -long * 0.6, z + 0.06), (wide * 0.96, 0.4, wide)),
                  egg((0, y, up), (head * 1.04, head * 0.9, head * 0.92))),
            _legs(a, b, z - 0.1, 0.17),
            both(egg((a, -b - 0.08, 0.12), (0.19, 0.24, 0.13))),
            curl,
        ),
        "mask": join(
            egg((0, face + 0.02, up - 0.16), (0.38, 0.24, 0.29)),
            both(egg((0.17, face - 0.02, up - 0.22), (0.21, 0.2, 0.19))),
        ),
        "ears": both(flap),
        "folds": join(*folds),
        "eyes": eyes(0.32, face + 0.08, up + 0.16, 0.14),
        "nose": egg((0, face - 0.2, up - 0.04), (0.13, 0.1, 0.1)),
    }  # fmt: skip


def poodle(draw: Draw) -> Parts:
    """Shorn but for great pompoms: on its head, its ears, chest, legs, hips and the tail's end."""
    wide, long, leg = draw(0.26, 0.28), draw(0.58, 0.62), draw(0.86, 0.92)
    z = leg + 0.18
    y, up, head = -long - 0.16, z + 0.84, draw(0.25, 0.27)
    a, b = wide * 0.8, long * 0.8
    tail = (0, long + 0.3, z + 0.66)
    return {
        "pompoms": join(
            ball((0, y + 0.08, up + 0.36), 0.4),
            both(ball((0.4, y + 0.1, up - 0.14), 0.25)),
            ball((0, -long * 0.62, z + 0.1), 0.5),
            both(ball((a * 0.9, long * 0.72, z + 0.1), 0.29)),
            both(ball((a, b, 0.36), 0.24), 0, 1),
            ball(tail, 0.27),
        ),
        "body": join(
            capsule((0, -long * 0.6, z), (0, long * 0.8, z), wide),
            taper((0, -long * 0.8, z + 0.2), (0, y, up), 0.2, 0.17),
            ball((0, y, up), head),
            _legs(a, b, z - 0.06, 0.13),
            both(egg((a, b - 0.08, 0.1), (0.15, 0.2, 0.11)), 0),
            both(egg((a, -b - 0.08, 0.1), (0.15, 0.2, 0.11)), 0),
            taper((0, long * 0.9, z + 0.1), tail, 0.12, 0.1),
            taper((0, y - 0.1, up - 0.02), (0, y - 0.56, up - 0.1), 0.17, 0.12),
        ),
        "collar": tube((0, y + 0.06, up - 0.38), (0, y + 0.02, up - 0.24), 0.24, 0.03),
        "eyes": eyes(0.16, y - head * 0.84, up + 0.08, 0.09),
        "nose": ball((0, y - 0.66, up - 0.04), 0.11),
    }


MENAGERIE = {
    "phoenix": phoenix,
    "pegasus": fitted(pegasus),
    "hamster": hamster,
    "otter": fitted(otter),
    "moose": fitted(moose),
    "walrus": fitted(walrus),
    "toucan": fitted(toucan),
    "pug": pug,
    "poodle": fitted(poodle),
}
