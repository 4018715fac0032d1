"""What people write before what they ask for: "can you make a chair", "I'm making a game and need
a potion", "it's for a diorama, a small bridge".

Standard library only.
"""

import re

_NEXT = r"(?=(?:an?|the|some|one|two|three|my|me an?)\s)"
_WANT = r"(?:need|want|would like|would love|am looking for|are looking for|looking for)"
_MAKE = r"(?:make|do|create|generate|build|design|draw|model|sculpt|get|have|see|try)"
_WHO = r"(?:i|we)"
_OPENERS = (
    # "Hi, could you please make me a"
    rf"(?:can|could|would|will|may) (?:you|u|ya|{_WHO}) (?:please |pls |just |maybe )*{_MAKE}"
    rf"(?: me| us)? (?:please )?{_NEXT}",
    # "I'd like to have a", "I'm looking for a", "let's try a"
    r"(?:(?:i|we)[’']?(?:d| would)|let[’']?s) (?:really |just )*"
    rf"(?:(?:like|love|want|need)(?: to)?(?: {_MAKE})?|{_MAKE}) {_NEXT}",
    r"(?:(?:i|we)(?:[’']?m|[’']?re| am| are) )?(?:looking for|trying to (?:make|get|create)) "
    rf"{_NEXT}",
    # "I'm doing a kitchen render and need a"
    rf"(?:i|we)(?:[’']?m|[’']?re| am| are) \w+ing\b[^;.]*?(?:,|\band\b|\bso\b)\s+(?:{_WHO} )?"
    rf"{_WANT} {_NEXT}",
    # "It's for a diorama, a"
    rf"(?:it[’']?s|it is|this is|its) for [^,;.]+[,;.]\s*(?:{_WHO} {_WANT} )?{_NEXT}",
)
_GREETING = r"(?:(?:hi|hey|hello|ok|okay|so|please|pls)\b[,!.]?\s+)*"
_ASKED = re.compile(rf"\s*{_GREETING}(?:{'|'.join(_OPENERS)})", re.IGNORECASE)


def asked_for(prompt: str) -> str:
    """The prompt from where it names what is wanted; "can" is a verb there, and no thing."""
    match = _ASKED.match(prompt)
    return prompt[match.end() :] if match else prompt
