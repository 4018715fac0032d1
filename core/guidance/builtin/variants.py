"""Materials that the networks know by a wider word, as data.

The network is asked for the wider word (``words.MATERIALS``). The texture then gets the kind's own
detail, and, where no colour is stated, its own colour; roughness too.
"""

from typing import NamedTuple

Color = tuple[float, float, float]


class Variant(NamedTuple):
    """A narrower material: its detail's kind, and what differs from the wider word's finish."""

    kind: str
    color: Color | None = None  # sRGB
    roughness: float | None = None
    clear: float = 0.0  # how much of the light goes through it


VARIANTS: dict[str, Variant] = {
    # of wooden
    "oak": Variant("wooden", (0.66, 0.48, 0.29)),
    "walnut": Variant("wooden", (0.36, 0.22, 0.13)),
    "mahogany": Variant("wooden", (0.42, 0.17, 0.10), 0.4),
    "bamboo": Variant("wooden", (0.80, 0.67, 0.42), 0.45),
    "wicker": Variant("wicker", (0.62, 0.46, 0.27), 0.8),
    "rattan": Variant("wicker", (0.68, 0.52, 0.32), 0.75),
    # of metal
    "brushed metal": Variant("brushed metal", None, 0.38),
    "brushed steel": Variant("brushed metal", None, 0.38),
    "brushed aluminium": Variant("brushed metal", (0.80, 0.81, 0.82), 0.4),
    "brushed aluminum": Variant("brushed metal", (0.80, 0.81, 0.82), 0.4),
    "polished metal": Variant("polished metal", None, 0.1),
    "shiny metal": Variant("polished metal", None, 0.12),
    "polished steel": Variant("polished metal", None, 0.1),
    "polished": Variant("polished metal", None, 0.12),
    "chrome": Variant("polished metal", (0.78, 0.79, 0.80), 0.06),
    "silver": Variant("polished metal", (0.86, 0.85, 0.82), 0.2),
    "iron": Variant("cast iron", (0.42, 0.41, 0.41), 0.5),
    "cast iron": Variant("cast iron", (0.25, 0.25, 0.26), 0.6),
    # of golden
    "gold leaf": Variant("gold leaf", None, 0.3),
    "gilded": Variant("gold leaf", None, 0.3),
    "brass": Variant("metal", (0.88, 0.74, 0.42), 0.3),
    "polished brass": Variant("polished metal", (0.88, 0.74, 0.42), 0.12),
    # of stone
    "marble": Variant("marble", (0.90, 0.89, 0.87), 0.16),
    "granite": Variant("granite", (0.52, 0.50, 0.49), 0.35),
    "concrete": Variant("concrete", (0.60, 0.59, 0.57), 0.9),
    "brick": Variant("brick", (0.58, 0.30, 0.22), 0.9),
    "sandstone": Variant("concrete", (0.76, 0.62, 0.43), 0.9),
    "slate": Variant("stone", (0.29, 0.31, 0.34), 0.7),
    # of ceramic
    "clay": Variant("clay", (0.72, 0.42, 0.29), 0.85),
    "terracotta": Variant("clay", (0.72, 0.38, 0.25), 0.85),
    # of copper
    "bronze": Variant("copper", (0.66, 0.47, 0.27), 0.35),
    "polished copper": Variant("polished metal", None, 0.12),
    # of fabric
    "felt": Variant("felt"),
    "wool": Variant("felt"),
    "woollen": Variant("felt"),
    "woolen": Variant("felt"),
    "velvet": Variant("velvet"),
    "plush": Variant("felt"),
    "fur": Variant("fur"),
    "furry": Variant("fur"),
    "fluffy": Variant("fur"),
    "denim": Variant("denim", (0.20, 0.29, 0.45)),
    # of leather
    "suede": Variant("velvet", (0.55, 0.38, 0.24), 0.85),
}

# Of glass; "glossy" is the only form of it that is opaque. The colour is that of a wall.
_CLEAR = Variant("glass", (0.96, 0.98, 0.98), 0.03, 0.95)
VARIANTS |= dict.fromkeys(("glass", "glassy", "glass like", "crystal glass", "crystalline"), _CLEAR)

# Things that are built of stones, not carved from one.
BUILDINGS = (
    *("house", "cottage", "tower", "lighthouse", "church", "arch"),
    *("bridge", "windmill", "castle", "pyramid", "pagoda", "temple", "wall"),
)
