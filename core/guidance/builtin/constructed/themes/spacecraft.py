"""Spacecraft, missiles and a jet engine."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
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
        "spinner mark": spiral,
        "core": [*core, *struts],
        "pipes": pipes,
    }


SPACECRAFT: dict[str, Callable[[Draw], Parts]] = {
    "space capsule": _space_capsule,
    "lunar lander": _lunar_lander,
    "missile": _missile,
    "torpedo": _torpedo,
    "jet engine": _jet_engine,
}
