"""Instruments."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    turned,
)


def _cello(draw: Draw) -> Parts:
    half = [
        (0.2, -0.5),
        (0.31, -0.36),
        (0.28, -0.16),
        (0.17, -0.04),
        (0.185, 0.1),
        (0.25, 0.22),
        (0.23, 0.38),
        (0.1, 0.48),
    ]
    outline = closed_curve([(0, -0.54), *half, (0, 0.49), *((-x, z) for x, z in half[::-1])])
    deep = draw(0.19, 0.24)
    front = -deep / 2
    body = [
        plate(0.94 * outline, deep, (0, 0, 0), FRONT),
        *(plate(outline, 0.03, (0, y, 0), FRONT) for y in (front + 0.012, deep / 2 - 0.012)),
    ]
    neck = [
        box((0.085, 0.06, 0.56), (0, front - 0.01, 0.72), 0.022),
        box((0.075, 0.025, 0.74), (0, front - 0.05, 0.6), 0.006),
        box((0.075, 0.07, 0.2), (0, front, 1.06), 0.016),
        pipe(
            [
                (0, front, 1.14),
                (0, front + 0.02, 1.24),
                (0, front - 0.05, 1.27),
                (0, front - 0.07, 1.2),
            ],
            (0.036, 0.036, 0.03, 0.022),
        ),
    ]
    strings = [
        rod((x, front - 0.11, -0.14), (0.6 * x, front - 0.07, 1.0), 0.0075)
        for x in (-0.045, -0.015, 0.015, 0.045)
    ] + [
        rod((x, front - 0.11, -0.14), (0.8 * x, front - 0.06, -0.32), 0.0075)
        for x in (-0.045, -0.015, 0.015, 0.045)
    ]
    bridge = [box((0.13, 0.12, 0.022), (0, front - 0.05, -0.14), 0.006)]
    tail = [
        plate(
            closed_curve([(-0.05, -0.3), (0.05, -0.3), (0.034, -0.5), (-0.034, -0.5)]),
            0.022,
            (0, front - 0.05, 0),
            FRONT,
        ),
        rod((0, front - 0.05, -0.48), (0, front + 0.03, -0.53), 0.016),
    ]
    pegs = [
        capsule((0, front, z), (0.11 * s, front, z), 0.014, 0.022)
        for z, s in ((1.0, 1), (1.04, -1), (1.08, 1), (1.12, -1))
    ]
    spike = [
        rod((0, 0, -0.52), (0, 0, -0.95), 0.016, 0.012),
        rod((0, 0, -0.56), (0, 0, -0.5), 0.04, rim=0.01),
    ]
    holes = [
        pipe(
            [
                (s * 0.13, front - 0.002, 0.02),
                (s * 0.115, front - 0.002, -0.02),
                (s * 0.145, front - 0.002, -0.16),
                (s * 0.13, front - 0.002, -0.22),
            ],
            (0.02, 0.013, 0.013, 0.022),
        )
        for s in (-1, 1)
    ]
    stick = [
        rod((0.36, front - 0.1, -0.72), (0.5, front - 0.1, 0.72), 0.014),
        rod((0.39, front - 0.1, -0.7), (0.52, front - 0.1, 0.64), 0.009),
        box((0.06, 0.04, 0.09), (0.375, front - 0.1, -0.66), 0.01, (0, 6, 0)),
        rod((0.2, front + 0.03, -0.32), (0.41, front - 0.1, -0.22), 0.016),
    ]
    return {
        "body": body,
        "neck": [*neck, *tail],
        "strings": [*strings, *bridge],
        "pegs": pegs,
        "sound holes": holes,
        "spike": spike,
        "bow": stick,
    }


def _tuba(draw: Draw) -> Parts:
    flare = curve([(0.12, 0.2), (0.15, 0.55), (0.22, 0.82), (0.34, 0.98), (0.46, 1.04)])
    bell = turned(
        [(0, 0.2), *flare, (0.43, 1.06), (0.3, 1.0), (0.17, 0.84), (0.1, 0.6), (0, 0.5)],
        (0.1, 0, 0),
    )
    main = [
        pipe(
            [
                (0.1, 0, 0.24),
                (0.1, 0, -0.2),
                (0.02, 0, -0.52),
                (-0.2, 0, -0.6),
                (-0.42, 0, -0.5),
                (-0.48, 0, -0.2),
                (-0.48, 0, 0.3),
                (-0.42, 0, 0.5),
                (-0.28, 0, 0.54),
                (-0.2, 0, 0.42),
                (-0.2, 0, -0.1),
            ],
            (0.125, 0.13, 0.14, 0.14, 0.13, 0.11, 0.085, 0.075, 0.065, 0.055, 0.045),
        )
    ]
    main += [
        pipe(
            [
                (-0.2, -0.02, -0.06),
                (-0.1, -0.08, -0.14),
                (0.04, -0.1, -0.1),
                (0.06, -0.12, 0.3),
                (-0.1, -0.14, 0.4),
                (-0.3, -0.2, 0.42),
                (-0.46, -0.26, 0.46),
            ],
            0.034,
        )
    ]
    main += [
        ring(0.455, 0.022, (0.1, 0, 1.04)),
        *(rod((0.02, 0, z), (-0.46, 0, z), 0.02) for z in (0.1, -0.3)),
    ]
    valves = [
        rod((-0.32 + 0.12 * k, -0.12, -0.18), (-0.32 + 0.12 * k, -0.12, 0.22), 0.05, rim=0.008)
        for k in range(3 + draw.which(2))
    ]
    valves += [rod((x.center[0], -0.12, 0.2), (x.center[0], -0.12, 0.3), 0.016) for x in valves] + [
        rod((-0.36, -0.12, 0.0), (0.08, -0.08, 0.0), 0.022)
    ]
    caps = [
        rod((-0.32 + 0.12 * k, -0.12, 0.29), (-0.32 + 0.12 * k, -0.12, 0.32), 0.04, rim=0.008)
        for k in range((len(valves) - 1) // 2)
    ]
    mouth = [
        rod((-0.44, -0.25, 0.455), (-0.56, -0.3, 0.48), 0.026, 0.05),
        rod((-0.55, -0.296, 0.478), (-0.6, -0.315, 0.488), 0.062, 0.07, 0.01),
    ]
    return {"body": [bell, *main], "valves": valves, "buttons": caps, "mouthpiece": mouth}


def _french_horn(draw: Draw) -> Parts:
    turn = np.linspace(0.4, 2 * np.pi * 1.9, 30)
    coil = [(0.4 * np.cos(-a), 0.02 - 0.012 * a, 0.4 * np.sin(-a)) for a in turn]
    body = [pipe(coil, tuple(np.linspace(0.03, 0.046, 30)))]
    r = np.linspace(0.32, 0.3, 18)
    inner = [
        (b * np.cos(-a), -0.06, b * np.sin(-a))
        for a, b in zip(np.linspace(0, 2 * np.pi, 18), r, strict=True)
    ]
    body += [pipe(inner, 0.026)]
    way = np.array([0.55, -0.35, -0.76])
    way /= np.linalg.norm(way)
    x = np.cross(way, (0, 1.0, 0))
    x /= np.linalg.norm(x)
    frame = np.stack([x, np.cross(way, x), way], 1)
    start = np.array([0.22, -0.08, -0.3])
    flare = curve([(0.05, 0.0), (0.075, 0.22), (0.15, 0.42), (0.3, 0.54), (0.4, 0.57)])
    body += placed(
        [
            turned(
                [
                    (0, -0.04),
                    *flare,
                    (0.38, 0.59),
                    (0.28, 0.57),
                    (0.13, 0.46),
                    (0.05, 0.28),
                    (0, 0.2),
                ]
            ),
            ring(0.39, 0.02, (0, 0, 0.575)),
        ],
        frame,
        start,
    )
    body += [
        capsule((-0.39, -0.04, 0.0), (0.38, -0.05, 0.05), 0.02),
        capsule((-0.1, -0.06, -0.37), (0.05, -0.08, 0.34), 0.02),
    ]
    valves = [
        rod(
            (-0.06 + 0.14 * k, -0.16, 0.05 - 0.06 * k),
            (-0.06 + 0.14 * k, 0.08, 0.05 - 0.06 * k),
            0.06,
            rim=0.008,
        )
        for k in range(3)
    ] + [
        capsule(
            (-0.06 + 0.14 * k, -0.16, 0.05 - 0.06 * k),
            (-0.28 + 0.1 * k, -0.17, 0.22 - 0.02 * k),
            0.014,
        )
        for k in range(3)
    ]
    valves += [rod((-0.12, -0.03, 0.08), (0.3, -0.03, -0.1), 0.02)]
    keys = [
        rod(
            (-0.28 + 0.1 * k, -0.2, 0.22 - 0.02 * k),
            (-0.28 + 0.1 * k, -0.16, 0.22 - 0.02 * k),
            0.045,
            rim=0.008,
        )
        for k in range(3)
    ]
    lead = draw(0.0, 0.06)
    pipework = [
        pipe(
            [
                (0.36, -0.02, 0.16),
                (0.2, -0.1, 0.5),
                (-0.2, -0.16, 0.56 + lead),
                (-0.56, -0.2, 0.5 + lead),
            ],
            (0.03, 0.026, 0.022, 0.02),
        )
    ]
    mouth = [
        rod((-0.54, -0.2, 0.5 + lead), (-0.66, -0.214, 0.48 + lead), 0.022, 0.04),
        rod((-0.65, -0.213, 0.482 + lead), (-0.69, -0.218, 0.475 + lead), 0.05, 0.056, 0.008),
    ]
    return {"body": [*body, *pipework], "valves": valves, "keys": keys, "mouthpiece": mouth}


def _tambourine(draw: Draw) -> Parts:
    count = 5 + draw.which(2)
    gaps = np.arange(count) * 2 * np.pi / count + 0.3
    frame = [
        turned([(0.56, -0.12), (0.62, -0.12), (0.62, -0.06), (0.56, -0.06)], axis="y"),
        turned([(0.56, 0.06), (0.62, 0.06), (0.62, 0.12), (0.56, 0.12)], axis="y"),
    ]
    for k in range(count):
        for a in np.linspace(gaps[k] + 0.18, gaps[k] + 2 * np.pi / count - 0.18, 6):
            frame.append(
                box(
                    (0.2, 0.2, 0.06),
                    (0.59 * np.cos(a), 0, 0.59 * np.sin(a)),
                    0.004,
                    (0, 90 - np.degrees(a), 0),
                )
            )
    skin = [rod((0, -0.13, 0), (0, -0.1, 0), 0.605, rim=0.006)]
    jingles = []
    for a in gaps:
        at = np.array([0.59 * np.cos(a), 0, 0.59 * np.sin(a)])
        jingles += [
            rod((at[0], -0.035 + y, at[2]), (at[0], -0.012 + y, at[2]), 0.11, rim=0.004)
            for y in (0.0, 0.045)
        ]
        jingles.append(rod((at[0], -0.09, at[2]), (at[0], 0.09, at[2]), 0.016))
    tacks = [
        rod(
            (0.585 * np.cos(a), -0.1, 0.585 * np.sin(a)),
            (0.625 * np.cos(a), -0.1, 0.625 * np.sin(a)),
            0.018,
        )
        for a in np.arange(24) * np.pi / 12
    ]
    return {"frame": frame, "skin": skin, "jingles": jingles, "tacks": tacks}


def _triangle(draw: Draw) -> Parts:
    side = draw(0.62, 0.68)
    way = [
        (0.16, -0.42),
        (side - 0.06, -0.44),
        (side, -0.38),
        (side - 0.03, -0.28),
        (0.06, 0.62),
        (0, 0.68),
        (-0.06, 0.62),
        (-side + 0.03, -0.28),
        (-side, -0.38),
        (-side + 0.06, -0.44),
        (-0.06, -0.42),
    ]
    steel = [pipe([(x, 0, z) for x, z in way], 0.034)]
    cord = [
        pipe(
            [(0.05, 0, 0.6), (0.07, 0, 0.78), (0, 0, 0.98), (-0.07, 0, 0.78), (-0.05, 0, 0.6)],
            0.016,
        )
    ]
    beater = [
        rod((0.1, -0.05, -0.7), (0.5, -0.06, 0.06), 0.024),
        rod((0.1, -0.05, -0.7), (-0.02, -0.048, -0.93), 0.04, rim=0.01),
    ]
    return {"bar": steel, "beater": beater, "cord": cord}


def _tuning_fork(draw: Draw) -> Parts:
    gap = draw(0.14, 0.18)
    fork = both_sides(
        [
            pipe(
                [(0, 0, -0.16), (0.08, 0, -0.14), (gap, 0, -0.02), (gap, 0, 0.14), (gap, 0, 1.1)],
                0.055,
            )
        ]
    )
    stem = [rod((0, 0, -0.16), (0, 0, -0.72), 0.05), ball(0.085, (0, 0, -0.75))]
    stand = [
        box((0.7, 0.46, 0.28), (0, 0, -0.94), 0.02),
        box((0.76, 0.52, 0.05), (0, 0, -1.09), 0.012),
    ]
    return {"fork": [*fork, *stem], "box": stand}


def _castanets(draw: Draw) -> Parts:
    open_by = draw(10.0, 20.0)
    wood, cord = [], []
    for x, turn in ((-0.42, -10.0), (0.44, 14.0)):
        for s in (-1, 1):
            shell = [
                ball((0.34, 0.13, 0.38), (0, s * 0.07, -0.3)),
                box((0.14, 0.09, 0.14), (0.1, s * 0.06, 0.06), 0.03),
                box((0.14, 0.09, 0.14), (-0.1, s * 0.06, 0.06), 0.03),
                box((0.3, 0.1, 0.12), (0, s * 0.06, -0.02), 0.03),
            ]
            way = (
                Rotation.from_euler("y", turn, degrees=True).as_matrix()
                @ Rotation.from_euler("x", s * open_by / 2, degrees=True).as_matrix()
            )
            wood += placed(shell, way, (x, 0, 0))
        cord += placed(
            [
                rod((-0.12, 0, 0.08), (0.12, 0, 0.08), 0.03),
                pipe(
                    [
                        (-0.1, 0, 0.08),
                        (-0.15, 0, 0.26),
                        (0, 0, 0.36),
                        (0.15, 0, 0.26),
                        (0.1, 0, 0.08),
                    ],
                    0.024,
                ),
                rod((0, -0.1, 0.06), (0, 0.1, 0.06), 0.035),
            ],
            Rotation.from_euler("y", turn, degrees=True).as_matrix(),
            (x, 0, 0),
        )
    cord += [pipe([(-0.36, 0, 0.34), (-0.1, 0, 0.2), (0.12, 0, 0.22), (0.36, 0, 0.34)], 0.022)]
    return {"wood": wood, "cord": cord}


def _bongos(draw: Draw) -> Parts:
    high = draw(0.52, 0.6)
    shells, skins, hoops, rods = [], [], [], []
    for x, r in ((-0.37, 0.34), (0.36, 0.28)):
        shells += [
            rod((x, 0, 0), (x, 0, high), 0.82 * r, r),
            rod((x, 0, -0.01), (x, 0, 0.05), 0.84 * r, rim=0.01),
        ]
        skins.append(rod((x, 0, high - 0.01), (x, 0, high + 0.035), 0.985 * r, rim=0.012))
        hoops += [ring(r + 0.012, 0.026, (x, 0, high - 0.01)), ring(0.84 * r, 0.022, (x, 0, 0.06))]
        for a in np.arange(5) * 2 * np.pi / 5 + 0.5:
            rods.append(
                rod(
                    (x + 0.9 * r * np.cos(a), 0.9 * r * np.sin(a), 0.06),
                    (x + (r + 0.03) * np.cos(a), (r + 0.03) * np.sin(a), high),
                    0.016,
                )
            )
            rods.append(ball(0.032, (x + 0.9 * r * np.cos(a), 0.9 * r * np.sin(a), 0.05)))
    block = [box((0.24, 0.2, 0.3), (0.02, 0, 0.5 * high), 0.02)]
    return {"shells": [*shells, *block], "skins": skins, "hoops": hoops, "rods": rods}


MUSIC: dict[str, Callable[[Draw], Parts]] = {
    "cello": _cello,
    "tuba": _tuba,
    "french horn": _french_horn,
    "tambourine": _tambourine,
    "musical triangle": _triangle,
    "tuning fork": _tuning_fork,
    "castanets": _castanets,
    "bongos": _bongos,
}
