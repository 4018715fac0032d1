"""What many things have: wheels, tracks, arches, threads, stars, and stacks of plates."""

import itertools
from collections.abc import Sequence

import numpy as np

from core.geometry.parts.primitives import Loop, Primitive
from core.guidance.builtin.constructed.shapes import SIDE, Place, box, plate, rod, spun, turned

SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
HEXAGON = np.stack([np.cos(np.arange(6) * np.pi / 3), np.sin(np.arange(6) * np.pi / 3)], 1)
PITCH, RIM = 0.085, 0.007  # from one link of a track to the next, about; of its edges


def star(points: int, far: float, near: float, at: Sequence[float] = (0.0, 0.0)) -> Loop:
    """A star's outline with a point upwards: how far its points are from its middle, and its
    corners between them."""
    angle = np.arange(2 * points) * np.pi / points
    away = np.where(np.arange(2 * points) % 2, near, far)[:, None]
    return np.array(at) + away * np.stack([np.sin(angle), np.cos(angle)], 1)


def arch_opening(wide: float, high: float, sides: int = 11) -> Loop:
    """An opening with a round head, on the ground, by its width and its whole height."""
    half = wide / 2
    angle = np.linspace(0, np.pi, sides)
    head = [(half * np.cos(a), high - half + half * np.sin(a)) for a in angle]
    return np.array([(half, 0.0), *head, (-half, 0.0)])


def wheel(radius: float, width: float, spokes: int, rim: float = 0.12) -> list[Primitive]:
    """A spoked cart wheel about the x axis; ``rim``: its height, by the radius."""
    inner, half = (1 - rim) * radius, width / 2
    band = [(inner, -half), (radius, -half), (radius, half), (inner, half)]
    spoke = rod((0, 0, 0), (0, 0, inner + 0.02 * radius), 0.05 * radius, 0.038 * radius)
    hub = rod((-0.8 * width, 0, 0), (0.8 * width, 0, 0), 0.16 * radius, rim=0.01)
    return [turned(band, axis="x"), *spun([spoke], spokes, "x"), hub]


def track(loop: Loop, inside: Loop, x: float, width: float, link: Place) -> list[Primitive]:
    """A crawler's track and its links: the outlines of its outside and its inside, in y and z; the
    size of a link along x, along the track and across it."""
    solids = [plate(loop, width, (x, 0, 0), SIDE, [inside])]
    for a, b in itertools.pairwise([*loop, loop[0]]):
        steps = max(int(np.linalg.norm(b - a) / PITCH), 1)
        turn = np.degrees(np.arctan2(*(b - a)[::-1]))
        for f in (np.arange(steps) + 0.5) / steps:
            solids.append(box(link, (x, *(a + f * (b - a))), RIM, (turn, 0, 0)))
    return solids


def screw_thread(radius: float, start: float, end: float, pitch: float = 0.07) -> list[Primitive]:
    """A screw's ridges about the z axis."""
    return [
        turned([(radius - 0.02, z), (radius + 0.022, z + pitch / 2), (radius - 0.02, z + pitch)])
        for z in np.arange(start, end - pitch, pitch)
    ]
