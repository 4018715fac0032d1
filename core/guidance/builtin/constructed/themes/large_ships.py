"""Ships and an excavator that the networks know and drew roughly."""

import itertools
from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    placed,
    plate,
    rod,
)


def _hull(wide: float, bow: float, stern: float) -> np.ndarray:
    """A ship's outline from above, its bow towards -y."""
    half = [
        (0.0, -bow),
        (0.5 * wide, -0.8 * bow),
        (0.9 * wide, -0.5 * bow),
        (wide, -0.15 * bow),
        (wide, 0.75 * stern),
        (0.86 * wide, stern),
    ]
    return np.array([*half, *((-x, y) for x, y in half[:0:-1])])


def _cargo_ship(draw: Draw) -> Parts:
    wide = 0.26
    hull = [
        plate(
            _hull(wide * (0.86 + 0.14 * k / 4), 1.32 + 0.04 * k, 1.22),
            0.056,
            (0, 0, -0.02 + 0.05 * k),
        )
        for k in range(5)
    ]
    hull += [
        plate(
            _hull(wide + 0.012, 1.5, 1.24), 0.09, (0, 0, 0.24), FLAT, [_hull(wide - 0.02, 1.4, 1.2)]
        ),
        plate(_hull(wide, 1.47, 1.23), 0.03, (0, 0, 0.21)),
    ]
    front = _hull(wide + 0.008, 1.5, 1.2)
    hull += [
        plate(front[front[:, 1] < -0.85], 0.12, (0, 0, 0.27)),
        ball((0.09, 0.16, 0.07), (0, -1.32, -0.14)),
    ]
    keel = [
        plate(
            _hull(wide * (0.6 + 0.24 * k / 3), 1.22 + 0.04 * k, 1.16),
            0.062,
            (0, 0, -0.2 + 0.055 * k),
        )
        for k in range(4)
    ]
    orange, green = [], []
    rng = np.random.default_rng(draw.which(1000))
    for j in range(9):
        y = -0.8 + 0.18 * j
        for i in range(4):
            x = -0.165 + 0.11 * i
            for level in range(int(rng.integers(2, 5))):
                (orange if rng.uniform() < 0.55 else green).append(
                    box((0.104, 0.17, 0.108), (x, y, 0.27 + 0.102 * level), 0.004)
                )
    white = [
        box((0.46, 0.26, 0.56), (0, 0.98, 0.48), 0.008),
        box((0.62, 0.18, 0.1), (0, 0.94, 0.8), 0.01),
        box((0.4, 0.2, 0.06), (0, 0.97, 0.87), 0.01),
        box((0.16, 0.16, 0.3), (0, 1.1, 0.74), 0.015),
        rod((0, 0.92, 0.86), (0, 0.92, 1.1), 0.016),
        rod((-0.1, 0.92, 1.02), (0.1, 0.92, 1.02), 0.014),
    ]
    white += [
        rod((0, -1.28, 0.28), (0, -1.28, 0.62), 0.016),
        *(
            box((0.5, 0.03, 0.34), (0, y, 0.38), 0.004)
            for y in (-0.71 + 0.36 * k for k in range(4))
        ),
    ]
    glass = [
        box((0.56, 0.02, 0.05), (0, 0.85, 0.81), 0.004),
        *(
            box((0.05, 0.02, 0.05), (x, 0.849, z), 0.004)
            for x in (-0.16, -0.05, 0.06, 0.17)
            for z in (0.6, 0.7)
        ),
        *both_sides(
            [
                box((0.02, 0.04, 0.05), (0.229, y, z), 0.004)
                for y in (0.92, 1.04)
                for z in (0.5, 0.6, 0.7)
            ]
        ),
    ]
    return {
        "hull": hull,
        "keel": keel,
        "containers": orange,
        "boxes": green,
        "bridge": white,
        "windows": glass,
    }


def _cruise_ship(draw: Draw) -> Parts:
    wide, floors = 0.27, 4 + draw.which(2)
    hull = [
        plate(
            _hull(wide * (0.82 + 0.18 * k / 4), 1.3 + 0.05 * k, 1.16 + 0.02 * k),
            0.056,
            (0, 0, -0.02 + 0.05 * k),
        )
        for k in range(7)
    ]
    keel = [
        plate(
            _hull(wide * (0.58 + 0.24 * k / 3), 1.2 + 0.04 * k, 1.12),
            0.062,
            (0, 0, -0.2 + 0.055 * k),
        )
        for k in range(4)
    ]
    decks, glass = [], []
    for k in range(floors):
        z, w, bow, stern = 0.3 + 0.1 * k, wide - 0.012 - 0.014 * k, 1.12 - 0.11 * k, 1.12 - 0.09 * k
        outline = _hull(w, bow, stern)
        decks += [
            plate(outline, 0.104, (0, 0, z + 0.04)),
            plate(outline * (1.05, 1.015), 0.024, (0, 0, z + 0.092)),
        ]
        for y in np.arange(-0.13 * bow, 0.72 * stern, 0.1):
            glass += both_sides([box((0.02, 0.06, 0.045), (w, y, z + 0.04), 0.004)])
    top = 0.3 + 0.1 * floors
    decks += [
        box((0.3, 0.2, 0.1), (0, -0.62, top + 0.03), 0.02),
        rod((0, -0.3, top), (0, -0.3, top + 0.3), 0.016),
        ball((0.05, 0.05, 0.05), (0, -0.46, top + 0.03)),
        box((0.26, 0.5, 0.03), (0, -0.02, top + 0.01), 0.01),
    ]
    glass += [
        box((0.26, 0.02, 0.05), (0, -0.722, top + 0.04), 0.006),
        box((0.14, 0.3, 0.02), (0, -0.02, top + 0.022), 0.006),
    ]
    lean = Rotation.from_euler("x", -8, degrees=True).as_matrix()
    funnel = placed(
        [
            plate(
                0.1
                * closed_curve(
                    [
                        (0, -1.9),
                        (0.9, -1.2),
                        (1.0, 0),
                        (0.9, 1.2),
                        (0, 1.9),
                        (-0.9, 1.2),
                        (-1.0, 0),
                        (-0.9, -1.2),
                    ]
                ),
                0.4,
                (0, 0, 0.18),
            )
        ],
        lean,
        (0, 0.48, top),
    )
    rim = placed(
        [
            plate(
                0.106
                * closed_curve(
                    [
                        (0, -1.9),
                        (0.9, -1.2),
                        (1.0, 0),
                        (0.9, 1.2),
                        (0, 1.9),
                        (-0.9, 1.2),
                        (-1.0, 0),
                        (-0.9, -1.2),
                    ]
                ),
                0.08,
                (0, 0, 0.37),
            )
        ],
        lean,
        (0, 0.48, top),
    )
    boats = both_sides(
        [
            capsule((wide + 0.012, y - 0.05, 0.35), (wide + 0.012, y + 0.05, 0.35), 0.042)
            for y in np.arange(-0.4, 0.75, 0.17)
        ]
    )
    return {
        "hull": hull,
        "keel": keel,
        "decks": decks,
        "windows": glass,
        "funnel": funnel,
        "rim": rim,
        "lifeboats": boats,
    }


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
    middle = np.array([0.0, 0.18])
    tracks = [plate(loop, 0.2, (0.36, 0, 0), SIDE, [(loop - middle) * (0.93, 0.78) + middle])]
    ends = [*loop, loop[0]]
    for a, b in itertools.pairwise(ends):
        steps = max(int(np.linalg.norm(b - a) / 0.085), 1)
        turn = np.degrees(np.arctan2(*(b - a)[::-1]))
        for f in (np.arange(steps) + 0.5) / steps:
            tracks.append(box((0.22, 0.05, 0.04), (0.36, *(a + f * (b - a))), 0.006, (turn, 0, 0)))
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


LARGE_SHIPS: dict[str, Callable[[Draw], Parts]] = {
    "cargo ship": _cargo_ship,
    "cruise ship": _cruise_ship,
    "sailboat": _sailboat,
    "excavator": _excavator,
}
