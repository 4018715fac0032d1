"""Things of the garden, of smoking, pets and leisure."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

GARDEN_AND_LEISURE: dict[str, Callable[[Draw], Parts]] = {}
