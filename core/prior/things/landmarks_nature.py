"""Mountains and an island."""

import math

from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    cut,
    grown,
    join,
    lathe,
    moved,
    prism,
    taper,
    turned,
    within,
)
from core.prior.things.shared.outlines import dome_of


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


def _peak(x: float, y: float, r: float, high: float, turn: float) -> Solid:
    """A pyramid of six sides that stands at (x, y); a lower bound."""
    length = math.hypot(r, high)
    sides = [math.radians(turn + 60 * k) for k in range(6)]
    normals = [(math.cos(a) * high / length, math.sin(a) * high / length) for a in sides]

    def distance(p: Tensor) -> Tensor:
        faces = [(p[:, 0] - x) * u + (p[:, 1] - y) * v + (p[:, 2] - high) * r / length
                 for u, v in normals]  # fmt: skip
        result = -p[:, 2]
        for face in faces:
            result = result.maximum(face)
        return result

    return distance


def _above_teeth(low: float, deep: float) -> Solid:
    """All that is above a jagged edge about +Z, between ``low`` and ``low`` + ``deep``."""
    notch = prism([(-0.3, low - 0.5), (-0.22, low - 0.01), (0, low + deep), (0.22, low - 0.01),
                   (0.3, low - 0.5)], 0, 1.0, 1.0)  # fmt: skip
    return cut(box((0, 0, low + 3), (3, 3, 3)), around(6, notch, 30))


def mountain(draw: Draw) -> Parts:
    """A high peak between lower ones, snow on top with a jagged edge, firs at its foot."""
    r, high, side = draw(0.86, 1.06), draw(1.8, 2.8), draw(0.46, 0.74)
    line, out = draw(0.48, 0.68), draw(0.6, 0.72)
    rise = high * side
    main, left = _peak(0, 0.2, r, high, 0), _peak(-out, -0.16, r * 0.66, rise, 30)
    right = _peak(out, -0.1, r * 0.62, rise * draw(0.7, 0.95), 30)
    tooth = moved(_above_teeth(high * line, high * 0.15), (0, 0.2, 0))
    lower = box((0, 0, rise * 0.66 + 3), (3, 3, 3))
    firs = [lathe([(0.2, 0.1), (0.03, 0.62)], 0.01, (u, v))
            for u, v in ((-1.0, -0.86), (-0.6, -1.04), (0.7, -0.96), (1.06, -0.7))]  # fmt: skip
    return {
        "rock": main,
        "snow": join(within(grown(main, 0.06), tooth), within(grown(left, 0.06), lower)),
        "peaks": join(left, right),
        "ground": lathe([(1.46, 0), (1.4, 0.16)], 0.02),
        "firs": join(*firs),
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


LANDMARKS_NATURE = {
    "island": island,
    "mountain": mountain,
    "volcano": volcano,
}
