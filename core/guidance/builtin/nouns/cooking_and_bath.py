"""Things of the kitchen, the bath and the household, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

COOKING_AND_BATH: dict[str, Noun] = {}
