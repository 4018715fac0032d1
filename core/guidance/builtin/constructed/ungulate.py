"""The body of a beast with hooves or heavy feet, in the proportions of a species."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from core.geometry.parts.limbs import Limb
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import (
    aside,
    body,
    cloven,
    eyes_on,
    spine,
    stouter,
)
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Point, both_sides

SHOULDERS = np.array([0.0, -0.3, 0.8])


class Build(NamedTuple):
    """Lengths are fractions of the height at the withers."""

    neck: float = 0.3  # how long
    carry: float = 25.0  # degrees: how steeply the neck rises
    nape: float = 0.115  # radius of the neck at the head
    throat: float = 0.17  # and at the shoulders
    head: float = 0.34  # how long
    face: float = 45.0  # degrees: how far it points downwards
    skull: float = 0.1  # radius
    nose: float = 0.068
    wide: float = 0.85  # the head: times as wide as deep
    thick: float = 1.0  # the legs
    stout: float = 1.0
    long: float = 1.0  # the trunk
    eye: float = 0.024


class Ungulate(NamedTuple):
    """An animal without its ears, its horns and its tail."""

    middle: list[Limb]
    sides: list[Limb]
    feet: list[Primitive]
    build: Build
    poll: Point

    def whole(self, *more: Limb, sides: Iterable[Limb] = (), softness: float = 0.028) -> Primitive:
        """Its body, with other limbs."""
        return body([*self.middle, *more], [*self.sides, *sides], softness)

    def place(self, along: float, up: float, x: float = 0.0) -> Point:
        """On the head, from its poll towards its nose and upwards, by the head's length."""
        angle, size = np.radians(self.build.face), self.build.head
        forward = np.array([0, -np.cos(angle), -np.sin(angle)])
        high = np.array([0, -np.sin(angle), np.cos(angle)])
        return self.poll + size * (along * forward + up * high + np.array([x, 0, 0]))

    def on_head(self, *nodes: tuple[float, ...]) -> Limb:
        """A limb on the head by nodes as ``place`` has them, with radii by the head's length, and
        how many times as wide."""
        size, found = self.build.head, []
        for along, up, x, radius, *wide in nodes:
            found.append((*self.place(along, up, x), size * radius, *wide))
        return aside(*found)

    def eyes(self, whole: Primitive, along: float = 0.3, up: float = 0.04) -> list[Primitive]:
        """On both sides of the head."""
        return eyes_on(whole, self.place(along, up), (-1, 0.3, 0), self.build.eye, 0.35)

    def muzzle(self, start: float = 0.86, more: float = 0.005, end: float = 1.0) -> Limb:
        """The end of the head, a little larger."""
        build = self.build
        wide = build.wide + (1 - build.wide) * 0.6
        thick = np.interp(start, (0.25, 1.0), (build.skull, build.nose)) / build.head
        return self.on_head(
            (start, -0.03, 0, thick + more / build.head, wide),
            (end, -0.02, 0, build.nose / build.head + more / build.head, wide),
        )


def ungulate(build: Build, draw: Draw) -> Ungulate:
    """One of that build, a little different by its seed."""
    build = build._replace(
        head=build.head * draw(0.95, 1.05),
        stout=build.stout * draw(0.94, 1.07),
        carry=build.carry + draw(-5, 5),
    )
    back = 1 + 0.9 * (build.long - 1)
    trunk = spine(
        (-0.38 * back, 0.69, 0.18, 0.8),
        (-0.18 * back, 0.68, 0.22, 0.85),
        (0.1 * back, 0.68, 0.228, 0.95),
        (0.32 * back, 0.73, 0.195, 0.95),
        (0.45 * back, 0.785, 0.15, 1.05),
    )
    shoulders = SHOULDERS * (1, back, 1)
    withers = spine((-0.32 * back, 0.84, 0.11, 0.6), (-0.1 * back, 0.83, 0.09, 0.7))
    rise = np.radians(build.carry)
    way = np.array([0, -np.cos(rise), np.sin(rise)])
    poll = shoulders + (build.neck + 0.1) * way
    throat, nape = build.throat, build.nape
    neck = aside(
        (*(shoulders - 0.06 * way), throat, 0.75),
        (*(shoulders + (0.1 + 0.45 * build.neck) * way), 0.4 * throat + 0.6 * nape, 0.72),
        (*poll, nape, 0.8),
    )
    front = aside(
        (0.11, -0.31 * back, 0.78, 0.1),
        (0.13, -0.31 * back, 0.62, 0.095),
        (0.125, -0.28 * back, 0.5, 0.07),
        (0.115, -0.275 * back, 0.36, 0.05),
        (0.113, -0.28 * back, 0.28, 0.048),
        (0.11, -0.272 * back, 0.17, 0.035),
        (0.11, -0.272 * back, 0.09, 0.04),
        (0.11, -0.285 * back, 0.05, 0.036),
    )
    hind = aside(
        (0.09, 0.38 * back, 0.76, 0.14),
        (0.115, 0.37 * back, 0.6, 0.112),
        (0.12, 0.42 * back, 0.46, 0.072),
        (0.115, 0.49 * back, 0.33, 0.047),
        (0.11, 0.485 * back, 0.24, 0.038),
        (0.108, 0.47 * back, 0.09, 0.042),
        (0.108, 0.455 * back, 0.05, 0.036),
    )
    feet = [
        *cloven(0.11, -0.29 * back, 0.06 * build.thick),
        *cloven(0.108, 0.45 * back, 0.058 * build.thick),
    ]
    found = Ungulate([], [], both_sides(feet), build, poll)
    size, wide = build.head, build.wide
    head = found.on_head(
        (0.02, 0.0, 0, 0.95 * build.skull / size, wide),
        (0.28, -0.02, 0, build.skull / size, wide),
        (0.68, -0.03, 0, (0.42 * build.skull + 0.58 * build.nose) / size, wide),
        (1.0, -0.03, 0, build.nose / size, wide + (1 - wide) * 0.6),
    )
    middle = [*stouter([trunk], build.stout), withers, neck, head]
    return found._replace(middle=middle, sides=stouter([front, hind], build.thick))
