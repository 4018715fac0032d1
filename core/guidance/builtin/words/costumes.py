"""Costumes: "dressed as a pirate" says what is worn. Standard library only."""

import re

# What tells a role at sight, by its names.
_COSTUMES = {
    "pirate, pirate captain, captain": "a pirate hat",
    "witch": "a black wizard hat and a black cape",
    "wizard, magician, sorcerer, mage": "a blue wizard hat and a blue cape",
    "king": "a golden crown and a red cape",
    "queen, princess": "a golden crown and a pink dress",
    "prince": "a golden crown and a blue cape",
    "knight, medieval knight": "a helmet and a chestplate",
    "samurai, viking, gladiator, roman soldier": "a helmet and a chestplate",
    "cowboy, cowgirl, sheriff": "a cowboy hat and a brown leather jacket",
    "santa, santa claus, father christmas, christmas": "a red beanie and a red coat",
    "superhero, superman, super hero, supergirl, hero": "a red cape",
    "batman, vampire, dracula": "a black cape",
    "astronaut, firefighter, fireman": "a helmet",
    "police officer, policeman, police, cop": "a navy baseball cap and a navy shirt",
    "doctor, scientist": "a lab coat",
    "chef, cook, baker": "a white beanie and a white shirt",
    "ballerina": "a pink tutu",
    "businessman, spy, secret agent, groom, gentleman, james bond": "a black suit and a necktie",
    "bride": "a white dress",
    "detective": "a trench coat and a hat",
    "sailor": "a white shirt",
    "explorer, adventurer, safari": "a backpack and a cowboy hat",
}
ROLES = {name: worn for names, worn in _COSTUMES.items() for name in names.split(", ")}
_NAMED = "|".join(sorted(map(re.escape, ROLES), key=len, reverse=True))
_DRESSED = re.compile(
    rf"(?:(?:who|that) is )?(?:dressed|disguised) (?:up )?(?:as|like) (?:an? |the )?"
    rf"(?P<as>{_NAMED})(?![\w-])"
    rf"|(?:dressed in|wearing|in|with) (?:an? |the )?(?P<in>{_NAMED})(?:'s)? "
    r"(?:costume|outfit|uniform|suit|clothes)(?![\w-])",
    re.IGNORECASE,
)


def undisguised(prompt: str) -> str:
    """The prompt with what is worn for each costume."""

    def worn(match: re.Match[str]) -> str:
        return f"wearing {ROLES[(match['as'] or match['in']).lower()]}"

    return _DRESSED.sub(worn, prompt)
