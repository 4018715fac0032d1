"""Things of the garden."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    RIGHTWARD,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _bird_feeder(draw: Draw) -> Parts:
    high = draw(1.2, 1.4)
    z = high
    wood = [
        rod((0, 0, 0), (0, 0, z), 0.045),
        box((0.62, 0.5, 0.04), (0, 0, z), 0.01),
        *both_sides([box((0.03, 0.5, 0.07), (0.3, 0, z + 0.03), 0.006)]),
        *(box((0.62, 0.03, 0.07), (0, y, z + 0.03), 0.006) for y in (-0.24, 0.24)),
    ]
    wood += both_sides(
        [
            plate(
                [(-0.16, 0), (0.16, 0), (0.16, 0.3), (0, 0.42), (-0.16, 0.3)],
                0.035,
                (0.24, 0, z),
                SIDE,
            )
        ]
    )
    roof = []
    for s in (-1, 1):
        way = Rotation.from_euler("x", -s * 38, degrees=True).as_matrix()
        roof += placed(
            [
                box((0.74, 0.13, 0.03), (0, s * (0.05 + 0.11 * k), 0.01 * (3 - k)), 0.006)
                for k in range(3)
            ],
            way,
            (0, 0, z + 0.43),
        )
    glass = [box((0.46, 0.2, 0.27), (0, 0, z + 0.17), 0.006)]
    seeds = [
        ball((0.05, 0.05, 0.022), (x, y, z + 0.03))
        for x in np.linspace(-0.2, 0.2, 5)
        for y in (-0.17, 0.17)
    ]
    seeds += [box((0.44, 0.3, 0.05), (0, 0, z + 0.03), 0.02)]
    foot = [rod((0, 0, -0.02), (0, 0, 0.05), 0.3, 0.26, 0.015)]
    bird = [
        ball((0.075, 0.11, 0.08), (0.1, -0.27, z + 0.15), (20, 0, 0)),
        ball(0.056, (0.1, -0.36, z + 0.24)),
        plate([(0, 0), (0.17, -0.02), (0.17, 0.04), (0, 0.05)], 0.06, (0.1, -0.2, z + 0.12), SIDE),
    ]
    beak = [
        rod((0.1, -0.4, z + 0.24), (0.1, -0.48, z + 0.23), 0.024, 0.004),
        *(rod((x, -0.26, z + 0.05), (x, -0.27, z + 0.1), 0.011) for x in (0.07, 0.13)),
    ]
    return {
        "post": [*wood, *foot],
        "roof": roof,
        "glass": glass,
        "seeds": seeds,
        "bird": bird,
        "beak": beak,
    }


def _bird_bath(draw: Draw) -> Parts:
    wide = draw(0.5, 0.56)
    column = [
        (0, 0),
        (0.34, 0),
        (0.34, 0.06),
        (0.28, 0.1),
        (0.2, 0.13),
        (0.13, 0.2),
        (0.15, 0.42),
        (0.11, 0.6),
        (0.12, 0.86),
        (0.2, 0.9),
        (0, 0.92),
    ]
    bowl = [
        (0, 0.88),
        (0.16, 0.88),
        (0.36, 0.93),
        (wide, 1.05),
        (wide + 0.02, 1.1),
        (wide - 0.03, 1.1),
        (0.34, 0.99),
        (0, 0.96),
    ]
    flutes = spun([capsule((0, -0.145, 0.24), (0, -0.12, 0.8), 0.022)], 12)
    rope = [
        ball(0.026, ((wide + 0.012) * np.cos(a), (wide + 0.012) * np.sin(a), 1.085))
        for a in np.arange(44) * 2 * np.pi / 44
    ]
    water = [rod((0, 0, 0.94), (0, 0, 1.045), wide - 0.16, wide - 0.09)]
    at = np.array([0.2, -wide + 0.02, 1.13])
    bird = [
        ball((0.08, 0.12, 0.085), tuple(at + (0, 0, 0.08)), (24, 0, -20)),
        ball(0.06, tuple(at + (-0.03, -0.09, 0.18))),
        capsule(tuple(at + (0.02, 0.06, 0.07)), tuple(at + (0.05, 0.2, 0.1)), 0.036, 0.024),
    ]
    beak = [
        rod(tuple(at + (-0.045, -0.13, 0.18)), tuple(at + (-0.07, -0.22, 0.17)), 0.024, 0.004),
        *(rod(tuple(at + (x, 0, -0.04)), tuple(at + (x, 0, 0.04)), 0.011) for x in (-0.03, 0.03)),
    ]
    return {
        "basin": [turned(column), turned(bowl), *flutes, *rope],
        "water": water,
        "bird": bird,
        "beak": beak,
    }


def _weather_vane(draw: Draw) -> Parts:
    turn = Rotation.from_euler("z", draw(-25.0, 25.0), degrees=True).as_matrix()
    pole = [
        rod((0, 0, 0), (0, 0, 1.1), 0.028),
        ball(0.06, (0, 0, 0.42)),
        ball(0.05, (0, 0, 0.78)),
        rod((0, 0, -0.02), (0, 0, 0.1), 0.2, 0.09, 0.02),
    ]
    pole += [
        rod((-0.42, 0, 0.5), (0.42, 0, 0.5), 0.018),
        rod((0, -0.47, 0.5), (0, 0.47, 0.5), 0.018),
    ]
    stroke = {
        "N": [((0, 0), (0, 1)), ((0, 1), (0.6, 0)), ((0.6, 0), (0.6, 1))],
        "E": [((0, 0), (0, 1)), ((0, 0), (0.6, 0)), ((0, 0.5), (0.5, 0.5)), ((0, 1), (0.6, 1))],
        "S": [
            ((0, 0), (0.6, 0)),
            ((0.6, 0), (0.6, 0.5)),
            ((0.6, 0.5), (0, 0.5)),
            ((0, 0.5), (0, 1)),
            ((0, 1), (0.6, 1)),
        ],
        "W": [
            ((0, 1), (0.15, 0)),
            ((0.15, 0), (0.35, 0.6)),
            ((0.35, 0.6), (0.55, 0)),
            ((0.55, 0), (0.7, 1)),
        ],
    }
    letters = []
    for name, at in (("N", (0, 0.46)), ("S", (0, -0.46)), ("E", (0.46, 0)), ("W", (-0.46, 0))):
        letters += [
            capsule(
                (at[0] + 0.17 * a - 0.055, at[1], 0.42 + 0.17 * b),
                (at[0] + 0.17 * c - 0.055, at[1], 0.42 + 0.17 * d),
                0.016,
            )
            for (a, b), (c, d) in stroke[name]
        ]
        letters.append(ball(0.026, (*at, 0.5)))
    rooster = [
        (0.3, 1.22),
        (0.2, 1.2),
        (0.02, 1.1),
        (-0.14, 1.14),
        (-0.24, 1.28),
        (-0.26, 1.44),
        (-0.34, 1.42),
        (-0.27, 1.5),
        (-0.22, 1.56),
        (-0.12, 1.52),
        (-0.08, 1.4),
        (0.06, 1.34),
        (0.16, 1.46),
        (0.3, 1.58),
        (0.44, 1.5),
        (0.42, 1.34),
    ]
    comb = [
        ball((0.045, 0.026, 0.05), (x, 0, z))
        for x, z in ((-0.25, 1.58), (-0.19, 1.61), (-0.13, 1.57))
    ] + [ball((0.03, 0.022, 0.05), (-0.26, 0, 1.39))]
    body = [
        plate(closed_curve(rooster), 0.05, (0, 0, 0), FRONT),
        rod((0, 0, 1.0), (0, 0, 1.16), 0.022),
    ]
    arrow = [
        rod((-0.6, 0, 1.02), (0.55, 0, 1.02), 0.02),
        plate([(-0.78, 1.02), (-0.56, 1.11), (-0.56, 0.93)], 0.04, (0, 0, 0), FRONT),
        plate(
            [(0.4, 1.02), (0.5, 1.12), (0.68, 1.12), (0.6, 1.02), (0.68, 0.92), (0.5, 0.92)],
            0.04,
            (0, 0, 0),
            FRONT,
        ),
    ]
    return {
        "pole": pole,
        "letters": letters,
        "arrow": placed(arrow, turn),
        "rooster": placed(body, turn),
        "comb": placed(comb, turn),
    }


def _windsock(draw: Draw) -> Parts:
    drop = draw(4.0, 18.0)
    pole = [
        rod((0, 0, 0), (0, 0, 1.5), 0.032, 0.024),
        rod((0, 0, -0.02), (0, 0, 0.06), 0.2, 0.17, 0.015),
        ball(0.04, (0, 0, 1.5)),
    ]
    down = Rotation.from_euler("y", drop, degrees=True).as_matrix()
    red, white = [], []
    for k in range(5):
        a, b = 0.2 * k, 0.2 * (k + 1)
        r0, r1 = 0.17 - 0.075 * a, 0.17 - 0.075 * b
        band = turned([(r0 - 0.022, a), (r0, a), (r1, b + 0.003), (r1 - 0.022, b + 0.003)])
        (white if k % 2 else red).append(band)
    hoop = [
        ring(0.165, 0.018, (0, 0, 0.0)),
        rod((-0.17, 0, 0), (0.17, 0, 0), 0.012),
        rod((0, -0.17, 0), (0, 0.17, 0), 0.012),
    ]
    at = (0.06, 0, 1.38)
    pole += [*placed(hoop, down @ RIGHTWARD, at), rod((0, 0, 1.38), (0.1, 0, 1.38), 0.018)]
    return {
        "stripes": placed(red, down @ RIGHTWARD, at),
        "sleeve": placed(white, down @ RIGHTWARD, at),
        "pole": pole,
    }


def _pergola(draw: Draw) -> Parts:
    wide, deep, count = draw(0.85, 0.95), 0.62, 9
    wood = [
        box((0.1, 0.1, 1.3), (s * wide, t * deep, 0.65), 0.01) for s in (-1, 1) for t in (-1, 1)
    ]
    wood += [
        box((0.15, 0.15, 0.1), (s * wide, t * deep, 0.05), 0.012) for s in (-1, 1) for t in (-1, 1)
    ]
    beam = [
        (-wide - 0.24, 0.06),
        (-wide - 0.24, 0.12),
        (wide + 0.24, 0.12),
        (wide + 0.24, 0.06),
        (wide + 0.16, 0),
        (-wide - 0.16, 0),
    ]
    wood += [
        plate(beam, 0.05, (0, t * (deep + 0.04 * s), 1.24), FRONT) for t in (-1, 1) for s in (-1, 1)
    ]
    wood += [
        rod((s * wide, t * deep, 1.0), (s * (wide - 0.2), t * deep, 1.24), 0.026)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    rafter = [
        (-deep - 0.26, 0.04),
        (-deep - 0.26, 0.1),
        (deep + 0.26, 0.1),
        (deep + 0.26, 0.04),
        (deep + 0.18, 0),
        (-deep - 0.18, 0),
    ]
    slats = [plate(rafter, 0.04, (x, 0, 1.34), SIDE) for x in np.linspace(-wide, wide, count)]
    slats += [
        box((2 * wide + 0.3, 0.03, 0.03), (0, y, 1.445), 0.004)
        for y in np.linspace(-deep - 0.1, deep + 0.1, 8)
    ]
    rng = np.random.default_rng(draw.which(100))
    leaves, flowers = [], []
    vine = [
        (wide + 0.07 * np.cos(3 * a), -deep + 0.07 * np.sin(3 * a), 0.12 * a)
        for a in np.linspace(0, 11, 24)
    ]
    leaves.append(pipe(vine, 0.018))
    for x, y, z in vine[2:]:
        leaves.append(
            ball(
                (0.06, 0.06, 0.045), (x + rng.uniform(-0.03, 0.03), y + rng.uniform(-0.03, 0.03), z)
            )
        )
    for _ in range(26):
        leaves.append(
            ball(
                (0.13, 0.12, 0.06),
                (rng.uniform(-0.1, wide + 0.1), rng.uniform(-deep - 0.1, 0.2), 1.46),
            )
        )
    for _ in range(12):
        flowers.append(
            ball(
                0.045,
                (rng.uniform(0, wide), -deep - 0.1 + 0.3 * rng.uniform(), 1.47),
            )
        )
    floor = [box((2 * wide + 0.4, 2 * deep + 0.4, 0.05), (0, 0, 0.0), 0.01)]
    return {"frame": wood, "slats": slats, "leaves": leaves, "flowers": flowers, "floor": floor}


GARDEN: dict[str, Callable[[Draw], Parts]] = {
    "bird feeder": _bird_feeder,
    "bird bath": _bird_bath,
    "weather vane": _weather_vane,
    "windsock": _windsock,
    "pergola": _pergola,
}
