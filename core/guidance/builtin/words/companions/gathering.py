"""Lists of things with a thing, and their places: "a desk with a lamp and a mug" has both on it.

Standard library only.
"""

import re
from collections.abc import Callable
from itertools import islice
from typing import NamedTuple

from core.guidance.builtin.words.companions import fillings, known_as
from core.guidance.builtin.words.companions.fillings import PLATE, named
from core.guidance.builtin.words.companions.whereabouts import (
    BY_IT,
    LAID,
    STOVES,
    TOPS,
    Place,
    place_of,
)
from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up
from core.guidance.builtin.words.grammar.openers import ends_in_name, named_in
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.pictured import is_pictured

_COMPUTERS = re.compile(r"\b(?:computer|pc|laptop|monitor|keyboard)s?\b", re.IGNORECASE)
_POT = re.compile(
    r"(?<!flower )(?<!cooking )\bpot\b(?! of (?!soup|stew|tea|coffee|water))", re.IGNORECASE
)
_CLOCK = re.compile(
    r"(?<!alarm )(?<!grandfather )(?<!cuckoo )\b(?:mantel |desk |table )?clock\b", re.IGNORECASE
)
_MOUSE = re.compile(r"(?<!computer )(?<!cat and )\bmouse\b(?! ?pad)", re.IGNORECASE)
_ONE = re.compile(
    r"(?:a (?:pair|couple) of|an?|the|its|one|some|two|three|four|five|six|several)\s",
    re.IGNORECASE,
)
_JOIN = re.compile(r"\s*,\s*(?:and\s+)?(?:with\s+)?|\s+(?:and|plus)\s+(?:with\s+)?", re.IGNORECASE)
_POSTURE = r"(?:(?:[a-z]+(?:ing|ed)|asleep|built|stuck|set)(?: up)? )"
_WHERE = re.compile(
    rf"\s{_POSTURE}?(?:"
    r"(?:on top of|on|upon|atop) (?:it|them)|(?:on|at) (?:the |its )?top(?: of it)?|"
    r"(?P<edge>on (?:the|its|a|one) (?:edge|rim|seat|cushion|branch|mantel|surface))|"
    rf"(?P<within>in(?:side)? (?:it|them)|inside)|(?P<by>{BY_IT}))$",
    re.IGNORECASE,
)
_PERCHED = re.compile(r" on (?:the|its|an?|one) (?:[\w-]+ )?[\w-]+$", re.IGNORECASE)
LOOKED_AT = 12  # of a prompt's clauses: all before are parsed for each
_UNDER = re.compile(r" (?:under|below|beneath|underneath)\b", re.IGNORECASE)
# Descriptions of a thing behind its name.
_STATED = re.compile(
    r" (?:that|in|on|over|under|above|from|for|melted|[a-z]{2,}ing|covered|stuck|asleep|full)\b"
)
_CLAUSE = re.compile(
    r"(?:(?<![\w-])(?:with|having|that has|(?P<on>topped with|strewn with)|(?P<by>surrounded by)|"
    rf"(?P<has>holding|carrying)|(?P<of>of)|(?P<full>{fillings.FULL}))|(?P<colon>:)) "
    r"(?=(?P<list>[^.;:!?()\"“]+))",
    re.IGNORECASE,
)
_END = re.compile(
    r"(?:^|,?(?: and)? )(?:no|not|without)\b|"
    r",?(?: and)? (?:that|which|who|while|made|for|wearing|holding|from|"
    r"in (?=an? |the )|on (?=an? [^,]*$))",
    re.IGNORECASE,
)
_WORD = (
    r"(?!(?:with|on|in|inside|wearing|holding|that|which|who|and|an?|the|made|next|at|for|under|over|"
    r"by|from|against|riding|to)\b)[\w'-]+(?![\w'-])"
)
_ITEM = rf"{_ONE.pattern}{_WORD}(?: {_WORD}){{0,4}}"
_LIST = rf"{_ITEM}(?:, {_ITEM})*,? and {_ITEM}"
_LISTED = re.compile(rf"\s*(?P<list>{_LIST})\s*[.!]?\s*", re.IGNORECASE)
_LISTED_ON = re.compile(
    rf"\s*(?P<list>{_LIST})(?: (?:sitting|standing|lying|resting))? "
    rf"(?P<way>on top of|on|in|inside) (?P<below>{_ITEM})\s*[.!]?\s*",
    re.IGNORECASE,
)
_MIXTURES = {
    "f": "apples, oranges and bananas",
    "v": "tomatoes, carrots and onions",
    "b": "apples, carrots and tomatoes",
}
_KINDS = r"(?:(?:fresh|mixed|ripe|colou?rful|tropical|assorted|various) )*"
_MIXED = re.compile(
    rf"(?P<before> (?:of|with) ){_KINDS}(?P<what>fruit|vegetable|veggie)s?"
    r"(?P<both> and (?:fruit|vegetable|veggie)s?)?"
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
    r"(?P<begin>\s*(?:an?|the|my|some)?\s*(?:(?!empty\b)[\w'-]+ ){0,3}?)"
    r"(?P<what>fruit|vegetable|veggie)s? (?P<container>bowl|basket|crate|platter)\b"
    r"(?! (?:full|filled|with|of|that))",
    re.IGNORECASE,
)
_ANOTHER = re.compile(r" (?:with|on|in|beside|holding|next to) ", re.IGNORECASE)


class Item(NamedTuple):
    """One thing of a list."""

    phrase: str
    place: Place
    left_out: str = ""  # other words about it


class Listed(NamedTuple):
    """A list in a prompt, between two of its indices."""

    items: list[Item]
    start: int
    end: int


def in_a_row(prompt: str) -> list[str]:
    """The things of a prompt that is a list of three or more: "a fork, a knife and a spoon"."""
    listed = _LISTED.fullmatch(prompt)
    items = _JOIN.split(listed["list"].strip()) if listed else []
    return items if len(items) > 2 else []


def turned(prompt: str) -> str:
    """The prompt with the support of several things first: "a lamp and a mug on a desk"."""
    listed = _LISTED_ON.fullmatch(prompt)
    if listed is None:
        return prompt
    below = named_in(listed["below"])
    items = [_as_meant(below, one, prompt) for one in _JOIN.split(listed["list"])]
    within = below in known_as.CONTAINERS and below != PLATE
    sit = not within and any(is_creature(named_in(one)) for one in items)
    if sit or not all(_names(one, bare=False) for one in items):
        return prompt
    if not (within or below in TOPS) or (within == listed["way"].startswith("on")):
        return prompt
    return f"{listed['below'].strip()} with {listed['list'].strip()} {'in' if within else 'on'} it"


def listed_in(
    prompt: str, first_of: Callable[[str], str], is_own: Callable[[str, str], bool]
) -> Listed | None:
    """The first list of a prompt, of things with its thing.

    Args:
        first_of: the thing that a text names first, or "".
        is_own: whether a phrase names a thing that the first has by itself.
    """
    for clause in islice(_CLAUSE.finditer(prompt), LOOKED_AT):
        first = first_of(prompt[: clause.start()])
        if first and (found := _placed(prompt[: clause.start()], clause, first, is_own)):
            end = clause.start("list") + found[-1].end
            text = clause["list"]
            items = [Item(_as_meant(first, one.phrase, text), one.where, one.rest) for one in found]
            return Listed(items, clause.start(), end)
    return None


def _as_meant(first: str, phrase: str, text: str) -> str:
    """Things with a desk or on a stove by their full names: a computer mouse."""
    if _COMPUTERS.search(text):
        phrase = _MOUSE.sub("computer mouse", phrase)
    if first in TOPS:
        phrase = _CLOCK.sub("alarm clock", phrase)
    return _POT.sub("cooking pot", phrase) if first in STOVES else phrase


class _Part(NamedTuple):
    """A part of a list between commas."""

    phrase: str  # without its place
    rest: str  # the words of its place
    text: str  # all of it, with the place
    end: int  # in the list
    where: Place = ""  # as stated
    edge: bool = False  # on the first thing's edge, its seat


def _placed(
    before: str, clause: re.Match[str], first: str, is_own: Callable[[str, str], bool]
) -> list[_Part]:
    """The things of the clause up to the last with a place, with the places; none where the clause
    stays as it is."""
    text, full = clause["list"], clause["of"] or (clause["full"] and first not in TOPS)
    alone = full or clause["on"] or clause["by"]  # "with" starts another list
    parts = _parts(re.split(",? with ", text)[0] if alone else text)
    if _is_read_otherwise(clause, first, parts) or (full and not _is_full(before, first, parts)):
        return []
    if full:
        return [part._replace(where="in") for part in parts]
    bare = bool(clause["colon"]) or (len(parts) > 1 and first in TOPS)
    last = parts[-1]
    of_all = "by" if clause["by"] else "" if last.edge or last.where == "by" else last.where
    found = []
    for part in parts:
        whole = _as_meant(first, part.phrase, text)
        is_one = _names(whole, bare)
        place: Place = "" if is_own(whole, first) else place_of(first, whole, is_one)
        if first in LAID and _may_be_drawn(whole):  # a rug with a tiger
            place = ""
        if is_one:
            said = of_all or part.where
            if said == "in" and not fillings.may_hold(first, whole):  # "with a candle inside"
                said = place = ""
            place = said or place or ("on" if clause["on"] else "")
        if _PERCHED.search(part.text) and is_creature(named_in(whole)):
            place = "on"
        found.append(part._replace(where="" if _UNDER.search(part.text) else place))
    if first == PLATE and not all(one.where for one in found):
        return []  # the food is the thing
    while found and not found[-1].where:
        found.pop()
    return found


def _is_read_otherwise(clause: re.Match[str], first: str, parts: list[_Part]) -> bool:
    """Whether it is another kind of list: one with its place, of held things, of a meal, of
    pictures."""
    several, last = len(parts) > 1, parts[-1]
    if (clause["colon"] and first not in TOPS) or (clause["has"] and known_as.is_dressed(first)):
        return True
    if not several and ((last.where and not last.edge) or clause["of"] or clause["full"]):
        return True
    if first == PLATE and not several and named_in(last.phrase) in known_as.EDIBLE:
        return True
    return last.where == "on" and is_pictured(first) and first not in TOPS


def _may_be_drawn(phrase: str) -> bool:
    return is_creature(named_in(phrase)) or named_in(phrase) in known_as.FLOWERS


def _is_full(before: str, first: str, parts: list[_Part]) -> bool:
    """Whether the first thing is a container filled by all of them."""
    if first not in known_as.CONTAINERS or _ANOTHER.search(before):
        return False
    many = [bool(named_in(one.phrase)) and fillings.fills(one.phrase) for one in parts]
    if first == PLATE:
        return all(many)
    return (
        all(x or _names(one.phrase, bare=False) for x, one in zip(many, parts, strict=True))
        and many[0]
    )


def _parts(text: str) -> list[_Part]:
    """The texts between the commas, up to the stated place."""
    end = _END.search(text)
    text = text[: end.start()] if end else text
    found: list[_Part] = []
    at = 0
    while True:
        join = _next_join(text, at)
        phrase = text[at : join.start() if join else len(text)].rstrip()
        where = _WHERE.search(phrase)
        stop, whole = at + len(phrase), phrase
        phrase = phrase[: where.start()] if where else phrase
        stated: Place = ""
        if where:
            stated = "in" if where["within"] else "by" if where["by"] else "on"
        alone = _by_itself(phrase)
        edge = bool(where and where["edge"])
        found.append(_Part(alone, phrase[len(alone) :], whole, stop, stated, edge))
        if where or join is None:
            return found
        at = join.end()


def _by_itself(phrase: str) -> str:
    """The phrase without an activity or a place: "a candle melted over a skull"."""
    for stated in _STATED.finditer(phrase):
        behind = look_up(phrase[stated.end() :].lstrip().split(" ")[0].lower(), SLOTS)
        is_look = stated[0] == " in" and behind is not None and behind.slot == "color"
        if named_in(phrase[: stated.start()]) and not is_look:
            return phrase[: stated.start()]
    return phrase


def _next_join(text: str, begin: int) -> re.Match[str] | None:
    """The end of the item that starts there: behind "a basket of apples and oranges", "a mug with
    hearts and stars"."""
    for join in _JOIN.finditer(text, begin):
        item = text[begin : join.start()]
        goes_on = (" of " in item and "," not in join[0]) or " with " in item
        if not goes_on or _ONE.match(text, join.end()):
            return join
    return None


def _names(phrase: str, bare: bool) -> bool:
    """Whether the item names one thing, or a number of them: "a lamp", but not "wooden legs";
    without an article where ``bare``."""
    whole = re.split(" (?:with|in) ", phrase)[0]
    noun = named_in(whole)
    one = _ONE.match(whole) or (bare and not named(whole).is_many)
    return bool(noun and one) and ends_in_name(whole, noun)


def mixtures_named(prompt: str) -> str:
    """The prompt with kinds in place of "fruit": a bowl of it."""
    before = _MIXED_BEFORE.match(prompt)
    if before:
        name = f"{before['what']} {before['container']}".lower()
        called = before[0] if look_up(name, SLOTS) else before["begin"] + before["container"]
        prompt = f"{called} of {before['what']}{prompt[before.end() :]}"
    prompt = _LISTED_MIXED.sub(" of ", prompt)
    found = _MIXED.search(prompt)
    if found is None or _ANOTHER.search(prompt, 0, found.start()):
        return prompt
    if named_in(prompt[: found.start()]) not in known_as.CONTAINERS | TOPS | {"cube"}:  # a box
        return prompt
    kinds = found["before"] + _MIXTURES["b" if found["both"] else found["what"][0].lower()]
    return prompt[: found.start()] + kinds + prompt[found.end() :]
