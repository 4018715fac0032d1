"""Trains, coaches, aircraft and a treehouse that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.redrawn_vehicles import wheel
from core.guidance.builtin.constructed.shapes import (
    FORWARD,
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
    ring,
    rod,
    rounded,
    spun,
    turned,
)



def _train(draw: Draw) -> Parts:
    long, drivers = draw(1.15, 1.3), 2 + draw.which(2)
    z, r = 0.62, 0.27
    drum = [(0, -0.35), (r, -0.35), (r, long - 0.34), (r + 0.02, long - 0.33), (r + 0.02, long)]
    drum += [(r - 0.02, long + 0.02), (0.2, long + 0.03), (0.18, long + 0.06), (0, long + 0.06)]
    boiler = placed([turned(drum)], FORWARD, (0, 0.28, z))
    front = 0.28 - long
    boiler += [
        rod((-0.05, front - 0.05, z), (0.05, front - 0.05, z), 0.03),
        ball(0.05, (0, front - 0.07, z)),
    ]
    boiler += [box((0.2, 0.5, 0.2), (0, -0.3, 0.3), 0.02)]
    boiler += both_sides([rod((0.14, y, 0.3), (0.25, y, 0.62), 0.03) for y in (-0.55, 0.0)])
    dome = [(0, 0), (0.12, 0), (0.115, 0.12), (0.09, 0.18), (0.04, 0.21), (0, 0.215)]
    boiler += [turned(dome, (0, -0.2, z + r - 0.03))]
    walls = [(-0.38, 0.26), (0.38, 0.26), (0.38, 0.95), (-0.38, 0.95)]
    hole = rounded((0.22, 0.26), 0.05)
    cab = both_sides(
        [
            plate(
                [
                    (0.24, 0.24),
                    (0.86, 0.24),
                    (0.86, 0.62),
                    (0.72, 0.62),
                    (0.72, 1.16),
                    (0.24, 1.16),
                ],
                0.045,
                (0.37, 0, 0),
                SIDE,
                [hole * (0.95, 0.9) + (0.48, 0.92)],
            )
        ]
    )
    cab += [
        plate(
            [*walls[:2], (0.38, 1.16), (-0.38, 1.16)],
            0.045,
            (0, 0.26, 0),
            FRONT,
            [rounded((0.17, 0.2), 0.04, (x, 1.0)) for x in (-0.24, 0.24)],
        )
    ]
    cab += [
        box((0.76, 0.66, 0.06), (0, 0.54, 0.27), 0.01),
        box((0.74, 0.05, 0.36), (0, 0.84, 0.44)),
    ]
    top = np.linspace(0.12 * np.pi, 0.88 * np.pi, 15)
    roof = [(0.5 * np.cos(a), 0.98 + 0.32 * np.sin(a)) for a in top]
    roof += [(0.93 * x, y - 0.05) for x, y in roof[::-1]]
    ceiling = [plate(roof, 0.84, (0, 0.52, 0), FRONT), box((0.8, 0.62, 0.05), (0, 0.52, 1.13))]
    stack = [
        (0, 0),
        (0.085, 0),
        (0.075, 0.06),
        (0.075, 0.24),
        (0.15, 0.4),
        (0.16, 0.44),
        (0.13, 0.48),
    ]
    stack += [(0.1, 0.47), (0.1, 0.4), (0, 0.38)]
    chimney = [
        turned(stack, (0, front + 0.2, z + r - 0.02)),
        rod((0, 0.0, z + r - 0.01), (0, 0.0, z + r + 0.1), 0.03),
    ]
    frame = [box((0.5, long + 0.95, 0.1), (0, 0.28 - long / 2 + 0.24, 0.24), 0.01)]
    frame += [
        box((0.86, 0.1, 0.16), (0, front - 0.1, 0.24), 0.015),
        box((0.8, 0.08, 0.12), (0, 0.92, 0.24), 0.01),
    ]
    frame += both_sides([box((0.1, 1.0, 0.03), (0.38, -0.3, 0.36), 0.008)])
    for x in np.linspace(-0.36, 0.36, 9):
        tip = front - 0.15 - 0.28 * (1 - abs(x) / 0.42)
        frame.append(rod((x, front - 0.12, 0.24), (0.9 * x, tip, 0.05), 0.02))
    rail = [(-0.34, front - 0.16, 0.05), (0.0, front - 0.45, 0.05), (0.34, front - 0.16, 0.05)]
    frame += [capsule(rail[0], rail[1], 0.024), capsule(rail[1], rail[2], 0.024)]
    frame += both_sides(
        [
            rod((0.3, front - 0.14, 0.3), (0.3, front - 0.24, 0.3), 0.03),
            rod((0.3, front - 0.22, 0.3), (0.3, front - 0.26, 0.3), 0.07, rim=0.01),
        ]
    )
    frame += both_sides(
        [
            rod((0.36, front + 0.04, 0.26), (0.36, front + 0.36, 0.26), 0.085, rim=0.015),
            box((0.14, 0.2, 0.1), (0.3, front + 0.2, 0.26)),
        ]
    )
    places = np.linspace(-0.12, 0.56, drivers)
    big = 0.24 if drivers == 2 else 0.2
    wheels = []
    for y in places:
        wheels += moved(wheel(big, 0.07, 10, 0.16), (0.3, y, big))
    for y in (front + 0.08, front + 0.36):
        wheels += moved(wheel(0.13, 0.06, 8, 0.2), (0.3, y, 0.13))
    crank = 0.05
    wheels += [
        box(
            (0.03, float(places[-1] - places[0]) + 0.1, 0.05),
            (0.365, float(places.mean()), big - crank),
            0.01,
        )
    ]
    wheels += [
        box(
            (0.025, float(places[0] - front) - 0.1, 0.04),
            (0.375, (float(places[0]) + front + 0.24) / 2, 0.235),
            0.008,
        )
    ]
    wheels += [rod((0.33, y, big - crank), (0.4, y, big - crank), 0.03) for y in places]
    axles = [rod((-0.31, y, big), (0.31, y, big), 0.03) for y in places]
    axles += [rod((-0.31, y, 0.14), (0.31, y, 0.14), 0.03) for y in (front + 0.08, front + 0.36)]
    lamp = [
        rod((0, front + 0.02, z + r + 0.08), (0, front - 0.08, z + r + 0.08), 0.075, 0.085, 0.012),
        box((0.08, 0.1, 0.1), (0, front + 0.02, z + r + 0.0)),
    ]
    bell = [(0, 0), (0.06, 0.0), (0.045, 0.04), (0.035, 0.08), (0, 0.1)]
    lamp += [
        turned(bell, (0, -0.48, z + r + 0.05)),
        rod((0, -0.48, z + r - 0.02), (0, -0.48, z + r + 0.06), 0.02),
    ]
    struts = [
        box((0.14, 0.12, 0.16), (0, y, 0.15))
        for y in (float(places[0]), float(places[-1]), front + 0.22)
    ]
    return {
        "boiler": boiler,
        "cab": cab,
        "chimney": chimney,
        "frame": [*frame, *axles, *struts, *ceiling],
        "wheels": both_sides(wheels),
        "lamp": lamp,
    }


def _stagecoach(draw: Draw) -> Parts:
    spokes = 12
    shell = [(-0.5, 0.62), (-0.3, 0.46), (0.3, 0.46), (0.5, 0.62), (0.56, 1.24), (-0.56, 1.24)]
    body = [plate(shell, 0.74, (0, 0, 0), SIDE)]
    body += both_sides([box((0.03, 0.34, 0.68), (0.372, 0, 0.85), 0.008)])
    body += [
        box((0.7, 0.34, 0.05), (0, -0.78, 0.98), 0.012),
        box((0.7, 0.06, 0.3), (0, -0.64, 1.12), 0.012),
    ]
    body += [
        plate(
            [
                (-0.98, 0.55),
                (-0.9, 0.5),
                (-0.52, 0.6),
                (-0.52, 0.72),
                (-0.66, 0.96),
                (-0.92, 0.96),
                (-0.72, 0.66),
            ],
            0.68,
            (0, 0, 0),
            SIDE,
        )
    ]
    body += [box((0.66, 0.34, 0.34), (0, 0.72, 0.68), 0.02)]
    roof = [box((0.86, 1.28, 0.07), (0, 0, 1.27), 0.03), box((0.7, 1.1, 0.05), (0, 0, 1.31), 0.02)]
    windows = both_sides(
        [
            box((0.04, 0.22, 0.3), (0.375, 0, 1.02), 0.01),
            *(box((0.02, 0.2, 0.28), (0.366, y, 1.04), 0.008) for y in (-0.34, 0.34)),
        ]
    )
    wheels = []
    for y, radius in ((-0.72, 0.38), (0.72, 0.48)):
        wheels += moved(wheel(radius, 0.075, spokes), (0.52, y, radius))
    trim = both_sides(
        [
            *(box((0.035, 0.03, 0.74), (0.378, y, 0.86), 0.006) for y in (-0.19, 0.19)),
            *(box((0.035, 0.98, 0.03), (0.372, 0, z), 0.006) for z in (0.66, 1.2)),
            rod((0.385, 0.13, 0.8), (0.42, 0.13, 0.8), 0.018),
            ring(0.05, 0.014, (0.39, 0, 0.72), "x"),
        ]
    )
    under = [box((0.1, 1.6, 0.1), (0, 0, 0.38), 0.01)]
    for y, radius in ((-0.72, 0.38), (0.72, 0.48)):
        under.append(rod((-0.56, y, radius), (0.56, y, radius), 0.035))
        arc = [(y - 0.26, 0.64), (y - 0.12, 0.54), (y, 0.5), (y + 0.12, 0.54), (y + 0.26, 0.64)]
        under += both_sides([pipe([(0.27, a, b) for a, b in arc], 0.026)])
        under += both_sides([box((0.07, 0.08, 0.2), (0.27, y, 0.45))])
    under += both_sides(
        [
            pipe(
                [(0.27, -0.46, 0.62), (0.27, -0.3, 0.5), (0.27, 0.3, 0.5), (0.27, 0.46, 0.62)],
                0.026,
            )
        ]
    )
    pole = [(0, -0.4, 0.38), (0, -1.1, 0.36), (0, -1.5, 0.42)]
    under += [pipe(pole, 0.034), capsule((-0.28, -1.36, 0.4), (0.28, -1.36, 0.4), 0.024)]
    lamps = both_sides(
        [
            rod((0.4, -0.56, 1.06), (0.4, -0.56, 1.22), 0.05, rim=0.01),
            rod((0.4, -0.56, 1.2), (0.4, -0.56, 1.29), 0.06, 0.0),
            box((0.12, 0.04, 0.04), (0.37, -0.54, 1.14)),
        ]
    )
    rack = [capsule((0.32, y, 1.44), (-0.32, y, 1.44), 0.016) for y in (-0.5, 0.5)]
    rack += both_sides(
        [
            capsule((0.32, -0.5, 1.44), (0.32, 0.5, 1.44), 0.016),
            *(rod((0.32, y, 1.32), (0.32, y, 1.44), 0.014) for y in (-0.5, 0, 0.5)),
        ]
    )
    luggage = [
        box((0.5, 0.34, 0.22), (0.02, 0.22, 1.44), 0.025),
        box((0.36, 0.3, 0.18), (-0.08, -0.22, 1.42), 0.03),
    ]
    luggage += [
        box((0.3, 0.24, 0.14), (0.04, 0.2, 1.61), 0.03),
        box((0.58, 0.24, 0.3), (0, 0.98, 0.68), 0.02),
    ]
    luggage += [rod((x, 0.22, 1.33), (x, 0.22, 1.33 + 0.235), 0.02) for x in (0.0,)]
    return {
        "body": body,
        "roof": roof,
        "windows": windows,
        "wheels": both_sides(wheels),
        "frame": [*trim, *under, *lamps, *rack],
        "luggage": luggage,
    }


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
    back = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    body = placed([turned(tube)], back)
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
        pods += placed([turned(cowl)], back, (x, y, z))
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
    loop = [
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
    outer = np.array(loop)
    middle = np.array([0.0, 0.235])
    inner = (outer - middle) * (0.955, 0.83) + middle
    tracks = [plate(outer, 0.26, (0.44, 0, 0), SIDE, [inner])]
    ends = [*outer, outer[0]]
    for a, b in zip(ends[:-1], ends[1:], strict=True):
        way2, steps = b - a, max(int(np.linalg.norm(b - a) / 0.085), 1)
        turn = np.degrees(np.arctan2(way2[1], way2[0]))
        for f in (np.arange(steps) + 0.5) / steps:
            y, z = a + f * way2
            tracks.append(box((0.28, 0.045, 0.045), (0.44, y, z), 0.008, (turn, 0, 0)))
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


def _baby_stroller(draw: Draw) -> Parts:
    tilt, spokes = draw(-6.0, 6.0), 8
    turn = np.radians(np.linspace(180, 350, 27))
    basin = [(0.44 * np.cos(a) + 0.02, 0.7 + 0.34 * np.sin(a)) for a in turn]
    tub = [plate([*basin, (0.46, 0.7), (-0.42, 0.7)], 0.5, (0, 0, 0), SIDE)]
    tub += [
        plate(
            [(-0.5, 0.64), (0.1, 0.68), (0.48, 0.66), (0.48, 0.71), (-0.52, 0.71)],
            0.54,
            (0, 0, 0),
            SIDE,
        )
    ]
    hood = []
    for k in range(5):
        a, b = (np.radians(24 + 24 * n + tilt) for n in (k, k + 1))
        angles = np.linspace(a, b, 5)
        r = 0.5
        fan = [(r * np.cos(x), r * np.sin(x)) for x in angles]
        fan += [((r - 0.035) * np.cos(x), (r - 0.035) * np.sin(x)) for x in angles[::-1]]
        hood.append(plate(fan, 0.55, (0, 0.04, 0.7), SIDE))
        side = [(0, 0), *fan[:5]]
        hood += both_sides([plate(side, 0.035, (0.262, 0.04, 0.7), SIDE)])
        edge = (0.04 + r * np.cos(a), 0.7 + r * np.sin(a))
        hood.append(capsule((-0.27, *edge), (0.27, *edge), 0.028))
    pillow = [
        ball((0.2, 0.16, 0.07), (0, 0.26, 0.74), (20, 0, 0)),
        box((0.42, 0.5, 0.08), (0, -0.2, 0.715), 0.035),
    ]
    frame = both_sides(
        [
            pipe([(0.27, 0.1, 0.46), (0.28, 0.46, 0.78), (0.28, 0.78, 1.02)], 0.022),
            pipe([(0.24, 0.42, 0.2), (0.24, 0.1, 0.42), (0.24, -0.36, 0.66)], 0.024),
            pipe([(0.24, -0.42, 0.2), (0.24, 0.0, 0.4), (0.24, 0.36, 0.5)], 0.024),
        ]
    )
    grip = [capsule((-0.29, 0.78, 1.02), (0.29, 0.78, 1.02), 0.034)]
    frame += [rod((-0.36, y, 0.21), (0.36, y, 0.21), 0.024) for y in (-0.42, 0.42)]
    wheels, tyres = [], []
    for y in (-0.42, 0.42):
        tyres += [ring(0.185, 0.026, (0.35, y, 0.21), "x")]
        wheels += moved(wheel(0.17, 0.03, spokes, 0.1), (0.35, y, 0.21))
    basket = [
        box((0.44, 0.62, 0.03), (0, 0, 0.27), 0.01),
        *both_sides([rod((0.2, y, 0.26), (0.24, y, 0.4), 0.016) for y in (-0.24, 0.24)]),
    ]
    return {
        "body": tub,
        "hood": hood,
        "bedding": pillow,
        "frame": [*frame, *basket, *both_sides(wheels)],
        "grip": grip,
        "tyres": both_sides(tyres),
    }


REDRAWN_RAILS_AND_ROADS: dict[str, Callable[[Draw], Parts]] = {
    "train": _train,
    "stagecoach": _stagecoach,
    "treehouse": _treehouse,
    "airplane": _airplane,
    "tank": _tank,
    "baby stroller": _baby_stroller,
}
