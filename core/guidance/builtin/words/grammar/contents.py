"""Visible contents: things on a plate or in a chest, reordered so that they are the thing.

"A plate of pancakes" is pancakes with a plate, "a chest full of gold" an open chest. Standard
library only.
"""

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.grammar.tokens import Tokens
from core.guidance.builtin.words.tables.colors import TASTES
from core.guidance.builtin.words.tables.words import ARTICLES, LOOKS, PHRASE_ENDS

PLATES = frozenset("plate plates platter platters tray dish".split())
FOOD = frozenset(GROUPS["Food"]) | frozenset(GROUPS["Fruit and Vegetables"])
HOLDING = (["of"], ["with"])
SERVED_ON = ("platter", "board")  # behind the food's name: "a sushi platter"
BETWEEN = 3  # words between "of" and the food, at most
OPEN_CHEST = ["open", "chest"]
CHESTS = ("chest", "open chest")
FULL = [
    way.split()
    for way in (
        "full of, filled with, overflowing with, brimming with, heaped with, loaded with, packed "
        "with, bursting with, spilling over with, with"
    ).split(", ")
]
RICHES = frozenset(
    """coin coins doubloons treasure treasures riches loot jewels gems jewelry jewellery pearls gold
    silver""".split()
)
AMONG = RICHES | frozenset("golden copper bronze shiny shining glittering sparkling and".split())
FLAVORS = frozenset((*TASTES, "mint", "pistachio", "caramel", "lavender"))  # the others: colours
SHINING = frozenset("glowing gleaming".split())
OPENED = ("open", "opened", "ajar")
HALF = ("half", "slightly", "partly", "wide")  # open
COINS = ("silver", "copper", "bronze")  # they are of gold anyway


def set_contents_first(tokens: Tokens) -> None:
    """Reorder the words where a thing is named by its contents."""
    _serve(tokens)
    _open_chests(tokens)
    _taste(tokens)


def _serve(tokens: Tokens) -> None:
    for at, word in enumerate(tokens.words):
        holds = word in PLATES and tokens.words[at + 1 : at + 2] in HOLDING
        if holds and _is_food(tokens, at + 2):
            begin = tokens.qualities_begin(at, LOOKS)
            served = tokens.words[begin : at + 1]
            tokens.cut(begin, at + 2)
        elif word in SERVED_ON and _names_food(tokens, at):
            served = [word]
            tokens.cut(at, at + 1)
        else:
            continue
        tokens.words += ["with", *served]
        return


def _is_food(tokens: Tokens, begin: int) -> bool:
    """Whether a food starts there, with its qualities before it."""
    for at in range(begin, min(begin + BETWEEN + 1, len(tokens.words))):
        if tokens.words[at] in ARTICLES:
            continue
        if tokens.first_thing(at):
            return tokens.first_thing(at) in FOOD
        if tokens.words[at] in PHRASE_ENDS or at in tokens.breaks:
            return False
    return False


def _names_food(tokens: Tokens, end: int) -> bool:
    """Whether a food's name ends there."""
    return any(
        tokens.thing(" ".join(tokens.words[begin:end])) in FOOD
        for begin in range(max(end - 2, 0), end)
    )


def _open_chests(tokens: Tokens) -> None:
    if tokens.entry(" ".join(OPEN_CHEST)):
        _open_full_chests(tokens)
        _open_stated_chests(tokens)


def _open_stated_chests(tokens: Tokens) -> None:
    """ "A chest, slightly open", "a chest, gold glowing inside"."""
    named = [p for p in map(tokens.first_thing, range(len(tokens.words))) if p in CHESTS]
    if named[:1] != [CHESTS[0]]:
        return
    full, opened = _cut_riches(tokens), _cut_open(tokens)
    if full or opened:
        at = next(k for k in range(len(tokens.words)) if tokens.first_thing(k) in CHESTS)
        count = next(len(p.split()) for p in tokens.phrases(at) if tokens.thing(p) in CHESTS)
        tokens.put(at, at + count, [*OPEN_CHEST, *(["with", "coins"] if full else [])])


def _cut_riches(tokens: Tokens) -> bool:
    """Take out riches that are stated to be inside; whether there were any."""
    for at, word in enumerate(tokens.words):
        if word == "inside" and tokens.ends_phrase(at + 1):
            begin = _riches_begin(tokens, at)
            with_them = begin and begin not in tokens.breaks and tokens.words[begin - 1] == "with"
            if begin < at:
                tokens.cut(begin - bool(with_them), at + 1)
                return True
    return False


def _cut_open(tokens: Tokens) -> bool:
    """Take out that it is open, but not a window next to it; whether it was stated."""
    opened = (k for k, word in enumerate(tokens.words) if word in OPENED)
    at = next((k for k in opened if _is_of_chest(tokens, k + 1)), None)
    if at is None:
        return False
    tokens.cut(at - (at > 0 and tokens.words[at - 1] in HALF), at + 1)
    return True


def _is_of_chest(tokens: Tokens, end: int) -> bool:
    """Whether the words before the index are about a chest or its lid."""
    if tokens.ends_phrase(end) or tokens.words[end] == "lid":
        return True
    return tokens.first_thing(tokens.qualities_end(end, (*LOOKS, "weather"))) in CHESTS


def _riches_begin(tokens: Tokens, end: int) -> int:
    """The start of the riches that end there; the index itself for other words."""
    begin = end
    while begin and begin not in tokens.breaks and tokens.words[begin - 1] in AMONG | SHINING:
        begin -= 1
    return end if RICHES.isdisjoint(tokens.words[begin:end]) else begin


def _open_full_chests(tokens: Tokens) -> None:
    for at in range(len(tokens.words)):
        name = next((p for p in tokens.phrases(at) if tokens.thing(p) in CHESTS), "")
        behind = at + len(name.split())
        full = next((w for w in FULL if tokens.words[behind : behind + len(w)] == w), None)
        if not (name and full):
            continue
        begin = end = behind + len(full)
        while end < len(tokens.words) and tokens.words[end] in AMONG:
            end += 1
        inside = tokens.words[begin:end]
        # "With gold bands" it is closed, "with gold coins" not.
        if RICHES.isdisjoint(inside) or not tokens.ends_phrase(end):
            continue
        tokens.breaks -= set(range(at + 1, end))
        of = [word for word in inside if word in COINS]
        tokens.put(at, end, [*OPEN_CHEST, "with", *of[:1], "coins"])
        return


def _taste(tokens: Tokens) -> None:
    """ "Vanilla and chocolate ice cream" is vanilla."""
    for at in range(1, len(tokens.words)):
        if tokens.first_thing(at) != "ice cream" or tokens.words[at - 1] not in FLAVORS:
            continue
        first = at - 1
        while first and tokens.words[first - 1] in FLAVORS | {"and"}:
            first -= 1
        first += tokens.words[first] == "and"
        others = [word for word in tokens.words[first + 1 : at] if word != "and"]
        tokens.notes += [f"{word}: left out, as one taste is taken." for word in others]
        tokens.breaks -= set(range(first + 1, at + 1))
        tokens.cut(first + 1, at)
        return
