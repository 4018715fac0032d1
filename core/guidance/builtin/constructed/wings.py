"""Wings of feathers and of skin, raised; the left ones."""

from collections.abc import Sequence

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import along
from core.guidance.builtin.constructed.shapes import (
    Frame,
    Place,
    Point,
    limb,
    plate,
    smooth_union,
)

LEAN = np.radians(35.0)  # of a raised wing, outwards


def _frame(lean: float) -> Frame:
    """Columns: to the rear, upwards within the wing, and across it."""
    up = np.array([np.sin(lean), 0, np.cos(lean)])
    rear = np.array([0.0, 1.0, 0.0])
    return np.stack([rear, up, np.cross(rear, up)], 1)


def feathered_wing(at: Place, size: float, feathers: int = 11) -> tuple[Primitive, Primitive]:
    """A bird's wing from a shoulder: its arm with the short feathers, and the long feathers.

    They are two solids, as they have colours of their own.
    """
    frame, root = _frame(LEAN), np.array(at, float)

    def place(rear: float, up: float, off: float = 0.0) -> Point:
        return root + size * (frame @ np.array([rear, up, off]))

    arm = [(0.0, 0.0), (-0.06, 0.34), (0.04, 0.62), (0.3, 0.98)]
    bone = limb(
        [place(*p) for p in arm], [0.07 * size, 0.06 * size, 0.045 * size, 0.016 * size], 0.7
    )
    long, short = [], [bone]
    for k, t in enumerate(np.linspace(0.12, 1, feathers)):
        start = along([(*p, 0) for p in arm], t)[:2]
        way = np.radians(np.interp(t, (0, 0.6, 1), (-38, 8, 62)))
        step = np.array([np.cos(way), np.sin(way)])
        far, off = np.interp(t, (0, 0.5, 1), (0.5, 0.62, 0.62)), 0.012 * (k % 2)
        ends = [start + f * far * step + np.array([0, -0.05 * f * f]) for f in (0.0, 0.4, 0.8, 1.0)]
        long.append(
            _feather([place(*p, off) for p in ends], size * np.array([0.04, 0.062, 0.056, 0.02]))
        )
        ends = [start + f * 0.42 * far * step for f in (0.0, 0.6, 1.0)]
        short.append(
            _feather([place(*p, 0.024 - off) for p in ends], size * np.array([0.05, 0.06, 0.02]))
        )
    return smooth_union(short, 0.008 * size), smooth_union(long, 0.004 * size)


def _feather(points: Sequence[Point], radii: np.ndarray) -> Limb:
    return limb(points, list(radii), 0.3)


def skin_wing(
    at: Place, size: float, thick: float = 0.021
) -> tuple[list[Primitive], list[Primitive]]:
    """A dragon's or a bat's wing from a shoulder: its skin, and its bones."""
    frame, root = _frame(LEAN), np.array(at, float)

    def place(rear: float, up: float) -> Point:
        return root + size * (frame @ np.array([rear, up, 0.0]))

    elbow, wrist = (-0.1, 0.34), (-0.02, 0.8)
    tips = [(0.62, 1.06), (0.92, 0.66), (0.9, 0.2), (0.46, -0.14)]
    edge = [np.array((0.0, 0.0)), np.array(elbow), np.array(wrist)]
    for one, other in zip(tips, [*tips[1:], (0.02, -0.06)], strict=True):
        a, b = np.array(one), np.array(other)
        hollow = (a + b) / 2 * 0.78 + 0.22 * np.array(wrist)
        for t in np.linspace(0, 1, 7)[:-1]:  # a curve between two fingers
            edge.append((1 - t) ** 2 * a + 2 * t * (1 - t) * hollow + t * t * b)
    skin = plate(size * np.array(edge), thick * size, root, frame)
    arm = limb(
        [place(0, 0), place(*elbow), place(*wrist)], [0.05 * size, 0.042 * size, 0.036 * size]
    )
    claw = limb(
        [place(*wrist), place(-0.07, 0.88), place(-0.06, 0.95)],
        [0.03 * size, 0.022 * size, 0.006 * size],
    )
    fingers = []
    for x, z in tips:
        middle = ((wrist[0] + x) / 2 + 0.03, (wrist[1] + z) / 2 + 0.07)
        fingers.append(
            limb(
                [place(*wrist), place(*middle), place(x, z)],
                [0.03 * size, 0.022 * size, 0.014 * size],
            )
        )
    return [skin], [smooth_union([arm, claw, *fingers], 0.01 * size)]
