"""Words reordered for the parser: the thing first, and its name in one.

"The seat is red, a chair" is a chair, "a house for birds" a bird house. Standard library only.
"""

import re
from itertools import takewhile

from core.guidance.builtin.words.grammar.findings import with_article
from core.guidance.builtin.words.grammar.lexicon import SLOTS, corrected, look_up
from core.guidance.builtin.words.grammar.look_order import STRANGE, looks_end
from core.guidance.builtin.words.grammar.part_names import is_own, owns
from core.guidance.builtin.words.grammar.tokens import LONGEST, Tokens
from core.guidance.builtin.words.tables.part_tables import WITH_PARTS
from core.guidance.builtin.words.tables.words import (
    ARTICLES,
    COUNTS,
    FILLER,
    IGNORED_ADJECTIVES,
    LOOKS,
    OWN,
    PHRASE_ENDS,
    WITHOUT,
)

HEAPS = COUNTS | {"slice", "piece", "bunch", "glass"}  # before "of" and the thing
POT = "flower pot"
# Things whose names also describe another: "a strawberry and chocolate cake".
SAYS_OF_WHAT = frozenset(
    "crystal bone feather shell strawberry lemon cherry banana pumpkin carrot apple coconut".split()
)
HOLDING = frozenset(("with", "containing", "holding"))
MADE_OF = [way.split() for way in ("made of", "made from", "made out of")]
SHAPED_LIKE = [
    way.split() for way in ("shaped like, in the shape of, in the form of, in shape of").split(", ")
]
# How a word ends that says what something is like.
ADJECTIVE = re.compile(
    "[a-z]{2,}(?:ant|ent|y|ic|al|ive|able|ible|ful|ous|less|ish|ed|ing|some|ern|ine)"
)
APART = 4  # words within a name, at most: "a stack of dusty old leather books"


def set_names_in_order(tokens: Tokens) -> None:
    """Reorder the words where the thing comes late, or its name is split."""
    _join_adjectives(tokens)
    _take_its_shape(tokens)
    _take_owners_first(tokens)
    _take_the_thing_first(tokens)
    _take_plants_first(tokens)
    _leave_listed_out(tokens)
    _name_tins(tokens)
    _join_names_of(tokens)
    _join_names_for(tokens)
    _join_names_made_of(tokens)
    _join_split_names(tokens)
    _set_qualifiers_first(tokens)
    _take_what_has_the_part(tokens)


def _join_adjectives(tokens: Tokens) -> None:
    """ "A vibrant, handwoven rug" is a vibrant handwoven rug."""
    if tokens.words[:1] not in [[article] for article in ARTICLES]:
        return
    while end := min((k for k in tokens.breaks if k > 1), default=0):
        more = list(takewhile(lambda word: word not in PHRASE_ENDS, tokens.words[end:]))
        named = any(map(tokens.has_thing, range(end, end + len(more))))
        before = tokens.words[1:end]
        if end >= len(tokens.words) or not named or not all(map(_is_adjective, before)):
            return
        if all(map(tokens.entry, before)):  # "a red, shiny car"
            return
        tokens.breaks.discard(end)


def _is_adjective(word: str) -> bool:
    """Whether it says what something is like, known or not, as far as its end tells."""
    entry = look_up(word, SLOTS)
    known = entry.slot in (*LOOKS, "weather") if entry else word in IGNORED_ADJECTIVES | FILLER
    return known or (entry is None and ADJECTIVE.fullmatch(word) is not None)


def _take_its_shape(tokens: Tokens) -> None:
    """ "A doorstop shaped like a dog" is a dog, as doorstops are unknown."""
    for at in range(1, len(tokens.words)):
        way = next((w for w in SHAPED_LIKE if tokens.words[at : at + len(w)] == w), None)
        if way is None or not tokens.breaks.isdisjoint(range(at, at + len(way))):
            continue
        word, end = tokens.words[at - 1], at + len(way)
        end += tokens.words[end : end + 1] in [[article] for article in ARTICLES]
        thing = tokens.first_thing(tokens.qualities_end(end, ("color", "material")))
        if thing and tokens.entry(word) is None and not corrected(word):
            names = (" ".join(tokens.words[k : at - 1]) for k in range(max(at - 3, 0), at - 1))
            before = next(filter(tokens.thing, names), "")  # "a pirate ship figurehead"
            tokens.notes.append(f"{word}: made as {with_article('noun', thing)}.")
            tokens.cut(at - 1 - len(before.split()), end)
        return


def _take_owners_first(tokens: Tokens) -> None:
    """ "The roof of the house is red" is a house with a roof that is red."""
    for at in range(1, len(tokens.words) - 2):
        start = at + 1 + (tokens.words[at + 1] in OWN)
        if tokens.words[at] != "of" or not tokens.breaks.isdisjoint(range(at, start + 1)):
            continue
        name = next((phrase for phrase in tokens.phrases(start) if tokens.thing(phrase)), "")
        end = start + len(name.split())
        stated = tokens.words[end : end + 1] in (["is"], ["are"])
        begin = max(at - LONGEST, 0)
        while begin < at and not owns(tokens.thing(name), " ".join(tokens.words[begin:at])):
            begin += 1
        if name and stated and begin < at and tokens.breaks.isdisjoint(range(begin + 1, end + 1)):
            tokens.put(begin, end, [*name.split(), "with", *tokens.words[begin:at]])
            return


def _take_the_thing_first(tokens: Tokens) -> None:
    """ "The seat is red, a chair" is a chair, the seat is red."""
    begins = [0, *sorted(k for k in tokens.breaks if 0 < k < len(tokens.words))]
    parts: list[str] = []  # things before, possible parts of a later one
    found = None
    for begin, end in zip(begins, [*begins[1:], len(tokens.words)], strict=True):
        at = next((k for k in range(begin, end) if tokens.has_thing(k)), end)
        if at == end:
            continue
        thing = tokens.first_thing(at)
        before = set(tokens.words[begin:at]) - {*ARTICLES, "and"}
        name = next(p for p in tokens.phrases(at) if tokens.thing(p))
        ended = tokens.ends_phrase(at + len(name.split()))  # not "a hat, wizard style"
        heads = before.isdisjoint(PHRASE_ENDS) and all(owns(thing, part) for part in parts)
        # "A door, a house" is a door; a red one is the house's.
        given = not parts or any(_is_look(tokens, w) or w in WITHOUT for w in tokens.words[:begin])
        if ended and heads and given and any(owns(thing, word) for word in tokens.words[:begin]):
            found = (begin, end)  # the last: "a red roof, white walls, a house"
        parts.append(name)
    if found:
        tokens.take_first(*found)


def _take_plants_first(tokens: Tokens) -> None:
    """ "A terracotta plant pot with a cactus" is a cactus with a terracotta pot."""
    for at in range(len(tokens.words)):
        name = next((p for p in tokens.phrases(at) if tokens.thing(p) == POT), "")
        behind = at + len(name.split())
        follows = tokens.words[behind : behind + 2]
        if not name or behind in tokens.breaks or not HOLDING.intersection(follows[:1]):
            continue
        if (first := _pots_looks_begin(tokens, at)) is None:
            continue
        begin = behind + 1 + (follows[-1] in OWN)
        for start in range(begin, min(begin + STRANGE + 1, len(tokens.words))):
            plant = next((p for p in tokens.phrases(start) if is_own(tokens.thing(p), "pot")), "")
            end = start + len(plant.split())
            ended = tokens.ends_phrase(end) and tokens.breaks.isdisjoint(range(first + 1, end))
            more = any(is_own(POT, word) for word in tokens.words[end:])
            if plant and ended and not more:
                # "A terracotta pot" is a name by itself.
                named = (word for word in name.split() if _is_look(tokens, word))
                looks = [*tokens.words[first:at], *named]
                tokens.put(first, end, [*tokens.words[begin:end], "with", *looks, "pot"])
                return


def _leave_listed_out(tokens: Tokens) -> None:
    """ "A crystal and gold chandelier" is a gold one, without crystal; so is one "in gold and
    crystal"."""
    for at in range(2, len(tokens.words)):
        joined = tokens.words[at] in SAYS_OF_WHAT and tokens.words[at - 1] == "and"
        before = tokens.qualities_begin(at - 1, LOOKS) < at - 1 if joined else False
        named = any(map(tokens.has_thing, range(at - 1)))
        if (
            before
            and named
            and tokens.ends_phrase(at + 1)
            and tokens.breaks.isdisjoint((at - 1, at))
        ):
            tokens.notes.append(f"{tokens.words[at]}: left out, as one material is taken.")
            tokens.put(at - 1, at + 1, [])
            return
    for at in range(len(tokens.words) - 3):
        if tokens.words[at] not in SAYS_OF_WHAT or tokens.words[at + 1] != "and":
            continue
        end = tokens.qualities_end(at + 2, LOOKS)
        if tokens.has_thing(end) and tokens.breaks.isdisjoint(range(at + 1, end + 1)):
            tokens.notes.append(f"{tokens.words[at]}: left out, as one material is taken.")
            tokens.put(at, end, tokens.words[at + 2 : end])
            return


def _is_look(tokens: Tokens, word: str) -> bool:
    entry = look_up(word, tokens.known)
    return entry is not None and entry.slot in LOOKS


def _pots_looks_begin(tokens: Tokens, at: int) -> int | None:
    """The start of the looks of the pot at the index; None where a plant's pot has none such."""
    begin = at
    while begin and begin not in tokens.breaks and tokens.words[begin - 1] not in OWN:
        begin -= 1
    slots = {one.slot for one in (look_up(w, tokens.known) for w in tokens.words[begin:at]) if one}
    return begin if slots <= set(LOOKS) - {"shape"} else None


def _name_tins(tokens: Tokens) -> None:
    """ "A tin of sardines" is a tin can; its content is left out."""
    for at in range(len(tokens.words) - 2):
        follows = tokens.words[at : at + 2] in (["tin", "of"], ["tins", "of"])
        if follows and tokens.breaks.isdisjoint((at + 1, at + 2)) and not tokens.has_thing(at):
            tokens.put(at, at + 2, ["tin", "can", "full", "of"])
            return


def _join_names_of(tokens: Tokens) -> None:
    """ "A stack of old books" is an old stack of books, which is a thing's name."""
    for at in reversed(range(len(tokens.words) - 3)):
        words = tokens.words[at : at + 3 + APART]
        if (
            words[0] not in HEAPS
            or words[1] != "of"
            or tokens.breaks.intersection(range(at + 1, at + 3))
        ):
            continue
        for k in range(3, len(words)):
            between = words[2:k]
            ended = at + k in tokens.breaks or not PHRASE_ENDS.isdisjoint(between)
            if ended or tokens.thing(words[k - 1]):
                break
            if tokens.thing(f"{words[0]} of {words[k]}"):
                tokens.put(at, at + k, [*between, words[0], "of"])
                break


def _join_names_for(tokens: Tokens) -> None:
    """ "A lamp for the desk" is a desk lamp, "a house for birds" a bird house; "a helmet for a
    biker in black" is a black helmet."""
    for at in reversed(range(1, len(tokens.words) - 1)):
        end = at + 2 + (tokens.words[at + 1] in OWN)
        if tokens.words[at] != "for" or end > len(tokens.words):
            continue
        head, purpose = tokens.words[at - 1], tokens.words[end - 1]
        begin = end + (tokens.words[end : end + 1] == ["in"])
        looks = looks_end(tokens, begin)
        ended = tokens.ends_phrase(looks) or tokens.words[looks] in FILLER
        if not ended or not tokens.breaks.isdisjoint(range(at, looks)):
            continue
        names = [f"{form} {head}" for form in (purpose, purpose.removesuffix("s"))]
        if name := next(filter(tokens.thing, names), ""):
            tokens.put(at - 1, end, name.split())
        elif looks > begin:
            tokens.put(at, looks, [*tokens.words[begin:looks], *tokens.words[at:end]])


def _join_names_made_of(tokens: Tokens) -> None:
    """ "A box made of cardboard" is a cardboard box, which is another thing than a box."""
    for at in reversed(range(1, len(tokens.words) - 2)):
        way = next((w for w in MADE_OF if tokens.words[at : at + len(w)] == w), [])
        end = at + len(way)
        if not way or end >= len(tokens.words) or not tokens.breaks.isdisjoint(range(at, end + 1)):
            continue
        head, of = tokens.words[at - 1], tokens.words[end]
        name = next(filter(tokens.thing, (f"{of} {head}", f"{of}{head}")), "")
        other = bool(name) and tokens.thing(name) != tokens.thing(head)
        if other and tokens.ends_phrase(end + 1):
            tokens.put(at - 1, end + 1, name.split())


def _join_split_names(tokens: Tokens) -> None:
    """ "A modern white house" is a white modern house, which is a thing's name."""
    for at in range(len(tokens.words) - 2):
        qualifier = tokens.words[at]
        entry = look_up(qualifier, tokens.known)
        if entry and (
            entry.slot != "noun" or _is_look(tokens, " ".join(tokens.words[at : at + 2]))
        ):
            continue  # a colour by itself, or "apple green"
        looks = _adjectives_end(tokens, at + 1)
        ahead = range(at + 1, looks + 1)
        if looks == at + 1 or looks == len(tokens.words) or not tokens.breaks.isdisjoint(ahead):
            continue
        if tokens.thing(f"{qualifier} {tokens.words[looks]}"):
            tokens.put(at, looks, [*tokens.words[at + 1 : looks], qualifier])


def _adjectives_end(tokens: Tokens, begin: int) -> int:
    """The end of the looks at the index, with words that do not describe them: "two storey"."""
    end = begin
    while end < len(tokens.words):
        counted = next((p for p in tokens.phrases(end)[:-1] if p in IGNORED_ADJECTIVES), "")
        step = end + len(counted.split()) if counted else looks_end(tokens, end)
        if step == end:
            break
        end = step
    return end


def _set_qualifiers_first(tokens: Tokens) -> None:
    """ "A car sports", "a guitar electric red": in some languages qualifiers come last; "a pirates
    ship" is a pirate ship."""
    for at in range(len(tokens.words) - 1):
        name, word = tokens.words[at : at + 2]
        single = name.removesuffix("s")
        if tokens.thing(f"{single} {word}") and not tokens.thing(f"{name} {word}"):
            tokens.words[at] = name = single  # "a pirates ship"
        own = tokens.thing(name) and not tokens.thing(f"{name} {word}")
        entry = look_up(word, tokens.known)
        apart = (
            at + 1 in tokens.breaks
            or word in FILLER
            or (entry and entry.slot not in ("noun", "part"))
        )
        longer = at > 0 and tokens.thing(
            f"{tokens.words[at - 1]} {name}"
        )  # "street lamp victorian"
        if own and not apart and not longer and tokens.thing(f"{word} {name}"):
            tokens.put(at, at + 2, [word, name])


def _take_what_has_the_part(tokens: Tokens) -> None:
    """ "A horse with a horn" is a unicorn, "a pumpkin with a face" a jack-o'-lantern."""
    at = next((k for k, word in enumerate(tokens.words) if word in WITH_PARTS), -2)
    begins = tokens.words[at + 1 : at + 2] == ["with"] and at + 1 not in tokens.breaks
    if not begins or any(map(tokens.has_thing, range(at))):
        return
    thing, ends = tokens.words[at], PHRASE_ENDS - {*ARTICLES, "and"}
    clause = range(at + 2, min(k for k in (*tokens.breaks, len(tokens.words)) if k > at))
    clause = list(takewhile(lambda word: word not in ends, (tokens.words[k] for k in clause)))
    for name, parts in WITH_PARTS[thing].items():
        part = next((word for word in clause if word in parts.split()), "")
        if part and tokens.thing(name) and not set(WITHOUT).intersection(clause):
            made = with_article("noun", tokens.thing(name))
            tokens.notes.append(f"{thing} with {part}: made as {made}.")
            tokens.put(at, at + 1, name.split())
            return
