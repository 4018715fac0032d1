"""Things of the laboratory, the desk and the workshop."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

LABORATORY_AND_WORKSHOP: dict[str, Callable[[Draw], Parts]] = {}
