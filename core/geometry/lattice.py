"""Signed distances of one component on a lattice, along any axes."""

from typing import NamedTuple

import numpy as np
from jaxtyping import Float
from scipy import ndimage

FAR = 3.0  # cells: farther from the surface all is the same
TURN = 1.25  # times around


class Lattice(NamedTuple):
    """A component's signed distances."""

    values: Float[np.ndarray, "a b c"]  # training units
    low: Float[np.ndarray, " 3"]  # the first node
    cell: float  # training units

    def along(self, frame: Float[np.ndarray, "3 3"]) -> "Lattice":
        """The same along other axes, the frame's columns; its places are in the frame."""
        axes = np.abs(frame).argmax(0)
        if np.allclose(frame, np.eye(3)[:, axes]):
            return Lattice(self.values.transpose(axes), self.low[axes], self.cell)
        half = (len(self.values) - 1) / 2
        node = np.stack(np.meshgrid(*[np.arange(len(self.values)) - half] * 3, indexing="ij"), -1)
        low = (self.low + half * self.cell) @ frame - half * self.cell
        return Lattice(self._at(node @ frame.T + half), low, self.cell)

    def around(self, center: Float[np.ndarray, " 3"], radius: float) -> "Lattice":
        """The same unrolled from a vertical line, a little more than once around: its places are
        those of ``unrolled``."""
        half = int(np.ceil(TURN * np.pi * radius / self.cell))
        around = np.linspace(-TURN * np.pi, TURN * np.pi, 2 * half + 1)
        scale = TURN * np.pi * radius / half / self.cell  # a little finer
        up = np.arange(self.values.shape[2] / scale)
        out = np.arange(len(self.values) / 2 / scale)
        angle, height, far = np.meshgrid(around, up * scale, out * scale, indexing="ij")
        middle = (center - self.low) / self.cell
        node = np.stack(
            [middle[0] + far * np.sin(angle), middle[1] - far * np.cos(angle), height], -1
        )
        low = np.array([-TURN * np.pi * radius, self.low[2], 0.0])
        return Lattice(self._at(node), low, TURN * np.pi * radius / half)

    def near(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, " n"]:
        """The distances at points."""
        return self._at(((points - self.low) / self.cell)[:, None, None])[:, 0, 0]

    def _at(self, node: Float[np.ndarray, "a b c 3"]) -> Float[np.ndarray, "a b c"]:
        places = np.moveaxis(node, -1, 0)
        return ndimage.map_coordinates(self.values, places, order=1, cval=FAR * self.cell)
