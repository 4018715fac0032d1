"""Materials that the networks know by a wider word, as data.

The network gets the wider word (``words.MATERIALS``). The texture then gets the kind's own detail,
and without a stated colour its own colour; roughness too.
"""

from typing import NamedTuple

from core.guidance.builtin.words.tables.colors import OF_MATERIALS, Color


class Variant(NamedTuple):
    """A narrower material: its detail's kind, and what differs from the wider word's finish."""

    kind: str
    color: Color | None = None  # sRGB
    roughness: float | None = None
    clear: float = 0.0  # transmitted fraction of the light
    glow: float = 0.0  # emitted fraction of the colour


ALL_CLEAR = 1.0  # one looks through it at what is inside

_ROWS: dict[str, Variant] = {  # forms of a material: their variant
    # of wooden
    "oak, oak wood": Variant("wooden", (0.66, 0.48, 0.29)),
    "walnut, walnut wood": Variant("wooden", (0.36, 0.22, 0.13)),
    "mahogany": Variant("wooden", (0.42, 0.17, 0.10), 0.4),
    "bamboo": Variant("wooden", (0.80, 0.67, 0.42), 0.45),
    "wicker": Variant("wicker", (0.62, 0.46, 0.27), 0.8),
    "rattan": Variant("wicker", (0.68, 0.52, 0.32), 0.75),
    "pine, pinewood": Variant("wooden", (0.80, 0.62, 0.40)),
    "spruce": Variant("wooden", (0.84, 0.69, 0.47)),
    "birch": Variant("wooden", (0.86, 0.76, 0.58)),
    "maple": Variant("wooden", (0.82, 0.64, 0.42)),
    "cherry wood, cherrywood": Variant("wooden", (0.58, 0.29, 0.17), 0.4),
    "rosewood": Variant("wooden", (0.33, 0.14, 0.10), 0.35),
    "ebony": Variant("wooden", (0.13, 0.10, 0.09), 0.3),
    "teak": Variant("wooden", (0.55, 0.36, 0.20), 0.5),
    "cedar": Variant("wooden", (0.62, 0.36, 0.23)),
    "beech, beechwood": Variant("wooden", (0.78, 0.58, 0.40)),
    "ash wood, light ash, pale ash, solid ash": Variant("wooden", (0.84, 0.74, 0.58)),
    "hickory": Variant("wooden", (0.72, 0.54, 0.36)),
    "seagrass": Variant("wicker", (0.70, 0.60, 0.40), 0.85),
    "plywood": Variant("wooden", (0.80, 0.65, 0.45), 0.65),
    "driftwood": Variant("wooden", (0.60, 0.55, 0.48), 0.85),
    "reclaimed wood": Variant("wooden", (0.45, 0.34, 0.24), 0.8),
    "dark wood": Variant("wooden", (0.27, 0.16, 0.10), 0.5),
    "light wood": Variant("wooden", (0.80, 0.64, 0.44)),
    "pale wood": Variant("wooden", (0.84, 0.72, 0.54)),
    "white wood": Variant("wooden", (0.88, 0.84, 0.76)),
    "lacquered wood": Variant("wooden", (0.40, 0.18, 0.10), 0.12),
    "straw": Variant("wicker", (0.85, 0.71, 0.38), 0.85),
    "thatch, thatched": Variant("thatch", (0.70, 0.56, 0.32), 0.95),
    # of metal
    "stainless steel, stainless": Variant("brushed metal", (0.78, 0.79, 0.80), 0.28),
    "galvanized, galvanised, galvanized steel, galvanised steel": Variant(
        "metal", (0.66, 0.69, 0.71), 0.45
    ),
    "tin": Variant("metal", (0.74, 0.74, 0.73), 0.35),
    "zinc": Variant("metal", (0.68, 0.70, 0.72), 0.4),
    "pewter": Variant("metal", (0.56, 0.56, 0.56), 0.4),
    "titanium": Variant("brushed metal", (0.62, 0.60, 0.58), 0.35),
    "nickel": Variant("polished metal", (0.72, 0.69, 0.63), 0.18),
    "platinum": Variant("polished metal", (0.82, 0.81, 0.79), 0.12),
    "sterling silver": Variant("metal", (0.86, 0.85, 0.82), 0.2),
    "wrought iron": Variant("cast iron", (0.20, 0.20, 0.21), 0.65),
    "gunmetal": Variant("metal", (0.24, 0.26, 0.29), 0.4),
    "dark metal": Variant("metal", (0.24, 0.25, 0.27), 0.4),
    "black metal": Variant("metal", (0.12, 0.12, 0.13), 0.45),
    "chromed, chrome plated, chrome": Variant("polished metal", (0.78, 0.79, 0.80), 0.06),
    "brushed metal, brushed steel": Variant("brushed metal", None, 0.38),
    "iridescent, holographic": Variant("iridescent", (0.66, 0.66, 0.68), 0.16),
    "brushed aluminium, brushed aluminum": Variant("brushed metal", (0.80, 0.81, 0.82), 0.4),
    "polished metal, polished steel": Variant("polished metal", None, 0.1),
    "shiny metal": Variant("polished metal", None, 0.12),
    "silver": Variant("polished metal", (0.86, 0.85, 0.82), 0.2),
    "iron": Variant("cast iron", (0.42, 0.41, 0.41), 0.5),
    "cast iron": Variant("cast iron", (0.25, 0.25, 0.26), 0.6),
    # of golden
    "gold leaf, gold foil, gilded": Variant("gold leaf", None, 0.3),
    "brass": Variant("metal", (0.88, 0.74, 0.42), 0.3),
    "polished brass": Variant("polished metal", (0.88, 0.74, 0.42), 0.12),
    "rose gold": Variant("golden", (0.90, 0.62, 0.52), 0.2),
    "white gold": Variant("golden", (0.88, 0.86, 0.80), 0.15),
    # of stone
    "white marble": Variant("marble", (0.92, 0.91, 0.89), 0.16),
    "black marble": Variant("marble", (0.10, 0.10, 0.11), 0.12),
    "green marble": Variant("marble", (0.16, 0.34, 0.26), 0.14),
    "limestone": Variant("concrete", (0.80, 0.75, 0.65), 0.85),
    "travertine": Variant("marble", (0.80, 0.72, 0.60), 0.45),
    "cobblestone": Variant("masonry", (0.46, 0.45, 0.44), 0.9),
    "alabaster": Variant("marble", (0.93, 0.89, 0.82), 0.3),
    "onyx": Variant("marble", (0.06, 0.06, 0.07), 0.08),
    "obsidian": Variant("glass", (0.04, 0.04, 0.05), 0.06),
    "jade": Variant("marble", (0.30, 0.56, 0.40), 0.2),
    "malachite": Variant("marble", (0.05, 0.42, 0.29), 0.2),
    "lapis lazuli": Variant("granite", (0.10, 0.18, 0.52), 0.25),
    "quartz": Variant("marble", (0.90, 0.86, 0.86), 0.12),
    "basalt": Variant("granite", (0.22, 0.22, 0.23), 0.75),
    "plaster": Variant("concrete", (0.90, 0.88, 0.84), 0.95),
    "stucco": Variant("concrete", (0.84, 0.78, 0.68), 0.95),
    # of plastic
    "carbon fiber, carbon fibre": Variant("denim", (0.07, 0.07, 0.08), 0.25),
    "fiberglass, fibreglass": Variant("paint", None, 0.2),
    "bakelite": Variant("plastic", (0.16, 0.10, 0.07), 0.2),
    "tortoiseshell": Variant("marble", (0.36, 0.19, 0.08), 0.15),
    "chocolate": Variant("cream", (0.24, 0.12, 0.06), 0.35),
    "dark chocolate": Variant("cream", (0.13, 0.07, 0.04), 0.3),
    "white chocolate": Variant("cream", (0.93, 0.87, 0.72), 0.35),
    "wax": Variant("cream", (0.92, 0.86, 0.72), 0.45),
    "plasticine, claymation, modelling clay, modeling clay, play doh, playdoh, play dough": (
        Variant("plasticine", None, 0.5)
    ),
    "made of candy": Variant("candy", (0.84, 0.07, 0.16), 0.1),
    "pearlescent, pearly, nacreous, opalescent": Variant("pearl", (0.90, 0.87, 0.86), 0.15),
    # of rubber
    "latex": Variant("rubber", None, 0.35),
    "silicone": Variant("rubber", None, 0.6),
    # of stone
    "marble": Variant("marble", (0.90, 0.89, 0.87), 0.16),
    "granite": Variant("granite", (0.52, 0.50, 0.49), 0.35),
    "concrete": Variant("concrete", (0.60, 0.59, 0.57), 0.9),
    # of rubber
    "brick": Variant("brick", (0.58, 0.30, 0.22), 0.9),
    "sandstone": Variant("concrete", (0.76, 0.62, 0.43), 0.9),
    "slate": Variant("stone", (0.29, 0.31, 0.34), 0.7),
    "made of snow, packed snow": Variant("snow", (0.93, 0.95, 0.98), 0.85),
    "made of sand": Variant("sand", (0.80, 0.67, 0.46), 0.95),
    "made of lava": Variant("lava", (1.0, 0.34, 0.03), 0.85, glow=1.0),
    # of ceramic
    "clay": Variant("clay", (0.72, 0.42, 0.29), 0.85),
    "terracotta, terra cotta": Variant("clay", (0.72, 0.38, 0.25), 0.85),
    "earthenware": Variant("clay", (0.62, 0.40, 0.28), 0.7),
    "stoneware": Variant("clay", (0.66, 0.60, 0.52), 0.5),
    "enamel, enameled, enamelled": Variant("paint", None, 0.12),
    "mother of pearl": Variant("marble", (0.92, 0.89, 0.87), 0.12),
    "of bone, of bones, made of bone, made of bones, from bone": Variant(
        "bone", (0.89, 0.84, 0.73), 0.45
    ),
    # of stone
    "glass": Variant("glass", (0.96, 0.98, 0.98), 0.03, 0.95),
    # of glass: the colour is that of a wall
    "clear glass": Variant("glass", (0.97, 0.985, 0.985), 0.03, ALL_CLEAR),
    "glassy, glass like, crystal glass, crystalline, of crystal": Variant(
        "glass", (0.96, 0.98, 0.98), 0.03, 0.95
    ),
    "transparent, see through, see thru, crystal clear, perspex, plexiglass, plexiglas": (
        Variant("glass", (0.96, 0.98, 0.98), 0.03, 0.95)
    ),
    "translucent": Variant("glass", (0.96, 0.98, 0.98), 0.4, 0.85),
    "frosted glass": Variant("glass", (0.96, 0.98, 0.98), 0.5, 0.85),
    "tinted glass, smoked glass, smoky glass": Variant("glass", (0.20, 0.26, 0.26), 0.06, 0.9),
    "stained glass": Variant("glass", None, 0.08, 0.7),
    "of ice, made of ice, from ice, icy": Variant("glass", (0.80, 0.92, 0.97), 0.15, 0.6),
    "made of jelly, gummy candy": Variant("glass", (0.86, 0.10, 0.14), 0.12, 0.6),
    # of copper
    "bronze": Variant("copper", (0.66, 0.47, 0.27), 0.35),
    "polished copper": Variant("polished metal", None, 0.12),
    # of fabric
    "felt, wool, woollen, woolen, plush, fleece, cashmere": Variant("felt"),
    "velvet": Variant("velvet"),
    "sequined, sequinned, sequin": Variant("sequins"),
    "made of moss": Variant("soil", (0.27, 0.38, 0.11), 0.95),
    "fur, furry, fluffy": Variant("fur"),
    "sheepskin": Variant("fur", (0.90, 0.86, 0.77)),
    "linen": Variant("fabric", (0.80, 0.74, 0.63)),
    "burlap": Variant("wicker", (0.66, 0.53, 0.35), 0.95),
    "jute": Variant("wicker", (0.68, 0.55, 0.36), 0.95),
    "tweed": Variant("fabric", (0.45, 0.40, 0.33)),
    "corduroy": Variant("denim"),
    "silk": Variant("velvet", None, 0.35),
    "paper": Variant("paper", (0.93, 0.91, 0.86), 0.85),
    "papier mache, paper mache": Variant("paper", (0.86, 0.83, 0.76), 0.9),
    "cardboard": Variant("paper", (0.70, 0.53, 0.35), 0.9),
    # of plastic
    "denim": Variant("denim", (0.20, 0.29, 0.45)),
    # of leather
    "patent leather": Variant("leather", None, 0.12),
    "snakeskin": Variant("scales", (0.45, 0.38, 0.26), 0.35),
    "suede": Variant("velvet", (0.55, 0.38, 0.24), 0.85),
}
VARIANTS = {form: row for forms, row in _ROWS.items() for form in forms.split(", ")}


def split_tone(form: str) -> tuple[str, str]:
    """The tone before a material and the rest, such as of light oak; "" without a tone."""
    tone, _, rest = form.partition(" ")
    return (tone, rest) if tone in OF_MATERIALS and form not in VARIANTS else ("", form)


def has_own_look(form: str) -> bool:
    """Whether a material as written looks different from its wider word."""
    tone, rest = split_tone(form)
    return bool(tone) or rest in VARIANTS


# Things built of stones, not carved from one.
BUILDINGS = (
    *("house", "cottage", "tower", "lighthouse", "church", "arch"),
    *("bridge", "windmill", "castle", "pyramid", "pagoda", "temple", "wall"),
)
