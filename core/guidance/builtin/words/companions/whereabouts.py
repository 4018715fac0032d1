"""The place of a thing that accompanies another: a vase on a table, a tree next to a house.

Standard library only.
"""

from typing import Literal

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companions import fillings, known_as
from core.guidance.builtin.words.companions.fillings import PLATE, named
from core.guidance.builtin.words.grammar.openers import named_in
from core.guidance.builtin.words.tables.count_words import SEVERAL
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.pictured import is_pictured
from core.guidance.builtin.words.tables.sizes import usual

# Relative to the first thing, several in a row or in a heap; "": unclear.
Place = Literal["on", "three on", "heaped on", "in", "by", ""]
# Words for a place next to the thing.
BY_IT = (
    "(?:next to|beside|near|behind|in front of|around|(?:leaning|propped) (?:up )?"
    "(?:against|on)) (?:it|them)|"
    "(?:at|by|on) (?:its|each|either|one|both) sides?(?! of)"
)
# Things on these are real, not painted.
TOPS = frozenset(
    (
        "table, desk, coffee table, picnic table, pool table, nightstand, dresser, cabinet, stool, "
        "bench, bed, bunk bed, four-poster bed, sofa, armchair, ottoman, shelf, bookshelf, "
        "counter, rug, towel, piano, grand piano, fireplace, stove, grill, cutting board, plate, "
        "stump, column, pallet, trailer, island, cloud"
    ).split(", ")
)
_FURNITURE = frozenset(GROUPS["Furniture"]) - {"lamp", "pillow", "shelf", "mirror", "beanbag"}
LAID = frozenset(("rug", "towel"))  # a thing with them may be a picture
_LEVEL = LAID | {"pallet", "trailer"}  # furniture may be on these
_TALL = 0.5  # times as long as a table: plants and vehicles next to it
_LARGEST = 1.2  # times as long as its support or container
_VEHICLES = frozenset(GROUPS["Vehicles"]) | frozenset(GROUPS["Aircraft and Space"])
_OF_VEHICLES = (
    frozenset(GROUPS["Flags and Signs"])
    | frozenset("flag anchor wheel engine oar cannon radio tire speaker".split())
    | {"ship wheel"}
)
_BUILDINGS = frozenset(GROUPS["Buildings"])
_GROWING = frozenset("tree palm bush mushroom boulder stump log".split()) | {
    *("oak tree", "christmas tree", "willow tree", "bamboo plant"),
}
_PERCHING = frozenset("bird owl parrot eagle squirrel toucan".split())
_NESTING = frozenset("nest beehive birdhouse".split())
_ELECTRONICS = frozenset(GROUPS["Electronics"])
_LANDS = ("island", "cloud")  # things on them have any size
_NEAR_BY = frozenset("bucket lantern basket bicycle sack shovel axe".split())
_PITCHED = frozenset("tent campfire well signpost mailbox tombstone anvil scarecrow".split())
# Things next to a house or a tree, in addition to vehicles and living things.
_OUTSIDE = (
    _GROWING
    | _FURNITURE
    | _PITCHED
    | frozenset(
        "cactus barrel chest crate cauldron cannon snowman wheelbarrow pumpkin fence".split()
    )
    | frozenset("windmill fountain silo swing seesaw crane ladder".split())
    | {
        "street lamp",
        "potted plant",
        "treehouse",
        "hay bale",
        "flower pot",
        "trash can",
        "fire hydrant",
    }
)
_LARGE = _VEHICLES | _BUILDINGS  # on an island
_SERVED = frozenset("mug teacup goblet teapot bottle candle bowl can".split()) | {"wine glass"}
STOVES = frozenset("stove grill campfire fireplace".split())
_HEATED = frozenset("pan kettle teapot cauldron".split()) | {"cooking pot", "moka pot"}
_SMALL = 0.35  # times as long as a table: several of these are on it
_POURED = frozenset("coin gem bone bullet dice".split()) | {"poker chip"}
_TOPPED = frozenset("cake pie cupcake pancakes sundae waffle".split()) | {"ice cream"}


def place_of(first: str, phrase: str, is_one: bool) -> Place:
    """The place of the phrase's thing relative to the first thing.

    Args:
        is_one: whether it names one, or a number of them; else "apples", "bread".
    """
    noun = named_in(phrase)
    if not noun or noun == first or noun in known_as.HUNG:
        return ""
    long = fillings.length(noun, phrase) / usual(first)[0]
    many = not is_one and named(phrase).is_many
    if noun in known_as.POINTED and first in known_as.PIERCED:
        return "in"
    if (first in STOVES and noun in _HEATED) or (first == "anvil" and noun in known_as.PUT_DOWN):
        return "on"
    if first in _TOPPED and noun in known_as.EDIBLE:
        return "heaped on" if many else "on" if is_one else ""
    if first == PLATE and noun in _SERVED:
        return "on"
    if first in known_as.CONTAINERS:
        return _in(first, noun, long, is_one)
    if first in _LANDS:
        return "on" if (is_one and noun in _LARGE | _OUTSIDE) or is_creature(noun) else ""
    if first in TOPS and not is_one:
        return _on_top(noun, long, many)
    if first in TOPS:
        tall = long > _TALL and noun in _GROWING | _VEHICLES
        beside = tall or (noun in _FURNITURE and first not in _LEVEL)
        return "by" if beside else "on" if long < _LARGEST else ""
    return _beside(first, noun) if is_one else ""


def _on_top(noun: str, long: float, many: bool) -> Place:
    """The place of several things on a table, or of bread."""
    if noun in SEVERAL:
        return "on"
    if noun in known_as.EDIBLE or (many and noun in _POURED):
        return "heaped on" if many else "on"
    return "three on" if many and long < _SMALL else ""


def _in(first: str, noun: str, long: float, is_one: bool) -> Place:
    if first in known_as.VESSELS and noun in known_as.STIRRING:
        return "in"
    if first in known_as.DRINKS:
        return "by" if noun in known_as.EDIBLE and is_one else ""
    if is_pictured(first):
        fits = noun in known_as.EDIBLE
    else:
        fits = first not in _VEHICLES or noun not in _OF_VEHICLES | _BUILDINGS
    return "in" if fits and long < _LARGEST else ""


def _beside(first: str, noun: str) -> Place:
    """The place of one that may be next to the first thing."""
    if first in _GROWING and noun in _PERCHING | _NESTING:
        return "on"
    if known_as.is_dressed(first) and first not in _GROWING:
        return ""
    if first in _VEHICLES:
        return "by" if is_creature(noun) or noun == "trailer" else ""
    for alike in (_FURNITURE, _ELECTRONICS):
        if first in alike:
            return "by" if noun in alike else ""
    stands = noun in _OUTSIDE | _VEHICLES or is_creature(noun)
    if first in _BUILDINGS:
        return "by" if stands else ""
    return "by" if first in _GROWING | _PITCHED and (stands or noun in _NEAR_BY) else ""
