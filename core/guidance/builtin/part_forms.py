"""How flat and how round the parts of each noun are: a table of the families (core.prior)."""

import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

TABLE = Path(__file__).with_suffix(".json")


class PartForms(NamedTuple):
    """Of each part of a noun, fractions of its surface."""

    flat: tuple[float, ...]
    round: tuple[float, ...]  # the same all around an upright axis


@cache
def part_forms_table() -> dict[str, PartForms]:
    """By noun."""
    rows = json.loads(TABLE.read_text("utf-8"))
    return {noun: PartForms(tuple(r["flat"]), tuple(r["round"])) for noun, r in rows.items()}
