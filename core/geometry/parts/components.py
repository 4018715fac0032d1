"""The components of parts: where each is, its surface as it is drawn, and how it repeats itself."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple, cast

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy import ndimage
from torch import Tensor

from core.geometry.init_shape import sample_surface
from core.geometry.lattice import FAR, Lattice
from core.geometry.mesh import compact, component_labels, face_areas, polished
from core.geometry.parts.primitives import Primitive
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, tet_grid

SEARCH = 72  # cubes along an edge of the lattice that finds the components
BOARD = 0.25  # of its cell: a thin board between two nodes is found by what is so near to it
LEAST_NODES = 4  # of a component
# Nodes between which the tetrahedral lattice has an edge.
JOINED = np.zeros((3, 3, 3), bool)
JOINED[:2, :2, :2] = JOINED[1:, 1:, 1:] = True
# Fraction of the largest one's nodes that a component has which only the first lattice joins to it.
ALSO = 0.25
BRIDGE, SHORT = 0.4, 2.0  # errors: a bridge's half thickness at most, its distance to a component
MARGIN = 1.6  # of its cell, around a component
# The network's errors are of about this size, and smaller on small components: a twelfth of the
# component's longest side.
ERROR, ERROR_FRACTION = (0.02, 0.04), 1 / 12
CELLS = 1.6  # of the component's own lattice, to such an error
MOST_CELLS = 72  # along the component's longest side
POLISH = 2  # rounds
TURNS, TURNED = 12, 500  # by which a component is turned about its middle, vertices that are
TURNED_OFF = 0.5  # errors off the surface, of what is the same all around
TIMES = (8, 7, 6, 5, 4, 3, 2)  # that a component may repeat itself around an axis
REPEATED = 0.94  # the least fraction of its surface that does
FITTED = 400  # points of a component's surface that its primitive is fitted to

Mesh = tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]
Distances = Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n p"]]
Elsewhere = Callable[[Float[Tensor, "n 3"]], Tensor]


class Place(NamedTuple):
    """Where one connected component of a part is."""

    part: int
    low: Float[np.ndarray, " 3"]  # of the box around it, with a margin
    high: Float[np.ndarray, " 3"]
    others: Elsewhere  # whether a place is of another of the part's


class Component(NamedTuple):
    """One connected component of a part, as it is drawn."""

    place: Place
    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    lattice: Lattice  # of the part's distances, that the surface comes from
    error: float  # about what it may be off
    primitive: Primitive | None = None  # that it is up to its errors

    @property
    def cell(self) -> float:
        """The cell of its lattice."""
        return self.lattice.cell

    @property
    def middle(self) -> Float[Tensor, " 3"]:
        """The middle of its surface."""
        area = face_areas(self.verts, self.faces)
        return area @ self.verts[self.faces].mean(1) / area.sum()


def places_of(distances: Distances, parts: int) -> Iterator[Place]:
    """The connected components of each part, found on one lattice."""
    cell = 2 * EXTENT / SEARCH
    side = torch.linspace(-EXTENT, EXTENT, SEARCH + 1)
    nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)
    found = distances(nodes.view(-1, 3))[:, :parts].view(*nodes.shape[:3], parts).cpu().numpy()
    for part in range(parts):
        labels = np.zeros(found.shape[:3], np.int32)
        ndimage.label(found[..., part] < BOARD * cell, output=labels)
        for index, where in enumerate(ndimage.find_objects(labels)):
            mine = labels[where] == index + 1
            if mine.sum() < LEAST_NODES or found[(*where, part)][mine].min() >= 0:
                continue
            ends = np.array([(side.start, side.stop - 1) for side in where]).T * cell - EXTENT
            others = _elsewhere(labels, index + 1, cell, np.full(3, -EXTENT))
            yield Place(part, ends[0] - MARGIN * cell, ends[1] + MARGIN * cell, others)


def _elsewhere(
    labels: Int[np.ndarray, "n m k"], mine: int, cell: float, low: Float[np.ndarray, " 3"]
) -> Elsewhere:
    """Whether places are in another labelled component than ``mine``, by the nearest node of a
    lattice from ``low`` on."""
    table = torch.from_numpy((labels != 0) & (labels != mine))
    last = torch.tensor(table.shape) - 1

    def at(points: Float[Tensor, "n 3"]) -> Tensor:
        node = ((points - torch.from_numpy(low).to(points)) / cell).round().long()
        return table[tuple(node.clamp(min=0).minimum(last).T)]

    return at


def drawn_in(distances: Distances, place: Place) -> Iterator[Component]:
    """The components at a place: mostly one, or several that only the common lattice joins."""
    whole = drawn_at(distances, place)
    if whole is None:
        return
    places = list(_places_within(whole))
    if len(places) < 2:
        yield whole
        return
    for one in places:
        yield from drawn_in(distances, one)  # on a finer lattice more come apart


def _places_within(component: Component) -> Iterator[Place]:
    """Where the lattice of the component's surface has components of about its size, each apart."""
    part, lattice = component.place.part, component.lattice
    labels = _labelled(component)
    nodes = np.bincount(labels.ravel())[1:]
    for index, where in enumerate(ndimage.find_objects(labels)):
        if nodes[index] < ALSO * nodes.max():
            continue
        ends = np.array([(side.start, side.stop - 1) for side in where]).T * lattice.cell
        low, high = ends + lattice.low + MARGIN * lattice.cell * np.array([[-1], [1]])
        away = _elsewhere(labels, index + 1, lattice.cell, lattice.low)
        yield Place(part, low, high, partial(_any_of, (component.place.others, away)))


def _labelled(component: Component) -> Int[np.ndarray, "n m k"]:
    """The components among the lattice's nodes, numbered from 1; 0 outside.

    What a bridge joins that is thinner than the errors is two: the gap between a dresser's rows of
    drawers was mostly shut, and they became one roll.
    """
    values, cell = component.lattice.values, component.lattice.cell
    inside, labels = values < 0, np.zeros(values.shape, np.int32)
    ndimage.label(values < -BRIDGE * component.error, JOINED, output=labels)
    nodes = np.bincount(labels.ravel())[1:]
    large = np.flatnonzero(nodes >= ALSO * nodes.max(initial=0)) + 1
    if len(large) > 1:
        labels[~np.isin(labels, large)] = 0
        found = ndimage.distance_transform_edt(labels == 0, cell, return_indices=True)
        away, nearest = cast(tuple, found)
        if away[inside].max() <= SHORT * component.error:  # or it is a thin sheet, and no bridge
            grown = np.where(inside, labels[tuple(nearest)], 0)
            return np.unique(grown, return_inverse=True)[1].reshape(values.shape).astype(np.int32)
    ndimage.label(inside, JOINED, output=labels)
    return labels


def _any_of(each: Sequence[Elsewhere], points: Float[Tensor, "n 3"]) -> Tensor:
    return torch.stack([one(points) for one in each]).any(0)


def drawn_at(distances: Distances, place: Place) -> Component | None:
    """The largest component's closed surface on a lattice of its own."""
    longest = float((place.high - place.low).max())
    error = min(max(longest * ERROR_FRACTION, ERROR[0]), ERROR[1])
    grid = tet_grid(min(int(np.ceil(longest * CELLS / error)), MOST_CELLS))
    cell = longest / grid.resolution
    middle = torch.from_numpy((place.low + place.high) / 2).float()
    nodes = grid.tet_verts * (longest / (2 * EXTENT)) + middle
    low, high = (torch.from_numpy(end).float() for end in (place.low, place.high))
    asked = ((nodes > low) & (nodes < high)).all(1) & ~grid.boundary
    asked[asked.clone()] = ~place.others(nodes[asked])
    distance = torch.full((len(nodes),), FAR * cell)  # outside, where nothing is asked
    distance[asked] = distances(nodes[asked])[:, place.part].cpu()
    verts, faces, *_ = surface(distance, nodes, grid)
    if not len(faces):
        return None
    verts, faces = largest(verts, faces)
    verts = polished(verts, faces, POLISH)
    values = distance.view(grid.shape).double().numpy()
    return Component(place, verts, faces, Lattice(values, nodes[0].double().numpy(), cell), error)


def points_of(component: Component) -> Float[np.ndarray, "n 3"]:
    """Points of the component's surface, evenly by area."""
    generator = torch.Generator().manual_seed(0)
    return sample_surface(component.verts, component.faces, FITTED, generator).double().numpy()


def turned_fraction(distances: Distances, component: Component, axis: int) -> float:
    """The fraction of a component's surface that stays on it when it is turned about the line along
    ``axis`` through its middle."""
    # By no symmetry of a square.
    turns = [k / (TURNS + 0.5) for k in range(1, TURNS + 1)]
    return on_itself(distances, component, component.middle, axis, turns)


def repeated(distances: Distances, component: Component) -> Component:
    """The mean of the component over the turns that leave it unchanged."""
    mean = repeats(distances, component)
    return (mean and drawn_at(mean, component.place)) or component


def repeats(distances: Distances, component: Component) -> Distances | None:
    """The mean of a component's distances over the turns that leave it unchanged, or None."""
    middle = component.middle
    for times in TIMES:
        turns = [k / times for k in range(times)]
        for axis in (2, 0, 1):
            if on_itself(distances, component, middle, axis, turns[1:]) >= REPEATED:
                return lambda points: torch.stack(
                    [distances(x + middle) for x in ring_of(points - middle, axis, turns)]
                ).mean(0)
    return None


def on_itself(
    distances: Distances,
    component: Component,
    middle: Float[Tensor, " 3"],
    axis: int,
    turns: Sequence[float],
) -> float:
    """The fraction of a component's surface that parts of a whole turn about its middle leave on
    it."""
    some = component.verts[:: -(-len(component.verts) // TURNED)] - middle
    places = ring_of(some, axis, turns) + middle
    off = distances(places.view(-1, 3))[:, component.place.part].abs()
    return float((off < TURNED_OFF * component.error).float().mean())


def ring_of(
    points: Float[Tensor, "n 3"], axis: int, turns: Sequence[float]
) -> Float[Tensor, "t n 3"]:
    """The points by each part of a whole turn about an axis through the origin."""
    angle = 2 * torch.pi * torch.tensor(turns)
    c, s = angle.cos()[:, None], angle.sin()[:, None]
    i, j = (k for k in range(3) if k != axis)
    placed = points.repeat(len(turns), 1, 1)
    placed[..., i] = c * points[:, i] - s * points[:, j]
    placed[..., j] = s * points[:, i] + c * points[:, j]
    return placed


def largest(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Mesh:
    """The component of the most faces."""
    _, label = component_labels(faces, len(verts))
    return compact(verts, faces[torch.from_numpy(label == np.bincount(label).argmax())])
