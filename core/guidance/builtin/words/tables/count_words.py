"""Words for the number of a thing and its arrangement, as data.

Standard library only.
"""

from typing import Literal

Order = Literal["row", "heap", "stack", "crossed", "back to back", "face to face", "circle"]

MOST = 6  # the largest exact count; more are as many as "many"
MANY, FEW, HEAPED, STACKED, CONTAINED, GROWING, CIRCLED = 5, 3, 7, 5, 6, 5, 6
MIXED = 10  # of all kinds together that fill a container
MOST_IN_CIRCLE = 12
FIGURES = {
    word: number
    for number, word in enumerate(
        """two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen
        sixteen seventeen eighteen nineteen twenty""".split(),
        2,
    )
} | {"fifty": 50, "hundred": 100}
ONE = ("one", "single", "lone", "solitary")
MOST_PARTS = 24  # components of a part
MOST_DIGITS = 100  # 1967 is a year
FEW_WORDS = frozenset("several few some multiple various".split())
MANY_WORDS = frozenset("many numerous countless".split())
EVEN_WORDS = {"twin": 2, "dual": 2}
# Before "of", and their meaning for animals and for things as large as a chair.
SETS = {
    **dict.fromkeys("pair couple duo brace".split(), 2),
    **dict.fromkeys("trio triplet trinity handful set row".split(), FEW),
    **dict.fromkeys("quartet foursome".split(), 4),
}
GROUPS = frozenset(
    """bunch group bundle cluster clump collection assortment pack dozen dozens hundreds lots lot
    plenty loads tons load flock herd school swarm crowd team gang army family litter""".split()
)
HEAPS = frozenset("pile piles heap heaps mound mounds mountain".split())
STACKS = frozenset("stack stacks".split())
CAIRNS = ("cairn", "cairns")  # of stones, one on another
# Words that are materials by themselves, and the things in a pile of them.
STONES = dict.fromkeys(("rock", "stone", "cobblestone"), ("rocks",)) | {
    "brick": ("brick", "blocks")
}
PLAIN_STONES = tuple(f"{word}s" for word in STONES)[1:3]
WITHOUT_OF = frozenset("dozen couple".split())
# Before the name: "three stacked crates", "crossed swords"; of a plain plural the number, too.
LAID: dict[str, tuple[Order, int]] = {
    "stacked": ("stack", FEW),
    "piled": ("stack", FEW),
    "crossed": ("crossed", 2),
    "crossing": ("crossed", 2),
}
PAIRS: tuple[Order, ...] = ("crossed", "back to back", "face to face")  # of two
# The number of a plain plural with its arrangement: "chairs in a circle".
COUNTS_OF: dict[Order, int] = {
    "row": FEW,
    "stack": FEW,
    "heap": HEAPED,
    "circle": CIRCLED,
    **dict.fromkeys(PAIRS, 2),
}
# Before "of": "a circle of stones".
RINGS = frozenset("circle ring".split())
GEM = "gem"  # a ring of these is a jewel
_EACH = ("on top of each other", "on each other", "on top of one another", "high", "up")
_FACING = [
    f"{how}{what}"
    for how in ("standing ", "sitting ", "")
    for what in (
        "facing each other",
        "facing one another",
        "face to face",
        "nose to nose",
        "looking at each other",
        "staring at each other",
        "fighting each other",
        "kissing each other",
        "hugging each other",
        "talking to each other",
        "kissing",
    )
]
LYING: dict[str, Order] = {
    **{f"stacked {how}": "stack" for how in _EACH},
    **{f"piled {how}": "heap" for how in _EACH},
    **dict.fromkeys(("on top of each other", "on top of one another", "in a stack"), "stack"),
    **dict.fromkeys(("stacked",), "stack"),
    **dict.fromkeys(("piled", "in a pile", "in a heap"), "heap"),
    **dict.fromkeys(
        ("crossed over each other", "crossing each other", "crossed", "crossing"), "crossed"
    ),
    **dict.fromkeys(
        (
            "standing back to back",
            "sitting back to back",
            "back to back",
            "facing away from each other",
        ),
        "back to back",
    ),
    **dict.fromkeys(_FACING, "face to face"),
    **{
        f"{how}in a {form}": "circle"
        for form in ("circle", "ring")
        for how in ("arranged ", "standing ", "sitting ", "placed ", "set ", "")
    },
    **dict.fromkeys(("in a row", "in a line", "side by side", "next to each other"), "row"),
}
# Their plural names one thing, or the thing has several by itself.
SEVERAL = frozenset(
    """headphones trousers sunglasses scissors grapes fries pancakes maracas binoculars pliers
    goggles crystal popcorn salad ramen pawn wings horns antlers""".split()
) | {
    *("stack of books", "bamboo plant", "drum kit", "hay bale"),
    *("bat wings", "butterfly wings", "fairy wings", "devil horns", "ram horns"),
    *("cat ears", "fox ears", "bunny ears"),
}
# So does that of these, if no number is stated: one has them as one.
AS_ONE = SEVERAL | {
    *("staircase", "spiral staircase", "curtain", "bunk bed", "swing", "ladder", "fence", "wall"),
}
SAY_LITTLE = ("pair", "some", "bunch")  # of these
DOUBLE = frozenset(("cherry",))  # it is two on one stalk
PAIRED = frozenset("boot sneaker sandal sock glove".split()) | {
    *("high heel", "roller skate", "boxing glove"),
}
LOOSE = 0.6  # metres: longer things and living things are in no heap unless that is stated
BOXES = ("box", "boxes")
PORTIONS = {f"{one}s": one for one in ("slice", "piece", "wedge", "chunk", "segment", "section")}
RICHES = frozenset("gold treasure treasures riches loot".split())
COINS = ["golden", "coins"]
ALIKE = frozenset(
    """dice mice geese people cacti sheep deer oxen koi squid salmon moose teeth firewood sushi
    bacon""".split()
)
NO_PLURAL = ("ss", "us", "is", "lens", "gas", "christmas", "canvas")
# Right behind a number these are parts of the thing: "two headed dragons", "3 seater sofas".
OF_PARTS = frozenset(
    """tone toned story storey storied seater tier tiers tiered piece pack player way speed door
    wheel wheeled leg legged string stringed karat carat year page sided pointed headed eyed eared
    horned winged handed armed footed tailed masted engine barrel barreled fingered toed ply
    layer layered""".split()
)
WITHIN = 6  # words from the number to the name, at most
# One of these fills a bowl.
IN_ONE_HEAP = frozenset(("grapes", "hay bale"))
PORTION = "five"  # of food on a plate


def number_of(word: str) -> int:
    """The number of a part's components that a word states; 0: none."""
    if word in ONE:
        return 1
    if word.isascii() and word.isdigit() and len(word) < 3:
        return int(word) if int(word) <= MOST_PARTS else 0
    number = FIGURES.get(word, 0)
    return number if number <= MOST_PARTS else 0
