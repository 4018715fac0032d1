"""The bodywork of vehicles: how round a body's edges are, and which wheels it has wells around."""

from collections.abc import Sequence

from core.geometry.parts.bodywork import Bodywork
from core.guidance.builtin.nouns import solid_of

# Of each thing the parts with rounded edges, and their radius, training units.
ROUNDED: dict[str, dict[str, float]] = {
    "ambulance": {"body": 0.05},
    "bus": {"body": 0.05},
    "camper": {"body": 0.04},
    "car": {"body": 0.045},
    "cement mixer": {"cab": 0.04},
    "double decker bus": {"body": 0.04},
    "fire truck": {"body": 0.04},
    "garbage truck": {"cab": 0.05},
    "jeep": {"body": 0.025, "roof": 0.035},
    "limousine": {"body": 0.03},
    "monster truck": {"body": 0.03},
    "pickup truck": {"body": 0.03},
    "sports car": {"body": 0.04},
    "taxi": {"body": 0.045},
    "train": {"cab": 0.03},
    "tram": {"body": 0.05},
    "truck": {"cab": 0.06, "cargo": 0.02},
    "van": {"body": 0.05},
}
LEANING = ("car", "pickup truck", "sports car", "taxi")  # these have a cabin


def bodywork_of(noun: str, names: Sequence[str]) -> dict[int, Bodywork]:
    """By the index of the part in ``names``, the noun's parts in order."""
    wheels = names.index("wheels") if "wheels" in names else None
    rows = ROUNDED.get(noun, ROUNDED.get(solid_of(noun), {}))
    leans = solid_of(noun) in LEANING
    return {
        index: Bodywork(rows[name], wheels, leans)
        for index, name in enumerate(names)
        if name in rows
    }
