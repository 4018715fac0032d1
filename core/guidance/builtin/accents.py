"""What a prompt says of parts alone. Standard library only."""

from collections.abc import Iterable
from typing import NamedTuple

from core.guidance.builtin.lexicon import Entry
from core.guidance.builtin.part_names import own_name
from core.guidance.builtin.prompt_errors import two_error


class StatedPart(NamedTuple):
    """A part that a prompt names, and what is right before it."""

    name: str
    there: bool
    form: str  # as it was written
    color: str = ""
    material: Entry | None = None


class Accent(NamedTuple):
    """What a part alone is painted with, or is of; the material also as it was written."""

    part: str
    color: str = ""
    material: str = ""
    material_form: str = ""


def accents_of(parts: Iterable[StatedPart], noun: str) -> list[Accent]:
    """What is said of each of the noun's parts, once each.

    Raises ``UserError`` for two colours or two materials of one part.
    """
    accents: dict[str, Accent] = {}
    for part in parts:
        if not (part.color or part.material):
            continue
        name = own_name(noun, part.name)
        before = accents.get(name, Accent(name))
        word, form = part.material[1:] if part.material else ("", "")
        for slot, old, new in (
            ("color", before.color, part.color),
            ("material", before.material, word),
        ):
            if old and new and old != new:
                raise two_error(slot, [old, new])
        own = Accent(name, part.color, word, form)
        accents[name] = Accent(*(new or old for old, new in zip(before, own, strict=True)))
    return list(accents.values())
