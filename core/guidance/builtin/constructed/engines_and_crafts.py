"""Engines of war, vehicles and old crafts."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

ENGINES_AND_CRAFTS: dict[str, Callable[[Draw], Parts]] = {}
