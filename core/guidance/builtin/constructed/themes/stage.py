"""Things of the stage, and a magic gate."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import star
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _stage(draw: Draw) -> Parts:
    wide = draw(1.15, 1.3)
    floor = [
        box((2 * wide / 12 - 0.012, 1.3, 0.08), (-wide + 2 * wide * (k + 0.5) / 12, 0, 0.3), 0.006)
        for k in range(12)
    ] + [box((2 * wide - 0.04, 1.26, 0.28), (0, 0, 0.14), 0.006)]
    steps = [
        box((0.6, 0.18, 0.1 * (3 - k)), (0, -0.72 - 0.17 * k, 0.05 * (3 - k)), 0.006)
        for k in range(3)
    ]
    frame = [box((0.16, 0.2, 1.5), (s * wide, -0.5, 0.75), 0.012) for s in (-1, 1)] + [
        box((2 * wide + 0.3, 0.24, 0.2), (0, -0.5, 1.58), 0.015),
        box((2 * wide, 0.04, 1.5), (0, 0.62, 0.8), 0.006),
    ]
    frame += [
        ball((0.14, 0.07, 0.14), (0, -0.63, 1.6)),
        *both_sides(
            [ball(0.1, (wide, -0.5, 1.74)), box((0.24, 0.28, 0.12), (wide, -0.5, 0.06), 0.015)]
        ),
    ]
    red = []
    for s in (-1, 1):
        for k in range(7):
            x = s * (wide - 0.13 - 0.085 * k)
            red.append(
                capsule(
                    (x, -0.44 + 0.03 * (k % 2), 1.5),
                    (s * (wide - 0.12 - 0.05 * k), -0.42 + 0.03 * (k % 2), 0.42),
                    0.055,
                    0.066,
                )
            )
    red += [
        ball(
            (0.16, 0.07, 0.13 + 0.05 * (k % 2)),
            (-wide + 0.16 + (2 * wide - 0.32) * k / 10, -0.5, 1.45),
        )
        for k in range(11)
    ]
    back = [
        capsule((x, 0.56, 1.46), (x, 0.56, 0.36), 0.07)
        for x in np.linspace(-wide + 0.1, wide - 0.1, 17)
    ]
    gold = [
        ball(
            (0.075, 0.05, 0.035),
            (-wide + 0.16 + (2 * wide - 0.32) * k / 10, -0.53, 1.33 - 0.05 * (k % 2)),
        )
        for k in range(11)
    ] + both_sides([box((0.24, 0.05, 0.05), (wide - 0.24, -0.46, 0.86), 0.02)])
    lamps = [
        ball((0.05, 0.06, 0.04), (x, -0.66, 0.35))
        for x in np.linspace(-wide + 0.14, wide - 0.14, 9)
    ]
    return {
        "floor": [*floor, *steps],
        "frame": frame,
        "curtains": red,
        "backdrop": back,
        "fringe": gold,
        "footlights": lamps,
    }


def _podium(draw: Draw) -> Parts:
    first, second, third = 0.78, draw(0.5, 0.58), draw(0.34, 0.42)
    blocks = [
        box((0.62, 0.62, first), (0, 0, first / 2), 0.015),
        box((0.62, 0.6, second), (-0.61, 0, second / 2), 0.015),
        box((0.62, 0.6, third), (0.61, 0, third / 2), 0.015),
    ]
    tops = [
        box((0.66, 0.66, 0.05), (0, 0, first), 0.012),
        box((0.6, 0.64, 0.05), (-0.63, 0, second), 0.012),
        box((0.6, 0.64, 0.05), (0.63, 0, third), 0.012),
    ]
    digits = {
        1: [((0.3, 0), (0.3, 1)), ((0.3, 1), (0.08, 0.78)), ((0.08, 0), (0.52, 0))],
        2: [
            ((0, 0.75), (0.1, 0.95)),
            ((0.1, 0.95), (0.45, 0.95)),
            ((0.45, 0.95), (0.55, 0.7)),
            ((0.55, 0.7), (0, 0)),
            ((0, 0), (0.6, 0)),
        ],
        3: [
            ((0, 1), (0.55, 1)),
            ((0.55, 1), (0.25, 0.58)),
            ((0.25, 0.58), (0.55, 0.42)),
            ((0.55, 0.42), (0.5, 0.1)),
            ((0.5, 0.1), (0.25, 0)),
            ((0.25, 0), (0, 0.12)),
        ],
    }
    marks = []
    for number, x, high in ((1, 0.0, first), (2, -0.61, second), (3, 0.61, third)):
        size = 0.3 if number == 1 else 0.22
        z = 0.5 * high - size / 2
        marks += [
            capsule(
                (x + size * (a - 0.3), -0.31 if number == 1 else -0.3, z + size * b),
                (x + size * (c - 0.3), -0.31 if number == 1 else -0.3, z + size * d),
                0.026,
            )
            for (a, b), (c, d) in digits[number]
        ]
    base = [box((1.96, 0.8, 0.06), (0, 0, 0.0), 0.015)]
    return {"blocks": blocks, "tops": tops, "numbers": marks, "base": base}


def _lectern(draw: Draw) -> Parts:
    high = draw(1.0, 1.12)
    front = [
        (-0.32, 0),
        (0.32, 0),
        (0.26, 0.1),
        (0.26, high - 0.1),
        (0.38, high),
        (-0.38, high),
        (-0.26, high - 0.1),
        (-0.26, 0.1),
    ]
    wood = [plate(front, 0.36, (0, 0, 0), FRONT), box((0.78, 0.56, 0.08), (0, 0, 0.03), 0.015)]
    tilt = Rotation.from_euler("x", -18, degrees=True).as_matrix()
    desk = placed(
        [box((0.92, 0.6, 0.06), (0, 0, 0), 0.012), box((0.92, 0.05, 0.1), (0, 0.29, 0.04), 0.01)],
        tilt,
        (0, 0.02, high + 0.04),
    )
    panel = [box((0.36, 0.03, 0.5), (0, -0.185, 0.5), 0.01)]
    emblem = [
        rod((0, -0.19, 0.52), (0, -0.212, 0.52), 0.12),
        *(
            capsule((0, -0.205, 0.52), (0.1 * np.cos(a), -0.205, 0.52 + 0.1 * np.sin(a)), 0.0125)
            for a in np.arange(5) * 2 * np.pi / 5 + np.pi / 2
        ),
    ]
    paper = placed(
        [
            box((0.3, 0.42, 0.02), (-0.16, 0.0, 0.035), 0.0),
            box((0.3, 0.42, 0.02), (0.17, -0.01, 0.035), 0.0, (0, 0, 4)),
        ],
        tilt,
        (0, 0.02, high + 0.04),
    )
    mic = [
        pipe(
            [(0.3, -0.2, high + 0.08), (0.3, -0.24, high + 0.3), (0.22, -0.08, high + 0.42)], 0.014
        ),
        capsule((0.22, -0.08, high + 0.42), (0.2, 0.0, high + 0.45), 0.042),
    ]
    return {
        "body": [*wood, *desk],
        "panel": panel,
        "emblem": emblem,
        "papers": paper,
        "microphone": mic,
    }


def _metronome(draw: Draw) -> Parts:
    swing = draw(-24.0, 24.0)
    shell = [(-0.42, 0.06), (0.42, 0.06), (0.16, 1.24), (-0.16, 1.24)]
    case = [
        plate(shell, 0.3, (0, 0.12, 0), FRONT),
        *both_sides(
            [
                plate(
                    [(0.35, 0.06), (0.42, 0.06), (0.16, 1.24), (0.1, 1.24)],
                    0.24,
                    (0, -0.1, 0),
                    FRONT,
                )
            ]
        ),
    ]
    case += [
        box((0.8, 0.24, 0.3), (0, -0.1, 0.2), 0.006),
        box((0.24, 0.3, 0.06), (0, 0.06, 1.26), 0.012),
    ]
    base = [
        box((0.96, 0.66, 0.08), (0, 0.0, 0.03), 0.015),
        *(ball(0.05, (0.38 * s, 0.24 * t, -0.02)) for s in (-1, 1) for t in (-1, 1)),
    ]
    way = Rotation.from_euler("y", swing, degrees=True).as_matrix()
    arm = placed(
        [
            rod((0, 0, 0.0), (0, 0, 1.0), 0.015),
            plate(
                [(-0.06, 0.56), (0.06, 0.56), (0.085, 0.7), (-0.085, 0.7)], 0.06, (0, 0, 0), FRONT
            ),
        ],
        way,
        (0, -0.12, 0.3),
    )
    scale = [box((0.12, 0.02, 0.76), (0, -0.035, 0.76), 0.004)]
    marks = [box((0.05, 0.014, 0.014), (0, -0.046, 0.44 + 0.052 * k)) for k in range(13)]
    key = [
        rod((0.36, 0.1, 0.3), (0.5, 0.1, 0.3), 0.02),
        box((0.03, 0.05, 0.12), (0.5, 0.1, 0.3), 0.01),
        rod((0, -0.06, 0.3), (0, -0.15, 0.3), 0.03),
    ]
    return {"case": case, "base": base, "pendulum": [*arm, *key], "scale": scale, "marks": marks}


def _jack_in_the_box(draw: Draw) -> Parts:
    lean = draw(-0.1, 0.1)
    cube = (
        [box((0.9, 0.06, 0.8), (0, s * 0.42, 0.42), 0.015) for s in (-1, 1)]
        + both_sides([box((0.06, 0.9, 0.8), (0.42, 0, 0.42), 0.015)])
        + [box((0.9, 0.9, 0.08), (0, 0, 0.05), 0.015)]
    )
    lid = placed(
        [box((0.9, 0.06, 0.9), (0, 0, 0.45), 0.015)],
        Rotation.from_euler("x", -20, degrees=True).as_matrix(),
        (0, 0.44, 0.8),
    )
    trim = [
        box((0.07, 0.07, 0.86), (s * 0.43, t * 0.43, 0.42), 0.012) for s in (-1, 1) for t in (-1, 1)
    ]
    outline = star(5, 0.27, 0.12, (0.0, 0.42))
    stars = [
        plate(outline, 0.94, (0, 0, 0), FRONT),
        plate(outline, 0.94, (0, 0, 0), SIDE),
    ]
    t = np.linspace(0, 7 * 2 * np.pi, 85)
    spring = [
        pipe(
            np.stack(
                [lean * t / t[-1] + 0.2 * np.cos(t), 0.2 * np.sin(t), 0.1 + 0.98 * t / t[-1]], 1
            ),
            0.026,
        ),
        rod((lean, 0, 1.04), (lean, 0, 1.12), 0.23, rim=0.01),
    ]
    z = 1.36
    head = [ball((0.27, 0.26, 0.28), (lean, 0, z))]
    suit = [turned([(0, 0), (0.34, 0), (0.38, 0.04), (0.2, 0.12), (0, 0.14)], (lean, 0, 1.04))]
    suit += [
        ball((0.075, 0.075, 0.05), (lean + 0.33 * np.cos(a), 0.33 * np.sin(a), 1.07))
        for a in np.arange(12) * np.pi / 6
    ]
    arms = [
        capsule((lean + s * 0.16, 0, 1.12), (lean + s * 0.46, -0.06, 1.3), 0.055) for s in (-1, 1)
    ]
    hat = [
        rod((lean, 0, z + 0.16), (lean, 0, z + 0.62), 0.22, 0.02),
        ring(0.225, 0.04, (lean, 0, z + 0.18)),
    ]
    red = [
        ball(0.065, (lean, -0.26, z - 0.01)),
        ball(0.06, (lean, 0, z + 0.63)),
        pipe(
            [
                (lean - 0.13, -0.215, z - 0.1),
                (lean, -0.245, z - 0.155),
                (lean + 0.13, -0.215, z - 0.1),
            ],
            0.022,
        ),
        *(ball((0.1, 0.1, 0.11), (lean + s * 0.25, 0.02, z + 0.02)) for s in (-1, 1)),
    ]
    eyes = [ball((0.03, 0.02, 0.045), (lean + s * 0.1, -0.235, z + 0.075)) for s in (-1, 1)]
    crank = [
        rod((0.42, 0, 0.42), (0.62, 0, 0.42), 0.03),
        rod((0.6, 0, 0.42), (0.6, 0, 0.62), 0.025),
        rod((0.58, 0, 0.61), (0.78, 0, 0.61), 0.045, rim=0.01),
    ]
    return {
        "box": [*cube, *lid],
        "trim": [*trim, *crank],
        "stars": stars,
        "spring": spring,
        "face": [*head, *(ball(0.075, (lean + s * 0.48, -0.06, 1.31)) for s in (-1, 1))],
        "suit": [*suit, *arms, *hat],
        "nose": red,
        "eyes": eyes,
    }


def _portal(draw: Draw) -> Parts:
    count = 14 + 2 * draw.which(2)
    ringed = []
    for k in range(count):
        way = Rotation.from_euler("y", 360 * (k + 0.5) / count, degrees=True).as_matrix()
        ringed += placed(
            [
                plate(
                    [(-0.17, 0.8), (0.17, 0.8), (0.21, 1.04), (-0.21, 1.04)],
                    0.26 + 0.04 * (k % 2),
                    (0, 0, 0),
                    FRONT,
                )
            ],
            way,
        )
    glow = [
        ring(0.79, 0.035, (0, -0.04, 0), "y"),
        *placed(spun([ball((0.045, 0.03, 0.06), (0, -0.155, 0.92))], count // 2, "y"), np.eye(3)),
    ]
    swirl = [rod((0, -0.03, 0), (0, 0.024, 0), 0.87)]
    arms = []
    for k in range(5):
        t = np.linspace(0.1, 3.6, 14)
        r = 0.06 + 0.19 * t
        arms.append(
            pipe(
                [
                    (a * np.cos(b + 2 * np.pi * k / 5), -0.025, a * np.sin(b + 2 * np.pi * k / 5))
                    for a, b in zip(r, t, strict=True)
                ],
                tuple(np.linspace(0.05, 0.018, 14)),
            )
        )
    arms.append(ball((0.13, 0.06, 0.13), (0, -0.02, 0)))
    base = [
        box((1.5, 0.7, 0.12), (0, 0, -1.08), 0.02),
        box((1.1, 0.5, 0.14), (0, 0, -0.98), 0.02),
        box((0.9, 0.9, 0.08), (0, -0.1, -1.12), 0.02),
    ]
    return {"frame": [*ringed, *base], "surface": swirl, "swirl": arms, "glow": glow}


STAGE: dict[str, Callable[[Draw], Parts]] = {
    "theatre stage": _stage,
    "podium": _podium,
    "lectern": _lectern,
    "metronome": _metronome,
    "jackbox": _jack_in_the_box,
    "portal": _portal,
}
