"""Things of a games hall and a barber's pole."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    both_sides,
    box,
    pipe,
    placed,
    ring,
    rod,
    spun,
    turned,
)


def _boxing_ring(draw: Draw) -> Parts:
    half = draw(0.9, 1.0)
    base = [box((2 * half + 0.2, 2 * half + 0.2, 0.3), (0, 0, 0.15), 0.015)]
    mat = [box((2 * half + 0.1, 2 * half + 0.1, 0.06), (0, 0, 0.32), 0.015)]
    apron = spun([box((2 * half + 0.1, 0.03, 0.2), (0, -half - 0.1, 0.16), 0.006)], 4)
    posts = [
        rod((s * half, t * half, 0.3), (s * half, t * half, 1.0), 0.05, rim=0.01)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    red, white, blue = [], [], []
    for k, where in enumerate((red, white, blue)):
        z = 0.52 + 0.17 * k
        for a, b in (
            ((-1, -1), (1, -1)),
            ((1, -1), (1, 1)),
            ((1, 1), (-1, 1)),
            ((-1, 1), (-1, -1)),
        ):
            where.append(rod((half * a[0], half * a[1], z), (half * b[0], half * b[1], z), 0.024))
    pads = {(1, -1): red, (-1, 1): blue}
    for s in (-1, 1):
        for t in (-1, 1):
            pads.get((s, t), white).append(
                box(
                    (0.16, 0.16, 0.5), (s * (half - 0.06), t * (half - 0.06), 0.7), 0.05, (0, 0, 45)
                )
            )
    steps = [
        box(
            (0.34, 0.12, 0.1 * (3 - k)),
            (half * 0.6, -half - 0.16 - 0.11 * k, 0.05 * (3 - k)),
            0.006,
        )
        for k in range(3)
    ]
    disc = [
        rod((0, 0, 0.345), (0, 0, 0.362), 0.36),
    ]
    return {
        "base": [*base, *posts, *steps],
        "mat": mat,
        "apron": apron,
        "lower ropes": red,
        "middle ropes": white,
        "upper ropes": blue,
        "logo": disc,
    }


def _table_tennis(draw: Draw) -> Parts:
    long = 1.37
    top = [box((1.52, 2 * long, 0.06), (0, 0, 0.76), 0.01)]
    lines = (
        [box((0.03, 2 * long - 0.002, 0.012), (s * 0.74, 0, 0.79)) for s in (-1, 1)]
        + [box((0.022, 2 * long - 0.002, 0.012), (0, 0, 0.79))]
        + [box((1.52, 0.03, 0.012), (0, s * (long - 0.015), 0.79)) for s in (-1, 1)]
    )
    net = [rod((x, 0, 0.78), (x, 0, 0.93), 0.0115) for x in np.linspace(-0.8, 0.8, 33)] + [
        rod((-0.86, 0, z), (0.86, 0, z), 0.0115) for z in (0.82, 0.86, 0.9)
    ]
    tape = [
        box((1.72, 0.022, 0.03), (0, 0, 0.94), 0.004),
        *both_sides(
            [
                rod((0.85, 0, 0.72), (0.85, 0, 0.96), 0.02),
                box((0.12, 0.08, 0.06), (0.8, 0, 0.74), 0.01),
            ]
        ),
    ]
    legs = (
        [box((0.07, 0.07, 0.74), (s * 0.6, t * 1.0, 0.37), 0.012) for s in (-1, 1) for t in (-1, 1)]
        + [box((1.2, 0.05, 0.05), (0, t * 1.0, 0.2), 0.01) for t in (-1, 1)]
        + [box((0.06, 2.1, 0.06), (s * 0.6, 0, 0.7), 0.01) for s in (-1, 1)]
    )
    spin = draw(-20, 40)
    bat = placed(
        [rod((0, 0, -0.016), (0, 0, 0.016), 0.16, rim=0.006)],
        Rotation.from_euler("z", spin, degrees=True).as_matrix(),
        (0.3, -0.7, 0.8),
    ) + placed([rod((0, 0, -0.016), (0, 0, 0.016), 0.16, rim=0.006)], np.eye(3), (-0.3, 0.6, 0.8))
    grips = placed(
        [box((0.05, 0.22, 0.04), (0, -0.22, 0), 0.014)],
        Rotation.from_euler("z", spin, degrees=True).as_matrix(),
        (0.3, -0.7, 0.8),
    ) + [box((0.05, 0.22, 0.04), (-0.3, 0.82, 0.8), 0.014)]
    balls = [ball(0.045, (0.1, -0.3, 0.83))]
    return {
        "top": top,
        "lines": [*lines, *balls],
        "net": net,
        "tape": tape,
        "legs": legs,
        "bats": bat,
        "grips": grips,
    }


def _foosball_table(draw: Draw) -> Parts:
    box_ = (
        [box((0.08, 1.5, 0.34), (s * 0.4, 0, 0.82), 0.012) for s in (-1, 1)]
        + [box((0.88, 0.08, 0.34), (0, s * 0.72, 0.82), 0.012) for s in (-1, 1)]
        + [box((0.8, 1.44, 0.06), (0, 0, 0.68), 0.01)]
    )
    legs = [
        box((0.1, 0.1, 0.68), (s * 0.36, t * 0.66, 0.34), 0.012) for s in (-1, 1) for t in (-1, 1)
    ] + [box((0.7, 0.06, 0.06), (0, t * 0.66, 0.2), 0.01) for t in (-1, 1)]
    pitch = [box((0.74, 1.38, 0.04), (0, 0, 0.72))]
    lines = [
        box((0.72, 0.014, 0.012), (0, 0, 0.743)),
        ring(0.12, 0.0105, (0, 0, 0.741)),
        *(box((0.3, 0.014, 0.012), (0, s * 0.5, 0.743)) for s in (-1, 1)),
        *(box((0.014, 0.18, 0.012), (t * 0.15, s * 0.59, 0.743)) for s in (-1, 1) for t in (-1, 1)),
    ]
    rods, red, blue, grips = [], [], [], []
    for k, y in enumerate(np.linspace(-0.58, 0.58, 8)):
        shift = draw(-0.05, 0.05)
        rods.append(rod((-0.66, y, 0.9), (0.66, y, 0.9), 0.0135))
        grips.append(
            rod(
                ((0.56 if k % 2 else -0.56) - 0.1 * (0 if k % 2 else 1), y, 0.9),
                ((0.66 if k % 2 else -0.56), y, 0.9),
                0.03,
                rim=0.008,
            )
        )
        count = (1, 2, 3, 4, 4, 3, 2, 1)[k]
        who = red if k in (0, 1, 3, 5) else blue
        for x in (np.arange(count) - (count - 1) / 2) * 0.16 + shift:
            who += [
                box((0.05, 0.05, 0.13), (x, y, 0.88), 0.008),
                ball((0.03, 0.03, 0.034), (x, y, 0.97)),
                box((0.04, 0.05, 0.04), (x, y, 0.8), 0.01),
            ]
    return {
        "cabinet": [*box_, *legs],
        "pitch": pitch,
        "lines": [*lines, ball(0.026, (0.1, 0.06, 0.76))],
        "rods": rods,
        "home team": red,
        "away team": blue,
        "grips": grips,
    }


def _barber_pole(draw: Draw) -> Parts:
    turns = 2.5 + 0.5 * draw.which(2)
    white = [rod((0, 0, -0.62), (0, 0, 0.62), 0.2)]
    found = {"first bands": [], "second bands": []}
    for k, name in enumerate(found):
        for shift in (0.0, 0.5):
            t = np.linspace(0, 1, 40)
            a = 2 * np.pi * (turns * t + shift + 0.25 * k)
            found[name].append(
                pipe(np.stack([0.175 * np.cos(a), 0.175 * np.sin(a), -0.58 + 1.16 * t], 1), 0.055)
            )
    ends = [
        turned(
            [
                (0, z0 - 0.1),
                (0.2, z0 - 0.1),
                (0.26, z0 - 0.04),
                (0.26, z0 + 0.04),
                (0.2, z0 + 0.1),
                (0, z0 + 0.1),
            ]
        )
        for z0 in (-0.68, 0.68)
    ]
    ends += [
        ball(0.2, (0, 0, 0.84)),
        turned([(0, -1.0), (0.06, -0.98), (0.17, -0.86), (0.18, -0.76), (0, -0.74)]),
        box((0.1, 0.4, 0.1), (0, 0.28, 0.68), 0.02),
        box((0.1, 0.4, 0.1), (0, 0.28, -0.68), 0.02),
        box((0.24, 0.06, 1.6), (0, 0.46, 0), 0.02),
    ]
    return {"pole": white, **found, "caps": ends}


GAMES_HALL: dict[str, Callable[[Draw], Parts]] = {
    "boxing ring": _boxing_ring,
    "ping pong table": _table_tennis,
    "foosball table": _foosball_table,
    "barber pole": _barber_pole,
}
