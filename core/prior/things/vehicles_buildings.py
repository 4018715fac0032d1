"""Vehicles and buildings."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    taper,
    tube,
    turned,
)


def _wheels(x: float, ys: tuple[float, ...], radius: float, thick: float = 0.12):
    """Pairs of wheels on axles along x, standing on the floor."""
    pairs = (tube((x - thick, y, radius), (x + thick, y, radius), radius, 0.04) for y in ys)
    return both(join(*pairs))


def car(draw: Draw) -> Parts:
    """A small car, its lamps to the front."""
    x, y, wheel = draw(0.55, 0.63), draw(1.1, 1.25), draw(0.25, 0.29)
    hood, roof = draw(0.72, 0.8), draw(1.18, 1.32)
    front, back = -y * draw(0.4, 0.5), y * draw(0.7, 0.82)
    cabin = [(front, hood - 0.1), (back, hood - 0.1), (back - 0.2, roof), (front + 0.34, roof)]
    glass = [(front + 0.02, hood + 0.02), (back - 0.0, hood + 0.02), (back - 0.16, roof - 0.12)]
    glass += [(front + 0.32, roof - 0.12)]
    pane = prism([(b * 0.86 + 0.03, c) for b, c in glass], 0, x * 0.94)
    return {
        "body": join(
            box((0, 0, (hood + 0.24) / 2), (x, y, (hood - 0.24) / 2), 0.12),
            prism(cabin, 0, x * 0.86),
        ),
        "windows": join(pane, prism(glass, 0, x * 0.74)),
        "wheels": _wheels(x * 0.95, (-y * 0.6, y * 0.6), wheel),
        "lamps": both(ball((x * 0.62, -y + 0.02, hood - 0.24), 0.12)),
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
    """Nose to the front."""
    radius, nose, tail, span = draw(0.22, 0.26), -1.2, draw(1.1, 1.25), draw(1.2, 1.4)
    sweep, chord = draw(0.1, 0.45), draw(0.26, 0.32)
    wing = [
        (0, -0.25 - chord),
        (span, sweep - chord * 0.2),
        (span, sweep + chord),
        (0, -0.25 + chord * 1.4),
    ]
    rear = [(0, tail - 0.4), (0.52, tail - 0.1), (0.52, tail + 0.16), (0, tail + 0.08)]
    fin = [
        (tail - 0.5, 0.1),
        (tail - 0.05, radius + draw(0.45, 0.55)),
        (tail + 0.2, radius + 0.45),
        (tail + 0.06, 0.1),
    ]
    return {
        "body": join(
            taper((0, nose + 0.2, 0), (0, 0.2, 0), radius * 0.9, radius),
            taper((0, 0.2, 0), (0, tail, 0.08), radius, 0.1),
        ),
        "wings": join(
            both(prism(wing, 2, 0.08, -0.04)), both(prism(rear, 2, 0.08, 0.08)), prism(fin, 0, 0.08)
        ),
        "windows": egg((0, nose + 0.38, radius * 0.55), (radius * 0.75, 0.26, radius * 0.7)),
        "engines": both(tube((span * 0.45, -0.55, -0.16), (span * 0.45, 0.0, -0.16), 0.14, 0.04)),
    }


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
    radius, y, floor = draw(0.34, 0.4), draw(1.1, 1.25), draw(0.42, 0.48)
    z, cab = floor + radius, draw(0.32, 0.38)
    plough = [(-y - 0.05, 0.4), (-y - 0.38, 0.06), (-y + 0.1, 0.06), (-y + 0.1, 0.4)]
    big, small = draw(0.27, 0.31), 0.2
    wheels = [
        tube((0.36, v, r), (0.56, v, r), r, 0.03)
        for v, r in ((-0.8, small), (-0.2, big), (0.45, big))
    ]
    return {
        "boiler": join(
            tube((0, -y + 0.05, z), (0, y - 2 * cab + 0.1, z), radius, 0.06),
            ball((0, 0.0, z + radius * 0.85), 0.2),
        ),
        "cab": join(
            box((0, y - cab, z + 0.22), (0.5, cab, radius + 0.16)),
            box((0, y - cab, z + radius + 0.44), (0.6, cab + 0.1, 0.08), 0.03),
        ),
        "chimney": lathe([(0.14, z), (0.14, z + 0.62), (0.24, z + 0.86)], 0.02, (0, -y + 0.4)),
        "frame": join(box((0, 0, floor - 0.06), (0.44, y, 0.09)), prism(plough, 0, 0.4)),
        "wheels": both(join(*wheels, tube((0.36, y - cab, big), (0.56, y - cab, big), big, 0.03))),
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
            both(box((x * 0.64, -y, wall * 0.62), (0.13, 0.06, 0.15))),
            both(box((x, 0.0, wall * 0.52), (0.06, y * 0.3, 0.15))),
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
    merlon = box((rim - 0.13, 0, deck + rise / 2), (0.13, 0.2, rise / 2 + 0.02))
    slit = box((0, -radius, high * 0.66), (0.1, 0.1, 0.2))
    return {
        "walls": join(
            tube((0, 0, 0), (0, 0, 0.2), radius + 0.1),
            tube((0, 0, 0), (0, 0, high + 0.1), radius),
            tube((0, 0, high), (0, 0, deck), rim),
            around(6, merlon, -90),
        ),
        "door": join(
            box((0, -radius, 0.25), (0.22, 0.2, 0.25)),
            tube((0, -radius - 0.2, 0.5), (0, -radius + 0.2, 0.5), 0.22),
        ),
        "windows": join(slit, both(turned(slit, 2, 90))),
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
