"""Passive phrases as active ones: "a tractor driven by a pig". Standard library only."""

import re

from core.guidance.builtin.words.companion_openers import named_in, openers_in
from core.guidance.builtin.words.companion_words import is_dressed

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
