"""Trains, carts and a sleigh."""

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
from core.prior.things.shared.wheels import disc_wheel, disc_wheels, rimmed_wheel


def train(draw: Draw) -> Parts:
    """A steam engine, its boiler to the front."""
    radius, y, floor = draw(0.35, 0.4), draw(1.12, 1.24), draw(0.44, 0.5)
    z, half, big, small = floor + radius, draw(0.38, 0.44), draw(0.29, 0.32), 0.22
    roof, rear = z + radius + draw(0.42, 0.5), y - half
    # The plough is a ramp with a prow.
    ramp = [(-y - 0.42, 0.05), (-y + 0.12, 0.05), (-y + 0.12, 0.5), (-y - 0.05, 0.5)]
    prow = mirrored([(0.1, -y - 0.44), (0.46, -y + 0.04), (0.46, -y + 0.2)])
    ahead = box((0.24, rear - half, roof - 0.24), (0.13, 0.05, 0.12), 0.02)
    arc = [(0.62 * math.sin(a), roof + 0.26 * math.cos(a)) for a in (0, 0.4, 0.8, 1.2, 1.57)]
    pairs = (rimmed_wheel(0.56, v, r) for v, r in ((-y * 0.6, small), (-0.02, big), (rear, big)))
    rod = box((0.64, rear / 2, big), (0.1, rear / 2 + 0.12, 0.09), 0.02)
    return {
        "boiler": join(
            tube((0, -y + 0.05, z), (0, rear - half + 0.1, z), radius, 0.03),
            tube((0, -y - 0.02, z), (0, -y + 0.1, z), radius * 0.62, 0.04),
            tube((0, -y + 0.16, z), (0, -y + 0.34, z), radius + 0.04, 0.02),
            capsule((0, 0.02, z), (0, 0.02, z + radius + 0.08), 0.17),
        ),
        "cab": join(
            box((0, rear, (floor + roof) / 2), (0.48, half, (roof - floor) / 2)),
            prism(mirrored([*arc, (0.62, roof - 0.14)]), 1, half + 0.12, rear),
        ),
        "chimney": lathe(
            [(0.14, z), (0.14, z + radius + 0.16), (0.25, z + radius + 0.42)], 0.02, (0, -y + 0.42)
        ),
        "frame": join(
            box((0, 0, floor - 0.08), (0.46, y, 0.1)),
            within(prism(ramp, 0, 1), prism(prow, 2, 2)),
            both(rod),
        ),
        "wheels": both(join(*(solid for pair in pairs for solid in pair))),
        "windows": join(box((0, rear, roof - 0.3), (0.52, half - 0.19, 0.2), 0.02), both(ahead)),
        "lamp": tube((0, -y - 0.06, z + radius), (0, -y + 0.3, z + radius), 0.13, 0.03),
    }


def tram(draw: Draw) -> Parts:
    """A rail car with rows of windows and a pantograph."""
    x, y, top = draw(0.44, 0.52), draw(1.3, 1.46), draw(1.1, 1.26)
    half = (0.05, y * 0.16, top * 0.16)
    row = (box((x, y * s, top * 0.7), half) for s in (-0.69, -0.23, 0.23, 0.69))
    ends = both(box((0, y, top * 0.7), (x * 0.72, 0.05, top * 0.16)), 1)
    return {
        "body": box((0, 0, (top + 0.2) / 2), (x, y, (top - 0.2) / 2), 0.06),
        "windows": join(both(join(*row)), ends),
        "stripe": box((0, 0, top * 0.4), (x + 0.05, y + 0.05, 0.09)),
        "wheels": disc_wheels(x * 0.7, (-y * 0.7, -y * 0.36, y * 0.36, y * 0.7), 0.22, 0.14),
        "roof": join(
            box((0, 0, top + 0.03), (x * 0.7, y * 0.84, 0.11)),
            both(capsule((0, 0, top + 0.5), (0, 0.4, top + 0.1), 0.09), 1),
            box((0, 0, top + 0.54), (0.4, 0.1, 0.09)),
        ),
    }


def minecart(draw: Draw) -> Parts:
    """A tub of planks in iron bands, heaped with ore, on four wheels, often on rails."""
    x, y, top, r = draw(0.56, 0.64), draw(0.84, 0.94), draw(1.2, 1.34), draw(0.3, 0.34)
    rail, low, slope, axle = draw.chance(0.6), 0.52, draw(0.74, 0.8), y * 0.5
    side = [(-y * slope, low), (y * slope, low), (y, top), (-y, top)]
    rim = cut(box((0, 0, top), (x + 0.1, y + 0.1, 0.11)), box((0, 0, top), (x - 0.12, y - 0.12, 1)))
    straps = both(box((x - 0.02, y * 0.44, (low + top) / 2), (0.09, 0.1, (top - low) / 2)), 0, 1)
    rocks = [box((u * x, v * y, top + 0.1), (0.19, 0.19, h), 0.05)
             for u, v, h in ((0.42, 0.5, 0.16), (0.42, -0.5, 0.16), (-0.42, -0.5, 0.2),
                             (-0.42, 0.5, 0.2))]  # fmt: skip
    wheel = join(tube((x - 0.08, axle, r), (x + 0.15, axle, r), r, 0.03),
                 tube((x, axle, r), (x + 0.24, axle, r), r * 0.45, 0.02))  # fmt: skip
    parts = {
        "box": prism(side, 0, x),
        "bands": join(rim, straps, box((0, 0, low), (x + 0.07, y * slope + 0.08, 0.1))),
        "ore": join(
            box((0, 0, top), (x - 0.08, y - 0.08, 0.06)),
            *rocks,
            turned(box((0, 0, top + 0.16), (0.25, 0.25, 0.24), 0.05), 2, 45),
        ),
        "wheels": join(both(wheel, 0, 1), both(tube((-x, axle, r), (x, axle, r), 0.1), 1)),
    }
    track = {
        "rails": both(box((x + 0.04, 0, -0.05), (0.1, 1.25, 0.1), 0.02)),
        "sleepers": both(
            join(*(box((0, v, -0.2), (x + 0.32, 0.16, 0.1), 0.02) for v in (0.32, 0.96))), 1
        ),
    }
    return parts | track if rail else parts


def wheelbarrow(draw: Draw) -> Parts:
    """A tray on one wheel, two handles, two legs."""
    x, r, floor, top = draw(0.46, 0.54), draw(0.28, 0.34), draw(0.56, 0.62), draw(1.05, 1.2)
    side = [(-0.85, top), (-0.4, floor), (0.45, floor), (0.7, top)]
    hollow = [(-0.72, top + 0.02), (-0.36, floor + 0.13), (0.4, floor + 0.13), (0.58, top + 0.02)]
    rail = capsule((0.1, -0.85, r), (x - 0.08, 1.2, draw(0.72, 0.9)), 0.09)
    leg = capsule((x * 0.6, 0.5, 0.6), (x * 0.75, 0.55, 0.1), 0.09)
    return {
        "tray": cut(prism(side, 0, x), prism(hollow, 0, x - 0.12)),
        "wheel": disc_wheel(0, -0.85, r, r, 0.12),
        "frame": both(join(rail, leg)),
        "handles": both(capsule((x - 0.09, 1.0, 0.78), (x - 0.06, 1.36, 0.86), 0.12)),
    }


def wagon(draw: Draw) -> Parts:
    """A cart on four spoked wheels with a shaft; often with a canvas cover on hoops."""
    x, y, r, floor = draw(0.46, 0.54), draw(0.92, 1.0), draw(0.47, 0.51), draw(0.62, 0.7)
    top, covered = floor + draw(0.36, 0.44), draw.chance(0.6)
    tray = box((0, 0, (floor + top) / 2), (x, y, (top - floor) / 2), 0.02)
    hole = box((0, 0, top + 0.1), (x - 0.15, y - 0.15, top - floor - 0.06))
    bars = join(*(box((0, 0, 0), (0.07, *half)) for half in ((r - 0.1, 0.07), (0.07, r - 0.1))))
    hub = tube((-0.1, 0, 0), (0.14, 0, 0), 0.13)
    wheel = moved(join(ring((0, 0, 0), r - 0.09, 0.09, 0), bars, hub), (x + 0.14, y * 0.62, r))
    low, front, block = floor - 0.06, -y - 0.42, (floor - r) / 2 + 0.04
    axle = join(
        tube((-x - 0.1, y * 0.62, r), (x + 0.1, y * 0.62, r), 0.1),
        box((0, y * 0.62, r + block), (x * 0.7, 0.13, block)),
    )
    shaft = join(
        tube((0, -y + 0.2, low), (0, front, low), 0.1, 0.02),
        tube((-0.32, front, low), (0.32, front, low), 0.11, 0.03),
    )

    def hoop(out: float, middle: float, half: float) -> Solid:
        wide, rise = x + out, x * 0.3 + top
        arch = [(wide * math.cos(math.pi * k / 16), rise + wide * math.sin(math.pi * k / 16))
                for k in range(17)]  # fmt: skip
        return prism([(wide, top - 0.06), *arch, (-wide, top - 0.06)], 1, half, middle)

    hoops = [hoop(0.13, s * (y - 0.12), 0.12) for s in (-1, 0, 1)]
    parts = {
        "body": join(tray if covered else cut(tray, hole), both(axle, 1)),
        "wheels": both(wheel, 0, 1),
        "handle": shaft,
    }
    return parts | {"cover": join(hoop(0.05, 0, y - 0.05), *hoops)} if covered else parts


def stagecoach(draw: Draw) -> Parts:
    """A rounded body with a door between spoked wheels, the driver's seat, trunks on top."""
    x, big, small = draw(0.46, 0.54), draw(0.54, 0.62), draw(0.42, 0.48)
    low, top, half = draw(0.54, 0.62), draw(1.5, 1.66), draw(0.68, 0.77)
    belly = smooth_curve([(half, top), (half * 0.96, low + 0.46), (half * 0.62, low + 0.08),
                          (0.0, low)])  # fmt: skip
    z, pane, seat = top - 0.3, half * 0.2, top - 0.34
    windows = [box((x, s * half * 0.6, z), (0.06, pane * 0.9, 0.16)) for s in (-1, 1)]

    def wheel(y: float, r: float) -> Solid:
        rim = cut(
            tube((x + 0.1, y, r), (x + 0.28, y, r), r, 0.02),
            tube((x, y, r), (x + 1, y, r), r - 0.14),
        )
        spokes = turned(around(5, box((r / 2, 0, 0), (r / 2 - 0.05, 0.075, 0.075))), 1, 90)
        hub = tube((x + 0.08, y, r), (x + 0.34, y, r), 0.13, 0.03)
        return join(rim, moved(spokes, (x + 0.19, y, r)), hub)

    front, rear = -half - 0.22, half + 0.12
    box_seat = [(-half + 0.1, low + 0.3), (-half + 0.1, seat - 0.1), (front - 0.2, seat - 0.1),
                (front - 0.32, low + 0.3), (front - 0.2, low + 0.2)]  # fmt: skip
    boot = [(half - 0.05, low + 0.3), (half - 0.05, top - 0.3), (half + 0.38, low + 0.44),
            (half + 0.34, low + 0.24)]  # fmt: skip
    axles = ((front, small), (rear, big))
    return {
        "body": join(prism(mirrored(belly), 0, x), prism(box_seat, 0, x * 0.82)),
        "roof": box((0, 0, top + 0.04), (x + 0.08, half + 0.12, 0.1), 0.04),
        "windows": both(join(*windows, box((x, 0, z), (0.11, pane * 0.7, 0.14)))),
        "wheels": both(join(*(wheel(v, r) for v, r in axles))),
        "frame": join(
            both(box((x, 0, (low + top) / 2 + 0.04), (0.07, pane * 1.2, (top - low) / 2 - 0.1))),
            both(ball((x + 0.04, -half - 0.02, z - 0.04), 0.12)),
            box((0, (front + rear) / 2, big * 0.9), (0.13, (rear - front) / 2 + 0.1, 0.1)),
            *(tube((-x - 0.2, v, r), (x + 0.2, v, r), 0.1) for v, r in axles),
            box((0, front + 0.1, 0.56), (0.13, 0.13, 0.24)),
            capsule((0, front, small + 0.04), (0, front - 0.38, small + 0.02), 0.1),
        ),
        "luggage": join(
            box((0, half * 0.42, top + 0.28), (x * 0.7, half * 0.4, 0.2), 0.05),
            box((0, -half * 0.46, top + 0.22), (x * 0.56, half * 0.34, 0.14), 0.05),
            box((0, front + 0.02, seat), (x * 0.86, 0.22, 0.11), 0.05),
            prism(boot, 0, x * 0.8),
        ),
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


TRAINS_AND_CARTS = {
    "train": train,
    "tram": tram,
    "minecart": minecart,
    "wheelbarrow": wheelbarrow,
    "wagon": wagon,
    "stagecoach": stagecoach,
    "sleigh": sleigh,
}
