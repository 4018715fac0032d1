"""What the words of colour look like, in sRGB, the way one picks it. Standard library only.

The networks know the eighteen words of ``COLOR_VALUES``; the texture is painted in the very shade.
"""

from core.guidance.builtin.words import COLORS

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
# The shades that have names of their own, by the word that the networks know them by.
SHADES: dict[str, dict[str, str]] = {
    "red": {
        "neon red": "ff2a3c",
        "bright red": "e01414", "cherry red": "b3122a", "crimson": "a80f2b", "scarlet": "d8210c",
        "ruby red": "9b111e", "blood red": "7c0a0a", "vermilion": "e0402c", "brick red": "9c3a2c",
        "tomato red": "d8402a", "coral red": "e5533f", "rust red": "97412a",
        "raspberry red": "b3204a", "candy red": "d2122e", "fire engine red": "ce2029",
        "strawberry red": "cf2b3a", "rose red": "c21e4f",
    },
    "orange": {
        "neon orange": "ff7a14",
        "bright orange": "ff7a0a", "burnt orange": "c1541b", "amber": "e09a20",
        "rust orange": "b1521c", "tangerine orange": "f28500", "apricot orange": "f5a86a",
        "pumpkin orange": "ee7a1e", "carrot orange": "ed8128", "safety orange": "ff6a00",
        "coral orange": "ff7f50", "peach orange": "fbb27c", "ginger": "c8702a",
    },
    "yellow": {
        "neon yellow": "eaff1f",
        "bright yellow": "ffe01a", "lemon yellow": "f4e04d", "golden yellow": "f5b81f",
        "mustard": "cc9a22", "mustard yellow": "cc9a22", "canary yellow": "ffe733",
        "saffron": "f0b32a", "ochre": "c08030", "sunny yellow": "ffd42a",
        "honey yellow": "e8a628", "butter yellow": "f7e08a", "banana yellow": "ffe135",
    },
    "green": {
        "bright green": "1fb82a", "grass green": "4d9a2a", "olive": "6b7a2a",
        "olive green": "6b7a2a", "emerald": "0f8f56", "emerald green": "0f8f56",
        "sea green": "2e8b57", "jade green": "2aa06b", "moss green": "6b7a3a",
        "leaf green": "4f9a35", "army green": "4b5320", "sage green": "9caf88", "sage": "9caf88",
        "apple green": "8db600", "seafoam green": "9fe2bf", "seafoam": "9fe2bf",
        "fern green": "4f7942", "kelly green": "4cbb17", "avocado green": "568203",
    },
    "cyan": {
        "turquoise": "30c5c0", "teal": "0d7f80", "aqua": "3fd0d4", "aquamarine": "7fe0cf",
        "mint": "a3dcc0", "mint green": "a3dcc0",
    },
    "blue": {
        "neon blue": "2e6bff",
        "bright blue": "1f4cff", "royal blue": "2a4fc0", "cobalt blue": "0f47ab",
        "cobalt": "0f47ab", "slate blue": "5f6ea8", "electric blue": "2b6cff",
        "sapphire blue": "1438a0", "azure": "2a7fe0", "steel blue": "4682b4",
        "silver blue": "9db2c6",
        "cerulean": "2a7fb8", "ocean blue": "1f6a9c", "denim blue": "3a5580",
        "cornflower blue": "6495ed", "duck egg blue": "b8dcd4", "periwinkle": "9aa5e8",
        "periwinkle blue": "9aa5e8", "seafoam blue": "7fc4c8",
    },
    "purple": {
        "neon purple": "b32cff",
        "violet": "7a3fc0", "lilac": "c0a0d8", "lavender": "b8a4e0", "indigo": "3f1f8f",
        "mauve": "a8799a", "royal purple": "5a2a96", "aubergine purple": "3f1a3c",
        "plum purple": "6a2a5a", "grape purple": "5c2d82", "eggplant purple": "3f1a3c",
    },
    "pink": {
        "neon pink": "ff3cac",
        "light red": "f08080", "rose pink": "e8799a", "hot pink": "ff3f9a", "barbie pink": "e0218a",
        "magenta": "d0207f",
        "fuchsia": "e0208f", "baby pink": "f6c2d0", "blush": "e8b4b8", "blush pink": "e8b4b8",
        "dusty pink": "cf9a9e", "salmon pink": "f58f7c", "coral pink": "f57f6c",
        "bubblegum pink": "ff8fc0", "flamingo pink": "fc8eac", "candy pink": "f57fa8",
    },
    "brown": {
        "chocolate brown": "3f2416", "light brown": "a97c50", "chestnut": "6f3a22",
        "chestnut brown": "6f3a22", "cognac": "8f4a22", "caramel": "b8742e",
        "coffee brown": "4b3020", "golden brown": "b07a35", "umber": "5c4030", "sienna": "a0522d",
        "mocha": "6b4a3a", "walnut brown": "5d4030", "rust brown": "7a3f20",
        "camel brown": "c19a6b",
    },
    "black": {"jet black": "060606", "coal black": "121212", "pitch black": "050505"},
    "white": {
        "snow white": "f7f7f7", "off white": "efe9dc", "pearl white": "f1ede4",
        "bone white": "e8e0cc", "eggshell white": "f0ead6", "pure white": "fafafa",
    },
    "grey": {
        "slate grey": "6b7684", "slate coloured": "6b7684",
        "slate colored": "6b7684", "charcoal": "36393d", "charcoal grey": "36393d",
        "anthracite": "2f3236", "silver grey": "b0b4b8",
        "ash grey": "a8aaa6", "taupe": "8a7d70",
        "dove grey": "a9a9a6", "gunmetal grey": "53565b", "graphite": "3a3c3f",
        "graphite grey": "3a3c3f", "space grey": "55585c",
    },
    "dark red": {
        "maroon": "5c0f1f", "burgundy": "6a1027", "wine red": "5f0f22", "oxblood": "4f0c0e",
        "bordeaux": "5a0f24",
    },
    "dark green": {
        "forest green": "1f5c2a", "bottle green": "0b3d2a", "hunter green": "355e3b",
        "british racing green": "0b4028", "racing green": "0b4028", "pine green": "12503f",
    },
    "navy": {"midnight blue": "14183f", "petrol blue": "0b4458"},
    "light blue": {
        "pale blue": "b8d8ee", "sky blue": "87ceeb", "baby blue": "a8d4f0",
        "powder blue": "b0d8e6", "ice blue": "c8e8f4",
    },
    "lime": {
        "lime green": "8ed31f", "light green": "98d88a", "pale green": "b4dca4",
        "neon green": "5cff2a", "chartreuse": "b5e61d", "pistachio green": "a9c77a",
    },
    "beige": {
        "cream": "f3e6c4", "cream coloured": "f3e6c4", "cream colored": "f3e6c4",
        "ivory": "f0e8d4", "ivory coloured": "f0e8d4", "ivory colored": "f0e8d4",
        "tan": "c8a070", "khaki": "b8a97c", "sand coloured": "d8c08c", "sand colored": "d8c08c",
        "champagne": "ead6ae", "wheat coloured": "e0c890", "wheat colored": "e0c890",
        "blonde": "e3c37a", "blond": "e3c37a",
    },
}  # fmt: skip
RAINBOW = "rainbow"
# Of many colours; the network knows them as the first of these.
MANY_COLORS = (
    *(RAINBOW, "rainbow coloured", "rainbow colored", "rainbow colors", "rainbow colours"),
    *("multicolored", "multicoloured", "multi colored", "multi coloured", "multicolor"),
    *("multicolour", "multi color", "multi colour"),
)
SHADES["red"] |= dict.fromkeys(MANY_COLORS, "dc1a1f")
SHADES["grey"] |= {form.replace("grey", "gray"): rgb for form, rgb in SHADES["grey"].items()}
_RGB = {form: value for shades in SHADES.values() for form, value in shades.items()}
LIGHT, DARK = COLOR_VALUES["white"], COLOR_VALUES["black"]
# Before a colour: how far it is then on the way to black, or to white.
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
    """``form``, where it is another shade than the word's own; else ""."""
    return form if color_value(word, form) != COLOR_VALUES[word] else ""


def color_value(word: str, form: str = "") -> Color:
    """What a colour word looks like; ``form``: as it was written, such as "dark teal" for cyan."""
    tone, _, rest = form.partition(" ")
    if form in _RGB:
        red, green, blue = (int(_RGB[form][i : i + 2], 16) / 255 for i in (0, 2, 4))
        return red, green, blue
    if tone not in TOWARDS or not rest or form in (word, *COLORS[word].split(", ")):
        return COLOR_VALUES[word]
    return toned(color_value(word, rest), tone)


def luma(color: Color) -> float:
    """How light a colour is, in [0, 1]: Rec.601's, rounded."""
    red, green, blue = color
    return 0.3 * red + 0.6 * green + 0.1 * blue


def rainbow_tone(form: str) -> str | None:
    """The tone of a form that means many colours, "" without one: of pastel rainbow; else None."""
    tone, _, rest = form.partition(" ")
    if form in MANY_COLORS:
        return ""
    return tone if tone in TOWARDS and rest in MANY_COLORS else None


def toned(color: Color, tone: str) -> Color:
    """The colour with a tone's word before it."""
    end, way = TOWARDS[tone]
    red, green, blue = (c + way * (e - c) for c, e in zip(color, end, strict=True))
    return red, green, blue
