"""Errors of a prompt that the built-in prior refuses."""

from core.errors import UserError
from core.guidance.builtin.words.grammar.lexicon import LEXICON, Vocabulary, nearest_words

ELSEWHERE = (
    "For any other wording use Stable Diffusion: --guidance FOLDER, where FOLDER holds its weights."
)


class PromptError(UserError):
    """A prompt that the built-in prior cannot make."""

    window_fix = "Change the prompt. “Words” next to it lists what is known."


class UnknownWordsError(PromptError):
    """A prompt has words that are not known; ``nearest`` has the nearest known ones of each."""

    def __init__(self, text: str, fix: str, nearest: dict[str, list[str]]) -> None:
        super().__init__(text, fix)
        self.nearest = nearest


def unknown_error(unknown: list[str], qualifiers: list[str], known: Vocabulary) -> UserError:
    """The error for ``unknown`` words, with the ``qualifiers`` that precede a noun."""
    nearest = {token: near_words(token, qualifiers, known) for token in unknown}
    texts = "; ".join(with_hint(token, near) for token, near in nearest.items())
    return UnknownWordsError(
        f"The built-in model does not know {texts}.",
        f"{known_things(known)} It knows the shapes {', '.join(known['shape'])}; "
        f"the colours {', '.join(known['color'])}; the materials {', '.join(known['material'])}; "
        f"the patterns {', '.join(known['pattern'])}. --ignore-unknown-words leaves out what it "
        f"does not know. {ELSEWHERE}",
        nearest,
    )


class TwoWordsError(PromptError):
    """A prompt has more than one word where a slot takes one."""


def two_error(slot: str, words: list[str]) -> UserError:
    """The error for more than one word in a slot that takes one."""
    return TwoWordsError(
        f"The built-in model takes one {slot} in a prompt and got "
        f"{' and '.join(repr(word) for word in dict.fromkeys(words))}.",
        f"Keep one of them. {ELSEWHERE}",
    )


def part_error(noun: str, part: str, there: bool, options: list[str]) -> UserError:
    """The error for a part that the noun cannot have (``there``) or lack; ``options``: those it
    can."""
    choice = f"Use one of: {', '.join(options)}." if options else "Leave that out."
    state = f"with {part}" if there else f"without {part}"
    return UserError(f"The built-in model cannot make a {noun} {state}.", choice)


def known_things(known: Vocabulary) -> str:
    """A hint to the list of things, with a few examples."""
    some = list(known["noun"])[5:20]
    return f"It knows {len(known['noun'])} things, such as {', '.join(some)}; all: run.py words."


def near_words(token: str, qualifiers: list[str], known: Vocabulary) -> list[str]:
    """The known words nearest to an unknown one; no things for a word before a noun."""
    near = nearest_words(token, known)
    if token not in qualifiers:
        return near
    return [word for word in near if LEXICON[word][0] != "noun"]


def with_hint(token: str, near: list[str]) -> str:
    """The unknown word as an error or a note shows it."""
    return f"{token!r} (did you mean {' or '.join(near)}?)" if near else repr(token)
