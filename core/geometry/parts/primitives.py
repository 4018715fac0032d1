"""Simple solids. Most components of things are one: a box, a ball, a wheel, a leg, a board.

Where one fits (:mod:`core.geometry.parts.fitting`, :mod:`core.geometry.parts.layered`), it takes
the place of what was drawn, and has its edges, its roundness and its symmetry.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.geometry.parts.limbs import limbs, limbs_mesh
from core.geometry.parts.pipes import pipes, surface_of, unpacked_pipes
from core.geometry.union import ball, hull, lathe, prisms, rolled, rounded_box, union
from core.kernels import distances

Lengths = Float[np.ndarray, " k"]
Points = Float[np.ndarray, "n 3"]
Loop = Float[np.ndarray, "_ 2"]
Layer = tuple[float, float, Sequence[Loop]]  # from one height to another: outline, holes clockwise
Turn = Float[np.ndarray, " 3"]  # rotation vector, radians

# By so much a sharp edge is rounded that the network draws, a rounded one by less, training units:
# a rim of 0.055 comes out as 0.07, one of 0.08 as it is.
BLUR, UNBLURRED, LEAST_RIM = 0.05, 2.5, 0.02
ON_AXIS = 1e-4  # training units
CHORD = 8e-4  # training units, at most, between a circle and its polygon
SEGMENTS = (24, 96)
# The last axis is z, y and x.
FRAMES = tuple(np.roll(np.eye(3), k, 1) for k in range(3))


def ellipsoid(p: Points, radii: Lengths) -> Float[np.ndarray, " n"]:
    """To first order."""
    return distances.ellipsoid(_contiguous(p), _contiguous(radii))


def box(p: Points, half: Lengths) -> Float[np.ndarray, " n"]:
    """Half sizes, and the radius of the edges."""
    return distances.box(_contiguous(p), _contiguous(half))


def frustum(p: Points, lengths: Lengths) -> Float[np.ndarray, " n"]:
    """A cone without its tip, or a cylinder: half its height, the radii below and above, and the
    radius of the rims."""
    return distances.frustum(_contiguous(p), _contiguous(lengths))


def capsule(p: Points, lengths: Lengths) -> Float[np.ndarray, " n"]:
    """The hull of two balls: half the distance of their middles, the radii below and above."""
    return distances.capsule(_contiguous(p), _contiguous(lengths))


def ring(p: Points, radii: Lengths) -> Float[np.ndarray, " n"]:
    """A torus: its radius, its tube's."""
    return np.hypot(np.hypot(p[:, 0], p[:, 1]) - radii[0], p[:, 2]) - radii[1]


def turned(p: Points, profile: Lengths) -> Float[np.ndarray, " n"]:
    """A closed profile about the axis: radius and height of each corner, one after another."""
    start, end = sides_of([profile.reshape(-1, 2)])
    seen = np.maximum(start[:, 0], end[:, 0]) >= ON_AXIS  # on the axis there is no surface
    across = np.stack([np.hypot(p[:, 0], p[:, 1]), p[:, 2]], 1)
    return _within(across, start[seen], end[seen])


def layers(p: Points, lengths: Lengths) -> Float[np.ndarray, " n"]:
    """Flat outlines one upon another along the axis, as ``packed`` has them; inside, the distance
    from the nearest layer's surface."""
    nearest = np.full(len(p), np.inf)
    for low, high, loops in unpacked(lengths):
        apart = np.abs(p[:, 2] - (low + high) / 2) - (high - low) / 2
        q = np.stack([_within(p[:, :2], *sides_of(loops)), apart])
        nearest = np.minimum(nearest, np.hypot(*q.clip(min=0)) + q.max(0).clip(max=0))
    return nearest


def crossed(p: Points, lengths: Lengths) -> Float[np.ndarray, " n"]:
    """Layers along each of the three axes at once, as ``packed_along`` has them; inside, the
    distance from the nearest layer's surface."""
    return np.min([layers(p @ frame, own) for frame, own in along_axes(lengths)], axis=0)


def wall(p: Points, lengths: Lengths) -> Float[np.ndarray, " n"]:
    """Outlines laid around the axis: the radius at which they are as long as flat, and layers as
    ``packed`` has them, of which height is distance from the axis; about the distance."""
    return layers(unrolled(p, lengths[0]), lengths[1:])


def blade(p: Points, lengths: Lengths) -> Float[np.ndarray, " n"]:
    """A lozenge across that goes up from z = 0 to a point: its half widths along x and y there, how
    high the shoulder is, how long the point, and how many times as wide it is at the shoulder;
    outside, at least the distance from the farthest side's plane."""
    wide, thick, shoulder, tip, slim = lengths
    slope, steep = (slim - 1) / shoulder, slim / tip
    across, z = np.abs(p[:, 0]) / wide + np.abs(p[:, 1]) / thick, p[:, 2]
    norm = np.hypot(1 / wide, 1 / thick)
    side = (across - 1 - slope * z) / np.hypot(norm, slope)
    point = (across - steep * (shoulder + tip - z)) / np.hypot(norm, steep)
    return np.max([side, point, -z], axis=0)


def unrolled(p: Points, radius: float) -> Points:
    """The way around the axis at a radius, 0 where y is least; the height; the distance from it."""
    angle = np.arctan2(p[:, 0], -p[:, 1])
    return np.stack([radius * angle, p[:, 2], np.hypot(p[:, 0], p[:, 1])], 1)


def sides_of(loops: Sequence[Loop]) -> tuple[Loop, Loop]:
    """The first and the last point of each side."""
    return np.concatenate(loops), np.concatenate([np.roll(loop, -1, 0) for loop in loops])


def _within(p: Float[np.ndarray, "n 2"], start: Loop, end: Loop) -> Float[np.ndarray, " n"]:
    """Signed distance from an outline of such sides, negative inside."""
    return distances.outline(_contiguous(p), _contiguous(start), _contiguous(end))


def _contiguous(x: np.ndarray) -> np.ndarray:
    """As the compiled loops take it."""
    return np.ascontiguousarray(x, dtype=float)


def packed(found: Sequence[Layer]) -> Lengths:
    """Each layer's ends and number of loops, each loop's number of corners and
    these."""
    numbers = []
    for low, high, loops in found:
        numbers += [low, high, len(loops)]
        for loop in loops:
            numbers += [len(loop), *loop.ravel()]
    return np.array(numbers)


def unpacked(lengths: Lengths) -> list[Layer]:
    """The layers."""
    found, at = [], 0
    while at < len(lengths):
        low, high, count = lengths[at : at + 3]
        loops, at = [], at + 3
        for _ in range(int(count)):
            corners = int(lengths[at])
            loops.append(lengths[at + 1 : at + 1 + 2 * corners].reshape(-1, 2))
            at += 1 + 2 * corners
        found.append((float(low), float(high), loops))
    return found


def packed_along(axes: Sequence[Sequence[Layer]]) -> Lengths:
    """For each of the three ``FRAMES`` the count of its layers' numbers, and these."""
    each = [packed(found) for found in axes]
    return np.concatenate([[len(numbers), *numbers] for numbers in each])


def along_axes(lengths: Lengths) -> Iterator[tuple[Float[np.ndarray, "3 3"], Lengths]]:
    """The frames that there are layers along the last axis of, and these as ``packed`` has them."""
    at = 0
    for frame in FRAMES:
        end = at + 1 + int(lengths[at])
        if end > at + 1:
            yield frame, lengths[at + 1 : end]
        at = end


class Form(NamedTuple):
    """One kind of solid about the origin, and the z axis if it has one."""

    distance: Callable[[Points, Lengths], Float[np.ndarray, " n"]]
    same: tuple[tuple[int, ...], ...] = ()  # lengths that are often the same
    rims: bool = False  # whether the last length rounds its edges
    # How far points of it are off in the mean, in errors, at most; least fraction within half an
    # error
    fits: tuple[float, float] = (0.22, 0.93)
    # Within so many errors of what is drawn is at least such a fraction of its surface.
    drawn: tuple[tuple[float, float], ...] = ((0.6, 0.9), (1.2, 0.985))


# The network rounds the edges of an outline; battlements, a spout or a notch are no noise of what
# is turned.
OUTLINED = {"fits": (0.25, 0.85), "drawn": ((0.6, 0.84), (1.2, 0.985))}
FORMS = {
    "ellipsoid": Form(ellipsoid, ((0, 1, 2), (0, 1), (0, 2), (1, 2))),
    "box": Form(box, rims=True),
    "frustum": Form(frustum, ((1, 2),), rims=True),
    "capsule": Form(capsule, ((1, 2),)),
    "ring": Form(ring),
    "turned": Form(turned, drawn=((0.6, 0.9), (1.2, 0.995))),
    "layers": Form(layers, **OUTLINED),
    "crossed": Form(crossed, **OUTLINED),
    "wall": Form(wall, **OUTLINED),
    "pipes": Form(pipes, fits=(0.25, 0.85), drawn=((0.6, 0.84), (1.2, 0.96))),
    "limbs": Form(limbs),
    "blade": Form(blade, fits=(0.25, 0.85), drawn=((0.6, 0.75), (1.5, 0.95))),
}


class Primitive(NamedTuple):
    """A solid of some form in its place; lengths in training units."""

    form: str
    center: Float[np.ndarray, " 3"]
    turn: Turn
    lengths: Lengths

    def distance(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distance, negative inside; of an ellipsoid to first order."""
        return torch.from_numpy(self.at(points.detach().cpu().double().numpy())).to(points)

    def at(self, points: Points) -> Float[np.ndarray, " n"]:
        """The same, without torch."""
        return FORMS[self.form].distance(self.local(points), self.lengths)

    @property
    def frame(self) -> Float[np.ndarray, "3 3"]:
        """Its own axes, the columns."""
        return Rotation.from_rotvec(self.turn).as_matrix()

    def local(self, points: Points) -> Points:
        """The points where the solid is about the origin."""
        return (points - self.center) @ self.frame

    def off(self, points: Points, error: float) -> float:
        """How far the points are from its surface in the mean, in errors."""
        return float(np.abs(self.at(points)).mean() / error)

    def fits(self, points: Points, error: float) -> bool:
        """Whether the points are on its surface up to their errors."""
        within = (np.abs(self.at(points)) < error / 2).mean()
        mean, least = FORMS[self.form].fits
        return self.off(points, error) <= mean and bool(within >= least)

    def placed(
        self, frame: Float[np.ndarray, "3 3"], origin: Float[np.ndarray, " 3"]
    ) -> "Primitive":
        """In the frame, its columns, at an origin; a frame may mirror x or y, as all forms are the
        same on both sides of these."""
        turn = frame @ self.frame
        turn = turn @ np.diag(np.sign([np.linalg.det(frame), 1, 1]))
        turn = Rotation.from_matrix(turn).as_rotvec()
        return self._replace(center=frame @ self.center + origin, turn=turn)

    def sharp(self) -> "Primitive":
        """With its rims as they were before a network drew them."""
        if not FORMS[self.form].rims:
            return self
        rim = min((self.lengths[3] - BLUR) * UNBLURRED, self.lengths[3])
        return self._replace(lengths=np.append(self.lengths[:3], rim if rim > LEAST_RIM else 0.0))

    def mesh(self, edge: float) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
        """Its closed surface; flat edges are no longer than ``edge``."""
        verts, faces = _mesh(self.form, self.lengths, edge)
        placed = verts.double().numpy() @ self.frame.T + self.center
        return torch.from_numpy(placed).to(verts), faces


def _mesh(form: str, lengths: Lengths, edge: float) -> tuple[Tensor, Tensor]:
    if form == "box":
        return rounded_box(lengths[:3], lengths[3], edge, _segments(lengths[3]))
    if form == "ellipsoid":
        return ball(lengths, edge, _segments(lengths.max()))
    if form == "layers":
        return prisms(unpacked(lengths), edge)
    if form == "crossed":
        each = ((frame, *prisms(unpacked(own), edge)) for frame, own in along_axes(lengths))
        turned = [(verts @ torch.from_numpy(frame.T).to(verts), f) for frame, verts, f in each]
        return union(turned, 0.0)
    if form == "pipes":
        found = unpacked_pipes(lengths)
        each = [surface_of(one, edge, _segments(one.nodes[:, 3].max())) for one in found]
        return union(each, 0.0)
    if form == "limbs":
        return limbs_mesh(lengths, edge)
    if form == "wall":
        chord = 2 * np.sqrt(2 * CHORD * lengths[0])
        return rolled(unpacked(lengths[1:]), lengths[0], min(edge, chord))
    if form == "blade":
        return hull(_corners(lengths), edge)
    widest = {"ring": lengths.sum(), "turned": lengths[::2].max()}
    count = _segments(widest.get(form, lengths[1:3].max()))
    return lathe(_profile(form, lengths), edge, count)


def _corners(blade: Lengths) -> Points:
    """Where it begins, its shoulder's, its point."""
    wide, thick, shoulder, tip, slim = blade
    across = np.array([(wide, 0), (0, thick), (-wide, 0), (0, -thick)])
    rings = [np.c_[k * across, np.full(4, z)] for k, z in ((1, 0.0), (slim, shoulder))]
    return np.concatenate([*rings, [(0, 0, shoulder + tip)]])


def _profile(form: str, lengths: Lengths) -> Float[np.ndarray, "c 2"]:
    """Radius and height, counter-clockwise."""
    if form == "turned":
        return lengths.reshape(-1, 2)
    if form == "ring":
        radius, tube = lengths
        return np.array([radius, 0.0]) + tube * _arc(0, 2 * np.pi, _segments(tube))[:-1]
    if form == "capsule":
        half, below, above = lengths
        tilt = np.arcsin(np.clip((below - above) / (2 * half), -0.99, 0.99))
        count = _segments(max(below, above)) // 2
        low = below * _arc(-np.pi / 2, tilt, count) + (0, -half)
        return np.concatenate([low, above * _arc(tilt, np.pi / 2, count) + (0, half)])
    half, below, above, rim = lengths
    tilt = np.arctan2(below - above, 2 * half)
    if not rim:
        return np.array([(0, -half), (below, -half), (above, half), (0, half)])
    count = _segments(rim) // 2
    low = rim * _arc(-np.pi / 2, tilt, count) + (below - rim, rim - half)
    high = rim * _arc(tilt, np.pi / 2, count) + (above - rim, half - rim)
    return np.concatenate([[(0, -half)], low, high, [(0, half)]])


def _arc(first: float, last: float, count: int) -> Float[np.ndarray, "c 2"]:
    angle = np.linspace(first, last, count + 1)
    return np.stack([np.cos(angle), np.sin(angle)], 1)


def _segments(radius: float) -> int:
    """A circle's corners, so many that its polygon is as near as ``CHORD``; equal per quarter."""
    count = np.pi / np.arccos(1 - min(CHORD / max(radius, CHORD), 0.5))
    return 4 * int(np.ceil(np.clip(count, *SEGMENTS) / 4))
