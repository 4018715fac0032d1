"""A factory, a shop, a gas station; and a mountain."""

import math

from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    both,
    box,
    cut,
    grown,
    join,
    lathe,
    limb,
    moved,
    prism,
    tube,
    within,
)


def factory(draw: Draw) -> Parts:
    """A hall with a saw-tooth roof, windows and a gate; two chimneys with bands."""
    x, y, eave = draw(1.05, 1.35), draw(0.6, 0.95), draw(0.85, 1.2)
    tooth, high, r = draw(0.4, 0.54), draw(2.2, 2.7), draw(0.2, 0.25)
    step = 2 * x / 3
    teeth = [prism([(-x + step * k, eave - 0.15), (-x + step * k, eave + tooth),
                    (-x + step * (k + 1), eave + 0.08), (-x + step * (k + 1), eave - 0.15)], 1,
                   y + 0.06) for k in range(3)]  # fmt: skip
    back = y + 0.1
    stacks = [(x * 0.1, high), (x * 0.72, high - 0.32)]
    return {
        "hall": join(
            box((0, 0, eave / 2), (x, y, eave / 2)),
            box((x * 0.2, back, 0.5), (x * 0.76, 0.34, 0.5)),
        ),
        "roof": join(*teeth),
        "chimneys": join(*(lathe([(r + 0.1, 0), (r, top)], 0.0, (u, back)) for u, top in stacks)),
        "bands": join(*(tube((u, back, top - d - 0.2), (u, back, top - d), r + 0.1, 0.02)
                        for u, top in stacks for d in (0.0, 0.42))),
        "windows": join(
            *(box((-x + step * (k + 0.5), -y, eave * 0.66), (step * 0.32, 0.05, 0.16), 0.01)
              for k in range(3)),
            both(box((x, 0, eave * 0.6), (0.05, y * 0.6, 0.17), 0.01)),
        ),
        "gate": join(
            box((-x + step * 1.5, -y, 0.2), (step * 0.36, 0.06, 0.22), 0.01),
            box((-x + step * 2.5, -y, 0.19), (0.16, 0.06, 0.2), 0.01),
        ),
    }  # fmt: skip


def shop(draw: Draw) -> Parts:
    """A front with a wide window, a door, a striped awning, a sign above them."""
    x, y, high = draw(0.9, 1.35), draw(0.6, 0.95), draw(1.9, 2.6)
    eave, out = draw(1.16, 1.34), draw(0.34, 0.55)
    sign, stripe = draw(0.2, 0.25), 2 * (x + 0.04) / 7
    slope = [(-y + 0.05, eave + 0.34), (-y + 0.05, eave + 0.1), (-y - out, eave - 0.14),
             (-y - out, eave + 0.02)]  # fmt: skip
    bars = [prism(slope, 0, stripe / 2, stripe * (k - 3)) for k in range(7)]
    raised = [grown(bars[k], 0.03) for k in (1, 3, 5)]
    side = 1 if draw.chance(0.5) else -1
    door, z = -side * x * 0.58, eave + 0.34 + sign + 0.06
    pane = (side * x * 0.32, x * 0.5)
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y, high / 2)),
            box((0, -0.04, 0.07), (x + 0.06, y + 0.1, 0.07), 0.02),
        ),
        "awning": join(*bars),
        "stripes": join(*raised),
        "window": join(
            box((pane[0], -y, 0.64), (pane[1], 0.09, 0.36), 0.01),
            both(box((x, 0, 0.66), (0.08, y * 0.5, 0.3), 0.01)),
        ),
        "door": join(
            box((door, -y, 0.54), (x * 0.24, 0.12, 0.48), 0.01),
            box((0, 0, high + 0.02), (x + 0.1, y + 0.1, 0.11), 0.03),
        ),
        "sign": box((0, -y - 0.03, z), (x * draw(0.7, 0.86), 0.09, sign), 0.03),
    }


def gas_station(draw: Draw) -> Parts:
    """A flat roof with a band on two posts, two pumps with hoses on their islands."""
    x, y, high = draw(1.15, 1.48), draw(0.65, 1.0), draw(1.7, 2.35)
    post, pump, tall = draw(0.12, 0.2), draw(0.22, 0.32), draw(0.9, 1.25)
    at, deep = x * 0.52, 0.2
    front = -0.28
    hose = [(at + pump, front, tall * 0.82), (at + pump + 0.2, front, tall * 0.7),
            (at + pump + 0.2, front, tall * 0.36),
            (at + pump - 0.02, front, tall * 0.3)]  # fmt: skip
    return {
        "roof": box((0, 0, high + 0.1), (x, y, 0.14), 0.03),
        "band": box((0, 0, high + 0.12), (x + 0.05, y + 0.05, 0.07), 0.02),
        "posts": join(
            both(box((at, 0.1, high / 2), (post, post, high / 2))),
            box((0, 0, 0.07), (x * 0.98, y * 0.8, 0.07), 0.03),
        ),
        "pumps": both(box((at, front, tall / 2 + 0.06), (pump, deep, tall / 2), 0.06)),
        "screens": both(
            join(
                box((at, front - deep, tall * 0.78), (pump - 0.08, 0.05, 0.14), 0.02),
                box((at, front - deep, tall * 0.4), (pump - 0.1, 0.05, 0.1), 0.02),
            )
        ),
        "hoses": both(limb(hose, 0.085, 0.085)),
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


def _above_teeth(low: float, deep: float) -> Solid:
    """All that is above a jagged edge about +Z, between ``low`` and ``low`` + ``deep``."""
    notch = prism([(-0.3, low - 0.5), (-0.22, low - 0.01), (0, low + deep), (0.22, low - 0.01),
                   (0.3, low - 0.5)], 0, 1.0, 1.0)  # fmt: skip
    return cut(box((0, 0, low + 3), (3, 3, 3)), around(6, notch, 30))


PREMISES = {
    "factory": factory,
    "shop": shop,
    "gas station": gas_station,
    "mountain": mountain,
}
