"""Another number of similar components of a part: five candles on a cake that is drawn with three.

The components are arranged as the drawn ones are (:mod:`core.geometry.parts.arrangements`). Each
copy is seated: moved along its own direction until it is as deep in the other parts as the drawn
one is. What only touches one of the components goes with it: a candle's flame, a drawer's handle.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from scipy import ndimage
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.mesh import face_areas
from core.geometry.parts.arrangements import Spot, arrangements
from core.geometry.parts.balls import Ball, balls_of
from core.geometry.parts.components import Component, Distances

SIMILAR = 1.7  # times the area of the largest one's: what is smaller is no such component
SOME = 300  # vertices of each that are looked at
DEEP = 0.1  # quantile of the distances from the other parts: how deep a component is in them
TOUCHES = 0.03  # training units, from what it is attached to
BURIED = 0.2  # of the surface, more than of the drawn one's: inside other parts at most
ALIKE, MANY = 0.6, 3  # of the largest one's nodes: what comes apart; how many do below a level
LEVELS = np.linspace(0.9, 0.4, 11)  # of its height
AROUND = 1.3  # cells, around what is below the level
ON_AXIS = 0.03  # training units, off the plane x = 0
ASIDE = 0.6  # x of a direction at most that is straight in the middle
INTO = 0.08  # of its width: how far a copy is within another at most, or as far as the drawn ones
REACH, STEPS = 0.75, 61  # of its size, along its direction, and places where it may be seated
RIDES = 0.04  # training units, from the component that it goes with
AWAY = 0.15  # of its spread, from where it is attached to its middle


class Copy(NamedTuple):
    """A component in another place: ``matrix`` @ point + ``shift``."""

    part: int
    source: int  # among the components
    matrix: Float[Tensor, "3 3"]
    shift: Float[Tensor, " 3"]

    def out(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the drawn one in the copy's place."""
        return points @ self.matrix.T.to(points) + self.shift.to(points)

    def into(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """The inverse of :meth:`out`."""
        return (points - self.shift.to(points)) @ torch.linalg.inv(self.matrix).T.to(points)

    @property
    def least(self) -> float:
        """The least factor of a distance."""
        return float(torch.linalg.svdvals(self.matrix).min())


class Recount(NamedTuple):
    """Components that are replaced, and the copies in their place."""

    replaced: tuple[int, ...]
    copies: tuple[Copy, ...]
    balls: Mapping[int, Ball] = MappingProxyType({})  # that one component is taken apart into
    apart: Mapping[int, Component] = MappingProxyType({})  # or what of it is apart, and the rest


def recounted(
    distances: Distances, components: Sequence[Component], part: int, count: int
) -> Recount | None:
    """What makes ``count`` similar components of the part; None where that isn't possible."""
    group = similar_of(components, part)
    gone, balls, apart = tuple(group), {}, {}
    if len(group) == 1 and count != 1:
        whole, last = group[0], len(components)
        balls = dict(enumerate(balls_of(components[whole]), last))
        found = [components[whole]._replace(verts=ball.points()) for ball in balls.values()]
        if not balls:
            found, rest = taken_apart(distances, components[whole])
            apart = dict(enumerate(found, last)) | {whole: rest}
        components = [*components, *found]
        group = list(range(last, last + len(found))) or group
        gone = gone if balls else tuple(group)
    if len(group) == count:
        return Recount((), ())
    if len(group) < 2 or count < 1:
        return None
    stage = _Stage(distances, components, part, group, balls)
    for spots in arrangements(stage.middles, stage.sizes, count):
        if copies := stage.seated(spots):
            return Recount((*gone, *stage.riders), tuple(copies), balls, apart)
    return None


def similar_of(components: Sequence[Component], part: int) -> list[int]:
    """The part's components of about the size of its largest one; of a snowman's eyes and buttons
    the buttons."""
    area = {
        k: float(face_areas(one.verts, one.faces).sum())
        for k, one in enumerate(components)
        if one.place.part == part
    }
    group = [k for k, size in area.items() if size * SIMILAR >= max(area.values())]
    middles = np.array([components[k].middle.numpy() for k in group])
    inner = [k for k, (x, *_) in zip(group, middles, strict=True) if abs(x) < ON_AXIS]
    if len(inner) > 1 and len(group) == len(inner) + 2:
        _, deep, high = np.ptp(middles[np.abs(middles[:, 0]) < ON_AXIS], axis=0)
        return inner if high > deep else group
    return group


def taken_apart(distances: Distances, component: Component) -> tuple[list[Component], Component]:
    """What of a component is apart, and the rest: the fins of a rocket, which are joined within its
    hull, have all; the legs of a table have what is over them, and the frame between them goes."""
    values, cell = component.lattice.values, component.lattice.cell
    verts = component.verts
    nodes = np.stack(np.nonzero(values < 0), 1) * cell + component.lattice.low
    outside = np.zeros(values.shape, bool)
    outside[values < 0] = (_away(distances, component, nodes) > 0).numpy()
    height = np.arange(values.shape[2]) * cell + component.lattice.low[2]
    low, high = (float(end) for end in (verts[:, 2].amin(), verts[:, 2].amax()))
    for level in (None, *(low + LEVELS * (high - low))):
        inside = outside if level is None else (values < 0) & (height < level)
        labels = np.zeros(values.shape, np.int32)
        ndimage.label(inside, output=labels)
        number = np.bincount(labels.ravel())[1:]
        large = np.flatnonzero(number >= ALIKE * number.max(initial=0)) + 1
        if len(large) < (2 if level is None else MANY):
            continue
        at = np.nonzero(np.isin(labels, large))
        places = np.stack(at, 1) * cell + component.lattice.low
        flat = 3 if level is None else 2  # a leg goes on above the level, straight up
        away, nearest = KDTree(places[:, :flat]).query(verts[:, :flat].numpy())
        owner = labels[at][nearest]
        if level is not None:
            owner[away > AROUND * cell] = 0
        each = [component._replace(verts=verts[torch.from_numpy(owner == k)]) for k in large]
        return each, component._replace(verts=verts[:0])
    return [], component


def _away(
    distances: Distances, component: Component, points: Float[np.ndarray, "n 3"]
) -> Float[Tensor, " n"]:
    """The distance of points from all parts but the component's."""
    away = distances(torch.from_numpy(points).float())
    return away[:, [k for k in range(away.shape[1]) if k != component.place.part]].amin(1)


@dataclass
class _Stage:
    """The drawn components that are counted, and what is around them."""

    distances: Distances
    components: Sequence[Component]
    part: int
    group: list[int]
    balls: Mapping[int, Ball]

    @cached_property
    def some(self) -> list[Float[Tensor, "s 3"]]:
        """Vertices of each of the group."""
        each = (self.components[k].verts for k in self.group)
        return [verts[:: -(-len(verts) // SOME)] for verts in each]

    @cached_property
    def middles(self) -> Float[np.ndarray, "k 3"]:
        """The middle of each one's box."""
        boxes = [self._box(k) for k in self.group]
        return torch.stack([(low + high) / 2 for low, high in boxes]).double().numpy()

    @cached_property
    def sizes(self) -> Float[np.ndarray, "k 3"]:
        """The sides of each one's box."""
        boxes = [self._box(k) for k in self.group]
        return torch.stack([high - low for low, high in boxes]).double().numpy()

    def _box(self, k: int) -> tuple[Tensor, Tensor]:
        verts = self.components[k].verts
        return verts.amin(0), verts.amax(0)

    @cached_property
    def riders(self) -> dict[int, int]:
        """Components of other parts that only touch one of the group, as many of a part on each:
        the index in the group of the one that each goes with."""
        found: dict[int, int] = {}
        trees = [KDTree(self.components[k].verts.numpy()) for k in self.group]
        others = [k for k, one in enumerate(self.components) if one.place.part != self.part]
        for part in sorted({self.components[k].place.part for k in others}):
            own = [k for k in others if self.components[k].place.part == part]
            on = [self._borne_by(k, trees) for k in own]
            each = [on.count(index) for index in range(len(self.group))]
            if None not in on and min(each) == max(each) > 0:
                found |= {k: index for k, index in zip(own, on, strict=True) if index is not None}
        return found

    def _borne_by(self, k: int, trees: Sequence[KDTree]) -> int | None:
        component = self.components[k]
        verts = component.verts[:: -(-len(component.verts) // SOME)]
        gaps = [float(tree.query(verts.numpy())[0].min()) for tree in trees]
        nearest = int(np.argmin(gaps))
        away = self.distances(verts)
        rest = [c for c in range(away.shape[1]) if c not in (self.part, component.place.part)]
        apart = float(away[:, rest].min()) if rest else np.inf
        own = float(away[:, self.part].min())
        return nearest if gaps[nearest] < RIDES and own < apart else None

    def others(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """The distance from all parts but the group's and its riders'."""
        gone = {self.part, *(self.components[k].place.part for k in self.riders)}
        away = self.distances(points)
        return away[:, [k for k in range(away.shape[1]) if k not in gone]].amin(1)

    @cached_property
    def attached(self) -> list[Float[Tensor, " s"]]:
        """The distances of the vertices of each of the group from what is around them."""
        return [self.others(verts) for verts in self.some]

    def direction(self, index: int) -> Float[Tensor, " 3"]:
        """From where one of the group is attached to its middle; up where it is in the middle of
        that."""
        verts, off = self.some[index], self.attached[index]
        at = verts[off <= max(0.0, float(off.quantile(DEEP)))].mean(0)
        away = (verts.amin(0) + verts.amax(0)) / 2 - at
        if away.norm() < AWAY * (verts.amax(0) - verts.amin(0)).norm():
            return torch.tensor([0.0, 0.0, 1.0])
        away = away / away.norm()
        axis = int(away.abs().argmax())
        upright = torch.zeros(3)
        upright[axis] = away[axis].sign()
        return upright if away[axis].abs() > 0.9 else away

    def seated(self, spots: Sequence[Spot]) -> list[Copy] | None:
        """The copies at these spots, each as deep in the other parts as the drawn one is, with
        their riders; None where one has no hold or meets another."""
        placed: list[tuple[Spot, Copy]] = []
        for spot in spots:
            copy = self._seated(spot)
            if copy is None or any(self._meet(copy, other) for _, other in placed):
                return None
            placed.append((spot, copy))
        found = [copy for _, copy in placed]
        for spot, copy in placed:
            for k, index in self.riders.items():
                if index == spot.source:
                    found.append(self._ridden(k, spot, copy))
        return found

    def _seated(self, spot: Spot) -> Copy | None:
        verts, off = self.some[spot.source], self.attached[spot.source]
        middle = torch.from_numpy(self.middles[spot.source]).float()
        turn = torch.from_numpy(spot.turn).float()
        matrix = turn @ torch.diag(torch.from_numpy(spot.scale).float())
        shift = torch.from_numpy(spot.at).float() - matrix @ middle
        copy = Copy(self.part, self.group[spot.source], matrix, shift)
        there = copy.out(verts)
        if spot.stays:
            return copy
        way = turn @ self.direction(spot.source)
        if abs(spot.at[0]) < ON_AXIS and way[0].abs() < ASIDE:
            way = torch.nn.functional.normalize(way * way.new_tensor((0, 1, 1)), dim=0)
        size = float((verts.amax(0) - verts.amin(0)).max())
        steps = torch.linspace(-REACH, REACH, STEPS) * size
        steps = steps[steps.abs().argsort()]
        deep = float(off.quantile(DEEP))
        away = self.others((there + steps[:, None, None] * way).view(-1, 3)).view(STEPS, -1)
        depth = away.quantile(DEEP, dim=1) - deep
        fits = depth.abs() <= TOUCHES / 2
        fits &= (away < 0).float().mean(1) <= float((off < 0).float().mean()) + BURIED
        fits &= away.amin(1) <= max(TOUCHES, float(off.min()) + TOUCHES / 2)
        if not fits.any():
            return None
        near = fits.nonzero()[0, 0]
        # Of neighbouring places the one that is as deep.
        close = fits & ((steps - steps[near]).abs() <= 2.5 * REACH * size / STEPS * 2)
        best = torch.where(close, depth.abs(), torch.inf).argmin()
        return copy._replace(shift=shift + steps[best] * way)

    def _meet(self, one: Copy, other: Copy) -> bool:
        """Whether two copies are in one another, more than the drawn ones are."""
        verts = self.some[self.group.index(other.source)]
        local = one.into(other.out(verts))
        own = self.components[one.source].verts
        low, high = own.amin(0), own.amax(0)
        near = local[((local > low) & (local < high)).all(1)]
        if not len(near):
            return False
        ball = self.balls.get(one.source)
        away = ball.distance(near) if ball else self.distances(near)[:, self.part]
        return float(away.min()) < -INTO * float((high - low).min())

    def _ridden(self, k: int, spot: Spot, copy: Copy) -> Copy:
        """A component that goes with one of the group, no wider or higher by itself."""
        verts = self.components[k].verts
        middle = ((verts.amin(0) + verts.amax(0)) / 2)[None]
        matrix = torch.from_numpy(spot.turn).float() * min(1.0, float(spot.scale.min()))
        shift = (copy.out(middle) - middle @ matrix.T)[0]
        return Copy(self.components[k].place.part, k, matrix, shift)
