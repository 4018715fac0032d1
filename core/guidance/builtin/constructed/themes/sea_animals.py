"""The shark, and the whales."""

from collections.abc import Callable, Sequence

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import aside, body, eyes_on, on_surface, spine
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    Place,
    ball,
    both_sides,
    closed_curve,
    plate,
    rod,
    smooth_union,
)


def _blade(
    at: Place, outline: Sequence[Sequence[float]], size: float, drop: float, thick: float
) -> Primitive:
    """A level fin of such an outline, outwards and to the rear; ``drop``: degrees."""
    c, s = np.cos(np.radians(drop)), np.sin(np.radians(drop))
    frame = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return plate(size * closed_curve(outline), thick * size, at, frame)


def _fin(x: float, y: float, z: float, size: float, drop: float = 24) -> Primitive:
    """A left one."""
    outline = [
        (-0.1, -0.16),
        (0.28, -0.04),
        (0.66, 0.2),
        (0.96, 0.5),
        (0.98, 0.6),
        (0.62, 0.42),
        (0.26, 0.24),
        (-0.1, 0.18),
    ]
    return _blade((x, y, z), outline, size, drop, 0.045)


def _flukes(y: float, z: float, size: float) -> Primitive:
    """The left half of a level tail."""
    outline = [
        (-0.06, -0.26),
        (0.14, -0.1),
        (0.42, 0.12),
        (0.68, 0.4),
        (0.66, 0.47),
        (0.36, 0.34),
        (0.12, 0.28),
        (-0.06, 0.22),
    ]
    return _blade((0, y, z), outline, size, -6, 0.055)


def _sail(y: float, z: float, size: float, lean: float = 0.6) -> Limb:
    """A fin on the back."""
    return spine(
        (y - 0.1 * size, z - 0.06 * size, 0.12 * size, 0.4),
        (y + 0.12 * size, z + 0.22 * size, 0.12 * size, 0.28),
        (y + lean * 0.7 * size, z + 0.5 * size, 0.06 * size, 0.26),
        (y + lean * size, z + 0.7 * size, 0.012 * size, 0.5),
    )


def _shark(draw: Draw) -> Parts:
    sway = draw(-0.02, 0.06)
    trunk = spine(
        (-0.92, 0.02, 0.05, 1.3),
        (-0.76, 0.02, 0.12, 1.05),
        (-0.5, 0.0, 0.19, 0.9),
        (-0.1, -0.01, 0.225, 0.85),
        (0.3, 0.02, 0.165, 0.8),
        (0.68, 0.06, 0.075, 0.8),
        (0.86, 0.08 + sway, 0.045, 0.9),
    )
    upper = spine(
        (0.84, 0.08 + sway, 0.05, 0.6),
        (0.98, 0.2 + sway, 0.06, 0.3),
        (1.1, 0.36 + sway, 0.035, 0.3),
        (1.16, 0.46 + sway, 0.01, 0.5),
    )
    lower = spine(
        (0.85, 0.07 + sway, 0.05, 0.6),
        (0.94, -0.03 + sway, 0.045, 0.3),
        (1.0, -0.13 + sway, 0.01, 0.5),
    )
    second, under = (
        _sail(0.46, 0.16, 0.2),
        spine((0.46, -0.1, 0.04, 0.4), (0.53, -0.15, 0.03, 0.3), (0.58, -0.2, 0.008, 0.5)),
    )
    fins = both_sides([_fin(0.13, -0.32, -0.1, 0.5, 28), _fin(0.07, 0.32, -0.07, 0.18, 30)])
    whole = body([trunk, upper, lower, _sail(-0.1, 0.2, 0.5), second, under], [], 0.02)
    belly = spine(
        (-0.86, -0.012, 0.06, 1.1),
        (-0.66, -0.05, 0.115, 1.0),
        (-0.4, -0.065, 0.155, 0.95),
        (-0.1, -0.075, 0.175, 0.9),
        (0.3, -0.04, 0.135, 0.82),
        (0.66, 0.03, 0.058, 0.8),
    ) + np.array([0, 0, -0.012, 0.004, 0])
    gape = [
        aside(
            *[
                (0.115 * np.sin(a), -0.72 - 0.1 * np.cos(a), -0.082 + 0.016 * abs(np.sin(a)), 0.026)
                for a in np.linspace(-1.5, 1.5, 11)
            ]
        )
    ]
    mouth = smooth_union(gape, 0.005)
    teeth = []
    for a in np.linspace(-1.25, 1.25, 12):
        at = np.array(
            (0.115 * np.sin(a), -0.732 - 0.1 * np.cos(a), -0.075 + 0.016 * abs(np.sin(a)))
        )
        teeth.append(rod(at, at - (0, 0.004, 0.048), 0.016, 0.002))
    return {
        "body": [whole, *fins],
        "belly": [smooth_union([belly], 0.02)],
        "mouth": [mouth],
        "teeth": teeth,
        "eyes": eyes_on(whole, (0, -0.72, 0.05), (-1, 0.25, 0), 0.022, 0.35),
    }


def _whale_body(
    draw: Draw, snout: list[Limb], fat: float, fin: float, sail: float
) -> tuple[list[Primitive], float]:
    dive = draw(0.0, 0.1)
    trunk = spine(
        (-0.66, 0.0, 0.15 * fat, 0.95),
        (-0.36, 0.0, 0.2 * fat, 0.95),
        (0.0, 0.0, 0.2 * fat, 0.92),
        (0.34, 0.02, 0.145 * fat, 0.85),
        (0.68, 0.05 + 0.3 * dive, 0.07, 0.8),
        (0.92, 0.06 + dive, 0.038, 0.9),
    )
    middle = [trunk, *snout]
    if sail:
        middle.append(_sail(0.02, 0.17 * fat, sail))
    whole = body(middle, [], 0.022)
    if not fin:
        return [whole], dive
    fins = [_fin(0.13 * fat, -0.36, -0.09 * fat, fin), _flukes(0.9, 0.06 + dive, 0.46)]
    return [whole, *both_sides(fins)], dive


def _dolphin(draw: Draw) -> Parts:
    snout = [
        spine(
            (-0.78, 0.015, 0.105, 0.95),
            (-0.86, -0.025, 0.06, 1.0),
            (-0.98, -0.05, 0.036, 1.1),
            (-1.04, -0.055, 0.03, 1.1),
        )
    ]
    whole, dive = _whale_body(draw, snout, 0.92, 0.42, 0.44)
    belly = spine(
        (-1.02, -0.066, 0.026, 1.1),
        (-0.84, -0.055, 0.065, 0.95),
        (-0.6, -0.05, 0.115, 0.9),
        (-0.3, -0.055, 0.142, 0.88),
        (0.0, -0.055, 0.142, 0.86),
        (0.34, -0.015, 0.1, 0.8),
        (0.6, 0.03 + 0.2 * dive, 0.05, 0.8),
    ) + np.array([0, 0, -0.01, 0.004, 0])
    return {
        "body": whole,
        "belly": [smooth_union([belly], 0.02)],
        "eyes": eyes_on(whole[0], (0, -0.78, -0.005), (-1, 0.2, 0), 0.02, 0.35),
    }


def _orca(draw: Draw) -> Parts:
    snout = [spine((-0.8, 0.0, 0.13, 0.95), (-0.94, -0.015, 0.085, 1.0), (-1.0, -0.02, 0.06, 1.05))]
    whole, dive = _whale_body(draw, snout, 1.06, 0.5, 0.78)
    belly = spine(
        (-0.99, -0.05, 0.05, 1.1),
        (-0.8, -0.062, 0.1, 0.98),
        (-0.5, -0.07, 0.148, 0.92),
        (-0.1, -0.08, 0.155, 0.9),
        (0.3, -0.03, 0.12, 0.84),
        (0.62, 0.015 + 0.2 * dive, 0.06, 0.8),
    ) + np.array([0, 0, -0.012, 0.004, 0])
    spot = on_surface(whole[0], (2, -0.72, 0.07), (-1, 0.1, 0))
    flank = on_surface(whole[0], (2, 0.34, -0.0), (-1, 0, 0))
    patches = [
        ball((0.02, 0.085, 0.04), spot - (0.01, 0, 0), (14, 0, 0)),
        ball((0.02, 0.13, 0.05), flank - (0.01, 0, 0.0), (24, 0, 0)),
    ]
    return {
        "body": whole,
        "belly": [smooth_union([belly], 0.02)],
        "patches": both_sides(patches),
        "eyes": eyes_on(whole[0], (0, -0.83, 0.02), (-1, 0.2, 0), 0.018, 0.35),
    }


def _whale(draw: Draw) -> Parts:
    snout = [spine((-0.66, -0.02, 0.2, 1.0), (-0.9, -0.02, 0.17, 1.05), (-1.06, -0.03, 0.1, 1.2))]
    whole, dive = _whale_body(draw, snout, 1.2, 0.0, 0.16)
    belly = spine(
        (-1.08, -0.09, 0.075, 1.25),
        (-0.9, -0.1, 0.135, 1.05),
        (-0.6, -0.1, 0.178, 1.0),
        (-0.2, -0.09, 0.182, 0.95),
        (0.16, -0.05, 0.15, 0.9),
        (0.5, 0.0 + 0.1 * dive, 0.08, 0.85),
    ) + np.array([0, 0, -0.012, 0.004, 0])
    return {
        "body": whole,
        "belly": [smooth_union([belly], 0.02)],
        "fins": both_sides([_fin(0.17, -0.42, -0.13, 0.62), _flukes(0.88, 0.06 + dive, 0.6)]),
        "eyes": eyes_on(whole[0], (0, -0.74, -0.03), (-1, 0.2, 0), 0.018, 0.35),
    }


SEA_ANIMALS: dict[str, Callable[[Draw], Parts]] = {
    "shark": _shark,
    "dolphin": _dolphin,
    "orca": _orca,
    "whale": _whale,
}
