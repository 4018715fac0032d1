"""Prompts in other words, with the larger thing first: "an owl in a tree", "chairs around a table",
"crossed bones under a skull".

Standard library only.
"""

import re

from core.guidance.builtin.words.companions.known_as import ROOFS, may_coil
from core.guidance.builtin.words.grammar.lexicon import SLOTS, look_up
from core.guidance.builtin.words.grammar.openers import named_in
from core.guidance.builtin.words.grammar.part_names import owns
from core.guidance.builtin.words.tables.living import is_creature

# These are in a tree's branches, as animals are.
_IN_BRANCHES = ("nest", "birdhouse", "beehive", "kite", "balloon", "lantern", "paper lantern")
_VINES = r"(?:(?:green|leafy|climbing|thick|hanging) )*(?:ivy|vines?|creepers?)"
_GROWS = "(?:growing|climbing|wrapped|winding|twisting|twining|twisted|creeping|wound|crawling)"
_TREE = r"(?P<tree>(?:an?|the|its|some) (?:(?!branch)[\w-]+ ){0,2}?tree)"
_IN = (
    r"(?:(?:sitting|perched|perching|hiding|hidden|sleeping|stuck|built|resting|nesting|living|"
    r"climbing|lodged) )?(?:(?:high )?up )?(?:high )?"
    r"in (?:the (?:branches|top|crown|leaves|canopy) of )?"
)
_CROSSED = (
    r"(?:(?:two|a pair of) )?(?:crossed |cross)(?P<what>bones|swords|axes|daggers|sabers|sabres)"
)
_MANY = (
    r"(?:(?:two|three|four|five|six|seven|eight|ten|twelve|several|some|many|"
    r"a (?:circle|ring|group) of|\d) )?(?:[\w-]+ ){0,2}?[\w-]+s"
)
_SET = r"(?:(?:arranged|sitting|standing|placed|gathered|set|seated|lying|growing|all) )?"
_WORN = "scarf|shawl|cape|cloak|belt|necklace|tie|bow tie|medal|collar"
_NO_FREIGHT = "".join(
    rf"(?<!{sort} )" for sort in "fire dump garbage pickup pick-up tow toy food cream".split()
)
_FREIGHT = (
    r"(?:(?:carry|haul|transport|deliver)ing|loaded |full of|filled with|piled |stacked |"
    r"with an? (?:load|cargo|bed))"
)
_TURNED = {
    r"(?<!viking )(?<!motorcycle )\bhelmet(?= with (?:[\w-]+ ){0,4}horns?\b)": "viking helmet",
    rf"\b(?:house|cabin|hut|cottage|shack) {_IN}{_TREE}(?! ?(?:house|stump|trunk))": "treehouse",
    r"(?P<of>with an? (?:[\w-]+ ){0,3}?)(?:cloth|picnic blanket)"
    r"(?= (?:in|on|over|draped)\b|[,.]|$)": r"\g<of>napkin",
    rf"^\s*(?P<what>{_MANY}) {_SET}(?:in a (?:circle|ring) )?around "
    r"(?P<of>(?:an?|the) [^,.]+?)(?=[,.]|$)": r"\g<of> with \g<what> around it",
    rf"^\s*(?P<what>an? (?:[\w-]+ ){{0,3}}?(?:{_WORN})) (?:wrapped|tied|draped|hanging|worn) "
    r"around (?P<of>(?:an?|the) [^,.]+?)(?:'s (?:neck|shoulders|waist))?(?=[,.]|$)": (
        r"\g<of> wearing \g<what>"
    ),
    r"^(?P<of>\s*(?:(?!with\b)[^,.;])+?) growing (?:out (?:of|from)|up from|from|through) "
    r"(?=(?:an?|the) )": r"\g<of> on ",
    # A rock with other things is a boulder.
    r"^(?P<of>\s*(?:an?|the) (?:(?!with\b)[\w-]+ ){0,3}?)(?:rock|stone) (?=with )": (
        r"\g<of>boulder "
    ),
    rf"{_NO_FREIGHT}\btruck(?= {_FREIGHT})": "pickup truck",
    rf"^(?P<of>\s*(?:an? |the )?(?:[\w-]+ ){{0,2}}?)skull "
    rf"(?:and|with|over|on|above|on top of) {_CROSSED}(?! (?:behind|under|below))": (
        r"\g<of>skull with two crossed \g<what> behind it"
    ),
    rf"^\s*{_CROSSED} (?:under|below|beneath|underneath|behind) "
    r"(?P<of>(?:an?|the) [^,.]*\bskull)": r"\g<of> with two crossed \g<what> behind it",
    rf"^\s*(?:an? )?{_VINES} (?:{_GROWS} )?(?:around|up|over|on) (?P<of>(?:an?|the) [^,.]+)": (
        r"\g<of> overgrown"
    ),
    rf"(?:with|(?:covered|draped|wrapped|overgrown) (?:in|with|by)) {_VINES}"
    rf"(?: (?:{_GROWS}(?: (?:up|around|over|on))?|around|on) (?:it|them))?(?= and\b|[,.]|$)": (
        "overgrown"
    ),
    r"^(?P<of>\s*(?:an?|the) (?:[\w-]+ ){0,3}?(?:snake|serpent|cobra|python|viper) )"
    r"(?=around (?:an?|the|its) )": r"\g<of>coiled ",
    r"\b(?P<of>snow ?globes?|glass domes?|terrariums?) with "
    r"(?P<what>an? (?!(?:[\w-]+ )*(?:stand|base|lid|plaque)\b)[^,.]+?)(?= and\b|[,.]|$)"
    r"(?<!inside)(?<!in it)": r"\g<of> with \g<what> inside",
    r"\b(?P<of>jack[- ]o[- ]lantern|pumpkin|skull) with "
    r"(?P<what>an? (?:[\w-]+ ){0,3}?(?:hat|cap|crown|beret|beanie|fez|fedora))"
    r"(?= and\b|[,.]|$)": r"\g<of> wearing \g<what>",
}
_PATTERNS = {re.compile(one, re.IGNORECASE): meant for one, meant in _TURNED.items()}
_END = r"(?= with\b|[,.;]|$)"
_IN_A_TREE = re.compile(
    rf"^\s*(?P<who>(?:an?|the|two|three|some) (?:(?! in )[^,;.])+?) {_IN}{_TREE}{_END}",
    re.IGNORECASE,
)
_HANGING = re.compile(
    r"^\s*(?P<who>[^,;.]+?),? (?:that (?:is|are) )?hanging (?:down )?(?:from|in|on|off) "
    r"(?:(?:the|an?|its) (?:[\w-]+ )?(?:branch|branches|limb) of )?"
    rf"(?:{_TREE}(?: branch(?:es)?| limb)?|an? (?:[\w-]+ ){{0,2}}branch){_END}",
    re.IGNORECASE,
)
POSES = ("sitting", "sleeping", "lying", "crouching", "kneeling")
_POSTURES = "|".join((*POSES, "standing", "resting", "hiding", "waiting", "napping"))
_UNDER = re.compile(
    r"^\s*(?P<who>(?:an? |the )?(?:(?!\b(?:with|in|on|an?|the)\b)[^,;.])+?)"
    rf"(?: (?P<how>{_POSTURES}|placed|piled))? "
    rf"(?:under|underneath|beneath|below) (?P<of>(?:an?|the) [^,;.]+?){_END}",
    re.IGNORECASE,
)
_OVER = re.compile(
    r"^\s*(?P<of>(?:an?|the) (?:[\w-]+ ){0,3}?(?:umbrella|parasol|tree)) over "
    rf"(?P<who>(?:an?|the) [^,;.]+?){_END}",
    re.IGNORECASE,
)
_ARTICLE = re.compile(r"(?P<a>(?:an?|the|two|three|some) )", re.IGNORECASE)
_DECORATED = re.compile(
    r"(?P<of>\b(?:vase|urn|mug|teapot|jug|shield|flag|banner|coin|skateboard|surfboard|poster)) "
    rf"with (?P<what>an? (?:(?!\b(?:on|in|inside|and|wrapped|around)\b)[^,.;])+?){_END}",
    re.IGNORECASE,
)
_WINGED = re.compile(
    r"^(?P<before>\s*(?:(?:an?|the|two|three|some) )?(?:[\w-]+ ){0,4}?)"
    r"(?P<how>winged|horned|antlered) (?P<rest>(?:(?!\b(?:with|wearing|holding|carrying|riding|"
    r"sitting|standing|on|in|and)\b)[^,.;])+?)"
    r"(?= (?:with|wearing|holding|carrying|riding|sitting|standing|on|in|and)\b|[,.;]|$)",
    re.IGNORECASE,
)
_HAVING = {"winged": "wings", "horned": "horns", "antlered": "antlers"}
_COILED = re.compile(
    r"^(?P<of>\s*(?:an?|the) [^,.]+?) with (?P<what>an? [^,.]+?) "
    r"(?:(?:coiled|wrapped|curled|twisted|entwined|winding|coiling|wrapping|twined)(?: up)? )?"
    rf"around (?:it|the [\w-]+|its [\w-]+){_END}",
    re.IGNORECASE,
)


def turned_around(prompt: str) -> str:
    """The prompt with the thing first that the others are around or behind."""
    for pattern, meant in _PATTERNS.items():
        prompt = pattern.sub(meant, prompt)
    return _DECORATED.sub(_as_picture, prompt)


def _as_picture(found: re.Match[str]) -> str:
    """ "A vase with a dragon": a creature is a picture on it."""
    what = found["what"]
    return f"{found['of']} with {what} on it" if is_creature(named_in(what)) else found[0]


def grown_last(prompt: str) -> str:
    """A "winged lion" as "a lion with wings", if a lion has none by itself."""
    found = _WINGED.match(prompt)
    if found is None:
        return prompt
    how, rest = found["how"].lower(), found["rest"]
    noun, part = named_in(rest), _HAVING[how]
    if not noun or look_up(f"{how} {rest}".lower(), SLOTS):  # a winged horse is a pegasus
        return prompt
    having = "" if owns(noun, part) else f" with {part}"
    return f"{found['before']}{rest}{having}{prompt[found.end() :]}"


def snake_first(prompt: str) -> str:
    """The prompt with a snake first that is coiled around a slender thing: "a staff with a snake
    around it"."""
    found = _COILED.match(prompt)
    if found is None or not may_coil(named_in(found["what"]), named_in(found["of"])):
        return prompt
    return f"{found['what']} coiled around {found['of'].strip()}{prompt[found.end() :]}"


def roof_first(prompt: str) -> str:
    """The prompt with what others are under first: "a cat sleeping under a table"."""
    found = _UNDER.match(prompt) or _OVER.match(prompt)
    if found is None or named_in(found["of"]) not in ROOFS or not named_in(found["who"]):
        return prompt
    who, how = found["who"], found.groupdict().get("how")
    if how and how.lower() in POSES:  # "a sleeping cat"
        who = _ARTICLE.sub(rf"\g<a>{how} ", who, count=1)
    return f"{found['of']} with {who} under it{prompt[found.end() :]}"


def tree_first(prompt: str) -> str:
    """The prompt with the tree first, which is larger: "an owl in a tree", "lanterns hanging from a
    tree"; not with a fruit or an animal that hangs there."""
    for rule, how in ((_HANGING, "hanging from it"), (_IN_A_TREE, "on it")):
        found = rule.match(prompt)
        if found is None:
            continue
        noun = named_in(found["who"])
        alive = is_creature(noun)
        if noun and (not alive if rule is _HANGING else alive or noun in _IN_BRANCHES):
            return f"{found['tree'] or 'a tree'} with {found['who']} {how}{prompt[found.end() :]}"
    return prompt
