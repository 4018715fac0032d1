"""The requested number of a thing and its arrangement: "two apples", "a pile of gold coins".

The words for it are taken out before the rest is parsed. Standard library only.
"""

import re
from dataclasses import dataclass
from typing import NamedTuple

from core.guidance.builtin.words.grammar.lexicon import SLOTS, singulars
from core.guidance.builtin.words.grammar.tokens import LONGEST, Tokens
from core.guidance.builtin.words.tables.count_words import (
    ALIKE,
    AS_ONE,
    BOXES,
    CAIRNS,
    CIRCLED,
    COINS,
    COUNTS_OF,
    DOUBLE,
    EVEN_WORDS,
    FEW,
    FEW_WORDS,
    FIGURES,
    GEM,
    GROUPS,
    HEAPED,
    HEAPS,
    LAID,
    LOOSE,
    LYING,
    MANY,
    MANY_WORDS,
    MOST,
    MOST_DIGITS,
    MOST_IN_CIRCLE,
    NO_PLURAL,
    OF_PARTS,
    PAIRED,
    PAIRS,
    PLAIN_STONES,
    PORTIONS,
    RICHES,
    RINGS,
    SAY_LITTLE,
    SETS,
    SEVERAL,
    STACKED,
    STACKS,
    STONES,
    WITHIN,
    WITHOUT_OF,
    Order,
)
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.sizes import usual
from core.guidance.builtin.words.tables.words import (
    ARTICLES,
    FILLER,
    IGNORED_ADJECTIVES,
    OWN,
    PHRASE_ENDS,
    SIZE_WORDS,
)


class Counted(NamedTuple):
    """The number, the arrangement, and the word for them, "" for a plain plural."""

    count: int = 1
    order: Order = "row"
    stated: str = ""


@dataclass
class _StatedCount:
    """The meaning of a number or a word such as "pile", and the index behind it."""

    end: int
    count: int
    order: Order = "row"
    is_number: bool = False
    is_pile: bool = False
    is_vague: bool = False


class _Head(NamedTuple):
    """The place of the thing's name, and whether it is plural."""

    begin: int
    end: int
    is_plural: bool

    def name(self, tokens: Tokens) -> str:
        return " ".join(tokens.words[self.begin : self.end])


def set_counts_apart(tokens: Tokens) -> Counted:
    """Take out the number of the first thing, where that many can be made."""
    _turn_piles(tokens)
    _name_stones(tokens)
    for at in range(len(tokens.words)):
        named = tokens.first_thing(at)
        stated = _stated_count(tokens, at)
        if named and not (stated and _is_more_than_name(tokens, at, named)):
            break
        if stated is None or not _begins(tokens, at, stated):
            continue
        if stated.is_pile:
            _name_what_is_piled(tokens, stated.end)
        head = _head(tokens, stated.end)
        return _taken(tokens, at, stated, head) if head else Counted()
    return _plain(tokens)


def _turn_piles(tokens: Tokens) -> None:
    """ "A coin pile" is a pile of coins, "a rock cairn" a stack of rocks."""
    for at in range(len(tokens.words)):
        word, before = tokens.words[at], tokens.words[max(at - 1, 0)]
        apart = at == 0 or at in tokens.breaks or at - 1 in tokens.owners
        what = "" if apart or before in FILLER else before
        if word in CAIRNS:
            tokens.put(at - (what in STONES), at + 1, ["stack", "of", *STONES["rock"]])
            return
        named = bool(what) and (bool(tokens.thing(what)) or what in STONES)
        piled = word in HEAPS | STACKS and tokens.ends_phrase(at + 1)
        if named and piled and not tokens.thing(f"{what} {word}"):
            many = what if _is_plural([what]) else f"{what}s"
            tokens.put(at - 1, at + 1, [word, "of", many])
            return


def _name_stones(tokens: Tokens) -> None:
    """ "Stones in a circle" are rocks."""
    text = " ".join(tokens.words)
    if any(re.search(rf"\b{form}\b", text) for form in LYING):
        tokens.words = [STONES["stone"][0] if w in PLAIN_STONES else w for w in tokens.words]


def is_many(tokens: Tokens) -> bool:
    """Whether they name several of a thing, with a number or without."""
    head = _head(tokens, 0)
    return head is not None and head.is_plural


def is_plain_plural(phrase: str) -> bool:
    """Whether it begins with several of a thing and no number: "old books", "cats on a sofa"."""
    tokens = Tokens.of(phrase, SLOTS)
    head = _head(tokens, 0)
    if head is None or not head.is_plural or not head.name(tokens).endswith("s"):
        return False
    before, noun = tokens.words[: head.begin], tokens.thing(head.name(tokens))
    *names, last = head.name(tokens).split()
    single = any(tokens.thing(" ".join([*names, one])) == noun for one in singulars(last)[1:])
    is_one = noun in AS_ONE or noun.endswith("s") or not {*ARTICLES, *OWN}.isdisjoint(before)
    return single and not is_one and not any(map(_number, before))


def named_singly(phrase: str, tokens: Tokens) -> str:
    """The phrase with its thing's name in the singular: "old books" is not a stack of books."""
    head = _head(tokens, 0)
    if head is None:
        return phrase
    last = tokens.words[head.end - 1]
    single = _single(tokens, head)
    return phrase[: phrase.lower().rindex(last)] + single if single and last in phrase else phrase


def _stated_count(tokens: Tokens, at: int) -> _StatedCount | None:
    """The count of the word at the index."""
    words = tokens.words
    word, behind = words[at], words[at + 1 : at + 2]
    if at + 1 in tokens.breaks:
        return None
    if word == "half" and "dozen" in words[at + 1 : at + 3]:
        end = words.index("dozen", at) + 1
        return _StatedCount(end + (words[end : end + 1] == ["of"]), MOST, is_number=True)
    if number := _number(word):
        pairs = behind == ["pairs"] and words[at + 2 : at + 3] == ["of"]
        end, number = (at + 3, 2 * number) if pairs else (at + 1, number)
        return _exactly(end, number)
    if word in EVEN_WORDS:
        return _StatedCount(at + 1, EVEN_WORDS[word], is_number=True)
    of = behind == ["of"]
    end = at + 1 + of
    if word in FEW_WORDS and not (word == "some" and of):
        return _StatedCount(end, FEW, is_vague=True)
    if word in MANY_WORDS:
        return _StatedCount(end, MANY, "heap", is_vague=True)
    if not of and word not in WITHOUT_OF:
        return None
    inner = _number(words[end]) if end < len(words) and end not in tokens.breaks else 0
    if word in HEAPS:
        count = min(inner, HEAPED) or HEAPED
        return _StatedCount(end + bool(inner), count, "heap", is_pile=True)
    if word in RINGS and of:
        count = min(inner, MOST) or CIRCLED
        return _StatedCount(end + bool(inner), count, "circle", is_pile=True)
    if word in STACKS:
        count = min(inner, MOST) or STACKED
        return _StatedCount(end + bool(inner), count, "stack", is_pile=True)
    if inner:
        return _exactly(end + 1, inner) if word in {*SETS, *GROUPS} else None
    if word in SETS:
        return _StatedCount(end, SETS[word], is_number=SETS[word] == 2)
    return _StatedCount(end, MANY, "heap") if word in GROUPS else None


def _exactly(end: int, number: int) -> _StatedCount:
    if number > MOST:
        return _StatedCount(end, MANY, "heap", is_number=True)
    return _StatedCount(end, number, is_number=True)


def _number(word: str) -> int:
    """The number of a word, from two on, or 0."""
    if word.isascii() and word.isdigit():
        return int(word) if len(word) < 4 and 2 <= int(word) <= MOST_DIGITS else 0
    return FIGURES.get(word, 0)


def _is_more_than_name(tokens: Tokens, at: int, named: str) -> bool:
    """Whether a thing's name only starts with a count: "pair of socks", and "three candles", which
    may be a candelabra's."""
    name = next(phrase for phrase in tokens.phrases(at) if tokens.thing(phrase))
    number, _, rest = name.partition(" ")
    group = not rest and number in GROUPS | HEAPS | RINGS  # "a school of fish"
    return group or named in PAIRED or bool(_number(number) and tokens.thing(rest))


def _begins(tokens: Tokens, at: int, stated: _StatedCount) -> bool:
    """Whether a count of the first thing is at the index, not of its parts: "a two headed
    dragon"."""
    before = tokens.words[at - 1] if at else ""
    ahead = tokens.words[stated.end : stated.end + 1]
    clause = max((k for k in tokens.breaks if k <= at), default=0)
    if any(tokens.entry(word) for word in tokens.words[:clause]) or not ahead:
        return False
    if stated.is_number and (
        not OF_PARTS.isdisjoint(ahead) or ahead[0].isdigit() or len(ahead[0]) < 2
    ):
        return False
    if stated.end != at + 1 or stated.is_pile:  # "a big pile of"
        before = next((w for w in reversed(tokens.words[:at]) if w in PHRASE_ENDS), "")
        return before in ("", "of", *ARTICLES)
    if before in ("a", "an"):
        return tokens.words[at] in {*WITHOUT_OF, "few", "hundred"}
    if at in tokens.breaks or not before:
        return True
    is_said_of = before in PHRASE_ENDS and before not in ("of", *OWN)
    return not is_said_of and before in FILLER | IGNORED_ADJECTIVES


def _head(tokens: Tokens, begin: int) -> _Head | None:
    """The thing's name at or behind the index."""
    found, portions = None, False
    at = begin
    while at < min(len(tokens.words), begin + WITHIN + LONGEST):
        if at in tokens.breaks and found:
            break
        if many := "" if found else _of_many(tokens, at):
            tokens.words[at], portions = many, True
        name = next((phrase for phrase in tokens.phrases(at) if tokens.thing(phrase)), "")
        word = tokens.words[at]
        if name:
            found = (at, at + len(name.split()))
        elif portions and not found and (many or word == "of"):  # "slices of pizza"
            pass
        elif found or (word in PHRASE_ENDS - {"and"} and at > begin) or at > begin + WITHIN:
            break
        at = found[1] if found else at + 1
    return _Head(*found, portions or _is_plural(tokens.words[slice(*found)])) if found else None


def _of_many(tokens: Tokens, at: int) -> str:
    """The singular of the word there, where that starts a name for several of a thing: "cups of
    coffee", "slices of pizza"."""
    words = tokens.words[at : at + LONGEST]
    if words[1:2] != ["of"] or not tokens.breaks.isdisjoint((at + 1, at + 2)):
        return ""
    names = (s for s in singulars(words[0])[1:] if tokens.thing(" ".join([s, *words[1:]])))
    return next(names, "") or PORTIONS.get(words[0], "")


def _is_plural(words: list[str]) -> bool:
    """Whether a name is in the plural."""
    heads = [words[0], words[-1]] if "of" in words else words[-1:]
    return any(
        word in ALIKE
        or word.endswith(("men", "fish"))
        or (word.endswith("s") and not word.endswith(NO_PLURAL))
        for word in heads
    )


def _single(tokens: Tokens, head: _Head) -> str:
    """The last word of the name in the singular, where that names another thing, or ""."""
    *before, last = tokens.words[head.begin : head.end]
    noun = tokens.thing(head.name(tokens))
    for form in singulars(last)[1:]:
        name = " ".join([*before, form])
        single = tokens.thing(name)
        if single and single != noun:
            return form
    return ""


def _name_what_is_piled(tokens: Tokens, begin: int) -> None:
    """ "A pile of gold" consists of coins, "a stack of boxes" of cardboard boxes."""
    end = next((k for k in range(begin, len(tokens.words)) if tokens.ends_phrase(k + 1)), begin)
    word = tokens.words[end]
    if word in RICHES and tokens.thing(COINS[-1]):
        tokens.put(begin, end + 1, COINS)
    elif stones := STONES.get(word.removesuffix("s")):
        tokens.put(end, end + 1, [*stones])
    elif word in BOXES and end == tokens.qualities_end(begin, ("color",)):
        tokens.put(end, end + 1, ["cardboard", "boxes"])


def _taken(tokens: Tokens, at: int, stated: _StatedCount, head: _Head) -> Counted:
    """Take the words out, if several of the thing named there are possible."""
    words = tokens.words
    pile = " ".join([*words[at : at + 2], words[head.end - 1]])  # "a stack of old books"
    if not head.is_plural or tokens.thing(pile) in SEVERAL:
        return Counted()
    is_exact = stated.is_number and stated.count != MANY
    name = head.name(tokens)
    may_differ = tokens.thing(name) != name  # "horns" are no drinking horns
    if (is_exact or stated.is_pile) and may_differ and (single := _single(tokens, head)):
        words[head.end - 1] = single
    noun = tokens.thing(head.name(tokens))
    word = words[at]
    if words[at] == "ring" and noun == GEM:  # a jewel
        return Counted()
    if noun in SEVERAL:
        tokens.cut(at, stated.end)
        tokens.notes += [] if word in SAY_LITTLE else [f"{word}: one thing is made at a time."]
        return Counted()
    count, order = _fitting(noun, stated)
    if word == "some" and noun in PAIRED:
        count = 2
    for k in reversed(range(stated.end, head.begin)):
        if words[k] in LAID:
            order = order if stated.is_pile else LAID[words[k]][0]
            tokens.cut(k, k + 1)
    order = _cut_how_it_lies(tokens, head.end) or order
    if order in PAIRS and count != 2:
        order = "row"
    if order == "circle" and _number(word):
        count = min(_number(word), MOST_IN_CIRCLE)
    if _number(word) > MOST and count != _number(word):
        tokens.notes.append(f"{word}: {count} are made.")
    tokens.cut(at, stated.end)
    if stated.is_pile:
        _leave_its_size(tokens, at)
    return Counted(count, order, word)


def _cut_how_it_lies(tokens: Tokens, begin: int) -> Order | None:
    """Take out "stacked on top of each other", "in a row"; the arrangement."""
    for at in range(begin, len(tokens.words)):
        for text, order in LYING.items():
            words = text.split()
            if tokens.words[at : at + len(words)] == words:
                tokens.cut(at, at + len(words))
                return order
    return None


def _fitting(noun: str, stated: _StatedCount) -> tuple[int, Order]:
    """The number of the thing, and the arrangement of such things."""
    count = (stated.count + 1) // 2 if noun in DOUBLE and not stated.is_pile else stated.count
    loose = stated.is_pile or (not is_creature(noun) and usual(noun)[0] <= LOOSE)
    return count, stated.order if loose else "row"


def _leave_its_size(tokens: Tokens, at: int) -> None:
    """A huge pile consists of the same things."""
    for k in reversed(range(at)):
        if tokens.words[k] in SIZE_WORDS:
            tokens.cut(k, k + 1)


def _plain(tokens: Tokens) -> Counted:
    """A plain plural is one of it, except for pairs and stacks."""
    at = next((k for k in range(len(tokens.words)) if tokens.has_thing(k)), None)
    if at is None:
        return Counted()
    head = _head(tokens, at)
    if head is None or not head.is_plural:
        return Counted()
    noun = tokens.thing(head.name(tokens))
    if noun in PAIRED:
        return Counted(2)
    laid = next(iter(tokens.words[at - 1 : at]), "") if at else ""
    if noun not in SEVERAL and laid in LAID:
        tokens.cut(at - 1, at)
        order, count = LAID[laid]
        return Counted(count, order)
    order = _cut_how_it_lies(tokens, head.end) if noun not in SEVERAL else None
    return Counted(COUNTS_OF[order], order) if order else Counted()
