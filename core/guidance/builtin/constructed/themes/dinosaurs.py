"""Dinosaurs on four legs."""

from collections.abc import Callable

import numpy as np

from core.geometry.parts.limbs import Limb
from core.guidance.builtin.constructed.anatomy import (
    along,
    aside,
    body,
    eyes_on,
    nails,
    on_surface,
    spine,
    with_legs,
)
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    SIDE,
    Parts,
    ball,
    both_sides,
    closed_curve,
    moved,
    plate,
    rod,
    smooth_union,
)

FEET = [(0.18, -0.28), (0.175, 0.3)]  # x and y of the left ones


def _bulk(high: float, fat: float) -> tuple[list[Limb], list[Limb]]:
    """The trunk and the legs of a heavy one whose back is about so high."""
    trunk = spine(
        (-0.4, 0.62 * high, 0.17 * fat, 0.9),
        (-0.16, 0.66 * high, 0.235 * fat, 0.92),
        (0.12, 0.7 * high, 0.25 * fat, 0.95),
        (0.36, 0.68 * high, 0.2 * fat, 0.95),
    )
    front = aside(
        (0.13, -0.3, 0.58 * high, 0.115),
        (0.19, -0.28, 0.4 * high, 0.085),
        (0.18, -0.26, 0.24 * high, 0.07),
        (0.18, -0.27, 0.09, 0.07),
        (0.18, -0.28, 0.06, 0.075),
    )
    hind = aside(
        (0.12, 0.3, 0.62 * high, 0.16),
        (0.18, 0.28, 0.44 * high, 0.12),
        (0.175, 0.34, 0.26 * high, 0.08),
        (0.175, 0.32, 0.09, 0.074),
        (0.175, 0.3, 0.06, 0.078),
    )
    return [trunk], [front, hind]


def _triceratops(draw: Draw) -> Parts:
    trunk, legs = _bulk(0.94, 1.05)
    tail = spine(
        (0.34, 0.64, 0.17, 0.95),
        (0.62, 0.52, 0.11, 0.95),
        (0.9, 0.38, 0.06, 1),
        (1.08, 0.32, 0.02, 1),
    )
    neck = spine((-0.38, 0.62, 0.16, 0.9), (-0.56, 0.6, 0.15, 0.9))
    head = spine((-0.56, 0.6, 0.15, 0.95), (-0.72, 0.55, 0.12, 0.9), (-0.9, 0.46, 0.085, 0.8))
    cheek = aside((0.1, -0.62, 0.52, 0.06), (0.15, -0.58, 0.46, 0.02))
    whole = body([*trunk, tail, neck, head], [*legs, cheek], 0.028)
    size = draw(0.92, 1.1)
    rim = [
        np.array((0.02 + 0.36 * np.sin(a) * size, 0.1 + 0.4 * np.cos(a) * size))
        for a in np.linspace(-2.1, 2.1, 17)
    ]
    c, s = np.cos(np.radians(32)), np.sin(np.radians(32))
    frame = np.array([[1, 0, 0], [0, s, -c], [0, c, s]])
    outline = closed_curve([p - (0.02, 0) for p in rim])
    at = np.array((0, -0.5, 0.68))
    frill = [plate(outline, 0.05, at, frame)]
    for a in np.linspace(-1.9, 1.9, 13):
        p = at + frame @ np.array([0.355 * np.sin(a) * size, 0.1 + 0.4 * np.cos(a) * size, 0.0])
        out = frame @ np.array([np.sin(a), np.cos(a), 0.0])
        frill.append(rod(p - 0.02 * out, p + 0.055 * out, 0.032, 0.004))
    long = draw(0.85, 1.15)
    horns = both_sides(
        [
            smooth_union(
                [
                    aside(
                        (0.085, -0.66, 0.66, 0.045),
                        (0.11, -0.8, 0.72 + 0.02 * long, 0.034),
                        (0.12, -0.8 - 0.2 * long, 0.78 + 0.06 * long, 0.006),
                    )
                ],
                0.005,
            )
        ]
    )
    horns.append(
        smooth_union(
            [spine((-0.88, 0.54, 0.045, 0.9), (-0.93, 0.62, 0.03, 0.9), (-0.94, 0.67, 0.006, 1))],
            0.005,
        )
    )
    bill = spine((-0.9, 0.46, 0.085, 0.75), (-0.97, 0.42, 0.062, 0.7), (-1.01, 0.35, 0.014, 0.8))
    return {
        "body": [whole],
        "frill": frill,
        "horns": horns,
        "bill": [smooth_union([bill], 0.01)],
        "hooves": nails(FEET, 0.078, 40, 0.026),
        "eyes": eyes_on(whole, (0, -0.71, 0.6), (-1, 0.3, 0), 0.022, 0.35),
    }


def _stegosaurus(draw: Draw) -> Parts:
    trunk = spine(
        (-0.44, 0.5, 0.14, 0.9),
        (-0.16, 0.6, 0.215, 0.85),
        (0.12, 0.7, 0.25, 0.82),
        (0.36, 0.68, 0.2, 0.85),
    )
    _, legs = _bulk(0.86, 1.0)
    tail = spine(
        (0.34, 0.66, 0.17, 0.9),
        (0.64, 0.6, 0.11, 0.9),
        (0.95, 0.55, 0.06, 1),
        (1.22, 0.56, 0.024, 1),
    )
    neck = spine((-0.42, 0.48, 0.12, 0.85), (-0.6, 0.42, 0.085, 0.9))
    head = spine((-0.62, 0.42, 0.078, 0.9), (-0.74, 0.39, 0.066, 0.9), (-0.86, 0.36, 0.042, 0.9))
    whole = body([trunk, tail, neck, head], legs, 0.028)
    belly = spine(
        (-0.5, 0.43, 0.085, 0.9),
        (-0.34, 0.48, 0.12, 0.9),
        (-0.14, 0.52, 0.165, 0.85),
        (0.12, 0.58, 0.175, 0.85),
        (0.34, 0.6, 0.13, 0.9),
    ) + np.array([0, 0, -0.016, 0.008, 0])
    plates = []
    back = [
        (0, -0.52, 0.55),
        (0, -0.36, 0.68),
        (0, -0.16, 0.82),
        (0, 0.08, 0.94),
        (0, 0.28, 0.9),
        (0, 0.48, 0.8),
        (0, 0.68, 0.7),
        (0, 0.88, 0.62),
    ]
    for k, t in enumerate(np.linspace(0, 1, 13)):
        _, y, z = along(back, t)
        high = (0.09 + 0.24 * np.sin(np.pi * min(t * 0.95 + 0.06, 1))) * draw(0.95, 1.05)
        wide = 0.52 * high + 0.02
        leaf = closed_curve(
            [
                (0, high),
                (0.5 * wide, 0.55 * high),
                (0.4 * wide, 0.0),
                (0, -0.06),
                (-0.4 * wide, 0.0),
                (-0.5 * wide, 0.55 * high),
            ]
        )
        x = 0.045 if k % 2 else -0.045
        plates += moved([plate(leaf, 0.028, (0, 0, 0), SIDE)], (x, y, z - 0.035))
    spikes = []
    for y in (1.02, 1.14):
        spikes.append(
            smooth_union(
                [
                    aside(
                        (0.02, y, 0.57, 0.026),
                        (0.1, y + 0.06, 0.63, 0.02),
                        (0.2, y + 0.14, 0.7, 0.004),
                    )
                ],
                0.004,
            )
        )
    return {
        "body": [whole],
        "belly": [smooth_union([belly], 0.02)],
        "plates": plates,
        "spikes": both_sides(spikes),
        "hooves": nails(FEET, 0.078, 40, 0.026),
        "eyes": eyes_on(whole, (0, -0.72, 0.43), (-1, 0.3, 0), 0.018, 0.35),
    }


def _brachiosaurus(draw: Draw) -> Parts:
    trunk, legs = _bulk(1.0, 1.02)
    rise = draw(-0.08, 0.08)
    neck = spine(
        (-0.3, 0.78, 0.18, 0.9),
        (-0.5, 1.0, 0.125, 0.9),
        (-0.62, 1.3, 0.092, 0.95),
        (-0.68, 1.62 + rise, 0.072, 1),
        (-0.74, 1.76 + rise, 0.068, 1),
    )
    head = spine(
        (-0.74, 1.78 + rise, 0.075, 0.9),
        (-0.84, 1.79 + rise, 0.072, 0.9),
        (-0.97, 1.745 + rise, 0.05, 1.0),
    )
    crown = spine((-0.78, 1.83 + rise, 0.05, 0.8), (-0.85, 1.83 + rise, 0.04, 0.8))
    tail = spine(
        (0.34, 0.68, 0.18, 0.95),
        (0.64, 0.54, 0.12, 0.95),
        (0.96, 0.36, 0.07, 1),
        (1.28, 0.24, 0.04, 1),
        (1.52, 0.2, 0.012, 1),
    )
    whole = body([*trunk, neck, head, crown, tail], legs, 0.03)
    belly = spine(
        (-0.715, 1.6 + rise, 0.05, 1),
        (-0.66, 1.3, 0.07, 0.95),
        (-0.54, 1.0, 0.1, 0.9),
        (-0.36, 0.7, 0.14, 0.9),
        (-0.14, 0.57, 0.18, 0.92),
        (0.12, 0.59, 0.195, 0.95),
        (0.38, 0.62, 0.15, 0.95),
        (0.66, 0.51, 0.095, 0.95),
    ) + np.array([0, -0.008, -0.012, 0.008, 0])
    spots = []
    for k in range(14):
        y, x = -0.34 + 0.095 * k, 0.055 * (-1) ** k
        p = on_surface(whole, (x, y, 2.0), (0, 0, -1))
        r = 0.034 + 0.016 * ((k * 7) % 3)
        spots.append(ball((r, r, 0.5 * r), p - (0, 0, 0.25 * r)))
    return {
        "body": [whole],
        "belly": [smooth_union([belly], 0.02)],
        "spots": spots,
        "nails": nails(FEET, 0.078, 40, 0.026),
        "eyes": eyes_on(whole, (0, -0.84, 1.81 + rise), (-1, 0.3, 0), 0.02, 0.35),
    }


DINOSAURS: dict[str, Callable[[Draw], Parts]] = {
    "triceratops": with_legs(_triceratops, 0.9, 1.05),
    "stegosaurus": with_legs(_stegosaurus, 0.92, 1.05),
    "brachiosaurus": with_legs(_brachiosaurus, 0.94, 1.06),
}
