"""The words of the built-in prior, as data.

The order within a table is that of the networks' embeddings; new words go to the end.
"""

# A row's text has two parts. Before the semicolon: other names of the same thing, without a note.
# After it: narrower or neighbouring things, which are made as the row's word, with a note.

SHAPES = {
    "tall": "lofty",
    "flat": "flattened; low, short, squat",
    "wide": "broad; long",
    "thick": "chunky, bulky, stout, fat",
    "thin": "slim, narrow, slender; shallow",
    "round": "rounded, circular; chubby, plump",
}
PLUMP = ("chubby", "plump")  # round, whatever the thing
# The rows of colours: ``colors.SHADES`` has the shades with names of their own.
COLORS = {
    "red": "",
    "orange": "",
    "yellow": "",
    "green": "",
    "cyan": "",
    "blue": "",
    "purple": "",
    "pink": "",
    "brown": "",
    "black": "",
    "white": "",
    "grey": "gray",
    "dark red": "",
    "dark green": "",
    "navy": "navy blue, dark blue",
    "light blue": "",
    "lime": "",
    "beige": "",
}
MATERIALS = {
    "wooden": "wood, timber; oak, walnut, bamboo, mahogany, wicker, rattan, pine, "
    "pinewood, spruce, birch, maple, cherry wood, cherrywood, rosewood, ebony, teak, cedar, beech, "
    "beechwood, plywood, driftwood, dark wood, light wood, pale wood, white wood, oak wood, "
    "walnut wood, straw, thatched, thatch, lacquered wood, reclaimed wood, ash wood, light ash, "
    "pale ash, solid ash, olive wood, olivewood, hickory, seagrass, hardwood, softwood, hard wood",
    "metal": "polished metal, shiny metal, metallic; brushed metal, brushed steel, "
    "brushed aluminium, brushed aluminum, steel, iron, silver, silvery, cast iron, chrome, "
    "aluminium, aluminum, polished steel, stainless steel, stainless, galvanized, galvanised, "
    "galvanized steel, galvanised steel, tin, pewter, titanium, nickel, zinc, wrought iron, "
    "gunmetal, chromed, chrome plated, dark metal, black metal, sterling silver, platinum, "
    "robotic, mechanical, mirrored, scrap metal, sheet metal, corrugated metal, "
    "corrugated iron, steel mesh, "
    "wire mesh, iridescent, holographic",
    "golden": "gold, polished gold, gold plated; gold leaf, gold foil, gilded, brass, "
    "polished brass, rose gold, white gold",
    "plastic": "; acrylic, vinyl, resin, epoxy, nylon, carbon fiber, carbon fibre, fiberglass, "
    "polypropylene, polycarbonate, acetate, pvc, "
    "fibreglass, bakelite, tortoiseshell, chocolate, white chocolate, dark chocolate, wax, "
    "plasticine, claymation, modelling clay, modeling clay, play doh, playdoh, play dough, "
    "made of candy, pearlescent, pearly, nacreous, opalescent",
    "rubber": "; silicone, latex",
    "stone": "rock; marble, granite, concrete, brick, sandstone, slate, limestone, cobblestone, "
    "alabaster, onyx, obsidian, jade, quartz, travertine, plaster, stucco, basalt, white marble, "
    "black marble, green marble, lapis lazuli, malachite, "
    "terrazzo, made of snow, packed snow, made of sand, made of lava",
    "rusty": "rusty metal, rusted, rusted metal, rusty iron, rusty steel, rust, corroded",
    "ceramic": "porcelain, china, bone china, glazed ceramic; clay, terracotta, terra cotta, "
    "earthenware, stoneware, enamel, enameled, enamelled, mother of pearl, made of bone, "
    "made of bones, of bone, of bones, from bone",
    "leather": "; suede, faux leather, patent leather, snakeskin",
    "glass": "glassy, glass like; crystal glass, crystalline, frosted glass, clear glass, "
    "tinted glass, smoked glass, smoky glass, stained glass, of crystal, of ice, icy, made of ice, "
    "from ice, "
    "transparent, translucent, crystal clear, see through, see thru, perspex, plexiglass, "
    "plexiglas, made of jelly, gummy candy",
    "copper": "polished copper; bronze",
    "fabric": "cloth, textile, upholstered; canvas, felt, wool, woollen, woolen, velvet, cotton, "
    "silk, denim, knitted, knit, woven, plush, fur, furry, fluffy, linen, lace, tweed, corduroy, "
    "burlap, jute, cashmere, microfiber, polyester, yarn, crochet, crocheted, quilted, sheepskin, "
    "fleece, paper, cardboard, papier mache, paper mache, boucle, chenille, mohair, "
    "sequined, sequinned, sequin, made of moss",
}
# Names of things that imply glass, unless a material is stated.
GLASSWARE = frozenset(
    (
        "glass of water, glass of milk, drinking glass, pint of beer, glass of beer, fishbowl, "
        "fish bowl, goldfish bowl, decanter"
    ).split(", ")
)
# Weathering, applied at the bake.
WEATHERS = {
    "worn": "weathered, scratched, shabby, old, antique, ancient, rustic, worn out, well worn, "
    "distressed, aged, used, battered, scuffed, timeworn, time worn, weather beaten, beat up, "
    "beaten up, with scratches; chipped, cracked, peeling, faded, dented, chipped paint, "
    "peeling paint, cracked paint, faded paint, tarnished, patinated, scratch marks, rust spots, "
    "rust stains, patches of rust, abandoned, derelict, crumbling",
    "charred": "burnt, burned, scorched, singed, burnt down, burned down, burnt out, burned out, "
    "fire damaged; sooty, covered in soot",
    "dirty": "grimy, muddy, filthy, grungy, covered in mud, covered in dirt, covered with mud",
    "dusty": "dust covered, covered in dust, covered with dust",
    "mossy": "moss covered, overgrown, covered in moss, covered with moss, with moss, moss on",
    "snowy": "snow covered, covered in snow, covered with snow, snow capped, frosty, with snow, "
    "snow on, snow dusted, dusted with snow, snow topped",
}
# Gloss of a surface, or its light; also for a part alone.
SHEENS = {
    "matte": "matt, dull, unglazed, unpolished",
    "satin": "semi gloss, silky",
    "glossy": "gloss, shiny, polished, high gloss, lacquered, varnished, "
    "glazed, shining, sleek, mirror polished, lacquer",
    "glowing": "luminous, illuminated, luminescent, bioluminescent, neon, lit, glowy",
}
# Words for what lamps and flames always do.
LIT, ALIGHT = "lit", frozenset("burning flaming blazing alight ablaze".split())
PATTERNS = {
    "striped": "stripe, stripy, stripey, banded, tabby, brindle, tiger stripe, tiger striped, "
    "zebra stripe, zebra striped, candy striped, pinstripe, pinstriped",
    "spotted": "spot, spotty, dotted, dot, polka dot, polka dotted, leopard spotted, speckled, "
    "dappled",
    "checkered": "checked, chequered, checkerboard, check; plaid, tartan",
    "two-tone": "two tone, two toned, two coloured, two colored, bicolor, bicolour",
}
# Striped with two colours before it, unless the thing has such a part.
BANDS = ("bands", "rings", "lines")
# Those on a thing's surface: "a crate with orange stripes" is orange nowhere else.
FIGURES = ("stripe", "spot", "dot", "polka dot", "check")
# Things that state the material of another one behind them: "a robot dog", "a crystal ball".
ROBOTS = ("robot", "cyborg", "android")
AS_MATERIAL = dict.fromkeys(ROBOTS, "metal") | {
    "crystal": "crystal glass",
    "bone": "of bone",
    "lego": "plastic",
    "origami": "paper",
    "papercraft": "paper",
    "amigurumi": "crochet",
    "balloon": "vinyl",
    "inflatable": "vinyl",
    "stuffed": "plush",
    "cuddly": "plush",
    "ice": "of ice",
    "frozen": "of ice",
    "snow": "made of snow",
    "sand": "made of sand",
    **dict.fromkeys(("lava", "magma", "molten"), "made of lava"),
    **dict.fromkeys(("jelly", "gummy", "jello", "gelatin", "gelatine"), "made of jelly"),
    "candy": "made of candy",
    "moss": "made of moss",
}
# Only for likenesses, these groups and these things: an ice bucket is for ice, a snow leopard is
# white, a lava lamp is lit, a jelly jar is for jelly, a candy factory makes candy.
_FROZEN = ("throne", "crown", "sword", "shield", "staff")
_STONY = ("castle", "tower", "temple", "wall", "gate", "arch", "bridge", "cube", "ball")
_ONLY_OF = {
    "ice, frozen": ("buildings creatures", _FROZEN),
    "snow, sand": ("buildings", ("golem", "ball")),
    "lava, magma, molten": (
        "creatures",
        (*_FROZEN, *_STONY, "axe", "war hammer", "helmet", "chestplate"),
    ),
    "jelly, gummy, jello, gelatin, gelatine": ("creatures", ("cube", "ball", "heart", "star")),
    "candy": ("animals", ("house", "cottage", "castle", "tower")),
    "moss": ("", ("golem", "ball", "cube", "heart", "wall", "rug", "house", "cottage")),
}
ONLY_OF = {form: row for forms, row in _ONLY_OF.items() for form in forms.split(", ")}
# What steam might drive: things of these groups, and these; clothes are of leather and brass.
STEAMPUNK, STEAM_METALS, STEAM_CLOTHES = "steampunk", ("brass", "copper"), ("leather", "brass")
STEAM_GROUPS = ("Vehicles", "Aircraft and Space", "Buildings", "Electronics", "Tools and Toys")
STEAM_DRIVEN = frozenset(
    """mech lamp clock engine cannon pistol rifle shotgun revolver crossbow jetpack lantern spyglass
    binoculars compass kettle stove safe globe megaphone syringe bomb grenade padlock key""".split()
) | {
    *("floor lamp", "desk lamp", "alarm clock", "grandfather clock", "pocket watch", "ray gun"),
    *("rocket launcher", "washing machine", "gumball machine", "moka pot", "wall sconce"),
}
STEAM_WORN = frozenset("hat helmet goggles watch".split()) | {"cowboy hat", "gas mask"}
# Finishes more than materials: "an iridescent glass vase" is of glass.
FILMS = ("iridescent", "holographic", "pearlescent", "pearly", "nacreous", "opalescent")
OF_ANIMALS = ("stuffed", "cuddly", "balloon")  # a stuffed pepper is not of plush
# Unspecific materials.
PLAIN = ("metal", "metallic", "wood", "wooden", "fabric", "plastic", "stone", "upholstered")
# The part below a thing's natural stripes, where it is not most of the thing.
STRIPED_PARTS = {"longship": "sail", "market stall": "awning", "shop": "awning"}
STRIPED_PARTS |= {"cement mixer": "drum", "american football": "ball"}
# Stones that are gems of a thing with gems, by their colours.
GEMS = {"emerald": "green", "ruby": "red", "sapphire": "blue", "diamond": "white"}
GEMS |= {"amethyst": "purple", "topaz": "yellow", "onyx": "black"}
# Materials that are also things: "a table with a white cloth".
COUNTED = ("cloth", "glass", "straw", "canvas")
# Words for the place of something else: "a cottage by a lake".
PLACES = frozenset(
    """by at near beside behind under inside above against between over through along across around
    down into onto below among to as out off up while where whose beside atop who being
    like""".split()
)
# Words around the subject that do not describe it.
FILLER = PLACES | frozenset(
    """a an the of in on with and is are been was were it its one single some made from out color
    colour colored coloured photo photograph picture image render rendering rendered dslr 3d 3 d cg
    model
    object highly very detailed high quality hd 4k 8k hdr realistic photorealistic beautiful nice
    simple studio lighting isolated background view please style shape cute
    shaped asset game ready material s has have that which for texture textured pattern patterned
    pair bunch slice piece wedge chunk segment section wearing holding new classic modern
    traditional elegant lovely pretty infront shot carving replica pose posed warm cool or nor but
    only extra some please pls plz i you we he she they me my your his her our their want need would
    make create generate give show draw build design lol idk omg btw tho kinda smth something just
    only really number also thats all too so any yet other nothing else lowkey quite actually
    basically literally together kind sort type version""".split()
)
# Words about a picture, without meaning for the thing itself.
FILLER |= frozenset(
    """hyperrealistic photoreal masterpiece pbr octane unreal isometric cinematic ultra macro
    archviz closeup uhd bokeh zoomed resolution textures centered centred orthographic""".split()
)
# Praise: nothing that one could miss in the result.
FILLER |= frozenset(
    """adorable delicious tasty yummy majestic gorgeous stunning amazing awesome epic magnificent
    wonderful charming fabulous fantastic incredible breathtaking exquisite splendid perfect superb
    delightful impressive glorious cutest coolest prettiest best ever extremely incredibly insanely
    favorite favourite""".split()
)
# What all that is made has: large heads, large eyes and simple forms.
FILLER |= frozenset(
    "stylized stylised cartoon cartoons cartoony cartoonish toon toony chibi kawaii".split()
)
# Abbreviations.
SHORT = {"w": "with", "n": "and", "wo": "without", "coffe": "coffee", "glows": "glowing"}
# Slips that are words of their own, or too short to tell.
SHORT |= {"amor": "armor", "comin": "coming", "acustic": "acoustic"}
SHORT |= dict.fromkeys(("isnt", "arent", "doesnt", "dont", "non"), "not")
SHORT |= {"neither": "not", "withe": "white", "litle": "little", "smal": "small"}
SHORT |= {"whit": "with", "wiht": "with", "wih": "with", "wth": "with", "witht": "with"}
# Surroundings of the picture: a colour before them is not the thing's.
SURROUNDINGS = frozenset("lighting backdrop background shadows".split())
# Fillers that end a noun phrase: unknown words before them describe no noun after them.
PHRASE_ENDS = PLACES | frozenset(
    """a an the of in on with and or nor but is are it its made from out has have which that wearing
    holding""".split()
)
ARTICLES = ("a", "an", "the")
OWN = (*ARTICLES, "my", "your", "our", "his", "her", "their", "its", "some")
# Those that an accessory may follow: "a vase of flowers".
GOES_WITH = PLACES | frozenset("of in on with has have wearing holding from".split())
# After these all is about something else: a chest full of gold is not golden.
OF_ANOTHER = (
    "for",
    "worn by",
    "used for",
    "used by",
    "used as",
    "used in",
    "about",
    "filled with",
    "full of",
    "surrounded by",
    "in front of",
    "on top of",
    "next to",
    "dressed as",
    "disguised as",
)
# Numbers. One is made, with a note.
COUNTS = frozenset(
    """two three four five six seven eight nine ten twelve dozen dozens several many few couple
    multiple various set pile heap stack group row collection pack bundle cluster clump
    assortment""".split()
)
# Requests for the style of the mesh, without effect on a shape and its materials.
STYLES = frozenset("intricate voxel anime vivid".split()) | {
    *("low poly", "high poly", "low detail", "low res", "low quality", "low resolution"),
    *("pixel art", "voxel art"),
    *("pastel colors", "pastel colours", "soft colors", "soft colours", "bright colors"),
    *("bright colours", "vibrant colors", "vibrant colours", "vivid colors", "vivid colours"),
    *("t pose", "a pose", "full body", "top down", "product design"),
    *("flat shading", "flat shaded", "smooth shaded", "cel shaded", "cel shading"),
    *("clay render", "matcap", "hard surface", "soft shading"),
}
# Phrases about a picture of the thing, without meaning for the thing itself.
OF_PICTURES = frozenset(
    (
        "high detail, high res, high resolution, high quality, best quality, concept art, "
        "digital art, "
        "product render, product photo, product photography, studio shot, octane render, "
        "blender render, cycles render, blender 3d, unreal engine, unreal engine 5, ray traced, "
        "ray tracing, trending on artstation, depth of field, white background, "
        "black background, plain background, transparent background, zoomed out, zoomed in, "
        "close up, close up shot, close up view, wide angle, wide shot, product shot, hero shot, "
        "front view, side view, top view, aerial view, aerial shot, bird eye view, "
        "birds eye view, top down view, cinematic lighting, studio lighting, game ready, "
        "well lit"
    ).split(", ")
)
# Adjectives of age, finish or mood. They name no thing, so a prompt is accepted without them.
IGNORED_ADJECTIVES = frozenset(
    """vintage retro organic medieval victorian baroque ornate
    cozy cosy comfy comfortable soft sturdy heavy clean
    fresh ripe juicy funny happy jolly friendly sweet scary magic magical
    fantasy fancy luxury luxurious royal lowpoly minimalist
    handmade decorated evil miniature empty full racing sunburst
    facade entrance interior exterior wreck wreckage ruin ruins remains
    asleep seated crouched curled
    electric acoustic sitting standing running sleeping lying walking flying jumping swimming
    smiling half halved bitten eaten partly broken open closed filled surrounded topped toy
    figurine prop
    ornament stuffed cuddly cut sliced stained bent torn crooked percent
    double triple mesh
    backwards upright sideways stuck kept tied hung sick laser lazer
    solid premium mockup icon emoji exotic rugged ergonomic wireless portable foldable folding
    inflatable adjustable lightweight waterproof electronic digital analog analogue automatic
    industrial commercial gooseneck curly wavy spiky pointy bumpy fuzzy puffy bushy frilly smug
    dwarven smooth rough lush dense sharp grumpy sleepy sad shy proud brave clever silly goofy
    derpy wacky quirky lazy hungry
    spanish french italian german english british american japanese chinese korean indian mexican
    greek roman egyptian turkish moroccan russian dutch swedish scandinavian nordic persian arabic
    african european asian""".split()
) | {
    *("stove top", "table top", "wall mounted", "free standing", "floor standing"),
    *("old fashioned", "never used", "barely used", "life cycle", "low key"),
    *("hand drawn", "sci fi", "science fiction"),
    *("king size", "king sized", "queen size", "queen sized", "full size", "life size"),
    *("lawn ornament", "garden ornament", "lawn decoration", "garden decoration"),
    "wind up",
    *("you can", "can see", "you can see", "so you can"),
    "on canvas",
    *("leopard print", "zebra print", "tiger print", "animal print"),
    *STYLES,
}
# Counts of parts that are not separate ones: "a three-seater sofa", "a two story house".
IGNORED_ADJECTIVES |= {
    f"{count} {of}"
    for count in (
        *"one two three four five six seven eight nine ten".split(),
        *map(str, range(1, 21)),
    )
    for of in (
        "seater poster piece storey storeys story stories floor floors floored level levels tier "
        "tiers tiered way burner"
    ).split()
}
COLORED = ("colored", "coloured", "color", "colour")
# How a material or a look was made; the look has its own word.
HOW_MADE = frozenset(
    """carved cast hewn sculpted chiseled chiselled forged moulded molded welded wrapped covered
    bound bare plated coated clad hammered crafted painted handcrafted embroidered
    frosted""".split()
) | {
    *("hand carved", "hand crafted", "hand painted", "hand forged", "hand blown"),
}
SHAPED_OF = ("carved", "carving", "cast", "hewn", "sculpted", "chiseled", "chiselled")
# Words for a thing as small as a hand can hold.
TOYS = frozenset("toy figurine miniature ornament".split()) | {
    *("scale model", "scale replica", "ho scale", "n scale", "small scale"),
}
# Factors on a thing's usual size.
SIZE_WORDS = {
    **dict.fromkeys(("tiny", "teeny"), 0.4),
    "mini": 0.5,
    **dict.fromkeys(("small", "little"), 0.7),
    **dict.fromkeys(("big", "large", "oversized"), 1.5),
    **dict.fromkeys(("huge", "massive", "enormous"), 2.0),
    **dict.fromkeys(("giant", "gigantic", "colossal"), 3.0),
}
FILLER |= SIZE_WORDS.keys()
# Sizes of a part, by the word before it: of all of it, of its length, of its thickness.
PART_SCALES = {word: round(by**0.7, 2) for word, by in SIZE_WORDS.items()}
PART_LENGTHS = dict.fromkeys(("long", "tall"), 1.5) | {"short": 0.6}
PART_WIDTHS = dict.fromkeys(("thick", "chunky", "bulky", "stout", "fat"), 1.5)
PART_WIDTHS |= dict.fromkeys(("thin", "slim", "slender", "narrow"), 0.6)
PART_SIZES = {*PART_SCALES, *PART_LENGTHS, *PART_WIDTHS}
# Depictions: "a bronze statue of a lion" is a lion of bronze, eyes and all.
STATUES = ("statue", "sculpture", "statuette", "idol", "effigy")
BUSTS = ("bust", "head bust")  # of an animal: the whole animal is made
PLUSHIES = ("plushie", "plush toy", "stuffed animal", "stuffed toy", "soft toy", "cuddly toy")
SMALL_FIGURES = ("action figure", "toy figure", "vinyl figure")
DEPICTIONS = (*STATUES, *PLUSHIES, *SMALL_FIGURES, "figure", "doll", "character")
# An animal of these materials is a statue; for a person, a gold wizard, fewer apply.
CAST = ("metal", "rusty", "golden", "copper", "stone", "glass")
CARVED = ("stone", "glass", "wooden", "ceramic")
EDIBLE = ("chocolate", "white chocolate", "dark chocolate")
MOULDED = (*EDIBLE, "clay", "terracotta", "terra cotta", "latex", "vinyl", "of bone")  # of both
# All of a creature is of these, a golem too: no moss grows on lava.
MASSES = ("made of lava", "made of snow", "made of sand", "made of jelly", "gummy candy")
MASSES += ("made of candy", "packed snow")
# But for the eyes, of these: among glowing cracks one would not find the head.
WITH_EYES = ("made of lava", "made of snow", "made of sand")
# A living thing of these is a soft toy; a foldable thing of the others is a toy too.
SEWN = ("plush", "felt", "knitted", "knit", "crochet", "crocheted", "yarn")
FOLDABLE = ("airplane", "boat", "dragon", "fighter jet")
FOLDED = ("origami", "papercraft", "lego", "paper", "papier mache", "paper mache")
# Words for metals that are colours on hair and skin; for a whole animal fewer are: "a golden lion".
ALSO_COLORS = ("silver", "silvery", "gold", "golden", "copper", "bronze")
ALSO_OF_FUR = ("silver", "silvery", "golden")
# Words for living things that do not mean wear.
AGES = frozenset("old ancient aged".split())
# Forms of colours and materials that name a thing by themselves: "a grey rock".
ALONE = {"rock": "boulder", "stone": "boulder", "orange": "orange fruit"}
ALONE |= {"brick": "brick block", "bricks": "brick block", "rainbow": "rainbow arch"}
ALONE |= {"emerald": "gem", "tabby": "cat"}
ALONE |= {"iron": "clothes iron", "bamboo": "bamboo plant", "straw": "hay bale"}
ALONE |= {
    "cobblestone": "boulder",
    "quartz": "crystal",
    "cardboard": "cardboard box",
    "driftwood": "log",
}
ALONE |= dict.fromkeys(("pine", "spruce", "cedar"), "tree")
ALONE |= dict.fromkeys(("oak", "birch", "maple", "beech"), "oak tree")
ALONE |= dict.fromkeys(("chocolate", "white chocolate", "dark chocolate"), "chocolate bar")
WITHOUT = ("without", "no", "not", "lacking")
LOOKS = ("color", "material", "sheen", "shape", "pattern")  # which a part may have of its own
