"""Things of the garden, of smoking, pets and leisure, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

GARDEN_AND_LEISURE: dict[str, Noun] = {}
