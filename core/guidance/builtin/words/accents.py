"""What a prompt says of parts alone. Standard library only."""

from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

from core.guidance.builtin.words.lexicon import Entry
from core.guidance.builtin.words.part_names import is_wide, looks_of, own_names
from core.guidance.builtin.words.part_tables import LEGS


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


OF_BODY = ("spout", "handle", "dome", "rim", "neck")
# What is said of a part together.
TOGETHER = (
    ("color", "color_form"),
    ("material", "material_form"),
    ("sheen",),
    ("pattern", "second", "second_form"),
)


def accents_of(parts: Iterable[StatedPart], noun: str) -> tuple[list[Accent], list[str]]:
    """What is said of each of the noun's parts, once each; and what is said of one that has such
    a word already: of "beige keys and a red escape key" the red."""
    accents: dict[str, Accent] = {}
    again: list[str] = []
    # What is said of the trim is not of the part of it that something else is said of.
    for part in sorted(parts, key=lambda part: is_wide(noun, part.name)):
        if not (part.color or part.material or part.sheen or part.pattern):
            continue
        names = own_names(noun, part.name, accents)
        if part.name in LEGS and not names:  # "three legs made of oak"
            names = own_names(noun, "legs")
        if not names and own_names(noun, part.name):  # all of it is taken
            said = (part.pattern, part.sheen, part.color_form, part.color)
            of = part.material.form if part.material else ""
            again.append(f"{next(filter(None, (*said, of)))} {part.form}")
        for name in names:
            if name not in accents or not is_wide(noun, part.name):
                accents[name], more = _joined(accents.get(name, Accent(name)), part)
                again += more
    if "body" in accents:
        accents |= {name: accents["body"]._replace(part=name) for name in _like_body(noun, accents)}
    return list(accents.values()), list(dict.fromkeys(again))


def _like_body(noun: str, accents: Collection[str]) -> Iterator[str]:
    """What is by nature as the body is, and nothing is said of: a cream teapot's spout."""
    looks = looks_of(noun)
    for name in OF_BODY:
        if name in looks and name not in accents and looks[name][1:] == looks["body"][1:]:
            yield name


def _joined(before: Accent, part: StatedPart) -> tuple[Accent, list[str]]:
    """What was said of a part first, and what that left open; and what would be its second."""
    word, form = part.material[1:] if part.material else ("", "")
    color, drawn = (part.color, part.color_form), (part.pattern, part.second, part.second_form)
    now = Accent(before.part, *color, word, form, part.sheen, *drawn)
    joined, again = {}, []
    for look in TOGETHER:
        old, new = (tuple(getattr(one, name) for name in look) for one in (before, now))
        joined |= zip(look, old if old[0] else new, strict=True)
        if old[0] and new[0] and old != new:
            again.append(f"{next(filter(None, reversed(new)))} {part.form}")
    return before._replace(**joined), again
