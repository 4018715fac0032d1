"""Balls swept along a smooth curve: an arm, a tail, a horn, a handle, a rope.

The curve goes through stops, each the middle and the radius of a ball (a centripetal Catmull-Rom
spline: Yuksel, Schaefer and Keyser 2011, "Parameterization and applications of Catmull-Rom
curves"); what lies between two samples of it is the hull of their balls.
"""

import numpy as np
from jaxtyping import Float, Int
from scipy.interpolate import CubicHermiteSpline

Stops = Float[np.ndarray, "_ 4"]  # of each its place and its radius, training units
STEPS = 6  # samples from one stop to the next
LEAST = 1e-9


def samples(stops: Stops, steps: int = STEPS) -> Stops:
    """Balls along the curve, the stops among them."""
    if len(stops) < 3:
        return stops
    way = np.linalg.norm(np.diff(stops[:, :3], axis=0), axis=1).clip(LEAST) ** 0.5
    knots = np.concatenate([[0.0], way.cumsum()])
    slopes = np.diff(stops, axis=0) / np.diff(knots)[:, None]
    before, after = np.diff(knots)[:-1, None], np.diff(knots)[1:, None]
    inner = (slopes[:-1] * after + slopes[1:] * before) / (before + after)
    # Natural ends bend as much as the neighbours do.
    tangents = np.concatenate([[2 * slopes[0] - inner[0]], inner, [2 * slopes[-1] - inner[-1]]])
    at = np.interp(np.arange(steps * (len(stops) - 1) + 1) / steps, np.arange(len(stops)), knots)
    balls = CubicHermiteSpline(knots, stops, tangents)(at)
    # A radius goes evenly from one stop to the next: a spline's could become less than none.
    balls[:, 3] = np.interp(at, knots, stops[:, 3])
    return balls


def distance(p: Float[np.ndarray, "n 3"], balls: Stops) -> Float[np.ndarray, " n"]:
    """Signed, from the hulls of each two balls that follow one another; inside, from the nearest
    hull's surface. After Quilez's round cone."""
    start, end = balls[:-1, :3], balls[1:, :3]
    first, last = balls[:-1, 3], balls[1:, 3]
    along = end - start
    length = np.linalg.norm(along, axis=1).clip(LEAST)
    sine = ((first - last) / length).clip(-0.999, 0.999)
    cosine = np.sqrt(1 - sine * sine)
    off = p[:, None] - start
    up = (off * along).sum(2) / length
    across = np.sqrt(((off * off).sum(2) - up * up).clip(min=0))
    place = up * cosine - across * sine
    side = across * cosine + up * sine - first
    ends = np.hypot(across, up) - first, np.hypot(across, up - length) - last
    found = np.where(place < 0, ends[0], np.where(place > length * cosine, ends[1], side))
    return found.min(1)


def bends(balls: Stops) -> Float[np.ndarray, " k"]:
    """At each inner sample the radius there over that of the curve: from 1 on it folds."""
    way = np.diff(balls[:, :3], axis=0)
    length = np.linalg.norm(way, axis=1).clip(LEAST)
    unit = way / length[:, None]
    turn = np.linalg.norm(np.diff(unit, axis=0), axis=1)
    return turn / ((length[1:] + length[:-1]) / 2) * balls[1:-1, 3]


def tube(balls: Stops, segments: int) -> tuple[Float[np.ndarray, "v 3"], Int[np.ndarray, "f 3"]]:
    """The closed surface: circles where each ball touches the hulls, half balls at the ends."""
    caps = segments // 4
    places, radii = balls[:, :3], balls[:, 3]
    way = np.gradient(places, axis=0)
    length = np.linalg.norm(way, axis=1).clip(LEAST)
    ahead = way / length[:, None]
    sine = (-np.gradient(radii) / length).clip(-0.99, 0.99)  # towards the thinner end
    # Of each circle, from pole to pole, its ball and the angle towards where the curve goes.
    rows = [(0, angle) for angle in _angles(-np.pi / 2, np.arcsin(sine[0]), caps)]
    rows += [(k, np.arcsin(sine[k])) for k in range(len(balls))]
    rows += [(-1, angle) for angle in _angles(np.pi / 2, np.arcsin(sine[-1]), caps)[::-1]]
    index, angle = np.array([k % len(balls) for k, _ in rows]), np.array([a for _, a in rows])
    aside = _carried(ahead)
    around = 2 * np.pi * np.arange(segments) / segments
    circle = np.cos(around)[:, None] * aside[index][:, None]
    circle = circle + np.sin(around)[:, None] * np.cross(ahead, aside)[index][:, None]
    out = np.cos(angle)[:, None, None] * circle + (np.sin(angle)[:, None] * ahead[index])[:, None]
    verts = places[index][:, None] + radii[index][:, None, None] * out
    poles = places[[0, -1]] + np.array([[-1], [1]]) * radii[[0, -1], None] * ahead[[0, -1]]
    return np.concatenate([verts.reshape(-1, 3), poles]), _faces(len(rows), segments)


def _angles(pole: float, end: float, count: int) -> Float[np.ndarray, " c"]:
    """Between the pole and where the side begins, both left out."""
    return pole + (end - pole) * np.arange(1, count) / count


def _carried(ahead: Float[np.ndarray, "k 3"]) -> Float[np.ndarray, "k 3"]:
    """A direction across the curve at each sample, that turns no more than the curve does."""
    found = [np.cross(ahead[0], np.eye(3)[np.abs(ahead[0]).argmin()])]
    for way in ahead[1:]:
        found.append(found[-1] - way * (found[-1] @ way))
    return np.array([one / np.linalg.norm(one) for one in found])


def _faces(rows: int, segments: int) -> Int[np.ndarray, "f 3"]:
    """Of circles one after another, and a pole at each end."""
    here = np.arange(segments)
    there = (here + 1) % segments
    step = segments * np.arange(rows - 1)[:, None]
    a, b = here + step, there + step
    c, d = a + segments, b + segments
    sides = np.concatenate([np.stack([a, b, d], -1), np.stack([a, d, c], -1)]).reshape(-1, 3)
    low, high = rows * segments, rows * segments + 1
    last = (rows - 1) * segments
    ends = [np.stack([np.full(segments, low), there, here], 1)]
    ends.append(np.stack([np.full(segments, high), here + last, there + last], 1))
    return np.concatenate([sides, *ends])
