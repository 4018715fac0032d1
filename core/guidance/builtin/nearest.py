"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those that it is nearest to in meaning, or in shape where nothing is near in
# meaning: a chest is a box with a lid.
NEAREST = {
    "armchair": "seat",
    "chair": "wheelchair, swing",
    "bookshelf": "shelf, drawer, rack",
    "cube": (
        "fridge, refrigerator, oven, microwave, stove, safe, treasure, coffin, "
        "television, tv, computer"
    ),
    "table": "counter, altar",
    "bed": "bunk, hammock",
    "sofa": "futon, divan, chaise",
    "bench": "pew",
    "vase": "pot, jar, pitcher, jug, amphora",
    "teapot": "kettle, coffeepot, samovar",
    "goblet": "tumbler, grail",
    "mug": "tankard, beaker, stein",
    "bowl": "dish, plate, sink, bathtub",
    "bucket": "bin, tub, dustbin",
    "bottle": "can, perfume, thermos",
    "cylinder": "pipe, log, battery",
    "candle": "match, lighter",
    "lamp": "light, streetlight, flashlight, chandelier",
    "house": (
        "building, barn, shed, school, villa, garage, mansion, hotel, shop, store, "
        "palace, temple, mosque, farmhouse, windmill"
    ),
    "church": "cathedral, monastery",
    "tower": "skyscraper, pillar, column, obelisk, minaret, silo, fortress",
    "cottage": "igloo, bungalow, treehouse",
    "arch": "bridge, door, portal, tunnel",
    "flower": "rose, tulip, plant, sunflower, orchid, lily, bouquet",
    "tree": "bush, shrub, bonsai",
    "cactus": "succulent, aloe",
    "mushroom": "fungus",
    "car": "limousine",
    "bus": "caravan, camper",
    "truck": "forklift",
    "airplane": "jet, glider",
    "boat": "raft, ferry, gondola, warship",
    "train": "subway",
    "rocket": "missile",
    "ball": "planet, moon, earth, football, basketball, egg, beach, bubble, coconut",
    "snowman": "man, person, figure, doll, woman, child",
    "robot": "android, mech, cyborg, droid, astronaut, knight, soldier, alien",
    "bust": "head, face, statue, sculpture, mask, mannequin",
    "cone": "pyramid, tornado",
    "torus": "wheel, tyre, tire, bracelet, pretzel",
    "pig": "horse, goat, donkey, pony, zebra, hippo, rhino, camel, deer, tiger, corgi",
    "duck": (
        "bird, chicken, penguin, swan, owl, crow, goose, eagle, parrot, pigeon, turkey, "
        "rooster, hen"
    ),
    "fish": "shark, whale, dolphin, trout, octopus, seal",
    "rabbit": "mouse, hamster, squirrel, hare, rat, hedgehog, kangaroo",
    "turtle": "snail, frog, crab, dinosaur, dragon, crocodile, lizard",
    "teddy bear": "panda, koala, gorilla, monkey",
    "hammer": "mallet, drill",
    "axe": "spear, scythe",
    "guitar": "harp",
    "drum": "tambourine, bongo",
    "bell": "gong",
    "dumbbell": "kettlebell",
    "apple": "orange fruit, tomato",
    "pumpkin": "squash, gourd",
    "carrot": "cucumber, radish",
    "cupcake": "cake, pie, cookie, bread, biscuit, croissant",
    "hamburger": "sandwich, hotdog, pizza, taco",
    "ice cream": "popsicle, sundae, lollipop",
    "hat": "bonnet, beret",
    "trophy": "prize, award",
    "bowling pin": "chess",
    "orange": "tangerine",
    "yellow": "mustard",
    "grey": "charcoal, slate",
    "beige": "sand, khaki, taupe",
    "light blue": "azure, aqua",
    "lime": "chartreuse",
    "purple": "mauve",
    "pink": "salmon",
    "green": "mint",
    "glass": "transparent, translucent",
    "plastic": "vinyl, nylon, acrylic",
    "metal": "titanium, tin, zinc",
    "wooden": "wicker",
    "stone": "cement, sandstone",
    "ceramic": "earthenware, enamel",
    "rubber": "silicone, latex",
    "fabric": "fur, fluffy, linen, canvas, knitted, plush",
}
# Words of other things, one slip away from a known word: no misspellings.
REAL = frozenset(
    """three bead bread hose rain crow beard cape goat coat beat horse moose mouse stove
    hall wall plant plate plane play pine spine moth math lame comb core
    stale cable able stable tale tools pools sport port card cars scar bush burn bowel flow floor
    hair stair fair pair clamp stamp whale wail snail sail rail tail battle golf food time
    greek plain store blank steam creek grain shore""".split()
)
