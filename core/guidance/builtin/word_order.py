"""Words put in the order in which they are read: looks right before what has them, a name in one.

"A car with wheels in black" has black wheels, as "a car in black" is black. Standard library only.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from core.guidance.builtin.colors import TOWARDS
from core.guidance.builtin.lexicon import NAMED, look_up
from core.guidance.builtin.part_names import is_own, own_name, owns
from core.guidance.builtin.tokens import LONGEST, MADE, Tokens
from core.guidance.builtin.words import (
    ARTICLES,
    BANDS,
    COUNTS,
    FIGURES,
    FILLER,
    GOES_WITH,
    IGNORED_ADJECTIVES,
    LOOKS,
    PHRASE_ENDS,
    PLAIN,
    WITHOUT,
)

OF_LOOKS = ("in", "of", "from")  # before a colour or a material, behind what has it
LINK = re.compile(
    r"(?P<said>(?:(?:that|which|who) )?(?:is|are|should be) )?"
    r"(?P<glow>(?:glow|glowing|shine|shines|shining) )?"
    rf"(?P<way>(?:{'|'.join(MADE)}) (?:out of |of |in |from |with |by )"
    r"|(?:painted|dyed) |(?:in|of|from) )?"
    r"(?P<article>(?:an?|the) )?"
)
LONGEST_LINK = 7  # words: "which are made out of the"
# The link begins before what is right behind these.
BEFORE = {*MADE, *OF_LOOKS, *"out by with that which who is are should be glow shine".split()}
STRANGE = 2  # words before a look that are not known: "in signal orange"
HEAPS = COUNTS | {"slice", "piece", "bunch"}  # of what is then the thing
OWN = (*ARTICLES, "my", "your", "our", "his", "her", "their", "some")
# What a material comes in: "sandstone blocks" are sandstone, where the thing has no such part.
BLOCKS = frozenset("blocks bricks slabs".split())
PIECES = BLOCKS | frozenset("slats sheets panels tiles".split())
POT = "flower pot"
FULL = frozenset(("with", "containing", "holding"))
APART = 4  # words within a name, at most: "a stack of dusty old leather books"


def set_in_order(tokens: Tokens) -> None:
    """Change the words' order where it is another than that of "with black wheels"."""
    _take_the_thing_first(tokens)
    _take_plants_first(tokens)
    _join_names_of(tokens)
    _join_names_for(tokens)
    _join_split_names(tokens)
    _set_qualifiers_first(tokens)
    for at in range(len(tokens.words)):
        _set_pattern_last(tokens, at)
        _set_figure_on_part(tokens, at)
    for at in reversed(range(1, len(tokens.words))):
        _drop_pieces(tokens, at)
    for at in reversed(range(1, len(tokens.words))):
        _set_looks_before(tokens, at)


def _take_the_thing_first(tokens: Tokens) -> None:
    """ "The seat is red, a chair" is a chair, the seat is red."""
    begins = [0, *sorted(k for k in tokens.breaks if 0 < k < len(tokens.words))]
    parts: list[str] = []  # things before, which may be parts of what comes
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
        said = not parts or any(_is_look(tokens, w) or w in WITHOUT for w in tokens.words[:begin])
        if ended and heads and said and any(owns(thing, word) for word in tokens.words[:begin]):
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
        if not name or behind in tokens.breaks or not FULL.intersection(follows[:1]):
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


def _is_look(tokens: Tokens, word: str) -> bool:
    entry = look_up(word, tokens.known)
    return entry is not None and entry.slot in LOOKS


def _pots_looks_begin(tokens: Tokens, at: int) -> int | None:
    """Where what is said of the pot at the index begins; None where a plant's pot has no such."""
    begin = at
    while begin and begin not in tokens.breaks and tokens.words[begin - 1] not in OWN:
        begin -= 1
    slots = {one.slot for one in (look_up(w, tokens.known) for w in tokens.words[begin:at]) if one}
    return begin if slots <= set(LOOKS) - {"shape"} else None


def _drop_pieces(tokens: Tokens, at: int) -> None:
    """ "A pyramid, sandstone blocks" is one of sandstone, as one of sandstone tiles is; "a house
    with slate tiles" is not of slate."""
    word, ended = tokens.words[at], tokens.ends_phrase(at + 1)
    if word not in PIECES or at in tokens.breaks or not (ended or tokens.words[at + 1] == "and"):
        return
    if tokens.qualities_begin(at, ("material",)) == at:
        return
    begin = tokens.qualities_begin(at, ("material", "color"))
    listed = begin in tokens.breaks and word in BLOCKS
    thing = _thing_before(tokens, begin)
    made_of = listed or tokens.words[begin - 1] in ("of", "from")
    if made_of and thing and not own_name(thing, word):
        tokens.cut(at, at + 1)


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
        looks = _looks_end(tokens, begin)
        ended = tokens.ends_phrase(looks) or tokens.words[looks] in FILLER
        if not ended or not tokens.breaks.isdisjoint(range(at, looks)):
            continue
        names = [f"{form} {head}" for form in (purpose, purpose.removesuffix("s"))]
        if name := next(filter(tokens.thing, names), ""):
            tokens.put(at - 1, end, name.split())
        elif looks > begin:
            tokens.put(at, looks, [*tokens.words[begin:looks], *tokens.words[at:end]])


def _join_split_names(tokens: Tokens) -> None:
    """ "A modern white house" is a white modern house, which is a thing's name."""
    for at in range(len(tokens.words) - 2):
        qualifier = tokens.words[at]
        if look_up(qualifier, tokens.known):  # a colour or a thing by itself
            continue
        looks = _adjectives_end(tokens, at + 1)
        ahead = range(at + 1, looks + 1)
        if looks == at + 1 or looks == len(tokens.words) or not tokens.breaks.isdisjoint(ahead):
            continue
        if tokens.thing(f"{qualifier} {tokens.words[looks]}"):
            tokens.put(at, looks, [*tokens.words[at + 1 : looks], qualifier])


def _adjectives_end(tokens: Tokens, begin: int) -> int:
    """Where the looks that begin at the index end, with what says nothing of them: "two storey"."""
    end = begin
    while end < len(tokens.words):
        counted = next((p for p in tokens.phrases(end)[:-1] if p in IGNORED_ADJECTIVES), "")
        step = end + len(counted.split()) if counted else _looks_end(tokens, end)
        if step == end:
            break
        end = step
    return end


def _set_qualifiers_first(tokens: Tokens) -> None:
    """ "A car sports", "a guitar electric red": of some languages what qualifies comes last; "a
    pirates ship" is a pirate ship."""
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
        if own and not apart and tokens.thing(f"{word} {name}"):
            tokens.put(at, at + 2, [word, name])


def _set_pattern_last(tokens: Tokens, at: int) -> None:
    """ "A striped red and white awning" is a red and white striped one; "red and white bands", on
    what has no bands, are stripes."""
    words = tokens.words[at : at + 4]
    slots = [entry.slot if (entry := look_up(word, tokens.known)) else word for word in words]
    together = tokens.breaks.isdisjoint(range(at + 1, at + 4))
    if together and slots == ["pattern", "color", "and", "color"]:
        tokens.put(at, at + 4, [*words[1:], words[0]])
    banded = together and slots[:3] == ["color", "and", "color"] and words[-1] in BANDS
    if banded and not is_own(_thing_before(tokens, at), words[-1]):
        tokens.put(at, at + 4, [*words[:3], "stripes"])


def _set_figure_on_part(tokens: Tokens, at: int) -> None:
    """ "A red shade with white dots" is a red and white spotted shade."""
    words = tokens.words[at : at + 5]
    if len(words) < 5 or words[2] != "with" or tokens.breaks.intersection(range(at + 1, at + 5)):
        return
    first, second, figure = (look_up(words[k], tokens.known) for k in (0, 3, 4))
    colors = all(entry and entry.slot == "color" for entry in (first, second))
    drawn = figure is not None and figure.slot == "pattern" and figure.form in FIGURES
    if colors and drawn and own_name(_thing_before(tokens, at), words[1]):
        tokens.put(at, at + 5, [words[0], "and", words[3], figure.word, words[1]])


class Link(NamedTuple):
    """What stands between a name and how it looks."""

    end: int  # where the looks begin
    is_said: bool  # as by "is", of whatever the sentence is about
    is_bare: bool  # nothing at all: "with a handle wooden"
    glowing: bool = False  # "glow", which says how besides


def _set_looks_before(tokens: Tokens, at: int) -> None:
    """Put what is said of a part, or of what goes with the thing, from behind to before it; ``at``
    is where the link between them may begin."""
    link = _link(tokens, at)
    if link is None or not tokens.breaks.isdisjoint(range(at, link.end + 1)):
        return
    head = _head_begins(tokens, at)
    if head == at or ((link.is_said or link.is_bare) and not _is_part(tokens, head, at)):
        return
    end = _looks_end(tokens, link.end)
    if end == link.end or not (tokens.ends_phrase(end) or tokens.words[end] == "and"):
        return
    is_its = link.is_said or _goes_with(tokens, head)
    if is_its and not _looks_so(tokens, head, link.end, end):
        looks = ["glowing"] * link.glowing + tokens.words[link.end : end]
        tokens.put(head, end, [*looks, *tokens.words[head:at]])


def _link(tokens: Tokens, at: int) -> Link | None:
    """The link that begins at the index, if there is one."""
    words = tokens.words
    whole = look_up(" ".join(words[at : at + 2]), tokens.known)
    if words[at] in OF_LOOKS and whole is not None and whole.slot in LOOKS:  # "of ice"
        return Link(at, is_said=False, is_bare=False)
    found = LINK.match(" ".join([*words[at : at + LONGEST_LINK], ""]))
    assert found  # of nothing, if of no more
    said, glow, way, article = found.group("said", "glow", "way", "article")
    end = at + len(found[0].split())
    if words[at - 1] in BEFORE or (article and not (said or way)):
        return None
    return Link(end, bool(said or glow), end == at, bool(glow))


def _is_part(tokens: Tokens, begin: int, end: int) -> bool:
    """Whether the name between the indices is a part's of the thing before it."""
    name = " ".join(tokens.words[begin:end])
    entry = look_up(name, tokens.known)
    # A colour is none, and "in light oak" says nothing of a light.
    if name in TOWARDS or (entry is not None and entry.slot in LOOKS):
        return False
    thing = _thing_before(tokens, begin)
    is_named = (entry is not None and entry.slot == "part") or name in NAMED
    return bool(thing) and (is_named or is_own(thing, name))


def _thing_before(tokens: Tokens, end: int) -> str:
    """The first thing that is named before the index, or ""."""
    things = (tokens.thing(phrase) for at in range(end) for phrase in tokens.phrases(at))
    return next(filter(None, things), "")


def _looks_end(tokens: Tokens, begin: int) -> int:
    """Where the looks that begin at the index end, with what is unknown between them."""
    end = begin
    while end < len(tokens.words):
        joined = end + (end > begin and tokens.words[end] == "and")
        step = _look_ends(tokens, joined)
        if step == joined or not tokens.breaks.isdisjoint(range(end + 1, step)):
            break
        if end in tokens.breaks and end > begin:
            break
        end = step
    return end


def _look_ends(tokens: Tokens, begin: int) -> int:
    """Where the one look that the index begins ends; the index itself where there is none."""
    for at in range(begin, min(begin + STRANGE + 1, len(tokens.words))):
        if toned := tokens.toned(at):
            return at + toned[1] if toned[0].slot in LOOKS else begin
        for phrase in tokens.phrases(at):
            entry = look_up(phrase, tokens.known)
            if entry is not None:
                return at + len(phrase.split()) if entry.slot in LOOKS else begin
        if tokens.words[at] in {*PHRASE_ENDS, *FILLER, *COUNTS, *WITHOUT}:
            return begin
    return begin


def _head_begins(tokens: Tokens, end: int) -> int:
    """Where the name that ends before the index begins; the index itself if there is none."""
    for count in range(min(LONGEST, end), 0, -1):
        begin = end - count
        phrase = " ".join(tokens.words[begin:end])
        if tokens.breaks.isdisjoint(range(begin + 1, end)) and look_up(phrase, tokens.known):
            return begin
    plain = tokens.words[end - 1] not in {*PHRASE_ENDS, *FILLER, *WITHOUT}
    return end - 1 if plain else end


def _goes_with(tokens: Tokens, head: int) -> bool:
    """Whether the word at the index is of a phrase about what goes with a thing before it."""
    for begin in _phrases_before(tokens, head):
        word = tokens.words[begin - 1] if begin else ""
        introduced = begin in tokens.breaks or (word in GOES_WITH and word != "of")
        if introduced:
            return any(map(tokens.has_thing, range(begin - (begin not in tokens.breaks))))
        if word not in ("and", "or", "of", "made", "out", "its", "whose"):
            return False
    return False


def _phrases_before(tokens: Tokens, head: int) -> Iterator[int]:
    """Where the phrase with the index begins, and those that "and" joins to it."""
    begin = head
    while begin >= 0:
        while begin and begin not in tokens.breaks:
            if tokens.words[begin - 1] in PHRASE_ENDS and tokens.words[begin - 1] not in ARTICLES:
                break
            begin -= 1
        yield begin
        begin -= 1


def _looks_so(tokens: Tokens, head: int, begin: int, end: int) -> bool:
    """Whether what is right before the name says as much of it already: "yellow eyes in blue"."""
    first = tokens.qualities_begin(head, LOOKS)
    before, behind = (
        {
            entry.slot
            for word in tokens.words[a:b]
            if (entry := look_up(word, tokens.known)) and entry.form not in PLAIN
        }
        for a, b in ((first, head), (begin, end))
    )
    return not before.isdisjoint(behind)
