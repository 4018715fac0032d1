"""What a prompt states about parts alone. Standard library only."""

from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

from core.guidance.builtin.words.grammar.lexicon import Entry
from core.guidance.builtin.words.grammar.part_names import is_wide, looks_of, own_names
from core.guidance.builtin.words.tables.part_tables import LEGS


class StatedPart(NamedTuple):
    """A part that a prompt names, with the words right before it."""

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
    sizes: tuple[str, ...] = ()
    number: str = ""  # of its components, as it was written


class Accent(NamedTuple):
    """The paint and the material of one part, both also as written; its gloss; its pattern."""

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
# Slots of one part that go together.
TOGETHER = (
    ("color", "color_form"),
    ("material", "material_form"),
    ("sheen",),
    ("pattern", "second", "second_form"),
)


def accents_of(parts: Iterable[StatedPart], noun: str) -> tuple[list[Accent], list[str]]:
    """The accents of the noun's parts, once each; and descriptions of a part that already has such
    a word: for "beige keys and a red escape key" the red."""
    accents: dict[str, Accent] = {}
    again: list[str] = []
    # Words for the trim do not apply to the part of it that has words of its own.
    for part in sorted(parts, key=lambda part: is_wide(noun, part.name)):
        if not (part.color or part.material or part.sheen or part.pattern):
            continue
        names = own_names(noun, part.name, accents)
        if part.name in LEGS and not names:  # "three legs made of oak"
            names = own_names(noun, "legs")
        if not names and own_names(noun, part.name):  # all of it is taken
            stated = (part.pattern, part.sheen, part.color_form, part.color)
            of = part.material.form if part.material else ""
            again.append(f"{next(filter(None, (*stated, of)))} {part.form}")
        for name in names:
            if name not in accents or not is_wide(noun, part.name):
                accents[name], more = _joined(accents.get(name, Accent(name)), part)
                again += more
    if "body" in accents:
        accents |= {name: accents["body"]._replace(part=name) for name in _like_body(noun, accents)}
    return list(accents.values()), list(dict.fromkeys(again))


def _like_body(noun: str, accents: Collection[str]) -> Iterator[str]:
    """Parts that look like the body by nature, without words of their own: a cream teapot's
    spout."""
    looks = looks_of(noun)
    for name in OF_BODY:
        if name in looks and name not in accents and looks[name][1:] == looks["body"][1:]:
            yield name


def _joined(before: Accent, part: StatedPart) -> tuple[Accent, list[str]]:
    """The first description of a part, completed by the later ones; and what would be its
    second."""
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
