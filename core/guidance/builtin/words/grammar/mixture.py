"""The parts of a thing for each of several materials: "a wood and metal desk".

By the parts' natural materials, and by usual materials of parts with such names: of wood and steel
a hammer has a wooden handle and a chair steel legs. Standard library only.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from core.guidance.builtin.nouns import GROUPS, NOUNS
from core.guidance.builtin.substances import (
    CLASS_OF,
    CLOTH,
    GLASS,
    METAL,
    PLASTIC,
    RUBBER,
    STONE,
    WOOD,
    natural_kind,
)
from core.guidance.builtin.variants import VARIANTS
from core.guidance.builtin.words.grammar.accents import StatedPart
from core.guidance.builtin.words.grammar.findings import Findings
from core.guidance.builtin.words.grammar.lexicon import Entry, forms_of, look_up
from core.guidance.builtin.words.grammar.part_names import own_names
from core.guidance.builtin.words.grammar.tokens import LONGEST, Tokens
from core.guidance.builtin.words.tables.colors import shade
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.words import (
    ARTICLES,
    COLORED,
    LOOKS,
    PHRASE_ENDS,
    PLAIN,
    STEAM_CLOTHES,
    STEAM_DRIVEN,
    STEAM_GROUPS,
    STEAM_METALS,
    STEAM_WORN,
    STEAMPUNK,
)

GEM_PARTS = ("gem", "gems", "stone")
BY_NATURE, WELL = 2, 4  # score of a part for its natural class; and one without doubt
RUSTY = "rusty"
_PLAIN = frozenset(PLAIN) - {"stone", "plastic"}  # "brick and stone" are two
_LISTING = PHRASE_ENDS - {*ARTICLES}
QUALITIES = ("rusty", "rusted", "rust", "corroded", "metallic", "mirrored", "robotic")
QUALITIES += ("enamel", "enameled", "enamelled")
MADE_OF = ("of", "from", "in", "out")
HOW = ("quilted", "woven", "knitted", "padded")  # which describe how a cloth or a leather is made
# Colours of metals as the second colour of a thing.
TONES = {"golden": "golden yellow", "metal": "silver grey", "copper": "sienna"}
# Scores of parts for a class by their names.
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
        2: "handle, handles, shade, belt, flap, arms",
        1: "body",
    },
    STONE: {
        5: "top, foot, base, walls, basin, column, step, mantel, hearth, chimney, pot, bowl, cup",
        2: "legs",
        1: "body, seat, floor",
    },
    PLASTIC: {4: "seat, back, lid, cap", 1: "handle, handles, knob, knobs, grip, arms, body"},
    RUBBER: {5: "wheels, tracks, sole, grip, grips", 2: "feet, handle, handles"},
}
SUITED = {
    (name, part): points
    for name, rows in _SUITED.items()
    for points, parts in rows.items()
    for part in forms_of(parts)
}


class Named(NamedTuple):
    """A material in a prompt."""

    entry: Entry
    color: Entry | None = None  # right before it: "black leather"
    joined_by: str = ""  # a comma, "and", "with" or similar before it
    before: Entry | None = None  # the last colour before these: "black and gold"
    behind: Entry | None = None  # one joined by "and": "gold and black"


def distribute_materials(got: Findings, tokens: Tokens) -> None:
    """Distribute several materials of the whole: the first stays, the others go to the parts that
    they suit. A material without a part is left out with its colour, and noted. Next to a colour
    one is a second: "a black and gold chair"."""
    named = [one for one in _named(tokens) if one.entry in got.found["material"]]
    if not got.thing or got.is_statue:
        return
    if len(named) == 1 and (color := _color_next_to(named[0], got)):
        _set_next_to_color(got, named[0], color)
    if len(named) < 2 or is_creature(got.thing):
        return
    first, *others = _clearest(named)
    if first.color and first.before in got.found["color"]:  # "a car, red, black leather, chrome"
        first, others = Named(Entry("material", "", "")), [first, *others]
    suited = parts_of_each(got.thing, [first.entry, *(one.entry for one in others)])
    got.found["material"] = [first.entry] if first.entry.word else []
    for one in others:
        parts = [part for part, entry in suited.items() if entry == one.entry]
        if not parts and one.joined_by:
            parts = lesser_parts(got.thing, one.entry)
        if one.color in got.found["color"]:
            got.found["color"].remove(one.color)
        if not _state(got, parts, one):
            forms = [each.form for each in (one.color, one.entry) if each]
            got.leave_aside(forms, "one material is taken")


def make_steampunk(got: Findings, tokens: Tokens) -> None:
    """Make a steampunk machine, vehicle or building of brass and copper, a hat of leather and
    brass, unless the prompt states a colour or a material."""
    found, thing = got.found, got.thing
    looks = found["material"] + found["color"] + [part for part in got.parts if part.there]
    driven = thing in STEAM_DRIVEN or any(thing in GROUPS[group] for group in STEAM_GROUPS)
    forms = STEAM_CLOTHES if thing in STEAM_WORN else STEAM_METALS if driven else ()
    first, second = (look_up(form, got.known) for form in forms or ("", ""))
    ends = {*tokens.breaks, len(tokens.words)}
    alone = any(ends.issuperset((k, k + 1)) for k, x in enumerate(tokens.words) if x == STEAMPUNK)
    styled = f"{STEAMPUNK} style" in " ".join(tokens.words)
    said = alone or styled or STEAMPUNK in got.qualifiers
    if not said or STEAMPUNK not in got.left_out or looks or not (first and second):
        return
    suited = parts_of_each(thing, [first, second])
    found["material"].append(first)
    hard = [p for p in _lesser(thing, "+&") if CLASS_OF.get(natural_kind(thing, p)) != CLOTH]
    more = _lesser(thing, "+&") if thing in STEAM_WORN else hard  # a clock's face is of paper
    others = list(dict.fromkeys([*suited, *more]))
    both = f"{first.form} and {second.form}" if _state(got, others, Named(second)) else first.form
    got.left_out.remove(STEAMPUNK)
    got.notes.append(f"{STEAMPUNK}: made of {both}.")


def _color_next_to(material: Named, got: Findings) -> Entry | None:
    """The colour next to it that belongs to other parts; none for a quality of the whole: "grey and
    fluffy", "red and rusty", "a chair, red, wooden"."""
    entry, name = material.entry, class_of(material.entry)
    if entry.form in QUALITIES or name not in (METAL, WOOD, STONE) or material.color:
        return None
    metal = name == METAL and entry.form not in PLAIN
    joined = material.joined_by in ("and", "with") or (material.joined_by == "," and metal)
    color = material.before if joined else None
    color = color or material.behind
    return color if color in got.found["color"] else None


def _state(got: Findings, parts: list[str], material: Named) -> bool:
    """State the materials of the parts, unless they have words of their own; whether of any."""
    taken = {name for part in got.parts for name in own_names(got.thing, part.name)}
    color = material.color
    look = (color.word, shade(*color[1:])) if color else ("", "")
    stated = [part for part in parts if part not in taken]
    got.parts += [StatedPart(part, True, part, *look, material.entry) for part in stated]
    return bool(stated)


def _set_next_to_color(got: Findings, named: Named, color: Entry) -> None:
    """Give some parts the material, and leave the colour to the rest, or the other way round;
    without parts for it, or with a stated pattern, it is the second colour."""
    material, patterned = named.entry, bool(got.found["pattern"])
    if color == named.behind and not patterned and is_of_it(got.thing, material):
        got.found["color"].remove(color)
        parts = parts_of_color(got.thing, material)
        look = (color.word, shade(*color[1:]))
        got.parts += [StatedPart(part, True, part, *look) for part in parts]
        if not parts:
            got.leave_aside([color.form], "nothing else in it has a colour")
        return
    parts = [] if patterned else parts_next_to_color(got.thing, material)
    tone = look_up(TONES.get(material.word, ""), got.known)
    if not (parts or tone):
        return
    got.found["material"].remove(material)
    if not _state(got, parts, Named(material)) and tone:
        got.found["color"].append(tone)


def _clearest(named: list[Named]) -> list[Named]:
    """The materials without those that add nothing to one before: "a brass metal lamp",
    "upholstered in velvet", "a see through plastic box"; iron is rusty."""
    kept: list[Named] = []
    for one in named:
        if not kept or not _is_same(kept[-1], one):
            kept.append(one)
        elif one.entry.word == RUSTY or kept[-1].entry.form in (*PLAIN, *HOW):
            kept[-1] = one._replace(joined_by=kept[-1].joined_by)
    return kept


def _is_same(before: Named, one: Named) -> bool:
    """Whether two materials in a row belong to the same part."""
    both = {class_of(before.entry), class_of(one.entry)}
    if one.joined_by in MADE_OF and before.entry.form in HOW:  # "woven from straw"
        return len(both) == 1
    if one.joined_by:
        words = {before.entry.word, one.entry.word}
        plain = len(words) == 1 and {before.entry.form, one.entry.form} & _PLAIN
        return len(both) == 1 and (bool(plain) or RUSTY in words)
    return len(both) == 1 or both == {GLASS, PLASTIC}


def _named(tokens: Tokens) -> Iterator[Named]:
    """The materials that the prompt's words name, in order."""
    words, at, last = tokens.words, 0, 0
    while at < len(words):
        looked = [(look_up(phrase, tokens.known), phrase) for phrase in tokens.phrases(at)]
        known = [(one, phrase) for one, phrase in looked if one]
        entry, phrase = next((x for x in known if x[0].slot == "material"), (None, ""))
        phrase = phrase or next((phrase for _, phrase in known), "")
        end = at + max(len(phrase.split()), 1)
        if entry is not None:
            begin = max(tokens.qualities_begin(at), last)
            joined = words[begin - 1] if begin > last and words[begin - 1] in _LISTING else ""
            joined = "," if begin in tokens.breaks else joined
            before = next(filter(None, (_color(tokens, 0, k) for k in range(begin, 0, -1))), None)
            own = _color(tokens, begin, at)
            yield Named(entry, own, joined, before, _color_behind(tokens, end))
            last = end
        at = end


def _color(tokens: Tokens, begin: int, end: int) -> Entry | None:
    """The colour that ends at the index, in a phrase from ``begin`` on."""
    begin = max(begin, end - LONGEST)
    phrases = (" ".join(tokens.words[at:end]) for at in range(begin, end))
    looked = (look_up(phrase, tokens.known) for phrase in phrases)
    return next((one for one in looked if one and one.slot == "color"), None)


def _color_behind(tokens: Tokens, end: int) -> Entry | None:
    """The colour behind the "and" at the index, unless it belongs to more: "gold and white
    leather"."""
    while tokens.words[end : end + 1] and tokens.words[end] in COLORED:  # "gold coloured and black"
        end += 1
    if tokens.words[end : end + 1] != ["and"] or tokens.breaks.intersection((end, end + 1)):
        return None
    return _color(tokens, end + 1, tokens.qualities_end(end + 1, LOOKS))


def parts_of_each(noun: str, materials: Sequence[Entry]) -> dict[str, Entry]:
    """The noun's parts for each material but the first, which the rest has.

    The materials are of different classes, or the first of each counts.
    """
    found: dict[str, Entry] = {}
    for part, look in _looks(noun).items():
        best = max(materials, key=lambda one: suits(noun, part, class_of(one)))
        least = (BY_NATURE if materials[0].word else WELL) if look[0] == "*" else 1
        if best is not materials[0] and suits(noun, part, class_of(best)) >= least:
            found[part] = best
    return found


def parts_next_to_color(noun: str, material: Entry) -> list[str]:
    """The noun's parts that have the material where a colour is next to it for the rest: those that
    it suits well, without the main parts where nothing would be left of these."""
    name, looks = class_of(material), _looks(noun)
    by_nature = name != WOOD  # of which much is
    parts = [
        part
        for part in looks
        if suits(noun, part, name) >= WELL or (by_nature and _is_by_nature(noun, part, name))
    ]
    if all(part in parts for part, look in looks.items() if look[0] in "*&"):
        parts = [part for part in parts if looks[part][0] != "*"]
    return parts or _lesser(noun, "+&")


def is_of_it(noun: str, material: Entry) -> bool:
    """Whether the noun's main parts are naturally of such a material."""
    mains = (part for part, look in NOUNS[noun].looks.items() if look[0] == "*")
    return all(_is_by_nature(noun, part, class_of(material)) for part in mains)


def parts_of_color(noun: str, material: Entry) -> list[str]:
    """The noun's parts for a colour behind a material that the noun has by nature: "a silver and
    black sword"."""
    name, looks = class_of(material), _looks(noun)
    if gems := [part for part in GEM_PARTS if looks.get(part, "*")[0] != "*"]:
        return gems
    accents, rest = (
        [part for part in _lesser(noun, roles) if not _is_by_nature(noun, part, name)]
        for roles in ("+&", "-")
    )
    return accents or [part for part in rest if any((one, part) in SUITED for one in _SUITED)]


def lesser_parts(noun: str, material: Entry) -> list[str]:
    """The noun's parts for a second material that suits none better than the first, "a gold and
    silver shield": those that it suits well; else those that are naturally of such a one, or go
    with the main ones."""
    name, looks = class_of(material), _looks(noun)
    others = [part for part, look in looks.items() if look[0] != "*"]
    return [part for part in others if suits(noun, part, name) >= WELL] or [
        part
        for part in others
        if looks[part][0] == "&" or (looks[part][0] == "+" and _is_by_nature(noun, part, name))
    ]


def _looks(noun: str) -> dict[str, str]:
    """The noun's parts, without those of the same material as the part below."""
    return {part: look for part, look in NOUNS[noun].looks.items() if look[0] != "~"}


def suits(noun: str, part: str, name: str) -> int:
    """How well the noun's part suits a class of materials."""
    return BY_NATURE * _is_by_nature(noun, part, name) + SUITED.get((name, part), 0)


def _lesser(noun: str, roles: str) -> list[str]:
    """The noun's parts of these roles, without transparent ones."""
    some = [part for part, look in _looks(noun).items() if look[0] in roles]
    return [part for part in some if not _is_by_nature(noun, part, GLASS)]


def _is_by_nature(noun: str, part: str, name: str) -> bool:
    """Whether the noun's part is naturally of the class; plastic is the default for many."""
    return name != PLASTIC and CLASS_OF.get(natural_kind(noun, part)) == name


def class_of(material: Entry) -> str:
    """The class of a material, by the kind of its form or by its word."""
    variant = VARIANTS.get(material.form)
    woven = variant is not None and variant.kind == "wicker"
    return CLOTH if woven else CLASS_OF.get(material.word, material.word)
