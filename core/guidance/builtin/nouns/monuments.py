"""Monuments and large structures, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

MONUMENTS: dict[str, Noun] = {}
