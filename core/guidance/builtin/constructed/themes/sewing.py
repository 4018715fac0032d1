"""Things of sewing, knots and beads."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    box,
    closed_curve,
    curve,
    pipe,
    plate,
    ring,
    rod,
    turned,
)


def _spool_of_thread(draw: Draw) -> Parts:
    ends = [
        turned([(0, z), (0.34, z), (0.4, z + 0.04), (0.4, z + 0.1), (0.3, z + 0.14), (0, z + 0.14)])
        if z < 0.4
        else turned(
            [(0, z), (0.3, z), (0.4, z + 0.04), (0.4, z + 0.1), (0.34, z + 0.14), (0, z + 0.14)]
        )
        for z in (0.0, 0.82)
    ]
    hole = [rod((0, 0, 0.945), (0, 0, 0.966), 0.1)]
    count = 17
    thread = [
        ring(
            0.3 + 0.035 * np.sin(np.pi * k / (count - 1)),
            0.035,
            (0, 0, 0.17 + 0.62 * k / (count - 1)),
        )
        for k in range(count)
    ] + [rod((0, 0, 0.1), (0, 0, 0.86), 0.31)]
    tail = draw(0.5, 0.7)
    thread += [
        pipe(
            [
                (0.3, -0.12, 0.3),
                (0.42, -0.3, 0.16),
                (tail, -0.5, 0.022),
                (0.4 + tail, -0.44, 0.022),
                (0.6 + tail, -0.56, 0.022),
            ],
            0.02,
        )
    ]
    needle = [
        rod((0.12, -0.36, 0.12), (-0.12, -0.32, 0.98), 0.017, 0.014),
        rod((0.12, -0.36, 0.12), (0.15, -0.365, 0.0), 0.017, 0.004),
        ring(0.03, 0.012, (-0.128, -0.318, 1.0), "y"),
    ]
    return {"spool": ends, "thread": thread, "hole": hole, "needle": needle}


def _ball_of_yarn(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    yarn = [ball(0.605)]
    for k in range(9):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        u = np.cross(axis, (0.3, 0.5, 0.8))
        u /= np.linalg.norm(u)
        v = np.cross(axis, u)
        for j in range(-2, 3):
            off, r = 0.075 * j, np.sqrt(0.59**2 - (0.075 * j) ** 2)
            t = np.linspace(0, 2 * np.pi, 25)[:-1]
            yarn.append(
                pipe(
                    off * axis + r * (np.cos(t)[:, None] * u + np.sin(t)[:, None] * v),
                    0.036 + 0.001 * k,
                    closed=True,
                )
            )
    yarn += [
        pipe(
            [
                (0.34, -0.26, -0.34),
                (0.66, -0.4, -0.56),
                (0.95, -0.3, -0.59),
                (1.15, -0.5, -0.59),
                (1.4, -0.36, -0.59),
            ],
            0.04,
        )
    ]
    needles = [
        rod((-0.86, -0.2, 0.72), (0.6, 0.1, -0.2), 0.03),
        rod((0.86, -0.2, 0.76), (-0.6, 0.1, -0.16), 0.03),
    ]
    knobs = [ball(0.07, (-0.88, -0.205, 0.735)), ball(0.07, (0.88, -0.205, 0.775))]
    return {"yarn": yarn, "needles": needles, "knobs": knobs}


def _thimble(draw: Draw) -> Parts:
    high = draw(0.8, 0.9)
    body = [
        turned(
            [
                (0, 0.06),
                (0.4, 0),
                (0.44, 0.0),
                (0.44, 0.08),
                (0.41, 0.12),
                (0.34, high - 0.12),
                (0.28, high - 0.02),
                (0.16, high + 0.03),
                (0, high + 0.04),
            ]
        ),
        ring(0.425, 0.03, (0, 0, 0.04)),
    ]
    dots = []
    for j in range(7):
        z = 0.3 + (high - 0.42) * j / 6
        r = 0.41 - 0.07 * (z - 0.12) / (high - 0.24)
        dots += [
            ball(0.026, (r * np.cos(a), r * np.sin(a), z))
            for a in (np.arange(22) + 0.5 * (j % 2)) * 2 * np.pi / 22
        ]
    band = [turned([(0.38, 0.16), (0.418, 0.16), (0.412, 0.22), (0.38, 0.22)])]
    return {"body": body, "dots": dots, "band": band}


def _sewing_needle(draw: Draw) -> Parts:
    long = draw(1.5, 1.7)
    steel = [
        rod((0, 0, 0.1), (0, 0, long), 0.036, 0.034),
        rod((0, 0, 0.11), (0, 0, -0.14), 0.036, 0.004),
        plate(
            closed_curve(
                [
                    (-0.05, long - 0.02),
                    (-0.055, long + 0.14),
                    (0, long + 0.2),
                    (0.055, long + 0.14),
                    (0.05, long - 0.02),
                ]
            ),
            0.06,
            (0, 0, 0),
            FRONT,
            [
                closed_curve(
                    [
                        (-0.02, long + 0.03),
                        (-0.022, long + 0.11),
                        (0, long + 0.14),
                        (0.022, long + 0.11),
                        (0.02, long + 0.03),
                    ]
                )
            ],
        ),
    ]
    z = long + 0.08
    thread = [
        pipe(
            [
                (0.02, 0.1, z - 0.3),
                (0.0, 0.07, z - 0.1),
                (0, 0, z),
                (0.02, -0.08, z - 0.12),
                (0.16, -0.1, z - 0.44),
                (0.32, -0.06, z - 0.72),
                (0.2, 0, z - 1.0),
                (0.34, 0.02, z - 1.3),
            ],
            0.02,
        )
    ]
    return {"needle": steel, "thread": thread}


def _ribbon(draw: Draw) -> Parts:
    droop = draw(-0.08, 0.04)
    bow = []
    for s in (-1, 1):
        loop = [
            (s * 0.06, 0.02),
            (s * 0.4, 0.3),
            (s * 0.72, 0.28 + droop),
            (s * 0.78, 0.02 + droop),
            (s * 0.6, -0.2 + droop),
            (s * 0.3, -0.12),
        ]
        bow.append(
            plate(
                _band(closed_curve(loop), 0.05),
                0.34,
                (0, 0, 0),
                FRONT,
                [_inner(closed_curve(loop), 0.05)],
            )
        )
    tails = []
    for s in (-1, 1):
        way = np.array([(s * 0.02, 0.0), (s * 0.16, -0.3), (s * 0.3, -0.56), (s * 0.5, -0.86)])
        line = curve(way)
        tails.append(
            plate([*(line + (0.045, 0)), *(line - (0.045, 0))[::-1]], 0.32, (0, 0, 0), FRONT)
        )
    knot = [box((0.22, 0.4, 0.24), (0, 0, 0.02), 0.09)]
    return {"loops": bow, "tails": tails, "knot": knot}


def _band(loop: np.ndarray, thick: float) -> np.ndarray:
    """The outer outline of a strap laid along a loop."""
    return loop + 0.5 * thick * _outwards(loop)


def _inner(loop: np.ndarray, thick: float) -> np.ndarray:
    """The inner outline of it."""
    return loop - 0.5 * thick * _outwards(loop)


def _outwards(loop: np.ndarray) -> np.ndarray:
    along = np.roll(loop, -1, 0) - np.roll(loop, 1, 0)
    way = np.stack([along[:, 1], -along[:, 0]], 1)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    x, y = loop.T
    return way if x @ np.roll(y, -1) - y @ np.roll(x, -1) > 0 else -way


def _knot(draw: Draw) -> Parts:
    t = np.linspace(0, 2 * np.pi, 61)[:-1]
    spread = draw(0.95, 1.05)
    way = (
        np.stack(
            [
                spread * (np.sin(t) + 2 * np.sin(2 * t)),
                0.9 * -np.sin(3 * t),
                np.cos(t) - 2 * np.cos(2 * t),
            ],
            1,
        )
        * 0.28
    )
    thin = [pipe(way, 0.155, closed=True)]
    strands = []
    frames = np.gradient(np.concatenate([way, way, way]), axis=0)[60:120]
    frames /= np.linalg.norm(frames, axis=1, keepdims=True)
    u = np.cross(frames, (0.0, 1.0, 0.0))
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    v = np.cross(frames, u)
    for k in range(3):
        a = 9 * t + 2 * np.pi * k / 3
        strands.append(
            pipe(
                way + 0.118 * (np.cos(a)[:, None] * u + np.sin(a)[:, None] * v), 0.062, closed=True
            )
        )
    return {"core": thin, "strands": strands}


def _rosary(draw: Draw) -> Parts:
    count = 35 + 5 * draw.which(3)
    beads, large, chain = [], [], []
    t = np.linspace(-np.pi / 2 + 0.16, 1.5 * np.pi - 0.16, count)
    loop = np.stack([0.56 * np.cos(t), 0 * t, 0.2 + 0.62 * np.sin(t)], 1)
    for k, at in enumerate(loop):
        (large if k % 7 == 3 else beads).append(ball(0.046 if k % 7 == 3 else 0.034, tuple(at)))
    centre = (0, 0, -0.5)
    chain.append(pipe([centre, *loop, centre], 0.013))
    chain.append(rod(centre, (0, 0, -0.86), 0.013))
    large += [ball((0.07, 0.04, 0.08), centre)]
    beads += [ball(0.034, (0, 0, z)) for z in (-0.62, -0.7, -0.78)]
    cross = [
        box((0.07, 0.05, 0.4), (0, 0, -1.04), 0.014),
        box((0.26, 0.05, 0.07), (0, 0, -0.98), 0.014),
    ]
    return {"beads": beads, "large beads": large, "chain": chain, "cross": cross}


SEWING: dict[str, Callable[[Draw], Parts]] = {
    "spool of thread": _spool_of_thread,
    "ball of yarn": _ball_of_yarn,
    "thimble": _thimble,
    "sewing needle": _sewing_needle,
    "ribbon": _ribbon,
    "knot": _knot,
    "rosary": _rosary,
}
