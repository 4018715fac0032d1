"""Charms, games, weapons and things of the sky, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

BUILT_CHARMS_AND_GAMES: dict[str, Noun] = {}
