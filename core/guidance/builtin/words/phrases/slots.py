"""The contents of a prompt, by slot. Standard library only."""

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import NamedTuple

from core.guidance.builtin.nouns import row_of
from core.guidance.builtin.variants import has_own_look
from core.guidance.builtin.words.grammar.accents import Accent
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.grammar.measures import Size
from core.guidance.builtin.words.grammar.openers import Relation
from core.guidance.builtin.words.phrases.cuts import CutWord
from core.guidance.builtin.words.phrases.emblems import Emblem
from core.guidance.builtin.words.phrases.moods import Mood
from core.guidance.builtin.words.phrases.poses import PoseWord
from core.guidance.builtin.words.phrases.styles import Style
from core.guidance.builtin.words.tables.count_words import Order
from core.guidance.builtin.words.tables.living import is_animal
from core.guidance.builtin.words.tables.part_tables import LEGS
from core.guidance.builtin.words.tables.sizes import usual
from core.guidance.builtin.words.tables.words import ALSO_OF_FUR
from core.io.job import SIZES

# In the order of the networks' embeddings.
GEOMETRY_SLOTS = ("noun", "shape", "part")


@dataclass(frozen=True)
class Words:
    """A parsed prompt, by slot; an empty slot is not stated."""

    noun: str = ""
    shape: str = ""
    part: str = ""
    color: str = ""
    material: str = ""
    pattern: str = ""
    second: str = ""  # colour of the pattern, the target or the accent parts
    target: str = ""  # the part that the second colour is for
    accents: tuple[Accent, ...] = ()  # words for other parts
    weather: tuple[str, ...] = ()  # weathering
    sheen: tuple[str, ...] = ()  # gloss
    is_statue: bool = False  # of one material all over, eyes and all
    kinds: tuple[int, ...] = field(
        default=(), compare=False
    )  # allowed kinds of the drawn noun; (): all
    is_toy: bool = field(default=False, compare=False)  # or another small likeness of the thing
    kind_size: float = field(default=0.0, compare=False)  # metres; 0: the thing's own
    scale: float = field(default=1.0, compare=False)  # of its usual size
    color_form: str = ""  # the first colour's shade, where that has its own name
    second_form: str = ""
    material_form: str = field(default="", compare=False)  # the material as written
    size: Size | None = field(default=None, compare=False)
    pose: PoseWord = ""
    mood: Mood = ""  # of a thing with eyes
    cut: CutWord = ""  # what is cut off or broken off
    style: Style = ""  # of the shape
    absent: tuple[str, ...] = ()  # parts that are left out on request
    part_sizes: tuple[tuple[str, str], ...] = ()  # parts of a size of their own, and its words
    part_counts: tuple[tuple[str, int], ...] = ()  # parts with a stated number of components
    emblems: tuple[Emblem, ...] = ()  # what is drawn on it
    companions: tuple["Companion", ...] = ()  # other things that are made with it
    count: int = 1  # how many of it are made
    order: Order = "row"  # their arrangement
    notes: tuple[str, ...] = field(default=(), compare=False)  # notes for the user
    left_out: tuple[str, ...] = field(default=(), compare=False)  # words without effect

    def indices(self, slots: Collection[str] = tuple(SLOTS)) -> list[int]:
        """Each slot's row in its embedding; 0 is "not stated"."""
        own = {"noun": row_of(self.noun)}
        return [["", *SLOTS[slot]].index(own.get(slot, getattr(self, slot))) for slot in slots]

    def of_parts(self, what: str) -> dict[str, str]:
        """The "color", the "material", the "sheen" or the "pattern" of each part with its own."""
        found = {self.target: self.second} if self.target and what == "color" else {}
        own = {accent.part: getattr(accent, what) for accent in self.accents}
        return found | {part: word for part, word in own.items() if word}

    def stated_parts(self) -> list[str]:
        """The parts that the thing should have, and "no ..." for those that it should lack."""
        lacked = [f"no {part}" for part in self.absent]
        counted = self.part in LEGS and "legs" in dict(self.part_counts)
        stated = [self.part] if self.part and not counted else []
        return list(dict.fromkeys([*stated, *lacked]))

    def usual(self) -> tuple[float, float]:
        """The thing's usual size in metres, changed by "small" and similar words, and its density
        in kg/m³."""
        # Of an animal these are colours of its fur.
        furry = self.material_form in ALSO_OF_FUR and not self.is_statue and is_animal(self.noun)
        material = "" if furry else self.material
        size, density = usual(self.noun, material, self.is_toy, self.kind_size)
        return min(max(round(size * self.scale, 4), SIZES[0]), SIZES[1]), density

    def named_material(self) -> str:
        """The material as written, where it gets its own detail; else its word."""
        return self.material_form if has_own_look(self.material_form) else self.material

    def part_materials(self) -> dict[str, str]:
        """The material of each part that has its own, as :meth:`named_material`."""
        forms = {accent.part: accent.material_form for accent in self.accents}
        own = self.of_parts("material")
        return {part: forms[part] if has_own_look(forms[part]) else own[part] for part in own}

    def part_patterns(self) -> dict[str, str]:
        """The pattern of each part with its own, and its second colour."""
        seconds = {accent.part: accent.second_form or accent.second for accent in self.accents}
        own = self.of_parts("pattern")
        return {part: " with ".join(filter(None, (own[part], seconds[part]))) for part in own}

    def part_shades(self) -> dict[str, str]:
        """The colour of each part with its own, as written."""
        forms = {accent.part: accent.color_form for accent in self.accents}
        forms |= {self.target: self.second_form}
        return {part: forms.get(part) or word for part, word in self.of_parts("color").items()}

    def __str__(self) -> str:
        slots = ("shape", "pattern", "color", "material", "noun")
        return " ".join(word for slot in slots if (word := getattr(self, slot)))


class Companion(NamedTuple):
    """Another thing that a prompt requests on, in or under the first."""

    relation: Relation
    words: Words
    verb: str = ""  # the first thing's activity: "sitting", "riding"
