"""What sport is done with."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    blend,
    both,
    box,
    capsule,
    cut,
    ellipsoid,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


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


SPORT = {
    "kettlebell": kettlebell,
    "barbell": barbell,
    "treadmill": treadmill,
    "golf club": golf_club,
    "hockey stick": hockey_stick,
    "surfboard": surfboard,
    "roller skate": roller_skate,
    "boxing glove": boxing_glove,
}
