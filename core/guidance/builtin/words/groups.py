"""The known words by group, as a menu shows them. Standard library only."""

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.offered import offered_words
from core.guidance.builtin.words.phrases.moods import MOODS
from core.guidance.builtin.words.phrases.styles import OFFERED
from core.guidance.builtin.words.tables.part_tables import OPTIONS

ADJECTIVES = {"Shapes": "shape", "Colors": "color", "Materials": "material", "Patterns": "pattern"}


def word_groups() -> list[dict[str, object]]:
    """Groups in a menu's order: ``name``, ``kind`` ("thing", a slot's name, "mood", "style" or
    "part"), ``words``.

    A part names the things that may have it in ``of``.
    """
    known = offered_words()
    groups: list[dict[str, object]] = [
        {"name": name, "kind": "thing", "words": [noun for noun in things if noun in known["noun"]]}
        for name, things in GROUPS.items()
    ]
    for name, slot in ADJECTIVES.items():
        groups.append({"name": name, "kind": slot, "words": list(known[slot])})
    groups.append({"name": "Moods", "kind": "mood", "words": list(MOODS)})
    groups.append({"name": "Styles", "kind": "style", "words": list(OFFERED)})
    of = {
        part: [noun for noun, parts in OPTIONS.items() if part in parts] for part in known["part"]
    }
    groups.append({"name": "Parts", "kind": "part", "words": list(of), "of": of})
    return groups
