"""Large ships that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    placed,
    plate,
    rod,
)


def _hull(wide: float, bow: float, stern: float) -> np.ndarray:
    """A ship's outline from above, its bow towards -y."""
    half = [
        (0.0, -bow),
        (0.5 * wide, -0.8 * bow),
        (0.9 * wide, -0.5 * bow),
        (wide, -0.15 * bow),
        (wide, 0.75 * stern),
        (0.86 * wide, stern),
    ]
    return np.array([*half, *((-x, y) for x, y in half[:0:-1])])


def _cargo_ship(draw: Draw) -> Parts:
    wide = 0.26
    hull = [
        plate(
            _hull(wide * (0.86 + 0.14 * k / 4), 1.32 + 0.04 * k, 1.22),
            0.056,
            (0, 0, -0.02 + 0.05 * k),
        )
        for k in range(5)
    ]
    hull += [
        plate(
            _hull(wide + 0.012, 1.5, 1.24), 0.09, (0, 0, 0.24), FLAT, [_hull(wide - 0.02, 1.4, 1.2)]
        ),
        plate(_hull(wide, 1.47, 1.23), 0.03, (0, 0, 0.21)),
    ]
    front = _hull(wide + 0.008, 1.5, 1.2)
    hull += [
        plate(front[front[:, 1] < -0.85], 0.12, (0, 0, 0.27)),
        ball((0.09, 0.16, 0.07), (0, -1.32, -0.14)),
    ]
    keel = [
        plate(
            _hull(wide * (0.6 + 0.24 * k / 3), 1.22 + 0.04 * k, 1.16),
            0.062,
            (0, 0, -0.2 + 0.055 * k),
        )
        for k in range(4)
    ]
    orange, green = [], []
    rng = np.random.default_rng(draw.which(1000))
    for j in range(9):
        y = -0.8 + 0.18 * j
        for i in range(4):
            x = -0.165 + 0.11 * i
            for level in range(int(rng.integers(2, 5))):
                (orange if rng.uniform() < 0.55 else green).append(
                    box((0.104, 0.17, 0.108), (x, y, 0.27 + 0.102 * level), 0.004)
                )
    white = [
        box((0.46, 0.26, 0.56), (0, 0.98, 0.48), 0.008),
        box((0.62, 0.18, 0.1), (0, 0.94, 0.8), 0.01),
        box((0.4, 0.2, 0.06), (0, 0.97, 0.87), 0.01),
        box((0.16, 0.16, 0.3), (0, 1.1, 0.74), 0.015),
        rod((0, 0.92, 0.86), (0, 0.92, 1.1), 0.016),
        rod((-0.1, 0.92, 1.02), (0.1, 0.92, 1.02), 0.014),
    ]
    white += [
        rod((0, -1.28, 0.28), (0, -1.28, 0.62), 0.016),
        *(
            box((0.5, 0.03, 0.34), (0, y, 0.38), 0.004)
            for y in (-0.71 + 0.36 * k for k in range(4))
        ),
    ]
    glass = [
        box((0.56, 0.02, 0.05), (0, 0.85, 0.81), 0.004),
        *(
            box((0.05, 0.02, 0.05), (x, 0.849, z), 0.004)
            for x in (-0.16, -0.05, 0.06, 0.17)
            for z in (0.6, 0.7)
        ),
        *both_sides(
            [
                box((0.02, 0.04, 0.05), (0.229, y, z), 0.004)
                for y in (0.92, 1.04)
                for z in (0.5, 0.6, 0.7)
            ]
        ),
    ]
    return {
        "hull": hull,
        "keel": keel,
        "containers": orange,
        "boxes": green,
        "bridge": white,
        "windows": glass,
    }


def _cruise_ship(draw: Draw) -> Parts:
    wide, floors = 0.27, 4 + draw.which(2)
    hull = [
        plate(
            _hull(wide * (0.82 + 0.18 * k / 4), 1.3 + 0.05 * k, 1.16 + 0.02 * k),
            0.056,
            (0, 0, -0.02 + 0.05 * k),
        )
        for k in range(7)
    ]
    keel = [
        plate(
            _hull(wide * (0.58 + 0.24 * k / 3), 1.2 + 0.04 * k, 1.12),
            0.062,
            (0, 0, -0.2 + 0.055 * k),
        )
        for k in range(4)
    ]
    decks, glass = [], []
    for k in range(floors):
        z, w, bow, stern = 0.3 + 0.1 * k, wide - 0.012 - 0.014 * k, 1.12 - 0.11 * k, 1.12 - 0.09 * k
        outline = _hull(w, bow, stern)
        decks += [
            plate(outline, 0.104, (0, 0, z + 0.04)),
            plate(outline * (1.05, 1.015), 0.024, (0, 0, z + 0.092)),
        ]
        for y in np.arange(-0.13 * bow, 0.72 * stern, 0.1):
            glass += both_sides([box((0.02, 0.06, 0.045), (w, y, z + 0.04), 0.004)])
    top = 0.3 + 0.1 * floors
    decks += [
        box((0.3, 0.2, 0.1), (0, -0.62, top + 0.03), 0.02),
        rod((0, -0.3, top), (0, -0.3, top + 0.3), 0.016),
        ball((0.05, 0.05, 0.05), (0, -0.46, top + 0.03)),
        box((0.26, 0.5, 0.03), (0, -0.02, top + 0.01), 0.01),
    ]
    glass += [
        box((0.26, 0.02, 0.05), (0, -0.722, top + 0.04), 0.006),
        box((0.14, 0.3, 0.02), (0, -0.02, top + 0.022), 0.006),
    ]
    lean = Rotation.from_euler("x", -8, degrees=True).as_matrix()
    oval = closed_curve(
        [
            (0, -1.9),
            (0.9, -1.2),
            (1.0, 0),
            (0.9, 1.2),
            (0, 1.9),
            (-0.9, 1.2),
            (-1.0, 0),
            (-0.9, -1.2),
        ]
    )
    funnel = placed(
        [
            plate(
                0.1 * oval,
                0.4,
                (0, 0, 0.18),
            )
        ],
        lean,
        (0, 0.48, top),
    )
    rim = placed(
        [
            plate(
                0.106 * oval,
                0.08,
                (0, 0, 0.37),
            )
        ],
        lean,
        (0, 0.48, top),
    )
    boats = both_sides(
        [
            capsule((wide + 0.012, y - 0.05, 0.35), (wide + 0.012, y + 0.05, 0.35), 0.042)
            for y in np.arange(-0.4, 0.75, 0.17)
        ]
    )
    return {
        "hull": hull,
        "keel": keel,
        "decks": decks,
        "windows": glass,
        "funnel": funnel,
        "rim": rim,
        "lifeboats": boats,
    }


LARGE_SHIPS: dict[str, Callable[[Draw], Parts]] = {
    "cargo ship": _cargo_ship,
    "cruise ship": _cruise_ship,
}
