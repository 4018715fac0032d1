"""Odd vehicles, spacecraft and old crafts."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FLAT,
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    curve,
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
        rod((0, 0, 2 * r + 0.16), (0, 0, high), 0.034),
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
        rod((0.06, 0, r + 0.05), (0.14, 0, r + 0.05), 0.045),
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
        "metal": [*metal, *cranks],
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


def _hovercraft(draw: Draw) -> Parts:
    long = draw(0.95, 1.1)
    outline = rounded((1.16, 2 * long), 0.4)
    skirt = [
        plate(g * outline, 0.075, (0, 0, z))
        for g, z in ((1.0, 0.04), (1.05, 0.1), (1.06, 0.16), (1.03, 0.22))
    ] + [ball((0.085, 0.085, 0.11), (1.03 * x, 1.03 * y, 0.11)) for x, y in outline[::2]]
    edge = np.concatenate([outline, outline[:1]])
    for a, b in zip(edge[:-1], edge[1:], strict=True):
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


def _space_capsule(draw: Draw) -> Parts:
    cone = [
        turned(
            [
                (0, 0.16),
                (0.72, 0.16),
                (0.74, 0.2),
                (0.72, 0.25),
                (0.3, 0.98),
                (0.28, 1.02),
                (0, 1.02),
            ]
        ),
        rod((0, 0, 1.0), (0, 0, 1.14), 0.24, 0.22, 0.01),
    ]
    shield = [
        turned([(0, -0.02), *curve([(0.3, 0.0), (0.56, 0.06), (0.72, 0.16)]), (0.7, 0.2), (0, 0.2)])
    ]
    probe = [
        rod((0, 0, 1.12), (0, 0, 1.3), 0.1, 0.07, 0.01),
        rod((0, 0, 1.28), (0, 0, 1.46), 0.03),
        ball(0.05, (0, 0, 1.46)),
    ]
    lean = np.degrees(np.arctan2(0.42, 0.73))
    windows, frames, seams = [], [], []
    for a in (-28, 28, 180 - 28, 180 + 28):
        way = Rotation.from_euler("z", a, degrees=True).as_matrix()
        tilt = Rotation.from_euler("x", -lean, degrees=True).as_matrix()
        windows += placed(
            placed(
                [plate(rounded((0.16, 0.16), 0.04), 0.06, (0, 0, 0), FRONT)],
                tilt,
                (0, -0.475, 0.68),
            ),
            way,
        )
        frames += placed(
            placed(
                [plate(rounded((0.22, 0.22), 0.06), 0.04, (0, 0.005, 0), FRONT)],
                tilt,
                (0, -0.475, 0.68),
            ),
            way,
        )
    hatch = placed(
        [
            plate(rounded((0.3, 0.34), 0.08), 0.04, (0, 0, 0), FRONT),
            plate(rounded((0.22, 0.26), 0.06), 0.06, (0, 0, 0), FRONT),
        ],
        Rotation.from_euler("x", -lean, degrees=True).as_matrix(),
        (0, -0.57, 0.5),
    )
    hatch += placed(
        [box((0.14, 0.05, 0.03), (0, -0.03, -0.04), 0.008)],
        Rotation.from_euler("x", -lean, degrees=True).as_matrix(),
        (0, -0.57, 0.5),
    )
    seams += [ring(0.725 - 0.42 * (z - 0.25) / 0.73, 0.013, (0, 0, z)) for z in (0.36, 0.9)]
    jets = spun(
        moved(
            both_sides([rod((0.05, -0.02, 0), (0.05, -0.1, 0.0), 0.022, 0.035)]), (0, -0.68, 0.3)
        ),
        4,
    )
    count = 12 + 2 * draw.which(3)
    bolts = spun([ball(0.02, (0, -0.735, 0.2))], count)
    return {
        "hull": cone,
        "heat shield": shield,
        "docking probe": [*probe, *bolts],
        "windows": windows,
        "frames": [*frames, *seams],
        "hatch": hatch,
        "thrusters": jets,
    }


def _lunar_lander(draw: Draw) -> Parts:
    octagon = np.stack(
        [
            np.cos(np.arange(8) * np.pi / 4 + np.pi / 8),
            np.sin(np.arange(8) * np.pi / 4 + np.pi / 8),
        ],
        1,
    )
    gold = [
        plate(0.56 * octagon, 0.34, (0, 0, 0.5)),
        plate(0.5 * octagon, 0.06, (0, 0, 0.7)),
        *spun([box((0.26, 0.03, 0.24), (0, -0.525, 0.5), 0.004)], 8),
    ]
    white = [
        plate(0.34 * octagon, 0.3, (0, 0, 0.88)),
        rod((0, -0.42, 0.92), (0, 0.3, 0.92), 0.3, rim=0.03),
        box((0.44, 0.3, 0.3), (0, 0.24, 0.92), 0.03),
        ball((0.18, 0.2, 0.18), (0.36, 0.04, 0.9)),
        ball((0.18, 0.2, 0.18), (-0.36, 0.04, 0.9)),
        rod((0, 0, 1.16), (0, 0, 1.3), 0.16, 0.13, 0.01),
    ]
    glass = [
        plate([(-0.2, 0), (-0.04, -0.02), (-0.06, -0.14)], 0.04, (0, -0.415, 1.05), FRONT),
        plate([(0.2, 0), (0.04, -0.02), (0.06, -0.14)], 0.04, (0, -0.415, 1.05), FRONT),
    ]
    hatch = [
        plate(rounded((0.2, 0.2), 0.03), 0.04, (0, -0.42, 0.8), FRONT),
        box((0.24, 0.16, 0.03), (0, -0.5, 0.7), 0.006),
    ]
    legs, pads = [], []
    spread = draw(0.95, 1.05)
    for k in range(4):
        a = k * np.pi / 2 - np.pi / 2
        way = np.array([np.cos(a), np.sin(a)])
        side = np.array([-way[1], way[0]])
        foot = (*(spread * way), 0.03)
        legs += [
            rod((*(0.5 * way), 0.66), foot, 0.034, 0.03),
            *(
                rod((*(0.48 * way + s * 0.2 * side), 0.38), (*(0.8 * way), 0.25), 0.02)
                for s in (-1, 1)
            ),
            *(
                rod((*(0.5 * way + s * 0.18 * side), 0.62), (*(0.7 * way), 0.4), 0.018)
                for s in (-1, 1)
            ),
        ]
        pads.append(
            turned(
                [(0, -0.03), (0.1, -0.03), (0.15, 0.02), (0.12, 0.03), (0, 0.02)],
                (*(spread * way), 0.0),
            )
        )
    ladder = [rod((x, -0.58, 0.66), (x, -spread + 0.06, 0.12), 0.013) for x in (-0.07, 0.07)] + [
        rod(
            (-0.08, -0.58 - (spread - 0.64) * f, 0.66 - 0.54 * f),
            (0.08, -0.58 - (spread - 0.64) * f, 0.66 - 0.54 * f),
            0.0125,
        )
        for f in np.linspace(0.05, 0.95, 7)
    ]
    ladder += [rod((0, -0.55 - 0.1, 0.6), (-0.08, -0.62, 0.62), 0.0125)]
    engine = [
        turned(
            [(0, 0.36), (0.1, 0.36), (0.13, 0.24), (0.22, 0.1), (0.2, 0.1), (0.1, 0.24), (0, 0.28)]
        )
    ]
    thrusters = both_sides(
        [
            rod((0.44, y, 0.94), (0.44, y + 0.1 * np.sign(y), 0.94), 0.025, 0.04)
            for y in (-0.14, 0.2)
        ]
        + [rod((0.36, 0.04, 1.0), (0.46, 0.04, 0.94), 0.05)]
    )
    thrusters += [
        rod((0.1, 0.1, 1.26), (0.22, 0.12, 1.44), 0.014),
        ball((0.11, 0.04, 0.11), (0.23, 0.12, 1.46), (20, 0, 30)),
    ]
    return {
        "descent stage": gold,
        "ascent stage": white,
        "windows": glass,
        "hatch": hatch,
        "legs": [*legs, *ladder],
        "pads": pads,
        "engine": [*engine, *thrusters],
    }


def _missile(draw: Draw) -> Parts:
    long = draw(0.95, 1.1)
    body = [rod((0, 0, -long), (0, 0, long), 0.12)]
    nose = [
        turned(
            [
                (0, long - 0.01),
                *curve(
                    [
                        (0.122, long - 0.01),
                        (0.105, long + 0.16),
                        (0.05, long + 0.32),
                        (0.01, long + 0.4),
                    ]
                ),
                (0, long + 0.41),
            ]
        )
    ]
    fins = spun(
        [
            plate(
                [
                    (0.1, -long + 0.02),
                    (0.42, -long - 0.06),
                    (0.42, -long + 0.12),
                    (0.1, -long + 0.5),
                ],
                0.028,
                (0, 0, 0),
                FRONT,
            ),
            plate([(0.1, 0.36), (0.28, 0.36), (0.28, 0.44), (0.1, 0.62)], 0.026, (0, 0, 0), FRONT),
        ],
        4,
    )
    nozzle = [
        turned(
            [
                (0, -long + 0.02),
                (0.09, -long + 0.02),
                (0.085, -long - 0.04),
                (0.115, -long - 0.14),
                (0.095, -long - 0.14),
                (0.06, -long - 0.04),
                (0, -long - 0.03),
            ]
        )
    ]
    bands = [
        rod((0, 0, z), (0, 0, z + w), 0.125, rim=0.003)
        for z, w in ((long - 0.16, 0.07), (0.12, 0.05), (-0.2, 0.05))
    ]
    hatch = [plate(rounded((0.1, 0.34), 0.02), 0.03, (0, -0.115, -0.5), FRONT)]
    return {"body": body, "nose": nose, "fins": fins, "nozzle": [*nozzle, *hatch], "bands": bands}


def _torpedo(draw: Draw) -> Parts:
    long = draw(0.9, 1.05)
    body = placed(
        [
            turned(
                [
                    (0, -long + 0.34),
                    (0.17, -long + 0.34),
                    (0.17, long - 0.3),
                    *curve([(0.17, long - 0.3), (0.14, long), (0.08, long + 0.2)]),
                    (0, long + 0.2),
                ]
            )
        ],
        BACKWARD,
    )
    nose = placed(
        [
            turned(
                [
                    (0, -long - 0.02),
                    *curve(
                        [
                            (0.03, -long - 0.01),
                            (0.12, -long + 0.06),
                            (0.166, -long + 0.2),
                            (0.171, -long + 0.36),
                        ]
                    ),
                    (0, -long + 0.36),
                ]
            )
        ],
        BACKWARD,
    )
    fins = placed(
        spun(
            [
                plate(
                    [
                        (0.1, long - 0.14),
                        (0.26, long - 0.02),
                        (0.26, long + 0.12),
                        (0.07, long + 0.18),
                    ],
                    0.03,
                    (0, 0, 0),
                    FRONT,
                )
            ],
            4,
        ),
        BACKWARD,
    )
    screw = placed([rod((0, 0, long + 0.16), (0, 0, long + 0.34), 0.06, 0.03)], BACKWARD)
    blades = [
        ball(
            (0.06, 0.02, 0.11),
            (0.1 * np.sin(a), long + 0.26, 0.1 * np.cos(a)),
            (0, np.degrees(a), 0),
        )
        for a in np.arange(4) * np.pi / 2
    ]
    bands = placed(
        [rod((0, 0, z), (0, 0, z + 0.04), 0.176, rim=0.004) for z in (-0.4, 0.1, 0.5)], BACKWARD
    )
    guard = placed(
        [
            turned(
                [(0.25, long + 0.03), (0.28, long + 0.03), (0.28, long + 0.12), (0.25, long + 0.12)]
            )
        ],
        BACKWARD,
    )
    return {
        "body": body,
        "nose": nose,
        "fins": [*fins, *guard],
        "propeller": [*screw, *blades],
        "bands": bands,
    }


def _jet_engine(draw: Draw) -> Parts:
    blades = 18 + 2 * draw.which(3)
    cowl = placed(
        [
            turned(
                [
                    (0.5, -0.6),
                    (0.56, -0.66),
                    (0.62, -0.58),
                    (0.66, -0.2),
                    (0.64, 0.24),
                    (0.56, 0.5),
                    (0.52, 0.5),
                    (0.54, 0.2),
                    (0.53, -0.3),
                ]
            )
        ],
        BACKWARD,
    )
    fan = [rod((0, -0.3, 0), (0, 0.1, 0), 0.16)]
    fan += [
        box(
            (0.11, 0.022, 0.42),
            (0.34 * np.sin(a), -0.26, 0.34 * np.cos(a)),
            0.004,
            (0, np.degrees(a), 0),
        )
        for a in np.arange(blades) * 2 * np.pi / blades
    ]
    spinner = placed(
        [turned([(0, -0.56), *curve([(0.01, -0.555), (0.1, -0.44), (0.17, -0.29)]), (0, -0.28)])],
        BACKWARD,
    )
    spiral = [
        pipe(
            [
                (0.17 * f * np.cos(9 * f), -0.55 + 0.26 * f**1.5 - 0.008, 0.17 * f * np.sin(9 * f))
                for f in np.linspace(0.14, 0.96, 18)
            ],
            0.016,
        )
    ]
    core = placed(
        [
            turned(
                [
                    (0, -0.2),
                    (0.42, -0.1),
                    (0.46, 0.1),
                    (0.4, 0.6),
                    (0.3, 0.86),
                    (0.26, 0.86),
                    (0.3, 0.5),
                    (0, 0.5),
                ]
            ),
            turned([(0, 0.5), (0.2, 0.5), (0.12, 0.9), (0.02, 1.12), (0, 1.12)]),
        ],
        BACKWARD,
    )
    struts = spun([box((0.04, 0.16, 0.56), (0, 0.0, 0.3), 0.006)], 6, "y")
    pipes = [
        pipe(
            [
                (0.46 * np.cos(a), 0.12, 0.46 * np.sin(a)),
                (0.47 * np.cos(a + 0.2), 0.4, 0.47 * np.sin(a + 0.2)),
                (0.4 * np.cos(a + 0.1), 0.6, 0.4 * np.sin(a + 0.1)),
            ],
            0.022,
        )
        for a in np.arange(7) * 0.9
    ]
    pylon = [plate([(-0.2, 0.6), (0.5, 0.52), (0.62, 0.84), (-0.04, 0.84)], 0.14, (0, 0, 0), SIDE)]
    return {
        "cowling": [*cowl, *pylon],
        "fan": fan,
        "spinner": spinner,
        "spiral": spiral,
        "core": [*core, *struts],
        "pipes": pipes,
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
        box((0.5, 0.1, 0.04), (0, -0.53, 0.06), 0.01),
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


ODD_VEHICLES: dict[str, Callable[[Draw], Parts]] = {
    "unicycle": _unicycle,
    "penny farthing": _penny_farthing,
    "segway": _segway,
    "hoverboard": _hoverboard,
    "hovercraft": _hovercraft,
    "tugboat": _tugboat,
    "space capsule": _space_capsule,
    "lunar lander": _lunar_lander,
    "missile": _missile,
    "torpedo": _torpedo,
    "jet engine": _jet_engine,
    "cable car": _cable_car,
}
