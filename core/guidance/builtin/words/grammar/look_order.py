"""Words reordered for the parser: each look right before its thing or part.

"A car with wheels in black" has black wheels, as "a car in black" is black. Standard library only.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from core.guidance.builtin.substances import CLASS_OF, GLASS, natural_kind
from core.guidance.builtin.words.grammar.joined_parts import (
    first_begins,
    may_both_be,
    set_look_on_both,
)
from core.guidance.builtin.words.grammar.lexicon import NAMED, look_up
from core.guidance.builtin.words.grammar.part_names import (
    LIQUID,
    is_own,
    is_wide,
    own_name,
    owns,
    shows_liquid,
)
from core.guidance.builtin.words.grammar.tokens import LONGEST, MADE, Tokens
from core.guidance.builtin.words.tables.colors import TOWARDS
from core.guidance.builtin.words.tables.part_tables import CONTENTS, SAID_OF_PARTS, SURFACE
from core.guidance.builtin.words.tables.words import (
    ARTICLES,
    BANDS,
    COUNTS,
    FIGURES,
    FILLER,
    GOES_WITH,
    LOOKS,
    OWN,
    PHRASE_ENDS,
    PLAIN,
    WITHOUT,
)

OF_LOOKS = ("in", "of", "from")  # before a colour or a material, behind its owner
LINK = re.compile(
    r"(?P<said>(?:(?:that|which|who) )?(?:is|are|was|were|should be|(?:has|have) been) )?"
    r"(?P<glow>(?:(?:that|which) )?(?:glows?|glowing|shines?|shining) )?"
    rf"(?P<way>(?:{'|'.join(MADE)}) (?:out of |of |in |from |with |by )"
    r"|(?:painted|dyed) |(?:in|of|from|with) )?"
    r"(?P<article>(?:an?|the) )?"
)
OVER = ("on", "around", "over", "along", "across")  # before a covered part
# Past participles, by the part that they apply to.
EDGED = {"framed": "frame", "trimmed": "trim", "edged": "trim", "rimmed": "rim", "topped": "top"}
EDGED |= {"banded": "bands", "tipped": "tip head", "capped": "cap", "cushioned": "cushion"}
LONGEST_LINK = 7  # words: "which are made out of the"
# The link starts before the word right behind these.
BEFORE = {
    *MADE,
    *OF_LOOKS,
    *"out by with that which who is are was were been has have should be".split(),
    *"glow glows shine shines".split(),
}
STRANGE = 2  # unknown words before a look, or a plant: "in signal orange"
INSIDES = ("inside", "interior", "lining")
FULL = frozenset("of with containing filled full some".split())  # right before its content
# Units of a material: "sandstone blocks" are sandstone, unless the thing has such a part.
BLOCKS = frozenset("blocks bricks slabs".split())
PIECES = BLOCKS | frozenset("slats sheets panels tiles".split())


def set_looks_in_order(tokens: Tokens) -> None:
    """Reorder words that are not in the order of "with black wheels"."""
    for at in range(len(tokens.words)):
        _set_pattern_last(tokens, at)
        _set_figure_on_part(tokens, at)
    changes = (_name_part, _set_edge, _set_cover_on_part, _drop_place, _set_contents, _drop_pieces)
    for change in (*changes, _set_looks_before):
        for at in _backwards(tokens):
            change(tokens, at)
    for at in _backwards(tokens):
        _set_glow_on_part(tokens, at)
    at = 1
    while at < len(tokens.words) - 1:  # it grows
        set_look_on_both(tokens, at, _thing_before(tokens, at))
        at += 1


def _backwards(tokens: Tokens) -> Iterator[int]:
    """The indices from the last word to the second; words may be removed meanwhile."""
    at = len(tokens.words)
    while (at := min(at, len(tokens.words)) - 1) > 0:
        yield at


def _drop_pieces(tokens: Tokens, at: int) -> None:
    """ "A pyramid, sandstone blocks" is of sandstone, as one of sandstone tiles is; "a house with
    slate tiles" is not of slate."""
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


def _set_pattern_last(tokens: Tokens, at: int) -> None:
    """ "A striped red and white awning" is a red and white striped one; "red and white bands", on a
    thing without bands, are stripes."""
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


def _set_glow_on_part(tokens: Tokens, at: int) -> None:
    """ "A staff, purple crystal on top, glowing": the crystal glows."""
    alone = at in tokens.breaks and at + 1 in (*tokens.breaks, len(tokens.words))
    entry = tokens.entry(tokens.words[at])
    if not alone or entry is None or entry.word != "glowing":
        return
    thing = _thing_before(tokens, at)
    begin = max((k for k in tokens.breaks if k < at), default=0)
    if not begin:  # behind the thing's own name
        begin = 1 + next((k for k in range(at) if tokens.has_thing(k)), at)
    for part in range(begin, at):
        name = own_name(thing, tokens.words[part])
        if name and CLASS_OF.get(natural_kind(thing, name)) == GLASS:
            tokens.cut(at, at + 1)
            tokens.put(part, part + 1, ["glowing", tokens.words[part]])
            return


def _set_cover_on_part(tokens: Tokens, at: int) -> None:
    """ "Black leather on the grip" is a black leather grip, as "blue paint on" it is a blue one."""
    if tokens.words[at] not in OVER or at in tokens.breaks or at + 1 in tokens.breaks:
        return
    start = at + 1 + (tokens.words[at + 1 : at + 2] in [[word] for word in OWN])
    thing = _thing_before(tokens, at)
    part = next((phrase for phrase in tokens.phrases(start) if owns(thing, phrase)), "")
    end = start + len(part.split())
    if not part or start in tokens.breaks or not tokens.ends_phrase(end):
        return
    named = at - (tokens.words[at - 1] in SURFACE)
    begin = tokens.qualities_begin(named)
    last = tokens.entry(tokens.words[at - 1])
    covers = named < at or (last is not None and last.slot == "material")
    introduced = begin in tokens.breaks or tokens.words[begin - 1] in (*GOES_WITH, *ARTICLES, "and")
    if begin < named and covers and introduced:
        tokens.put(begin, end, [*tokens.words[begin:named], *part.split()])


def _name_part(tokens: Tokens, at: int) -> None:
    """ "A cake with white cream" has white icing; "a boy in jeans" denim trousers."""
    *looks, part = SAID_OF_PARTS.get(tokens.words[at], "").split() or [""]
    ended = tokens.ends_phrase(at + 1) or tokens.words[at + 1] == "and"
    entry = tokens.entry(tokens.words[at])
    is_look = entry is not None and entry.slot in LOOKS  # "a cake in cream" is of that colour
    named = not is_look or _introduced_by(tokens, at) == "with"
    if part and ended and named and own_name(_thing_before(tokens, at), part):
        tokens.put(at, at + 1, [*looks, part])


def _set_edge(tokens: Tokens, at: int) -> None:
    """ "A mirror framed in gold" has a gold frame."""
    thing, begin = _thing_before(tokens, at), at + 2
    parts = EDGED.get(tokens.words[at], "").split()
    named = (name for name in parts if own_name(thing, name) and not is_wide(thing, name))
    part = next(named, "")
    end = tokens.qualities_end(begin, ("color", "material")) if parts else begin
    linked = tokens.words[at + 1 : begin] in (["in"], ["with"])
    if not linked or end == begin or not tokens.breaks.isdisjoint(range(at, end)):
        return
    ended = tokens.ends_phrase(end) or tokens.words[end] == "and"
    if ended:
        # A thing without such a part is not all of that: "a table edged in brass".
        tokens.put(at, end, ["with", *tokens.words[begin:end], part or "edges"])


def _introduced_by(tokens: Tokens, at: int) -> str:
    """The word that introduced the phrase at the index, also across "and"; or ""."""
    while at and at not in tokens.breaks:
        at -= 1
        if tokens.words[at] in PHRASE_ENDS - {*ARTICLES, "and"}:
            return tokens.words[at]
    return ""


def _drop_place(tokens: Tokens, at: int) -> None:
    """ "With a cherry on top" names no top; "with velvet inside" is not visible."""
    words, ended = tokens.words, tokens.ends_phrase(at + 1)
    if words[at - 1 : at + 1] == ["on", "top"] and ended and words[at + 1 : at + 2] != ["of"]:
        tokens.cut(at - 1, at + 1)
        return
    if words[at] not in INSIDES or at + 1 not in (*tokens.breaks, len(words)):
        return
    if (begin := tokens.qualities_begin(at, ("color", "material"))) < at:
        stated = " ".join(words[begin : at + 1])
        tokens.notes.append(f"{stated}: left out, as the inside looks like the outside.")
        tokens.cut(begin - (words[begin - 1] in ("with", "and")), at + 1)


def _set_contents(tokens: Tokens, at: int) -> None:
    """ "A jar of honey", "a bottle filled with red wine": a transparent thing has that colour."""
    word, thing = tokens.words[at], _thing_before(tokens, at)
    ended = tokens.ends_phrase(at + 1) or tokens.words[at + 1] == "and"
    if word not in CONTENTS or not ended or not shows_liquid(thing) or is_own(thing, word):
        return
    begin = tokens.qualities_begin(at, ("color",))
    full = begin
    while full > 1 and full not in tokens.breaks and tokens.words[full - 1] in FULL:
        full -= 1
    before = filter(None, map(tokens.entry, tokens.words[:full]))
    colored = any(entry.slot == "color" for entry in before)
    usual = [] if colored else CONTENTS[word].split()  # not "a green bottle of oil"
    looks = tokens.words[begin:at] or usual
    if looks and full < begin:
        tokens.put(full, at + 1, ["with", *looks, LIQUID])


class Link(NamedTuple):
    """The words between a name and its look."""

    end: int  # start of the looks
    is_stated: bool  # by "is", of the sentence's subject
    is_bare: bool  # nothing, "a handle wooden", or only "with"
    glowing: bool = False  # "glow", which is a look too


def _set_looks_before(tokens: Tokens, at: int) -> None:
    """Move the look of a part, or of an accessory, from behind to before it; ``at``: the possible
    start of the link between them."""
    link = _link(tokens, at)
    if link is None or not tokens.breaks.isdisjoint(range(at, link.end + 1)):
        return
    head = _head_begins(tokens, at)
    if link.end == at and _is_look(tokens, head, at + 1):  # "sheet metal"
        return
    if head == at or ((link.is_stated or link.is_bare) and not _is_part(tokens, head, at)):
        return
    end = looks_end(tokens, link.end)
    if end == link.end or not (tokens.ends_phrase(end) or tokens.words[end] == "and"):
        return
    is_its = link.is_stated or _goes_with(tokens, head)
    if is_its and not _looks_so(tokens, head, link.end, end):
        looks = ["glowing"] * link.glowing + tokens.words[link.end : end]
        thing, name = _thing_before(tokens, head), tokens.words[head:at]
        first = first_begins(tokens, head, thing, "are" in tokens.words[at : link.end])
        tokens.put(head, end, [*looks, *name])
        other = tokens.words[first : first + 1] if first < head else []
        names = (" ".join(tokens.words[first:head]).split(" and")[0], " ".join(name))
        if other and may_both_be(tokens, thing, names, looks):
            tokens.put(first, first + 1, [*looks, *other])


def _is_look(tokens: Tokens, begin: int, end: int) -> bool:
    """Whether the words between the indices are one look."""
    entry = look_up(" ".join(tokens.words[begin:end]), tokens.known)
    return end - begin > 1 and entry is not None and entry.slot in LOOKS


def _link(tokens: Tokens, at: int) -> Link | None:
    """The link at the index, if any."""
    words = tokens.words
    whole = look_up(" ".join(words[at : at + 2]), tokens.known)
    of_look = words[at] in OF_LOOKS and whole is not None and whole.slot in LOOKS  # "of ice"
    if of_look and words[at - 1] not in BEFORE:
        return Link(at, is_stated=False, is_bare=False)
    found = LINK.match(" ".join([*words[at : at + LONGEST_LINK], ""]))
    assert found  # of nothing, if of no more
    stated, glow, way, article = found.group("said", "glow", "way", "article")
    end = at + len(found[0].split())
    if end > at and _is_look(tokens, end - 1, end + 1):  # "carved from bone"
        end -= 1
    if words[at - 1] in BEFORE or (article and not (stated or way)):
        return None
    return Link(end, bool(stated or glow), end == at or way == "with ", bool(glow))


def _is_part(tokens: Tokens, begin: int, end: int) -> bool:
    """Whether the name between the indices is a part of the thing before it."""
    name = " ".join(tokens.words[begin:end])
    entry = look_up(name, tokens.known)
    # A colour is not a part, and "in light oak" names no light.
    if name in TOWARDS or (entry is not None and entry.slot in LOOKS):
        return False
    thing = _thing_before(tokens, begin)
    is_named = (entry is not None and entry.slot == "part") or name in NAMED
    return bool(thing) and (is_named or is_own(thing, name) or owns(thing, name))


def _thing_before(tokens: Tokens, end: int) -> str:
    """The first thing named before the index, or ""."""
    things = (tokens.thing(phrase) for at in range(end) for phrase in tokens.phrases(at))
    return next(filter(None, things), "")


def looks_end(tokens: Tokens, begin: int) -> int:
    """The end of the looks at the index, with unknown words between them."""
    end = last = begin  # the last: before what "and" joins
    while end < len(tokens.words):
        joined = end + (end > begin and tokens.words[end] == "and")
        step = _look_ends(tokens, joined)
        if step == joined or not tokens.breaks.isdisjoint(range(end + 1, step)):
            break
        if end in tokens.breaks and end > begin:
            break
        last = end if joined > end else last
        end = step
    # "Walls in brick and slate roof": the slate is the roof's.
    ended = tokens.ends_phrase(end) or tokens.words[end] in ("and", *FILLER)
    return end if last == begin or ended else last


def _look_ends(tokens: Tokens, begin: int) -> int:
    """The end of the one look at the index; the index itself without one."""
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
    """The start of the name that ends before the index; the index itself without one."""
    for count in range(min(LONGEST, end), 0, -1):
        begin = end - count
        phrase = " ".join(tokens.words[begin:end])
        if tokens.breaks.isdisjoint(range(begin + 1, end)) and look_up(phrase, tokens.known):
            return begin
    plain = tokens.words[end - 1] not in {*PHRASE_ENDS, *FILLER, *WITHOUT}
    return end - 1 if plain else end


def _goes_with(tokens: Tokens, head: int) -> bool:
    """Whether the word at the index is in an accessory's phrase."""
    for begin in _phrases_before(tokens, head):
        word = tokens.words[begin - 1] if begin else ""
        introduced = begin in tokens.breaks or (word in GOES_WITH and word != "of")
        if introduced:
            return any(map(tokens.has_thing, range(begin - (begin not in tokens.breaks))))
        if word not in ("and", "or", "of", "made", "out", "its", "whose"):
            return False
    return False


def _phrases_before(tokens: Tokens, head: int) -> Iterator[int]:
    """The start of the phrase with the index, and of those that "and" joins to it."""
    begin = head
    while begin >= 0:
        while begin and begin not in tokens.breaks:
            if tokens.words[begin - 1] in PHRASE_ENDS and tokens.words[begin - 1] not in ARTICLES:
                break
            begin -= 1
        yield begin
        begin -= 1


def _looks_so(tokens: Tokens, head: int, begin: int, end: int) -> bool:
    """Whether the words right before the name already state as much: "yellow eyes in blue"."""
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
