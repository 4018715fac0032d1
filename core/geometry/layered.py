"""What is flat outlines one upon another along an axis: an arch, a saw, a shelf with its back.

The sections through a layer say the same, each with errors of its own: their mean has less. Where
one layer ends and the next begins is told by dynamic programming, as for a signal that is constant
in pieces (Jackson et al. 2005, "An algorithm for optimal partitioning of data on an interval").
"""

import itertools
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int
from scipy import ndimage
from scipy.spatial.transform import Rotation

from core.geometry.faces import areas_and_normals
from core.geometry.outline import even, level, outline
from core.geometry.primitives import Layer, Primitive, packed, unrolled

MOST = 4  # layers
DEAR = 0.12  # of the nodes near the surface: what a layer more has to explain
BLURRED = 4  # nodes that a layer is high, from which its first and last do not count
DRIFT = 0.7  # cells: what its outline moves by more is no layer
FAR = 3.0  # cells: farther from the surface all is the same
TURN = 1.25  # times around
FINER = 2  # times, an outline's lattice than the piece's
FACING = 0.9  # cosine between a step and the axis
NEAR = 1.5  # errors between where a step may be and where its faces are


class Lattice(NamedTuple):
    """A piece's signed distances."""

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

    def _at(self, node: Float[np.ndarray, "a b c 3"]) -> Float[np.ndarray, "a b c"]:
        places = np.moveaxis(node, -1, 0)
        return ndimage.map_coordinates(self.values, places, order=1, cval=FAR * self.cell)


def layered(
    lattice: Lattice,
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    error: float,
    frame: Float[np.ndarray, "3 3"],
) -> Primitive | None:
    """The layers along a frame's last axis that a piece is of; None where it is not of layers, or
    of more than ``MOST``.

    Args:
        verts: of its surface, with ``faces``: where the layers end.
        error: about what the distances may be off.
    """
    found = layers_of(lattice.along(frame), verts @ frame, faces, error)
    turn = Rotation.from_matrix(frame).as_rotvec()
    return Primitive("layers", np.zeros(3), turn, packed(found)) if found else None


def wall(
    lattice: Lattice,
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    error: float,
    center: Float[np.ndarray, " 3"],
) -> Primitive | None:
    """The outline that a piece is around a vertical line, all through its thickness: a crown's;
    None where it is none.

    Args:
        center: on the line, which is empty.
    """
    center = center * (1, 1, 0)
    radius = float(np.hypot(*(verts - center)[:, :2].T).mean())
    flat = lattice.around(center, radius)
    if (flat.values[:, :, :2] < 0).any():
        return None
    found = layers_of(flat, unrolled(verts - center, radius), faces, error)
    lengths = np.append(radius, packed(found))
    return Primitive("wall", center, np.zeros(3), lengths) if len(found) == 1 else None


def layers_of(lattice: Lattice, verts: np.ndarray, faces: np.ndarray, error: float) -> list[Layer]:
    """Those along the last axis; none where what is there is not of layers."""
    sections = np.clip(np.moveaxis(lattice.values, 2, 0) / lattice.cell, -FAR, FAR)
    starts = segments(sections.clip(-1, 1))
    area, normal = areas_and_normals(verts, faces)
    steps = np.stack([verts[faces][..., 2].mean(1), area * (np.abs(normal[:, 2]) > FACING)])
    ends = [
        step_at(lattice.low[2] + (k - 0.5) * lattice.cell, *steps, NEAR * error) for k in starts
    ]
    found = []
    for (first, last), (low, high) in zip(
        itertools.pairwise(starts), itertools.pairwise(ends), strict=True
    ):
        blurred = int(last - first >= BLURRED)
        inner = sections[first + blurred : last - blurred]
        mean = inner.mean(0)
        if mean.min() >= 0 or high <= low:
            continue
        if drift(inner) > DRIFT or len(found) == MOST:
            return []
        finer = ndimage.zoom(mean, FINER) * lattice.cell
        step = lattice.cell * (len(mean) - 1) / (len(finer) - 1)
        loops = outline(even(finer, error), lattice.low[:2], step, error)
        if loops:
            found.append((low, high, loops))
    level([loop for *_, loops in found for loop in loops], error)
    return found


def segments(sections: Float[np.ndarray, "k r c"]) -> list[int]:
    """Where each run of like sections begins, and where the last ends."""
    flat = sections.reshape(len(sections), -1)
    dear = DEAR * (np.abs(flat) < 1).sum()
    total = np.concatenate([np.zeros((1, flat.shape[1])), flat.cumsum(0)])
    square = np.append(0, (flat**2).sum(1).cumsum())
    product = total @ total.T
    norm = np.diag(product)
    best, before = np.zeros(len(square)), np.zeros(len(square), int)
    for end in range(1, len(square)):
        # The squares about the mean of the sections from each start on.
        start = np.arange(end)
        mean = (norm[end] + norm[:end] - 2 * product[:end, end]) / (end - start)
        cost = best[:end] + square[end] - square[:end] - mean + dear
        before[end] = cost.argmin()
        best[end] = cost.min()
    starts = [len(flat)]
    while starts[-1]:
        starts.append(int(before[starts[-1]]))
    return starts[::-1]


def drift(sections: Float[np.ndarray, "k r c"]) -> float:
    """How far the outline moves from the first third of a layer to its last, cells: in the mean
    over the quarter of it that moves most; 0 for one so thin that its ends blur all of it."""
    if len(sections) < BLURRED:
        return 0.0
    third = -(-len(sections) // 3)
    first, last = sections[:third].mean(0), sections[-third:].mean(0)
    edge = (np.abs(first) < 1) | (np.abs(last) < 1)
    moved = np.sort(np.abs(first - last)[edge])
    return float(moved[-(len(moved) // 4) - 1 :].mean())


def step_at(
    about: float,
    heights: Float[np.ndarray, " f"],
    areas: Float[np.ndarray, " f"],
    near: float,
) -> float:
    """The height of the step that is about there: the median of its faces'."""
    there = (np.abs(heights - about) < near) & (areas > 0)
    if not there.any():
        return about
    order = heights[there].argsort()
    weight = areas[there][order].cumsum()
    return float(heights[there][order][np.searchsorted(weight, weight[-1] / 2)])
