"""The curve skeleton of a component: a graph of nodes in its middle, each with a radius.

It is the graph of the level sets of the way from an end (a Reeb graph: Verroust and Lazarus 2000,
"Extracting skeletal curves from 3D scattered data"), over the nodes of a lattice within the
surface.
"""

import itertools
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, dijkstra

from core.geometry.lattice import Lattice

NEIGHBOURS = [way for way in itertools.product((-1, 0, 1), repeat=3) if way > (0, 0, 0)]
MOST_NODES = 40_000  # of a lattice, within the surface
STUB = 1.6  # radii: a branch that is shorter is the end of a thick one


class Skeleton(NamedTuple):
    """A graph."""

    nodes: Float[np.ndarray, "k 4"]  # x, y, z, radius
    edges: dict[int, set[int]]  # of each node, those that it is joined to

    @property
    def loops(self) -> int:
        """How many independent loops it has, if it is connected."""
        return sum(map(len, self.edges.values())) // 2 - len(self.edges) + 1

    def chains(self) -> list[list[int]]:
        """The nodes from one end or branching to the next, one after another; a loop without
        branchings begins and ends at one node."""
        ends = {k for k, joined in self.edges.items() if len(joined) != 2}
        found, seen = [], set()
        for end in ends or set(list(self.edges)[:1]):
            for first in self.edges[end]:
                chain = [end, first]
                while chain[-1] not in ends and chain[-1] != end:
                    chain.append(next(k for k in self.edges[chain[-1]] if k != chain[-2]))
                if frozenset(chain[:2]) not in seen:
                    seen |= {frozenset(chain[:2]), frozenset(chain[-2:])}
                    found.append(chain)
        return found

    def length(self, chain: list[int]) -> float:
        """Of a chain."""
        return float(np.linalg.norm(np.diff(self.nodes[chain, :3], axis=0), axis=1).sum())

    def is_stub(self, chain: list[int]) -> bool:
        """Whether a chain is only the rounded end of what is thick."""
        end, branching = sorted((chain[0], chain[-1]), key=lambda k: len(self.edges[k]))
        if len(self.edges[end]) != 1 or len(self.edges[branching]) < 3:
            return False
        return self.length(chain) < STUB * float(self.nodes[branching, 3])

    def is_one(self, chain: list[int]) -> bool:
        """Whether the branchings at the ends of a chain are one."""
        ends = {chain[0], chain[-1]}
        if len(ends) == 1 or min(len(self.edges[k]) for k in ends) < 3:
            return False
        return self.length(chain) < float(self.nodes[list(ends), 3].max())


def skeleton_of(lattice: Lattice, width: float) -> Skeleton | None:
    """The skeleton of what is within a component's surface; None where it is too large.

    ``width``: of the bands of way that become a node each, in radii.
    """
    depth = -lattice.values
    inside = np.argwhere(depth > 0)
    if not 0 < len(inside) <= MOST_NODES:
        return None
    graph = _graph_of(depth.shape, inside)
    label = connected_components(graph, directed=False)[1]
    mine = label == np.bincount(label).argmax()
    graph, inside = graph.tocsr()[mine][:, mine], inside[mine]
    deep = depth[tuple(inside.T)]
    radius = float(np.median(deep[deep >= np.percentile(deep, 70)])) + lattice.cell / 4
    far = dijkstra(graph, directed=False, indices=0)
    way = dijkstra(graph, directed=False, indices=int(far.argmax()))
    band = (way * lattice.cell / (width * radius)).astype(int)
    pairs = np.stack(graph.nonzero())
    same = pairs[:, band[pairs[0]] == band[pairs[1]]]
    count = len(inside)
    joined = coo_array((np.ones(same.shape[1]), same), shape=(count, count))
    groups, group = connected_components(joined, directed=False)
    weight = deep**2
    total = np.bincount(group, weight, groups).clip(1e-12)
    center = np.stack([np.bincount(group, weight * x, groups) / total for x in inside.T], 1)
    radii = np.zeros(groups)
    np.maximum.at(radii, group, deep)
    places = lattice.low + lattice.cell * center
    edges: dict[int, set[int]] = {k: set() for k in range(groups)}
    for a, b in np.unique(group[pairs], axis=1).T.tolist():
        if a != b:
            edges[a].add(b)
            edges[b].add(a)
    return without_stubs(Skeleton(np.c_[places, radii], edges))


def _graph_of(shape: tuple[int, ...], inside: Int[np.ndarray, "n 3"]) -> coo_array:
    """The inner nodes, each joined to its neighbours by the way between them."""
    index = np.full(shape, -1)
    index[tuple(inside.T)] = np.arange(len(inside))
    padded = np.pad(index, 1, constant_values=-1)
    rows, columns, ways = [], [], []
    for step in NEIGHBOURS:
        other = padded[tuple((inside + 1 + step).T)]
        has = np.flatnonzero(other >= 0)
        rows.append(has)
        columns.append(other[has])
        ways.append(np.full(len(has), np.linalg.norm(step)))
    both = np.concatenate(rows), np.concatenate(columns)
    count = len(inside)
    return coo_array((np.concatenate(ways), both), shape=(count, count))


def without_stubs(skeleton: Skeleton) -> Skeleton:
    """Without the short branches at the ends of what is thick, and with branchings that are within
    a radius of one another made one."""
    nodes, edges = skeleton.nodes.copy(), {k: set(v) for k, v in skeleton.edges.items()}
    made = Skeleton(nodes, edges)
    while stub := next(filter(made.is_stub, made.chains()), None):
        _remove(edges, stub[:-1] if len(edges[stub[0]]) == 1 else stub[1:])
    while short := next(filter(made.is_one, made.chains()), None):
        kept, *rest = short
        others = {k for one in short for k in edges[one]} - set(short)
        nodes[kept, :3] = nodes[short, :3].mean(0)
        _remove(edges, rest)
        edges[kept] = others
        for k in others:
            edges[k].add(kept)
    return made


def _remove(edges: dict[int, set[int]], nodes: list[int]) -> None:
    for k in nodes:
        for other in edges.pop(k):
            if other in edges:
                edges[other].discard(k)
