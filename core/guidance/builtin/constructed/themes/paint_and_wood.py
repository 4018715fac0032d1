"""Tools of painters and joiners."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    both_sides,
    box,
    capsule,
    closed_curve,
    curve,
    pipe,
    plate,
    ring,
    rod,
    turned,
)


def _paint_roller(draw: Draw) -> Parts:
    wide = draw(0.42, 0.5)
    roller = [rod((-wide, 0, 0.8), (wide, 0, 0.8), 0.15, rim=0.03)]
    caps = both_sides([rod((wide - 0.01, 0, 0.8), (wide + 0.02, 0, 0.8), 0.1, rim=0.006)])
    wire = [
        pipe(
            [
                (wide, 0, 0.8),
                (wide + 0.1, 0, 0.8),
                (wide + 0.12, 0, 0.72),
                (wide + 0.1, 0, 0.52),
                (wide - 0.02, 0, 0.44),
                (0.1, 0, 0.36),
                (0, 0, 0.26),
                (0, 0, 0.0),
            ],
            0.026,
        )
    ]
    grip = [
        turned(
            [
                (0, 0.04),
                (0.05, 0.04),
                (0.07, 0.0),
                (0.055, -0.1),
                (0.075, -0.3),
                (0.06, -0.5),
                (0.075, -0.62),
                (0.05, -0.7),
                (0, -0.71),
            ][::-1]
        )
    ]
    paint = [
        plate(
            closed_curve(
                [
                    (-wide, 1.5),
                    (-0.5 * wide, 1.56),
                    (0.4 * wide, 1.52),
                    (0.98 * wide, 1.55),
                    (0.98 * wide, 0.86),
                    (-0.98 * wide, 0.86),
                    (-0.98 * wide, 1.1),
                ]
            ),
            0.03,
            (0, 0.13, 0),
            FRONT,
        ),
        *(
            capsule((x, 0.12, 0.86), (x, 0.12, 0.86 - d), 0.03)
            for x, d in ((-0.28, 0.2), (0.02, 0.12), (0.3, 0.26))
        ),
    ]
    return {"roller": [*roller], "wire": [*wire, *caps], "grip": grip, "coat": paint}


def _paint_bucket(draw: Draw) -> Parts:
    r, high = 0.42, draw(0.82, 0.94)
    tin = [
        turned(
            [
                (0, 0),
                (r, 0),
                (r, high - 0.05),
                (r + 0.02, high - 0.02),
                (r + 0.02, high + 0.02),
                (r - 0.08, high + 0.02),
                (r - 0.08, high - 0.1),
                (0, high - 0.12),
            ]
        ),
        ring(r, 0.018, (0, 0, 0.02)),
    ]
    label = [
        turned(
            [(r - 0.02, 0.16), (r + 0.008, 0.16), (r + 0.008, high - 0.2), (r - 0.02, high - 0.2)]
        )
    ]
    paint = [rod((0, 0, high - 0.15), (0, 0, high - 0.06), r - 0.07)]
    for a, d, w in (
        (-1.9, 0.4, 0.05),
        (-1.55, 0.62, 0.06),
        (-1.2, 0.3, 0.05),
        (-2.4, 0.2, 0.04),
        (-0.7, 0.18, 0.045),
    ):
        x, y = np.cos(a), np.sin(a)
        paint += [
            capsule(
                ((r - 0.12) * x, (r - 0.12) * y, high - 0.07),
                ((r + 0.01) * x, (r + 0.01) * y, high + 0.03),
                w,
            ),
            capsule(
                ((r + 0.015) * x, (r + 0.015) * y, high + 0.02),
                ((r + 0.012) * x, (r + 0.012) * y, high - d),
                w,
                0.8 * w,
            ),
        ]
    handle = [
        pipe(
            [
                (-r - 0.01, 0, high - 0.1),
                (-r - 0.1, -0.1, high - 0.2),
                (-0.3, -r - 0.12, high - 0.42),
                (0.3, -r - 0.12, high - 0.42),
                (r + 0.1, -0.1, high - 0.2),
                (r + 0.01, 0, high - 0.1),
            ],
            0.018,
        ),
        *both_sides([rod((r - 0.02, 0, high - 0.1), (r + 0.03, 0, high - 0.1), 0.04, rim=0.008)]),
    ]
    brush = [
        rod((0.1, 0.1, high - 0.05), (0.34, 0.34, high + 0.5), 0.035, 0.05),
        box((0.24, 0.09, 0.14), (0.07, 0.07, high - 0.08), 0.01, (0, 20, 45)),
    ]
    return {"tin": tin, "label": label, "coat": paint, "handle": handle, "brush": brush}


def _chisel(draw: Draw) -> Parts:
    long = draw(0.8, 0.95)
    blade = [
        plate([(-0.1, 0), (0.1, 0), (0.1, -long), (-0.1, -long)], 0.05, (0, 0, 0), FRONT),
        rod((0, 0, -0.05), (0, 0, 0.14), 0.05, 0.07, 0.01),
    ]
    edge = [
        plate(
            [(-0.026, -long), (0.026, -long), (0.026, -long - 0.02), (-0.02, -long - 0.14)],
            0.198,
            (0, 0, 0),
            SIDE,
        )
    ]
    grip = [
        turned(
            [
                (0, 0.12),
                (0.08, 0.12),
                (0.09, 0.16),
                *curve([(0.09, 0.16), (0.075, 0.3), (0.1, 0.55), (0.09, 0.72)]),
                (0.075, 0.76),
                (0, 0.77),
            ]
        )
    ]
    bands = [
        rod((0, 0, 0.12), (0, 0, 0.2), 0.098, rim=0.01),
        rod((0, 0, 0.68), (0, 0, 0.75), 0.1, rim=0.01),
    ]
    return {"blade": blade, "edge": edge, "grip": grip, "bands": bands}


def _wood_plane(draw: Draw) -> Parts:
    long = draw(0.85, 1.0)
    body = [
        box((0.34, 2 * long, 0.24), (0, 0, 0.14), 0.02),
        box((0.36, 2 * long + 0.02, 0.06), (0, 0, 0.03), 0.01),
    ]
    tote = [
        plate(
            closed_curve(
                [
                    (0.34, 0.24),
                    (0.62, 0.24),
                    (0.66, 0.4),
                    (0.6, 0.62),
                    (0.7, 0.74),
                    (0.58, 0.8),
                    (0.46, 0.7),
                    (0.46, 0.46),
                ]
            ),
            0.12,
            (0, 0, 0),
            SIDE,
        )
    ]
    knob = [
        turned(
            [
                (0, 0.22),
                (0.12, 0.22),
                (0.09, 0.3),
                (0.06, 0.36),
                *curve([(0.06, 0.36), (0.13, 0.44), (0.12, 0.54), (0.06, 0.58)]),
                (0, 0.59),
            ],
            (0, -0.66 * long, 0),
        )
    ]
    iron = [
        box((0.24, 0.04, 0.62), (0, 0.1, 0.4), 0.008, (-42, 0, 0)),
        box((0.2, 0.05, 0.34), (0, 0.06, 0.42), 0.01, (-42, 0, 0)),
        rod((0, -0.06, 0.36), (0, 0.06, 0.5), 0.05, rim=0.01),
    ]
    shaving = [
        pipe(
            [
                (
                    0,
                    -0.14 + 0.16 * (1 - 0.07 * t) * np.cos(t + 3.6),
                    0.44 + 0.16 * (1 - 0.07 * t) * np.sin(t + 3.6),
                )
                for t in np.linspace(0, 8, 18)
            ],
            0.03,
        ),
        rod((0, -0.16, 0.22), (0, -0.24, 0.38), 0.035),
    ]
    return {"body": body, "handle": [*tote, *knob], "iron": iron, "shaving": shaving}


def _workbench(draw: Draw) -> Parts:
    wide = draw(0.95, 1.1)
    top = [box((2 * wide, 0.13, 0.09), (0, -0.34 + 0.136 * k, 0.86), 0.01) for k in range(6)] + [
        box((2 * wide - 0.1, 0.7, 0.08), (0, 0, 0.79), 0.01)
    ]
    legs = (
        [
            box((0.12, 0.12, 0.8), (s * (wide - 0.16), t * 0.28, 0.4), 0.012)
            for s in (-1, 1)
            for t in (-1, 1)
        ]
        + [box((2 * wide - 0.3, 0.08, 0.1), (0, t * 0.28, 0.2), 0.01) for t in (-1, 1)]
        + [box((0.08, 0.56, 0.1), (s * (wide - 0.16), 0, 0.2), 0.01) for s in (-1, 1)]
    )
    shelf = [box((2 * wide - 0.36, 0.54, 0.05), (0, 0, 0.25), 0.01)]
    board = [
        box((2 * wide, 0.05, 0.74), (0, 0.4, 1.26), 0.01),
        *(box((0.07, 0.07, 0.9), (s * (wide - 0.06), 0.42, 1.2), 0.01) for s in (-1, 1)),
    ]
    vise = [
        box((0.34, 0.1, 0.16), (-wide + 0.3, -0.5, 0.82), 0.015),
        rod((-wide + 0.3, -0.42, 0.8), (-wide + 0.3, -0.66, 0.8), 0.03),
        rod((-wide + 0.18, -0.62, 0.8), (-wide + 0.42, -0.62, 0.8), 0.016),
        box((0.34, 0.08, 0.16), (-wide + 0.3, -0.42, 0.82), 0.012),
    ]
    steel = [
        rod((-0.52, 0.36, 1.44), (-0.52, 0.36, 1.2), 0.022),
        box((0.2, 0.07, 0.08), (-0.52, 0.36, 1.46), 0.015),
        plate(
            closed_curve([(-0.2, 1.5), (-0.06, 1.5), (-0.06, 1.12), (-0.2, 1.12), (-0.19, 1.3)]),
            0.04,
            (0, 0.36, 0),
            FRONT,
        ),
        *(
            rod((0.12 + 0.13 * k, 0.36, 1.46), (0.12 + 0.13 * k, 0.36, 1.3), 0.018)
            for k in range(4)
        ),
        plate([(0.62, 1.5), (0.86, 1.42), (0.86, 1.36), (0.62, 1.34)], 0.03, (0, 0.36, 0), FRONT),
    ]
    grips = [
        rod((-0.52, 0.36, 1.22), (-0.52, 0.36, 1.06), 0.032, rim=0.008),
        *(
            capsule((0.12 + 0.13 * k, 0.36, 1.28), (0.12 + 0.13 * k, 0.36, 1.16), 0.034)
            for k in range(4)
        ),
        box((0.16, 0.05, 0.14), (0.62, 0.36, 1.43), 0.03),
        box((0.5, 0.3, 0.22), (0.3, 0.0, 0.38), 0.02),
        box((0.24, 0.2, 0.06), (0.2, 0.02, 0.93), 0.01),
    ]
    return {
        "top": top,
        "legs": [*legs, *shelf],
        "board": board,
        "vise": vise,
        "tools": steel,
        "grips": grips,
    }


PAINT_AND_WOOD: dict[str, Callable[[Draw], Parts]] = {
    "paint roller": _paint_roller,
    "paint bucket": _paint_bucket,
    "chisel": _chisel,
    "wood plane": _wood_plane,
    "workbench": _workbench,
}
