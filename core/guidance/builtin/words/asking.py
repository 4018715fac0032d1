"""Introductions before the request: "can you make a chair", "my daughter wants a robot",
"I'm making a game and need a potion", "it's for a diorama, a small bridge".

Standard library only.
"""

import re

from core.guidance.builtin.words.companions.roles import first_names
from core.guidance.builtin.words.grammar.tokens import PERSON

_ARTICLE = r"(?=(?:an?|some|one|two|three)\s)"
_NEXT = r"(?=(?:an?|the|some|one|two|three|my|me an?)\s)"
_WANT = r"(?:need|want|would like|would love|am looking for|are looking for|looking for)"
_MAKE = r"(?:make|do|create|generate|build|design|draw|model|sculpt|get|have|see|try)"
_WHO = r"(?:i|we)"
_OPENERS = (
    # "Hi, could you please make me a"
    rf"(?:can|could|would|will|may) (?:you|u|ya|{_WHO}) (?:please |pls |just |maybe )*{_MAKE} "
    r"(?:(?:me|us|it|please) )*",
    # "I'd like to have a", "I'm looking for a", "let's try a"
    r"(?:(?:i|we)[’']?(?:d| would)|let[’']?s) (?:really |just )*"
    rf"(?:(?:like|love|want|need)(?: to)?(?: {_MAKE})?|{_MAKE}) {_NEXT}",
    r"(?:(?:i|we)(?:[’']?m|[’']?re| am| are) )?(?:looking for|trying to (?:make|get|create)) "
    rf"{_NEXT}",
)
# For whom or what it is, and then what it is; neither is followed by a text.
_PURPOSES = (
    r"(?:(?:my|our|the|his|her) )?(?:\w+ ){1,2}?(?:really )?"
    r"(?:wants?|needs?|ask(?:s|ed) for|would (?:like|love))(?: to have)? (?=(?:an?|the|some|one) )",
    # "I'm doing a kitchen render and need a"
    rf"(?:i|we)(?:[’']?m|[’']?re| am| are) \w+ing\b[^;.\"“”]*?(?:,|\band\b|\bso\b)\s+"
    rf"(?:{_WHO} )?{_WANT} {_ARTICLE}",
    # "It's for a diorama, a"
    rf"(?:it[’']?s|it is|this is|its) for [^,;.\"“”]+[,;.]\s*(?:{_WHO} {_WANT} )?{_ARTICLE}",
)
_GREETING = r"\s*(?:(?:hi|hey|hello|there|ok|okay|so|please|pls)\b[,!.]?\s+)*"
_ASKED = re.compile(rf"{_GREETING}(?:{'|'.join(_OPENERS)})", re.IGNORECASE)
_ASKING = frozenset(("", PERSON, "boy", "girl", "baby"))  # "my kids want a robot"
_PURPOSE = re.compile(rf"{_GREETING}(?:{'|'.join(_PURPOSES)})", re.IGNORECASE)


def asked_for(prompt: str) -> str:
    """The prompt from the first name of the requested thing; "can" is a verb there, not a thing."""
    if match := _ASKED.match(prompt):
        return prompt[match.end() :]
    match = _PURPOSE.match(prompt)
    # "A robot needs a hug", "I'm making a chair and want a cushion on it" are about the first.
    if match and _ASKING.issuperset(name.noun for name in first_names(match[0])):
        return prompt[match.end() :]
    return prompt
