"""Vehicles and machines of less common kinds."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    both,
    box,
    cut,
    egg,
    join,
    lathe,
    limb,
    mirrored,
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
from core.prior.things.transport import strip


def longship(draw: Draw) -> Parts:
    """Of vikings: a long hull that sweeps up to a dragon's head and a curled tail, round shields
    along it, one square sail in stripes."""
    x, y, high, wide = draw(0.42, 0.47), draw(1.3, 1.4), draw(1.7, 1.84), draw(0.66, 0.74)
    rail, top, full = draw(0.46, 0.52), draw(1.06, 1.16), draw(0.08, 0.13)
    keel = smooth_curve([(-y - 0.08, 0.66), (-y * 0.84, 0.24), (-y * 0.5, 0.03), (0, 0),
                         (y * 0.5, 0.03), (y * 0.84, 0.24), (y + 0.08, 0.66)])  # fmt: skip
    sheer = smooth_curve([(y - 0.12, 0.86), (y * 0.74, rail + 0.12), (y * 0.4, rail),
                          (0, rail - 0.02), (-y * 0.4, rail), (-y * 0.74, rail + 0.12),
                          (-y + 0.12, 0.86)])  # fmt: skip
    beam = smooth_curve([(0.1, -y - 0.1), (x * 0.66, -y * 0.7), (x, -y * 0.3), (x, y * 0.3),
                         (x * 0.66, y * 0.7), (0.1, y + 0.1)])  # fmt: skip
    well = [(u - 0.15, v * 0.84) for u, v in beam if u > x * 0.6]
    bilge = prism(mirrored([(0.14, -0.1), (x * 0.76, 0.16), (x + 0.05, 0.42), (x + 0.05, 3)]), 1, 2)
    hull = cut(within(outlined([*keel, *sheer], beam), bilge), prism(mirrored(well), 2, 1, 1.22))
    # Seen from the side: of the front as far out, to -Y, as of the back to +Y.
    neck = [(y - 0.3, 0.4), *smooth_curve([(y - 0.06, 0.34), (y + 0.17, 0.66), (y + 0.17, 0.9),
                                           (y + 0.06, top)]),
            *smooth_curve([(y - 0.16, top), (y - 0.05, 0.88), (y - 0.3, 0.62)])]  # fmt: skip
    head = [(y - 0.18, top - 0.06), (y - 0.1, top + 0.16), (y + 0.06, top + 0.18),
            (y + 0.2, top + 0.07), (y + 0.42, top + 0.06), (y + 0.38, top - 0.12),
            (y + 0.06, top - 0.14)]  # fmt: skip
    horn = taper((0.08, y - 0.04, top + 0.08), (0.22, y - 0.24, top + 0.24), 0.1, 0.09)
    tail = [(0, y - 0.05, top - 0.08), (0, y - 0.1, top + 0.14), (0, y - 0.26, top + 0.26),
            (0, y - 0.42, top + 0.16)]  # fmt: skip
    dragon = turned(join(prism(head, 0, 0.13), both(horn)), 2, 180)
    low, up = rail + 0.3, high - 0.14
    wind = smooth_curve([(0, low), (-full * 0.9, low + (up - low) * 0.4), (0, up)])
    cloth = [(v - 0.12, w) for v, w in wind] + [(v + 0.08, w) for v, w in reversed(wind)]
    stripe = [(v - 0.18, w) for v, w in wind] + [(v + 0.12, w) for v, w in reversed(wind)]
    round_ = lathe([(0.17, -0.1), (0.17, 0.05), (0.08, 0.1)], 0.02)
    shields = (moved(turned(round_, 1, 90), (at - 0.02, v, rail - 0.06)) for v, at in
               ((-0.81, x * 0.84), (-0.27, x), (0.27, x), (0.81, x * 0.84)))  # fmt: skip
    return {
        "hull": hull,
        "prows": join(both(prism(neck, 0, 0.1), 1), dragon, limb(tail, 0.11, 0.1)),
        "mast": join(
            tube((0, 0.01, 0.14), (0, 0.01, high + 0.14), 0.1, 0.03),
            tube((-wide - 0.1, 0, up), (wide + 0.1, 0, up), 0.1, 0.03),
        ),
        "sail": prism(cloth, 0, wide),
        "stripes": both(prism(stripe, 0, wide / 5, wide * 0.4)),
        "shields": both(join(*shields)),
    }


def biplane(draw: Draw) -> Parts:
    """Two wings one above the other with struts, an engine, a propeller, wheels, a tail."""
    span, chord, r, tail = draw(1.2, 1.35), draw(0.26, 0.31), draw(0.22, 0.26), draw(1.1, 1.25)
    z, gap, nose = 0.62, draw(0.62, 0.7), -0.72
    low, top = z - 0.12, z - 0.12 + gap
    fin = [(tail - 0.34, z), (tail - 0.14, z + 0.5), (tail + 0.08, z + 0.5), (tail + 0.08, z)]
    flat = [(0, tail - 0.32), (0.42, tail - 0.16), (0.42, tail + 0.06), (0, tail + 0.06)]
    strut = [box((span * 0.66, v, (low + top) / 2), (0.065, 0.065, gap / 2)) for v in (-0.5, -0.16)]
    cabane = box((0.13, -0.33, (z + top) / 2), (0.065, 0.065, (top - z) / 2))
    blade = box((0.28, 0, 0), (0.28, 0.1, 0.06))
    wheel = 0.2
    return {
        "body": join(
            tube((0, nose + 0.2, z), (0, 0.1, z), r),
            taper((0, 0.1, z), (0, tail, z + 0.04), r, 0.09),
            prism(fin, 0, 0.07),
            both(prism(flat, 2, 0.065, z + 0.05)),
        ),
        "wings": join(
            box((0, -0.33, low), (span * 0.92, chord, 0.075), 0.03),
            box((0, -0.33, top), (span, chord, 0.075), 0.03),
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


def rover(draw: Draw) -> Parts:
    """For Mars: a box under solar panels on six wheels, a mast with a camera, a dish."""
    x, y, wheel = draw(0.42, 0.5), draw(0.66, 0.76), draw(0.23, 0.27)
    z, mast, wing = 0.72, draw(0.62, 0.75), draw(0.3, 0.38)
    side, deck = x + 0.26, z + 0.22
    wheels = [tube((side - 0.12, v, wheel), (side + 0.12, v, wheel), wheel) for v in (-y, 0, y)]
    rocker = [
        strip((-y, wheel), (-y * 0.45, z), 0.075),
        strip((y * 0.5, z - 0.2), (-y * 0.5, z), 0.075),
        strip((y, wheel), (y * 0.5, z - 0.2), 0.075),
        strip((0, wheel), (y * 0.5, z - 0.2), 0.075),
    ]
    head, eye = deck + mast, 0.085
    return {
        "body": box((0, 0, z), (x, y * 0.8, 0.2)),
        "panels": join(
            box((0, 0.12, deck), (x + 0.06, y * 0.85, 0.06)),
            both(box((x + 0.19 + wing, 0.12, deck), (wing, y * 0.7, 0.06))),
        ),
        "wheels": both(join(*wheels)),
        "arms": both(
            join(
                *(prism(strip, 0, 0.07, side - 0.16) for strip in rocker),
                box((x, 0, z - 0.06), (side - x, 0.09, 0.09)),
                box((x + 0.1, 0.12, deck - 0.02), (0.16, 0.12, 0.055)),
            )
        ),
        "mast": join(
            tube((0, -y * 0.62, z), (0, -y * 0.62, head), 0.09),
            box((0, -y * 0.62, head), (0.26, 0.13, 0.14)),
        ),
        "eyes": both(tube((0.13, -y * 0.62 - 0.2, head), (0.13, -y * 0.62, head), eye)),
    }


def crane(draw: Draw) -> Parts:
    """A tower crane: a mast of bars, a jib to the front with a hook, a counterweight behind."""
    high, half, reach = draw(1.65, 1.85), 0.16, draw(1.75, 1.95)
    tail, deep, peak = draw(0.8, 0.95), draw(0.24, 0.28), draw(0.42, 0.5)
    thick, hang = 0.06, draw(0.5, 0.7)
    floor, count = 0.14, 4
    step = (high - floor) / count
    rungs, braces = [], []
    for k in range(count):
        z = floor + step * k
        a, b = (-half, half) if k % 2 else (half, -half)
        braces.append(prism(strip((a, z), (b, z + step), 0.05), 0, 0.05, half))
        rungs.append(both(box((0, half, z + step), (half, 0.05, 0.05)), 1))
    posts = both(box((half, half, high / 2), (0.07, 0.07, high / 2)), 0, 1)
    low, top = high + 0.16, high + 0.16 + deep
    bays = 5
    pitch = (reach - 0.3) / bays
    web = []
    for k in range(bays):
        near = -0.2 - pitch * k
        web.append(strip((near, low), (near - pitch / 2, top), 0.055))
        web.append(strip((near - pitch / 2, top), (near - pitch, low), 0.055))
    tip = top + peak
    hook = -reach * 0.78
    parts: Parts = {
        "mast": join(posts, *rungs, both(join(*braces))),
        "jib": join(
            box((0, (tail - reach) / 2, low), (0.12, (tail + reach) / 2, thick + 0.01)),
            box((0, -(reach + 0.1) / 2, top), (0.075, (reach - 0.3) / 2, thick)),
            *(prism(strip, 0, 0.075) for strip in web),
            box((0, 0, high + 0.06), (0.25, 0.25, 0.1)),
        ),
        "ties": join(
            prism([(-0.16, low), (0.16, low), (0.06, tip), (-0.06, tip)], 0, 0.08),
            prism(strip((0, tip - 0.05), (-reach * 0.62, top), 0.055), 0, 0.06),
            prism(strip((0, tip - 0.05), (tail - 0.1, low), 0.055), 0, 0.06),
        ),
        "cab": box((0, -0.36, low - 0.24), (0.17, 0.17, 0.2)),
        "weights": join(
            box((0, tail - 0.12, low - 0.14), (0.2, 0.2, 0.2)),
            box((0, 0, 0.09), (0.46, 0.46, 0.09)),
        ),
        "hook": join(
            box((0, hook, low - hang / 2), (0.06, 0.06, hang / 2)),
            box((0, hook, low - hang), (0.09, 0.12, 0.11)),
            cut(
                ring((0, hook, low - hang - 0.22), 0.13, 0.06, 0),
                box((0, hook + 0.2, low - hang - 0.12), (0.2, 0.16, 0.1)),
            ),
        ),
    }
    # So that both ends of the jib are equally far from the middle.
    return {name: moved(part, (0, 0.5, 0)) for name, part in parts.items()}


def forklift(draw: Draw) -> Parts:
    """A short truck with a cage over its seat, a mast and two forks in front."""
    x, y, high = draw(0.46, 0.54), draw(0.62, 0.7), draw(1.45, 1.6)
    wheel, fork, tall = draw(0.26, 0.3), draw(0.62, 0.74), draw(1.7, 1.9)
    hood, front = draw(0.78, 0.88), -y - 0.1
    side = [(-y, 0.16), (y + 0.12, 0.16), (y + 0.2, 0.36), (y + 0.14, hood), (0.02, hood)]
    side += [(0.02, 0.5), (-y, 0.5)]
    post = 0.07
    cage = [
        prism(strip((-y + 0.05, 0.4), (-y + 0.25, high), post), 0, post, x - 0.07),
        box((x - 0.07, y - 0.02, (hood + high) / 2), (post, post, (high - hood) / 2 + 0.05)),
    ]
    roof = box((0, 0.12, high), (x, y - 0.04, 0.07))
    z = draw(0.14, 0.3)
    parts: Parts = {
        "body": join(prism(side, 0, x), box((0, -y + 0.14, 0.62), (x - 0.06, 0.12, 0.16))),
        "cage": join(both(join(*cage)), roof),
        "mast": join(
            both(box((x * 0.56, front, tall / 2 + 0.06), (0.085, 0.1, tall / 2))),
            *(box((0, front, tall * k), (x * 0.56, 0.08, 0.07)) for k in (0.34, 0.66, 1.0)),
        ),
        "forks": join(
            both(box((x * 0.52, front - 0.14 - fork / 2, z), (0.11, fork / 2 + 0.06, 0.06))),
            both(box((x * 0.52, front - 0.14, z + 0.24), (0.11, 0.07, 0.28))),
            box((0, front - 0.12, z + 0.4), (x * 0.8, 0.065, 0.08)),
        ),
        "wheels": join(
            both(tube((x - 0.14, -y + 0.2, wheel), (x + 0.1, -y + 0.2, wheel), wheel)),
            both(tube((x - 0.14, y - 0.1, wheel), (x + 0.1, y - 0.1, wheel), wheel)),
        ),
        "seat": join(
            box((0, 0.16, hood + 0.05), (0.24, 0.24, 0.08), 0.03),
            box((0, 0.38, hood + 0.24), (0.24, 0.08, 0.24), 0.03),
        ),
    }
    # The forks reach far to the front.
    return {name: moved(part, (0, 0.35, 0)) for name, part in parts.items()}


def wheelchair(draw: Draw) -> Parts:
    """Two large wheels and two small ones, a seat with a back, handles and footrests."""
    x, r, small = draw(0.4, 0.46), draw(0.56, 0.64), draw(0.18, 0.21)
    seat, back, arm = draw(0.78, 0.86), draw(0.62, 0.72), draw(0.3, 0.36)
    y, tire, side = 0.24, 0.075, x + 0.16
    front, top = -0.62, seat + back
    spoke = box((0, 0, 0), (0.05, r, 0.05))
    spokes = join(*(tilted(spoke, 45 * k, (side, y, r)) for k in range(4)))
    return {
        "wheels": both(
            join(
                ring((side, y, r), r - tire, tire + 0.01, 0),
                tube((x - 0.12, front, small), (x + 0.06, front, small), small),
            )
        ),
        "spokes": both(join(spokes, tube((x - 0.05, y, r), (side + 0.1, y, r), 0.12))),
        "seat": join(
            box((0, -0.08, seat), (x - 0.04, 0.42, 0.09), 0.03),
            box((0, 0.34, seat + back / 2), (x - 0.04, 0.085, back / 2 + 0.04), 0.03),
        ),
        "frame": both(
            join(
                box((x - 0.04, 0.34, seat + back / 2 - 0.2), (0.065, 0.065, back / 2 + 0.36)),
                box((x - 0.04, -0.1, seat - 0.12), (0.065, 0.5, 0.065)),
                box((x - 0.04, -0.54, (seat + small) / 2), (0.065, 0.065, (seat - small) / 2)),
                prism(strip((-0.54, seat - 0.12), (-0.86, 0.2), 0.065), 0, 0.065, x - 0.1),
                box((x - 0.04, -0.32, seat + arm / 2), (0.06, 0.06, arm / 2)),
            )
        ),
        "armrests": both(
            join(
                box((x - 0.02, -0.06, seat + arm), (0.09, 0.4, 0.065), 0.02),
                box((x - 0.04, 0.46, top), (0.07, 0.2, 0.07), 0.02),
            )
        ),
        "footrests": both(box((x / 2 + 0.02, -0.92, 0.16), (x / 2 - 0.06, 0.2, 0.06))),
    }


def camper(draw: Draw) -> Parts:
    """A motorhome: a tall body that reaches over its cab, windows, a door, a stripe."""
    x, y, high = draw(0.54, 0.62), draw(1.3, 1.42), draw(1.25, 1.4)
    low, wheel, nose = 0.26, draw(0.23, 0.26), draw(0.4, 0.5)
    cab = -y + nose + 0.42
    side = [(-y, low), (y, low), (y, high), (-y + nose - 0.1, high)]
    side += [(-y + nose - 0.22, high - 0.1), (-y + nose - 0.22, high * 0.72)]
    side += [(-y + nose + 0.06, high * 0.68), (-y + nose - 0.14, 0.62), (-y, 0.56)]
    shield = [(-y + nose - 0.2, 0.63), (-y + nose + 0.1, 0.63), (-y + nose + 0.14, high * 0.68)]
    shield.append((-y + nose + 0.01, high * 0.68))
    mid = high * 0.66
    return {
        "body": prism(side, 0, x),
        "windows": join(
            prism(shield, 0, x - 0.08),
            both(box((x, cab - 0.16, 0.74), (0.05, 0.19, 0.13))),
            both(box((x, y * 0.72, mid), (0.05, 0.24, 0.15))),
            both(box((x, y * 0.02, mid), (0.05, 0.2, 0.15))),
            box((0, y, mid), (0.3, 0.05, 0.16)),
        ),
        "wheels": join(
            *(
                both(tube((x - 0.16, v, wheel), (x + 0.05, v, wheel), wheel))
                for v in (-y * 0.62, y * 0.55)
            )
        ),
        "stripe": join(
            both(box((x, (cab + y) / 2 - 0.1, 0.5), (0.04, (y - cab) / 2 + 0.12, 0.09))),
            box((0, y, 0.5), (x + 0.04, 0.04, 0.09)),
        ),
        "door": both(box((x + 0.01, y * 0.36, 0.66), (0.05, 0.16, 0.36))),
        "lamps": both(box((x - 0.16, -y, 0.46), (0.11, 0.05, 0.07))),
    }


MACHINES = {
    "longship": fitted(longship),
    "biplane": biplane,
    "blimp": blimp,
    "rover": rover,
    "crane": crane,
    "forklift": forklift,
    "wheelchair": wheelchair,
    "camper": camper,
}
