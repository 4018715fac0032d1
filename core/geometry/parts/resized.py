"""Components that a prompt wants longer, larger or smaller: from where they are attached."""

from collections.abc import Iterator
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float
from torch import Tensor

LONG = 1.3  # times as long as wide, at least, is what has a length of its own
JOINS = 0.6  # of its length: what is attached along more of it holds two things together
TOUCHING = 0.05  # of the surface: what is attached where nothing of it is within another part
AWAY = 0.3  # of its spread, at least, from where it is attached to its middle
UPRIGHT = 0.98  # cosine between its length and an axis, of what is along the axis


class Resized(NamedTuple):
    """A change of size about a point that stays."""

    stays: Float[Tensor, " 3"]
    matrix: Float[Tensor, "3 3"]

    def moved(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Where points come to be."""
        return (points - self.stays.to(points)) @ self.matrix.to(points).T + self.stays.to(points)

    def before(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Where points were."""
        back = torch.linalg.inv(self.matrix).to(points)
        return (points - self.stays.to(points)) @ back.T + self.stays.to(points)

    @property
    def least(self) -> float:
        """The least factor of a distance."""
        return float(torch.linalg.svdvals(self.matrix).min())


def resized(
    verts: Float[Tensor, "v 3"], others: Float[Tensor, " v"], scale: float, length: float
) -> Resized:
    """The change of a component.

    Args:
        verts: of its surface.
        others: their distance from all other parts; it is attached where they are within one.
        scale: its new size, by the old one.
        length: of what is so scaled, the new length; of what has none, away from the others.
    """
    attached = _attached(others)
    stays, middle = verts[attached].mean(0), verts.mean(0)
    matrix = torch.eye(3).to(verts)
    for axis in _axes(verts, middle - stays):
        along = verts @ axis
        span = along[attached].max() - along[attached].min()
        if span <= JOINS * (along.max() - along.min()):
            matrix = matrix + (length - 1) * axis[:, None] * axis
            break
    return Resized(stays, scale * matrix)


def _axes(verts: Float[Tensor, "v 3"], away: Float[Tensor, " 3"]) -> Iterator[Float[Tensor, " 3"]]:
    """That of the component's length, if it has one; and away from where it is attached."""
    sizes, axes = torch.linalg.svd(verts - verts.mean(0), full_matrices=False)[1:]
    if sizes[0] > LONG * sizes[1]:
        yield _upright(axes[0])
    if away.norm() > AWAY * sizes[0] / len(verts) ** 0.5:
        yield _upright(away / away.norm())


def _upright(axis: Float[Tensor, " 3"]) -> Float[Tensor, " 3"]:
    """The axis, or the coordinate axis that it is nearly along."""
    nearest = int(axis.abs().argmax())
    return torch.eye(3).to(axis)[nearest] if axis[nearest].abs() > UPRIGHT else axis


def _attached(others: Float[Tensor, " v"]) -> Bool[Tensor, " v"]:
    """Which of the vertices are within another part, or at least next to one."""
    within = others < 0
    return within if within.any() else others <= others.quantile(TOUCHING)
