"""Substances that are materials only where a prompt says so: "made of snow", but "in the snow".

Standard library only.
"""

import re

from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up
from core.guidance.builtin.words.grammar.tokens import DOING
from core.guidance.builtin.words.tables.words import PHRASE_ENDS

# What people call each, with the words that add nothing to it.
_CALLED = {
    "lava": "(?:(?:glowing|hot|molten|flowing) )*(?:lava rock|molten rock|lava|magma)",
    "snow": "(?:(?:white|packed|fresh|pure) )*snow",
    "sand": "(?:(?:wet|beach|golden) )*sand",
    "jelly": "(?:(?:wobbly|translucent) )*"
    "(?:gummy candy|gummy|gummies|jelly|jell-?o|gelatine?)(?! beans?)",
    "candy": "(?:hard |boiled |sugar )*(?:candy|candies|sweets)",
    "moss": "(?:(?:green|living|lush|soft) )*moss",
}
_MADE = "made|built|carved|sculpted|formed|moulded|molded|shaped|crafted|constructed"
# "Made entirely out of": then perhaps the word for a colour.
_SAID = re.compile(
    rf"\b(?:{_MADE}) (?:\w+ly )?(?:up )?(?:out of|of|from) "
    rf"(?P<color>[a-z]+ )??(?:{'|'.join(f'(?P<{one}>{said})' for one, said in _CALLED.items())})"
    r"(?!-)\b(?P<behind> [\w'-]+)?",
    re.IGNORECASE,
)


def as_made_of(prompt: str) -> str:
    """The prompt with one way of naming such a substance: "sculpted out of wet sand" is "made of
    sand"; what only starts so, "made of candy canes", is not."""
    return _SAID.sub(_named, prompt)


def _named(said: re.Match[str]) -> str:
    name = next(one for one in _CALLED if said[one])
    behind = (said["behind"] or "").strip().lower()
    if behind and behind not in PHRASE_ENDS and not DOING.fullmatch(behind):
        whole = look_up(f"{name} {behind}", SLOTS)
        is_thing = whole is not None and whole.slot == "noun"
        return said[0].replace(" of ", " from ", 1) if is_thing else said[0]
    color = f"in {said['color'].strip()} " if said["color"] else ""
    return f"{color}made of {name}{said['behind'] or ''}"
