"""A component as bent pipes: a bicycle's frame, a handle, antlers, an insect's legs.

Its skeleton's chains are simplified (Douglas and Peucker 1973), and their nodes and radii moved to
where the points of its surface are least off.
"""

import itertools
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.optimize import least_squares

from core.geometry.init_shape import sample_surface
from core.geometry.mesh import face_areas
from core.geometry.parts.components import Component
from core.geometry.parts.pipes import Pipe, apart, packed_pipes, weights_of
from core.geometry.parts.primitives import Primitive
from core.geometry.parts.skeleton import Skeleton, skeleton_of
from core.kernels import distances

WIDTHS = (1.5, 2.0, 1.2)  # of the skeleton's bands, radii: the first that has all loops
POINTS = 1500  # on the surface
SIMPLE = 0.4  # errors that a node of a chain may be off the line without it
CORNER = 0.7  # cosine between two sides of a chain, below which it has a corner
NEAR = 1.5  # radii between two nodes of a chain, at least
SLIM = 8.0  # times the mean radius that the pipes are long together, at least
AREA = 0.15  # by which the surface of pipes may be larger or smaller than what is drawn
STOUT = 0.125  # training units, a pipe's radius, at most
MOST = 60  # nodes
STILL, LEVEL = 0.05, 0.1  # what a move of a node counts, and a difference between two radii
STEPS = 15
THINNEST = 0.25  # errors, a radius
SOFT = 0.5  # errors, beyond which a point counts less


class Graph(NamedTuple):
    """Nodes, and the pipes between them: indices, one after another."""

    nodes: Float[np.ndarray, "k 4"]
    pipes: list[list[int]]

    @property
    def sides(self) -> Int[np.ndarray, "s 2"]:
        """The pairs of nodes that are next to each other."""
        return np.array([pair for pipe in self.pipes for pair in itertools.pairwise(pipe)])

    @property
    def length(self) -> float:
        """Of all pipes."""
        first, second = self.nodes[self.sides.T, :3]
        return float(np.linalg.norm(second - first, axis=1).sum())

    def made(self) -> list[Pipe]:
        """A closed pipe's first node is its last."""
        closed = [len(pipe) > 3 and pipe[0] == pipe[-1] for pipe in self.pipes]
        return [
            Pipe(self.nodes[pipe[:-1] if ends else pipe], ends)
            for pipe, ends in zip(self.pipes, closed, strict=True)
        ]


def piped(component: Component) -> Primitive | None:
    """The pipes that the component is; None where it is none, as where it is too stout."""
    skeleton = _skeleton(component)
    if skeleton is None or len(skeleton.edges) < 2:
        return None
    graph = simplified(skeleton, SIMPLE * component.error)
    if len(graph.nodes) > MOST:
        return None
    generator = torch.Generator().manual_seed(0)
    points = sample_surface(component.verts, component.faces, POINTS, generator).double().numpy()
    graph = fitted(graph, points, component.error)
    radii = graph.nodes[:, 3]
    if graph.length < SLIM * radii.mean() or radii.max() > STOUT:
        return None
    one = Primitive("pipes", np.zeros(3), np.zeros(3), packed_pipes(graph.made()))
    drawn, made = (
        float(face_areas(verts, faces).sum())
        for verts, faces in ((component.verts, component.faces), one.mesh(np.inf))
    )
    # A small wing fits a pipe that winds over it.
    return one if abs(made / drawn - 1) < AREA else None


def _skeleton(component: Component) -> Skeleton | None:
    """One with as many loops as the surface has handles."""
    verts, faces = len(component.verts), len(component.faces)
    handles = 1 - (verts - faces // 2) // 2
    each = (skeleton_of(component.lattice, width) for width in WIDTHS)
    return next((one for one in each if one and one.loops == handles), None)


def simplified(skeleton: Skeleton, off: float) -> Graph:
    """The skeleton's chains of as few nodes as are within ``off`` of them, apart at corners."""
    nodes, pipes = skeleton.nodes, []
    for chain in skeleton.chains():
        if chain[0] == chain[-1] and len(skeleton.edges[chain[0]]) == 2:  # it begins anywhere
            away = np.linalg.norm(nodes[chain, :3] - nodes[chain, :3].mean(0), axis=1)
            first = int(away.argmax())
            chain = [*chain[first:-1], *chain[: first + 1]]
        short = _apart(nodes, [chain[k] for k in np.flatnonzero(_kept(nodes[chain, :3], off))])
        sides = np.diff(nodes[short, :3], axis=0)
        sides = sides / np.linalg.norm(sides, axis=1, keepdims=True).clip(1e-9)
        turns = (sides[:-1] * sides[1:]).sum(1)
        cuts = [0, *(np.flatnonzero(turns < CORNER) + 1).tolist(), len(short) - 1]
        pipes += [short[a : b + 1] for a, b in itertools.pairwise(cuts)]
    used = sorted({k for pipe in pipes for k in pipe})
    number = {k: i for i, k in enumerate(used)}
    return Graph(nodes[used], [[number[k] for k in pipe] for pipe in pipes])


def _apart(nodes: Float[np.ndarray, "k 4"], chain: list[int]) -> list[int]:
    """The chain without one of two inner nodes that are near each other: bands cut a corner."""
    kept = chain[:1]
    for k in chain[1:-1]:
        away = float(np.linalg.norm(nodes[k, :3] - nodes[kept[-1], :3]))
        if len(kept) < 2 or away > NEAR * nodes[k, 3]:
            kept.append(k)
    return [*kept, chain[-1]]


def _kept(places: Float[np.ndarray, "n 3"], off: float) -> Bool[np.ndarray, " n"]:
    """Which of a line's places stay."""
    kept = np.zeros(len(places), bool)
    kept[[0, -1]] = True
    if np.allclose(places[0], places[-1]) and len(places) > 3:  # a loop: the farthest is one too
        kept[np.linalg.norm(places - places[0], axis=1).argmax()] = True
    waiting = list(zip(np.flatnonzero(kept)[:-1], np.flatnonzero(kept)[1:], strict=True))
    while waiting:
        a, b = waiting.pop()
        if b - a < 2:
            continue
        way, from_start = places[b] - places[a], places[a + 1 : b] - places[a]
        along = (from_start @ way / max(way @ way, 1e-12)).clip(0, 1)
        away = np.linalg.norm(from_start - along[:, None] * way, axis=1)
        if away.max() > off:
            middle = a + 1 + int(away.argmax())
            kept[middle] = True
            waiting += [(a, middle), (middle, b)]
    return kept


def fitted(graph: Graph, points: Float[np.ndarray, "n 3"], error: float) -> Graph:
    """The graph where the points are least off.

    A move of a node and a difference between two radii count a little too, so that what no point
    shows stays.
    """
    curves, first, sides = _curves(graph), graph.nodes, graph.sides
    count, size = len(points), len(first)
    scale = np.sqrt(count / size)
    level = np.zeros((len(sides), size, 4))
    level[np.arange(len(sides)), sides[:, 0], 3] = scale * LEVEL
    level[np.arange(len(sides)), sides[:, 1], 3] -= scale * LEVEL
    still = scale * STILL * np.eye(4 * size).reshape(size, 4, size, 4)[:, :3]
    rest = np.concatenate([level.reshape(-1, 4 * size), still.reshape(-1, 4 * size)])
    wanted = np.append(np.zeros(len(sides)), scale * STILL * first[:, :3].ravel())

    def residuals(x: np.ndarray) -> np.ndarray:
        off = _nearest(curves, x.reshape(-1, 4), points).off
        return np.concatenate([off, rest @ x - wanted]) / error

    def jacobian(x: np.ndarray) -> np.ndarray:
        near = _nearest(curves, x.reshape(-1, 4), points)
        along = near.along[:, None]
        ends = (1 - along) * curves[near.row] + along * curves[near.row + 1]
        slope = -np.concatenate([near.away, np.ones((count, 1))], 1)
        own = (ends[:, :, None] * slope[:, None]).reshape(count, 4 * size)
        return np.concatenate([own, rest]) / error

    solved = least_squares(
        residuals, first.ravel(), jacobian, loss="soft_l1", f_scale=SOFT, max_nfev=STEPS
    )
    nodes = solved.x.reshape(-1, 4)
    nodes[:, 3] = nodes[:, 3].clip(min=THINNEST * error)
    return Graph(nodes, graph.pipes)


def _curves(graph: Graph) -> Float[np.ndarray, "m k"]:
    """The points of all curves as weights of the nodes; a row that is not finite between two."""
    each = []
    for pipe, one in zip(graph.pipes, graph.made(), strict=True):
        own = weights_of(one.nodes[:, :3], one.closed)
        wide = np.zeros((len(own), len(graph.nodes)))
        wide[:, pipe[: own.shape[1]]] = own
        each.append(wide)
    return apart(each)


class Nearest(NamedTuple):
    """Of each point the nearest place of the curves."""

    off: Float[np.ndarray, " n"]  # how far off the surface there
    row: Int[np.ndarray, " n"]  # the point of the curves that its segment begins at
    along: Float[np.ndarray, " n"]  # the segment, 0 to 1
    away: Float[np.ndarray, "n 3"]  # the direction from the axis to the point


def _nearest(
    curves: Float[np.ndarray, "m k"], nodes: Float[np.ndarray, "k 4"], points: np.ndarray
) -> Nearest:
    fine = curves @ nodes
    off, row, along = distances.pipes(points, fine)
    t = along[:, None]
    away = points - (1 - t) * fine[row, :3] - t * fine[row + 1, :3]
    away = away / np.linalg.norm(away, axis=1, keepdims=True).clip(1e-9)
    return Nearest(off, row, along, away)
