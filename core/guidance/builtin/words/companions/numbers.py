"""How many of a companion are made, and on which sides.

Standard library only.
"""

import math
import re
from dataclasses import replace

from core.guidance.builtin.words.companions import fillings
from core.guidance.builtin.words.companions.fit import Found
from core.guidance.builtin.words.tables.count_words import (
    CIRCLED,
    CONTAINED,
    FEW,
    FIGURES,
    HEAPED,
    MIXED,
    MOST_IN_CIRCLE,
)


def distributed(found: list[Found]) -> list[Found]:
    """Fewer of each of the things that fill a container together."""
    heaps = (CONTAINED, HEAPED)
    mixed = [one for one in found if one.relation == "bears" and one.words.count in heaps]
    if len(mixed) < 2:
        return found
    few = math.ceil(MIXED / len(mixed))
    return [
        one._replace(words=replace(one.words, count=few)) if one in mixed else one for one in found
    ]


def next_to(one: Found, where: str) -> list[Found]:
    """Things on both sides of the thing, or all around it."""
    several = fillings.named(one.phrase).is_many and one.words.count == 1
    count = CIRCLED if several else one.words.count
    figures = [FIGURES.get(word, 0) for word in one.phrase.lower().split()]
    stated = min(max([0, *figures]), MOST_IN_CIRCLE)
    if stated > count:
        count, notes = stated, (note for note in one.words.notes if "are made" not in note)
        one = one._replace(words=replace(one.words, notes=tuple(notes)))
    if "around" not in where.lower() or count < FEW or one.relation != "beside":
        return on_both_sides(one, where)
    words = replace(one.words, count=count, order="row")
    return [one._replace(relation="surrounding", words=words)]


def on_both_sides(one: Found, where: str) -> list[Found]:
    """Things next to the thing, as one or two: "two chairs", "a chair on each side"."""
    twice = re.search("each|either|both", where, re.IGNORECASE)
    half = one.words.count if twice else one.words.count // 2
    if not half:
        return [one]
    rest = half if twice else one.words.count - half
    return [one._replace(words=replace(one.words, count=count)) for count in (rest, half)]
