"""What a prompt says of parts alone. Standard library only."""

from collections.abc import Iterable
from typing import NamedTuple

from core.guidance.builtin.lexicon import Entry
from core.guidance.builtin.part_names import is_wide, own_names


class StatedPart(NamedTuple):
    """A part that a prompt names, and what is right before it."""

    name: str
    there: bool
    form: str  # as it was written
    color: str = ""
    color_form: str = ""
    material: Entry | None = None
    sheen: str = ""
    pattern: str = ""
    second: str = ""  # the pattern's other colour, where that is stated
    second_form: str = ""


class Accent(NamedTuple):
    """What a part alone is painted with, or is of, both also as they were written; how it shines;
    and its pattern."""

    part: str
    color: str = ""
    color_form: str = ""
    material: str = ""
    material_form: str = ""
    sheen: str = ""
    pattern: str = ""
    second: str = ""  # the pattern's other colour
    second_form: str = ""


def accents_of(parts: Iterable[StatedPart], noun: str) -> tuple[list[Accent], list[str]]:
    """What is said of each of the noun's parts, once each; and what is said of one that has such
    a word already: of "beige keys and a red escape key" the red."""
    accents: dict[str, Accent] = {}
    again: list[str] = []
    # What is said of the trim is not of the part of it that something else is said of.
    for part in sorted(parts, key=lambda part: is_wide(noun, part.name)):
        if not (part.color or part.material or part.sheen or part.pattern):
            continue
        for name in own_names(noun, part.name):
            if name not in accents or not is_wide(noun, part.name):
                before = accents.get(name, Accent(name))
                accents[name] = _joined(before, part)
                again += _second(before, part)
    return list(accents.values()), list(dict.fromkeys(again))


def _joined(before: Accent, part: StatedPart) -> Accent:
    """What was said of a part first, and what that left open."""
    word, form = part.material[1:] if part.material else ("", "")
    color = before[1:3] if before.color else (part.color, part.color_form)
    material = before[3:5] if before.material else (word, form)
    drawn = before[6:] if before.pattern else (part.pattern, part.second, part.second_form)
    return Accent(before.part, *color, *material, before.sheen or part.sheen, *drawn)


def _second(before: Accent, part: StatedPart) -> list[str]:
    """The colour and the material that would be a part's second ones, with its name."""
    word, form = part.material[1:] if part.material else ("", "")
    said = (
        (before.color_form or before.color, part.color_form or part.color, part.color),
        (before.material, form, word),
    )
    return [f"{form} {part.form}" for old, form, new in said if old and new and old != new]
