"""Sizes that a prompt states: "2 m tall", "a 30 cm ruler", "6'2\\"", "120 x 60 x 75 cm".

Standard library only.
"""

import re
import unicodedata
from collections.abc import Iterable
from typing import NamedTuple

from core.io.job import SIZES

METRES = {  # of a unit, by its names
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 0.001),
    **dict.fromkeys(("cm", "cms", "centimeter", "centimeters", "centimetre", "centimetres"), 0.01),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1.0),
    **dict.fromkeys(("in", "inch", "inches", '"'), 0.0254),
    **dict.fromkeys(("ft", "foot", "feet", "'"), 0.3048),
    **dict.fromkeys(("yd", "yard", "yards"), 0.9144),
}
SIDES = {  # of the box around a thing, by the words for them
    "height": ("tall", "high", "height"),
    "width": ("wide", "broad", "width"),
    "depth": ("deep", "depth"),
    "diameter": ("across", "diameter"),
    "length": ("long", "length", "size"),
}
THICK = ("thick", "thickness")  # of a wall or a board, not of the whole thing
# Such a number is a size only where a side is named: "a 9mm pistol".
CALIBRE = "mm"
# Marks for inches and feet, as they may be typed.
MARKS = {"\u2033": '"', "\u201d": '"', "\u2032": "'", "\u2019": "'", "''": '"'}
UNSURE = ("in", "feet")  # no unit at all: "2 in 1", "a sofa with 4 feet"
# Units of what is no length, such as a weight or an age.
OTHERS = """kg kgs kilo kilos kilogram kilograms g gram grams lb lbs pound pounds ounce ounces oz ml
    l liter liters litre litres gallon gallons watt watts volt volts mph kmh hp cc year years
    year-old years-old month-old week-old weeks months""".split()
COUNTS = {"half a": 0.5, "a": 1, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6}
COUNTS |= {"seven": 7, "eight": 8, "nine": 9, "ten": 10, "twelve": 12, "twenty": 20}


class Size(NamedTuple):
    """How long a prompt says that a side of the box around the thing is, in metres.

    side: one of ``SIDES``; the length is the longest side.
    """

    metres: float
    side: str = "length"

    def longest(self, extents: Iterable[float]) -> float:
        """The longest side in metres of a thing whose box is to the ``extents`` x, y and z."""
        x, y, z = extents
        longest = max(x, y, z)
        own = {"height": z, "width": x, "depth": y, "diameter": max(x, y), "length": longest}
        return self.metres * longest / max(own[self.side], 1e-9)


def _any_of(words: Iterable[str]) -> str:
    return "|".join(re.escape(word) for word in sorted(words, key=len, reverse=True))


_NUMBER = r"[0-9]+(?:[.,][0-9]+)?"
_UNIT = rf"(?:{_any_of(METRES)})(?![a-z0-9])"
_FEET, _INCHES = (_any_of(k for k in METRES if METRES[k] == METRES[of]) for of in ("ft", "in"))
_SIDES = {word: side for side, words in SIDES.items() for word in words}
_STATED = re.compile(
    rf"""
    (?: (?: \bwith\s+an?\s+ )? \b(?P<before> height|width|depth|diameter|length|size|thickness )
        (?: \s+of | \s*[:=] )? \s+ )?
    (?: \b(?:about|around|approximately|approx\.?|roughly|nearly|almost|exactly|over)\s+ | ~\s* )?
    (?: (?<![\w.,]) (?P<box> {_NUMBER} (?: \s*(?:{_UNIT})? \s*[x\u00d7]\s* {_NUMBER} )+ )
            [\s-]* (?P<box_unit> {_UNIT} )
      | (?<![\w.,]) (?P<feet> {_NUMBER} ) [\s-]* (?:{_FEET}) [\s-]* (?P<inches> [0-9]{{1,2}} )
            (?! [\w.,]*[0-9] ) [\s-]* (?: (?:{_INCHES})(?![a-z]) )?
      | (?<![\w.,]) (?P<number> {_NUMBER} ) [\s-]* (?P<unit> {_UNIT} )
      | \b(?P<count> {_any_of(COUNTS)} ) [\s-]+ (?P<counted> {_UNIT} )
            (?= [\s-]+ (?: {_any_of(_SIDES)} )\b )
    )
    (?: [\s-]* (?: \bin\s+ )? (?P<after> {_any_of([*_SIDES, *THICK])} )\b )?
    """,
    re.VERBOSE,
)
_OF_PART = re.compile(r"\b(?:with|has|have|and)\s+(?:an?\s+|its\s+|the\s+|two\s+|four\s+)?$")
_OTHER = re.compile(rf"(?<![\w.,]){_NUMBER}[\s-]*(?:{_any_of(OTHERS)})(?![a-z0-9])(?:[\s-]+old\b)?")


def set_apart(prompt: str) -> tuple[str, list[Size], list[str]]:
    """A prompt in lower case without what measures something in it; the sizes that it states; and
    what measures something else, such as a weight or a thickness, as it was written."""
    for mark, plain in MARKS.items():
        prompt = prompt.replace(mark, plain)
    text = unicodedata.normalize("NFKC", prompt).lower()
    sizes: list[Size] = []
    others: list[str] = []

    def taken(found: re.Match[str]) -> str:
        side = found["after"] or found["before"] or ""
        if not side and found["unit"] in UNSURE:
            return found[0]
        size = Size(round(_metres(found), 6), _SIDES.get(side, "length"))
        of_part = not found["before"] and _OF_PART.search(text, 0, found.start())
        is_other = side in THICK or of_part or (not side and found["unit"] == CALIBRE)
        if is_other or not SIZES[0] <= size.metres <= SIZES[1]:
            others.append(found[0].strip())
        else:
            sizes.append(size)
        return " "

    def other(found: re.Match[str]) -> str:
        others.append(found[0].strip())
        return " "

    text = _OTHER.sub(other, text)
    return _STATED.sub(taken, text), sizes, others


def _metres(found: re.Match[str]) -> float:
    if found["box"]:
        numbers = re.findall(_NUMBER, found["box"])
        return max(map(_number, numbers)) * METRES[found["box_unit"]]
    if found["feet"]:
        return _number(found["feet"]) * METRES["ft"] + int(found["inches"]) * METRES["in"]
    if found["count"]:
        return COUNTS[found["count"]] * METRES[found["counted"]]
    return _number(found["number"]) * METRES[found["unit"]]


def _number(text: str) -> float:
    return float(text.replace(",", "."))
