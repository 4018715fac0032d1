"""Books, charms, weapons and things of games."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    circle,
    closed_curve,
    pipe,
    plate,
    ring,
    rod,
)


def _open_book(draw: Draw) -> Parts:
    deep, lines = draw(1.1, 1.25), 9 + draw.which(3)
    # From the spine to the right: the pages rise, then fall to the fore edge.
    top = [(0.0, 0.1), (0.08, 0.19), (0.25, 0.22), (0.5, 0.17), (0.76, 0.09)]
    block = [*top, (0.79, 0.02), (0.0, 0.02)]
    pages = plate(block, deep - 0.06, (0, 0, 0), FRONT)
    text = []
    for k in range(lines):
        y = (0.5 - (k + 1) / (lines + 1)) * (deep - 0.16)
        end = 0.66 if k % 4 < 3 else 0.45
        places = [
            (x, y, float(np.interp(x, *np.array(top).T)) + 0.001) for x in (0.16, 0.3, 0.5, end)
        ]
        text.append(pipe(places, 0.009))
    cover = [
        box((0.86, deep, 0.035), (0.43, 0, 0.005), 0.008, (0, 0, 0)),
        box((0.1, deep, 0.04), (0.0, 0, 0.004), 0.01),
    ]
    corner = [(0, 0), (0.13, 0), (0, 0.13)]
    corners = [
        plate(np.array(corner) * (-1, s), 0.05, (0.862, -s * (deep / 2 + 0.002), 0.005), FLAT)
        for s in (-1, 1)
    ]
    ribbon = [(0.02, deep / 2 - 0.1, 0.12), (0.03, 0.0, 0.125), (0.06, -deep / 2 + 0.02, 0.13)]
    ribbon += [(0.09, -deep / 2 - 0.06, 0.06), (0.1, -deep / 2 - 0.16, 0.0)]
    return {
        "cover": both_sides(cover),
        "pages": both_sides([pages]),
        "text": both_sides(text),
        "corners": both_sides(corners),
        "ribbon": [pipe(ribbon, 0.018)],
    }


def _shuriken(draw: Draw) -> Parts:
    points = 4 + 2 * draw.which(2)
    angle = np.arange(2 * points) * np.pi / points + np.pi / 2
    far = np.where(np.arange(2 * points) % 2, 0.28 if points == 4 else 0.42, 1.0)
    outline = far[:, None] * np.stack([np.cos(angle), np.sin(angle)], 1)
    return {
        "blade": [plate(outline, 0.07, (0, 0, 0), FRONT, [circle(0.11)])],
        "edge": [
            plate(0.6 * outline, 0.1, (0, 0, 0), FRONT, [circle(0.16)]),
        ],
        "ring": [ring(0.14, 0.035, (0, 0, 0), "y")],
    }


def _dreamcatcher(draw: Draw) -> Parts:
    count, radius = 8 + 2 * draw.which(2), 0.5
    wound = [ring(radius, 0.035, (0, 0, 0), "y")]
    net, outer = [], radius
    for k in range(4):
        inner, shift = outer * 0.66, k % 2
        for j in range(count):
            a, b, c = (2 * np.pi * (j + s + 0.5 * shift) / count for s in (0.0, 0.5, 1.0))
            for first, last in ((a, b), (b, c)):
                far = (outer, inner) if first == a else (inner, outer)
                ends = [
                    (r * np.cos(t), 0, r * np.sin(t))
                    for r, t in zip(far, (first, last), strict=True)
                ]
                net += [rod(ends[0], ends[1], 0.01), ball(0.014, ends[1])]
        outer = inner
    for j in range(count):
        a = 2 * np.pi * j / count
        net.append(rod((0, 0, 0), (outer * np.cos(a), 0, outer * np.sin(a)), 0.01))
    vane = closed_curve(
        [
            (0, 0.02),
            (0.05, -0.06),
            (0.055, -0.2),
            (0.02, -0.36),
            (0, -0.4),
            (-0.05, -0.28),
            (-0.055, -0.1),
        ]
    )
    feathers, strings, beads = [], [], [ball(0.06, (0, -0.01, 0))]
    for x, long in ((-0.3, 0.32), (0.0, 0.42), (0.3, 0.32)):
        start = (x, 0, -np.sqrt(radius**2 - x * x))
        end = start[2] - long
        strings.append(rod(start, (x, 0, end), 0.012))
        beads += [ball(0.035, (x, 0, start[2] - f * long)) for f in (0.3, 0.5, 0.85)]
        feathers += [
            plate(vane, 0.022, (x, 0, end + 0.01), FRONT),
            rod((x, 0, end + 0.02), (x, 0, end - 0.37), 0.014),
        ]
    strings.append(
        pipe([(0, 0, 0.5), (-0.05, 0, 0.62), (0, 0, 0.72), (0.05, 0, 0.62)], 0.014, closed=True)
    )
    return {"hoop": wound, "net": [*net, *strings], "beads": beads, "feathers": feathers}


CHARMS_AND_GAMES: dict[str, Callable[[Draw], Parts]] = {
    "open book": _open_book,
    "shuriken": _shuriken,
    "dreamcatcher": _dreamcatcher,
}
