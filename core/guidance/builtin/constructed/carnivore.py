"""The body of a beast of prey on four legs, in the proportions of a breed or a species."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import (
    aside,
    body,
    eyes_on,
    grown,
    on_surface,
    paw,
    spine,
    stouter,
)
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts, Point, ball, both_sides, smooth_union

NAPE, SHOULDERS = (0.0, -0.5, 1.1), (0.0, -0.28, 0.8)


class Build(NamedTuple):
    """What a species or a breed is known by, times a hound's."""

    head: float = 1.0
    muzzle: float = 1.0  # how long
    snub: float = 1.0  # how thick
    thick: float = 1.0  # the legs
    stout: float = 1.0
    eye: float = 0.027
    nose: float = 1.0
    nod: float = 0.0  # degrees: how far the head is turned downwards
    carry: float = 0.0  # degrees: how far the neck is lowered


class Carnivore(NamedTuple):
    """An animal without its ears and its tail."""

    middle: list[Limb]
    sides: list[Limb]
    paws: list[Primitive]
    build: Build

    def whole(self, *more: Limb, sides: tuple[Limb, ...] = ()) -> Primitive:
        """Its body, with other limbs."""
        return body([*self.middle, *more], [*self.sides, *sides])

    def on_head(self, *limbs: Limb) -> list[Limb]:
        """Limbs as its head is."""
        return carried(self.build, grown(limbs, NAPE, self.build.head, self.build.nod))

    def place(self, y: float, z: float, x: float = 0.0) -> tuple[float, float, float]:
        """A place as its head is."""
        (at,) = self.on_head(aside((x, y, z, 0.0), (x, y, z, 0.0)))
        return tuple(at[0, :3])

    @property
    def tip(self) -> Point:
        """Within the end of its muzzle."""
        return np.array(self.place(-0.76 - 0.12 * self.build.muzzle, 1.13))

    def face(self, whole: Primitive) -> Parts:
        """Its eyes, and its nose at the end of its muzzle."""
        size = self.build.head
        eye = self.build.eye * size
        eyes = eyes_on(whole, self.place(-0.7, 1.208, 0.06), (-0.3, 1, 0), eye, 0.3, 0.9)
        tip = on_surface(whole, self.tip - np.array((0, 3.0, 0)), (0, 1, 0))
        wide = self.build.nose * size
        nose = ball(
            (0.037 * wide, 0.026 * wide, 0.028 * wide), tip + np.array((0, 0.006, 0.012 * size))
        )
        return {"eyes": eyes, "nose": [nose]}

    def muzzle(self) -> list[Primitive]:
        """Its end, in another colour."""
        return [smooth_union(self.on_head(*_snout(self.build, 0.009)), 0.02)]


def _snout(build: Build, more: float = 0.0) -> list[Limb]:
    """The muzzle and the lower jaw; ``more``: how much thicker, and from farther in front."""
    far, k = -0.78 - 0.13 * build.muzzle, build.snub
    start = 0.03 if more else 0.0
    upper = spine(
        (-0.715 - start, 1.145, 0.08 * k + more / 2, 0.95),
        (far + 0.07 * build.muzzle, 1.13, 0.061 * k + more, 0.97),
        (far, 1.12, 0.047 * k + more, 1.0),
    )
    lower = spine(
        (-0.66 - start, 1.085, 0.055 * k + more, 0.9), (far + 0.03, 1.078, 0.033 * k + more, 1.0)
    )
    return [upper, lower]


def carried(build: Build, limbs: Iterable[Limb]) -> list[Limb]:
    """Limbs of the neck and the head, lowered."""
    return grown(limbs, SHOULDERS, 1.0, build.carry)


def carnivore(build: Build, draw: Draw) -> Carnivore:
    """One of that build, a little different by its seed."""
    build = build._replace(
        head=build.head * draw(0.95, 1.06),
        muzzle=build.muzzle * draw(0.88, 1.15),
        stout=build.stout * draw(0.94, 1.08),
    )
    trunk = spine(
        (-0.36, 0.72, 0.18, 0.82),
        (-0.22, 0.7, 0.205, 0.82),
        (0.05, 0.725, 0.172, 0.86),
        (0.28, 0.77, 0.138, 0.9),
        (0.42, 0.79, 0.14, 0.95),
    )
    neck = spine((-0.3, 0.82, 0.165, 0.75), (-0.43, 0.99, 0.13, 0.82), (-0.51, 1.1, 0.12, 0.9))
    skull = spine(
        (-0.55, 1.17, 0.125, 1.0), (-0.64, 1.185, 0.125, 1.02), (-0.71, 1.15, 0.095, 0.95)
    )
    cheek = aside((0.07, -0.62, 1.13, 0.06), (0.06, -0.67, 1.11, 0.045))
    front = aside(
        (0.09, -0.31, 0.78, 0.1),
        (0.115, -0.33, 0.62, 0.085),
        (0.115, -0.27, 0.49, 0.062),
        (0.108, -0.275, 0.33, 0.046),
        (0.106, -0.285, 0.17, 0.045),
        (0.106, -0.3, 0.08, 0.04),
        (0.106, -0.315, 0.05, 0.038),
    )
    hind = aside(
        (0.075, 0.36, 0.77, 0.13),
        (0.11, 0.34, 0.6, 0.105),
        (0.112, 0.37, 0.46, 0.07),
        (0.108, 0.475, 0.3, 0.042),
        (0.105, 0.475, 0.22, 0.037),
        (0.105, 0.445, 0.09, 0.038),
        (0.105, 0.425, 0.05, 0.037),
    )
    head = grown([skull, *_snout(build)], NAPE, build.head, build.nod)
    cheek, *_ = carried(build, grown([cheek], NAPE, build.head, build.nod))
    high = carried(build, [*stouter([neck], (1 + build.head) / 2), *head])
    middle = [*stouter([trunk], build.stout), *high]
    sides = [*stouter([front, hind], build.thick), cheek]
    size = 0.064 * build.thick
    paws = both_sides([paw(0.106, -0.325, size), paw(0.105, 0.415, 0.94 * size)])
    return Carnivore(middle, sides, paws, build)


def pricked(one: Carnivore, high: float = 0.16, wide: float = 0.055) -> Limb:
    """An ear that stands, of the body."""
    ear = aside(
        (0.072, -0.555, 1.255, wide, 0.85),
        (0.086, -0.55, 1.255 + 0.5 * high, 0.75 * wide, 0.65),
        (0.095, -0.555, 1.26 + high, 0.008, 0.8),
    )
    return one.on_head(ear)[0]
