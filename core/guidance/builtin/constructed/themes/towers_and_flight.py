"""A biplane, a shuttle, a skyscraper and others that were drawn roughly."""

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
    capsule,
    closed_curve,
    curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _biplane(draw: Draw) -> Parts:
    span = draw(1.0, 1.12)
    tube = [
        (0, -0.6),
        (0.13, -0.58),
        (0.17, -0.5),
        (0.18, -0.2),
        (0.15, 0.3),
        (0.09, 0.8),
        (0.04, 1.1),
        (0, 1.12),
    ]
    body = placed([turned(tube)], BACKWARD)
    body += [
        plate([(0.72, 0.02), (1.02, 0.34), (1.18, 0.34), (1.16, 0.0)], 0.035, (0, 0, 0), SIDE),
        *both_sides(
            [plate([(0.02, 0.82), (0.4, 0.94), (0.4, 1.1), (0.02, 1.12)], 0.03, (0, 0, 0.02))]
        ),
    ]
    body += [
        box((0.2, 0.05, 0.1), (0, 0.34, 0.17), 0.02),
        box((0.2, 0.26, 0.04), (0, 0.16, 0.165), 0.02),
    ]
    wings = []
    for z, shift in ((-0.1, 0.06), (0.44, -0.06)):
        outline = rounded((2 * span, 0.36), 0.12) + (0, -0.2 + shift)
        wings += [
            plate(outline, 0.032, (0, 0, z)),
            plate(outline * (0.98, 0.9) - (0, 0.02), 0.05, (0, 0, z)),
        ]
        wings += [
            box((0.02, 0.34, 0.062), (x, -0.2 + shift, z), 0.006)
            for x in np.linspace(-0.84 * span, 0.84 * span, 7)
        ]
    struts = []
    for x in (0.28 * span, 0.78 * span):
        struts += both_sides(
            [
                rod((x, -0.28, -0.1), (x, -0.38, 0.44), 0.018),
                rod((x, -0.04, -0.1), (x, -0.14, 0.44), 0.018),
            ]
        )
    struts += both_sides(
        [
            rod((0.28 * span, -0.2, -0.08), (0.78 * span, -0.26, 0.42), 0.009),
            rod((0.28 * span, -0.26, 0.42), (0.78 * span, -0.2, -0.08), 0.009),
        ]
    )
    struts += both_sides(
        [
            rod((0.1, -0.3, 0.12), (0.14, -0.34, 0.44), 0.018),
            rod((0.1, -0.02, 0.12), (0.14, -0.1, 0.44), 0.018),
            rod((0.1, -0.36, -0.14), (0.26, -0.36, -0.42), 0.02),
            rod((0.1, -0.14, -0.14), (0.26, -0.34, -0.42), 0.018),
        ]
    )
    struts += [
        rod((-0.3, -0.36, -0.42), (0.3, -0.36, -0.42), 0.02),
        rod((0, 1.0, -0.04), (0, 1.08, -0.16), 0.018),
    ]
    engine = [
        rod((0, -0.56, 0), (0, -0.68, 0), 0.16, 0.12, 0.02),
        *(
            rod(
                (0.1 * np.cos(a), -0.62, 0.1 * np.sin(a)),
                (0.2 * np.cos(a), -0.62, 0.2 * np.sin(a)),
                0.045,
                rim=0.01,
            )
            for a in np.arange(7) * 2 * np.pi / 7
        ),
    ]
    way = draw(0.0, 180.0)
    blades = placed(
        spun([box((0.085, 0.022, 0.44), (0, 0, 0.22), 0.008, (0, 0, 24))], 2, "y"),
        Rotation.from_euler("y", way, degrees=True).as_matrix(),
        (0, -0.74, 0),
    )
    propeller = [*blades, ball((0.055, 0.09, 0.055), (0, -0.75, 0))]
    wheels = both_sides(
        [
            ring(0.1, 0.04, (0.29, -0.36, -0.42), "x"),
            rod((0.27, -0.36, -0.42), (0.31, -0.36, -0.42), 0.08),
        ]
    ) + [ball(0.04, (0, 1.09, -0.18))]
    return {
        "body": body,
        "wings": wings,
        "struts": struts,
        "engine": engine,
        "propeller": propeller,
        "wheels": wheels,
    }


def _space_shuttle(draw: Draw) -> Parts:
    tube = [
        (0, -1.16),
        *curve([(0.05, -1.14), (0.15, -1.0), (0.21, -0.78), (0.23, -0.5)]),
        (0.23, 0.86),
        (0.2, 0.92),
        (0, 0.92),
    ]
    body = placed([turned(tube)], BACKWARD, (0, 0, 0.04))
    body += [
        box((0.44, 1.5, 0.26), (0, 0.14, -0.08), 0.05),
        plate([(0.56, 0.1), (0.9, 0.1), (0.96, 0.42), (0.72, 0.36)], 0.2, (0, 0, 0), SIDE),
    ]
    body += both_sides([capsule((0.17, 0.62, 0.2), (0.17, 0.98, 0.2), 0.11, 0.09)])
    nose = placed(
        [turned([(0, -1.19), *curve([(0.04, -1.17), (0.12, -1.08), (0.17, -0.98)]), (0, -0.97)])],
        BACKWARD,
        (0, 0, 0.035),
    )
    wing = [
        (0.16, -0.6),
        (0.28, -0.34),
        (0.84 + draw(-0.04, 0.06), 0.56),
        (0.84, 0.74),
        (0.5, 0.8),
        (0.16, 0.8),
    ]
    wings = both_sides([plate(wing, 0.06, (0, 0, -0.14))])
    wings += [plate([(0.4, 0.2), (0.86, 0.82), (1.06, 0.82), (0.98, 0.2)], 0.06, (0, 0, 0), SIDE)]
    windows = [
        box(
            (0.075, 0.05, 0.07),
            (x, -0.86 + 1.2 * abs(x) ** 1.5, 0.2 - 0.16 * abs(x)),
            0.01,
            (-38, 0, 46 * np.sign(x) * min(abs(x) * 8, 1)),
        )
        for x in (-0.13, -0.045, 0.045, 0.13)
    ]
    nozzle = [
        turned(
            [(0, 0), (0.06, 0), (0.07, 0.06), (0.13, 0.22), (0.11, 0.22), (0.05, 0.08), (0, 0.06)]
        )
    ]
    engines = [
        one
        for x, z in ((0.0, 0.16), (-0.12, -0.04), (0.12, -0.04))
        for one in placed(nozzle, BACKWARD, (x, 0.88, z))
    ]
    engines += both_sides(
        placed(
            [turned([(0, 0), (0.03, 0), (0.07, 0.1), (0.05, 0.1), (0, 0.03)])],
            BACKWARD,
            (0.17, 1.04, 0.2),
        )
    )
    return {"body": body, "wings": wings, "nose": nose, "windows": windows, "engines": engines}


def _skyscraper(draw: Draw) -> Parts:
    floors = 5 + draw.which(2)
    tiers = ((0.42, 0.42, floors), (0.34, 0.34, 5), (0.25, 0.25, 4), (0.16, 0.16, 2))
    walls, glass, z, step = [], [], 0.2, 0.105
    for wide, deep, count in tiers:
        high = step * count
        glass.append(
            box((2 * wide - 0.03, 2 * deep - 0.03, high + 0.02), (0, 0, z + high / 2), 0.004)
        )
        for k in range(count + 1):
            walls.append(box((2 * wide, 2 * deep, 0.034), (0, 0, z + step * k), 0.004))
        piers = max(round(2 * wide / 0.12), 2)
        for x in np.linspace(-wide + 0.02, wide - 0.02, piers + 1):
            walls += [
                box((0.034, 0.036, high), (x, s * (deep - 0.004), z + high / 2), 0.004)
                for s in (-1, 1)
            ]
            walls += [
                box(
                    (0.036, 0.034, high), (s * (wide - 0.004), x * deep / wide, z + high / 2), 0.004
                )
                for s in (-1, 1)
            ]
        walls.append(box((2 * wide + 0.03, 2 * deep + 0.03, 0.045), (0, 0, z + high + 0.01), 0.006))
        z += high + 0.02
    base = [
        box((0.98, 0.98, 0.2), (0, 0, 0.1), 0.01),
        box((1.1, 1.1, 0.05), (0, 0, 0.01), 0.01),
        *(box((0.06, 0.05, 0.18), (x, -0.5, 0.11), 0.006) for x in (-0.4, -0.2, 0.2, 0.4)),
    ]
    door = [
        box((0.22, 0.05, 0.13), (0, -0.48, 0.09), 0.006),
        box((0.34, 0.14, 0.025), (0, -0.53, 0.17), 0.006),
    ]
    spire = [
        rod((0, 0, z - 0.02), (0, 0, z + 0.16), 0.07, 0.035, 0.01),
        rod((0, 0, z + 0.14), (0, 0, z + 0.56), 0.022, 0.006),
    ]
    return {"walls": walls, "windows": glass, "base": base, "door": door, "spire": spire}


def _scythe(draw: Draw) -> Parts:
    long = draw(0.78, 0.9)
    shaft = [
        pipe(
            [(0.06, 0, -1.0), (0.0, 0, -0.5), (0.02, 0, 0.1), (-0.02, 0, 0.62), (0.0, 0, 0.9)],
            0.036,
        )
    ]
    top = 0.84
    outer = curve([(0.06, top + 0.06), (-0.2, top + 0.1), (-0.55, top - 0.02), (-long, top - 0.42)])
    inner = curve(
        [(-long, top - 0.42), (-0.58, top - 0.14), (-0.26, top - 0.06), (0.04, top - 0.08)]
    )
    blade = [
        plate([*outer, *inner[1:]], 0.034, (0, 0, 0), FRONT),
        pipe(
            [(x, 0, z - 0.012) for x, z in outer[::6]],
            (0.03, *([0.028] * (len(outer[::6]) - 2)), 0.014),
        ),
    ]
    collar = [
        rod((0, 0, top - 0.14), (0, 0, top + 0.14), 0.055, rim=0.01),
        rod((0, 0, top + 0.08), (0, 0, top + 0.18), 0.045, 0.02),
        rod((0.055, 0, -1.04), (0.062, 0, -0.92), 0.046, rim=0.01),
    ]
    pegs = [capsule((0.01, 0, z), (0.22, -0.02, z + 0.02), 0.026) for z in (0.06, -0.36)] + [
        capsule((0.22, -0.02, z + 0.02), (0.23, -0.02, z + 0.15), 0.034) for z in (0.06, -0.36)
    ]
    return {"blade": blade, "shaft": shaft, "collar": collar, "pegs": pegs}


def _microscope(draw: Draw) -> Parts:
    tilt = Rotation.from_euler("x", -draw(18.0, 26.0), degrees=True).as_matrix()
    foot = closed_curve(
        [
            (-0.3, -0.42),
            (0, -0.3),
            (0.3, -0.42),
            (0.38, -0.2),
            (0.3, 0.3),
            (0, 0.4),
            (-0.3, 0.3),
            (-0.38, -0.2),
        ]
    )
    base = [
        plate(foot, 0.09, (0, 0, 0.05)),
        plate(0.9 * foot, 0.13, (0, 0.02, 0.05)),
        box((0.22, 0.26, 0.16), (0, 0.24, 0.16), 0.04),
    ]
    arm = [
        plate(
            closed_curve(
                [
                    (0.16, 0.14),
                    (0.36, 0.16),
                    (0.46, 0.4),
                    (0.42, 0.78),
                    (0.24, 1.0),
                    (0.02, 1.06),
                    (-0.02, 0.94),
                    (0.16, 0.86),
                    (0.28, 0.7),
                    (0.3, 0.44),
                    (0.2, 0.28),
                ]
            ),
            0.16,
            (0, 0, 0),
            SIDE,
        )
    ]
    stage = [
        box((0.56, 0.5, 0.05), (0, -0.06, 0.4), 0.015),
        box((0.14, 0.4, 0.06), (0, 0.16, 0.37), 0.01),
        *both_sides([rod((0.14, 0.0, 0.42), (0.05, -0.16, 0.44), 0.014)]),
        rod((0, -0.06, 0.36), (0, -0.06, 0.3), 0.09, rim=0.01),
    ]
    tube = placed(
        [
            rod((0, 0, -0.06), (0, 0, 0.5), 0.085, rim=0.01),
            rod((0, 0, -0.02), (0, 0, 0.1), 0.13, rim=0.02),
            box((0.14, 0.2, 0.2), (0, 0.1, 0.14), 0.03),
        ],
        tilt,
        (0, -0.02, 0.86),
    )
    eye = placed(
        [
            rod((0, 0, 0.48), (0, 0, 0.62), 0.07, rim=0.01),
            rod((0, 0, 0.6), (0, 0, 0.68), 0.095, 0.08, 0.01),
        ],
        tilt,
        (0, -0.02, 0.86),
    )
    lenses = [
        ball((0.12, 0.12, 0.07), (0, -0.04, 0.8)),
        rod((0, -0.05, 0.8), (0, -0.06, 0.54), 0.045, 0.03, 0.006),
        rod((0.05, -0.05, 0.79), (0.16, -0.1, 0.62), 0.04, 0.03, 0.006),
        rod((-0.05, -0.05, 0.79), (-0.16, -0.1, 0.64), 0.04, 0.03, 0.006),
        ball((0.09, 0.03, 0.09), (0, -0.1, 0.2), (40, 0, 0)),
        rod((0, -0.1, 0.1), (0, -0.1, 0.18), 0.03),
    ]
    knobs = both_sides(
        [
            rod((0.06, 0.34, 0.5), (0.16, 0.34, 0.5), 0.085, rim=0.012),
            rod((0.15, 0.34, 0.5), (0.2, 0.34, 0.5), 0.05, rim=0.01),
            rod((0.06, 0.36, 0.3), (0.13, 0.36, 0.3), 0.05, rim=0.01),
        ]
    )
    return {
        "base": base,
        "arm": arm,
        "stage": stage,
        "tube": tube,
        "eyepiece": eye,
        "lenses": lenses,
        "knobs": knobs,
    }


TOWERS_AND_FLIGHT: dict[str, Callable[[Draw], Parts]] = {
    "biplane": _biplane,
    "space shuttle": _space_shuttle,
    "skyscraper": _skyscraper,
    "scythe": _scythe,
    "microscope": _microscope,
}
