"""Horses, and what is like them."""

from typing import NamedTuple

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import (
    along,
    aside,
    body,
    eyes_on,
    hoof,
    locks,
    spine,
    stouter,
    with_legs,
)
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    both_sides,
    limb,
    rod,
    smooth_union,
)

CREST = [(0, -0.64, 1.395), (0, -0.55, 1.3), (0, -0.42, 1.11), (0, -0.28, 0.95)]
FALL = [(0, 0, 0), (0.06, 0.02, -0.03), (0.085, 0.04, -0.11), (0.075, 0.035, -0.2)]


class Horse(NamedTuple):
    """The solids of one."""

    body: Primitive
    hooves: list[Primitive]
    eyes: list[Primitive]


def _horse(draw: Draw, ear: float = 1.0, thick: float = 1.0) -> Horse:
    """``ear``: times as long as a horse's; ``thick``: its legs."""
    trunk = spine(
        (-0.36, 0.7, 0.165, 0.8),
        (-0.18, 0.715, 0.205, 0.84),
        (0.08, 0.7, 0.21, 0.95),
        (0.28, 0.74, 0.185, 0.95),
        (0.41, 0.775, 0.165, 0.98),
    )
    withers = spine((-0.32, 0.86, 0.1, 0.5), (-0.14, 0.845, 0.07, 0.6))
    neck = spine(
        (-0.3, 0.78, 0.175, 0.62),
        (-0.46, 0.99, 0.14, 0.56),
        (-0.59, 1.2, 0.11, 0.6),
        (-0.65, 1.3, 0.095, 0.7),
    )
    head = spine(
        (-0.665, 1.315, 0.088, 0.78),
        (-0.755, 1.24, 0.098, 0.76),
        (-0.86, 1.11, 0.07, 0.8),
        (-0.93, 1.02, 0.06, 0.95),
    )
    front = aside(
        (0.1, -0.33, 0.8, 0.085),
        (0.115, -0.33, 0.64, 0.088),
        (0.112, -0.285, 0.52, 0.068),
        (0.1, -0.275, 0.4, 0.05),
        (0.1, -0.28, 0.31, 0.048),
        (0.098, -0.272, 0.2, 0.033),
        (0.098, -0.27, 0.105, 0.04),
        (0.098, -0.29, 0.06, 0.036),
    )
    hind = aside(
        (0.085, 0.38, 0.76, 0.14),
        (0.11, 0.36, 0.6, 0.118),
        (0.115, 0.42, 0.47, 0.075),
        (0.108, 0.5, 0.36, 0.048),
        (0.1, 0.495, 0.26, 0.037),
        (0.098, 0.48, 0.115, 0.042),
        (0.098, 0.455, 0.06, 0.036),
    )
    ears = aside(
        (0.05, -0.655, 1.385, 0.028, 0.9),
        (0.068, -0.655, 1.385 + 0.07 * ear, 0.032, 0.75),
        (0.06, -0.675, 1.385 + 0.15 * ear, 0.006, 0.8),
    )
    nose = aside((0.034, -0.955, 1.035, 0.022), (0.03, -0.985, 1.005, 0.012))
    brow = aside((0.06, -0.735, 1.29, 0.03), (0.062, -0.78, 1.25, 0.024))
    legs = stouter([front, hind], thick)
    middle = [*stouter([trunk], draw(0.95, 1.08)), withers, neck, head]
    sides = [*legs, ears, nose, brow]
    whole = body(middle, sides, 0.026)
    feet = both_sides([hoof(0.098, y, 0.058 * thick) for y in (-0.29, 0.455)])
    return Horse(whole, feet, eyes_on(whole, (0, -0.752, 1.265), (-1, 0.25, 0), 0.026, 0.4))


def _mane(draw: Draw) -> list[Primitive]:
    """Long locks on one side, the forelock and the tail."""
    side, count = 1 if draw.chance(0.5) else -1, 13
    fall = [(side * x, y, draw(0.9, 1.3) * z) for x, y, z in FALL]
    hanging = locks(CREST, count, fall, (0.028, 0.032, 0.026, 0.007))
    forelock = limb(
        [(0, -0.64, 1.41), (0, -0.7, 1.395), (0.012, -0.765, 1.32)], [0.03, 0.03, 0.008]
    )
    end = draw(0.2, 0.36)
    tail = [
        limb(
            [
                (0, 0.53, 0.86),
                (0, 0.61, 0.83),
                (x, 0.66, 0.64),
                (1.6 * x, 0.65, 0.12 + end),
                (2 * x, 0.69, end),
            ],
            [0.03, 0.04, 0.05, 0.042, 0.01],
        )
        for x in (-0.035, 0.0, 0.03)
    ]
    return [smooth_union([_crest(), *hanging, forelock], 0.012), smooth_union(tail, 0.02)]


def _brush() -> list[Primitive]:
    """A mane that stands, and a tail with a tuft."""
    bristles = []
    for k in range(11):
        root = along(CREST, k / 10)
        bristles.append(limb([root, root + (0, 0.035, 0.05)], [0.03, 0.018], 0.7))
    rope = spine(
        (0.53, 0.86, 0.024, 1), (0.6, 0.8, 0.022, 1), (0.625, 0.58, 0.02, 1), (0.615, 0.5, 0.03, 1)
    )
    tuft = spine((0.617, 0.52, 0.03, 1), (0.62, 0.42, 0.042, 1), (0.63, 0.33, 0.008, 1))
    return [smooth_union([_crest(), *bristles], 0.012), smooth_union([rope, tuft], 0.015)]


def _crest() -> Limb:
    return spine(
        (-0.64, 1.395, 0.032, 0.8),
        (-0.55, 1.3, 0.036, 0.8),
        (-0.42, 1.11, 0.036, 0.8),
        (-0.29, 0.955, 0.03, 0.8),
    )


def _muzzle() -> list[Primitive]:
    """Its end, in another colour."""
    whole = spine((-0.89, 1.075, 0.069, 0.84), (-0.935, 1.015, 0.066, 0.97))
    return [smooth_union([whole], 0.02)]


def _plain(draw: Draw) -> Parts:
    horse = _horse(draw)
    return {"body": [horse.body], "mane": _mane(draw), "hooves": horse.hooves, "eyes": horse.eyes}


def _donkey(draw: Draw) -> Parts:
    horse = _horse(draw, draw(1.8, 2.2), 0.95)
    return {
        "body": [horse.body],
        "mane": _brush(),
        "muzzle": _muzzle(),
        "hooves": horse.hooves,
        "nostrils": both_sides([ball((0.009, 0.014, 0.018), (0.034, -0.992, 1.03))]),
        "eyes": horse.eyes,
    }


def _zebra(draw: Draw) -> Parts:
    horse = _horse(draw, 1.3)
    return {
        "body": [horse.body],
        "mane": _brush(),
        "muzzle": _muzzle(),
        "hooves": horse.hooves,
        "eyes": horse.eyes,
    }


def _unicorn(draw: Draw) -> Parts:
    return _plain(draw) | {"horn": [rod((0, -0.74, 1.34), (0, -0.86, 1.66), 0.026, 0.002)]}


_EACH = {"horse": _plain, "donkey": _donkey, "zebra": _zebra, "unicorn": _unicorn}
HORSES = {noun: with_legs(of) for noun, of in _EACH.items()}
