"""Building sites, playgrounds and places."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

SITES: dict[str, Callable[[Draw], Parts]] = {}
