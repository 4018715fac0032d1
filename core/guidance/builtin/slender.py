"""Parts that are thinner than the solids' network can draw them: nothing of what it draws is
thinner than a tenth of the object's radius."""

from collections.abc import Sequence

from core.guidance.builtin.nouns import NOUNS

# How many times as thick as it is drawn a part is.
SLENDER: dict[str, dict[str, float]] = {
    "bicycle": {"frame": 0.55, "handlebar": 0.5, "wheels": 0.6},
    "birdcage": {"bars": 0.45, "hoops": 0.6, "ring": 0.6, "perch": 0.5},
    "bow": {"limbs": 0.7, "string": 0.25, "arrow": 0.5},
    "bucket": {"handle": 0.3},
    "chandelier": {"arms": 0.5, "cups": 0.7},
    "desk lamp": {"base": 0.5, "arms": 0.5, "joints": 0.7},
    "fishing rod": {"rod": 0.6, "line": 0.2},
    "kettle": {"handle": 0.6},
    "ladder": {"rails": 0.6, "rungs": 0.5},
    "sunglasses": {"frame": 0.5, "glasses": 0.3, "arms": 0.4},
    "swing": {"frame": 0.6, "ropes": 0.3, "seats": 0.5},
    "umbrella": {"stick": 0.4, "handle": 0.5},
}


def slender_parts(noun: str, parts: Sequence[str]) -> list[float]:
    """For each of the noun's parts how many times as thick as it is drawn it is; what has another
    thing's solid is as that one where it has no row of its own."""
    own = SLENDER.get(noun)
    if own is None and NOUNS[noun].solid:
        other = NOUNS[NOUNS[noun].solid]
        return slender_parts(NOUNS[noun].solid, list(other.looks))[: len(parts)]
    return [(own or {}).get(part, 1.0) for part in parts]
