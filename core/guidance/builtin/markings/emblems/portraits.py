"""Portraits: flat pictures of a drawn thing, as they are printed on another one.

A thing is seen from its front and a little from its right and from above; each of its areas has one
colour, and lines are around it and where one part is before another.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy import ndimage
from torch import Tensor

from core.geometry.init_shape import sample_surface
from core.guidance.builtin.markings.margins import Margin
from core.guidance.builtin.markings.stencils import margins_of, read
from core.guidance.builtin.words.tables.colors import Color

AZIMUTH, ELEVATION = math.radians(28), math.radians(10)
SIDE, FINER = 128, 3  # pixels, and by how much the margins' pictures are finer
SAMPLES = 500_000  # places of the surface
LINE = 0.045  # of half the picture: the width of the line around the thing
STEP = 0.07  # of half the picture: a larger step in depth is drawn
LEAST = 12  # pixels of an area
SOFT = 0.8  # pixels: the blur that makes borders smooth
ROOM = 1.06  # half the picture, of half the thing's longest side


class Layer(NamedTuple):
    """An area of a picture."""

    field: Float[Tensor, "t t"]  # margins of the pixels, in halves of the picture's side
    color: Color

    def margin(self, at: Float[Tensor, "p 2"]) -> Margin:
        """Positive inside; places to the right of the middle and above it, from -1 to 1."""
        return _margin(self.field, at)


class Portrait(NamedTuple):
    """A picture: the silhouette with the line around it, and the areas on it."""

    silhouette: Float[Tensor, "t t"]
    layers: tuple[Layer, ...]

    def margin(self, at: Float[Tensor, "p 2"]) -> Margin:
        """That of the silhouette, as a layer's."""
        return _margin(self.silhouette, at)


def _margin(field: Float[Tensor, "t t"], at: Float[Tensor, "p 2"]) -> Margin:
    found = read(field, at * at.new_tensor([1.0, -1.0]))
    return found - (at.abs() - 1).clamp_min(0).amax(1)


def portrait_of(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    area_of: Callable[[Float[Tensor, "n 3"]], Int[Tensor, " n"]],
    colors: Sequence[Color],
) -> Portrait:
    """The portrait of a thing.

    Args:
        area_of: the area of each point of the surface.
        colors: of the areas.
    """
    points = sample_surface(verts, faces, SAMPLES, torch.Generator().manual_seed(0))
    at, depth = _seen(points)
    nearest = _nearest(at, depth)
    shown = nearest >= 0
    area = np.full((SIDE, SIDE), -1)
    area[shown] = area_of(points[torch.from_numpy(nearest[shown])]).numpy()
    away = np.full((SIDE, SIDE), np.inf)
    away[shown] = depth.numpy()[nearest[shown]]
    inside = ndimage.binary_closing(shown, iterations=2)
    area, away = _filled(area, shown, inside), _filled(away, shown, inside)
    masks = {color: np.zeros((SIDE, SIDE), bool) for color in colors}
    for index, color in enumerate(colors):  # areas of one colour are one
        masks[color] |= area == index
    found = [color for color, mask in masks.items() if mask.sum() >= LEAST]
    fine = [_smooth(masks[color] & inside) for color in found]
    silhouette = _smooth(inside)
    best = np.argmax(fine, 0)
    lines = _lines(away, inside)
    layers = [
        Layer(_margins((best == k) & (silhouette > 0.5) & ~lines), color)
        for k, color in enumerate(found)
    ]
    return Portrait(_margins(silhouette > 0.5) + LINE, tuple(layers))


def _seen(
    points: Float[Tensor, "n 3"],
) -> tuple[Float[Tensor, "n 2"], Float[Tensor, " n"]]:
    """Places to the right and up, the longest half being 1, and distances from the eye."""
    c, s = math.cos(AZIMUTH), math.sin(AZIMUTH)
    x, y, z = points.unbind(1)
    right, behind = c * x + s * y, c * y - s * x
    c, s = math.cos(ELEVATION), math.sin(ELEVATION)
    up, behind = c * z + s * behind, c * behind - s * z
    at = torch.stack([right, up], 1)
    low, high = at.amin(0), at.amax(0)
    half = float((high - low).max()) / 2
    return (at - (low + high) / 2) / half, behind / half


def _nearest(at: Float[Tensor, "n 2"], depth: Float[Tensor, " n"]) -> Int[np.ndarray, "s s"]:
    """The place that is seen in each pixel; -1 without one."""
    column, row = ((at.numpy() * [1, -1] / ROOM + 1) * SIDE / 2).astype(int).clip(0, SIDE - 1).T
    index = row * SIDE + column
    order = np.lexsort((-depth.numpy(), index))  # the nearest last
    last = order[np.append(np.diff(index[order]) > 0, True)]
    found = np.full(SIDE * SIDE, -1)
    found[index[last]] = last
    return found.reshape(SIDE, SIDE)


def _filled(
    picture: np.ndarray, shown: Bool[np.ndarray, "s s"], inside: Bool[np.ndarray, "s s"]
) -> np.ndarray:
    """The picture with the nearest pixel's value where a place is inside and none was seen."""
    nearest = ndimage.distance_transform_edt(~shown, return_distances=False, return_indices=True)
    return np.where(inside, picture[tuple(nearest)], picture)


def _smooth(mask: Bool[np.ndarray, "s s"]) -> Float[np.ndarray, "t t"]:
    """How much of each finer pixel's neighbourhood is inside."""
    return ndimage.zoom(ndimage.gaussian_filter(mask.astype(float), SOFT), FINER, order=1)


def _lines(
    away: Float[np.ndarray, "s s"], inside: Bool[np.ndarray, "s s"]
) -> Bool[np.ndarray, "t t"]:
    """The borders of parts that are before others."""
    away = ndimage.median_filter(np.where(inside, away, away[inside].max()), 3)
    step = away - ndimage.minimum_filter(away, 3)  # on the side of what is behind
    core = ndimage.binary_erosion(inside, iterations=2)
    drawn = ndimage.zoom(((step > STEP) & core).astype(float), FINER, order=1)
    return ndimage.gaussian_filter(drawn, FINER / 2) > 0.4


def _margins(inside: Bool[np.ndarray, "t t"]) -> Float[Tensor, "t t"]:
    """Margins, in halves of the picture's side."""
    return torch.from_numpy(margins_of(inside) * (2 / len(inside))).float()
