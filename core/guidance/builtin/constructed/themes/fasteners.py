"""Fasteners, hooks and what closes clothes."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import HEXAGON, screw_thread
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    box,
    capsule,
    circle,
    pipe,
    plate,
    ring,
    rod,
    rounded,
    turned,
)


def _nail(draw: Draw) -> Parts:
    long = draw(1.5, 1.8)
    shank = [
        rod((0, 0, 0), (0, 0, long), 0.07),
        rod((0, 0, 0.01), (0, 0, -0.2), 0.07, 0.006),
        rod((0, 0, long - 0.02), (0, 0, long + 0.06), 0.19, 0.18, 0.015),
    ]
    shank += [
        turned([(0.05, z), (0.078, z + 0.012), (0.05, z + 0.024)])
        for z in np.arange(long - 0.36, long - 0.04, 0.05)
    ]
    return {"shank": shank}


def _bolt(draw: Draw) -> Parts:
    long = draw(1.0, 1.2)
    steel = [
        plate(0.34 * HEXAGON, 0.24, (0, 0, 0.12)),
        rod((0, 0, 0.2), (0, 0, 0.27), 0.3, 0.24),
        rod((0, 0, -0.04), (0, 0, 0.03), 0.4, rim=0.015),
        rod((0, 0, -long), (0, 0, 0.0), 0.165, rim=0.02),
        *screw_thread(0.17, -long + 0.03, -0.34),
    ]
    nut = [
        plate(0.34 * HEXAGON, 0.24, (0, 0, -0.62 * long)),
        rod((0, 0, -0.62 * long - 0.13), (0, 0, -0.62 * long + 0.13), 0.28, rim=0.02),
    ]
    return {"bolt": steel, "nut": nut}


def _fishing_hook(draw: Draw) -> Parts:
    wide = draw(0.3, 0.36)
    way = [
        (0, 0.8),
        (0, 0.2),
        (0, -0.3),
        (0.1, -0.62),
        (wide, -0.76),
        (2 * wide - 0.1, -0.62),
        (2 * wide, -0.3),
        (2 * wide, -0.04),
    ]
    steel = [
        pipe([(x, 0, z) for x, z in way], (0.042, 0.042, 0.045, 0.05, 0.05, 0.046, 0.04, 0.024)),
        ring(0.075, 0.032, (0, 0, 0.9), "y"),
        rod((2 * wide, 0, -0.08), (2 * wide, 0, 0.16), 0.032, 0.004),
        rod((2 * wide - 0.02, 0, 0.02), (2 * wide - 0.14, 0, -0.14), 0.026, 0.006),
    ]
    fly = [
        rod((0, 0, 0.52), (0, 0, 0.68), 0.09, 0.06, 0.02),
        *(
            capsule((0, 0, 0.6), (0.26 * np.cos(a), 0.26 * np.sin(a), 0.26), 0.034, 0.012)
            for a in np.arange(9) * 2 * np.pi / 9
        ),
    ]
    thread = [rod((0, 0, z - 0.02), (0, 0, z + 0.02), 0.07, rim=0.008) for z in (0.1, 0.2, 0.3)]
    return {"hook": steel, "feathers": fly, "thread": thread}


def _safety_pin(draw: Draw) -> Parts:
    gape = draw(0.14, 0.34)
    steel = [
        pipe([(0.16, 0, 0.8), (0.16, 0, -0.6), (0.13, 0, -0.78), (0.0, 0, -0.86)], 0.036),
        pipe(
            [
                (0.0, 0, -0.86),
                (-0.12, 0, -0.78),
                (-0.15, 0, -0.6),
                (-0.13 - 0.5 * gape, 0, 0.1),
                (-0.1 - gape, 0, 0.78),
            ],
            (0.036, 0.036, 0.036, 0.034, 0.014),
        ),
        ring(0.09, 0.036, (0, 0.02, -0.82), "y"),
        ring(0.09, 0.034, (0, -0.05, -0.82), "y"),
    ]
    cap = [
        plate(rounded((0.5, 0.36), 0.12), 0.16, (0.02, 0, 0.86), FRONT),
        capsule((-0.2, 0, 0.72), (-0.2, 0, 0.9), 0.07),
    ]
    return {"wire": steel, "cap": cap}


def _button(draw: Draw) -> Parts:
    count = 4 if draw.which(3) else 2
    spots = (
        [(0.1 * s, 0.1 * t) for s in (-1, 1) for t in (-1, 1)]
        if count == 4
        else [(-0.11, 0), (0.11, 0)]
    )
    holes = [circle(0.06, spot, 20) for spot in spots]
    body = [plate(circle(0.5), 0.12, (0, 0, 0), FRONT, holes)]
    rim = [
        turned(
            [
                (0.36, -0.09),
                (0.42, -0.13),
                (0.5, -0.13),
                (0.56, -0.06),
                (0.56, 0.06),
                (0.5, 0.09),
                (0.36, 0.06),
            ],
            axis="y",
        )
    ]
    if count == 4:
        thread = [
            capsule((-0.1, -0.07, -0.1), (0.1, -0.085, 0.1), 0.03),
            capsule((-0.1, -0.075, 0.1), (0.1, -0.07, -0.1), 0.03),
        ]
    else:
        thread = [
            capsule((-0.11, -0.07, 0.02), (0.11, -0.07, 0.02), 0.026),
            capsule((-0.11, -0.07, -0.02), (0.11, -0.07, -0.02), 0.026),
        ]
    return {"body": body, "rim": rim, "thread": thread}


def _zipper(draw: Draw) -> Parts:
    at = draw(0.0, 0.3)
    cloth, teeth = [], []
    count = 26
    for s in (-1, 1):
        for k in range(count):
            z = -0.95 + 1.9 * k / (count - 1)
            x = s * (0.045 + max(z - at, 0.0) ** 1.5 * 0.34)
            teeth.append(box((0.13, 0.06, 0.042), (x + s * 0.012, 0, z + s * 0.018), 0.01))
        edge = [
            (s * (0.07 + max(z - at, 0.0) ** 1.5 * 0.34), z) for z in np.linspace(-1.0, 1.0, 21)
        ]
        outer = [
            (s * (0.36 + max(z - at, 0.0) ** 1.5 * 0.34), z) for z in np.linspace(1.0, -1.0, 21)
        ]
        cloth.append(plate([*edge, *outer], 0.03, (0, 0.0, 0), FRONT))
    slider = [
        plate(
            [(-0.13, -0.14), (0.13, -0.14), (0.18, 0.14), (-0.18, 0.14)], 0.13, (0, 0, at), FRONT
        ),
        box((0.08, 0.1, 0.18), (0, -0.08, at), 0.03),
    ]
    pull = [
        plate(
            rounded((0.14, 0.46), 0.06),
            0.04,
            (0, -0.13, at - 0.3),
            FRONT,
            [circle(0.035, (0, -0.15), 20)],
        ),
        ring(0.05, 0.018, (0, -0.12, at - 0.05), "x"),
    ]
    stop = [box((0.2, 0.08, 0.09), (0, 0, -0.98), 0.02)]
    return {"cloth": cloth, "teeth": teeth, "slider": [*slider, *stop], "pull": pull}


FASTENERS: dict[str, Callable[[Draw], Parts]] = {
    "nail": _nail,
    "bolt": _bolt,
    "fishing hook": _fishing_hook,
    "safety pin": _safety_pin,
    "button": _button,
    "zipper": _zipper,
}
