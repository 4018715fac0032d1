"""A prompt's words, sorted into slots: the grammar of the built-in prior. Standard library only."""

import re
import unicodedata
from typing import Any

from core.guidance.builtin.accents import StatedPart, accents_of
from core.guidance.builtin.lexicon import (
    LEXICON,
    MEANT,
    SLOTS,
    Entry,
    Vocabulary,
    corrected,
    look_up,
    singulars,
)
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.part_names import always_has, as_part, may_state
from core.guidance.builtin.prompt_errors import near_words, part_error, two_error, with_hint
from core.guidance.builtin.words import (
    ALONE,
    COUNTS,
    DEPICTIONS,
    FILLER,
    GOES_WITH,
    IGNORED_ADJECTIVES,
    OF_ANOTHER,
    OPTIONS,
    PHRASE_ENDS,
    TONES,
    TOYS,
    WITHOUT,
)

MADE_AS = {"color": "painted as", "pattern": "drawn as", "shape": "made"}  # else "made as"
ARTICLES = ("a", "an", "the")
LONGEST = 3  # words of a phrase
DOING = re.compile("[a-z]{3,}ing")  # what a thing does


class Reading:
    """A prompt's words, sorted into slots.

    ``alone``: what ends a phrase is a thing if it can be one: "a grey rock" is a boulder.
    """

    def __init__(self, prompt: str, known: Vocabulary, alone: bool = False) -> None:
        self.known = known
        self._alone = alone
        self.found: dict[str, list[Entry]] = {slot: [] for slot in (*SLOTS, "weather")}
        self.parts: list[StatedPart] = []
        self.left_out: list[str] = []  # all that has no effect, in order
        self.aside: list[str] = []  # accessories, which have no effect either
        self.qualifiers: list[str] = []  # of ``left_out``, before a noun, known or not
        self.refused: list[str] = []  # those of them without which the prompt is another
        self.notes: list[str] = []
        self.is_toy = False
        self._pending: list[str] = []  # unknown words since the noun phrase began
        self._before: list[StatedPart] = []  # parts in a phrase that has no noun yet
        self._without = False
        self._looks: list[str] = []  # slots of the colours and materials right before
        # How many words each slot had when a phrase about what goes with the thing began; else None
        self._accessory: dict[str, int] | None = None
        self._strange = False  # whether an unknown word was read in it
        self._of_another = False  # whether all of it is about another thing
        self._ended_by = ""  # the word that began the phrase
        self._noun_end = -1  # the index behind the last noun, if nothing ended its phrase
        self._tokens, self._breaks = _tokens(prompt)
        at = 0
        while at < len(self._tokens):
            if at in self._breaks:
                self._end_phrase()
                self._without = False
                self._accessory, self._of_another = None, False
            at += self._take(at)
        self._end_phrase()
        self._leave_strange_parts_aside()

    def _take(self, at: int) -> int:
        """Read from the token ``at`` on; how many tokens that were."""
        tokens = self._tokens[at:]
        # The longest phrase first: "ice cream" must not be read as the colour "cream".
        for count in range(min(LONGEST, len(tokens)), 0, -1):
            phrase = " ".join(tokens[:count])
            entry = look_up(phrase, self.known)
            if entry is not None:
                self._put(entry, at, at + count)
                return count
            if count > 1 and phrase in IGNORED_ADJECTIVES:
                self.left_out.append(phrase)
                return count
            if phrase in OF_ANOTHER and self.found["noun"]:
                self._go_with(phrase)
                self._of_another = True
                return count
            # "a computer mouse" is no mouse.
            if count > 1 and any(form in MEANT for form in singulars(phrase)):
                return self._leave_out(phrase, count)
        token = tokens[0]
        if token in WITHOUT:
            self._without = True
            self._end_phrase()
        # A tone that makes no colour word of its own ("dark red" has one) is dropped, with a note.
        elif token in TONES and len(tokens) > 1 and LEXICON.get(tokens[1], ("",))[0] == "color":
            self.notes.append(f"{token} {tokens[1]} is painted as {LEXICON[tokens[1]][1]}.")
        elif token in IGNORED_ADJECTIVES:
            self.left_out.append(token)
            # Of the thing itself: not "a child with a toy".
            self.is_toy |= token in TOYS and self._accessory is None
        elif token in COUNTS and not self.found["noun"]:
            self.notes.append(f"{token}: one thing is made at a time.")
        elif token in COUNTS:
            self.left_out.append(token)
        elif token in PHRASE_ENDS:
            self._without &= token in ARTICLES
            # "a statue of a lion": the article says nothing new.
            word = self._ended_by if token in ARTICLES else token
            if self.found["noun"] and (token in GOES_WITH or self._accessory is not None):
                self._go_with(word)
            else:
                self._end_phrase()
                self._ended_by = word
        elif self.found["noun"] and DOING.fullmatch(token):
            # "a robot playing guitar"
            self.left_out.append(token)
            self._go_with(token)
            self._of_another = True
        elif token == "shaped" and self._noun_end == at:
            # "a heart shaped box": as if the two nouns were next to each other.
            self._noun_end += 1
        elif token not in FILLER:
            return self._correct(token, at)
        return 1

    def _end_phrase(self) -> None:
        """A noun phrase is over: what is unknown in it qualified no known noun. The last of it is
        the phrase's own noun."""
        # The accessory is unknown, or all is of another thing: its colours are not the thing's.
        if self._strange or self._of_another:
            self.left_out += self._of_accessory()
        self._strange = False
        self.parts += self._before
        self.refused += self._pending
        self.qualifiers += self._pending[:-1]
        self._pending, self._before, self._noun_end, self._looks = [], [], -1, []

    def _go_with(self, word: str) -> None:
        """``word`` begins a phrase about what goes with the thing."""
        self._end_phrase()
        self._ended_by = word
        self._accessory = {slot: len(found) for slot, found in self.found.items()}

    def _correct(self, token: str, at: int) -> int:
        """Read an unknown token as the word that it is a slip of; how many tokens that were."""
        # Only where it is surely one known word; anything less is a hint in the error.
        close = corrected(token)
        if not close or (close not in WITHOUT and look_up(close, self.known) is None):
            return self._leave_out(token, 1)
        self.notes.append(f"{token!r} is read as {close!r}.")
        self._tokens[at] = close
        return self._take(at)  # it may begin a phrase: "a wizzard hat"

    def _leave_out(self, unknown: str, count: int) -> int:
        """Leave an unknown word, or a phrase of ``count``, out."""
        self.left_out.append(unknown)
        self._strange = self._accessory is not None
        # What goes with the thing may be unknown, the thing itself may not.
        if self._accessory is None:
            self._pending.append(unknown)
        return count

    def _put(self, entry: Entry, start: int, end: int) -> None:
        if self._alone and entry.form in ALONE and not self.found["noun"] and self._stands(end):
            entry = Entry("noun", ALONE[entry.form], entry.form)
        slot, word = entry.slot, entry.word
        if slot == "noun" and self._is_depicted(entry):
            return
        if slot == "weather" and self._without:  # "without scratches"
            self.left_out.append(entry.form)
            return
        # "with a hat" after the noun is a part; "a hat" is a thing
        if slot == "noun" and self.found["noun"]:
            noun = self.found["noun"][0].word
            # "pirate boots" are no pirate: what somebody wears is a thing by itself.
            worn = self._noun_end == start and noun in GROUPS["Characters"]
            part = "" if worn else as_part(entry, noun)
            slot, word = ("part", part) if part else (slot, word)
            if slot == "noun" and self._accessory is not None:
                self._leave_aside(entry.form)
                return
        if slot == "part" and not self.found["noun"] and entry.form not in LEXICON:
            # Until the phrase ends: before a noun ("a fin whale") it only qualifies that.
            self._before.append(StatedPart(word, not self._without, entry.form))
        elif slot == "part":
            # "with a blue leather handle": what is right before a part is the part's, not the
            # thing's.
            own = {look: self.found[look].pop() for look in dict.fromkeys(self._looks)}
            color = own["color"].word if "color" in own else ""
            self.left_out += self._of_accessory()
            self._strange = False
            there = not self._without
            if not there:  # "without a red chimney"
                color, own = "", {}
            self.parts.append(StatedPart(word, there, entry.form, color, own.get("material")))
            self._end_phrase()
        else:
            if slot == "noun":
                self._head(entry, start, end)
            self.found[slot].append(entry)
        if slot in ("color", "material") and self.found["noun"]:
            self._looks.append(slot)
        elif slot != "weather":
            self._looks = []
        if slot in ("noun", "part"):
            self._without = False

    def _stands(self, end: int) -> bool:
        """Whether a phrase ends before the token ``end`` and is no quality of another: "a rock with
        moss", but "orange and blue", "in orange"."""
        if self._ended_by in ("and", "in", "with"):
            return False
        ends = PHRASE_ENDS - {"and"}
        return end in (*self._breaks, len(self._tokens)) or self._tokens[end] in ends

    def _is_depicted(self, entry: Entry) -> bool:
        """Whether ``entry`` and the noun before it are a thing and its depiction: "a statue of a
        lion", "a lion statue". The thing is made then."""
        nouns = self.found["noun"]
        if len(nouns) != 1 or nouns[0].word == entry.word:
            return False
        before = nouns[0]
        if before.form in DEPICTIONS and self._accessory is not None and self._ended_by == "of":
            nouns[:] = [entry]
            self._accessory = None
            thing, depiction = entry, before
        elif entry.form in DEPICTIONS and self._noun_end >= 0:
            thing, depiction = before, entry
        else:
            return False
        self.notes.append(f"{depiction.form}: made as {_with_article('noun', thing.word)}.")
        return True

    def _leave_strange_parts_aside(self) -> None:
        """A part that the thing never has is an accessory: icing on a torus."""
        noun = self.found["noun"][0].word if self.found["noun"] else ""
        for stated in list(self.parts):
            part, there, form, color, material = stated
            # What may be stated of the thing is refused instead where it is not known.
            if noun and there and not may_state(noun, part) and not always_has(noun, part):
                self.parts.remove(stated)
                of = material.form if material else ""
                self._leave_aside(" ".join(filter(None, (color, of, form))))

    def _leave_aside(self, form: str) -> None:
        left = [*self._of_accessory(), form]
        self.aside += left
        self.notes.append(f"{' '.join(left)}: left out, as one thing is made at a time.")

    def _of_accessory(self) -> list[str]:
        """Take back the colours and the like that were read in a phrase about an accessory, since
        they are not the thing's; their forms."""
        taken = []
        for slot, count in (self._accessory or {}).items():
            taken += [entry.form for entry in self.found[slot][count:]]
            del self.found[slot][count:]
        return taken

    def _head(self, noun: Entry, start: int, end: int) -> None:
        """``noun`` ends a compound: what is unknown before it qualifies it, and so does another
        noun right before it ("desk lamp")."""
        if self._noun_end == start and self.found["noun"][-1].word != noun.word:
            form = self.found["noun"].pop().form
            self.left_out.append(form)
            self.qualifiers.append(form)
        parts = [part.name for part in self._before]
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
            raise two_error(slot, words)
        return words[0] if words else ""

    def narrower(self) -> list[str]:
        """A note for each word that stands for less than what is made for it."""
        of_parts = [part.material for part in self.parts if part.material]
        return [
            f"{entry.form}: {MADE_AS.get(entry.slot, 'made as')} "
            f"{_with_article(entry.slot, entry.word)}."
            for entry in [*(x for entries in self.found.values() for x in entries), *of_parts]
            if entry.is_narrower
        ]

    def omissions(self) -> list[str]:
        """A note for all that is left out. A qualifier comes with the colour or the like that it
        may mean; there is nothing to suggest for the rest."""
        if not self.left_out:
            return []
        texts = [
            with_hint(token, near_words(token, self.qualifiers, self.known))
            if token in self.qualifiers
            else repr(token)
            for token in dict.fromkeys(self.left_out)
        ]
        return [f"The built-in model does not know {', '.join(texts)}: left out."]

    def colors(self) -> dict[str, Any]:
        """The first colour, the second, the pattern that a second one implies, the part that the
        second is for, and what other parts have of their own."""
        colors = self.words("color")
        if len(colors) > 2:
            raise two_error("color", colors)
        # In the order of the prompt: the first is the thing's, the next the pattern's.
        color, second = (*colors, "", "")[:2]
        # A second colour needs a place: without a pattern it goes to the accent parts.
        pattern = self.only("pattern") or ("two-tone" if second else "")
        noun = self.found["noun"][0].word if self.found["noun"] else ""
        accents = accents_of(self.parts, noun)
        target = ""
        first = next((accent for accent in accents if accent.color), None)
        if first and not pattern:
            second, target = first.color, first.part
            accents[accents.index(first)] = first._replace(color="")
        told = tuple(accent for accent in accents if accent.color or accent.material)
        found = {"color": color, "second": second, "pattern": pattern, "target": target}
        return found | {"accents": told}

    def options(self, noun: str) -> list[str]:
        """What may be stated of the noun's parts."""
        return [state for state in OPTIONS.get(noun, ()) if state in self.known["part"]]

    def part(self, noun: str) -> str:
        """The one word of ``PARTS`` that is stated of the noun, or none."""
        states = []
        for part, there, *_ in self.parts:
            state = part if there else f"no {part}"
            if state in self.options(noun):
                states.append(state)
            elif noun and not (there and always_has(noun, part)):
                raise part_error(noun, part, there, self.options(noun))
        if len(set(states)) > 1:
            raise two_error("part", states)
        return states[0] if states else ""


def _tokens(prompt: str) -> tuple[list[str], set[int]]:
    """The words of a prompt in lower case, and the indices of those that punctuation precedes."""
    tokens: list[str] = []
    breaks: set[int] = set()
    # The s of a possessive is no word.
    plain = unicodedata.normalize("NFKC", prompt).lower().replace("'s", " ")
    for token in re.findall(r"[^\W_]+|[,;:.!?()]", plain):
        if token[0].isalnum():
            tokens.append(token)
        else:
            breaks.add(len(tokens))
    return tokens, breaks


def _with_article(slot: str, word: str) -> str:
    if slot != "noun":
        return word
    return f"{'an' if word[0] in 'aeiou' else 'a'} {word}"
