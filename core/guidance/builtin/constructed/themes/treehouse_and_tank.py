"""A treehouse, an airplane and a tank that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import track
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    moved,
    pipe,
    placed,
    plate,
    rod,
    spun,
    turned,
)


def _treehouse(draw: Draw) -> Parts:
    sway = draw(-0.06, 0.06)
    trunk = [
        pipe(
            [(0, 0.1, -0.05), (0.02, 0.08, 0.4), (sway, 0.12, 0.9), (sway, 0.16, 1.7)],
            (0.2, 0.155, 0.15, 0.1),
        )
    ]
    for k in range(6):
        a = 2 * np.pi * k / 6 + 0.4
        trunk.append(
            capsule(
                (0.42 * np.cos(a), 0.1 + 0.42 * np.sin(a), 0.0),
                (0.1 * np.cos(a), 0.1 + 0.1 * np.sin(a), 0.2),
                0.05,
                0.1,
            )
        )
    for x, y, z in ((-0.52, 0.28, 1.75), (0.55, 0.3, 1.65), (0.1, 0.6, 1.6), (-0.1, 0.1, 2.0)):
        trunk.append(
            pipe(
                [(sway, 0.13, 1.05), (0.45 * x, 0.13 + 0.4 * (y - 0.13), 1.3), (x, y, z)],
                (0.09, 0.07, 0.04),
            )
        )
    balls = [
        (-0.55, 0.3, 1.8, 0.36),
        (0.58, 0.32, 1.72, 0.38),
        (0.1, 0.62, 1.7, 0.4),
        (-0.05, 0.12, 2.1, 0.42),
    ]
    balls += [
        (0.35, 0.12, 1.98, 0.32),
        (-0.38, 0.05, 2.0, 0.3),
        (-0.3, 0.62, 1.86, 0.32),
        (0.42, 0.56, 1.98, 0.3),
        (0.05, 0.4, 2.28, 0.32),
    ]
    leaves = [ball((r * 1.06, r * 1.06, 0.86 * r), (x, y, z)) for x, y, z, r in balls]
    base, depth = 0.86, -0.16
    floor = [
        box((0.17, 1.2, 0.045), (x, depth + 0.06, base), 0.008) for x in np.linspace(-0.52, 0.52, 7)
    ]
    floor += [box((1.16, 0.08, 0.08), (0, y, base - 0.05), 0.008) for y in (-0.6, 0.0, 0.5)]
    floor += [
        rod((x, y, base - 0.05), (0.25 * x, 0.1, 0.42), 0.035)
        for x, y in ((-0.5, -0.56), (0.5, -0.56), (-0.5, 0.46), (0.5, 0.46))
    ]
    rail = both_sides([rod((0.55, y, base), (0.55, y, base + 0.3), 0.024) for y in (-0.68, -0.36)])
    rail += both_sides(
        [
            rod((0.55, -0.7, base + 0.28), (0.55, -0.34, base + 0.28), 0.02),
            rod((0.55, -0.7, base + 0.15), (0.55, -0.34, base + 0.15), 0.016),
        ]
    )
    rail += [rod((x, -0.7, base), (x, -0.7, base + 0.3), 0.024) for x in (-0.55, -0.2, 0.2, 0.55)]
    rail += both_sides(
        [
            rod((0.2, -0.7, z), (0.56, -0.7, z), t)
            for z, t in ((base + 0.28, 0.02), (base + 0.15, 0.016))
        ]
    )
    ladder = both_sides([rod((0.13, -1.0, -0.05), (0.13, -0.68, base + 0.16), 0.026)])
    ladder += [
        rod(
            (-0.14, -1.0 + 0.32 * f, -0.05 + (base + 0.2) * f),
            (0.14, -1.0 + 0.32 * f, -0.05 + (base + 0.2) * f),
            0.02,
        )
        for f in np.linspace(0.12, 0.85, 7)
    ]
    house = [
        (-0.38, base),
        (0.38, base),
        (0.38, base + 0.44),
        (0, base + 0.74),
        (-0.38, base + 0.44),
    ]
    walls = [plate(house, 0.62, (0, 0.03, 0), FRONT)]
    walls += both_sides(
        [box((0.05, 0.05, 0.46), (0.375, y, base + 0.22), 0.008) for y in (-0.27, 0.33)]
    )
    roof = []
    for side in (-1, 1):
        slope = Rotation.from_euler("y", side * 38, degrees=True).as_matrix()
        boards = [
            box((0.16, 0.86, 0.04), (side * (0.04 + 0.145 * k), 0, 0.012 * (4 - k)), 0.006)
            for k in range(4)
        ]
        roof += placed(boards, slope, (0, 0.03, base + 0.73))
    roof += [rod((0, -0.4, base + 0.78), (0, 0.46, base + 0.78), 0.03)]
    door = [
        box((0.2, 0.04, 0.34), (-0.17, -0.29, base + 0.19), 0.01),
        ball(0.02, (-0.1, -0.315, base + 0.18)),
    ]
    swing = [rod((x, 0.3, 0.3), (x + 0.02, 0.3, 1.56), 0.012) for x in (0.56, 0.76)]
    swing += [box((0.27, 0.1, 0.03), (0.66, 0.3, 0.3), 0.006)]
    return {
        "trunk": trunk,
        "leaves": leaves,
        "walls": walls,
        "roof": roof,
        "floor": [*floor, *rail, *ladder, *swing],
        "door": door,
    }


def _airplane(draw: Draw) -> Parts:
    span, engines = draw(1.22, 1.36), 1 + draw.which(2)
    tube = [(0, -1.3), (0.06, -1.28), (0.12, -1.2), (0.165, -1.02), (0.175, -0.8), (0.175, 0.5)]
    tube += [(0.15, 0.8), (0.1, 1.1), (0.04, 1.32), (0, 1.33)]
    body = placed([turned(tube)], BACKWARD)
    body += [ball((0.2, 0.36, 0.11), (0, 0.02, -0.1))]
    wing = [(0.08, -0.36), (0.3, -0.22), (span, 0.42), (span, 0.54), (0.42, 0.28), (0.08, 0.3)]
    rise = Rotation.from_euler("y", -5, degrees=True).as_matrix()
    tip = [(0.4, 0.0), (0.54, 0.0), (0.62, 0.2), (0.55, 0.2)]
    half = [plate(wing, 0.04, (0, 0, 0)), plate(tip, 0.024, (span - 0.01, 0.01, 0.0), SIDE)]
    flaps = [box((0.05, 0.3, 0.06), (x, 0.28 + 0.2 * (x - 0.4), -0.03), 0.02) for x in (0.4, 0.72)]
    wings = placed([*half, *flaps], rise, (0, 0.0, -0.1))
    pods = []
    for k in range(engines):
        x = 0.42 + 0.36 * k
        y, z = -0.28 + 0.52 * (x - 0.3), -0.24 + 0.08 * (x - 0.3)
        cowl = [
            (0, -0.16),
            (0.06, -0.17),
            (0.08, -0.21),
            (0.1, -0.2),
            (0.115, -0.12),
            (0.115, 0.06),
            (0.075, 0.24),
            (0.04, 0.27),
            (0.03, 0.34),
            (0, 0.35),
        ]
        pods += placed([turned(cowl)], BACKWARD, (x, y, z))
        pods += [
            plate(
                [
                    (y - 0.1, z + 0.06),
                    (y + 0.3, z + 0.03),
                    (y + 0.36, z + 0.14),
                    (y + 0.08, z + 0.15),
                ],
                0.035,
                (x, 0, 0),
                SIDE,
            )
        ]
        fan = spun([box((0.02, 0.012, 0.075), (0, 0, 0.04))], 8, "y")
        pods += moved([*fan, rod((0, 0.03, 0), (0, -0.06, 0), 0.03, 0.0)], (x, y - 0.165, z))
    fin = [(0.72, 0.1), (1.08, 0.62), (1.3, 0.62), (1.24, 0.06)]
    stab = [(0.02, 0.98), (0.46, 1.24), (0.46, 1.34), (0.02, 1.26)]
    tail = [
        plate(fin, 0.04, (0, 0, 0), SIDE),
        *both_sides(placed([plate(stab, 0.032)], rise, (0, 0, 0.05))),
    ]
    return {
        "body": body,
        "wings": both_sides(wings),
        "engines": both_sides(pods),
        "tail": tail,
    }


def _tank(draw: Draw) -> Parts:
    long, tilt = draw(0.95, 1.1), draw(0.02, 0.1)
    shell = [
        (-0.86, 0.3),
        (-0.72, 0.18),
        (0.74, 0.18),
        (0.86, 0.34),
        (0.84, 0.5),
        (-0.46, 0.52),
        (-0.86, 0.38),
    ]
    hull = [plate(shell, 0.66, (0, 0, 0), SIDE)]
    guard = [
        (-0.92, 0.4),
        (-0.82, 0.5),
        (0.86, 0.5),
        (0.92, 0.42),
        (0.92, 0.46),
        (0.88, 0.53),
        (-0.84, 0.53),
        (-0.94, 0.43),
    ]
    hull += both_sides([plate(guard, 0.28, (0.43, 0, 0), SIDE)])
    hull += both_sides([box((0.2, 0.24, 0.1), (0.44, y, 0.56), 0.012) for y in (0.1, 0.38)])
    hull += [
        box((0.5, 0.3, 0.05), (0, 0.62, 0.53), 0.01),
        rod((-0.16, -0.42, 0.5), (-0.16, -0.42, 0.54), 0.09, rim=0.01),
    ]
    hull += both_sides(
        [
            rod((0.28, -0.72, 0.44), (0.28, -0.8, 0.44), 0.045, rim=0.01),
            rod((0.24, 0.84, 0.42), (0.24, 0.98, 0.42), 0.05, rim=0.01),
        ]
    )
    plan = [
        (-0.2, -0.42),
        (0.2, -0.42),
        (0.36, -0.12),
        (0.36, 0.26),
        (0.24, 0.44),
        (-0.24, 0.44),
        (-0.36, 0.26),
        (-0.36, -0.12),
    ]
    turret = [
        plate(np.array(plan) * grow, 0.07, (0, 0.02, z))
        for grow, z in ((1.0, 0.56), (1.0, 0.61), (0.95, 0.66), (0.88, 0.71))
    ]
    turret += [
        rod((0.14, 0.1, 0.72), (0.14, 0.1, 0.8), 0.11, 0.1, 0.012),
        rod((0.14, 0.1, 0.78), (0.14, 0.1, 0.825), 0.085, rim=0.01),
    ]
    turret += [
        rod((-0.14, 0.14, 0.72), (-0.14, 0.14, 0.76), 0.09, rim=0.01),
        box((0.5, 0.16, 0.12), (0, 0.5, 0.62), 0.02),
    ]
    turret += [
        rod((-0.22, 0.36, 0.7), (-0.22, 0.38, 1.2), 0.012),
        box((0.08, 0.06, 0.06), (-0.14, -0.16, 0.76), 0.01),
    ]
    start = np.array([0.0, -0.34, 0.63])
    way = np.array([0.0, -1.0, tilt])
    gun = [
        box((0.24, 0.2, 0.17), tuple(start), 0.03),
        rod(tuple(start), tuple(start + long * way), 0.05, 0.042),
    ]
    gun += [
        rod(tuple(start + (long - 0.06) * way), tuple(start + (long + 0.1) * way), 0.068, rim=0.012)
    ]
    gun += [
        rod(tuple(start + 0.42 * long * way), tuple(start + 0.58 * long * way), 0.062, rim=0.012)
    ]
    gun += [
        rod((0.14, 0.02, 0.84), (0.14, -0.3, 0.86), 0.018),
        box((0.05, 0.16, 0.05), (0.14, 0.06, 0.84), 0.01),
    ]
    loop = np.array(
        [
            (-0.62, 0.03),
            (0.6, 0.03),
            (0.84, 0.17),
            (0.93, 0.3),
            (0.86, 0.43),
            (0.6, 0.44),
            (-0.6, 0.44),
            (-0.86, 0.43),
            (-0.95, 0.32),
            (-0.88, 0.2),
        ]
    )
    middle = (0.0, 0.235)
    tracks = track(loop, (loop - middle) * (0.955, 0.83) + middle, 0.44, 0.26, (0.28, 0.045, 0.045))
    wheels = [
        rod((0.32, y, 0.17), (0.585, y, 0.17), 0.115, rim=0.012)
        for y in np.linspace(-0.56, 0.56, 5)
    ]
    wheels += [rod((0.32, y, 0.3), (0.58, y, 0.3), 0.1, rim=0.012) for y in (-0.8, 0.8)]
    wheels += [
        rod((0.57, y, 0.17), (0.605, y, 0.17), 0.04, rim=0.008) for y in np.linspace(-0.56, 0.56, 5)
    ]
    wheels += [rod((0.28, y, 0.3), (0.36, y, 0.3), 0.05) for y in (-0.8, 0.8)]
    wheels += [rod((0.2, y, 0.22), (0.36, y, 0.18), 0.04) for y in np.linspace(-0.56, 0.56, 5)]
    return {
        "hull": hull,
        "turret": turret,
        "gun": gun,
        "tracks": both_sides(tracks),
        "wheels": both_sides(wheels),
    }


TREEHOUSE_AND_TANK: dict[str, Callable[[Draw], Parts]] = {
    "treehouse": _treehouse,
    "airplane": _airplane,
    "tank": _tank,
}
