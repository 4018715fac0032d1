"""Machines, vehicles and engines of war, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

BUILT_MACHINES_AND_VEHICLES: dict[str, Noun] = {}
