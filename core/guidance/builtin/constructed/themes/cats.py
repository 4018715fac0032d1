"""Cats and big cats, bears, and the raccoon."""

from collections.abc import Callable

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import aside, spine, with_legs
from core.guidance.builtin.constructed.carnivore import Build, Carnivore, carnivore, pricked
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    both_sides,
    smooth_union,
)

CAT = Build(
    head=1.2, muzzle=0.3, snub=0.86, thick=0.88, stout=0.92, eye=0.034, nose=0.6, carry=22, nod=-14
)
BIG_CAT = Build(
    head=1.06, muzzle=0.62, snub=1.12, thick=1.14, stout=1.06, eye=0.022, carry=14, nod=-6
)
BEAR = Build(head=1.14, muzzle=0.8, snub=1.0, thick=1.45, stout=1.3, eye=0.02, carry=16, nod=-4)


def _tail(draw: Draw, radius: float, tip: float) -> Limb:
    """A long one, hanging or raised."""
    if draw.chance(0.5):
        return spine(
            (0.48, 0.85, radius, 1),
            (0.62, 0.8, radius, 1),
            (0.75, 0.66, 0.9 * radius, 1),
            (0.9, 0.58, 0.85 * radius, 1),
            (1.04, 0.62, tip, 1),
        )
    return spine(
        (0.48, 0.85, radius, 1),
        (0.6, 0.86, radius, 1),
        (0.7, 0.98, 0.95 * radius, 1),
        (0.72, 1.16, 0.9 * radius, 1),
        (0.68, 1.3, tip, 1),
    )


def _round_ear(one: Carnivore, size: float) -> Limb:
    ear = aside(
        (0.095, -0.555, 1.245, size, 0.75), (0.115, -0.555, 1.262 + 0.5 * size, 0.8 * size, 0.7)
    )
    return one.on_head(ear)[0]


def _cat(draw: Draw) -> Parts:
    one = carnivore(CAT, draw)
    whole = one.whole(_tail(draw, 0.036, 0.024), sides=(pricked(one, draw(0.12, 0.16), 0.058),))
    return {"body": [whole, *one.paws], "muzzle": one.muzzle(), **one.face(whole)}


def _big_cat(draw: Draw) -> Parts:
    one = carnivore(BIG_CAT, draw)
    whole = one.whole(_tail(draw, 0.036, 0.03), sides=(_round_ear(one, 0.045),))
    return {"body": [whole, *one.paws], "muzzle": one.muzzle(), **one.face(whole)}


def _lion(draw: Draw) -> Parts:
    one = carnivore(BIG_CAT._replace(head=1.08), draw)
    tail = spine(
        (0.48, 0.85, 0.034, 1), (0.62, 0.8, 0.03, 1), (0.73, 0.67, 0.026, 1), (0.84, 0.59, 0.024, 1)
    )
    whole = one.whole(tail, sides=(_round_ear(one, 0.045),))
    tuft = spine((0.82, 0.6, 0.03, 1), (0.92, 0.57, 0.05, 1), (1.03, 0.57, 0.008, 1))
    mane = [smooth_union(_ruff(one, draw), 0.022), smooth_union([tuft], 0.02)]
    return {"body": [whole, *one.paws], "mane": mane, "muzzle": one.muzzle(), **one.face(whole)}


def _ruff(one: Carnivore, draw: Draw) -> list[Limb]:
    """Tufts around the face, and others behind them down to the chest."""
    (core,) = one.on_head(spine((-0.57, 1.14, 0.175, 1.05), (-0.5, 1.08, 0.19, 1.05)))
    chest = spine((-0.36, 0.92, 0.21, 0.9), (-0.4, 0.78, 0.2, 0.9), (-0.37, 0.64, 0.16, 0.85))
    found, long = [core, chest], draw(0.9, 1.15)
    for row, (y, far, count) in enumerate(((-0.62, 0.24, 15), (-0.53, 0.27, 15))):
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5 * row) / count
            x, z = np.sin(angle), np.cos(angle)
            reach = far * long * (1.0 if z > -0.3 else 1.18)
            at = [
                (0.4 * reach * x, y, 1.15 + 0.4 * reach * z),
                (0.85 * reach * x, y + 0.03, 1.15 + 0.85 * reach * z),
            ]
            at.append((1.05 * reach * x, y + 0.1, 1.15 + 1.05 * reach * z - 0.03))
            found += one.on_head(
                aside(*[(*p, r) for p, r in zip(at, (0.05, 0.045, 0.008), strict=True)])
            )
    for k in range(7):
        x, y = 0.13 * np.sin(np.pi * (k / 6 - 0.5)), -0.4 + 0.02 * (k % 2)
        found.append(
            aside(
                (x, y, 0.84 - 0.1 * (k % 2), 0.05),
                (x, y - 0.05, 0.7 - 0.1 * (k % 2), 0.035),
                (x, y - 0.02, 0.6 - 0.1 * (k % 2), 0.008),
            )
        )
    return found


def _bear(draw: Draw) -> Parts:
    one = carnivore(BEAR, draw)
    hump = spine((-0.22, 0.86, 0.15, 0.9), (-0.1, 0.84, 0.12, 0.9))
    rump = spine((0.3, 0.76, 0.2, 0.9), (0.42, 0.74, 0.19, 0.9))
    tail = spine((0.6, 0.82, 0.05, 1), (0.64, 0.79, 0.03, 1))
    whole = one.whole(hump, rump, tail, sides=(_round_ear(one, 0.042),))
    return {"body": [whole, *one.paws], "muzzle": one.muzzle(), **one.face(whole)}


def _raccoon(draw: Draw) -> Parts:
    one = carnivore(
        Build(
            head=1.16, muzzle=0.85, snub=0.72, thick=0.9, stout=1.08, eye=0.028, carry=16, nod=-4
        ),
        draw,
    )
    nodes = [
        (0.48, 0.84, 0.05, 1),
        (0.6, 0.76, 0.08, 1),
        (0.72, 0.62, 0.09, 1),
        (0.84, 0.5, 0.085, 1),
        (0.97, 0.44, 0.012, 1),
    ]
    tail = spine(*nodes)
    ruff = one.on_head(aside((0.1, -0.6, 1.13, 0.055), (0.165, -0.56, 1.1, 0.012)))
    whole = one.whole(tail, sides=(_round_ear(one, 0.046), *ruff))
    rings = [_ring(tail, t) for t in (0.3, 0.47, 0.64, 0.81)]
    face = one.face(whole)
    mask = [ball((0.085, 0.07, 0.055), face["eyes"][0].center + (0.02, 0.046, -0.006))]
    eyes = [eye._replace(center=eye.center + (0, -0.014, 0)) for eye in face["eyes"]]
    return {
        "body": [whole, *one.paws],
        "mask": both_sides(mask),
        "muzzle": one.muzzle(),
        "stripes": rings,
        "eyes": eyes,
        "nose": face["nose"],
    }


def _ring(tail: Limb, t: float) -> Primitive:
    """A band around a tail."""
    at = t * (len(tail) - 1)
    ends = [
        np.array([np.interp(at + d, range(len(tail)), tail[:, k]) for k in range(5)])
        for d in (-0.13, 0.13)
    ]
    return smooth_union([np.stack(ends) + np.array([0, 0, 0, 0.007, 0])], 0.01)


CATS: dict[str, Callable[[Draw], Parts]] = {
    "cat": with_legs(_cat, 0.74, 0.84),
    "lion": with_legs(_lion, 0.8, 0.9),
    "tiger": with_legs(_big_cat, 0.78, 0.88),
    "leopard": with_legs(_big_cat, 0.8, 0.9),
    "bear": with_legs(_bear, 0.66, 0.76),
    "raccoon": with_legs(_raccoon, 0.6, 0.7),
}
