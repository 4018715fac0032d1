"""Passive phrases as active ones, "a tractor driven by a pig"; sentences without their verb, "a
sandwich sits next to a flask". Standard library only."""

import re

from core.guidance.builtin.words.companions.known_as import is_dressed
from core.guidance.builtin.words.grammar.openers import named_in, openers_in
from core.guidance.builtin.words.tables.living import is_creature

_ACTIVE = {
    "driven": "driving",
    "piloted": "driving",
    "steered": "driving",
    "ridden": "riding",
    "worn": "wearing",
    "held": "holding",
    "carried": "holding",
    "wielded": "holding",
    "played": "playing",
    "eaten": "eating",
    "read": "reading",
}
_GUARDED = "guarded|watched|protected"
_PASSIVE = re.compile(
    r"(?P<thing>[^,;:.!?]+?) (?:(?:(?:that|which) )?(?:is|are) )?(?:being )?"
    rf"(?P<done>{'|'.join(_ACTIVE)}|{_GUARDED}) by "
    r"(?P<who>(?:an?|the|some|two|three|four) [^,;:.!?]+)",
    re.IGNORECASE,
)
_WHERE = (
    r"(?:next to|beside|in front of|(?:on|in|at|by|near|above|under|against|among|atop|upon|inside|"
    r"from|between|behind|over) (?:an?|the|its|his|her|two)) "
)
_STANDS = re.compile(
    r"\s*(?P<thing>(?:an?|the|one|my) [^,;:.!?]+?) "
    r"(?P<verb>sits|stands|lies|rests|leans|hangs|floats) "
    rf"(?=(?:[a-z]+ly |poised |alone )?{_WHERE})",
    re.IGNORECASE,
)


def as_phrase(prompt: str) -> str:
    """The sentence as a phrase: "a lamp stands on a table" is one standing there."""
    match = _STANDS.match(prompt)
    noun = named_in(match["thing"]) if match else ""
    if not match or not noun or is_creature(noun):  # of these it is a pose
        return prompt
    verb = {"lies": "lying", "sits": "sitting"}.get(match["verb"].lower())
    doing = verb or f"{match['verb'].lower().removesuffix('s')}ing"
    return f"{match['thing']} {doing} {prompt[match.end() :]}"


def made_active(prompt: str) -> str:
    """The prompt with the agent first, where it starts so; a guarded thing is next to it."""
    match = _PASSIVE.match(prompt)
    if match is None:
        return prompt
    thing, who = match["thing"].strip(), match["who"].strip()
    if openers_in(thing) or not is_dressed(named_in(who)):  # "worn by the sea"
        return prompt
    doing = _ACTIVE.get(match["done"].lower())
    text = f"{who} {doing} {thing}" if doing else f"{thing} next to {who}"
    return text + prompt[match.end() :]
