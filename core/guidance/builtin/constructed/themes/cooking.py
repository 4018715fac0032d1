"""Machines and dishes of the kitchen."""

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
    pipe,
    placed,
    plate,
    ring,
    rod,
    turned,
)


def _stand_mixer(draw: Draw) -> Parts:
    base = [
        box((0.6, 1.1, 0.12), (0, 0, 0.06), 0.06),
        box((0.36, 0.34, 0.72), (0, 0.34, 0.42), 0.1),
    ]
    arm = [
        capsule((0, 0.34, 0.9), (0, -0.38, 0.9), 0.2, 0.17),
        box((0.34, 0.5, 0.3), (0, 0.3, 0.82), 0.12),
    ]
    band = [
        turned([(0.15, -0.03), (0.192, -0.03), (0.192, 0.03), (0.15, 0.03)], (0, -0.22, 0.9), "y")
    ]
    band += [
        ball((0.1, 0.05, 0.1), (0, -0.54, 0.9)),
        rod((0, -0.34, 0.7), (0, -0.34, 0.78), 0.08, rim=0.01),
    ]
    knob = [
        rod((0.12, 0.1, 0.86), (0.23, 0.1, 0.86), 0.035, rim=0.01),
        rod((-0.25, 0.24, 0.86), (-0.19, 0.24, 0.86), 0.05, rim=0.01),
    ]
    deep = draw(0.34, 0.4)
    bowl = [
        (0, 0.11),
        (0.14, 0.11),
        (0.16, 0.15),
        (0.27, 0.26),
        (0.31, 0.12 + deep),
        (0.325, 0.14 + deep),
        (0.29, 0.14 + deep),
        (0.24, 0.27),
        (0, 0.2),
    ]
    bowls = [
        turned(bowl, (0, -0.3, 0)),
        pipe(
            [(0.29, -0.3, 0.44), (0.42, -0.3, 0.42), (0.42, -0.3, 0.28), (0.26, -0.3, 0.24)], 0.022
        ),
    ]
    whisk = [rod((0, -0.34, 0.56), (0, -0.34, 0.74), 0.03)]
    for k in range(4):
        a = np.pi * k / 4
        loop = [
            (
                0.1 * np.sin(t) * np.cos(a),
                -0.34 + 0.1 * np.sin(t) * np.sin(a),
                0.42 + 0.16 * np.cos(t),
            )
            for t in np.linspace(0.15, 2 * np.pi - 0.15, 13)
        ]
        whisk.append(pipe(loop, 0.011))
    return {"body": [*base, *arm], "bowl": bowls, "whisk": whisk, "band": band, "knobs": knob}


def _mortar_and_pestle(draw: Draw) -> Parts:
    lean = np.array([draw(0.5, 0.62), 0.1, 0.95])
    bowl = [
        (0, 0),
        (0.26, 0),
        (0.28, 0.05),
        (0.22, 0.12),
        (0.36, 0.22),
        (0.48, 0.42),
        (0.52, 0.62),
        (0.54, 0.66),
        (0.46, 0.66),
        (0.4, 0.42),
        (0.24, 0.26),
        (0, 0.22),
    ]
    pestle = [
        capsule((0.02, 0, 0.33), tuple(lean), 0.075, 0.05),
        ball((0.11, 0.11, 0.1), (0.0, 0, 0.32)),
        ball(0.07, tuple(lean)),
    ]
    herbs = [
        ball((0.27, 0.27, 0.06), (0, 0, 0.27)),
        *(
            ball(
                (0.07, 0.045, 0.03),
                (0.2 * np.cos(a), 0.2 * np.sin(a), 0.31),
                (0, 20, np.degrees(a)),
            )
            for a in np.arange(7) * 0.9
        ),
    ]
    return {
        "mortar": [turned(bowl), ring(0.235, 0.03, (0, 0, 0.115))],
        "pestle": pestle,
        "herbs": herbs,
    }


def _cake_stand(draw: Draw) -> Parts:
    high = draw(0.42, 0.52)
    stand = [
        (0, 0),
        (0.32, 0),
        (0.3, 0.05),
        (0.1, 0.12),
        (0.06, 0.22),
        (0.09, 0.3),
        (0.06, high - 0.06),
        (0.2, high),
        (0.66, high),
        (0.68, high + 0.05),
        (0.62, high + 0.03),
        (0, high + 0.03),
    ]
    scallops = [
        ball(0.045, (0.67 * np.cos(a), 0.67 * np.sin(a), high + 0.02))
        for a in np.arange(36) * 2 * np.pi / 36
    ]
    base = high + 0.02
    sponge = [rod((0, 0, base), (0, 0, base + 0.32), 0.5, 0.5, 0.03)]
    icing = [rod((0, 0, base + 0.28), (0, 0, base + 0.37), 0.515, 0.5, 0.03)]
    for k, a in enumerate(np.arange(20) * 2 * np.pi / 20):
        icing.append(
            capsule(
                (0.495 * np.cos(a), 0.495 * np.sin(a), base + 0.32),
                (0.505 * np.cos(a), 0.505 * np.sin(a), base + 0.3 - 0.06 * (1 + (k * 7) % 3)),
                0.055,
            )
        )
    icing += [ring(0.505, 0.03, (0, 0, base + 0.02))]
    berries = [
        ball((0.06, 0.06, 0.07), (0.36 * np.cos(a), 0.36 * np.sin(a), base + 0.41))
        for a in np.arange(8) * 2 * np.pi / 8
    ] + [ball((0.075, 0.075, 0.085), (0, 0, base + 0.42))]
    leaves = [
        ball((0.04, 0.02, 0.014), (0.36 * np.cos(a) + 0.03, 0.36 * np.sin(a), base + 0.475))
        for a in np.arange(8) * 2 * np.pi / 8
    ]
    return {
        "stand": [turned(stand), *scallops],
        "cake": sponge,
        "icing": icing,
        "berries": berries,
        "leaves": leaves,
    }


def _kitchen_scale(draw: Draw) -> Parts:
    at = draw(-0.9, 0.9)
    body = [
        plate(
            [(-0.42, 0), (0.42, 0), (0.36, 0.62), (0.24, 0.72), (-0.24, 0.72), (-0.36, 0.62)],
            0.52,
            (0, 0, 0),
            FRONT,
        ),
        box((0.96, 0.66, 0.08), (0, 0, 0.04), 0.03),
        rod((0, 0, 0.7), (0, 0, 0.82), 0.06),
    ]
    pan = [
        turned(
            [
                (0, 0.8),
                (0.2, 0.8),
                (0.42, 0.86),
                (0.56, 0.96),
                (0.58, 1.0),
                (0.53, 0.99),
                (0.4, 0.9),
                (0, 0.85),
            ]
        ),
        rod((0, 0, 0.78), (0, 0, 0.82), 0.16),
    ]
    face = [rod((0, -0.24, 0.38), (0, -0.285, 0.38), 0.25)]
    rim = [
        turned([(0.24, -0.03), (0.285, -0.03), (0.285, 0.03), (0.24, 0.03)], (0, -0.27, 0.38), "y")
    ]
    marks = [
        box(
            (0.018, 0.014, 0.05 if k % 3 else 0.08),
            (0.19 * np.sin(a), -0.286, 0.38 + 0.19 * np.cos(a)),
            0.002,
            (0, np.degrees(a), 0),
        )
        for k, a in enumerate(np.arange(12) * np.pi / 6)
    ]
    hand = [
        rod((0, -0.29, 0.38), (0.2 * np.sin(at), -0.29, 0.38 + 0.2 * np.cos(at)), 0.015),
        rod((0, -0.28, 0.38), (0, -0.305, 0.38), 0.035),
    ]
    return {"body": body, "pan": pan, "face": face, "rim": rim, "marks": marks, "pointer": hand}


def _waffle_maker(draw: Draw) -> Parts:
    angle = draw(55.0, 75.0)
    base = [
        rod((0, 0, 0.04), (0, 0, 0.2), 0.6, 0.56, 0.03),
        *(
            rod((0.42 * s, 0.42 * t, 0), (0.42 * s, 0.42 * t, 0.06), 0.06, rim=0.01)
            for s in (-1, 1)
            for t in (-1, 1)
        ),
        box((0.3, 0.2, 0.12), (0, 0.56, 0.16), 0.03),
    ]
    grid = [
        box((0.035, 0.035, 0.04), (x, y, 0.215), 0.006)
        for x in np.linspace(-0.42, 0.42, 9)
        for y in np.linspace(-0.42, 0.42, 9)
        if x * x + y * y < 0.2
    ]
    iron = [rod((0, 0, 0.18), (0, 0, 0.22), 0.5, rim=0.01)]
    way = Rotation.from_euler("x", -angle, degrees=True).as_matrix()
    hinge = (0, 0.6, 0.22)
    top = placed(
        [
            rod((0, -0.6, 0.02), (0, -0.6, 0.16), 0.58, 0.52, 0.03),
            box((0.2, 0.16, 0.1), (0, 0.0, 0.06), 0.03),
        ],
        way,
        hinge,
    )
    inner = placed([rod((0, -0.6, -0.01), (0, -0.6, 0.04), 0.5, rim=0.01)], way, hinge)
    handle = placed([box((0.26, 0.3, 0.07), (0, -1.26, 0.06), 0.03)], way, hinge) + [
        box((0.22, 0.16, 0.06), (0, -0.64, 0.14), 0.02)
    ]
    waffle = [
        rod((0, 0, 0.2), (0, 0, 0.265), 0.44, rim=0.02),
        *(
            box((0.84 * (1 - abs(x) ** 2 / 0.2) ** 0.5, 0.028, 0.03), (0, x, 0.272), 0.006)
            for x in np.linspace(-0.32, 0.32, 6)
        ),
        *(
            box((0.028, 0.84 * (1 - abs(x) ** 2 / 0.2) ** 0.5, 0.03), (x, 0, 0.272), 0.006)
            for x in np.linspace(-0.32, 0.32, 6)
        ),
    ]
    lamp = [ball(0.03, (0.16, -0.57, 0.13)), ball(0.03, (-0.16, -0.57, 0.13))]
    return {
        "body": [*base, *top],
        "plates": [*iron, *grid, *inner],
        "waffle": waffle,
        "handle": handle,
        "lamps": lamp,
    }


def _samovar(draw: Draw) -> Parts:
    wide = draw(0.36, 0.42)
    body = [
        (0, 0.06),
        (0.3, 0.06),
        (0.28, 0.12),
        (0.14, 0.2),
        (0.16, 0.28),
        (0.3, 0.4),
        (wide, 0.7),
        (wide + 0.02, 0.95),
        (wide - 0.04, 1.12),
        (0.24, 1.18),
        (0.26, 1.22),
        (0.14, 1.26),
        (0.12, 1.42),
        (0.2, 1.46),
        (0.2, 1.5),
        (0, 1.5),
    ]
    pot = [
        (0, 1.48),
        (0.14, 1.48),
        (0.21, 1.58),
        (0.2, 1.72),
        (0.12, 1.8),
        (0.05, 1.82),
        (0.04, 1.88),
        (0, 1.9),
    ]
    spout = [
        pipe([(0.16, 0, 1.58), (0.28, 0, 1.64), (0.33, 0, 1.78)], (0.05, 0.036, 0.026)),
        pipe([(-0.17, 0, 1.74), (-0.3, 0, 1.76), (-0.3, 0, 1.6), (-0.18, 0, 1.58)], 0.024),
    ]
    tap = [
        rod((0, -0.3, 0.5), (0, -0.58, 0.5), 0.035),
        rod((0, -0.54, 0.52), (0, -0.54, 0.4), 0.032),
        rod((0, -0.48, 0.5), (0, -0.48, 0.62), 0.022),
        box((0.15, 0.03, 0.05), (0, -0.48, 0.63), 0.014),
        rod((0, -0.32, 0.5), (0, -0.36, 0.5), 0.07, rim=0.01),
    ]
    handles = both_sides(
        [
            pipe(
                [
                    (wide, 0, 0.92),
                    (wide + 0.14, 0, 0.98),
                    (wide + 0.15, 0, 0.76),
                    (wide - 0.02, 0, 0.7),
                ],
                0.026,
            )
        ]
    )
    rings = [
        ring(r, 0.02, (0, 0, z))
        for r, z in ((wide + 0.015, 0.96), (0.25, 1.19), (0.165, 0.27), (0.3, 0.4))
    ]
    feet = [ball(0.06, (0.22 * s, 0.22 * t, 0.05)) for s in (-1, 1) for t in (-1, 1)]
    return {
        "body": [turned(body), *tap, *feet],
        "rings": rings,
        "handles": handles,
        "teapot": [turned(pot), *spout],
    }


def _french_press(draw: Draw) -> Parts:
    high, level = draw(0.86, 0.96), 0.52
    r = 0.3
    glass = [
        rod((0, 0, 0.05), (0, 0, high), r),
        plate([(r - 0.06, -0.07), (r + 0.08, 0.0), (r - 0.06, 0.07)], 0.07, (0, 0, high - 0.05)),
    ]
    coffee = [rod((0, 0, 0.04), (0, 0, level), r + 0.006)]
    frame = [
        rod((0, 0, 0.0), (0, 0, 0.07), r + 0.03, rim=0.01),
        ring(r + 0.015, 0.022, (0, 0, high - 0.16)),
        ring(r + 0.015, 0.022, (0, 0, 0.3)),
    ]
    frame += [
        box(
            (0.05, 0.02, high - 0.16),
            ((r + 0.02) * np.cos(a), (r + 0.02) * np.sin(a), (high - 0.16) / 2),
            0.006,
            (0, 0, np.degrees(a) + 90),
        )
        for a in (0.9, 2.2, 3.9, 5.4)
    ]
    lid = [
        turned(
            [
                (0, high - 0.02),
                (r + 0.02, high - 0.02),
                (r + 0.02, high + 0.04),
                (0.16, high + 0.14),
                (0, high + 0.15),
            ]
        )
    ]
    rodlet = [rod((0, 0, high + 0.1), (0, 0, high + 0.42), 0.018)]
    knob = [
        ball((0.065, 0.065, 0.06), (0, 0, high + 0.45)),
        pipe(
            [
                (-r, 0, high - 0.14),
                (-r - 0.22, 0, high - 0.1),
                (-r - 0.24, 0, 0.4),
                (-r - 0.01, 0, 0.3),
            ],
            0.04,
        ),
    ]
    return {"glass": glass, "coffee": coffee, "frame": [*frame, *lid, *rodlet], "handle": knob}


COOKING: dict[str, Callable[[Draw], Parts]] = {
    "stand mixer": _stand_mixer,
    "mortar and pestle": _mortar_and_pestle,
    "cake stand": _cake_stand,
    "kitchen scale": _kitchen_scale,
    "waffle maker": _waffle_maker,
    "samovar": _samovar,
    "french press": _french_press,
}
