"""What fills a vessel and has no form of its own: "a mug of beer", "a wheelbarrow full of soil".

Standard library only.
"""

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from core.guidance.builtin.words.grammar.lexicon import LEXICON, singulars

# Open vessels without a filling of their own; what else fills one is a part of it.
OPEN = frozenset(
    "mug, bowl, bucket, goblet, sink, wheelbarrow, pan, basket, cardboard box, trash can".split(
        ", "
    )
)
# By the content's look as a solid of its own, in words; the rest of a row are its names.
_LIQUIDS = {
    "azure": "water, rain water, rainwater, seawater, mineral water",
    "ivory": "milk, cream, yogurt, yoghurt, coconut milk",
    "amber": "beer, ale, lager, cider, mead, whiskey, whisky, rum, honey, broth, syrup",
    "burgundy": "wine, red wine, grape juice, punch, mulled wine",
    "dark red": "blood, fake blood",
    "rust orange": "soup, stew, curry, chili, vegetable soup, pumpkin soup, carrot soup",
    "red": "tomato soup, ketchup, tomato sauce, tomato juice, salsa",
    "coffee brown": "coffee, black coffee, espresso, latte, cappuccino",
    "rust brown": "tea, black tea",
    "chocolate brown": "hot chocolate, cocoa, melted chocolate, chocolate",
    "orange": "orange juice, juice, lemonade, cheese sauce",
    "charcoal": "oil, crude oil, tar, ink",
    "lime": "slime, goo, acid, ooze, toxic waste",
    "white": "paint",
    "purple": "potion, magic potion, poison",
}
_HEAPS = {
    "umber": "soil, dirt, earth, compost, mud, mulch, manure, potting soil",
    "sand": "sand",
    "snow": "snow, ice cubes, crushed ice",
    "ivory": "rice, white rice, flour, sugar, salt, porridge, oatmeal, mashed potatoes",
    "tan": "cereal, granola, grain, wheat, oats, cornflakes, sawdust, nuts, peanuts, crisps",
    "straw": "hay, straw",
    "cream": "popcorn",
    "ash grey": "ash, ashes, gravel, cement, concrete, rubble",
    "charcoal": "coal, charcoal, gunpowder",
    "leaf green": "salad, lettuce, grass",
}
HEAPED = {name: look for look, names in _HEAPS.items() for name in names.split(", ")}
POURED = {name: look for look, names in _LIQUIDS.items() for name in names.split(", ")}
_NAMES = "|".join(sorted(map(re.escape, (*HEAPED, *POURED)), key=len, reverse=True))
_STATES = frozenset(
    """hot cold warm iced fresh steaming creamy clear murky bubbling boiling dark rich thick foamy
    frothy delicious some fluffy brown loose""".split()
)
_POURED = re.compile(
    r" (?:(?:completely |half )?(?:full|filled)(?: up)?(?: to the brim)? (?:of|with)|of|with|"
    rf"containing|holding) (?:some )?(?P<look>(?:[\w-]+ ){{0,3}}?)(?P<what>{_NAMES})"
    r"(?: in(?:side)? (?:it|them))?(?=$|[,.;!?]| (?:and|with|next|beside)\b| (?:on|in) an?\b)",
    re.IGNORECASE,
)


class Poured(NamedTuple):
    """What fills a vessel: a phrase for its look, and its place in the prompt."""

    phrase: str
    start: int
    end: int


def poured_in(prompt: str, first_of: Callable[[str], str]) -> Iterator[Poured]:
    """The fillings that the prompt's first thing may have; of a colour, where one is stated."""
    for match in _POURED.finditer(prompt):
        what = match["what"].lower()
        said = [word for word in match["look"].lower().split() if word not in _STATES]
        known = [LEXICON.get(word) for word in said]
        colored = bool(known) and all(one is not None and one[0] == "color" for one in known)
        before = prompt[: match.start()]
        named = _is_one_name(before.rpartition(" ")[2].lower(), what)
        if (said and not colored) or named or first_of(before) not in OPEN:
            continue
        look = " ".join(said) if said else POURED.get(what) or HEAPED[what]
        solid = f"glossy {look} cylinder" if what in POURED else f"matte {look} ball"
        yield Poured(f"a {solid}", match.start(), match.end())


def _is_one_name(vessel: str, what: str) -> bool:
    """Whether it is a thing by that name: "cups of coffee", "a bucket of popcorn"."""
    return any(f"{one} of {what}" in LEXICON for one in (vessel, *singulars(vessel)))
