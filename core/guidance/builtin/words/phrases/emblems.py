"""Texts and shapes to draw on the thing: "a sign that says OPEN", "a mug with a red heart",
"a race car with the number 7", "a sports car with white racing stripes".

They are taken out of the prompt before the rest is parsed. Standard library only.
"""

import re
import unicodedata
from collections.abc import Collection, Iterator
from typing import NamedTuple

from core.guidance.builtin.words.grammar.lexicon import LEXICON
from core.guidance.builtin.words.grammar.openers import named_in
from core.guidance.builtin.words.tables.pictured import is_pictured

MOST = 3  # on one thing
MOST_LETTERS = 48  # of a text
STRIPES = "racing stripes"


class Emblem(NamedTuple):
    """A text or a shape to draw."""

    text: str = ""
    shape: str = ""  # of ``SHAPES``, or ``STRIPES``
    color: str = ""  # or a metal; "": its own, or a visible one
    color_form: str = ""
    on: str = ""  # a part by its word, where stated
    side: str = ""  # front, side, top or back, where stated
    is_scattered: bool = False  # many of the shape, all over
    is_portrait: bool = False  # a picture of the thing that ``shape`` names, in its colour

    def __str__(self) -> str:
        shape = plural(self.shape) if self.is_scattered else self.shape
        drawn = f'"{self.text}"' if self.text else shape
        return f"{self.color_form} {drawn}".strip()


# By their words. Shapes that are always flat are drawn on a thing "with" them.
FLAT = {
    "heart": "heart, love heart",
    "star": "star",
    "smiley": "smiley face, smiley, emoji face, emoji",
    "skull and crossbones": "skull and crossbones, skull and cross bones, jolly roger",
    "flame": "flame, hot rod flame",
    "lightning bolt": "lightning bolt, thunderbolt, bolt of lightning",
    "cross": "cross",
    "peace sign": "peace sign, peace symbol",
    "radiation sign": "radiation sign, radiation symbol, radioactive sign, radioactive symbol",
    "check mark": "check mark, checkmark, tick mark",
    "music note": "music note, musical note",
    "paw print": "paw print, pawprint",
}
# These are things too, and are drawn where stated: "with an anchor on it", "a crown logo".
ALSO_THINGS = {
    "skull": "skull",
    "moon": "crescent moon, moon, crescent",
    "sun": "sun",
    "flower": "flower, daisy",
    "snowflake": "snowflake",
    "arrow": "arrow",
    "crown": "crown",
    "anchor": "anchor",
    "diamond": "diamond",
    "circle": "circle, disc, dot",
    "ring": "ring",
    "square": "square",
    "triangle": "triangle",
    "maple leaf": "maple leaf",
    "leaf": "leaf",
    "paw print": "paw",
}
PARTS_TOO = ("ring", "square", "crown", "leaf")  # what else a thing may come with
SIGNS = {  # by a letter of the font
    "?": "question mark",
    "!": "exclamation mark, exclamation point",
    "$": "dollar sign, dollar symbol, dollar",
    "@": "at sign",
    "&": "ampersand",
    "%": "percent sign",
}


def plural(name: str) -> str:
    """The plural of a shape."""
    irregular = {
        "skull and crossbones": "skulls and crossbones",
        "leaf": "leaves",
        "maple leaf": "maple leaves",
        "daisy": "daisies",
    }
    return irregular.get(name, f"{name}{'es' if name.endswith('s') else 's'}")


def _forms(table: dict[str, str]) -> dict[str, str]:
    return {form: name for name, forms in table.items() for form in forms.split(", ")}


FLAT_FORMS, THING_FORMS, SIGN_FORMS = map(_forms, (FLAT, ALSO_THINGS, SIGNS))
# By words for several of them; spots are a pattern.
_NO_MANY = ("cross", "circle", "ring", "smiley", "check mark")
MANY_FORMS = {
    plural(form): form
    for form, name in (FLAT_FORMS | THING_FORMS).items()
    if name not in _NO_MANY and form != "paw"
} | dict.fromkeys(("roses", "blossoms", "poppies", "sunflowers", "cherry blossoms"), "flower")


def _any(forms: "dict[str, str]") -> str:
    return "|".join(form.replace(" ", "[ -]") for form in sorted(forms, key=len, reverse=True))


def _rule(text: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-]){text}", re.IGNORECASE)


METALS = ("golden", "copper", "metal")  # that a shape or a text may be of
_COLORS = {
    form: word
    for form, (slot, word) in LEXICON.items()
    if slot == "color" or (slot == "material" and word in METALS)
}
_COLOR = rf"(?:(?P<color>{_any(_COLORS)})[ -])?"
_A = r"(?:an? |the |one )?"
_WITHS = "with|featuring|bearing|showing|has|having"
_WITH = rf"(?:{_WITHS}) "
_WORD = r"(?:words?|text|letters?|lettering|inscription|title|name|label|slogan|logo|message)"
_SAYS = r"(?:(?:that |which )?(?:says?|reads?)|saying|reading)"
_MADE = (
    r"(?:paint|print|draw|stitch|embroid|engrav|carv|stamp|writ|stencil|emboss|etch|spray|sew)"
    r"\w*(?:ed|d|n)\b"
)
_MARK = (
    r"(?:emblem|logo|symbol|label|print|design|patch|sticker|motif|badge|decal|icon|drawing|image|"
    r"picture|insignia|crest|graphic|mark)s?(?!\w)"
)
_AFTER = "and|on|onto|across|in|at|with|plus"  # what may come right after a shape
_BOLD = (
    "(?:(?:big|bold|large|small|chunky|fat|block|capital|fancy|cursive|gothic|neat|huge|"
    "bright|tiny|tall|thin|thick|giant) ){0,2}"
)
_INK = "(?:letter(?:s|ing)|text|paint|writing|ink|icing|frosting|thread|chalk)"
_SIDES = r"(?:(?P<side>front|side|top|back)s?|middle|outside)"
_QUOTED = re.compile(r"[\"“”«]([^\"“”«»]+)[\"“”»]|['‘]([^'’]{2,})['’](?!\w)")
_CAPITALS = re.compile(r"([A-Z0-9][A-Z0-9!?&.'-]+(?: [A-Z0-9][A-Z0-9!?&.'-]*){0,3})(?!\w)")
_TITLE = re.compile(r"((?:[A-Z0-9&][\w!?&.'-]*|-)(?: (?:[A-Z0-9&][\w!?&.'-]*|-)){0,7})(?!\w)")
_ENDS = rf"(?!(?:on|in|at|with|and|or|made|of|next|under|above|from|for|to|by|{_MADE})\b)"
_PLAIN = re.compile(rf"(?!(?:an?|the) )({_ENDS}[\w!?&.'-]+(?: {_ENDS}[\w!?&.'-]+){{0,7}})")
_NUMBER = re.compile(r"([A-Z]{0,3}-?\d{1,4}|[A-Z])\b")
# Words before a text, and its forms then.
_OPENERS = (
    (
        _rule(rf"(?:{_WITHS}|and) {_A}{_COLOR}{_WORD}(?: (?:{_SAYS}|of))?:? "),
        (_QUOTED, _CAPITALS, _PLAIN),
    ),
    (
        _rule(r"(?:(?:(?:that|which|who) )?says?|(?:that|which) reads|spelling|saying|titled):? "),
        (_QUOTED, _CAPITALS, _PLAIN),
    ),
    (
        _rule(rf"(?:with )?{_A}{_COLOR}(?:racing )?(?:number |no\. ?|# ?)"),
        (_QUOTED, _NUMBER),
    ),
    (
        _rule(
            rf"(?:{_MADE}|labell?ed|marked|inscribed|lettered|branded|called|named|reading)"
            rf"(?: with)?(?: the)?(?: {_WORD})?:? "
        ),
        (_QUOTED, _TITLE),
    ),
    (_rule(r"with (?=(?:(?!and )[\w']+ ){1,5}written\b)"), (_QUOTED, _CAPITALS, _PLAIN)),
)
# The same with its manner or place: "with FRAGILE on it".
_BY_THE_WAY = _rule(rf"(?:with|and) {_A}{_COLOR}")
_BARE = _rule(r"(?=[\"“”«'‘])")
# Words that may follow an emblem: its colour, its manner, its place.
_TAIL = re.compile(
    rf"(?P<mark> {_MARK})?"
    rf"(?: in {_BOLD}(?:(?P<color>{_any(_COLORS)})(?: {_BOLD}{_INK})?|{_INK})(?!\w))?"
    rf"(?: {_MADE})?"
    rf"(?:,? (?:on|onto|across|in) (?:it\b|them\b|(?:the|its|his|her|both|each) "
    rf"(?:{_SIDES}(?: of (?:it|the \w+))?|(?P<on>\w+))))?"
    rf"(?: in {_BOLD}(?:(?P<after>{_any(_COLORS)})(?: {_BOLD}{_INK})?|{_INK})(?!\w))?",
    re.IGNORECASE,
)
_SHAPE = _rule(
    rf"(?:(?:{_MADE} |marked |decorated )?{_WITH}{_A})?"
    rf"(?:(?:big|bold|large|small|little|simple|cute|single|giant|painted) ){{0,3}}{_COLOR}"
    rf"(?P<shape>{_any(FLAT_FORMS | THING_FORMS | SIGN_FORMS)})"
    rf"(?:(?P<mark>[ -](?:{_MARK}|sign))(?![\w-])|"
    rf"(?=$|[,.;!]| (?!on top(?! of)\b)(?:{_AFTER}|{_MADE})\b))"
)
_SCATTERED = _rule(
    rf"(?:(?:(?:(?:{_MADE} |marked |decorated |covered )(?:with|in)|with|featuring|having) |and )"
    r"(?:(?:lots of|many|some|several|a pattern of|a few|an?) )?)?"
    rf"(?:(?:big|bold|large|small|little|tiny|simple|cute|painted) ){{0,3}}{_COLOR}"
    rf"(?P<shape>{_any(MANY_FORMS)}|floral|"
    rf"(?:{_any(FLAT_FORMS | THING_FORMS)})(?= patterned| pattern| decals| stickers))"
    r"(?P<mark>[ -](?:patterns?|patterned|prints?|printed|motifs?|decals?|stickers?)(?![\w-]))?"
    rf"(?P<all> all over(?: (?:it|them))?| around (?:it|them))?"
    rf"(?:(?<=floral)|(?<=patterned)|(?<=printed)|(?=$|[,.;!]| (?!on top(?! of)\b)"
    rf"(?:{_AFTER}|please|all|{_MADE})\b)(?! in(?:side)? (?:it|them)\b))(?![\w-])"
)
# A picture of a thing: "with a wolf on it", "with a dinosaur print".
_PORTRAIT = _rule(
    rf"(?:(?:{_MADE} |marked |decorated )?{_WITH}{_A})"
    rf"(?:(?:big|bold|large|small|little|simple|cute|single|giant|painted) ){{0,3}}{_COLOR}"
    rf"(?P<thing>[a-z'-]+(?: [a-z'-]+){{0,2}}?)"
    rf"(?:(?P<mark>[ -]{_MARK})(?![\w-])|"
    rf"(?=$|[,.;!]| (?!on top(?! of)\b)(?:{_AFTER}|{_MADE})\b))"
)
_ON_IT, _ON_ITS = (
    re.compile(rf"(?: {_MADE})?,? (?:on|onto|across) (?:{what})\b", re.IGNORECASE)
    for what in ("it", "it|the|its|his|her")
)
# Flat things: another one "with" them is a picture.
_PRINTED = _rule(
    r"(?:t-?shirt|shirt|hoodie|jersey|flag|banner|shield|poster|medal|sticker|badge|coin|"
    r"tarot card|playing card|skateboard|snowboard|surfboard|stamp|tapestry)\b"
)
# Things with pictures on them: a thing "with" them is drawn.
_BEARING = (
    "t-?shirt|shirt|hoodie|jersey|jacket|mug|cup|flag|banner|sign|shield|poster|crate|barrel|"
    "bottle|potion|jar|box|bag|sack|backpack|cap|medal|plate|skateboard|surfboard|pillow|cushion|"
    "rug|book|sticker|badge"
)
_BEARERS = _rule(rf"(?:{_BEARING})\b")
# And many small ones.
_MORE_BEARERS = _rule(
    rf"(?:{_BEARING}|dress|skirt|teapot|teacup|kettle|scarf|socks?|curtains?|umbrella|towel|blanket|"
    r"tie|kite|wallpaper|apron|suitcase|bush|hedge|wreath|hat|cake)(?:e?s)?\b"
)
_VESSELS = _rule(r"(?:vase|bowl|pot|goblet)\b")  # where they are stated to be on it
_OTHERS = re.compile(r"\b(?:with|wearing|holding|on|in|and|next)\b", re.IGNORECASE)
_RACING = _rule(
    rf"(?:with {_A})?(?:two |twin |double )?{_COLOR}(?:(?:racing|go[ -]faster|rally) stripes?|"
    r"stripes? (?:running )?(?:down|along|over) (?:the|its) "
    r"(?:middle|cent(?:er|re)|hood|bonnet|top))(?![\w-])"
)
_ALSO = re.compile(r"^(?:,? and (?!with\b)|, (?=(?:an?|two|three|\d) ))", re.IGNORECASE)
_NOUN = re.compile(rf" (?!(?:{_AFTER})\b)\w")
_BEHIND = re.compile(rf"({_MADE} |marked |decorated )?{_WITH}", re.IGNORECASE)


def emblems_in(prompt: str, but: Collection[str] = ()) -> tuple[tuple[Emblem, ...], str]:
    """The emblems of the thing, stripes first, and the prompt without them; no shapes of
    ``but``."""
    found: list[Emblem] = []
    while len(found) < MOST:
        emblem, rest = emblem_in(prompt, but)
        if emblem is None:
            break
        found.append(emblem)
        prompt = rest
    return tuple(sorted(found, key=lambda one: one.shape != STRIPES)), prompt


def emblem_in(prompt: str, but: Collection[str] = ()) -> tuple[Emblem | None, str]:
    """The first emblem, and the prompt without it."""
    for emblem, start, end in drawn_in(prompt):
        after = prompt[end:]
        also = _ALSO.sub(" with ", after, count=1)
        # "With a heart and a star", "that says HELLO and a heart".
        if _BEHIND.match(prompt, start) or _SHAPE.match(also, 1):
            after = also
        rest = re.sub(r"\s+", " ", f"{prompt[:start]} {after}").strip(" ,")
        rest = re.sub(r" and$|,? and(?=,)", "", rest).replace(" ,", ",")
        if emblem.shape not in but and re.search("[a-z]{2}", rest, re.IGNORECASE):
            return emblem, rest
    return None, prompt


def drawn_in(prompt: str) -> list[tuple[Emblem, int, int]]:
    """All possible emblems, and their places in the prompt."""
    return [*_texts(prompt), *_shapes(prompt), *_portraits(prompt)]


def _texts(prompt: str) -> Iterator[tuple[Emblem, int, int]]:
    """The texts, and the places of their phrases in the prompt."""
    shouted = prompt == prompt.upper()  # all of it in capitals: no sign of a text
    for opener, kinds in (*_OPENERS, (_BY_THE_WAY, (_QUOTED, _CAPITALS)), (_BARE, (_QUOTED,))):
        for match in opener.finditer(prompt):
            stated = (k for k in kinds if not (shouted and k in (_CAPITALS, _TITLE)))
            found = next(filter(None, (kind.match(prompt, match.end()) for kind in stated)), None)
            tail = found and _TAIL.match(prompt, found.end())
            if not found or not tail:
                continue
            text, end = _drawable(next(filter(None, found.groups()))), tail.end()
            if opener is _BARE and tail["mark"]:
                end = found.end()  # "a 'VIP' badge"
            if opener is _BY_THE_WAY and not tail[0]:
                continue
            if opener is _BARE and not (tail[0] or _is_written(text, prompt[end:])):
                continue
            if 0 < len(text) <= MOST_LETTERS and text.isascii():
                given = match.groupdict().get("color") or tail["color"] or tail["after"]
                yield Emblem(text, "", *_color(given), *_place(tail)), match.start(), end


def _is_written(text: str, after: str) -> bool:
    """Whether a quoted text is to be written, not a doubtful word: a 'vintage' car."""
    if text.lower() in LEXICON and text != text.upper():
        return False
    beside = re.match(r"\W*$|[,.;]", after) or _BEARERS.match(after.lstrip())
    return text == text.upper() or bool(beside)


def _shapes(prompt: str) -> Iterator[tuple[Emblem, int, int]]:
    """The shapes, and the places of their phrases in the prompt."""
    for match in _RACING.finditer(prompt):
        yield Emblem("", STRIPES, *_color(match["color"])), match.start(), match.end()
    yield from _scattered(prompt)
    for match in _SHAPE.finditer(prompt):
        tail = _TAIL.match(prompt, match.end())
        form = re.sub("[ -]", " ", match["shape"].lower())
        follows = _BEHIND.match(match[0])  # "a mug with a heart", or "a heart print mug"
        given = match["mark"] or (follows and (follows[1] or (tail and tail[0])))
        flat = form not in THING_FORMS or (form not in PARTS_TOO and _BEARERS.search(prompt))
        if not tail or not (given or (follows and flat)):
            continue
        text, shape = SIGN_FORMS.get(form, ""), FLAT_FORMS.get(form) or THING_FORMS.get(form, "")
        color = _color(match["color"] or tail["color"] or tail["after"])
        # "With a paw print collar": the collar stays.
        of_noun = match["mark"] and not tail[0] and _NOUN.match(prompt, tail.end())
        start = match.start("shape") if of_noun else match.start()
        yield Emblem(text, shape, *color, *_place(tail)), start, tail.end()


def _portraits(prompt: str) -> Iterator[tuple[Emblem, int, int]]:
    """The pictures of things, and the places of their phrases in the prompt."""
    for match in _PORTRAIT.finditer(prompt):
        form = match["thing"].lower()
        slot, noun = LEXICON.get(form, ("", ""))
        tail = _TAIL.match(prompt, match.end())
        if slot != "noun" or not tail or form in FLAT_FORMS:
            continue
        before = prompt[: match.start()]
        printed, first = _PRINTED.search(before), is_pictured(named_in(before))
        follows = _BEHIND.match(match[0])
        drawn = match["mark"] or (follows and follows[1]) or re.match(f" {_MADE}", tail[0])
        # "A cat on a skateboard with a hat on its head": that is no picture.
        if first:
            given = drawn or printed or _ON_ITS.match(tail[0])
        else:
            given = printed and (drawn or _ON_IT.match(tail[0]))
        if not given:
            continue
        color = _color(match["color"] or tail["color"] or tail["after"])
        yield Emblem("", noun, *color, *_place(tail), is_portrait=True), match.start(), tail.end()


def _scattered(prompt: str) -> Iterator[tuple[Emblem, int, int]]:
    """The shapes drawn many times, and the places of their phrases in the prompt."""
    for match in _SCATTERED.finditer(prompt):
        form = re.sub("[ -]", " ", match["shape"].lower())
        is_floral = form == "floral"
        form = MANY_FORMS.get(form, "flower" if is_floral else form)
        tail = _TAIL.match(prompt, match.end())
        assert tail
        follows = _BEHIND.match(match[0])
        first = _OTHERS.split(prompt[: match.start()])[0]
        flat = form not in THING_FORMS or (
            form not in PARTS_TOO and _MORE_BEARERS.search(first) is not None
        )
        bears = form not in THING_FORMS or _MORE_BEARERS.search(first) or _VESSELS.search(first)
        on_it = tail[0] and (bears or tail["on"])
        painted = re.match(rf"{_MADE}|covered|decorated", match[0]) or re.match(
            rf" {_MADE}", tail[0]
        )
        given = is_floral or match["mark"] or match["all"] or painted or on_it
        if not (given or (follows and flat)):
            continue
        shape = FLAT_FORMS.get(form) or THING_FORMS[form]
        color = _color(match["color"] or tail["color"] or tail["after"])
        one = Emblem("", shape, *color, *_place(tail), is_scattered=True)
        # "With floral cushions": the cushions stay.
        of_noun = not tail[0] and _NOUN.match(prompt, tail.end())
        yield one, match.start("shape") if of_noun else match.start(), tail.end()


def _drawable(text: str) -> str:
    """The text in available letters: without accents."""
    plain = unicodedata.normalize("NFKD", text.replace("’", "'"))
    return "".join(c for c in plain if not unicodedata.combining(c)).strip(" .,")


def _place(tail: re.Match[str]) -> tuple[str, str]:
    """The part, and the side."""
    return (tail["on"] or "").lower(), (tail["side"] or "").lower()


def _color(phrase: str | None) -> tuple[str, str]:
    """The word of the colour or of the metal, and its form."""
    form = re.sub("[ -]+", " ", phrase or "").lower()
    return _COLORS.get(form, ""), form
