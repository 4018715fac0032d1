"""What a prompt says of parts alone. Standard library only."""

from collections.abc import Iterable
from typing import NamedTuple

from core.guidance.builtin.lexicon import Entry
from core.guidance.builtin.part_names import is_wide, own_names
from core.guidance.builtin.prompt_errors import two_error


class StatedPart(NamedTuple):
    """A part that a prompt names, and what is right before it."""

    name: str
    there: bool
    form: str  # as it was written
    color: str = ""
    color_form: str = ""
    material: Entry | None = None
    sheen: str = ""


class Accent(NamedTuple):
    """What a part alone is painted with, or is of, both also as they were written; and how it
    shines."""

    part: str
    color: str = ""
    color_form: str = ""
    material: str = ""
    material_form: str = ""
    sheen: str = ""


def accents_of(parts: Iterable[StatedPart], noun: str) -> list[Accent]:
    """What is said of each of the noun's parts, once each.

    Raises ``UserError`` for two colours or two materials of one part.
    """
    accents: dict[str, Accent] = {}
    # What is said of the trim is not of the part of it that something else is said of.
    for part in sorted(parts, key=lambda part: is_wide(noun, part.name)):
        if not (part.color or part.material or part.sheen):
            continue
        for name in own_names(noun, part.name):
            if name not in accents or not is_wide(noun, part.name):
                accents[name] = _joined(accents.get(name, Accent(name)), part)
    return list(accents.values())


def _joined(before: Accent, part: StatedPart) -> Accent:
    """What was said of a part, and now."""
    word, form = part.material[1:] if part.material else ("", "")
    for slot, old, new in (
        ("color", before.color_form or before.color, part.color_form or part.color),
        ("material", before.material, word),
    ):
        if old and new and old != new:
            raise two_error(slot, [old, new])
    own = Accent(before.part, part.color, part.color_form, word, form, part.sheen)
    return Accent(*(new or old for old, new in zip(before, own, strict=True)))
