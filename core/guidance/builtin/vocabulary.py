"""The parser of the built-in prior's prompts, which refuses by name what it does not know.

A prompt is read into slots (``Words``). Order is free; articles, plurals, case and filler are
passed over. A note states what was not taken to the letter: a close misspelling that is read as
what it is close to, a narrower word that is made as a wider one, an adjective that is left out, an
unknown word before a known noun ("office chair"), also left out. Any other unknown word is an error
that names it, or, where the user asks for that, is left out too.

Standard library only, so that ``run.py words`` and the panel need not load a network.
"""

import re
from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any

from core.errors import UserError
from core.guidance.builtin.lexicon import (
    LEXICON,
    PART_FORMS,
    SLOTS,
    Entry,
    Vocabulary,
    corrected,
    forms_of,
    look_up,
    nearest_words,
)
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.offered import offered_words
from core.guidance.builtin.prompt_errors import PromptError, UnknownWordsError
from core.guidance.builtin.sizes import usual
from core.guidance.builtin.words import (
    FILLER,
    IGNORED_ADJECTIVES,
    LEGS,
    OPTIONS,
    PART_SYNONYMS,
    PART_WORDS,
    PHRASE_ENDS,
    TONES,
    WITHOUT,
)

SLOT_NAMES = {"color": "colour", "second": "second colour"}  # in a sentence
MADE_AS = {"color": "painted as", "pattern": "drawn as", "shape": "made"}  # else "made as"
ELSEWHERE = (
    "For any other wording use Stable Diffusion: --guidance FOLDER, where FOLDER holds its weights."
)
LONGEST = 3  # words of a phrase


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
    material_form: str = field(default="", compare=False)  # the material as it was written
    notes: tuple[str, ...] = field(default=(), compare=False)  # what the user should know
    left_out: tuple[str, ...] = field(default=(), compare=False)  # words without effect

    def indices(self, slots: Collection[str] = tuple(SLOTS)) -> list[int]:
        """Each slot's row in its embedding; 0 is "not stated"."""
        return [["", *SLOTS[slot]].index(getattr(self, slot)) for slot in slots]

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
    size_m, density = usual(words.noun, words.material)
    second = "" if words.target else words.second
    return {
        "prompt": prompt,
        "thing": words.noun,
        "shape": words.shape or None,
        "parts": [words.part] if words.part else [],
        "colours": [color for color in (words.color, second) if color],
        "part_colours": {words.target: words.second} if words.target else {},
        "materials": [words.material] if words.material else [],
        "pattern": words.pattern or None,
        "size_m": size_m,
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
    ``ignore_unknown``), two words for one slot, a part that the thing cannot lack or have, and a
    missing noun unless ``noun_needed`` is false (a negative prompt).
    """
    reading = _Reading(prompt, known)
    # Before the missing noun: an error with the nearest known words says more.
    if reading.refused and not ignore_unknown:
        raise _unknown_error(reading.refused, reading.qualifiers, known)
    if noun_needed and not reading.found["noun"]:
        raise PromptError(
            f"The prompt {prompt.strip()!r} does not name a thing the built-in prior knows.",
            f"{_things(known)} {ELSEWHERE}",
        )
    # The part last: what may be stated of it depends on the noun.
    words = {slot: reading.only(slot) for slot in ("noun", "shape", "material", "pattern")}
    words |= reading.colors() | {"part": reading.part(words["noun"])}
    words["material_form"] = next((entry.form for entry in reading.found["material"]), "")
    notes = dict.fromkeys([*reading.notes, *reading.narrower(), *reading.omissions()])
    return Words(**words, notes=tuple(notes), left_out=tuple(dict.fromkeys(reading.left_out)))


class _Reading:
    """A prompt's words, sorted into slots."""

    def __init__(self, prompt: str, known: Vocabulary) -> None:
        self.known = known
        self.found: dict[str, list[Entry]] = {slot: [] for slot in SLOTS}
        self.parts: list[tuple[str, bool, str]] = []  # a part, whether it is there, its colour
        self.left_out: list[str] = []  # all that has no effect, in order
        self.qualifiers: list[str] = []  # those of them that are before a noun, known or not
        self.refused: list[str] = []  # those of them without which the prompt is another
        self.notes: list[str] = []
        self._pending: list[str] = []  # unknown words since the noun phrase began
        self._before: list[tuple[str, bool, str]] = []  # parts in a phrase that has no noun yet
        self._without = self._after_color = False
        self._noun_end = -1  # the index behind the last noun, if nothing ended its phrase
        self._tokens, breaks = _tokens(prompt)
        at = 0
        while at < len(self._tokens):
            if at in breaks:
                self._end_phrase()
            at += self._take(at)
        self._end_phrase()

    def _take(self, at: int) -> int:
        """Read from the token ``at`` on; how many tokens that were."""
        tokens = self._tokens[at:]
        # The longest phrase first: "ice cream" must not be read as the colour "cream".
        for count in range(min(LONGEST, len(tokens)), 0, -1):
            entry = look_up(" ".join(tokens[:count]), self.known)
            if entry is not None:
                self._put(entry, at, at + count)
                return count
        token = tokens[0]
        if token in WITHOUT:
            self._without = True
            self._end_phrase()
        # A tone that makes no colour word of its own ("dark red" has one) is dropped, with a note.
        elif token in TONES and len(tokens) > 1 and LEXICON.get(tokens[1], ("",))[0] == "color":
            self.notes.append(f"{token} {tokens[1]} is painted as {LEXICON[tokens[1]][1]}.")
        elif token in IGNORED_ADJECTIVES:
            self.left_out.append(token)
        elif token in PHRASE_ENDS:
            self._end_phrase()
        elif token not in FILLER:
            self._correct(token, at)
        return 1

    def _end_phrase(self) -> None:
        """A noun phrase is over: what is unknown in it qualified no known noun. The last of it is
        the phrase's own noun."""
        self.parts += self._before
        self.refused += self._pending
        self.qualifiers += self._pending[:-1]
        self._pending, self._before, self._noun_end = [], [], -1

    def _correct(self, token: str, at: int) -> None:
        # Only where it is surely one known word; anything less is a hint in the error.
        close = corrected(token)
        entry = look_up(close, self.known) if close else None
        if entry is None:
            self.left_out.append(token)
            self._pending.append(token)
        else:
            self.notes.append(f"{token!r} is read as {close!r}.")
            self._put(entry, at, at + 1)

    def _put(self, entry: Entry, start: int, end: int) -> None:
        slot, word = entry.slot, entry.word
        # "with a hat" after the noun is a part; "a hat" is a thing
        if slot == "noun" and self.found["noun"]:
            part = _as_part(entry, self.found["noun"][0].word)
            slot, word = ("part", part) if part else (slot, word)
        if slot == "part" and not self.found["noun"] and entry.form not in LEXICON:
            # Until the phrase ends: before a noun ("a fin whale") it only qualifies that.
            self._before.append((word, not self._without, ""))
        elif slot == "part":
            color = ""
            # "with a blue handle": a colour right before a part is the part's, not the thing's.
            if self.found["color"] and self.found["noun"]:
                color = self.found["color"].pop().word if self._after_color else ""
            self.parts.append((word, not self._without, color))
            self._end_phrase()
        else:
            if slot == "noun":
                self._head(entry, start, end)
            self.found[slot].append(entry)
        self._after_color = slot == "color" and bool(self.found["noun"])
        self._without = False

    def _head(self, noun: Entry, start: int, end: int) -> None:
        """``noun`` ends a compound: what is unknown before it qualifies it, and so does another
        noun right before it ("desk lamp")."""
        if self._noun_end == start and self.found["noun"][-1].word != noun.word:
            form = self.found["noun"].pop().form
            self.left_out.append(form)
            self.qualifiers.append(form)
        parts = [part for part, _, _ in self._before]
        self.left_out += parts
        self.qualifiers += [*parts, *self._pending]
        self._pending, self._before, self._noun_end = [], [], end

    def words(self, slot: str) -> list[str]:
        """The slot's words, each once."""
        return list(dict.fromkeys(entry.word for entry in self.found[slot]))

    def only(self, slot: str) -> str:
        """The slot's one word, or none."""
        words = self.words(slot)
        if len(words) > 1:
            raise _two_error(slot, words)
        return words[0] if words else ""

    def narrower(self) -> list[str]:
        """A note for each word that stands for less than what is made for it."""
        return [
            f"{entry.form}: {MADE_AS.get(slot, 'made as')} {_with_article(slot, entry.word)}."
            for slot, entries in self.found.items()
            for entry in entries
            if entry.is_narrower
        ]

    def omissions(self) -> list[str]:
        """A note for all that is left out. A qualifier comes with the colour or the like that it
        may mean; there is nothing to suggest for the rest."""
        if not self.left_out:
            return []
        texts = [
            _with_hint(token, _near(token, self.qualifiers, self.known))
            if token in self.qualifiers
            else repr(token)
            for token in dict.fromkeys(self.left_out)
        ]
        return [f"The built-in prior does not know {', '.join(texts)}: left out."]

    def colors(self) -> dict[str, str]:
        """The first colour, the second, and the pattern that a second one implies."""
        colors = self.words("color")
        noun = self.found["noun"][0].word if self.found["noun"] else ""
        # In the order of the prompt: the first is the thing's, the next the pattern's.
        color, second = (*colors, "", "")[:2]
        target = ""
        for part, _, painted in self.parts:
            if not painted:
                continue
            if second and (second, target) != (painted, _own_name(noun, part)):
                raise _two_error("second", [second, painted])
            second, target = painted, _own_name(noun, part)
        if len(colors) > 2:
            raise _two_error("color", colors)
        # A second colour needs a place: without a pattern it goes to the accent parts.
        pattern = self.only("pattern") or ("two-tone" if second and not target else "")
        if target and pattern:
            text = f"With a pattern no part can have its own colour: {target}, {second}: left out."
            self.notes.append(text)
            second = target = ""
        return {"color": color, "second": second, "pattern": pattern, "target": target}

    def options(self, noun: str) -> list[str]:
        """What may be stated of the noun's parts."""
        return [state for state in OPTIONS.get(noun, ()) if state in self.known["part"]]

    def part(self, noun: str) -> str:
        """The one word of ``PARTS`` that is stated of the noun, or none."""
        states = []
        for part, there, _ in self.parts:
            state = part if there else f"no {part}"
            if state in self.options(noun):
                states.append(state)
            elif noun and not (there and _always_has(noun, part)):
                raise _part_error(noun, part, there, self.options(noun))
        if len(set(states)) > 1:
            raise _two_error("part", states)
        return states[0] if states else ""


def _tokens(prompt: str) -> tuple[list[str], set[int]]:
    """The words of a prompt in lower case, and the indices of those that punctuation precedes."""
    tokens: list[str] = []
    breaks: set[int] = set()
    # The s of a possessive is no word.
    for token in re.findall(r"[^\W_]+|[,;:.!?()]", prompt.lower().replace("'s", " ")):
        if token[0].isalnum():
            tokens.append(token)
        else:
            breaks.add(len(tokens))
    return tokens, breaks


def _with_article(slot: str, word: str) -> str:
    if slot != "noun":
        return word
    return f"{'an' if word[0] in 'aeiou' else 'a'} {word}"


def _near(token: str, qualifiers: list[str], known: Vocabulary) -> list[str]:
    """The known words nearest to an unknown one; no things for what stands before a noun."""
    near = nearest_words(token, known)
    if token not in qualifiers:
        return near
    return [word for word in near if LEXICON[word][0] != "noun"]


def _with_hint(token: str, near: list[str]) -> str:
    return f"{token!r} (did you mean {' or '.join(near)}?)" if near else repr(token)


def _looks(noun: str) -> dict[str, str]:
    return NOUNS[noun].looks if noun in NOUNS else {}


def _as_part(entry: Entry, noun: str) -> str:
    """The name under which a thing is a part of another: a bottle's cap, a piano's keys; or ""."""
    for name in (entry.word, entry.form):
        states = [state.removeprefix("no ") for state in OPTIONS.get(noun, ())]
        if name in states or _own_name(noun, name):
            return name
    return ""


def _own_name(noun: str, part: str) -> str:
    """What the noun itself calls the part; "" where it has none of that name."""
    return next((name for name in _names(part) if name in _looks(noun)), "")


def _always_has(noun: str, part: str) -> bool:
    if any(part in state for state in OPTIONS.get(noun, ())):
        return False
    legs = {"bench", "chair", "pig", "turtle"}
    # These nouns have four legs in any case, so that stating it changes nothing.
    if part in LEGS:
        return part == "four legs" and noun in legs
    return any(name in _looks(noun) for name in _names(part))


def _names(part: str) -> list[str]:
    """What a noun may call the part."""
    own = {"backrest": "back", "armrests": "arms", "cap": "lid"}.get(part, part)
    forms = forms_of(PART_WORDS.get(part, "")) + forms_of(PART_SYNONYMS.get(part, ""))
    names = [part, PART_FORMS.get(part, part), own, *forms]
    return [form for name in names for form in (name, f"{name}s")]


def _things(known: Vocabulary) -> str:
    """Where to find the things: some, since all would fill the screen."""
    some = list(known["noun"])[5:20]
    return f"It knows {len(known['noun'])} things, such as {', '.join(some)}; all: run.py words."


def _unknown_error(unknown: list[str], qualifiers: list[str], known: Vocabulary) -> UserError:
    nearest = {token: _near(token, qualifiers, known) for token in unknown}
    texts = "; ".join(_with_hint(token, near) for token, near in nearest.items())
    return UnknownWordsError(
        f"The built-in prior does not know {texts}.",
        f"{_things(known)} It knows the shapes {', '.join(known['shape'])}; "
        f"the colours {', '.join(known['color'])}; the materials {', '.join(known['material'])}; "
        f"the patterns {', '.join(known['pattern'])}. --ignore-unknown-words leaves out what it "
        f"does not know. {ELSEWHERE}",
        nearest,
    )


def _two_error(slot: str, words: list[str]) -> UserError:
    return PromptError(
        f"The built-in prior takes one {SLOT_NAMES.get(slot, slot)} in a prompt and got "
        f"{' and '.join(repr(word) for word in dict.fromkeys(words))}.",
        f"Keep one of them. {ELSEWHERE}",
    )


def _part_error(noun: str, part: str, there: bool, options: list[str]) -> UserError:
    choice = f"Use one of: {', '.join(options)}." if options else "Leave that out."
    state = f"with {part}" if there else f"without {part}"
    return UserError(f"The built-in prior cannot make a {noun} {state}.", choice)
