"""A circle swept along a curve: the closed surface of a bent pipe."""

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

Curve = Float[np.ndarray, "k 4"]  # x, y, z, radius


def swept(
    curve: Curve, closed: bool, around: int
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The surface around a curve, with round ends.

    Args:
        closed: whether it goes on from the last point to the first.
        around: corners of a circle.
    """
    rings = curve if closed else with_caps(curve, around)
    side, other = across(rings[:, :3], closed)
    if not closed:
        tips, rings, side, other = rings[[0, -1], :3], rings[1:-1], side[1:-1], other[1:-1]
    turn = np.linspace(0, 2 * np.pi, around, endpoint=False)[:, None, None]
    circles = (np.cos(turn) * side + np.sin(turn) * other) * rings[:, 3:] + rings[:, :3]
    verts = circles.transpose(1, 0, 2).reshape(-1, 3)
    index = np.arange(len(verts)).reshape(-1, around)
    here, ahead = (index, np.roll(index, -1, 0)) if closed else (index[:-1], index[1:])
    a, b, c, d = here, np.roll(here, -1, 1), np.roll(ahead, -1, 1), ahead
    faces = [np.stack(corners, -1).reshape(-1, 3) for corners in ((a, b, c), (a, c, d))]
    if not closed:
        for tip, ring in ((len(verts), index[0, ::-1]), (len(verts) + 1, index[-1])):
            faces.append(np.stack([ring, np.roll(ring, -1), np.full(around, tip)], 1))
        verts = np.concatenate([verts, tips])
    return torch.from_numpy(verts).float(), torch.from_numpy(np.concatenate(faces))


def with_caps(curve: Curve, around: int) -> Float[np.ndarray, "m 4"]:
    """A curve with half a ball at each end, from its pole to its pole."""
    angle = np.linspace(0, np.pi / 2, max(around // 4, 2) + 1)[1:, None]
    caps = []
    for end, inner in ((curve[0], curve[1]), (curve[-1], curve[-2])):
        way = end[:3] - inner[:3]
        way = way / np.linalg.norm(way).clip(1e-9)
        caps.append(np.c_[end[:3] + end[3] * np.sin(angle) * way, end[3] * np.cos(angle)])
    return np.concatenate([caps[0][::-1], curve, caps[1]])


def across(
    places: Float[np.ndarray, "k 3"], closed: bool
) -> tuple[Float[np.ndarray, "k 3"], Float[np.ndarray, "k 3"]]:
    """Two directions across a curve at each of its points, each laid on from the last point's."""
    before, after = (np.roll(places, by, 0) for by in (1, -1))
    if not closed:
        before[0], after[-1] = places[0], places[-1]
    along = _unit(after - before)
    sides = [_unit(np.cross(along[0], np.eye(3)[np.abs(along[0]).argmin()]))]
    for way in along[1:]:
        sides.append(_laid(sides[-1], way))
    side = np.stack(sides)
    other = np.cross(along, side)
    if closed:  # what is missing of a whole turn, a little on each
        back = _laid(side[-1], along[0])
        off = np.arctan2(back @ -other[0], back @ side[0])
        turn = (off * np.arange(len(along)) / len(along))[:, None]
        side = np.cos(turn) * side + np.sin(turn) * other
        other = np.cross(along, side)
    return side, other


def _laid(side: Float[np.ndarray, " 3"], way: Float[np.ndarray, " 3"]) -> Float[np.ndarray, " 3"]:
    """A direction without what of it is along another."""
    return _unit(side - (side @ way) * way)


def _unit(x: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
    return x / np.linalg.norm(x, axis=-1, keepdims=True).clip(1e-9)
