"""Names of several words that mean other known things: "a pot of gold", "a tea set".

Standard library only.
"""

import re

from core.guidance.builtin.words.companion_openers import named_in
from core.guidance.builtin.words.living import is_creature

NESTS = ("nest", "birdhouse", "beehive", "kite", "balloon", "lantern", "paper lantern")
_DOOR = r"(?:(?:tiny|small|little|round|wooden|red|blue|green) )*(?:doors?|windows?)"
_IDIOMS = {
    r"pots? of gold": "cauldron full of gold coins",
    r"pot of (?:soup|stew|chili)": "cooking pot",
    r"tea (?:set|service)": "teapot and two teacups",
    r"pack of (?:playing )?cards": "deck of cards",
    r"boat with (?:(?:two|a pair of|wooden|long) )*(?:oars|paddles)": "rowboat",
    r"tank (?:of|with) (?:tropical )?fish(?:es)?": "fish tank",
    r"jelly ?beans": "pink eggs",
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
_VINES = r"(?:(?:green|leafy|climbing|thick|hanging) )*(?:ivy|vines?|creepers?)"
_GROWS = "(?:growing|climbing|wrapped|winding|twisting|twining|twisted|creeping|wound|crawling)"
_TREE = r"(?P<tree>(?:an?|the|its|some) (?:(?!branch)[\w-]+ ){0,2}?tree)"
_IN = (
    r"(?:(?:sitting|perched|perching|hiding|hidden|sleeping|stuck|built|resting|nesting|living|"
    r"climbing|lodged) )?(?:(?:high )?up )?(?:high )?in (?:the (?:branches|top|crown|leaves|canopy) of )?"
)
_CROSSED = r"(?:(?:two|a pair of) )?(?:crossed |cross)(?P<what>bones|swords|axes|daggers|sabers|sabres)"
_A = r"(?P<of>with an? (?:[\w-]+ ){0,3}?)"
# What is first in a prompt and what is said of it, in other words.
_TURNED = {
    r"(?<!viking )(?<!motorcycle )\bhelmet(?= with (?:[\w-]+ ){0,4}horns?\b)": "viking helmet",
    rf"\b(?:house|cabin|hut|cottage|shack) {_IN}{_TREE}(?! ?(?:house|stump|trunk))": "treehouse",
    rf"{_A}(?:cloth|picnic blanket)(?= (?:in|on|over|draped)\b|[,.]|$)": r"\g<of>napkin",
    r"^\s*(?P<what>(?:(?:two|three|four|five|six|seven|eight|ten|twelve|several|some|many|a (?:circle|"
    r"ring|group) of|\d) )?(?:[\w-]+ ){0,2}?[\w-]+s) (?:(?:arranged|sitting|standing|placed|gathered|set|"
    r"seated|lying|all) )?(?:in a (?:circle|ring) )?around (?P<of>(?:an?|the) [^,.]+?)(?=[,.]|$)": (
        r"\g<of> with \g<what> around it"
    ),
    # A rock with other things is a boulder.
    r"^(?P<of>\s*(?:an?|the) (?:(?!with\b)[\w-]+ ){0,3}?)(?:rock|stone) (?=with )": r"\g<of>boulder ",
    r"(?<!fire )(?<!dump )(?<!garbage )(?<!pickup )(?<!tow )(?<!toy )(?<!food )(?<!cream )"
    r"(?<!pick-up )\btruck(?= (?:(?:carry|haul|transport|deliver)ing|loaded |full of|filled with|piled |"
    r"stacked |with an? (?:load|cargo|bed)))": "pickup truck",
    rf"^(?P<of>\s*(?:an? |the )?(?:[\w-]+ ){{0,2}}?)skull (?:and|with|over|on|above|on top of) {_CROSSED}"
    r"(?! (?:behind|under|below))": r"\g<of>skull with two crossed \g<what> behind it",
    rf"^\s*{_CROSSED} (?:under|below|beneath|underneath|behind) (?P<of>(?:an?|the) [^,.]*\bskull)": (
        r"\g<of> with two crossed \g<what> behind it"
    ),
    rf"^\s*(?:an? )?{_VINES} (?:{_GROWS} )?(?:around|up|over|on) (?P<of>(?:an?|the) [^,.]+)": (
        r"\g<of> overgrown"
    ),
    rf"(?:with|(?:covered|draped|wrapped|overgrown) (?:in|with|by)) {_VINES}"
    rf"(?: (?:{_GROWS}(?: (?:up|around|over|on))?|around|on) (?:it|them))?(?= and\b|[,.]|$)": "overgrown",
}
_TURNED_PATTERNS = {re.compile(one, re.IGNORECASE): meant for one, meant in _TURNED.items()}
_IN_A_TREE = re.compile(
    rf"^\s*(?P<who>(?:an?|the|two|three|some) (?:(?! in )[^,;.])+?) {_IN}{_TREE}"
    r"(?= with\b|[,.;]|$)",
    re.IGNORECASE,
)
_HANGING = re.compile(
    r"^\s*(?P<who>[^,;.]+?),? (?:that (?:is|are) )?hanging (?:down )?(?:from|in|on|off) "
    rf"(?:(?:the|an?|its) (?:[\w-]+ )?(?:branch|branches|limb) of )?{_TREE}(?: branch(?:es)?| limb)?"
    r"(?= with\b|[,.;]|$)",
    re.IGNORECASE,
)
_PATTERNS = {re.compile(rf"\b{idiom}\b", re.IGNORECASE): meant for idiom, meant in _IDIOMS.items()}


def in_known_words(prompt: str) -> str:
    """The prompt with what such names mean in their place."""
    for pattern, meant in _PATTERNS.items():
        prompt = pattern.sub(meant, prompt)
    for pattern, meant in _TURNED_PATTERNS.items():
        prompt = pattern.sub(meant, prompt)
    return prompt


def tree_first(prompt: str) -> str:
    """The prompt with the tree first, which is larger: "an owl in a tree", "lanterns hanging from a
    tree"; not with a fruit or an animal that hangs there."""
    for rule, how in ((_HANGING, "hanging from it"), (_IN_A_TREE, "on it")):
        found = rule.match(prompt)
        if found is None:
            continue
        noun = named_in(found["who"])
        alive = is_creature(noun)
        if noun and (not alive if rule is _HANGING else alive or noun in NESTS):
            return f"{found['tree']} with {found['who']} {how}{prompt[found.end() :]}"
    return prompt
