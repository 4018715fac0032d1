"""Names of several words that mean other known things: "a pot of gold", "a tea set".

Standard library only.
"""

import re

# What is stated of a set is of each thing in it.
_LOOK = r"(?P<look>(?:(?!an?\b|the\b|of\b|and\b|with\b|in\b|on\b)[\w'-]+ ){0,4})"
_TAIL = (
    r"(?P<tail>(?: (?:painted|decorated))? (?:with|in) (?:(?!an?\b|the\b|and\b)[\w'-]+ ){0,3}"
    r"(?:flowers|roses|dots|stripes|hearts|stars|leaves|birds|patterns?|print|trim|rims?|handles?|"
    r"accents|details)\b)"
)
_BROOM = r"(?:an?|the|her|his|its) (?:[\w-]+ ){0,2}broom"
_DOOR = r"(?:(?:tiny|small|little|round|wooden|red|blue|green) )*(?:doors?|windows?)"
_IDIOMS = {
    r"pots? of gold": "cauldron full of gold coins",
    r"pot of (?:soup|stew|chili)": "cooking pot",
    rf"{_LOOK}tea (?:set|service){_TAIL}": (
        r"\g<look>teapot\g<tail> next to two \g<look>teacups\g<tail>"
    ),
    rf"{_LOOK}tea (?:set|service)": r"\g<look>teapot and two \g<look>teacups",
    rf"(?<=\w )(?:flying|soaring|sitting)(?= (?:on|upon) {_BROOM})": "riding",
    r"(?<=\w )fishing(?= (?:in|at|on|from|off|by)\b|,|\.|$)(?<!for fishing)(?<!ice fishing)": (
        "holding a fishing rod"
    ),
    r"(?P<of>jack[- ]o[- ]?lantern|carved (?:halloween )?pumpkin|lantern) with (?:an? )?"
    r"(?:(?:lit|burning|glowing|small|little) )*candles? (?:inside|in)(?: of)?(?: it)?": (
        r"\g<of>"
    ),
    r"(?:magic |magical )?flying broom": "broom",
    r"(?:pack|deck) of (?:playing )?cards": "stack of playing cards",
    r"boat with (?:(?:two|a pair of|wooden|long) )*(?:oars|paddles)": "rowboat",
    r"tank (?:of|with) (?:tropical )?fish(?:es)?": "fish tank",
    r"jelly ?beans": "pink eggs",
    r"(?:leaning )?(?:tower of pisa|pisa tower)": "leaning tower",
    r"jack[- ]in[- ](?:the|a)[- ]box(?:es)?": "jackbox",
    r"box(?:es)? of (?:match(?:es|sticks))": "matchbox",
    r"(?:jolly roger|pirate) flag": "black flag with a white skull and crossbones",
    r"(?<=in )(?:an? )?space ?suits?": "an astronaut costume",
    r"wearing (?:an? )?space ?suits?": "in an astronaut costume",
    # A ship's bottle has one with sails in it.
    r"(?<!pirate )(?<!cargo )(?<!cruise )(?<!sailing )(?<!tall )ship"
    r"(?= (?:in|inside(?: of)?) (?:an? |the )?(?:[\w-]+ ){0,2}bottle)": "sailing ship",
    r"(?<=bottle with a )ship": "sailing ship",
    r"(?<= in a )(?:clear |hollow )?glass (?:sphere|ball|orb)": "crystal ball",
    r"(?:message|letter|note)(?= (?:in|inside(?: of)?) (?:an? |the )?(?:[\w-]+ ){0,2}bottle)": (
        "scroll"
    ),
    r"(?<=bottle with a )(?:message|letter|note)": "scroll",
    r"(?<=typewriter with a )(?:(?:blank|white|fresh) )?(?:sheet|page|piece) of paper": "paper",
    r"(?<=glove with a )(?:ball|baseball)": "baseball",
    rf"mushroom with (?:an? )?{_DOOR}(?: and (?:an? )?{_DOOR})?": "mushroom house",
}
_PATTERNS = {re.compile(rf"\b{idiom}\b", re.IGNORECASE): meant for idiom, meant in _IDIOMS.items()}


def in_known_words(prompt: str) -> str:
    """The prompt with what such names mean in their place."""
    for pattern, meant in _PATTERNS.items():
        prompt = pattern.sub(meant, prompt)
    return prompt
