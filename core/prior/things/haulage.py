"""What hauls, builds and carries, on wheels and tracks; and a water tower."""

import math
from collections.abc import Iterable

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

Point = tuple[float, float]


def wheels(x: float, axles: Iterable[Point], half: float) -> tuple[Solid, Solid]:
    """Tyres on the floor at both sides, ``x`` from the middle, (y, radius) each; and their hubs."""
    tyres, hubs = [], []
    for y, r in axles:
        hollow = tube((x + half - 0.05, y, r), (x + half + 1, y, r), r * 0.64)
        tyres.append(cut(tube((x - half, y, r), (x + half, y, r), r, 0.05), hollow))
        hubs.append(tube((x - half, y, r), (x + half + 0.02, y, r), r * 0.5, 0.03))
    return both(join(*tyres)), both(join(*hubs))


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


def pane(low: Point, high: Point, out: int, half: float) -> Solid:
    """A pane on a cabin's slanted end, of which the lower and the upper edge are given as (y, z);
    ``out`` is the side of y that it looks to."""
    (a, b), (c, d) = low, high
    length = math.hypot(c - a, d - b)
    across = (out * (d - b) / length * 0.06, abs(c - a) / length * 0.06)
    ends = [(a + (c - a) * t, b + (d - b) * t) for t in (0.3, 0.84)]
    corners = [(u + s * across[0], v + s * across[1]) for s in (1, -1) for u, v in ends[::s]]
    return prism(corners, 0, half)


def pickup_truck(draw: Draw) -> Parts:
    """A hood, a cab and an open bed, all of plane faces, on large wheels; or with a roll bar."""
    x, y, wheel = draw(0.64, 0.7), draw(1.28, 1.4), draw(0.33, 0.36)
    belt, roof, nose = 2 * wheel + draw(0.32, 0.36), draw(1.54, 1.64), 2 * wheel + draw(0.22, 0.26)
    front, back, axles = -y * draw(0.38, 0.44), y * draw(0.22, 0.28), (-y * 0.58, y * 0.6)
    side, cab, floor, eyes = x - 0.16, x - 0.09, wheel + 0.02, nose - 0.2  # side: where arches end
    hull = [(-y, floor), (-y, nose - 0.08), (-y + 0.08, nose), (front, belt), (y, belt), (y, floor)]
    roofline = [(front, belt - 0.1), (front + 0.38, roof), (back - 0.08, roof), (back, belt - 0.1)]
    middle, half = (back + y) / 2 - 0.06, (y - back) / 2 - 0.12
    flare = mirrored([(wheel + 0.18, floor), (wheel - 0.02, 2 * wheel + 0.16)])
    flares = [moved(prism(flare, 0, x + 0.08), (0, v, 0)) for v in axles]
    arches = join(*(tube((side, v, wheel), (2, v, wheel), wheel + 0.07) for v in axles))
    solid = join(prism(hull, 0, x), *flares)
    low, high = belt + 0.06, roof - 0.12
    light = [(front + 0.22, low), (front + 0.45, high), (back - 0.22, high), (back - 0.17, low)]
    slants = ((front, front + 0.38, -1), (back, back - 0.08, 1))
    panes = (pane((a, belt - 0.1), (b, roof), s, cab - 0.12) for a, b, s in slants)
    bar = box((0, back + 0.28, roof - 0.37), (x - 0.07, 0.1, 0.32))
    hoop = cut(bar, box((0, back, roof - 0.57), (x - 0.28, 1, 0.32)))
    body = join(
        cut(solid, box((0, middle, belt), (x - 0.18, half, 0.28)), both(arches)),
        prism(roofline, 0, cab),
    )
    tyres, hubs = wheels(x - 0.05, [(v, wheel) for v in axles], 0.17)
    return {
        "body": join(body, hoop) if draw.chance(0.4) else body,
        "windows": join(*panes, both(prism(light, 0, 0.07, cab))),
        "wheels": tyres,
        "trim": join(
            hubs,
            both(box((0, y + 0.02, floor), (x + 0.04, 0.12, 0.11)), 1),
            box((0, -y, eyes), (x - 0.34, 0.08, 0.1)),
        ),
        "lamps": both(box((x - 0.18, -y, eyes), (0.13, 0.1, 0.11))),
        "bed": box((0, middle, belt - 0.28), (x - 0.15, half + 0.03, 0.06)),
    }


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


def water_tower(draw: Draw) -> Parts:
    """A banded tank with a pointed roof on four braced legs, a pipe down its middle."""
    r, low, high = draw(0.64, 0.76), draw(1.4, 1.66), draw(0.74, 0.92)
    top, foot, rise = low + high, draw(0.62, 0.74), draw(0.34, 0.46)
    hip, z = r * 0.68, low * 0.46
    mid = (foot + hip) / 2
    tank = tube((0, 0, low), (0, 0, top), r)
    hoops = join(*(tube((0, 0, v - 0.08), (0, 0, v + 0.08), r + 0.05)
                   for v in (low + high * 0.24, low + high * 0.74)))  # fmt: skip
    bowl = lathe(smooth_curve([(0.14, low - 0.26), (r * 0.7, low - 0.14), (r, low + 0.02)]))
    side = join(
        capsule((0.0, mid, z), (mid, mid, z), 0.085),
        capsule((mid, mid, z), (-hip, hip, low - 0.06), 0.085),
        capsule((-mid, mid, z), (hip, hip, low - 0.06), 0.085),
    )
    return {
        "tank": join(tank, bowl),
        "roof": join(
            lathe([(r + 0.12, top - 0.04), (r + 0.12, top + 0.06), (0.1, top + rise),
                   (0.0, top + rise)]), ball((0, 0, top + rise), 0.12)),
        "bands": hoops,
        "legs": both(
            join(taper((foot, foot, 0.1), (hip, hip, low), 0.1, 0.1),
                 box((foot, foot, 0.06), (0.16, 0.16, 0.08), 0.02)), 0, 1),
        "braces": join(both(side, 0, 1), turned(both(side, 0, 1), 2, 90)),
        "pipe": join(tube((0, 0, 0), (0, 0, low), 0.13), tube((0, 0, 0), (0, 0, 0.16), 0.22)),
    }  # fmt: skip


HAULAGE = {
    "pickup truck": pickup_truck,
    "bulldozer": bulldozer,
    "dump truck": dump_truck,
    "cement mixer": cement_mixer,
    "steamroller": steamroller,
    "minecart": minecart,
    "stagecoach": stagecoach,
    "water tower": water_tower,
}
