"""The usual size of a thing and its density, by its noun and its material."""

from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.nouns.noun import (
    CERAMIC,
    COPPER,
    FABRIC,
    GLASS,
    GOLD,
    LEATHER,
    PLASTIC,
    RUBBER,
    STEEL,
    STONE,
    WOOD,
    Usual,
)

DENSITIES = {  # kg/m³, of the prior's materials
    "wooden": WOOD,
    "metal": STEEL,
    "golden": GOLD,
    "plastic": PLASTIC,
    "rubber": RUBBER,
    "stone": STONE,
    "rusty": STEEL,
    "ceramic": CERAMIC,
    "leather": LEATHER,
    "glass": GLASS,
    "copper": COPPER,
    "fabric": FABRIC,  # with its padding
}
TOY_SIZE = 0.25  # metres
UNKNOWN = Usual(1.0, 400.0)  # where the prompt names no known thing: 1 m, light wood


def usual(
    noun: str, material: str = "", toy: bool = False, kind_size: float = 0.0
) -> tuple[float, float]:
    """The size in metres and the density in kg/m³, averaged over the volume, of a thing of
    ``material``; "": the usual one. A toy is no longer than a forearm.

    kind_size: that of the kind, where it has its own; else 0.
    """
    size, own, filled = NOUNS[noun].usual if noun in NOUNS else UNKNOWN
    size = kind_size or size
    size = min(size, TOY_SIZE) if toy else size
    return size, round(DENSITIES.get(material, own) * filled, 3)
