"""Cloths of a room, toiletries and a coat rack."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Point,
    Solid,
    Vector,
    around,
    ball,
    both,
    box,
    capsule,
    chain,
    cut,
    join,
    lathe,
    mirrored,
    moved,
    prism,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.shared.outlines import rounded


def rug(draw: Draw) -> Parts:
    """Lies flat: a border about a field, a lozenge in its middle, fringes at both ends."""
    x, y, z = draw(1.12, 1.25), draw(0.8, 0.92), 0.08
    wide, reach, lozenge = draw(0.2, 0.27), draw(0.24, 0.3), draw(0.7, 0.85)
    count, inner, high = 7, (x - wide, y - wide), draw(0.4, 0.5)
    threads = [
        box((0, y * (2 * (k + 0.5) / count - 1), z), (x + reach, y * 0.54 / count, z * 0.9))
        for k in range(count)
    ]

    def diamond(share: float) -> list[Point]:
        a, b = inner[0] * lozenge * share, inner[1] * lozenge * share
        return [(a, 0.0), (0.0, b), (-a, 0.0), (0.0, -b)]

    return {
        "border": box((0, 0, z), (x, y, z + 0.01), 0.02),
        "field": box((0, 0, z + 0.02), (*inner, z + 0.02)),
        "lozenge": prism(diamond(1), 2, z, z + 0.07),
        "middle": prism(diamond(high), 2, z, z + 0.1),
        "fringes": join(*threads),
    }


def curtain(draw: Draw) -> Parts:
    """Two, drawn aside and tied, on a rod."""
    x, top, tie = draw(0.98, 1.1), draw(2.1, 2.3), draw(0.85, 1.0)
    waist, low, fold = x * draw(0.76, 0.82), x * draw(0.34, 0.42), 0.17
    folds = []
    for k in range(4):
        share = k / 3
        upper = 0.13 + (x - 0.13) * share
        lower = low + (x - low) * share
        held = waist + (x - 0.02 - waist) * share
        stops = [((upper, 0, top), fold), ((held, 0, tie), 0.1), ((lower, 0, 0.14), 0.14)]
        folds.append(chain(stops))
    mid = (waist + x) / 2
    return {
        "curtain": both(join(*folds)),
        "rod": tube((-x - 0.3, 0, top + 0.1), (x + 0.3, 0, top + 0.1), 0.085),
        "knobs": both(ball((x + 0.32, 0, top + 0.1), draw(0.15, 0.18))),
        "ties": both(box((mid, 0, tie), ((x - waist) / 2 + 0.14, 0.17, 0.09), 0.05)),
    }


def towel(draw: Draw) -> Parts:
    """Three rolled towels as a pyramid, striped around near their front ends."""
    r, long = draw(0.5, 0.54), draw(0.94, 1.0)
    x, top = r * 0.98, r * 2.7
    middles = ((-x, r), (x, r), (0.0, top))

    def rolled(u: float, z: float, radius: float, out: float, rounding: float) -> Solid:
        return tube((u, -long - out, z), (u, long + out, z), radius, rounding)

    return {
        "towels": both(rolled(x, r, r, 0, 0.1)),
        "folds": join(*(rolled(u, z, r * 0.45, 0.07, 0.03) for u, z in middles)),
        "bands": join(
            *(
                tube((u, v - 0.07, z), (u, v + 0.07, z), r + 0.05, 0.02)
                for u, z in middles
                for v in (0.26 - long, 0.52 - long)
            )
        ),
        "roll": rolled(0, top, r, 0, 0.1),
    }


def toilet_paper(draw: Draw) -> Parts:
    """A plump roll on its side, its last sheets down its front and out on the ground."""
    r, half, core = draw(0.82, 0.88), draw(0.74, 0.82), draw(0.32, 0.35)
    out, thick, bend = draw(0.48, 0.54), 0.07, 0.24
    y, floor, wide = -r - 0.03, bend + thick, half - 0.04
    turns = [math.radians(-15 * k) for k in range(7)]
    path = [(-0.78 * r, r * 1.5, 0.88, 0.48), (y, r * 1.04, 1.0, 0.06)]
    path += [(y - bend * (1 - math.cos(a)), floor + bend * math.sin(a), math.cos(a), math.sin(a))
             for a in turns]  # fmt: skip
    path.append((y - bend - out, thick, 0.0, -1.0))
    back, front = ([(a + s * c, b + s * d) for a, b, c, d in path] for s in (thick, -thick))
    hole = tube((-2, 0, r), (2, 0, r), core - 0.06)
    xs, far = (-wide * 0.58, 0.0, wide * 0.58), y - bend - out * 0.5
    return {
        "roll": cut(tube((-half, 0, r), (half, 0, r), r, 0.16), hole),
        "sheet": prism(back + front[::-1], 0, wide),
        "core": cut(tube((-half - 0.07, 0, r), (half + 0.07, 0, r), core + 0.08, 0.02), hole),
        "line": box((0, y - thick, floor + 0.04), (wide + 0.04, 0.06, 0.06), 0.02),
        "dots": join(
            *(tube((v, y - thick - 0.06, r * 0.86), (v, y, r * 0.86), 0.14) for v in xs),
            *(tube((v, far, thick), (v, far, 2 * thick + 0.06), 0.14) for v in xs),
        ),
    }


def hammock(draw: Draw) -> Parts:
    """A cloth that sags between two posts, striped along it; a bar at each end, ropes to it."""
    x, high, y, sag = draw(1.17, 1.22), draw(1.04, 1.11), draw(0.39, 0.43), draw(0.53, 0.59)
    reach, thick = x - 0.38, 0.065
    low = high - sag - 0.15
    bar: Vector = (reach, 0, low + sag)

    def cloth(out: float) -> list[tuple[float, float]]:
        us = [reach * (k / 10 - 1) for k in range(21)]
        curve = [(u, low + sag * (u / reach) ** 2) for u in us]
        return [(u, v + out) for u, v in curve] + [(u, v - out) for u, v in curve[::-1]]

    hook = (x - 0.03, 0.0, high + 0.04)
    return {
        "cloth": prism(cloth(thick), 1, y),
        "stripes": both(prism(cloth(thick + 0.06), 1, y * 0.17, y * 0.56), 1),
        "bars": both(tube((reach, -y - 0.09, bar[2]), (reach, y + 0.09, bar[2]), 0.14, 0.04)),
        "ropes": both(both(capsule((reach, y - 0.04, bar[2]), hook, 0.055), 1)),
        "posts": both(tube((x - 0.08, 0, 0.08), (x, 0, high + 0.22), 0.12, 0.04)),
        "base": both(lathe([(0.36, 0), (0.33, 0.09), (0.17, 0.19)], 0.02, (x - 0.08, 0))),
    }


def coat_rack(draw: Draw) -> Parts:
    """A pole on four feet, hooks about its top."""
    high, foot, reach = draw(2.5, 2.7), draw(0.62, 0.75), draw(0.5, 0.6)
    z, rise, knob = high - draw(0.3, 0.4), draw(0.2, 0.3), draw(0.12, 0.14)
    leg = chain([((0, 0, 0.42), 0.11), ((foot * 0.6, 0, 0.26), 0.1), ((foot, 0, 0.1), 0.1)])
    hook = capsule((0, 0, z), (reach, 0, z + rise), 0.085)
    small = capsule((0, 0, z - 0.65), (reach * 0.7, 0, z - 0.65 + rise * 0.8), 0.085)
    return {
        "pole": lathe([(0.15, 0.2), (0.11, 0.6), (0.11, high)], 0.01),
        "legs": around(4, leg, 45),
        "hooks": join(around(4, hook, 0), around(4, small, 45)),
        "knobs": join(
            around(4, ball((reach, 0, z + rise), knob), 0),
            around(4, ball((reach * 0.7, 0, z - 0.65 + rise * 0.8), knob), 45),
            ball((0, 0, high + 0.06), knob + 0.05),
        ),
    }


def hairbrush(draw: Draw) -> Parts:
    """Upright, its cushion with rows of bristles to the front."""
    x, z, grip = draw(0.44, 0.52), draw(0.7, 0.8), draw(0.95, 1.1)
    y, out, pitch = draw(0.12, 0.15), draw(0.27, 0.34), 0.27
    middle = grip + z - 0.06
    oval = [
        (x * math.cos(math.tau * k / 28), middle + z * math.sin(math.tau * k / 28))
        for k in range(28)
    ]
    inner = [(u * 0.8, middle + (v - middle) * 0.85) for u, v in oval]
    bristles = [
        tube((u, -y - out, v), (u, 0, v), 0.075, 0.03)
        for u, v in (
            (pitch * i, middle + pitch * k)
            for i, k in ((0, 0), (1, 0), (0, 1), (0, 2), (0, -1), (0, -2), (1, 1), (1, -1))
        )
    ]
    stem = [(0.1, 0.02), (0.17, 0.14), (draw(0.14, 0.17), grip * 0.6), (0.12, grip)]
    return {
        "body": prism(oval, 1, y),
        "cushion": prism(inner, 1, 0.09, -y + 0.02),
        "bristles": both(join(*bristles)),
        "handle": lathe(smooth_curve(stem), 0.01),
    }


def toothbrush(draw: Draw) -> Parts:
    """Upright, its bristles to the front, a soft grip on its handle."""
    high, x, y = draw(2.7, 2.9), draw(0.092, 0.105), draw(0.055, 0.065)
    head, out, neck = draw(0.26, 0.3), draw(0.16, 0.2), draw(0.05, 0.056)
    z = high - head - 0.06
    tufts = [
        box((0, -y * 0.7 - out / 2, z + head * s), (0.092, out / 2 + 0.03, head * 0.28), 0.01)
        for s in (-0.62, 0.0, 0.62)
    ]
    side = [(x * 0.7, 0.03), (x, 0.2), (x * 1.08, 0.7), (x * 0.92, 1.15), (neck, 1.6)]
    return {
        "handle": join(
            prism(mirrored(smooth_curve([(0.001, 0), *side, (neck, z)], 3)), 1, y),
            prism([(u, v + z) for u, v in rounded(0.115, head + 0.06, 0.1)], 1, y * 0.9),
        ),
        "grip": prism([(u, v + 0.74) for u, v in rounded(x * 0.66, 0.5, x * 0.6)], 1, y + 0.022),
        "bristles": join(tufts[0], tufts[2]),
        "stripe": tufts[1],
    }


def lipstick(draw: Draw) -> Parts:
    """Open: a slanted stick out of a golden tube, in a dark case."""
    r, low, mid = draw(0.4, 0.46), draw(0.85, 1.0), draw(0.38, 0.48)
    inner, stick, high = r - 0.07, r - draw(0.14, 0.17), draw(0.75, 0.9)
    z, slant = low + mid, draw(32, 42)
    top = z + high
    # All above a plane that falls to the front is cut off.
    off = moved(turned(box((0, 0, 1), (2, 2, 1)), 0, slant), (0, 0, top - stick * 0.75))
    return {
        "case": tube((0, 0, 0), (0, 0, low), r, 0.02),
        "tube": tube((0, 0, low - 0.1), (0, 0, z), inner, 0.01),
        "stick": cut(tube((0, 0, z - 0.1), (0, 0, top), stick), off),
        "band": tube((0, 0, low - 0.16), (0, 0, low + 0.03), r + 0.04, 0.02),
    }


TEXTILES_AND_TOILETRIES = {
    "rug": rug,
    "curtain": curtain,
    "towel": towel,
    "toilet paper": toilet_paper,
    "hammock": hammock,
    "coat rack": coat_rack,
    "hairbrush": hairbrush,
    "toothbrush": toothbrush,
    "lipstick": lipstick,
}
