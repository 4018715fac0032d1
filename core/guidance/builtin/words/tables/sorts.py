"""Sorts of a thing in words, and their kinds in the solids' network.

A sort was seen in what the weights draw, so it belongs to them: ``core/tests/words/test_sorts.py``
measures each against the thing's others. Standard library only.
"""

import re
from typing import NamedTuple

# Words for a thing's place, or for a thing next to it.
BESIDE = r"\b(?:next to|beside|near|on|by|under|behind|in front of|against|for)\b"
OF_WHOLE = "round circular square rectangular oblong oval flat artist".split()


class Sort(NamedTuple):
    """A sort of the thing in a prompt."""

    stated: tuple[str, ...] = ()  # its words
    kinds: tuple[int, ...] = ()  # kinds of the noun in the network; (): any
    size_m: float = 0.0  # its usual size; 0: the thing's

    def __bool__(self) -> bool:
        return bool(self.kinds)


def sort_of(noun: str, prompt: str) -> Sort:
    """The first of the noun's sorts that a word of the prompt names, unless it is negated, belongs
    to another thing or, for a form, to a part."""
    text = re.sub(r"[\W_]+", " ", prompt.lower())
    own = re.split(BESIDE, text)[0]
    whole = re.split(r"\b(?:with|whose|that has)\b", own)[0]
    for words, kinds in SORTS.get(noun, {}).items():
        named = [one for one in words.split(", ") if says(whole if one in OF_WHOLE else own, one)]
        if named:
            return Sort(tuple(named), kinds, SIZES_M.get((noun, kinds), 0.0))
    return Sort()


def says(text: str, word: str) -> bool:
    """Whether a text of words and spaces has the word, and does not deny it."""
    denied = r"\b(?:without|no|not|non|neither|nor|t)(?: an?| any| very)?(?: \w+)? $"
    found = re.finditer(rf"\b{word}s?\b", text)
    return any(not re.search(denied, text[: one.start()]) for one in found)


# By thing: words that name a sort, and its kinds. The first sort that a word of the prompt names is
# drawn, so that the more specific one comes first.
SORTS: dict[str, dict[str, tuple[int, ...]]] = {
    "hat": {
        "top hat, stovepipe, magician": (0, 1),
        "bowler, derby, round": (2, 3),
    },
    "television": {
        "flat screen, flatscreen, flat, smart, modern, led, lcd, oled, widescreen, plasma": (0, 1),
        "retro, vintage, crt, tube, antenna, old fashioned, 1950s, 1960s, 1970s, 1980s, 50s, 60s, "
        "70s, 80s": (2, 3),
    },
    "shield": {
        "round, viking, circular": (0, 3),
        "heater, knight, crusader, heraldic, kite, coat of arms, medieval": (1, 2),
    },
    "mirror": {
        "oval, round, cheval": (2, 3),
        "rectangular, square": (0, 1),
    },
    "refrigerator": {
        "french door, side by side, double door": (2, 3),
        "retro, vintage, freezer": (0, 1),
    },
    "cake": {"wedding, tiered, tier, two tier, three tier, layered": (0, 1)},
    "pizza": {
        "slice of, pizza slice, piece of, wedge": (0,),
        "whole, round": (2,),
    },
    "window": {"shutter": (0, 2)},
    "floor lamp": {"tripod, three legged": (1, 3)},
    "coffee table": {
        "round, circular": (0, 2, 3),
        "rectangular, square, oblong": (1,),
    },
    "ottoman": {
        "round, circular": (1, 3),
        "rectangular, square": (0, 2),
    },
    "sunglasses": {
        "round, circular, john lennon, hippie": (1,),
        "square, rectangular": (0, 2, 3),
    },
    "clock": {
        "bell, twin bell": (1, 3),
        "wall, kitchen, station": (0, 2),
    },
    "street lamp": {
        "double, twin": (2,),
        "victorian, gas, vintage, antique, old fashioned, lantern": (1,),
        "modern": (0,),
    },
    "pillow": {"tassel": (1, 2)},
    "screwdriver": {
        "flathead, flat head, slotted": (0, 1),
        "phillips, crosshead, cross head, cross": (2, 3),
    },
    "club": {
        "spiked, spike, studded, nail": (0, 1),
        "caveman, smooth, plain": (2, 3),
    },
    "paintbrush": {
        "artist, round, watercolor, watercolour": (2, 3),
        "flat, wide, decorator": (0, 1),
    },
}
# Usual sizes of what is larger or smaller than the thing's other sorts, metres.
SIZES_M = {("television", (2, 3)): 0.6, ("pizza", (0,)): 0.2}
