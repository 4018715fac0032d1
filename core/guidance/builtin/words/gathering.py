"""What a prompt lists with a thing, put so that each says its place: "a desk with a lamp and a mug"
is one with a lamp on it and with a mug on it.

Standard library only.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words import companion_words as known_as
from core.guidance.builtin.words import fillings
from core.guidance.builtin.words.companion_openers import ends_in_name, named_in
from core.guidance.builtin.words.count_words import SEVERAL
from core.guidance.builtin.words.fillings import PLATE, named
from core.guidance.builtin.words.living import is_creature
from core.guidance.builtin.words.sizes import usual

ON, IN, BY, HEAPED = "on top of it", "in it", "next to it", "in a heap on top of it"
# On these things stand, and are not painted.
_TOPS = frozenset(
    (
        "table, desk, coffee table, picnic table, pool table, nightstand, dresser, cabinet, stool, "
        "bench, bed, bunk bed, four-poster bed, sofa, armchair, ottoman, shelf, bookshelf, "
        "counter, rug, towel, piano, grand piano, fireplace, stove, grill, cutting board, plate, "
        "stump, column, pallet, trailer"
    ).split(", ")
)
_FURNITURE = frozenset(GROUPS["Furniture"]) - {"lamp", "pillow", "shelf", "mirror", "beanbag"}
_TALL = 0.5  # times as long as a table: what stands beside it, if it is furniture or grows
_LARGEST = 1.2  # times as long as what it is on or in
_VEHICLES = frozenset(GROUPS["Vehicles"]) | frozenset(GROUPS["Aircraft and Space"])
_OF_VEHICLES = (
    frozenset(GROUPS["Flags and Signs"])
    | frozenset("flag anchor wheel engine oar cannon radio tire speaker".split())
    | {"ship wheel"}
)
_BUILDINGS = frozenset(GROUPS["Buildings"])
_GROWING = frozenset("tree palm bush mushroom boulder stump log".split()) | {
    *("oak tree", "christmas tree", "willow tree", "bamboo plant"),
}
_PERCHING = frozenset("bird owl parrot eagle squirrel toucan".split())
_PITCHED = frozenset("tent campfire well signpost mailbox tombstone anvil scarecrow".split())
# What stands beside a house or a tree, besides vehicles, and who is alive.
_OUTSIDE = (
    _GROWING
    | _FURNITURE
    | _PITCHED
    | frozenset(
        "cactus barrel chest crate cauldron cannon snowman wheelbarrow pumpkin fence".split()
    )
    | frozenset("windmill fountain silo swing seesaw crane ladder".split())
    | {"street lamp", "potted plant", "hay bale", "flower pot", "trash can", "fire hydrant"}
)
_SERVED = frozenset("mug teacup goblet teapot bottle candle bowl can".split()) | {"wine glass"}
_COMPUTERS = re.compile(r"\b(?:computer|pc|laptop|monitor|keyboard)s?\b", re.IGNORECASE)
_STOVES = frozenset("stove grill campfire fireplace".split())
_POT = re.compile(r"(?<!flower )(?<!cooking )\bpot\b(?! of)", re.IGNORECASE)
_HEATED = frozenset("pan kettle teapot cauldron".split()) | {"cooking pot", "moka pot"}
_CLOCK = re.compile(r"(?<=\ba )clock\b", re.IGNORECASE)
_MOUSE = re.compile(r"(?<!computer )(?<!cat and )\bmouse\b(?! ?pad)", re.IGNORECASE)
_ONE = re.compile(
    r"(?:an?|the|its|one|some|two|three|four|five|six|several|a (?:pair|couple) of)\s",
    re.IGNORECASE,
)
_JOIN = re.compile(r"\s*,\s*(?:and\s+)?(?:with\s+)?|\s+(?:and|plus)\s+(?:with\s+)?", re.IGNORECASE)
_WHERE = re.compile(
    r"\s(?:(?:sitting|standing|lying|resting|placed) )?(?:"
    r"(?P<on>(?:on top of|on|upon|atop) (?:it|them)|(?:on|at) (?:the |its )?top(?: of it)?)|"
    r"(?P<within>in(?:side)? (?:it|them)|inside)|(?P<by>BY))$".replace("BY", known_as.BY_IT),
    re.IGNORECASE,
)
_CLAUSE = re.compile(
    r"(?<![\w-])(?P<way>with|having|of|(?:full|filled) (?:of|with)) (?=(?P<list>[^.;:!?()\"“]+))",
    re.IGNORECASE,
)
_END = re.compile(
    r" (?:with|that|which|who|while|made|for|wearing|holding|from|in (?=an? |the )|on (?=an? ))",
    re.IGNORECASE,
)
_ITEM = (
    rf"{_ONE.pattern}(?:(?!(?:with|on|in|inside|wearing|holding|that|which|who|and|an?|the|made|next|"
    r"at|for|under|over|by|from|against|riding|to)\b)[\w'-]+ ?){1,5}"
)
_LIST = rf"{_ITEM}(?:, {_ITEM})*,? ?and {_ITEM}"
_LISTED = re.compile(rf"\s*(?P<list>{_LIST})[.!]?\s*", re.IGNORECASE)
_LISTED_ON = re.compile(
    rf"\s*(?P<list>{_LIST})(?:(?:sitting|standing|lying|resting) )?"
    rf"(?P<way>on top of|on|in|inside) (?P<below>{_ITEM})[.!]?\s*",
    re.IGNORECASE,
)
_MIXTURES = {"f": "apples, oranges and bananas", "v": "tomatoes, carrots and onions"}
_KINDS = r"(?:(?:fresh|mixed|ripe|colou?rful|tropical|assorted|various) )*"
_MIXED = re.compile(
    rf"(?P<before> (?:of|with) ){_KINDS}(?P<what>fruit|vegetable|veggie)s?"
    r"(?=$|[,.;!?]| (?:and|on|in|next|beside)\b)",
    re.IGNORECASE,
)
# "Of fruit with apples and pears"
_LISTED_MIXED = re.compile(
    rf" of {_KINDS}(?:fruit|vegetable|veggie)s?(?: with|,? like|,? such as|,? including|:|,) "
    r"(?=[\w-]+s\b)",
    re.IGNORECASE,
)
_MIXED_BEFORE = re.compile(
    r"\b(?P<what>fruit|vegetable|veggie)s? (?P<container>bowl|basket|crate|platter)\b",
    re.IGNORECASE,
)


_ANOTHER = re.compile(r" (?:with|on|in|beside|holding|next to) ", re.IGNORECASE)


class _Item(NamedTuple):
    """One of a list, and the place that it has there."""

    phrase: str
    end: int
    place: str


def in_a_row(prompt: str) -> list[str]:
    """What a prompt is a list of, if it is of three or more: "a fork, a knife and a spoon"."""
    listed = _LISTED.fullmatch(prompt)
    items = _JOIN.split(listed["list"].strip()) if listed else []
    return items if len(items) > 2 else []


def turned(prompt: str) -> str:
    """The prompt with what bears several first: "a lamp and a mug on a desk"."""
    listed = _LISTED_ON.fullmatch(prompt)
    if listed is None:
        return prompt
    below, items = named_in(listed["below"]), _JOIN.split(listed["list"])
    if any(not _names(one, 0) or is_creature(named_in(one)) for one in items):
        return prompt
    within = below in known_as.CONTAINERS and below != PLATE
    if not (within or below in _TOPS) or (within == listed["way"].startswith("on")):
        return prompt
    where = IN if within else ON
    return listed["below"] + "".join(f" with {one} {where}" for one in items)


def spread(prompt: str, first_of: Callable[[str], str], is_own: Callable[[str, str], bool]) -> str:
    """The prompt with the place behind each thing that it lists with the first.

    Args:
        first_of: the thing that a text names first, or "".
        is_own: whether a phrase names what the first thing has by itself.
    """
    for begin in (match.start() for match in _CLAUSE.finditer(prompt)):
        first = first_of(prompt[:begin])
        rest = _as_meant(first, prompt[begin:])
        clause = _CLAUSE.match(rest)
        if first and clause and (found := _listed(prompt[:begin], clause, first, is_own)):
            kept = " and ".join(one.phrase for one in found if not one.place)
            parts = [prompt[:begin].rstrip(), *([f"with {kept}"] if kept else [])]
            parts += [
                f"with {one.phrase} {one.place}" for one in found if one.place not in ("", HEAPED)
            ]
            parts += [f"with a heap of {one.phrase} {ON}" for one in found if one.place == HEAPED]
            return " ".join(parts) + rest[found[-1].end :]
    return prompt


def _as_meant(first: str, text: str) -> str:
    """What is listed with a desk or on a stove by its full name: a mouse of a computer."""
    if _COMPUTERS.search(text):
        text = _MOUSE.sub("computer mouse", text)
    if first in _TOPS:
        text = _CLOCK.sub("alarm clock", text)
    return _POT.sub("cooking pot", text) if first in _STOVES else text


def _listed(
    before: str, clause: re.Match[str], first: str, is_own: Callable[[str, str], bool]
) -> list[_Item]:
    """What the clause lists up to the last that has a place; nothing where it is to stay."""
    items, given = _items(clause)
    several = len(items) > 1
    if given:
        if not several or (given == ON and known_as.is_pictured(first)):
            return []
        items = [
            one._replace(place=given if _names(one.phrase, k) else "")
            for k, one in enumerate(items)
        ]
    elif clause["way"].lower() not in ("with", "having"):
        nearest = not _ANOTHER.search(before)
        of_first = nearest and first in known_as.CONTAINERS
        if not (several and of_first and _are_many(items)):
            return []
        items = [one._replace(place=IN) for one in items]
    else:
        items = [
            one._replace(place="" if is_own(one.phrase, first) else _place(first, one.phrase, k))
            for k, one in enumerate(items)
        ]
    is_meal = not several and named_in(items[0].phrase) in known_as.EDIBLE
    if first == PLATE and (is_meal or not all(one.place for one in items)):
        return []  # the food is the thing
    while items and not items[-1].place:
        items.pop()
    return items


def _items(clause: re.Match[str]) -> tuple[list[_Item], str]:
    """What stands between the commas, up to where the place of all is said; that place."""
    text, begin = clause["list"], clause.start("list")
    end = _END.search(text)
    text = text[: end.start()] if end else text
    found, at = [], 0
    while at <= len(text):
        join = _next_join(text, at)
        stop = join.start() if join else len(text)
        phrase = text[at:stop].rstrip()
        where = _WHERE.search(phrase)
        if where:
            phrase = phrase[: where.start()]
        found.append(_Item(phrase, begin + at + len(text[at:stop].rstrip()), ""))
        if where:
            given = ON if where["on"] else IN if where["within"] else BY
            return found, given
        if join is None:
            break
        at = join.end()
    return found, ""


def _next_join(text: str, begin: int) -> re.Match[str] | None:
    """Where the item that begins there ends: behind "a basket of apples and oranges"."""
    for join in _JOIN.finditer(text, begin):
        goes_on = " of " in text[begin : join.start()] and "," not in join[0]
        if not goes_on or _ONE.match(text, join.end()):
            return join
    return None


def _names(phrase: str, index: int) -> bool:
    """Whether the item names one thing, or some: "a lamp", and no "wooden legs"; behind the first
    it may have no article."""
    noun = named_in(phrase)
    return bool(noun and (index or _ONE.match(phrase))) and ends_in_name(phrase, noun)


def _are_many(items: list[_Item]) -> bool:
    """Whether each is several things that lie in a heap: "apples"."""
    return all(named_in(one.phrase) and named(one.phrase).is_many for one in items)


def _place(first: str, phrase: str, index: int) -> str:
    """Where a thing is that the first one is said to be with; "" where that is not clear."""
    noun = named_in(phrase)
    heap = bool(noun) and not _ONE.match(phrase) and fillings.fills(phrase)
    if noun == first or not (heap or _names(phrase, index)) or noun in known_as.HUNG:
        return ""
    long = fillings.length(noun, phrase) / usual(first)[0]
    if noun in known_as.POINTED and first in known_as.PIERCED:
        return IN
    if first in _STOVES and noun in _HEATED:
        return ON
    if first in _TOPS and heap:
        return ON if noun in SEVERAL else HEAPED if noun in known_as.EDIBLE else ""
    if first in _TOPS:
        beside = long > _TALL and noun in _FURNITURE | _GROWING | _VEHICLES
        return BY if beside else ON if long < _LARGEST else ""
    if first == PLATE and noun in _SERVED:
        return ON
    if first in known_as.VESSELS and noun in known_as.STIRRING:
        return IN
    if first in known_as.DRINKS:
        return BY if noun in known_as.EDIBLE and not heap else ""
    if first in known_as.CONTAINERS:
        return IN if long < _LARGEST and _goes_in(first, noun) else ""
    if heap or (known_as.is_dressed(first) and first not in _GROWING):
        return ""
    if first in _GROWING and noun in _PERCHING:
        return ON
    if first in _VEHICLES:
        return BY if is_creature(noun) or noun == "trailer" else ""
    if first in _FURNITURE:
        return BY if noun in _FURNITURE else ""
    stands = noun in _OUTSIDE | _VEHICLES or is_creature(noun)
    return BY if stands and first in _BUILDINGS | _GROWING | _PITCHED else ""


def _goes_in(first: str, noun: str) -> bool:
    if known_as.is_pictured(first):
        return noun in known_as.EDIBLE
    return first not in _VEHICLES or noun not in _OF_VEHICLES


def mixtures_named(prompt: str) -> str:
    """The prompt with the kinds of what only says "fruit": a bowl of it."""
    prompt = _MIXED_BEFORE.sub(r"\g<container> of \g<what>", prompt)
    prompt = _LISTED_MIXED.sub(" of ", prompt)
    found = _MIXED.search(prompt)
    if found is None or _ANOTHER.search(prompt, 0, found.start()):
        return prompt
    kinds = found["before"] + _MIXTURES[found["what"][0].lower()]
    return prompt[: found.start()] + kinds + prompt[found.end() :]
