"""Spacecraft."""

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
    curve,
    moved,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _space_capsule(draw: Draw) -> Parts:
    cone = [
        turned(
            [
                (0, 0.16),
                (0.72, 0.16),
                (0.74, 0.2),
                (0.72, 0.25),
                (0.3, 0.98),
                (0.28, 1.02),
                (0, 1.02),
            ]
        ),
        rod((0, 0, 1.0), (0, 0, 1.14), 0.24, 0.22, 0.01),
    ]
    shield = [
        turned([(0, -0.02), *curve([(0.3, 0.0), (0.56, 0.06), (0.72, 0.16)]), (0.7, 0.2), (0, 0.2)])
    ]
    probe = [
        rod((0, 0, 1.12), (0, 0, 1.3), 0.1, 0.07, 0.01),
        rod((0, 0, 1.28), (0, 0, 1.46), 0.03),
        ball(0.05, (0, 0, 1.46)),
    ]
    lean = np.degrees(np.arctan2(0.42, 0.73))
    windows, frames, seams = [], [], []
    for a in (-28, 28, 180 - 28, 180 + 28):
        way = Rotation.from_euler("z", a, degrees=True).as_matrix()
        tilt = Rotation.from_euler("x", -lean, degrees=True).as_matrix()
        windows += placed(
            placed(
                [plate(rounded((0.16, 0.16), 0.04), 0.06, (0, 0, 0), FRONT)],
                tilt,
                (0, -0.475, 0.68),
            ),
            way,
        )
        frames += placed(
            placed(
                [plate(rounded((0.22, 0.22), 0.06), 0.04, (0, 0.005, 0), FRONT)],
                tilt,
                (0, -0.475, 0.68),
            ),
            way,
        )
    hatch = placed(
        [
            plate(rounded((0.3, 0.34), 0.08), 0.04, (0, 0, 0), FRONT),
            plate(rounded((0.22, 0.26), 0.06), 0.06, (0, 0, 0), FRONT),
        ],
        Rotation.from_euler("x", -lean, degrees=True).as_matrix(),
        (0, -0.57, 0.5),
    )
    hatch += placed(
        [box((0.14, 0.05, 0.03), (0, -0.03, -0.04), 0.008)],
        Rotation.from_euler("x", -lean, degrees=True).as_matrix(),
        (0, -0.57, 0.5),
    )
    seams += [ring(0.725 - 0.42 * (z - 0.25) / 0.73, 0.013, (0, 0, z)) for z in (0.36, 0.9)]
    jets = spun(
        moved(
            both_sides([rod((0.05, -0.02, 0), (0.05, -0.1, 0.0), 0.022, 0.035)]), (0, -0.68, 0.3)
        ),
        4,
    )
    count = 12 + 2 * draw.which(3)
    bolts = spun([ball(0.02, (0, -0.735, 0.2))], count)
    return {
        "hull": cone,
        "heat shield": shield,
        "docking probe": [*probe, *bolts],
        "windows": windows,
        "frames": [*frames, *seams],
        "hatch": hatch,
        "thrusters": jets,
    }


def _lunar_lander(draw: Draw) -> Parts:
    octagon = np.stack(
        [
            np.cos(np.arange(8) * np.pi / 4 + np.pi / 8),
            np.sin(np.arange(8) * np.pi / 4 + np.pi / 8),
        ],
        1,
    )
    gold = [
        plate(0.56 * octagon, 0.34, (0, 0, 0.5)),
        plate(0.5 * octagon, 0.06, (0, 0, 0.7)),
        *spun([box((0.26, 0.03, 0.24), (0, -0.525, 0.5), 0.004)], 8),
    ]
    white = [
        plate(0.34 * octagon, 0.3, (0, 0, 0.88)),
        rod((0, -0.42, 0.92), (0, 0.3, 0.92), 0.3, rim=0.03),
        box((0.44, 0.3, 0.3), (0, 0.24, 0.92), 0.03),
        ball((0.18, 0.2, 0.18), (0.36, 0.04, 0.9)),
        ball((0.18, 0.2, 0.18), (-0.36, 0.04, 0.9)),
        rod((0, 0, 1.16), (0, 0, 1.3), 0.16, 0.13, 0.01),
    ]
    glass = [
        plate([(-0.2, 0), (-0.04, -0.02), (-0.06, -0.14)], 0.04, (0, -0.415, 1.05), FRONT),
        plate([(0.2, 0), (0.04, -0.02), (0.06, -0.14)], 0.04, (0, -0.415, 1.05), FRONT),
    ]
    hatch = [
        plate(rounded((0.2, 0.2), 0.03), 0.04, (0, -0.42, 0.8), FRONT),
        box((0.24, 0.16, 0.03), (0, -0.5, 0.7), 0.006),
    ]
    legs, pads = [], []
    spread = draw(0.95, 1.05)
    for k in range(4):
        a = k * np.pi / 2 - np.pi / 2
        way = np.array([np.cos(a), np.sin(a)])
        side = np.array([-way[1], way[0]])
        foot = (*(spread * way), 0.03)
        legs += [
            rod((*(0.5 * way), 0.66), foot, 0.034, 0.03),
            *(
                rod((*(0.48 * way + s * 0.2 * side), 0.38), (*(0.8 * way), 0.25), 0.02)
                for s in (-1, 1)
            ),
            *(
                rod((*(0.5 * way + s * 0.18 * side), 0.62), (*(0.7 * way), 0.4), 0.018)
                for s in (-1, 1)
            ),
        ]
        pads.append(
            turned(
                [(0, -0.03), (0.1, -0.03), (0.15, 0.02), (0.12, 0.03), (0, 0.02)],
                (*(spread * way), 0.0),
            )
        )
    ladder = [rod((x, -0.58, 0.66), (x, -spread + 0.06, 0.12), 0.013) for x in (-0.07, 0.07)] + [
        rod(
            (-0.08, -0.58 - (spread - 0.64) * f, 0.66 - 0.54 * f),
            (0.08, -0.58 - (spread - 0.64) * f, 0.66 - 0.54 * f),
            0.0125,
        )
        for f in np.linspace(0.05, 0.95, 7)
    ]
    ladder += [rod((0, -0.55 - 0.1, 0.6), (-0.08, -0.62, 0.62), 0.0125)]
    engine = [
        turned(
            [(0, 0.36), (0.1, 0.36), (0.13, 0.24), (0.22, 0.1), (0.2, 0.1), (0.1, 0.24), (0, 0.28)]
        )
    ]
    thrusters = both_sides(
        [
            rod((0.44, y, 0.94), (0.44, y + 0.1 * np.sign(y), 0.94), 0.025, 0.04)
            for y in (-0.14, 0.2)
        ]
        + [rod((0.36, 0.04, 1.0), (0.46, 0.04, 0.94), 0.05)]
    )
    thrusters += [
        rod((0.1, 0.1, 1.26), (0.22, 0.12, 1.44), 0.014),
        ball((0.11, 0.04, 0.11), (0.23, 0.12, 1.46), (20, 0, 30)),
    ]
    return {
        "descent stage": gold,
        "ascent stage": white,
        "windows": glass,
        "hatch": hatch,
        "legs": [*legs, *ladder],
        "pads": pads,
        "engine": [*engine, *thrusters],
    }


SPACECRAFT: dict[str, Callable[[Draw], Parts]] = {
    "space capsule": _space_capsule,
    "lunar lander": _lunar_lander,
}
