"""Clothes and gloves."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
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


def shirt(draw: Draw) -> Parts:
    """A polo shirt, as if worn by someone unseen: short sleeves, a collar, three buttons."""
    wide, high, y, soft = draw(0.47, 0.54), draw(1.4, 1.6), draw(0.3, 0.34), 0.2
    reach, drop = draw(0.24, 0.32), draw(0.3, 0.42)
    half = [(0, 0), (wide, 0), (wide - 0.02, high * 0.4), (wide + 0.02, high - 0.3)]
    half += [(wide - 0.06, high - 0.13), (0.2, high), (0, high)]
    trunk = [(max(u - soft, 0.0), min(max(v, soft), high - soft)) for u, v in half]
    shoulder, end = (wide - 0.17, 0, high - 0.25), (wide + reach, 0, high - 0.22 - drop)
    along = [e - s for s, e in zip(shoulder, end, strict=True)]
    last = tuple(e - 0.4 * d for e, d in zip(end, along, strict=True))
    start = tuple(e - 0.2 * d for e, d in zip(end, along, strict=True))
    out = tuple(e + 0.16 * d for e, d in zip(end, along, strict=True))
    neck = egg((0, -0.06, high + 0.06), (0.22, 0.2, 0.28))
    flap = [(0.05, high - 0.08), (0.3, high - 0.02), (0.3, high - 0.22), (0.2, high - 0.34)]
    spots = (egg((0, -y, high * v), (0.085, 0.08, 0.085)) for v in (0.19, 0.39, 0.59))
    return {
        "body": cut(
            join(
                both(grown(prism(trunk, 1, y - soft), soft)),
                both(taper(shoulder, last, 0.25, 0.22)),
            ),
            neck,
        ),
        "cuffs": both(tube(start, out, 0.26, 0.05)),
        "collar": join(
            tilted(ring((0, 0, 0), 0.25, 0.1), 12, (0, -0.03, high + 0.01)),
            both(grown(prism(flap, 1, 0.05, -y + 0.02), 0.05)),
        ),
        "buttons": join(*spots),
    }


def trousers(draw: Draw) -> Parts:
    """Jeans as if worn: round legs, turned up, a belt, pockets in front and behind."""
    hip, y, leg = draw(0.46, 0.51), draw(0.29, 0.32), draw(0.2, 0.23)
    crotch, foot = draw(1.2, 1.4), draw(0.34, 0.4)
    top = crotch + draw(0.44, 0.52)

    def waist(by: float, low: float, high: float) -> Solid:
        quarter = [
            (0.0, -y - by),
            (hip * 0.62, -y - by),
            (hip * 0.96 + by, -y * 0.5),
            (hip + by, 0),
        ]
        plan = smooth_curve([*quarter, *((u, -v) for u, v in reversed(quarter[:-1]))], 3)
        return grown(prism(mirrored(plan), 2, (high - low) / 2 - 0.03, (low + high) / 2), 0.03)

    hole = egg((0, 0, top + 0.06), (hip - 0.14, y - 0.13, 0.24))
    hose = taper((hip - 0.25, 0, crotch + 0.06), (foot, 0, 0.22), 0.28, leg)
    pocket = box((hip * 0.54, y - 0.03, crotch + 0.05), (0.14, 0.09, 0.14), 0.03)
    return {
        "body": cut(blend(0.12, both(hose), waist(-0.03, crotch + 0.02, top - 0.05)), hole),
        "belt": cut(waist(0.04, top - 0.18, top), hole),
        "buckle": box((0, -y - 0.09, top - 0.09), (0.12, 0.08, 0.11), 0.03),
        "cuffs": both(tube((foot, 0, 0), (foot, 0, 0.24), leg + 0.06, 0.04)),
        "pockets": both(pocket, 0, 1),
    }


def dress(draw: Draw) -> Parts:
    """A dress with a wide skirt and short sleeves, low at the neck."""
    waist, low, skirt, high = draw(0.26, 0.3), draw(0.8, 0.95), draw(0.9, 1.3), draw(0.62, 0.7)
    top = skirt + high
    flare = smooth_curve([(low, 0), (low * draw(0.55, 0.75), skirt * 0.5), (waist, skirt)], 4)
    bust = [(waist, skirt - 0.05), (waist + 0.12, top - 0.3), (waist + 0.1, top - 0.08)]
    reach, drop = draw(0.5, 0.58), draw(0.2, 0.34)
    sleeve = taper((waist - 0.02, 0, top - 0.12), (reach, 0, top - 0.12 - drop), 0.15, 0.19)
    hollow = egg((0, 0, 0), (low * 0.85, low * 0.85, skirt * 0.35))
    neck = join(egg((0, -0.04, top + 0.02), (0.23, 0.25, 0.3)))
    return {
        "skirt": cut(lathe(flare, 0.02), hollow),
        "body": cut(lathe([*bust, (waist - 0.02, top)], 0.02), neck),
        "belt": tube((0, 0, skirt - 0.09), (0, 0, skirt + 0.08), waist + 0.06, 0.03),
        "hem": cut(tube((0, 0, -0.02), (0, 0, 0.13), low + 0.04, 0.04), hollow),
        "bow": join(
            ball((0, waist + 0.1, skirt), 0.11),
            both(egg((0.24, waist + 0.12, skirt + 0.04), (0.22, 0.1, 0.15))),
        ),
        "sleeves": both(sleeve),
    }


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


def cape(draw: Draw) -> Parts:
    """A cloak as on a bust: open in front, wider below, a collar that stands, a clasp."""
    top, foot, high = draw(0.34, 0.37), draw(0.84, 0.92), draw(1.96, 2.1)
    thick = 0.15
    outside = [(0, 0), (foot, 0), (top + 0.14, high * 0.72), (top, high), (0, high)]
    inside = [(0, -0.1), (foot - thick, -0.1), (top + 0.14 - thick, high * 0.72),
              (top - thick, high + 0.1), (0, high + 0.1)]  # fmt: skip
    gap = prism([(0.0, 0.06), (-0.62 * foot, -2.0), (0.62 * foot, -2.0)], 2, high, high / 2)
    rise = high + draw(0.2, 0.24)
    brim = [(top - 0.02, high - 0.06), (top + 0.16, rise), (top + 0.02, rise), (top - 0.16, high)]
    narrow = prism([(0.0, 0.1), (-0.5, -1.0), (0.5, -1.0)], 2, high, high)
    return {
        "cloth": cut(lathe(outside), lathe(inside), gap),
        "collar": cut(lathe(brim), narrow),
        "clasp": join(
            both(ball((0.26, -0.3, high - 0.02), 0.11)),
            box((0, -0.34, high - 0.02), (0.26, 0.07, 0.07)),
        ),
    }


def scarf(draw: Draw) -> Parts:
    """Wound about a neck that is not there, both ends hang down before it, with fringes."""
    wide, thick, long = draw(0.5, 0.56), draw(0.25, 0.29), draw(1.05, 1.25)
    z, lean = 1.5, draw(7, 11)
    half, y = 0.24, -wide - 0.12
    loops = join(
        tilted(ring((0, 0, 0), wide, thick), 14, (0, 0, z)),
        tilted(ring((0, 0, 0), wide * 0.94, thick * 0.9), -4, (0, 0.02, z + 0.3)),
    )

    def hung(solid: Solid, side: float) -> Solid:
        return moved(turned(solid, 1, side * lean), (-0.2 * side, y - 0.1 * (side > 0), z - 0.1))

    def end(share: float) -> Solid:
        tall = long * share
        return box((0, 0, -tall / 2), (half, 0.1, tall / 2), 0.04)

    def bands(share: float) -> Solid:
        low = -long * share
        return join(*(box((0, 0, low + at), (half + 0.025, 0.125, 0.075)) for at in (0.16, 0.44)))

    def fringe(share: float) -> Solid:
        low = -long * share
        tufts = (tube((u, 0, low - 0.17), (u, 0, low + 0.04), 0.08) for u in (-0.17, 0, 0.17))
        return join(*tufts)

    sides = ((-1, 0.84), (1, 1.0))
    return {
        "wool": join(loops, *(hung(end(share), side) for side, share in sides)),
        "stripes": join(*(hung(bands(share), side) for side, share in sides)),
        "fringes": join(*(hung(fringe(share), side) for side, share in sides)),
        "knot": egg((0, y - 0.14, z - 0.06), (0.3, 0.2, 0.26)),
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


def bow_tie(draw: Draw) -> Parts:
    """A bow tie, upright."""
    x, high, pinch, y = draw(0.95, 1.1), draw(0.45, 0.6), draw(0.16, 0.22), draw(0.15, 0.2)
    wing = [(0, -pinch), (x * 0.8, -high), (x, -high * 0.85), (x * 0.92, 0), (x, high * 0.85)]
    solid = prism([*wing, (x * 0.8, high), (0, pinch)], 1, y)
    knot = draw(0.2, 0.26)
    fold = both(prism([(0.1, -0.06), (x * 0.6, -0.11), (x * 0.6, 0.11), (0.1, 0.06)], 1, y + 0.05))
    parts = {
        "body": both(solid),
        "knot": box((0, 0, 0), (knot, y + 0.12, knot * 1.2), 0.1),
        "folds": fold,
    }
    return {name: moved(part, (0, 0, high)) for name, part in parts.items()}


def _oval(wide: float, deep: float, low: float, high: float) -> Solid:
    """An upright wall's filling: an oval between two heights."""
    turns = [math.tau * k / 48 for k in range(48)]
    outline = [(wide * math.cos(t), deep * math.sin(t)) for t in turns]
    return prism(outline, 2, (high - low) / 2, (high + low) / 2)


def belt(draw: Draw) -> Parts:
    """Closed, its great buckle to the front; the free end lies over it beside the buckle."""
    wide, deep, half = draw(0.95, 1.05), draw(0.76, 0.86), draw(0.19, 0.22)
    frame, reach = half + 0.14, draw(0.56, 0.66)
    strap = cut(_oval(wide, deep, 0, 2 * half), _oval(wide - 0.15, deep - 0.15, -1, 2))
    end = cut(
        _oval(wide + 0.1, deep + 0.1, 0.02, 2 * half - 0.02), _oval(wide - 0.05, deep - 0.05, -1, 2)
    )
    region = prism(
        [(0, half - 1), (reach, half - 1), (reach + 0.2, half), (reach, half + 1), (0, half + 1)],
        1,
        1,
        -1,
    )
    y = -deep - 0.06
    window = box((0, y, half), (frame - 0.13, 1, frame - 0.15))
    prong = capsule((-frame + 0.06, y - 0.08, half), (frame - 0.08, y - 0.1, half), 0.075)
    holes = [tube((u, -2, half), (u, 0, half), 0.07) for u in (-0.62, -0.42)]
    dots = within(
        cut(_oval(wide + 0.02, deep + 0.02, 0, 2 * half), _oval(wide - 0.17, deep - 0.17, -1, 2)),
        join(*holes),
    )
    keeper = box((reach * 0.8, -deep * 0.9, half), (0.085, 0.2, half + 0.075), 0.02)
    return {
        "strap": join(strap, within(end, region)),
        "buckle": join(cut(box((0, y, half), (frame + 0.04, 0.1, frame), 0.03), window), prong),
        "keeper": keeper,
        "holes": dots,
    }


def glove(draw: Draw) -> Parts:
    """A glove, its fingers up and its thumb to the right; some are mittens."""
    wide, palm, thick = draw(0.42, 0.5), draw(0.62, 0.75), draw(0.17, 0.21)
    low, finger = 0.5, draw(0.52, 0.7)
    top = low + palm
    if draw.chance(0.25):
        fingers = [egg((0, 0, top), (wide, thick + 0.05, finger * 1.15))]
    else:
        reach = (0.82, 1.0, 0.94, 0.68)
        fingers = [
            capsule(
                (wide * (0.75 - 0.5 * k), 0, top - 0.1),
                (wide * (0.9 - 0.6 * k), 0, top + finger * reach[k]),
                wide * 0.25,
            )
            for k in range(4)
        ]
    thumb = taper(
        (wide * 0.6, -0.04, low + 0.25), (wide + 0.36, -0.08, low + palm * 0.95), 0.19, 0.14
    )
    hand = egg((0, 0, low + palm * 0.5), (wide * 1.08, thick + 0.06, palm * 0.72))
    flare = draw(0.9, 1.15)
    cuff = [
        (-wide * flare, 0),
        (wide * flare, 0),
        (wide * 0.8, low + 0.1),
        (-wide * 0.8, low + 0.1),
    ]
    return {
        "body": blend(0.06, hand, thumb, *fingers),
        "cuff": prism(cuff, 1, thick),
        "band": box((0, 0, low + 0.06), (wide * 0.9, thick + 0.06, 0.09), 0.04),
    }


CLOTHES = {
    "shirt": shirt,
    "trousers": trousers,
    "dress": dress,
    "jacket": jacket,
    "cape": cape,
    "scarf": scarf,
    "necktie": necktie,
    "bow tie": bow_tie,
    "belt": belt,
    "glove": glove,
}
