"""Engines of siege."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import wheel
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    turned,
)


def _trebuchet(draw: Draw) -> Parts:
    frame = both_sides(
        [
            box((0.1, 2.0, 0.1), (0.42, 0, 0.2), 0.01),
            *(rod((0.42, y, 0.2), (0.34, 0.0, 1.4), 0.05) for y in (-0.75, 0.75)),
            rod((0.42, 0, 0.2), (0.35, 0, 1.4), 0.045),
            box((0.08, 0.9, 0.08), (0.385, 0, 0.7), 0.01),
        ]
    )
    frame += [box((0.94, 0.1, 0.1), (0, y, 0.2), 0.01) for y in (-0.9, -0.3, 0.3, 0.9)]
    frame += both_sides([rod((0.42, s * 0.3, 0.22), (0.36, 0, 0.95), 0.03) for s in (-1, 1)])
    tilt = Rotation.from_euler("x", draw(24.0, 36.0), degrees=True).as_matrix()
    pivot = np.array([0, 0, 1.42])
    arm = placed(
        [rod((0, -0.55, 0), (0, 1.55, 0), 0.075, 0.038), box((0.16, 0.24, 0.16), (0, 0, 0), 0.02)],
        tilt,
        pivot,
    )
    end = tilt @ (0, -0.52, 0) + pivot
    tip = tilt @ (0, 1.54, 0) + pivot
    weight = [
        box((0.5, 0.5, 0.46), (0, end[1], end[2] - 0.5), 0.02),
        *both_sides([box((0.05, 0.06, 0.4), (0.12, end[1], end[2] - 0.15), 0.006)]),
    ]
    iron = [box((0.53, 0.53, 0.05), (0, end[1], end[2] + z), 0.006) for z in (-0.66, -0.34)]
    iron += [
        rod((-0.52, 0, 1.42), (0.52, 0, 1.42), 0.05),
        rod((-0.2, *end[1:]), (0.2, *end[1:]), 0.035),
    ]
    iron += placed(
        [
            rod((0, y - 0.03, 0), (0, y + 0.03, 0), 0.075 - 0.022 * y, rim=0.006)
            for y in (0.5, 0.9, 1.25)
        ],
        tilt,
        pivot,
    )
    low = (0, tip[1] - 0.28, 0.62)
    sling = [
        rod(tuple(tip), low, 0.014),
        rod((0.05, *tip[1:]), (0.02, low[1], low[2]), 0.014),
        ball((0.1, 0.13, 0.07), (0, low[1], low[2] - 0.02)),
    ]
    stone = [ball(0.105, (0, low[1], low[2] + 0.03))]
    wheels = both_sides(
        [rod((0.47, y, 0.15), (0.58, y, 0.15), 0.16, rim=0.012) for y in (-0.72, 0.72)]
    )
    hubs = both_sides(
        [rod((0.4, y, 0.15), (0.62, y, 0.15), 0.045, rim=0.01) for y in (-0.72, 0.72)]
    )
    winch = [
        rod((-0.46, 0.62, 0.42), (0.46, 0.62, 0.42), 0.055),
        *both_sides(
            [
                rod((0.5, 0.62 - a, 0.42 - b), (0.5, 0.62 + a, 0.42 + b), 0.018)
                for a, b in ((0.18, 0.0), (0.0, 0.18))
            ]
        ),
        *both_sides(
            [
                box((0.05, 0.14, 0.3), (0.4, 0.62, 0.32), 0.01),
                rod((0.44, 0.62, 0.42), (0.53, 0.62, 0.42), 0.04),
            ]
        ),
    ]
    winch += [rod((0, 0.62, 0.46), tuple(tilt @ (0, 0.9, 0) + pivot), 0.013)]
    return {
        "frame": [*frame, *winch],
        "arm": arm,
        "counterweight": weight,
        "wheels": wheels,
        "iron": [*iron, *hubs],
        "sling": sling,
        "stone": stone,
    }


def _ballista(draw: Draw) -> Parts:
    tilt = Rotation.from_euler("x", -draw(8.0, 16.0), degrees=True).as_matrix()
    at = (0, 0, 0.72)
    stock = [
        box((0.14, 1.5, 0.1), (0, 0.1, 0), 0.012),
        *both_sides([box((0.04, 1.4, 0.05), (0.05, 0.05, 0.06), 0.006)]),
    ]
    stock += both_sides(
        [
            box((0.1, 0.14, 0.5), (0.26, -0.5, 0.06), 0.012),
            box((0.1, 0.14, 0.5), (0.1, -0.5, 0.06), 0.012),
        ]
    )
    stock += [box((0.66, 0.17, 0.08), (0, -0.5, z), 0.012) for z in (-0.17, 0.3)]
    ropes = both_sides(
        [
            rod((0.18, -0.5, -0.2), (0.18, -0.5, 0.33), 0.062, rim=0.01),
            *(ring(0.06, 0.016, (0.18, -0.5, z)) for z in (-0.06, 0.02, 0.1, 0.18)),
        ]
    )
    limbs = both_sides(
        [rod((0.16, -0.5, 0.06), (0.86, -0.2, 0.06), 0.045, 0.03), ball(0.04, (0.86, -0.2, 0.06))]
    )
    nock = (0, 0.42, 0.1)
    string = both_sides([rod((0.85, -0.2, 0.06), nock, 0.014)])
    bolt = [
        rod((0, 0.42, 0.11), (0, -0.86, 0.11), 0.026),
        box((0.13, 0.16, 0.014), (0, 0.32, 0.11)),
        box((0.014, 0.16, 0.13), (0, 0.32, 0.12)),
    ]
    tip = [
        rod((0, -0.82, 0.11), (0, -1.06, 0.11), 0.062, 0.004),
        rod((0, -0.78, 0.11), (0, -0.84, 0.11), 0.036),
    ]
    winch = [
        rod((-0.24, 0.76, 0.02), (0.24, 0.76, 0.02), 0.045),
        *both_sides(
            [
                rod((0.22, 0.76 - a, 0.02 - b), (0.22, 0.76 + a, 0.02 + b), 0.018)
                for a, b in ((0.15, 0.0), (0.0, 0.15))
            ]
        ),
        rod((0, 0.72, 0.04), nock, 0.013),
        box((0.08, 0.1, 0.07), (0, 0.44, 0.09), 0.012),
    ]
    base = [
        rod((0, 0, 0.1), (0, 0, 0.72), 0.07),
        *both_sides([rod((0.5, y, 0.05), (0.0, 0.0, 0.5), 0.045) for y in (-0.5, 0.5)]),
        *(box((1.1, 0.11, 0.1), (0, y, 0.06), 0.012) for y in (-0.5, 0.5)),
        box((0.11, 1.1, 0.1), (0, 0, 0.06), 0.012),
        box((0.2, 0.24, 0.14), (0, 0, 0.66), 0.02),
    ]
    return {
        "frame": [*base, *placed(stock, tilt, at)],
        "limbs": placed(limbs, tilt, at),
        "ropes": placed([*ropes, *string], tilt, at),
        "bolt": placed(bolt, tilt, at),
        "iron": placed([*tip, *winch], tilt, at),
    }


def _siege_tower(draw: Draw) -> Parts:
    floors = 3
    wood, hides, iron, ramp = [], [], [], []
    for k in range(floors):
        z, w = 0.3 + 0.5 * k, 0.46 - 0.05 * k
        wood += [
            box((0.07, 0.07, 0.54), (s * w, t * w, z + 0.25), 0.008)
            for s in (-1, 1)
            for t in (-1, 1)
        ]
        wood += [box((2 * w + 0.12, 2 * w + 0.12, 0.05), (0, 0, z), 0.008)]
        for j in range(4):
            way = Rotation.from_euler("z", 90 * j, degrees=True).as_matrix()
            count = 6
            planks = [
                box(
                    (2 * w / count - 0.008, 0.035, 0.5),
                    (-w + 2 * w * (m + 0.5) / count, -w, z + 0.25),
                    0.006,
                )
                for m in range(count)
                if not (k == floors - 1 and j == 0 and 1 <= m <= 4)
            ]
            if j == 1:
                planks = [
                    rod(
                        (-w, -w, z + 0.05 + 0.45 * (m % 2)),
                        (w, -w, z + 0.5 - 0.45 * (m % 2)),
                        0.026,
                    )
                    for m in range(2)
                ]
            wood += placed(planks, way)
            if j != 1 and k < floors - 1:
                hides += placed(
                    [
                        box(
                            (0.17, 0.05, 0.2 + 0.04 * (m % 2)),
                            (x, -w - 0.012, z + 0.3 - 0.03 * (m % 2)),
                            0.02,
                        )
                        for m, x in enumerate((-0.26, 0.0, 0.26))
                    ],
                    way,
                )
    top, w = 0.3 + 0.5 * floors, 0.46 - 0.05 * (floors - 1)
    wood += [box((2 * w + 0.16, 2 * w + 0.16, 0.06), (0, 0, top), 0.008)]
    for j in range(4):
        wood += placed(
            [
                box((0.13, 0.06, 0.2), (x, -w - 0.04, top + 0.1), 0.008)
                for x in (-0.3, -0.1, 0.1, 0.3)
            ],
            Rotation.from_euler("z", 90 * j, degrees=True).as_matrix(),
        )
    lean = Rotation.from_euler("x", draw(-30.0, -18.0), degrees=True).as_matrix()
    ramp += placed(
        [box((0.13, 0.62, 0.04), (x, -0.3, 0), 0.006) for x in (-0.21, -0.07, 0.07, 0.21)]
        + [box((0.56, 0.06, 0.06), (0, y, 0.0), 0.008) for y in (-0.12, -0.5)],
        lean,
        (0, -w, top - 0.46),
    )
    hook = lean @ (0.2, -0.5, 0.02) + np.array([0, -w, top - 0.46])
    iron += both_sides([rod(tuple(hook), (0.24, -w, top - 0.04), 0.013)])
    wheels = both_sides([rod((0.5, y, 0.2), (0.6, y, 0.2), 0.2, rim=0.014) for y in (-0.32, 0.32)])
    iron += both_sides(
        [
            turned(
                [(0.19, -0.04), (0.215, -0.04), (0.215, 0.04), (0.19, 0.04)], (0.55, y, 0.2), "x"
            )
            for y in (-0.32, 0.32)
        ]
    )
    iron += [rod((-0.64, y, 0.2), (0.64, y, 0.2), 0.045) for y in (-0.32, 0.32)]
    wood += [box((0.9, 0.12, 0.16), (0, y, 0.24), 0.01) for y in (-0.32, 0.32)]
    ladder = [rod((0.5 - 0.02, s * 0.1, 0.1), (0.36, s * 0.1, top), 0.02) for s in (-1, 1)]
    ladder += [
        rod(
            (0.48 - 0.12 * f, -0.1, 0.1 + f * (top - 0.1)),
            (0.48 - 0.12 * f, 0.1, 0.1 + f * (top - 0.1)),
            0.015,
        )
        for f in np.linspace(0.06, 0.95, 12)
    ]
    ladder += [box((0.1, 0.3, 0.05), (0.46, 0, 0.3), 0.01)]
    flag = [rod((0, 0.3, top), (0, 0.3, top + 0.62), 0.018), ball(0.026, (0, 0.3, top + 0.62))]
    banner = [
        plate(
            [(0, 0), (0.34, -0.02), (0.26, -0.11), (0.34, -0.2), (0, -0.22)],
            0.022,
            (0.0, 0.3, top + 0.6),
            FRONT,
        )
    ]
    return {
        "timber": [*wood, *ladder, *flag],
        "ramp": ramp,
        "hides": hides,
        "wheels": wheels,
        "iron": iron,
        "banner": banner,
    }


def _battering_ram(draw: Draw) -> Parts:
    long = draw(1.0, 1.15)
    frame = both_sides(
        [
            box((0.1, 1.5, 0.1), (0.4, 0, 0.3), 0.01),
            *(rod((0.4, y, 0.3), (0.03, y, 1.2), 0.045) for y in (-0.6, 0.0, 0.6)),
        ]
    )
    frame += [box((0.9, 0.1, 0.1), (0, y, 0.3), 0.01) for y in (-0.66, 0.66)] + [
        rod((0, -0.8, 1.18), (0, 0.8, 1.18), 0.045)
    ]
    roof = []
    for s in (-1, 1):
        way = Rotation.from_euler("y", s * 68, degrees=True).as_matrix()
        roof += placed(
            [
                box((0.16, 1.66, 0.03), (s * (0.1 + 0.13 * k), 0, 0.012 * (3 - k)), 0.006)
                for k in range(4)
            ],
            way,
            (0, 0, 1.24),
        )
    trunk = [rod((0, -long, 0.66), (0, 0.85, 0.66), 0.12, 0.1, 0.01)]
    head = [
        rod((0, -long + 0.02, 0.66), (0, -long - 0.12, 0.66), 0.15, 0.14, 0.02),
        ball((0.13, 0.16, 0.13), (0, -long - 0.12, 0.66)),
    ]
    for s in (-1, 1):
        curl = [
            (s * 0.1, -long - 0.06, 0.74),
            (s * 0.2, -long - 0.02, 0.78),
            (s * 0.25, -long + 0.04, 0.68),
            (s * 0.22, -long - 0.05, 0.58),
            (s * 0.16, -long - 0.13, 0.6),
        ]
        head.append(pipe(curl, (0.05, 0.05, 0.045, 0.035, 0.022)))
    head += [
        rod((0, y - 0.035, 0.66), (0, y + 0.035, 0.66), 0.128, rim=0.006) for y in (-0.6, 0.0, 0.6)
    ]
    chains = [rod((s * 0.1, y, 0.7), (0, y, 1.18), 0.016) for y in (-0.55, 0.55) for s in (-1, 1)]
    wheels = both_sides(
        [
            *moved(wheel(0.24, 0.08, 8, 0.2), (0.52, -0.5, 0.24)),
            *moved(wheel(0.24, 0.08, 8, 0.2), (0.52, 0.5, 0.24)),
        ]
    )
    axles = [rod((-0.5, y, 0.24), (0.5, y, 0.24), 0.04) for y in (-0.5, 0.5)]
    return {
        "frame": [*frame, *axles],
        "roof": roof,
        "ram": trunk,
        "head": head,
        "chains": chains,
        "wheels": wheels,
    }


SIEGE: dict[str, Callable[[Draw], Parts]] = {
    "trebuchet": _trebuchet,
    "ballista": _ballista,
    "siege tower": _siege_tower,
    "battering ram": _battering_ram,
}
