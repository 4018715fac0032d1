"""How flat and how round the parts of each noun are, and how small their components: a table from
the families (core.prior)."""

import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

from core.guidance.builtin.nouns import CONSTRUCTED, NOUNS

ROUND = 0.8  # of a part's surface
TABLE = Path(__file__).with_suffix(".json")
# Parts with so many corners that the network's errors make them look round.
CORNERED = {"stop sign": ("plate", "rim")}
# Parts that are curved both ways: flat outlines one upon another are near them.
CURVED = {"canoe": ("hull",)}


class PartForms(NamedTuple):
    """The forms of a noun's parts."""

    flat: tuple[float, ...]  # fraction of its surface
    # And the fraction that is the same all around an axis of its component, along x, y, z: each
    # wheel of a car is a component.
    round: tuple[tuple[float, ...], ...]
    # The area of its smallest component, as a fraction of its largest one's.
    least: tuple[float, ...]


def is_round(noun: str) -> bool:
    """Whether the first part is round by itself, around the vertical or as a clock is."""
    _, *around = part_forms_table()[noun].round
    return max(axis[0] for axis in around) >= ROUND


def is_solid(noun: str, part: str) -> bool:
    """Whether a part has a solid of its own; others are markings."""
    least, names = part_forms_table()[noun].least, list(NOUNS[noun].looks)
    index = names.index(part)
    return index < len(least) and least[index] > 0


@cache
def part_forms_table() -> dict[str, PartForms]:
    """The forms by noun."""
    rows = json.loads(TABLE.read_text("utf-8"))
    known = {
        noun: PartForms(tuple(r["flat"]), tuple(map(tuple, r["round"])), tuple(r["least"]))
        for noun, r in rows.items()
    }
    known |= {noun: known[row.solid] for noun, row in NOUNS.items() if row.solid}
    # Of what is put together from simple solids nothing has to be known.
    nothing = (0.0,) * len(known["cube"].flat)
    for noun, row in CONSTRUCTED.items():
        if noun in known:
            continue
        least = (1.0,) * len(row.looks)
        known[noun] = PartForms(nothing, (nothing,) * 3, (*least, *nothing[len(least) :]))
    return known
