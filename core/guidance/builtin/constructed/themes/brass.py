"""Brass instruments that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    LEFTWARD,
    RIGHTWARD,
    Parts,
    ball,
    capsule,
    pipe,
    placed,
    ring,
    rod,
    turned,
)


def _saxophone(draw: Draw) -> Parts:
    keys = 7 + draw.which(3)
    way = [(0.3, 0.7), (0.2, 0.75), (0.12, 0.66), (0.08, 0.4), (0.02, 0.0), (-0.05, -0.42)]
    way += [(-0.12, -0.62), (-0.28, -0.68), (-0.42, -0.56), (-0.46, -0.3), (-0.49, -0.1)]
    radii = (0.024, 0.028, 0.034, 0.046, 0.07, 0.1, 0.118, 0.13, 0.142, 0.155, 0.165)
    tube = pipe([(x, 0, z) for x, z in way], radii)
    lean = Rotation.from_euler("y", -8, degrees=True).as_matrix()
    flare = [(0.1, 0.0), (0.155, 0.0), (0.17, 0.14), (0.2, 0.26), (0.26, 0.35), (0.33, 0.39)]
    inside = [(0.31, 0.41), (0.24, 0.37), (0.17, 0.27), (0.14, 0.14), (0.0, 0.06)]
    bell = placed([turned([(0, 0), *flare[1:], *inside])], lean, (-0.475, 0, -0.2))
    rims = [ring(0.095, 0.022, (-0.05, 0, -0.38)), ring(0.052, 0.016, (0.1, 0, 0.52))]
    brace = [
        rod((-0.08, 0, -0.2), (-0.42, 0, -0.16), 0.02),
        ring(0.06, 0.018, (-0.25, 0, -0.18), "y"),
    ]
    caps, rods = [], []
    for k, f in enumerate(np.linspace(0.0, 1.0, keys)):
        z = 0.5 - 0.86 * f
        x = float(np.interp(z, [-0.42, 0.0, 0.4, 0.66], [-0.05, 0.02, 0.08, 0.12]))
        r = float(np.interp(z, [-0.42, 0.0, 0.4, 0.66], [0.1, 0.07, 0.046, 0.034]))
        wide = 0.026 + 0.03 * f
        caps.append(rod((x, -r + 0.015, z), (x, -r - 0.045, z), wide, rim=0.008))
        caps.append(ball((0.5 * wide, 0.014, 0.5 * wide), (x, -r - 0.048, z)))
        if k % 2:
            caps.append(capsule((x, -r * 0.7, z), (x + r + 0.05, -0.05, z + 0.03), 0.013))
    for y in (-0.06, 0.05):
        rods.append(rod((0.16, y, 0.48), (0.07, y - 0.02, -0.4), 0.014))
        rods += [
            capsule((0.16, y, 0.48), (0.08, 0, 0.5), 0.016),
            capsule((0.07, y - 0.02, -0.4), (-0.02, 0, -0.4), 0.016),
        ]
    for z, x in ((-0.5, -0.32), (-0.3, -0.46), (-0.05, -0.48)):
        caps += [
            rod((x, -0.12, z), (x, -0.19, z), 0.075, rim=0.012),
            ball((0.03, 0.016, 0.03), (x, -0.19, z)),
        ]
    mouth = [(0.28, 0.0, 0.705), (0.38, 0.0, 0.66), (0.5, 0.0, 0.6)]
    return {
        "body": [tube, *bell, *rims, *brace],
        "keys": [*caps, *rods],
        "mouthpiece": [
            pipe(mouth, (0.04, 0.044, 0.022)),
            rod((0.33, 0, 0.684), (0.37, 0, 0.666), 0.054, rim=0.006),
        ],
    }


def _trumpet(draw: Draw) -> Parts:
    rise = draw(0.2, 0.24)
    flare = [
        (0.0, 0),
        (0.04, 0),
        (0.046, 0.2),
        (0.062, 0.34),
        (0.1, 0.46),
        (0.17, 0.54),
        (0.25, 0.58),
    ]
    inside = [(0.24, 0.6), (0.15, 0.57), (0.08, 0.48), (0.04, 0.34), (0.0, 0.3)]
    bell = placed([turned([*flare, *inside])], LEFTWARD, (-0.3, 0, rise))
    r = 0.03
    loop = [(-0.3, 0, rise), (0.4, 0, rise), (0.53, 0, rise - 0.04), (0.58, 0, 0.06)]
    loop += [(0.53, 0, -0.11), (0.4, 0, -0.15), (0.1, 0, -0.15)]
    lead = [
        (0.72, -0.0, rise - 0.06),
        (0.2, -0.08, rise - 0.06),
        (-0.36, -0.08, rise - 0.06),
        (-0.47, -0.08, rise - 0.1),
    ]
    lead += [(-0.5, -0.08, 0.02), (-0.47, -0.08, -0.11), (-0.36, -0.08, -0.15), (0.0, -0.08, -0.15)]
    body = [*bell, pipe(loop, r), pipe(lead, 0.026)]
    body += [rod((x, 0.0, rise), (x, 0, -0.15), 0.014) for x in (0.36,)]
    body += [
        rod((-0.3, 0.0, rise), (-0.3, -0.08, rise - 0.06), 0.016),
        rod((-0.3, -0.08, rise - 0.06), (-0.3, -0.08, -0.15), 0.014),
    ]
    body += [
        ring(0.05, 0.016, (0.46, -0.06, -0.05), "y"),
        rod((0.36, 0, -0.02), (0.42, -0.05, -0.03), 0.014),
    ]
    valves, buttons = [], []
    for x in (-0.12, 0.02, 0.16):
        valves += [rod((x, -0.04, -0.26), (x, -0.04, 0.24), 0.058, rim=0.006)]
        valves += [
            rod((x, -0.04, z - 0.018), (x, -0.04, z + 0.018), 0.066, rim=0.006)
            for z in (-0.22, 0.05, 0.21)
        ]
        valves += [
            rod((x, -0.04, 0.22), (x, -0.04, 0.33), 0.02),
            ball((0.03, 0.03, 0.02), (x, -0.04, -0.265)),
        ]
        buttons += [rod((x, -0.04, 0.31), (x, -0.04, 0.345), 0.045, rim=0.01)]
    cup = [(0, 0), (0.03, 0.0), (0.032, 0.12), (0.06, 0.18), (0.075, 0.2), (0.06, 0.215), (0, 0.18)]
    mouth = placed([turned(cup)], RIGHTWARD, (0.68, 0.0, rise - 0.06))
    return {"body": body, "valves": valves, "buttons": buttons, "mouthpiece": mouth}


BRASS: dict[str, Callable[[Draw], Parts]] = {
    "saxophone": _saxophone,
    "trumpet": _trumpet,
}
