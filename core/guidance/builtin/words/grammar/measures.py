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
# So few millimetres of these are not a size without a side: "a 9mm pistol", "a 35 mm camera".
OF_CALIBRE = frozenset(
    """pistol revolver handgun gun rifle cannon howitzer mortar camera cameras lens lenses film ammo
    bullet cartridge screw bolt nail wrench spanner socket drill projector needle syringe pipe tube
    hose rope jack""".split()
)
CALIBRE, MOST_CALIBRE = "mm", 0.21  # metres
UNSURE = ("in", "feet")  # no unit at all: "2 in 1", "a sofa with 4 feet"
MOST_FEET = 8  # feet of a thing
# Marks for inches and feet, as they may be typed.
MARKS = {"\u2033": '"', "\u201d": '"', "\u2032": "'", "\u2019": "'", "''": '"'}
# Units of other quantities, such as a weight or an age.
OTHERS = """kg kgs kilo kilos kilogram kilograms g gram grams lb lbs pound pounds ounce ounces oz ml
    l liter liters litre litres gallon gallons watt watts volt volts mph kmh hp cc year years yr yrs
    year-old years-old month month-old months week week-old weeks day day-old days""".split()
COUNTS = {"half a": 0.5, "a": 1, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6}
COUNTS |= {"seven": 7, "eight": 8, "nine": 9, "ten": 10, "twelve": 12, "fifteen": 15, "twenty": 20}
COUNTS |= {"thirty": 30, "forty": 40, "fifty": 50, "a hundred": 100, "hundred": 100}
# After these a clause is about something else: "a castle on a 10 m high hill".
OF_ANOTHER = """with on at near beside next under behind above against between over inside around
    has have having whose holding pulling carrying""".split()


class Size(NamedTuple):
    """The stated length of a side of the box around the thing, in metres.

    side: one of ``SIDES``; the length is the longest side.
    """

    metres: float
    side: str = "length"

    def longest(self, extents: Iterable[float]) -> float:
        """The longest side in metres of a thing with a box of the ``extents`` x, y and z."""
        x, y, z = extents
        longest = max(x, y, z)
        own = {"height": z, "width": x, "depth": y, "diameter": max(x, y), "length": longest}
        return self.metres * longest / max(own[self.side], 1e-9)


def _any_of(words: Iterable[str]) -> str:
    return "|".join(re.escape(word) for word in sorted(words, key=len, reverse=True))


# 1,200 or 1,5; 1 1/2; .5
_NUMBER = (
    r"(?:[0-9]{1,3}(?:,[0-9]{3})+(?:\.[0-9]+)?|(?:[0-9]+\s+)?[0-9]+/[0-9]+"
    r"|[0-9]+(?:[.,][0-9]+)?|\.[0-9]+)"
)
_UNIT = rf"(?:{_any_of(METRES)})(?![a-z0-9])\.?"
_FEET, _INCHES = (
    _any_of(k for k in METRES if METRES[k] == METRES[of] and k.isalpha()) for of in ("ft", "in")
)
_SIDES = {word: side for side, words in SIDES.items() for word in words}
_SINGULAR = "foot|metre|meter|inch|yard"
_START = r"(?<![\w.,/\"'])"
_TWO = r"[0-9]{1,2} (?![\w.,]*[0-9])"
_SEVERAL = _any_of(word for word in COUNTS if COUNTS[word] > 1)
_STATED = re.compile(
    rf"""
    (?: (?: \bwith\s+an?\s+ )? \b(?P<before> height|width|depth|diameter|length|size|thickness )
        (?: \s+of\s+ | \s*[:=]\s* | \s+ ) )?
    (?: \b(?:about|around|approximately|approx\.?|roughly|nearly|almost|exactly|over)\s+ | ~\s* )?
    (?: {_START} (?P<box> {_NUMBER}
            (?: \s* (?:{_UNIT}\s*)? (?:[x\u00d7]|by\b)\s* {_NUMBER} )+ ) [\s-]*
            (?P<box_unit> {_UNIT} )
      | {_START} (?P<feet> [0-9]+ ) \s* (?: ' \s* (?P<inches> {_TWO} ) "?
            | (?:{_FEET})\.? [\s-]* (?P<more> {_TWO} ) [\s-]*
              (?: (?:{_INCHES})(?![a-z])\.? | " ) )
      | {_START} (?P<metres> [0-9] ) m (?P<cm> [0-9]{{2}} ) (?![\w.,]*[0-9])
      | {_START} (?P<number> {_NUMBER} ) [\s-]* (?P<unit> {_UNIT} )
      | \b(?P<count> {_any_of(COUNTS)} ) [\s-]+ (?P<counted> {_UNIT} )
            (?= [\s-]+ (?: {_any_of(_SIDES)} )\b )
      | \b(?P<several> {_SEVERAL} ) [\s-]+ (?P<each> {_SINGULAR} )\b
    )
    (?: [\s-]* (?: \bin\s+ )? (?P<after> {_any_of([*_SIDES, *THICK])} )\b )?
    """,
    re.VERBOSE,
)
_ELSEWHERE = re.compile(rf"\b(?:{_any_of(OF_ANOTHER)})\b[^,;.:!?()]*$")
_OTHER = re.compile(
    rf"(?<![\w.,])(?:{_NUMBER}|{_any_of(k for k in COUNTS if ' ' not in k and k != 'a')})[\s-]*"
    rf"(?:{_any_of(OTHERS)})(?![a-z0-9])(?:[\s-]+old\b)?"
)


def set_apart(prompt: str) -> tuple[str, list[Size], list[str]]:
    """A prompt in lower case without its measurements; the stated sizes; and other measurements,
    such as a weight, a thickness or the size of another thing, as written."""
    for mark, plain in MARKS.items():
        prompt = prompt.replace(mark, plain)
    text = unicodedata.normalize("NFKC", prompt).lower()
    sizes: list[Size] = []
    others: list[str] = []

    def taken(found: re.Match[str]) -> str:
        side = found["after"] or found["before"] or ""
        unit = (found["unit"] or "").rstrip(".")
        if not side and unit in UNSURE and not _is_sure(unit, found["number"]):
            return found[0]
        if unit == '"' and text.count('"', 0, found.start()) % 2:  # the end of a quotation
            return found[0]
        size = Size(round(_metres(found), 6), _SIDES.get(side, "length"))
        elsewhere = _ELSEWHERE.search(text, 0, found.start())
        # But "with a 30 cm height".
        of_another = elsewhere and not (found["before"] or side in SIDES)
        calibre = not side and unit == CALIBRE and size.metres <= MOST_CALIBRE
        # Of the word next to it: "a 35 mm film camera", "pistol, 9mm".
        beside = re.findall("[a-z]+", text[: found.start()])[-1:]
        beside += re.findall("[a-z]+", re.split("[,;.:!?()]", text[found.end() :])[0])[:3]
        is_calibre = calibre and not OF_CALIBRE.isdisjoint(beside)
        is_other = side in THICK or of_another or is_calibre
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


def _is_sure(unit: str, number: str) -> bool:
    """Whether a number of feet is a length, not the feet of a thing."""
    return unit == "feet" and not (number.isdigit() and int(number) <= MOST_FEET)


def _metres(found: re.Match[str]) -> float:
    if found["box"]:
        own = re.findall(rf"({_NUMBER})\s*({_UNIT})?", found["box"])
        last = found["box_unit"]
        return max(_number(number) * _unit(unit or last) for number, unit in own)
    if found["feet"]:
        inches = int(found["inches"] or found["more"])
        return float(found["feet"]) * METRES["ft"] + inches * METRES["in"]
    if found["metres"]:
        return int(found["metres"]) + int(found["cm"]) / 100
    if found["count"] or found["several"]:
        unit = found["counted"] or found["each"]
        return COUNTS[found["count"] or found["several"]] * _unit(unit)
    return _number(found["number"]) * _unit(found["unit"])


def _unit(text: str) -> float:
    return METRES[text.rstrip(".")]


def _number(text: str) -> float:
    if "/" in text:
        *whole, fraction = text.split()
        above, below = map(float, fraction.split("/"))  # no int: it may be too large to divide
        return sum(map(float, whole)) + above / max(below, 1)
    thousands = re.fullmatch(r"[0-9]{1,3}(?:,[0-9]{3})+(?:\.[0-9]+)?", text)
    return float(text.replace(",", "" if thousands else "."))
