"""Things of the laboratory, the desk and the workshop, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

LABORATORY_AND_WORKSHOP: dict[str, Noun] = {}
