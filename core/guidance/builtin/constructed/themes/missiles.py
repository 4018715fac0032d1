"""Missiles and a jet engine."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FRONT,
    SIDE,
    Parts,
    ball,
    box,
    curve,
    pipe,
    placed,
    plate,
    rod,
    rounded,
    spun,
    turned,
)


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


MISSILES: dict[str, Callable[[Draw], Parts]] = {
    "missile": _missile,
    "torpedo": _torpedo,
    "jet engine": _jet_engine,
}
