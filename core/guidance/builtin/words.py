"""The words of the built-in prior, as data.

The order within a table is that of the networks' embeddings; new words go to the end.
"""

# A row's text has two parts. Before the semicolon: other names of the same thing, of which nothing
# is reported. After it: narrower or neighbouring things, which are made as the row's word; a note
# states that.

SHAPES = {
    "tall": "lofty",
    "flat": "flattened; low, short, squat",
    "wide": "broad; long",
    "thick": "chunky, bulky, stout, fat",
    "thin": "slim, narrow, slender; shallow",
    "round": "rounded, circular; chubby, plump",
}
COLORS = {
    "red": "bright red; cherry red, crimson, scarlet, ruby red, blood red",
    "orange": "bright orange",
    "yellow": "bright yellow; lemon yellow, golden yellow",
    "green": "bright green; grass green, olive, emerald",
    "cyan": "; turquoise, teal",
    "blue": "bright blue; royal blue, cobalt blue, slate blue",
    "purple": "violet; lilac, lavender, indigo",
    "pink": "light red; rose pink, magenta, fuchsia",
    "brown": "; chocolate brown, light brown, chestnut, cognac, ochre, amber",
    "black": "jet black, coal black",
    "white": "snow white",
    "grey": "gray; slate grey, slate gray, slate coloured, slate colored",
    "dark red": "; maroon, burgundy, wine red",
    "dark green": "; forest green, bottle green",
    "navy": "navy blue, dark blue; midnight blue",
    "light blue": "pale blue; sky blue, baby blue",
    "lime": "lime green; light green, pale green",
    "beige": "; cream, cream coloured, cream colored, ivory, tan",
}
MATERIALS = {
    "wooden": "wood, timber; oak, walnut, bamboo, mahogany, wicker, rattan",
    "metal": "polished metal, shiny metal, metallic, polished; brushed metal, brushed steel, "
    "brushed aluminium, brushed aluminum, steel, iron, silver, silvery, cast iron, chrome, "
    "aluminium, aluminum, polished steel",
    "golden": "gold, polished gold; gold leaf, gilded, brass, polished brass",
    "plastic": "",
    "rubber": "",
    "stone": "rock; marble, granite, concrete, brick, sandstone, slate",
    "rusty": "rusty metal, rusted, rusted metal, rusty iron, rusty steel, rust, corroded",
    "ceramic": "porcelain, china, glazed, glazed ceramic; clay, terracotta",
    "leather": "; suede",
    "glass": "glassy, glass like; glossy, crystal glass, crystalline",
    "copper": "polished copper; bronze",
    "fabric": "cloth, textile, upholstered; felt, wool, woollen, woolen, velvet, cotton, silk, "
    "denim, knitted, knit, woven, plush, fur, furry, fluffy",
}
# Names of things that say that they are of glass, where no material is stated.
GLASSWARE = frozenset(
    (
        "wine glass, wineglass, glass of wine, glass of water, glass of milk, champagne flute, "
        "champagne glass, cocktail, martini, martini glass, cocktail glass, drinking glass, pint "
        "of beer, glass of beer, fishbowl, fish bowl, goldfish bowl, decanter"
    ).split(", ")
)
# What time has done to it, which is seen at the bake.
WEATHERS = {
    "worn": "weathered, scratched, shabby, old, antique, ancient, rustic, worn out, well worn, "
    "distressed",
    "dirty": "grimy, muddy, filthy, grungy, covered in mud, covered in dirt, covered with mud",
    "dusty": "dust covered, covered in dust, covered with dust",
    "mossy": "moss covered, overgrown, covered in moss, covered with moss",
    "snowy": "snow covered, covered in snow, covered with snow, snow capped, frosty",
}
PATTERNS = {
    "striped": "stripe, stripy, stripey, banded",
    "spotted": "spot, spotty, dotted, dot, polka dot, polka dotted",
    "checkered": "checked, chequered, checkerboard, check; plaid, tartan",
    "two-tone": "two tone, two toned, two coloured, two colored, bicolor, bicolour",
}
# The names of the parts that a caption may state (``CHOICES`` and ``LEGS``).
PART_WORDS = {
    "armrests": "armrest, arm, arm rest, arm rests",
    "backrest": "back, back rest",
    "handle": "ear",
    "cap": "lid, cork, stopper",
    "hat": "top hat",
    "chimney": "",
    "one leg": "single leg, pedestal, one foot",
    "three legs": "3 legs, three legged, 3 legged",
    "four legs": "4 legs, four legged, 4 legged",
}
# Words for the parts that a noun always has: they change nothing but where a colour goes.
PART_SYNONYMS = {
    "legs": "leg, feet, foot",
    "wheels": "wheel, tyres, tyre, tires, tire",
    "windows": "window",
    "cushion": "seat, cushions",
    "scoop": "scoops",
    "shade": "lampshade",
    "leaves": "leaf, foliage",
    "sails": "sail",
    "icing": "frosting",
    "wings": "wing",
    "fins": "fin, flippers, flipper",
    "stem": "stalk",
    "tray": "pot",
    "grip": "hilt",
    "guard": "crossguard",
    "lamps": "headlights, headlight",
    "body": "scales, scale, plumage",
    "handles": "handle, ears",
    "bill": "beak",
    "claws": "claw, pincers, pincer",
    "antlers": "antler",
}
# Where something else stands: "a cottage by a lake".
PLACES = frozenset(
    """by at near beside behind under inside above against between over through along across around
    down into onto below among""".split()
)
# What people write around the subject and what describes nothing of it.
FILLER = PLACES | frozenset(
    """a an the of in on with and is it its one single some made from out color colour colored
    coloured photo photograph picture image render rendering rendered dslr 3d 3 d cg model object
    highly very detailed high quality hd 4k 8k hdr realistic photorealistic beautiful nice
    simple studio lighting isolated background view please style shape cute small little big large
    shaped asset game ready material s has have that which for texture textured pattern patterned
    pair bunch slice piece wearing holding new classic modern traditional elegant
    lovely pretty statuette carving replica""".split()
)
# Fillers that end a noun phrase: what is unknown before them describes no noun after them.
PHRASE_ENDS = PLACES | frozenset(
    """a an the of in on with and is it its made from out has have which that wearing
    holding""".split()
)
# Of them those after which something else may come that goes with the thing: "a vase of flowers".
GOES_WITH = PLACES | frozenset("of in on with has have wearing holding from".split())
# After these all is about something else: a chest full of gold is not golden.
OF_ANOTHER = (
    "for",
    "worn by",
    "used for",
    "filled with",
    "full of",
    "surrounded by",
    "in front of",
    "on top of",
    "next to",
)
# How many there are. One is made, and a note says so.
COUNTS = frozenset(
    """two three four five six seven eight nine ten twelve dozen dozens several many few couple
    multiple various set pile heap stack group row collection pack bundle""".split()
)
# How the picture or the mesh is wanted, of which a shape and its materials know nothing.
STYLES = frozenset(
    """hyperrealistic photoreal intricate masterpiece pbr voxel toon anime octane unreal isometric
    cinematic ultra""".split()
) | {
    *("low poly", "high poly", "pixel art", "voxel art", "concept art", "digital art"),
    *("octane render", "blender render", "cycles render", "unreal engine", "unreal engine 5"),
    *("ray traced", "ray tracing", "trending on artstation", "best quality", "depth of field"),
    *("white background", "black background", "plain background", "transparent background"),
    *("full body", "close up", "front view", "side view", "top view", "cinematic lighting"),
}
# Adjectives of age, finish or mood. They name no thing, so a prompt is accepted without them.
IGNORED_ADJECTIVES = frozenset(
    """vintage retro medieval victorian baroque ornate
    cozy cosy comfy comfortable soft sturdy heavy matte matt satin glowing shining clean
    fresh ripe juicy tasty delicious funny happy jolly friendly sweet scary magic magical
    fantasy fancy luxury luxurious royal stylized stylised cartoon cartoonish lowpoly minimalist
    carved handmade crafted painted decorated evil tiny huge giant miniature empty full racing
    electric acoustic sitting standing running sleeping lying walking flying jumping swimming
    smiling half broken open closed filled covered surrounded topped toy figurine prop
    ornament cut sliced used aged battered stained""".split()
) | {
    *("old fashioned", "stained glass"),
    *("hand carved", "hand crafted", "hand painted", "hand drawn", "sci fi", "science fiction"),
    *("king size", "king sized", "queen size", "queen sized", "full size", "life size"),
    *("leopard print", "zebra print", "tiger print", "animal print"),
    *STYLES,
}
# Of them those that make a thing as small as a hand can hold.
TOYS = frozenset("toy figurine miniature ornament".split())
# What a thing is depicted as: "a bronze statue of a lion" is a lion of bronze.
DEPICTIONS = ("statue", "sculpture", "figure", "doll")
# Forms of colours and materials that name a thing where they stand alone: "a grey rock".
ALONE = {"rock": "boulder", "stone": "boulder", "orange": "orange fruit"}
ALONE |= {"iron": "clothes iron", "bamboo": "bamboo plant"}
TONES = ("dark", "light", "pale", "deep", "bright", "vivid", "pastel")  # before a colour
WITHOUT = ("without", "no", "lacking")
# Parts that a thing may have or lack, as a caption may state them; "no hat" is a word like "hat".
# Of the legs a caption states how many.
CHOICES = ("armrests", "backrest", "handle", "cap", "hat", "chimney")
LEGS = {"one leg": 1, "three legs": 3, "four legs": 4}
PARTS = (*(state for part in CHOICES for state in (part, f"no {part}")), *LEGS)
# What a caption may state of each noun's parts.
OPTIONS: dict[str, tuple[str, ...]] = {
    "chair": ("armrests", "no armrests"),
    "table": ("one leg", "four legs"),
    "stool": ("one leg", "three legs", "four legs"),
    "bench": ("backrest", "no backrest"),
    "mug": ("handle", "no handle"),
    "bucket": ("handle", "no handle"),
    "candle": ("handle", "no handle"),
    "bottle": ("cap", "no cap"),
    "snowman": ("hat", "no hat"),
    "house": ("chimney", "no chimney"),
    "cottage": ("chimney", "no chimney"),
}
