"""How flat and how round the parts of each noun are, and how small their pieces: a table of the
families (core.prior)."""

import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

from core.guidance.builtin.nouns import NOUNS

ROUND = 0.8  # of a part's surface
TABLE = Path(__file__).with_suffix(".json")
# Parts of corners that are too many for the network's errors to tell them from round.
CORNERED = {"stop sign": ("plate", "rim")}


class PartForms(NamedTuple):
    """Of each part of a noun."""

    flat: tuple[float, ...]  # fraction of its surface
    # And what is the same all around an axis of its piece, along x, y, z: of a car's wheels each is
    # a piece.
    round: tuple[tuple[float, ...], ...]
    # The area of its least piece, as a fraction of its largest one's.
    least: tuple[float, ...]


def is_round(noun: str) -> bool:
    """Whether the first of its parts is round anyway, about the vertical or as a clock is."""
    _, *around = part_forms_table()[noun].round
    return max(axis[0] for axis in around) >= ROUND


@cache
def part_forms_table() -> dict[str, PartForms]:
    """By noun."""
    rows = json.loads(TABLE.read_text("utf-8"))
    known = {
        noun: PartForms(tuple(r["flat"]), tuple(map(tuple, r["round"])), tuple(r["least"]))
        for noun, r in rows.items()
    }
    return known | {noun: known[row.solid] for noun, row in NOUNS.items() if row.solid}
