"""What one opens, cuts, serves and eats with."""

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
    capsule,
    closed_curve,
    curve,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _corkscrew(draw: Draw) -> Parts:
    turns, r = draw.which(2) + 4, 0.07
    t = np.linspace(0, 2 * np.pi * turns, 14 * turns)
    screw = [
        (0, 0, 0.05),
        *(
            (
                r * np.cos(a) * min(1, 0.4 + a),
                r * np.sin(a) * min(1, 0.4 + a),
                -0.03 - 0.62 * a / t[-1],
            )
            for a in t[4:]
        ),
    ]
    metal = [
        pipe(screw, (*([0.026] * (len(screw) - 4)), 0.024, 0.02, 0.014, 0.008)),
        rod((0, 0, 0.0), (0, 0, 0.42), 0.03),
    ]
    body = [
        turned(
            [
                (0, 0.12),
                (0.1, 0.12),
                (0.13, -0.06),
                (0.17, -0.1),
                (0.17, -0.16),
                (0.14, -0.16),
                (0.1, -0.08),
                (0.08, 0.0),
                (0, 0.02),
            ]
        ),
        box((0.24, 0.12, 0.22), (0, 0, 0.2), 0.03),
    ]
    lift = Rotation.from_euler("y", -draw(10.0, 40.0), degrees=True).as_matrix()
    arm = [
        rod((-0.02, 0, 0), (0.52, 0, 0), 0.035),
        capsule((0.46, 0, 0), (0.6, 0, 0), 0.055, 0.05),
        rod((0, -0.04, 0), (0, 0.04, 0), 0.085, rim=0.01),
        *spun([box((0.03, 0.07, 0.04), (0, 0, 0.085), 0.004)], 10, "y"),
    ]
    arms = both_sides(placed(arm, lift, (0.15, 0, 0.22)))
    handle = [rod((0, 0, 0.36), (0, 0, 0.44), 0.055), ring(0.12, 0.035, (0, 0, 0.55), "y")]
    return {"screw": metal, "body": body, "arms": arms, "handle": handle}


def _bottle_opener(draw: Draw) -> Parts:
    half = draw(0.2, 0.23)
    outline = closed_curve(
        [
            (-0.07, -0.25),
            (-0.08, 0.1),
            (-half, 0.36),
            (-half + 0.02, 0.62),
            (0, 0.72),
            (half - 0.02, 0.62),
            (half, 0.36),
            (0.08, 0.1),
            (0.07, -0.25),
        ]
    )
    hole = closed_curve(
        [
            (-0.11, 0.36),
            (-0.12, 0.54),
            (0, 0.61),
            (0.12, 0.54),
            (0.11, 0.36),
            (0.045, 0.42),
            (-0.045, 0.42),
        ]
    )
    grip = closed_curve(
        [
            (-0.075, -0.1),
            (-0.1, -0.5),
            (-0.085, -0.86),
            (0, -0.95),
            (0.085, -0.86),
            (0.1, -0.5),
            (0.075, -0.1),
        ]
    )
    rivets = [rod((0, -0.06, z), (0, 0.06, z), 0.028, rim=0.006) for z in (-0.25, -0.72)]
    return {
        "opener": [
            plate(outline, 0.06, (0, 0, 0), FRONT, [hole]),
            rod((0, 0, -0.3), (0, 0, -0.2), 0.03),
        ],
        "grip": [plate(grip, 0.1, (0, 0, 0), FRONT)],
        "rivets": rivets,
    }


def _can_opener(draw: Draw) -> Parts:
    spread = draw(5.0, 9.0)
    half = [box((0.09, 0.07, 0.9), (0, 0, -0.5), 0.034), box((0.07, 0.05, 0.3), (0, 0, 0.0), 0.02)]
    handles = []
    for s in (-1, 1):
        handles += placed(
            half,
            Rotation.from_euler("y", -s * spread, degrees=True).as_matrix(),
            (s * 0.04, s * 0.022, 0),
        )
    metal = [box((0.2, 0.1, 0.26), (0, 0, 0.06), 0.03), rod((0, -0.09, 0.1), (0, 0.1, 0.1), 0.035)]
    cutter = [
        rod((0.05, -0.085, 0.2), (0.05, -0.045, 0.2), 0.11, rim=0.008),
        rod((-0.07, -0.1, 0.12), (-0.07, -0.04, 0.12), 0.07),
        *moved(spun([box((0.02, 0.05, 0.024), (0, 0, 0.07))], 16, "y"), (-0.07, -0.07, 0.12)),
    ]
    crank = [
        rod((0, 0.06, 0.1), (0, 0.17, 0.1), 0.03),
        box((0.46, 0.035, 0.085), (0, 0.17, 0.1), 0.016, (0, draw(10, 40), 0)),
    ]
    return {"handles": handles, "body": metal, "cutter": cutter, "crank": crank}


def _ladle(draw: Draw) -> Parts:
    r = draw(0.22, 0.25)
    angle = np.linspace(-np.pi / 2, 0.05, 12)
    outer = [(r * np.cos(a), r * np.sin(a)) for a in angle]
    inner = [((r - 0.03) * np.cos(a), (r - 0.03) * np.sin(a)) for a in angle[::-1]]
    bowl = [turned([(0, -r), *outer[1:], *inner[:-1], (0, -r + 0.03)])]
    stem = [
        pipe([(r - 0.02, 0, 0.0), (r + 0.03, 0, 0.2), (r + 0.06, 0, 0.62)], (0.03, 0.026, 0.026))
    ]
    grip = [capsule((r + 0.06, 0, 0.56), (r + 0.08, 0, 1.08), 0.042, 0.05)]
    hook = [
        pipe(
            [(r + 0.08, 0, 1.1), (r + 0.085, 0, 1.2), (r, 0, 1.24), (r - 0.05, 0, 1.16)],
            0.018,
        )
    ]
    return {"bowl": bowl, "stem": [*stem, *hook], "grip": grip}


def _tongs(draw: Draw) -> Parts:
    spread = draw(7.0, 12.0)
    arm = [
        box((0.028, 0.09, 1.3), (0, 0, -0.66), 0.01),
        ball((0.04, 0.11, 0.15), (-0.005, 0, -1.32)),
        *(ball((0.035, 0.03, 0.03), (-0.02, y, -1.45)) for y in (-0.07, 0.0, 0.07)),
    ]
    grip = [box((0.05, 0.115, 0.5), (0.008, 0, -0.42), 0.02)]
    way = Rotation.from_euler("y", -spread, degrees=True).as_matrix()
    spring = [
        ball((0.06, 0.06, 0.05), (0, 0, 0.0)),
        rod((0, -0.055, -0.01), (0, 0.055, -0.01), 0.055, rim=0.01),
        ring(0.055, 0.014, (0, 0, 0.08), "y"),
    ]
    return {
        "arms": [*both_sides(placed(arm, way, (0.02, 0, 0))), *spring],
        "grips": both_sides(placed(grip, way, (0.02, 0, 0))),
    }


def _egg_cup(draw: Draw) -> Parts:
    high = draw(0.3, 0.38)
    cup = [
        (0, 0),
        (0.26, 0),
        (0.25, 0.04),
        (0.1, 0.1),
        (0.07, high - 0.1),
        (0.14, high - 0.02),
        (0.26, high + 0.1),
        (0.3, high + 0.3),
        (0.27, high + 0.3),
        (0.25, high + 0.2),
        (0, high + 0.2),
    ]
    egg = curve(
        [
            (0, high + 0.05),
            (0.16, high + 0.1),
            (0.255, high + 0.26),
            (0.265, high + 0.38),
            (0.22, high + 0.58),
            (0.12, high + 0.7),
            (0, high + 0.73),
        ]
    )
    band = [ring(0.292, 0.02, (0, 0, high + 0.24)), ring(0.25, 0.018, (0, 0, 0.035))]
    return {"cup": [turned(cup)], "egg": [turned(egg)], "bands": band}


def _pizza_cutter(draw: Draw) -> Parts:
    r = draw(0.36, 0.4)
    blade = [
        rod((0, -0.016, 0), (0, 0.016, 0), r),
        rod((0, -0.045, 0), (0, 0.045, 0), 0.06, rim=0.01),
    ]
    fork = [box((0.09, 0.022, 0.46), (0, y, 0.2), 0.008) for y in (-0.04, 0.04)] + [
        box((0.13, 0.12, 0.08), (0, 0, 0.44), 0.02),
        rod((0, 0, 0.44), (0, 0, 0.54), 0.05),
    ]
    grip = [
        capsule((0, 0, 0.58), (0, 0, 1.18), 0.075, 0.09),
        rod((0, 0, 0.52), (0, 0, 0.58), 0.1, 0.08, 0.015),
    ]
    end = [ball(0.05, (0, 0, 1.26))]
    return {"blade": blade, "fork": [*fork, *end], "grip": grip}


def _chopsticks(draw: Draw) -> Parts:
    gap = draw(3.0, 6.0)
    sticks, bands = [], []
    for s in (-1, 1):
        way = (
            Rotation.from_euler("y", s * gap, degrees=True).as_matrix()
            @ Rotation.from_euler("x", 78, degrees=True).as_matrix()
        )
        at = (0, 0, 0.1)
        sticks += placed(
            [
                rod((0, 0, -1.0), (0, 0, 0.25), 0.024, 0.04),
                box((0.075, 0.075, 0.6), (0, 0, 0.5), 0.012),
            ],
            way,
            (s * 0.1, 0, at[2]),
        )
        bands += placed(
            [box((0.082, 0.082, 0.05), (0, 0, z), 0.012) for z in (0.62, 0.72)]
            + [box((0.08, 0.08, 0.03), (0, 0, 0.795), 0.01)],
            way,
            (s * 0.1, 0, at[2]),
        )
    rest = [
        box((0.62, 0.2, 0.1), (0, 0.36, -0.02), 0.04),
        *both_sides([ball((0.11, 0.1, 0.08), (0.26, 0.36, 0.0))]),
    ]
    return {"sticks": sticks, "bands": bands, "rest": rest}


KITCHEN_TOOLS: dict[str, Callable[[Draw], Parts]] = {
    "corkscrew": _corkscrew,
    "bottle opener": _bottle_opener,
    "can opener": _can_opener,
    "ladle": _ladle,
    "tongs": _tongs,
    "egg cup": _egg_cup,
    "pizza cutter": _pizza_cutter,
    "chopsticks": _chopsticks,
}
