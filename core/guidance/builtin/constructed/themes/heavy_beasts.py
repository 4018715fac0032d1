"""Elephants, the rhino, the hippo and the pig."""

from collections.abc import Callable

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import (
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
    Parts,
    ball,
    both_sides,
    limb,
    mirrored_limbs,
    smooth_union,
)
from core.guidance.builtin.constructed.themes.cattle import tail
from core.guidance.builtin.constructed.ungulate import Build, ungulate

FOOT = 0.16  # how far the middle of a foot is aside


def _feet(front: float, hind: float) -> list[tuple[float, float]]:
    """Where the left ones are."""
    return [(FOOT, front), (FOOT, hind)]


def _pillars(front: float, hind: float, radius: float) -> list[Limb]:
    """Legs like pillars at such y."""
    return [
        aside(
            (0.15, front, 0.7, 1.25 * radius),
            (0.165, front - 0.01, 0.48, 1.05 * radius),
            (0.16, front, 0.3, 0.9 * radius),
            (0.16, front - 0.005, 0.12, 0.88 * radius),
            (0.16, front - 0.01, 0.08, 0.92 * radius),
        ),
        aside(
            (0.13, hind, 0.72, 1.4 * radius),
            (0.16, hind - 0.02, 0.5, 1.15 * radius),
            (0.16, hind + 0.03, 0.3, 0.9 * radius),
            (0.16, hind + 0.02, 0.12, 0.86 * radius),
            (0.16, hind, 0.08, 0.92 * radius),
        ),
    ]


_COAT = spine((-0.36, 0.84, 0.2, 0.95), (-0.2, 0.88, 0.21, 0.95), (0.1, 0.78, 0.2, 1.0))


def _elephant_body(draw: Draw, hump: float, *coat: Limb) -> Primitive:
    back = spine(
        (-0.38, 0.74, 0.2, 0.95),
        (-0.15, 0.72, 0.27, 0.95),
        (0.14, 0.7, 0.28, 0.98),
        (0.36, 0.7, 0.24, 0.98),
        (0.5, 0.7, 0.15, 1),
    )
    neck = spine((-0.4, 0.78, 0.18, 0.95), (-0.52, 0.84, 0.17, 0.95))
    skull = spine(
        (-0.54, 0.93 + hump, 0.15, 1.05), (-0.62, 0.86, 0.15, 1.0), (-0.68, 0.76, 0.12, 1.0)
    )
    jaw = spine((-0.6, 0.72, 0.085, 0.9), (-0.66, 0.63, 0.05, 0.9))
    curl = draw(-0.12, 0.12)
    trunk = spine(
        (-0.68, 0.78, 0.105, 1),
        (-0.77, 0.66, 0.085, 1),
        (-0.8, 0.48, 0.066, 1),
        (-0.79, 0.3, 0.052, 1),
        (-0.8 - abs(curl), 0.16 + 0.4 * max(curl, 0), 0.043, 1),
        (-0.86 - 1.2 * abs(curl), 0.1 + 1.2 * max(curl, 0), 0.036, 1),
    )
    legs = _pillars(-0.3, 0.4, 0.105)
    return body([back, neck, skull, jaw, trunk, *coat], legs, 0.03)


def _tusks(long: float, curl: float = 0.0) -> list[Primitive]:
    x = 0.085
    tusk = [
        (x, -0.68, 0.68),
        (x + 0.03, -0.78, 0.57),
        (x + 0.04 + curl, -0.78 - 0.14 * long, 0.53 + 0.2 * curl),
        (x + 0.03 - curl, -0.78 - 0.3 * long, 0.56 + 0.5 * curl),
    ]
    return both_sides([smooth_union([limb(tusk, [0.034, 0.032, 0.026, 0.008])], 0.01)])


def _flap(size: float) -> Primitive:
    """A left ear: a fan behind the cheek, which stands off a little."""
    found = []
    for k in range(11):
        angle, far = 75 - 13.5 * k, 0.25 + 0.1 * np.sin(np.pi * k / 10)
        a = np.radians(angle)
        end = np.array((0.1 + 0.1 * np.cos(a), 0.9 * far * np.cos(a), far * np.sin(a))) * size
        root = np.array((0.125, -0.56, 0.9))
        found.append(
            limb(
                [root, root + 0.55 * end + (0.03, 0, 0), root + end],
                [0.05, 0.075 * size, 0.05 * size],
                0.32,
            )
        )
    return smooth_union(found, 0.02)


def _elephant(draw: Draw) -> Parts:
    whole = _elephant_body(draw, 0.0)
    rope = tail(0.36, 0.016, 0.98)
    return {
        "body": [whole, smooth_union(rope, 0.015)],
        "ears": both_sides([_flap(draw(0.78, 0.94))]),
        "tusks": _tusks(draw(0.8, 1.2)),
        "eyes": eyes_on(whole, (0, -0.71, 0.85), (-1, 0.45, 0), 0.026, 0.35),
    }


def _mammoth(draw: Draw) -> Parts:
    whole = _elephant_body(draw, 0.06, _COAT)
    skirt = []
    for k in range(13):
        t = k / 12
        y, x = -0.4 + 0.9 * t, 0.2 + 0.05 * np.sin(np.pi * t)
        skirt.append(
            aside(
                (x, y, 0.62, 0.075),
                (x + 0.04, y + 0.01, 0.48, 0.06),
                (x + 0.025, y + 0.02, 0.3 + 0.035 * (k % 2), 0.012),
            )
        )
    chest = [
        aside(
            (x, -0.46 - 0.02 * (k % 2), 0.68, 0.08),
            (x, -0.54, 0.52, 0.055),
            (x, -0.52, 0.38, 0.012),
        )
        for k, x in enumerate((-0.1, 0.0, 0.1))
    ]
    crown = [
        spine((-0.53, 1.06, 0.13, 1.0), (-0.6, 1.05, 0.1, 1.0)),
        *(
            aside(
                (x, -0.62, 1.07, 0.05), (1.3 * x, -0.72, 1.0, 0.035), (1.4 * x, -0.75, 0.92, 0.01)
            )
            for x in (-0.08, 0.0, 0.08)
        ),
    ]
    return {
        "fur": [whole],
        "hair": [smooth_union([*mirrored_limbs(skirt), *chest], 0.02), smooth_union(crown, 0.02)],
        "ears": both_sides([_flap(0.6)]),
        "tusks": _tusks(1.9, 0.11),
        "nails": nails(_feet(-0.31, 0.4), 0.098, 50, 0.024),
        "eyes": eyes_on(whole, (0, -0.71, 0.85), (-1, 0.45, 0), 0.026, 0.35),
    }


def _rhino(draw: Draw) -> Parts:
    back = spine(
        (-0.4, 0.66, 0.2, 0.95),
        (-0.16, 0.66, 0.27, 0.95),
        (0.14, 0.64, 0.28, 1.0),
        (0.38, 0.67, 0.24, 0.98),
        (0.5, 0.68, 0.15, 1),
    )
    hump = spine((-0.3, 0.84, 0.14, 0.8), (-0.18, 0.84, 0.12, 0.8))
    neck = spine((-0.42, 0.7, 0.19, 0.85), (-0.6, 0.62, 0.16, 0.85))
    head = spine(
        (-0.62, 0.62, 0.145, 0.85),
        (-0.76, 0.53, 0.115, 0.85),
        (-0.9, 0.43, 0.095, 0.9),
        (-0.95, 0.4, 0.09, 0.95),
    )
    ears = aside(
        (0.085, -0.6, 0.75, 0.028, 0.9),
        (0.105, -0.6, 0.82, 0.034, 0.7),
        (0.11, -0.61, 0.88, 0.01, 0.8),
    )
    whole = body(
        [back, hump, neck, head, *tail(0.36, 0.014, 0.98)], [*_pillars(-0.3, 0.4, 0.1), ears], 0.028
    )
    long = draw(0.85, 1.2)
    horns = [
        spine(
            (-0.95, 0.48, 0.068, 0.9),
            (-1.03, 0.58, 0.052, 0.9),
            (-1.05, 0.6 + 0.17 * long, 0.01, 1),
        ),
        spine(
            (-0.83, 0.57, 0.05, 0.9),
            (-0.88, 0.65, 0.036, 0.9),
            (-0.89, 0.66 + 0.07 * long, 0.01, 1),
        ),
    ]
    plates = [
        smooth_union([spine((-0.3, 0.72, 0.256, 0.95), (-0.16, 0.71, 0.284, 0.95))], 0.02),
        smooth_union([spine((0.36, 0.7, 0.25, 0.99), (0.46, 0.69, 0.2, 0.99))], 0.02),
    ]
    return {
        "body": [whole],
        "horns": [smooth_union([one], 0.01) for one in horns],
        "plates": plates,
        "hooves": nails(_feet(-0.31, 0.4), 0.092, 50, 0.03),
        "eyes": eyes_on(whole, (0, -0.74, 0.6), (-1, 0.3, 0), 0.02, 0.35),
    }


def _hippo(draw: Draw) -> Parts:
    fat = draw(0.94, 1.06)
    back = spine(
        (-0.4, 0.56, 0.22, 1.0),
        (-0.12, 0.56, 0.3 * fat, 1.0),
        (0.18, 0.55, 0.31 * fat, 1.0),
        (0.42, 0.57, 0.25, 1.0),
    )
    neck = spine((-0.4, 0.62, 0.21, 0.95), (-0.54, 0.66, 0.19, 0.95))
    head = spine((-0.56, 0.68, 0.16, 1.0), (-0.7, 0.63, 0.13, 1.0), (-0.84, 0.56, 0.13, 1.1))
    ears = aside((0.1, -0.54, 0.83, 0.03, 0.9), (0.13, -0.54, 0.885, 0.028, 0.8))
    brow = aside((0.085, -0.66, 0.77, 0.04), (0.085, -0.69, 0.77, 0.036))
    stub = spine((0.64, 0.62, 0.035, 1), (0.69, 0.54, 0.02, 1))
    whole = body(
        [back, neck, head, stub],
        [*(one * np.array([1, 1, 0.82, 1, 1]) for one in _pillars(-0.3, 0.42, 0.105)), ears, brow],
        0.03,
    )
    snout = [
        spine((-0.85, 0.56, 0.155, 1.12), (-0.93, 0.53, 0.145, 1.15)),
        *mirrored_limbs([aside((0.09, -0.98, 0.585, 0.075), (0.09, -0.97, 0.56, 0.08))]),
    ]
    teeth = both_sides(
        [smooth_union([aside((0.1, -1.0, 0.44, 0.024), (0.1, -1.035, 0.37, 0.018))], 0.01)]
    )
    muzzle = smooth_union(snout, 0.03)

    nostril = on_surface(muzzle, (0.075, -1.5, 1.1), (0, 0.75, -0.75))
    placed = [ball((0.024, 0.02, 0.018), nostril)]
    return {
        "body": [whole],
        "muzzle": [muzzle],
        "nostrils": both_sides(placed),
        "teeth": teeth,
        "hooves": nails(_feet(-0.31, 0.42), 0.098, 50, 0.024),
        "eyes": eyes_on(whole, (0, -0.675, 0.79), (-1, 0.4, 0), 0.022, 0.3),
    }


def _pig(draw: Draw) -> Parts:
    build = Build(
        neck=0.12,
        carry=14,
        nape=0.15,
        throat=0.21,
        head=0.33,
        face=26,
        skull=0.15,
        nose=0.078,
        wide=0.95,
        thick=1.15,
        stout=1.18,
        eye=0.022,
    )
    one = ungulate(build, draw)
    curl = aside(
        *[
            (0.045 * np.sin(a), 0.6 + 0.012 * a, 0.86 + 0.045 * (1 - np.cos(a)), 0.022 - 0.0012 * a)
            for a in np.linspace(0, 9.5, 14)
        ]
    )
    ears = one.on_head(
        (0.06, 0.32, 0.24, 0.12, 0.9), (0.12, 0.48, 0.36, 0.13, 0.6), (0.32, 0.52, 0.46, 0.025, 0.8)
    )
    whole = one.whole(curl, sides=(ears,))
    disc = one.on_head((1.06, -0.04, 0, 0.235, 1.15), (1.2, -0.03, 0, 0.225, 1.15))
    return {
        "body": [whole, *one.feet],
        "snout": [smooth_union([disc], 0.01)],
        "eyes": one.eyes(whole, 0.42, 0.1),
    }


HEAVY_BEASTS: dict[str, Callable[[Draw], Parts]] = {
    "elephant": with_legs(_elephant, 0.92, 1.06),
    "mammoth": with_legs(_mammoth, 0.92, 1.04),
    "rhino": with_legs(_rhino, 0.74, 0.86),
    "hippo": with_legs(_hippo, 0.66, 0.76),
    "pig": with_legs(_pig, 0.6, 0.7),
}
