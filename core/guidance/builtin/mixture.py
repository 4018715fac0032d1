"""Which parts of a thing are of which of several materials: "a wood and metal desk".

By what its parts are of by nature, and by what people make parts of such a name of: of wood and
steel a hammer has a wooden handle and a chair steel legs. Standard library only.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from core.guidance.builtin.accents import StatedPart
from core.guidance.builtin.colors import shade
from core.guidance.builtin.findings import Findings
from core.guidance.builtin.lexicon import Entry, forms_of, look_up
from core.guidance.builtin.living import is_creature
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.part_names import own_names
from core.guidance.builtin.substances import natural_kind
from core.guidance.builtin.tokens import LONGEST, Tokens
from core.guidance.builtin.variants import VARIANTS
from core.guidance.builtin.words import ARTICLES, COLORED, LOOKS, PHRASE_ENDS, PLAIN

METAL, WOOD, GLASS, CLOTH = "metal", "wood", "glass", "cloth"
STONE, PLASTIC, RUBBER = "stone", "plastic", "rubber"
# The materials' words and the kinds of substances.
_CLASS_OF = {
    METAL: "metal, golden, copper, rusty, cast iron, brushed metal, polished metal, gold leaf",
    WOOD: "wooden",
    GLASS: "glass",
    CLOTH: "fabric, leather, felt, wicker, velvet, paper",
    STONE: "stone, ceramic, masonry, brick, concrete, marble, granite, clay",
    PLASTIC: "plastic",
    RUBBER: "rubber",
}
CLASS_OF = {form: name for name, forms in _CLASS_OF.items() for form in forms_of(forms)}
BY_NATURE, WELL = 2, 4  # how well a part suits the class that it is of by nature; and no doubt
RUSTY = "rusty"
_PLAIN = frozenset(PLAIN) - {"stone"}  # "brick and stone" are two
_LISTING = PHRASE_ENDS - {*ARTICLES}
QUALITIES = ("metallic", "mirrored", "robotic", "enamel", "enameled", "enamelled")
# The colours of metals, where one is the second colour of a thing.
TONES = {"golden": "golden yellow", "metal": "silver grey", "copper": "sienna"}
# How well parts suit a class by their names.
_SUITED = {
    METAL: {
        4: (
            "legs, feet, frame, pole, stand, stem, post, posts, brackets, bands, hoops, rails, "
            "bars, hinges, blade, head, rockers, tap, pegs, buckle, clasp, strings, chain"
        ),
        1: "handle, handles, knob, knobs, rim, base, foot, trim, arms, spout, ladder, body, lid",
    },
    WOOD: {
        2: (
            "top, seat, back, handle, handles, grip, shelf, board, drawers, doors, door, panels, "
            "planks, lid, neck, pole, stock"
        ),
        1: "legs, arms, body, frame, feet, roof, base, foot, stand, step, posts, rim, walls",
    },
    GLASS: {5: "top, glass, windows, window, panels, doors, shade, globe, shelf, jug, screen"},
    CLOTH: {
        5: "seat, back, cushion, cushions, grip, strap, straps, blanket, curtains, canopy, lining",
        2: "handle, handles, shade, belt, flap, arms, body",
    },
    STONE: {
        5: "top, foot, base, walls, basin, column, step, mantel, hearth, chimney, pot, bowl, cup",
        2: "legs",
        1: "body, seat, floor",
    },
    PLASTIC: {4: "seat, back, lid, cap", 2: "handle, handles, knob, knobs, grip, arms, body"},
    RUBBER: {5: "wheels, tracks, sole, grip, grips", 2: "feet, handle, handles"},
}
SUITED = {
    (name, part): points
    for name, rows in _SUITED.items()
    for points, parts in rows.items()
    for part in forms_of(parts)
}


class Beside(NamedTuple):
    """A colour that an "and" joins to a material."""

    color: Entry
    is_behind: bool


class Named(NamedTuple):
    """A material where a prompt names it."""

    entry: Entry
    color: Entry | None  # right before it: "black leather"
    is_listed: bool  # behind a comma, "and", "with" or the like
    beside: Beside | None = None  # a colour: "black and gold", "gold and black"


def share_out(got: Findings, tokens: Tokens) -> None:
    """Of several materials of the whole: the first stays, the others go to the parts that they
    suit. What finds none is left out with its colour, and said. Next to a colour one is a second:
    "a black and gold chair"."""
    named = [one for one in _named(tokens) if one.entry in got.found["material"]]
    if not got.thing or got.is_statue:
        return
    if len(named) == 1 and _is_second(named[0], got):
        _set_beside_color(got, named[0])
    if len(named) < 2 or is_creature(got.thing):
        return
    first, *others = _clearest(named)
    suited = parts_of_each(got.thing, [first.entry, *(one.entry for one in others)])
    got.found["material"] = [first.entry]
    for one in others:
        parts = [part for part, entry in suited.items() if entry == one.entry]
        if not parts and one.is_listed:
            parts = lesser_parts(got.thing, one.entry)
        if one.color in got.found["color"]:
            got.found["color"].remove(one.color)
        if not _state(got, parts, one):
            forms = [each.form for each in (one.color, one.entry) if each]
            got.leave_aside(forms, "one material is taken")


def _is_second(material: Named, got: Findings) -> bool:
    """Whether it is of other parts than the colour next to it, and no quality of all: "grey and
    fluffy", "red and rusty"."""
    entry = material.entry
    quality = entry.word == RUSTY or entry.form in QUALITIES
    colored = material.beside is not None and material.beside.color in got.found["color"]
    return colored and not quality and class_of(entry) in (METAL, WOOD, STONE)


def _state(got: Findings, parts: list[str], material: Named) -> bool:
    """Say of the parts what they are of, unless something is said of them; whether of any."""
    taken = {name for part in got.parts for name in own_names(got.thing, part.name)}
    color = material.color
    look = (color.word, shade(*color[1:])) if color else ("", "")
    stated = [part for part in parts if part not in taken]
    got.parts += [StatedPart(part, True, part, *look, material.entry) for part in stated]
    return bool(stated)


def _set_beside_color(got: Findings, named: Named) -> None:
    """Give some parts the material, and leave the colour to the rest, or the other way about; where
    no part is for it, or a pattern is stated, it is the second colour."""
    material, beside = named.entry, named.beside
    parts = parts_of_color(got.thing, material) if beside and beside.is_behind else []
    if beside and parts and not got.found["pattern"]:
        got.found["color"].remove(beside.color)
        look = (beside.color.word, shade(*beside.color[1:]))
        got.parts += [StatedPart(part, True, part, *look) for part in parts]
        return
    parts = [] if got.found["pattern"] else parts_beside_color(got.thing, material)
    tone = look_up(TONES.get(material.word, ""), got.known)
    if not (parts or tone):
        return
    got.found["material"].remove(material)
    if not _state(got, parts, Named(material, None, True)) and tone:
        got.found["color"].append(tone)


def _clearest(named: list[Named]) -> list[Named]:
    """Without what says no more than what is named before it: "a brass metal lamp", "upholstered in
    velvet", "a see through plastic box"; iron is rusty."""
    kept: list[Named] = []
    for one in named:
        if not kept or not _is_same(kept[-1], one):
            kept.append(one)
        elif one.entry.word == RUSTY or kept[-1].entry.form in PLAIN:
            kept[-1] = one._replace(is_listed=kept[-1].is_listed)
    return kept


def _is_same(before: Named, one: Named) -> bool:
    """Whether two materials in a row are of one and the same part."""
    both = {class_of(before.entry), class_of(one.entry)}
    if one.is_listed:
        plain = before.entry.word == one.entry.word and {before.entry.form, one.entry.form} & _PLAIN
        return bool(plain) or (len(both) == 1 and RUSTY in (before.entry.word, one.entry.word))
    return len(both) == 1 or both == {GLASS, PLASTIC}


def _named(tokens: Tokens) -> Iterator[Named]:
    """The materials that the prompt's words name, in order."""
    words, at, last = tokens.words, 0, 0
    while at < len(words):
        looked = ((look_up(phrase, tokens.known), phrase) for phrase in tokens.phrases(at))
        entry, phrase = next(((one, phrase) for one, phrase in looked if one), (None, ""))
        end = at + max(len(phrase.split()), 1)
        if entry is not None and entry.slot == "material":
            begin = max(tokens.qualities_begin(at), last)
            before = words[max(begin - 1, last) : begin]
            is_listed = begin in tokens.breaks or not _LISTING.isdisjoint(before)
            beside = _beside(tokens, at if before == ["and"] and begin == at else 0, end)
            yield Named(entry, _color(tokens, begin, at), is_listed, beside)
            last = end
        at = end


def _color(tokens: Tokens, begin: int, end: int) -> Entry | None:
    """The colour that ends at the index, of a phrase from ``begin`` on."""
    begin = max(begin, end - LONGEST)
    phrases = (" ".join(tokens.words[at:end]) for at in range(begin, end))
    looked = (look_up(phrase, tokens.known) for phrase in phrases)
    return next((one for one in looked if one and one.slot == "color"), None)


def _beside(tokens: Tokens, begin: int, end: int) -> Beside | None:
    """The colour before the "and" that stands before ``begin``, if that is not 0; or behind the one
    that stands at ``end``, unless it is that of more: "gold and white leather"."""
    before = _color(tokens, 0, begin - 1) if begin else None
    if before:
        return Beside(before, False)
    while tokens.words[end : end + 1] and tokens.words[end] in COLORED:  # "gold coloured and black"
        end += 1
    if tokens.words[end : end + 1] != ["and"] or tokens.breaks.intersection((end, end + 1)):
        return None
    behind = _color(tokens, end + 1, tokens.qualities_end(end + 1, LOOKS))
    return Beside(behind, True) if behind else None


def parts_of_each(noun: str, materials: Sequence[Entry]) -> dict[str, Entry]:
    """The noun's parts that are of another of the materials than the first, which the rest is of.

    The materials are of different classes, or the first of each counts.
    """
    found: dict[str, Entry] = {}
    for part in NOUNS[noun].looks:
        best = max(materials, key=lambda one: suits(noun, part, class_of(one)))
        if best is not materials[0] and suits(noun, part, class_of(best)):
            found[part] = best
    return found


def parts_beside_color(noun: str, material: Entry) -> list[str]:
    """The noun's parts that are of the material where a colour is said next to it, and of the rest:
    what it suits well, without the main parts where nothing would be left of these."""
    name, looks = class_of(material), NOUNS[noun].looks
    by_nature = name != WOOD  # of which much is
    parts = [
        part
        for part in looks
        if suits(noun, part, name) >= WELL or (by_nature and _is_by_nature(noun, part, name))
    ]
    if all(part in parts for part, look in looks.items() if look[0] in "*&"):
        parts = [part for part in parts if looks[part][0] != "*"]
    return parts or _lesser(noun, "+&")


def parts_of_color(noun: str, material: Entry) -> list[str]:
    """The noun's parts that a colour is of behind a material that the noun is of by nature: "a
    silver and black sword"."""
    name, looks = class_of(material), NOUNS[noun].looks
    if not all(_is_by_nature(noun, part, name) for part, look in looks.items() if look[0] == "*"):
        return []
    accents, rest = (
        [part for part in _lesser(noun, roles) if not _is_by_nature(noun, part, name)]
        for roles in ("+&", "-")
    )
    return accents or rest


def lesser_parts(noun: str, material: Entry) -> list[str]:
    """The noun's parts for a second material that suits none better than the first, "a gold and
    silver shield": those that it suits well; else those that are of such a one by nature, or go
    with the main ones."""
    name, looks = class_of(material), NOUNS[noun].looks
    others = [part for part, look in looks.items() if look[0] != "*"]
    return [part for part in others if suits(noun, part, name) >= WELL] or [
        part
        for part in others
        if looks[part][0] == "&" or (looks[part][0] == "+" and _is_by_nature(noun, part, name))
    ]


def suits(noun: str, part: str, name: str) -> int:
    """How well the noun's part suits a class of materials."""
    return BY_NATURE * _is_by_nature(noun, part, name) + SUITED.get((name, part), 0)


def _lesser(noun: str, roles: str) -> list[str]:
    """The noun's parts of these roles, but for those that one looks through."""
    some = [part for part, look in NOUNS[noun].looks.items() if look[0] in roles]
    return [part for part in some if not _is_by_nature(noun, part, GLASS)]


def _is_by_nature(noun: str, part: str, name: str) -> bool:
    """Whether the noun's part is of the class by nature."""
    return CLASS_OF.get(natural_kind(noun, part)) == name


def class_of(material: Entry) -> str:
    """The class of a material, by the kind of what was written or by its word."""
    variant = VARIANTS.get(material.form)
    woven = variant is not None and variant.kind == "wicker"
    return CLOTH if woven else CLASS_OF.get(material.word, material.word)
