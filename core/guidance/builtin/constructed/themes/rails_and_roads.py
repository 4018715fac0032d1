"""A train, a coach and a stroller that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import wheel
from core.guidance.builtin.constructed.shapes import (
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
    turned,
)


def _train(draw: Draw) -> Parts:
    long, drivers = draw(1.15, 1.3), 2 + draw.which(2)
    z, r = 0.62, 0.27
    drum = [(0, -0.35), (r, -0.35), (r, long - 0.34), (r + 0.02, long - 0.33), (r + 0.02, long)]
    drum += [(r - 0.02, long + 0.02), (0.2, long + 0.03), (0.18, long + 0.06), (0, long + 0.06)]
    boiler = placed([turned(drum)], FRONT, (0, 0.28, z))
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
        box((0.08, 0.1, 0.1), (0, front + 0.02, z + r)),
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
    spokes = 10 + 2 * draw.which(3)
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
        angles = np.linspace(a - 0.03, b + 0.03, 5)
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


RAILS_AND_ROADS: dict[str, Callable[[Draw], Parts]] = {
    "train": _train,
    "stagecoach": _stagecoach,
    "baby stroller": _baby_stroller,
}
