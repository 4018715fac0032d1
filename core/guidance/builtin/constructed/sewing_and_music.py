"""Instruments, and things of sewing, of ninjas and of a gymnasium."""

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
        rod((0.3, front - 0.06, -0.3), (0.41, front - 0.1, -0.22), 0.014),
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
    bell = turned([(0, 0.2), *flare, (0.43, 1.05), (0.2, 0.86), (0.1, 0.62), (0, 0.5)], (0.1, 0, 0))
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
            turned([(0, -0.04), *flare, (0.37, 0.58), (0.14, 0.44), (0.05, 0.24), (0, 0.2)]),
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
    return {"steel": steel, "beater": beater, "cord": cord}


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


def _spool_of_thread(draw: Draw) -> Parts:
    ends = [
        turned([(0, z), (0.34, z), (0.4, z + 0.04), (0.4, z + 0.1), (0.3, z + 0.14), (0, z + 0.14)])
        if z < 0.4
        else turned(
            [(0, z), (0.3, z), (0.4, z + 0.04), (0.4, z + 0.1), (0.34, z + 0.14), (0, z + 0.14)]
        )
        for z in (0.0, 0.82)
    ]
    hole = [rod((0, 0, 0.945), (0, 0, 0.966), 0.1)]
    count = 17
    thread = [
        ring(
            0.3 + 0.035 * np.sin(np.pi * k / (count - 1)),
            0.035,
            (0, 0, 0.17 + 0.62 * k / (count - 1)),
        )
        for k in range(count)
    ] + [rod((0, 0, 0.1), (0, 0, 0.86), 0.31)]
    tail = draw(0.5, 0.7)
    thread += [
        pipe(
            [
                (0.3, -0.12, 0.3),
                (0.42, -0.3, 0.16),
                (tail, -0.5, 0.022),
                (0.4 + tail, -0.44, 0.022),
                (0.6 + tail, -0.56, 0.022),
            ],
            0.02,
        )
    ]
    needle = [
        rod((0.12, -0.36, 0.12), (-0.12, -0.32, 0.98), 0.017, 0.014),
        rod((0.12, -0.36, 0.12), (0.15, -0.365, 0.0), 0.017, 0.004),
        ring(0.03, 0.012, (-0.128, -0.318, 1.0), "y"),
    ]
    return {"spool": ends, "thread": thread, "hole": hole, "needle": needle}


def _ball_of_yarn(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    yarn = [ball(0.58)]
    for k in range(9):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        u = np.cross(axis, (0.3, 0.5, 0.8))
        u /= np.linalg.norm(u)
        v = np.cross(axis, u)
        for j in range(-2, 3):
            off, r = 0.075 * j, np.sqrt(0.59**2 - (0.075 * j) ** 2)
            t = np.linspace(0, 2 * np.pi, 25)[:-1]
            yarn.append(
                pipe(
                    off * axis + r * (np.cos(t)[:, None] * u + np.sin(t)[:, None] * v),
                    0.036 + 0.001 * k,
                    closed=True,
                )
            )
    yarn += [
        pipe(
            [
                (0.45, -0.3, -0.4),
                (0.66, -0.4, -0.56),
                (0.95, -0.3, -0.59),
                (1.15, -0.5, -0.59),
                (1.4, -0.36, -0.59),
            ],
            0.04,
        )
    ]
    needles = [
        rod((-0.86, -0.2, 0.72), (0.6, 0.1, -0.2), 0.03),
        rod((0.86, -0.2, 0.76), (-0.6, 0.1, -0.16), 0.03),
    ]
    knobs = [ball(0.07, (-0.88, -0.205, 0.735)), ball(0.07, (0.88, -0.205, 0.775))]
    return {"yarn": yarn, "needles": needles, "knobs": knobs}


def _thimble(draw: Draw) -> Parts:
    high = draw(0.8, 0.9)
    body = [
        turned(
            [
                (0, 0.06),
                (0.4, 0),
                (0.44, 0.0),
                (0.44, 0.08),
                (0.41, 0.12),
                (0.34, high - 0.12),
                (0.28, high - 0.02),
                (0.16, high + 0.03),
                (0, high + 0.04),
            ]
        ),
        ring(0.425, 0.03, (0, 0, 0.04)),
    ]
    dots = []
    for j in range(7):
        z = 0.3 + (high - 0.42) * j / 6
        r = 0.41 - 0.07 * (z - 0.12) / (high - 0.24)
        dots += [
            ball(0.026, (r * np.cos(a), r * np.sin(a), z))
            for a in (np.arange(22) + 0.5 * (j % 2)) * 2 * np.pi / 22
        ]
    band = [turned([(0.38, 0.16), (0.418, 0.16), (0.412, 0.22), (0.38, 0.22)])]
    return {"body": body, "dots": dots, "band": band}


def _sewing_needle(draw: Draw) -> Parts:
    long = draw(1.5, 1.7)
    steel = [
        rod((0, 0, 0.1), (0, 0, long), 0.036, 0.034),
        rod((0, 0, 0.11), (0, 0, -0.14), 0.036, 0.004),
        plate(
            closed_curve(
                [
                    (-0.05, long - 0.02),
                    (-0.055, long + 0.14),
                    (0, long + 0.2),
                    (0.055, long + 0.14),
                    (0.05, long - 0.02),
                ]
            ),
            0.06,
            (0, 0, 0),
            FRONT,
            [
                closed_curve(
                    [
                        (-0.02, long + 0.03),
                        (-0.022, long + 0.11),
                        (0, long + 0.14),
                        (0.022, long + 0.11),
                        (0.02, long + 0.03),
                    ]
                )
            ],
        ),
    ]
    z = long + 0.08
    thread = [
        pipe(
            [
                (0.02, 0.1, z - 0.3),
                (0.0, 0.07, z - 0.1),
                (0, 0, z),
                (0.02, -0.08, z - 0.12),
                (0.16, -0.1, z - 0.44),
                (0.32, -0.06, z - 0.72),
                (0.2, 0, z - 1.0),
                (0.34, 0.02, z - 1.3),
            ],
            0.02,
        )
    ]
    return {"needle": steel, "thread": thread}


def _ribbon(draw: Draw) -> Parts:
    droop = draw(-0.08, 0.04)
    bow = []
    for s in (-1, 1):
        loop = [
            (s * 0.06, 0.02),
            (s * 0.4, 0.3),
            (s * 0.72, 0.28 + droop),
            (s * 0.78, 0.02 + droop),
            (s * 0.6, -0.2 + droop),
            (s * 0.3, -0.12),
        ]
        bow.append(
            plate(
                _band(closed_curve(loop), 0.05),
                0.34,
                (0, 0, 0),
                FRONT,
                [_inner(closed_curve(loop), 0.05)],
            )
        )
    tails = []
    for s in (-1, 1):
        way = np.array([(s * 0.02, 0.0), (s * 0.16, -0.3), (s * 0.3, -0.56), (s * 0.5, -0.86)])
        line = curve(way)
        tails.append(
            plate([*(line + (0.045, 0)), *(line - (0.045, 0))[::-1]], 0.32, (0, 0, 0), FRONT)
        )
    knot = [box((0.22, 0.4, 0.24), (0, 0, 0.02), 0.09)]
    return {"loops": bow, "tails": tails, "knot": knot}


def _band(loop: np.ndarray, thick: float) -> np.ndarray:
    """The outer outline of a strap laid along a loop."""
    return loop + 0.5 * thick * _outwards(loop)


def _inner(loop: np.ndarray, thick: float) -> np.ndarray:
    """The inner outline of it."""
    return loop - 0.5 * thick * _outwards(loop)


def _outwards(loop: np.ndarray) -> np.ndarray:
    along = np.roll(loop, -1, 0) - np.roll(loop, 1, 0)
    way = np.stack([along[:, 1], -along[:, 0]], 1)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    x, y = loop.T
    return way if x @ np.roll(y, -1) - y @ np.roll(x, -1) > 0 else -way


def _knot(draw: Draw) -> Parts:
    t = np.linspace(0, 2 * np.pi, 61)[:-1]
    spread = draw(0.95, 1.05)
    way = (
        np.stack(
            [
                spread * (np.sin(t) + 2 * np.sin(2 * t)),
                0.9 * -np.sin(3 * t),
                np.cos(t) - 2 * np.cos(2 * t),
            ],
            1,
        )
        * 0.28
    )
    thin = [pipe(way, 0.155, closed=True)]
    strands = []
    frames = np.gradient(np.concatenate([way, way, way]), axis=0)[60:120]
    frames /= np.linalg.norm(frames, axis=1, keepdims=True)
    u = np.cross(frames, (0.0, 1.0, 0.0))
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    v = np.cross(frames, u)
    for k in range(3):
        a = 9 * t + 2 * np.pi * k / 3
        strands.append(
            pipe(
                way + 0.118 * (np.cos(a)[:, None] * u + np.sin(a)[:, None] * v), 0.062, closed=True
            )
        )
    return {"core": thin, "strands": strands}


def _rosary(draw: Draw) -> Parts:
    count = 35 + 5 * draw.which(3)
    beads, large, chain = [], [], []
    t = np.linspace(-np.pi / 2 + 0.16, 1.5 * np.pi - 0.16, count)
    loop = np.stack([0.56 * np.cos(t), 0 * t, 0.2 + 0.62 * np.sin(t)], 1)
    for k, at in enumerate(loop):
        (large if k % 7 == 3 else beads).append(ball(0.046 if k % 7 == 3 else 0.034, tuple(at)))
    centre = (0, 0, -0.5)
    chain.append(pipe([centre, *loop, centre], 0.013))
    chain.append(rod(centre, (0, 0, -0.86), 0.013))
    large += [ball((0.07, 0.04, 0.08), centre)]
    beads += [ball(0.034, (0, 0, z)) for z in (-0.62, -0.7, -0.78)]
    cross = [
        box((0.07, 0.05, 0.4), (0, 0, -1.04), 0.014),
        box((0.26, 0.05, 0.07), (0, 0, -0.98), 0.014),
    ]
    return {"beads": beads, "large beads": large, "chain": chain, "cross": cross}


SEWING_AND_MUSIC: dict[str, Callable[[Draw], Parts]] = {
    "cello": _cello,
    "tuba": _tuba,
    "french horn": _french_horn,
    "tambourine": _tambourine,
    "musical triangle": _triangle,
    "tuning fork": _tuning_fork,
    "castanets": _castanets,
    "bongos": _bongos,
    "spool of thread": _spool_of_thread,
    "ball of yarn": _ball_of_yarn,
    "thimble": _thimble,
    "sewing needle": _sewing_needle,
    "ribbon": _ribbon,
    "knot": _knot,
    "rosary": _rosary,
}
