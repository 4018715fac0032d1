"""Engines of war, vehicles and old crafts, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

ENGINES_AND_CRAFTS: dict[str, Noun] = {}
