"""Rides of a fair."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    pipe,
    placed,
    ring,
    rod,
    spun,
    turned,
)


def _ferris_wheel(draw: Draw) -> Parts:
    count = 10 + 2 * draw.which(2)
    r, z, half = 0.85, 1.08, 0.13
    rim = [
        turned([(q - 0.025, -0.018), (q, -0.018), (q, 0.018), (q - 0.025, 0.018)], (0, y, z), "y")
        for q in (r, 0.66 * r)
        for y in (-half, half)
    ]
    spokes = []
    for k in range(count):
        a = 2 * np.pi * k / count
        b = a + np.pi / count
        for y in (-half, half):
            spokes.append(rod((0, y, z), (r * np.cos(a), y, z + r * np.sin(a)), 0.014))
            spokes.append(
                rod(
                    (0.65 * r * np.cos(a), y, z + 0.65 * r * np.sin(a)),
                    (0.99 * r * np.cos(b), y, z + 0.99 * r * np.sin(b)),
                    0.0105,
                )
            )
            spokes.append(
                rod(
                    (0.99 * r * np.cos(b), y, z + 0.99 * r * np.sin(b)),
                    (
                        0.65 * r * np.cos(a + 2 * np.pi / count),
                        y,
                        z + 0.65 * r * np.sin(a + 2 * np.pi / count),
                    ),
                    0.0105,
                )
            )
        spokes.append(
            rod(
                (r * np.cos(a), -half - 0.02, z + r * np.sin(a)),
                (r * np.cos(a), half + 0.02, z + r * np.sin(a)),
                0.014,
            )
        )
    spokes += [
        rod((0, -0.3, z), (0, 0.3, z), 0.04),
        *(rod((0, y - 0.02, z), (0, y + 0.02, z), 0.1, rim=0.008) for y in (-half, half)),
    ]
    cabins, roofs = [], []
    for k in range(count):
        a = 2 * np.pi * k / count
        x, h = r * np.cos(a), z + r * np.sin(a)
        cabins += [
            turned(
                [
                    (0, h - 0.25),
                    (0.07, h - 0.25),
                    (0.105, h - 0.19),
                    (0.105, h - 0.14),
                    (0.085, h - 0.14),
                    (0.085, h - 0.18),
                    (0, h - 0.2),
                ],
                (x, 0, 0),
            ),
            *(
                rod((x + s * 0.095, 0, h - 0.16), (x + s * 0.085, 0, h - 0.03), 0.0115)
                for s in (-1, 1)
            ),
        ]
        roofs += [
            turned([(0, h - 0.05), (0.125, h - 0.05), (0.1, h - 0.02), (0, h + 0.03)], (x, 0, 0))
        ]
    legs = (
        [rod((s * 0.6, t * 0.34, 0.04), (0, t * 0.24, z), 0.035) for s in (-1, 1) for t in (-1, 1)]
        + [rod((-0.32, t * 0.29, 0.52), (0.32, t * 0.29, 0.52), 0.024) for t in (-1, 1)]
        + [rod((0, t * 0.2, z), (0, t * 0.28, z), 0.085, rim=0.01) for t in (-1, 1)]
    )
    base = [box((1.5, 0.9, 0.09), (0, 0, 0.02), 0.02), box((0.4, 0.16, 0.05), (0, -0.5, 0.0), 0.01)]
    return {
        "rim": rim,
        "spokes": spokes,
        "cabins": cabins,
        "roofs": roofs,
        "legs": legs,
        "base": base,
    }


def _carousel(draw: Draw) -> Parts:
    count = 6 + 2 * draw.which(2)
    floor = [
        rod((0, 0, 0), (0, 0, 0.1), 0.98, rim=0.015),
        rod((0, 0, -0.06), (0, 0, 0.03), 1.08, 1.04, 0.015),
    ]
    column = [
        rod((0, 0, 0.08), (0, 0, 1.2), 0.2),
        *spun([box((0.13, 0.03, 0.6), (0, -0.185, 0.6), 0.008)], 8),
    ]
    canopy = [
        turned(
            [
                (0, 1.12),
                (1.04, 1.12),
                (1.04, 1.2),
                (0.6, 1.42),
                (0.12, 1.62),
                (0.08, 1.74),
                (0, 1.76),
            ]
        )
    ]
    canopy += spun([pipe([(0, -1.03, 1.2), (0, -0.6, 1.43), (0, -0.13, 1.63)], 0.022)], 12)
    trim = [
        turned([(1.0, 1.06), (1.08, 1.06), (1.08, 1.22), (1.0, 1.22)]),
        *spun([ball((0.12, 0.04, 0.09), (0, -1.06, 1.06))], 20),
        ball(0.06, (0, 0, 1.8)),
        ring(0.99, 0.022, (0, 0, 0.1)),
        *(ring(0.205, 0.022, (0, 0, z)) for z in (0.14, 1.06)),
    ]
    poles, horses = [], []
    for k in range(count):
        a = 2 * np.pi * k / count
        up = 0.1 * (k % 2)
        way = Rotation.from_euler("z", np.degrees(a), degrees=True).as_matrix()
        at = way @ (0.7, 0, 0)
        poles += [
            rod((at[0], at[1], 0.08), (at[0], at[1], 1.16), 0.016),
            ball(0.032, (at[0], at[1], 0.4 + up)),
        ]
        z = 0.5 + up
        horse = [
            capsule((0, -0.12, z), (0, 0.14, z + 0.01), 0.075, 0.08),
            capsule((0, -0.14, z + 0.04), (0, -0.24, z + 0.2), 0.06, 0.045),
            capsule((0, -0.25, z + 0.21), (0, -0.37, z + 0.14), 0.045, 0.032),
            *both_sides([rod((0.024, -0.24, z + 0.24), (0.03, -0.24, z + 0.31), 0.02, 0.006)]),
            pipe(
                [(0, 0.2, z + 0.05), (0, 0.3, z + 0.04), (0, 0.34, z - 0.1)], (0.03, 0.035, 0.016)
            ),
        ]
        horse += both_sides(
            [
                pipe(
                    [(0.045, -0.12, z - 0.02), (0.05, -0.22, z - 0.1), (0.05, -0.16, z - 0.22)],
                    (0.04, 0.03, 0.022),
                ),
                pipe(
                    [(0.045, 0.14, z - 0.02), (0.05, 0.12, z - 0.14), (0.05, 0.22, z - 0.24)],
                    (0.045, 0.03, 0.022),
                ),
            ]
        )
        horses += placed(horse, way, (at[0], at[1], 0))
    return {
        "floor": floor,
        "column": column,
        "canopy": canopy,
        "trim": trim,
        "poles": poles,
        "horses": horses,
    }


FAIR: dict[str, Callable[[Draw], Parts]] = {
    "ferris wheel": _ferris_wheel,
    "carousel": _carousel,
}
