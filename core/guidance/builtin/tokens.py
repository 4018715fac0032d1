"""A prompt's text as words. Standard library only."""

import re
import unicodedata
from dataclasses import dataclass, field

from core.guidance.builtin.lexicon import Entry, Vocabulary, look_up
from core.guidance.builtin.words import PHRASE_ENDS, SHORT

POSSESSIVE = "'s"
LONGEST = 3  # words of a phrase
DOING = re.compile("[a-z]{3,}ing")  # what a thing does
DONE = re.compile("[a-z]{2,}[^e]ed")  # what was done to it
# What it is like; a catfish is a thing.
LIKE = re.compile("[a-z]{3,}(?:ful|ous|(?<!f)ish|less|ical|esque|istic|ural)")
NUMBER = re.compile("[0-9]+[a-z]{0,2}")  # with its unit: "60", "1950s", "2m"


@dataclass
class Tokens:
    """A prompt's words in lower case; what is short for a word is that word."""

    known: Vocabulary
    words: list[str] = field(default_factory=list)
    breaks: set[int] = field(default_factory=set)  # indices of those that punctuation precedes
    owners: set[int] = field(default_factory=set)  # of those that are possessive, without their s

    @classmethod
    def of(cls, prompt: str, known: Vocabulary) -> "Tokens":
        """The words of a prompt; ``known`` are those that may be asked for."""
        found = cls(known)
        plain = unicodedata.normalize("NFKC", prompt).lower().replace("\u2019", "'")
        for token in re.findall(r"'s\b|[^\W_]+|[,;:.!?()]", plain):
            if token == POSSESSIVE:
                found.owners.add(len(found.words) - 1)
            elif token[0].isalnum():
                found.words.append(SHORT.get(token, token))
            else:
                found.breaks.add(len(found.words))
        return found

    def phrases(self, at: int) -> list[str]:
        """What begins at the index, the longest first: "ice cream" is not the colour "cream"."""
        words = self.words[at : at + LONGEST]
        return [" ".join(words[:count]) for count in range(len(words), 0, -1)]

    def color(self, at: int) -> tuple[Entry, int] | None:
        """The colour that begins at the index, and how many words it takes."""
        for phrase in self.phrases(at):
            entry = look_up(phrase, self.known)
            if entry is not None:
                return (entry, len(phrase.split())) if entry.slot == "color" else None
        return None

    def has_thing(self, at: int) -> bool:
        """Whether a thing's name begins at the index."""
        found = (look_up(phrase, self.known) for phrase in self.phrases(at))
        return any(entry is not None and entry.slot == "noun" for entry in found)

    def ends_phrase(self, end: int) -> bool:
        """Whether a phrase ends before the index, and goes on with no "and"."""
        if end in (*self.breaks, len(self.words)):
            return True
        after = self.words[end]
        return after in PHRASE_ENDS - {"and"} or DOING.fullmatch(after) is not None


def describes(word: str) -> bool:
    """Whether a word that is not known only says what another is like, and names nothing."""
    return any(form.fullmatch(word) for form in (DONE, LIKE, NUMBER))
