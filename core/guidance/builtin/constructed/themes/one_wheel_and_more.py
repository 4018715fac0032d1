"""What is ridden: on one wheel, a high one, or two beside each other."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
)


def _tyre(radius: float, tube: float, spokes: int, at: tuple) -> tuple[list, list]:
    """A tyre with thin spokes, and its rim, about the x axis."""
    tyre = [ring(radius, tube, at, "x")]
    metal = moved(
        [
            ring(radius - tube, 0.5 * tube, (0, 0, 0), "x"),
            *spun([rod((0, 0, 0), (0, 0, radius - tube), 0.0115)], spokes, "x"),
            rod((-0.06, 0, 0), (0.06, 0, 0), 0.035),
        ],
        at,
    )
    return tyre, metal


def _unicycle(draw: Draw) -> Parts:
    r, high = 0.46, draw(1.3, 1.45)
    tyre, metal = _tyre(r, 0.05, 16, (0, 0, r + 0.05))
    fork = both_sides(
        [
            pipe(
                [
                    (0.1, 0, r + 0.05),
                    (0.1, 0, 2 * r + 0.06),
                    (0.06, 0, 2 * r + 0.18),
                    (0, 0, 2 * r + 0.2),
                ],
                0.03,
            )
        ]
    ) + [
        rod((0, 0, 2 * r + 0.16), (0, 0, high + 0.07), 0.034),
        rod((0, 0, 2 * r + 0.26), (0, 0, 2 * r + 0.34), 0.055, rim=0.01),
    ]
    seat = [
        plate(
            closed_curve(
                [
                    (-0.3, high + 0.12),
                    (-0.14, high + 0.04),
                    (0.1, high + 0.03),
                    (0.28, high + 0.14),
                    (0.24, high + 0.2),
                    (0.08, high + 0.1),
                    (-0.12, high + 0.11),
                    (-0.26, high + 0.19),
                ]
            ),
            0.17,
            (0, 0, 0),
            SIDE,
        )
    ]
    cranks = [
        rod((0.02, 0, r + 0.05), (0.14, 0, r + 0.05), 0.045),
        rod((0.14, 0, r + 0.05), (0.15, -0.02, r - 0.16), 0.026),
        rod((-0.06, 0, r + 0.05), (-0.14, 0, r + 0.05), 0.045),
        rod((-0.14, 0, r + 0.05), (-0.15, 0.02, r + 0.26), 0.026),
    ]
    pedals = [
        box((0.16, 0.13, 0.04), (0.23, -0.02, r - 0.16), 0.01),
        box((0.16, 0.13, 0.04), (-0.23, 0.02, r + 0.26), 0.01),
    ]
    return {
        "frame": fork,
        "tyre": tyre,
        "spokes": [*metal, *cranks],
        "saddle": seat,
        "pedals": pedals,
    }


def _penny_farthing(draw: Draw) -> Parts:
    big, small = draw(0.72, 0.8), 0.24
    tyre, metal = _tyre(big, 0.032, 28, (0, -0.2, big + 0.03))
    y = -0.2 + big + small + 0.12
    tyre2, metal2 = _tyre(small, 0.03, 12, (0, y, small + 0.03))
    top = 2 * big + 0.12
    spine = [
        pipe(
            [
                (0, -0.2, top),
                (0, 0.12, top - 0.06),
                (0, -0.2 + 0.86 * big, big + 0.42),
                (0, y - 0.26, 0.72),
                (0, y - 0.1, 0.5),
            ],
            (0.036, 0.036, 0.034, 0.03, 0.03),
        ),
        *both_sides(
            [
                rod((0.07, -0.2, big + 0.03), (0.06, -0.2, top), 0.026),
                pipe([(0, y - 0.12, 0.53), (0.06, y - 0.06, 0.44), (0.06, y, small + 0.03)], 0.022),
            ]
        ),
        rod((-0.07, -0.2, top - 0.02), (0.07, -0.2, top - 0.02), 0.03),
        rod((0, -0.2, top - 0.03), (0, -0.22, top + 0.18), 0.03),
    ]
    bar = [
        pipe(
            [
                (-0.42, -0.1, top - 0.02),
                (-0.34, -0.2, top + 0.12),
                (0, -0.23, top + 0.16),
                (0.34, -0.2, top + 0.12),
                (0.42, -0.1, top - 0.02),
            ],
            0.022,
        )
    ]
    saddle = [
        ball((0.11, 0.2, 0.05), (0, 0.14, top + 0.03)),
        rod((0, 0.14, top - 0.07), (0, 0.14, top + 0.02), 0.026),
    ]
    grips = both_sides([capsule((0.42, -0.1, top - 0.02), (0.43, -0.02, top - 0.08), 0.034)])
    cranks = [
        rod((-0.12, -0.2, big + 0.03), (0.12, -0.2, big + 0.03), 0.03),
        rod((0.11, -0.2, big + 0.03), (0.12, -0.24, big - 0.16), 0.022),
        rod((-0.11, -0.2, big + 0.03), (-0.12, -0.16, big + 0.22), 0.022),
        box((0.14, 0.09, 0.035), (0.18, -0.24, big - 0.16), 0.01),
        box((0.14, 0.09, 0.035), (-0.18, -0.16, big + 0.22), 0.01),
    ]
    return {
        "frame": [*spine, *bar],
        "tyres": [*tyre, *tyre2],
        "spokes": [*metal, *metal2, *cranks],
        "saddle": [*saddle, *grips],
    }


def _segway(draw: Draw) -> Parts:
    high = draw(1.15, 1.28)
    tyres, rims = [], []
    for s in (-1, 1):
        tyres.append(ring(0.25, 0.07, (s * 0.42, 0, 0.32), "x"))
        rims += moved(
            [
                rod((-0.03, 0, 0), (0.03, 0, 0), 0.2, rim=0.01),
                *spun([box((0.08, 0.05, 0.15), (0, 0, 0.1), 0.01)], 5, "x"),
                rod((-0.05, 0, 0), (0.05, 0, 0), 0.05),
            ],
            (s * 0.42, 0, 0.32),
        )
    deck = [
        box((0.66, 0.46, 0.1), (0, 0, 0.3), 0.03),
        *both_sides(
            [
                box((0.1, 0.5, 0.12), (0.33, 0, 0.37), 0.03),
                plate(
                    [(0.3 * np.cos(a), 0.3 * np.sin(a)) for a in np.linspace(0.3, np.pi - 0.3, 15)]
                    + [
                        (0.345 * np.cos(a), 0.345 * np.sin(a))
                        for a in np.linspace(np.pi - 0.3, 0.3, 15)
                    ],
                    0.19,
                    (0.42, 0, 0.34),
                    SIDE,
                ),
                box((0.18, 0.3, 0.06), (0.34, 0, 0.42), 0.02),
            ]
        ),
    ]
    mats = both_sides([box((0.2, 0.36, 0.03), (0.13, 0.0, 0.355), 0.008)])
    pole = [
        rod((0, -0.18, 0.3), (0, -0.3, high), 0.03),
        box((0.14, 0.1, 0.14), (0, -0.19, 0.38), 0.03),
    ]
    bar = [
        pipe(
            [
                (-0.34, -0.24, high + 0.02),
                (-0.1, -0.3, high),
                (0.1, -0.3, high),
                (0.34, -0.24, high + 0.02),
            ],
            0.024,
        ),
        box((0.13, 0.06, 0.1), (0, -0.31, high + 0.04), 0.02, (-20, 0, 0)),
    ]
    grips = both_sides([capsule((0.26, -0.262, high + 0.013), (0.4, -0.225, high + 0.026), 0.036)])
    lamp = [
        ball((0.06, 0.03, 0.04), (0, -0.245, 0.4)),
        box((0.09, 0.02, 0.06), (0, -0.275, high + 0.055), 0.004, (-20, 0, 0)),
    ]
    return {
        "body": deck,
        "tyres": tyres,
        "rims": rims,
        "mats": mats,
        "pole": [*pole, *bar],
        "grips": grips,
        "lamps": lamp,
    }


def _hoverboard(draw: Draw) -> Parts:
    twist = draw(-4.0, 4.0)
    body, mats, lamps = [], [], []
    for s in (-1, 1):
        way = Rotation.from_euler("x", s * twist, degrees=True).as_matrix()
        body += placed(
            [
                plate(
                    [
                        (0.0, -0.1),
                        (s * 0.1, -0.13),
                        (s * 0.52, -0.22),
                        (s * 0.56, -0.2),
                        (s * 0.56, 0.2),
                        (s * 0.52, 0.22),
                        (s * 0.1, 0.13),
                        (0, 0.1),
                    ],
                    0.11,
                    (0, 0, 0.2),
                ),
                plate(
                    [(s * 0.1, -0.1), (s * 0.5, -0.18), (s * 0.5, 0.18), (s * 0.1, 0.1)],
                    0.15,
                    (0, 0, 0.2),
                ),
                plate(
                    [(0.23 * np.cos(a), 0.02 + 0.23 * np.sin(a)) for a in np.linspace(0, np.pi, 17)]
                    + [
                        (0.19 * np.cos(a), 0.02 + 0.19 * np.sin(a))
                        for a in np.linspace(np.pi, 0, 17)
                    ],
                    0.2,
                    (s * 0.64, 0, 0.17),
                    SIDE,
                ),
            ],
            way,
        )
        mats += placed(
            [
                plate(
                    [(s * 0.15, -0.09), (s * 0.47, -0.155), (s * 0.47, 0.155), (s * 0.15, 0.09)],
                    0.03,
                    (0, 0, 0.278),
                )
            ]
            + [box((0.26, 0.014, 0.014), (s * 0.31, y, 0.295)) for y in (-0.06, -0.02, 0.02, 0.06)],
            way,
        )
        lamps += placed(
            [
                box((0.2, 0.03, 0.035), (s * 0.3, -0.165, 0.2), 0.01, (0, 0, -s * 13)),
                box((0.06, 0.06, 0.014), (s * 0.1, 0, 0.262), 0.004),
            ],
            way,
        )
    tyres = both_sides([rod((0.57, 0, 0.17), (0.71, 0, 0.17), 0.18, rim=0.04)])
    hubs = both_sides(
        [
            rod((0.68, 0, 0.17), (0.725, 0, 0.17), 0.11, rim=0.01),
            *(box((0.03, 0.03, 0.17), (0.72, 0, 0.17), 0.004, (a, 0, 0)) for a in (0, 60, 120)),
            rod((0.5, 0, 0.17), (0.6, 0, 0.17), 0.05),
        ]
    )
    joint = [rod((-0.06, 0, 0.2), (0.06, 0, 0.2), 0.095, rim=0.01)]
    return {"body": body, "mats": mats, "tyres": tyres, "hubs": [*hubs, *joint], "lamps": lamps}


ONE_WHEEL_AND_MORE: dict[str, Callable[[Draw], Parts]] = {
    "unicycle": _unicycle,
    "penny farthing": _penny_farthing,
    "segway": _segway,
    "hoverboard": _hoverboard,
}
