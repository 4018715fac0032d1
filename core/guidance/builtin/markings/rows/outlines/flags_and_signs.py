"""Outlines and spans of the markings of flags and signs."""

from functools import partial

from core.guidance.builtin.markings.forms.bands import bands

LEFT, RIGHT = (partial(bands, axis=0, low=a, high=b) for a, b in ((-2, -1 / 3), (1 / 3, 2)))
TOP, BOTTOM = (partial(bands, axis=2, low=a, high=b) for a, b in ((1 / 3, 2), (-2, -1 / 3)))
LOWER = partial(bands, axis=2, low=-2, high=0)
