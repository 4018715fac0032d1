"""Things of a home and a kitchen, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

BUILT_HOME_AND_KITCHEN: dict[str, Noun] = {}
