"""Machines of the building site and the farm, a tank and a rover."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    both,
    box,
    capsule,
    join,
    lathe,
    moved,
    prism,
    smooth_curve,
    tube,
)
from core.prior.things.shared.outlines import strip
from core.prior.things.shared.wheels import disc_wheel


def bulldozer(draw: Draw) -> Parts:
    """Two tracks, a hood with an exhaust, a cab, a broad hollow blade in front."""
    x, high, hood = draw(0.5, 0.58), draw(0.48, 0.56), draw(0.94, 1.04)
    top, wide, blade = draw(1.6, 1.8), draw(0.8, 0.95), draw(0.72, 0.9)
    side = [(-0.62, 0), (0.78, 0), (1.0, high * 0.4), (0.84, high), (-0.66, high),
            (-0.84, high * 0.5)]  # fmt: skip
    face = smooth_curve([(-1.32, 0), (-1.16, blade * 0.3), (-1.15, blade * 0.65), (-1.34, blade)])
    plate = [*face, (-1.2, blade + 0.04), *((u + 0.18, v) for u, v in reversed(face[2:-2])),
             (-1.12, 0)]  # fmt: skip
    middle, half, cab = (hood + top) / 2, (top - hood) / 2, x * 0.82
    spots = [(-0.5, 0.2), (-0.04, 0.15), (0.3, 0.15), (0.68, 0.2)]
    return {
        "body": join(
            box((0, -0.3, (hood + 0.3) / 2), (x * 0.68, 0.6, (hood - 0.3) / 2), 0.06),
            box((0, 0.52, hood * 0.66), (x * 0.9, 0.44, hood * 0.34), 0.05),
            box((0, 0.4, middle), (cab, 0.38, half), 0.03),
            box((0, 0.36, top), (cab + 0.1, 0.52, 0.09), 0.04),
            both(box((x * 0.9, -0.75, high * 0.5), (0.1, 0.34, 0.1))),
        ),
        "windows": join(
            box((0, 0.4, middle), (cab - 0.13, 0.44, half - 0.14), 0.02),
            box((0, 0.4, middle), (cab + 0.06, 0.25, half - 0.14), 0.02),
        ),
        "tracks": both(prism(side, 0, 0.2, x)),
        "wheels": both(join(*(tube((x, v, 0.26), (x + 0.26, v, 0.26), r, 0.03) for v, r in spots))),
        "blade": prism(plate, 0, wide),
        "exhaust": join(
            tube((0, -0.45, hood - 0.1), (0, -0.45, hood + draw(0.4, 0.55)), 0.1, 0.02),
            box((0, -0.88, hood * 0.68), (x * 0.5, 0.07, 0.17), 0.02),
        ),
    }


def excavator(draw: Draw) -> Parts:
    """Tracks, a cab, a bent arm with a bucket."""
    x, high, top = draw(0.46, 0.54), draw(0.38, 0.44), draw(1.2, 1.35)
    knee, low = (draw(-0.75, -0.6), draw(1.55, 1.8)), (draw(-1.32, -1.22), draw(0.65, 0.8))
    side = [(-0.5, 0), (0.75, 0), (0.95, high / 2), (0.75, high), (-0.5, high), (-0.7, high / 2)]
    a, b = low
    scoop = [(a - 0.1, b + 0.1), (a + 0.2, b + 0.02), (a + 0.42, b - 0.3), (a + 0.2, b - 0.56)]
    cab = (-0.22 - 0.0, (high + top) / 2 + 0.04)
    return {
        "body": join(
            box((0, 0.5, high + 0.34), (x + 0.04, 0.5, 0.28), 0.06),
            box((x * 0.45, cab[0] + 0.3, cab[1]), (x * 0.55, 0.38, (top - high) / 2), 0.05),
            tube((0, 0.15, high - 0.15), (0, 0.15, high + 0.2), 0.36),
        ),
        "windows": join(
            box((x * 0.45, cab[0] - 0.06, cab[1] + 0.12), (x * 0.42, 0.06, 0.22), 0.02),
            box((x, cab[0] + 0.28, cab[1] + 0.14), (0.05, 0.24, 0.18), 0.02),
        ),
        "arm": join(
            prism(strip((0.1, high + 0.3), knee, 0.13), 0, 0.12, -x * 0.45),
            tube((-x * 0.45 - 0.14, *knee), (-x * 0.45 + 0.14, *knee), 0.17),
            prism(strip(knee, low, 0.11), 0, 0.11, -x * 0.45),
        ),
        "bucket": prism([*scoop, (a - 0.08, b - 0.34)], 0, 0.26, -x * 0.45),
        "tracks": both(prism(side, 0, 0.17, x)),
    }


def steamroller(draw: Draw) -> Parts:
    """A boiler with a chimney, a broad roller in a fork before it, two behind, a roof."""
    r, big, x = draw(0.42, 0.5), draw(0.54, 0.64), draw(0.44, 0.52)
    front, rear, z = -draw(0.86, 0.96), draw(0.5, 0.6), draw(0.92, 1.02)
    top, tall = draw(1.8, 2.0), draw(0.78, 0.98)
    fork = box((x + 0.1, front, r + 0.18), (0.085, 0.13, 0.34), 0.02)
    post = tube((x - 0.04, rear + 0.38, 0.9), (x - 0.04, rear + 0.38, top), 0.085)
    pipe = [(0.13, z), (0.12, z + tall * 0.8), (0.2, z + tall * 0.92), (0.2, z + tall)]
    yoke = r + 0.46
    return {
        "body": join(
            tube((0, front + 0.08, z), (0, rear, z), 0.32, 0.03),
            box((0, rear + 0.06, 0.8), (x - 0.02, 0.42, 0.36), 0.05),
            both(fork),
            box((0, front, yoke), (x + 0.17, 0.14, 0.1), 0.03),
        ),
        "rollers": join(
            tube((-x, front, r), (x, front, r), r, 0.04),
            both(tube((x - 0.02, rear, big), (x + 0.3, rear, big), big, 0.04)),
        ),
        "hubs": both(
            join(
                tube((0, front, r), (x + 0.26, front, r), 0.13, 0.02),
                tube((x, rear, big), (x + 0.36, rear, big), big * 0.46, 0.03),
            )
        ),
        "roof": join(
            box((0, rear - 0.05, top), (x + 0.14, 0.68, 0.09), 0.04),
            both(join(post, moved(post, (0, -0.84, 0)))),
        ),
        "chimney": lathe(pipe, center=(0, front + 0.22)),
        "bands": join(*(tube((0, v - 0.09, z), (0, v + 0.09, z), 0.37) for v in (-0.42, -0.02))),
    }


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


def tractor(draw: Draw) -> Parts:
    """Large wheels behind, small ones in front, a cab, an exhaust."""
    big, small, x = draw(0.6, 0.68), draw(0.34, 0.4), draw(0.28, 0.34)
    hood, top, y = draw(0.95, 1.05), draw(1.6, 1.8), draw(0.95, 1.05)
    wide = x + 0.24
    post = box((x, 0.12, (hood + top) / 2), (0.08, 0.08, (top - hood) / 2))
    return {
        "body": join(
            box((0, -y * 0.45, (hood + 0.4) / 2), (x, y * 0.62, (hood - 0.4) / 2), 0.08),
            box((0, 0.42, 0.68), (x + 0.06, 0.4, 0.3), 0.05),
        ),
        "cab": join(
            box((0, 0.42, top), (x + 0.16, 0.46, 0.1), 0.04),
            both(join(post, moved(post, (0, 0.6, 0)))),
        ),
        "windows": box((0, 0.42, (hood + top) / 2), (x - 0.01, 0.31, (top - hood) / 2), 0.02),
        "wheels": both(
            join(
                disc_wheel(wide, 0.5, big, big, 0.18),
                disc_wheel(wide - 0.04, -y * 0.75, small, small, 0.13),
            )
        ),
        "rims": both(
            join(
                disc_wheel(wide + 0.1, 0.5, big, big * 0.5, 0.13),
                disc_wheel(wide, -y * 0.75, small, small * 0.5, 0.14),
                tube((0, -y * 0.75, small), (wide, -y * 0.75, small), 0.13),
                tube((0, 0.5, big), (wide, 0.5, big), 0.13),
            )
        ),
        "exhaust": capsule(
            (x * 0.45, -y * 0.5, hood - 0.1), (x * 0.45, -y * 0.5, top - 0.15), 0.09
        ),
    }


def tank(draw: Draw) -> Parts:
    """Two tracks, a hull, a turret with a long gun."""
    x, y, high = draw(0.62, 0.74), draw(0.95, 1.1), draw(0.5, 0.58)
    turret, top, gun = draw(0.4, 0.5), high + draw(0.42, 0.5), draw(0.1, 0.13)
    side = [(-y * 0.75, 0), (y * 0.75, 0), (y + 0.1, high * 0.55), (y * 0.9, high)]
    side += [(-y * 0.95, high), (-y - 0.1, high * 0.6)]
    round_ = draw.chance(0.5)
    plate = [(-turret, -turret * 1.2), (turret, -turret * 1.2), (turret * 1.1, 0.3)]
    plate += [(turret * 0.7, turret * 1.5), (-turret * 0.7, turret * 1.5), (-turret * 1.1, 0.3)]
    dome = lathe(smooth_curve([(turret * 1.15, high), (turret, top - 0.1), (0.1, top)]), 0.02)
    body = dome if round_ else prism(plate, 2, (top - high) / 2 + 0.08, (top + high) / 2)
    hull = [(-y, high * 0.6), (-y * 0.7, high + 0.14), (y * 0.9, high + 0.14), (y, high * 0.5)]
    ys = [y * s for s in (-0.66, -0.22, 0.22, 0.66)]
    z = (top + high) / 2 + 0.04
    return {
        "hull": prism([*hull, (y * 0.8, 0.2), (-y * 0.8, 0.2)], 0, x),
        "turret": join(body, tube((0, 0.2, top - 0.1), (0, 0.2, top + 0.1), 0.18, 0.03)),
        "gun": join(
            tube((0, 0, z), (0, -1.5, z), gun, 0.02), tube((0, -1.3, z), (0, -1.54, z), gun + 0.05)
        ),
        "tracks": both(prism(side, 0, 0.18, x)),
        "wheels": both(join(*(disc_wheel(x + 0.14, v, high * 0.46, high * 0.33, 0.1) for v in ys))),
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


TRACTORS_AND_DIGGERS = {
    "bulldozer": bulldozer,
    "excavator": excavator,
    "steamroller": steamroller,
    "forklift": forklift,
    "tractor": tractor,
    "tank": tank,
    "rover": rover,
}
