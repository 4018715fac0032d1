"""What one is provided with: clothes, a doll, and two dishes on a table."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)

_QUARTER = [k * math.pi / 12 for k in range(7)]


def jacket(draw: Draw) -> Parts:
    """As if worn by someone unseen: zipped half way over a shirt, lapels or a hood, pockets."""
    wide, high, y, soft = draw(0.5, 0.54), draw(1.42, 1.52), draw(0.31, 0.34), 0.2
    hood, low = draw.chance(0.35), draw(0.58, 0.61) * high
    half = [(0, 0.02), (wide, 0.02), (wide, high - 0.32), (wide - 0.1, high - 0.14), (0.2, high)]
    half += [(0, high)]
    trunk = [(max(u - soft, 0.0), min(max(v, soft), high - soft)) for u, v in half]
    shoulder, wrist = (wide - 0.1, 0, high - 0.28), (wide + draw(0.46, 0.52), -0.06, high * 0.24)
    start, end = (
        tuple(s + (w - s) * t for s, w in zip(shoulder, wrist, strict=True)) for t in (0.9, 1.12)
    )
    ends = [(wide + 0.07 - 0.2 * (1 - math.cos(a)), y - 0.14 + 0.2 * math.sin(a)) for a in _QUARTER]
    hem = [*mirrored(ends), *((-u, -v) for u, v in mirrored(ends))]
    vee = mirrored([(0.06, low), (0.29, high - 0.14), (0.2, high - 0.08)])
    lapel = [(0.08, low - 0.06), (0.2, high - 0.06), (0.36, high - 0.12), (0.44, high * 0.76)]
    if hood:
        collar = join(
            tilted(ring((0, 0, 0), 0.27, 0.14), 14, (0, 0, high + 0.02)),
            egg((0, y, high - 0.04), (0.42, 0.26, 0.34)),
        )
    else:
        collar = join(
            both(grown(prism(lapel, 1, 0.06, -y), 0.03)),
            tilted(
                cut(
                    lathe([(0.26, -0.14), (0.35, 0.0), (0.3, 0.2)], 0.02),
                    tube((0, 0, -1), (0, 0, 1), 0.22),
                ),
                8,
                (0, 0.02, high),
            ),
        )
    return {
        "body": join(
            both(grown(prism(trunk, 1, y - soft), soft)), both(taper(shoulder, wrist, 0.25, 0.19))
        ),
        "shirt": join(
            prism(vee, 1, 0.08, -y + 0.03), tube((0, 0, high - 0.2), (0, 0, high + 0.04), 0.26)
        ),
        "collar": collar,
        "cuffs": join(both(tube(start, end, 0.24, 0.05)), grown(prism(hem, 2, 0.1, 0.1), 0.03)),
        "pockets": both(box((wide * 0.56, -y, high * 0.36), (0.16, 0.09, 0.13), 0.04)),
        "zip": box((0, -y, (low + 0.06) / 2), (0.07, 0.13, (low - 0.06) / 2), 0.02),
    }


def sandal(draw: Draw) -> Parts:
    """A sole like a foot, toes to the front, under a thong or two broad straps."""
    long, wide, thick, kind = draw(0.98, 1.06), draw(0.42, 0.46), draw(0.28, 0.32), draw.which(2)
    side = [(0.0, -long), (wide * 0.76, -long * 0.86), (wide, -long * 0.46)]
    side += [(wide * 0.86, long * 0.1), (wide * 0.84, long * 0.6), (wide * 0.54, long * 0.92)]
    side += [(0.0, long)]
    curve = smooth_curve(side, 6)
    outline = [*curve, *((-u, v) for u, v in reversed(curve[1:-1]))]

    def slab(grow: float, low: float, high: float) -> Solid:
        half, soft = (high - low) / 2, 0.03
        shape = [(u * (1 + grow), v * (1 + grow * 0.5)) for u, v in outline]
        return grown(prism(shape, 2, half - soft, low + half), soft)

    top, level = thick + 0.07, thick * 0.5

    def arch(r: float, sunk: float) -> Solid:
        """A half pipe along the foot, its axis ``sunk`` below the sole's middle."""
        pipe = cut(
            tube((0, -1, level - sunk), (0, 1, level - sunk), r + 0.05),
            tube((0, -2, level - sunk), (0, 2, level - sunk), r - 0.05),
        )
        return cut(pipe, box((0, 0, level - 2), (2, 2, 2)))

    def strap(at: float, half: float, r: float) -> Solid:
        return within(arch(r, 0), box((0, at, 0), (2, half, 2)))

    if kind == 0:
        vee = [(0, -long * 0.66), (wide * 0.3, -long * 0.6), (wide * 1.3, -long * 0.04)]
        vee += [(wide * 1.3, long * 0.3), (wide * 0.9, long * 0.16), (0, -long * 0.36)]
        straps = within(arch(wide * 1.06, wide * 0.1), prism(mirrored(vee), 2, 2))
        crown = level + wide * 0.96 + 0.14
        buckles = tube((0, -long * 0.51, thick), (0, -long * 0.51, crown), 0.1, 0.03)
    else:
        straps = join(strap(-long * 0.5, 0.2, wide), strap(long * 0.12, 0.18, wide * 0.92))
        pin = box((0, 0, 0), (0.09, 0.14, 0.13), 0.03)
        slope = (math.cos(0.7), math.sin(0.7))
        buckles = join(
            *(
                moved(turned(pin, 1, -40), (r * slope[0], at, level + r * slope[1]))
                for at, r in ((-long * 0.5, wide + 0.05), (long * 0.12, wide * 0.92 + 0.05))
            )
        )
    return {
        "sole": slab(0.04, 0.0, thick),
        "footbed": slab(-0.06, 0.06, top),
        "straps": straps,
        "edges": slab(0.15, thick * 0.34, thick * 0.76),
        "buckles": buckles,
    }


def necktie(draw: Draw) -> Parts:
    """Tied and hung up: a loop, a knot, a blade that widens to its point, slanted stripes."""
    high, wide, top = draw(1.5, 1.7), draw(0.34, 0.42), 0.16
    tip, knot, y = wide * 0.9, draw(0.24, 0.29), 0.1
    z = high

    def blade(grow: float, half: float) -> Solid:
        half_shape = [(wide + grow, tip), (top + grow, z)]
        shape = [(0, -grow), *mirrored(half_shape)]
        return grown(prism(shape, 1, half), 0.04)

    step, rise = draw(0.46, 0.56), draw(0.6, 0.9)
    bands = [
        prism([(-1, b - rise), (1, b + rise), (1, b + rise + 0.17), (-1, b - rise + 0.17)], 1, 1)
        for b in (tip * 0.75 + step * k for k in range(3))
    ]
    head = [(-knot, z + 0.36), (-top - 0.02, z - 0.06), (top + 0.02, z - 0.06), (knot, z + 0.36)]
    x = wide * 0.62
    tail = [(x, 0.42), (x + 0.26, 0.62), (0.18, z), (-0.12, z), (x - 0.22, 0.66)]
    hoop = cut(tube((0, 0, -0.12), (0, 0, 0.12), 0.42, 0.03), tube((0, 0, -1), (0, 0, 1), 0.28))
    loop = turned(hoop, 0, -32)
    return {
        "blade": blade(0.0, y - 0.04),
        "knot": grown(prism(head, 1, 0.12, -0.03), 0.04),
        "stripes": within(blade(0.0, y + 0.01), join(*bands)),
        "tail": grown(prism(tail, 1, 0.05, 0.14), 0.03),
        "loop": moved(loop, (0, 0.36, z + 0.42)),
    }


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


def roast_chicken(draw: Draw) -> Parts:
    """Plump, on its back, the drumsticks to the front, on a platter with leaves and tomatoes."""
    wide, long, layout = draw(0.54, 0.62), draw(0.66, 0.76), draw.arranged(3)
    plate, z = draw(1.04, 1.14), 0.5
    breast = both(egg((0.17, 0.0, z + 0.14), (wide * 0.74, long, draw(0.44, 0.5))))
    knee, ankle = (wide * 0.96, -0.12, z + 0.02), (0.27, -long - 0.16, z + 0.3)
    thigh = taper((wide * 0.8, 0.06, z), knee, 0.3, 0.27)
    drum = taper(knee, ankle, 0.27, 0.13)
    end = (0.2, -long - 0.4, z + 0.42)
    x, y, up = end
    knobs = ball((x + 0.06, y, up), 0.105), ball((x - 0.05, y, up + 0.05), 0.105)
    bone = join(capsule(ankle, end, 0.085), *knobs)
    elbow = (wide + 0.14, 0.3, z)
    wing = limb([(wide * 0.7, 0.4, z + 0.2), elbow, (wide * 0.9, 0.56, z - 0.06)], 0.17, 0.13)
    dish = [(0.0, 0.0), (plate * 0.66, 0.0), (plate, 0.15), (plate, 0.26), (plate * 0.7, 0.13)]
    dish += [(0.0, 0.13)]
    leaves, tomatoes = [], []
    for k in range(11):
        turn = math.tau * (k + 0.5) / 11 + layout(-0.12, 0.12)
        leaf = egg((plate * 0.78, 0, 0.27), (0.23, layout(0.19, 0.25), 0.11))
        leaves.append(turned(leaf, 2, math.degrees(turn)))
        if k % 3 == 0:
            at = turn + 0.26
            out = plate * 0.82
            tomatoes.append(ball((out * math.cos(at), out * math.sin(at), 0.38), 0.17))
    return {
        "meat": join(breast, egg((0, 0.06, z), (wide, long * 0.96, 0.44)), both(wing)),
        "drumsticks": both(join(thigh, drum)),
        "bones": both(bone),
        "platter": lathe(dish, 0.02),
        "leaves": join(*leaves),
        "tomatoes": join(*tomatoes),
    }


def salad(draw: Draw) -> Parts:
    """A wide bowl heaped with curly leaves, tomatoes, slices of cucumber and rings of onion."""
    r, high, foot = draw(0.98, 1.1), draw(0.66, 0.8), draw(0.4, 0.5)
    layout, heap = draw.arranged(3), draw(0.26, 0.36)
    side = smooth_curve([(foot, 0.0), (foot + 0.02, 0.08), (r * 0.82, high * 0.46), (r, high)])
    hollow = lathe([(0.02, high * 0.6), (r * 0.8, high - 0.1), (r - 0.12, high + 0.2)])

    def laid(solid: Solid, out: float, turn: float, lean: float, up: float) -> Solid:
        u = out * r
        at = (u * math.cos(turn), u * math.sin(turn), high + heap * (1 - out * out) + up)
        return moved(turned(turned(solid, 1, lean), 2, math.degrees(turn)), at)

    leaves: list[Solid] = [egg((0, 0, high - 0.1), (r * 0.86, r * 0.86, heap + 0.1))]
    for k in range(13):
        size, turn = layout(0.2, 0.27), k * math.tau / 9 + layout(-0.2, 0.2)
        frill = around(5, ball((size, 0, 0), 0.1))
        leaf = join(egg((0, 0, 0), (size, size, 0.11)), frill)
        leaves.append(laid(leaf, 0.84 if k < 9 else 0.4, turn, layout(10, 50), -0.03))
    tomato, slices, rinds, rings = [], [], [], []
    for k in range(9):
        out, turn = (0.62, 0.3)[k % 2], math.tau * k / 9 + layout(-0.1, 0.1)
        where = out, turn, layout(10, 34)
        if k % 3 == 0:
            tomato.append(laid(ball((0, 0, 0), 0.2), *where, 0.07))
        elif k % 3 == 1:
            slices.append(laid(tube((0, 0, -0.075), (0, 0, 0.095), 0.19, 0.02), *where, 0.06))
            rinds.append(laid(tube((0, 0, -0.075), (0, 0, 0.07), 0.25, 0.02), *where, 0.06))
        else:
            rings.append(laid(ring((0, 0, 0.02), 0.19, 0.07), *where, 0.06))
    return {
        "bowl": cut(lathe(side, 0.02), hollow),
        "leaves": join(*leaves),
        "tomato": join(*tomato),
        "cucumber": join(*slices),
        "rind": join(*rinds),
        "onion": join(*rings),
    }


PROVISIONS = {
    "jacket": jacket,
    "sandal": sandal,
    "necktie": necktie,
    "doll": doll,
    "roast chicken": roast_chicken,
    "salad": salad,
}
