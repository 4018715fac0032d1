"""One description of two parts: "with golden handle and spout", "the legs and arms are chrome".

Standard library only.
"""

from core.guidance.builtin.substances import CLASS_OF, CLOTH, GLASS, METAL, RUBBER, natural_kind
from core.guidance.builtin.words.grammar.lexicon import NAMED, Entry
from core.guidance.builtin.words.grammar.mixture import class_of, suits
from core.guidance.builtin.words.grammar.part_names import is_wide, own_name
from core.guidance.builtin.words.grammar.tokens import LONGEST, Tokens
from core.guidance.builtin.words.tables.words import ARTICLES, LOOKS, WITHOUT

# Parts with a colour of their own, whatever the part before has: "red petals and leaves".
FIXED_KINDS = ("flesh", "leaf", "foliage", "flame", "embers", "eye", "liquid")
FIXED = frozenset(
    """teeth tooth tusks whiskers eyes eye cherry cherries crown gold beard hair blade
    head trunk dial face candles candle""".split()
)
EYES = ("eyes", "eye")
WITH_EYES = ("nose", "mouth", "lips", "buttons", "lights")  # which may look as the eyes do
SOFT = (GLASS, CLOTH, RUBBER)  # these looks seldom apply to other parts


def set_look_on_both(tokens: Tokens, at: int, thing: str) -> None:
    """Repeat the look of the part before the "and" at the index for the part behind it, which has
    none."""
    words = tokens.words
    if words[at] != "and" or not tokens.breaks.isdisjoint((at, at + 1)):
        return
    named = (phrase for phrase in tokens.phrases(at + 1) if _has(tokens, thing, phrase))
    second = next((phrase for phrase in named if not _is_look(tokens, phrase)), "")
    end = at + 1 + len(second.split())
    head = part_begins(tokens, at, thing)
    if not second or head == at or not (tokens.ends_phrase(end) or words[end] == "and"):
        return
    first = " ".join(words[head:at])
    begin = _looks_begin(tokens, head)
    lacked = begin > 0 and words[begin - 1 - (words[begin - 1] in ARTICLES)] in WITHOUT
    looks = _looks(tokens, begin, head)
    if lacked or not looks or _own(tokens, thing, first) == _own(tokens, thing, second):
        return
    names = (_own(tokens, thing, first), _own(tokens, thing, second))
    if _may_both_have(thing, names, (first, second), looks):
        stated = [word for look in looks for word in look.form.split()]
        if "and" in words[begin:head]:  # "a red and white striped sail and flag"
            stated = words[begin:head]
        tokens.put(at + 1, end, [*stated, *second.split()])


def first_begins(tokens: Tokens, head: int, thing: str, are: bool) -> int:
    """The start of the part that "and" joins to the one at the index, so that the look behind it
    applies to both: "the wheels and the roof are black"; else the index itself."""
    article = head > 0 and tokens.words[head - 1] in ARTICLES
    at = head - 1 - article
    both = at > 0 and tokens.words[at] == "and" and tokens.breaks.isdisjoint(range(at, head + 1))
    if not both or (article and not are):
        return head
    first = part_begins(tokens, at, thing)
    bare = first < at and tokens.qualities_begin(first, LOOKS) == first
    return first if bare else head


def may_both_be(tokens: Tokens, thing: str, names: tuple[str, str], looks: list[str]) -> bool:
    """Whether the look behind the second of two parts may also be the first's."""
    copied = Tokens(tokens.known, list(looks))
    stated = _looks(copied, 0, len(looks))
    first, second = (_own(tokens, thing, name) for name in names)
    return bool(stated) and _may_both_have(thing, (second, first), names[::-1], stated)


def part_begins(tokens: Tokens, end: int, thing: str) -> int:
    """The start of the part name that ends before the index, of the thing's own part or of one that
    it lacks; else the index."""
    for count in range(min(LONGEST, end), 0, -1):
        begin = end - count
        name = " ".join(tokens.words[begin:end])
        named = _has(tokens, thing, name) or name in NAMED
        if tokens.breaks.isdisjoint(range(begin + 1, end)) and named:
            return end if _is_look(tokens, name) else begin
    return end


def _has(tokens: Tokens, thing: str, phrase: str) -> bool:
    """Whether the phrase names a part of the thing, and not most of it."""
    return bool(_own(tokens, thing, phrase)) and not is_wide(thing, phrase)


def _own(tokens: Tokens, thing: str, phrase: str) -> str:
    """The thing's own name for the part: a robot's arms are limbs; or ""."""
    entry = tokens.entry(phrase)
    named = entry is not None and entry.slot in ("noun", "part")
    return own_name(thing, phrase) or (own_name(thing, entry.word) if named else "")


def _is_look(tokens: Tokens, phrase: str) -> bool:
    """Whether a phrase is a look, even if a part has that name: "orange", "glass"."""
    entry = tokens.entry(phrase)
    return entry is not None and entry.slot in LOOKS


def _looks_begin(tokens: Tokens, head: int) -> int:
    """The start of the looks before the index, also across an "and": "red and white striped"."""
    begin = tokens.qualities_begin(head, LOOKS)
    while begin > 1 and begin < head and tokens.words[begin - 1] == "and":
        before = tokens.qualities_begin(begin - 1, LOOKS)
        if before == begin - 1 or not tokens.breaks.isdisjoint((begin - 1, begin)):
            break
        begin = before
    return begin


def _looks(tokens: Tokens, begin: int, end: int) -> list[Entry]:
    """The looks between the indices, without shapes, which parts do not have."""
    found, at = [], begin
    while at < end:
        toned = tokens.toned(at)
        sized = [(tokens.entry(phrase), len(phrase.split())) for phrase in tokens.phrases(at)]
        entry, count = toned or next(((one, n) for one, n in sized if one), (None, 1))
        if entry is not None and entry.slot in LOOKS and entry.slot != "shape":
            found.append(entry)
        at += count
    return found


def _may_both_have(
    thing: str, own_names: tuple[str, str], forms: tuple[str, str], looks: list[Entry]
) -> bool:
    """Whether the second of two parts may look like the first: not glass legs. By the thing's own
    names for them, and as written."""
    (own_first, name), (first, second) = own_names, forms
    if first in EYES or not name:
        return bool(name) and second in WITH_EYES
    kind = natural_kind(thing, name)
    if second in FIXED or kind in FIXED_KINDS or CLASS_OF.get(kind) == GLASS:
        return False
    classes = [class_of(one) for one in looks if one.slot == "material"]
    if not own_first and len(classes) < len(looks):  # "a red cushion and legs"
        return False
    own = CLASS_OF.get(kind)
    if own == METAL and any(of != METAL for of in classes):  # a wooden handle, and a steel head
        return False
    return all(
        of == own or (own not in SOFT and of not in SOFT) or suits(thing, name, of) > 0
        for of in classes
    )
