"""Things of music, film, sewing and games, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

STAGE_AND_STUDIO: dict[str, Noun] = {}
