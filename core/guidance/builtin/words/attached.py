"""Small things on a thing: mushrooms on a log, lanterns that hang from a tree, a pen on a journal.

Standard library only.
"""

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words import companion_words as known_as
from core.guidance.builtin.words.companion_openers import Relation, ends_in_name, named_in
from core.guidance.builtin.words.count_words import CIRCLED, FEW, MANY, SEVERAL
from core.guidance.builtin.words.emblems import FLAT
from core.guidance.builtin.words.fillings import named
from core.guidance.builtin.words.glassware import VESSELS, may_enclose
from core.guidance.builtin.words.living import is_creature
from core.guidance.builtin.words.pictured import is_pictured
from core.guidance.builtin.words.sizes import usual

TREES = frozenset(("tree", "oak tree", "palm", "christmas tree", "willow tree", "bush"))
# Things that plants and mushrooms grow on, and what does.
_SOILS = TREES | {"cactus", "log", "stump", "boulder", "skull", "island", "tombstone", "wreath"}
_GROWING = known_as.FLOWERS | {"mushroom", "cactus", "potted plant", "snail", "ladybug", "butterfly"}
_GROWING |= {"bird", "bee", "acorn", "seashell", "starfish"}
HATS = known_as.HEADWEAR - {"crown", "chef hat", "beanie", "motorcycle helmet"} | {"crown"}
_TRIM = known_as.FLOWERS | {"feather", "star", "heart", "goggles", "gem", "skull", "leaf"}
_READ = frozenset(("book", "notebook", "clipboard", "newspaper", "envelope", "scroll", "laptop"))
_WRITING = frozenset("pen pencil feather key magnifying-glass candle sunglasses".split()) | {
    "magnifying glass",
    "paintbrush",
    "flower",
    "rose",
}
# Things with a bed or a deck, on which loads lie.
_LOADED = frozenset(("pickup truck", "dump truck", "trailer", "cargo ship", "raft", "sled", "pallet"))
_HANDLEBARS = frozenset(("bicycle", "motorcycle", "scooter", "tricycle"))
_CARRIERS = frozenset(("basket", "lantern", "crate", "cardboard box", "backpack", "flower pot"))
_BACKED = frozenset(("shield", "skull", "helmet", "crown", "viking helmet"))
# The inside of these is seen: what comes with them is in them.
_SHOWN_IN = frozenset(("aquarium", "snow globe", "glass dome", "crystal ball", "light bulb", "jar"))
_BALLS = frozenset(("ball", "baseball", "tennis ball", "softball"))
# Words that end a phrase about another thing.
_ENDS = (
    r"on|in|at|of|and|with|that|which|growing|hanging|sitting|lying|resting|perched|standing|coming|"
    r"attached|stuck|sprouting|dangling|suspended|inside|behind"
)
_PHRASE = rf"(?P<phrase>(?:(?!(?:{_ENDS})\b)[\w'-]+ ?){{1,5}})(?<! )"
_WITHS = r"(?P<way>with|and|covered (?:in|with)|full of|that has|has|having|decorated with)"
_IT = r"(?:it|them|its|the|a|one)"
_ATTACHED = re.compile(
    rf"(?:^|(?<= )|,? ){_WITHS} {_PHRASE}(?P<where>"
    rf"(?P<hanging>(?: (?:hanging|dangling|suspended))(?: down)? (?:from|off|in|on) {_IT}"
    r"(?: of its)?(?: [\w-]+)?(?: branch(?:es)?)?\b)|"
    rf"(?P<growing>(?: (?:growing|sprouting|blooming))(?: (?:out|up))?(?: (?:on|of|from|out of|over|in) "
    rf"{_IT}(?: (?:top|sides?|branches|surface|bark))?)?\b)|"
    r"(?P<behind> (?:crossed )?behind (?:it|them)\b)|"
    r"(?P<front> (?:attached )?(?:on|at|to|in) (?:the|its) (?:front|handlebars?|rack|back)\b)|"
    rf"(?P<lid>(?: (?:sitting|perched|standing|resting|sleeping|lying))? on (?:the|its|an?|one of its) "
    r"(?:lid|cover|branch|branches|canopy|chimney|spout|roof|handle|hood|bonnet)\b)|"
    r"(?P<within> in(?:side)? (?:it|its palm)\b)|"
    r"(?P<on>(?: (?:sitting|perched|resting|lying|stuck))?(?: (?:on|to) (?:it|them|its side|the side|the brim|"
    r"its brim|the band|top|the top))\b)|)(?=$|[,.;!?]| and\b| with\b)",
    re.IGNORECASE,
)
_LOAD = re.compile(
    r" (?:carrying|hauling|transporting|delivering|(?:loaded(?: up)?|filled|piled(?: high)?|stacked)"
    r" with|full of|with an? (?:load|cargo|bed|pile|stack)(?: full)? of|with) "
    rf"{_PHRASE}(?: (?:in|on) (?:the|its) (?:back|bed|deck|trailer))?(?=$|[,.;!?]| and\b)",
    re.IGNORECASE,
)
_ONE = re.compile(r"(?:an?|one|the|its) ", re.IGNORECASE)
# Their parts are named as things, too: a boat's cabin, a castle's tower.
_WITH_PARTS = frozenset(GROUPS["Vehicles"]) | frozenset(GROUPS["Aircraft and Space"])
_WITH_PARTS |= frozenset(GROUPS["Buildings"]) - {"column"}
LOAD = 8  # in no stated number
_SMALL = 0.7  # times as long as the first thing: on it


class Attached(NamedTuple):
    """Small things on or at a prompt's thing, and their place in the prompt."""

    relation: Relation
    phrase: str
    many: int  # how many are made in no stated number
    start: int
    end: int
    heaped: bool = False
    is_top: bool = False  # on top, where the first thing has nothing


def attached_in(prompt: str, first_of: Callable[[str], str]) -> Iterator[Attached]:
    """The small things that the prompt's first thing may have so."""
    for match in _LOAD.finditer(prompt):
        first = first_of(prompt[: match.start()])
        if first in _LOADED and named(match["phrase"]).is_many and not is_creature(named_in(match["phrase"])):
            yield Attached("bears", match["phrase"], LOAD, match.start(), match.end(), heaped=True)
    for match in _ATTACHED.finditer(prompt):
        first = first_of(prompt[: match.start()])
        phrase = match["phrase"].strip()
        noun = named_in(phrase)
        if not first or not noun or noun == first or not ends_in_name(phrase, noun):
            continue
        if is_creature(first) and first not in ("skull",):
            continue
        found = _how(first, noun, match)
        if found:
            relation, many = found
            top = bool(match["on"]) and match["on"].endswith("top")
            yield Attached(relation, phrase, many, match.start(), match.end(), is_top=top or relation == "behind")


def _how(first: str, noun: str, match: re.Match[str]) -> tuple[Relation, int] | None:
    """The relation, and the number where none is stated; None: it is read otherwise."""
    covered = MANY if "covered" in match["way"] else FEW
    plain = not match["where"] or bool(match["on"])
    if match["hanging"]:
        framed = noun == "swing"  # it has its own frame
        return ("beside" if framed else "hanging", FEW) if first in TREES else None
    if match["behind"]:
        return ("behind", 2) if noun in known_as.POINTED | {"bone"} else None
    if first in _BACKED and match["phrase"].lower().startswith(("crossed", "two crossed", "a pair of c")):
        return ("behind", 2)
    if match["front"]:
        return ("front", 1) if first in _HANDLEBARS and noun in _CARRIERS else None
    if first in _HANDLEBARS and plain and noun in _CARRIERS:
        return ("front", 1)
    if first == "glove" and noun in _BALLS and (plain or match["within"]):
        return ("front", 1)
    if match["lid"]:
        pictured = noun in FLAT
        return None if pictured else ("bears", 1)
    fruit = noun in GROUPS["Fruit and Vegetables"] or noun in ("christmas bauble",)
    if first in TREES and (plain or match["growing"]) and fruit:
        return ("growing", CIRCLED)
    if first in _SOILS and noun in _GROWING and (plain or match["growing"]):
        return ("growing", covered)
    if first in HATS and noun in _TRIM and (match["on"] or "").endswith("top"):
        return ("bears", 1)
    if first in HATS and noun in _TRIM - {"star", "heart", "skull", "leaf"} and plain:
        return ("front", 1)
    if first in _READ and noun in _WRITING and not match["where"]:
        return ("front", 1)
    if first in _SHOWN_IN and not match["where"] and may_enclose(first, noun):
        return ("bears", FEW)
    return None


def others_in(prompt: str) -> Iterator[tuple[str, int, int]]:
    """The phrases behind "with" and "and", and their places."""
    for match in _ATTACHED.finditer(prompt):
        if not match["where"] and match["way"].lower() in ("with", "and", "has", "that has", "having"):
            yield match["phrase"].strip(), match.start(), match.end()


def by_size(first: str, phrase: str) -> Relation | None:
    """The relation of one more thing that a prompt names, and that has no other place: small ones
    are on it, larger ones next to it; None where it is a picture or a part."""
    noun = named_in(phrase)
    apart = is_creature(first) or is_pictured(first) or first in VESSELS or noun in FLAT
    apart |= first in known_as.INSTRUMENTS and noun == "bow"  # which is for arrows
    apart |= first in _WITH_PARTS or first in known_as.EDIBLE
    if not noun or apart or noun == first or noun in SEVERAL or noun in known_as.HUNG:
        return None
    if not _ONE.match(phrase) or not ends_in_name(phrase, noun):
        return None
    small = usual(noun)[0] <= _SMALL * usual(first)[0]
    bears = first not in known_as.NO_SUPPORTS | known_as.NO_BEARERS | known_as.INSTRUMENTS
    return "bears" if small and bears else "beside"
