"""Openers: words after which a prompt is about another thing than the first.

Standard library only.
"""

import re
from typing import Literal, NamedTuple

from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up
from core.guidance.builtin.words.grammar.tokens import DOING, LONGEST

# The relation of the first thing to the other: it is on it or in it, wears it or holds it, bears it
# on top of itself, or is next to it; the other hangs or grows on it, is behind it or at its front;
# the first is coiled around the other; the others are all around the first.
Relation = Literal[
    "on",
    "in",
    "wears",
    "holds",
    "bears",
    "beside",
    "hanging",
    "growing",
    "behind",
    "front",
    "around",
    "surrounding",
    "below",
    "fills",
]
TOKEN = re.compile(r"[^\W_]+(?:['’-][^\W_]+)*|[,;:.!?()]")


class Opener(NamedTuple):
    """The words for the relation to another thing, and their place in the prompt."""

    relation: Relation
    start: int
    end: int
    verb: str = ""
    weak: bool = False  # "with" and "in" also start phrases without another thing


_BEING = r"(?:(?:who|that|which) )?(?:(?:is|are|was|were) )?"
_HOW = (
    "(?:up|down|upright|still|together|upside down|comfortably|back|around|peacefully|proudly|"
    "quietly|[a-z]{3,}ly)"
)
_POSTURE = (
    r"(?:[a-z]{3,}ing|sits|stands|lies|sleeps|rests|perched|seated|laid|placed|mounted|balanced|"
    r"curled|parked|set|propped|planted|potted|settled|nestled|tucked|hidden|stuffed|asleep|served|"
    r"poised|stranded|dozing|stuck|embedded|lodged|stabbed|plunged|driven|thrust|buried|trapped|sealed|preserved|suspended|captured|imprisoned|enclosed|encased|"
    r"floating)"
)
_DOING = (
    rf"(?:(?:[a-z]{{3,}}ly )?(?:(?P<first>{_POSTURE})(?: {_HOW})* )?"
    rf"(?P<doing>{_POSTURE})(?: {_HOW})* )?"
)
# "On its side" is its own position, "on it" and "on top" are things on it.
_NOT_IT = (
    r"(?!(?:it|them|itself|top|each|both|one side|all|fire|wheels|display|sale)\b|(?:the|its|his|"
    r"her|their|each|one) (?:\w+ )?(?:sides?|front|back|top|bottom|lid|inside|outside|ends?|"
    r"corners?|face|chest|neck|antlers|hind legs|left|right|cover|label|rim|head|handle|body|"
    r"surface|edges?)\b)"
)
_HOLDING = (
    "holding|holds|carrying|carries|wielding|wields|clutching|clutches|gripping|grasping|grabbing|"
    "brandishing|waving(?! (?:at|from|to|goodbye|hello|with|in|on) )|hugging|lifting|raising|"
    "swinging|presenting|offering|armed with|hold"
)
# "A doctor, black coat, holding a lantern".
_GARMENT = (
    r"(?=(?:[\w-]+ ){0,3}(?:hat|cap|hood|helmet|crown|coat|jacket|raincoat|hoodie|sweater|shirt|"
    r"dress|cape|cloak|scarf|armou?r|boots|shoes|sneakers|backpack|glasses|sunglasses|goggles|mask)"
    r"(?![\w-]))"
)
# What somebody does to another thing, which is then next to it.
_TOWARDS = (
    "(?:looking|staring|barking|smiling|pointing|roaring|laughing|shouting) at|"
    "(?:talking|speaking|singing|bowing|waving) to|dancing with|fighting (?:with|against)|"
    "playing (?:with|against)|working (?:at|on)|leaning (?:on|against)"
)
_COILED = (
    "curled|coiled|wrapped|twisted|twined|entwined|wound|curling|coiling|wrapping|twisting|winding|"
    "slithering"
)
_TO_ANOTHER = (
    r"(?!(?:being|resembling|becoming|including|featuring|depicting|missing|lacking|having|showing|"
    r"representing|looking|using|wearing|following)\b)[a-z]{3,}ing "
    r"(?=(?:an?|the|his|her|their|another|two|three|some) )"
)
UNDER_GLASS = (
    r"(?:under|underneath|beneath|below) (?=(?:an? |the |its )?(?:[\w-]+ ){0,3}"
    r"(?:dome|cloche|bell jar)(?![\w-]))"
)
_DRIVING = ("rowing", "paddling", "piloting", "steering")
_RELATIONS: tuple[tuple[Relation, str, bool], ...] = (
    (
        "on",
        rf"{_BEING}(?P<verb>riding|rides?|driving|drives?|{'|'.join(_DRIVING)})(?: around)?"
        r"(?: (?:on top of|on|in|atop))? ",
        False,
    ),
    (
        "on",
        rf"{_BEING}(?P<verb>jumping|jumps|leaping|leaps|bounding|vaulting|hopping) over ",
        False,
    ),
    (
        "on",
        rf"{_BEING}{_DOING}(?:right )?(?:on top of|ontop of|on|upon|atop of|atop|onto) {_NOT_IT}",
        False,
    ),
    ("wears", rf"{_BEING}(?:wearing|wears|donning|sporting|dressed in|wear) ", False),
    (
        "holds",
        rf"{_BEING}(?P<verb>{_HOLDING}|using|uses|playing(?: on| with)?|plays?|eating|eats?|"
        r"biting|licking|munching(?: on)?|nibbling(?: on)?|drinking(?: from)?|"
        r"sipping(?: from)?|reading|reads) ",
        False,
    ),
    (
        "around",
        rf"{_BEING}(?P<verb>{_COILED})(?: (?:up|tightly|itself))* (?:around|round|about) ",
        False,
    ),
    ("beside", rf"{_BEING}(?P<verb>{_TOWARDS}) ", False),
    ("beside", rf"{_BEING}(?P<verb>{_TO_ANOTHER})", False),
    ("in", rf"{_BEING}{_DOING}(?:inside of|inside|into|within|in) {_NOT_IT}", True),
    ("in", rf"{_BEING}{_DOING}{UNDER_GLASS}", True),
    ("wears", r"with ", True),
    ("wears", rf"(?<=,) (?:and )?{_GARMENT}", True),
)
_OPENERS = [
    (relation, re.compile(rf"(?<![\w-]){text}(?=[\w'\"])", re.IGNORECASE), weak)
    for relation, text, weak in _RELATIONS
]


def named_in(text: str) -> str:
    """The thing that a text names first, as far as a look at its words shows."""
    words = [match[0] for match in TOKEN.finditer(text)]
    return name_in(words)[0]


def name_in(words: list[str]) -> tuple[str, int]:
    """The first thing that the words name, and the index behind its name; "" and -1 without one."""
    noun, end = "", -1
    at = 0
    while at < len(words):
        step = 0
        for count in range(LONGEST, 0, -1):
            phrase = " ".join(words[at : at + count]).lower().replace("-", " ")
            entry = look_up(phrase.replace("'s", ""), SLOTS)
            if entry is not None and entry.slot == "noun" and at + count <= len(words):
                noun, step = entry.word, count
                break
        if not step and noun:
            break
        at += step or 1
        end = at if step else end
    return noun, end


def is_doing(word: str) -> bool:
    """Whether it is an activity: "jumping", but not "glowing"."""
    return DOING.fullmatch(word) is not None and look_up(word, SLOTS) is None


def ends_in_doing(text: str) -> bool:
    """Whether it ends in an activity of the thing: "reading news" on a phone."""
    words = re.split(r"[,;.!?]", text)[-1].split()
    return any(map(is_doing, words[max(name_in(words)[1], 0) :]))


def ends_in_name(text: str, noun: str) -> bool:
    """Whether a text ends with the noun's name, or with its material: a "sword made of ice", but
    not a "star pattern"."""
    words = [match[0].lower() for match in TOKEN.finditer(text)]
    name, end = name_in(words)
    return name == noun and (end == len(words) or words[end] in ("of", "made"))


def openers_in(prompt: str) -> list[Opener]:
    """All possible openers in order."""
    found: dict[int, Opener] = {}
    for relation, rule, weak in _OPENERS:
        for match in rule.finditer(prompt):
            stated, start = match.groupdict(), match.start()
            for doing in ("first", "doing"):  # "a painting on an easel", "glowing"
                if stated.get(doing) and look_up(stated[doing].lower(), SLOTS):
                    start = match.end(doing) + 1
            verb = (stated.get("verb") or stated.get("doing") or "").split(" ")[0].lower()
            one = Opener(relation, start, match.end(), verb, weak)
            one = one._replace(verb="driving") if verb in _DRIVING else one
            # "Riding on" is more than "on".
            if not any(start < other.end and other.start < one.end for other in found.values()):
                found[start] = one
    return sorted(found.values(), key=lambda one: one.start)
