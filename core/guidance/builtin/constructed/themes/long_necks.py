"""The giraffe, the camel and the llama."""

from collections.abc import Callable

from core.geometry.parts.limbs import Limb
from core.guidance.builtin.constructed.anatomy import aside, spine, with_legs
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    both_sides,
    box,
    closed_curve,
    plate,
    smooth_union,
)
from core.guidance.builtin.constructed.themes.cattle import ear, tail
from core.guidance.builtin.constructed.ungulate import Build, Ungulate, ungulate

GIRAFFE = Build(
    neck=0.86,
    carry=64,
    nape=0.075,
    throat=0.17,
    head=0.3,
    face=28,
    skull=0.075,
    nose=0.05,
    thick=0.86,
    stout=0.92,
    long=0.88,
    eye=0.023,
)
CAMEL = Build(
    neck=0.46,
    carry=34,
    nape=0.085,
    throat=0.14,
    head=0.32,
    face=12,
    skull=0.085,
    nose=0.062,
    thick=0.92,
    stout=0.98,
    eye=0.024,
)
LLAMA = Build(
    neck=0.46,
    carry=72,
    nape=0.085,
    throat=0.14,
    head=0.28,
    face=18,
    skull=0.085,
    nose=0.052,
    thick=0.8,
    stout=0.9,
    long=0.94,
    eye=0.024,
)


def _giraffe(draw: Draw) -> Parts:
    one = ungulate(GIRAFFE, draw)
    whole = one.whole(*tail(0.34, 0.016, 0.88), sides=(ear(one, 0.42, 0.16, -0.05, 0.12),))
    horn = one.on_head(
        (0.08, 0.22, 0.12, 0.06), (0.02, 0.46, 0.15, 0.05), (0.01, 0.56, 0.155, 0.075)
    )
    return {
        "body": [whole, *one.feet],
        "muzzle": [smooth_union([one.muzzle(0.8)], 0.02)],
        "horns": both_sides([smooth_union([horn], 0.01)]),
        "eyes": one.eyes(whole),
    }


def _camel(draw: Draw) -> Parts:
    one, two = ungulate(CAMEL, draw), draw.chance(0.4)
    drop = spine((-0.5, 0.86, 0.08, 0.8), (-0.56, 0.8, 0.1, 0.8))
    places = [(-0.16, 0.13), (0.22, 0.13)] if two else [(0.03, 0.17)]
    humps = [
        spine((y, 0.86, 1.2 * r, 0.85), (y, 0.96, 0.95 * r, 0.8), (y + 0.02, 1.06, 0.55 * r, 0.8))
        for y, r in places
    ]
    whole = one.whole(drop, *humps, *tail(0.4, 0.016), sides=(ear(one, 0.22, 0.22, -0.08, 0.1),))
    return {
        "body": [whole],
        "humps": [smooth_union([one[1:] + (0, 0, 0.01, 0.012, 0)], 0.03) for one in humps],
        "muzzle": [smooth_union([one.muzzle(0.78)], 0.02)],
        "hooves": one.feet,
        "eyes": one.eyes(whole),
    }


def _llama(draw: Draw) -> Parts:
    one = ungulate(LLAMA, draw)
    fleece = [
        spine((-0.34, 0.72, 0.2, 0.9), (0.0, 0.7, 0.235, 0.95), (0.32, 0.74, 0.2, 1.0)),
        _thicker(one),
        spine((0.48, 0.84, 0.075, 1), (0.56, 0.8, 0.07, 1), (0.6, 0.7, 0.02, 1)),
    ]
    thighs = [
        aside((0.1, -0.3, 0.62, 0.11), (0.115, -0.28, 0.48, 0.085)),
        aside((0.1, 0.37, 0.64, 0.14), (0.12, 0.41, 0.46, 0.095)),
    ]
    top = one.on_head((0.02, 0.22, 0, 0.18, 1.0), (0.1, 0.3, 0, 0.13, 1.0))
    pointed = one.on_head(
        (0.06, 0.26, 0.16, 0.075, 0.8), (0.02, 0.5, 0.2, 0.075, 0.7), (0.06, 0.8, 0.17, 0.02, 0.8)
    )
    wool = one.whole(*fleece, top, sides=(*thighs, pointed))
    return {
        "wool": [wool],
        "face": [smooth_union([one.muzzle(0.42, 0.006)], 0.02)],
        **_blanket(),
        "hooves": one.feet,
        "eyes": one.eyes(wool),
    }


def _thicker(one: Ungulate) -> Limb:
    neck = one.middle[2].copy()
    neck[:, 3] += (0.02, 0.045, 0.03)
    return neck


def _blanket() -> Parts:
    """Over the back."""
    outer, y = (
        closed_curve(
            [
                (0, 0.985),
                (0.17, 0.93),
                (0.255, 0.74),
                (0.262, 0.6),
                (0.245, 0.6),
                (0.16, 0.7),
                (0, 0.8),
                (-0.16, 0.7),
                (-0.245, 0.6),
                (-0.262, 0.6),
                (-0.255, 0.74),
                (-0.17, 0.93),
            ]
        ),
        0.02,
    )

    cloth = plate(outer, 0.34, (0, y, 0), FRONT)
    fringe = [
        box((0.03, 0.036, 0.05), (0.253, y - 0.15 + 0.06 * k, 0.585), 0.008) for k in range(6)
    ]
    return {"blanket": [cloth], "fringe": both_sides(fringe)}


LONG_NECKS: dict[str, Callable[[Draw], Parts]] = {
    "giraffe": with_legs(_giraffe, 1.24, 1.36),
    "camel": with_legs(_camel, 1.02, 1.12),
    "llama": with_legs(_llama, 1.0, 1.1),
}
