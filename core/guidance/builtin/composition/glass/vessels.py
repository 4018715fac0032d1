"""The shapes of glass vessels that have something inside, by their noun and what is inside.

A vessel is upright about the z axis, in units of about its radius, until it is put into the
training's size (:meth:`Shape.framed`).
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.primitives import Primitive
from core.geometry.union import room_within
from core.guidance.builtin.composition.placing.placement import Z_TO_X

WALL = 0.055  # of glass
PLATE = 0.012  # over a neck's end
EASED = 6  # sides of a rounded corner of a profile
CORK = 0.9  # of a neck's radius
FLAKES, FLAKE = 16, 0.03
UPRIGHT = np.zeros(3)
Profile = Sequence[tuple[float, float, float]]  # radius, height and rounding of each corner


@dataclass(frozen=True)
class Shape:
    """A vessel's solids by part of its noun; one part is of glass and hollow."""

    glass: str
    parts: Mapping[str, Sequence[Primitive]]
    room: Primitive  # what the glass is around
    middle: tuple[float, float] = (0.0, 0.0)  # of the room, where things stand
    loose: str = ""  # a part that floats in the room

    def moved(self, change: Callable[[Primitive], Primitive]) -> "Shape":
        """The same with each solid changed."""
        parts = {name: [change(one) for one in own] for name, own in self.parts.items()}
        return replace(self, parts=parts, room=change(self.room))

    def framed(self, scale: float, shift: Float[np.ndarray, " 3"]) -> "Shape":
        """Scaled around the origin, then moved."""

        def change(one: Primitive) -> Primitive:
            return one._replace(center=scale * one.center + shift, lengths=scale * one.lengths)

        x, y = self.middle
        middle = scale * x + float(shift[0]), scale * y + float(shift[1])
        return replace(self.moved(change), middle=middle)

    def free(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """How far points are outside the room that the other parts leave; negative in it."""
        kept = [one for name, own in self.parts.items() for one in own if name != self.loose]
        own = self.parts[self.glass]
        taken = [one.distance(points) for one in kept if not any(one is wall for wall in own)]
        return torch.stack([self.room.distance(points), *(-away for away in taken)]).amax(0)


def shape_for(noun: str, high: float, lies: bool) -> Shape:
    """The vessel for contents that are ``high`` times as high as wide; ``lies``: on its side."""
    return _bottle(high, lies) if noun == "bottle" else _SHAPES[noun](high)


def _jar(high: float) -> Shape:
    tall = _between(2.1 * high + 0.7, 1.8, 3.6)
    walls = [(1, 0, 0.25), (1, tall - 0.35, 0.4), (0.8, tall - 0.1, 0.12), (0.8, tall + 0.1, 0)]
    lid = _frustum(tall - 0.02, tall + 0.3, 0.9, 0.9, 0.05)
    return _turned("body", walls, {"lid": [lid]})


def _bottle(high: float, lies: bool) -> Shape:
    tall = _between(1.5 / high + 0.9, 2.2, 4.0) if lies else _between(2.1 * high + 0.3, 2.2, 4.4)
    neck, end = 0.36, tall + 1.5
    walls = [(1, 0, 0.25), (1, tall, 0.9), (neck, tall + 0.75, 0.4), (neck, end, 0.0)]
    lip = Primitive("ring", np.array([0, 0, end - 0.06]), UPRIGHT, np.array([neck, 0.09]))
    inner = CORK * (neck - WALL)
    shape = _turned("body", walls, {"cap": [_frustum(end - 0.5, end + 0.3, inner, neck, 0.03)]})
    shape = replace(shape, parts={**shape.parts, "body": [*shape.parts["body"], lip]})
    if not lies:
        return shape
    frame = Z_TO_X.double().numpy()
    shape = shape.moved(lambda one: one.placed(frame, np.zeros(3)))
    stand = [_box((0.16, 0.62, 0.28), (x, 0.0, -1.02)) for x in (0.22 * tall, 0.85 * tall)]
    parts = {**shape.parts, "cap": [*shape.parts["cap"], *stand]}
    return replace(shape, parts=parts, middle=(0.5 * tall, 0.0))


def _flask(high: float) -> Shape:
    tall = _between(1.6 * high + 1.4, 2.2, 3.2)
    walls = [(1.25, 0, 0.35), (0.34, tall, 0.5), (0.34, tall + 0.9, 0)]
    lip = Primitive("ring", np.array([0, 0, tall + 0.88]), UPRIGHT, np.array([0.36, 0.09]))
    return _turned("glass", walls, {"rim": [lip]})


def _potion(high: float) -> Shape:
    del high
    walls = [*_ball(1.0, 0.95, -70, 66), (0.4, 2.1, 0.2), (0.4, 2.6, 0)]
    lip = Primitive("ring", np.array([0, 0, 2.58]), UPRIGHT, np.array([0.4, 0.1]))
    cork = _frustum(2.3, 2.95, CORK * (0.4 - WALL), 0.38, 0.04)
    return _turned("flask", walls, {"rim": [lip], "cork": [cork]})


def _snow_globe(high: float) -> Shape:
    del high
    middle = 1.35
    walls = _ball(1.0, middle, -80, 90)
    ground = [(0.0, middle - 0.97, 0.0), *_ball(0.97, middle, -75, -33), (0, middle - 0.47, 0)]
    parts = {
        "base": [_frustum(0, 0.34, 1.0, 0.92, 0.08), _frustum(0.3, 0.72, 0.84, 0.76, 0.08)],
        "snow": [_lathed(ground)],
        "flakes": _flakes(middle),
    }
    return replace(_turned("glass", walls, parts), loose="flakes")


def _flakes(middle: float) -> list[Primitive]:
    spread = np.random.default_rng(0).uniform(-1, 1, (16 * FLAKES, 3))
    inside = spread[(np.linalg.norm(spread, axis=1) < 0.9) & (spread[:, 2] > -0.35)]
    return [
        Primitive("ellipsoid", at + np.array([0, 0, middle]), UPRIGHT, np.full(3, FLAKE))
        for at in inside[:FLAKES]
    ]


def _crystal_ball(high: float) -> Shape:
    del high
    ring = Primitive("ring", np.array([0, 0, 0.47]), UPRIGHT, np.array([0.66, 0.07]))
    stand = [_frustum(0, 0.2, 0.9, 0.8, 0.06), _frustum(0.15, 0.5, 0.6, 0.68, 0.06)]
    return _turned("ball", _ball(1.0, 1.2, -80, 90), {"stand": stand, "bands": [ring]})


def _light_bulb(high: float) -> Shape:
    del high
    walls = [(0.42, 0.9, 0), (0.42, 1.1, 0.3), *_ball(1.0, 2.2, -50, 90)]
    screw = [_frustum(0.3 + 0.2 * k, 0.5 + 0.2 * k, 0.45, 0.45, 0.09) for k in range(3)]
    cap = [_frustum(0.25, 1.0, 0.41, 0.41, 0.03), *screw]
    return _turned("bulb", walls, {"cap": cap, "tip": [_frustum(0, 0.32, 0.16, 0.38, 0.04)]})


def _dome(high: float) -> Shape:
    tall = _between(2.1 * high + 0.5, 1.7, 4.2)
    below = 0.3
    walls = [(1, below, 0), *_ball(1.0, below + tall - 1, 0, 90)]
    base = [_frustum(0, 0.2, 1.25, 1.25, 0.06), _frustum(0.15, below + 0.02, 1.12, 1.08, 0.03)]
    base.append(_frustum(0.1, below + WALL + 0.03, 0.96, 0.96, 0.0))
    knob = [
        Primitive("ellipsoid", np.array([0, 0, below + tall + 0.12]), UPRIGHT, np.full(3, 0.15))
    ]
    shape = _turned("glass", walls, {"base": base})
    return replace(shape, parts={**shape.parts, "glass": [*shape.parts["glass"], *knob]})


def _tank(high: float) -> Shape:
    tall = _between(0.8 * high + 0.5, 0.7, 1.3)
    glass, room = (_box((1.3 - by, 0.85 - by, tall - by), (0, 0, tall)) for by in (0.0, WALL))
    at = ((1.3, 0.05, 0.85, 0.0), (0.05, 0.9, 0.0, 1.3))
    bars = [
        _box((wide, deep, 0.06), (side * x, side * y, z))
        for wide, deep, y, x in at
        for side in (-1, 1)
        for z in (0.03, 2 * tall - 0.03)
    ]
    bars += [_box((0.05, 0.05, tall), (x, y, tall)) for x in (-1.3, 1.3) for y in (-0.85, 0.85)]
    soil = _box((1.27, 0.82, 0.16), (0, 0, 0.19))
    return Shape("water", {"water": [glass], "frame": bars, "gravel": [soil]}, room)


def _turned(glass: str, walls: Profile, parts: Mapping[str, Sequence[Primitive]]) -> Shape:
    """A vessel whose glass is turned about the axis, closed at both ends."""
    has_neck = walls[-1][0] > 0
    ends = [(0.0, walls[0][1], 0.0), *walls, *([(0.0, walls[-1][1], 0.0)] if has_neck else [])]
    outer = _eased(ends)
    solid = Primitive("turned", np.zeros(3), UPRIGHT, outer.ravel())
    inner = room_within(outer, WALL)
    # A neck is closed by its cork, not by a plate of glass.
    if has_neck:
        inner[inner[:, 1] > walls[-1][1] - 1.5 * WALL, 1] = walls[-1][1] - PLATE
    room = Primitive("turned", np.zeros(3), UPRIGHT, inner.ravel())
    return Shape(glass, {glass: [solid], **parts}, room)


def _lathed(corners: Profile) -> Primitive:
    return Primitive("turned", np.zeros(3), UPRIGHT, _eased(corners).ravel())


def _ball(radius: float, middle: float, low: float, high: float) -> list[tuple[float, ...]]:
    """A profile along a ball, from one latitude to another, degrees."""
    angles = np.radians(np.linspace(low, high, max(int((high - low) / 5), 2)))
    return [
        (max(radius * math.cos(a), 0.0) if a < math.pi / 2 - 1e-6 else 0.0,
         middle + radius * math.sin(a), 0.0)
        for a in angles
    ]  # fmt: skip


def _eased(corners: Profile) -> Float[np.ndarray, "k 2"]:
    """A profile with rounded corners: from each the given length back on both its sides."""
    points = np.array([corner[:2] for corner in corners])
    found = []
    for k, (_, _, by) in enumerate(corners):
        if not by:
            found.append(points[k][None])
            continue
        before, after = points[k - 1] - points[k], points[k + 1] - points[k]
        start = points[k] + before * min(by / np.linalg.norm(before), 0.5)
        end = points[k] + after * min(by / np.linalg.norm(after), 0.5)
        t = np.linspace(0, 1, EASED + 1)[:, None]
        found.append((1 - t) ** 2 * start + 2 * t * (1 - t) * points[k] + t**2 * end)
    return np.concatenate(found)


def _frustum(low: float, high: float, below: float, above: float, rim: float) -> Primitive:
    center = np.array([0, 0, (low + high) / 2])
    return Primitive("frustum", center, UPRIGHT, np.array([(high - low) / 2, below, above, rim]))


def _box(half: Sequence[float], center: Sequence[float]) -> Primitive:
    return Primitive("box", np.array(center, float), UPRIGHT, np.array([*half, 0.0]))


def _between(x: float, least: float, most: float) -> float:
    return min(max(x, least), most)


_SHAPES: dict[str, Callable[[float], Shape]] = {
    "jar": _jar,
    "flask": _flask,
    "potion": _potion,
    "snow globe": _snow_globe,
    "crystal ball": _crystal_ball,
    "light bulb": _light_bulb,
    "glass dome": _dome,
    "aquarium": _tank,
}
