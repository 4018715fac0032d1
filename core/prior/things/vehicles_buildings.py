"""Vehicles and buildings."""

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
    join,
    lathe,
    mirrored,
    moved,
    prism,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.haulage import pane


def _wheels(x: float, ys: tuple[float, ...], radius: float, thick: float = 0.12):
    """Pairs of wheels on axles along x, standing on the floor."""
    pairs = (tube((x - thick, y, radius), (x + thick, y, radius), radius, 0.04) for y in ys)
    return both(join(*pairs))


def _rimmed(x: float, y: float, radius: float, half: float = 0.11) -> tuple[Solid, Solid]:
    """A tyre on an axle along x, on the floor, its outer side hollow, and the hub in it."""
    face = x + half
    hollow = tube((face - 0.06, y, radius), (face + 1, y, radius), radius * 0.66)
    tyre = cut(tube((x - half, y, radius), (face, y, radius), radius, 0.04), hollow)
    return tyre, tube((x, y, radius), (face - 0.02, y, radius), radius * 0.5, 0.03)


def car(draw: Draw) -> Parts:
    """A car with a hood, a cabin and a short boot, its wheels in arches, all of plane faces."""
    x, y, wheel = draw(0.62, 0.68), draw(1.26, 1.38), draw(0.28, 0.31)
    belt, roof, nose = draw(0.74, 0.8), draw(1.16, 1.24), draw(0.6, 0.66)
    front, back = -y * draw(0.34, 0.4), y * draw(0.74, 0.82)
    axles, side = (-y * 0.6, y * 0.6), x * 0.76  # the cabin's half width, and where arches end
    eyes = nose - 0.16
    hull = [(-y, 0.22), (-y, nose - 0.06), (-y + 0.08, nose), (front, belt), (y - 0.05, belt)]
    hull += [(y, belt - 0.05), (y, 0.22)]
    roofline = [(front - 0.02, belt - 0.1), (front + 0.42, roof), (back - 0.4, roof)]
    roofline += [(back, belt - 0.1)]
    arches = (tube((side, v, wheel), (2, v, wheel), wheel + 0.07) for v in axles)
    low, high, post = belt + 0.05, roof - 0.11, (front + back) / 2 + 0.02
    lights = (
        [(front + 0.2, low), (front + 0.44, high), (post - 0.07, high), (post - 0.07, low)],
        [(post + 0.07, low), (post + 0.07, high), (back - 0.44, high), (back - 0.2, low)],
    )
    slants = ((front, front + 0.42, -1), (back, back - 0.4, 1))
    panes = (pane((a, belt - 0.1), (b, roof), s, side - 0.1) for a, b, s in slants)
    tyres, hubs = zip(*(_rimmed(x - 0.1, v, wheel) for v in axles), strict=True)
    return {
        "body": join(cut(prism(hull, 0, x), both(join(*arches))), prism(roofline, 0, side)),
        "windows": join(*panes, *(both(prism(light, 0, 0.06, side)) for light in lights)),
        "wheels": both(join(*tyres)),
        "lamps": both(tube((x * 0.66, -y - 0.06, eyes), (x * 0.66, -y + 0.1, eyes), 0.1)),
        "hubs": both(join(*hubs)),
    }


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
        "wheels": _wheels(x * 0.92, (-y * 0.62, y * 0.6), wheel),
        "lamps": both(ball((x * 0.64, -y, 0.42), 0.1)),
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
        "wheels": _wheels(x * 0.86, (-y + cab * 0.95, y * 0.25, y * 0.72), wheel),
    }


def airplane(draw: Draw) -> Parts:
    """A plump airliner: swept wings, a great engine hung under each, portholes, a tall fin."""
    r, span, sweep = draw(0.29, 0.31), draw(1.24, 1.32), draw(0.46, 0.54)
    nose, tail, half, low = -1.3, draw(1.26, 1.32), 0.08, -0.17
    out = [(0.0, 0.0), (0.36, 0.02), (0.76, 0.16), (0.95, 0.38), (1.0, 0.6), (1.0, 1.2), (1.0, 1.7)]
    shape = smooth_curve([*((r * u, v) for u, v in out), (r * 0.8, 2.1), (0.1, tail - nose)])

    def fuselage(more: float) -> Solid:
        return tilted(turned(lathe(shape, more), 0, 180), 90, (0, nose, 0))

    wing = [(0, -0.44), (r, -0.4), (span, sweep), (span, sweep + 0.26), (r + 0.2, 0.3), (0, 0.3)]
    rear = [(0, tail - 0.5), (0.6, tail - 0.14), (0.6, tail + 0.1), (0, tail - 0.06)]
    fin = [(tail - 0.74, 0.1), (tail - 0.7, r - 0.04), (tail - 0.2, r + 0.6),
           (tail + 0.12, r + 0.6), (tail - 0.06, 0.1)]  # fmt: skip
    x, y, z = span * 0.43, -0.2, low - 0.44
    barrel = [(0.19, 0.0), (0.225, 0.06), (0.225, 0.3), (0.14, 0.62)]
    screen = [(nose + 0.18, 0.05), (nose + 0.46, 0.05), (nose + 0.54, r + 0.1),
              (nose + 0.32, r + 0.1)]  # fmt: skip
    panes = (capsule((r, v, 0.04), (r, v, 0.14), 0.08) for v in (-0.52, -0.26, 0.0, 0.26, 0.52))
    return {
        "body": fuselage(0.0),
        "wings": both(prism(wing, 2, half, low)),
        "windows": join(within(fuselage(0.08), prism(screen, 0, 1)), both(join(*panes))),
        "engines": both(
            join(
                cut(tilted(turned(lathe(barrel), 0, 180), 90, (x, y - 0.3, z)),
                    tube((x, y - 1, z), (x, y - 0.18, z), 0.13)),
                box((x, y + 0.04, low - 0.2), (0.07, 0.16, 0.18)),
            )
        ),
        "tail": join(both(prism(rear, 2, half, 0.06)), prism(fin, 0, half)),
    }  # fmt: skip


def boat(draw: Draw) -> Parts:
    """A sailing boat, its bow to the front."""
    wide, long, deep = draw(0.42, 0.5), draw(0.95, 1.1), draw(0.42, 0.5)
    hull = cut(egg((0, 0, 0.5), (wide, long, deep * 1.1)), box((0, 0, 1.5), (2, 2, 1)))
    deck = cut(egg((0, 0, 0.5), (wide - 0.11, long - 0.16, 0.16)), box((0, 0, -1), (2, 2, 1)))
    top, y = draw(2.2, 2.5), -0.12
    sail = [(y + 0.12, 0.78), (long * 0.8, 0.82), (y + 0.12, top)]
    jib = [(y - 0.12, 0.78), (-long * 0.85, 0.72), (y - 0.12, top * 0.82)]
    return {
        "hull": cut(hull, deck),
        "sails": join(prism(sail, 0, 0.08), prism(jib, 0, 0.08)),
        "mast": capsule((0, y, 0.2), (0, y, top + 0.08), 0.1),
    }


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
    pairs = (_rimmed(0.56, v, r) for v, r in ((-y * 0.6, small), (-0.02, big), (rear, big)))
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


def cottage(draw: Draw) -> Parts:
    """A low gabled house with a thick roof, its door in the gable, a chimney at its side."""
    x, y, wall = draw(0.72, 0.82), draw(0.75, 0.95), draw(0.62, 0.75)
    ridge, eave, thick = wall + draw(0.8, 0.95), draw(0.18, 0.24), 0.2
    gable = [(-x, 0), (x, 0), (x, wall), (0, ridge - 0.1), (-x, wall)]
    slope = (ridge - wall) / x
    low = wall - eave * slope
    outer = [(-x - eave, low), (0, ridge), (x + eave, low), (x + eave, low + thick)]
    roof = prism([*outer, (0, ridge + thick * 1.3), (-x - eave, low + thick)], 1, y + 0.12)
    parts = {
        "walls": prism(gable, 1, y),
        "roof": roof,
        "door": box((0, -y, 0.32), (0.2, 0.1, 0.32), 0.02),
        "windows": join(
            both(box((x * 0.63, -y, wall * 0.6), (0.17, 0.1, 0.19))),
            both(box((x, 0.0, wall * 0.52), (0.1, y * 0.32, 0.17))),
        ),
    }
    if draw.has("chimney", 0.8):
        parts |= {
            "chimney": box((x * 0.55, y * 0.45, ridge * 0.5 + 0.2), (0.14, 0.14, ridge * 0.5 + 0.2))
        }
    return parts


def tower(draw: Draw) -> Parts:
    """A castle's round tower with six battlements."""
    radius, high, rise = draw(0.5, 0.6), draw(1.55, 1.85), draw(0.26, 0.34)
    rim, deck = radius + 0.16, high + 0.3
    slit = box((0, 0.05 - radius, high * 0.66), (0.1, 0.1, 0.2))
    side = [(radius + 0.1, 0), (radius + 0.1, 0.2), (radius, 0.2), (radius, high), (rim, high)]
    return {
        "walls": lathe([*side, (rim, deck)]),
        "door": join(
            box((0, 0.02 - radius, 0.25), (0.22, 0.16, 0.25)),
            tube((0, -radius - 0.14, 0.5), (0, -radius + 0.18, 0.5), 0.22),
        ),
        "windows": join(slit, both(turned(slit, 2, 90))),
        "battlements": around(6, box((rim - 0.13, 0, deck + rise / 2), (0.13, 0.2, rise / 2)), -90),
    }


def lighthouse(draw: Draw) -> Parts:
    """A tapered tower with a gallery and a lantern."""
    low, high, top = draw(0.46, 0.54), draw(1.55, 1.8), draw(0.3, 0.34)
    shape = [(low, 0.1), (top + 0.04, high * 0.6), (top, high)]
    return {
        "tower": lathe(shape, 0.01),
        "lantern": tube((0, 0, high + 0.1), (0, 0, high + 0.48), top * 0.72),
        "roof": lathe([(top + 0.06, high + 0.45), (0.02, high + 0.45 + draw(0.3, 0.4))], 0.04),
        "base": join(
            tube((0, 0, 0), (0, 0, 0.16), draw(0.66, 0.76), 0.04),
            tube((0, 0, high - 0.03), (0, 0, high + 0.14), top + 0.18, 0.03),
        ),
        "door": box((0, -low, 0.4), (0.15, 0.13, 0.25), 0.02),
    }


def church(draw: Draw) -> Parts:
    """A nave behind a tower with a spire."""
    x, y, wall = draw(0.5, 0.58), draw(0.75, 0.85), draw(0.72, 0.85)
    ridge, side, high = wall + draw(0.5, 0.62), draw(0.27, 0.32), draw(1.35, 1.55)
    front = -y + 0.1
    nave = [(-x, 0), (x, 0), (x, wall), (0, ridge), (-x, wall)]
    roof = [
        (-x - 0.1, wall - 0.1),
        (0, ridge + 0.0),
        (x + 0.1, wall - 0.1),
        (x + 0.1, wall + 0.06),
        (0, ridge + 0.17),
    ]
    spire = moved(
        turned(around(4, prism([(0, 0), (side + 0.1, 0), (0, draw(0.85, 1.0))], 1, 0.6)), 2, 0),
        (0, front, high),
    )
    return {
        "walls": join(prism(nave, 1, y), box((0, front, high / 2), (side, side, high / 2))),
        "roof": join(prism([*roof, (-x - 0.1, wall + 0.06)], 1, y + 0.08), spire),
        "door": box((0, front - side, 0.28), (0.16, 0.08, 0.28), 0.02),
        "windows": join(
            both(
                join(*(box((x, y * s, wall * 0.55), (0.06, 0.1, 0.2), 0.02) for s in (-0.05, 0.55)))
            ),
            tube((0, front - side - 0.06, high * 0.72), (0, front, high * 0.72), 0.14),
        ),
    }


def arch(draw: Draw) -> Parts:
    """A gate of stone."""
    x, y, gap, top = draw(0.9, 1.05), draw(0.28, 0.38), draw(0.44, 0.52), draw(1.7, 1.95)
    spring = draw(0.75, 0.95)
    opening = join(tube((0, -1, spring), (0, 1, spring), gap), box((0, 0, spring - 2), (gap, 1, 2)))
    plinth = both(box(((gap + x) / 2 + 0.02, 0, 0.13), ((x - gap) / 2 + 0.1, y + 0.1, 0.13), 0.02))
    return {
        "body": cut(box((0, 0, top / 2), (x, y, top / 2), 0.02), opening),
        "cornice": join(box((0, 0, top), (x + 0.13, y + 0.12, 0.12), 0.02), plinth),
    }


VEHICLES_BUILDINGS = {
    "car": car,
    "bus": bus,
    "truck": truck,
    "airplane": airplane,
    "boat": boat,
    "train": train,
    "cottage": cottage,
    "tower": tower,
    "lighthouse": lighthouse,
    "church": church,
    "arch": arch,
}
