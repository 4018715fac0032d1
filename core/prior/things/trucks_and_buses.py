"""Trucks, buses and a trailer."""

import math

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
    mirrored,
    moved,
    outlined,
    prism,
    smooth_curve,
    tube,
    turned,
    within,
)
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.outlines import strip
from core.prior.things.shared.vehicle_parts import greenhouse
from core.prior.things.shared.wheels import disc_wheels, wheels


def bus(draw: Draw) -> Parts:
    """Long and high, a row of windows on either side."""
    x, y, top, wheel = draw(0.48, 0.55), draw(1.25, 1.4), draw(1.15, 1.3), draw(0.23, 0.26)
    middle = (top + 0.2) / 2
    row = (
        box((x, y * s, top * 0.7), (0.05, y * 0.165, top * 0.15), 0.03)
        for s in (-0.66, -0.22, 0.22, 0.66)
    )
    shield = box((0, -y, top * 0.68), (x * 0.8, 0.05, top * 0.19), 0.03)
    return {
        "body": box((0, 0, middle), (x, y, top - middle), 0.1),
        "windows": join(both(join(*row)), shield),
        "wheels": disc_wheels(x * 0.92, (-y * 0.62, y * 0.6), wheel),
        "lamps": both(ball((x * 0.64, -y, 0.42), 0.1)),
    }


def double_decker_bus(draw: Draw) -> Parts:
    """Two rows of windows one above the other, round corners, a sign over the windscreen."""
    x, y, top, wheel = draw(0.46, 0.54), draw(1.16, 1.34), draw(1.6, 1.8), draw(0.24, 0.29)
    low, high, half = top * 0.46, top * 0.81, top * 0.1
    row = [box((x, y * s, z), (0.06, y * 0.16, half), 0.03)
           for s in (-0.68, -0.23, 0.23, 0.68) for z in (low, high)]  # fmt: skip
    axles = (-y * 0.56, y * 0.56)
    arches = join(*(tube((x - 0.2, v, wheel), (2, v, wheel), wheel + 0.05) for v in axles))
    tyres, hubs = wheels(x - 0.1, [(v, wheel) for v in axles], 0.13)
    z = (low + high) / 2
    ends = [box((0, 0, v), (x * 0.76, y + 0.06, half), 0.03) for v in (low + 0.01, high)]
    return {
        "body": cut(box((0, 0, (top + 0.16) / 2), (x, y, (top - 0.16) / 2), 0.12), both(arches)),
        "windows": join(both(join(*row)), *ends),
        "wheels": tyres,
        "hubs": hubs,
        "stripe": join(
            both(box((x, 0, z), (0.05, y - 0.1, 0.075), 0.02)),
            box((0, -y, z), (x * 0.62, 0.08, 0.11), 0.02),
        ),
        "lamps": join(
            both(tube((x * 0.62, -y - 0.06, 0.4), (x * 0.62, -y + 0.2, 0.4), 0.11, 0.03)),
            box((0, -y, 0.4), (x * 0.3, 0.05, 0.11), 0.03),
        ),
    }


def truck(draw: Draw) -> Parts:
    """A cab in front of a box."""
    x, y, wheel, floor = draw(0.52, 0.6), draw(1.2, 1.35), draw(0.24, 0.28), 0.36
    cab, top, high = draw(0.32, 0.38), draw(1.0, 1.12), draw(1.25, 1.45)
    split = -y + 2 * cab
    return {
        "cargo": box(
            (0, (split + 0.14 + y) / 2, (floor + high) / 2),
            (x, (y - split - 0.14) / 2, (high - floor) / 2),
            0.03,
        ),
        "cab": box(
            (0, -y + cab, (floor + top) / 2 - 0.04), (x * 0.94, cab, (top - floor) / 2 + 0.04), 0.09
        ),
        "windows": join(
            box((0, -y, top * 0.76), (x * 0.74, 0.06, top * 0.13), 0.02),
            both(box((x * 0.94, -y + cab, top * 0.76), (0.05, cab * 0.6, top * 0.13), 0.02)),
        ),
        "chassis": box((0, 0.05, floor - 0.06), (x * 0.6, y - 0.1, 0.1)),
        "wheels": disc_wheels(x * 0.86, (-y + cab * 0.95, y * 0.25, y * 0.72), wheel),
    }


def pickup_truck(draw: Draw) -> Parts:
    """A hood, a cab whose sides lean in and an open bed, on large wheels; or with a roll bar."""
    x, y, wheel = draw(0.6, 0.66), draw(1.3, 1.4), draw(0.32, 0.35)
    belt, roof, nose = 2 * wheel + draw(0.28, 0.32), draw(1.4, 1.5), 2 * wheel + draw(0.2, 0.24)
    front, back, axles = -y * draw(0.4, 0.46), y * draw(0.16, 0.22), (-y * 0.6, y * 0.62)
    floor, eyes = wheel + 0.04, nose - 0.19
    hull = [(-y + 0.04, floor), (-y, floor + 0.06), (-y, nose - 0.08), (-y + 0.08, nose)]
    hull += [(front, belt), (y, belt), (y, floor)]
    plan = [(x * 0.86, -y), (x, -y * 0.8), (x, y)]
    line = (front, front + draw(0.34, 0.4), back - draw(0.04, 0.1), back)
    middle, half = (back + y) / 2 - 0.05, (y - back) / 2 - 0.14
    bar = box((0, back + 0.28, roof - 0.37), (x - 0.07, 0.1, 0.32))
    hoop = cut(bar, box((0, back, roof - 0.57), (x - 0.28, 1, 0.32)))
    cab, glass = greenhouse(x, belt, roof, line)
    body = join(cut(outlined(hull, plan), box((0, middle, belt), (x - 0.15, half, 0.26))), cab)
    tyres, hubs = wheels(x - 0.09, [(v, wheel) for v in axles], 0.15)
    return {
        "body": join(body, hoop) if draw.chance(0.4) else body,
        "windows": glass,
        "wheels": tyres,
        "trim": join(
            hubs,
            both(box((0, y + 0.01, floor + 0.02), (x * 0.94, 0.1, 0.1)), 1),
            box((0, -y, eyes), (x - 0.34, 0.07, 0.1)),
        ),
        "lamps": both(box((x - 0.2, -y + 0.02, eyes), (0.11, 0.1, 0.1))),
        "bed": box((0, middle, belt - 0.26), (x - 0.13, half + 0.03, 0.06)),
    }


def cabin(
    x: float, belt: float, roof: float, ys: tuple[float, float, float, float], post: float = 0.0
) -> tuple[Solid, Solid]:
    """A car's cabin, ``ys`` where its outline starts, has its roof and ends, and its windows."""
    edge, (front, first, last, back) = 0.06, ys
    low, high, sill = belt + 0.04, roof - 0.11, belt - 0.1
    outline = [(front, sill), (first, roof - edge), (last, roof - edge), (back, sill)]
    across = [(x * 0.92 - edge, sill), (x * 0.74 - edge, roof - edge)]
    line, walls = grown(prism(outline, 0, 1), edge), grown(prism(mirrored(across), 1, 2), edge)
    a, b = ((z - sill) / (roof - edge - sill) for z in (low, high))
    fronts = [front + (first - front) * t + 0.13 for t in (a, b)]
    backs = [back + (last - back) * t - 0.13 for t in (a, b)]
    light = [(fronts[0], low), (fronts[1], high), (backs[1], high), (backs[0], low)]
    lights = prism(light, 0, 1)
    if post:
        lights = cut(lights, box((0, post, belt), (2, 0.07, 2)))
    shields = prism(mirrored([(x * 0.76, low), (x * 0.6, high)]), 1, 2)
    panes = join(within(shields, grown(line, 0.045)), within(lights, grown(walls, 0.045)))
    return within(line, walls), panes


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


def dump_truck(draw: Draw) -> Parts:
    """A cab with a hood, behind it a tub that is full, or raised and empty."""
    x, y, wheel, floor = draw(0.56, 0.66), draw(1.2, 1.32), draw(0.3, 0.36), draw(0.6, 0.68)
    top, rim, split = draw(1.16, 1.3), draw(1.1, 1.26), -y * draw(0.3, 0.36)
    raised, tip = draw.chance(0.4), draw(28, 36)
    side = [(split + 0.1, floor), (split, top + 0.14), (y - 0.02, rim), (y - 0.22, floor)]
    hollow = [(split + 0.27, floor + 0.17), (split + 0.17, 2), (y + 0.5, 2), (y - 0.2, rim + 0.2),
              (y - 0.34, floor + 0.17)]  # fmt: skip
    visor = box((0, split - 0.2, top + 0.12), (x * 0.92, 0.32, 0.08), 0.02)
    ribs = [box((x, v, (floor + rim) / 2), (0.07, 0.09, (rim - floor) / 2)) for v in (0.05, 0.6)]
    tub = join(cut(prism(side, 0, x), prism(hollow, 0, x - 0.16)), visor, both(join(*ribs)))
    at = (0, y - 0.24, floor)
    lifted = moved(turned(moved(tub, (0, -at[1], -at[2])), 0, -tip), at)
    tyres, hubs = wheels(x - 0.1, [(-y * 0.62, wheel), (y * 0.18, wheel), (y * 0.7, wheel)], 0.16)
    nose, deck = -y + 0.02, floor + 0.12
    jack = capsule((0, y * 0.1, floor - 0.1), (0, -0.12, floor + 0.42), 0.11)
    parts = {
        "body": join(
            box((0, (nose + split) / 2, (deck + 0.3) / 2), (x * 0.9, (split - nose) / 2,
                                                            (deck - 0.3) / 2), 0.05),
            box((0, split - 0.32, (top + 0.4) / 2), (x * 0.84, 0.28, (top - 0.4) / 2), 0.05),
            box((0, 0.1, floor - 0.14), (x * 0.6, y - 0.3, 0.15)),
            box((0, nose, 0.4), (x * 0.94, 0.1, 0.11), 0.03),
            *([jack] if raised else []),
        ),
        "bed": lifted if raised else tub,
        "windows": join(
            box((0, split - 0.6, (deck + top) / 2), (x * 0.66, 0.06, (top - deck) / 2 - 0.07)),
            both(box((x * 0.84, split - 0.34, (deck + top) / 2),
                     (0.06, 0.17, (top - deck) / 2 - 0.07))),
        ),
        "wheels": tyres,
        "hubs": join(hubs, both(box((x * 0.6, nose, deck - 0.14), (0.12, 0.08, 0.09), 0.03))),
    }  # fmt: skip
    middle = (split + y) / 2
    load = join(
        egg((0, middle - 0.12, rim - 0.06), (x - 0.12, 0.56, 0.32)),
        egg((0, middle + 0.2, rim - 0.08), (x - 0.14, 0.4, 0.2)),
    )
    return parts if raised else parts | {"load": load}


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


def cement_mixer(draw: Draw) -> Parts:
    """A cab, and on its frame a slanting drum with bands and a chute at its mouth."""
    x, y, wheel, floor = draw(0.52, 0.6), draw(1.24, 1.36), draw(0.29, 0.34), 0.5
    top, r, lean = draw(1.14, 1.28), draw(0.52, 0.6), draw(12, 18)
    long, split = y * 1.28, -y * 0.46
    drum = lathe(smooth_curve([(r * 0.5, 0), (r * 0.9, 0.16), (r, long * 0.38),
                               (r * 0.82, long * 0.64), (r * 0.5, long * 0.92),
                               (r * 0.46, long)]))  # fmt: skip
    bands = [turned(box((0, 0, long * s), (1, 1, 0.1)), 0, 24) for s in (0.16, 0.44, 0.7)]
    at = (0, split + 0.16, floor + 0.1 + r * 0.86)

    def laid(solid: Solid) -> Solid:
        return moved(turned(solid, 0, lean - 90), at)

    mouth = (at[1] + long * 0.96, at[2] + long * math.sin(math.radians(lean)))
    tyres, hubs = wheels(x - 0.08, [(-y * 0.66, wheel), (y * 0.26, wheel), (y * 0.76, wheel)], 0.15)
    z = top * 0.74
    chute = [(mouth[0] - 0.12, mouth[1] - 0.2), (mouth[0] + 0.12, mouth[1] - 0.2),
             (y + 0.2, floor + 0.02), (y - 0.02, floor + 0.02)]  # fmt: skip
    return {
        "cab": join(
            box((0, (split - y) / 2, (top + 0.3) / 2), (x, (split + y) / 2, (top - 0.3) / 2), 0.08),
            box((0, -y, 0.38), (x * 0.96, 0.1, 0.1), 0.03),
        ),
        "drum": laid(cut(drum, tube((0, 0, long - 0.16), (0, 0, long + 1), r * 0.3))),
        "stripes": laid(within(grown(drum, 0.05), join(*bands))),
        "windows": join(
            box((0, -y, z), (x * 0.78, 0.07, top * 0.15), 0.02),
            both(box((x, (split - y) / 2, z), (0.06, y * 0.16, top * 0.15), 0.02)),
        ),
        "wheels": tyres,
        "frame": join(
            hubs,
            box((0, 0.1, floor - 0.1), (x * 0.74, y - 0.14, 0.12)),
            box((0, mouth[0] - 0.26, (floor + mouth[1]) / 2 - 0.1), (0.3, 0.1, mouth[1] * 0.26)),
            prism(chute, 0, 0.17),
            both(box((x * 0.62, -y, 0.56), (0.11, 0.07, 0.08), 0.03)),
        ),
    }


def fire_truck(draw: Draw) -> Parts:
    """A long truck with a ladder on its roof."""
    x, y, top, wheel = draw(0.5, 0.58), draw(1.25, 1.4), draw(0.98, 1.1), draw(0.25, 0.29)
    cab, high = draw(0.36, 0.44), draw(0.2, 0.34)
    a, b = (y - 0.1, top + 0.16), (-y + 0.1, top + 0.16 + high)
    rails = both(prism(strip(a, b, 0.08), 0, 0.07, 0.22))
    steps = [
        tuple(p + (q - p) * t for p, q in zip(a, b, strict=True)) for t in (0.1, 0.37, 0.64, 0.9)
    ]
    locker = (box((x, v, 0.66), (0.05, y * 0.16, 0.2), 0.02) for v in (0.0, y * 0.36, y * 0.72))
    return {
        "body": join(
            box((0, 0, (top + 0.26) / 2), (x, y, (top - 0.26) / 2), 0.06),
            box((0, y - 0.45, top + 0.05), (0.24, 0.3, 0.14)),
        ),
        "ladder": join(rails, *(tube((-0.24, v, z), (0.24, v, z), 0.07) for v, z in steps)),
        "windows": join(
            box((0, -y, top * 0.74), (x * 0.84, 0.05, top * 0.16), 0.02),
            both(box((x, -y + cab, top * 0.74), (0.05, cab * 0.6, top * 0.15), 0.02)),
        ),
        "wheels": disc_wheels(
            x * 0.92, (-y * 0.6, y * 0.42, y * 0.82)[: 2 + draw.chance(0.5)], wheel
        ),
        "lockers": both(join(*locker)),
        "light": box((0, -y + cab, top + 0.04), (x * 0.75, 0.13, 0.13), 0.04),
    }


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


TRUCKS_AND_BUSES = {
    "bus": bus,
    "double decker bus": double_decker_bus,
    "truck": truck,
    "pickup truck": pickup_truck,
    "monster truck": monster_truck,
    "dump truck": dump_truck,
    "garbage truck": garbage_truck,
    "cement mixer": cement_mixer,
    "fire truck": fire_truck,
    "trailer": fitted(trailer),
}
