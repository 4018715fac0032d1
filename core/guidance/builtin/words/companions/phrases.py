"""Where a phrase about another thing begins and ends: "wearing a hat and a red scarf on a sled".

Standard library only.
"""

import re
from collections.abc import Iterator

from core.guidance.builtin.words.companions import known_as
from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up
from core.guidance.builtin.words.grammar.openers import (
    TOKEN,
    Opener,
    is_doing,
    name_in,
    named_in,
)
from core.guidance.builtin.words.grammar.part_names import is_within, owns
from core.guidance.builtin.words.grammar.tokens import describes
from core.guidance.builtin.words.tables.words import FILLER, IGNORED_ADJECTIVES, PLACES

# Relations that several things may have, with the words for them.
VERBS = {"wears": "wearing", "holds": "holding", "in": "in"}
ARTICLES = frozenset("a an the some his her its their my your".split())
SAYS_LITTLE = FILLER | IGNORED_ADJECTIVES | {"very"}
_STOP = re.compile(r"[,;:.!?()]")
_DECIMAL = re.compile(r"\d\.\d")
_LIST = re.compile(r"(?: and|, and|,) ", re.IGNORECASE)
_AND = ("and", "while", "plus")
_BEYOND = PLACES - set("to as like being among up down out off inside into whose atop".split())


def items(
    prompt: str, opener: Opener, openers: list[Opener], first: str
) -> Iterator[tuple[int, int]]:
    """The ranges of the following things: several may be worn or held."""
    starts = {one.start for one in openers if one.start >= opener.end and _ends_here(prompt, one)}
    begin = opener.end
    while True:
        end = _phrase_end(prompt, begin, starts, first)
        yield begin, end
        listed = _LIST.match(prompt, end)
        if opener.relation not in VERBS or not listed or listed.end() in starts:
            return
        noun = named_in(prompt[listed.end() : _phrase_end(prompt, listed.end(), starts, first)])
        comma = listed[0].startswith(",")
        if not noun or (comma and opener.relation == "holds"):
            return
        also = opener.relation == "holds" or (opener.weak and opener.relation == "wears")
        if noun not in known_as.WORN and (comma or not also):
            return
        begin = listed.end()


def _ends_here(prompt: str, opener: Opener) -> bool:
    """Whether the words before the opener end the phrase."""
    if not opener.weak:
        return True
    noun = named_in(" ".join(prompt[opener.end :].split()[:4]))
    return noun in (known_as.WORN if opener.relation == "wears" else known_as.ENTERED)


def _phrase_end(prompt: str, begin: int, starts: set[int], first: str) -> int:
    """The end of a phrase that starts at the index."""
    tokens = list(TOKEN.finditer(prompt, begin))
    words = [token[0].lower() for token in tokens]
    stop = next((k for k, token in enumerate(tokens) if _stops(prompt, token)), len(tokens))
    name_end = name_in(words[:stop])[1]
    for k, token in enumerate(tokens[:stop]):
        word, named = words[k], 0 <= name_end <= k
        more = words[k + 1 : stop]
        if token.start() in starts and k:
            return _before(prompt, token.start())
        listed = named or (more and more[0] in ARTICLES)
        ends = (
            (word in _AND and listed)
            or (word in _BEYOND and k > 0)
            or ((named or _is_strange(words[:k])) and is_doing(word))
            or (named and word == "in" and _looks_again(words[:k], more))
            or (named and word == "with" and _is_firsts(more, first, named_in(" ".join(words[:k]))))
        )
        if ends:
            return _before(prompt, token.start())
    return _before(prompt, tokens[stop].start() if stop < len(tokens) else len(prompt))


def _stops(prompt: str, token: re.Match[str]) -> bool:
    decimal = _DECIMAL.match(prompt, max(token.start() - 1, 0))
    quoted = prompt[token.end() : token.end() + 2].strip()[:1] in ('"', "“", "'")
    return bool(_STOP.fullmatch(token[0])) and not decimal and not (token[0] == ":" and quoted)


def _before(prompt: str, end: int) -> int:
    return len(prompt[:end].rstrip())


def _is_firsts(words: list[str], first: str, other: str) -> bool:
    """Whether the words of "with" behind the other thing belong to the first: "a dog on a rug with
    big ears"."""
    for word in words[:5]:
        if word in ("and", "on", "in", "with"):
            return False
        if owns(other, word):
            return False
        if owns(first, word) or is_within(first, word):
            return True
    return False


def _is_strange(words: list[str]) -> bool:
    """Whether they end in a possible unknown thing: "a unicycle juggling balls"."""
    word = next(reversed(words), "a")
    return look_up(word, SLOTS) is None and word not in SAYS_LITTLE and not describes(word)


def _looks_again(words: list[str], more: list[str]) -> bool:
    """Whether a colour behind "in" is the first thing's: "a bear with a red scarf in blue"."""

    def is_colored(some: list[str]) -> bool:
        slots = (entry.slot for entry in (look_up(word, SLOTS) for word in some) if entry)
        return "color" in slots

    return (
        bool(more) and is_colored(more[:2]) and not named_in(" ".join(more)) and is_colored(words)
    )
