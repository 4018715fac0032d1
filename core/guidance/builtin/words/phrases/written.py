"""What is to be written or drawn on a thing: other readings of a prompt leave it as it is.

Standard library only.
"""

import re
from collections.abc import Callable

from core.guidance.builtin.words.phrases.emblems import drawn_in

_QUOTED = re.compile('["“][^"“”]*["”]')


def written_in(prompt: str) -> list[tuple[int, int]]:
    """The places of texts, and of all that is between quotes, from the first on; of two that
    overlap the first."""
    spans = [(start, end) for _, start, end in drawn_in(prompt)]
    spans += [match.span() for match in _QUOTED.finditer(prompt)]
    found: list[tuple[int, int]] = []
    for start, end in sorted(spans):
        if not found or start >= found[-1][1]:
            found.append((start, end))
    return found


def without_texts(prompt: str) -> str:
    """The prompt with blanks in their places."""
    for start, end in written_in(prompt):
        prompt = prompt[:start] + " " * (end - start) + prompt[end:]
    return prompt


def apart_from_texts(prompt: str, change: Callable[[str], str]) -> str:
    """The prompt with ``change``, but for them."""
    at, pieces = 0, []
    for start, end in written_in(prompt):
        pieces += [change(prompt[at:start]), prompt[start:end]]
        at = end
    return "".join([*pieces, change(prompt[at:])])
