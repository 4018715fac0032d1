"""The words the built-in prior knows, and the parser that refuses all others.

A prompt is read into four slots: noun, shape, colour, material. Order is free; articles, plurals,
case and filler are passed over. A word that is not known is an error that names it, never a guess.
"""

import difflib
import re
from dataclasses import astuple, dataclass

from core.errors import UserError

NOUNS = {
    "ball": "sphere globe orb",
    "cube": "box block dice",
    "torus": "donut doughnut ring bagel",
    "cylinder": "barrel drum",
    "cone": "",
    "table": "desk",
    "chair": "",
    "armchair": "recliner",
    "mug": "cup teacup",
    "vase": "urn",
    "bottle": "flask",
    "lamp": "lampshade",
    "snowman": "snowmen",
    "mushroom": "toadstool",
    "house": "cottage home hut",
    "dumbbell": "barbell",
    "rocket": "spaceship",
    "tree": "fir pine conifer",
}
SHAPES = {
    "tall": "high slim thin narrow slender",
    "flat": "low short squat flattened",
    "wide": "long broad",
}
COLORS = {
    "red": "crimson scarlet",
    "orange": "",
    "yellow": "",
    "green": "",
    "cyan": "turquoise teal",
    "blue": "navy",
    "purple": "violet",
    "pink": "magenta",
    "brown": "",
    "black": "",
    "white": "",
    "grey": "gray",
}
MATERIALS = {
    "wooden": "wood timber oak walnut",
    "metal": "metallic steel iron silver silvery chrome aluminium aluminum",
    "golden": "gold brass",
    "plastic": "",
    "rubber": "",
    "stone": "marble granite concrete rock",
}
# What people write around the subject and what says nothing about it.
FILLER = frozenset(
    """a an the of in on with and is it its one single some made from out color colour colored
    coloured photo photograph picture image render rendering rendered dslr 3d 3-d cg model object
    highly very detailed high-quality quality hd 4k 8k hdr realistic photorealistic beautiful nice
    simple studio lighting isolated background view please style shape
    shaped asset game ready material""".split()
)
# Nearest known words for common ones that no spelling leads to.
NEAREST = {
    **dict.fromkeys(["sofa", "couch", "loveseat"], "armchair"),
    **dict.fromkeys(["stool", "bench", "throne", "seat"], "chair"),
    **dict.fromkeys(["pot", "jar", "pitcher", "jug", "amphora"], "vase"),
    **dict.fromkeys(["glass", "goblet", "bowl", "teapot", "bucket"], "mug"),
    **dict.fromkeys(["building", "castle", "church", "tower", "cabin", "barn", "shed"], "house"),
    **dict.fromkeys(["plant", "bush", "cactus", "flower"], "tree"),
    **dict.fromkeys(["plane", "airplane", "car", "ship", "missile"], "rocket"),
    **dict.fromkeys(["apple", "planet", "moon", "earth", "football", "egg"], "ball"),
    **dict.fromkeys(["man", "person", "figure", "doll", "robot"], "snowman"),
    **dict.fromkeys(["light", "lantern", "candle", "streetlight"], "lamp"),
    **dict.fromkeys(["tube", "pipe", "can", "pillar", "column"], "cylinder"),
    **dict.fromkeys(["pyramid", "hat"], "cone"),
    **dict.fromkeys(["tyre", "tire", "wheel"], "torus"),
    **dict.fromkeys(["leather", "glass-like"], "plastic"),
    **dict.fromkeys(["bronze", "copper"], "golden"),
    **dict.fromkeys(["beige", "tan"], "brown"),
    **dict.fromkeys(["fuchsia", "rose"], "pink"),
    **dict.fromkeys(["lime", "olive"], "green"),
}
SLOTS = {"noun": NOUNS, "shape": SHAPES, "color": COLORS, "material": MATERIALS}
ELSEWHERE = (
    "For any other wording use Stable Diffusion: --guidance FOLDER, where FOLDER holds its weights."
)


@dataclass(frozen=True)
class Words:
    """What a prompt says, by slot; empty is not said."""

    noun: str = ""
    shape: str = ""
    color: str = ""
    material: str = ""

    def indices(self, slots: tuple[str, ...] = tuple(SLOTS)) -> list[int]:
        """Each slot's row in its embedding; 0 is "not said"."""
        return [_rows(slot).index(getattr(self, slot)) for slot in slots]

    def __str__(self) -> str:
        return " ".join(word for word in reversed(astuple(self)) if word)


def _rows(slot: str) -> list[str]:
    return ["", *SLOTS[slot]]


def _lexicon() -> dict[str, tuple[str, str]]:
    lexicon = {}
    for slot, words in SLOTS.items():
        for word, synonyms in words.items():
            for form in [word, *synonyms.split()]:
                lexicon[form] = (slot, word)
    return lexicon


LEXICON = _lexicon()


def parse(prompt: str, *, noun_needed: bool = True) -> Words:
    """Read a prompt into slots.

    Raises ``UserError`` that names every word it does not know with the nearest it does, two words
    for one slot, and a missing noun unless ``noun_needed`` is false (a negative prompt).
    """
    found: dict[str, list[str]] = {slot: [] for slot in SLOTS}
    unknown = []
    for token in re.findall(r"[^\W_]+(?:[-'][^\W_]+)*", prompt.lower()):
        entry = _look_up(token)
        if entry is not None:
            found[entry[0]].append(entry[1])
        elif token not in FILLER and not _parts_are_filler(token):
            unknown.append(token)
    if unknown:
        raise _unknown_error(unknown)
    for slot, words in found.items():
        if len(set(words)) > 1:
            raise UserError(
                f"The built-in prior takes one {slot} in a prompt and got "
                f"{' and '.join(repr(word) for word in dict.fromkeys(words))}.",
                f"Keep one of them. {ELSEWHERE}",
            )
    if noun_needed and not found["noun"]:
        raise UserError(
            f"The prompt {prompt.strip()!r} does not name a thing the built-in prior knows.",
            f"Say one of: {', '.join(NOUNS)}. {ELSEWHERE}",
        )
    return Words(**{slot: words[0] if words else "" for slot, words in found.items()})


def _look_up(token: str) -> tuple[str, str] | None:
    for form in _singulars(token):
        if form in LEXICON:
            return LEXICON[form]
    return None


def _singulars(token: str) -> list[str]:
    """The token and what it may be the plural or the possessive of."""
    token = token.removesuffix("'s")
    forms = [token]
    if token.endswith("s"):
        forms.append(token[:-1])
    if token.endswith("es"):
        forms.append(token[:-2])
    return forms


def _parts_are_filler(token: str) -> bool:
    return "-" in token and all(part in FILLER for part in token.split("-"))


def _unknown_error(unknown: list[str]) -> UserError:
    named = "; ".join(_describe(token) for token in dict.fromkeys(unknown))
    return UserError(
        f"The built-in prior does not know {named}.",
        f"It knows the things {', '.join(NOUNS)}; the shapes {', '.join(SHAPES)}; the colours "
        f"{', '.join(COLORS)}; the materials {', '.join(MATERIALS)}. {ELSEWHERE}",
    )


def _describe(token: str) -> str:
    close = nearest_words(token)
    return f"{token!r} (did you mean {' or '.join(close)}?)" if close else repr(token)


def nearest_words(token: str) -> list[str]:
    """Known words that look or mean nearly the same, best first; at most three."""
    meant = [NEAREST[form] for form in _singulars(token) if form in NEAREST]
    alike = difflib.get_close_matches(token, LEXICON, n=3, cutoff=0.7)
    return list(dict.fromkeys([*meant, *alike]))[:3]
