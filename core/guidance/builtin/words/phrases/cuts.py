"""What is bitten, cut or broken in words: "a half-eaten donut", "a ruined tower".

Standard library only.
"""

import re
from typing import Literal

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.tables.sorts import says

# "" is whole.
CutWord = Literal[
    "", "bitten", "half-eaten", "halved", "slice missing", "slice", "broken", "ruined"
]

_BITES = r"(?:(?:an?|one|two|three|some|several|big|large|huge|small|little|missing|few) )*bites?"
_OUT_OF_IT = r"(?: (?:out of|out|from|off|in|into|of)\b(?: (?:it|its side|one side|the side))?)?"
_GONE = r"(?:missing|gone|removed|taken|cut|sliced|eaten)"
_SLICE = r"(?:(?:an?|one|the|its|single|large|big|small) )*(?:missing )?(?:slice|wedge|piece)s?"
_NOT_HALVED = "(?!dozen|met(?:re|er)|inch|foot|yard|mile|kilo|cent|pound|ton)"
# Phrases, and the words for them that are looked for behind a thing's name.
_PHRASES = {
    rf",? ?\b(?:with|that has|has|having|missing|minus) {_BITES}(?: marks?)?(?: (?:that )?(?:is )?"
    rf"(?:{_GONE}|bitten))?{_OUT_OF_IT}(?![\w-])": " bitten",
    rf",? and {_BITES} {_GONE}{_OUT_OF_IT}(?![\w-])": " bitten",
    rf"\bbitten{_OUT_OF_IT}(?! by)(?![\w-])": "bitten",
    r"\b(?:partly|partially|half)[- ](?:eaten|bitten)\b": "half-eaten",
    r"\b(?:nibbled(?: on)?|(?:a )?(?:bit|partially) eaten)\b": "bitten",
    r"(?:,? ?\b(?:that is|which is) )?\b(?:cut|sliced|chopped|split|divided)(?: open)?"
    r" (?:in|into|in to) (?:half|halves|two)\b": " halved",
    rf"^\s*(?:an?|one) half (?:of )?(?=an? )|^\s*half (?:of )?(?=an? {_NOT_HALVED})": "halved ",
}
# Of these alone: "a table with a missing piece" is another thing.
_SLICED = re.compile(
    r"\b(?P<of>(?:cake|cheesecake|torte|pie|tart|quiche|pizza|watermelon)s?\b[^,]*?),? "
    rf"(?:(?:with|that has|missing|minus|lacking) {_SLICE}(?: (?:is |being )?{_GONE})?{_OUT_OF_IT}|"
    rf"with {_SLICE} {_GONE}{_OUT_OF_IT})(?![\w-])",
    re.IGNORECASE,
)
_PATTERNS = {re.compile(phrase, re.IGNORECASE): meant for phrase, meant in _PHRASES.items()}

_WORDS: dict[CutWord, str] = {
    "half-eaten": "half eaten",
    "bitten": "bitten",
    "slice missing": "partly sliced",
    "slice": "slice of, piece of, wedge of, slice",
    "halved": "halved",
    "ruined": "ruined, ruin, ruinous, crumbling, crumbled, collapsed, destroyed, demolished",
    "broken": "broken, shattered, smashed, snapped, splintered, fractured, broke",
}
# Of a part, or another sense: "with a broken leg", "a broken down car".
_OF_A_PART = re.compile(
    r"\b(?:with|has|having|and) (?:(?:an?|the|its|his|her|one|two|some) )*"
    r"(?:broken|shattered|smashed|snapped|splintered) \w+|\bbroken (?:down|english|colou?rs?)\b"
)

_FOOD = {*GROUPS["Food"], *GROUPS["Fruit and Vegetables"]}
EATEN = (
    frozenset(_FOOD)
    - frozenset(
        "ramen salad fries popcorn can jar grapes cherry garlic coconut sundae avocado".split()
    )
    - {"milk carton"}
)
HALVED = frozenset(
    """apple pear lemon peach strawberry watermelon tomato pumpkin onion potato eggplant pepper
    pineapple bread cake pie pizza hamburger burrito donut cookie muffin cupcake croissant egg
    carrot cucumber log""".split()
) | {"orange fruit", "easter egg", "cinnamon roll"}
# Drawn as halves, or with a slice.
AS_DRAWN: dict[CutWord, frozenset[str]] = {
    "halved": frozenset("kiwi coconut avocado".split()) | {"watermelon slice"},
    "slice missing": frozenset(["watermelon"]),
}
SHOWN_SLICED = AS_DRAWN["halved"] | {"bread", "orange fruit"}
SLICED = frozenset("cake pie pizza".split())
IN_SLICES = frozenset(["cake"])  # a pizza is drawn as one, a pie's lattice hangs out
SLICE_SIZE = 0.5  # of the whole thing's
_STANDING = (
    frozenset(GROUPS["Buildings"])
    - frozenset(
        """treehouse island mountain volcano dumpster pallet crane seesaw swing carousel""".split()
    )
    - frozenset(
        ["street lamp", "bus stop", "phone booth", "parking meter", "gas pump", "vending machine"]
    )
    - frozenset(
        ["market stall", "shipping container", "wind turbine", "solar panel", "ferris wheel"]
    )
)
RUINED = _STANDING - frozenset(
    ["column", "gate", "torii gate", "wall", "fountain", "staircase", "spiral staircase", "pyramid"]
)
BROKEN = (
    _STANDING
    | frozenset(
        """ball cube torus cylinder cone star gear chair stool bench throne table desk bookshelf
        wardrobe cabinet mug teacup goblet bottle bowl teapot door vase bust trophy bell candle
        mirror crown jug plate pen ruler flask pipe sword dagger shield arrow staff torch lantern
        chest barrel crate coin gem key cauldron hourglass skull tombstone sarcophagus signpost
        fence well ladder padlock horseshoe wheel spear halberd mace club scythe trident katana bow
        crossbow catapult crystal ingot coffin anchor egg lollipop cookie tree palm bonsai stump
        log boulder acorn coral seashell cactus mask bone tooth moai obelisk rowboat canoe raft
        sled wagon oar boomerang slingshot hammer axe pickaxe shovel screwdriver paintbrush pencil
        broom knife fork spoon pawn guitar banjo ukulele violin flute drum harp piano
        skateboard surfboard birdhouse abacus""".split()
    )
    | frozenset(
        """picnic table;rocking chair;wine glass;flower pot;picture frame;cutting board;stack of
         books;brick block;stone cross;stone tablet;totem pole;war hammer;magic wand;
         crystal ball;easter egg;candy cane;chocolate bar;oak tree;willow tree;christmas tree;
         chess knight;chess rook;chess king;rolling pin;hockey stick;golf club;baseball bat;
         tennis racket;electric guitar;bowling pin;snow globe;light bulb;christmas bauble;
         grandfather clock;full moon;planet;drinking horn;ship wheel;wall sconce;barbell;
         gingerbread man;grand piano;piggy bank;salt shaker;perfume;chestplate""".replace(
            "\n", ""
        ).split(";")
    )
) - {""}
BROKEN = frozenset(" ".join(name.split()) for name in BROKEN)


def in_cut_words(prompt: str) -> str:
    """The prompt with one word for a cut in place of a phrase: "an apple bitten" for "an apple with
    a bite taken out of it"."""
    prompt = _SLICED.sub(r"\g<of> partly sliced", prompt)
    for pattern, meant in _PATTERNS.items():
        prompt = pattern.sub(meant, prompt)
    return prompt


def cut_of(noun: str, prompt: str, is_statue: bool = False) -> tuple[CutWord, list[str]]:
    """How the thing of a prompt about it alone is cut, and its words there; a word for what is
    drawn so is one of these, too."""
    text = re.sub(r"[\W_]+", " ", prompt.lower())
    whole = _OF_A_PART.sub("", text)
    for cut, words in _WORDS.items():
        stated = [word for word in words.split(", ") if says(whole, word)]
        if stated and noun in AS_DRAWN.get(cut, ()):
            return "", stated
        if stated and _may_be(cut, noun, is_statue):
            return _kept(cut, noun, is_statue), stated
    if noun in ("egg", "easter egg") and says(text, "cracked"):
        return "broken", ["cracked"]
    if noun in SHOWN_SLICED and says(text, "sliced"):
        return "", ["sliced"]
    if noun == "lemon" and says(text, "sliced"):
        return "halved", ["sliced"]
    return "", []


def _may_be(cut: CutWord, noun: str, is_statue: bool) -> bool:
    of_cut = {
        "bitten": EATEN,
        "half-eaten": EATEN,
        "halved": HALVED,
        "slice missing": SLICED,
        "slice": IN_SLICES,
        "ruined": BROKEN,
        "broken": BROKEN,
    }
    return noun in of_cut[cut] or (is_statue and cut in ("broken", "ruined"))


def _kept(cut: CutWord, noun: str, is_statue: bool) -> CutWord:
    """A building that is broken is a ruin; what is small does not fall to ruins."""
    if cut in ("broken", "ruined"):
        return "ruined" if noun in RUINED and not is_statue else "broken"
    return cut
