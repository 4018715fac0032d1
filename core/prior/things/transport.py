"""Vehicles on wheels and runners."""

import itertools
import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
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
    ring,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.vehicles_buildings import car

Point = tuple[float, float]


def _wheels(x: float, ys: tuple[float, ...], radius: float, thick: float = 0.12) -> Solid:
    """Pairs of wheels on axles along x, standing on the floor."""
    return both(join(*(_disc(x, y, radius, radius, thick) for y in ys)))


def _disc(x: float, y: float, z: float, radius: float, thick: float = 0.12) -> Solid:
    return tube((x - thick, y, z), (x + thick, y, z), radius, 0.04)


def strip(a: Point, b: Point, half: float) -> list[Point]:
    """The corners of a straight strip from a to b."""
    u, v = b[0] - a[0], b[1] - a[1]
    u, v = -v * half / math.hypot(u, v), u * half / math.hypot(u, v)
    return [(a[0] + u, a[1] + v), (b[0] + u, b[1] + v), (b[0] - u, b[1] - v), (a[0] - u, a[1] - v)]


def rods(radius: float, *ends: tuple[Vector, Vector]) -> Solid:
    return join(*(capsule(a, b, radius) for a, b in ends))


def bicycle(draw: Draw) -> Parts:
    """Two wheels, a diamond of tubes, a saddle, a handlebar."""
    y, r, tire, rod = draw(0.88, 0.94), draw(0.46, 0.5), draw(0.09, 0.1), draw(0.08, 0.09)
    saddle = [(-0.09, 0), (0.09, 0), (0.2, 0.34), (0.18, 0.62), (-0.18, 0.62), (-0.2, 0.34)]
    z, seat, bar = r + tire, draw(1.32, 1.42), draw(1.5, 1.62)
    low, post, head = (0, 0.12, z - 0.06), (0, 0.32, seat - 0.16), (0, -y + 0.26, seat - 0.14)
    top, out = (0, -y + 0.2, bar), tire + rod - 0.01
    stays = [((out, y, z), (out, *low[1:])), ((out, y, z), (out, *post[1:]))]
    fork = ((out, -y, z), (out, head[1] - 0.02, head[2]))
    hub = tube((-out - 0.05, 0, 0), (out + 0.05, 0, 0), 0.15)
    spokes = join(*(box((0, 0, 0), half) for half in ((0.07, 0.06, r), (0.07, r, 0.06))))
    wheel = join(ring((0, 0, 0), r, tire, 0), turned(spokes, 0, 45), hub)
    return {
        "frame": join(
            rods(rod, (low, post), (low, head), (post, head)), both(rods(rod, *stays, fork))
        ),
        "wheels": join(moved(wheel, (0, y, z)), moved(wheel, (0, -y, z))),
        "seat": moved(prism(saddle, 2, 0.09), (0, 0.02, seat)),
        "handlebar": join(
            capsule(head, top, rod),
            tube((-0.56, *top[1:]), (0.56, *top[1:]), rod),
            both(tube((0.32, *top[1:]), (0.58, *top[1:]), rod + 0.03)),
        ),
        "pedals": join(
            tube((-0.14, *low[1:]), (0.14, *low[1:]), 0.24),
            box((0.28, low[1], low[2] - 0.33), (0.15, 0.13, 0.08)),
            box((-0.28, low[1], low[2] + 0.33), (0.15, 0.13, 0.08)),
            box((0.16, low[1], low[2] - 0.2), (0.08, 0.08, 0.21)),
            box((-0.16, low[1], low[2] + 0.2), (0.08, 0.08, 0.21)),
        ),
    }


def motorcycle(draw: Draw) -> Parts:
    """Thick wheels, a tank, a long saddle, a lamp."""
    y, r, wide, tail = draw(0.8, 0.92), draw(0.42, 0.48), draw(0.13, 0.17), draw(0.95, 1.1)
    bar = draw(1.2, 1.4)
    hub = join(
        *(cut(_disc(0, s * y, r, r, wide), _disc(0, s * y, r, r * 0.45, 1)) for s in (-1, 1))
    )
    cores = join(*(_disc(0, s * y, r, r * 0.55, 0.07) for s in (-1, 1)))
    saddle = [(0.0, 0.8), (tail - 0.2, 0.8), (tail, 1.06), (0.3, 0.95), (0.0, 0.96)]
    return {
        "body": join(
            egg((0, -0.2, 0.98), (0.25, 0.42, 0.22)),
            box((0, y + 0.02, 2 * r + 0.03), (0.17, 0.34, 0.08), 0.05),
            box((0, -y, 2 * r + 0.02), (0.17, 0.28, 0.07), 0.05),
        ),
        "wheels": hub,
        "engine": join(
            box((0, 0, 0.52), (0.22, 0.36, 0.28), 0.05),
            rods(0.09, ((0, 0.2, 0.5), (0, y, r)), ((0.2, 0.1, 0.36), (0.26, tail, 0.4))),
            cores,
        ),
        "seat": prism(saddle, 0, 0.2),
        "handlebar": join(
            both(capsule((0.16, -y, r), (0.14, -y + 0.4, bar - 0.12), 0.08)),
            both(capsule((0, -y + 0.4, bar - 0.1), (0.5, -y + 0.55, bar), 0.08)),
            box((0, -0.45, 0.8), (0.14, 0.2, 0.14)),
        ),
        "lamp": ball((0, -y + 0.2, bar - 0.22), 0.18),
    }


def scooter(draw: Draw) -> Parts:
    """A motor scooter: a leg shield, a low floor, a saddle over a round tail."""
    y, r, seat, bar = draw(0.72, 0.82), draw(0.3, 0.35), draw(0.98, 1.1), draw(1.35, 1.55)
    x = draw(0.28, 0.34)
    shield = strip((-y + 0.2, r + 0.05), (-y + 0.48, bar - 0.15), 0.1)
    return {
        "body": join(
            egg((0, y - 0.12, seat - 0.4), (x, 0.55, 0.42)),
            box((0, 0, 0.36), (x * 0.85, y - 0.15, 0.1), 0.04),
            prism(shield, 0, x),
            egg((0, -y, r + 0.22), (0.19, 0.38, 0.22)),
        ),
        "wheels": join(_disc(0, -y, r, r), _disc(0, y, r, r)),
        "seat": box((0, y - 0.24, seat), (x * 0.8, 0.45, 0.12), 0.1),
        "handlebar": join(
            tube((-0.48, -y + 0.5, bar), (0.48, -y + 0.5, bar), 0.09, 0.03),
            capsule((0, -y + 0.5, bar), (0, -y + 0.42, bar - 0.3), 0.12),
        ),
        "lamp": ball((0, -y + 0.36, bar - 0.04), 0.17),
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
        "wheels": both(join(*(_disc(x + 0.14, v, high * 0.46, high * 0.33, 0.1) for v in ys))),
    }


def _van(draw: Draw, top: float, y: float, panes: int) -> Parts:
    """A high body with a short slanted nose."""
    x, hood, wheel = draw(0.54, 0.62), draw(0.72, 0.82), draw(0.24, 0.28)
    nose, brow = (-y * 0.74, hood), (-y * draw(0.46, 0.54), top)
    side = [(-y, 0.24), (y, 0.24), (y, top), brow, nose, (-y, hood - 0.1)]
    at = [tuple(a + (b - a) * t for a, b in zip(nose, brow, strict=True)) for t in (0.1, 0.86)]
    z = (hood + top) / 2
    spots = [-y * 0.3, y * 0.18, y * 0.64][:panes]
    row = [box((x, v, z), (0.05, y * 0.19, (top - hood) * 0.3), 0.02) for v in spots]
    return {
        "body": prism(side, 0, x),
        "windows": join(prism(strip(at[0], at[1], 0.05), 0, x * 0.84), both(join(*row))),
        "wheels": _wheels(x * 0.95, (-y * 0.62, y * 0.6), wheel),
        "lamps": both(ball((x * 0.66, -y + 0.02, hood - 0.28), 0.11)),
    }


def van(draw: Draw) -> Parts:
    """A van with one, two or three side windows."""
    return _van(draw, draw(1.2, 1.4), draw(1.1, 1.25), 1 + draw.which(3))


def ambulance(draw: Draw) -> Parts:
    """A high van with a cross on its side and a light on its roof."""
    top, y = draw(1.3, 1.45), draw(1.1, 1.2)
    parts = _van(draw, top, y, 1)
    v, z = y * 0.42, top * 0.64
    cross = (box((0, v, z), (0.66, 0.3, 0.1)), box((0, v, z), (0.66, 0.1, 0.3)))
    stripe = box((0, 0.1, 0.42), (0.65, y - 0.08, 0.07))
    light = box((0, -y * 0.28, top + 0.06), (0.38, 0.14, 0.14), 0.04)
    return parts | {"cross": join(*cross, stripe), "light": light}


def taxi(draw: Draw) -> Parts:
    """A car with a sign on its roof and a chequered band."""
    parts = car(draw)
    return parts | {"sign": box((0, 0.2, 1.3), (draw(0.24, 0.34), 0.13, draw(0.17, 0.2)), 0.04)}


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
        "wheels": _wheels(x * 0.92, (-y * 0.6, y * 0.42, y * 0.82)[: 2 + draw.chance(0.5)], wheel),
        "lockers": both(join(*locker)),
        "light": box((0, -y + cab, top + 0.04), (x * 0.75, 0.13, 0.13), 0.04),
    }


def jeep(draw: Draw) -> Parts:
    """An open field car: flat fenders, a windscreen, a spare wheel, sometimes a top."""
    x, y, wheel = draw(0.5, 0.56), draw(0.98, 1.1), draw(0.34, 0.38)
    belt, top = draw(0.82, 0.9), draw(1.38, 1.5)
    hood, front = -y * draw(0.25, 0.35), draw(0.1, 0.14)
    roll = box((x - 0.1, y - 0.5, (belt + top) / 2), (0.09, 0.09, (top - belt) / 2 + 0.08))
    closed = draw.chance(0.5)
    well = box((0, (hood + y) / 2 + 0.02, belt), (x - 0.12, (y - hood) / 2 - 0.16, 0.3))
    roof = box((0, (hood + y) / 2, top), (x, (y - hood) / 2, 0.09), 0.03)
    bar = box((0, y - 0.5, top), (x - 0.02, 0.09, 0.09))
    return {
        "body": join(
            cut(box((0, 0, belt / 2 + 0.16), (x, y, belt / 2 - 0.16), 0.04), well),
            both(box((x + 0.08, -y * 0.62, wheel * 2 + 0.06), (0.16, 0.36, 0.08), 0.02)),
            both(box((x + 0.08, y * 0.62, wheel * 2 + 0.06), (0.16, 0.36, 0.08), 0.02)),
        ),
        "windows": box(
            (0, hood, (belt + top) / 2 + 0.02), (x - 0.02, 0.08, (top - belt) / 2), 0.02
        ),
        "wheels": join(
            _wheels(x + 0.04, (-y * 0.62, y * 0.62), wheel, 0.14),
            tube((0, y - 0.02, belt * 0.75), (0, y + 0.2, belt * 0.75), wheel * 0.9, 0.04),
        ),
        "lamps": both(ball((x * 0.68, -y, belt * 0.74), front)),
        "seats": both(box((x * 0.45, hood + 0.62, belt * 0.95), (0.17, 0.12, 0.3), 0.06)),
        "roof": join(both(roll), roof if closed else bar),
    }


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
                _disc(wide, 0.5, big, big, 0.18), _disc(wide - 0.04, -y * 0.75, small, small, 0.13)
            )
        ),
        "rims": both(
            join(
                _disc(wide + 0.1, 0.5, big, big * 0.5, 0.13),
                _disc(wide, -y * 0.75, small, small * 0.5, 0.14),
                tube((0, -y * 0.75, small), (wide, -y * 0.75, small), 0.13),
                tube((0, 0.5, big), (wide, 0.5, big), 0.13),
            )
        ),
        "exhaust": capsule(
            (x * 0.45, -y * 0.5, hood - 0.1), (x * 0.45, -y * 0.5, top - 0.15), 0.09
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


def wheelbarrow(draw: Draw) -> Parts:
    """A tray on one wheel, two handles, two legs."""
    x, r, floor, top = draw(0.46, 0.54), draw(0.28, 0.34), draw(0.56, 0.62), draw(1.05, 1.2)
    side = [(-0.85, top), (-0.4, floor), (0.45, floor), (0.7, top)]
    hollow = [(-0.72, top + 0.02), (-0.36, floor + 0.13), (0.4, floor + 0.13), (0.58, top + 0.02)]
    rail = capsule((0.1, -0.85, r), (x - 0.08, 1.2, draw(0.72, 0.9)), 0.09)
    leg = capsule((x * 0.6, 0.5, 0.6), (x * 0.75, 0.55, 0.1), 0.09)
    return {
        "tray": cut(prism(side, 0, x), prism(hollow, 0, x - 0.12)),
        "wheel": _disc(0, -0.85, r, r, 0.12),
        "frame": both(join(rail, leg)),
        "handles": both(capsule((x - 0.09, 1.0, 0.78), (x - 0.06, 1.36, 0.86), 0.12)),
    }


def skateboard(draw: Draw) -> Parts:
    """A board with raised ends on four small wheels."""
    x, y, bend, r = draw(0.34, 0.4), draw(0.66, 0.78), draw(0.18, 0.34), draw(0.17, 0.21)
    z = 2 * r + 0.16
    end = moved(tube((0, 0, -0.1), (0, 0, 0.1), x, 0.04), (0, 0.4, 0))
    tip = turned(join(end, box((0, 0.16, 0), (x, 0.26, 0.1), 0.04)), 0, math.degrees(bend))
    return {
        "board": join(
            box((0, 0, z), (x, y + 0.05, 0.1), 0.04),
            both(moved(tip, (0, y, z)), 1),
        ),
        "wheels": both(tube((x - 0.2, y * 0.7, r), (x + 0.04, y * 0.7, r), r, 0.05), 0, 1),
        "trucks": both(
            join(
                tube((-x + 0.1, y * 0.7, r), (x - 0.1, y * 0.7, r), 0.09),
                box((0, y * 0.7, r + 0.08), (0.14, 0.14, 0.16)),
            ),
            1,
        ),
    }


def sled(draw: Draw) -> Parts:
    """Slats upon two runners that curl up in front."""
    x, y, seat, count = draw(0.42, 0.52), draw(1.0, 1.2), draw(0.48, 0.58), 3
    curl = draw(0.3, 0.4)
    bend = [
        (-y + curl * (1 - math.sin(a)), 0.1 + curl * (1 - math.cos(a)))
        for a in (0, 0.5, 1, 1.6, 2.2, 2.7)
    ]
    path = [(y, 0.1), *bend]
    runner = [((x, *a), (x, *b)) for a, b in itertools.pairwise(path)]
    posts = [((x, v, 0.1), (x, v, seat)) for v in (-y * 0.45, y * 0.6)]
    width = (x + 0.12) / count
    slats = (
        box(((2 * k - count + 1) * width, 0.1, seat), (width - 0.04, y - 0.05, 0.09), 0.03)
        for k in range(count)
    )
    bars = (box((0, v, seat - 0.1), (x + 0.06, 0.11, 0.08)) for v in (-y * 0.45, y * 0.6))
    return {"seat": join(*slats, *bars), "runners": both(rods(0.1, *runner, *posts))}


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
        "wheels": _wheels(x * 0.7, (-y * 0.7, -y * 0.36, y * 0.36, y * 0.7), 0.22, 0.14),
        "roof": join(
            box((0, 0, top + 0.03), (x * 0.7, y * 0.84, 0.11)),
            both(capsule((0, 0, top + 0.5), (0, 0.4, top + 0.1), 0.09), 1),
            box((0, 0, top + 0.54), (0.4, 0.1, 0.09)),
        ),
    }


TRANSPORT = {
    "bicycle": bicycle,
    "motorcycle": motorcycle,
    "scooter": scooter,
    "tank": tank,
    "van": van,
    "ambulance": ambulance,
    "taxi": taxi,
    "fire truck": fire_truck,
    "jeep": jeep,
    "tractor": tractor,
    "excavator": excavator,
    "wagon": wagon,
    "wheelbarrow": wheelbarrow,
    "skateboard": skateboard,
    "sled": sled,
    "tram": tram,
}
