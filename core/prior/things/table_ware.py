"""What is in a kitchen, at a window, on a floor."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
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
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
)

Corners = list[tuple[float, float]]


def rounded(x: float, y: float, r: float, steps: int = 5) -> Corners:
    """A rectangle of half sizes x, y with round corners of radius r."""
    quarters = ((1, 1, 0), (-1, 1, 90), (-1, -1, 180), (1, -1, 270))
    return [
        (
            sx * (x - r) + r * math.cos(math.radians(first + 90 * k / steps)),
            sy * (y - r) + r * math.sin(math.radians(first + 90 * k / steps)),
        )
        for sx, sy, first in quarters
        for k in range(steps + 1)
    ]


def plate(draw: Draw) -> Parts:
    """With a wide rim about a round well, two rings of colour on it."""
    r, high, well = draw(1.15, 1.25), draw(0.34, 0.42), draw(0.6, 0.68)
    foot, low = well * draw(0.8, 0.95), 0.2
    inner, edge = r * well, draw(0.07, 0.085)
    side = [(r * foot, 0.0), (r * foot, 0.06), (r, high - 0.1), (r, high)]
    return {
        "body": lathe([*side, (inner + 0.08, low + 0.07), (inner, low), (0.0, low)], 0.01),
        "rim": join(
            ring((0, 0, high - 0.04), r, edge),
            ring((0, 0, low + 0.03), inner + 0.04, edge * 0.9),
        ),
    }


def cutting_board(draw: Draw) -> Parts:
    """A board of wood with darker strips, a hole in its handle."""
    long, wide, z = draw(0.85, 0.95), draw(0.66, 0.76), draw(0.1, 0.12)
    grip, out, strip = draw(0.21, 0.24), draw(1.42, 1.52), draw(0.09, 0.12)
    hole, shift = 0.11, -0.25
    board = prism([(x + shift, y) for x, y in rounded(long, wide, draw(0.16, 0.24))], 2, z, z)
    handle = prism(
        [(x + out - 0.6 + shift, y) for x, y in rounded(0.6, grip, grip * 0.95)], 2, z * 0.85, z
    )
    eye = out - grip + shift
    at = long * 0.62
    return {
        "body": board,
        "bands": join(
            *(box((s * at + shift, 0, z + 0.01), (strip, wide, z + 0.01)) for s in (-1, 1))
        ),
        "handle": cut(handle, tube((eye, 0, -1), (eye, 0, 1), hole)),
    }


def salt_shaker(draw: Draw) -> Parts:
    """Of glass, half full of salt, with a round cap of metal that has holes."""
    low, top, high = draw(0.55, 0.62), draw(0.36, 0.42), draw(1.15, 1.35)
    fill, dome, rim = draw(0.5, 0.65) * high, draw(0.28, 0.36), draw(0.07, 0.1)

    def radius(z: float) -> float:
        return low + (top - low) * z / high

    cap, eaves = top + 0.07, high + 0.1
    roof = [(cap, eaves), (cap * 0.82, eaves + dome * 0.7), (0.0, eaves + dome)]
    hole = ball((cap * 0.56, 0, eaves + dome * 0.78), 0.075)
    return {
        "body": lathe([(radius(fill), fill), (top, high)], 0.0),
        "salt": lathe([(low, 0.06), (radius(fill), fill)], 0.012),
        "cap": lathe([(cap, high - 0.1), *smooth_curve(roof)], 0.01),
        "base": tube((0, 0, 0), (0, 0, 0.16), low + rim, 0.04),
        "holes": join(ball((0, 0, eaves + dome - 0.02), 0.075), around(4, hole, 45)),
    }


def easel(draw: Draw) -> Parts:
    """Three legs of wood, a painting on a ledge."""
    lean, spread, high = draw(9, 13), draw(0.62, 0.72), draw(2.25, 2.45)
    x, z, ledge = draw(0.66, 0.78), draw(0.5, 0.58), draw(0.72, 0.8)
    back, low, sun = draw(0.75, 0.9), ledge + 0.1, draw(0.12, 0.15)
    middle = low + z
    front = capsule((spread, 0, 0.09), (0.12, 0, high), 0.09)
    y = -0.09
    hill = [(-x + 0.08, low + 0.08), (x - 0.08, low + 0.08), (x - 0.08, low + z * 0.75)]
    hill += [(x * 0.45, low + z * 1.15), (0.0, low + z * 0.6), (-x * 0.45, low + z * 0.95)]
    hill += [(-x + 0.08, low + z * 0.55)]
    parts = {
        "legs": join(both(front), box((0, 0.02, high - 0.2), (0.24, 0.07, 0.08), 0.02)),
        "ledge": box((0, -0.16, ledge), (x + 0.06, 0.2, 0.085), 0.02),
        "canvas": box((0, y - 0.06, middle), (x, 0.08, z)),
        "picture": box((0, y - 0.08, middle), (x - 0.08, 0.09, z - 0.08)),
        "hills": prism(hill, 1, 0.05, y - 0.16),
        "sun": tube((x * 0.42, y - 0.21, middle + z * 0.5), (x * 0.42, y, middle + z * 0.5), sun),
    }
    # The whole front leans back against the third leg.
    leaning = {name: tilted(solid, -lean, (0, 0, 0)) for name, solid in parts.items()}
    slope = math.sin(math.radians(lean))
    stay = capsule((0, back, 0.09), (0, slope * (high - 0.2), high * 0.97 - 0.2), 0.09)
    return leaning | {"legs": join(leaning["legs"], stay)}


def flask(draw: Draw) -> Parts:
    """An Erlenmeyer flask of the laboratory, with liquid and marks of its volume."""
    low, neck, high = draw(0.85, 0.98), draw(0.24, 0.29), draw(1.3, 1.5)
    top, fill = high + draw(0.5, 0.65), draw(0.42, 0.55) * high

    def radius(z: float) -> float:
        return low + (neck - low) * (z - 0.12) / (high - 0.12)

    marks = []
    for k, wide in enumerate((0.2, 0.13, 0.2)):
        z = fill + (high - fill) * (0.12 + 0.27 * k)
        marks.append(box((0, -radius(z), z), (wide, 0.06, 0.05)))
    return {
        "glass": lathe([(radius(fill), fill), (neck, high), (neck, top)], 0.0),
        "liquid": lathe([(low - 0.06, 0.0), (low, 0.06), (low, 0.12), (radius(fill), fill)], 0.012),
        "rim": ring((0, 0, top), neck + 0.01, 0.085),
        "marks": join(*marks),
    }


def rug(draw: Draw) -> Parts:
    """Lies flat: a border about a field, a lozenge in its middle, fringes at both ends."""
    x, y, z = draw(1.12, 1.25), draw(0.8, 0.92), 0.08
    wide, reach, lozenge = draw(0.2, 0.27), draw(0.24, 0.3), draw(0.7, 0.85)
    count, inner, high = 7, (x - wide, y - wide), draw(0.4, 0.5)
    threads = [
        box((0, y * (2 * (k + 0.5) / count - 1), z), (x + reach, y * 0.54 / count, z * 0.9))
        for k in range(count)
    ]

    def diamond(share: float) -> Corners:
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


def counter(draw: Draw) -> Parts:
    """Of a bar or a shop: panels in front under a wide top, a rail for the feet."""
    x, y, high = draw(1.3, 1.42), draw(0.36, 0.44), draw(1.0, 1.15)
    over, thick, z = draw(0.1, 0.16), draw(0.085, 0.11), draw(0.26, 0.32)
    count, rail = 3 + draw.chance(0.5), -y - 0.2
    step = 2 * (x - 0.08) / count
    panels = [
        box(
            (-x + 0.08 + step * (k + 0.5), -y, high * 0.56),
            (step / 2 - 0.09, 0.06, high * 0.3),
            0.02,
        )
        for k in range(count)
    ]
    stays = tube((x * 0.72, rail, z), (x * 0.72, -y + 0.05, z), 0.075)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), 0.01),
        "top": box((0, -over * 0.6, high + thick * 0.8), (x + over, y + over, thick), 0.03),
        "panels": join(*panels),
        "base": box((0, 0, 0.09), (x + 0.04, y + 0.05, 0.09)),
        "rail": join(tube((-x + 0.04, rail, z), (x - 0.04, rail, z), 0.08), both(stays)),
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


def envelope(draw: Draw) -> Parts:
    """Upright, its closed flap to the front with a seal of wax on it."""
    x, z, y = draw(1.15, 1.3), draw(0.75, 0.85), 0.1
    tip, seal, low = draw(0.85, 1.0) * z, draw(0.19, 0.23), draw(0.12, 0.2) * z
    flap = [(x, 2 * z), (-x, 2 * z), (-0.05, tip), (0.05, tip)]
    sides = [(x, 0.02), (x, 2 * z - 0.02), (low, z)]
    bottom = [(-x, 0.0), (x, 0.0), (0.0, z * 1.08)]
    return {
        "body": box((0, 0, z), (x, y, z), 0.01),
        "sides": both(prism(sides, 1, 0.05, -y + 0.01)),
        "bottom": prism(bottom, 1, 0.05, -y - 0.015),
        "flap": prism(flap, 1, 0.07, -y - 0.04),
        "seal": tube((0, -y - 0.19, tip + 0.06), (0, -y, tip + 0.06), seal, 0.03),
    }


TABLE_WARE = {
    "plate": plate,
    "cutting board": cutting_board,
    "salt shaker": salt_shaker,
    "easel": easel,
    "flask": flask,
    "rug": rug,
    "curtain": curtain,
    "counter": counter,
    "coat rack": coat_rack,
    "hairbrush": hairbrush,
    "toothbrush": toothbrush,
    "lipstick": lipstick,
    "envelope": envelope,
}
