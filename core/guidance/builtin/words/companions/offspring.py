"""Young animals with a parent: "a mother duck with three ducklings", "a bear and her cub".

Standard library only.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up, singulars
from core.guidance.builtin.words.grammar.openers import Relation, named_in
from core.guidance.builtin.words.grammar.tokens import LONGEST
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.count_words import FEW, FIGURES
from core.guidance.builtin.words.tables.living import is_animal

_BIRDS = (
    "chicken penguin bird owl eagle flamingo ostrich toucan parrot peacock turkey crow seagull "
    "pigeon dodo vulture puffin pelican swan goose duck"
)
_CALVING = (
    "cow bull elephant whale orca dolphin hippo rhino giraffe camel moose bison deer mammoth yak "
    "buffalo manatee narwhal walrus triceratops"
)
# Words for young ones, by the animals that have them.
_OF = {
    "duckling": "duck",
    "gosling": "goose",
    "cygnet": "swan",
    "owlet": "owl",
    "chick": _BIRDS,
    "kitten": "cat",
    "puppy": "dog corgi dalmatian pug poodle wolf fox",
    "lamb": "sheep",
    "kid": "goat",
    "piglet": "pig",
    "fawn": "deer moose",
    "joey": "kangaroo koala",
    "foal": "horse zebra donkey unicorn pegasus",
    "colt": "horse zebra donkey",
    "filly": "horse zebra",
    "calf": _CALVING,
    "tadpole": "frog",
}
_OF_ANY = (*"baby young cub pup hatchling newborn offspring child infant".split(), "little one")
_HUMAN = ("child", "infant")  # but for "its child"
_POSSESSIVE = re.compile("its|her|his|their", re.IGNORECASE)
_MANY = {
    "baby": "babies",
    "puppy": "puppies",
    "calf": "calves",
    "filly": "fillies",
    "child": "children",
}
_SINGLE = {_MANY.get(one, f"{one}s"): one for one in (*_OF, *_OF_ANY)}
_NUMBERS = {"pair": 2, "couple": 2, "litter": 4, "many": 5} | dict.fromkeys(
    ("several", "some", "few"), FEW
)
_LOOKS = (
    "color color_form material material_form pattern second second_form target accents sheen "
    "weather is_statue"
).split()
_FEW = (1, FEW)  # in no stated number, of a singular and of a plural
_WORDS = sorted({*_OF, *_OF_ANY, *_SINGLE}, key=len, reverse=True)
_COUNTS = "two|three|four|five|six|several|some|many|a few|a pair of|a couple of|a litter of|[2-6]"
_COUNT = (
    rf"(?:(?:(?:its|her|his|their|the)(?: own)? )?(?:{_COUNTS})|"
    r"(?:its|her|his|their|the|an?|one|another)(?: own)?)"
)
_HOLDING = "holding|carrying|hugging|cuddling|cradling|embracing|picking up"
_JOIN = (
    r"(?:who |that |which |and )?(?:is |are )?"
    r"(?:with|and|plus|alongside|accompanied by|followed by|surrounded by|next to|beside|near|"
    r"(?:lead|feed|nurs|nuzzl|protect|guard|watch|lick|groom|teach|suckl|bath|warm|mother)ing"
    r"(?: over)?|looking (?:after|at)|caring for|taking care of|standing over|"
    rf"(?P<holds>{_HOLDING}))"
)
_PLACED = re.compile(
    r"(?: (?:riding|sitting|sleeping|lying|standing|clinging|perched))? "
    r"(?P<back>on (?:top of )?(?:its|her|his|their) (?:back|shoulders?|head)\b)|"
    r" (?:(?:peeking|peering|looking) out of|in|inside|against|to) "
    r"(?P<pouch>(?:its|her|his|a|the) (?:pouch|arms|mouth|chest)\b)|"
    r"(?: (?:following|walking|standing|swimming|waddling|trailing|lying|sitting|sleeping))?"
    r" (?:(?:right )?behind|beside|next to|near|around|by|close to|after|at|under|between) "
    r"(?:it|them|(?:its|her|his|their) (?:sides?|feet|wings?|belly|legs)|her|him)\b|"
    r" (?:following|trailing)(?: (?:it|her|him|them|closely|behind|along))*\b",
    re.IGNORECASE,
)
_YOUNG = re.compile(
    rf",? (?<![\w-]){_JOIN} (?P<count>{_COUNT} )?"
    r"(?P<looks>(?:(?!(?:and|with|of|on|in)\b)[\w'-]+ ){0,3}?)"
    rf"(?P<young>{'|'.join(_WORDS)})(?![\w'-])",
    re.IGNORECASE,
)
_ADULT = r"(?:mother|mama|momma|mommy|mom|mum|father|papa|daddy|dad|parent)"
_BOTH = re.compile(
    rf"^(?P<article>\s*(?:(?:an?|the) )?){_ADULT} and (?:(?:her|his|its|a) )?"
    rf"(?P<young>{'|'.join(_WORDS)}) (?P<name>(?:[\w-]+ ?){{1,3}})",
    re.IGNORECASE,
)
_ADULT_NAME = re.compile(
    rf"(?<![\w-]){_ADULT} (?=(?P<name>[\w-]+(?: [\w-]+){{0,2}}))", re.IGNORECASE
)
_NAME_ADULT = re.compile(
    rf"(?P<name>\b[\w-]+) {_ADULT}(?= (?:with|and|who|that|her|his|its|[a-z]+ing)\b|$)",
    re.IGNORECASE,
)
_SOW = re.compile(r"\bsow(?= [^,.]*piglet)", re.IGNORECASE)


class Young(NamedTuple):
    """Young ones of a prompt's thing, and their place in the prompt."""

    parent: str  # the thing's name
    relation: Relation
    phrases: tuple[str, ...]  # one of them by its own word, and as a baby of the thing
    count: int
    start: int
    end: int


def parents_named(prompt: str) -> str:
    """The prompt without "mother" before an animal, which is drawn grown anyway; "a mother and baby
    giraffe" are a giraffe and a baby giraffe."""
    both = _BOTH.match(prompt)
    if both and is_animal(named_in(name := _named_at(both["name"]))):
        rest = prompt[both.end("young") :]
        return f"{both['article']}{name} and a {both['young']}{rest}"
    prompt = _NAME_ADULT.sub(
        lambda one: one["name"] if is_animal(named_in(one["name"])) else one[0], prompt
    )
    prompt = _SOW.sub("pig", prompt)
    return _ADULT_NAME.sub(lambda one: "" if is_animal(named_in(one["name"])) else one[0], prompt)


def young_in(prompt: str, first_of: Callable[[str], str]) -> Iterator[Young]:
    """The young ones of the prompt's first thing; ``first_of``: the thing that a text names
    first, or ""."""
    for match in _YOUNG.finditer(prompt):
        first = first_of(prompt[: match.start()])
        word = match["young"].lower()
        single = _SINGLE.get(word, word)
        if not is_animal(first) or (single in _OF and first not in _OF[single].split()):
            continue
        if single in _HUMAN and not _POSSESSIVE.match(match["count"] or ""):
            continue
        rest = prompt[match.end("young") :]
        name = _named_at(rest)
        if name and named_in(name) != first:  # "a baby panda" is no bear's
            continue
        end = match.end("young") + (rest.index(name) + len(name) if name else 0)
        place = _PLACED.match(prompt, end)
        end = place.end() if place else end
        count = _count_of(
            match["count"], word in _SINGLE or (bool(name) and len(singulars(name)) > 1)
        )
        looks = "" if named_in(match["looks"]) else match["looks"]
        phrases = f"a {match['looks']}{single}", f"a {looks}baby {first}"
        relation = _relation(match["holds"] if count == 1 else None, place)
        yield Young(first, relation, phrases, count, match.start(), end)


def like_its_parent(words: Words, parent: Words, count: int) -> Words:
    """So many young ones, with the parent's fur where they have no colour of their own."""
    words = replace(words, count=count, is_toy=parent.is_toy, style=parent.style)
    if words.color or words.material or words.pattern or words.accents:
        return words
    return replace(words, **{look: getattr(parent, look) for look in _LOOKS})


def _relation(holds: str | None, place: re.Match[str] | None) -> Relation:
    if place and place["back"]:
        return "bears"
    return "holds" if holds or (place and place["pouch"]) else "beside"


def _count_of(stated: str | None, is_plural: bool) -> int:
    words = (stated or "").lower().split()
    numbers = [FIGURES[word] for word in words if word in FIGURES]
    numbers += [int(word) for word in words if word.isdigit()]
    return next(iter([*numbers, *(_NUMBERS[w] for w in words if w in _NUMBERS)]), _FEW[is_plural])


def _named_at(text: str) -> str:
    """The name of a thing at the beginning of the text, as written there, or ""."""
    words = text.split()[:LONGEST]
    for count in range(len(words), 0, -1):
        name = " ".join(words[:count]).rstrip(",.;:!?")
        entry = look_up(name.lower(), SLOTS)
        if entry is not None and entry.slot == "noun":
            return name
    return ""
