"""Equipment for fitness, water, snow and outdoor sports."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    ellipsoid,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


def golf_club(draw: Draw) -> Parts:
    """A driver that stands on its head, which points to the left."""
    long, thick, grip = draw(2.6, 2.8), draw(0.039, 0.043), draw(0.62, 0.74)
    x, y, z = draw(0.25, 0.28), draw(0.18, 0.2), draw(0.15, 0.17)
    top, lean, low = long + 0.1, 0.3, z * 1.05
    head = cut(
        ellipsoid((-x * 0.72, 0, low), (x, y, z)),
        box((-x * 0.72, -1 - y * 0.72, low), (2, 1, 2)),
        box((0, 0, -1 + z * 0.22), (2, 2, 1)),
    )

    def at(height: float) -> tuple[float, float, float]:
        return (lean * height / long - 0.02, 0, height)

    return {
        "shaft": tube(at(low), at(top - grip + 0.05), thick),
        "grip": taper(at(top - grip), at(top), thick + 0.012, thick + 0.02),
        "head": head,
        "neck": taper(at(low), at(low + 0.32), thick + 0.03, thick + 0.02),
        "face": box((-x * 0.72, -y * 0.7, low - 0.01), (x * 0.56, 0.03, z * 0.54), 0.01),
    }


def hockey_stick(draw: Draw) -> Parts:
    """An ice hockey stick, its blade on the ground to the left."""
    long, lean, wide = draw(2.5, 2.7), draw(0.6, 0.72), draw(0.048, 0.054)
    reach, blade, grip = draw(0.54, 0.62), draw(0.08, 0.092), draw(0.16, 0.2)
    y = 0.04

    def bar(low: float, high: float, extra: float, deep: float) -> Solid:
        a, b = lean * low - 0.5, lean * high - 0.5
        w = wide + extra
        corners = [(a - w, long * low), (a + w, long * low), (b + w, long * high)]
        return prism([*corners, (b - w, long * high)], 1, deep)

    heel = -0.5 + wide
    tape, tall = heel - reach * 0.56, 2 * blade
    foot = [(heel - 0.02, 0), (heel + 0.03, tall), (heel - reach * 0.5, tall)]
    foot += [(heel - reach + 0.02, tall + 0.05), (heel - reach - 0.04, tall * 0.8)]
    foot += [(heel - reach, 0.05), (heel - reach * 0.7, 0)]
    return {
        "shaft": bar(0.02, 0.98, 0.0, y),
        "blade": prism(foot, 1, y),
        "grip": bar(1 - grip, 1.0, 0.012, y + 0.012),
        "tape": box((tape, 0, blade + 0.01), (reach * 0.24, y + 0.012, blade + 0.025)),
        "band": bar(0.42, 0.56, 0.006, y + 0.008),
    }


def boxing_glove(draw: Draw) -> Parts:
    """Its fist up, its thumb to the right."""
    wide, deep, tall = draw(0.56, 0.64), draw(0.52, 0.6), draw(0.58, 0.66)
    cuff, low, thumb = draw(0.37, 0.41), draw(0.5, 0.58), draw(0.22, 0.25)
    z = low + tall * 0.8
    return {
        "body": ellipsoid((0, 0, z), (wide, deep, tall)),
        "thumb": capsule((wide * 0.62, -0.2, low + 0.2), (wide + 0.06, -0.32, z + 0.14), thumb),
        "cuff": lathe([(cuff + 0.1, 0), (cuff, low + 0.1)], 0.03),
        "band": tube((0, 0, low * 0.32), (0, 0, low * 0.66), cuff + 0.11, 0.03),
    }


def kettlebell(draw: Draw) -> Parts:
    """A ball with a flat foot, a ring for a handle."""
    r, bow, thick = draw(0.66, 0.76), draw(0.42, 0.48), draw(0.12, 0.145)
    flat = draw(0.84, 0.9)
    z = r * flat
    up = z + r + bow * draw(0.28, 0.4)
    return {
        "body": cut(ellipsoid((0, 0, z), (r, r, r)), box((0, 0, -1), (2, 2, 1.02))),
        "handle": join(
            ring((0, 0, up), bow, thick, 1),
            both(tube((bow, 0, z + r * 0.5), (bow, 0, up), thick)),
        ),
        "badge": tube((0, -r - 0.01, z), (0, 0, z), r * draw(0.36, 0.42)),
        "base": tube((0, 0, 0), (0, 0, 0.14), r * 0.66, 0.03),
    }


def barbell(draw: Draw) -> Parts:
    """A long bar along x, three plates at each end."""
    r, bar, inner = draw(0.54, 0.62), draw(0.085, 0.1), draw(0.72, 0.82)
    big, middle = draw(0.15, 0.19), draw(0.13, 0.16)
    a, b = inner + big, inner + big + middle
    end = b + draw(0.3, 0.36)
    return {
        "weights": both(tube((inner, 0, r), (a, 0, r), r, 0.04)),
        "plates": both(tube((a - 0.02, 0, r), (b, 0, r), r * draw(0.68, 0.76), 0.04)),
        "bar": tube((-end, 0, r), (end, 0, r), bar),
        "collars": both(
            join(
                tube((b - 0.02, 0, r), (b + 0.12, 0, r), 0.2, 0.03),
                tube((inner - 0.12, 0, r), (inner + 0.02, 0, r), 0.2, 0.03),
            )
        ),
    }


def treadmill(draw: Draw) -> Parts:
    """Its belt to the front, its console at the back."""
    x, y, deck = draw(0.54, 0.62), draw(1.1, 1.25), draw(0.2, 0.26)
    high, hand = draw(1.35, 1.5), draw(0.5, 0.62)
    rail, post = 0.15, x - 0.1
    back = y - 0.2
    arm = high - 0.3
    console = turned(box((0, 0, 0), (x + 0.06, 0.11, 0.28), 0.04), 0, -24)
    screen = turned(box((0, -0.11, 0.02), (x * 0.6, 0.05, 0.17), 0.02), 0, -24)
    return {
        "body": join(
            both(box((x - rail / 2, 0, deck / 2), (rail / 2, y, deck / 2), 0.03)),
            box((0, y - 0.24, deck * 0.75), (x, 0.24, deck * 0.75), 0.05),
        ),
        "belt": box((0, -0.1, deck * 0.5), (x - rail + 0.03, y - 0.05, deck * 0.38)),
        "posts": both(taper((post, back, deck), (post, back, high), 0.1, 0.1)),
        "handles": both(capsule((post, back, arm), (post, back - hand, arm), 0.1)),
        "console": moved(console, (0, back - 0.04, high + 0.08)),
        "screen": moved(screen, (0, back - 0.04, high + 0.08)),
    }


def roller_skate(draw: Draw) -> Parts:
    """A laced boot on four wheels, its toe and a stop to the front."""
    long, wide, r = draw(0.84, 0.9), draw(0.33, 0.36), draw(0.25, 0.27)
    high, sole = draw(1.06, 1.14), 2 * r + 0.16
    top, back, toe = sole + high, long - 0.4, wide - 0.03 - long
    axles = (-long * 0.56, long * 0.56)
    ankle, front = (0.0, back - 0.02, sole + 0.62), (0.0, toe + 0.12, sole + 0.2)
    along = math.hypot(ankle[1] - front[1], ankle[2] - front[2])
    up = ((ankle[1] - front[1]) / along, (ankle[2] - front[2]) / along)
    rows = [
        (front[1] + up[0] * s - up[1] * wide, front[2] + up[1] * s + up[0] * wide)
        for s in (along * 0.3, along * 0.58, along * 0.86)
    ]
    boot = blend(
        0.1,
        taper(ankle, front, wide, wide),
        taper((0, back + 0.06, sole + 0.2), front, wide, wide),
        tube((0, back, sole + 0.2), (0, back + 0.03, top), wide, 0.03),
    )
    collar = ring((0, back + 0.03, top - 0.02), wide - 0.03, 0.1)
    under = box((0, 0, sole - 1), (2, 3, 1))
    hole = tube((0, back, top - 0.2), (0, back, top + 1), wide * 0.66)
    return {
        "body": cut(join(boot, collar), under, hole),
        "sole": join(
            box((0, 0, sole - 0.06), (wide * 0.94, long, 0.11), 0.05),
            *(box((0, v, r + 0.12), (0.15, 0.17, 0.2), 0.03) for v in axles),
        ),
        "wheels": both(
            join(*(tube((wide * 0.4, v, r), (wide * 1.3, v, r), r, 0.06) for v in axles))
        ),
        "hubs": both(
            join(*(tube((0, v, r), (wide * 1.3 + 0.05, v, r), r * 0.46, 0.02) for v in axles))
        ),
        "stop": tube((0, -long * 0.9, sole - 0.08), (0, -long - 0.08, r + 0.1), 0.14, 0.05),
        "laces": join(*(capsule((-0.2, v, w), (0.2, v, w), 0.08) for v, w in rows)),
    }


def skis(draw: Draw) -> Parts:
    """A pair of skis that stands, tips curled forward, bound by a strap; two poles crossed behind
    them."""
    x, wide, high, deep = 0.34, draw(0.2, 0.215), draw(2.96, 3.04), 0.085
    # Along the middle of a ski: y, z, and how far it leans forward.
    stops = [(0, 0, 0), (0, high - 0.74, 4), (-0.07, high - 0.46, 22), (-0.22, high - 0.2, 40),
             (-0.46, high, 56)]  # fmt: skip
    turns = [(y, z, math.cos(math.radians(a)), math.sin(math.radians(a))) for y, z, a in stops]
    back = smooth_curve([(y + deep * c, z + deep * s) for y, z, c, s in turns])
    front = smooth_curve([(y - deep * c, z - deep * s) for y, z, c, s in turns])
    outline = mirrored([(wide * 0.8, -0.1), (wide, 0.2), (wide * 0.84, high * 0.45),
                        (wide * 1.08, high - 0.52), (wide * 0.8, high - 0.2),
                        (wide * 0.4, high), (0.03, high + 0.1)])  # fmt: skip
    ski = within(prism([*back, *reversed(front)], 0, 1), prism(outline, 1, 2))
    toe, heel = (box((x, -0.16, v), (wide - 0.04, 0.14, e), 0.05)
                 for v, e in ((1.5, 0.11), (1.02, 0.14)))  # fmt: skip
    plate = box((x, -0.09, 1.26), (wide - 0.08, 0.08, 0.3), 0.03)
    marks = [box((x, -deep + 0.01, v), (wide * 0.5, 0.08, e), 0.03)
             for v, e in ((0.42, 0.26), (2.16, 0.16))]  # fmt: skip

    def pole(t: float, side: int) -> Vector:
        """A part of the way up the pole that leans to a side."""
        return side * 0.86 * (2 * t - 1), 0.13, 0.06 + 2.3 * t

    return {
        "skis": both(moved(ski, (x, 0, 0))),
        "stripes": both(join(*marks)),
        "bindings": both(join(toe, heel, plate)),
        "strap": box((0, 0, 1.82), (x + wide + 0.04, deep + 0.06, 0.09), 0.03),
        "poles": join(*(capsule(pole(0, s), pole(1, s), 0.08) for s in (-1, 1))),
        "grips": join(
            *(capsule(pole(0.86, s), pole(1, s), 0.13) for s in (-1, 1)),
            *(egg(pole(0.1, s), (0.22, 0.22, 0.1)) for s in (-1, 1)),
        ),
    }


def surfboard(draw: Draw) -> Parts:
    """It stands on its tail, its deck to the front, its fins at the back."""
    wide, high, thick = draw(0.42, 0.5), draw(1.25, 1.4), draw(0.1, 0.12)
    nose, tail = draw(0.5, 0.62), draw(0.56, 0.66)
    side = [(0.0, 2 * high), (wide * nose * 0.8, high * 1.82), (wide * 0.9, high * 1.4)]
    side += [(wide, high * 0.9), (wide * 0.9, high * 0.42), (wide * tail, high * 0.1), (0.1, 0.0)]
    right = smooth_curve(side, 3)
    outline = [*right, *((-a, b) for a, b in reversed(right[1:]))]
    fin = [(0, 0.62), (0, 0.18), (0.3, 0.12), (0.34, 0.24), (0.2, 0.36)]
    low, up = high * draw(0.6, 0.7), high * draw(1.3, 1.4)
    band = prism(outline, 1, thick + 0.025)
    return {
        "board": prism(outline, 1, thick),
        "stripe": box((0, 0, high), (0.09, thick + 0.04, high * 0.93)),
        "bands": cut(
            band,
            box((0, 0, up + 0.14 + 2), (2, 2, 2)),
            box((0, 0, (low + up) / 2), (2, 2, (up - low) / 2 - 0.14)),
            box((0, 0, low - 0.14 - 2), (2, 2, 2)),
        ),
        "fins": moved(
            join(prism(fin, 0, 0.075), both(moved(prism(fin, 0, 0.075), (wide * 0.6, 0, 0.16)))),
            (0, thick - 0.03, 0),
        ),
    }


def fishing_rod(draw: Draw) -> Parts:
    """It leans to the right and bends, a reel below its grip, a float on its line."""
    lean, high, reach = draw(1.0, 1.2), draw(2.2, 2.45), draw(0.6, 0.75)
    foot, thick = -1.0, 0.1
    slope = lean / high
    hold = 0.86
    end = (foot + lean + reach, high + draw(-0.05, 0.14))
    bend = smooth_curve(
        [
            (foot + slope * 0.7, 0.7),
            (foot + slope * 1.4, 1.36),
            (foot + slope * 1.95, 1.95),
            (foot + lean + reach * 0.3, high),
            end,
        ],
        3,
    )

    def at(height: float, aside: float = 0.0) -> Vector:
        return (foot + slope * height + aside, 0.0, height - aside * slope)

    low = draw(0.6, 0.85)
    spool, drop = at(0.98, 0.36), (end[0], 0.0, low)
    bob = draw(0.23, 0.28)
    crank = [(spool[0], -0.2, spool[2]), (spool[0], -0.36, spool[2])]
    crank += [(spool[0] + 0.2, -0.36, spool[2] - 0.16)]
    return {
        "rod": limb([(u, 0.0, v) for u, v in bend], thick + 0.02, thick - 0.01),
        "handle": join(
            tube(at(0.02), at(hold - 0.16), 0.15, 0.05), tube(at(1.12), at(1.4), 0.15, 0.05)
        ),
        "reel": join(
            *(tube((spool[0], a, spool[2]), (spool[0], b, spool[2]), 0.27, 0.03)
              for a, b in ((-0.22, -0.09), (0.09, 0.22))),
            tube((spool[0], -0.2, spool[2]), (spool[0], 0.2, spool[2]), 0.17),
            capsule(at(0.98), spool, 0.1),
            limb(crank, 0.085, 0.085),
            ball((spool[0] + 0.2, -0.42, spool[2] - 0.16), 0.12),
        ),
        "line": capsule((end[0], 0, end[1]), drop, 0.08),
        "float": cut(egg(drop, (bob, bob, bob * 1.2)), box((0, 0, low - 1), (3, 2, 1))),
        "tip": join(
            cut(egg(drop, (bob, bob, bob * 1.2)), box((0, 0, low + 1), (3, 2, 1))),
            tube((end[0], 0, low), (end[0], 0, low - bob - 0.2), 0.085, 0.03),
        ),
    }  # fmt: skip


def oar(draw: Draw) -> Parts:
    """It stands on its blade: a long shaft with a sleeve, a knob or a bar across at its top."""
    wide, blade, long = draw(0.17, 0.21), draw(0.95, 1.1), draw(2.9, 3.1)
    thick, deep, broad = draw(0.047, 0.052), 0.045, draw.chance(0.5)
    half = [(0.001, 0.0), (wide * 0.62, 0.05), (wide * 0.96, 0.24), (wide * 0.9, blade * 0.6)]
    if broad:
        half = [(0.001, 0.0), (wide * 0.85, 0.01), (wide * 1.06, 0.12), (wide * 0.9, blade * 0.66)]
    flat = mirrored(smooth_curve([*half, (wide * 0.42, blade * 0.88), (0.04, blade + 0.1)], 3))
    low, up = draw(0.3, 0.38), draw(0.1, 0.13)
    bar = box((0, 0, long), (0.16, 0.06, 0.09), 0.05)
    knob = join(
        tube((0, 0, long - 0.5), (0, 0, long), thick + 0.017, 0.01), ball((0, 0, long), 0.09)
    )
    sleeve = long * draw(0.54, 0.6)
    return {
        "shaft": tube((0, 0, blade * 0.2), (0, 0, long), thick),
        "blade": prism(flat, 1, deep),
        "stripe": within(prism(flat, 1, deep + 0.015), box((0, 0, low), (2, 2, up))),
        "grip": bar if draw.chance(0.5) else knob,
        "sleeve": tube((0, 0, sleeve), (0, 0, sleeve + 0.4), thick + 0.017, 0.01),
        "collar": tube((0, 0, sleeve + 0.11), (0, 0, sleeve + 0.29), thick + 0.042, 0.02),
    }


SPORT_FITNESS_AND_OUTDOOR = {
    "golf club": golf_club,
    "hockey stick": hockey_stick,
    "boxing glove": boxing_glove,
    "kettlebell": kettlebell,
    "barbell": barbell,
    "treadmill": treadmill,
    "roller skate": roller_skate,
    "skis": skis,
    "surfboard": surfboard,
    "fishing rod": fishing_rod,
    "oar": oar,
}
