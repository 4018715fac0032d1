"""Arms of ninjas, a whip, a hook."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    capsule,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
)


def _kunai(draw: Draw) -> Parts:
    wide = draw(0.15, 0.18)
    blade = [
        plate(
            [(0, 1.0), (wide, 0.3), (0.055, 0.12), (-0.055, 0.12), (-wide, 0.3)],
            0.05,
            (0, 0, 0),
            FRONT,
        ),
        plate(
            [(0, 0.98), (0.55 * wide, 0.3), (0.03, 0.14), (-0.03, 0.14), (-0.55 * wide, 0.3)],
            0.09,
            (0, 0, 0),
            FRONT,
        ),
    ]
    edge = [
        plate(
            [(0, 0.72), (0.16 * wide, 0.34), (0, 0.24), (-0.16 * wide, 0.34)], 0.1, (0, 0, 0), FRONT
        )
    ]
    grip = [
        rod((0, 0, -0.34), (0, 0, 0.16), 0.048),
        *(ring(0.044, 0.018, (0, 0, -0.3 + 0.05 * k)) for k in range(9)),
    ]
    loop = [ring(0.12, 0.036, (0, 0, -0.46), "y")]
    return {"blade": blade, "edge": edge, "grip": grip, "ring": loop}


def _nunchucks(draw: Draw) -> Parts:
    spread = draw(24.0, 36.0)
    sticks, caps, chain = [], [], []
    top = {}
    for s in (-1, 1):
        way = Rotation.from_euler("y", s * -spread / 2, degrees=True).as_matrix()
        at = np.array([s * 0.22, 0, 0.3])
        sticks += placed([rod((0, 0, -1.1), (0, 0, -0.02), 0.085, 0.075, 0.015)], way, at)
        caps += placed(
            [
                rod((0, 0, -0.12), (0, 0, 0.02), 0.09, rim=0.015),
                rod((0, 0, -1.12), (0, 0, -1.02), 0.095, rim=0.015),
                *(rod((0, 0, z), (0, 0, z + 0.03), 0.088, rim=0.006) for z in (-0.3, -0.84)),
                ball(0.045, (0, 0, 0.04)),
            ],
            way,
            at,
        )
        top[s] = way @ (0, 0, 0.05) + at
    count = 9
    links = [
        top[-1] + f * (top[1] - top[-1]) + np.array([0, 0, 0.3 * np.sin(np.pi * f)])
        for f in np.linspace(0, 1, count)
    ]
    for k, at in enumerate(links):
        chain.append(ring(0.05, 0.018, tuple(at), "y" if k % 2 else "z"))
        if k:
            chain.append(capsule(tuple(links[k - 1]), tuple(at), 0.014))
    return {"sticks": sticks, "caps": caps, "chain": chain}


def _whip(draw: Draw) -> Parts:
    turns = 2 + draw.which(2)
    t = np.linspace(0, 2 * np.pi * turns, 14 * turns)
    coil = [
        ((0.5 + 0.022 * a) * np.cos(a), (0.5 + 0.022 * a) * np.sin(a), 0.05 + 0.052 * a / np.pi)
        for a in t
    ]
    way = [*coil[::-1], (0.36, 0.42, 0.03), (0.1, 0.52, 0.03)]
    start = np.array(coil[-1])
    lash = [pipe(way, tuple(np.linspace(0.06, 0.02, len(way))))]
    lash += [capsule(coil[-1], (start[0] + 0.02, start[1] - 0.1, start[2]), 0.06)]
    handle = [
        rod(
            (start[0] + 0.02, start[1] - 0.06, start[2]),
            (start[0] + 0.06, start[1] - 0.72, start[2] + 0.04),
            0.075,
            0.085,
            0.02,
        )
    ]
    rings = [
        rod(
            tuple(start + (0.02 + 0.04 * f, -0.06 - 0.66 * f, 0.04 * f)),
            tuple(start + (0.022 + 0.04 * f, -0.11 - 0.66 * f, 0.04 * f)),
            0.095,
            rim=0.01,
        )
        for f in (0.0, 0.45, 0.96)
    ]
    wraps = [
        rod(
            tuple(start + (0.02 + 0.04 * f, -0.06 - 0.66 * f, 0.04 * f)),
            tuple(start + (0.021 + 0.04 * f, -0.085 - 0.66 * f, 0.04 * f)),
            0.088,
            rim=0.008,
        )
        for f in (0.14, 0.23, 0.32, 0.6, 0.69, 0.78)
    ]
    tip = [
        capsule(way[-1], (way[-1][0] - 0.16, way[-1][1] + 0.02, 0.03), 0.02),
        *(
            capsule(
                (way[-1][0] - 0.12, way[-1][1] + 0.02, 0.03),
                (way[-1][0] - 0.3, way[-1][1] + 0.02 + d, 0.03),
                0.014,
            )
            for d in (-0.06, 0.0, 0.06)
        ),
    ]
    return {"lash": lash, "handle": handle, "rings": rings, "wraps": wraps, "tassel": tip}


def _grappling_hook(draw: Draw) -> Parts:
    count = 3 + draw.which(2)
    prong = [
        pipe(
            [(0, 0, 0.0), (0, -0.1, -0.06), (0, -0.34, 0.02), (0, -0.5, 0.24), (0, -0.5, 0.42)],
            (0.05, 0.05, 0.046, 0.04, 0.022),
        ),
        rod((0, -0.5, 0.36), (0, -0.5, 0.56), 0.05, 0.004),
        rod((0, -0.5, 0.46), (0, -0.4, 0.3), 0.03, 0.006),
    ]
    steel = [
        *spun(prong, count),
        rod((0, 0, -0.1), (0, 0, 0.62), 0.06),
        ball(0.085, (0, 0, -0.08)),
        rod((0, 0, 0.56), (0, 0, 0.66), 0.085, rim=0.012),
        ring(0.085, 0.03, (0, 0, 0.74), "y"),
    ]
    t = np.linspace(0, 2 * np.pi * 2.6, 36)
    coil = [
        (0.62 + 0.3 * np.cos(a), -0.35 + 0.3 * np.sin(a), -0.08 + 0.05 * a / np.pi) for a in t[::-1]
    ]
    rope = [
        pipe(
            [
                (0, 0, 0.74),
                (0.06, -0.02, 0.9),
                (0.24, -0.06, 0.98),
                (0.6, -0.1, 0.7),
                (0.95, -0.2, 0.4),
                *coil,
            ],
            0.036,
        )
    ]
    rope += [rod((0.0, 0, 0.78), (0.06, -0.01, 0.9), 0.055, rim=0.012)]
    return {"hook": steel, "rope": rope}


NINJA_AND_ROPES: dict[str, Callable[[Draw], Parts]] = {
    "kunai": _kunai,
    "nunchucks": _nunchucks,
    "whip": _whip,
    "grappling hook": _grappling_hook,
}
