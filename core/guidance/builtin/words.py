"""The words of the built-in prior, as data: each with its synonyms, which commas part.

The order within a table is that of the networks' embeddings; new words go to the end.
"""

NOUNS = {
    # Plain solids and the first things
    "ball": "sphere, globe, orb",
    "cube": "box, block, dice",
    "torus": "donut, doughnut, ring, bagel",
    "cylinder": "barrel",
    "cone": "traffic cone",
    "table": "desk",
    "chair": "dining chair",
    "armchair": "recliner",
    "mug": "cup, teacup, coffee cup, coffee mug, beer mug",
    "vase": "urn",
    "bottle": "flask",
    "lamp": "table lamp, lampshade",
    "snowman": "snowmen",
    "mushroom": "toadstool",
    "house": "home",
    "dumbbell": "barbell",
    "rocket": "spaceship, rocket ship, space rocket",
    "tree": "fir, pine, conifer, fir tree, pine tree, christmas tree",
    # Household
    "sofa": "couch, settee, loveseat",
    "stool": "bar stool, barstool",
    "bench": "park bench",
    "bed": "",
    "bookshelf": "bookcase, bookshelves, book shelf",
    "teapot": "tea pot",
    "bowl": "",
    "pan": "frying pan, skillet, saucepan, wok",
    "goblet": "chalice, wine glass, wineglass",
    "bucket": "pail",
    "candle": "candlestick",
    "crown": "tiara",
    "hat": "top hat",
    "bell": "church bell",
    "bust": "head bust, statue head",
    "trophy": "trophies",
    "bowling pin": "skittle, pin",
    # Food, plants, animals
    "hamburger": "burger, cheeseburger",
    "ice cream": "icecream, ice cream cone, gelato",
    "pineapple": "",
    "apple": "",
    "carrot": "",
    "cupcake": "muffin, cup cake",
    "pumpkin": "",
    "cactus": "cacti",
    "flower": "daisy, potted flower",
    "palm": "palm tree",
    "pig": "piglet, piggy, piggy bank",
    "fish": "goldfish, clownfish",
    "rabbit": "bunny, bunnies",
    "turtle": "tortoise",
    "duck": "rubber duck, bath duck",
    "teddy bear": "teddy, bear",
    # Vehicles, buildings, tools, instruments, toys
    "car": "automobile, sports car, race car",
    "bus": "coach, school bus",
    "truck": "lorry, lorries",
    "airplane": "plane, aeroplane, aircraft",
    "boat": "sailboat, sailing boat, ship, yacht, rowboat, rowing boat, fishing boat",
    "train": "locomotive, steam engine, steam train",
    "cottage": "hut, cabin",
    "tower": "castle tower, castle",
    "lighthouse": "light house",
    "church": "chapel",
    "arch": "archway, gate",
    "hammer": "",
    "axe": "ax, hatchet",
    "anvil": "",
    "guitar": "",
    "drum": "snare drum",
    "robot": "toy robot",
}
SHAPES = {
    "tall": "lofty",
    "flat": "low, short, squat, flattened",
    "wide": "long, broad",
    "thick": "chunky, bulky, stout, fat",
    "thin": "slim, narrow, slender, shallow",
    "round": "rounded, chubby, plump, circular",
}
COLORS = {
    "red": "cherry red, crimson, scarlet, ruby red, blood red, bright red",
    "orange": "bright orange",
    "yellow": "lemon yellow, golden yellow, bright yellow",
    "green": "grass green, bright green",
    "cyan": "turquoise, teal",
    "blue": "royal blue, cobalt blue, bright blue",
    "purple": "violet",
    "pink": "rose pink, light red",
    "brown": "chocolate brown, light brown, chestnut, cognac",
    "black": "jet black, coal black",
    "white": "snow white",
    "grey": "gray",
    "dark red": "maroon, burgundy, wine red",
    "dark green": "forest green, bottle green",
    "navy": "navy blue, dark blue, midnight blue",
    "light blue": "sky blue, baby blue, pale blue",
    "lime": "lime green, light green, pale green",
    "beige": "cream, cream coloured, cream colored, ivory, tan",
}
MATERIALS = {
    "wooden": "wood, timber, oak, walnut",
    "metal": "polished metal, shiny metal, metallic, steel, iron, silver, silvery, "
    "cast iron, chrome, aluminium, aluminum, polished steel, polished",
    "golden": "gold, brass, polished gold, polished brass",
    "plastic": "",
    "rubber": "",
    "stone": "marble, granite, concrete, rock",
    "rusty": "rusty metal, rusted, rusted metal, rusty iron, rusty steel, rust, corroded",
    "ceramic": "porcelain, china, glazed, glazed ceramic, clay",
    "leather": "",
    "glass": "glassy, glass like, glossy, crystal",
    "copper": "bronze, polished copper",
    "fabric": "cloth, felt, wool, woollen, woolen, velvet, cotton, textile, upholstered",
}
PATTERNS = {
    "striped": "stripe, stripy, stripey, banded",
    "spotted": "spot, spotty, dotted, dot, polka dot, polka dotted",
    "checkered": "checked, chequered, checkerboard, chessboard, check, plaid, tartan",
    "two-tone": "two tone, two toned, two coloured, two colored, bicolor, bicolour",
}
# How a caption calls the parts that it may tell of (``draw.CHOICES`` and ``draw.LEGS``).
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
# Words for the parts that a noun always has: said of it, they change nothing but a colour's place.
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
    "fins": "fin",
    "stem": "stalk",
    "handles": "handle, ears",
}
# What people write around the subject and what says nothing about it.
FILLER = frozenset(
    """a an the of in on with and is it its one single some made from out color colour colored
    coloured photo photograph picture image render rendering rendered dslr 3d 3 d cg model object
    highly very detailed high quality hd 4k 8k hdr realistic photorealistic beautiful nice
    simple studio lighting isolated background view please style shape cute small little big large
    shaped asset game ready material s has have that which for texture textured pattern patterned
    old new classic modern traditional elegant lovely pretty""".split()
)
# Said of a thing's age, finish or mood: no thing, so a prompt need not be refused for them.
UNHEARD = frozenset(
    """worn weathered aged antique vintage retro rustic ancient medieval victorian baroque ornate
    cozy cosy comfy comfortable soft sturdy heavy matte matt satin glowing shining dirty clean dusty
    fresh ripe juicy tasty delicious funny happy jolly friendly sweet scary magic magical
    fantasy fancy luxury luxurious royal stylized stylised cartoon cartoonish lowpoly minimalist
    carved handmade hand crafted painted decorated tiny huge giant miniature empty full racing
    electric acoustic""".split()
)
TONES = ("dark", "light", "pale", "deep", "bright", "vivid", "pastel")  # before a colour
WITHOUT = ("without", "no", "lacking")
# Nearest known words for common ones that no spelling leads to.
NEAREST = {
    "armchair": "throne, seat",
    "bookshelf": "cabinet, wardrobe, cupboard, shelf, drawer, dresser",
    "vase": "pot, jar, pitcher, jug, amphora",
    "teapot": "kettle",
    "goblet": "tumbler",
    "bucket": "basket, bin",
    "house": "building, barn, shed, school, villa",
    "tower": "skyscraper, pillar, column, obelisk",
    "flower": "rose, tulip, plant, sunflower",
    "tree": "bush, shrub",
    "car": "taxi, van, jeep, cart",
    "truck": "tractor, tank",
    "airplane": "jet, helicopter",
    "boat": "canoe, submarine",
    "train": "tram, rain",
    "ball": "planet, moon, earth, football, basketball, egg, beach",
    "snowman": "man, person, figure, doll, woman",
    "bust": "head, face, statue",
    "lamp": "light, lantern, streetlight, lamb",
    "cone": "pyramid, corn",
    "torus": "wheel, tyre, tire",
    "pig": "cow, sheep, horse, elephant, dog, cat, goat, wolf, lion",
    "duck": "bird, chicken, penguin, swan, owl, crow, goose",
    "fish": "shark, whale, dolphin, trout",
    "rabbit": "mouse, hamster, squirrel, hare",
    "turtle": "snail, frog, crab",
    "hammer": "wrench, screwdriver, mallet, spanner",
    "axe": "sword, knife, saw, spade, shovel",
    "guitar": "violin, piano, cello, banjo",
    "drum": "trumpet, tambourine",
    "apple": "pear, peach, orange fruit, tomato, cherry",
    "cupcake": "cake, pie, cookie, bread",
    "hamburger": "sandwich, hotdog, pizza",
    "cottage": "tent, igloo",
    "arch": "bridge, door",
    "crown": "helmet, jewel",
    "bottle": "battle, can",
    "brown": "ochre, amber",
    "purple": "lilac, lavender, indigo",
    "pink": "magenta, fuchsia, salmon",
    "green": "olive, emerald, mint",
    "glass": "transparent, translucent",
    "plastic": "vinyl, nylon",
    "fabric": "silk, denim, fur, fluffy",
}
# Words of other things, one slip away from a known word: no misspellings.
REAL = frozenset(
    """three bead bread hose rain crow beard cart cape goat coat boot beat horse moose mouse stove
    lamb bull hall well wall pants plant plate plane play pine spine moth math lame comb core
    stale cable able stable tale tools pools sport port card cars scar bush burn bowel flow floor
    hair stair fair pair clamp stamp whale wail snail sail rail tail""".split()
)

# Parts that a thing may have or lack, as a caption may say; "no hat" is told like "hat". Of the
# legs a caption says how many.
CHOICES = ("armrests", "backrest", "handle", "cap", "hat", "chimney")
LEGS = {"one leg": 1, "three legs": 3, "four legs": 4}
PARTS = (*(said for choice in CHOICES for said in (choice, f"no {choice}")), *LEGS)
# What a caption may say of each noun's parts.
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
