"""Building sites, playgrounds and places, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

BUILT_SITES: dict[str, Noun] = {}
