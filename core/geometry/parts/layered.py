"""Solids of flat outlines, one upon another along an axis: an arch, a saw, a shelf with its back.

The sections through a layer agree, each with errors of its own: their mean has less. Where
one layer ends and the next begins is found by dynamic programming, as for a signal that is constant
in components (Jackson et al. 2005, "An algorithm for optimal partitioning of data on an interval").
"""

import itertools
from collections.abc import Callable, Iterator

import numpy as np
from jaxtyping import Float
from scipy import ndimage
from scipy.spatial.transform import Rotation

from core.geometry.faces import areas_and_normals
from core.geometry.lattice import FAR, Lattice
from core.geometry.parts.components import Component
from core.geometry.parts.outline import even, level, outline
from core.geometry.parts.primitives import Layer, Points, Primitive, along_axes, packed, unrolled

MOST = 4  # layers
DEAR = 0.12  # of the nodes near the surface: what a layer more has to explain
BLURRED = 4  # nodes that a layer is high, from which its first and last do not count
DRIFT = 0.7  # cells: what its outline moves by more is no layer
FINER = 2  # times, an outline's lattice than the component's
FACING = 0.9  # cosine between a step and the axis
ACROSS = 0.99  # cosine between an end and the axis
NEAR = 1.5  # errors between where a step may be and where its faces are


def layered(component: Component, frame: Float[np.ndarray, "3 3"]) -> Primitive | None:
    """The component's layers along a frame's last axis; None where it has none, or more than
    ``MOST``."""
    found = layers_of(component.lattice.along(frame), component, lambda verts: verts @ frame)
    turn = Rotation.from_matrix(frame).as_rotvec()
    return Primitive("layers", np.zeros(3), turn, packed(found)) if found else None


def wall(component: Component) -> Primitive | None:
    """The outline that a component is around the vertical line through its middle, all through its
    thickness: a crown's; None where it is none, as where that line is not empty."""
    center = component.middle.double().numpy() * (1, 1, 0)
    radius = float(np.hypot(*(component.verts.double().numpy() - center)[:, :2].T).mean())
    flat = component.lattice.around(center, radius)
    if (flat.values[:, :, :2] < 0).any():
        return None
    found = layers_of(flat, component, lambda verts: unrolled(verts - center, radius))
    lengths = np.append(radius, packed(found))
    return Primitive("wall", center, np.zeros(3), lengths) if len(found) == 1 else None


def layers_of(
    lattice: Lattice, component: Component, placed: Callable[[Points], Points]
) -> list[Layer]:
    """Those along the lattice's last axis; none where what is there is not of layers.

    ``placed``: the component's vertices where the lattice has them.
    """
    found = list(even_layers(lattice, component, placed))
    whole = [layer for layer in found if layer is not None]
    if len(whole) < len(found) or len(found) > MOST:
        return []
    level([loop for *_, loops in whole for loop in loops], component.error)
    return whole


def even_layers(
    lattice: Lattice, component: Component, placed: Callable[[Points], Points]
) -> Iterator[Layer | None]:
    """Each segment along the lattice's last axis as a layer; None where it is none."""
    sections = np.clip(np.moveaxis(lattice.values, 2, 0) / lattice.cell, -FAR, FAR)
    starts = segments(sections.clip(-1, 1))
    verts, faces = placed(component.verts.double().numpy()), component.faces.numpy()
    area, normal = areas_and_normals(verts, faces)
    steps = np.stack([verts[faces][..., 2].mean(1), area * (np.abs(normal[:, 2]) > FACING)])
    ends = [
        step_at(lattice.low[2] + (k - 0.5) * lattice.cell, *steps, NEAR * component.error)
        for k in starts
    ]
    for (first, last), (low, high) in zip(
        itertools.pairwise(starts), itertools.pairwise(ends), strict=True
    ):
        blurred = int(last - first >= BLURRED)
        inner = sections[first + blurred : last - blurred]
        mean = inner.mean(0)
        if mean.min() >= 0 or high <= low:
            continue
        if drift(inner) > DRIFT:
            yield None
            continue
        finer = ndimage.zoom(mean, FINER) * lattice.cell
        step = lattice.cell * (len(mean) - 1) / (len(finer) - 1)
        loops = outline(even(finer, component.error), lattice.low[:2], step, component.error)
        if loops:
            yield low, high, loops


def ends_fraction(layers: Primitive) -> float:
    """The fraction of the layers' surface across their axis, or axes."""
    verts, faces = layers.mesh(np.inf)
    area, normal = areas_and_normals(verts.double().numpy() @ layers.frame, faces.numpy())
    frames = [np.eye(3)]
    if layers.form == "crossed":
        frames = [frame for frame, _ in along_axes(layers.lengths)]
    across = np.abs(np.stack([normal @ frame[:, 2] for frame in frames])).max(0)
    return float(area[across > ACROSS].sum() / area.sum())


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
