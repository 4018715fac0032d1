"""Things of a home and a kitchen."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

HOME_AND_KITCHEN: dict[str, Callable[[Draw], Parts]] = {}
