"""Machines, vehicles and engines of war."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts

MACHINES_AND_VEHICLES: dict[str, Callable[[Draw], Parts]] = {}
