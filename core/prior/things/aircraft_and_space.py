"""Aircraft, spacecraft and a planet."""

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
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.fitted import fitted

LEAN_DEG = 23.0  # of a planet's axis, as the markings' (``markings/forms/globes.py``) of its globe


def airplane(draw: Draw) -> Parts:
    """A plump airliner: swept wings, a great engine under each, portholes, a tall fin.

    No part touches itself: fin, tailplanes and engines are drawn each as one exact shape."""
    r, span, sweep = draw(0.29, 0.31), draw(1.24, 1.32), draw(0.46, 0.54)
    nose, tail, half, low = -1.3, draw(1.26, 1.32), 0.08, -0.17
    out = [(0.0, 0.0), (0.36, 0.02), (0.76, 0.16), (0.95, 0.38), (1.0, 0.6), (1.0, 1.2), (1.0, 1.7)]
    shape = smooth_curve([*((r * u, v) for u, v in out), (r * 0.8, 2.1), (0.1, tail - nose)])

    def fuselage(more: float) -> Solid:
        return tilted(turned(lathe(shape, more), 0, 180), 90, (0, nose, 0))

    wing = [(0, -0.46), (span, sweep), (span, sweep + 0.26), (0, 0.34)]
    rear = [(0.14, tail - 0.56), (0.64, tail - 0.18), (0.64, tail + 0.06), (0.14, tail - 0.14)]
    fin = [(tail - 0.8, 0.2), (tail - 0.26, r + 0.62), (tail + 0.06, r + 0.62), (tail - 0.1, 0.1)]
    x, y, z = span * 0.43, -0.16, low - half - 0.17
    screen = [(nose + 0.18, 0.05), (nose + 0.46, 0.05), (nose + 0.54, r + 0.1),
              (nose + 0.32, r + 0.1)]  # fmt: skip
    panes = (capsule((r, v, 0.04), (r, v, 0.14), 0.08) for v in (-0.52, -0.26, 0.0, 0.26, 0.52))
    return {
        "body": fuselage(0.0),
        "wings": both(prism(wing, 2, half, low)),
        "windows": join(within(fuselage(0.08), prism(screen, 0, 1)), both(join(*panes))),
        "engines": both(tube((x, y - 0.36, z), (x, y + 0.34, z), 0.2, 0.05)),
        "tail": join(both(prism(rear, 2, half, -0.1)), prism(fin, 0, half)),
    }  # fmt: skip


def biplane(draw: Draw) -> Parts:
    """Two wings one above the other with struts, an engine, a propeller, wheels, a tail."""
    span, chord, r, tail = draw(1.2, 1.35), draw(0.26, 0.31), draw(0.22, 0.26), draw(1.1, 1.25)
    z, gap, nose = 0.62, draw(0.62, 0.7), -0.72
    low, top = z - 0.12, z - 0.12 + gap
    fin = [(tail - 0.42, z + 0.12), (tail - 0.16, z + 0.54), (tail + 0.1, z + 0.54),
           (tail + 0.02, z + 0.09)]  # fmt: skip
    rear = [(0.0, tail - 0.36), (0.46, tail - 0.18), (0.46, tail + 0.06), (0.0, tail - 0.02)]
    hull = [(r, nose + 0.2), (r, 0.1), (0.12, tail)]
    strut = [box((span * 0.66, v, (low + top) / 2), (0.065, 0.065, gap / 2)) for v in (-0.5, -0.16)]
    cabane = box((0.13, -0.33, (z + top) / 2), (0.065, 0.065, (top - z) / 2))
    blade = box((0.28, 0, 0), (0.28, 0.1, 0.06))
    wheel = 0.2
    return {
        "body": moved(turned(lathe([(u, -v) for u, v in reversed(hull)]), 0, 90), (0, 0, z)),
        "wings": join(
            box((0, -0.33, low), (span * 0.92, chord, 0.075), 0.03),
            box((0, -0.33, top), (span, chord, 0.075), 0.03),
            prism(fin, 0, 0.075),
            prism(mirrored(rear), 2, 0.075, z - 0.07),
        ),
        "struts": both(
            join(*strut, cabane, box((0.28, -0.42, low / 2 + 0.1), (0.065, 0.09, low / 2 - 0.06)))
        ),
        "engine": moved(
            turned(lathe([(r + 0.06, 0), (r + 0.06, 0.2), (r * 0.7, 0.32)], 0.02), 0, 90),
            (0, nose + 0.24, z),
        ),
        "propeller": moved(
            turned(
                join(around(2, blade, 90), lathe([(0.12, -0.1), (0.12, 0.04), (0.04, 0.18)])), 0, 90
            ),
            (0, nose - 0.1, z),
        ),
        "wheels": join(
            both(tube((0.2, -0.42, wheel), (0.4, -0.42, wheel), wheel)),
            tube((0, tail - 0.1, z - 0.22), (0, tail - 0.1, z), 0.08),
        ),
    }


def fighter_jet(draw: Draw) -> Parts:
    """A turned fuselage with a pointed nose, delta wings, twin tails that lean out, two nozzles, a
    canopy, and missiles at the ends of the wings."""
    r, nose, tail = draw(0.24, 0.27), draw(1.4, 1.55), draw(1.1, 1.2)
    span, sweep, up = draw(1.05, 1.2), draw(0.4, 0.52), draw(0.62, 0.74)
    x = 0.24
    wing = [(0.1, -0.75), (span, sweep), (span, sweep + 0.36), (0.1, 0.8)]
    rear = [(0.2, tail - 0.2), (0.74, tail + 0.08), (0.74, tail + 0.34), (0.2, tail + 0.2)]
    fin = [(-0.46, 0.0), (0.02, up), (0.3, up), (0.24, 0.0)]
    hull = [(r * 0.9, -tail), (r, 0.3), (r * 0.86, 0.7), (r * 0.52, nose - 0.24), (0.03, nose)]
    at = sweep + 0.2
    missile = capsule((span, at - 0.5, 0), (span, at + 0.3, 0), 0.11)
    return {
        # Its axis, upright, to lie along y, the nose to the front.
        "body": join(
            turned(lathe(smooth_curve(hull), 0.02), 0, 90),
            both(box((x, tail / 2 - 0.2, -0.03), (0.2, tail / 2 + 0.24, 0.2), 0.06)),
        ),
        "wings": prism(mirrored(wing), 2, 0.09),
        "canopy": egg((0, -0.56, r * 0.8), (0.19, 0.46, 0.25)),
        "tails": join(
            both(moved(turned(prism(fin, 0, 0.085), 1, 16), (x + 0.08, tail - 0.24, 0.1))),
            both(prism(rear, 2, 0.085)),
        ),
        "nozzles": both(tube((x, tail - 0.2, 0), (x, tail + 0.26, 0), 0.17, 0.02)),
        "missiles": both(missile),
    }


def helicopter(draw: Draw) -> Parts:
    """A round cabin with a glass nose, a tail boom, a rotor of two crossed blades, skids."""
    x, z, long = draw(0.52, 0.58), draw(0.86, 0.94), draw(0.72, 0.82)
    top, tail, reach = z + x + 0.22, draw(1.06, 1.16), draw(1.15, 1.3)
    fin = [(tail - 0.34, z + 0.1), (tail - 0.06, z + 0.66), (tail + 0.24, z + 0.66)]
    fin += [(tail + 0.16, z + 0.1)]
    blades = [turned(box((0, 0, top), (reach, 0.15, 0.085)), 2, a) for a in (45, -45)]
    cap = tube((0, 0, top - 0.1), (0, 0, top + 0.17), 0.22, 0.03)
    mast = join(tube((0, 0, z), (0, 0, top + 0.1), 0.12), cap)
    side, hub = x * 0.9, (tail + 0.04, z + 0.36)
    legs = (capsule((x * 0.5, v, z - 0.3), (side, v, 0.11), 0.1) for v in (-0.66, -0.02))
    return {
        "body": join(
            egg((0, -0.36, z), (x, long, x)),
            taper((0, 0, z + 0.12), (0, tail, z + 0.2), 0.26, 0.13),
            prism(fin, 0, 0.1),
        ),
        "windows": egg((0, -0.36 - long * 0.42, z + 0.09), (x * 0.88, long * 0.64, x * 0.78)),
        "rotor": moved(join(*blades, mast), (0, -0.36, 0)),
        "skids": both(join(capsule((side, -1.06, 0.11), (side, 0.38, 0.11), 0.11), *legs)),
        "tail rotor": join(
            *(box((0.22, *hub), (0.08, *size)) for size in ((0.1, 0.38), (0.38, 0.1))),
            tube((0, *hub), (0.36, *hub), 0.13),
        ),
    }


def hot_air_balloon(draw: Draw) -> Parts:
    """A large balloon above a basket."""
    r, z, side = draw(0.95, 1.1), draw(1.75, 1.9), draw(0.2, 0.26)
    low = z - r * draw(1.15, 1.3)
    shape = [(0.22, low), (0.55, low + 0.3), (r, z - 0.05), (r * 0.72, z + r * 0.68), (0.02, z + r)]
    rope = capsule((side * 0.9, side * 0.9, 0.3), (0.17, 0.17, low + 0.08), 0.075)
    ring_ = tube((0, 0, 0.36), (0, 0, 0.5), side * 1.3, 0.03)
    return {
        "balloon": lathe(smooth_curve(shape), 0.01),
        "basket": join(box((0, 0, 0.22), (side, side, 0.24), 0.04), ring_),
        "ropes": both(rope, 0, 1),
    }


def blimp(draw: Draw) -> Parts:
    """A long balloon with a nose cap and a band, four fins, a cabin with windows, two engines."""
    r, y, cabin = draw(0.55, 0.62), draw(1.4, 1.5), draw(0.42, 0.5)
    z, size, deep = 1.0, draw(0.42, 0.5), draw(0.16, 0.2)
    low = z - r
    hull = egg((0, 0, z), (r, y, r))
    coat = egg((0, 0, z), (r + 0.035, y + 0.03, r + 0.035))
    middle = box((0, 0, z), (2, 0.17, 2))
    nose = box((0, -y - 0.62, z), (2, 0.9, 2))
    cover = join(cut(coat, lambda p: -middle(p)), cut(coat, lambda p: -nose(p)))
    fin = [(0.1, y * 0.5), (r * 0.72 + size * 0.5, y * 0.82), (r * 0.72 + size * 0.5, y + 0.06)]
    fin.append((0.1, y * 0.92))
    fins = join(*(turned(prism(fin, 2, 0.075), 1, 45 + 90 * k) for k in range(4)))
    return {
        "balloon": hull,
        "band": cover,
        "fins": moved(fins, (0, 0, z)),
        "cabin": box((0, -0.1, low - deep + 0.12), (0.24, cabin, deep + 0.08), 0.08),
        "windows": both(box((0.18, -0.16, low - deep + 0.12), (0.1, cabin - 0.14, 0.085))),
        "engines": both(
            join(
                tube((0.36, 0.02, low - 0.02), (0.36, 0.38, low - 0.02), 0.11),
                box((0.26, 0.2, low - 0.02), (0.14, 0.07, 0.07)),
            )
        ),
    }


def rocket(draw: Draw) -> Parts:
    """A round window in front, four swept fins."""
    radius, shoulder, tip = draw(0.42, 0.48), draw(1.3, 1.45), draw(2.15, 2.4)
    hull = [(radius * 0.72, 0.24), (radius * 0.95, 0.6), (radius, 0.95), (radius, shoulder)]
    split = shoulder + 0.12
    nose = [(radius, shoulder), (radius * 0.75, shoulder + (tip - shoulder) * 0.5), (0.05, tip)]
    reach, high, z = radius + draw(0.36, 0.46), draw(0.78, 0.88), shoulder - draw(0.3, 0.36)
    fin = [(0, 0.26), (radius, 0.26), (reach, 0), (reach, 0.42), (radius - 0.05, high), (0, high)]
    fins = (prism(f, axis, 0.1) for axis in (0, 1) for f in (fin, [(-a, b) for a, b in fin[::-1]]))
    return {
        "hull": lathe(smooth_curve(hull, 4)),
        "nose": cut(lathe(smooth_curve(nose, 5)), box((0, 0, split - 1), (1, 1, 1))),
        "fins": join(*fins),
        "nozzle": lathe([(radius * 0.72, 0), (radius * 0.5, 0.3)]),
        "window": tube((0, -radius - 0.08, z), (0, 0, z), 0.2, 0.03),
        "rim": tube((0, -radius - 0.01, z), (0, 0, z), 0.3),
    }


def space_shuttle(draw: Draw) -> Parts:
    """A blunt body with delta wings, flying to the front."""
    r, y, span = draw(0.34, 0.4), draw(1.1, 1.25), draw(0.85, 1.0)
    wing = [(0, -0.75), (r + 0.05, -0.35), (span, 0.7), (span, 0.98), (0, 1.05)]
    fin = [(0.45, r * 0.6), (0.95, r + draw(0.5, 0.62)), (1.2, r + 0.55), (1.08, r * 0.6)]
    return {
        "body": join(
            tube((0, -y + 0.45, 0), (0, 1.0, 0), r, 0.04),
            taper((0, -y + 0.1, -0.08), (0, -y + 0.6, 0), 0.2, r),
        ),
        "wings": join(both(prism(wing, 2, 0.09, -r * 0.72)), prism(fin, 0, 0.09)),
        "nose": ball((0, -y + 0.05, -0.08), 0.21),
        "windows": box((0, -y + 0.34, r * 0.6), (r * 0.55, 0.12, 0.12), 0.04),
        "engines": join(
            moved(turned(lathe([(0.1, 0), (0.16, 0.28)], 0.02), 0, -90), (0, 0.95, r * 0.42)),
            both(moved(turned(lathe([(0.1, 0), (0.16, 0.28)], 0.02), 0, -90), (0.2, 0.95, -0.12))),
        ),
    }


def spaceship(draw: Draw) -> Parts:
    """A star fighter: a pointed hull, swept wings, guns at their tips, glowing engines."""
    r, nose, span, sweep = draw(0.26, 0.32), -1.4, draw(0.9, 1.15), draw(0.25, 0.6)
    root = draw(0.5, 0.62)
    wing = [(0, -0.35), (span, sweep - 0.05), (span, sweep + 0.42), (0, 0.95)]
    fin = [(0.35, 0.1), (0.75, r + draw(0.3, 0.45)), (1.02, r + 0.4), (1.0, 0.1)]
    return {
        "hull": join(
            taper((0, nose + 0.1, -0.02), (0, -0.1, 0.02), 0.09, r),
            taper((0, -0.1, 0.02), (0, 0.95, 0.02), r, r * 0.8),
        ),
        "wings": join(
            both(prism(wing, 2, 0.09)), both(moved(prism(fin, 0, 0.08), (root * 0.6, 0, 0)))
        ),
        "cockpit": egg((0, -0.28, r * 0.7), (r * 0.7, 0.46, r * 0.7)),
        "guns": both(capsule((span - 0.02, sweep - 0.65, 0), (span - 0.02, sweep + 0.4, 0), 0.11)),
        "engines": both(tube((root * 0.55, 0.5, 0.02), (root * 0.55, 1.12, 0.02), 0.2, 0.05)),
        "flames": both(egg((root * 0.55, 1.14, 0.02), (0.14, 0.2, 0.14))),
    }


def ufo(draw: Draw) -> Parts:
    """A flying saucer."""
    r, thick, dome, count = (
        draw(1.1, 1.3),
        draw(0.2, 0.26),
        draw(0.45, 0.56),
        6 + 2 * draw.which(2),
    )
    rise, z = draw(0.4, 0.62), 0.7
    shape = [
        (0.34, z - thick - 0.08),
        (r * 0.7, z - thick * 0.7),
        (r, z),
        (r * 0.7, z + thick * 0.8),
    ]
    leg = capsule((r * 0.42, 0, z - 0.1), (r * 0.62, 0, 0.1), 0.09)
    parts = {
        "body": lathe([*shape, (0.3, z + thick + 0.12)], 0.04),
        "dome": egg((0, 0, z + thick * 0.8), (dome, dome, rise)),
        "lights": around(count, ball((r * 0.84, 0, z + thick * 0.42), 0.13)),
    }
    feet = join(leg, tube((r * 0.62, 0, 0), (r * 0.62, 0, 0.12), 0.16, 0.03))
    return parts | {"legs": around(3, feet, -90)} if draw.chance(0.5) else parts


def satellite(draw: Draw) -> Parts:
    """A box with two solar panels, a dish in front and an aerial."""
    x, z, high = draw(0.28, 0.36), 0.8, draw(0.34, 0.46)
    wide, panel, count = draw(0.2, 0.24), draw(0.3, 0.4), 2
    start = x + 0.22
    cells = [
        box((start + wide * (2 * k + 1), 0, z), (wide - 0.03, 0.08, panel)) for k in range(count)
    ]
    dish = lathe([(0.1, 0), (0.28, 0.1), (0.4, 0.3), (0.26, 0.3), (0.1, 0.16)], 0.02)
    return {
        "body": box((0, 0, z), (x, x, high), 0.04),
        "panels": both(join(*cells)),
        "arms": both(capsule((0, 0, z), (start + wide * 3, 0, z), 0.08)),
        "dish": join(
            moved(turned(dish, 0, 90), (0, -x - 0.08, z)),
            capsule((0, -x, z), (0, -x - 0.5, z), 0.08),
        ),
        "aerial": join(
            capsule((0, 0, z), (0, 0, z + high + 0.32), 0.075), ball((0, 0, z + high + 0.34), 0.12)
        ),
    }


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


def planet(draw: Draw) -> Parts:
    """A globe with bands and a thin ring around it, leaning."""
    r, near, far, thick = 0.82, draw(1.04, 1.1), draw(1.42, 1.52), 0.05
    disc = lathe([(near, -thick), (far, -thick), (far, thick), (near, thick)])
    hole = tube((0, 0, -1), (0, 0, 1), near)
    bridge = box((0, 0, 0), (near + 0.05, 0.06, thick * 0.9))
    belt = lathe([(r + 0.02, -0.1), (r + 0.02, 0.1)])
    parts = {
        "globe": ball((0, 0, 0), r),
        "bands": belt,
        "rings": join(cut(disc, hole), bridge),
    }
    return {name: moved(turned(solid, 1, LEAN_DEG), (0, 0, 1)) for name, solid in parts.items()}


AIRCRAFT_AND_SPACE = {
    "airplane": airplane,
    "biplane": biplane,
    "fighter jet": fighter_jet,
    "helicopter": helicopter,
    "hot air balloon": hot_air_balloon,
    "blimp": blimp,
    "rocket": rocket,
    "space shuttle": space_shuttle,
    "spaceship": spaceship,
    "ufo": ufo,
    "satellite": satellite,
    "space station": fitted(space_station),
    "planet": planet,
}
