"""Companions: things that a prompt requests with the thing: "a cat on a cushion", "a corgi wearing
a beret".

They are taken out of the prompt before the rest is parsed. Standard library only.
"""

import re
from collections.abc import Callable, Collection, Iterable
from dataclasses import replace
from itertools import islice

from core.guidance.builtin.words.companions import fillings, known_as
from core.guidance.builtin.words.companions.attached import (
    attached_in,
    by_size,
    others_in,
    without_stem,
)
from core.guidance.builtin.words.companions.bouquets import apart, are_all_flowers, fewer_of_each
from core.guidance.builtin.words.companions.fit import (
    Found,
    Reader,
    fitting,
    is_part,
    standing_in,
)
from core.guidance.builtin.words.companions.gathering import Item, listed_in, mixtures_named, turned
from core.guidance.builtin.words.companions.known_as import is_dressed
from core.guidance.builtin.words.companions.numbers import distributed, next_to, on_both_sides
from core.guidance.builtin.words.companions.offspring import like_its_parent, young_in
from core.guidance.builtin.words.companions.phrases import ARTICLES, SAYS_LITTLE, VERBS, items
from core.guidance.builtin.words.companions.poured import poured_in
from core.guidance.builtin.words.companions.whereabouts import BY_IT, Place, place_of
from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up, singulars
from core.guidance.builtin.words.grammar.openers import (
    Opener,
    Relation,
    ends_in_doing,
    named_in,
    openers_in,
)
from core.guidance.builtin.words.grammar.tokens import DOING
from core.guidance.builtin.words.phrases.emblems import FLAT, drawn_in
from core.guidance.builtin.words.tables.count_words import FEW, HEAPED, Order
from core.guidance.builtin.words.tables.pictured import is_pictured

MOST = 4  # with one thing
LOOKED_AT = 12  # of a prompt's phrases: all before are parsed for each
_RELATIONS: dict[Place, Relation] = {
    "on": "bears",
    "three on": "bears",
    "heaped on": "bears",
    "in": "bears",
    "by": "beside",
}
_MANY: dict[Place, tuple[int, Order]] = {"three on": (FEW, "row"), "heaped on": (HEAPED, "heap")}
_HAVING = ("holds", "beside", "bears")


_PLACES = {
    "head": "head|forehead|heads|hair|ears?",
    "face": "face|eyes|nose|snout|muzzle",
    "neck": "neck",
    "back": "back|backs|shoulders?|shell|top|roof|hump|belly|lap",
    "hand": "hands?|paws?|mouth|claws?|beak|bill|arms?|tentacles?|wings?|teeth|grip|trunk|jaws?|"
    "fingers?|talons?|pincers?|hooves|hoof",
}
_WHOSE = "(?:its|his|her|their|the|one|each|both)"
_PLACED = re.compile(
    r"(?<![\w-])(?P<lead>(?:with|has|having|and|carrying|wearing|holding|balancing|bearing|"
    r"carries|bears))"
    r" (?P<phrase>(?:(?!(?:with|has|wearing|holding|carrying|on|in|and an?|that|which)\b)"
    r"[\w'-]+ ){1,8}?)"
    r"(?:(?:sitting|standing|perched|resting|growing|placed|balanced|lying|built|stuck|floating|"
    r"hovering|trapped|suspended|preserved|sealed) )?"
    r"(?:(?:(?:on top of|on|in|between|around|over|atop|upon|from) "
    rf"(?:{_WHOSE} (?:(?:one|left|right|front|two|little|tiny|big) )?(?P<place>"
    rf"{'|'.join(_PLACES.values())})(?! of)))"
    r"|on top of (?P<over>it|them)|on (?P<it>it|them)|in(?:side)? (?P<within>it|them)"
    r"|(?P<inside>inside)(?= ?(?:$|[,.;!?]))"
    rf"|(?P<by>{BY_IT})"
    r"|(?:on|at) (?:the |its )?(?P<top>top)"
    r"(?: of it)?)(?![\w-])",
    re.IGNORECASE,
)
_WITH_ONE = re.compile(r"with an? [\w'-]+(?: [\w'-]+){0,4} ?$", re.IGNORECASE)
# In "a deer with a lantern on its antlers" it is not held.
_ELSEWHERE = re.compile(
    r"\s*(?:inside|(?:in|on|around|through|under|inside|from|over) "
    r"(?:its|his|her|their|the|one|each)\b)",
    re.IGNORECASE,
)
_TOPPED = re.compile(
    r"(?<![\w-])(?:topped|crowned) (?:off )?(?:with|by) (?P<phrase>an? [^,;.!?()]+)", re.IGNORECASE
)


def companions_in(
    prompt: str, read: Reader, first_of: Callable[[str], str], found: Iterable[Found] = ()
) -> tuple[list[Found], str]:
    """The companions of the thing, ``MOST`` at most, and the prompt without them.

    Args:
        read: parses a phrase about another thing by itself.
        first_of: the thing that a text names first, or "".
        found: companions known already, part of the ``MOST``.
    """
    found = list(found)
    search = _Search(standing_in(read), first_of)
    prompt = turned(mixtures_named(prompt))
    steps = (search.young, search.poured, search.attached, search.listed, search.placed)
    steps = (*steps, search.served)
    for step in (*steps, search.filled, search.opened):
        while len(found) < MOST:
            more, prompt = step(prompt, found)
            if not more:
                break
            found += more
    return fewer_of_each(distributed(found)), prompt


def one_more(
    prompt: str,
    read: Reader,
    first_of: Callable[[str], str],
    found: list[Found],
    left_out: Collection[str],
) -> tuple[list[Found], str]:
    """One more companion, of no stated place, that would be left out: "a lamp with a bird"; and the
    prompt without it."""
    drawn = drawn_in(prompt)
    for phrase, start, end in islice(others_in(prompt), LOOKED_AT):
        first = first_of(prompt[:start])
        named = {single for word in phrase.lower().split() for single in singulars(word)}
        relation = by_size(first, phrase) if first and not named.isdisjoint(left_out) else None
        if relation is None or any(a <= start < b for _, a, b in drawn):
            continue
        if one := fitting(standing_in(read), relation, phrase, first, found):
            return [one], _cut(prompt, start, end, [])
    return [], prompt


class _Search:
    """A search for one more companion."""

    def __init__(self, read: Reader, first_of: Callable[[str], str]) -> None:
        self._read, self._first_of = read, first_of

    def young(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "With three ducklings", "and her cub"."""
        drawn = drawn_in(prompt)
        for one in islice(young_in(prompt, self._first_of), LOOKED_AT):
            each = (got.words for got in map(self._read, one.phrases) if got)
            words = next((words for words in each if words.noun == one.parent), None)
            pictured = any(start <= one.start < end for _, start, end in drawn)
            parent = self._read(prompt[: one.start])
            if words is None or parent is None or pictured:
                continue
            words = like_its_parent(words, parent.words, one.count)
            got = Found(one.relation, one.phrases[0], words)
            each = on_both_sides(got, "") if one.relation == "beside" else [got]
            if len(found) + len(each) <= MOST:
                return each, _cut(prompt, one.start, one.end, [])
        return [], prompt

    def attached(self, prompt: str, _: list[Found]) -> tuple[list[Found], str]:
        """ "With mushrooms growing on it", "with lanterns hanging from its branches"."""
        for one in islice(attached_in(prompt, self._first_of), LOOKED_AT):
            many = fillings.named(one.phrase)
            got = self._read(many.phrase if many.is_many and not many.is_counted else one.phrase)
            first = self._first_of(prompt[: one.start])
            if got is None or (is_part(got.entry, first) and not one.is_top):
                continue
            words = without_stem(first, got.words)
            if many.is_many and words.count == 1:
                words = replace(words, count=one.many)
            if one.heaped:
                words = replace(words, order="heap")
            return [Found(one.relation, one.phrase, words)], _cut(prompt, one.start, one.end, [])
        return [], prompt

    def poured(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "Of beer", "full of soil": one filling of the first thing."""
        if any(one.relation == "fills" for one in found):
            return [], prompt
        for one in islice(poured_in(prompt, self._first_of), LOOKED_AT):
            if got := self._read(one.phrase):
                words = replace(got.words, notes=())  # a material is no reading of another
                filling = Found("fills", one.phrase, words)
                return [filling], _cut(prompt, one.start, one.end, [])
        return [], prompt

    def listed(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "With a lamp, a laptop and a mug"."""
        got = listed_in(prompt, lambda text: self._holding(text)[0], self._is_own)
        if got is None or any(start <= got.start < end for _, start, end in drawn_in(prompt)):
            return [], prompt
        first, before = self._holding(prompt[: got.start])
        taken: list[Found] = []
        kept: list[str] = []
        for item in got.items:
            more = self._at_place(item, first, [*found, *taken])
            taken += more
            kept += [] if more else [item.phrase + item.left_out]
        if not taken or (first == fillings.PLATE and kept):
            return [], prompt
        left = [f"with {' and '.join(kept)}"] if kept else []
        whole, start = before + prompt[got.start :], len(before)
        return taken, _cut(whole, start, start + got.end - got.start, left)

    def _holding(self, text: str) -> tuple[str, str]:
        """The thing that a text names first and that holds something, and the text with its name: a
        box is one of cardboard."""
        first = self._first_of(text)
        if first == "cube":  # as a box is parsed by itself
            text = known_as.as_container(text.rstrip()) + " "
            first = self._first_of(text)
        return first, text

    def _is_own(self, phrase: str, first: str) -> bool:
        """Whether it names a thing that the first has by itself, or nothing known."""
        got = self._read(phrase)
        return got is None or is_part(got.entry, first)

    def _at_place(self, item: Item, first: str, found: list[Found]) -> list[Found]:
        """The listed things, as one or two; none without room."""
        if not item.place or len(found) >= MOST:
            return []
        many = _MANY.get(item.place)
        phrase = fillings.named(item.phrase).phrase if many else item.phrase
        one = fitting(self._read, _RELATIONS[item.place], phrase, first, found)
        if one and many:
            one = one._replace(words=replace(one.words, count=many[0], order=many[1]))
        if one and item.place == "in":
            one = self._as_filling(one, first)
        if one is None:
            return []
        more = [word for word in item.left_out.split() if word not in SAYS_LITTLE]
        words = replace(one.words, left_out=(*one.words.left_out, *more))
        one = one._replace(words=words)
        return on_both_sides(one, "") if item.place == "by" else [one]

    def placed(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "With a house on its back", "with a strawberry on top"."""
        drawn = drawn_in(prompt)
        matches = (*_PLACED.finditer(prompt), *_TOPPED.finditer(prompt))
        for match in matches[:LOOKED_AT]:
            first = self._first_of(prompt[: match.start()])
            stated = match.groupdict()
            place = next(
                filter(None, (stated.get(k) for k in ("place", "it", "over", "top"))), "top"
            )
            by = bool(stated.get("by"))
            within = stated.get("within") or stated.get("inside")
            if stated.get("inside") and not fillings.is_some(match["phrase"]):
                continue  # "with green potion inside"
            if within and not fillings.may_hold(first, match["phrase"]):
                continue
            relation = self._at(place.lower(), match["phrase"]) if first else None
            if by and first:
                relation = self._is_next_to(first, match)
            if relation is None or (stated.get("it") and is_pictured(first)):
                continue
            pictures = (one for one, start, end in drawn if start <= match.start() < end)
            is_head = bool(stated.get("place")) and is_dressed(first)
            if any(not is_head or one.text or one.shape in FLAT for one in pictures):
                continue
            # "A cat wearing a hat with a flower on top": that is the hat's.
            clause = re.split(r"[,;.!?]", prompt[: match.start()])[-1]
            if not stated.get("place") and self._has_opener(clause):
                continue
            one = fitting(self._read, relation, match["phrase"].strip(), first, found)
            if one and within:
                one = self._as_filling(one, first)
            if one:
                # "With a skull and a candle on top": the skull is there too.
                before = prompt[: match.start()]
                also = match["lead"].lower() == "and" and _WITH_ONE.search(before)
                where = prompt[match.end("phrase") : match.end()]
                left = [where.strip()] if also and not self._has_opener(clause) else []
                each = next_to(one, where) if by else [one]
                return each, _cut(prompt, match.start(), match.end(), left)
        return [], prompt

    def served(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "A plate of croissants": they are the thing, and are on it."""
        for match in fillings.SERVED.finditer(prompt):
            start, phrase = match.start(), match["phrase"].strip()
            food, plate = self._read(phrase), self._read(match["plate"])
            rest = fillings.portion(food.words.noun, phrase) if food else ""
            if not rest or plate is None or self._first_of(prompt[:start]):
                continue
            if one := fitting(
                self._read, "on", match["plate"], food.words.noun if food else "", found
            ):
                gap = " " if match[0].endswith(" ") else ""
                return [one], f"{prompt[:start]}{rest}{gap}{prompt[match.end() :]}"
        return [], prompt

    def filled(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "A vase of red tulips", "a basket of apples": it bears some."""
        drawn = drawn_in(prompt)
        for match in fillings.FILLED.finditer(prompt):
            if any(start <= match.start() < end for _, start, end in drawn):
                continue
            phrase = match["phrase"].strip()
            first, before = self._holding(prompt[: match.start()])
            later = self._is_later(prompt, match.start())
            full = any(one.relation == "bears" for one in found)
            full &= not are_all_flowers(phrase, found)
            # "A pot of flowers" is a name by itself.
            bare = " ".join(word for word in before.split() if word.lower() not in ARTICLES)
            named = look_up(f"{bare} {match['way']} {phrase}".lower(), SLOTS) is not None
            if later or full or named or not fillings.may_fill(first, match["way"], phrase):
                continue
            one = fitting(self._read, "bears", fillings.named(phrase).phrase, first, found)
            whole, start = before + prompt[match.start() :], len(before)
            if one and (one := self._as_filling(one._replace(phrase=phrase), first)):
                return apart(one), _cut(whole, start, start + len(match[0].rstrip()), [])
        return [], prompt

    @staticmethod
    def _as_filling(one: Found, container: str) -> Found | None:
        words = fillings.filling(one.words, one.phrase, container)
        return one._replace(words=words) if words else None

    def _is_later(self, prompt: str, at: int) -> bool:
        """Whether the words there belong to a companion: "a table with a vase of roses"."""
        return any(one.end < at and not one.weak for one in openers_in(prompt))

    def opened(self, prompt: str, found: list[Found]) -> tuple[list[Found], str]:
        """ "Riding a horse", "on a red cushion", "wearing a hat and a scarf"."""
        drawn = drawn_in(prompt)
        openers = openers_in(prompt)
        for opener in openers[:LOOKED_AT]:
            if any(start <= opener.start < end for _, start, end in drawn):
                continue
            first = self._first_of(prompt[: opener.start])
            surely = opener.verb or (opener.relation == "wears" and not opener.weak)
            if not first or (not surely and ends_in_doing(prompt[: opener.start])):
                continue
            taken: list[Found] = []
            kept: list[str] = []
            end = opener.end
            for begin, end in items(prompt, opener, openers, first):
                phrase = prompt[begin:end].strip()
                both = [*found, *taken]
                one = fitting(
                    self._read, opener.relation, phrase, first, both, opener.verb, opener.weak
                )
                away = one and opener.weak and one.relation in _HAVING
                if one and len(both) < MOST and not (away and _ELSEWHERE.match(prompt, end)):
                    taken += on_both_sides(one, "") if one.relation == "beside" else [one]
                else:
                    kept.append(phrase)
            if taken:
                has = opener.weak and opener.relation == "wears"
                verb = "with" if has else VERBS.get(opener.relation, "")
                left = [verb, " and ".join(kept)] if kept else []
                return taken, _cut(prompt, opener.start, end, left, openers)
        return [], prompt

    def _is_next_to(self, first: str, match: re.Match[str]) -> Relation | None:
        """The relation of a thing next to the first, not on its side, nor worn around it."""
        phrase = match["phrase"].strip()
        if "side" in match["by"] and place_of(first, phrase, is_one=True) != "by":
            return None
        worn = named_in(phrase) in known_as.WORN and is_dressed(first)
        return ("wears" if worn else "beside") if "around" in match["by"] else "beside"

    def _has_opener(self, clause: str) -> bool:
        return any(
            self._first_of(clause[: one.start]) for one in openers_in(clause) if not one.weak
        )

    def _at(self, place: str, phrase: str) -> Relation | None:
        """The relation of the first thing to one at one of its places."""
        noun = named_in(phrase)
        where = next((k for k, forms in _PLACES.items() if re.fullmatch(forms, place)), "back")
        if where == "hand":
            return "holds"
        if where in ("head", "face", "neck") and noun in known_as.WORN:
            return "wears"
        return "bears" if where in ("head", "back") or place == "nose" else None


def _cut(
    prompt: str, start: int, end: int, left: list[str], openers: list[Opener] | None = None
) -> str:
    """The prompt without the words between the indices, except for those ``left``."""
    before = re.sub(r"(?:,? (?:and|while)|,)\s*$", "", prompt[:start].rstrip())
    comma = "," if prompt[:start].rstrip().endswith(",") else ""
    after = prompt[end:]
    if joined := re.match(r",? (?:and|while|plus) ", after):
        begins = {one.start for one in openers or ()}
        goes_on = end + joined.end() in begins or DOING.match(after, joined.end())
        after = f" {'' if goes_on else 'with '}{after[joined.end() :]}"
    text = f"{before}{' '.join(['', *left])}{after if after[:1] in ',.;!?)' else comma + after}"
    return re.sub(r"\s+", " ", re.sub(r"\s+(?=[,;.!?)])", "", text)).strip(" ,")
