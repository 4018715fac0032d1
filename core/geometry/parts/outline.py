"""The outline of what a flat field has inside, with lines where it was meant to be straight.

Where the polygon that is nowhere far from the outline (Douglas and Peucker 1973) has a side that
does not bend, it was a line; lines that meet have a corner, and the rest is a curve.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import igl
import numpy as np
from jaxtyping import Bool, Float
from scipy import ndimage

Field = Float[np.ndarray, "r c"]
Loop = Float[np.ndarray, "_ 2"]
Point = Float[np.ndarray, " 2"]

TINY = 1e-9  # of a node's distance
SYMMETRY = 0.5  # errors, in the mean, between the two sides of what is the same on both
SPECK = 1.4  # errors: no loop is as small as a square of this side
ONE = 0.5  # errors between lines that are one
CORNERED = 0.3  # errors that a polygon's side may be off the outline
LINE = 2.0  # errors long, at least
FEWEST = 4  # points, without its ends
BEND_DEG = 11.0  # over a line's length, at most
ARC, UNEVEN = np.radians(40.0), 2.5  # between the chords of one arc; of their lengths
RIM = 0.14  # training units along the outline, of a corner that the network has rounded
JUMP = 0.07  # training units from there to the corner, at most
BOARD = 0.15  # training units wide, at most
ALONG_AXIS = np.cos(np.radians(6.0))
CORNER = np.sin(np.radians(15.0))  # between lines that meet in one
SMOOTH, CURVE = 0.015, 0.0015  # that a curve is smoothed over, simplified by; training units


class Line(NamedTuple):
    """A straight side."""

    place: Point
    way: Point  # unit

    def off(self, points: Float[np.ndarray, "*_ 2"]) -> np.ndarray | np.floating:
        """How far the points are to its left."""
        return (points - self.place) @ np.array([-self.way[1], self.way[0]])

    def onto(self, point: Point) -> Point:
        """The nearest place on it."""
        return self.place + self.way * ((point - self.place) @ self.way)

    def meets(self, other: "Line") -> Point | None:
        """Where it crosses another that is not nearly along it."""
        across = cross(self.way, other.way)
        if abs(across) < CORNER:
            return None
        return self.place + self.way * (cross(other.place - self.place, other.way) / across)


def outline(field: Field, low: Point, step: float, error: float) -> list[Loop]:
    """The loops around what is negative, its inside on their left.

    Args:
        field: signed distances at the nodes of a lattice; beyond it nothing is inside.
        low: the first node's place.
        step: between nodes.
        error: about what the distances may be off.
    """
    rimmed = np.pad(field, 1, constant_values=error)
    found = [(loop - 1) * step + low for loop in contours(rimmed)]
    return [straightened(x, error, step) for x in found if abs(area(x)) > (SPECK * error) ** 2]


def even(field: Field, error: float) -> Field:
    """The field as its two sides have it in the mean, where they are the same, each way."""
    for axis in (0, 1):
        other = np.flip(field, axis)
        near = np.abs(field) < error
        if near.any() and np.abs(field - other)[near].mean() < SYMMETRY * error:
            field = (field + other) / 2
    return field


def contours(field: Field) -> Iterator[Loop]:
    """The loops where the field is 0, in nodes, counter-clockwise around what is negative."""
    rows, columns = field.shape
    node = np.arange(rows * columns).reshape(rows, columns)
    place = np.stack([*np.divmod(node.reshape(-1), columns), np.zeros(node.size)], 1)
    a, b, c, d = node[:-1, :-1], node[1:, :-1], node[1:, 1:], node[:-1, 1:]
    triangles = np.concatenate([np.stack(x, -1).reshape(-1, 3) for x in ((a, b, c), (a, c, d))])
    # libigl's run counter-clockwise around maxima. At a node of just 0 two could meet.
    value = np.where(field == 0, TINY, -field).reshape(-1)
    points, steps, _ = map(np.asarray, igl.isolines(place, triangles, value, np.zeros(1)))
    following = np.empty(len(points), int)
    following[steps[:, 0]] = steps[:, 1]
    left = np.ones(len(points), bool)
    for k in range(len(points)):
        loop = []
        while left[k]:
            left[k] = False
            loop.append(k)
            k = following[k]
        if len(loop) > 2:
            yield points[loop, :2]


def area(loop: Loop) -> float:
    """Positive, counter-clockwise."""
    return float(cross(loop, np.roll(loop, -1, 0)).sum() / 2)


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray | np.floating:
    """The third coordinate of the cross product."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def straightened(loop: Loop, error: float, step: float) -> Loop:
    """The loop with lines where it is straight up to its errors, and corners where they meet."""
    spots = corners_of(loop, CORNERED * error)
    if len(spots) < 3:
        return loop
    sides = [between(loop, a, b) for a, b in zip(spots, spots[1:] + spots[:1], strict=True)]
    arcs = chords(loop[spots])
    lines = [None if arc else line_of(x, error) for x, arc in zip(sides, arcs, strict=True)]
    lines = joined(lines, sides, error)
    curve = ndimage.gaussian_filter1d(loop, SMOOTH / step, axis=0, mode="wrap")
    return met(loop, curve, spots, lines)


def corners_of(loop: Loop, off: float) -> list[int]:
    """The points of a polygon that is nowhere farther than ``off`` from the loop."""
    first = int(((loop - loop.mean(0)) ** 2).sum(1).argmax())
    second = int(((loop - loop[first]) ** 2).sum(1).argmax())
    halves = between(loop, first, second), between(loop, second, first)
    kept = [first, second]
    for start, half in zip((first, second), halves, strict=True):
        kept += [(start + k) % len(loop) for k in needed(half, off)]
    return sorted(set(kept))


def needed(run: Loop, off: float) -> list[int]:
    """The inner points of a run that a polygon needs to be nowhere farther than ``off`` from it
    (Douglas and Peucker 1973)."""
    _, kept = igl.ramer_douglas_peucker(run, off)
    return np.asarray(kept)[1:-1].tolist()


def through(a: Point, b: Point) -> Line:
    """The line from one point to another."""
    return Line(a, (b - a) / max(np.hypot(*(b - a)), 1e-12))


def between(loop: Loop, a: int, b: int) -> Loop:
    """From its point a on to its point b."""
    return np.concatenate([loop[a:], loop[: b + 1]]) if b <= a else loop[a : b + 1]


def chords(corners: Loop) -> Bool[np.ndarray, " _"]:
    """The sides of a polygon that are chords of an arc: they turn into both neighbours, which are
    about as long, by about as little."""
    way = np.roll(corners, -1, 0) - corners
    length, angle = np.hypot(*way.T), np.arctan2(way[:, 1], way[:, 0])
    turn = (angle - np.roll(angle, 1) + np.pi) % (2 * np.pi) - np.pi  # before each
    after = np.roll(turn, -1)
    slight = (turn * after > 0) & (np.maximum(np.abs(turn), np.abs(after)) < ARC)
    return slight & (length < UNEVEN * np.minimum(np.roll(length, 1), np.roll(length, -1)))


def line_of(side: Loop, error: float) -> Line | None:
    """The line that a side is; None where it is too short, or bends."""
    whole = through(side[0], side[-1])
    along = (side - whole.place) @ whole.way
    length = along[-1]
    # Its ends are rounded into the corners.
    cut = min(RIM / 2, length / 4)
    inner = side[(along > cut) & (along < length - cut)]
    if length < LINE * error or len(inner) < FEWEST:
        return None
    middle = inner.mean(0)
    way = np.linalg.svd(inner - middle, full_matrices=False)[2][0]
    one = Line(middle, way * np.sign(way @ whole.way))
    rise = np.polyfit((inner - middle) @ one.way, one.off(inner), 2)[0]
    if np.degrees(np.arctan(abs(2 * rise * length))) > BEND_DEG:
        return None
    axis = int(np.abs(way).argmax())
    if abs(way[axis]) > ALONG_AXIS:
        one = Line(middle, np.sign(one.way[axis]) * np.eye(2)[axis])
    return one


def joined(lines: list[Line | None], sides: list[Loop], error: float) -> list[Line | None]:
    """Neighbours that are one line are so."""
    made = list(lines)
    for k in range(len(made)):
        one, other = made[k - 1], made[k]
        if one is None or other is None or cross(one.way, other.way) ** 2 > CORNER**2:
            continue
        both = np.concatenate([sides[k - 1], sides[k]])
        whole = line_of(both, error)
        if whole is not None and np.abs(whole.off(both)).max() < 2 * CORNERED * error:
            made[k - 1] = made[k] = whole
    return made


def met(loop: Loop, curve: Loop, spots: list[int], lines: list[Line | None]) -> Loop:
    """Lines, corners where two meet, and the curve in between.

    Args:
        curve: the loop without its noise.
        spots: the points from which each of ``lines`` goes on to the next.
    """
    straight = [k for k, line in enumerate(lines) if line is not None]
    if not straight:
        return curve[corners_of(curve, CURVE)]
    made = []
    for k, following in zip(straight, straight[1:] + straight[:1], strict=True):
        one, other = lines[k], lines[following]
        assert one is not None and other is not None  # they are straight
        end, start = spots[(k + 1) % len(spots)], spots[following]
        if one is other and end == start:
            continue
        gap = end != start or len(straight) == 1
        rounded = between(loop, end, start) if gap else loop[[end]]
        corner = one.meets(other)
        short = np.hypot(*np.diff(rounded, axis=0).T).sum() < RIM
        if corner is not None and short and np.hypot(*(rounded - corner).T).min() < JUMP:
            made.append(corner)
            continue
        if (
            gap
            and one.way @ other.way < -ALONG_AXIS
            and _is_end(rounded, abs(one.off(other.place)))
        ):
            tip = rounded[(rounded @ one.way).argmax()]
            made += [one.onto(tip), other.onto(tip)]
            continue
        made.append(one.onto(loop[end]))
        if gap:
            bend = between(curve, end, start)
            made += list(bend[needed(bend, CURVE)])
        made.append(other.onto(loop[start]))
    return np.array(made) if len(made) > 2 else loop


def _is_end(run: Loop, width: float) -> bool:
    """Whether a run between two sides is a board's end, which is flat: so narrow that it comes out
    round."""
    length = np.hypot(*np.diff(run, axis=0).T).sum()
    return bool(width < BOARD and length < 2 * width + RIM)


def level(loops: Sequence[Loop], error: float) -> None:
    """Move lines along x or y that are nearly one line into one, in all loops."""
    for axis in (0, 1):
        lines = []
        for loop in loops:
            way = np.roll(loop, -1, 0) - loop
            along = (np.abs(way[:, axis]) < 1e-9) & (np.abs(way[:, 1 - axis]) > LINE * error)
            lines += [(loop[k, axis], abs(way[k, 1 - axis]), loop, k) for k in along.nonzero()[0]]
        lines.sort(key=lambda line: line[0])
        while lines:
            same = [line for line in lines if line[0] - lines[0][0] < ONE * error]
            lines = lines[len(same) :]
            place = np.average([x[0] for x in same], weights=[x[1] for x in same])
            for _, _, loop, k in same:
                loop[[k, (k + 1) % len(loop)], axis] = place
