"""Guitars that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    box,
    circle,
    closed_curve,
    pipe,
    plate,
    rod,
)


def _guitar(draw: Draw) -> Parts:
    waist, deep = draw(0.17, 0.21), draw(0.15, 0.19)
    half = [
        (0.16, -0.86),
        (0.31, -0.76),
        (0.35, -0.6),
        (0.29, -0.42),
        (waist + 0.03, -0.3),
        (waist + 0.04, -0.2),
        (0.25, -0.08),
        (0.2, 0.03),
        (0.09, 0.07),
    ]
    outline = closed_curve([(0, -0.88), *half, (0, 0.07), *((-x, z) for x, z in half[::-1])])
    inner = (outer_mid := outline.mean(0)) + 0.955 * (outline - outer_mid)
    front = -deep / 2
    hole = circle(0.092, (0, -0.28))
    body = [plate(inner, deep, (0, 0, 0), FRONT, [])]
    body += [plate(outline, 0.028, (0, y, 0), FRONT) for y in (front + 0.014, deep / 2 - 0.014)]
    neck = [
        box((0.1, 0.04, 0.78), (0, front + 0.01, 0.36), 0.016),
        box((0.092, 0.026, 0.98), (0, front - 0.018, 0.26), 0.004),
    ]
    head = [
        (-0.06, 0.72),
        (0.06, 0.72),
        (0.085, 0.8),
        (0.075, 1.04),
        (0.03, 1.02),
        (0, 1.05),
        (-0.03, 1.02),
        (-0.075, 1.04),
        (-0.085, 0.8),
    ]
    neck += [
        plate(head, 0.04, (0, front + 0.012, 0), FRONT),
        box((0.1, 0.05, 0.02), (0, front - 0.016, 0.735)),
    ]
    neck += [
        plate(
            [(front, -0.02), (front + 0.1, -0.02), (front + 0.02, 0.2), (front, 0.2)],
            0.08,
            (0, 0.0, 0),
            SIDE,
        )
    ]
    strings = [
        rod((x, front - 0.044, -0.62), (0.8 * x, front - 0.04, 0.74), 0.0065)
        for x in (-0.036, -0.022, -0.008, 0.008, 0.022, 0.036)
    ]
    strings += [
        rod((0.8 * x, front - 0.04, 0.73), (1.4 * x, front - 0.01, 0.9), 0.0065)
        for x in (-0.036, -0.022, -0.008, 0.008, 0.022, 0.036)
    ]
    bridge = [
        box((0.24, 0.03, 0.06), (0, front - 0.01, -0.62), 0.01),
        box((0.12, 0.05, 0.018), (0, front - 0.018, -0.6), 0.004),
    ]
    pegs = []
    for z in (0.82, 0.89, 0.96):
        for s in (-1, 1):
            pegs += [
                rod((s * 0.05, front + 0.012, z), (s * 0.125, front + 0.012, z), 0.01),
                ball((0.02, 0.012, 0.026), (s * 0.13, front + 0.012, z)),
                rod((s * 0.042, front, z), (s * 0.042, front - 0.03, z), 0.014),
            ]
    dark = [plate(hole, 0.012, (0, front - 0.0035, 0), FRONT)]
    return {"body": body, "neck": [*neck, *strings], "hole": dark, "bridge": bridge, "pegs": pegs}


def _electric_guitar(draw: Draw) -> Parts:
    horn = draw(0.2, 0.28)
    points = [
        (0, -0.84),
        (0.2, -0.8),
        (0.31, -0.62),
        (0.26, -0.42),
        (0.19, -0.26),
        (0.24, -0.1),
        (0.27, horn - 0.16),
        (0.2, horn - 0.12),
        (0.1, -0.02),
    ]
    points += [
        (0, -0.06),
        (-0.1, -0.02),
        (-0.2, horn),
        (-0.29, horn - 0.02),
        (-0.27, -0.14),
        (-0.2, -0.28),
        (-0.27, -0.44),
        (-0.32, -0.62),
        (-0.2, -0.8),
    ]
    outline = closed_curve(points)
    mid = outline.mean(0)
    body = [
        plate(outline, 0.09, (0, 0, 0), FRONT),
        plate(mid + 0.95 * (outline - mid), 0.12, (0, 0, 0), FRONT),
    ]
    front = -0.06
    neck = [
        box((0.1, 0.05, 0.84), (0, front + 0.012, 0.36), 0.016),
        box((0.092, 0.026, 0.92), (0, front - 0.018, 0.32), 0.004),
    ]
    head = [
        (-0.05, 0.74),
        (0.05, 0.74),
        (0.06, 0.86),
        (0.1, 1.1),
        (0.06, 1.14),
        (0.0, 1.12),
        (-0.1, 0.98),
        (-0.11, 0.86),
    ]
    neck += [
        plate(closed_curve(head), 0.045, (0, front + 0.012, 0), FRONT),
        box((0.1, 0.05, 0.02), (0, front - 0.016, 0.77)),
    ]
    strings = [
        rod((x, front - 0.055, -0.56), (0.82 * x, front - 0.042, 0.77), 0.0065)
        for x in (-0.037, -0.022, -0.008, 0.008, 0.022, 0.037)
    ]
    guard = [
        (0.0, -0.12),
        (0.14, -0.1),
        (0.18, -0.28),
        (0.24, -0.56),
        (0.18, -0.72),
        (0.02, -0.56),
        (-0.13, -0.5),
        (-0.12, -0.24),
        (-0.08, -0.1),
    ]
    pickups = [box((0.14, 0.04, 0.05), (0, front - 0.015, z), 0.012) for z in (-0.16, -0.3, -0.43)]
    pickups += [
        rod((x, front - 0.03, z), (x, front - 0.042, z), 0.009)
        for z in (-0.16, -0.3, -0.43)
        for x in np.linspace(-0.045, 0.045, 6)
    ]
    bridge = [
        box((0.15, 0.045, 0.07), (0, front - 0.018, -0.56), 0.012),
        pipe(
            [(0.06, front - 0.03, -0.56), (0.12, front - 0.08, -0.52), (0.16, front - 0.1, -0.36)],
            0.012,
        ),
    ]
    for k, z in enumerate(np.linspace(0.84, 1.06, 6)):
        x = -0.1 + 0.012 * k
        bridge += [
            rod((x + 0.03, front + 0.012, z), (x - 0.05, front + 0.012, z), 0.01),
            ball((0.022, 0.014, 0.022), (x - 0.055, front + 0.012, z)),
            rod((x + 0.055, front, z), (x + 0.055, front - 0.03, z), 0.014),
        ]

    knobs = [
        rod((x, front, z), (x, front - 0.055, z), 0.034, 0.026, 0.006)
        for x, z in ((0.15, -0.46), (0.2, -0.56), (0.18, -0.67))
    ]
    knobs += [
        rod((0.11, front, -0.36), (0.12, front - 0.07, -0.36), 0.011),
        ball(0.016, (0.12, front - 0.07, -0.36)),
    ]
    knobs += [
        rod((x, 0, z), (x, 0, z + s * 0.05), 0.016)
        for s, x, z in ((1, -0.25, horn - 0.02), (-1, 0.0, -0.83))
    ]
    return {
        "body": body,
        "neck": [*neck, *strings],
        "pickguard": [plate(closed_curve(guard), 0.02, (0, front - 0.006, 0), FRONT)],
        "pickups": pickups,
        "bridge": bridge,
        "knobs": knobs,
    }


GUITARS: dict[str, Callable[[Draw], Parts]] = {
    "guitar": _guitar,
    "electric guitar": _electric_guitar,
}
