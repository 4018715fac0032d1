"""Things of music, film, sewing and games."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

STAGE_AND_STUDIO: dict[str, Callable[[Draw], Parts]] = {}
