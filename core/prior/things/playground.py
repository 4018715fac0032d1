"""Rides and swings of a playground or a fair."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.outlines import strip


def seesaw(draw: Draw) -> Parts:
    """A plank on a stand, one end down, with a seat and a handle at either end."""
    x, y, high = draw(1.3, 1.45), draw(0.16, 0.2), draw(0.5, 0.58)
    seat, bar, wide = draw(0.2, 0.25), draw(0.26, 0.32), draw(0.34, 0.42)
    tilt = math.degrees(math.asin((high - 0.12) / x))
    handle = join(
        box((x * 0.66, 0, bar / 2), (0.065, 0.065, bar / 2 + 0.04)),
        tube((x * 0.66, -y - 0.08, bar), (x * 0.66, y + 0.08, bar), 0.075),
    )
    board = {
        "plank": box((0, 0, 0), (x, y, 0.075)),
        "seats": both(box((x - seat, 0, 0.11), (seat, y + 0.08, 0.07), 0.02)),
        "handles": both(handle),
    }
    stand = prism([(-wide, 0), (wide, 0), (0.09, high), (-0.09, high)], 1, 0.075)
    return {name: moved(turned(part, 1, tilt), (0, 0, high)) for name, part in board.items()} | {
        "stand": both(moved(stand, (0, y + 0.07, 0)), 1),
        "axle": tube((0, -y - 0.2, high - 0.06), (0, y + 0.2, high - 0.06), 0.12),
    }


def swing(draw: Draw) -> Parts:
    """A beam on two pairs of legs, two seats that hang from it."""
    x, y, high = draw(1.1, 1.25), draw(0.6, 0.72), draw(1.65, 1.85)
    seat, wide, at = draw(0.4, 0.52), draw(0.22, 0.27), draw(0.46, 0.54)
    leg = prism(strip((0.0, high), (y, 0.08), 0.085), 0, 0.085, x)
    ropes = [
        box((at + s * wide, 0, (high + seat) / 2), (0.055, 0.055, (high - seat) / 2))
        for s in (-1, 1)
    ]
    return {
        "frame": join(
            both(leg, 0, 1),
            tube((-x - 0.16, 0, high), (x + 0.16, 0, high), 0.11),
            both(box((x, 0, high * 0.42), (0.07, y * 0.6, 0.07))),
        ),
        "ropes": both(join(*ropes)),
        "seats": both(box((at, 0, seat), (wide + 0.07, 0.2, 0.07), 0.02)),
    }


def _horse(size: float) -> Solid:
    """A wooden horse that runs to -Y, about the origin."""
    legs = both(
        join(
            taper((0.06, -0.17, -0.06), (0.06, -0.27, -0.28), 0.07, 0.055),
            taper((0.06, 0.17, -0.06), (0.06, 0.27, -0.28), 0.07, 0.055),
        )
    )
    whole = join(
        egg((0, 0, 0), (0.13, 0.28, 0.14)),
        taper((0, -0.18, 0.04), (0, -0.3, 0.3), 0.12, 0.085),
        taper((0, -0.29, 0.32), (0, -0.44, 0.22), 0.09, 0.065),
        taper((0, 0.25, 0.06), (0, 0.38, -0.1), 0.07, 0.055),
        legs,
    )
    return lambda p: whole(p / size) * size


def carousel(draw: Draw) -> Parts:
    """A round floor, horses on poles, a pointed canopy with a scalloped trim."""
    r, floor, eave = draw(1.2, 1.32), draw(0.2, 0.26), draw(1.35, 1.5)
    rise, way, size = draw(0.5, 0.62), r * 0.76, draw(0.98, 1.12)
    z = floor + draw(0.42, 0.5)
    horse = _horse(size)
    # On either side they run from the back to the front.
    ride = join(
        *(
            moved(turned(horse, 2, a), (way * math.cos(t), way * math.sin(t), z))
            for a in (-62, 0, 62)
            for t in (math.radians(a),)
        )
    )
    pole = tube((way, 0, floor - 0.02), (way, 0, eave), 0.065)
    scallop = tube((r + 0.0, 0, eave - 0.02), (r + 0.1, 0, eave - 0.02), 0.16)
    tip = eave + rise
    return {
        "floor": join(
            tube((0, 0, 0), (0, 0, floor), r), tube((0, 0, 0), (0, 0, floor * 0.5), r + 0.14)
        ),
        "column": lathe([(0.34, floor - 0.02), (0.28, eave + 0.02)]),
        "canopy": lathe([(r + 0.04, eave), (r + 0.04, eave + 0.06), (0.06, tip)]),
        "trim": join(
            around(12, scallop, 15),
            tube((0, 0, eave - 0.03), (0, 0, eave + 0.1), r + 0.1),
            tube((0, 0, tip - 0.1), (0, 0, tip + 0.08), 0.08),
            ball((0, 0, tip + 0.14), 0.13),
        ),
        "poles": both(join(*(turned(pole, 2, a) for a in (-62, 0, 62)))),
        "horses": both(ride),
    }


def ferris_wheel(draw: Draw) -> Parts:
    """A wheel that faces the front, eight cabins on its rim, legs on either side, a base."""
    r, z, cabin = draw(0.98, 1.06), draw(1.42, 1.5), draw(0.19, 0.215)
    foot, rim, hub = draw(0.62, 0.74), 0.085, draw(0.16, 0.2)
    y, low, high = 0.38, -0.36, draw(0.0, 0.04)
    cup = lathe([(cabin * 0.7, low), (cabin, low + 0.1), (cabin, low + 0.18)])
    lid = lathe([(cabin + 0.04, low + 0.17), (0.05, high + 0.06)])
    places = [
        (r * math.cos(a), 0.0, z + r * math.sin(a)) for a in (math.pi / 4 * k for k in range(8))
    ]
    spoke = box((0, 0, 0), (r, 0.06, 0.06))
    spokes = join(*(turned(spoke, 1, 45 * k) for k in range(4)))
    leg = prism(strip((0.02, z), (foot, 0.05), 0.085), 1, 0.08, y)
    return {
        "rim": ring((0, 0, z), r, rim, 1),
        "spokes": moved(spokes, (0, 0, z)),
        "cabins": join(*(moved(cup, at) for at in places)),
        "roofs": join(*(moved(lid, at) for at in places)),
        "legs": join(
            both(leg, 0, 1),
            tube((0, -y - 0.1, z), (0, y + 0.1, z), hub),
        ),
        "base": box((0, 0, 0.07), (foot + 0.22, y + 0.18, 0.07)),
    }


PLAYGROUND = {
    "seesaw": seesaw,
    "swing": swing,
    "carousel": carousel,
    "ferris wheel": ferris_wheel,
}
