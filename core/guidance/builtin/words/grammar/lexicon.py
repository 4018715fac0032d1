"""Known forms of words, readings of misspellings, and hints for the rest.

Standard library only: a prompt is parsed without loading a network.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import NamedTuple

from core.guidance.builtin.nouns import NOUNS, PART_NAMES
from core.guidance.builtin.variants import has_own_look
from core.guidance.builtin.words.tables.colors import SHADES
from core.guidance.builtin.words.tables.nearest import MISSPELLED, NEAREST, REAL
from core.guidance.builtin.words.tables.part_tables import (
    CALLED,
    PART_ALSO,
    PART_SYNONYMS,
    PART_WORDS,
    PARTS,
    TRIM,
    WHOLE,
)
from core.guidance.builtin.words.tables.words import (
    COLORS,
    FILLER,
    IGNORED_ADJECTIVES,
    MATERIALS,
    PATTERNS,
    SHAPES,
    SHEENS,
    WEATHERS,
    WITHOUT,
)

SLOTS: dict[str, Collection[str]] = {
    "noun": NOUNS,
    "shape": SHAPES,
    "part": PARTS,
    "color": COLORS,
    "material": MATERIALS,
    "pattern": PATTERNS,
    "second": COLORS,
    "target": PART_NAMES,
}
Vocabulary = Mapping[str, Collection[str]]  # words by slot


class Entry(NamedTuple):
    """A word of a slot, and its form as written."""

    slot: str
    word: str
    form: str

    @property
    def is_narrower(self) -> bool:
        """Whether the form means less than, or something next to, the made word. A material with
        its own detail is made as named."""
        return self.form in NARROWER and not has_own_look(self.form)


def forms_of(text: str) -> list[str]:
    """The forms of a table's row: commas separate synonyms, a semicolon precedes narrower words."""
    return [form for form in re.split(r"[,;] ", text) if form]


def _lexicon() -> tuple[dict[str, tuple[str, str]], frozenset[str]]:
    """The word of each form, with its slot; and the forms that are narrower than their word."""
    lexicon: dict[str, tuple[str, str]] = {}
    narrower = []
    # The first table that has a form keeps it: "hat" is a thing, and a part only after a noun.
    names = {word: noun.names for word, noun in NOUNS.items()}
    tables = {"noun": names, "shape": SHAPES, "color": COLORS, "material": MATERIALS}
    tables |= {"pattern": PATTERNS, "weather": WEATHERS, "sheen": SHEENS}
    tables |= {"part": PART_WORDS}
    for slot, table in tables.items():
        for word, text in table.items():
            for form in (word, *forms_of(text), *SHADES.get(word, ())):
                lexicon.setdefault(_as_read(form), (slot, word))
            narrower += map(_as_read, forms_of(text.partition("; ")[2]))
    return lexicon, frozenset(narrower)


def _as_read(form: str) -> str:
    """A form as a prompt's words are parsed, without hyphens and possessives."""
    return form.replace("-", " ").replace("'s", "")


LEXICON, NARROWER = _lexicon()
# The ends of plurals with those of their singulars.
PLURALS = (("s", ""), ("es", ""), ("ies", "y"), ("ves", "f"), ("ves", "fe"), ("men", "man"))
HISSING = ("s", "x", "z", "ch", "sh", "o")
MEANT = {form: word for word, text in NEAREST.items() for form in forms_of(text)}
PART_FORMS = {form: part for part, text in PART_SYNONYMS.items() for form in forms_of(text)}
COMPOUNDS = tuple(form for form in LEXICON if " " in form)
# Meanings of frequent spellings.
OFTEN = {form.replace(" ", ""): form for form in COMPOUNDS}
OFTEN |= {form: word for word, text in MISSPELLED.items() for form in text.split()}
SAID = LEXICON.keys() | IGNORED_ADJECTIVES | FILLER  # words that are not slips of others
OWN_NAMES = {form for forms in CALLED.values() for form in forms}
# Parts, whether a thing calls them so or not.
NAMED = PART_FORMS.keys() | PART_ALSO | WHOLE | TRIM | OWN_NAMES
PARTS = frozenset(NAMED) | {part for noun in NOUNS.values() for part in noun.looks}


def look_up(phrase: str, known: Vocabulary) -> Entry | None:
    """The meaning of a phrase among the ``known`` words: itself, or its possible singular."""
    forms = singulars(phrase)
    for form in forms:
        slot, word = LEXICON.get(form, ("", ""))
        if slot in ("part", "weather", "sheen") or word in known.get(slot, ()):
            return Entry(slot, word, form)
    for form in forms:
        if form in PARTS:
            return Entry("part", PART_FORMS.get(form, form), form)
    return None


def singulars(phrase: str) -> list[str]:
    """The phrase and its possible singulars."""
    stem = [phrase.removesuffix(plural) + one for plural, one in PLURALS if phrase.endswith(plural)]
    hissing = phrase.removesuffix("es").endswith(HISSING)
    return [phrase, *(one for one in stem if hissing or f"{one}es" != phrase)]  # "tines": no tin


def corrected(token: str, also: Iterable[str] = (), no_thing: bool = False) -> str:
    """The known word, or the one of ``also``, of which ``token`` is surely a misspelling, or "";
    ``no_thing``: not a thing's name, if it may be another word.

    One letter missing, doubled, or changed places with its neighbour; in words of six letters and
    more also one wrong letter after the first; or an entry of the table of misspellings. Words of
    other things are not misspellings.
    """
    if token in OFTEN:
        return OFTEN[token]
    # A set has another order in each process.
    found = list(_one_slip_away(token, (*LEXICON, *sorted(NAMED), *WITHOUT, *also), 6))
    if no_thing:
        found.sort(key=lambda word: LEXICON.get(word, ("", ""))[0] == "noun")
    return found[0] if found else ""


def corrected_phrase(tokens: list[str]) -> str:
    """The known name of several words at the start of ``tokens`` with a slip in one of them, as in
    :func:`corrected`, or ""."""
    for form in COMPOUNDS:
        words = form.split()
        pairs = zip(tokens, words, strict=False)
        wrong = [(token, word) for token, word in pairs if token != word]
        if len(wrong) == 1 and len(tokens) >= len(words):
            token, word = wrong[0]
            if token not in SAID and any(_one_slip_away(token, [word], 5)):
                return form
    return ""


def nearest_words(token: str, known: Vocabulary = SLOTS) -> list[str]:
    """Known words near to ``token``, best first, at most three: near in meaning by the table of
    meanings, else in spelling, as one slip away."""
    forms = [form for form in singulars(token) if form in MEANT]
    # A wrong letter in a word of five may be a slip, or another word: enough for a hint alone.
    near = [MEANT[form] for form in forms] or list(_one_slip_away(token, LEXICON, 5))
    return [form for form in dict.fromkeys(near) if _is_known(form, known)][:3]


def _one_slip_away(token: str, words: Iterable[str], length: int) -> Iterator[str]:
    """``words`` that ``token`` may misspell; a wrong letter counts from ``length`` letters."""
    forms = [form for form in singulars(token) if len(form) > 3]
    # Another thing's name is not a misspelling, however near it is.
    if any(form in MEANT or form in REAL for form in forms):
        return
    # Words of three letters are one slip away from too many others.
    known = [word for word in words if " " not in word and len(word) > 3]
    yield from (word for form in forms for word in known if _one_slip(form, word, length))


def _one_slip(token: str, word: str, length: int) -> bool:
    a, b = sorted((token, word), key=len)
    # One letter missing, or one too many.
    if len(b) == len(a) + 1:
        return any(b[:i] + b[i + 1 :] == a for i in range(len(b)))
    if len(a) != len(b) or a == b:
        return False
    # Two neighbours that changed places, or, in long words, one wrong letter that is not the first.
    wrong = [i for i in range(len(a)) if a[i] != b[i]]
    if len(wrong) == 2 and wrong[1] == wrong[0] + 1:
        return a[wrong[0]] == b[wrong[1]] and a[wrong[1]] == b[wrong[0]]
    return len(wrong) == 1 and wrong[0] > 0 and len(a) >= length


def _is_known(form: str, known: Vocabulary) -> bool:
    slot, word = LEXICON[form]
    return slot == "part" or word in known.get(slot, ())
