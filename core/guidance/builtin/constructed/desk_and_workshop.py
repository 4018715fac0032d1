"""Things of a desk, a laboratory and a workshop."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

DESK_AND_WORKSHOP: dict[str, Callable[[Draw], Parts]] = {}
