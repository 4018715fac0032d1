"""Drawn things and compositions that several tests look at, each made once."""

from dataclasses import replace
from functools import cache

import torch

from core.guidance.builtin.composition.composed import Composed
from core.guidance.builtin.composition.placing.copies import copies_of
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.guidance import BuiltinGuidance, load_builtin
from core.guidance.builtin.words.phrases.slots import Words


@cache
def shipped_prior() -> BuiltinGuidance:
    """The shipped prior: a second of a CPU to load."""
    return load_builtin("cpu")


@cache
def body(prompt: str) -> Body:
    drawn = shipped_prior().prompted(prompt, "").of_object(0)
    assert drawn.solid is not None
    return Body.of(drawn.words, drawn.solid)


@cache
def composed(prompt: str) -> Composed:
    found = shipped_prior().prompted(prompt, "").of_object(0)
    assert isinstance(found, Composed) and found.made
    return found


def box(low, high, noun="crate") -> Body:
    """A box's surface as a thing."""
    low, high = torch.tensor(low), torch.tensor(high)
    corners = torch.tensor([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    faces = "013 032 467 475 045 051 237 276 026 064 157 173".split()
    faces = torch.tensor([[int(corner) for corner in face] for face in faces])
    verts = low + corners * (high - low)
    return Body(Words(noun=noun), verts.float(), faces, torch.zeros(8, dtype=torch.long))


def centered(thing: Body) -> torch.Tensor:
    return thing.box.mean(0)


def several(prompt: str, count: int, order: str) -> tuple[Body, list[Placement], Body]:
    one = replace(body(prompt), words=replace(body(prompt).words, count=count, order=order))
    copies = copies_of(one)
    return one, copies, one.group(copies)
