"""Craft: in the air, in space and on water."""

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
    grown,
    join,
    lathe,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.transport import rods

Point = tuple[float, float]


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


def submarine(draw: Draw) -> Parts:
    """A round hull, a tower with a periscope, round windows, a screw."""
    r, y, count = draw(0.42, 0.52), draw(1.0, 1.15), 2 + draw.chance(0.6)
    top, tower = r + draw(0.34, 0.44), draw(0.28, 0.36)
    ports = [(k - (count - 1) / 2) * 0.48 - 0.1 for k in range(count)]
    scope = [((0, 0, top - 0.1), (0, 0, top + 0.4)), ((0, 0, top + 0.4), (0, -0.24, top + 0.4))]
    blade = box((0.2, 0, 0), (0.2, 0.12, 0.07), 0.03)
    screw = turned(join(around(4, blade), tube((0, 0, -0.2), (0, 0, 0.1), 0.12)), 0, 90)
    rudder = [(y * 0.6, 0.0), (y + 0.1, 0.42), (y + 0.28, 0.42), (y + 0.1, 0.0)]
    return {
        "hull": egg((0, 0, 0), (r, y + 0.15, r)),
        "tower": join(
            box((0, 0, top - 0.3), (tower * 0.7, tower, 0.36), 0.14),
        ),
        "windows": both(
            join(*(tube((r * 0.6, v, 0.04), (r + 0.05, v, 0.04), 0.15) for v in ports))
        ),
        "periscope": rods(0.1, *scope),
        "fins": join(
            prism(rudder, 0, 0.08),
            both(prism([(0.0, y * 0.6), *[(v, u) for u, v in rudder[1:]]], 2, 0.08)),
        ),
        "screw": moved(screw, (0, y + 0.2, 0)),
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


def canoe(draw: Draw) -> Parts:
    """A slim open hull, its ends swept up; a wooden rail, two seats, a paddle laid across."""
    x, y, high, rise = draw(0.46, 0.52), draw(1.32, 1.44), draw(0.44, 0.5), draw(0.44, 0.54)
    bow = [(0.07, y + 0.12), (x * 0.4, y * 0.8), (x * 0.82, y * 0.42), (x, 0.0)]
    plan = prism(mirrored(smooth_curve([*bow, *((u, -v) for u, v in bow[-2::-1])])), 2, 3)
    chine = smooth_curve([(0.0, 0.0), (x * 0.5, 0.02), (x * 0.9, 0.22), (x + 0.08, high)])
    bilge = prism(mirrored([*chine, (x + 0.08, 3)]), 1, 3)
    sheer = smooth_curve([(0.0, high), (y * 0.45, high + rise * 0.14),
                          (y * 0.78, high + rise * 0.46), (y * 0.98, high + rise)])  # fmt: skip
    stem = smooth_curve([(y, high + rise * 0.4), (y * 0.95, high * 0.6), (y * 0.84, 0.16),
                         (y * 0.62, 0.02), (0.0, 0.0)])  # fmt: skip
    band = [(u * 1.03, v - 0.1) for u, v in reversed(sheer)]
    well = within(grown(plan, -0.14), box((0, 0, 1.12), (x, y * 0.7, 1)))
    rail = cut(grown(plan, 0.05), within(grown(plan, -0.17), box((0, 0, 0), (x, y * 0.67, 3))))
    blade = [(0.5, -0.1), (0.66, -0.19), (1.02, -0.19), (1.1, -0.1)]
    paddle = join(
        capsule((-0.8, 0, 0), (0.6, 0, 0), 0.1),
        capsule((-0.8, -0.14, 0), (-0.8, 0.14, 0), 0.1),
        prism([*blade, *((u, -v) for u, v in reversed(blade))], 2, 0.09),
    )
    return {
        "hull": cut(within(within(plan, bilge), prism(mirrored([*sheer, *stem]), 0, 2)), well),
        "seats": join(
            within(rail, prism(mirrored([*((u * 1.03, v + 0.1) for u, v in sheer), *band]), 0, 2)),
            both(box((0, y * 0.4, high - 0.06), (x * 0.7, 0.15, 0.09), 0.02), 1),
        ),
        "paddle": moved(turned(paddle, 2, draw(-36, -28)), (-0.08, -0.02, high + 0.14)),
    }


def pirate_ship(draw: Draw) -> Parts:
    """A hull with a high stern and a bow, two masts with square sails, a black flag."""
    x, y, deck, tall = draw(0.4, 0.48), draw(1.05, 1.15), draw(0.52, 0.6), draw(2.3, 2.5)
    plan = [(-x, y), (x, y), (x, -y * 0.5), (0, -y), (-x, -y * 0.5)]
    stern = box((0, y * 0.72, deck + 0.16), (x, y * 0.28, 0.22))
    bow = prism([(x * 0.92, -y * 0.52), (0, -y), (-x * 0.92, -y * 0.52)], 2, 0.12, deck + 0.06)
    sails, masts = [], []
    for v, top in ((-0.36, tall * 0.86), (0.34, tall)):
        masts.append(tube((0, v, 0.3), (0, v, top), 0.08))
        low, span = deck + 0.42, top - deck - 0.5
        for z, half in ((low + span * 0.2, 0.66), (low + span * 0.66, 0.48)):
            sails.append(box((0, v - 0.1, z), (half, 0.075, span * 0.19)))
    masts.append(tube((0, -y * 0.8, deck + 0.08), (0, -y - 0.4, deck + 0.42), 0.08))
    return {
        "hull": join(prism(plan, 2, deck / 2, deck / 2), stern, bow),
        "sails": join(*sails),
        "masts": join(*masts),
        "flag": box((0, 0.56, tall - 0.13), (0.075, 0.25, 0.15)),
        "windows": both(
            join(*(box((x, v, deck * 0.55), (0.07, 0.1, 0.1)) for v in (-0.35, 0.1, 0.55)))
        ),
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


CRAFT = {
    "helicopter": helicopter,
    "submarine": submarine,
    "hot air balloon": hot_air_balloon,
    "ufo": ufo,
    "spaceship": spaceship,
    "canoe": canoe,
    "pirate ship": pirate_ship,
    "space shuttle": space_shuttle,
    "satellite": satellite,
}
