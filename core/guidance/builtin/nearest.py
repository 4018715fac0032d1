"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those that it is nearest to in meaning, or in shape where nothing is near in
# meaning: a chest is a box with a lid.
NEAREST = {
    "armchair": "throne, seat",
    "chair": "wheelchair, rocker, swing",
    "bookshelf": "cabinet, wardrobe, cupboard, shelf, drawer, dresser, rack, closet, sideboard",
    "cube": "chest, crate, trunk, package, parcel, present, gift, suitcase, "
    "fridge, refrigerator, oven, microwave, stove, safe, treasure, coffin, "
    "tombstone, television, tv, computer",
    "table": "workbench, nightstand, counter, altar",
    "bed": "cot, crib, bunk, hammock, cradle",
    "sofa": "futon, ottoman, divan, chaise",
    "stool": "footstool, pouffe",
    "bench": "pew",
    "vase": "pot, jar, pitcher, jug, amphora",
    "teapot": "kettle, coffeepot, samovar",
    "goblet": "tumbler, grail",
    "mug": "tankard, beaker, stein",
    "bowl": "dish, plate, saucer, sink, bathtub",
    "bucket": "basket, bin, tub, cauldron, dustbin",
    "bottle": "can, potion, vial, perfume, thermos",
    "cylinder": "coin, pipe, log, battery",
    "candle": "match, lighter",
    "lamp": "light, lantern, streetlight, torch, flashlight, chandelier",
    "house": "building, barn, shed, school, villa, garage, mansion, hotel, shop, "
    "store, palace, temple, mosque, farmhouse, windmill",
    "church": "cathedral, monastery",
    "tower": "skyscraper, pillar, column, obelisk, minaret, silo, fortress",
    "cottage": "tent, igloo, bungalow, treehouse",
    "arch": "bridge, door, portal, fence, tunnel",
    "flower": "rose, tulip, plant, sunflower, orchid, lily, bouquet",
    "tree": "bush, shrub, bonsai",
    "cactus": "succulent, aloe",
    "mushroom": "fungus, umbrella, parasol",
    "car": "taxi, van, jeep, cart, motorcycle, motorbike, bicycle, bike, wagon, "
    "scooter, carriage, limousine, ambulance",
    "bus": "minibus, trolley, caravan, camper",
    "truck": "tractor, tank, bulldozer, excavator, digger, forklift",
    "airplane": "jet, helicopter, drone, glider",
    "boat": "canoe, submarine, kayak, raft, ferry, gondola, warship, galleon",
    "train": "tram, subway",
    "rocket": "missile, shuttle, ufo, spacecraft",
    "ball": "planet, moon, earth, football, basketball, egg, beach, balloon, "
    "bubble, bomb, coconut, watermelon, melon",
    "snowman": "man, person, figure, doll, woman, child",
    "robot": "android, mech, cyborg, droid, astronaut, knight, soldier, alien",
    "bust": "head, face, statue, skull, sculpture, mask, mannequin",
    "cone": "pyramid, tornado",
    "torus": "wheel, tyre, tire, bracelet, pretzel",
    "pig": "cow, sheep, horse, elephant, dog, cat, goat, wolf, lion, donkey, "
    "pony, zebra, giraffe, hippo, rhino, camel, deer, fox, tiger, corgi, puppy, "
    "kitten",
    "duck": "bird, chicken, penguin, swan, owl, crow, goose, eagle, parrot, "
    "pigeon, turkey, rooster, hen",
    "fish": "shark, whale, dolphin, trout, octopus, seal",
    "rabbit": "mouse, hamster, squirrel, hare, rat, hedgehog, kangaroo",
    "turtle": "snail, frog, crab, dinosaur, dragon, crocodile, lizard",
    "teddy bear": "panda, koala, gorilla, monkey",
    "hammer": "wrench, screwdriver, mallet, spanner, pliers, drill",
    "axe": "sword, knife, saw, spade, shovel, dagger, katana, spear, scythe, pickaxe",
    "guitar": "violin, piano, cello, banjo, ukulele, harp",
    "drum": "trumpet, tambourine, bongo",
    "bell": "gong",
    "dumbbell": "kettlebell",
    "apple": "pear, peach, orange fruit, tomato, cherry",
    "pumpkin": "squash, gourd",
    "carrot": "cucumber, radish, banana",
    "cupcake": "cake, pie, cookie, bread, biscuit, croissant",
    "hamburger": "sandwich, hotdog, pizza, taco",
    "ice cream": "popsicle, sundae, lollipop",
    "crown": "helmet, jewel",
    "hat": "bonnet, beret, fedora, sombrero",
    "trophy": "medal, prize, award",
    "bowling pin": "pawn, chess",
    "orange": "tangerine, apricot",
    "yellow": "mustard",
    "grey": "charcoal, slate",
    "beige": "sand, khaki, taupe",
    "light blue": "azure, aqua",
    "lime": "chartreuse",
    "purple": "plum, mauve",
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
    """three bead bread hose rain crow beard cart cape goat coat boot beat horse moose mouse stove
    lamb bull hall well wall pants plant plate plane play pine spine moth math lame comb core corn
    stale cable able stable tale tools pools sport port card cars scar bush burn bowel flow floor
    hair stair fair pair clamp stamp whale wail snail sail rail tail battle golf food time medal
    greek plain store blank steam creek grain shore""".split()
)
