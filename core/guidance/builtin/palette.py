"""Values of the colour and material words, and each noun's parts by nature.

Colours are written as sRGB in [0, 1].
"""

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple, Protocol, runtime_checkable

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.markings.table import MARKINGS
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.patterns import LINES, RAINBOW_COLORS, natural_second
from core.guidance.builtin.substances import ROUGHNESS, natural_kind
from core.guidance.builtin.words.grammar.accents import Accent
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.grammar.part_names import ASKED
from core.guidance.builtin.words.tables.colors import (
    COLOR_VALUES,
    DARK,
    LIGHT,
    RAINBOW,
    Color,
    color_value,
    luma,
    rainbow_tone,
    toned,
)
from core.guidance.builtin.words.tables.living import is_animal
from core.guidance.builtin.words.tables.part_tables import FRAMES, WHOLE
from core.guidance.builtin.words.tables.words import ALSO_COLORS, STRIPED_PARTS, WITH_EYES

# Accents of one group do not take a material of the other group that is stated for the whole.
SOFT = ("fabric", "paper", "leather", "rubber", "felt", "wicker", "feathers")
HARD = ("metal", "golden", "copper", "rusty", "stone", "ceramic", "glass")
FRAMING = {*HARD, "wooden"} - {"glass"}
CLEAR = ("glass", "liquid")
COLORED_METALS = ("golden", "copper", "rusty")
NO_METAL = ("hair", "fur", "feathers", "skin", "hide", "fabric", "felt")
EYES = ("eyes", "eye", "whites", "pupils", "glints")
GLAZED = ("window", "lantern", "greenhouse")  # with a part of glass
STRIPES = "stripes"  # a part that some things have by nature
SHADE = "~"  # the role of such a marking, in ``nouns``
DARKER = 0.6  # sRGB: a shade of the part below
SWATCHES = 8  # channels of ``swatches``
# Factor on a metal's distance from white: the tables have its visible colour, and it mirrors
# surroundings that are darker than the light on a wall.
METAL_LEFT = 0.75


class Finish(NamedTuple):
    """A material word: its own colour unless a colour is stated, and its gloss."""

    color: Color | None
    roughness: float
    metallic: float
    pattern: str = ""


PLAIN = Finish(None, 0.5, 0.0)
FINISHES: dict[str, Finish] = {
    "": PLAIN,
    "wooden": Finish((0.56, 0.36, 0.19), 0.6, 0.0, "grain"),
    "metal": Finish((0.74, 0.75, 0.77), 0.3, 1.0),
    "golden": Finish((1.0, 0.78, 0.34), 0.25, 1.0),
    "plastic": Finish(None, 0.25, 0.0),
    "rubber": Finish((0.13, 0.13, 0.14), 0.85, 0.0),
    "stone": Finish((0.55, 0.53, 0.50), 0.9, 0.0, "mottle"),
    "rusty": Finish((0.48, 0.22, 0.10), 0.75, 0.6, "rust"),
    "ceramic": Finish((0.93, 0.91, 0.86), 0.12, 0.0),
    "leather": Finish((0.36, 0.19, 0.10), 0.5, 0.0, "mottle"),
    "glass": Finish((0.62, 0.82, 0.84), 0.08, 0.0),
    "copper": Finish((0.93, 0.56, 0.42), 0.3, 1.0),
    "fabric": Finish(None, 0.9, 0.0),
}
# Not words, only by nature: a car's paint, a bench's legs.
PAINT, CAST_IRON = Finish(None, 0.2, 0.0), Finish(None, 0.6, 1.0)


def swatches(words: Int[Tensor, "b n"]) -> Float[Tensor, "b 8"]:
    """The colours that the words state: the first (or the material's own without a colour), then
    the second (or the first one's companion, where only a pattern is stated); each
    [2 srgb - 1, 1], or zeros without one.

    So the network need not learn what each colour word looks like on each thing.

    Args:
        words: rows of noun, color, material, pattern, second and more; 0 is not stated.
    """
    colors, materials = (table.to(words.device) for table in _tables())
    stated = words > 0
    both = torch.where(stated[:, 1:2], colors[words[:, 1]], materials[words[:, 2]])
    first, goes_with = both.split(4, 1)
    # A companion shows in a pattern alone.
    goes_with = goes_with * stated[:, 3:4]
    second = torch.where(stated[:, 4:5], colors[words[:, 4], :4], goes_with)
    return torch.cat([first, second], 1)


@cache
def _tables() -> tuple[Float[Tensor, "c 8"], Float[Tensor, "m 8"]]:
    """For the colours and for the materials: each row's own swatch, and that of its companion."""

    def row(color: Color | None) -> list[float]:
        # The fourth channel distinguishes a stated mid-grey from no colour, which is all zeros.
        pair = (color, companion(color)) if color else ()
        return [x for rgb in pair for x in [*(2 * c - 1 for c in rgb), 1.0]] or [0.0] * 8

    colors = [None, *(COLOR_VALUES[word] for word in SLOTS["color"])]
    materials = [None, *(FINISHES[word].color for word in SLOTS["material"])]
    return torch.tensor([*map(row, colors)]), torch.tensor([*map(row, materials)])


class Look(NamedTuple):
    """One part by nature."""

    role: str  # see ``nature``
    color: Color
    pattern: str
    finish: Finish
    material: str = ""  # its finish's name, or the kind of its substance
    shaded: str = ""  # for a marking, the part whose colour it has a shade of under words
    asked: bool = False  # present only where the prompt states something of it


@cache
def looks(noun: str) -> dict[str, Look]:
    """The noun's parts by nature, in the order of the pictures' part index."""
    return {part: _look(noun, part, text) for part, text in NOUNS[noun].looks.items()}


def _look(noun: str, part: str, text: str) -> Look:
    color, pattern, stated = (*text[1:].split(), ".", ".")[:3]
    rgb = [int(color[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    kind = natural_kind(noun, part)
    finish = _natural(kind) if stated == "." else (FINISHES | {"paint": PAINT})[stated]
    if finish.metallic > 0.5:
        rgb = [1 - (1 - c) * METAL_LEFT for c in rgb]
    red, green, blue = rgb
    # A joint in the colour of the planks would not be visible.
    on = MARKINGS[noun][part].on if text[0] == SHADE else ""
    asked = text[0] == ASKED
    role = _role(noun, on) if on else "-" if asked else text[0]
    return Look(role, (red, green, blue), pattern.strip("."), finish, kind, on, asked)


def _role(noun: str, part: str) -> str:
    """A part's role; for a marking in a shade, that of the part below."""
    role = NOUNS[noun].looks[part][0]
    return _role(noun, MARKINGS[noun][part].on) if role == SHADE else role


def darker(color: Color) -> Color:
    """The shade of a marking on a part of the colour."""
    red, green, blue = (DARKER * x for x in color)
    return red, green, blue


def _natural(kind: str) -> Finish:
    """The finish of a part of a kind, whose look has the colour and the pattern."""
    known = (FINISHES | {"paint": PAINT, "cast iron": CAST_IRON}).get(kind, PLAIN)
    return Finish(None, ROUGHNESS.get(kind, known.roughness), known.metallic)


@runtime_checkable
class Stated(Protocol):
    """The words that a part's paint depends on; empty: not stated."""

    @property
    def color(self) -> str: ...
    @property
    def color_form(self) -> str: ...
    @property
    def material(self) -> str: ...
    @property
    def pattern(self) -> str: ...
    @property
    def second(self) -> str: ...
    @property
    def second_form(self) -> str: ...
    @property
    def target(self) -> str: ...
    @property
    def accents(self) -> tuple[Accent, ...]: ...
    @property
    def material_form(self) -> str: ...
    @property
    def sheen(self) -> tuple[str, ...]: ...
    @property
    def is_statue(self) -> bool: ...


class Painted(NamedTuple):
    """The paint of one part under words."""

    name: str
    look: Look  # by nature
    color: Color
    second: Color  # of the pattern
    finish: Finish
    pattern: str
    material: str = ""  # its word; "": by nature
    material_form: str = ""  # as it was written
    colored: bool = False  # by a word, and not by its material
    sheen: tuple[str, ...] = ()  # words for its gloss
    apart: bool = False  # whether words state something for it alone
    tone: str = ""  # of a rainbow

    def colors(self) -> tuple[Color, ...]:
        """Those of a rainbow; otherwise its own and the second."""
        if self.pattern != RAINBOW:
            return self.color, self.second
        return tuple(toned(color, self.tone) if self.tone else color for color in RAINBOW_COLORS)


def painted(noun: str, stated: Stated) -> Iterator[Painted]:
    """The paint of each of the noun's parts."""
    # The accents take the second colour, or without accents the lower half.
    two_tone = stated.pattern == "two-tone" and has_accents(noun)
    own = {accent.part: accent for accent in stated.accents}
    first, other = (stated.color, stated.color_form), (stated.second, stated.second_form)
    lines = _own_stripes(noun, stated)
    drawn = lines is not None and not lines.on
    # "A red cap and white spots": where all parts have their own looks, these are on top.
    given = {a.part for a in stated.accents if a.color or a.material or a.pattern} | {stated.target}
    mains = {name for name, look in looks(noun).items() if look.role == "*"}
    covered = bool(mains) and mains <= given
    # "A white cake with pink icing": then its colour is that of the part below.
    below = [name for name in WHOLE if covered and name in looks(noun) and name not in given]
    for name, look in looks(noun).items():
        accent = own.get(name, Accent(name))
        if name not in own and look.shaded in own:
            accent = own[look.shaded]._replace(pattern="")
        if lines and name == STRIPES and not accent.color:
            accent = accent._replace(color=lines.color, color_form=lines.form)
        if lines and name == lines.on:
            accent = accent._replace(pattern="")
        # The material first: a stated colour then replaces the material's own.
        material, form, finish, color, pattern = _of_words(noun, look, accent, stated)
        word = (accent.color, accent.color_form)
        targets = (name, look.shaded) if look.shaded else (name,)
        word = other if stated.target in targets and not accent.color else word
        # Words for the whole do not apply to it.
        apart = bool(word[0] or accent.material or accent.pattern)
        sees = name in EYES and stated.material_form in WITH_EYES
        of_whole = (look.role in "*&" or stated.is_statue) and not (apart or sees)
        if of_whole or name in below:
            word = first
        if word[0] or apart:
            color, pattern = _value(word) or color, finish.pattern
        if look.shaded and (word[0] or material) and name not in own:
            color = darker(color)
        sheen = (accent.sheen,) if accent.sheen else stated.sheen
        sheen = sheen if accent.sheen or of_whole else ()
        second = _value(other) or companion(color)
        if accent.pattern:  # "a market stall with a striped awning"
            pattern = accent.pattern
            second = _value((accent.second, accent.second_form)) or companion(color)
        elif two_tone and look.role in "+&" and not apart:
            color = _value(other) or companion(_value(first) or look.color)
            pattern, word = finish.pattern, other if stated.second else word
        elif (
            stated.pattern
            and not (two_tone or drawn)
            and (look.role == "*" if apart and covered else look.role in "*&" and not apart)
        ):
            pattern = stated.pattern
        # Also for rainbow stripes.
        below_form = accent.second_form if accent.pattern else other[1] if stated.pattern else ""
        tones = (rainbow_tone(form) for form in (word[1], below_form))
        tone = next((tone for tone in tones if tone is not None), None)
        if tone is not None and pattern in ("", finish.pattern, "striped"):
            pattern = RAINBOW
        of_two = pattern == "two-tone"  # "a black and white basketball": its seams are white
        if look.pattern in LINES and pattern in ("", finish.pattern, "two-tone"):
            pattern = look.pattern
        natural = None if of_two else natural_second(pattern, color)
        yield Painted(
            name,
            look,
            color,
            natural or second,
            finish,
            pattern,
            material,
            form,
            bool(word[0]),
            sheen,
            bool((apart or accent.sheen) and (name in own or not look.shaded)),
            tone or "",
        )


class OwnStripes(NamedTuple):
    """Stripes that a thing has by nature, used where it should be striped."""

    on: str  # the part below; "": the whole
    color: str  # their colour; "": by nature
    form: str


def _own_stripes(noun: str, stated: Stated) -> OwnStripes | None:
    """None without stripes of its own, or where others are meant."""
    if STRIPES not in looks(noun):
        return None
    on = STRIPED_PARTS.get(noun, "")
    accent = next((one for one in stated.accents if one.part == on), None)
    if accent and accent.pattern == "striped":
        return OwnStripes(on, accent.second, accent.second_form)
    if not on and stated.pattern == "striped":
        return OwnStripes("", stated.second, stated.second_form)
    return None


def _of_words(
    noun: str, look: Look, accent: Accent, stated: Stated
) -> tuple[str, str, Finish, Color, str]:
    """A part's material by the words and its form, its finish, colour and pattern."""
    material, form = accent.material, accent.material_form
    if not material and accent.part in EYES and stated.material_form in WITH_EYES:
        return "", "", look.finish, look.color, look.pattern
    if not material and (stated.is_statue or is_of(noun, accent.part, stated.material)):
        material, form = stated.material, stated.material_form
    if not material:
        return "", "", look.finish, look.color, look.pattern
    finish = FINISHES[material]
    of_statue = stated.is_statue and not accent.material
    mains = (one.color for one in looks(noun).values() if one.role == "*")
    color = finish.color or (next(mains, look.color) if of_statue else look.color)
    if form in ALSO_COLORS and look.material in NO_METAL and not stated.is_statue:  # "silver hair"
        return "", "", look.finish, color, look.pattern
    return material, form, finish, color, finish.pattern


def _value(word: tuple[str, str]) -> Color | None:
    """The colour of a colour word and its form; None if not stated."""
    return color_value(*word) if word[0] else None


def is_of(noun: str, part: str, material: str) -> bool:
    """Whether a material that is stated for the noun applies to the part: not to a wooden lamp's
    shade; not to the metal fittings of a thing that is not of metal, such as a wooden chest's bands
    (but to a wooden sword's guard); not to a golden medal's ribbon or a golden staff's crystal; and
    where the thing is of it by nature, not to its other parts, such as a glass bottle's cap."""
    look = looks(noun)[part]
    if material == "glass" and noun in GLAZED:
        return look.material == "glass"
    if material in FRAMING and noun in FRAMES:
        return part in FRAMES[noun]
    if look.role == "-":  # "a brass floor lamp": its pole too
        return material in COLORED_METALS and look.finish.metallic > 0.5
    if look.role != "+" or not material:
        return True
    if look.material in CLEAR and material != "glass":
        return False
    if any(other.role == "*" and other.material == material for other in looks(noun).values()):
        return look.material == material
    if look.finish.metallic < 0.5:
        # A wooden boat has sails of cloth, a wooden owl is carved of one block.
        hard = HARD if is_animal(noun) else (*HARD, "wooden")
        return look.material not in SOFT or material not in hard
    main = [other.finish.metallic for other in looks(noun).values() if other.role == "*"]
    return FINISHES[material].metallic > 0.5 or max(main, default=0) > 0.5


def has_accents(noun: str) -> bool:
    """Whether some of the noun's parts take the second colour of "two-tone"."""
    return any(look.role in "+&" for look in looks(noun).values())


def companion(color: Color) -> Color:
    """The second colour where none is stated: white, or black next to a light colour."""
    return DARK if luma(color) > 0.65 else LIGHT
