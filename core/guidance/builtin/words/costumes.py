"""What somebody has on who is dressed as a pirate, who is a penguin chef or a farmer.

Standard library only.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from core.guidance.builtin.words.companion_openers import TOKEN
from core.guidance.builtin.words.companion_words import is_dressed
from core.guidance.builtin.words.lexicon import SLOTS, look_up
from core.guidance.builtin.words.tokens import LONGEST, PERSON
from core.guidance.builtin.words.words import DEPICTIONS

# What tells a role at sight, by its names.
_COSTUMES = {
    "pirate, pirate captain": "wearing a pirate hat",
    "witch, sorceress": "wearing a black wizard hat and a black cape",
    "wizard, magician, sorcerer, mage, alchemist": "wearing a blue wizard hat and a blue cape",
    "king, emperor, pharaoh": "wearing a golden crown and a red cape",
    "queen, princess": "wearing a golden crown and a pink dress",
    "prince": "wearing a golden crown and a blue cape",
    "knight, medieval knight, paladin": "wearing a helmet and a chestplate",
    "samurai, viking, gladiator, roman soldier, guard": "wearing a helmet and a chestplate",
    "warrior, soldier": "wearing a helmet and holding a sword",
    "ninja": "wearing a black scarf and holding a katana",
    "archer, ranger": "wearing a green cape and holding a bow",
    "cowboy, cowgirl, sheriff": "wearing a cowboy hat and a brown leather jacket",
    "santa, santa claus, father christmas, christmas": "wearing a red beanie and a red coat",
    "superhero, superman, super hero, supergirl, hero": "wearing a red cape",
    "batman, vampire, dracula": "wearing a black cape",
    "astronaut, spaceman, cosmonaut": "wearing a white helmet and a jetpack",
    "firefighter, fireman": "wearing a red helmet and holding an axe",
    "police officer, policeman, police, cop": "wearing a navy baseball cap and a navy shirt",
    "doctor, nurse, scientist": "wearing a lab coat",
    "chef, cook, baker": "wearing a white beanie and a white shirt",
    "butcher": "wearing a white shirt and holding a knife",
    "ballerina": "wearing a pink tutu",
    "businessman, spy, secret agent, groom, gentleman, james bond, bartender, waiter, butler": (
        "wearing a black suit and a necktie"
    ),
    "lawyer": "wearing a black suit and holding a briefcase",
    "judge, priest, nun, cleric": "wearing a black dress",
    "bride": "wearing a white dress and holding a rose",
    "detective": "wearing a trench coat and a hat",
    "captain, pilot": "wearing a navy baseball cap and a navy jacket",
    "sailor": "wearing a white shirt",
    "diver, scuba diver": "wearing goggles",
    "explorer, adventurer, safari": "wearing a backpack and a cowboy hat",
    "hiker, tourist, student": "wearing a backpack",
    "merchant, trader": "wearing a backpack and holding a lantern",
    "farmer, peasant, villager": "wearing a cowboy hat and holding a rake",
    "gardener": "wearing a cowboy hat and holding a shovel",
    "fisherman": "wearing a yellow coat and holding a fishing rod",
    "lumberjack": "wearing a red beanie and holding an axe",
    "hunter": "wearing a brown jacket and holding a rifle",
    "miner": "wearing a yellow helmet and holding a pickaxe",
    "worker, construction worker, builder": "wearing a yellow helmet and holding a hammer",
    "engineer, electrician": "wearing a yellow helmet and holding a wrench",
    "plumber, mechanic": "wearing a red baseball cap and holding a wrench",
    "carpenter": "holding a saw",
    "blacksmith": "holding a hammer",
    "janitor": "holding a broom",
    "teacher, librarian": "holding a book",
    "mailman, postman": "wearing a blue baseball cap and holding an envelope",
    "painter, artist": "wearing a black beanie and holding a paintbrush",
    "photographer": "holding a camera",
    "singer": "holding a microphone",
    "guitarist, musician": "holding a guitar",
    "rockstar, rock star": "wearing sunglasses and holding an electric guitar",
    "bard": "holding a guitar",
    "dj, gamer": "wearing headphones",
    "basketball player": "holding a basketball",
    "soccer player, footballer, goalkeeper": "holding a soccer ball",
    "baseball player": "wearing a baseball cap and holding a baseball bat",
    "bandit, robber": "wearing a black beanie and holding a sack",
    "healer": "wearing a white dress",
}
ROLES = {name: worn for names, worn in _COSTUMES.items() for name in names.split(", ")}
# Animals that are called so.
NO_ROLES = frozenset(
    ("king penguin", "emperor penguin", "king crab", "king cobra", "vampire bat", "hermit crab")
)
DEPICTED = frozenset((*DEPICTIONS, "toy"))  # "a wizard plushie" is a wizard
_COUNTS = range(LONGEST, 0, -1)
_NAMED = "|".join(sorted(map(re.escape, ROLES), key=len, reverse=True))
_DRESSED = re.compile(
    rf" ?(?:(?:(?:who|that) is )?(?:dressed|disguised) (?:up )?(?:as|like) (?:an? |the )?"
    rf"(?P<as>{_NAMED})(?![\w-])"
    rf"|(?:dressed in|wearing|in|with) (?:an? |the )?(?P<in>{_NAMED})(?:'s)? "
    r"(?:costume|outfit|uniform|suit|clothes)(?![\w-]))",
    re.IGNORECASE,
)


class _Name(NamedTuple):
    """What one or a few words of a prompt name."""

    text: str
    noun: str  # "": a role alone, such as "police"
    start: int
    end: int


def undisguised(prompt: str) -> tuple[str, str]:
    """The prompt without what says the costume; and what is worn or held, or ""."""
    if match := _DRESSED.search(prompt):
        role = (match["as"] or match["in"]).lower()
        return f"{prompt[: match.start()]}{prompt[match.end() :]}", ROLES[role]
    names = list(_first_names(prompt))
    if len(names) == 1 and names[0].noun == PERSON:  # "a farmer"
        return prompt, ROLES.get(names[0].text, "")
    if len(names) == 2 and (role := _role_of(*names)):
        return f"{prompt[: role.start]}{prompt[role.end :]}".rstrip(), ROLES[role.text]
    return prompt, ""


def _role_of(first: _Name, last: _Name) -> _Name | None:
    """Which of two names is the other's role: "a penguin chef", "a pirate cat"."""
    if f"{first.text} {last.text}" in NO_ROLES or last.text in DEPICTED:
        return None
    # Of two roles the last is who it is: "a warrior princess".
    order = (first, last) if first.text in ROLES and last.noun else (last, first)
    for role, other in (order, order[::-1]):
        if role.text in ROLES and is_dressed(other.noun):
            return role
    return None


def _first_names(prompt: str) -> Iterator[_Name]:
    """Those that stand together where the prompt first names anything."""
    tokens = list(TOKEN.finditer(prompt))
    at, begun = 0, False
    while at < len(tokens):
        name = next(filter(None, (_named(tokens[at : at + k]) for k in _COUNTS)), None)
        if name is None and begun:
            return
        if name:
            begun = True
            yield name
        at += len(name.text.split()) if name else 1


def _named(tokens: list[re.Match[str]]) -> _Name | None:
    if not tokens:
        return None
    start, end = tokens[0].start(), tokens[-1].end()
    text = " ".join(token[0] for token in tokens).lower()
    entry = look_up(text, SLOTS)
    noun = entry.word if entry and entry.slot == "noun" else ""
    return _Name(text, noun, start, end) if noun or text in ROLES else None
