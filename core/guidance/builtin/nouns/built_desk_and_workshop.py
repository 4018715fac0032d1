"""Things of a desk, a laboratory and a workshop, put together from simple solids."""

from core.guidance.builtin.nouns.noun import Noun

BUILT_DESK_AND_WORKSHOP: dict[str, Noun] = {}
