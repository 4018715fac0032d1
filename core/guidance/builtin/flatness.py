"""How flat the parts of each noun are: a table that the families were asked for (core.prior)."""

import json
from functools import cache
from pathlib import Path

TABLE = Path(__file__).with_name("flatness.json")


@cache
def flatness_table() -> dict[str, tuple[float, ...]]:
    """By noun: the flat fraction of each part's surface."""
    return {noun: tuple(row) for noun, row in json.loads(TABLE.read_text("utf-8")).items()}
