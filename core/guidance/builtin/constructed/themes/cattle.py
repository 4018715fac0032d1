"""Cattle, sheep, goats, deer, and what has a long neck."""

from collections.abc import Callable, Sequence

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import aside, spine, with_legs
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    both_sides,
    mirrored_limbs,
    ring,
    smooth_union,
)
from core.guidance.builtin.constructed.ungulate import Build, Ungulate, ungulate

COW = Build(
    neck=0.24, carry=22, head=0.36, skull=0.108, nose=0.083, wide=0.95, stout=1.08, long=1.1
)
DEER = Build(
    neck=0.42,
    carry=52,
    nape=0.078,
    throat=0.14,
    head=0.3,
    face=32,
    skull=0.082,
    nose=0.05,
    thick=0.72,
    stout=0.8,
    eye=0.026,
)


def ear(
    one: Ungulate, long: float = 0.4, up: float = 0.18, drop: float = 0.06, thick: float = 0.13
) -> Limb:
    """One that stands out sideways."""
    return one.on_head(
        (0.06, up, 0.2, 0.6 * thick, 1),
        (0.04, up + 0.02, 0.2 + 0.5 * long, thick, 0.7),
        (0.05, up - drop, 0.2 + long, 0.02, 1),
    )


def tail(end: float = 0.32, radius: float = 0.02, back: float = 1.0) -> list[Limb]:
    """A rope with a tuft."""
    y = 0.56 * back
    rope = spine(
        (y, 0.86, 1.4 * radius, 1),
        (y + 0.05, 0.78, radius, 1),
        (y + 0.06, 0.5, radius, 1),
        (y + 0.06, end + 0.1, radius, 1),
    )
    tuft = spine(
        (y + 0.06, end + 0.13, 1.3 * radius, 1),
        (y + 0.065, end + 0.05, 2.2 * radius, 1),
        (y + 0.07, end - 0.05, 0.008, 1),
    )
    return [rope, tuft]


def _horns(one: Ungulate, nodes: Sequence[tuple[float, ...]]) -> list[Primitive]:
    """A pair, along the head's nodes."""
    return both_sides([smooth_union([one.on_head(*nodes)], 0.005)])


def _cow(draw: Draw) -> Parts:
    one = ungulate(COW, draw)
    whole = one.whole(*tail(back=1.1), sides=(ear(one),))
    udder = [
        ball((0.13, 0.15, 0.1), (0, 0.3, 0.5)),
        *both_sides(
            [
                smooth_union([aside((0.05, y, 0.44, 0.026), (0.055, y, 0.375, 0.02))], 0.01)
                for y in (0.24, 0.34)
            ]
        ),
    ]
    horn = draw(0.8, 1.2)
    horns = [
        (0.05, 0.26, 0.16, 0.075),
        (0.03, 0.34, 0.34 * horn, 0.065),
        (0.05, 0.46 + 0.1 * horn, 0.42 * horn, 0.015),
    ]
    return {
        "body": [whole, *one.feet],
        "muzzle": [smooth_union([one.muzzle()], 0.02)],
        "horns": _horns(one, horns),
        "eyes": one.eyes(whole),
        "udder": udder,
    }


def _bull(draw: Draw) -> Parts:
    one = ungulate(
        COW._replace(stout=1.16, throat=0.23, nape=0.16, thick=1.12, skull=0.12, carry=12), draw
    )
    hump = spine((-0.36, 0.9, 0.17, 0.8), (-0.16, 0.88, 0.13, 0.8))
    whole = one.whole(hump, *tail(back=1.1), sides=(ear(one),))
    out = draw(0.9, 1.15)
    horns = [
        (0.0, 0.22, 0.2, 0.1),
        (0.0, 0.25, 0.6 * out, 0.09),
        (0.12, 0.42, 0.85 * out, 0.055),
        (0.25, 0.62, 0.84 * out, 0.012),
    ]
    hair = [
        one.on_head(
            (0.02, 0.24, x, 0.1, 1),
            (0.2, 0.3 - 0.3 * abs(x), 0.9 * x, 0.075, 1),
            (0.32, 0.2, 0.8 * x, 0.02, 1),
        )
        for x in (-0.16, 0.0, 0.16)
    ]
    nose = one.place(1.16, -0.16)
    return {
        "body": [whole],
        "muzzle": [smooth_union([one.muzzle()], 0.02)],
        "horns": _horns(one, horns),
        "ring": [ring(0.045, 0.009, nose, "y")],
        "hair": [smooth_union(hair, 0.02)],
        "hooves": one.feet,
        "eyes": one.eyes(whole),
    }


def _sheep(draw: Draw) -> Parts:
    build = Build(
        neck=0.16,
        carry=38,
        nape=0.1,
        head=0.34,
        face=38,
        skull=0.1,
        nose=0.062,
        thick=0.85,
        stout=0.9,
        eye=0.024,
    )
    one = ungulate(build, draw)
    wool, count = (
        [
            spine((-0.34, 0.74, 0.24, 0.95), (0.0, 0.72, 0.28, 0.95), (0.34, 0.74, 0.23, 0.95)),
            spine((-0.38, 0.86, 0.16, 0.95), (-0.46, 0.92, 0.14, 0.95)),
        ],
        60,
    )
    for k in range(count):  # evenly over a ball: Fibonacci's spiral
        z = 1 - 2 * (k + 0.5) / count
        around, angle = np.sqrt(1 - z * z), k * np.pi * (3 - 5**0.5)
        at = (0.25 * around * np.cos(angle), 0.01 + 0.6 * around * np.sin(angle), 0.74 + 0.27 * z)
        wool.append(aside((*at, 0.09), (*at[:2], at[2] + 1e-3, 0.09)))
    crown = one.on_head(
        (0.0, 0.2, -0.14, 0.16, 1), (0.0, 0.26, 0.0, 0.18, 1), (0.0, 0.2, 0.14, 0.16, 1)
    )
    front, hind = one.sides
    legs = smooth_union(mirrored_limbs([front[2:], hind[2:]]), 0.01)
    head = one.whole(sides=(ear(one, 0.5, 0.08, 0.16),))
    face = smooth_union(
        [one.middle[-1], one.middle[-2], *mirrored_limbs([ear(one, 0.5, 0.1, 0.16)])], 0.02
    )
    return {
        "wool": [smooth_union(wool, 0.02), smooth_union([crown], 0.02)],
        "head": [face],
        "legs": [legs, *one.feet],
        "eyes": one.eyes(head),
    }


def _goat(draw: Draw) -> Parts:
    build = Build(
        neck=0.28,
        carry=48,
        nape=0.085,
        throat=0.14,
        head=0.33,
        face=38,
        skull=0.088,
        nose=0.056,
        thick=0.82,
        stout=0.88,
    )
    one = ungulate(build, draw)
    tail = spine((0.54, 0.86, 0.04, 1.2), (0.62, 0.92, 0.035, 1.2), (0.66, 0.99, 0.01, 1))
    whole = one.whole(tail, sides=(ear(one, 0.42, 0.06, 0.12),))
    bend = draw(0.85, 1.15)
    horns = [
        (0.1, 0.22, 0.1, 0.085),
        (-0.02, 0.52 * bend, 0.16, 0.075),
        (-0.34, 0.66 * bend, 0.22, 0.055),
        (-0.62, 0.5 * bend, 0.27, 0.012),
    ]
    beard = one.on_head(
        (0.82, -0.2, 0, 0.07, 1), (0.86, -0.4, 0, 0.075, 0.8), (0.8, -0.66, 0, 0.012, 1)
    )
    nose = ball((0.03, 0.02, 0.022), one.place(1.15, 0.06))
    return {
        "body": [whole],
        "horns": _horns(one, horns),
        "beard": [smooth_union([beard], 0.01)],
        "hooves": one.feet,
        "eyes": one.eyes(whole),
        "nose": [nose],
    }


def _antlers(one: Ungulate, draw: Draw) -> list[Primitive]:
    """Beams with tines."""
    wide = draw(0.85, 1.15)
    beam = [
        (0.05, 0.2, 0.13, 0.08),
        (-0.08, 0.6, 0.32 * wide, 0.074),
        (-0.25, 1.1, 0.62 * wide, 0.064),
        (-0.08, 1.55, 0.66 * wide, 0.026),
    ]
    tines = [
        [(-0.04, 0.42, 0.24 * wide, 0.06), (0.3, 0.66, 0.26 * wide, 0.026)],
        [(-0.16, 0.84, 0.46 * wide, 0.058), (0.18, 1.16, 0.42 * wide, 0.026)],
        [(-0.24, 1.14, 0.62 * wide, 0.056), (-0.54, 1.5, 0.8 * wide, 0.026)],
    ]
    return both_sides([smooth_union([one.on_head(*nodes) for nodes in (beam, *tines)], 0.008)])


def _deer(draw: Draw) -> Parts:
    one = ungulate(DEER, draw)
    tail = spine((0.52, 0.84, 0.045, 0.9), (0.6, 0.8, 0.04, 0.9), (0.64, 0.72, 0.012, 1))
    whole = one.whole(tail, sides=(ear(one, 0.5, 0.2, -0.06, 0.14),))
    belly = spine((-0.3, 0.58, 0.06, 1.1), (0.0, 0.55, 0.075, 1.3), (0.25, 0.6, 0.05, 1.2))
    nose = ball((0.03, 0.024, 0.024), one.place(1.14, 0.03))
    return {
        "body": [whole],
        "antlers": _antlers(one, draw),
        "muzzle": [smooth_union([one.muzzle(0.82, 0.008)], 0.02)],
        "belly": [smooth_union([belly], 0.02)],
        "hooves": one.feet,
        "eyes": one.eyes(whole),
        "nose": [nose],
    }


def _moose(draw: Draw) -> Parts:
    build = Build(
        neck=0.22,
        carry=18,
        nape=0.13,
        throat=0.2,
        head=0.44,
        face=40,
        skull=0.105,
        nose=0.09,
        wide=0.8,
        thick=0.95,
        stout=1.02,
    )
    one = ungulate(build, draw)
    hump, bell = (
        spine((-0.34, 0.9, 0.15, 0.75), (-0.14, 0.88, 0.12, 0.75)),
        one.on_head((0.3, -0.3, 0, 0.1, 0.8), (0.34, -0.55, 0, 0.05, 0.8)),
    )
    tail = spine((0.52, 0.84, 0.05, 0.9), (0.58, 0.76, 0.02, 0.9))
    whole = one.whole(hump, bell, tail, sides=(ear(one, 0.36, 0.16, -0.1),))
    palm, wide = [], draw(0.9, 1.12)
    palm.append(
        [
            (0.1, 0.16, 0.12, 0.055),
            (0.06, 0.22, 0.45 * wide, 0.05),
            (-0.02, 0.42, 0.75 * wide, 0.13),
            (-0.2, 0.62, 0.98 * wide, 0.14),
        ]
    )
    palm.append(
        [
            (0.06, 0.3, 0.66 * wide, 0.1),
            (-0.06, 0.5, 0.86 * wide, 0.15),
            (-0.28, 0.76, 0.98 * wide, 0.11),
        ]
    )
    for k in range(5):
        t = k / 4
        start = (0.06 - 0.36 * t, 0.5 + 0.26 * t, (0.86 + 0.16 * t) * wide, 0.05)
        palm.append(
            [
                start,
                (
                    start[0] + 0.1 - 0.12 * t,
                    start[1] + 0.2 + 0.06 * t,
                    start[2] + 0.2 - 0.12 * t,
                    0.025,
                ),
            ]
        )
    palm.append([(0.1, 0.22, 0.4 * wide, 0.045), (0.34, 0.36, 0.5 * wide, 0.025)])
    antlers = smooth_union([one.on_head(*nodes) for nodes in palm], 0.012)
    front, hind = one.sides
    low = [own[3:] + np.array([0, 0, 0, 0.006, 0]) for own in (front, hind)]
    return {
        "body": [whole],
        "antlers": both_sides([antlers]),
        "muzzle": [smooth_union([one.muzzle(0.72)], 0.02)],
        "legs": both_sides([smooth_union([own], 0.01) for own in low]),
        "hooves": one.feet,
        "eyes": one.eyes(whole),
    }


CATTLE: dict[str, Callable[[Draw], Parts]] = {
    "cow": with_legs(_cow, 0.9, 1.0),
    "bull": with_legs(_bull, 0.86, 0.96),
    "sheep": with_legs(_sheep, 0.76, 0.9),
    "goat": with_legs(_goat),
    "deer": with_legs(_deer, 1.02, 1.12),
    "moose": with_legs(_moose, 1.04, 1.14),
}
