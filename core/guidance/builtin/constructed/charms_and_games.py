"""Charms, games, weapons and things of the sky."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

CHARMS_AND_GAMES: dict[str, Callable[[Draw], Parts]] = {}
