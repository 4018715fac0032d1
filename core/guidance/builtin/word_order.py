"""Words put in the order in which they are read: looks right before what has them, a name in one.

"A car with wheels in black" has black wheels, as "a car in black" is black. Standard library only.
"""

from collections.abc import Iterator

from core.guidance.builtin.lexicon import look_up
from core.guidance.builtin.tokens import LONGEST, Tokens
from core.guidance.builtin.words import (
    ARTICLES,
    COUNTS,
    FILLER,
    GOES_WITH,
    LOOKS,
    PHRASE_ENDS,
    PLAIN,
)

OF_LOOKS = ("in", "of", "from")  # before a colour or a material, behind what has it
MADE = "made painted done finished covered coated upholstered dyed wrapped carved built".split()
BARE = ("painted", "dyed")  # behind these a colour comes by itself: "legs painted white"
BY = ("with", "by")  # behind these too: "covered in", "covered with"
STRANGE = 2  # words before a look that are not known: "in signal orange"
HEAPS = COUNTS | {"slice", "piece", "bunch"}  # of what is then the thing
APART = 4  # words within a name, at most: "a stack of dusty old leather books"


def set_in_order(tokens: Tokens) -> None:
    """Change the words' order where it is another than that of "with black wheels"."""
    _join_names_of(tokens)
    for at in range(len(tokens.words)):
        _set_pattern_last(tokens, at)
    for at in reversed(range(1, len(tokens.words))):
        _set_looks_before(tokens, at)


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
            last = look_up(words[k - 1], tokens.known)
            if ended or (last is not None and last.slot == "noun"):
                break
            entry = look_up(f"{words[0]} of {words[k]}", tokens.known)
            if entry is not None and entry.slot == "noun":
                tokens.put(at, at + k, [*between, words[0], "of"])
                break


def _set_pattern_last(tokens: Tokens, at: int) -> None:
    """ "A striped red and white awning" is a red and white striped one."""
    words = tokens.words[at : at + 4]
    slots = [entry.slot if (entry := look_up(word, tokens.known)) else word for word in words]
    together = tokens.breaks.isdisjoint(range(at + 1, at + 4))
    if together and slots == ["pattern", "color", "and", "color"]:
        tokens.put(at, at + 4, [*words[1:], words[0]])


def _set_looks_before(tokens: Tokens, at: int) -> None:
    """Put what is said of a part, or of what goes with the thing, from behind to before it; ``at``
    is where the link between them may begin."""
    begin = _behind_link(tokens, at)
    if begin is None or not tokens.breaks.isdisjoint(range(at, begin + 1)):
        return
    end = _looks_end(tokens, begin)
    if end == begin or not (tokens.ends_phrase(end) or tokens.words[end] == "and"):
        return
    head = _head_begins(tokens, at)
    if head < at and _goes_with(tokens, head) and not _looks_so(tokens, head, begin, end):
        tokens.put(head, end, [*tokens.words[begin:end], *tokens.words[head:at]])


def _behind_link(tokens: Tokens, at: int) -> int | None:
    """The index behind "in", "made of", "that are painted" and the like, if one is there."""
    words, k = tokens.words, at
    if words[at - 1] in (*MADE, "out", "that", "which"):  # the link begins before
        return None
    whole = look_up(" ".join(words[at : at + 2]), tokens.known)
    if words[at] in OF_LOOKS and whole is not None and whole.slot in LOOKS:  # "of ice"
        return at
    if words[k : k + 1] in (["that"], ["which"]):
        k += 1 + (words[k + 1 : k + 2] in (["is"], ["are"]))
    said = k > at + 1  # "wheels that are black" needs no more
    if words[k : k + 1] and words[k] in MADE:
        k += 1
        ways = (*OF_LOOKS, *BY)
        k += words[k : k + 2] == ["out", "of"]
        said = words[k - 1] in BARE and _look_ends(tokens, k) > k  # "painted white"
    else:
        ways = OF_LOOKS
    if words[k : k + 1] and words[k] in ways:
        k, said = k + 1, True
    while said and words[k : k + 1] and words[k] in ARTICLES:
        k += 1
    return k if said else None


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
        if tokens.words[at] in PHRASE_ENDS | FILLER | COUNTS:
            return begin
    return begin


def _head_begins(tokens: Tokens, end: int) -> int:
    """Where the name that ends before the index begins; the index itself if there is none."""
    for count in range(min(LONGEST, end), 0, -1):
        begin = end - count
        phrase = " ".join(tokens.words[begin:end])
        if tokens.breaks.isdisjoint(range(begin + 1, end)) and look_up(phrase, tokens.known):
            return begin
    plain = tokens.words[end - 1] not in PHRASE_ENDS | FILLER
    return end - 1 if plain else end


def _goes_with(tokens: Tokens, head: int) -> bool:
    """Whether the word at the index is of a phrase about what goes with a thing before it."""
    for begin in _phrases_before(tokens, head):
        word = tokens.words[begin - 1] if begin else ""
        introduced = begin in tokens.breaks or (word in GOES_WITH and word != "of")
        if introduced:
            return any(map(tokens.has_thing, range(begin - (begin not in tokens.breaks))))
        if word not in ("and", "or", "of", "made", "out"):
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
