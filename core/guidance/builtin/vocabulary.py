"""The parser of the built-in prior's prompts, which refuses by name what it does not know.

A prompt is read into slots (``Words``). Order is free; articles, plurals, case and filler are
passed over. A close misspelling is read as what it is close to, and a note says so; so does one
where an adjective is left out that is no thing's name. Any other word that is not known is an error
that names it, or, where the user asks for that, is left out too.
"""

import difflib
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from core.errors import UserError
from core.guidance.builtin.looks import LOOKS
from core.guidance.builtin.words import (
    COLORS,
    FILLER,
    LEGS,
    MATERIALS,
    NEAREST,
    NOUNS,
    OPTIONS,
    PART_SYNONYMS,
    PART_WORDS,
    PARTS,
    PATTERNS,
    REAL,
    SHAPES,
    TONES,
    UNHEARD,
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
}
CALLED = {"color": "colour", "second": "second colour"}  # slots, in a sentence
ELSEWHERE = (
    "For any other wording use Stable Diffusion: --guidance FOLDER, where FOLDER holds its weights."
)
LONGEST = 3  # words of a phrase


@dataclass(frozen=True)
class Words:
    """What a prompt says, by slot; empty is not said."""

    noun: str = ""
    shape: str = ""
    part: str = ""
    color: str = ""
    material: str = ""
    pattern: str = ""
    second: str = ""  # colour, of what the pattern or the accent parts are painted with
    notes: tuple[str, ...] = field(default=(), compare=False)  # what the user should know

    def indices(self, slots: Collection[str] = tuple(SLOTS)) -> list[int]:
        """Each slot's row in its embedding; 0 is "not said"."""
        return [["", *SLOTS[slot]].index(getattr(self, slot)) for slot in slots]

    def __str__(self) -> str:
        said = [getattr(self, slot) for slot in ("shape", "pattern", "color", "material", "noun")]
        return " ".join(word for word in said if word)


Entry = tuple[str, str]  # a slot and its word
Known = Mapping[str, Collection[str]]  # words by slot


def _lexicon() -> dict[str, Entry]:
    lexicon: dict[str, Entry] = {}
    tables = {"noun": NOUNS, "shape": SHAPES, "color": COLORS, "material": MATERIALS}
    tables |= {"pattern": PATTERNS, "part": PART_WORDS}
    for slot, table in tables.items():
        for word, synonyms in table.items():
            for form in (word, *synonyms.split(", ")):
                if form:
                    lexicon.setdefault(form.replace("-", " "), (slot, word))
    return lexicon


LEXICON = _lexicon()
MEANT = {form: word for word, forms in NEAREST.items() for form in forms.split(", ")}
PART_FORMS = {form: part for part, forms in PART_SYNONYMS.items() for form in forms.split(", ")}


def parse(
    prompt: str,
    *,
    noun_needed: bool = True,
    known: Known = SLOTS,
    ignore_unknown: bool = False,
) -> Words:
    """Read a prompt into slots; ``known`` are the words that may be said.

    Raises ``UserError`` that names every word it does not know with the nearest it does (unless
    ``ignore_unknown``), two words for one slot, a part that the thing cannot lack or have, and a
    missing noun unless ``noun_needed`` is false (a negative prompt).
    """
    reading = _Reading(re.findall(r"[^\W_]+", prompt.lower().replace("'s", " ")), known)
    refused = [token for token in reading.unknown if token not in UNHEARD]
    if refused and not ignore_unknown:
        raise _unknown_error(refused, known)
    if reading.unknown:
        left_out = ", ".join(repr(token) for token in dict.fromkeys(reading.unknown))
        reading.notes.append(f"The built-in prior does not know {left_out}: left out.")
    if noun_needed and not reading.found["noun"]:
        raise UserError(
            f"The prompt {prompt.strip()!r} does not name a thing the built-in prior knows.",
            f"Say one of: {', '.join(known['noun'])}. {ELSEWHERE}",
        )
    words = {slot: reading.only(slot) for slot in ("noun", "shape", "material", "pattern")}
    words |= reading.colors() | {"part": reading.part(words["noun"])}
    return Words(**words, notes=tuple(dict.fromkeys(reading.notes)))


class _Reading:
    """A prompt's tokens, sorted into slots."""

    def __init__(self, tokens: list[str], known: Known) -> None:
        self.known = known
        self.found: dict[str, list[str]] = {slot: [] for slot in SLOTS}
        self.parts: list[tuple[str, bool, str]] = []  # a part, whether it is there, its colour
        self.unknown: list[str] = []
        self.notes: list[str] = []
        self._without = False
        at = 0
        while at < len(tokens):
            at += self._take(tokens[at:])

    def _take(self, tokens: list[str]) -> int:
        """Read from the front; how many tokens that were."""
        for count in range(min(LONGEST, len(tokens)), 0, -1):
            entry = self._entry(" ".join(tokens[:count]))
            if entry is not None:
                self._put(*entry)
                return count
        token = tokens[0]
        if token in WITHOUT:
            self._without = True
        elif token in TONES and len(tokens) > 1 and LEXICON.get(tokens[1], ("",))[0] == "color":
            self.notes.append(f"{token} {tokens[1]} is painted as {LEXICON[tokens[1]][1]}.")
        elif token in UNHEARD:
            self.unknown.append(token)
        elif token not in FILLER:
            self._mend(token)
        return 1

    def _entry(self, phrase: str) -> Entry | None:
        forms = singulars(phrase)
        for form in forms:
            slot, word = LEXICON.get(form, ("", ""))
            if slot == "part" or word in self.known.get(slot, ()):
                return slot, word
        for form in forms:
            if form in PART_FORMS or any(form in parts for parts in LOOKS.values()):
                return "part", PART_FORMS.get(form, form)
        return None

    def _mend(self, token: str) -> None:
        close = corrected(token)
        entry = self._entry(close) if close else None
        if entry is None:
            self.unknown.append(token)
        else:
            self.notes.append(f"{token!r} is read as {close!r}.")
            self._put(*entry)

    def _put(self, slot: str, word: str) -> None:
        # "with a hat" after the noun is a part; "a hat" is a thing
        if slot == "noun" and self.found["noun"] and _is_part(word, self.found["noun"][0]):
            slot = "part"
        if slot == "part":
            color = ""
            if self.found["color"] and self.found["noun"]:
                color = self.found["color"].pop() if self._colored_last else ""
            self.parts.append((word, not self._without, color))
        else:
            self.found[slot].append(word)
        self._colored_last = slot == "color" and bool(self.found["noun"])
        self._without = False

    _colored_last = False

    def only(self, slot: str) -> str:
        """The slot's one word, or none."""
        words = list(dict.fromkeys(self.found[slot]))
        if len(words) > 1:
            raise _two_error(slot, words)
        return words[0] if words else ""

    def colors(self) -> dict[str, str]:
        """The first colour, the second, and the pattern that a second one implies."""
        said = list(dict.fromkeys(self.found["color"]))
        noun = self.found["noun"][0] if self.found["noun"] else ""
        color, second = (*said, "", "")[:2]
        for part, _, painted in self.parts:
            if painted and _role(noun, part) == "*":  # painted as the rest is
                if color and color != painted:
                    raise _two_error("color", [color, painted])
                color = painted
            elif painted and second and second != painted:
                raise _two_error("second", [second, painted])
            elif painted:
                second = painted
        if len(said) > 2:
            raise _two_error("color", said)
        pattern = self.only("pattern") or ("two-tone" if second else "")
        return {"color": color, "second": second, "pattern": pattern}

    def options(self, noun: str) -> list[str]:
        """What may be said of the noun's parts."""
        return [said for said in OPTIONS.get(noun, ()) if said in self.known["part"]]

    def part(self, noun: str) -> str:
        """The one word of ``PARTS`` that is said of the noun, or none."""
        told = []
        for part, there, _ in self.parts:
            said = part if there else f"no {part}"
            if said in self.options(noun):
                told.append(said)
            elif noun and not (there and _always_has(noun, part)):
                raise _part_error(noun, part, there, self.options(noun))
        if len(set(told)) > 1:
            raise _two_error("part", told)
        return told[0] if told else ""


def _is_part(word: str, noun: str) -> bool:
    return word in LOOKS.get(noun, ()) or any(word in said for said in OPTIONS.get(noun, ()))


def _role(noun: str, part: str) -> str:
    """The role of a noun's part, see ``nature``; "" where it has none of that name."""
    looks = LOOKS.get(noun, {})
    name = next((name for name in _names(part) if name in looks), "")
    return looks[name][0] if name else ""


def _always_has(noun: str, part: str) -> bool:
    if any(part in said for said in OPTIONS.get(noun, ())):
        return False
    legs = {"bench", "chair", "pig", "turtle"}
    if part in LEGS:
        return part == "four legs" and noun in legs
    return any(name in LOOKS[noun] for name in _names(part))


def _names(part: str) -> list[str]:
    """What a noun may call the part."""
    own = {"backrest": "back", "armrests": "arms", "cap": "lid"}.get(part, part)
    return [part, f"{part}s", PART_FORMS.get(part, part), own]


def singulars(phrase: str) -> list[str]:
    """The phrase and what it may be the plural of."""
    forms = [phrase]
    if phrase.endswith("s"):
        forms.append(phrase[:-1])
    if phrase.endswith("es"):
        forms.append(phrase[:-2])
    return forms


def corrected(token: str) -> str:
    """The known word of which ``token`` is surely a misspelling, or "".

    One letter missing, doubled, or changed places with its neighbour; in words of six letters and
    more also one wrong letter after the first. Words of other things are no misspellings.
    """
    forms = [form for form in singulars(token) if len(form) > 3]
    if any(form in MEANT or form in REAL for form in forms):
        return ""
    known = [form for form in (*LEXICON, *WITHOUT) if " " not in form and len(form) > 3]
    close = (word for form in forms for word in known if _one_slip(form, word))
    return next(close, "")


def _one_slip(token: str, word: str) -> bool:
    a, b = sorted((token, word), key=len)
    if len(b) == len(a) + 1:
        return any(b[:i] + b[i + 1 :] == a for i in range(len(b)))
    if len(a) != len(b) or a == b:
        return False
    wrong = [i for i in range(len(a)) if a[i] != b[i]]
    if len(wrong) == 2 and wrong[1] == wrong[0] + 1:
        return a[wrong[0]] == b[wrong[1]] and a[wrong[1]] == b[wrong[0]]
    return len(wrong) == 1 and wrong[0] > 0 and len(a) >= 6


def nearest_words(token: str, known: Known = SLOTS) -> list[str]:
    """Known words that look or mean nearly the same, best first; at most three."""
    meant = [MEANT[form] for form in singulars(token) if form in MEANT]
    alike = difflib.get_close_matches(token, LEXICON, n=3, cutoff=0.7)
    said = [form for form in (*meant, *alike) if _is_known(form, known)]
    return list(dict.fromkeys(said))[:3]


def _is_known(form: str, known: Known) -> bool:
    slot, word = LEXICON[form]
    return slot == "part" or word in known.get(slot, ())


def _unknown_error(unknown: list[str], known: Known) -> UserError:
    told = []
    for token in dict.fromkeys(unknown):
        close = nearest_words(token, known)
        told.append(f"{token!r} (did you mean {' or '.join(close)}?)" if close else repr(token))
    return UserError(
        f"The built-in prior does not know {'; '.join(told)}.",
        f"It knows the things {', '.join(known['noun'])}; the shapes {', '.join(known['shape'])}; "
        f"the colours {', '.join(known['color'])}; the materials {', '.join(known['material'])}; "
        f"the patterns {', '.join(known['pattern'])}. --ignore-unknown-words leaves out what it "
        f"does not know. {ELSEWHERE}",
    )


def _two_error(slot: str, words: list[str]) -> UserError:
    return UserError(
        f"The built-in prior takes one {CALLED.get(slot, slot)} in a prompt and got "
        f"{' and '.join(repr(word) for word in dict.fromkeys(words))}.",
        f"Keep one of them. {ELSEWHERE}",
    )


def _part_error(noun: str, part: str, there: bool, options: list[str]) -> UserError:
    choice = f"Of a {noun} you can say: {', '.join(options)}." if options else "Leave that out."
    told = f"with {part}" if there else f"without {part}"
    return UserError(f"The built-in prior cannot make a {noun} {told}.", choice)
