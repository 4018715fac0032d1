"""Values of the colour words in sRGB. Standard library only.

The networks know the eighteen words of ``COLOR_VALUES``; the texture is painted in the exact shade.
"""

from core.guidance.builtin.words.tables.words import COLORS

Color = tuple[float, float, float]

COLOR_VALUES: dict[str, Color] = {
    "red": (0.80, 0.06, 0.06),
    "orange": (0.95, 0.45, 0.05),
    "yellow": (0.95, 0.82, 0.10),
    "green": (0.12, 0.55, 0.15),
    "cyan": (0.10, 0.70, 0.75),
    "blue": (0.10, 0.20, 0.75),
    "purple": (0.45, 0.12, 0.65),
    "pink": (0.95, 0.45, 0.65),
    "brown": (0.42, 0.24, 0.12),
    "black": (0.05, 0.05, 0.05),
    "white": (0.92, 0.92, 0.90),
    "grey": (0.48, 0.48, 0.49),
    "dark red": (0.45, 0.04, 0.08),
    "dark green": (0.04, 0.28, 0.12),
    "navy": (0.05, 0.08, 0.32),
    "light blue": (0.50, 0.75, 0.95),
    "lime": (0.55, 0.82, 0.15),
    "beige": (0.85, 0.76, 0.60),
}
# Shades with names of their own, by the word that the networks know.
SHADES: dict[str, dict[str, str]] = {
    "red": {
        "neon red": "ff2a3c",
        "bright red": "e01414", "cherry red": "b3122a", "crimson": "a80f2b", "scarlet": "d8210c",
        "ruby red": "9b111e", "blood red": "7c0a0a", "vermilion": "e0402c", "brick red": "9c3a2c",
        "tomato red": "d8402a", "coral red": "e5533f", "rust red": "97412a",
        "raspberry red": "b3204a", "candy red": "d2122e", "fire engine red": "ce2029",
        "strawberry red": "cf2b3a", "rose red": "c21e4f", "poppy red": "dd2c1e",
        "cardinal red": "b01030", "signal red": "c4161c", "pillar box red": "c8141e",
        "post office red": "c8141e", "ferrari red": "e01a10", "candy apple red": "c0101c",
        "copper red": "a84a2c", "mahogany red": "6e2018", "fluorescent red": "ff2a3c",
        "reddish": "b8423a", "orange red": "e8401f", "red orange": "e8401f",
        "reddish orange": "e8401f",
    },
    "orange": {
        "neon orange": "ff7a14",
        "bright orange": "ff7a0a", "burnt orange": "c1541b", "amber": "e09a20",
        "rust orange": "b1521c", "tangerine orange": "f28500", "apricot orange": "f5a86a",
        "pumpkin orange": "ee7a1e", "carrot orange": "ed8128", "safety orange": "ff6a00",
        "coral orange": "ff7f50", "peach orange": "fbb27c", "ginger": "c8702a",
        "fluorescent orange": "ff7a14", "hi vis orange": "ff6a00", "high vis orange": "ff6a00",
        "rust coloured": "b1521c", "rust colored": "b1521c", "yellow orange": "f5a01e",
        "orange yellow": "f5a01e", "yellowish orange": "f5a01e", "peach coloured": "fbb27c",
        "peach colored": "fbb27c", "coral coloured": "ff7f50", "coral colored": "ff7f50",
    },
    "yellow": {
        "neon yellow": "eaff1f",
        "bright yellow": "ffe01a", "lemon yellow": "f4e04d", "golden yellow": "f5b81f",
        "mustard": "cc9a22", "mustard yellow": "cc9a22", "canary yellow": "ffe733",
        "saffron": "f0b32a", "ochre": "c08030", "sunny yellow": "ffd42a",
        "honey yellow": "e8a628", "butter yellow": "f7e08a", "banana yellow": "ffe135",
        "fluorescent yellow": "eaff1f", "hi vis yellow": "e6ff1f", "high vis yellow": "e6ff1f",
        "traffic yellow": "f6c000", "taxi yellow": "f7b500", "school bus yellow": "f5a800",
        "sunflower yellow": "f9c22b", "primrose yellow": "f3e58a", "corn yellow": "f2d35a",
        "gold yellow": "f5b81f", "lime yellow": "dfe62a",
        "yellowish": "d9c05a", "sulphur yellow": "e6e03a", "mustard coloured": "cc9a22",
        "mustard colored": "cc9a22", "honey coloured": "e8a628", "honey colored": "e8a628",
    },
    "green": {
        "bright green": "1fb82a", "grass green": "4d9a2a", "olive": "6b7a2a",
        "olive green": "6b7a2a", "emerald": "0f8f56", "emerald green": "0f8f56",
        "sea green": "2e8b57", "jade green": "2aa06b", "moss green": "6b7a3a",
        "leaf green": "4f9a35", "army green": "4b5320", "sage green": "9caf88", "sage": "9caf88",
        "apple green": "8db600", "seafoam green": "9fe2bf", "seafoam": "9fe2bf",
        "fern green": "4f7942", "kelly green": "4cbb17", "avocado green": "568203",
        "military green": "4b5320", "olive drab": "5a5a2c", "drab green": "5a5a2c",
        "camo green": "56602e", "camouflage green": "56602e", "khaki green": "7c7a4c",
        "khaki drab": "6b6a40", "dark olive": "4a5320", "jungle green": "2a6a3a",
        "pea green": "8a9a3a", "bronze green": "4a5230", "teal green": "0a6e5e",
        "shamrock green": "1a9a56", "spring green": "5ad06a", "clover green": "2f8a3a",
        "eucalyptus green": "7f9f88", "swamp green": "5a5f34", "tractor green": "2f7a2f",
        "pool table green": "14693c", "greenish": "6a9a70", "yellow green": "9ac232",
        "yellowish green": "9ac232", "green yellow": "9ac232", "grey green": "7d8a7d",
        "gray green": "7d8a7d", "green grey": "7d8a7d", "green gray": "7d8a7d",
        "greenish grey": "7d8a7d", "greenish gray": "7d8a7d", "greyish green": "7d8a7d",
        "grayish green": "7d8a7d",
    },
    "cyan": {
        "turquoise": "30c5c0", "teal": "0d7f80", "aqua": "3fd0d4", "aquamarine": "7fe0cf",
        "mint": "a3dcc0", "mint green": "a3dcc0", "teal blue": "157a90",
        "turquoise blue": "2abfd4", "turquoise green": "30c5a4", "aqua blue": "3fd0d4",
        "aqua green": "4fd0b4", "mint blue": "a8dcd8", "tiffany blue": "66c8c0",
        "peacock blue": "0f6f86", "lagoon blue": "2a9fb0", "blue green": "0f8a8a",
        "green blue": "0f8a8a", "bluish green": "0f8a7a", "greenish blue": "0f7f96",
    },
    "blue": {
        "neon blue": "2e6bff",
        "bright blue": "1f4cff", "royal blue": "2a4fc0", "cobalt blue": "0f47ab",
        "cobalt": "0f47ab", "slate blue": "5f6ea8", "electric blue": "2b6cff",
        "sapphire blue": "1438a0", "azure": "2a7fe0", "steel blue": "4682b4",
        "silver blue": "9db2c6",
        "cerulean": "2a7fb8", "ocean blue": "1f6a9c", "denim blue": "3a5580",
        "cornflower blue": "6495ed", "duck egg blue": "b8dcd4", "periwinkle": "9aa5e8",
        "periwinkle blue": "9aa5e8", "seafoam blue": "7fc4c8", "fluorescent blue": "2e6bff",
        "cornflower": "6495ed", "ultramarine": "1f2fa0", "ultramarine blue": "1f2fa0",
        "lapis blue": "1f3fa0", "french blue": "3f6fb8", "marine blue": "1a3f7a",
        "indigo blue": "2f2f8a", "bluish": "5a7fb0", "police blue": "1f3f8a",
        "air force blue": "5d7f9f", "wedgwood blue": "7a98c0", "delft blue": "1f4a90",
        "royal navy blue": "14285a",
        "violet blue": "4a3fc0", "blue violet": "4a3fc0", "purple blue": "4a3fc0",
        "purplish blue": "4a3fc0",
    },
    "purple": {
        "neon purple": "b32cff",
        "violet": "7a3fc0", "lilac": "c0a0d8", "lavender": "b8a4e0", "indigo": "3f1f8f",
        "mauve": "a8799a", "royal purple": "5a2a96", "aubergine purple": "3f1a3c",
        "plum purple": "6a2a5a", "grape purple": "5c2d82", "eggplant purple": "3f1a3c",
        "violet purple": "6f38b0", "lavender purple": "a088d8", "lilac purple": "b890d0",
        "amethyst purple": "8a5ac0", "heather purple": "9a7fa8",
        "purplish": "8a5f9a", "bluish purple": "5a3fc0", "pinkish purple": "a04aa8",
        "reddish purple": "84286a", "plum coloured": "6a2a5a", "plum colored": "6a2a5a",
    },
    "pink": {
        "neon pink": "ff3cac",
        "light red": "f08080", "rose pink": "e8799a", "hot pink": "ff3f9a", "barbie pink": "e0218a",
        "magenta": "d0207f",
        "fuchsia": "e0208f", "baby pink": "f6c2d0", "blush": "e8b4b8", "blush pink": "e8b4b8",
        "dusty pink": "cf9a9e", "salmon pink": "f58f7c", "coral pink": "f57f6c",
        "bubblegum pink": "ff8fc0", "flamingo pink": "fc8eac", "candy pink": "f57fa8",
        "bubble gum pink": "ff8fc0", "dusty rose": "c48a8a", "dusky pink": "c98f92",
        "powder pink": "f2d0d4", "peach pink": "f8b0a0", "strawberry pink": "f2688a",
        "watermelon pink": "f4596f", "cerise": "c8246a", "cerise pink": "d8306f",
        "magenta pink": "d8308f", "shell pink": "f4d0c4", "pinkish": "d89aa8",
        "fluorescent pink": "ff3cac", "shocking pink": "ff2f9a", "millennial pink": "eec0bc",
        "salmon coloured": "f58f7c", "salmon colored": "f58f7c", "purplish pink": "d070b8",
        "skin coloured": "e4b592", "skin colored": "e4b592", "flesh coloured": "e4b592",
        "flesh colored": "e4b592",
    },
    "brown": {
        "chocolate brown": "3f2416", "light brown": "a97c50", "chestnut": "6f3a22",
        "chestnut brown": "6f3a22", "cognac": "8f4a22", "caramel": "b8742e",
        "coffee brown": "4b3020", "golden brown": "b07a35", "umber": "5c4030", "sienna": "a0522d",
        "burnt umber": "6b3520", "burnt sienna": "a84a24",
        "mocha": "6b4a3a", "walnut brown": "5d4030", "rust brown": "7a3f20",
        "camel brown": "c19a6b", "mocha brown": "6b4a3a", "espresso brown": "3a2418",
        "nut brown": "7a4a28", "hazelnut brown": "94653c", "tobacco brown": "7a5230",
        "mud brown": "5c4630", "muddy brown": "5c4630", "earth brown": "5e4530",
        "dirt brown": "5e4530", "bark brown": "54402e", "sandy brown": "c8985e",
        "caramel brown": "b8742e", "toffee brown": "9a5f2c", "fawn brown": "b48a60",
        "mahogany brown": "5a2418", "sepia": "704c2e", "russet": "80461b",
        "russet brown": "80461b", "auburn": "7a3420", "hazel": "8a6a2c", "tawny": "b07236",
        "tawny brown": "b07236", "reddish brown": "7f3a22", "red brown": "7f3a22",
        "brown red": "7f3a22",
        "brownish red": "7f3a22", "yellowish brown": "a07a3c", "yellow brown": "a07a3c",
        "orange brown": "9a5424", "grey brown": "75675a", "gray brown": "75675a",
        "greyish brown": "75675a", "grayish brown": "75675a", "brownish": "8a6a50",
        "brownish grey": "75675a", "brownish gray": "75675a", "brown grey": "75675a",
        "brown gray": "75675a",
    },
    "black": {
        "jet black": "060606", "coal black": "121212", "pitch black": "050505",
        "raven black": "0a0a0e", "midnight black": "0b0b10", "ink black": "0a0a12",
        "onyx black": "0a0a0c", "ebony black": "141110", "piano black": "040404",
        "carbon black": "131313", "soot black": "161514", "off black": "1e1e1f",
        "blackish": "242424",
    },
    "white": {
        "snow white": "f7f7f7", "off white": "efe9dc", "pearl white": "f1ede4",
        "bone white": "e8e0cc", "eggshell white": "f0ead6", "pure white": "fafafa",
        "ivory white": "f4eedd", "milk white": "f6f3ea", "milky white": "f6f3ea",
        "chalk white": "f3f2ee", "chalky white": "f3f2ee", "antique white": "f0e6d4",
        "alabaster white": "f0ebe0", "cotton white": "f5f4f0", "porcelain white": "f2f2ee",
        "cream white": "f6eed8", "creamy white": "f6eed8", "paper white": "f4f3ee",
        "brilliant white": "fbfbfb", "whitewashed": "f1efe8", "white washed": "f1efe8",
        "whitewash": "f1efe8", "lime washed": "efece2", "limewashed": "efece2",
        "whitish": "e2e0da", "yellowish white": "f2ead0", "pinkish white": "f4e4e2",
        "silver white": "e6e8ea", "ghost white": "f4f5f8",
    },
    "grey": {
        "slate grey": "6b7684", "slate coloured": "6b7684",
        "slate colored": "6b7684", "charcoal": "36393d", "charcoal grey": "36393d",
        "anthracite": "2f3236", "silver grey": "b0b4b8",
        "ash grey": "a8aaa6", "taupe": "8a7d70",
        "dove grey": "a9a9a6", "gunmetal grey": "53565b", "graphite": "3a3c3f",
        "graphite grey": "3a3c3f", "space grey": "55585c", "stone grey": "8f8c84",
        "steel grey": "71797e", "iron grey": "5a5c5f", "pewter grey": "8b8f90",
        "smoke grey": "84868a", "smoky grey": "84868a", "battleship grey": "7f8582",
        "concrete grey": "95948f", "elephant grey": "7d7b78", "pearl grey": "c4c4c0",
        "navy grey": "4a5468", "anthracite grey": "2f3236", "storm grey": "5c636b",
        "greyish": "8c8c8e", "grayish": "8c8c8e", "blue grey": "76879a",
        "bluish grey": "76879a", "greyish blue": "76879a", "grey blue": "76879a",
    },
    "dark red": {
        "maroon": "5c0f1f", "burgundy": "6a1027", "wine red": "5f0f22", "oxblood": "4f0c0e",
        "bordeaux": "5a0f24", "ox blood": "4f0c0e", "oxblood red": "4f0c0e",
        "ox blood red": "4f0c0e", "burgundy red": "6a1027", "maroon red": "5c0f1f",
        "wine coloured": "5f0f22", "wine colored": "5f0f22", "claret": "6a1428",
        "garnet red": "6f1a24",
    },
    "dark green": {
        "forest green": "1f5c2a", "bottle green": "0b3d2a", "hunter green": "355e3b",
        "british racing green": "0b4028", "racing green": "0b4028", "pine green": "12503f",
        "british green": "0b4028", "deep forest green": "123f1e", "spruce green": "1f4a3a",
        "dark forest green": "123f1e", "dark olive green": "4a5320", "ivy green": "2c4f2a",
        "christmas green": "14532a", "holly green": "14532a",
    },
    "navy": {
        "midnight blue": "14183f", "petrol blue": "0b4458", "oxford blue": "0a1f44",
        "prussian blue": "0c2f4c", "ink blue": "141f48", "nautical blue": "12285a",
    },
    "light blue": {
        "pale blue": "b8d8ee", "sky blue": "87ceeb", "baby blue": "a8d4f0",
        "powder blue": "b0d8e6", "ice blue": "c8e8f4", "arctic blue": "cfeaf2",
        "glacier blue": "bfe0ec", "icy blue": "c8e8f4", "robin egg blue": "8fd8d8",
        "robins egg blue": "8fd8d8",
    },
    "lime": {
        "lime green": "8ed31f", "light green": "98d88a", "pale green": "b4dca4",
        "neon green": "5cff2a", "chartreuse": "b5e61d", "pistachio green": "a9c77a",
        "pistachio": "a9c77a", "fluorescent green": "5cff2a", "acid green": "a8d81a",
        "toxic green": "6fe01a", "slime green": "7fd81a", "lemon green": "b8d83a",
    },
    "beige": {
        "cream": "f3e6c4", "cream coloured": "f3e6c4", "cream colored": "f3e6c4",
        "ivory": "f0e8d4", "ivory coloured": "f0e8d4", "ivory colored": "f0e8d4",
        "tan": "c8a070", "khaki": "b8a97c", "sand coloured": "d8c08c", "sand colored": "d8c08c",
        "champagne": "ead6ae", "wheat coloured": "e0c890", "wheat colored": "e0c890",
        "sand beige": "d8c4a0", "sandy beige": "d8c4a0", "ecru": "d9cba8", "eggshell": "f0ead6",
        "eggshell coloured": "f0ead6", "eggshell colored": "f0ead6", "oatmeal coloured": "d8cab0",
        "biscuit coloured": "dcc09a", "biscuit colored": "dcc09a",
        "camel coloured": "c19a6b", "camel colored": "c19a6b", "straw coloured": "dcc37a",
        "straw colored": "dcc37a", "bone coloured": "e4d9c0",
        "bone colored": "e4d9c0",
        "blonde": "e3c37a", "blond": "e3c37a",
    },
}  # fmt: skip
# Things whose names are also shades before another name: "a peach armchair".
CALLED_SHADES = {
    "peach": "peach orange", "coral": "coral orange", "salmon": "salmon pink",
    "apricot": "apricot orange", "tangerine": "tangerine orange", "plum": "plum purple",
    "aubergine": "aubergine purple", "eggplant": "eggplant purple", "lemon": "lemon yellow",
    "raspberry": "raspberry red", "camel": "camel brown", "espresso": "espresso brown",
    "rose": "rose pink", "orchid": "lilac",
}  # fmt: skip
# Flavours of ice cream.
TASTES = {
    "strawberry": "strawberry pink", "vanilla": "cream white", "cherry": "cherry red",
    "chocolate": "chocolate brown", "coffee": "mocha", "coconut": "pure white",
    "banana": "butter yellow", "blueberry": "lavender", "mango": "apricot orange",
    "lemon": "lemon yellow", "peach": "peach orange", "raspberry": "raspberry red",
    "hazelnut": "light brown",
}  # fmt: skip
RAINBOW = "rainbow"
# Many colours; the network knows them as the first of these.
MANY_COLORS = (
    *(RAINBOW, "rainbow coloured", "rainbow colored", "rainbow colors", "rainbow colours"),
    *("multicolored", "multicoloured", "multi colored", "multi coloured", "multicolor"),
    *("multicolour", "multi color", "multi colour", "colorful", "colourful", "many colored"),
)
SHADES["red"] |= dict.fromkeys(MANY_COLORS, "dc1a1f")
SHADES["grey"] |= {form.replace("grey", "gray"): rgb for form, rgb in SHADES["grey"].items()}
_RGB = {form: value for shades in SHADES.values() for form, value in shades.items()}
LIGHT, DARK = COLOR_VALUES["white"], COLOR_VALUES["black"]
# Before a colour: how far it moves to black or to white.
TOWARDS: dict[str, tuple[Color, float]] = {
    "dark": ((0.0, 0.0, 0.0), 0.5),
    "deep": ((0.0, 0.0, 0.0), 0.3),
    "light": ((1.0, 1.0, 1.0), 0.45),
    "pale": ((1.0, 1.0, 1.0), 0.55),
    "pastel": ((1.0, 1.0, 1.0), 0.55),
    "soft": ((1.0, 1.0, 1.0), 0.3),
    "bright": ((0.0, 0.0, 0.0), 0.0),
    "vivid": ((0.0, 0.0, 0.0), 0.0),
}
OF_MATERIALS = ("dark", "deep", "light", "pale")  # soft leather is no lighter


def shade(word: str, form: str) -> str:
    """``form`` if it is another shade than the word's own; else ""."""
    return form if color_value(word, form) != COLOR_VALUES[word] else ""


def color_value(word: str, form: str = "") -> Color:
    """The value of a colour word; ``form``: as written, such as "dark teal" for cyan."""
    tone, _, rest = form.partition(" ")
    if form in _RGB:
        red, green, blue = (int(_RGB[form][i : i + 2], 16) / 255 for i in (0, 2, 4))
        return red, green, blue
    if tone not in TOWARDS or not rest or form in (word, *COLORS[word].split(", ")):
        return COLOR_VALUES[word]
    return toned(color_value(word, rest), tone)


def luma(color: Color) -> float:
    """The lightness of a colour in [0, 1]: Rec. 601, rounded."""
    red, green, blue = color
    return 0.3 * red + 0.6 * green + 0.1 * blue


def rainbow_tone(form: str) -> str | None:
    """The tone of a form for many colours, "" without one, such as that of pastel rainbow; None for
    other forms."""
    tone, _, rest = form.partition(" ")
    if form in MANY_COLORS:
        return ""
    return tone if tone in TOWARDS and rest in MANY_COLORS else None


def toned(color: Color, tone: str) -> Color:
    """The colour changed by a tone word."""
    end, way = TOWARDS[tone]
    red, green, blue = (c + way * (e - c) for c, e in zip(color, end, strict=True))
    return red, green, blue
