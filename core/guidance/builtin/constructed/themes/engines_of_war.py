"""Engines of war and of justice."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import wheel
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    circle,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _chariot(draw: Draw) -> Parts:
    turn = np.radians(np.linspace(-200, 20, 25))
    outer = [(0.42 * np.cos(a), 0.36 * np.sin(a)) for a in turn]
    inner = [(0.375 * np.cos(a), 0.315 * np.sin(a)) for a in turn[::-1]]
    body, gold = [], []
    for k in range(7):
        sweep = 3 * k
        a = np.array(
            [
                *outer[sweep // 2 : len(outer) - sweep // 2],
                *inner[sweep // 2 : len(inner) - sweep // 2],
            ]
        )
        body.append(plate(a, 0.09, (0, 0, 0.5 + 0.08 * k)))
    rim = [
        (0.4 * np.cos(a), 0.34 * np.sin(a), 1.06 - 0.46 * (abs(a + np.pi / 2) / 1.92) ** 1.4)
        for a in turn
    ]
    gold.append(pipe(rim[::3], 0.03))
    gold += [
        ball((0.06, 0.03, 0.06), (0, -0.375, 0.78)),
        *(
            rod((0, -0.37, 0.78), (0.17 * np.cos(a), -0.36, 0.78 + 0.17 * np.sin(a)), 0.018, 0.006)
            for a in np.arange(8) * np.pi / 4
        ),
    ]
    floor = [box((0.8, 0.62, 0.06), (0, 0.02, 0.46), 0.02)]
    wheels = both_sides(moved(wheel(0.42, 0.07, draw.which(2) * 2 + 8, 0.1), (0.56, 0.12, 0.42)))
    gold += both_sides([rod((0.56, 0.12, 0.42), (0.66, 0.12, 0.42), 0.05, 0.03, 0.01)])
    pole = [
        pipe(
            [(0, -0.2, 0.44), (0, -0.7, 0.42), (0, -1.2, 0.6), (0, -1.5, 0.78)],
            (0.045, 0.042, 0.036, 0.03),
        ),
        rod((-0.6, 0.12, 0.42), (0.6, 0.12, 0.42), 0.04),
    ]
    pole += [
        pipe(
            [
                (-0.5, -1.42, 0.66),
                (-0.3, -1.44, 0.8),
                (0, -1.45, 0.74),
                (0.3, -1.44, 0.8),
                (0.5, -1.42, 0.66),
            ],
            0.03,
        )
    ]
    gold += [ball(0.045, (0, -1.5, 0.8)), *both_sides([ball(0.04, (0.5, -1.42, 0.65))])]
    return {"body": [*body, *floor], "trim": gold, "wheels": wheels, "pole": pole}


def _guillotine(draw: Draw) -> Parts:
    up = draw(1.25, 1.6)
    frame = both_sides(
        [
            box((0.1, 0.14, 1.9), (0.26, 0, 1.0), 0.008),
            rod((0.26, 0.5, 0.16), (0.26, 0.05, 1.0), 0.035),
            box((0.1, 1.3, 0.1), (0.26, 0.28, 0.16), 0.01),
        ]
    )
    frame += [
        box((0.72, 0.16, 0.14), (0, 0, 1.96), 0.012),
        box((0.62, 0.12, 0.1), (0, -0.3, 0.16), 0.01),
        box((0.62, 0.12, 0.1), (0, 0.86, 0.16), 0.01),
    ]
    lunette = [
        plate(
            [(-0.22, 0), (0.22, 0), (0.22, 0.36), (-0.22, 0.36)],
            0.06,
            (0, -0.02, 0.42),
            FRONT,
            [circle(0.085, (0, 0.18))],
        )
    ]
    bench = [
        box((0.36, 1.0, 0.06), (0, 0.5, 0.5), 0.012),
        *both_sides([box((0.06, 0.06, 0.4), (0.12, y, 0.3), 0.006) for y in (0.14, 0.9)]),
        box((0.46, 0.08, 0.3), (0, 0.02, 0.3), 0.006),
    ]
    blade = [
        plate(
            [(-0.2, up + 0.16), (0.2, up + 0.16), (0.2, up - 0.1), (-0.2, up + 0.1 - 0.06)],
            0.035,
            (0, 0, 0),
            FRONT,
        )
    ]
    weight = [box((0.46, 0.1, 0.13), (0, 0, up + 0.18), 0.012)]
    rope = [
        rod((0, 0, up + 0.2), (0, 0, 1.96), 0.012),
        rod((0.34, 0.0, 1.98), (0.36, 0.02, 0.7), 0.012),
        rod((0, 0, 2.02), (0.345, 0, 2.02), 0.012),
        ball(0.04, (0.36, 0.02, 0.7)),
        rod((0.3, 0, 0.72), (0.37, 0.02, 0.72), 0.02),
    ]
    iron = [rod((-0.05, 0, 2.02), (0.05, 0, 2.02), 0.05), box((0.48, 0.02, 0.02), (0, -0.06, 0.42))]
    basket = [
        turned(
            [(0, 0.1), (0.17, 0.1), (0.22, 0.36), (0.19, 0.36), (0.15, 0.14), (0, 0.14)],
            (0, -0.34, 0.0),
        ),
        *(ring(0.175 + 0.015 * k, 0.016, (0, -0.34, 0.13 + 0.07 * k)) for k in range(4)),
    ]
    base = [box((0.9, 1.7, 0.12), (0, 0.24, 0.06), 0.012)]
    return {
        "frame": [*frame, *lunette, *bench],
        "blade": blade,
        "weight": [*weight, *iron],
        "rope": rope,
        "basket": basket,
        "platform": base,
    }


def _gallows(draw: Draw) -> Parts:
    high = draw(1.75, 1.95)
    wood = [
        box((0.13, 0.13, high), (-0.42, 0.1, high / 2 + 0.4), 0.012),
        box((1.1, 0.12, 0.12), (0.06, 0.1, high + 0.38), 0.012),
        rod((-0.42, 0.1, high - 0.1), (0.0, 0.1, high + 0.36), 0.045),
        *(rod((-0.42, 0.1 + s * 0.34, 0.52), (-0.42, 0.1, 0.95), 0.04) for s in (-1, 1)),
    ]
    deck = [box((0.16, 1.1, 0.06), (-0.6 + 0.17 * k, 0.06, 0.46), 0.008) for k in range(8)]
    deck += [
        box((0.1, 0.1, 0.46), (x, y, 0.23), 0.01) for x in (-0.6, 0.54) for y in (-0.4, 0.52)
    ] + [box((1.36, 0.07, 0.09), (0, y, 0.4), 0.008) for y in (-0.42, 0.54)]
    deck += [rod((-0.6, y, 0.06), (0.54, y, 0.38), 0.025) for y in (-0.42, 0.54)]
    steps = [
        box((0.42, 0.16, 0.05), (0.3, -0.56 - 0.14 * k, 0.38 - 0.09 * k), 0.006) for k in range(4)
    ] + [
        plate([(-0.48, 0.44), (-0.48, 0.36), (-1.04, 0.0), (-1.12, 0.0)], 0.05, (x, 0, 0), SIDE)
        for x in (0.1, 0.5)
    ]
    x = 0.42
    rope = [
        rod((x, 0.1, high + 0.36), (x, 0.1, high - 0.42), 0.022),
        rod((x, 0.1, high - 0.28), (x, 0.1, high - 0.42), 0.045, rim=0.01),
        *(ring(0.038, 0.014, (x, 0.1, high - 0.29 - 0.03 * k)) for k in range(5)),
        pipe(
            [
                (x, 0.1, high - 0.42),
                (x - 0.12, 0.1, high - 0.54),
                (x - 0.11, 0.1, high - 0.7),
                (x, 0.1, high - 0.77),
                (x + 0.11, 0.1, high - 0.7),
                (x + 0.12, 0.1, high - 0.54),
            ],
            0.022,
            closed=True,
        ),
        ring(0.085, 0.024, (x, 0.1, high + 0.38), "x"),
    ]
    return {"posts": wood, "deck": deck, "steps": steps, "rope": rope}


def _stocks(draw: Draw) -> Parts:
    high = draw(1.2, 1.4)
    holes = [circle(0.085), circle(0.05) + (0.27, 0), circle(0.05) - (0.27, 0)]
    wide, half = 0.5, 0.14

    boards = [
        plate(
            [(-wide, -half), (wide, -half), (wide, half), (-wide, half)],
            0.08,
            (0, 0, 1.0),
            FRONT,
            holes,
        )
    ]
    posts = both_sides(
        [
            box((0.12, 0.14, high), (0.5, 0, high / 2 + 0.05), 0.012),
            ball((0.075, 0.075, 0.05), (0.5, 0, high + 0.06)),
            rod((0.5, -0.36, 0.1), (0.5, -0.03, 0.6), 0.035),
            rod((0.5, 0.36, 0.1), (0.5, 0.03, 0.6), 0.035),
            box((0.13, 0.86, 0.1), (0.5, 0, 0.07), 0.012),
        ]
    )
    posts += [box((1.0, 0.1, 0.1), (0, 0, 0.42), 0.01)]
    iron = both_sides(
        [
            box((0.05, 0.1, 0.24), (0.41, 0, 1.0), 0.006),
            *(ball(0.018, (0.41, -0.05, 1.0 + z)) for z in (-0.08, 0.08)),
            ring(0.062, 0.015, (0.27, -0.04, 1.0), "y"),
        ]
    )
    iron += [
        box((0.09, 0.05, 0.1), (0.48, -0.09, 1.0), 0.012),
        pipe(
            [(0.455, -0.09, 1.04), (0.46, -0.09, 1.1), (0.5, -0.09, 1.1), (0.505, -0.09, 1.04)],
            0.014,
        ),
        ring(0.1, 0.015, (0, -0.04, 1.0), "y"),
        box((2 * wide - 0.2, 0.09, 0.012), (0, 0, 1.0 + half)),
    ]
    base = [box((0.9, 0.7, 0.07), (0, -0.1, 0.05), 0.012)]
    return {"boards": boards, "posts": [*posts, *base], "iron": iron}


def _gatling_gun(draw: Draw) -> Parts:
    count = 6 + 2 * draw.which(2)
    z = 0.66
    barrels = moved(spun([rod((0, -0.95, 0.085), (0, -0.12, 0.085), 0.03)], count, "y"), (0, 0, z))
    brass = [
        rod((0, -0.2, z), (0, 0.28, z), 0.16, rim=0.02),
        rod((0, 0.26, z), (0, 0.4, z), 0.12, 0.08, 0.02),
        *(rod((0, y - 0.03, z), (0, y + 0.03, z), 0.135, rim=0.008) for y in (-0.9, -0.55)),
        ball(0.05, (0, 0.43, z)),
    ]
    brass += [box((0.09, 0.16, 0.36), (0, 0.0, z + 0.3), 0.012)]
    iron = [
        rod((0.12, 0.14, z), (0.26, 0.14, z), 0.03),
        rod((0.24, 0.14, z + 0.02), (0.24, 0.14, z - 0.18), 0.022),
        rod((0.22, 0.14, z - 0.17), (0.34, 0.14, z - 0.17), 0.026),
        rod((-0.26, -0.02, z - 0.02), (0.26, -0.02, z - 0.02), 0.045),
    ]
    carriage = both_sides(
        [
            plate(
                [
                    (-0.22, 0.42),
                    (-0.14, 0.68),
                    (0.1, 0.68),
                    (0.3, 0.5),
                    (1.12, 0.08),
                    (1.12, 0.0),
                    (0.98, 0.0),
                    (0.2, 0.34),
                ],
                0.07,
                (0.19, 0, 0),
                SIDE,
            )
        ]
    )
    carriage += [box((0.36, 0.08, 0.1), (0, y, h), 0.01) for y, h in ((0.5, 0.28), (1.0, 0.06))] + [
        box((0.44, 0.12, 0.1), (0, -0.08, 0.44), 0.01),
        rod((-0.5, 0, 0.43), (0.5, 0, 0.43), 0.045),
    ]
    wheels = both_sides(moved(wheel(0.42, 0.075, 12, 0.11), (0.46, 0, 0.43)))
    return {"barrels": [*barrels, *iron], "casing": brass, "carriage": carriage, "wheels": wheels}


def _gun_turret(draw: Draw) -> Parts:
    tilt = Rotation.from_euler("x", -draw(4.0, 16.0), degrees=True).as_matrix()
    base = [
        rod((0, 0, 0), (0, 0, 0.12), 0.62, 0.58, 0.015),
        rod((0, 0, 0.1), (0, 0, 0.35), 0.46, 0.38, 0.015),
    ]
    bolts = spun([rod((0, -0.53, 0.1), (0, -0.53, 0.15), 0.04, rim=0.008)], 12)
    plan = np.array(
        [
            (-0.26, -0.46),
            (0.26, -0.46),
            (0.44, -0.2),
            (0.44, 0.3),
            (0.3, 0.48),
            (-0.3, 0.48),
            (-0.44, 0.3),
            (-0.44, -0.2),
        ]
    )
    armour = [
        plate(plan * g, 0.09, (0, 0, h))
        for g, h in ((1.0, 0.36), (1.0, 0.44), (0.94, 0.52), (0.84, 0.6))
    ]
    armour += both_sides(
        [
            box((0.1, 0.4, 0.26), (0.46, 0.04, 0.46), 0.03),
            rod((0.24, 0.26, 0.62), (0.24, 0.26, 0.68), 0.1, rim=0.01),
        ]
    )
    guns = [box((0.46, 0.16, 0.22), (0, -0.42, 0.47), 0.03)]
    tubes = []
    for x in (-0.13, 0.13):
        tubes += [
            rod((x, -0.1, 0), (x, -0.72, 0), 0.062),
            rod((x, -0.62, 0), (x, -0.82, 0), 0.075, rim=0.01),
            rod((x, -0.5, 0), (x, -1.2, 0), 0.04),
        ]
        tubes += placed(
            [turned([(0, 0), (0.06, 0), (0.06, 0.14), (0.03, 0.14), (0.03, 0.05), (0, 0.05)])],
            FRONT,
            (x, -1.16, 0),
        )
    guns += placed(tubes, tilt, (0, -0.36, 0.47))
    lamp = [
        ball((0.07, 0.04, 0.07), (0, -0.38, 0.62)),
        *both_sides([box((0.02, 0.2, 0.05), (0.512, 0.04, 0.48))]),
    ]
    sight = [
        box((0.14, 0.22, 0.12), (0, -0.28, 0.66), 0.02),
        rod((-0.3, 0.3, 0.6), (-0.3, 0.34, 1.1), 0.016),
    ]
    return {"armour": [*armour, *sight], "guns": guns, "base": base, "bolts": bolts, "lamps": lamp}


ENGINES_OF_WAR: dict[str, Callable[[Draw], Parts]] = {
    "chariot": _chariot,
    "guillotine": _guillotine,
    "gallows": _gallows,
    "stocks": _stocks,
    "gatling gun": _gatling_gun,
    "gun turret": _gun_turret,
}
