"""A part that is on another one as paint is."""

from typing import NamedTuple

from core.guidance.builtin.markings.margins import Marks


class Marking(NamedTuple):
    """The place and the form of a marking."""

    on: str  # the part with the solid, or another marking on that part
    marks: Marks
    of: str = ""  # where a prompt names a material: the only one with this marking
    by: str = ""  # the part whose box places it; "": the one with the solid
    paired: bool = False  # mirrored at x = 0, as the part that it is on
    every: bool = False  # on each of the part's components, by its own box: a hub on every wheel


Rows = dict[str, dict[str, Marking]]  # by noun and part; the uppermost comes first
