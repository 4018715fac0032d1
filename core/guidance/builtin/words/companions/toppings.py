"""Toppings and contents: "a mug of hot chocolate topped with whipped cream", "with marshmallows".

Standard library only.
"""

import re
from collections.abc import Collection
from dataclasses import replace

from core.guidance.builtin.words.companions.known_as import BROOM
from core.guidance.builtin.words.grammar.accents import Accent
from core.guidance.builtin.words.grammar.lexicon import LEXICON
from core.guidance.builtin.words.grammar.part_names import looks_of
from core.guidance.builtin.words.phrases.slots import Words

_SOME = r"(?:(?:an?|some|the|lots of|plenty of|loads of|extra|thick|fluffy|fresh) )*"
_AMOUNT = r"(?:(?:dollop|swirl|mound|pile|blob|layer|spoonful|bit)s? of )?"
_WHIPPED = r"(?:whipped|whipping|clotted|piped) cream"
_ON_TOP = r"(?:,? on (?:the )?top(?: of (?:it|them))?)?"
_TOPPED = r"(?:topped|crowned|finished|covered|garnished|decorated) (?:off )?(?:with|by)"
_WITH = rf"(?:{_TOPPED}|with|and|under)"
_HOT = r"(?:hot |warm |creamy |dark |rich )*(?:chocolate|cocoa)"
_COFFEE = r"(?:black |hot |fresh )*(?:coffee|cappuccino|latte|espresso|mocha|americano|macchiato)"
_HEATED = r"(?:(?:steaming|hot|warm|nice) )*"
CLOUD = "cloud"  # whipped cream is made as one, which a cherry may be on
CREAM = "topped with a whipped cream"
_PATTERNS = {
    rf"{_WITH} {_SOME}{_AMOUNT}{_WHIPPED}{_ON_TOP}": CREAM,
    rf"{_TOPPED} {_SOME}{_AMOUNT}cream{_ON_TOP}": CREAM,
    rf"{_WITH} {_SOME}(?:(?:white|mini|tiny|little|small) )*marshmallows{_ON_TOP}": (
        "full of white marshmallows"
    ),
    rf"{_WITH} {_SOME}(?:(?:mini|tiny|little|small) )*(?P<color>pink|coloured|colored) "
    rf"marshmallows{_ON_TOP}": r"full of \g<color> marshmallows",
    rf"{_HEATED}(?:tea ?)?cup of {_HOT}": "hot chocolate",
    rf"{_HEATED}(?:tea ?)?(?P<cup>cups?) of {_COFFEE}": r"\g<cup> of coffee",
    # "A tube of red lipstick"
    r"(?:tube|stick) of (?P<look>(?:[\w-]+ ){0,3}?)(?P<what>lipstick|lip balm|lip gloss|mascara)": (
        r"\g<look>\g<what>"
    ),
}
PATTERNS = {re.compile(rf"\b{one}\b", re.IGNORECASE): put for one, put in _PATTERNS.items()}
# What is under a topping is not visible.
UNDER = re.compile(
    rf"(?P<mug>\b(?:mug|goblet|bowl|glass)s?) of (?:{_HOT}|{_COFFEE}) (?=full of|topped with a wh)",
    re.IGNORECASE,
)
# The colour of the part that is a liquid, by the thing's name as it is written.
LIQUIDS = {
    "teacup": {
        "tea": {"cup of coffee": "coffee brown", "espresso cup": "coffee brown"}
        | {"hot chocolate": "chocolate brown"}
    }
}
# A part that something else on top is there in place of.
REPLACED = {"cupcake": "cherry", "sundae": "cherry"}
WITH_CREAM = ("cupcake", "sundae")  # of its own: whipped cream on it is that


def in_toppings(prompt: str) -> str:
    """The prompt with toppings as things that are on the first one or in it."""
    for pattern, put in PATTERNS.items():
        prompt = pattern.sub(put, prompt)
    return UNDER.sub(r"\g<mug> ", prompt)


def with_its_liquid(words: Words, names: Collection[str]) -> Words:
    """The thing with the colour of the liquid in it, by its ``names`` as they are written."""
    for part, colors in LIQUIDS.get(words.noun, {}).items():
        if words.target == part or part in {accent.part for accent in words.accents}:
            continue
        for name in names:
            if color := LEXICON.get(colors.get(name, "")):
                accent = Accent(part, color[1], colors[name])
                return replace(words, accents=(*words.accents, accent))
    return words


def without_replaced(words: Words) -> Words:
    """The thing without the cherry in whose place something else is: a strawberry on a cupcake.

    Nor with more cream than its own, nor a witch with a second broom while she rides one."""
    if words.noun in WITH_CREAM:
        others = tuple(one for one in words.companions if one.words.noun != CLOUD)
        words = replace(words, companions=others)
    rides = any(one.relation == "on" and one.words.noun == BROOM for one in words.companions)
    if rides and BROOM in looks_of(words.noun) and BROOM not in words.absent:
        return replace(words, absent=(*words.absent, BROOM))
    part = REPLACED.get(words.noun)
    borne = any(
        one.relation == "bears" and one.words.noun not in (CLOUD, part) for one in words.companions
    )
    if part is None or not borne or part in words.absent:
        return words
    return replace(words, absent=(*words.absent, part))
