"""Monuments and large structures."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

MONUMENTS: dict[str, Callable[[Draw], Parts]] = {}
