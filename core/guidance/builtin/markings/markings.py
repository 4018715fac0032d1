"""Parts that are on another one as paint is: a die's pips, a zebra's stripes, the hours of a clock.

A flat part has no shape of its own, and drawn as a solid its border is as ragged as the lattice.
Here it is a margin, as a pattern's is (:mod:`core.guidance.builtin.patterns`), so that it is as
sharp as the texture; and it is a part by name, with a colour and a material of its own.
"""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.markings.heights import FLAT, Height, height_of
from core.guidance.builtin.markings.margins import Margin
from core.guidance.builtin.markings.marking import Marking
from core.guidance.builtin.markings.table import MARKINGS

NUMBER = "number"  # a part by that name takes another as its margin's ``text``


class Laid(NamedTuple):
    """A marking on one object."""

    part: int
    on: int
    bearer: int  # the part with a solid below it
    marking: Marking
    boxes: Sequence[Float[Tensor, "2 3"]]  # that place it: one, or that of each component
    height: Height

    def margin(self, points: Float[Tensor, "n 3"]) -> Margin:
        """How far inside the marking each point is."""
        if len(self.boxes) == 1:
            return self._within(self.boxes[0], points)
        found = torch.empty_like(points[:, 0])
        away = [outside(points, box.to(points)) for box in self.boxes]
        nearest = torch.stack(away).argmin(0)
        for index, box in enumerate(self.boxes):
            here = (nearest == index).nonzero().squeeze(1)
            found[here] = self._within(box, points[here])
        return found

    def _within(self, box: Float[Tensor, "2 3"], points: Float[Tensor, "n 3"]) -> Margin:
        low, high = box.to(points)
        middle = (low + high) / 2
        if self.marking.paired:
            middle = torch.cat([middle[:1].abs(), middle[1:]])
            points = torch.cat([points[:, :1].abs(), points[:, 1:]], 1)
        return self.marking.marks(points - middle, (high - low) / 2)


class Marked:
    """The markings of one object: adds them to the distances of its parts."""

    def __init__(
        self,
        noun: str,
        names: Sequence[str],
        boxes: Sequence[Float[Tensor, "2 3"] | None],
        number: str = "",
        every: Sequence[Sequence[Float[Tensor, "2 3"]]] = (),
    ) -> None:
        """
        Args:
            names: of the noun's parts; "" for those that the object lacks.
            boxes: the lowest and the highest corner of each part; None without a solid.
            number: replaces its usual one.
            every: the boxes of all components of each part.
        """
        self.laid: list[Laid] = []
        self.bearers = list(range(len(names)))  # by part; the part itself where it has a solid
        for name, one in sorted(_of(noun), key=lambda one: _depth(noun, one[0])):
            bearer = bearer_of(noun, name)
            by = one.by or bearer
            if number and name == NUMBER:
                one = one._replace(marks=partial(one.marks, text=number))
            if {name, one.on, bearer, by} <= set(names):
                box = boxes[names.index(by)]
                if box is not None:
                    part, on, below = (names.index(which) for which in (name, one.on, bearer))
                    own = every[names.index(by)] if one.every and every else [box]
                    self.laid.append(Laid(part, on, below, one, own, height_of(noun, name)))
                    self.bearers[part] = below

    def __call__(
        self, distances: Float[Tensor, "n p"], points: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n p"]:
        """The parts' distances with the markings among them."""
        found = distances.clone()
        for one in self.laid:
            margin = one.margin(points)
            below = found[:, one.on].clone()
            found[:, one.part] = torch.maximum(below, -margin)
            found[:, one.on] = torch.maximum(below, margin)
        return found

    def height(self, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]) -> Float[Tensor, " n"]:
        """How far the surface stands out at points of the surfaces of parts, training units."""
        bearer = part.new_tensor(self.bearers)[part]
        found = torch.zeros_like(points[:, 0])
        for which in {one.bearer for one in self.laid if one.height != FLAT}:
            here = (bearer == which).nonzero().squeeze(1)
            if len(here):
                found[here] = self._height_on(which, points[here])
        return found

    @property
    def uneven(self) -> set[int]:
        """The parts that stand out or are sunk, and those on them."""
        found: set[int] = set()
        for one in self.laid:  # the lowest come first
            if one.height != FLAT or one.on in found:
                found.add(one.part)
        return found

    def _height_on(self, bearer: int, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """The sum of the heights of all markings on one part with a solid."""
        found = torch.zeros_like(points[:, 0])
        room = {bearer: torch.full_like(found, torch.inf)}  # how far inside each a point is
        for one in self.laid:
            if one.bearer == bearer:
                margin, below = one.margin(points), room[one.on]
                room[one.part] = torch.minimum(below, margin)
                room[one.on] = torch.minimum(below, -margin)
                found = found + one.height.at(room[one.part])
        return found


def outside(points: Float[Tensor, "n 3"], box: Float[Tensor, "2 3"]) -> Float[Tensor, " n"]:
    """How far outside a box each point is."""
    low, high = box
    return torch.maximum(low - points, points - high).clamp_min(0).norm(dim=1)


def bearer_of(noun: str, part: str) -> str:
    """The part with a solid below a marking: the white below a pupil."""
    while is_marking(noun, part):
        part = MARKINGS[noun][part].on
    return part


def unfit_markings(noun: str, materials: Mapping[str, str]) -> set[str]:
    """Markings of another material than the one that a prompt states for their part (``materials``;
    "" by nature): an iron chest has no planks."""
    named = ((name, one.of, materials[bearer_of(noun, name)]) for name, one in _of(noun))
    return {name for name, own, stated in named if own and stated not in ("", own)}


def _of(noun: str) -> Iterable[tuple[str, Marking]]:
    return MARKINGS.get(noun, {}).items()


def _depth(noun: str, part: str) -> int:
    """The number of parts below a marking."""
    on = MARKINGS[noun][part].on
    return 1 + _depth(noun, on) if is_marking(noun, on) else 1


def is_marking(noun: str, part: str) -> bool:
    """Whether the part has no solid of its own."""
    return part in MARKINGS.get(noun, {})


def has_markings(noun: str) -> bool:
    """Whether any part of the noun has no solid of its own."""
    return noun in MARKINGS
