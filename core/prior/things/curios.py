"""A truck on huge wheels, a nest, lamps that hang and stand out, and a gas mask."""

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
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.haulage import cabin, wheels


def monster_truck(draw: Draw) -> Parts:
    """A pickup's body high above huge wheels, on struts; perhaps with a bar of lamps."""
    x, y, r, edge = draw(0.54, 0.6), draw(1.2, 1.3), draw(0.54, 0.6), 0.06
    axle, floor = y * draw(0.62, 0.66), 2 * r - draw(0.0, 0.06)
    belt, roof = floor + draw(0.46, 0.52), floor + draw(0.9, 1.0)
    front, back = -y * draw(0.3, 0.36), y * draw(0.12, 0.18)
    side = [(-y + 0.08, floor + edge), (-y + 0.08, belt - 0.26), (-y + 0.2, belt - 0.12),
            (front, belt - edge), (y - edge, belt - edge), (y - edge, floor + edge)]  # fmt: skip
    middle, half = (back + y) / 2, (y - back - 0.36) / 2
    bed = box((0, middle, belt), (x - 0.17, half, 0.3))
    arches = join(*(tube((x - 0.22, v, r), (2, v, r), r + 0.1) for v in (-axle, axle)))
    hull = cut(grown(prism(side, 0, x - edge), edge), bed, both(arches))
    cab, panes = cabin(x, belt, roof, (front - 0.04, front + 0.28, back - 0.06, back))
    lamps = both(box((x * 0.66, -y + 0.08, belt - 0.27), (0.15, 0.14, 0.11), 0.04))
    body = join(hull, cab)
    if draw.chance(0.5):
        bar = box((0, back + 0.22, roof - 0.2), (x - 0.04, 0.1, 0.3), 0.03)
        body = join(body, cut(bar, box((0, back, roof - 0.38), (x - 0.24, 1, 0.3))))
        lamps = join(
            lamps, both(box((x * 0.46, back + 0.12, roof + 0.14), (0.16, 0.13, 0.12), 0.04))
        )
    tyres, hubs = wheels(x + 0.14, [(v, r) for v in (-axle, axle)], 0.25)
    strut = capsule((0.2, axle, r), (0.26, axle - 0.3, floor), 0.11)
    beam = tube((0, axle, r), (x + 0.1, axle, r), 0.13)
    rail = box((x * 0.5, 0, floor - 0.06), (0.13, y * 0.84, 0.13), 0.03)
    link = capsule((0.2, axle, r - 0.04), (0.2, 0.12, floor - 0.18), 0.11)
    return {
        "body": body,
        "windows": panes,
        "wheels": tyres,
        "trim": join(
            hubs,
            both(box((0, y - 0.04, floor + 0.1), (x * 0.94, 0.12, 0.12), 0.03), 1),
            box((0, -y + 0.08, belt - 0.27), (x * 0.3, 0.12, 0.1), 0.02),
        ),
        "chassis": both(join(strut, beam, rail, link, ball((0, axle, r), 0.2)), 0, 1),
        "lamps": lamps,
    }


def nest(draw: Draw) -> Parts:
    """A thick bowl of rings that lie askew, twigs woven about it, three eggs on the straw."""
    r, high, thick = draw(0.9, 0.98), draw(0.74, 0.84), draw(0.2, 0.23)
    size, first = draw(0.33, 0.36), 30 if draw.chance(0.5) else 90
    levels = ((0.26, 0.76, 0.05, 90), (0.62, 0.94, 0.05, 210), (0.98, 1.0, 0.05, 330))

    def askew(z: float, wide: float, off: float, turn: float) -> Solid:
        a = math.radians(turn)
        return ring((off * math.cos(a), off * math.sin(a), high * z), r * wide, thick)

    def twig(turn: float, out: float, z: float, tilt: float) -> Solid:
        return turned(capsule((out, -0.54, z - tilt), (out, 0.54, z + tilt), 0.115), 2, turn)

    laid = egg((size * 1.12, 0, high * 0.98), (size * 0.96, size * 0.96, size * 1.26))
    low = [twig(72 * k + 18, r * 0.92 + thick * 0.6, high * 0.46, 0.14) for k in range(5)]
    top = [twig(72 * k + 54, r + thick * 0.6, high * 0.92, -0.12) for k in range(5)]
    hollow = lathe([(r * 0.5, high * 0.5), (r * 0.8, high), (r * 0.8, 2)])
    return {
        "bowl": join(
            cut(lathe([(r * 0.6, 0.06), (r * 0.9, high * 0.5), (r * 0.96, high)], 0.06), hollow),
            *(askew(*level) for level in levels),
        ),
        "twigs": join(*low, *top),
        "straw": join(
            tube((0, 0, 0.2), (0, 0, high * 0.6), r * 0.7),
            ring((0, 0, high * 0.98), r * 0.8, 0.17),
        ),
        "eggs": join(*(turned(laid, 2, first + 120 * k) for k in range(3))),
    }


def paper_lantern(draw: Draw) -> Parts:
    """A ribbed globe of paper with a cap at either end, a loop above, a tassel below; or tall."""
    tall = draw.chance(0.35)
    r, half = (draw(0.6, 0.66), draw(0.82, 0.9)) if tall else (draw(0.92, 1.0), draw(0.74, 0.82))
    count, end = (7, r * 0.62) if tall else (6, r * 0.5)
    z, drop = half + 0.1, draw(0.5, 0.58)
    power = 3.2 if tall else 2.2

    def wide(t: float) -> float:
        return end + (r - end) * (1 - abs(t) ** power) ** (1 / power)

    folds = [(wide((2 * k - count) / count) - 0.02, z + half * (2 * k - count) / count)
             for k in range(count + 1)]  # fmt: skip
    hoops = [ring((0, 0, h), u - 0.03, 0.09) for u, h in folds[1:-1]]
    steps = [k / 24 for k in range(-24, 25)]
    cap = both(tube((0, 0, half - 0.06), (0, 0, half + 0.16), end + 0.08, 0.03), 2)
    low = z - half - 0.12
    return {
        "globe": lathe([(wide(t), z + half * t) for t in steps]),
        "ribs": join(*hoops),
        "caps": moved(cap, (0, 0, z)),
        "loop": ring((0, 0, z + half + 0.32), 0.22, 0.11, axis=1),
        "tassels": join(
            tube((0, 0, low + 0.1), (0, 0, low - 0.5), 0.13),
            ball((0, 0, low - 0.26), 0.2),
            lathe([(0.27, low - 0.4 - drop), (0.17, low - 0.4)], 0.02),
        ),
    }


def wall_sconce(draw: Draw) -> Parts:
    """A plate of the wall behind, a bent arm, a cup, on it a lamp's shade; or a bell of glass."""
    far, z, r = draw(0.72, 0.8), draw(0.94, 1.02), draw(0.54, 0.6)
    bell = draw.chance(0.45)
    if draw.chance(0.5):
        plate = tube((0, far, 0.62), (0, far + 0.2, 0.62), draw(0.44, 0.5), 0.05)
    else:
        plate = box((0, far + 0.1, 0.66), (0.32, 0.1, draw(0.6, 0.66)), 0.05)
    bend = [(far, 0.62), (far * 0.6, 0.36), (far * 0.22, 0.3), (0, 0.56), (0, z)]
    arm = limb([(0, u, v) for u, v in smooth_curve(bend)], 0.11, 0.11)
    boss = tube((0, far - 0.12, 0.62), (0, far + 0.1, 0.62), 0.22, 0.03)
    cup = lathe([(0.14, z - 0.12), (0.2, z - 0.04), (0.32, z + 0.04), (0.32, z + 0.12)], 0.02)
    if bell:
        side = smooth_curve([(0.24, z), (0.38, z + 0.2), (0.44, z + 0.5), (r, z + 0.8)])
        hollow = lathe([(0.26, z + 0.5), (r - 0.17, z + 0.82), (r - 0.17, z + 1)])
        shade, bulb = cut(lathe(side, 0.02), hollow), egg((0, 0, z + 0.7), (0.24, 0.24, 0.34))
    else:
        low, high = z + 0.42, z + draw(1.1, 1.2)
        hollow = lathe([(r - 0.16, low - 0.2), (r - 0.16, low + 0.1), (0.2, low + 0.2)])
        shade = cut(lathe([(r, low), (r * 0.6, high)], 0.02), hollow)
        bulb = join(tube((0, 0, z), (0, 0, low + 0.3), 0.16), ball((0, 0, low - 0.02), 0.26))
    return {"plate": plate, "arm": join(arm, boss), "cup": cup, "shade": shade, "bulb": bulb}


def pendant_lamp(draw: Draw) -> Parts:
    """From a rose of the ceiling hangs a dome, a cone or a globe, its bulb showing below."""
    shape, r, long = draw.which(3), draw(0.84, 0.94), draw(0.8, 0.92)
    high = r * (0.78, 0.86, 1.5)[shape]
    base, top = 0.26, 0.26 + high
    if shape == 0:
        side = [(r * math.cos(a), base + high * math.sin(a)) for a in
                (math.radians(5 * k) for k in range(17))]  # fmt: skip
        shade = join(lathe(side), tube((0, 0, base - 0.05), (0, 0, base + 0.12), r + 0.05, 0.03))
    elif shape == 1:
        shade = lathe([(r, base - 0.04), (r, base + 0.1), (0.26, top)], 0.02)
    else:
        q, c = r * 0.86, base + r * 0.68
        angles = (math.radians(-54 + 6 * k) for k in range(24))
        side = [(q * math.cos(a), c + q * math.sin(a)) for a in angles]
        shade, top = lathe(side), c + q * 0.94
    mouth = r * 0.86 * 0.45 if shape == 2 else r - 0.17
    bowl = lathe([(mouth, base - 0.6), (mouth, base + 0.06), (mouth * 0.8, base + high * 0.3)])
    size, drop = (0.29, 0.1) if shape == 2 else (0.34, 0.24)
    end = top + 0.2 + long
    return {
        "rose": lathe([(0.16, end - 0.12), (0.4, end), (0.42, end + 0.12)], 0.02),
        "cable": tube((0, 0, top), (0, 0, end), 0.1),
        "cap": lathe([(0.3, top - 0.14), (0.26, top + 0.1), (0.17, top + 0.22)], 0.02),
        "shade": cut(shade, bowl),
        "bulb": join(
            ball((0, 0, base - drop), size),
            tube((0, 0, base - drop), (0, 0, base + high * 0.5), 0.18),
        ),
    }


def gas_mask(draw: Draw) -> Parts:
    """Two great goggles with rims, straps behind; its filter in front, or one at either side."""
    x, high, r = draw(0.76, 0.82), draw(0.88, 0.96), draw(0.36, 0.39)
    z, eye, side = 1.05, (draw(0.4, 0.43), 1.22), draw.chance(0.45)
    face = blend(0.1, egg((0, 0, z), (x, 0.62, high)), egg((0, -0.2, z - 0.55), (0.5, 0.48, 0.42)))
    face = cut(face, box((0, 1.2, z), (2, 1, 2)))
    a = draw(12, 18)

    def goggle(first: float, last: float, radius: float) -> Solid:
        barrel = tube((0, first, 0), (0, last, 0), radius, 0.03)
        return moved(turned(barrel, 2, a), (eye[0], 0, eye[1]))

    rim = cut(goggle(-0.2, -0.7, r), goggle(-0.6, -1, r - 0.13))
    low = z - 0.55
    if side:
        can = turned(tube((0, 0, 0), (0, -0.92, 0), 0.3, 0.04), 2, 56)
        end = turned(tube((0, -0.8, 0), (0, -1.02, 0), 0.2, 0.03), 2, 56)
        at = (0.06, -0.16, low - 0.06)
        filters, caps = both(moved(can, at)), both(moved(end, at))
        caps = join(caps, tube((0, -0.4, low + 0.04), (0, -0.82, low + 0.04), 0.24, 0.04))
    else:
        neck = tube((0, -0.4, low), (0, -0.8, low), 0.26)
        can = tube((0, -0.76, low), (0, -1.3, low), 0.4, 0.05)
        filters = join(neck, can)
        caps = tube((0, -1.1, low), (0, -1.42, low), 0.24, 0.03)
    deep = draw(0.86, 0.96)
    turns = [math.pi * k / 14 for k in range(15)]

    def band(wide: float, width: float, shift: float = 0.0) -> list[tuple[float, float]]:
        outer = [(wide * math.cos(t), shift + deep * math.sin(t)) for t in turns]
        inner = [((wide - width) * math.cos(t), shift + (deep - width) * math.sin(t))
                 for t in reversed(turns)]  # fmt: skip
        return [*outer, *inner]

    over = [(v, z + u) for u, v in band(high - 0.02, 0.17) if u >= 0]
    return {
        "mask": face,
        "lenses": both(goggle(-0.3, -0.63, r - 0.1)),
        "rims": both(rim),
        "filters": filters,
        "caps": caps,
        "straps": join(
            prism(band(x - 0.04, 0.17), 2, 0.13, z + 0.02),
            prism(over, 0, 0.13),
            box((0, deep - 0.09, z + 0.04), (0.22, 0.1, 0.22), 0.03),
        ),
    }


CURIOS = {
    "monster truck": monster_truck,
    "nest": nest,
    "paper lantern": paper_lantern,
    "wall sconce": wall_sconce,
    "pendant lamp": pendant_lamp,
    "gas mask": gas_mask,
}
