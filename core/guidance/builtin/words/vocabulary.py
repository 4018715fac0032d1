"""The parser of the built-in prior's prompts, which refuses by name what it does not know.

A prompt is read into slots (``Words``). Order is free; articles, plurals, case and filler are
passed over. A note states what was not taken to the letter: a close misspelling that is read as
what it is close to, a narrower word that is made as a wider one, an adjective that is left out, an
unknown word before a known noun ("office chair"), also left out. Any other unknown word is an error
that names it, or, where the user asks for that, is left out too.

Standard library only, so that ``run.py words`` and the panel need not load a network.
"""

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any

from core.errors import UserError
from core.guidance.builtin.nouns import solid_of
from core.guidance.builtin.offered import offered_words
from core.guidance.builtin.variants import has_own_look
from core.guidance.builtin.words.accents import Accent
from core.guidance.builtin.words.emblems import Emblem, emblems_in
from core.guidance.builtin.words.findings import Findings
from core.guidance.builtin.words.lexicon import LEXICON, MEANT, SLOTS, Vocabulary
from core.guidance.builtin.words.living import is_animal
from core.guidance.builtin.words.measures import Size
from core.guidance.builtin.words.part_names import own_name
from core.guidance.builtin.words.prompt_errors import (
    ELSEWHERE,
    PromptError,
    UnknownWordsError,
    known_things,
    unknown_error,
)
from core.guidance.builtin.words.reading import Reading
from core.guidance.builtin.words.sizes import usual
from core.guidance.builtin.words.sorts import sort_of
from core.guidance.builtin.words.words import ALSO_OF_FUR, GLASSWARE, PLAIN, WEATHERS
from core.io.job import SIZES

DENIM_BLUE = "denim blue"


@dataclass(frozen=True)
class Words:
    """A parsed prompt, by slot; an empty slot is not stated."""

    noun: str = ""
    shape: str = ""
    part: str = ""
    color: str = ""
    material: str = ""
    pattern: str = ""
    second: str = ""  # colour, of what the pattern, the target or the accent parts are painted with
    target: str = ""  # the part that the second colour is for
    accents: tuple[Accent, ...] = ()  # what other parts have of their own
    weather: tuple[str, ...] = ()  # what time has done to it
    sheen: tuple[str, ...] = ()  # how it shines
    is_statue: bool = False  # of one material all over, eyes and all
    kinds: tuple[int, ...] = field(default=(), compare=False)  # of the drawn noun, if not any
    is_toy: bool = field(default=False, compare=False)  # or another small likeness of the thing
    kind_size: float = field(default=0.0, compare=False)  # metres; 0: the thing's own
    scale: float = field(default=1.0, compare=False)  # of its usual size
    color_form: str = ""  # the first colour's shade, where that has a name of its own
    second_form: str = ""
    material_form: str = field(default="", compare=False)  # the material as it was written
    size: Size | None = field(default=None, compare=False)
    absent: tuple[str, ...] = ()  # the thing's parts that it is to be made without
    emblems: tuple[Emblem, ...] = ()  # what is drawn on it
    notes: tuple[str, ...] = field(default=(), compare=False)  # what the user should know
    left_out: tuple[str, ...] = field(default=(), compare=False)  # words without effect

    def indices(self, slots: Collection[str] = tuple(SLOTS)) -> list[int]:
        """Each slot's row in its embedding; 0 is "not stated"."""
        own = {"noun": solid_of(self.noun)}
        return [["", *SLOTS[slot]].index(own.get(slot, getattr(self, slot))) for slot in slots]

    def of_parts(self, what: str) -> dict[str, str]:
        """The "color", the "material", the "sheen" or the "pattern" of each part with its own."""
        found = {self.target: self.second} if self.target and what == "color" else {}
        own = {accent.part: getattr(accent, what) for accent in self.accents}
        return found | {part: word for part, word in own.items() if word}

    def stated_parts(self) -> list[str]:
        """What the thing is to have, and "no ..." of what it is to lack."""
        lacked = [f"no {part}" for part in self.absent]
        return list(dict.fromkeys([*filter(None, [self.part]), *lacked]))

    def usual(self) -> tuple[float, float]:
        """The thing's usual size in metres, as "small" and the like have it, and its density in
        kg/m³."""
        # Of an animal these are colours of its fur.
        furry = self.material_form in ALSO_OF_FUR and not self.is_statue and is_animal(self.noun)
        material = "" if furry else self.material
        size, density = usual(self.noun, material, self.is_toy, self.kind_size)
        return min(max(round(size * self.scale, 4), SIZES[0]), SIZES[1]), density

    def named_material(self) -> str:
        """The material as it was written, where it gets its own detail; else its word."""
        return self.material_form if has_own_look(self.material_form) else self.material

    def part_materials(self) -> dict[str, str]:
        """The material of each part that has its own, as :meth:`named_material`."""
        forms = {accent.part: accent.material_form for accent in self.accents}
        own = self.of_parts("material")
        return {part: forms[part] if has_own_look(forms[part]) else own[part] for part in own}

    def part_patterns(self) -> dict[str, str]:
        """The pattern of each part that has its own, and the colour that it is drawn with."""
        seconds = {accent.part: accent.second_form or accent.second for accent in self.accents}
        own = self.of_parts("pattern")
        return {part: " with ".join(filter(None, (own[part], seconds[part]))) for part in own}

    def part_shades(self) -> dict[str, str]:
        """The colour of each part that has its own, as it was written."""
        forms = {accent.part: accent.color_form for accent in self.accents}
        forms |= {self.target: self.second_form}
        return {part: forms.get(part) or word for part, word in self.of_parts("color").items()}

    def __str__(self) -> str:
        slots = ("shape", "pattern", "color", "material", "noun")
        return " ".join(word for slot in slots if (word := getattr(self, slot)))


def understood(
    prompt: str, known: Vocabulary | None = None, ignore_unknown: bool = False
) -> dict[str, Any]:
    """What the built-in prior makes of ``prompt``, as plain data.

    Args:
        known: the words that may be asked for; None: those that the shipped weights offer.
        ignore_unknown: leave out what is not known.

    Raises:
        UserError: as ``parse``; ``UnknownWordsError`` has the nearest known words.
    """
    known = offered_words() if known is None else known
    words = parse(prompt, known=known, ignore_unknown=ignore_unknown)
    usual_m, density = words.usual()
    size_m, side = words.size or (usual_m, "length")
    second = "" if words.target else words.second_form or words.second
    return {
        "prompt": prompt,
        "thing": words.noun,
        "shape": words.shape or None,
        "parts": words.stated_parts(),
        "colours": [color for color in (words.color_form or words.color, second) if color],
        "part_colours": words.part_shades(),
        "part_materials": words.part_materials(),
        "part_sheens": words.of_parts("sheen"),
        "part_patterns": words.part_patterns(),
        "materials": [words.named_material()] if words.material else [],
        "pattern": words.pattern or None,
        "emblems": [str(emblem) for emblem in words.emblems],
        "weather": list(words.weather),
        "sheen": list(words.sheen),
        "size_m": size_m,
        "side": side,
        "density": density,
        "left_out": list(words.left_out),
        "notes": list(words.notes),
    }


def words_report(prompt: str, ignore_unknown: bool = False) -> tuple[dict[str, Any], int]:
    """``understood`` and exit code 0; or why the prompt is refused, with the nearest known words of
    each unknown one, and the error's exit code."""
    try:
        return understood(prompt, ignore_unknown=ignore_unknown), 0
    except UserError as error:
        nearest = error.nearest if isinstance(error, UnknownWordsError) else {}
        report = {"prompt": prompt, "error": error.text, "fix": error.fix, "nearest": nearest}
        return report, error.status


def parse(
    prompt: str,
    *,
    noun_needed: bool = True,
    known: Vocabulary = SLOTS,
    ignore_unknown: bool = False,
) -> Words:
    """Read a prompt into slots; ``known`` are the words that may be asked for.

    Raises ``UserError`` that names every word it does not know with the nearest it does (unless
    ``ignore_unknown``), two things, a part that the thing cannot lack or have, and a missing noun
    unless ``noun_needed`` is false (a negative prompt).
    """
    emblems, rest = emblems_in(prompt) if noun_needed else ((), prompt)
    got = _read(rest, known, noun_needed)
    shapes = {emblem.shape for emblem in emblems if emblem.shape}
    own = {one for one in shapes if any(own_name(got.thing, w) for w in (one, one.split()[0]))}
    if own:  # a medal's star is a part of it
        emblems, rest = emblems_in(prompt, own)
        got = _read(rest, known, noun_needed)
    if emblems and noun_needed and not got.found["noun"]:  # what is in quotes may be the thing
        emblems, got = (), _read(prompt, known, noun_needed)
    # Before the missing noun: an error with the nearest known words says more.
    if got.refused and not ignore_unknown:
        raise unknown_error(got.refused, got.qualifiers, known)
    if noun_needed and not got.found["noun"]:
        # A face is known, but only as a part of a clock.
        things = [part for part, *_ in got.parts if part in MEANT]
        if things:
            raise unknown_error(things, [], known)
        raise PromptError(
            f"The prompt {prompt.strip()!r} does not name a thing the built-in model knows.",
            f"{known_things(known)} {ELSEWHERE}",
        )
    sort = sort_of(got.thing, prompt) or got.sort
    got.take_as_sort(sort.said)
    # The part last: what may be stated of it depends on the noun.
    words = {slot: got.only(slot) for slot in ("noun", "shape", "material", "pattern")}
    words |= got.colors() | {"part": got.part(words["noun"])}
    words["absent"] = got.absent(words["noun"])
    # In the table's order: snow lies on dirt.
    words["weather"] = tuple(w for w in WEATHERS if w in got.words("weather"))
    words["sheen"] = tuple(got.words("sheen"))
    words |= {"is_statue": got.is_statue, "is_toy": got.is_toy, "kinds": sort.kinds}
    words |= {"kind_size": got.kind_size() or sort.size_m, "scale": got.scale, "size": got.size()}
    # "Upholstered in velvet": what only says that it is of fabric says less.
    forms = [one.form for one in got.found["material"] if one.word == words["material"]]
    words["material_form"] = next(
        (form for form in forms if form not in PLAIN), forms[0] if forms else ""
    )
    if not words["material"] and {entry.form for entry in got.found["noun"]} & GLASSWARE:
        words["material"] = words["material_form"] = "glass"
    words["emblems"] = emblems
    words |= _of_denim(words, {entry.form for entry in got.found["noun"]})
    notes = dict.fromkeys([*got.notes, *got.narrower(), *got.omissions()])
    left_out = tuple(dict.fromkeys([*got.left_out, *got.aside]))
    return Words(**words, notes=tuple(notes), left_out=left_out)


def _of_denim(words: dict[str, Any], names: set[str]) -> dict[str, str]:
    """The blue of blue jeans, and of what is of blue denim."""
    denim = words["material_form"] == "denim" or names & {"jeans", "jean"}
    if not denim or (words["color_form"] or words["color"]) != "blue":
        return {}
    _, color = LEXICON[DENIM_BLUE]
    return {"color": color, "color_form": DENIM_BLUE}


def _read(prompt: str, known: Vocabulary, noun_needed: bool) -> Findings:
    """What the words are found to say; without a thing, what may be one by itself."""
    got = Reading(prompt, known).got
    if noun_needed and not got.found["noun"]:
        got = Reading(prompt, known, alone=True).got
    return got
