"""Things of the kitchen, the bath and the household."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

COOKING_AND_BATH: dict[str, Callable[[Draw], Parts]] = {}
