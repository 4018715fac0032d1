"""Possible companions of a thing, as data: supports, holders, worn things.

Standard library only.
"""

import re

from core.guidance.builtin.nouns import GROUPS, NOUNS
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.words.companions.glassware import may_enclose
from core.guidance.builtin.words.grammar.openers import Relation
from core.guidance.builtin.words.grammar.part_names import owns
from core.guidance.builtin.words.tables.living import is_animal, is_creature, is_somebody
from core.guidance.builtin.words.tables.sizes import usual

HEADWEAR = frozenset(
    (
        "hat, wizard hat, cowboy hat, pirate hat, santa hat, chef hat, hard hat, crown, helmet, "
        "viking helmet, motorcycle helmet, beanie, baseball cap"
    ).split(", ")
)
EYEWEAR = frozenset(("sunglasses", "goggles", "vr headset"))
FACES = frozenset(("gas mask", "mask"))  # over them
AROUND_NECKS = frozenset(("bow tie", "necktie", "medal", "necklace"))
ON_BACKS = frozenset(("backpack", "jetpack", "quiver"))
# They are cut to their wearer.
CLOTHING = frozenset(
    "jacket shirt dress trousers belt chestplate boot sneaker sandal sock scarf cape".split()
) | {"high heel", "dog collar"}
ON_BODIES = frozenset(("shirt", "jacket", "dress", "chestplate"))  # one is worn
FITTED = CLOTHING | frozenset(APPENDAGES)  # they are made on their wearer
WORN = HEADWEAR | EYEWEAR | FACES | AROUND_NECKS | ON_BACKS | FITTED | {"headphones"}
# There is room on the ground under them, or at their foot.
ROOFS = frozenset(
    (
        "table, desk, coffee table, picnic table, pool table, bed, bunk bed, bench, chair, stool, "
        "tree, oak tree, palm, christmas tree, willow tree, bonsai, umbrella, mushroom, bridge, "
        "torii gate, street lamp, counter, piano, grand piano, slide, rainbow arch, sunflower, "
        "flower, satellite dish, carousel, ufo, airplane, treehouse, gate, swing, tent"
    ).split(", ")
)
# They are open above, so that their content is visible.
CONTAINERS = frozenset(
    (
        "vase, flower pot, cooking pot, cauldron, bowl, basket, bucket, cardboard box, crate, mug, "
        "teacup, paper cup, goblet, nest, bathtub, sink, boat, sailboat, canoe, rowboat, "
        "speedboat, longship, wagon, sleigh, yacht, wheelbarrow, shopping cart, minecart, go-kart, "
        "golf cart, race car, tractor, raft, sled, barrel, trash can, crib, pan, toilet, "
        "plate, dumpster, swimming pool"
    ).split(", ")
)
# Things that others stick in with their point, and things with such a point.
PIERCED = frozenset(
    "boulder stump log anvil tree pumpkin watermelon cake bread cheese apple skull shield".split()
)
POINTED = frozenset(
    "sword katana dagger knife axe pickaxe spear halberd arrow trident fork shovel saw".split()
)
# Things that are put on a table.
PUT_DOWN = (
    POINTED
    | frozenset(
        """spoon hammer wrench screwdriver paintbrush pencil pen whisk spatula key feather
    toothbrush hairbrush scissors pliers mace club scythe staff pistol revolver rifle shotgun bow
    arrow flute saw umbrella""".split()
    )
    | {"magic wand", "war hammer", "baseball bat", "rolling pin", "magnifying glass", "ray gun"}
)
# One sits in them as on a bench.
SEATS = frozenset(
    """chair armchair throne sofa bed beanbag wheelchair hammock saddle swing""".split()
) | {"rocking chair", "office chair", "gaming chair", "high chair", "bunk bed", "four-poster bed"}
VESSELS = frozenset("vase bowl bucket mug teacup goblet".split()) | {
    *("flower pot", "cooking pot", "paper cup"),
}
FLOWERS = frozenset("flower tulip rose sunflower".split())
STIRRING = frozenset("spoon fork whisk spatula".split())
ENTERED = CONTAINERS | WORN | SEATS | PIERCED | {"cube"}  # as a box is read by itself
BOX = "cardboard box"
BROOM = "broom"  # somebody may ride on one
# Worn, hanging or slender things, which bear nothing.
_SLENDER = (
    "chain, rope, curtain, clothes hanger, ladder, fence, staff, torch, key, arrow, umbrella, "
    "kite, feather, necklace, spear, halberd, mace, scythe, sword, dagger, trident, bow, crossbow, "
    "lightsaber, fork, knife, paintbrush, pencil, screwdriver, fishing rod, oar, golf club, "
    "hockey stick, baseball bat, tennis racket, whisk, spatula, hairbrush, toothbrush, syringe, "
    "screw, map pin, wheel, coat rack, umbrella stand, easel, street lamp, traffic light, window, "
    "door, mirror, picture frame, wall, clock, shield, padlock, wreath, light bulb, coin, balloon, "
    "paper lantern, parachute, pendant lamp, chandelier, wall sconce, bell, planet, earth, full "
    "moon, sun, snowflake, target, dartboard, notice board, flute, whistle, christmas bauble, "
    "broom, rake, lollipop, phone, remote control, wind turbine, satellite, stethoscope, solar "
    "panel, ring, bus stop, katana, magic wand, handcuffs, bullet, mop, wine glass, pen, ray gun, "
    "shotgun, rocket launcher, war hammer, quiver, skis"
)
_SLENDER_GROUPS = ("Flags and Signs", "Clothes")
_STURDY = frozenset("backpack suitcase briefcase handbag boot sneaker helmet".split())
NO_SUPPORTS = (
    frozenset(_SLENDER.split(", "))
    | {"signpost", "stop sign"}
    | frozenset(noun for group in _SLENDER_GROUPS for noun in GROUPS[group] if noun not in _STURDY)
)
# Places, not things.
NO_PLACES = frozenset(
    """wall walls ceiling floor background backdrop ground display museum stand surface mannequin
    hill hills mountain mountains beach mars canvas screen base table-top market""".split()
)
THE_MOON = frozenset(("moon", "sun", "sea", "ocean", "lake", "river", "sky", "street", "field"))
# Parts that grow on a body, not things that are put there.
GROWN = frozenset(("antenna", "antennae", "aerial", "horn", "feather"))
# Parts of a robot with a screen.
_FEATURES = frozenset(
    """screen wheel wheels display monocle hand hands tooth teeth fang fangs eyeball
    eyeballs""".split()
) | {"pumpkin head"}
_IN_HAND = 0.25  # of the holder's length, at most: a rabbit, but not a dog
_FISH = ("fish", "clownfish", "koi")
_NO_FIGURES = frozenset("moai obelisk mask bone tooth eyeball hand brain".split()) | {"totem pole"}
# Things that are not held.
_STANDS = (
    frozenset(GROUPS["Vehicles"])
    | frozenset(GROUPS["Aircraft and Space"])
    | frozenset("chest anvil barrel mailbox engine cannon nest bathtub campfire".split())
)
PEDESTALS = ("column", "pallet")
# Things on a building that are large enough to see.
LARGEST_BUILDING = 8.0  # times as long as what is on it
# A snake is coiled around these.
_COILED_AROUND = POINTED | {
    *("staff", "torch", "candle", "column", "magic wand", "street lamp", "signpost", "flute"),
    *(
        "tree",
        "oak tree",
        "palm",
        "umbrella",
        "baseball bat",
        "bottle",
        "goblet",
        "wine glass",
        "war hammer",
        "mace",
    ),
}
_STAND = (
    r"(?:wooden |black |display |sword |weapon |katana )*(?:stand|(?:sword|weapon|katana) rack)"
)
# Things that others stand or lie on, as what is known: "a parrot on a perch".
STAND_INS = {
    r"(?:tree |wooden |bare )*(?:perch|branch|twig|bough)": "log",
    r"(?:floating |small |large )*(?:ice ?floe|iceberg|ice ?berg|sheet of ice|slab of ice)": (
        "large flat boulder made of ice"
    ),
    r"(?:stone |marble |wooden )*(?:pedestal|plinth|podium)": "column",
    r"(?:table)?cloth": "towel",
    _STAND: "rectangular coffee table",
}
# These do not stand on things: they hang, or are flat against them.
HUNG = frozenset(
    (
        "necklace, dress, shirt, trousers, jacket, chain, curtain, picture frame, clock, "
        "dartboard, window, door, wall sconce, chandelier, pendant lamp, wreath, wheel, notice "
        "board, medal, scarf, necktie, belt, mirror, padlock, wall, faucet"
    ).split(", ")
)
# Things on these are pictures.
ALSO_DRESSED = ("Food", "Fruit and Vegetables", "Plants")
_ALSO_DRESSED = frozenset(("robot", "bust", "skull", "rubber duck", "piggy bank", "mech"))
NO_BEARERS = frozenset(GROUPS["Arms and Fantasy"]) | POINTED | {"staff", "key"}
NO_HANDS = ("bust", "skull")
INSTRUMENTS = frozenset(GROUPS["Instruments"])
EDIBLE = frozenset(GROUPS["Food"]) | frozenset(GROUPS["Fruit and Vegetables"])
DRINKS = frozenset(
    "mug teacup goblet bottle can jar milk-carton potion flask".replace("-", " ").split()
) | {"paper cup", "bubble tea", "milk carton", "drinking horn", "jug", "wine glass"}
READ = frozenset("book scroll envelope clipboard newspaper letter map tablet phone".split()) | {
    "treasure map",
}
USED = (
    dict.fromkeys(("playing", "plays", "play"), INSTRUMENTS)
    | dict.fromkeys(("eating", "eats", "eat", "biting", "licking", "munching", "nibbling"), EDIBLE)
    | dict.fromkeys(("drinking", "sipping"), DRINKS)
    | dict.fromkeys(("reading", "reads"), READ)
)
# Things that a hand does not take: worn elsewhere, or houses.
_NOT_HELD = (
    frozenset("sneaker boot sandal sock shirt trousers dress jacket belt".split())
    | {"high heel", "roller skate", "chestplate", "parachute", "drum kit"}
    | {"tree", "oak tree", "palm", "christmas tree", "bush"}
    | frozenset(GROUPS["Furniture"]) - {"pillow", "lamp", "mirror"}
)


def is_dressed(noun: str) -> bool:
    """Whether it may wear or hold something: a living thing, its likeness, or a funny fruit."""
    return (
        is_creature(noun)
        or noun in _ALSO_DRESSED
        or any(noun in GROUPS[group] for group in ALSO_DRESSED)
    )


def is_building(noun: str) -> bool:
    """Whether it is a building, or a part of the landscape."""
    return noun in GROUPS["Buildings"] and noun not in PEDESTALS


def is_no_place(phrase: str) -> bool:
    """Whether it only states a place, not a thing that it is on or in."""
    words = phrase.lower().replace("-", " ").split()
    there = [word for word in words if word in THE_MOON]
    return not NO_PLACES.isdisjoint(words) or (bool(there) and words[0] == "the")


def is_rack(first: str, phrase: str) -> bool:
    """Whether it is a stand on which the first thing lies, as a sword does."""
    return first in PUT_DOWN and bool(re.search(rf"\b{_STAND}$", phrase, re.IGNORECASE))


def as_container(phrase: str) -> str:
    """The phrase for its content: a box that holds something is a cardboard box."""
    return re.sub(r"(?<![\w-])(?<!cardboard )box$", BOX, phrase, flags=re.IGNORECASE)


def as_meant(noun: str) -> Relation:
    """The meaning of "in" with such a thing: on a chair, wearing a hat."""
    return "wears" if noun in WORN else "on" if noun in SEATS else "in"


def may_contain(other: str, first: str) -> bool:
    """Whether the first thing may be in the other; a cactus has a pot of its own."""
    potted = other in VESSELS and owns(first, "pot")
    if first in POINTED and other in PIERCED:
        return True
    within = other in CONTAINERS and not is_building(first) and not potted
    return within or may_enclose(other, first)


def may_hold_within(other: str, first: str) -> bool:
    """Whether "with the other in it" applies to the first: flowers in a vase, an axe in a stump."""
    stuck = other in POINTED and first in PIERCED
    stirs = other in STIRRING and first in VESSELS | {"pan", "cauldron"}
    return stuck or stirs or (first in CONTAINERS and (is_creature(other) or other in FLOWERS))


def may_coil(first: str, other: str) -> bool:
    """Whether the first thing may be drawn with its coils around the other."""
    return first == "snake" and other in _COILED_AROUND


def may_wear(first: str, other: str) -> bool:
    """Whether the first thing may wear the other, and has nothing there."""
    if other in APPENDAGES:  # a lion, a sneaker, a house
        return first not in APPENDAGES
    covered = other in ("helmet", "gas mask") and owns(first, "visor")
    if other in CLOTHING and not is_dressed(first):
        return False
    return other in WORN and first not in WORN and not covered


def is_put_on(first: str, other: str) -> bool:
    """Whether it is worn over the first thing's natural clothes: a person has a shirt."""
    armour = other == "chestplate" and not {"armour", "plate"}.intersection(NOUNS[first].looks)
    own = NOUNS[first].looks
    shirt = not {"shirt", "dress"}.isdisjoint(own) and is_somebody(first)
    return armour or (shirt and other in ("jacket", "dress", "cape") and other not in own)


def may_bear(other: str, first: str, heaped: bool = False) -> bool:
    """Whether the first thing may stand, lie, sit or ride on the other, or on a heap of it."""
    if other == BROOM:
        return is_dressed(first)
    if (other in NO_SUPPORTS and not heaped) or first in HUNG:
        return False
    return not is_building(other) or usual(other)[0] <= LARGEST_BUILDING * usual(first)[0]


def is_held(noun: str, verb: str) -> bool:
    """Whether a figure may have it in a hand, a paw or a mouth, by the verb."""
    if verb in USED:
        return noun in USED[verb]
    return noun not in _NOT_HELD and not is_building(noun)


def has_with(first: str, form: str, other: str) -> Relation | None:
    """The relation in "a girl with a kite", "a boy with a dog", "a horse with a saddle": she holds
    it, it is next to him, it bears it. None: a part, or a pattern."""
    figure = (is_creature(first) and first not in _NO_FIGURES) or first in _ALSO_DRESSED
    tied = form == "bow" and not is_somebody(first)  # a ribbon
    if form in _FEATURES or tied or not figure:
        return None
    if other == "saddle":
        return "bears"
    alive = is_animal(other) or is_somebody(other)
    large = alive and usual(other)[0] > _IN_HAND * usual(first)[0] and other not in _FISH
    return "beside" if large or other in _STANDS else "holds"
