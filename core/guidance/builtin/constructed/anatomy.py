"""What animals are put together from: limbs that flow into one another, paws, hooves, eyes, locks.

y goes to the rear and z up, as everywhere here; an animal's withers are about 1 high.
"""

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from core.geometry.parts.limbs import Limb, packed_limbs, unpacked_limbs
from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    Place,
    Point,
    ball,
    both_sides,
    limb,
    mirrored_limbs,
    rod,
    smooth_union,
)

MARCH, STEPS, NEAR = 0.8, 200, 1e-4  # of a distance; at most; from the surface
AWAY = 3.0  # from where a surface is looked for
LEGS = 0.5  # the height up to which it is leg

Node = tuple[float, float, float, float]


def spine(*nodes: Node) -> Limb:
    """A limb in the middle: y, z, radius, and how many times as wide, of each node."""
    each = np.array(nodes, float)
    return np.concatenate([np.zeros((len(each), 1)), each], 1)


def aside(*nodes: Sequence[float]) -> Limb:
    """A limb on the left: x, y, z, radius, and how many times as wide, or 1, of each node."""
    return np.array([[*node, 1.0][:5] for node in nodes], float)


def grown(limbs: Iterable[Limb], about: Place, by: float, pitch: float = 0.0) -> list[Limb]:
    """Limbs of another size about a place, and turned there: by so many degrees, downwards."""
    c, s = np.cos(np.radians(pitch)), np.sin(np.radians(pitch))
    turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    return [_moved(one, lambda p: (p - about) @ turn.T * by + about, by) for one in limbs]


def legged(parts: Parts, by: float) -> Parts:
    """An animal with longer legs."""
    return {name: [_raised(one, by) for one in own] for name, own in parts.items()}


def _raised(one: Primitive, by: float) -> Primitive:
    """A solid of it: limbs are as much longer as their nodes are on the legs, others as high."""
    low, high = by, (by - 1) * LEGS
    if one.form != "limbs":
        over = one.center[2] > LEGS
        return one._replace(center=one.center + np.array((0, 0, high if over else 0.0)))
    limbs, softness = unpacked_limbs(one.lengths)
    for nodes in limbs:
        z = nodes[:, 2]
        nodes[:, 2] = np.where(z < LEGS, low * z, z + high)
    return one._replace(lengths=packed_limbs(limbs, softness))


def with_legs(
    of: Callable[[Draw], Parts], low: float = 0.93, high: float = 1.07
) -> Callable[[Draw], Parts]:
    """An animal whose legs are longer or shorter by its seed."""
    return lambda draw: legged(of(draw), draw(low, high))


def stouter(limbs: Iterable[Limb], by: float) -> list[Limb]:
    """Limbs with other radii."""
    return [one * np.array([1, 1, 1, by, 1]) for one in limbs]


def _moved(one: Limb, to: Callable[[np.ndarray], np.ndarray], size: float = 1.0) -> Limb:
    made = one.copy()
    made[:, :3], made[:, 3] = to(one[:, :3]), size * one[:, 3]
    return made


def body(middle: Iterable[Limb], sides: Iterable[Limb], softness: float = 0.028) -> Primitive:
    """Limbs in the middle, and others on both sides, in one."""
    return smooth_union([*middle, *mirrored_limbs(sides)], softness)


def on_surface(one: Primitive, start: Place, way: Place) -> Point:
    """Where a line from outside meets the solid.

    Raises ValueError if it misses it.
    """
    along = np.array(way, float) / np.linalg.norm(way)
    at = np.array(start, float)
    for _ in range(STEPS):
        off = float(one.at(at[None])[0])
        if off < NEAR:
            return at
        at = at + MARCH * off * along
    raise ValueError(f"A line from {start} along {way} misses the solid.")


def eyes_on(
    one: Primitive, at: Place, way: Place, radius: float, sunk: float = 0.35, flat: float = 1.0
) -> list[Primitive]:
    """Balls on both sides where a line through ``at``, along ``way``, meets the head.

    Args:
        sunk: radii that their middles are within it.
        flat: of their radius, across.
    """
    along = np.array(way, float) / np.linalg.norm(way)
    there = on_surface(one, np.array(at, float) - AWAY * along, along)
    return both_sides([ball((flat * radius, radius, radius), there + sunk * radius * along)])


def paw(x: float, y: float, radius: float, toes: int = 4, long: float = 1.0) -> Primitive:
    """A left paw on the ground."""
    r = radius
    limbs = [
        aside((x, y + 0.45 * r, 0.72 * r, 0.62 * r), (x, y - 0.15 * r * long, 0.66 * r, 0.66 * r))
    ]
    for t in np.linspace(-1, 1, toes):
        back, tip = (
            (x + 0.35 * r * t, y - 0.2 * r),
            (x + 0.62 * r * t, y - long * r * (1.05 - 0.25 * t * t)),
        )
        limbs.append(aside((*back, 0.72 * r, 0.4 * r), (*tip, 0.38 * r, 0.36 * r)))
    return smooth_union(limbs, 0.09 * r)


def hoof(x: float, y: float, radius: float, high: float = 0.07) -> Primitive:
    """A left hoof of one toe on the ground."""
    return rod(
        (x, y + 0.03 * radius, high), (x, y - 0.35 * radius, 0), 0.64 * radius, radius, 0.008
    )


def cloven(x: float, y: float, radius: float, high: float = 0.06) -> list[Primitive]:
    """A left hoof of two toes on the ground."""
    r = radius
    return [
        rod(
            (x + 0.28 * s * r, y, high),
            (x + 0.4 * s * r, y - 0.4 * r, 0),
            0.42 * r,
            0.56 * r,
            0.006,
        )
        for s in (-1, 1)
    ]


def nails(
    places: Iterable[tuple[float, float]], radius: float, spread: float, size: float
) -> list[Primitive]:
    """Three on each foot, whose middles on the left are at such x and y; ``spread``: degrees."""
    found = []
    for x, y in places:
        for angle in np.radians([-spread, 0.0, spread]):
            at = (x + radius * np.sin(angle), y - radius * np.cos(angle), 1.1 * size)
            found.append(ball((size, size, 1.1 * size), at))
    return both_sides(found)


def along(points: Sequence[Place], t: float) -> Point:
    """A place on a broken line: from 0, its first point, to 1, its last."""
    each = np.array(points, float)
    return np.array([np.interp(t, np.linspace(0, 1, len(each)), each[:, k]) for k in range(3)])


def locks(
    points: Sequence[Place], count: int, fall: Sequence[Place], radii: Sequence[float]
) -> list[Limb]:
    """Locks of hair that hang from a line, a little uneven, each along ``fall`` from its place."""
    found = []
    for k, t in enumerate(np.linspace(0, 1, count)):
        root, by = along(points, t), 0.03 * np.sin(3.7 * k)
        steps = np.linspace(0, 1, len(fall))
        sway = np.outer(steps, (0, by, -0.5 * abs(by)))
        found.append(limb(root + np.array(fall, float) + sway, list(radii)))
    return found
