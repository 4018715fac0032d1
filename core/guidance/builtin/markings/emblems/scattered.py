"""Small copies of a shape all over a thing: "a mug with hearts"."""

import math
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.guidance.builtin.markings.emblems.windows import surface_places
from core.guidance.builtin.markings.margins import all_of
from core.guidance.builtin.markings.shapes import shape_margin

HALF = 0.1  # of a shape, times the thing's longest side
ABOVE, BELOW = 0.01, 0.6  # training units; the cosine between a normal and the way down
A_MAIN_PART = 0.2  # of all places, at least
FEWEST = 8  # shapes, or they are smaller
SIZES, SMALLER = 5, 0.75  # sizes to try, each this fraction of the one before
APART = 2.9  # halves, from one middle to the next
DEEP = 0.4  # halves: depth, so that none is on the other side of a mug's wall
EVEN = 0.85  # the mean normal's length around a middle, at least
OPPOSITE = -0.3  # cosine between the normals of both sides of a wall
TRIED = 6000  # places
TILT = math.radians(18)  # at most
UPRIGHT = 0.9  # of a normal's z: above it "up" is to the back


class Scattered(NamedTuple):
    """The shapes' places on a thing, each in a plane of its own."""

    middles: Float[Tensor, "k 3"]
    right: Float[Tensor, "k 3"]
    up: Float[Tensor, "k 3"]
    outward: Float[Tensor, "k 3"]
    half: float  # training units

    def margin(self, points: Float[Tensor, "n 3"], shape: str) -> Float[Tensor, " n"]:
        """How far inside the nearest shape."""
        nearest = torch.cdist(points, self.middles.to(points)).argmin(1)
        away = points - self.middles.to(points)[nearest]
        right, up, outward = (
            (away * axis.to(points)[nearest]).sum(1) for axis in (self.right, self.up, self.outward)
        )
        inside = shape_margin(torch.stack([right, up], 1) / self.half, shape) * self.half
        return all_of(inside, DEEP * self.half - outward.abs())


def scattered_on(parts: KnownParts, on: list[int]) -> Scattered | None:
    """Evenly placed shapes on these parts; None without room."""
    places, normals, of = surface_places(parts)
    here = np.isin(of, on)
    here[here] = _bare(parts, places[here], normals[here], of[here])
    places, normals = places[here], normals[here]
    if not len(places):
        return None
    longest = _longest(places, of[here])
    tree = KDTree(places)
    half, found = HALF * longest, []
    for k in range(SIZES):
        half = HALF * longest * SMALLER**k
        found = _apart(places, normals, tree, half)
        if len(found) >= FEWEST:
            break
    if not found:
        return None
    outward = normals[found]
    above = np.where(np.abs(outward[:, 2:]) > UPRIGHT, [[0.0, 1.0, 0.0]], [[0.0, 0.0, 1.0]])
    up = above - (above * outward).sum(1, keepdims=True) * outward
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    right = np.cross(up, outward)
    tilt = np.random.default_rng(0).uniform(-TILT, TILT, (len(found), 1))
    up, right = (np.cos(tilt) * up + np.sin(tilt) * right, np.cos(tilt) * right - np.sin(tilt) * up)
    axes = (torch.from_numpy(of).float() for of in (places[found], right, up, outward))
    return Scattered(*axes, half)


def _bare(
    parts: KnownParts,
    places: Float[np.ndarray, "n 3"],
    normals: Float[np.ndarray, "n 3"],
    of: Int[np.ndarray, " n"],
) -> Bool[np.ndarray, " n"]:
    """Which places are not under another part, as a cup's bottom is under its tea; all, if there
    are no such places."""
    above = torch.from_numpy(places + ABOVE * normals).float()
    away = parts.near(above).numpy().copy()
    away[np.arange(len(of)), of] = np.inf
    bare = away.min(1) > 0
    return bare if bare.any() else ~bare


def _longest(places: Float[np.ndarray, "n 3"], of: Int[np.ndarray, " n"]) -> float:
    """The longest side of the smallest of the main parts: a flower on a saucer is no larger than
    one on its cup."""
    parts, counts = np.unique(of, return_counts=True)
    main = parts[counts >= A_MAIN_PART * len(places)]
    return min(float(np.ptp(places[of == part], axis=0).max()) for part in main)


def _apart(
    places: Float[np.ndarray, "n 3"], normals: Float[np.ndarray, "n 3"], tree: KDTree, half: float
) -> list[int]:
    """Places far enough from one another, where the surface is even."""
    tried = np.random.default_rng(0).permutation(len(places))[:TRIED]
    inward = ((places - places.mean(0)) * normals).sum(1)[tried] < 0
    order = inward + 2 * (normals[tried, 2] < -BELOW)
    found: list[int] = []
    for index in tried[np.argsort(order, kind="stable")]:  # outer surfaces first, undersides last
        place = places[index]
        if found and np.linalg.norm(places[found] - place, axis=1).min() < APART * half:
            continue
        around = normals[tree.query_ball_point(place, half)]
        around = around[around @ normals[index] > OPPOSITE].mean(0)
        if np.linalg.norm(around) > EVEN and around @ normals[index] > EVEN:
            found.append(int(index))
    return found
