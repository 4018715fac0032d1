"""Objects on a road, and parts and supplies of cars."""

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
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
)


def traffic_light(draw: Draw) -> Parts:
    """A case with three lights under hoods, on a post."""
    x, y, r, post = draw(0.32, 0.38), draw(0.22, 0.28), draw(0.19, 0.22), draw(0.7, 1.3)
    pitch = 2 * r + 0.12
    low = post + pitch / 2 + 0.08
    lamps = [
        tube((0, -y - 0.05, low + pitch * k), (0, 0, low + pitch * k), r, 0.03) for k in range(3)
    ]
    # A hood is the upper half of a short pipe.
    pipe = cut(
        tube((0, -y - 0.26, 0), (0, -y + 0.05, 0), r + 0.08),
        tube((0, -2, 0), (0, -y, 0), r - 0.01),
        box((0, -y - 0.2, -1.02), (1, 1, 1)),
    )
    middle = (post + low + 2.5 * pitch + 0.08) / 2
    return {
        "body": box((0, 0, middle), (x, y, middle - post), draw(0.04, 0.12)),
        "reds": lamps[2],
        "yellows": lamps[1],
        "greens": lamps[0],
        "hoods": join(*(moved(pipe, (0, 0, low + pitch * k)) for k in range(3))),
        "pole": join(
            tube((0, 0, 0.05), (0, 0, post + 0.1), 0.1),
            tube((0, 0, 2 * middle - post - 0.05), (0, 0, 2 * middle - post + 0.09), 0.13, 0.03),
        ),
        "base": lathe([(0.3, 0.0), (0.3, 0.1), (0.16, 0.22)], 0.02),
    }


def traffic_cone(draw: Draw) -> Parts:
    """On a square foot, with one or two white stripes."""
    low, top, high, foot = draw(0.46, 0.54), draw(0.12, 0.15), draw(1.5, 1.75), draw(0.66, 0.76)
    foot_z, two = 0.17, draw.chance(0.6)

    def radius(z: float) -> float:
        return low + (top - low) * (z - foot_z) / (high - foot_z)

    def stripe(share: float, wide: float) -> Solid:
        a, b = high * (share - wide), high * (share + wide)
        return lathe([(radius(a) + 0.05, a), (radius(b) + 0.05, b)], 0.02)

    return {
        "body": join(
            lathe([(low + 0.1, foot_z - 0.03), (low, foot_z + 0.06), (top, high)], 0.01),
            tube((0, 0, high - 0.1), (0, 0, high + 0.03), top + 0.02, 0.03),
        ),
        "stripes": join(stripe(0.36, 0.1), stripe(0.7, 0.09)) if two else stripe(0.55, 0.13),
        "base": box((0, 0, foot_z / 2), (foot, foot, foot_z / 2), 0.05),
    }


def stop_sign(draw: Draw) -> Parts:
    """An octagon with a raised rim and letters, as a band across it, on a post."""
    r, post = draw(0.84, 0.92), draw(0.9, 1.1)
    z, slope = post + r, math.tan(math.pi / 8)

    def octagon(half: float, deep: float) -> Solid:
        e = half * slope
        side = [(half, e), (e, half), (-e, half), (-half, e), (-half, -e), (-e, -half), (e, -half),
                (half, -e)]  # fmt: skip
        return moved(prism(side, 1, deep), (0, 0, z))

    return {
        "plate": octagon(r, 0.12),
        "rim": moved(cut(octagon(r + 0.02, 0.08), octagon(r - 0.14, 0.2)), (0, -0.11, 0)),
        "letters": box((0, -0.11, z), (r * 0.68, 0.1, draw(0.16, 0.19)), 0.03),
        "post": tube((0, 0.2, 0), (0, 0.2, z + r * 0.6), draw(0.1, 0.12), 0.02),
        "base": lathe([(0.36, 0), (0.36, 0.08), (0.2, 0.2)], 0.02, (0, 0.2)),
    }


def signpost(draw: Draw) -> Parts:
    """A post with one or two arrow boards."""
    high, wide = draw(1.9, 2.2), draw(0.75, 0.9)

    def board(z: float, side: float) -> Solid:
        half = 0.22
        corners = [
            (-wide * 0.8, z - half),
            (wide * 0.7, z - half),
            (wide, z),
            (wide * 0.7, z + half),
            (-wide * 0.8, z + half),
        ]
        return prism([(side * u, v) for u, v in corners], 1, 0.09, -0.12)

    boards = [board(high - 0.35, 1)] + ([board(high - 0.95, -1)] if draw.chance(0.6) else [])
    return {
        "boards": join(*boards),
        "post": box((0, 0, high / 2), (0.12, 0.12, high / 2), 0.02),
        "base": tube((0, 0, 0), (0, 0, 0.12), 0.4, 0.03),
    }


def fire_hydrant(draw: Draw) -> Parts:
    """A post with a dome, two outlets at its sides and one in front."""
    r, high = draw(0.34, 0.4), draw(1.15, 1.35)
    z, front, small = high * draw(0.62, 0.67), draw(0.18, 0.21), draw(0.15, 0.18)
    dome = smooth_curve([(r + 0.06, high + 0.02), (r * 0.86, high + 0.26), (0.13, high + 0.42)])
    side = tube((0, 0, z), (r + 0.2, 0, z), small)
    return {
        "body": lathe([(r + 0.02, 0.1), (r, high)], 0.01),
        "dome": lathe(dome, 0.02),
        "rings": join(
            tube((0, 0, high - 0.1), (0, 0, high + 0.05), r + 0.13, 0.03),
            tube((0, 0, 0.0), (0, 0, 0.17), r + 0.2, 0.04),
            tube((0, 0, 0.14), (0, 0, 0.3), r + 0.1, 0.03),
        ),
        "outlets": join(both(side), tube((0, -r - 0.14, z - 0.1), (0, 0, z - 0.1), front)),
        "caps": join(
            both(tube((r + 0.12, 0, z), (r + 0.3, 0, z), small + 0.08, 0.03)),
            both(tube((r + 0.2, 0, z), (r + 0.42, 0, z), 0.09, 0.02)),
            tube((0, -r - 0.24, z - 0.1), (0, -r - 0.06, z - 0.1), front + 0.07, 0.03),
            tube((0, -r - 0.36, z - 0.1), (0, -r - 0.1, z - 0.1), 0.1, 0.02),
            tube((0, 0, high + 0.3), (0, 0, high + 0.56), 0.12, 0.03),
        ),
    }


def mailbox(draw: Draw) -> Parts:
    """A tunnel-shaped box on a post, a flag at its side."""
    r, y, high = draw(0.4, 0.48), draw(0.7, 0.85), draw(1.2, 1.5)
    tunnel = join(
        tube((0, -y, high + r), (0, y, high + r), r, 0.02), box((0, 0, high + r / 2), (r, y, r / 2))
    )
    return {
        "box": tunnel,
        "door": join(
            tube((0, -y - 0.08, high + r), (0, -y, high + r), r * 0.86),
            box((0, -y - 0.04, high + r / 2), (r * 0.86, 0.04, r / 2)),
        ),
        "flag": join(
            box((r + 0.06, -0.1, high + r + 0.2), (0.08, 0.08, 0.35)),
            box((r + 0.06, -0.26, high + r + 0.45), (0.08, 0.2, 0.14)),
        ),
        "post": box((0, 0, high / 2), (0.14, 0.14, high / 2 + 0.05), 0.02),
    }


def jerrycan(draw: Draw) -> Parts:
    """An upright can, an X on both faces, three bars to carry it by, its spout at a corner."""
    x, y, high, soft = draw(0.74, 0.82), draw(0.42, 0.46), draw(1.68, 1.84), 0.12
    slant, r, rise = draw(0.36, 0.42), 0.09, draw(0.26, 0.3)
    side = [(-x, 0), (x, 0), (x, high - slant), (x - slant, high), (-x + 0.14, high)]
    side += [(-x, high - 0.14)]
    middle, tall, wide = high * 0.48, high * 0.36, x * 0.68

    def outline(by: float) -> list[tuple[float, float]]:
        """The can's own, drawn in towards its middle."""
        k, m = 1 - by / x, 1 - by / (high / 2)
        return [(u * k, high / 2 + (v - high / 2) * m) for u, v in side]

    lean = math.degrees(math.atan2(wide, tall))
    bar = box((0, y, 0), (0.12, 0.12, math.hypot(wide, tall)), 0.05)
    cross = join(turned(bar, 1, lean), turned(bar, 1, -lean))
    left, right, top = -x + 0.2, x - slant - 0.02, high + rise
    half = (right - left) / 2
    path = [(-half, high - 0.08), (0.1 - half, top), (half - 0.1, top), (half, high - 0.08)]
    bow = limb([((left + right) / 2 + u, 0, v) for u, v in path], r, r)
    spout = (x - slant * 0.5, 0, high - slant * 0.5)

    def out(along: float) -> tuple[float, float, float]:
        return (spout[0] + along * 0.64, 0, spout[2] + along * 0.77)

    return {
        "body": join(
            grown(prism(outline(soft), 1, y - soft), soft), tube(out(-0.1), out(0.12), 0.17)
        ),
        "cross": both(moved(cross, (0, 0, middle)), 1),
        "handles": join(bow, both(moved(bow, (0, y - 0.08, 0)), 1)),
        "cap": tube(out(0.08), out(0.34), 0.23, 0.05),
        "seam": grown(prism(outline(0), 1, 0.06), 0.06),
    }


def tire(draw: Draw) -> Parts:
    """A tyre that stands on its tread, open in the middle: bold blocks about a thick ring."""
    r, half, hole = draw(1.16, 1.2), draw(0.42, 0.46), draw(0.62, 0.66)
    side = [(hole, -half * 0.72), (hole + 0.14, -half), (r - 0.2, -half), (r, -half * 0.62)]
    profile = [*side, *((u, -v) for u, v in reversed(side))]
    body = grown(cut(lathe(profile), tube((0, 0, -2), (0, 0, 2), hole)), 0.02)
    count = 14
    block = box((r + 0.02, 0, half * 0.5), (0.13, 0.15, half * 0.42), 0.03)
    lower = box((r + 0.02, 0, -half * 0.5), (0.13, 0.15, half * 0.42), 0.03)
    rib = both(ring((0, 0, half), (r + hole) / 2 - 0.04, 0.09), 2)

    def standing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, r + 0.13))

    return {
        "tyre": standing(body),
        "tread": standing(join(around(count, block), around(count, lower, 180 / count))),
        "stripe": standing(rib),
    }


def engine(draw: Draw) -> Parts:
    """A V8: two rows of cylinders under red covers with bright ribs, bright exhaust pipes at the
    sides, a fan and pulleys in front, a round air filter on top."""
    y, lean = draw(0.86, 0.9), 42
    z, pulley = 0.64, (0.6, 1.2)
    half = [(0.3, 0.12), (0.42, 0.42), (0.5, 0.7), (0.9, 1.2), (0.5, 1.5), (0.2, 1.3)]

    def on_bank(solid: Solid) -> Solid:
        return moved(turned(solid, 1, lean), (0.78, 0, 1.42))

    ribs = [on_bank(box((0, 0.5 * k, 0.2), (0.21, 0.11, 0.12), 0.04)) for k in (-1, 0, 1)]
    pipes = [limb([(0.62, 0.5 * k, 0.92), (1.02, 0.5 * k, 0.86), (1.14, 0.5 * k, 0.42)], 0.14, 0.14)
             for k in (-1, 0, 1)]  # fmt: skip
    drain = capsule((1.14, -0.5, 0.34), (1.14, y + 0.26, 0.34), 0.18)
    fan = tilted(around(5, box((0.33, 0, 0), (0.25, 0.15, 0.08), 0.05), 90), 90, (0, -y - 0.42, z))
    u, v = pulley
    return {
        "block": grown(prism(mirrored(half), 1, y - 0.04), 0.04),
        "covers": both(on_bank(box((0, 0, 0), (0.32, y - 0.06, 0.2), 0.08))),
        "ribs": both(join(drain, *ribs, *pipes)),
        "filter": join(
            tube((0, 0, 1.72), (0, 0, 2.04), draw(0.58, 0.61), 0.04),
            tube((0, 0, 1.2), (0, 0, 1.8), 0.3),
        ),
        "lid": join(tube((0, 0, 1.98), (0, 0, 2.16), 0.72, 0.05), ball((0, 0, 2.18), 0.15)),
        "pulleys": both(tube((u, -y - 0.24, v), (u, -y + 0.1, v), 0.25, 0.04)),
        "fan": join(fan, tube((0, -y - 0.58, z), (0, -y + 0.1, z), 0.17, 0.04)),
    }


ROAD = {
    "traffic light": traffic_light,
    "traffic cone": traffic_cone,
    "stop sign": stop_sign,
    "signpost": signpost,
    "fire hydrant": fire_hydrant,
    "mailbox": mailbox,
    "jerrycan": jerrycan,
    "tire": tire,
    "engine": engine,
}
