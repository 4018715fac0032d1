"""Bouquets, and flowers in a vase: "a bouquet of sunflowers in a vase", "red and white roses".

Standard library only.
"""

import math
import re
from collections.abc import Iterable
from dataclasses import replace

from core.guidance.builtin.words.companions.fillings import named
from core.guidance.builtin.words.companions.fit import Found
from core.guidance.builtin.words.companions.known_as import FLOWERS
from core.guidance.builtin.words.grammar.openers import named_in
from core.guidance.builtin.words.phrases.slots import Companion, Words
from core.guidance.builtin.words.tables.count_words import GROWING

_BUNCH = (
    r"(?:(?:hand-?tied|wedding|bridal|lovely|beautiful|fresh|small|little|big|large|huge|"
    r"mixed|colou?rful) )*(?:bouquet|posy|nosegay|bunch|arrangement|spray|sprig|cluster|bundle)"
)
_VESSEL = r"(?:vase|flower ?pot|planter|jug|pitcher|bucket|basket|mug|teacup|jar|bowl|pot|urn)"
_KIND = r"(?P<flowers>(?:[\w-]+, )*[^,;.!?()]+?)"
_IN = (
    rf"(?:,? (?:placed |standing |arranged |sitting )?(?:in|inside) "
    rf"(?P<vessel>(?:an?|the) (?:[\w-]+ ){{0,4}}?{_VESSEL}))"
)
OF_FLOWERS = re.compile(
    rf"\b(?:(?P<article>an?|the|one) )?{_BUNCH} (?:of|with) {_KIND}"
    rf"(?:{_IN}|(?=$|[,;.!?]| (?:tied|wrapped|with|on|in|held|and an?) ))",
    re.IGNORECASE,
)
# "A rose bouquet", "a flower arrangement in a vase"; a bouquet alone is of flowers.
BY_NAME = re.compile(
    rf"\b(?:(?P<article>an?|the|one) )?(?P<before>(?:(?!of\b|in\b|with\b)[\w-]+ ){{0,3}}?)"
    rf"(?:bouquet|posy|nosegay|flower arrangement|floral arrangement)\b(?! of)(?:{_IN})?",
    re.IGNORECASE,
)
_WILD = re.compile(r"\b(?:wild ?flowers|blooms|blossoms|flowers|flower)\b", re.IGNORECASE)
WRAPPED = re.compile(
    r",? (?:(?:that is|which is|all) )?(?:tied|wrapped|bound|held)"
    r"(?: up| together)? (?:with|in|by) [^,;.!?()]+",
    re.IGNORECASE,
)
BARE = "left out, as only the flowers are made"
OF_ANY_KIND = re.compile(
    r"(?:^|\b(?:of|with|some|several|the|bunch of) )(?:(?:mixed|colou?rful|different|various|"
    r"assorted|fresh|wild|spring|summer|garden|pretty|beautiful|lovely|some|cut|little|small) )*"
    r"(?:wild ?flowers|flowers|blooms|blossoms)\s*$",
    re.IGNORECASE,
)
MIXED = (("rose", 2), ("flower", 2), ("tulip", 2))  # of flowers that nothing else is stated of
HEADS = {"rose": ("petals", "mini"), "tulip": ("petals", "small")}
MOST = 7  # flowers of several kinds
TWO_TONE = "two-tone"


def in_bunches(prompt: str) -> str:
    """The prompt with a bouquet as a bunch of its flowers, or as the vase that is full of them."""
    found = BY_NAME.sub(_by_name, OF_FLOWERS.sub(_of_flowers, prompt))
    return found if found == prompt else WRAPPED.sub("", found)


def _of_flowers(match: re.Match[str]) -> str:
    return _named(match, match["flowers"]) if _is_flowers(match["flowers"]) else match[0]


def _by_name(match: re.Match[str]) -> str:
    before = match["before"].strip()
    kind = f"{before}s" if _is_flowers(before) and not before.endswith("s") else before
    flowers = kind if _is_flowers(before) else f"{before} flowers".strip()
    return _named(match, flowers.replace("wedding ", "").replace("bridal ", ""))


def _named(match: re.Match[str], flowers: str) -> str:
    flowers = _WILD.sub("flowers", flowers)
    if match["vessel"]:
        return f"{match['vessel']} of {flowers}"
    return f"{match['article'] or 'a'} bunch of {flowers}"


def _is_flowers(text: str) -> bool:
    return named_in(_WILD.sub("flowers", text)) in FLOWERS


def are_all_flowers(phrase: str, found: Iterable[Found]) -> bool:
    """Whether all that a vase bears are flowers, and those of a phrase too."""
    borne = [one.words.noun for one in found if one.relation == "bears"]
    return _is_flowers(phrase) and FLOWERS.issuperset(borne)


def fewer_of_each(found: list[Found]) -> list[Found]:
    """Several kinds of flowers that are named for one vase, of each as many as there is room
    for."""
    some = [one for one in found if one.relation == "bears" and one.words.noun in FLOWERS]
    each = [one for one in some if one.words.count == GROWING]
    if len(some) < 2 or not each:
        return found
    count = max(MOST // len(some), 2)
    return [
        one._replace(words=replace(one.words, count=count)) if one in each else one for one in found
    ]


def apart(one: Found) -> list[Found]:
    """The kinds or the colours of the flowers that a vase has, each by itself."""
    each = _kinds(one.words, bool(OF_ANY_KIND.search(one.phrase)))
    return [one._replace(words=words) for words in each]


def as_bouquet(words: Words, prompt: str) -> Words:
    """A bunch of flowers of several kinds or colours: the other ones are in it; flowers in a vase
    are several."""
    wrapped = WRAPPED.search(prompt)
    if wrapped and wrapped[0] not in (rest := in_bunches(prompt)) and rest != prompt:
        what = wrapped[0].strip(" ,")
        notes = (*words.notes, f"{what}: {BARE}.")
        words = replace(words, notes=notes, left_out=(*words.left_out, *what.split()))
    prompt = in_bunches(prompt)
    if words.noun not in FLOWERS:
        return words
    first, _, vessel = prompt.partition(" in ")
    if words.count == 1 and vessel and named(first).is_many:
        in_vase = any(one.relation == "in" for one in words.companions)
        words = replace(words, count=GROWING, order="heap") if in_vase else words
    if words.count < 2:
        return words
    kept = [one for one in words.companions if not _is_more(one)]
    more = [one.words for one in words.companions if _is_more(one)]
    of = prompt.partition(" of ")[2] or prompt
    of = re.split(r"[,;.!?]| (?:tied|wrapped|in|on|with) ", of)[0]
    first, *others = _kinds(replace(words, companions=()), bool(OF_ANY_KIND.search(of.strip())))
    if more:
        count = math.ceil(words.count / (1 + len(more)))
        first = replace(first, count=count)
        others += [replace(one, count=max(one.count, count), order="heap") for one in more]
    borne = [Companion("bears", one) for one in others]
    return replace(first, companions=(*borne, *kept), notes=words.notes, left_out=words.left_out)


def in_bunch(words: Words) -> Words:
    """One of several flowers: the heads of some are too large for that as they are drawn."""
    size = HEADS.get(words.noun)
    if words.count < 2 or size is None or words.part_sizes:
        return words
    return replace(words, part_sizes=(size,))


def _is_more(one: Companion) -> bool:
    return one.relation == "beside" and one.words.noun in FLOWERS


def _kinds(words: Words, any_kind: bool) -> list[Words]:
    """Flowers of one colour and kind each."""
    if words.noun not in FLOWERS or words.count < 2:
        return [words]
    plain = not (words.color or words.material or words.pattern or words.accents)
    if any_kind and plain and words.noun == "flower":
        quiet = replace(words, notes=(), left_out=())
        (first, count), *rest = MIXED
        others = [replace(quiet, noun=noun, count=count) for noun, count in rest]
        return [replace(words, noun=first, count=count), *others]
    if words.pattern == TWO_TONE and words.second and not words.target:
        none = {"second": "", "second_form": "", "pattern": ""}
        many = math.ceil(words.count / 2)
        first = replace(words, count=many, **none)
        rest = replace(words, count=words.count - many, notes=(), left_out=(), **none)
        color = {"color": words.second, "color_form": words.second_form}
        return [first, replace(rest, **color)]
    return [words]
