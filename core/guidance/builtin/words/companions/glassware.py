"""Closed vessels of clear glass, and what is in them, as data.

Standard library only.
"""

from collections.abc import Iterable
from dataclasses import replace

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.grammar.accents import Accent
from core.guidance.builtin.words.grammar.openers import Relation
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.living import is_creature

# The part that is of glass, and parts that it goes without where something is inside.
VESSELS: dict[str, tuple[str, tuple[str, ...]]] = {
    "jar": ("body", ("label",)),
    "bottle": ("body", ("label", "bands", "badge")),
    "flask": ("glass", ("liquid", "marks")),
    "potion": ("flask", ()),
    "snow globe": ("glass", ("firs", "plaque")),
    "crystal ball": ("ball", ("claws", "glints")),
    "light bulb": ("bulb", ()),
    "glass dome": ("glass", ()),
    "aquarium": ("water", ("fish", "plants", "lid")),
}
PICKLED = frozenset(("cucumber", "seashell", "acorn", "boulder"))  # these lie in a heap too
# These float or fly.
FLOATING = frozenset(
    """brain eyeball jellyfish fish clownfish koi shark octopus squid seahorse whale dolphin bee
    butterfly dragonfly ghost cloud heart planet earth star sun bat snowflake""".split()
) | {"full moon", "sea turtle"}
EDIBLE = frozenset(GROUPS["Food"]) | frozenset(GROUPS["Fruit and Vegetables"]) | PICKLED
UPRIGHT = ("Plants", "Buildings", "Furniture")
BOATS = frozenset(
    """boat sailboat canoe rowboat speedboat longship yacht raft submarine""".split()
) | {"pirate ship", "cargo ship", "cruise ship"}
PRINTED = ("bottle", "potion")  # "with stars": these are on it
NOT_IN = frozenset("sunflower tulip rose flower spoon fork whisk spatula straw".split())
SMALL_MOUTH = ("bottle", "jar", "flask", "potion")  # flowers are in them as in a vase
# What fills one: things that lie on one another; what floats; what stands on the bottom.
LYING, HOVERING, STANDING = 12, 6, 3
KG_M3 = 1100.0  # of the glass, thicker here than a real wall, and of what is in it
SMALL = 0.12  # metres: longer things stand
BLURRED = ("frosted glass", "stained glass", "tinted glass", "smoked glass", "smoky glass")
CLEAR = "clear glass"
PALE = "pale"


def filling_of(words: Words, many: bool) -> Words:
    """Several of a thing as they fill a vessel; ``many``: in no stated number."""
    noun = words.noun
    growing = noun not in EDIBLE and any(noun in GROUPS[group] for group in UPRIGHT)
    stands = growing or is_creature(noun) or words.usual()[0] > SMALL
    lies = noun in EDIBLE or not stands
    usual = HOVERING if noun in FLOATING else LYING if lies else STANDING
    count = usual if many and words.count == 1 else words.count
    return replace(words, count=count, order="heap" if usual != STANDING else "row")


def lies_in(vessel: str, content: str) -> bool:
    """Whether the vessel is on its side around the content: a ship's bottle."""
    return vessel == "bottle" and content in BOATS


def usual_of_whole(words: Words) -> tuple[float, float]:
    """The usual size in metres, and the density in kg/m³, of a vessel with what is in it, or else
    of the thing."""
    around = (one.words for one in words.companions if one.relation == "in")
    vessel = next((one for one in around if one.noun in VESSELS), None)
    holds = any(one.relation == "bears" for one in words.companions)
    if vessel is None and holds and words.noun in VESSELS:
        vessel = words
    return words.usual() if vessel is None else (vessel.usual()[0], KG_M3)


def may_enclose(vessel: str, content: str) -> bool:
    """Whether the vessel may have the content in it: not what it is of, nor another vessel."""
    if vessel not in VESSELS or content in VESSELS or content in GROUPS["Clothes"]:
        return False
    lit = vessel == "bottle" and content == "candle"  # it is in the neck
    return not (lit or (vessel in SMALL_MOUTH and content in NOT_IN))


def glazed(words: Words, relations: Iterable[Relation], encloses: bool) -> Words:
    """The words of a vessel that something is in: of clear glass, of the stated colour, and without
    what would hide its inside."""
    if words.noun not in VESSELS or not (encloses or "bears" in relations):
        return words
    glass, gone = VESSELS[words.noun]
    form = words.material_form if words.material_form in BLURRED else CLEAR
    own = [one for one in words.accents if one.part == glass]
    color = (words.color, words.color_form) if _is_main(words.noun) else ("", "")
    accent = own[0] if own else Accent(glass, *color)
    if accent.color:  # light goes through it four times
        accent = accent._replace(color_form=f"{PALE} {accent.color_form or accent.color}")
    accent = accent._replace(material="glass", material_form=form)
    accents = (accent, *(one for one in words.accents if one.part != glass))
    if words.noun == "bottle" and "cap" not in {one.part for one in accents}:
        accents = (*accents, Accent("cap", material="wooden", material_form="wooden"))
    plain = {"material": "", "material_form": ""} if words.material == "glass" else {}
    return replace(words, accents=accents, absent=(*words.absent, *gone), **plain)


def _is_main(noun: str) -> bool:
    """Whether a colour of the whole is that of the glass."""
    return noun not in ("snow globe", "glass dome", "aquarium")
