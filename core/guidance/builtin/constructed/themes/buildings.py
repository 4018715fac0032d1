"""Buildings that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    Place,
    ball,
    both_sides,
    box,
    moved,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _battlements(start: Place, end: Place, size: float, count: int) -> list[Primitive]:
    """A row of so many merlons from one place to another, on their foot's level."""
    first, last = np.array(start, float), np.array(end, float)
    turn = np.degrees(np.arctan2(last[1] - first[1], last[0] - first[0]))
    places = [first + f * (last - first) for f in (np.arange(count) + 0.5) / count]
    wide = 0.58 * float(np.linalg.norm(last - first)) / count
    return [
        box((wide, size, 1.4 * size), at + (0, 0, 0.7 * size - 0.01), 0.006, (0, 0, turn))
        for at in places
    ]


def _tower(radius: float, high: float, at: Place) -> tuple[list[Primitive], list[Primitive]]:
    """A round tower with a parapet on corbels, and its roof."""
    r = radius
    profile = [(0, -0.02), (1.16 * r, -0.02), (1.16 * r, 0.05), (1.02 * r, 0.12), (r, high - 0.12)]
    profile += [(1.2 * r, high - 0.04), (1.2 * r, high + 0.05), (0, high + 0.05)]
    merlon = box((0.4 * r, 0.26 * r, 0.09), (0, -1.09 * r, high + 0.085), 0.006)
    wall = [turned(profile), *spun([merlon], 9)]
    cone = [
        (0, high + 0.04),
        (1.02 * r, high + 0.04),
        (1.08 * r, high + 0.1),
        (0.5 * r, high + 0.1 + 1.5 * r),
    ]
    cone += [(0.03 * r, high + 0.1 + 3.0 * r), (0, high + 0.1 + 3.0 * r)]
    top = high + 0.1 + 3.0 * r
    flag = plate([(0, 0), (0.9 * r, -0.22 * r), (0, -0.5 * r)], 0.02, (0.0, 0, top + 0.17), FRONT)
    roof = [
        turned(cone),
        rod((0, 0, top - 0.06), (0, 0, top + 0.19), 0.014),
        flag,
        ball(0.024, (0, 0, top + 0.19)),
    ]
    return moved(wall, at), moved(roof, at)


def _castle(draw: Draw) -> Parts:
    half, high = 0.8, draw(0.5, 0.6)
    walls, roof = [], []
    for k in range(4):
        way = Rotation.from_euler("z", 90 * k, degrees=True).as_matrix()
        side = [
            box((2 * half, 0.14, high), (0, -half, high / 2), 0.004),
            box((2 * half, 0.2, 0.05), (0, -half - 0.02, high - 0.02), 0.004),
        ]
        side += _battlements(
            (-half + 0.16, -half - 0.07, high), (half - 0.16, -half - 0.07, high), 0.06, 9
        )
        if k == 0:
            side[:2] = [
                plate(
                    [
                        (-half, 0),
                        (-0.16, 0),
                        (-0.16, 0.2),
                        (0.16, 0.2),
                        (0.16, 0),
                        (half, 0),
                        (half, high),
                        (-half, high),
                    ],
                    0.14,
                    (0, -half, 0),
                    FRONT,
                ),
                side[1],
            ]
        walls += placed(side, way)
        tall = high + (draw(0.22, 0.4) if k % 2 else 0.24)
        own, cap = _tower(0.2, tall, way @ (half, -half, 0))
        walls += own
        roof += cap
    gate = [
        plate(
            [
                (-0.36, 0),
                (-0.17, 0),
                *((0.17 * np.cos(a), 0.22 + 0.17 * np.sin(a)) for a in np.linspace(np.pi, 0, 13)),
                (0.17, 0),
                (0.36, 0),
                (0.36, high + 0.14),
                (-0.36, high + 0.14),
            ],
            0.36,
            (0, -half - 0.06, 0),
            FRONT,
        )
    ]
    gate += _battlements(
        (-0.36, -half - 0.21, high + 0.13), (0.36, -half - 0.21, high + 0.13), 0.06, 5
    )
    gate += _battlements(
        (-0.36, -half + 0.09, high + 0.13), (0.36, -half + 0.09, high + 0.13), 0.06, 5
    )
    gate += both_sides(
        [
            rod((0.36, -half - 0.22, -0.01), (0.36, -half - 0.22, high + 0.24), 0.11),
            rod((0.36, -half - 0.22, high + 0.2), (0.36, -half - 0.22, high + 0.3), 0.13, rim=0.01),
        ]
    )
    roof += both_sides(
        [rod((0.36, -half - 0.22, high + 0.29), (0.36, -half - 0.22, high + 0.62), 0.14, 0.005)]
    )
    keep = [
        box((0.7, 0.6, 1.05), (0, 0.2, 0.52), 0.006),
        box((0.78, 0.68, 0.07), (0, 0.2, 1.03), 0.006),
    ]
    for a, b in (
        ((-0.38, -0.12), (0.38, -0.12)),
        ((0.38, 0.52), (-0.38, 0.52)),
        ((0.37, -0.12), (0.37, 0.52)),
        ((-0.37, 0.52), (-0.37, -0.12)),
    ):
        keep += _battlements((*a, 1.06), (*b, 1.06), 0.05, 5)
    hall = [(-0.3, 1.04), (0.3, 1.04), (0, 1.42)]
    roof += [plate(hall, 0.5, (0, 0.2, 0), FRONT)]
    for x, y, tall in ((0.33, 0.48, 1.35), (-0.33, -0.08, 1.2)):
        own, cap = _tower(0.14, tall, (x, y, 0))
        walls += own
        roof += cap
    ground = box((2 * half + 0.1, 2 * half + 0.1, 0.05), (0, 0, 0.0), 0.01)
    bars = [
        rod((x, -half - 0.1, 0.02), (x, -half - 0.1, 0.37), 0.014)
        for x in np.linspace(-0.13, 0.13, 5)
    ]
    bars += [rod((-0.18, -half - 0.1, z), (0.18, -half - 0.1, z), 0.012) for z in (0.1, 0.19, 0.28)]
    door = [box((0.33, 0.03, 0.39), (0, -half + 0.02, 0.2)), *bars]
    bridge = [box((0.36, 0.44, 0.035), (0, -half - 0.42, 0.015), 0.006)]
    bridge += both_sides([rod((0.16, -half - 0.6, 0.03), (0.2, -half - 0.2, 0.42), 0.012)])
    return {"walls": [*walls, *gate, *keep, ground], "roof": roof, "door": [*door, *bridge]}


def _windmill(draw: Draw) -> Parts:
    wide, sides = draw(0.4, 0.46), 8
    turn = np.arange(sides) * 2 * np.pi / sides + np.pi / sides
    base = [
        plate(np.stack([r * np.cos(turn), r * np.sin(turn)], 1), 0.09, (0, 0, z))
        for r, z in (
            (wide + 0.1, 0.04),
            (wide + 0.06, 0.12),
            (wide + 0.04, 0.2),
            (wide + 0.02, 0.28),
            (wide + 0.01, 0.36),
        )
    ]
    walls = [
        rod((0, 0, 0.36), (0, 0, 1.3), wide, 0.26),
        rod((0, 0, 1.27), (0, 0, 1.34), 0.3, 0.3, 0.01),
    ]
    gallery = [(wide - 0.1, 0.42), (wide + 0.2, 0.42), (wide + 0.2, 0.46), (wide - 0.1, 0.46)]
    spars = [turned(gallery), ring(wide + 0.18, 0.016, (0, 0, 0.62))]
    spars += spun([rod((0, wide + 0.18, 0.45), (0, wide + 0.18, 0.62), 0.014)], 16)
    spars += spun([rod((0, wide - 0.06, 0.22), (0, wide + 0.16, 0.43), 0.022)], 8)
    cap = [(0, 1.3), (0.32, 1.3), (0.33, 1.36), (0.28, 1.5), (0.18, 1.62), (0, 1.68)]
    roof = [turned(cap), box((0.2, 0.34, 0.2), (0, -0.2, 1.42), 0.05)]
    hub = (0, -0.46, 1.44)
    reach = draw(0.92, 1.0)
    arm = [box((0.045, 0.045, reach), (0, 0, reach / 2), 0.008)]
    lattice = [
        box((0.018, 0.02, 0.7 * reach), (x, -0.01, 0.6 * reach)) for x in (0.09, 0.165, 0.24)
    ]
    lattice += [
        box((0.3, 0.02, 0.018), (0.11, -0.01, z)) for z in np.linspace(0.26, 0.94, 8) * reach
    ]
    cloth = [box((0.22, 0.016, 0.66 * reach), (0.12, 0.004, 0.6 * reach))]
    way = Rotation.from_euler("y", draw(10.0, 60.0), degrees=True).as_matrix()
    spars += placed(spun([*arm, *lattice], 4, "y"), way, hub)
    sails = placed(spun(cloth, 4, "y"), way, hub)
    spars += [
        rod((0, -0.54, 1.44), (0, -0.2, 1.44), 0.06, rim=0.01),
        box((0.14, 0.08, 0.14), (0, -0.46, 1.44), 0.02),
    ]
    door = [box((0.2, 0.06, 0.34), (0, -wide - 0.03, 0.19), 0.01)]
    door += [ball(0.018, (0.06, -wide - 0.07, 0.18))]
    spars += [rod((0, 0.24, 1.44), (0, 0.5, 0.6), 0.022), rod((0, 0.3, 1.42), (0, 0.2, 1.42), 0.04)]
    steps = [box((0.26, 0.12, 0.05), (0, -wide - 0.12, 0.02), 0.008)]
    return {
        "walls": walls,
        "roof": roof,
        "sails": sails,
        "spars": spars,
        "base": [*base, *steps],
        "door": door,
    }


def _church(draw: Draw) -> Parts:
    long, high = draw(0.8, 0.95), 0.62
    nave = [(-0.36, 0), (0.36, 0), (0.36, high), (0, high + 0.36), (-0.36, high)]
    walls = [plate(nave, 2 * long, (0, 0.25, 0), FRONT)]
    for y in np.linspace(0.25 - long + 0.28, 0.25 + long - 0.12, 4):
        walls += both_sides(
            [
                plate(
                    [(0.34, 0), (0.47, 0), (0.47, 0.3), (0.41, 0.5), (0.34, 0.56)],
                    0.09,
                    (0, y, 0),
                    FRONT,
                )
            ]
        )
    apse = [(0, 0), (0.28, 0), (0.28, 0.5), (0, 0.5)]
    walls += [turned(apse, (0, 0.25 + long, 0))]
    front = 0.25 - long
    tower = [
        box((0.46, 0.46, 1.3), (0, front - 0.1, 0.65), 0.004),
        box((0.52, 0.52, 0.06), (0, front - 0.1, 0.86), 0.006),
    ]
    tower += [box((0.52, 0.52, 0.07), (0, front - 0.1, 1.3), 0.008)]
    tower += [
        box((0.1, 0.1, 1.1), (s * 0.23, front - 0.1 + t * 0.23, 0.55), 0.006)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    tower += [
        rod(
            (s * 0.22, front - 0.1 + t * 0.22, 1.3),
            (s * 0.22, front - 0.1 + t * 0.22, 1.5),
            0.04,
            0.005,
        )
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    roof = []
    for side in (-1, 1):
        slope = Rotation.from_euler("y", side * 45, degrees=True).as_matrix()
        roof += placed(
            [box((0.62, 2 * long + 0.1, 0.045), (side * 0.25, 0, 0), 0.006)],
            slope,
            (0, 0.26, high + 0.4),
        )
    roof += [rod((0, front - 0.02, high + 0.4), (0, 0.28 + long, high + 0.4), 0.026)]
    roof += [turned([(0, 0.48), (0.31, 0.48), (0.31, 0.52), (0, 0.8)], (0, 0.25 + long, 0))]
    spire = np.array([(s * 0.24, t * 0.24) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    roof += [
        plate(spire * (1 - k / 14), 0.075, (0, front - 0.1, 1.36 + 0.07 * k)) for k in range(14)
    ]
    roof += [
        rod((0, front - 0.1, 2.24), (0, front - 0.1, 2.56), 0.018),
        rod((-0.08, front - 0.1, 2.46), (0.08, front - 0.1, 2.46), 0.018),
        ball(0.03, (0, front - 0.1, 2.32)),
    ]
    arch = [
        (-0.12, 0),
        (0.12, 0),
        (0.12, 0.26),
        (0.07, 0.36),
        (0, 0.4),
        (-0.07, 0.36),
        (-0.12, 0.26),
    ]
    door = [plate(arch, 0.06, (0, front - 0.33, 0.02), FRONT)]
    walls += [
        box((0.5, 0.16, 0.04), (0, front - 0.4, 0.01), 0.006),
        box((0.86, 2 * long + 0.06, 0.05), (0, 0.25, 0.01), 0.008),
    ]
    return {"walls": [*walls, *tower], "roof": roof, "door": door}


BUILDINGS: dict[str, Callable[[Draw], Parts]] = {
    "castle": _castle,
    "windmill": _windmill,
    "church": _church,
}
