"""A stadium, train tracks, a water wheel, an oil rig."""

from collections.abc import Callable

import numpy as np

from core.geometry.parts.primitives import Loop
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    moved,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _stadium(draw: Draw) -> Parts:
    t = np.linspace(0, 2 * np.pi, 97)[:-1]

    def oval(scale: float, grow: float = 0.0) -> Loop:
        power = 0.72
        x, y = np.cos(t), np.sin(t)
        return np.stack(
            [
                (scale + grow) * np.sign(x) * np.abs(x) ** power,
                0.78 * (scale + grow) * np.sign(y) * np.abs(y) ** power,
            ],
            1,
        )

    stands = [
        plate(
            oval(0.94 - 0.075 * k),
            0.05 + 0.36 - 0.06 * k,
            (0, 0, (0.41 - 0.06 * k) / 2 - 0.01),
            FLAT,
            [oval(0.5)],
        )
        for k in range(6)
    ]
    walls = [plate(oval(1.0), 0.46, (0, 0, 0.22), FLAT, [oval(0.92)])]
    ribs = []
    for a in np.arange(32) * 2 * np.pi / 32:
        x, y = np.cos(a), np.sin(a)
        at = np.array([1.0 * np.sign(x) * abs(x) ** 0.72, 0.78 * np.sign(y) * abs(y) ** 0.72])
        ribs.append(rod((*at, 0.0), (*(1.04 * at), 0.6), 0.022))
        ribs.append(rod((*(1.04 * at), 0.6), (*(0.74 * at), 0.68), 0.018))
    roof = [
        plate(oval(1.06), 0.03, (0, 0, 0.6), FLAT, [oval(draw(0.82, 0.88))]),
        plate(oval(0.9), 0.03, (0, 0, 0.64), FLAT, [oval(0.72)]),
    ]
    pitch = [plate(oval(0.52), 0.05, (0, 0, 0.01))]
    lines = [box((0.62, 0.012, 0.012), (0, y, 0.037)) for y in (-0.22, 0.22)]
    lines += [box((0.012, 0.452, 0.012), (x, 0, 0.037)) for x in (-0.31, 0.0, 0.31)]
    lines += [ring(0.075, 0.008, (0, 0, 0.036))]
    lights = []
    for x, y in ((0.79, 0.6), (-0.79, 0.6), (0.79, -0.6), (-0.79, -0.6)):
        lights += [
            rod((x, y, 0.2), (1.02 * x, 1.02 * y, 0.98), 0.022),
            box(
                (0.2, 0.05, 0.13),
                (1.02 * x, 1.02 * y, 1.0),
                0.01,
                (0, 0, np.degrees(np.arctan2(-x, y)) if y > 0 else np.degrees(np.arctan2(x, -y))),
            ),
        ]
    return {
        "walls": walls,
        "stands": stands,
        "roof": roof,
        "ribs": [*ribs, *lights],
        "pitch": pitch,
        "lines": lines,
    }


def _train_tracks(draw: Draw) -> Parts:
    count = 11 + draw.which(3)
    long = 0.2 * count
    bed = [(-0.62, 0), (0.62, 0), (0.46, 0.12), (-0.46, 0.12)]
    sleepers = [
        box((0.86, 0.1, 0.07), (0, -long / 2 + 0.2 * (k + 0.5), 0.135), 0.012) for k in range(count)
    ]
    rail = [
        (-0.05, 0),
        (0.05, 0),
        (0.05, 0.02),
        (0.016, 0.03),
        (0.016, 0.08),
        (0.034, 0.085),
        (0.034, 0.115),
        (-0.034, 0.115),
        (-0.034, 0.085),
        (-0.016, 0.08),
        (-0.016, 0.03),
        (-0.05, 0.02),
    ]
    rails = both_sides([plate(rail, long + 0.06, (0.29, 0, 0.165), FRONT)])
    spikes = both_sides(
        [
            ball(0.018, (0.29 + s * 0.055, -long / 2 + 0.2 * (k + 0.5), 0.182))
            for k in range(count)
            for s in (-1, 1)
        ]
    )
    stones = []
    rng = np.random.default_rng(draw.which(1000))
    for _ in range(90):
        x, y = rng.uniform(-0.56, 0.56), rng.uniform(-long / 2 + 0.04, long / 2 - 0.04)
        z = min(0.12, (0.62 - abs(x)) * 0.75)
        stones.append(ball(tuple(rng.uniform(0.022, 0.042, 3)), (x, y, z)))
    return {
        "rails": rails,
        "sleepers": sleepers,
        "bed": [plate(bed, long + 0.04, (0, 0, 0), FRONT), *stones],
        "spikes": spikes,
    }


def _water_wheel(draw: Draw) -> Parts:
    count = 12 + 2 * draw.which(2)
    r, wide = 0.62, 0.3
    rims, spokes, paddles = [], [], []
    for x in (-wide / 2, wide / 2):
        rims.append(
            turned(
                [(r - 0.07, -0.025), (r + 0.01, -0.025), (r + 0.01, 0.025), (r - 0.07, 0.025)],
                (x, 0, 0),
                "x",
            )
        )
        spokes += moved(
            spun([box((0.04, 0.05, r - 0.05), (0, 0, r / 2), 0.006)], 8, "x"), (x, 0, 0)
        )
    paddles = spun(
        [box((wide + 0.06, 0.03, 0.2), (0, 0, r + 0.01), 0.006, (-18, 0, 0))], count, "x"
    )
    spokes += [
        rod((-wide - 0.16, 0, 0), (wide + 0.16, 0, 0), 0.055),
        *(rod((x - 0.05, 0, 0), (x + 0.05, 0, 0), 0.12, rim=0.01) for x in (-wide / 2, wide / 2)),
    ]
    frame = []
    for x in (-wide - 0.06, wide + 0.06):
        frame += [rod((x, s * 0.5, -0.86), (x, s * 0.03, 0.06), 0.045) for s in (-1, 1)]
        frame += [
            box((0.1, 1.2, 0.08), (x, 0, -0.86), 0.01),
            box((0.08, 0.62, 0.06), (x, 0, -0.42), 0.008),
            box((0.12, 0.2, 0.14), (x, 0, 0.02), 0.015),
        ]
    frame += [box((2 * wide + 0.2, 0.09, 0.07), (0, y, -0.85), 0.01) for y in (-0.54, 0.54)]
    top = r + 0.18
    frame += [
        box((0.34, 0.6, 0.03), (0, 0.5, top), 0.004),
        *both_sides(
            [
                box((0.03, 0.6, 0.1), (0.155, 0.5, top + 0.04), 0.004),
                rod((0.14, 0.74, top), (wide + 0.06, 0.52, -0.84), 0.03),
            ]
        ),
    ]
    water = [box((0.28, 0.58, 0.06), (0, 0.5, top + 0.035))]
    fall = [
        (0.22, top + 0.03),
        (0.1, top + 0.02),
        (0.03, top - 0.06),
        (0.04, top - 0.12),
        (0.1, top - 0.1),
        (0.24, top),
    ]
    water += [plate(fall, 0.24, (0, 0, 0), SIDE)]
    return {"rims": rims, "paddles": paddles, "spokes": spokes, "frame": frame, "water": water}


def _oil_rig(draw: Draw) -> Parts:
    legs, deck, derrick, yellow = [], [], [], []
    for x in (-0.5, 0.5):
        for y in (-0.4, 0.4):
            legs += [
                rod((x, y, -0.7), (x, y, 0.1), 0.075),
                rod((x, y, -0.74), (x, y, -0.64), 0.13, 0.11, 0.01),
            ]
    for z in (-0.45, -0.1):
        legs += [rod((-0.5, y, z), (0.5, y, z), 0.028) for y in (-0.4, 0.4)] + [
            rod((x, -0.4, z), (x, 0.4, z), 0.028) for x in (-0.5, 0.5)
        ]
    legs += [
        rod((-s * 0.5, y, -0.45), (s * 0.5, y, -0.1), 0.02) for s in (-1, 1) for y in (-0.4, 0.4)
    ]
    legs += [
        rod((x, -s * 0.4, -0.45), (x, s * 0.4, -0.1), 0.02) for s in (-1, 1) for x in (-0.5, 0.5)
    ]
    deck += [
        box((1.3, 1.06, 0.1), (0, 0, 0.1), 0.01),
        box((1.16, 0.94, 0.06), (0, 0, 0.01), 0.01),
        box((0.5, 0.4, 0.22), (-0.34, -0.22, 0.25), 0.015),
        box((0.36, 0.34, 0.14), (-0.38, -0.22, 0.42), 0.012),
    ]
    deck += [
        box((0.4, 0.26, 0.16), (0.38, -0.3, 0.22), 0.012),
        rod((0.34, 0.3, 0.14), (0.34, 0.3, 0.36), 0.11, rim=0.02),
        rod((0.54, 0.3, 0.14), (0.54, 0.3, 0.34), 0.08, rim=0.02),
    ]
    rail = []
    for a, b in (
        ((-0.63, -0.51), (0.63, -0.51)),
        ((0.63, -0.51), (0.63, 0.51)),
        ((0.63, 0.51), (-0.63, 0.51)),
        ((-0.63, 0.51), (-0.63, -0.51)),
    ):
        rail += [rod((*a, z), (*b, z), 0.011) for z in (0.2, 0.25)]
        rail += [rod((*p, 0.14), (*p, 0.255), 0.011) for p in np.linspace(a, b, 8)[:-1]]
    foot, top, high = 0.2, 0.06, draw(0.95, 1.1)
    base = np.array([0.02, 0.12, 0.14])
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    levels = np.linspace(0, 1, 7)
    for a, b in zip(corners, [*corners[1:], corners[0]], strict=True):
        pts = [
            (
                base
                + np.array(
                    [(foot + (top - foot) * f) * a[0], (foot + (top - foot) * f) * a[1], high * f]
                ),
                base
                + np.array(
                    [(foot + (top - foot) * f) * b[0], (foot + (top - foot) * f) * b[1], high * f]
                ),
            )
            for f in levels
        ]
        derrick += [capsule(pts[0][0], pts[-1][0], 0.02)]
        derrick += [rod(p, q, 0.012) for p, q in pts]
        derrick += [rod(pts[k][k % 2], pts[k + 1][1 - k % 2], 0.011) for k in range(6)]
    derrick += [
        box((0.2, 0.2, 0.05), tuple(base + (0, 0, high)), 0.008),
        rod(tuple(base), tuple(base + (0, 0, high)), 0.014),
        box((0.08, 0.08, 0.12), tuple(base + (0, 0, 0.55 * high)), 0.01),
    ]
    legs += [rod((0.02, 0.12, -0.72), (0.02, 0.12, 0.06), 0.04)]
    yellow += [
        rod((0.5, -0.34, 0.28), (0.5, -0.34, 0.46), 0.05),
        box((0.12, 0.12, 0.1), (0.5, -0.34, 0.48), 0.012),
        capsule((0.5, -0.34, 0.5), (0.94, -0.62, 0.86), 0.024),
        rod((0.93, -0.61, 0.85), (0.93, -0.61, 0.5), 0.0095),
        box((0.05, 0.05, 0.06), (0.93, -0.61, 0.5), 0.01),
    ]
    yellow += [
        rod((-0.66, 0.36, 0.16), (-1.0, 0.5, 0.5), 0.016),
        rod((-0.5, 0.36, 0.12), (-0.68, 0.37, 0.17), 0.03),
    ]
    pad = [
        rod((-0.56, 0.3, 0.36), (-0.56, 0.3, 0.4), 0.24, rim=0.008),
        rod((-0.5, 0.3, 0.12), (-0.52, 0.3, 0.37), 0.04),
    ]
    mark = [
        box((0.03, 0.2, 0.016), (-0.62, 0.3, 0.402)),
        box((0.03, 0.2, 0.016), (-0.5, 0.3, 0.402)),
        box((0.12, 0.03, 0.016), (-0.56, 0.3, 0.402)),
        ring(0.2, 0.01, (-0.56, 0.3, 0.4)),
    ]
    flame = [
        turned([(0, -0.02), (0.04, 0.02), (0.05, 0.07), (0.02, 0.15), (0, 0.19)], (-1.0, 0.5, 0.5))
    ]
    return {
        "legs": legs,
        "deck": [*deck, *rail],
        "derrick": derrick,
        "crane": yellow,
        "pad": pad,
        "markings": mark,
        "flame": flame,
    }


STRUCTURES: dict[str, Callable[[Draw], Parts]] = {
    "stadium": _stadium,
    "train tracks": _train_tracks,
    "water wheel": _water_wheel,
    "oil rig": _oil_rig,
}
