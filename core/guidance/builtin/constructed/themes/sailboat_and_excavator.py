"""A sailboat and an excavator that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import track
from core.guidance.builtin.constructed.shapes import (
    SIDE,
    Parts,
    both_sides,
    box,
    closed_curve,
    plate,
    rod,
)


def _sailboat(draw: Draw) -> Parts:
    wide, high = draw(0.25, 0.29), draw(1.5, 1.7)

    def deck(w: float, bow: float, stern: float) -> np.ndarray:
        return closed_curve(
            [
                (0, -bow),
                (0.5 * w, -0.66 * bow),
                (w, -0.05),
                (0.94 * w, 0.6 * stern),
                (0.6 * w, stern),
                (-0.6 * w, stern),
                (-0.94 * w, 0.6 * stern),
                (-w, -0.05),
                (-0.5 * w, -0.66 * bow),
            ]
        )

    hull = [
        plate(
            deck(
                wide * (0.42 + 0.58 * ((k + 0.5) / 8) ** 0.6),
                0.6 + 0.18 * k / 8,
                0.6 + 0.05 * k / 8,
            ),
            0.042,
            (0, 0, -0.26 + 0.036 * k),
        )
        for k in range(8)
    ]
    hull += [
        plate([(-0.2, -0.24), (0.22, -0.24), (0.16, -0.6), (-0.08, -0.6)], 0.05, (0, 0, 0), SIDE),
        plate([(0.54, -0.2), (0.66, -0.2), (0.64, -0.5), (0.54, -0.5)], 0.03, (0, 0, 0), SIDE),
    ]
    stripe = [plate(deck(wide + 0.01, 0.79, 0.655), 0.035, (0, 0, 0.0))]
    planks = [
        plate(deck(wide - 0.015, 0.76, 0.63), 0.04, (0, 0, 0.035)),
        plate(deck(0.6 * wide, 0.42, 0.16), 0.1, (0, 0.0, 0.09)),
        box((0.26, 0.3, 0.08), (0, 0.36, 0.06), 0.02),
    ]
    mast = [
        rod((0, -0.12, 0.02), (0, -0.12, high), 0.024, 0.016),
        rod((0, -0.12, 0.26), (0, 0.58, 0.24), 0.018),
        *both_sides([rod((wide - 0.02, -0.1, 0.03), (0, -0.12, 0.8 * high), 0.0085)]),
        rod((0, -0.76, 0.03), (0, -0.12, 0.92 * high), 0.0085),
        rod((0, 0.6, 0.03), (0, -0.12, high - 0.02), 0.0085),
        rod((-0.1, -0.12, 0.6 * high), (0.1, -0.12, 0.6 * high), 0.012),
        rod((0, 0.5, 0.04), (0, 0.62, 0.16), 0.016),
    ]
    z = np.linspace(0, 1, 12)
    leech = [(0.56 * (1 - t) ** 0.85 - 0.1, 0.3 + t * (high - 0.4)) for t in z]
    main = [plate([(-0.1, 0.3), *leech], 0.026, (0, 0, 0), SIDE)]
    jib = [
        plate(
            [
                (-0.7, 0.12),
                *((-0.16, 0.14 + t * (0.8 * high - 0.14)) for t in np.linspace(0, 1, 5)),
            ],
            0.026,
            (0.012, 0, 0),
            SIDE,
        )
    ]
    battens = [
        rod(
            (0, -0.1, 0.3 + f * (high - 0.4)),
            (0, 0.5 * (1 - f) ** 0.85 - 0.1, 0.3 + f * (high - 0.4)),
            0.0135,
        )
        for f in (0.25, 0.5, 0.75)
    ]
    flag = [plate([(-0.12, 0), (0.12, -0.05), (-0.12, -0.11)], 0.022, (0, 0, high), SIDE)]
    return {
        "hull": hull,
        "deck": planks,
        "mast": [*mast, *battens],
        "sails": [*main, *jib],
        "stripe": stripe,
        "flag": flag,
    }


def _excavator(draw: Draw) -> Parts:
    loop = np.array(
        [
            (-0.5, 0.02),
            (0.5, 0.02),
            (0.66, 0.1),
            (0.7, 0.2),
            (0.64, 0.31),
            (0.5, 0.34),
            (-0.5, 0.34),
            (-0.64, 0.31),
            (-0.7, 0.2),
            (-0.66, 0.1),
        ]
    )
    middle = (0.0, 0.18)
    tracks = track(loop, (loop - middle) * (0.93, 0.78) + middle, 0.36, 0.2, (0.22, 0.05, 0.04))
    body = [
        box((0.56, 1.0, 0.14), (0, 0, 0.24), 0.02),
        rod((0, 0.04, 0.3), (0, 0.04, 0.42), 0.28, rim=0.01),
        *both_sides(
            [rod((0.26, y, 0.18), (0.45, y, 0.18), 0.13, rim=0.015) for y in (-0.48, 0.48)]
        ),
        *both_sides(
            [rod((0.26, y, 0.12), (0.45, y, 0.12), 0.08, rim=0.012) for y in (-0.24, 0.0, 0.24)]
        ),
    ]
    body += [
        box((0.84, 0.94, 0.1), (0, 0.16, 0.46), 0.02),
        plate(
            [(0.06, 0.5), (0.66, 0.5), (0.72, 0.62), (0.66, 0.86), (0.06, 0.84)],
            0.8,
            (0, 0, 0),
            SIDE,
        ),
        box((0.84, 0.16, 0.34), (0, 0.66, 0.64), 0.05),
    ]
    body += [
        plate(
            [(-0.32, 0.5), (0.12, 0.5), (0.12, 1.18), (-0.2, 1.18), (-0.34, 0.86)],
            0.05,
            (-0.24 + s * 0.165, 0, 0),
            SIDE,
            [np.array([(-0.25, 0.62), (0.05, 0.62), (0.05, 1.1), (-0.17, 1.1), (-0.27, 0.86)])],
        )
        for s in (-1, 1)
    ] + [
        box((0.4, 0.38, 0.05), (-0.24, -0.03, 1.19), 0.015),
        box((0.38, 0.05, 0.14), (-0.24, -0.31, 0.56), 0.01),
    ]
    glass = [
        plate(
            [(-0.29, 0.47), (0.06, 0.47), (0.06, 1.17), (-0.19, 1.17), (-0.31, 0.86)],
            0.335,
            (-0.24, 0, 0),
            SIDE,
        )
    ]

    body += [rod((0.2, 0.5, 0.84), (0.2, 0.5, 1.02), 0.035, rim=0.006)]
    reach = draw(-0.06, 0.08)
    knee, wrist = (0.1, -0.86 + reach, 1.36), (0.1, -1.26 + reach, 0.66)
    arm = [
        plate(
            [
                (-0.24, 0.5),
                (-0.12, 0.62),
                (-0.42, 1.3),
                (-0.7, 1.46),
                (knee[1] - 0.04, 1.4),
                (knee[1] - 0.02, 1.3),
                (-0.66, 1.32),
                (-0.5, 1.16),
            ],
            0.15,
            (0.1, 0, 0),
            SIDE,
        )
    ]
    arm += [
        plate(
            [
                (knee[1] + 0.16, 1.46),
                (knee[1] + 0.1, 1.28),
                (wrist[1] + 0.06, wrist[2]),
                (wrist[1] - 0.05, wrist[2] + 0.02),
                (knee[1] - 0.1, 1.34),
            ],
            0.12,
            (0.1, 0, 0),
            SIDE,
        ),
        rod((0.0, *knee[1:]), (0.2, *knee[1:]), 0.06, rim=0.01),
        box((0.24, 0.2, 0.2), (0.1, -0.2, 0.54), 0.02),
    ]
    steel = [
        rod((0.1, -0.3, 0.56), (0.1, -0.5, 1.1), 0.045),
        rod((0.1, -0.46, 1.0), (0.1, -0.56, 1.28), 0.026),
        rod((0.1, -0.56, 1.47), (0.1, -0.72, 1.53), 0.045),
        rod((0.1, -0.7, 1.52), (0.1, knee[1] + 0.14, 1.46), 0.026),
        rod((0.1, knee[1] - 0.1, 1.28), (0.1, wrist[1] - 0.06, 0.8), 0.032),
        rod((0.0, *wrist[1:]), (0.2, *wrist[1:]), 0.05, rim=0.01),
    ]
    w = np.array(wrist)
    scoop = [
        (w[1] + 0.06, w[2] + 0.05),
        (w[1] - 0.14, w[2] + 0.06),
        (w[1] - 0.2, w[2] - 0.12),
        (w[1] - 0.12, w[2] - 0.32),
        (w[1] + 0.1, w[2] - 0.36),
        (w[1] + 0.2, w[2] - 0.28),
        (w[1] + 0.06, w[2] - 0.26),
        (w[1] - 0.06, w[2] - 0.2),
        (w[1] - 0.1, w[2] - 0.08),
        (w[1] - 0.06, w[2] - 0.01),
    ]
    bucket = [
        plate(scoop, 0.38, (0.1, 0, 0), SIDE),
        *(
            plate(
                [
                    (w[1] - 0.15, w[2] + 0.05),
                    (w[1] - 0.2, w[2] - 0.12),
                    (w[1] - 0.12, w[2] - 0.32),
                    (w[1] + 0.1, w[2] - 0.36),
                    (w[1] + 0.17, w[2] - 0.3),
                    (w[1] + 0.05, w[2] + 0.03),
                ],
                0.03,
                (0.1 + s * 0.18, 0, 0),
                SIDE,
            )
            for s in (-1, 1)
        ),
        *(
            rod(
                (0.1 + x, w[1] + 0.14, w[2] - 0.325),
                (0.1 + x, w[1] + 0.28, w[2] - 0.25),
                0.026,
                0.012,
            )
            for x in (-0.15, -0.05, 0.05, 0.15)
        ),
    ]
    return {
        "body": body,
        "windows": glass,
        "arm": arm,
        "bucket": [*bucket, *steel],
        "tracks": both_sides(tracks),
    }


SAILBOAT_AND_EXCAVATOR: dict[str, Callable[[Draw], Parts]] = {
    "sailboat": _sailboat,
    "excavator": _excavator,
}
