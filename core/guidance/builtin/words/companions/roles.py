"""Roles: "a penguin chef", "a pirate cat", "a farmer", "a cat dressed as a wizard": their costumes.

Standard library only.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companions.known_as import ALSO_DRESSED, is_dressed
from core.guidance.builtin.words.grammar.lexicon import SLOTS, corrected, look_up
from core.guidance.builtin.words.grammar.openers import TOKEN, named_in
from core.guidance.builtin.words.grammar.tokens import LONGEST, PERSON
from core.guidance.builtin.words.phrases.emblems import drawn_in
from core.guidance.builtin.words.tables.costumes import HUNTERS, KINDS, MAKERS, OF_KINDS, ROLES
from core.guidance.builtin.words.tables.living import is_animal
from core.guidance.builtin.words.tables.words import DEPICTIONS, FILLER, IGNORED_ADJECTIVES

ROBOT = "robot"
NO_ROLES = frozenset(("king penguin", "king cobra"))  # animals that are called so
DEPICTED = frozenset((*DEPICTIONS, "toy"))  # "a wizard plushie" is a wizard
EATEN = frozenset(noun for group in ALSO_DRESSED for noun in GROUPS[group])
_LEAST = 6  # letters of a name that may be misspelt
_NAMED = "|".join(sorted(map(re.escape, ROLES), key=len, reverse=True))
_HAS_ROLE = re.compile(rf"(?<![\w-])(?:{_NAMED})(?![\w-])", re.IGNORECASE)
# "As a queen bee", "as a wizard's apprentice" are no queen and no wizard.
_END = r"(?=\s*(?:$|[,;.!?)]|(?:with|and|in|on|at|by|who|that|for|from|[a-z]+ing)(?![\w-])))"
_DRESSED = re.compile(
    rf"(?<![\w-])(?:(?:(?:who|that) is )?(?:dressed|disguised) (?:up )?(?:as|like) (?:an? |the )?"
    rf"(?P<as>{_NAMED}){_END}"
    rf"|(?:dressed in|wearing|in|with) (?:an? |the )?(?P<in>{_NAMED})(?:'s)? "
    r"(?:costume|outfit|uniform|suit|clothes)(?![\w-])"
    rf"|as (?:an? |the )(?P<so>{_NAMED}){_END})",
    re.IGNORECASE,
)

_OF = re.compile(r" (?:of|depicting) ", re.IGNORECASE)


class Name(NamedTuple):
    """The meaning of one or a few words of a prompt."""

    text: str
    noun: str  # "": a role alone, such as "police"
    start: int
    end: int


def undisguised(prompt: str) -> tuple[str, tuple[str, ...]]:
    """The prompt with the role replaced by its costume, as "wearing a hat"."""
    if not _HAS_ROLE.search(prompt):
        return prompt, ()
    written = [(start, end) for _, start, end in drawn_in(prompt)]
    for match in _DRESSED.finditer(prompt):
        quoted = any(start <= match.start() < end for start, end in written)
        if not quoted and is_dressed(named_in(prompt[: match.start()])):
            role = (match["as"] or match["in"] or match["so"]).lower()
            return f"{prompt[: match.start()].rstrip()}{prompt[match.end() :]}", ROLES[role]
    names = _depicted(prompt, list(first_names(prompt)))
    if len(names) == 1 and names[0].noun == PERSON:  # "a farmer"
        return prompt, ROLES.get(names[0].text, ())
    return _in_role(prompt, *names) if len(names) == 2 else (prompt, ())


def _depicted(prompt: str, names: list[Name]) -> list[Name]:
    """The names of the depicted thing and not the depiction's: "a plush toy of a corgi nurse"."""
    if len(names) != 1 or names[0].text not in DEPICTED:
        return names
    of = _OF.match(prompt, names[0].end)
    begin = of.end() if of else len(prompt)
    behind = list(first_names(prompt[begin:]))
    return [one._replace(start=begin + one.start, end=begin + one.end) for one in behind] or names


def _in_role(prompt: str, first: Name, last: Name) -> tuple[str, tuple[str, ...]]:
    """Which of two names is the other's role: "a penguin chef", "a pirate cat"."""
    if f"{first.text} {last.text}" in NO_ROLES or last.text in DEPICTED:
        return prompt, ()
    own = {name.noun for name in (first, last)} - {"", PERSON}
    makes = last.text in MAKERS and first.noun in EATEN
    if makes or (last.text in HUNTERS and is_animal(first.noun)):  # "a sushi chef"
        worn = ROLES[last.text] if last.noun == PERSON else ()
        return _without(prompt, first), worn
    # "A woman warrior", "a robot knight": the role is a thing of its own.
    if first.noun == PERSON and last.noun in own and last.text in ROLES:
        return _without(prompt, first), ()
    if first.noun == ROBOT and last.noun in own:
        return prompt, ()
    # The last of two roles is the figure, "a warrior princess", unless it is only a person.
    leads = first.text in ROLES and last.noun and (last.noun != PERSON or first.noun not in own)
    for role, other in ((first, last), (last, first))[:: 1 if leads else -1]:
        if role.text in ROLES and is_dressed(other.noun) and not _is_kind(role, other):
            return _without(prompt, role), ROLES[role.text]
    return prompt, ()


def _is_kind(role: Name, other: Name) -> bool:
    """Whether both are one name of an animal or a cake: "a soldier ant", "a king cake"."""
    if role.start > other.start:
        return False
    kind = role.text in OF_KINDS and other.noun in KINDS
    return kind or other.noun in EATEN or role.text == "guard"


def _without(prompt: str, name: Name) -> str:
    return f"{prompt[: name.start]}{prompt[name.end :]}".rstrip()


def first_names(prompt: str) -> Iterator[Name]:
    """The adjacent names where a prompt first names anything."""
    tokens = list(TOKEN.finditer(prompt))
    at, started = 0, False
    while at < len(tokens):
        counts = range(min(LONGEST, len(tokens) - at), 0, -1)
        name = next(filter(None, (_named(tokens[at : at + k]) for k in counts)), None)
        if name is None and started:
            return
        if name:
            started = True
            yield name
        at += len(name.text.split()) if name else 1


def _named(tokens: list[re.Match[str]]) -> Name | None:
    text = " ".join(token[0] for token in tokens).lower()
    entry = look_up(text, SLOTS)
    plain = text in FILLER or text in IGNORED_ADJECTIVES or len(text) < _LEAST
    if entry is None and len(tokens) == 1 and not plain and text not in ROLES:
        text = corrected(text) or text  # "a skelton pirate"
        entry = look_up(text, SLOTS)
    noun = entry.word if entry and entry.slot == "noun" else ""
    named = noun or text in ROLES
    return Name(text, noun, tokens[0].start(), tokens[-1].end()) if named else None
