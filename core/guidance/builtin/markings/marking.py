"""A part that lies on another as paint does."""

from typing import NamedTuple

from core.guidance.builtin.markings.margins import Marks


class Marking(NamedTuple):
    """Where a part lies."""

    on: str  # the part that bears it, or another marking that lies on that
    marks: Marks
    of: str = ""  # the only material that is so marked, where a prompt names one: a plank's seams
    by: str = ""  # the part by whose box it is placed; "": what bears it
    paired: bool = False  # what bears it is alike on both sides of x = 0, and so is it


Rows = dict[str, dict[str, Marking]]  # by noun and part; what lies on top comes first
