"""Closed vessels of clear glass, and what is in them, as data.

Standard library only.
"""

from collections.abc import Iterable
from dataclasses import replace

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.accents import Accent
from core.guidance.builtin.words.companion_openers import Relation
from core.guidance.builtin.words.slots import Words

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
# These float or fly.
FLOATING = frozenset(
    """brain eyeball jellyfish fish clownfish koi shark octopus squid seahorse whale dolphin bee
    butterfly dragonfly ghost cloud heart planet earth star sun bat snowflake""".split()
) | {"full moon", "sea turtle"}
BOATS = frozenset(
    """boat sailboat canoe rowboat speedboat longship yacht raft submarine""".split()
) | {"pirate ship", "cargo ship", "cruise ship"}
PRINTED = ("bottle", "potion")  # "with stars": these are on it
NOT_IN = frozenset("sunflower tulip rose flower spoon fork whisk spatula straw candle".split())
SMALL_MOUTH = ("bottle", "jar", "flask", "potion")  # flowers are in them as in a vase
IN_A_JAR = 12  # things that fill one


def lies_in(vessel: str, content: str) -> bool:
    """Whether the vessel is on its side around the content: a ship's bottle."""
    return vessel == "bottle" and content in BOATS


def is_vessel(noun: str) -> bool:
    """Whether it is such a vessel."""
    return noun in VESSELS


def may_enclose(vessel: str, content: str) -> bool:
    """Whether the vessel may have the content in it: not what it is of, nor another vessel."""
    if vessel not in VESSELS or content in VESSELS or content in GROUPS["Clothes"]:
        return False
    return not (vessel in SMALL_MOUTH and content in NOT_IN)


def glazed(words: Words, relations: Iterable[Relation], encloses: bool) -> Words:
    """The words of a vessel that something is in: of clear glass, of the stated colour, and without
    what would hide its inside."""
    if words.noun not in VESSELS or not (encloses or "bears" in relations):
        return words
    glass, gone = VESSELS[words.noun]
    form = words.material_form if words.material == "glass" else "glass"
    own = [one for one in words.accents if one.part == glass]
    color = (words.color, words.color_form or words.color) if _is_main(words.noun) else ("", "")
    accent = own[0] if own else Accent(glass, *color)
    accent = accent._replace(material="glass", material_form=form)
    accents = (accent, *(one for one in words.accents if one.part != glass))
    plain = {"material": "", "material_form": ""} if words.material == "glass" else {}
    return replace(words, accents=accents, absent=(*words.absent, *gone), **plain)


def _is_main(noun: str) -> bool:
    """Whether a colour of the whole is that of the glass."""
    return noun not in ("snow globe", "glass dome", "aquarium")
