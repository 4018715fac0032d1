"""Contents of a container, and food on a plate: "a basket of apples", "a plate of croissants".

Standard library only.
"""

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import NamedTuple

from core.guidance.builtin.words.companions import known_as
from core.guidance.builtin.words.companions.glassware import (
    PRINTED,
    VESSELS,
    filling_of,
    may_enclose,
)
from core.guidance.builtin.words.grammar.contents import FOOD
from core.guidance.builtin.words.grammar.counts import is_many, named_singly, set_counts_apart
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.grammar.openers import ends_in_name, named_in
from core.guidance.builtin.words.grammar.tokens import Tokens
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.count_words import (
    CONTAINED,
    FEW,
    GROWING,
    IN_ONE_HEAP,
    PORTION,
    SEVERAL,
)
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.pictured import is_pictured
from core.guidance.builtin.words.tables.sizes import usual

_COLOR = "|".join(SLOTS["color"])
_PHRASE = (
    rf"(?P<phrase>(?:(?:{_COLOR}),? and )?"
    r"(?:(?!(?:on|in|and|with|that|which)\b)[\w'-]+ ?){1,6})"
)
FULL = (
    r"(?:(?:completely|half) )?(?:full of|full with|(?:filled|packed|overflowing|brimming|loaded|"
    r"stuffed|heaped|piled|bursting|laden)(?: to the (?:brim|top)| up| high)? with|"
    r"full to the (?:brim|top) (?:with|of)|containing)"
)
FILLED = re.compile(rf"(?<![\w-])(?P<way>{FULL}|of|with|holding|carrying) {_PHRASE}", re.IGNORECASE)
SERVED = re.compile(
    r"(?<![\w-])(?P<plate>(?:(?:an?|the) )?(?:(?!of\b)[\w'-]+ ){0,3}?(?:plate|platter|tray|dish)) "
    rf"(?:{FULL}|of|with) {_PHRASE}",
    re.IGNORECASE,
)
FISH = frozenset("fish clownfish koi starfish".split())
PLATE = "plate"
SURELY = ("of", "containing")  # and what is full of it: "with" may be a print
MASSES = frozenset("hay straw".split())
_SMALL = re.compile(r"\b(?:toy|tiny|little|small|model|mini|miniature)\b", re.IGNORECASE)
_ONE = re.compile(r"\s*(?:an?|one|another) (?!.*\bof\b)", re.IGNORECASE)
_COUNTED = re.compile(r"\s*(?:an?|the|one|some|two|three|four|five|six) ", re.IGNORECASE)
LARGEST = 2.0  # times as long as what it is in


class Named(NamedTuple):
    """A phrase with its thing's name in the singular, and whether it names several."""

    phrase: str
    is_many: bool
    is_counted: bool


@cache
def named(phrase: str) -> Named:
    """The thing of a phrase in any number."""
    tokens = Tokens.of(phrase, SLOTS)
    many, single = is_many(tokens), named_singly(phrase, tokens)
    counted = bool(set_counts_apart(Tokens.of(phrase, SLOTS)).stated)
    many &= counted or not _ONE.match(phrase)  # "a goldfish"
    return Named(phrase if counted else single, many, counted)


def may_fill(container: str, way: str, phrase: str) -> bool:
    """Whether it is in the container, not printed on it."""
    if named_in(phrase) in known_as.FLOWERS and container in known_as.VESSELS:
        return True
    if container in VESSELS:
        return may_be_full_of(container, way, phrase)
    if container == PLATE and named_in(phrase) in FOOD:  # then the food is the thing
        return False
    sure = way.lower() in SURELY or " " in way
    return (
        container in known_as.CONTAINERS and fills(phrase) and (sure or not is_pictured(container))
    )


def may_be_full_of(vessel: str, way: str, phrase: str) -> bool:
    """Whether a glass vessel has several of these in it: a jar of cookies, no bottle of apple
    juice."""
    noun = named_in(phrase)
    many = named(phrase).is_many or noun in SEVERAL
    sure = way.lower() in SURELY or " " in way or vessel not in PRINTED
    return many and sure and ends_in_name(phrase, noun) and may_enclose(vessel, noun)


def length(noun: str, phrase: str) -> float:
    """The length of a phrase's thing, metres."""
    return usual(noun, toy=bool(_SMALL.search(phrase)))[0]


def fills(phrase: str) -> bool:
    """Whether a container may be full of it: "apples", "bread", "hay"."""
    return named(phrase).is_many or named_in(phrase) in FOOD or phrase.lower() in MASSES


def is_some(phrase: str) -> bool:
    """Whether it names one thing or several, and no liquid."""
    return bool(_COUNTED.match(phrase)) or named(phrase).is_many


def may_hold(container: str, phrase: str) -> bool:
    """Whether it is stated to be "in" the container."""
    noun = named_in(phrase)
    fits = bool(noun) and length(noun, phrase) <= LARGEST * usual(container)[0]
    fits &= not known_as.is_building(noun)
    within = container in known_as.CONTAINERS and (fits or fills(phrase.strip()))
    within |= bool(noun) and may_enclose(container, noun)
    return within or known_as.may_hold_within(noun, container)


def filling(words: Words, phrase: str, container: str) -> Words | None:
    """The visible amount of a container's content; None: it is too large, or a meal."""
    noun = words.noun
    if container in VESSELS:
        many = named(phrase).is_many and noun not in SEVERAL
        return filling_of(words, many) if many or words.count > 1 else words
    flower = noun in known_as.FLOWERS
    if not flower and words.usual()[0] > LARGEST * usual(container)[0]:
        return None
    if noun in SEVERAL and noun not in IN_ONE_HEAP:
        return None
    if words.count > 1:
        return replace(words, order="heap")
    if not named(phrase).is_many or noun in IN_ONE_HEAP:
        return words
    few = FEW if is_creature(noun) and noun not in FISH else CONTAINED
    return replace(words, count=GROWING if flower else few, order="heap")


def in_a_vessel(words: Words, phrase: str, others: Iterable[tuple[str, str]]) -> Words:
    """Several things as they fill the vessel that they are in, if it is among the ``others``, of
    which it is the relation and the noun: "fireflies in a jar"."""
    vessel = next((noun for how, noun in others if how == "in" and noun in VESSELS), "")
    return filling(words, phrase, vessel) or words if vessel else words


def portion(noun: str, phrase: str) -> str:
    """The food on a plate as a prompt by itself; "" for a meal or other things."""
    own = named(phrase)
    if noun not in FOOD or noun in SEVERAL or not own.is_many:
        return ""
    return f"a heap of {'' if own.is_counted else PORTION + ' '}{own.phrase}"
