"""Cars, vans, and a wheel."""

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
    grown,
    join,
    limb,
    mirrored,
    moved,
    outlined,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.outlines import strip
from core.prior.things.shared.vehicle_parts import greenhouse
from core.prior.things.shared.wheels import disc_wheels, rimmed_wheel, wheels


def car(draw: Draw) -> Parts:
    """A car with a hood, a cabin whose sides lean in and a short boot, narrower at both ends."""
    x, y, wheel = draw(0.58, 0.63), draw(1.3, 1.38), draw(0.26, 0.285)
    belt, roof, floor = draw(0.66, 0.7), draw(1.02, 1.08), 0.2
    nose = belt - draw(0.07, 0.11)
    front, back = -y * draw(0.38, 0.42), y * draw(0.72, 0.78)
    hull = [(-y + 0.05, floor), (-y, floor + 0.08), (-y, nose - 0.08), (-y + 0.1, nose)]
    hull += [(front, belt), (y - 0.06, belt), (y, belt - 0.06), (y, floor + 0.08)]
    hull.append((y - 0.05, floor))
    plan = [(x * 0.8, -y), (x, -y * 0.68), (x, y * 0.72), (x * 0.86, y)]
    line = (front, front + draw(0.38, 0.44), back - draw(0.38, 0.44), back)
    tyres, hubs = zip(*(rimmed_wheel(x - 0.1, v, wheel) for v in (-y * 0.6, y * 0.6)), strict=True)
    cabin, glass = greenhouse(x, belt, roof, line)
    return {
        "body": join(outlined(hull, plan), cabin),
        "windows": glass,
        "wheels": both(join(*tyres)),
        "lamps": both(box((x * 0.57, -y + 0.03, nose - 0.13), (0.13, 0.08, 0.075))),
        "hubs": both(join(*hubs)),
    }


def taxi(draw: Draw) -> Parts:
    """A car with a sign on its roof and a chequered band."""
    parts = car(draw)
    return parts | {"sign": box((0, 0.2, 1.16), (draw(0.22, 0.3), 0.12, draw(0.15, 0.18)), 0.04)}


def sports_car(draw: Draw) -> Parts:
    """Low, broad and like a wedge, with a waist, a flat cabin, a wing over the tail."""
    x, y, wheel = draw(0.64, 0.69), draw(1.32, 1.42), draw(0.255, 0.275)
    belt, roof, floor = draw(0.6, 0.64), draw(0.88, 0.94), 0.15
    front, tail, wing = -y * draw(0.32, 0.38), belt + draw(0.0, 0.04), draw(0.86, 0.94)
    hull = [
        (-y + 0.1, floor),
        (-y, 0.2),
        (-y, 0.34),
        (-y * 0.8, 0.5),
        (-y * 0.5, 0.57),
        (front, belt),
    ]
    hull += [(y * 0.5, tail), (y, tail), (y, tail - 0.18), (y - 0.1, floor)]
    plan = [(x * 0.7, -y), (x * 0.97, -y * 0.74), (x * 0.97, -y * 0.4), (x * 0.93, 0.0)]
    plan += [(x, y * 0.42), (x, y * 0.7), (x * 0.9, y)]
    first = front + draw(0.48, 0.54)
    line = (front, first, first + draw(0.3, 0.36), y * 0.7)
    tyres, hubs = wheels(x - 0.11, [(v, wheel) for v in (-y * 0.6, y * 0.6)], 0.13)
    lamp = turned(box((0, 0, 0), (0.12, 0.14, 0.07)), 0, 24)
    foot = box((x * 0.56, y - 0.18, (tail + wing) / 2), (0.09, 0.12, (wing - tail) / 2 + 0.04))
    cabin, glass = greenhouse(x * 0.93, belt, roof, line)
    return {
        "body": join(outlined(hull, plan), cabin),
        "windows": glass,
        "wheels": tyres,
        "hubs": hubs,
        "lamps": both(moved(lamp, (x * 0.6, -y + 0.22, 0.46))),
        "spoiler": join(
            box((0, y - 0.16, wing), (x * 0.92, 0.19, 0.07)),
            both(foot),
            box((0, -y + 0.02, 0.18), (x * 0.66, 0.14, 0.08)),
        ),
    }


def race_car(draw: Draw) -> Parts:
    """A formula car: open wheels, a pointed nose between wings, a helmet in the cockpit."""
    x, y, front, back = draw(0.68, 0.78), draw(1.24, 1.36), draw(0.32, 0.37), draw(0.36, 0.42)
    pod, rear, high = draw(0.46, 0.56), draw(0.84, 0.92), draw(0.92, 1.06)
    axles = ((-y * 0.5, front), (rear, back))
    nose = [(-y - 0.06, 0.2), (-y - 0.06, 0.36), (-0.5, 0.66), (0.2, 0.66), (0.2, 0.16)]
    tub = [(-0.62, 0.14), (-0.6, 0.4), (-0.3, 0.56), (0.6, 0.54), (1.24, 0.44), (1.24, 0.16)]
    pods = [(0.24, 1.24), (pod, 0.7), (pod + 0.02, -0.1), (pod * 0.8, -0.4), (0.26, -0.62)]
    cover = [(0.14, 0.4), (0.14, 1.0), (0.24, 1.1), (0.46, 1.06), (1.2, 0.6), (1.2, 0.4)]
    ends = [(x * 0.98, -y + 0.02, 0.3, 0.2, 0.2), (x * 0.86, y - 0.18, high - 0.14, 0.26, 0.28)]
    tyres, hubs = wheels(x, axles, draw(0.17, 0.22))
    return {
        "body": join(
            outlined(nose, [(0.28, 0.2), (0.28, -0.4), (0.13, -y), (0.1, -y - 0.06)]),
            outlined(tub, pods),
            prism(cover, 0, 0.14),
        ),
        "wings": join(
            box((0, -y + 0.02, 0.18), (x, 0.17, 0.09), 0.02),
            box((0, y - 0.18, high), (x * 0.86, 0.22, 0.09), 0.02),
            box((0, y - 0.2, high - 0.3), (0.1, 0.14, 0.3)),
            box((0, y - 0.34, 0.34), (0.2, 0.24, 0.1)),
            *(both(box((u, v, w), (0.09, a, b), 0.02)) for u, v, w, a, b in ends),
        ),
        "wheels": tyres,
        "hubs": join(hubs, *(tube((-x, v, r), (x, v, r), 0.09) for v, r in axles)),
        "cockpit": box((0, -0.16, 0.64), (0.2, 0.32, 0.1), 0.06),
        "helmet": ball((0, -0.08, 0.84), draw(0.2, 0.23)),
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


def jeep(draw: Draw) -> Parts:
    """A field car: a flat hood between fenders, an upright cabin, bumpers, a spare wheel."""
    x, y, wheel = draw(0.56, 0.61), draw(1.04, 1.16), draw(0.31, 0.35)
    belt, roof, floor = 2 * wheel + draw(0.24, 0.3), draw(1.38, 1.48), wheel + 0.06
    front, hood, axles = -y * draw(0.28, 0.36), belt - 0.04, (-y * 0.62, y * 0.6)
    inner, eyes = x - 0.1, belt - 0.2  # half the width between the fenders
    side = [(-y, floor), (-y, hood - 0.05), (-y + 0.06, hood), (front, belt), (y, belt)]
    side.append((y, floor))
    flare = mirrored([(wheel + 0.2, wheel + 0.1), (wheel + 0.08, 2 * wheel + 0.09)])
    fenders = join(*(moved(prism(flare, 0, x + 0.04), (0, v, 0)) for v in axles))
    line = [(front, belt - 0.08), (front + draw(0.12, 0.18), roof), (y - 0.08, roof)]
    line.append((y - 0.02, belt - 0.08))
    across = [(inner - 0.01, belt - 0.08), (inner - 0.06, roof)]
    cabin = within(prism(line, 0, 2), prism(mirrored(across), 1, 3))
    band = box((0, 0, (belt + roof) / 2), (2, 3, (roof - belt) * 0.34))
    spare = wheel * 0.82
    bumper = box((0, -y - 0.05, floor + 0.05), (x - 0.02, 0.08, 0.09), 0.02)
    step = box((x - 0.02, 0, floor - 0.02), (0.1, y * 0.3, 0.06))
    return {
        "body": join(prism(side, 0, inner), fenders),
        "windows": within(grown(cabin, 0.04), band),
        "wheels": join(
            disc_wheels(x - 0.06, axles, wheel, 0.13),
            tube((0, y - 0.02, belt - 0.06), (0, y + 0.17, belt - 0.06), spare, 0.04),
        ),
        "lamps": both(tube((inner * 0.66, -y - 0.06, eyes), (inner * 0.66, -y + 0.1, eyes), 0.11)),
        "trim": join(bumper, moved(bumper, (0, 2 * y + 0.06, 0)), both(step)),
        "roof": cabin,
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
        "wheels": disc_wheels(x * 0.95, (-y * 0.62, y * 0.6), wheel),
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


def golf_cart(draw: Draw) -> Parts:
    """A low body with a bench under a roof on posts, golf bags behind."""
    x, y, r = draw(0.5, 0.58), draw(0.9, 1.02), draw(0.24, 0.29)
    top, nose, seat = draw(1.66, 1.82), draw(0.76, 0.86), draw(0.6, 0.68)
    side = [(-y, 0.22), (-y - 0.02, 0.5), (-y + 0.2, nose), (-y + 0.42, nose + 0.04),
            (-y + 0.6, 0.42), (-0.06, 0.42), (0.0, seat - 0.06), (y - 0.1, seat + 0.06),
            (y, seat - 0.1), (y, 0.24)]  # fmt: skip
    posts = [((x - 0.1, -y + 0.34, nose - 0.1), (x - 0.14, -y + 0.66, top)),
             ((x - 0.1, 0.56, seat), (x - 0.14, 0.5, top))]  # fmt: skip
    tyres, hubs = wheels(x - 0.06, [(-y * 0.62, r), (y * 0.62, r)], 0.13)
    wheel = tilted(ring((0, 0, 0), 0.17, 0.07), 50, (-x * 0.45, -y + 0.66, nose + 0.2))
    u, back, rim = x * 0.48, y + 0.04, seat + 0.42
    bag = tube((u, back - 0.06, 0.44), (u, back + 0.04, rim), 0.16, 0.04)
    clubs = [
        limb([(u + d, back, rim - 0.1), (u + d, back + 0.06, rim + up)], 0.07, 0.07)
        for d, up in ((-0.08, 0.3), (0.09, 0.18))
    ]
    heads = [egg((u - 0.08, back, rim + 0.32), (0.09, 0.15, 0.1)),
             egg((u + 0.09, back, rim + 0.2), (0.09, 0.15, 0.1))]  # fmt: skip
    return {
        "body": cut(
            grown(prism(side, 0, x - 0.05), 0.03),
            both(join(*(tube((x - 0.2, s * y * 0.62, r), (2, s * y * 0.62, r), r + 0.06)
                        for s in (-1, 1)))),
        ),
        "roof": box((0, 0.1, top), (x + 0.02, y * 0.76, 0.1), 0.06),
        "seat": join(
            box((0, 0.24, seat + 0.08), (x - 0.08, 0.26, 0.11), 0.05),
            box((0, 0.5, seat + 0.34), (x - 0.08, 0.1, 0.26), 0.05),
        ),
        "posts": join(
            both(join(*(capsule(a, b, 0.075) for a, b in posts))),
            hubs,
            wheel,
            both(join(*clubs, *heads)),
            capsule((-x * 0.45, -y + 0.68, nose + 0.2), (-x * 0.45, -y + 0.3, nose), 0.075),
        ),
        "wheels": tyres,
        "bags": both(join(bag, tube((u, back, rim - 0.1), (u, back + 0.02, rim), 0.19, 0.03))),
    }  # fmt: skip


def go_kart(draw: Draw) -> Parts:
    """Low, on four thick wheels: a nose, pods at its sides, a seat before the engine."""
    x, y, r = draw(0.76, 1.05), draw(0.9, 1.08), draw(0.28, 0.42)
    rear, wide, back = r * draw(1.0, 1.3), draw(0.13, 0.22), draw(0.4, 0.75)
    z = 0.3
    axles = ((-y, r, wide), (y, rear, wide * 1.35))
    wheels = [tube((x - w, v, q), (x + w, v, q), q, 0.07) for v, q, w in axles]
    hubs = [tube((x - w, v, q), (x + w + 0.04, v, q), q * 0.5, 0.03) for v, q, w in axles]
    nose = [(-y - 0.46, 0.14), (-y - 0.42, 0.34), (-y + 0.1, 0.62), (-y + 0.42, 0.56),
            (-y + 0.42, 0.16)]  # fmt: skip
    pod = [(-y + 0.52, 0.14), (-y + 0.52, 0.4), (y - 0.5, 0.48), (y - 0.5, 0.14)]
    seat = [(-0.12, z), (-0.16, z + 0.24), (0.32, z + 0.22), (0.5, z + back + 0.24),
            (0.68, z + back + 0.22), (0.56, z)]  # fmt: skip
    wheel = tilted(ring((0, 0, 0), 0.24, 0.085), 55, (0, -0.46, 0.86))
    return {
        "body": join(
            outlined(nose, [(x * 0.62, -y + 0.5), (x * 0.62, -y - 0.2), (x * 0.4, -y - 0.5)]),
            both(prism(pod, 0, 0.17, x * 0.74)),
        ),
        "frame": join(
            box((0, 0, 0.23), (x * 0.66, y + 0.12, 0.1), 0.03),
            tube((-x, -y, r), (x, -y, r), 0.1),
            tube((-x, y, rear), (x, y, rear), 0.1),
            box((0, y + 0.3, 0.38), (x * 0.6, 0.11, 0.12), 0.05),
            box((0, y + 0.16, 0.28), (0.3, 0.12, 0.08)),
        ),
        "wheels": both(join(*wheels)),
        "hubs": both(join(*hubs)),
        "seat": join(prism(seat, 0, 0.36), both(prism([*seat[:3], (0.5, z + 0.5), (0.56, z)], 0,
                                                      0.09, 0.36))),
        "engine": join(
            box((0, y - 0.12, z + 0.3), (0.4, 0.22, 0.26), 0.05),
            wheel,
            capsule((0, -0.46, 0.86), (0, -y + 0.3, 0.4), 0.09),
            both(tube((0.24, y - 0.1, z + 0.3), (0.24, y + 0.3, z + 0.36), 0.11, 0.02)),
        ),
    }  # fmt: skip


def wheel(draw: Draw) -> Parts:
    """Upright, its face to the front: a tyre with treads, a rim, five spokes, a hub with nuts."""
    r, wide, rim = draw(1.3, 1.48), draw(0.34, 0.54), draw(0.64, 0.74)
    half, hub, core = draw(0.13, 0.17), r * draw(0.24, 0.28), r * rim

    def facing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, r))

    def hoop(outer: float, inner: float, half: float) -> Solid:
        return cut(tube((0, 0, -half), (0, 0, half), outer), tube((0, 0, -2), (0, 0, 2), inner))

    lug = box((r - 0.15, 0, 0), (0.15, 0.17, wide))
    out = (hub + core) / 2 - 0.1
    nut = tube((out, 0, 0), (out, 0, wide * 0.5 + 0.1), 0.11)
    return {
        "tyre": facing(hoop(r - 0.11, core, wide)),
        "treads": facing(around(12, lug, 90)),
        "rim": facing(hoop(core + 0.04, core - 0.16, wide + 0.06)),
        "spokes": facing(around(5, box((core / 2, 0, 0), (core / 2, half, wide * 0.5)), 90)),
        "hub": facing(tube((0, 0, -wide * 0.8), (0, 0, wide * 0.8), hub)),
        "nuts": facing(join(around(5, nut, 90), tube((0, 0, 0), (0, 0, wide * 0.8 + 0.08), 0.14))),
    }


CARS = {
    "car": car,
    "taxi": taxi,
    "sports car": sports_car,
    "race car": race_car,
    "limousine": fitted(limousine),
    "jeep": jeep,
    "van": van,
    "ambulance": ambulance,
    "camper": camper,
    "golf cart": golf_cart,
    "go-kart": go_kart,
    "wheel": wheel,
}
