"""Poses of animals and figures in words: "a sitting dog", "a running boy".

Standard library only.
"""

import re
from typing import Literal

from core.guidance.builtin.words.tables.living import is_animal
from core.guidance.builtin.words.tables.sorts import says

# "" is the pose in which a thing is drawn.
PoseWord = Literal[
    "",
    "sitting",
    "lying",
    "sleeping",
    "rearing",
    "running",
    "walking",
    "leaping",
    "howling",
    "roaring",
    "grazing",
    "flying",
    "kneeling",
    "crouching",
    "dancing",
]

# The animals that are drawn standing on four legs, as ``core/tests/builtin/test_animal_poses.py``
# measures.
FOUR_LEGGED = frozenset(
    """dog corgi cat horse donkey cow bull sheep pig wolf fox bear deer lion elephant giraffe
    unicorn tiger leopard zebra rhino hippo camel llama goat moose dalmatian pug raccoon triceratops
    stegosaurus brachiosaurus mammoth pegasus dragon poodle griffin""".split()
)
GRAZING = frozenset(
    "horse donkey cow bull sheep deer giraffe unicorn zebra rhino camel llama goat moose".split()
) | {"pegasus", "elephant"}
WINGED = frozenset("dragon pegasus griffin".split())
# They are drawn sitting, on their bellies, flying, swimming.
SITTING = frozenset("rabbit squirrel koala panda monkey kangaroo beaver frog skunk hamster".split())
LYING = frozenset("crocodile lizard turtle seal walrus snake mouse".split())
FLYING = frozenset("bat butterfly bee dragonfly pterodactyl phoenix".split())
SWIMMING = frozenset(
    """fish clownfish koi pufferfish seahorse stingray jellyfish octopus whale orca dolphin shark
    turtle seal walrus axolotl duck goose swan""".split()
)

# The figures that are drawn standing on two legs, as ``core/tests/builtin/test_figure_poses.py``
# measures.
FIGURES = frozenset(
    """person boy girl knight robot skeleton astronaut ninja viking goblin zombie alien chef clown
    cowboy demon doll firefighter monster mummy orc pirate samurai soldier superhero werewolf
    gnome""".split()
) | {"police officer", "santa claus"}

WORDS: dict[PoseWord, str] = {
    "rearing": "rearing, rears, reared, rampant, upright",
    "sleeping": "sleeping, asleep, sleeps, napping, dozing, snoozing, curled",
    "sitting": "sitting, sits, seated, sit, crouching, crouched, squatting",
    "lying": "lying, lies, laying, lounging, reclining, resting, relaxing, lazing",
    "leaping": "leaping, leaps, jumping, jumps, pouncing, bounding",
    "running": "running, runs, galloping, gallops, sprinting, charging, racing",
    "walking": "walking, walks, trotting, prowling, strolling, strutting, marching, stalking",
    "howling": "howling, howls, braying, crowing",
    "roaring": "roaring, roars, barking, growling, snarling, meowing, bleating, neighing, "
    "trumpeting",
    "grazing": "grazing, grazes, drinking, sniffing",
    "flying": "flying, flies, soaring, hovering",
}
OF_SOME: dict[PoseWord, frozenset[str]] = {"grazing": GRAZING, "flying": WINGED}
OF_FIGURES: dict[PoseWord, str] = {
    "sleeping": "sleeping, asleep, sleeps, napping, dozing, snoozing",
    "kneeling": "kneeling, kneels, kneeled, knelt",
    "crouching": "crouching, crouched, crouches, squatting, squats",
    "sitting": "sitting, sits, seated, sit, resting, relaxing, lounging",
    "lying": "lying, lies, laying, reclining",
    "leaping": "leaping, leaps, jumping, jumps, hopping",
    "running": "running, runs, sprinting, sprints, jogging, charging",
    "walking": "walking, walks, strolling, marching, marches, hiking, strutting, sneaking",
    "dancing": "dancing, dances",
}
AS_DRAWN: dict[str, frozenset[str]] = {
    "standing, stands, stood, perched, perching": frozenset(),  # all that is not drawn otherwise
    WORDS["sitting"]: SITTING,
    WORDS["lying"]: LYING,
    WORDS["flying"]: FLYING,
    "swimming, swims, floating, diving": SWIMMING,
}
# Their wings are drawn spread.
SPREAD = FLYING | {"eagle", "dragon", "pegasus", "griffin", "angel", "fairy", "gargoyle", "demon"}
_SPREAD_WINGS = re.compile(
    r",? with (?:(?:its|his|her|their|both) )?(?:(?:wide|fully|big|large|huge) )*"
    r"(?:(?:spread|open|opened|outspread|outstretched|unfolded|unfurled|extended) wings|"
    r"wings (?:wide )?(?:spread|open|outstretched|extended|unfurled)(?: wide| out)?)\b",
    re.IGNORECASE,
)
_HIND_LEGS = re.compile(
    r"\b(?:(?:standing|stands|walking|dancing|sitting|up|rearing) )*on (?:(?:its|his|her|their|two|"
    r"the) )*(?:hind|back|rear) legs?\b",
    re.IGNORECASE,
)
_ON_KNEES = re.compile(
    r"\b(?:(?:kneeling|kneels|down|going|sitting) )*on (?:(?:its|his|her|their|one|a|both|the) )*"
    r"(?:bended |bent )?knees?\b",
    re.IGNORECASE,
)
_ON_BACK = re.compile(
    r"\b(?P<pose>lying|lies|laying|sleeping|sleeps|asleep) (?:(?:down|flat) )*on "
    r"(?:its|his|her|their|the) backs?\b",
    re.IGNORECASE,
)
# A thing's use or sort, not what a figure does: "running shoes", "a walking stick".
_OF_THINGS = re.compile(
    r"\b(?:running|walking|jogging|hiking|sleeping|sitting|jumping|dancing|marching|kneeling)"
    r" (?:shoes?|boots?|sneakers?|trainers?|sandals?|socks?|shorts|gear|suits?|outfits?|clothes|"
    r"tights|sticks?|canes?|poles?|frames?|staffs?|bags?|masks?|caps?|pills?|rooms?|areas?|"
    r"jacks?|ropes?|beans?|bands?|dress|gowns?|pads?|beauty|dead|tours?|machines?|water|nose)\b"
    r"|\brunning (?=an? (?!race|marathon|mile|lap|sprint)\w)"
)


def in_a_word(noun: str, prompt: str) -> str:
    """The prompt with "rearing" in place of "standing on its hind legs", "kneeling" in place of "on
    one knee", and without that wings are spread that are drawn so."""
    if noun in SPREAD:
        prompt = _SPREAD_WINGS.sub("", prompt)
    if noun in FIGURES:
        return _ON_BACK.sub(lambda found: found["pose"], _ON_KNEES.sub("kneeling", prompt))
    return _HIND_LEGS.sub("rearing", prompt) if noun in FOUR_LEGGED else prompt


def pose_of(noun: str, prompt: str) -> tuple[PoseWord, list[str]]:
    """The pose of the thing in a prompt about it alone, and its words there; a word for the pose in
    which it is drawn is one of these, too."""
    text = re.sub(r"[\W_]+", " ", prompt.lower())
    if noun in FIGURES:
        text = _OF_THINGS.sub("", text)
        for pose, words in OF_FIGURES.items():
            if stated := [word for word in words.split(", ") if says(text, word)]:
                return pose, stated
    for pose, words in WORDS.items():
        stated = [word for word in words.split(", ") if says(text, word)]
        if stated and noun in FOUR_LEGGED & OF_SOME.get(pose, FOUR_LEGGED):
            return pose, stated
    if not is_animal(noun) and noun not in FIGURES:
        return "", []
    for words, nouns in AS_DRAWN.items():
        stated = [word for word in words.split(", ") if says(text, word)]
        drawn = noun in nouns if nouns else noun not in SITTING | LYING
        if stated and drawn:
            return "", stated
    return "", []
