"""Small buildings and places."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    cut,
    join,
    lathe,
    moved,
    prism,
    taper,
    tube,
    turned,
)

Point = tuple[float, float]


def dome_of(radius: float, low: float, high: float, steps: int = 14) -> list[Point]:
    """The profile of a quarter ellipse, from its rim to its top."""
    angles = [math.pi / 2 * k / steps for k in range(steps + 1)]
    return [(radius * math.cos(a), low + (high - low) * math.sin(a)) for a in angles]


def tunnel(r: float, z: float, front: float, back: float) -> Solid:
    """A vault along y: a half cylinder of radius ``r`` on walls of height ``z``."""
    walls = box((0, (front + back) / 2, z / 2), (r, (back - front) / 2, z / 2))
    return join(cut(tube((0, front, z), (0, back, z), r), box((0, 0, z - 1), (3, 3, 1))), walls)


def igloo(draw: Draw) -> Parts:
    """A dome of snow, an entrance tunnel with a dark opening."""
    r, high, side = draw(1.05, 1.18), draw(1.0, 1.15), draw(0.34, 0.4)
    long, rim = draw(0.3, 0.42), draw(0.1, 0.13)
    front, z = -r - long, 0.3
    return {
        "dome": lathe([(r * 0.97, 0.0), *dome_of(r, 0.14, high)]),
        "tunnel": tunnel(side, z, front + 0.1, 0),
        "arch": tunnel(side + rim, z, front, front + 0.24),
        "door": tunnel(side - 0.08, z - 0.02, front - 0.04, -0.3),
    }


def volcano(draw: Draw) -> Parts:
    """A mountain with a crater, lava that overflows in streams, a cloud of smoke."""
    r, high, crater = draw(1.38, 1.52), draw(1.2, 1.4), draw(0.36, 0.42)
    waist = draw(0.66, 0.76)
    side = [(r, 0.0), (waist + 0.26, high * 0.33), (waist, high * 0.6), (crater + 0.04, high)]
    thick = [(u + 0.075, v + 0.02) for u, v in side]
    # A stream is what of a thicker mountain is above its foot and within a bar.
    coat = lathe(thick)
    feet = draw(0.16, 0.22), draw(0.36, 0.44)
    first = box((0, -1.0, 1 + high * feet[0]), (0.18, 1.0, 1))
    second = turned(box((1.0, 0, 1 + high * feet[1]), (1.0, 0.18, 1)), 2, 30)
    bars = join(first, both(second))
    streams = cut(coat, lambda p: -bars(p))
    puff = draw(0.24, 0.28)
    top = high + 0.2
    return {
        "mountain": lathe(side),
        "lava": join(streams, lathe(dome_of(crater + 0.1, high - 0.06, high + 0.16))),
        "smoke": join(
            ball((0, 0, top + puff * 0.7), puff),
            both(ball((puff * 1.15, 0, top + puff * 1.9), puff * 1.1)),
            ball((0, 0, top + puff * 2.5), puff * 1.25),
        ),
        "rocks": around(6, lathe(dome_of(0.2, 0, 0.24), 0.0, (r - 0.07, 0)), 30),
    }


def staircase(draw: Draw) -> Parts:
    """Six steps that rise to the back, with treads, and a handrail on either side."""
    x, run, rise, rail = draw(0.58, 0.7), draw(0.34, 0.38), draw(0.24, 0.29), draw(0.6, 0.7)
    count, thick = 6, 0.11
    front = -run * count / 2
    side, treads = [(front, 0.0)], []
    for k in range(count):
        y, z = front + run * k, rise * (k + 1)
        side += [(y, z - 0.04), (y + run, z - 0.04)]
        treads.append(box((0, y + run / 2 - 0.03, z - 0.03), (x + 0.05, run / 2 + 0.03, 0.055)))
    low, last = (front + run / 2, rise), (front + run * (count - 0.5), rise * count)
    posts = [box((x - 0.09, y, z + rail / 2), (0.09, 0.09, rail / 2)) for y, z in (low, last)]
    middle = ((low[0] + last[0]) / 2, (low[1] + last[1]) / 2)
    posts.append(box((x - 0.09, middle[0], middle[1] + rail / 2), (0.07, 0.07, rail / 2)))
    knobs = [ball((x - 0.09, y, z + rail + 0.14), 0.14) for y, z in (low, last)]
    bar = [(y, z + rail + e) for (y, z), e in ((low, -thick), (last, -thick), (last, thick))]
    bar.append((low[0], low[1] + rail + thick))
    return {
        "body": prism([*side, (-front, 0.0)], 0, x),
        "treads": join(*treads),
        "posts": both(join(*posts)),
        "rails": both(prism(bar, 0, 0.1, x - 0.09)),
        "knobs": both(join(*knobs)),
    }


def temple(draw: Draw) -> Parts:
    """Greek: steps, columns around, a beam and a gabled roof."""
    x, y, high = draw(0.84, 0.92), draw(1.08, 1.16), draw(0.88, 1.02)
    r, gable, step = draw(0.13, 0.155), draw(0.4, 0.5), 0.13
    low = 2 * step
    top, beam = low + high, 0.2
    across, along = [-x, -x / 3, x / 3, x], [-y, -y / 2, 0, y / 2, y]
    places = [(u, v) for u in across for v in along if abs(u) == x or abs(v) == y]
    columns = []
    for u, v in places:
        shaft = [(r * 1.08, low), (r * 0.86, top - 0.08), (r * 1.25, top - 0.02)]
        columns += [lathe(shaft, 0, (u, v)), box((u, v, top - 0.05), (r * 1.3, r * 1.3, 0.06))]
    wide, deep, eave = x + 0.26, y + 0.26, top + beam
    roof = [(-wide - 0.06, eave - 0.02), (wide + 0.06, eave - 0.02), (wide + 0.06, eave + 0.06)]
    roof += [(0, eave + gable + 0.14), (-wide - 0.06, eave + 0.06)]
    hall = y - 0.42
    return {
        "base": join(
            *(
                box((0, 0, step * (k + 0.5)), (x + d, y + d, step / 2 + 0.005))
                for k, d in enumerate((0.42, 0.26))
            )
        ),
        "columns": join(*columns),
        "walls": box((0, 0, low + high / 2), (x - 0.36, hall, high / 2 + 0.02)),
        "beam": join(
            box((0, 0, top + beam / 2), (x + 0.19, y + 0.19, beam / 2)),
            prism([(-wide + 0.1, eave), (wide - 0.1, eave), (0, eave + gable)], 1, deep + 0.03),
        ),
        "roof": prism(roof, 1, deep - 0.04),
        "door": box((0, -hall, low + high * 0.36), (x * 0.22, 0.06, high * 0.36)),
    }


def wall(draw: Draw) -> Parts:
    """A straight garden wall between two piers: blocks along its top, a ball on each pier."""
    x, y, high = draw(1.08, 1.18), draw(0.18, 0.23), draw(0.92, 1.1)
    pier, more, cap = draw(0.26, 0.31), draw(0.38, 0.46), 0.1
    top, step = high + more, (x - pier) * 2 / 3
    block = (step / 2 - 0.08, y + 0.1, cap)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2)),
        "piers": both(box((x, 0, top / 2), (pier, pier, top / 2))),
        "cap": join(
            box((0, 0, high), block, 0.02),
            both(box((step, 0, high), block, 0.02)),
            both(box((x, 0, top), (pier + 0.1, pier + 0.1, cap), 0.02)),
            both(ball((x, 0, top + 0.24), 0.21)),
        ),
        "base": join(
            box((0, 0, 0.12), (x, y + 0.1, 0.12)),
            both(box((x, 0, 0.12), (pier + 0.1, pier + 0.1, 0.12))),
        ),
    }


def island(draw: Draw) -> Parts:
    """Floating: a rock that narrows downwards, grass on top, a palm and some stones."""
    r, deep, high = draw(1.0, 1.12), draw(1.05, 1.25), draw(0.85, 1.0)
    leaf, droop = draw(0.74, 0.84), draw(0.24, 0.34)
    top = deep + 0.26
    rock = [(0.1, 0.0), (0.34, deep * 0.3), (0.4, deep * 0.42), (0.72, deep * 0.62)]
    rock += [(0.78, deep * 0.74), (r - 0.06, deep * 0.95), (r - 0.06, deep + 0.02)]
    crown = top + high
    blade = [(0, 0.1), (leaf * 0.45, 0.2), (leaf * 0.85, 0.06), (leaf, -droop)]
    blade += [(leaf * 0.78, -0.12), (leaf * 0.42, -0.02), (0, -0.1)]
    return {
        "rock": lathe(rock),
        "grass": lathe([(r, deep), (r + 0.02, deep + 0.1), (r * 0.86, top), (0, top + 0.05)]),
        "trunk": taper((0, 0, top - 0.1), (0, 0, crown), 0.17, 0.11),
        "leaves": around(5, moved(prism(blade, 1, 0.16), (0, 0, crown + 0.02)), -90),
        "coconuts": around(3, ball((0.16, 0, crown - 0.12), 0.13), 90),
        "stones": join(
            both(lathe(dome_of(0.2, top - 0.08, top + 0.2), 0, (r * 0.58, -r * 0.2))),
            lathe(dome_of(0.17, top - 0.08, top + 0.14), 0, (0, -r * 0.6)),
        ),
    }


def _gabled(x: float, eave: float, ridge: float) -> list[Point]:
    return [(-x, 0), (x, 0), (x, eave), (0, ridge), (-x, eave)]


def greenhouse(draw: Draw) -> Parts:
    """A house of glass in a frame of bars, on a low wall, with plants at its door."""
    x, y, eave = draw(0.74, 0.86), draw(0.94, 1.08), draw(0.85, 0.98)
    ridge, bar, low = eave + draw(0.46, 0.58), 0.085, 0.22
    door, pot = x * 0.36, x * 0.76
    hoop = cut(
        prism(_gabled(x + 0.05, eave + 0.03, ridge + 0.07), 1, bar),
        prism(_gabled(x - 0.13, eave - 0.06, ridge - 0.18), 1, 3),
    )
    end = join(
        box((0, 0, eave), (x, bar, bar)),
        both(box((door, 0, eave / 2), (bar, bar, eave / 2))),
    )
    return {
        "glass": prism(_gabled(x, eave, ridge), 1, y),
        "frame": join(
            *(moved(hoop, (0, y * k, 0)) for k in (-1, 0, 1)),
            both(moved(end, (0, y, 0)), 1),
            both(box((x, 0, eave), (bar, y, bar))),
            box((0, 0, ridge), (bar + 0.02, y + 0.04, bar + 0.02)),
        ),
        "base": box((0, 0, low / 2), (x + 0.12, y + 0.12, low / 2)),
        "door": box((0, -y - 0.06, eave * 0.42), (door - bar, 0.1, eave * 0.42)),
        "plants": both(ball((pot, -y - 0.28, 0.5), 0.26)),
        "pots": both(lathe([(0.16, 0), (0.23, 0.34)], 0, (pot, -y - 0.28))),
    }


def treehouse(draw: Draw) -> Parts:
    """A hut with a gabled roof on a platform in a tree, a ladder up to its door."""
    floor, x, y, wall = draw(1.08, 1.16), draw(0.6, 0.66), draw(0.44, 0.5), draw(0.66, 0.72)
    gable, r, top, front = draw(0.46, 0.54), draw(0.54, 0.6), floor + wall, -y - 0.34
    roof = [(-x - 0.2, top - 0.06), (x + 0.2, top - 0.06), (0, top + gable)]
    at, sill, behind = -0.36, floor + wall * 0.56, y + 0.16
    rungs = (box((at, front, floor * k), (0.3, 0.1, 0.095)) for k in (0.3, 0.64))
    rails = (box((at + s, front, floor / 2), (0.11, 0.12, floor / 2)) for s in (-0.32, 0.32))
    return {
        "trunk": join(
            lathe([(0.5, 0), (0.36, 0.3), (0.32, floor + 0.05)], 0, (0.12, 0.14)),
            tube((0.12, behind, floor), (0.12, behind, top + 0.3), 0.2),
        ),
        "leaves": join(
            ball((0, y + 0.24, top + 0.76), r * 1.12), both(ball((0.64, y + 0.24, top + 0.3), r))
        ),
        "walls": box((0, 0, floor + wall / 2), (x, y, wall / 2)),
        "roof": prism(roof, 1, y + 0.14),
        "floor": join(box((0, 0, floor), (x + 0.28, y + 0.36, 0.11)), *rungs, *rails),
        "door": box((-0.28, -y, floor + 0.34), (0.19, 0.1, 0.26)),
        "windows": join(
            box((0.28, -y, sill), (0.19, 0.1, 0.17)), both(box((x, 0, sill), (0.1, 0.22, 0.17)))
        ),
    }


def gazebo(draw: Draw) -> Parts:
    """Six posts with rails between on a floor, open in front, a pointed roof."""
    r, high, rise = draw(0.95, 1.08), draw(1.0, 1.15), draw(0.55, 0.7)
    over, low, post, rail = draw(0.2, 0.28), 0.2, 0.095, draw(0.4, 0.48)
    flat, eave = r * math.cos(math.pi / 6), low + high
    tip = eave + rise
    cap = [(0, eave), (flat + over, eave), (flat + over, eave + 0.1), (0.06, tip), (0, tip)]
    bars = join(
        box((flat, 0, low + rail), (0.085, r / 2, 0.075)),
        box((flat, 0, low + rail * 0.4), (0.06, r / 2, 0.065)),
    )
    step = [(-0.34, 0), (-0.34, low * 0.5), (-0.16, low * 0.5), (-0.16, low), (0, low), (0, 0)]
    front = flat + 0.14
    return {
        "base": join(
            around(6, box((0, 0, low / 2), (front, 2, low / 2)), -90),
            prism([(u - front + 0.02, v) for u, v in step], 0, r * 0.32),
        ),
        "posts": around(6, tube((r - 0.06, 0, low), (r - 0.06, 0, eave + 0.02), post), 0),
        "rails": cut(
            around(6, bars, -90), box((0, -1.5, low + 0.5), (r / 2 - post - 0.02, 1.2, 0.6))
        ),
        "roof": around(6, prism(cap, 1, 2), -90),
        "beam": cut(
            around(6, box((0, 0, eave - 0.06), (flat + 0.06, 2, 0.1)), -90),
            around(6, box((0, 0, eave - 0.1), (flat - 0.12, 2, 0.12)), -90),
        ),
        "finial": join(
            tube((0, 0, tip - 0.12), (0, 0, tip + 0.12), 0.09), ball((0, 0, tip + 0.18), 0.14)
        ),
    }


def silo(draw: Draw) -> Parts:
    """A tall round store of a farm: hoops, a domed roof, a ladder and a door in front."""
    r, high, dome = draw(0.52, 0.6), draw(1.8, 2.05), draw(0.38, 0.48)
    step = high / 5
    hoops = [tube((0, 0, step * k - 0.06), (0, 0, step * k + 0.06), r + 0.05) for k in (1, 2, 3, 4)]
    rungs = [
        box((0, -r - 0.12, z), (0.2, 0.05, 0.05)) for z in (step * k / 2 for k in range(3, 11))
    ]
    return {
        "body": tube((0, 0, 0), (0, 0, high), r),
        "roof": join(
            lathe([(r + 0.08, high - 0.06), *dome_of(r + 0.08, high + 0.02, high + dome)]),
            tube((0, 0, high + dome - 0.1), (0, 0, high + dome + 0.12), 0.1),
        ),
        "bands": join(*hoops),
        "ladder": join(both(box((0.17, -r - 0.1, high * 0.6), (0.055, 0.08, high * 0.4))), *rungs),
        "door": box((0, -r, 0.17), (0.17, 0.1, 0.17)),
        "base": tube((0, 0, 0), (0, 0, 0.12), r + 0.14, 0.02),
    }


SITES = {
    "igloo": igloo,
    "volcano": volcano,
    "staircase": staircase,
    "temple": temple,
    "wall": wall,
    "island": island,
    "greenhouse": greenhouse,
    "treehouse": treehouse,
    "gazebo": gazebo,
    "silo": silo,
}
