"""What is worn at the neck and at the waist."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    box,
    capsule,
    cut,
    egg,
    join,
    moved,
    prism,
    ring,
    tilted,
    tube,
    turned,
    within,
)


def _oval(wide: float, deep: float, low: float, high: float) -> Solid:
    """An upright wall's filling: an oval between two heights."""
    turns = [math.tau * k / 48 for k in range(48)]
    outline = [(wide * math.cos(t), deep * math.sin(t)) for t in turns]
    return prism(outline, 2, (high - low) / 2, (high + low) / 2)


def belt(draw: Draw) -> Parts:
    """Closed, its great buckle to the front; the free end lies over it beside the buckle."""
    wide, deep, half = draw(0.95, 1.05), draw(0.76, 0.86), draw(0.19, 0.22)
    frame, reach = half + 0.14, draw(0.56, 0.66)
    strap = cut(_oval(wide, deep, 0, 2 * half), _oval(wide - 0.15, deep - 0.15, -1, 2))
    end = cut(
        _oval(wide + 0.1, deep + 0.1, 0.02, 2 * half - 0.02), _oval(wide - 0.05, deep - 0.05, -1, 2)
    )
    region = prism(
        [(0, half - 1), (reach, half - 1), (reach + 0.2, half), (reach, half + 1), (0, half + 1)],
        1,
        1,
        -1,
    )
    y = -deep - 0.06
    window = box((0, y, half), (frame - 0.13, 1, frame - 0.15))
    prong = capsule((-frame + 0.06, y - 0.08, half), (frame - 0.08, y - 0.1, half), 0.075)
    holes = [tube((u, -2, half), (u, 0, half), 0.07) for u in (-0.62, -0.42)]
    dots = within(
        cut(_oval(wide + 0.02, deep + 0.02, 0, 2 * half), _oval(wide - 0.17, deep - 0.17, -1, 2)),
        join(*holes),
    )
    keeper = box((reach * 0.8, -deep * 0.9, half), (0.085, 0.2, half + 0.075), 0.02)
    return {
        "strap": join(strap, within(end, region)),
        "buckle": join(cut(box((0, y, half), (frame + 0.04, 0.1, frame), 0.03), window), prong),
        "keeper": keeper,
        "holes": dots,
    }


def scarf(draw: Draw) -> Parts:
    """Wound about a neck that is not there, both ends hang down before it, with fringes."""
    wide, thick, long = draw(0.5, 0.56), draw(0.25, 0.29), draw(1.05, 1.25)
    z, lean = 1.5, draw(7, 11)
    half, y = 0.24, -wide - 0.12
    loops = join(
        tilted(ring((0, 0, 0), wide, thick), 14, (0, 0, z)),
        tilted(ring((0, 0, 0), wide * 0.94, thick * 0.9), -4, (0, 0.02, z + 0.3)),
    )

    def hung(solid: Solid, side: float) -> Solid:
        return moved(turned(solid, 1, side * lean), (-0.2 * side, y - 0.1 * (side > 0), z - 0.1))

    def end(share: float) -> Solid:
        tall = long * share
        return box((0, 0, -tall / 2), (half, 0.1, tall / 2), 0.04)

    def bands(share: float) -> Solid:
        low = -long * share
        return join(*(box((0, 0, low + at), (half + 0.025, 0.125, 0.075)) for at in (0.16, 0.44)))

    def fringe(share: float) -> Solid:
        low = -long * share
        tufts = (tube((u, 0, low - 0.17), (u, 0, low + 0.04), 0.08) for u in (-0.17, 0, 0.17))
        return join(*tufts)

    sides = ((-1, 0.84), (1, 1.0))
    return {
        "wool": join(loops, *(hung(end(share), side) for side, share in sides)),
        "stripes": join(*(hung(bands(share), side) for side, share in sides)),
        "fringes": join(*(hung(fringe(share), side) for side, share in sides)),
        "knot": egg((0, y - 0.14, z - 0.06), (0.3, 0.2, 0.26)),
    }


WORN = {"belt": belt, "scarf": scarf}
