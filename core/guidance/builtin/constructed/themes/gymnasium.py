"""Things of a gymnasium and a games hall."""

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
    pipe,
    placed,
    plate,
    ring,
    rod,
)


def _punching_bag(draw: Draw) -> Parts:
    long = draw(0.95, 1.1)
    bag = [
        rod((0, 0, -long), (0, 0, 0.0), 0.3, rim=0.08),
        *(ring(0.298, 0.014, (0, 0, z)) for z in (-0.34, -0.7)),
    ]
    bands = [
        rod((0, 0, -0.16), (0, 0, -0.06), 0.306, rim=0.01),
        rod((0, 0, -long + 0.1), (0, 0, -long + 0.2), 0.306, rim=0.01),
    ]
    chains = []
    for a in np.arange(4) * np.pi / 2 + np.pi / 4:
        start, end = np.array([0.27 * np.cos(a), 0.27 * np.sin(a), -0.04]), np.array([0, 0, 0.56])
        chains += [
            ball((0.03, 0.03, 0.045), tuple(start + f * (end - start)))
            for f in np.linspace(0.02, 0.96, 9)
        ] + [rod(tuple(start), tuple(end), 0.016)]
    chains += [ring(0.06, 0.022, (0, 0, 0.6), "y")]
    frame = [
        rod((0, 0, 0.62), (0, 0, 0.78), 0.03),
        box((0.1, 1.0, 0.1), (0, 0.42, 0.82), 0.02),
        box((0.12, 0.12, 2.3), (0, 0.88, -0.3), 0.02),
        rod((0, 0.86, 0.3), (0, 0.44, 0.8), 0.04),
        *(box((0.12, 1.1, 0.1), (s * 0.42, 0.5, -1.42), 0.02, (0, 0, s * 28)) for s in (-1, 1)),
        box((0.7, 0.14, 0.1), (0, 0.9, -1.42), 0.02),
    ]
    return {"bag": bag, "bands": bands, "chains": chains, "frame": frame}


def _exercise_bike(draw: Draw) -> Parts:
    seat_z = draw(0.95, 1.05)
    frame = [box((0.6, 0.1, 0.08), (0, y, 0.05), 0.03) for y in (-0.5, 0.55)] + [
        pipe([(0, -0.5, 0.07), (0, -0.3, 0.2), (0, 0.3, 0.2), (0, 0.55, 0.07)], 0.045),
        rod((0, 0.14, 0.22), (0, 0.34, seat_z), 0.045),
        rod((0, -0.26, 0.2), (0, -0.36, 1.18), 0.045),
    ]
    wheel_ = [
        rod((-0.06, -0.24, 0.42), (0.06, -0.24, 0.42), 0.31, rim=0.03),
        ring(0.3, 0.03, (0, -0.24, 0.42), "x"),
    ]
    case = [
        plate(
            closed_curve(
                [
                    (-0.4, 0.3),
                    (-0.34, 0.62),
                    (-0.1, 0.68),
                    (0.2, 0.56),
                    (0.26, 0.36),
                    (0.1, 0.22),
                    (-0.24, 0.2),
                ]
            ),
            0.09,
            (0.0, 0, 0),
            SIDE,
        )
    ]
    saddle = [
        plate(
            closed_curve(
                [
                    (-0.06, -0.16),
                    (0.06, -0.16),
                    (0.15, 0.12),
                    (0.08, 0.2),
                    (-0.08, 0.2),
                    (-0.15, 0.12),
                ]
            ),
            0.08,
            (0, 0.34, seat_z + 0.03),
        )
    ]
    bars = [
        pipe(
            [
                (-0.26, -0.2, 1.2),
                (-0.24, -0.42, 1.22),
                (0, -0.38, 1.18),
                (0.24, -0.42, 1.22),
                (0.26, -0.2, 1.2),
            ],
            0.028,
        )
    ]
    screen = [box((0.26, 0.05, 0.18), (0, -0.42, 1.32), 0.02, (-20, 0, 0))]
    face = [box((0.2, 0.02, 0.12), (0, -0.393, 1.327), 0.004, (-20, 0, 0))]
    crank = [
        rod((-0.14, 0.06, 0.4), (0.14, 0.06, 0.4), 0.03),
        rod((0.13, 0.06, 0.4), (0.14, -0.02, 0.24), 0.022),
        rod((-0.13, 0.06, 0.4), (-0.14, 0.14, 0.56), 0.022),
        box((0.13, 0.1, 0.035), (0.2, -0.02, 0.24), 0.01),
        box((0.13, 0.1, 0.035), (-0.2, 0.14, 0.56), 0.01),
    ]
    frame.append(rod((0, -0.36, 1.14), (0, -0.42, 1.31), 0.03))
    return {
        "frame": frame,
        "flywheel": wheel_,
        "cover": case,
        "saddle": saddle,
        "handlebar": bars,
        "console": screen,
        "screen": face,
        "pedals": crank,
    }


def _weight_bench(draw: Draw) -> Parts:
    tilt = draw(0.0, 14.0)
    pad = [
        box((0.36, 0.7, 0.09), (0, -0.32, 0.52), 0.035),
        *placed(
            [box((0.36, 0.74, 0.09), (0, 0.37, 0.0), 0.035)],
            Rotation.from_euler("x", tilt, degrees=True).as_matrix(),
            (0, 0.05, 0.52),
        ),
    ]
    steel = [
        box((0.09, 1.5, 0.1), (0, 0.02, 0.44), 0.015),
        box((0.5, 0.09, 0.07), (0, -0.66, 0.05), 0.015),
        box((0.08, 0.08, 0.4), (0, -0.64, 0.23), 0.012),
        *(box((0.08, 0.08, 1.12), (s * 0.42, 0.66, 0.56), 0.012) for s in (-1, 1)),
        box((0.9, 0.08, 0.08), (0, 0.66, 0.36), 0.012),
        *(box((0.1, 0.5, 0.07), (s * 0.42, 0.66, 0.04), 0.012) for s in (-1, 1)),
        *(
            pipe([(s * 0.42, 0.6, 1.12), (s * 0.42, 0.54, 1.06), (s * 0.42, 0.5, 1.18)], 0.028)
            for s in (-1, 1)
        ),
        rod((0, 0.3, 0.42), (0, 0.42, 0.52), 0.03),
    ]
    bar = [
        rod((-0.95, 0.54, 1.13), (0.95, 0.54, 1.13), 0.024),
        *both_sides([rod((0.54, 0.54, 1.13), (0.58, 0.54, 1.13), 0.045, rim=0.008)]),
    ]
    plates = both_sides(
        [
            rod((0.6, 0.54, 1.13), (0.67, 0.54, 1.13), 0.28, rim=0.015),
            rod((0.69, 0.54, 1.13), (0.75, 0.54, 1.13), 0.22, rim=0.015),
            rod((0.66, 0.54, 1.13), (0.7, 0.54, 1.13), 0.1),
        ]
    )
    collars = both_sides(
        [
            rod((0.76, 0.54, 1.13), (0.82, 0.54, 1.13), 0.05, rim=0.01),
            ring(0.2, 0.012, (0.672, 0.54, 1.13), "x"),
        ]
    )
    return {"pads": pad, "frame": steel, "bar": [*bar, *collars], "plates": plates}


def _ice_skate(draw: Draw) -> Parts:
    high = draw(0.7, 0.8)
    shaft = closed_curve(
        [
            (0.44, 0.0),
            (0.46, 0.3),
            (0.4, high),
            (0.14, high + 0.05),
            (0.08, 0.5),
            (-0.06, 0.36),
            (-0.36, 0.24),
            (-0.54, 0.12),
            (-0.54, 0.0),
            (-0.1, -0.02),
        ]
    )
    boot = [
        plate(shaft, 0.24, (0, 0, 0), SIDE),
        plate(0.96 * (shaft - shaft.mean(0)) + shaft.mean(0), 0.3, (0, 0, 0), SIDE),
    ]
    sole = [
        plate([(-0.54, -0.05), (0.46, -0.05), (0.46, 0.03), (-0.54, 0.03)], 0.28, (0, 0, 0), SIDE),
        box((0.24, 0.26, 0.12), (0, 0.32, -0.09), 0.02),
    ]
    blade = [
        plate(
            [
                (-0.66, -0.16),
                (-0.7, -0.24),
                (-0.62, -0.31),
                (0.52, -0.31),
                (0.58, -0.27),
                (0.5, -0.24),
                (0.42, -0.24),
                (0.38, -0.13),
                (0.26, -0.13),
                (0.22, -0.23),
                (-0.16, -0.23),
                (-0.24, -0.03),
                (-0.46, -0.03),
                (-0.54, -0.22),
                (-0.62, -0.22),
            ],
            0.03,
            (0, 0, 0),
            SIDE,
        )
    ]
    laces = [
        capsule(
            (-0.09, -0.02 - 0.062 * k, 0.395 - 0.034 * k),
            (0.09, -0.05 - 0.062 * k, 0.38 - 0.034 * k),
            0.022,
        )
        for k in range(5)
    ] + [
        capsule(
            (-0.09, 0.075 + 0.008 * k, 0.54 + 0.07 * k),
            (0.09, 0.08 + 0.008 * k, 0.55 + 0.07 * k),
            0.018,
        )
        for k in range(3)
    ]
    cuff = [box((0.32, 0.36, 0.08), (0, 0.27, high + 0.01), 0.035)]
    tongue = [
        plate(
            [(0.06, 0.5), (0.16, 0.5), (0.2, high + 0.16), (0.1, high + 0.18)], 0.2, (0, 0, 0), SIDE
        )
    ]
    return {"boot": boot, "cuff": [*cuff, *tongue], "sole": sole, "blade": blade, "laces": laces}


GYMNASIUM: dict[str, Callable[[Draw], Parts]] = {
    "punching bag": _punching_bag,
    "exercise bike": _exercise_bike,
    "weight bench": _weight_bench,
    "ice skate": _ice_skate,
}
