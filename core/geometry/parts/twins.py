"""Pieces that are each other's mirror image: what one is made, the other is too.

Nearly everything that people make has two sides that are alike, and the eye sees at once where
they are not: of a dresser's drawers those on the left were boards and those on the right a roll.
"""

from collections.abc import Sequence
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.pieces import Distances, Mesh, Piece, points_of

BOX = 1.5  # cells
OFF = 0.3  # errors: how far one's mirrored points are from the other's surface, in the mean


class Twin(NamedTuple):
    """Whose mirror image a piece is, and across which of x = 0 and y = 0."""

    of: int
    axis: int


def twins(distances: Distances, pieces: Sequence[Piece]) -> dict[int, Twin]:
    """Of each piece that mirrors an earlier one, which."""
    found: dict[int, Twin] = {}
    boxes = [torch.stack([piece.verts.amin(0), piece.verts.amax(0)]) for piece in pieces]
    for later, piece in enumerate(pieces):
        for earlier in range(later):
            one = pieces[earlier]
            if earlier in found or one.place.part != piece.place.part:
                continue
            axis = _axis(boxes[earlier], boxes[later], BOX * max(one.cell, piece.cell))
            if axis is not None and _lies(distances, one, axis):
                found[later] = Twin(earlier, axis)
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


def _lies(distances: Distances, piece: Piece, axis: int) -> bool:
    """Whether the part's surface is also where the piece's mirrored points are."""
    points = torch.from_numpy(points_of(piece)).float()
    off = distances(across(points, axis))[:, piece.place.part].abs()
    return float(off.mean()) < OFF * piece.error


def across(points: Float[Tensor, "n 3"], axis: int) -> Float[Tensor, "n 3"]:
    """The points' mirror images."""
    sides = points.new_ones(3)
    sides[axis] = -1
    return points * sides


def mirrored_mesh(mesh: Mesh, axis: int) -> Mesh:
    """The mesh's mirror image, its faces still looking outwards."""
    verts, faces = mesh
    return across(verts, axis), faces.flip(1)
