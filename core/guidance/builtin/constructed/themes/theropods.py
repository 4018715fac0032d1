"""Dinosaurs on two legs."""

from collections.abc import Callable, Sequence

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import (
    along,
    aside,
    body,
    eyes_on,
    on_surface,
    spine,
    with_legs,
)
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    both_sides,
    rod,
    smooth_union,
)


def _foot(
    x: float, y: float, size: float, splay: float = 0.6
) -> tuple[list[Limb], list[Primitive]]:
    """Three toes of a left foot, and their claws."""
    toes, claws = [], []
    for k in (-1, 0, 1):
        a = splay * k
        way = np.array([np.sin(a), -np.cos(a)]) * size
        tip = np.array([x, y]) + way
        toes.append(
            aside(
                (x, y, 0.055, 0.34 * size),
                (*(np.array([x, y]) + 0.6 * way), 0.035, 0.24 * size),
                (*tip, 0.03, 0.2 * size),
            )
        )
        end = tip + 0.34 * way
        claws.append(rod((*(tip + 0.05 * way), 0.028), (*end, 0.008), 0.15 * size, 0.02 * size))
    return toes, claws


def _teeth(
    whole: Primitive, line: Sequence[tuple[float, float, float]], count: int, long: float, up: float
) -> list[Primitive]:
    """Cones of a jaw, along a broken line between the jaws; ``up``: 1 of the lower one."""
    found = []
    for t in np.linspace(0, 1, count):
        root = on_surface(whole, along(line, t), (0, 0, -up))
        found.append(
            rod(root - (0, 0, 0.4 * up * long), root + (0, 0, up * long), 0.34 * long, 0.03 * long)
        )
    return found


def _tyrannosaur(draw: Draw) -> Parts:
    trunk = spine(
        (-0.36, 0.84, 0.15, 0.85),
        (-0.16, 0.76, 0.205, 0.85),
        (0.08, 0.74, 0.225, 0.85),
        (0.28, 0.76, 0.18, 0.9),
    )
    lift = draw(-0.05, 0.1)
    tail = spine(
        (0.24, 0.78, 0.17, 0.9),
        (0.55, 0.76, 0.125, 0.85),
        (0.9, 0.72 + 0.4 * lift, 0.08, 0.85),
        (1.2, 0.7 + lift, 0.045, 0.9),
        (1.46, 0.72 + 1.6 * lift, 0.014, 1),
    )
    neck = spine((-0.3, 0.86, 0.16, 0.8), (-0.42, 1.02, 0.135, 0.85), (-0.48, 1.16, 0.125, 0.9))
    skull = spine(
        (-0.48, 1.22, 0.13, 0.9),
        (-0.62, 1.25, 0.13, 0.9),
        (-0.78, 1.21, 0.098, 0.85),
        (-0.93, 1.17, 0.083, 0.9),
    )
    jaw = spine((-0.52, 1.1, 0.085, 0.95), (-0.7, 1.03, 0.058, 0.95), (-0.88, 0.99, 0.045, 1.0))
    brow = aside((0.085, -0.6, 1.345, 0.032), (0.075, -0.7, 1.325, 0.028))
    arm = aside(
        (0.11, -0.34, 0.76, 0.06),
        (0.16, -0.36, 0.66, 0.04),
        (0.155, -0.45, 0.62, 0.03),
        (0.15, -0.5, 0.6, 0.026),
    )
    leg = aside(
        (0.1, 0.12, 0.72, 0.17),
        (0.16, 0.06, 0.52, 0.14),
        (0.165, 0.1, 0.38, 0.085),
        (0.16, 0.2, 0.24, 0.05),
        (0.16, 0.13, 0.09, 0.055),
        (0.16, 0.1, 0.06, 0.055),
    )
    toes, claws = _foot(0.16, 0.06, 0.12)
    fingers = [
        rod((0.15 + x, -0.5, 0.6), (0.15 + 1.6 * x, -0.55, 0.565), 0.016, 0.003)
        for x in (-0.018, 0.018)
    ]
    whole = body([trunk, tail, neck, skull, jaw], [brow, arm, leg, *toes], 0.026)
    belly = spine(
        (-0.44, 1.02, 0.1, 0.85),
        (-0.34, 0.8, 0.13, 0.85),
        (-0.16, 0.7, 0.175, 0.85),
        (0.08, 0.68, 0.195, 0.85),
        (0.3, 0.7, 0.13, 0.9),
        (0.6, 0.71, 0.1, 0.85),
        (0.95, 0.69 + 0.4 * lift, 0.055, 0.9),
    )
    belly = belly + np.array([0, -0.006, -0.006, 0.006, 0])
    gap = [(0.045, -0.7, 1.085), (0.04, -0.8, 1.07), (0.026, -0.88, 1.065), (0.006, -0.91, 1.065)]
    teeth = [*_teeth(whole, gap, 8, 0.045, -1.0), *_teeth(whole, gap[:3], 6, 0.034, 1.0)]
    return {
        "body": [whole],
        "belly": [smooth_union([belly], 0.02)],
        "teeth": both_sides([*teeth, *claws, *fingers]),
        "eyes": eyes_on(whole, (0, -0.645, 1.3), (-1, 0.3, 0), 0.026, 0.35),
    }


def _velociraptor(draw: Draw) -> Parts:
    trunk = spine(
        (-0.36, 0.84, 0.115, 0.85),
        (-0.18, 0.78, 0.15, 0.85),
        (0.04, 0.77, 0.155, 0.85),
        (0.22, 0.8, 0.125, 0.9),
    )
    lift = draw(0.0, 0.14)
    tail = spine(
        (0.2, 0.81, 0.115, 0.9),
        (0.5, 0.83 + 0.2 * lift, 0.07, 0.9),
        (0.9, 0.86 + 0.6 * lift, 0.042, 0.9),
        (1.3, 0.92 + lift, 0.024, 1),
        (1.55, 0.97 + 1.3 * lift, 0.01, 1),
    )
    neck = spine(
        (-0.34, 0.88, 0.11, 0.8),
        (-0.48, 1.02, 0.08, 0.85),
        (-0.52, 1.18, 0.07, 0.9),
        (-0.56, 1.27, 0.075, 0.9),
    )
    skull = spine(
        (-0.54, 1.3, 0.078, 0.9),
        (-0.64, 1.31, 0.074, 0.9),
        (-0.78, 1.275, 0.048, 0.9),
        (-0.9, 1.26, 0.036, 0.95),
    )
    jaw = spine((-0.58, 1.235, 0.042, 0.95), (-0.74, 1.2, 0.028, 0.95), (-0.87, 1.185, 0.02, 1.0))
    arm = aside(
        (0.09, -0.34, 0.8, 0.055),
        (0.13, -0.3, 0.68, 0.038),
        (0.13, -0.44, 0.62, 0.028),
        (0.13, -0.52, 0.66, 0.024),
    )
    leg = aside(
        (0.08, 0.1, 0.76, 0.12),
        (0.12, 0.0, 0.58, 0.1),
        (0.12, 0.1, 0.4, 0.055),
        (0.118, 0.17, 0.27, 0.036),
        (0.115, 0.1, 0.1, 0.036),
        (0.115, 0.07, 0.05, 0.036),
    )
    toes, claws = _foot(0.115, 0.03, 0.1)
    whole = body([trunk, tail, neck, skull, jaw], [arm, leg, *toes], 0.022)
    sickle = smooth_union(
        [aside((0.1, 0.02, 0.08, 0.02), (0.09, -0.03, 0.14, 0.018), (0.088, -0.08, 0.1, 0.005))],
        0.005,
    )
    fingers = [
        smooth_union(
            [
                aside(
                    (0.13 + x, -0.52, 0.655, 0.018),
                    (0.13 + 1.5 * x, -0.59, 0.64, 0.014),
                    (0.13 + 1.6 * x, -0.62, 0.59, 0.004),
                )
            ],
            0.005,
        )
        for x in (-0.022, 0.0, 0.022)
    ]
    belly = spine(
        (-0.51, 1.2, 0.05, 0.9),
        (-0.48, 1.0, 0.062, 0.85),
        (-0.34, 0.8, 0.1, 0.85),
        (-0.16, 0.72, 0.125, 0.85),
        (0.06, 0.71, 0.125, 0.85),
        (0.26, 0.76, 0.085, 0.9),
    )
    belly = belly + np.array([0, -0.008, -0.006, 0.006, 0])
    stripes = []
    for k in range(11):
        y = -0.3 + 0.12 * k
        wide = float(np.interp(y, (-0.3, 0.04, 0.9), (0.1, 0.13, 0.035)))
        over = [
            on_surface(whole, (x, y + 0.15 * abs(x), 2.0), (0, 0, -1))
            for x in np.linspace(-0.66, 0.66, 9) * wide
        ]
        stripes.append(smooth_union([aside(*((*p, 0.019) for p in over))], 0.005))
    crest = smooth_union(
        [
            spine((-0.56, 1.38, 0.03, 0.4), (-0.5, 1.43, 0.026, 0.4), (-0.42, 1.45, 0.006, 0.6)),
            spine((-0.54, 1.36, 0.03, 0.4), (-0.46, 1.38, 0.024, 0.4), (-0.38, 1.37, 0.006, 0.6)),
        ],
        0.01,
    )
    return {
        "body": [whole],
        "belly": [smooth_union([belly], 0.02)],
        "stripes": [*stripes, crest],
        "claws": both_sides([*claws, sickle, *fingers]),
        "eyes": eyes_on(whole, (0, -0.655, 1.325), (-1, 0.3, 0), 0.022, 0.35),
    }


THEROPODS: dict[str, Callable[[Draw], Parts]] = {
    "dinosaur": with_legs(_tyrannosaur, 0.95, 1.05),
    "velociraptor": with_legs(_velociraptor, 0.95, 1.05),
}
