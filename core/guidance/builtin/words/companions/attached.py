"""Small things on a thing: mushrooms on a log, lanterns that hang from a tree, a pen on a journal.

Standard library only.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companions import known_as
from core.guidance.builtin.words.companions.fillings import named
from core.guidance.builtin.words.companions.glassware import VESSELS, may_enclose
from core.guidance.builtin.words.companions.rephrasing import POSES
from core.guidance.builtin.words.companions.whereabouts import TOPS
from core.guidance.builtin.words.grammar.openers import Relation, ends_in_name, named_in
from core.guidance.builtin.words.grammar.part_names import looks_of
from core.guidance.builtin.words.phrases.emblems import FLAT
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.count_words import CIRCLED, FEW, MANY, SEVERAL
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.pictured import is_pictured
from core.guidance.builtin.words.tables.sizes import usual

TREES = frozenset(("tree", "oak tree", "palm", "christmas tree", "willow tree", "bush"))
# Things that plants and mushrooms grow on or small animals are on, and these.
_SOILS = TREES | {"cactus", "log", "stump", "boulder", "skull", "island", "tombstone", "wreath"}
_GROWING = known_as.FLOWERS | frozenset(
    (
        "mushroom, cactus, potted plant, snail, ladybug, butterfly, bird, bee, acorn, seashell, "
        "starfish"
    ).split(", ")
)
_STEMLESS = known_as.HEADWEAR | {"cactus", "skull", "wreath"}
_FRUIT = frozenset(GROUPS["Fruit and Vegetables"]) | {"christmas bauble"}  # on trees
_HATS = known_as.HEADWEAR - {"chef hat", "beanie", "motorcycle helmet"}
_ON_HATS = known_as.FLOWERS | {"feather", "goggles", "gem"}
_ON_TIPS = _ON_HATS | {"star", "heart", "skull", "leaf"}  # "on top"
_READ = frozenset("book notebook clipboard newspaper envelope scroll".split())
_WRITING = frozenset("pen pencil paintbrush feather key flower rose".split()) | {
    "magnifying glass",
}
# Things with a bed or a deck, on which loads lie.
_LOADED = frozenset(
    ("pickup truck", "dump truck", "trailer", "cargo ship", "raft", "sled", "pallet")
)
_HANDLEBARS = frozenset(("bicycle", "motorcycle", "scooter", "tricycle"))
_CARRIERS = frozenset(("basket", "lantern", "crate", "cardboard box", "backpack", "flower pot"))
# The inside of these is visible: what comes with them is in them.
_SHOWN_IN = frozenset(("aquarium", "snow globe", "glass dome", "crystal ball", "light bulb", "jar"))
_BALLS = frozenset(("ball", "baseball", "tennis ball", "softball"))
# Words that end a phrase about another thing.
_ENDS = (
    r"on|in|at|of|and|with|that|which|growing|hanging|sitting|lying|resting|perched|standing|"
    r"coming|attached|stuck|sprouting|dangling|suspended|inside|behind|under|underneath|beneath|below|"
    r"hidden|hiding|gathered|placed|piled"
)
_PHRASE = rf"(?P<phrase>(?:an? (?:{'|'.join(POSES)}) )?(?:(?!(?:{_ENDS})\b)[\w'-]+ ?){{1,5}})(?<! )"
_HAVING = ("with", "and", "has", "that has", "having")
_COVERED = ("covered in", "covered with", "full of", "decorated with")
_POSTURE = "(?: (?:sitting|perched|standing|resting|sleeping|lying|stuck))?"
_IT = r"(?:it|them|its|the|an?|one)"
# Where they are; "" where that is not stated.
_WHERE = {
    "hanging": r" (?:hanging|dangling|suspended)(?: down)? (?:from|off|in|on) "
    rf"{_IT}(?: of its)?(?: [\w-]+)?(?: branch(?:es)?)?\b",
    "growing": r" (?:growing|sprouting|blooming)(?: (?:out|up))?(?: (?:on|of|from|out of|over|in) "
    rf"{_IT}(?: (?:top|sides?|branches|surface|bark))?)?\b",
    "behind": r" (?:crossed )?behind (?:it|them)\b",
    "below": rf"{_POSTURE}(?: (?:placed|piled|hidden|hiding|gathered))? "
    r"(?:under|underneath|beneath|below)(?: (?:it|them|its branches))?(?=$|[,.;!?]| and\b)",
    "front": r" (?:attached )?(?:on|at|to|in) (?:the|its) (?:front|handlebars?|rack|back)\b",
    "lid": rf"{_POSTURE} on (?:the|its|an?|one of its) "
    r"(?:lid|branch|branches|canopy|chimney|spout|roof|handle|hood|bonnet)\b",
    "within": r" in(?:side)? (?:it|its palm)\b",
    "top": rf"{_POSTURE} on (?:the )?top\b",
    "on": rf"{_POSTURE} (?:on|to) (?:it|them|(?:its|the) (?:side|brim|band))\b",
}
_ATTACHED = re.compile(
    rf"(?:^|(?<= )|,? )(?P<way>{'|'.join((*_HAVING, *_COVERED))}) {_PHRASE}"
    rf"(?:{'|'.join(f'(?P<{name}>{rule})' for name, rule in _WHERE.items())}|)"
    r"(?=$|[,.;!?]| and\b| with\b)",
    re.IGNORECASE,
)
_LOADS = (
    r"carrying|hauling|transporting|delivering|(?:loaded(?: up)?|filled|piled(?: high)?|stacked) "
    r"with|full of|with an? (?:load|cargo|bed|pile|stack)(?: full)? of|with"
)
_LOAD = re.compile(
    rf" (?:{_LOADS}) {_PHRASE}(?: (?:in|on) (?:the|its) (?:back|bed|deck|trailer))?"
    r"(?=$|[,.;!?]| and\b)",
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
        phrase, noun = match["phrase"], named_in(match["phrase"])
        loads = named(phrase).is_many and not is_creature(noun)
        if loads and first_of(prompt[: match.start()]) in _LOADED:
            yield Attached("bears", phrase, LOAD, match.start(), match.end(), heaped=True)
    for match in _ATTACHED.finditer(prompt):
        first, phrase = first_of(prompt[: match.start()]), match["phrase"].strip()
        noun = named_in(phrase)
        named_so = bool(noun) and noun != first and ends_in_name(phrase, noun)
        if not (first and named_so) or (is_creature(first) and first != "skull"):
            continue
        if found := _how(first, noun, match):
            relation, many = found
            added = bool(match["top"]) or relation == "behind"
            yield Attached(relation, phrase, many, match.start(), match.end(), is_top=added)


def _how(first: str, noun: str, match: re.Match[str]) -> tuple[Relation, int] | None:
    """The relation, and the number where none is stated; None: it is read otherwise."""
    where = next((name for name in _WHERE if match[name]), "")
    crossed = re.match("(?:two |a pair of )?crossed ", match["phrase"], re.IGNORECASE)
    if where == "hanging" and first in TREES:  # a swing has its own frame
        return ("beside" if noun == "swing" else "hanging", FEW)
    if where == "lid" and noun not in FLAT:
        return ("bears", 1)
    covered = MANY if match["way"].lower() in _COVERED else FEW
    grows = _GROWING - known_as.FLOWERS if first in TREES else _GROWING  # it is in blossom
    rules: tuple[tuple[bool, str, Relation, int], ...] = (
        (noun in known_as.POINTED | {"bone"}, "behind", "behind", 2),
        (bool(crossed) and _has_a_back(first), ",behind", "behind", 2),
        (first in _HANDLEBARS and noun in _CARRIERS, ",front,on,top", "front", 1),
        (first == "glove" and noun in _BALLS, ",within,on", "front", 1),
        (first in known_as.ROOFS, "below", "below", FEW),
        (first in TREES and noun in _FRUIT, ",growing,on", "growing", CIRCLED),
        (first in _SOILS and noun in grows, ",growing,on,top", "growing", covered),
        (first in _HATS and noun in _ON_TIPS, "top", "bears", 1),
        (first in _HATS and noun in _ON_HATS, ",on", "front", 1),
        (first in _READ and noun in _WRITING, "", "front", 1),
        (first in _SHOWN_IN and may_enclose(first, noun), "", "bears", FEW),
    )
    fits = (rule[2:] for rule in rules if rule[0] and where in rule[1].split(","))
    return next(fits, None)


def _has_a_back(first: str) -> bool:
    """Whether crossed things may be behind it: they are on a table, and printed on a flag."""
    solid = first in ("shield", "barrel", "crate", "tombstone") or not is_pictured(first)
    return solid and first not in TOPS and first != "flag"


def others_in(prompt: str) -> Iterator[tuple[str, int, int]]:
    """The phrases behind "with" and "and" without a place, and where they are."""
    for match in _ATTACHED.finditer(prompt):
        if match["way"].lower() in _HAVING and not any(match[name] for name in _WHERE):
            yield match["phrase"].strip(), match.start(), match.end()


def without_stem(first: str, words: Words) -> Words:
    """A flower as it is on a cactus or a hat: only its blossom."""
    if words.noun not in known_as.FLOWERS or first not in _STEMLESS:
        return words
    stems = (part for part in ("stalk", "stem", "leaves") if part in looks_of(words.noun))
    return replace(words, absent=(*words.absent, *stems))


def by_size(first: str, phrase: str) -> Relation | None:
    """The relation of one more thing that a prompt names, and that has no other place: small ones
    are on it, larger ones next to it; None where it is a picture or a part."""
    noun = named_in(phrase)
    apart = is_creature(first) or is_pictured(first) or first in VESSELS or noun in FLAT
    apart |= first in known_as.INSTRUMENTS and noun == "bow"  # which is for arrows
    apart |= first in _WITH_PARTS or first in known_as.EDIBLE
    apart |= known_as.is_dressed(first) and first not in GROUPS["Plants"]  # a robot's screen
    apart &= not (first in known_as.EDIBLE and is_creature(noun))  # a mouse comes to the cheese
    if not noun or apart or noun == first or noun in SEVERAL or noun in known_as.HUNG:
        return None
    if not _ONE.match(phrase) or not ends_in_name(phrase, noun):
        return None
    small = usual(noun)[0] <= _SMALL * usual(first)[0]
    bears = first not in known_as.NO_SUPPORTS | known_as.NO_BEARERS | known_as.INSTRUMENTS
    return "bears" if small and bears else "beside"
