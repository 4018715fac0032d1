"""Parts that lie on another as paint does: a die's pips, a zebra's stripes, the hours of a clock.

What is flat on a surface has no shape of its own, and drawn as a solid its border is as ragged as
the lattice. Here it is a margin, as a pattern's is (:mod:`core.guidance.builtin.patterns`), so that
it is as sharp as the texture; and it is a part by name, with a colour and a material of its own.
"""

from collections.abc import Iterable, Mapping, Sequence

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.marking import Marking
from core.guidance.builtin.markings.table import MARKINGS


class Marked:
    """The markings of one object: what turns the distances of its parts without them to those with
    them."""

    def __init__(
        self, noun: str, names: Sequence[str], boxes: Sequence[Float[Tensor, "2 3"] | None]
    ) -> None:
        """
        Args:
            names: of the noun's parts; "" of those that the object is without.
            boxes: of each the lowest and the highest corner; None of what has no solid.
        """
        self.laid: list[tuple[int, int, Marking, Float[Tensor, "2 3"]]] = []
        for name, one in sorted(_of(noun), key=lambda one: _depth(noun, one[0])):
            bearer = bearer_of(noun, name)
            by = one.by or bearer
            if {name, one.on, bearer, by} <= set(names):
                box = boxes[names.index(by)]
                if box is not None:
                    self.laid.append((names.index(name), names.index(one.on), one, box))

    def __call__(
        self, distances: Float[Tensor, "n p"], points: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n p"]:
        """The parts' distances with the markings among them."""
        found = distances.clone()
        right = torch.cat([points[:, :1].abs(), points[:, 1:]], 1)
        for part, on, one, box in self.laid:
            low, high = box.to(points)
            middle = (low + high) / 2
            if one.paired:
                middle = torch.cat([middle[:1].abs(), middle[1:]])
            margin = one.marks((right if one.paired else points) - middle, (high - low) / 2)
            lies = found[:, on].clone()
            found[:, part] = torch.maximum(lies, -margin)
            found[:, on] = torch.maximum(lies, margin)
        return found


def bearer_of(noun: str, part: str) -> str:
    """The part with a solid that bears a marking: of a pupil the white."""
    while is_marking(noun, part):
        part = MARKINGS[noun][part].on
    return part


def unfit_markings(noun: str, materials: Mapping[str, str]) -> set[str]:
    """Those that are of another material than a prompt states of their part: ``materials``, ""
    by nature. An iron chest has no planks."""
    named = ((name, one.of, materials[bearer_of(noun, name)]) for name, one in _of(noun))
    return {name for name, own, stated in named if own and stated not in ("", own)}


def _of(noun: str) -> Iterable[tuple[str, Marking]]:
    return MARKINGS.get(noun, {}).items()


def _depth(noun: str, part: str) -> int:
    """How many parts lie below a marking: what bears others comes first."""
    on = MARKINGS[noun][part].on
    return 1 + _depth(noun, on) if is_marking(noun, on) else 1


def is_marking(noun: str, part: str) -> bool:
    """Whether the part has no solid of its own."""
    return part in MARKINGS.get(noun, {})


def has_markings(noun: str) -> bool:
    """Whether any part of the noun has no solid of its own."""
    return noun in MARKINGS
