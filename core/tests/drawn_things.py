"""Drawn things and compositions that several tests look at, each made once."""

from dataclasses import replace
from functools import cache

import torch

from core.guidance.builtin.composition.composed import Composed
from core.guidance.builtin.composition.copies import copies_of
from core.guidance.builtin.composition.placement import Body, Placement
from core.guidance.builtin.guidance import BuiltinGuidance, load_builtin


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


def centered(thing: Body) -> torch.Tensor:
    return thing.box.mean(0)


def several(prompt: str, count: int, order: str) -> tuple[Body, list[Placement], Body]:
    one = replace(body(prompt), words=replace(body(prompt).words, count=count, order=order))
    copies = copies_of(one)
    return one, copies, one.group(copies)
