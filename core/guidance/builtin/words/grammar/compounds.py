"""Looks of a part before the thing: "a marble topped table", "a red cap mushroom".

Parsed from left to right the look would be the whole thing's, as in "a marble table". Standard
library only.
"""

from collections.abc import Iterator

from core.guidance.builtin.words.grammar.lexicon import PARTS, look_up
from core.guidance.builtin.words.grammar.part_names import is_wide, own_name
from core.guidance.builtin.words.grammar.tokens import LONGEST, Tokens
from core.guidance.builtin.words.tables.words import LOOKS

ENDING = "ed"
# "Gold plated" means no plate, "crooked" no crook.
NO_PARTS = "plated painted glazed coated varnished covered wrapped crooked".split()
TOPPED_WITH = (["with"], ["by"], ["off"])
JEWELLED = ("jewelled", "jeweled", "bejewelled", "bejeweled")


def set_parts_apart(tokens: Tokens) -> None:
    """Move descriptions of a part behind the rest: "a marble topped table" as "a table, with marble
    top"."""
    at, stated = 0, []
    while at < len(tokens.words):
        part = _meant(tokens, at)
        # "A golden jewelled crown" has no golden gems.
        slots = ("color",) if tokens.words[at] in JEWELLED else LOOKS
        begin = tokens.qualities_begin(at, slots) if part else at
        if begin < at:
            stated.append(["with", *tokens.words[begin:at], part])
            tokens.cut(begin, at + 1)
            at = begin
        else:
            at += 1
    for clause in stated:
        tokens.add_clause(clause)


def _meant(tokens: Tokens, at: int) -> str:
    """The part that the word at the index describes, or ""."""
    word = tokens.words[at]
    # "A flower pot" and "a potted plant" are things by themselves, "ear cups" are parts.
    around = (look_up(" ".join(words), tokens.known) for words in _around(tokens.words, at))
    if any(entry.slot in ("noun", "part") for entry in around if entry):
        return ""
    entry = look_up(word, tokens.known)
    if word in JEWELLED:
        return "gem"
    if word == "topped" and tokens.words[at + 1 : at + 2] in TOPPED_WITH:  # no chocolate top
        return ""
    if entry is None and word.endswith(ENDING) and word not in NO_PARTS:
        forms = (form for stem in _stems(word) for form in (stem, f"{stem}s"))
        return next((form for form in forms if form in PARTS), "")
    if entry is not None and entry.slot in LOOKS:  # "a red stone crown", which has stones
        return ""
    # Of the thing right behind it, or behind its look: "a red lid white teapot".
    end = tokens.qualities_end(at + 1, LOOKS)
    noun = next(filter(None, map(tokens.thing, tokens.phrases(end))), "")
    if not noun or not tokens.breaks.isdisjoint(range(at + 1, end + 1)) or at in tokens.owners:
        return ""
    names = (own_name(noun, word), own_name(noun, f"{word}s"))
    return next((name for name in names if name and not is_wide(noun, word)), "")


def _around(words: list[str], at: int) -> Iterator[list[str]]:
    """The phrases of several words around the index."""
    for count in range(2, LONGEST + 1):
        for begin in range(max(at - count + 1, 0), at + 1):
            yield words[begin : begin + count]


def _stems(word: str) -> Iterator[str]:
    """The stems of a word with such an ending: topped a top, handled a handle, eyed an eye."""
    stem = word.removesuffix(ENDING)
    yield stem
    yield f"{stem}e"
    if stem[-1:] == stem[-2:-1]:
        yield stem[:-1]
