"""The harbour: ships, long cars, and what else travels."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
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
    moved,
    outlined,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.animals import fitted
from core.prior.things.haulage import wheels


def _ship(x: float, y: float, deck: float, bow: float) -> Solid:
    """A hull with a pointed raking bow, ``bow`` higher than its deck, and a straight stern."""
    plan = smooth_curve([(x * 0.86, y), (x, y * 0.5), (x, -y * 0.3), (x * 0.66, -y * 0.72),
                         (0.04, -y - 0.1)])  # fmt: skip
    side = [(y, deck), (y * 0.95, 0), (-y * 0.76, 0), (-y - 0.08, deck + bow),
            (-y * 0.4, deck + bow * 0.5), (y * 0.2, deck)]  # fmt: skip
    return outlined(side, plan)


def yacht(draw: Draw) -> Parts:
    """A white hull with a sharp bow, two raked decks with dark bands of windows, a mast arch."""
    x, y, deck = draw(0.46, 0.5), draw(1.36, 1.42), draw(0.44, 0.48)
    low, high = deck + draw(0.36, 0.4), deck + draw(0.72, 0.78)
    hull = _ship(x, y, deck, 0.16)
    cabin = [(-y * 0.56, deck - 0.1), (-y * 0.56, deck + 0.06), (-y * 0.28, low), (y * 0.6, low),
             (y * 0.54, deck - 0.1)]  # fmt: skip
    upper = [(-y * 0.24, low - 0.1), (-0.02, high), (y * 0.5, high), (y * 0.42, low - 0.1)]
    brow = [(-0.1, high - 0.05), (-0.06, high + 0.07), (y * 0.6, high + 0.07),
            (y * 0.6, high - 0.05)]  # fmt: skip
    arch = [(y * 0.22, high), (y * 0.4, high + 0.36), (y * 0.54, high + 0.36), (y * 0.42, high)]
    first = [(-y * 0.52, deck + 0.16), (-y * 0.34, low - 0.09), (y * 0.44, low - 0.09),
             (y * 0.36, deck + 0.13)]  # fmt: skip
    second = [(-y * 0.2, low + 0.07), (-0.08, high - 0.07), (y * 0.4, high - 0.07),
              (y * 0.34, low + 0.07)]  # fmt: skip
    band = within(grown(hull, 0.045), box((0, 0, 0.1), (2, 3, 0.11)))
    return {
        "hull": hull,
        "keel": band,
        "deck": join(
            box((0, y * 0.76, deck), (x * 0.76, y * 0.19, 0.06), 0.02),
            box((0, y * 0.99, 0.17), (x * 0.66, 0.16, 0.08), 0.02),
        ),
        "cabin": join(
            prism(cabin, 0, x * 0.76), prism(upper, 0, x * 0.62), prism(brow, 0, x * 0.68),
            prism([(-y * 0.3, low - 0.05), (-y * 0.28, low + 0.05), (y * 0.72, low + 0.05),
                   (y * 0.72, low - 0.05)], 0, x * 0.82),
        ),
        "windows": join(prism(first, 0, x * 0.76 + 0.05), prism(second, 0, x * 0.62 + 0.05)),
        "mast": join(
            both(prism(arch, 0, 0.07, x * 0.48)),
            box((0, y * 0.47, high + 0.35), (x * 0.62, 0.12, 0.065), 0.03),
            ball((0, y * 0.47, high + 0.5), 0.14),
        ),
    }  # fmt: skip


def speedboat(draw: Draw) -> Parts:
    """A low pointed hull with a stripe, a raked windscreen, two seats, a motor at the stern."""
    x, y, deck = draw(0.5, 0.54), draw(1.3, 1.4), draw(0.4, 0.44)
    hull = _ship(x, y, deck, 0.1)
    well = box((0, y * 0.42, deck + 0.1), (x * 0.72, y * 0.36, 0.24), 0.06)
    pane = [(-y * 0.1, deck - 0.06), (y * 0.12, deck + 0.3), (y * 0.2, deck + 0.3),
            (y * 0.06, deck - 0.06)]  # fmt: skip
    foot = box((0, y + 0.1, 0.16), (0.09, 0.1, 0.3))
    seat = join(
        box((0, 0, 0), (0.19, 0.17, 0.09), 0.05), box((0, 0.16, 0.18), (0.19, 0.07, 0.24), 0.05)
    )
    seat = moved(seat, (x * 0.36, y * 0.44, deck - 0.06))
    wheel = tilted(ring((0, 0, 0), 0.15, 0.05), 60, (-x * 0.36, y * 0.2, deck + 0.12))
    return {
        "hull": cut(hull, well),
        "stripe": within(grown(hull, 0.04), box((0, 0, deck * 0.56), (2, 3, 0.075))),
        "windscreen": within(prism(pane, 0, x * 0.74), grown(hull, 0.6)),
        "seats": join(both(seat), wheel),
        "motor": join(
            box((0, y + 0.12, deck + 0.16), (0.19, 0.2, 0.22), 0.08), foot,
            egg((0, y + 0.14, -0.1), (0.13, 0.22, 0.13)),
        ),
        "rails": join(
            both(limb([(x * 0.5, -y * 0.2, deck + 0.02), (x * 0.44, -y * 0.52, deck + 0.22),
                       (0.06, -y * 0.86, deck + 0.3)], 0.055, 0.055)),
            tube((0, -y * 0.86, deck), (0, -y * 0.86, deck + 0.3), 0.055),
        ),
    }  # fmt: skip


def cruise_ship(draw: Draw) -> Parts:
    """A dark blue hull, white decks in tiers with rows of windows, a red funnel, lifeboats."""
    x, y, deck = draw(0.42, 0.45), draw(1.4, 1.46), draw(0.48, 0.52)
    tall, fat = draw(0.27, 0.29), draw(0.19, 0.21)
    hull = _ship(x, y, deck, 0.16)
    tiers, panes = [], []
    for k, (front, back, wide) in enumerate(((-0.6, 0.84, 0.9), (-0.5, 0.74, 0.86),
                                             (-0.38, 0.64, 0.8))):  # fmt: skip
        low, half = deck + tall * k, x * wide
        tiers.append(box((0, (front + back) * y / 2, low + tall / 2 - 0.03),
                         (half, (back - front) * y / 2, tall / 2 + 0.05), 0.04))  # fmt: skip
        count = 7 - k
        step = (back - front) * y / count
        z = low + tall * 0.5
        panes += [box((0, front * y + step * (j + 0.5), z), (half + 0.05, step * 0.29, 0.075), 0.02)
                  for j in range(count) if k != 0]  # fmt: skip
        panes.append(box((0, front * y, z), (half * 0.72, 0.05, 0.075), 0.02))
        panes.append(box((0, back * y, z), (half * 0.72, 0.05, 0.075), 0.02))
    top = deck + tall * 3
    boat = [box((x * 0.9 + 0.04, v * y, deck + 0.15), (0.12, 0.165, 0.1), 0.09)
            for v in (-0.36, -0.04, 0.28, 0.6)]  # fmt: skip
    return {
        "hull": hull,
        "keel": within(grown(hull, 0.045), box((0, 0, 0.05), (2, 3, 0.1))),
        "decks": join(
            *tiers,
            box((0, -y * 0.3, top + 0.04), (x * 0.95, 0.17, 0.1), 0.03),
            tube((0, -y * 0.2, top), (0, -y * 0.17, top + 0.4), 0.075, 0.02),
        ),
        "windows": join(*panes, box((0, -y * 0.3 - 0.1, top + 0.05), (x * 0.7, 0.12, 0.06), 0.02)),
        "funnel": join(*(taper((0, v, top - 0.1), (0, v + 0.12, top + 0.4), fat + 0.05, fat)
                         for v in (y * 0.24, y * 0.34))),
        "rim": tube((0, y * 0.29 + 0.1, top + 0.38), (0, y * 0.29 + 0.17, top + 0.7), fat + 0.06,
                    0.04),
        "lifeboats": both(join(*boat)),
    }  # fmt: skip


def garbage_truck(draw: Draw) -> Parts:
    """A white cab with a wide windscreen, a big green box with hoops, behind it a slanting loader
    full of bags."""
    x, y, r = draw(0.56, 0.58), draw(1.3, 1.34), draw(0.27, 0.28)
    top, high, floor = draw(1.1, 1.14), draw(1.38, 1.42), 0.36
    split, rear, cab = -y + 0.72, y * 0.46, x - 0.05
    tyres, hubs = wheels(x - 0.08, ((-y + 0.42, r), (y * 0.1, r), (y * 0.62, r)), 0.14)
    bin_side = [(split + 0.1, floor), (split + 0.1, high - 0.16), (split + 0.26, high),
                (rear + 0.1, high), (rear + 0.1, floor)]  # fmt: skip
    hoops = [split + 0.36 + k * (rear - split - 0.44) / 2 for k in range(3)]
    tail = [(rear, 0.3), (rear, high - 0.02), (rear + 0.26, high - 0.02), (y + 0.12, 0.84),
            (y + 0.12, 0.3)]  # fmt: skip
    mouth = [(y - 0.2, 0.52), (y * 0.74, 1.14), (y + 1, 1.6), (y + 1, 0.52)]
    middle, tall = (high + floor) / 2, (high - floor) / 2
    return {
        "cargo": join(
            grown(prism(bin_side, 0, x - 0.04), 0.04),
            *(box((0, v, middle), (x + 0.07, 0.08, tall + 0.09), 0.03) for v in hoops),
        ),
        "cab": box((0, (split - y) / 2, (top + 0.28) / 2),
                   (cab, (split + y) / 2, (top - 0.28) / 2), 0.09),
        "hopper": join(
            cut(grown(prism(tail, 0, x), 0.03), prism(mouth, 0, x - 0.13)),
            box((0, 0, 0.34), (x * 0.66, y - 0.06, 0.11)),
        ),
        "windows": join(
            box((0, -y, top - 0.27), (cab - 0.11, 0.08, 0.19), 0.04),
            both(box((cab, -y + 0.39, top - 0.27), (0.08, 0.18, 0.19), 0.04)),
        ),
        "wheels": tyres,
        "hubs": hubs,
        "bags": join(*(ball((u, y - 0.16, 0.7), 0.24) for u in (-0.24, 0.24)),
                     ball((0, y - 0.3, 0.92), 0.22), ball((0, y - 0.02, 0.6), 0.17)),
        "lamps": both(tube((cab * 0.62, -y - 0.04, 0.46), (cab * 0.62, -y + 0.04, 0.46), 0.12)),
    }  # fmt: skip


def space_station(draw: Draw) -> Parts:
    """A standing core of white modules, a ring with lit windows about it, great blue panels left
    and right."""
    r, hoop, low = draw(0.34, 0.37), draw(0.92, 0.97), draw(0.66, 0.7)
    z, wide, tall = draw(1.72, 1.78), draw(0.28, 0.3), draw(0.6, 0.64)
    core = [(0.16, 0.02), (r, 0.24), (r, 1.1), (0.24, 1.24), (0.24, 1.36), (r, 1.48),
            (r, 2.06), (0.2, 2.24)]  # fmt: skip
    cells = [box((u, 0, z), (wide, 0.075, tall), 0.02) for u in (0.8, 1.5)]
    dish = lathe([(0.1, 0), (0.3, 0.1), (0.42, 0.28), (0.3, 0.28), (0.1, 0.14)], 0.02)
    spokes = [turned(tube((-hoop, 0, low), (hoop, 0, low), 0.11), 2, a) for a in (0, 90)]
    lights = [turned(ball((hoop + 0.1, 0, low + 0.02), 0.1), 2, a) for a in range(15, 360, 30)]
    return {
        "core": join(lathe(core, 0.02), ring((0, 0, low), hoop, 0.17)),
        "bands": join(
            *(tube((0, 0, v - 0.07), (0, 0, v + 0.07), r + 0.07, 0.02) for v in (0.3, 1.04, 1.54)),
            *spokes,
        ),
        "panels": both(join(*cells)),
        "arms": join(
            tube((-1.86, 0, z), (1.86, 0, z), 0.11, 0.03),
            tube((0, 0, 2.1), (0, 0, 2.36), 0.1),
        ),
        "windows": join(*lights, *(turned(ball((r - 0.02, 0, z + 0.04), 0.12), 2, a)
                                   for a in (-120, -60, 60, 120))),
        "dish": moved(dish, (0, 0, 2.32)),
    }  # fmt: skip


def trailer(draw: Draw) -> Parts:
    """A rounded caravan on a pair of wheels, a drawbar in front, a striped awning over the door."""
    x, y, high = draw(0.58, 0.62), draw(1.0, 1.06), draw(1.36, 1.44)
    low, r = 0.28, draw(0.27, 0.29)
    side = smooth_curve([(-y * 0.86, low), (-y, 0.62), (-y * 0.9, high * 0.8), (-y * 0.56, high),
                         (y * 0.6, high), (y * 0.94, high * 0.8), (y, 0.62),
                         (y * 0.86, low)])  # fmt: skip
    shell = grown(prism(side, 0, x - 0.08), 0.08)
    tyres, hubs = wheels(x - 0.04, ((y * 0.16, r),), 0.14)
    door = box((x, -y * 0.36, 0.74), (0.055, 0.2, 0.4), 0.04)

    def slab(v: float, half: float, more: float) -> Solid:
        """A part of the awning, at ``v`` along the wall."""
        slope = turned(box((0.3, 0, 0), (0.34 + more, half, 0.06 + more), 0.02), 1, 16)
        return moved(slope, (x - 0.06, v, high - 0.1))

    v, half = -y * 0.2, y * 0.55
    return {
        "body": shell,
        "stripe": within(grown(shell, 0.045), box((0, 0, 0.42), (2, 2, 0.16))),
        "windows": join(
            both(box((x, y * 0.44, 0.88), (0.06, 0.26, 0.18), 0.04)),
            box((-x, -y * 0.3, 0.88), (0.06, 0.24, 0.18), 0.04),
            box((0, -y + 0.02, 0.9), (x * 0.62, 0.14, 0.17), 0.04),
            box((0, y - 0.02, 0.9), (x * 0.62, 0.14, 0.17), 0.04),
            box((x + 0.03, -y * 0.36, 0.92), (0.06, 0.12, 0.13), 0.03),
        ),
        "door": door,
        "wheels": tyres,
        "hubs": join(
            hubs,
            both(limb([(x * 0.6, -y * 0.6, 0.3), (0, -y - 0.42, 0.3)], 0.09, 0.09)),
            ball((0, -y - 0.46, 0.34), 0.13),
            tube((0, -y - 0.28, 0.04), (0, -y - 0.28, 0.5), 0.08, 0.02),
        ),
        "awning": slab(v, half * 0.9, 0),
        "stripes": join(*(slab(v + half * k, half * 0.2, 0.04) for k in (-0.8, 0, 0.8))),
    }


def limousine(draw: Draw) -> Parts:
    """A very long, low black car with a row of windows, silver trim, wheels at its far ends."""
    x, y, r = draw(0.39, 0.42), draw(1.6, 1.66), draw(0.23, 0.245)
    belt, top = draw(0.5, 0.53), draw(0.8, 0.84)
    side = smooth_curve([(-y, 0.22), (-y - 0.01, 0.42), (-y + 0.16, belt - 0.02),
                         (-y * 0.58, belt + 0.02), (y * 0.7, belt + 0.02), (y - 0.04, belt),
                         (y, 0.3), (y - 0.02, 0.18)])  # fmt: skip
    roof = [(-y * 0.6, belt - 0.06), (-y * 0.42, top), (y * 0.6, top), (y * 0.76, belt - 0.06)]
    half = x - 0.06
    tyres, hubs = wheels(x - 0.06, ((-y * 0.66, r), (y * 0.66, r)), 0.12)
    first, last, count = -y * 0.37, y * 0.55, 4
    step = (last - first) / count
    pane = (half + 0.02, step * 0.355, 0.105)
    panes = [box((0, first + step * (k + 0.5), (belt + top) / 2), pane, 0.03) for k in range(count)]
    glass = prism(
        [
            (-y * 0.6 - 0.03, belt),
            (-y * 0.45 - 0.05, top - 0.06),
            (y * 0.64 + 0.02, top - 0.06),
            (y * 0.76 + 0.02, belt),
        ],
        0,
        x * 0.66,
    )
    return {
        "body": join(
            grown(prism(side, 0, x - 0.04), 0.04), grown(prism(roof, 0, half - 0.06), 0.03)
        ),
        "windows": join(*panes, glass),
        "wheels": tyres,
        "hubs": join(hubs, both(box((x, 0, 0.28), (0.05, y * 0.46, 0.05), 0.02))),
        "trim": join(
            both(box((0, y - 0.02, 0.22), (x + 0.03, 0.12, 0.07), 0.04), 1),
            box((0, -y - 0.01, 0.38), (0.17, 0.09, 0.09), 0.02),
        ),
        "lamps": both(box((x * 0.74, -y, 0.4), (0.12, 0.08, 0.075), 0.04)),
    }


def sleigh(draw: Draw) -> Parts:
    """Santa's: a red body swung up in a curl in front and a high back, golden runners, a sack."""
    x, y, deep = draw(0.56, 0.6), draw(1.04, 1.1), 0.42
    back, wall = draw(1.48, 1.56), 0.14
    edge = [(y + 0.1, back), (y * 0.72, back - 0.18), (y * 0.44, deep + 0.52),
            (-y * 0.1, deep + 0.4), (-y * 0.5, deep + 0.46), (-y * 0.84, deep + 0.7)]  # fmt: skip
    curve = smooth_curve(edge)
    low = smooth_curve([(-y * 0.84, deep + 0.7), (-y * 0.98, deep + 0.5), (-y * 0.86, deep + 0.12),
                        (-y * 0.5, deep), (y * 0.4, deep), (y * 0.84, deep + 0.2),
                        (y * 1.0, deep + 0.6), (y + 0.1, back)])  # fmt: skip
    hollow = [(-y * 0.72, deep + 0.3), (-y * 0.74, 3), (y * 0.86, 3), (y * 0.7, deep + 0.3)]
    body = cut(prism([*curve, *low[1:-1]], 0, x), prism(hollow, 0, x - wall))
    run = smooth_curve([(y * 1.06, 0.1), (y * 0.4, 0.1), (-y * 0.6, 0.1), (-y * 1.04, 0.24),
                        (-y * 1.26, 0.58), (-y * 1.12, 0.86), (-y * 0.96, 0.74)])  # fmt: skip
    rail = x * 0.78
    posts = [capsule((rail, v, 0.1), (rail, v, deep + 0.1), 0.09)
             for v in (-y * 0.5, y * 0.1, y * 0.64)]  # fmt: skip
    scroll = [(x, a, b) for a, b in (*curve, (-y * 1.0, deep + 0.78), (-y * 1.04, deep + 0.62))]
    return {
        "body": body,
        "trim": join(both(limb(scroll, 0.085, 0.085)),
                     capsule((-x, y + 0.1, back), (x, y + 0.1, back), 0.085),
                     capsule((-x, -y * 0.84, deep + 0.7), (x, -y * 0.84, deep + 0.7), 0.085)),
        "seat": join(box((0, -0.02, deep + 0.36), (x - 0.1, 0.24, 0.14), 0.06),
                     box((0, 0.2, deep + 0.6), (x - 0.1, 0.1, 0.34), 0.06)),
        "runners": both(join(limb([(rail, a, b) for a, b in run], 0.09, 0.09), *posts)),
        "sack": join(ball((0, y * 0.54, deep + 0.66), 0.42),
                     taper((0, y * 0.5, deep + 0.9), (0, y * 0.42, deep + 1.24), 0.3, 0.13),
                     ball((0, y * 0.4, deep + 1.34), 0.17)),
    }  # fmt: skip


HARBOUR = {
    "yacht": yacht,
    "speedboat": speedboat,
    "cruise ship": cruise_ship,
    "garbage truck": garbage_truck,
    "space station": fitted(space_station),
    "trailer": fitted(trailer),
    "limousine": fitted(limousine),
    "sleigh": sleigh,
}
