"""A hovercraft, a tug and a cable car."""

import itertools
from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FLAT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    closed_curve,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _hovercraft(draw: Draw) -> Parts:
    long = draw(0.95, 1.1)
    outline = rounded((1.16, 2 * long), 0.4)
    skirt = [
        plate(g * outline, 0.075, (0, 0, z))
        for g, z in ((1.0, 0.04), (1.05, 0.1), (1.06, 0.16), (1.03, 0.22))
    ] + [ball((0.085, 0.085, 0.11), (1.03 * x, 1.03 * y, 0.11)) for x, y in outline[::2]]
    edge = np.concatenate([outline, outline[:1]])
    for a, b in itertools.pairwise(edge):
        if np.linalg.norm(b - a) > 0.3:
            skirt += [
                ball((0.085, 0.085, 0.11), (*(1.03 * (a + f * (b - a))), 0.11))
                for f in np.arange(0.08, 1, 0.1)
            ]
    hull = [
        plate(0.97 * outline, 0.1, (0, 0, 0.3)),
        plate(0.9 * outline, 0.06, (0, 0, 0.36)),
        plate(
            [
                (-0.7 * long, 0.36),
                (0.35 * long, 0.36),
                (0.3 * long, 0.72),
                (-0.4 * long, 0.72),
                (-0.56 * long, 0.56),
            ],
            0.72,
            (0, 0, 0),
            SIDE,
        ),
        box((0.66, 0.6, 0.05), (0, 0.0, 0.74), 0.02),
    ]
    glass = [
        plate(
            [(-0.62 * long, 0.5), (-0.585 * long, 0.5), (-0.4 * long, 0.69), (-0.435 * long, 0.69)],
            0.62,
            (0, -0.012, 0),
            SIDE,
        ),
        *both_sides(
            [
                box((0.02, 0.2, 0.13), (0.357, y, 0.6), 0.02)
                for y in (-0.28 * long, 0.0, 0.22 * long)
            ]
        ),
    ]
    fans, rotors = [], []
    for x in (-0.3, 0.3):
        fans += placed(
            [turned([(0.24, -0.12), (0.29, -0.14), (0.3, 0.1), (0.26, 0.14), (0.25, 0.1)])],
            BACKWARD,
            (x, 0.74 * long, 0.72),
        )
        fans += [
            box((0.1, 0.16, 0.36), (x, 0.74 * long, 0.52), 0.02),
            rod((x, 0.74 * long - 0.02, 0.7), (x, 0.74 * long + 0.1, 0.72), 0.04),
            box((0.52, 0.03, 0.03), (x, 0.74 * long + 0.08, 0.72)),
            box((0.03, 0.03, 0.52), (x, 0.74 * long + 0.08, 0.72)),
        ]
        rotors += moved(
            [
                *spun([box((0.075, 0.022, 0.24), (0, 0, 0.12), 0.006, (0, 0, 25))], 4, "y"),
                rod((0, -0.1, 0), (0, 0.09, 0), 0.045, rim=0.02),
            ],
            (x, 0.74 * long, 0.72),
        )
        fans += [
            plate(
                [(0.0, -0.26), (0.14, -0.24), (0.14, 0.24), (0.0, 0.26)],
                0.025,
                (x, 0.74 * long + 0.14, 0.72),
                SIDE,
            )
        ]
    mast = [
        rod((0, 0.05, 0.74), (0, 0.1, 1.12), 0.02),
        rod((-0.12, 0.08, 1.0), (0.12, 0.08, 1.0), 0.016),
        ball(0.034, (0, 0.1, 1.12)),
    ]
    return {
        "hull": hull,
        "skirt": skirt,
        "windows": glass,
        "fans": fans,
        "rotors": rotors,
        "mast": mast,
    }


def _tugboat(draw: Draw) -> Parts:
    hull, red = [], []
    wide = draw(0.34, 0.39)

    def deck(w: float, bow: float, stern: float) -> np.ndarray:
        return closed_curve(
            [
                (0, -bow),
                (0.7 * w, -0.72 * bow),
                (w, -0.2),
                (w, 0.4 * stern),
                (0.86 * w, 0.86 * stern),
                (0, stern),
                (-0.86 * w, 0.86 * stern),
                (-w, 0.4 * stern),
                (-w, -0.2),
                (-0.7 * w, -0.72 * bow),
            ]
        )

    for k in range(8):
        up = (k + 0.5) / 8
        (red if k < 3 else hull).append(
            plate(
                deck(wide * (0.62 + 0.38 * up**0.6), 0.72 + 0.16 * up, 0.72 + 0.06 * up),
                0.066,
                (0, 0, -0.4 + 0.06 * k),
            )
        )
    rail = deck(wide + 0.015, 0.92, 0.8)
    hull += [plate(rail, 0.11, (0, 0, 0.1), FLAT, [0.9 * rail])]
    black = [
        pipe([(x, y, 0.09) for x, y in 1.03 * rail[::6]], 0.045, closed=True),
        *both_sides([ring(0.085, 0.04, (wide + 0.045, y, -0.04), "x") for y in (-0.2, 0.1, 0.4)]),
        ball((0.16, 0.1, 0.12), (0, -0.93, 0.06)),
    ]
    house = [
        box((0.46, 0.72, 0.3), (0, 0.06, 0.2), 0.03),
        box((0.38, 0.4, 0.3), (0, -0.08, 0.48), 0.03),
        box((0.46, 0.5, 0.04), (0, -0.08, 0.64), 0.015),
        box((0.52, 0.8, 0.035), (0, 0.06, 0.345), 0.012),
    ]
    glass = (
        [box((0.09, 0.02, 0.13), (x, -0.285, 0.52), 0.01) for x in (-0.11, 0.0, 0.11)]
        + both_sides([box((0.02, 0.1, 0.13), (0.195, y, 0.52), 0.01) for y in (-0.16, 0.0)])
        + both_sides([rod((0.22, y, 0.21), (0.245, y, 0.21), 0.05) for y in (-0.16, 0.06, 0.28)])
    )
    funnel = [rod((0, 0.3, 0.33), (0, 0.33, 0.86), 0.11, 0.1, 0.01)]
    band = [
        rod((0, 0.318, 0.62), (0, 0.324, 0.73), 0.115),
        rod((0, 0.33, 0.84), (0, 0.332, 0.88), 0.112, rim=0.008),
    ]
    mast = [
        rod((0, -0.02, 0.65), (0, 0.0, 1.1), 0.018),
        rod((-0.12, -0.01, 0.92), (0.12, -0.01, 0.92), 0.014),
        ball(0.03, (0, 0, 1.1)),
        rod((0, 0.62, 0.02), (0, 0.62, 0.2), 0.05, rim=0.01),
        rod((-0.12, 0.62, 0.16), (0.12, 0.62, 0.16), 0.03),
        *both_sides([ring(0.07, 0.022, (0.26, 0.26, 0.22), "x")]),
    ]
    return {
        "hull": hull,
        "keel": red,
        "fenders": black,
        "house": house,
        "windows": glass,
        "funnel": funnel,
        "bands": band,
        "mast": mast,
    }


def _cable_car(draw: Draw) -> Parts:
    slope = draw(0.04, 0.12)
    cabin = [
        box((0.86, 1.0, 0.3), (0, 0, 0.2), 0.1),
        box((0.8, 0.94, 0.1), (0, 0, 0.86), 0.04),
        *(
            box((0.06, 0.06, 0.6), (s * 0.37, t * 0.44, 0.58), 0.015)
            for s in (-1, 1)
            for t in (-1, 1)
        ),
        *(box((0.05, 0.05, 0.56), (s * 0.385, 0, 0.58), 0.01) for s in (-1, 1)),
    ]
    glass = [box((0.7, 0.86, 0.56), (0, 0, 0.58), 0.02)]
    stripe = [box((0.872, 1.012, 0.07), (0, 0, 0.26), 0.034)]
    roof = [box((0.92, 1.06, 0.05), (0, 0, 0.92), 0.02)]
    arm = [
        pipe([(0, 0, 0.92), (0, 0, 1.16), (0.22, 0, 1.36), (0.18, 0, 1.62), (0, 0, 1.72)], 0.04),
        rod((0, 0, 0.92), (0, 0, 1.0), 0.12, 0.08, 0.01),
        box((0.1, 0.44, 0.09), (0, 0, 1.74), 0.02),
        *(rod((-0.05, y, 1.8), (0.05, y, 1.8), 0.07, rim=0.008) for y in (-0.16, 0.0, 0.16)),
    ]
    rope = [rod((0, -1.3, 1.89 - slope), (0, 1.3, 1.89 + slope), 0.022)]
    step = [
        box((0.5, 0.14, 0.04), (0, -0.52, 0.16), 0.01),
        box((0.96, 0.06, 0.05), (0, 0.52, 0.1), 0.01),
    ]
    return {
        "cabin": cabin,
        "windows": glass,
        "stripe": stripe,
        "roof": roof,
        "hanger": [*arm, *step],
        "cable": rope,
    }


BOATS_AND_CABINS: dict[str, Callable[[Draw], Parts]] = {
    "hovercraft": _hovercraft,
    "tugboat": _tugboat,
    "cable car": _cable_car,
}
