"""Simple solids in their places, in words: boxes, rods, balls, rings, pipes, plates, turned ones.

Lengths are in any unit; a thing is brought to the training's size at the end. x is to the thing's
left (the viewer's right), y to its rear, z up.
"""

from collections.abc import Iterable, Sequence

import numpy as np
import torch
from jaxtyping import Float
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from core.geometry.parts.limbs import Limb, packed_limbs, unpacked_limbs
from core.geometry.parts.pipes import Pipe, packed_pipes, unpacked_pipes
from core.geometry.parts.primitives import Loop, Primitive, packed, unpacked
from core.guidance.builtin.stretch import training_size

Point = Float[np.ndarray, " 3"]
Frame = Float[np.ndarray, "3 3"]  # columns: the solid's own axes
Place = Sequence[float] | Point
Places = Sequence[Place] | Float[np.ndarray, "n 3"]
Corner = Sequence[float] | Float[np.ndarray, " 2"]
Corners = Loop | Sequence[Corner]
Parts = dict[str, list[Primitive]]

STEPS = 10  # sides of a curve between two of its points
ORIGIN = (0.0, 0.0, 0.0)
# The axes of a plate that lies flat, of one that looks to the front, of one that looks to the side.
FLAT = np.eye(3)
FRONT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
SIDE = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
# The axes in which the heights of what is turned go along -x, x and y; in ``FRONT``, along -y.
LEFTWARD = np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
RIGHTWARD = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
BACKWARD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
EDGE = 0.05  # training units, of the meshes that a thing is measured by


def box(size: Place, at: Place = ORIGIN, rim: float = 0.0, turn: Place = ORIGIN) -> Primitive:
    """A box around ``at``; ``rim``: the radius of its edges; ``turn``: degrees about x, then y,
    then z."""
    half = np.array(size, float) / 2
    return Primitive("box", _point(at), _turn(turn), np.append(half, min(rim, half.min())))


def ball(radius: float | Place, at: Place = ORIGIN, turn: Place = ORIGIN) -> Primitive:
    """A ball, or an ellipsoid with a radius along each axis."""
    radii = np.broadcast_to(np.array(radius, float), 3)
    return Primitive("ellipsoid", _point(at), _turn(turn), radii.copy())


def rod(
    start: Place, end: Place, radius: float, end_radius: float | None = None, rim: float = 0.0
) -> Primitive:
    """A cylinder or a cone's frustum from one place to another, with flat ends; ``rim``: the radius
    of their edges."""
    half, middle, turn = _along(start, end)
    other = radius if end_radius is None else end_radius
    return Primitive("frustum", middle, turn, np.array([half, radius, other, rim]))


def capsule(start: Place, end: Place, radius: float, end_radius: float | None = None) -> Primitive:
    """The hull of two balls."""
    half, middle, turn = _along(start, end)
    other = radius if end_radius is None else end_radius
    return Primitive("capsule", middle, turn, np.array([half, radius, other]))


def ring(radius: float, tube: float, at: Place = ORIGIN, axis: str = "z") -> Primitive:
    """A torus around a coordinate axis."""
    way = np.eye(3)["xyz".index(axis)]
    return Primitive("ring", _point(at), _upright(way), np.array([radius, tube]))


def pipe(points: Places, radius: float | Sequence[float], closed: bool = False) -> Primitive:
    """A smooth curve through points, with one radius or one at each."""
    radii = np.broadcast_to(np.array(radius, float), len(points))
    nodes = np.concatenate([np.array(points, float), radii[:, None]], 1)
    return Primitive("pipes", np.zeros(3), np.zeros(3), packed_pipes([Pipe(nodes, closed)]))


def limb(
    points: Places, radius: float | Sequence[float], wide: float | Sequence[float] = 1.0
) -> Limb:
    """A smooth curve through points, with a radius at each, and how many times as wide as deep it
    is there; for ``smooth_union``."""
    count = len(points)
    columns = [np.broadcast_to(np.array(of, float), count) for of in (radius, wide)]
    return np.concatenate([np.array(points, float), np.stack(columns, 1)], 1)


def smooth_union(limbs: Iterable[Limb], softness: float) -> Primitive:
    """Limbs that flow into one another; the softer, the rounder where they meet."""
    return Primitive("limbs", np.zeros(3), np.zeros(3), packed_limbs(list(limbs), softness))


def joined(one: Primitive, other: Primitive) -> Primitive:
    """Two smooth unions as one, as soft as the first is."""
    (limbs, softness), (more, _) = (unpacked_limbs(each.lengths) for each in (one, other))
    return smooth_union([*limbs, *more], softness)


def mirrored_limbs(limbs: Iterable[Limb]) -> list[Limb]:
    """Limbs and their mirror images across x = 0."""
    each = list(limbs)
    return [*each, *(one * np.array([-1.0, 1, 1, 1, 1]) for one in each)]


def plate(
    outline: Corners,
    thick: float,
    at: Place = ORIGIN,
    frame: Frame = FLAT,
    holes: Iterable[Loop] = (),
) -> Primitive:
    """A flat outline, half of its thickness on each side of ``at``; in x and y, with ``FRONT`` in x
    and z, with ``SIDE`` in y and z."""
    loops = [turning(outline), *(turning(hole, False) for hole in holes)]
    turn = Rotation.from_matrix(frame).as_rotvec()
    return Primitive("layers", _point(at), turn, packed([(-thick / 2, thick / 2, loops)]))


def turned(profile: Corners, at: Place = ORIGIN, axis: str = "z") -> Primitive:
    """A solid of revolution: radius and height of the corners of its section, from the lowest
    around its outside to the highest, and back inside if it is hollow."""
    way = np.eye(3)["xyz".index(axis)]
    corners = turning(profile)
    return Primitive("turned", _point(at), _upright(way), corners.ravel())


def circle(radius: float, at: Sequence[float] = (0.0, 0.0), sides: int = 64) -> Loop:
    """A round outline."""
    angle = np.arange(sides) / sides * 2 * np.pi
    return np.array(at) + radius * np.stack([np.cos(angle), np.sin(angle)], 1)


def rounded(size: Sequence[float], radius: float, at: Sequence[float] = (0.0, 0.0)) -> Loop:
    """A rectangle with round corners."""
    (x, y), corners = (np.array(size) / 2 - radius), []
    for k, (a, b) in enumerate(((x, y), (-x, y), (-x, -y), (x, -y))):
        angle = (k + np.linspace(0, 1, 7)) * np.pi / 2
        corners.append(np.array([a, b]) + radius * np.stack([np.cos(angle), np.sin(angle)], 1))
    return np.array(at) + np.concatenate(corners)


def curve(points: Corners) -> Loop:
    """A smooth open curve through points of a plane."""
    known = np.array(points, float)
    way = np.cumsum([0, *np.linalg.norm(np.diff(known, axis=0), axis=1)])
    return CubicSpline(way, known)(np.linspace(0, way[-1], STEPS * (len(known) - 1) + 1))


def closed_curve(points: Corners) -> Loop:
    """A smooth closed curve through points of a plane."""
    known = np.array([*points, points[0]], float)
    way = np.cumsum([0, *np.linalg.norm(np.diff(known, axis=0), axis=1)])
    found = CubicSpline(way, known, bc_type="periodic")
    return found(np.linspace(0, way[-1], STEPS * len(points) + 1)[:-1])


def turning(loop: Corners, left: bool = True) -> Loop:
    """The loop with its inside on the left, or on the right."""
    corners = np.array(loop, float)
    x, y = corners.T
    area = float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    return corners if (area > 0) is left else corners[::-1].copy()


def placed(solids: Iterable[Primitive], frame: Frame, at: Place = ORIGIN) -> list[Primitive]:
    """Solids turned about the origin, then moved."""
    return [one.placed(frame, _point(at)) for one in solids]


def moved(solids: Iterable[Primitive], by: Place) -> list[Primitive]:
    """Solids at another place."""
    return placed(solids, np.eye(3), by)


def spun(solids: Iterable[Primitive], count: int, about: str = "z") -> list[Primitive]:
    """So many copies around a coordinate axis."""
    each = list(solids)
    way = np.eye(3)["xyz".index(about)]
    turns = (Rotation.from_rotvec(2 * np.pi * k / count * way).as_matrix() for k in range(count))
    return [one for turn in turns for one in placed(each, turn)]


def both_sides(solids: Iterable[Primitive]) -> list[Primitive]:
    """Solids and their mirror images across x = 0."""
    each = list(solids)
    return [*each, *map(_mirrored, each)]


def framed(one: Primitive, scale: float, shift: Point) -> Primitive:
    """A solid scaled about the origin, then moved."""
    lengths = one.lengths * scale
    if one.form == "layers":
        each = unpacked(one.lengths)
        lengths = packed([(scale * a, scale * b, [scale * x for x in own]) for a, b, own in each])
    elif one.form == "pipes":
        each = unpacked_pipes(one.lengths)
        lengths = packed_pipes([pipe._replace(nodes=scale * pipe.nodes) for pipe in each])
    elif one.form == "limbs":
        limbs, softness = unpacked_limbs(one.lengths)
        by = np.array([scale, scale, scale, scale, 1.0])
        lengths = packed_limbs([by * nodes for nodes in limbs], scale * softness)
    return one._replace(center=scale * one.center + shift, lengths=lengths)


def of_training_size(parts: Parts) -> Parts:
    """A thing in the place and the size in which things are drawn."""
    meshes = [one.mesh(np.inf)[0] for own in parts.values() for one in own]
    scale, shift = training_size(torch.cat(meshes).float())
    by = shift.double().numpy()
    return {name: [framed(one, scale, by) for one in own] for name, own in parts.items()}


def _mirrored(one: Primitive) -> Primitive:
    across = np.diag([-1.0, 1.0, 1.0])
    turn = Rotation.from_matrix(across @ one.frame @ across).as_rotvec()
    lengths = one.lengths
    if one.form == "layers":
        flip = np.array([-1.0, 1.0])
        each = unpacked(lengths)
        lengths = packed([(a, b, [(flip * loop)[::-1] for loop in own]) for a, b, own in each])
    elif one.form == "pipes":
        flip = np.array([-1.0, 1.0, 1.0, 1.0])
        each = unpacked_pipes(lengths)
        lengths = packed_pipes([pipe._replace(nodes=flip * pipe.nodes) for pipe in each])
    elif one.form == "limbs":
        limbs, softness = unpacked_limbs(lengths)
        flip = np.array([-1.0, 1.0, 1.0, 1.0, 1.0])
        lengths = packed_limbs([flip * nodes for nodes in limbs], softness)
    return one._replace(center=across @ one.center, turn=turn, lengths=lengths)


def _point(at: Place) -> Point:
    return np.array(at, float)


def _turn(degrees: Place) -> Point:
    return Rotation.from_euler("xyz", np.array(degrees, float), degrees=True).as_rotvec()


def _upright(way: Point) -> Point:
    """The rotation vector that turns z to a direction."""
    other = np.eye(3)[np.abs(way).argmin()]
    x = np.cross(other, way) / np.linalg.norm(np.cross(other, way))
    return Rotation.from_matrix(np.stack([x, np.cross(way, x), way], 1)).as_rotvec()


def _along(start: Place, end: Place) -> tuple[float, Point, Point]:
    """Half the length, the middle, and the rotation vector of what goes from one to the other."""
    first, last = _point(start), _point(end)
    length = float(np.linalg.norm(last - first))
    return length / 2, (first + last) / 2, _upright((last - first) / length)
