"""A barn, a log cabin, a skyscraper, a castle of sand and a sailing boat."""

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
    mirrored,
    moved,
    prism,
    smooth_curve,
    tube,
    turned,
    within,
)


def barn(draw: Draw) -> Parts:
    """Its gambrel gable to the front: a great door with a white cross, a loft with hay."""
    wide, long, wall = draw(0.8, 0.92), draw(0.95, 1.2), draw(0.78, 0.9)
    knee, ridge = wall + draw(0.44, 0.52), wall + draw(0.72, 0.82)
    gable = [(wide, 0), (wide, wall), (wide * 0.66, knee), (0, ridge)]
    over = [(wide + 0.16, wall - 0.1), (wide * 0.68 + 0.1, knee + 0.09), (0, ridge + 0.15)]
    inner = [(0, ridge - 0.02), (wide * 0.66 - 0.02, knee - 0.05), (wide - 0.02, wall - 0.14)]
    sheet = [*over, *inner]
    x, y, high = wide * 0.5, -long, wall * 0.84
    bar = box((0, 0, 0), (0.075, 0.08, math.hypot(x, high / 2)))
    lean = math.degrees(math.atan2(x, high / 2))
    loft = wall + 0.26
    post = box((wide - 0.06, y, wall / 2), (0.085, 0.06, wall / 2))
    frame = both(box((x, y - 0.02, high / 2), (0.075, 0.08, high / 2)))
    cross = [moved(turned(bar, 1, side * lean), (0, y - 0.02, high / 2)) for side in (-1, 1)]
    return {
        "walls": prism(mirrored(gable), 1, long),
        "roof": both(prism(sheet, 1, long + 0.12)),
        "trim": join(
            both(post),
            frame,
            box((0, y - 0.02, high), (x + 0.075, 0.08, 0.08)),
            *cross,
            cut(box((0, y - 0.02, loft), (0.34, 0.09, 0.26)), box((0, y, loft), (0.2, 1, 0.12))),
        ),
        "door": box((0, y, high / 2), (x, 0.05, high / 2)),
        "hay": box((0, y, loft), (0.24, 0.06, 0.16)),
    }


def log_cabin(draw: Draw) -> Parts:
    """Thick logs that cross at the corners, a gable roof, a chimney, a door, a window."""
    wide, deep, r, rows = draw(1.0, 1.12), draw(0.7, 0.8), 0.2, 3
    rise, over, step = draw(0.6, 0.72), 0.28, 2 * 0.2
    top = rows * step
    sides = [
        tube((wide, -0.2, r * 2 + k * step), (wide, deep + over, r * 2 + k * step), r)
        for k in range(rows - 1)
    ]
    fronts = [
        tube((-0.2, deep, r + k * step), (wide + over, deep, r + k * step), r) for k in range(rows)
    ]
    half = deep + over + 0.1
    # Up into the roof: a gap under it would be a slit.
    eaves = top + 0.08 + rise - (rise + 0.18) * deep / half
    gable = [(-deep, top - 0.1), (deep, top - 0.1), (deep, eaves), (0, top + rise + 0.08)]
    slope = [(0.0, top + rise + 0.22), (half, top), (half, top - 0.18), (0.0, top + rise)]
    x, y = draw(0.42, 0.48), -deep - r
    stack, peak = wide * 0.6, top + rise + 0.46
    return {
        "logs": join(
            both(join(*fronts, *sides), 0, 1), box((0, 0, top / 2), (wide, deep, top / 2))
        ),
        "roof": both(prism(slope, 0, wide + over + 0.04), 1),
        "chimney": join(
            box((-stack, 0.2, (top + peak) / 2), (0.2, 0.2, (peak - top) / 2)),
            box((-stack, 0.2, peak), (0.28, 0.28, 0.1)),
        ),
        "door": box((-x, y, 0.46), (0.28, 0.13, 0.46)),
        "window": box((x, y, 0.66), (0.24, 0.18, 0.22)),
        "frame": join(
            box((x, y, 0.66), (0.36, 0.09, 0.34)),
            ball((-x + 0.13, y - 0.13, 0.44), 0.1),
        ),
        "gable": prism([*gable, (-deep, eaves)], 0, wide + 0.06),
    }


def skyscraper(draw: Draw) -> Parts:
    """A slim tower with set-backs, bands of windows around it, an entrance, a spire."""
    wide, low, mast, row = draw(0.4, 0.43), 0.33, draw(0.36, 0.44), draw(0.28, 0.292)
    walls, glass = [box((0, 0, low / 2), (wide, wide, low / 2))], []
    for count, share in ((5, 1.0), (2, 0.68)):
        half, high = wide * share, (count - 0.24) * row + 0.145
        walls.append(box((0, 0, low + high / 2 - 0.05), (half, half, high / 2 + 0.05)))
        for k in range(count):
            place = (0, 0, low + (k + 0.38) * row)
            glass.append(box(place, (half + 0.065, half + 0.065, row * 0.26)))
        low += high
    walls.append(box((0, 0, low), (wide * 0.4, wide * 0.4, 0.135)))
    return {
        "walls": join(*walls),
        "windows": join(*glass),
        "base": box((0, 0, 0.11), (wide + 0.145, wide + 0.145, 0.11)),
        "door": box((0, -wide - 0.07, 0.17), (0.16, 0.145, 0.17)),
        "spire": lathe([(0.082, low), (0.077, low + 0.135 + mast)]),
    }


def _merlons(count: int, r: float, z: float) -> Solid:
    return around(count, box((r - 0.08, 0, z), (0.09, 0.085, 0.1)))


def sandcastle(draw: Draw) -> Parts:
    """Round towers with battlements, two with cones, a keep with a flag, a gate, on a heap."""
    wide, r, high = draw(0.66, 0.74), draw(0.25, 0.29), draw(0.72, 0.86)
    keep, tall, heap = draw(0.33, 0.37), draw(1.1, 1.25), 0.18
    tower = lathe([(r * 1.16, 0), (r, high)], 0.0, (wide, wide))
    crown = moved(_merlons(5, r + 0.03, high + 0.06), (wide, wide, 0))
    cone = lathe([(r * 1.3, high), (r * 1.3, high + 0.08), (0.05, high + 0.56)], 0.02, (wide, wide))
    curtain = box((0, wide, 0.24), (wide, 0.13, 0.26))
    teeth = [box((u, wide, 0.52), (0.085, 0.13, 0.1)) for u in (0.0, 0.34)]
    walls = join(curtain, both(join(*teeth)))
    back = both(cut(cone, box((0, 0, high - 1), (3, 3, 1))))
    top = high + tall - 0.7
    flag = [(0.02, top + 0.52), (0.46, top + 0.4), (0.02, top + 0.26)]
    return {
        "towers": moved(
            join(
                both(tower, 0, 1),
                *(turned(walls, 2, 90 * k) for k in range(4)),
                both(moved(crown, (0, -2 * wide, 0))),
                lathe([(keep * 1.14, 0), (keep, top)]),
                _merlons(6, keep + 0.03, top + 0.06),
            ),
            (0, 0, heap),
        ),
        "cones": moved(back, (0, 0, heap)),
        "gate": moved(
            join(
                box((0, -wide - 0.1, 0.12), (0.16, 0.07, 0.14)),
                tube((0, -wide - 0.17, 0.26), (0, -wide - 0.03, 0.26), 0.16),
            ),
            (0, 0, heap),
        ),
        "heap": lathe([(wide * 2.0, 0), (wide * 1.72, heap)], 0.03),
        "flag": moved(
            join(prism(flag, 1, 0.075), tube((0, 0, top - 0.1), (0, 0, top + 0.54), 0.075)),
            (0, 0, heap),
        ),
    }


def sailboat(draw: Draw) -> Parts:
    """A hull with a pointed bow, a mast with its boom, a mainsail and a jib."""
    long, wide, deep = draw(1.05, 1.2), draw(0.36, 0.42), draw(0.36, 0.42)
    high, foot = draw(1.75, 1.95), deep + 0.26
    mast = -0.14
    plan = smooth_curve(
        [(wide * 0.8, long), (wide, long * 0.3), (wide * 0.86, -long * 0.3), (0.02, -long - 0.14)]
    )
    side = [
        (long, deep),
        (long * 0.9, 0.1),
        (long * 0.6, 0),
        (-long * 0.55, 0),
        (-long * 0.85, 0.12),
        (-long - 0.2, deep),
    ]
    hull = prism(mirrored(plan), 2, deep)
    rim = [(u + 0.025, v) for u, v in plan]
    half = prism(side, 0, 2)
    inner = [(u * 0.82, v * 0.86) for u, v in plan]
    main = smooth_curve(
        [(long * 0.86, foot), (long * 0.56, foot + high * 0.45), (mast + 0.14, foot + high * 0.94)]
    )
    jib = [(mast - 0.12, foot), (mast - 0.1, foot + high * 0.74), (-long * 0.98, foot - 0.04)]
    return {
        "hull": within(hull, half),
        "deck": prism(mirrored(inner), 2, 0.08, deep - 0.03),
        "mast": join(
            tube((0, mast, deep), (0, mast, foot + high), 0.08),
            tube((0, mast, foot - 0.06), (0, long * 0.9, foot - 0.06), 0.08),
        ),
        "sails": join(
            prism([(mast + 0.08, foot), *main, (mast + 0.08, foot + high * 0.94)], 0, 0.08),
            prism(jib, 0, 0.08),
        ),
        "stripe": within(prism(mirrored(rim), 2, 0.08, deep - 0.11), half),
        "flag": prism(
            [(mast, foot + high), (mast + 0.4, foot + high - 0.12), (mast, foot + high - 0.26)],
            0,
            0.08,
        ),
    }


DWELLINGS = {
    "sailboat": sailboat,
    "barn": barn,
    "log cabin": log_cabin,
    "skyscraper": skyscraper,
    "sandcastle": sandcastle,
}
