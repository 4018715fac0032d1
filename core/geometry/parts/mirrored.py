"""Mirrored pairs of components: both get the same surface.

Nearly everything that people make has two equal sides, and the eye sees at once where they
differ: a dresser's drawers on the left were boards and those on the right a roll.
"""

from collections.abc import Sequence
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.components import Component, Distances, Mesh, points_of

BOX = 1.5  # cells
OFF = 0.3  # errors: how far one's mirrored points are from the other's surface, in the mean


class Mirror(NamedTuple):
    """The component that another mirrors, and the axis (0: across x = 0, 1: across y = 0)."""

    of: int
    axis: int


def mirrored_pairs(distances: Distances, components: Sequence[Component]) -> dict[int, Mirror]:
    """For each component that mirrors an earlier one: that one, and the axis."""
    found: dict[int, Mirror] = {}
    boxes = [
        torch.stack([component.verts.amin(0), component.verts.amax(0)]) for component in components
    ]
    for later, component in enumerate(components):
        for earlier in range(later):
            one = components[earlier]
            if earlier in found or one.place.part != component.place.part:
                continue
            axis = _axis(boxes[earlier], boxes[later], BOX * max(one.cell, component.cell))
            if axis is not None and _lies(distances, one, axis):
                found[later] = Mirror(earlier, axis)
                break
    return found


def _axis(one: Float[Tensor, "2 3"], other: Float[Tensor, "2 3"], close: float) -> int | None:
    """The axis along which two boxes are on opposite sides and as large."""
    for axis in (0, 1):
        there = one.clone()
        there[:, axis] = -one[:, axis].flip(0)
        apart = float(one[0, axis]) > -close or float(one[1, axis]) < close
        if apart and float((there - other).abs().max()) < close:
            return axis
    return None


def _lies(distances: Distances, component: Component, axis: int) -> bool:
    """Whether the part's surface is also where the component's mirrored points are."""
    points = torch.from_numpy(points_of(component)).float()
    off = distances(across(points, axis))[:, component.place.part].abs()
    return float(off.mean()) < OFF * component.error


def across(points: Float[Tensor, "n 3"], axis: int) -> Float[Tensor, "n 3"]:
    """The points' mirror images."""
    sides = points.new_ones(3)
    sides[axis] = -1
    return points * sides


def mirrored_mesh(mesh: Mesh, axis: int) -> Mesh:
    """The mesh's mirror image, its faces still looking outwards."""
    verts, faces = mesh
    return across(verts, axis), faces.flip(1)
